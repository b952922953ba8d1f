//! What the book says of the study, from its table: figures and tables.

use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::Path;
use studies::figures::kappa::{
    model_kappa, model_slope, write_kappa_bandwidth, write_kappa_full, write_kappa_load,
};
use studies::light_load::{Kind, LogLaw, Row, Slope, difference, kinds, log_law, parse};

/// Loads of the table over the load.
const SHOWN: [f64; 4] = [0.0025, 0.01, 0.04, 0.1];

/// Writes `kappa-*.svg` and `kappa.md` into `folder`.
pub(crate) fn write(table: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(table)?;
    let rows = parse(&text).ok_or("the table cannot be read")?;
    let kinds = kinds(&rows);
    let law = log_law(&kinds);
    fs::create_dir_all(folder)?;
    let file = |name: &str| File::create(folder.join(name));
    write_kappa_bandwidth(&kinds, &mut file("kappa-bandwidth.svg")?)?;
    write_kappa_load(&three(&kinds), &mut file("kappa-load.svg")?)?;
    write_kappa_full(&full(&rows), &mut file("kappa-full.svg")?)?;
    let page = [
        bandwidth_table(&kinds),
        law_words(&kinds, law),
        hurst_words(&kinds, law),
        load_table(&three(&kinds)),
        grid_table(&rows),
        full_table(&full(&rows)),
        closing_words(&full(&rows)),
    ]
    .join("\n");
    fs::write(folder.join("kappa.md"), page)?;
    Ok(())
}

/// The narrowest spectrum, the one nearest to a parameter of 10, the broadest.
fn three(kinds: &[Kind]) -> Vec<&Kind> {
    let by = |f: &dyn Fn(&Kind) -> f64| kinds.iter().min_by(|a, b| f(a).total_cmp(&f(b)));
    [by(&|k| k.bandwidth), by(&|k| (k.bandwidth / 10.0).ln().abs()), by(&|k| -k.bandwidth)]
        .into_iter()
        .flatten()
        .collect()
}

/// Rows of the maps that were followed to full contact.
fn full(rows: &[Row]) -> Vec<Row> {
    let id = |r: &Row| (r.periods, r.breadth, r.pixels, r.hurst.to_bits(), r.seed);
    rows.iter()
        .filter(|r| rows.iter().any(|o| o.load > o.closing && id(o) == id(r)))
        .copied()
        .collect()
}

/// "2.376 ± 0.010 ± 0.094"
fn with_bars(s: Slope) -> String {
    format!("{:.3} ± {:.3} ± {:.3}", s.value, s.sampling, s.grid)
}

fn number(v: Option<f64>) -> String {
    v.map_or("–".into(), |v| format!("{v:.2}"))
}

fn bandwidth_table(kinds: &[Kind]) -> String {
    let mut page = String::from(
        "### Slope against the breadth of the spectrum\n\n\
         κ ± sampling (95 %) ± grid; BGT: Bush, Gibson & Thomas for the same α at the same loads.\n\n\
         | H | side / longest wave | longest / shortest wave | points per shortest wave | maps | α | κ | BGT |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    for k in kinds {
        let hurst = if k.breadth == 1 { "–".into() } else { format!("{}", k.hurst) };
        let _ = writeln!(
            page,
            "| {hurst} | {} | {} | {} | {} | {:.1} | {} | {} |",
            k.periods,
            k.breadth,
            k.pixels,
            k.maps,
            k.bandwidth,
            with_bars(k.kappa),
            number(model_kappa("bgt", k.bandwidth))
        );
    }
    page
}

fn law_words(kinds: &[Kind], law: LogLaw) -> String {
    // The first kinds carry nearly all weight: the law through the broad spectra alone.
    let broad: Vec<Kind> = kinds.iter().filter(|k| k.bandwidth > 10.0).cloned().collect();
    let rest = log_law(&broad);
    let within = kinds.iter().filter(|k| (2.0..=2.3).contains(&k.kappa.value));
    format!(
        "Least squares, weighted by the sampling error: κ = {:.3} − ({:.3} ± {:.3} ± {:.3}) ln α, \
         ± sampling (95 %, from leaving out each seed in all kinds) ± grid; no kind of map is further \
         than {:.3} from it. Through the {} kinds with α above 10 alone the fall is {:.3} ± {:.3} ± \
         {:.3}. {} of {} kinds lie within the 2.0 to 2.3 of the literature by their value alone, {} \
         with their bars.\n",
        law.at_one,
        law.fall,
        law.sampling,
        law.grid,
        law.largest,
        broad.len(),
        rest.fall,
        rest.sampling,
        rest.grid,
        within.count(),
        kinds.len(),
        kinds
            .iter()
            .filter(|k| k.kappa.value + k.kappa.uncertainty() >= 2.0
                && k.kappa.value - k.kappa.uncertainty() <= 2.3)
            .count()
    )
}

/// Whether the Hurst exponent matters, for maps of the same longest and shortest waves.
fn hurst_words(kinds: &[Kind], law: LogLaw) -> String {
    let mut page = String::from(
        "Differences between maps of the same seed, made of the same noise; ± sampling (95 %).\n\n\
         | side / longest wave | longest / shortest wave | κ at H = 0.3 | κ at H = 0.8 | difference | \
         by the law in α |\n|---|---|---|---|---|---|\n",
    );
    for a in kinds.iter().filter(|k| (k.hurst - 0.3).abs() < 1e-9) {
        let partner = kinds.iter().find(|b| {
            (b.periods, b.breadth, b.pixels) == (a.periods, a.breadth, a.pixels)
                && (b.hurst - 0.8).abs() < 1e-9
        });
        let Some(b) = partner else { continue };
        let Some([difference, half]) = difference(a, b) else { continue };
        let by_law = -law.fall * (b.bandwidth / a.bandwidth).ln();
        let _ = writeln!(
            page,
            "| {} | {} | {:.3} | {:.3} | {} ± {half:.3} | {} |",
            a.periods,
            a.breadth,
            a.kappa.value,
            b.kappa.value,
            minus(&format!("{difference:+.3}")),
            minus(&format!("{by_law:+.3}"))
        );
    }
    page
}

fn minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

fn load_table(shown: &[&Kind]) -> String {
    let mut page = String::from("### Slope against load\n\n| p/(E\\* g) |");
    for k in shown {
        let _ = write!(page, " here, α = {:.1} | BGT, same α |", k.bandwidth);
    }
    page.push_str(" Persson |\n|---|");
    page.push_str(&"---|---|".repeat(shown.len()));
    page.push_str("---|\n");
    for load in SHOWN {
        let _ = write!(page, "| {load} |");
        for k in shown {
            let here = k.curve.iter().find(|s| (s.load / load - 1.0).abs() < 1e-9);
            let here =
                here.map_or("–".into(), |s| format!("{:.2} ± {:.2}", s.value, s.uncertainty()));
            let _ = write!(page, " {here} | {} |", number(model_slope("bgt", k.bandwidth, load)));
        }
        let _ = writeln!(page, " {} |", number(model_slope("persson", 10.0, load)));
    }
    page
}

/// One map of two kinds on grids of other fineness.
fn grid_table(rows: &[Row]) -> String {
    let mut page = String::from(
        "### One map on three grids\n\n\
         A E\\* g / p ± grid.\n\n\
         | map | p/(E\\* g) | 8 points per shortest wave | 16 | 32 |\n|---|---|---|---|---|\n",
    );
    for (periods, breadth) in [(8, 8), (2, 32)] {
        for load in [0.0025, 0.016, 0.1] {
            let cells: Vec<String> = [8, 16, 32]
                .into_iter()
                .map(|pixels| {
                    let found = rows.iter().find(|r| {
                        (r.periods, r.breadth, r.pixels, r.seed) == (periods, breadth, pixels, 1)
                            && (r.hurst - 0.8).abs() < 1e-9
                            && (r.load / load - 1.0).abs() < 1e-9
                    });
                    found.map_or("–".into(), |r| {
                        format!("{:.3} ± {:.3}", r.area / r.load, r.grid / r.load)
                    })
                })
                .collect();
            let _ = writeln!(
                page,
                "| side / longest wave {periods}, longest / shortest {breadth} | {load} | {} |",
                cells.join(" | ")
            );
        }
    }
    page
}

fn full_table(rows: &[Row]) -> String {
    let mut page = String::from(
        "### The way to full contact\n\n\
         Mean of the maps, with the smallest and largest; gap over rms height. Grid: largest half \
         width of the open fraction, of itself.\n\n\
         | p/(E\\* g) | open fraction 1 − A | grid | Persson, erfc(√2 x) | ratio | mean gap / Sq |\n\
         |---|---|---|---|---|---|\n",
    );
    let mut loads: Vec<f64> =
        rows.iter().map(|r| r.load).filter(|x| (0.09..1.81).contains(x)).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    for load in loads {
        let at: Vec<&Row> = rows.iter().filter(|r| (r.load / load - 1.0).abs() < 1e-12).collect();
        // The loads beside the closing of a map belong to that map alone.
        if at.len() < 3 {
            continue;
        }
        let open = |r: &&Row| 1.0 - r.area;
        let mean = |f: &dyn Fn(&&Row) -> f64| at.iter().map(f).sum::<f64>() / at.len() as f64;
        let low = at.iter().map(open).fold(f64::INFINITY, f64::min);
        let high = at.iter().map(open).fold(0.0, f64::max);
        let persson = 1.0 - load * model_slope("persson", 10.0, load).unwrap_or(f64::NAN);
        let _ = writeln!(
            page,
            "| {load} | {} ({} to {}) | ±{:.1} % | {} | {:.2} | {} |",
            digits(mean(&open)),
            digits(low),
            digits(high),
            100.0 * at.iter().map(|r| r.grid / open(r)).fold(0.0, f64::max),
            digits(persson),
            mean(&open) / persson,
            digits(mean(&|r| r.gap))
        );
    }
    page
}

/// Three digits, powers below a hundredth.
fn digits(v: f64) -> String {
    if v < 0.0095 { minus(&format!("{v:.2e}")) } else { format!("{v:.3}") }
}

fn closing_words(rows: &[Row]) -> String {
    let before: Vec<&Row> =
        rows.iter().filter(|r| (r.load / r.closing - 0.999).abs() < 1e-4).collect();
    let after: Vec<&Row> = rows.iter().filter(|r| r.load > r.closing).collect();
    let least = |f: &dyn Fn(&Row) -> f64| after.iter().map(|r| f(r)).fold(f64::INFINITY, f64::min);
    let most = |rows: &[&Row], f: &dyn Fn(&Row) -> f64| {
        rows.iter().map(|r| f(r)).fold(f64::NEG_INFINITY, f64::max)
    };
    let closings = (least(&|r| r.closing), most(&after, &|r| r.closing));
    format!(
        "The last gap of these {} maps closes at p/(E\\* g) = {:.2} to {:.2}, known exactly from the \
         pressure of full contact. At 0.999 of that load the solver leaves open at most {} of the \
         surface, and {} of {} maps are open; at 1.001 of it the contact fraction is {} and the mean \
         gap at most {} of the rms height. Persson's open fraction at those loads is {} to {}.\n",
        after.len(),
        closings.0,
        closings.1,
        digits(most(&before, &|r| 1.0 - r.area)),
        before.iter().filter(|r| r.area < 1.0).count(),
        before.len(),
        least(&|r| r.area),
        digits(most(&after, &|r| r.gap.abs())),
        digits(erfc_open(closings.1)),
        digits(erfc_open(closings.0)),
    )
}

/// Persson's open fraction; the difference from 1 holds down to 1e-13.
fn erfc_open(load: f64) -> f64 {
    1.0 - load * model_slope("persson", 10.0, load).unwrap_or(f64::NAN)
}
