//! `rough-contact synth`: a random self-affine surface from a recipe and a seed.

use crate::args::{self, CommonOptions};
use crate::convert::MapFormat;
use crate::outcome::{self, Failure, Reply};
use crate::text::{self, TwoColumns};
use crate::units::Dimension::{Length, Number};
use clap::Args;
use rough_contact::contact_types::{Grid, HeightMap};
use rough_contact::surface_stats::synthesis::{Scale, SelfAffine};
use serde_json::json;
use std::path::PathBuf;

#[derive(Args)]
pub(crate) struct Synth {
    /// Rows and columns
    #[arg(long, value_name = "NY,NX", value_parser = args::shape)]
    shape: [usize; 2],
    /// Distance of neighbouring points
    #[arg(long, value_name = "DX[,DY]", value_parser = args::pixel, allow_hyphen_values = true)]
    pixel: [f64; 2],
    /// Hurst exponent, above 0 and at most 1
    #[arg(long, value_name = "H", value_parser = args::one(Number), allow_hyphen_values = true)]
    hurst: f64,
    /// Wavelength above which the spectrum is flat; with --rms-height and --rms-gradient both it is found
    #[arg(long, value_name = "L", value_parser = args::one(Length), allow_hyphen_values = true)]
    #[arg(required_unless_present_all = ["rms_height", "rms_gradient"])]
    rolloff: Option<f64>,
    /// Shortest wavelength
    #[arg(long, value_name = "L", value_parser = args::one(Length), allow_hyphen_values = true)]
    cutoff: f64,
    /// Rms height to scale to
    #[arg(long, value_name = "S", value_parser = args::one(Length), allow_hyphen_values = true)]
    #[arg(required_unless_present = "rms_gradient")]
    rms_height: Option<f64>,
    /// Rms gradient to scale to, instead of --rms-height or beside it
    #[arg(long, value_name = "G", value_parser = args::one(Number), allow_hyphen_values = true)]
    rms_gradient: Option<f64>,
    /// Seed of the random phases: the same seed gives the same surface everywhere
    #[arg(long, value_name = "N")]
    seed: u64,
    /// Round the heights to multiples of this step, as an instrument does
    #[arg(long, value_name = "DZ", value_parser = args::one(Length), allow_hyphen_values = true)]
    quantise: Option<f64>,
    /// File to write; its ending chooses the format: .npy (metres, f64), .x3p, .sdf, .txt, .vti or .h5
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

impl Synth {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let format = MapFormat::of(&self.out)?;
        outcome::check(&self.out, common.force)?;
        let (map, rolloff) = self.surface()?;
        let comment = format!(
            "rough-contact synth: Hurst {}, roll-off {rolloff} m, cut-off {} m, seed {}",
            self.hurst, self.cutoff, self.seed
        );
        outcome::write(&self.out, |writer| format.write(writer, &map, &comment))?;
        Ok(self.reply(&map, rolloff))
    }

    fn surface(&self) -> Result<(HeightMap, f64), Failure> {
        let grid = Grid::new(self.shape, self.pixel).map_err(|e| Failure::from(&e))?;
        let scale = match (self.rms_height, self.rms_gradient) {
            (Some(_), Some(_)) if self.rolloff.is_some() => {
                let message = "--rms-height, --rms-gradient and --rolloff fix more than one surface has; leave one out (the \
                               roll-off that gives both is found)";
                return Err(Failure::refused("usage", message));
            }
            (Some(height), _) => Scale::RmsHeight(height),
            (None, gradient) => Scale::RmsGradient(gradient.unwrap_or(f64::NAN)),
        };
        let recipe = SelfAffine {
            grid,
            hurst: self.hurst,
            rolloff: self.rolloff.unwrap_or(self.cutoff),
            cutoff: self.cutoff,
            scale,
            seed: self.seed,
            quantise: self.quantise,
        };
        let both = self.rms_gradient.filter(|_| self.rms_height.is_some());
        let recipe = both.map_or(Ok(recipe), |gradient| recipe.with_gradient(gradient));
        let recipe = recipe.map_err(|e| Failure::from(&e))?;
        let map = recipe.generate().map_err(|e| Failure::from(&e))?;
        Ok((map, recipe.rolloff))
    }

    fn reply(&self, map: &HeightMap, rolloff: f64) -> Reply {
        let [ny, nx] = self.shape;
        let (low, high) = map.range();
        let mut table = TwoColumns::default();
        table.row("wrote", self.out.display().to_string());
        table.row("points", format!("{ny} rows × {nx} columns"));
        table.row("heights", format!("{} to {}", text::length(low), text::length(high)));
        if self.rolloff.is_none() {
            table.row("roll-off", format!("{}, found", text::length(rolloff)));
        }
        let json = json!({
            "rolloff": rolloff,
            "path": self.out.to_string_lossy(),
            "shape": self.shape,
            "pixel": self.pixel,
            "height_min": low,
            "height_max": high,
            "seed": self.seed,
        });
        Reply::new(table.to_string(), json)
    }
}
