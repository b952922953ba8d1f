//! Defects of a measurement: a finding, a remedy to tick, its number before and after.

use crate::numbers::{count, length};
use crate::request::{Remedies, Request};
use crate::surface::{prepared, roughness};
use crate::trouble::Trouble;
use contact_compare::{Fact, SPIKE_THRESHOLD, Spikes};
use contact_front_end::{Failure, shown};
use contact_report::numbers::significant;
use contact_types::SpectralMoments;
use serde_json::{Value, json};
use surface_io::Measurement;
use surface_stats::clean::{Outliers, find_outliers, row_jumps};
use surface_stats::{SurfaceStatistics, Warning, repeats, seam_jump};

/// A tilt is worth a word from this many times the roughness on.
const TILTED: f64 = 1.0;

/// A dome is one if less than this share of the rms height is left without it.
const DOMED: f64 = 0.5;

/// The spikes of a map as measured: what the words count and the picture rings.
pub(crate) fn spikes(measured: &Measurement) -> Result<Outliers, Trouble> {
    find_outliers(measured.grid(), measured.heights(), SPIKE_THRESHOLD)
        .map_err(|e| Failure::from(&e).into())
}

/// Defects with a remedy, worst first.
pub(crate) fn of(
    measured: &Measurement,
    spikes: &Outliers,
    request: &Request,
) -> Result<Vec<Value>, Trouble> {
    let (grid, heights) = (measured.grid(), measured.heights());
    let remedies = &request.remedies;
    let mut remedied = Remedied { measured, request, known: Vec::new() };
    let mut defects = Vec::new();
    // With the other remedies as they are, the numbers without this one and with it.
    let mut add = |tag, claim: String, text: &str, key, label, numbers: Option<[Value; 2]>| {
        defects.push(json!({
            "tag": tag, "claim": claim, "text": text, "key": key, "label": label,
            "ticked": remedies.has(key), "fill": (key == "fill").then_some(&remedies.fill),
            "numbers": numbers,
        }));
    };
    if !spikes.indices.is_empty() {
        let numbers = remedied.both("spikes")?;
        let claim = match spikes.indices.len() {
            1 => "1 spike.".to_owned(),
            n => format!("{} spikes.", count(n)),
        };
        let [limit, largest] = [spikes.limit, spikes.largest].map(length);
        let text = format!(
            "Points more than {limit} off their neighbours, the farthest {largest}. Optics make such points, machining does not."
        );
        add("check", claim, &text, "spikes", "Remove and fill", Some(numbers));
    }
    let mut rms = |plane, dome| -> Result<f64, Trouble> {
        Ok(remedied.but(|r| (r.plane, r.dome) = (plane, dome))?.rms_height())
    };
    let [flat, domed, tilted] = [rms(true, false)?, rms(true, true)?, rms(false, false)?];
    if tilted > (1.0 + TILTED) * flat {
        let text = format!(
            "The plane in it is {} times the roughness. How the part lay in the instrument is no roughness.",
            significant((tilted * tilted - flat * flat).sqrt() / flat, 2)
        );
        let numbers = remedied.both("plane")?;
        add("check", "Tilt.".to_owned(), &text, "plane", "Take the plane off", Some(numbers));
    }
    if remedies.dome || domed < DOMED * flat {
        let numbers = remedied.both("dome")?;
        let text = "A dome or a saddle is left under the roughness. If it is machined, keep it; if the part is held flat, \
                    take it off.";
        add("note", "Form.".to_owned(), text, "dome", "Take the dome off", Some(numbers));
    }
    if measured.missing() > 0 {
        let share = shown::percent(measured.missing() as f64 / heights.len() as f64);
        let claim = format!("{} points are missing ({share}).", count(measured.missing()));
        let text = "Heights stand there that nobody measured: a smooth surface through the rims, or the nearest point.";
        add("note", claim, text, "fill", "Fill", None);
    }
    let (_, jump, warning) = row_jumps(grid, heights).map_err(|e| Failure::from(&e))?;
    if remedies.rows || warning.is_some() {
        let numbers = remedied.both("rows")?;
        let claim = format!("Scan lines: rows jump by {} rms.", length(jump));
        let text = "Slopes across them are those of the scan, not of the surface.";
        add("check", claim, text, "rows", "Put the rows in line", Some(numbers));
    }
    let map = prepared(measured, request)?;
    if remedies.mirror || !repeats(&map) {
        let jump = seam_jump(&map);
        let text = "Repeated as it is, the map has a step there, and the solution presses on it. Mirrored it has none.";
        let claim =
            format!("Edges do not match: they jump {} times the inner step.", significant(jump, 2));
        let cost = [json!(["as many points"]), json!(["4 times the points and the time"])];
        add("note", claim, text, "mirror", "Mirror the map", Some(cost));
    }
    defects.sort_by_key(|d| d["tag"] != "check");
    Ok(defects)
}

/// The roughness of a map with one set of remedies and another, each found once.
struct Remedied<'a> {
    measured: &'a Measurement,
    request: &'a Request,
    known: Vec<(Remedies, SpectralMoments)>,
}

impl Remedied<'_> {
    /// With the remedies as ticked but for this change.
    fn but(&mut self, change: impl FnOnce(&mut Remedies)) -> Result<SpectralMoments, Trouble> {
        let mut asked = self.request.clone();
        change(&mut asked.remedies);
        if let Some((_, known)) = self.known.iter().find(|(with, _)| *with == asked.remedies) {
            return Ok(*known);
        }
        let found = roughness(&prepared(self.measured, &asked)?)?;
        self.known.push((asked.remedies, found));
        Ok(found)
    }

    /// Without this remedy, and with it.
    fn both(&mut self, key: &str) -> Result<[Value; 2], Trouble> {
        let shown = |found: SpectralMoments| {
            let gradient = significant(found.rms_gradient(), 3);
            json!([format!("Sq {}", length(found.rms_height())), format!("Sdq {gradient}")])
        };
        Ok([shown(self.but(|r| r.set(key, false))?), shown(self.but(|r| r.set(key, true))?)])
    }
}

/// What the statistics of a map say, but for what has a remedy above.
pub(crate) fn beyond(statistics: &SurfaceStatistics) -> Value {
    use Warning::{EdgeJump, RowsJump, Tilted};
    let mut found = contact_compare::measured(statistics, &Spikes::default(), None, None);
    found.retain(|f| {
        !matches!(f.fact, Fact::Warned(Tilted { .. } | RowsJump { .. } | EdgeJump { .. }))
    });
    contact_report::findings_json(&found)
}
