//! The figures that README and book show: area and real pressure over the load for one ground
//! surface, made by the commands that the README shows, and the fields of one solver iteration.

use crate::generated::{check_flag, keep};
use crate::shell::{self, TaskResult, cargo, read, root, rough_contact};

/// The surface, as `rough-contact synth` makes it: the recipe "ground" of
/// `crates/compare/data/surfaces.toml`.
const GROUND: &str = "synth --force --shape 1001,1001 --pixel 1um --hurst 0.7 --rolloff 80um --cutoff 6um \
                      --rms-height 0.6um --quantise 10nm --seed 2";

/// Writes the figures, or checks that the committed ones are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let folder = root().join("target/figures");
    let (map, report) = (folder.join("ground.x3p"), folder.join("report"));
    std::fs::create_dir_all(&folder)
        .map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let mut synth = rough_contact(false);
    shell::run(synth.args(GROUND.split_whitespace()).arg("--out").arg(&map))?;
    let mut study = rough_contact(false);
    study.args("compare --modulus 110GPa --load 10N..6.31kN:15 --quiet --force".split(' '));
    shell::run(study.arg(map).arg("--out").arg(&report))?;
    for name in ["area.svg", "pressure.svg"] {
        let figure = read(&report.join(name))?;
        keep(&format!("docs/src/figures/{name}"), &figure, check)?;
    }
    if check.is_none() {
        // A picture of pixels: drawn by the solver's own test, which sees inside an iteration.
        let mut draw = cargo();
        draw.args(["test", "--quiet", "--locked", "--package", "fft-bem-solver", "--lib", "--"]);
        shell::run(draw.args(["--ignored", "draw_the_fields"]))?;
    }
    Ok(())
}
