//! What a page over many maps keeps of each study, and how such numbers are spread.

use serde_json::{Map, Value, json};

/// What is kept of one surface of `results.json`: its headline, its curve, what each model was wrong by.
///
/// Keys as there; `curve` is `[[mean_pressure (Pa), area_fraction], …]`, `models` has under
/// the name of each `area_error` (of the headline, signed, relative), `mean_absolute_area_error` (over the
/// loads) and `verdict`; `checks` has `kind` and `claim` of
/// each finding that is to be checked; `load` is that of the headline, if loads are forces (N).
pub fn digest(surface: &Value) -> Value {
    let at = |way: &str| surface.pointer(way).cloned().unwrap_or(Value::Null);
    let mut row = Map::new();
    let statistics =
        "shape pixel rms_height skewness kurtosis rms_gradient bandwidth hurst height_step missing";
    for key in statistics.split(' ') {
        row.insert(key.into(), at(&format!("/statistics/{key}")));
    }
    let empty = Vec::new();
    let points = surface["deterministic"]["points"].as_array().unwrap_or(&empty);
    let same = |p: &&Value| p["mean_pressure"] == surface["headline_pressure"];
    let headline = points.iter().find(same).unwrap_or(&Value::Null);
    let of_load =
        "mean_pressure area_fraction area_interval real_pressure mean_gap max_pressure converged";
    for key in of_load.split(' ') {
        row.insert(key.into(), headline.get(key).cloned().unwrap_or(Value::Null));
    }
    if surface["headline_load"].is_number() {
        row.insert("load".into(), at("/headline_load"));
    }
    row.insert("against".into(), at("/pair/second/name"));
    row.insert("modulus".into(), at("/deterministic/modulus"));
    row.insert("contact_spots".into(), at("/contact_spots/count"));
    row.insert("median_spot_area".into(), at("/contact_spots/median_area"));
    row.insert("largest_spot_area".into(), at("/contact_spots/largest_area"));
    let seconds: f64 = points.iter().filter_map(|p| p["seconds"].as_f64()).sum();
    row.insert("seconds".into(), json!(seconds));
    let is_check = |f: &&Value| f["weight"] == "check";
    let all = surface["findings"].as_array().unwrap_or(&empty);
    let check = |f: &Value| json!({ "kind": kind(f), "claim": f["claim"] });
    let checks: Vec<Value> = all.iter().filter(is_check).map(check).collect();
    row.insert("to_check".into(), json!(checks.len()));
    row.insert("checks".into(), json!(checks));
    let curve = points.iter().map(|p| json!([p["mean_pressure"], p["area_fraction"]]));
    row.insert("curve".into(), curve.collect());
    let mut models = Map::new();
    for model in surface["models"].as_array().unwrap_or(&empty) {
        let Some(name) = model["model"].as_str() else { continue };
        let entry = json!({
            "area_error": model["area_error"]["headline"],
            "mean_absolute_area_error": model["area_error"]["mean_absolute"],
            "verdict": model["verdict"],
        });
        models.insert(name.into(), entry);
    }
    row.insert("models".into(), Value::Object(models));
    Value::Object(row)
}

/// The name of what a finding is about.
fn kind(finding: &Value) -> String {
    let name = |value: &Value| match value {
        Value::Object(fact) => fact.keys().next().cloned(),
        other => other.as_str().map(str::to_owned),
    };
    let kind = name(&finding["fact"]).unwrap_or_default();
    let fact = &finding["fact"][&kind];
    // What a map says of one advice and of another is counted apart.
    let inner = match kind.as_str() {
        "warned" if fact["Noisy"]["step"].is_number() => Some("Stepped".to_owned()),
        "warned" if fact["Flat"]["rms_height"].as_f64() > Some(0.0) => Some("Rounding".to_owned()),
        "warned" => name(fact),
        "no_uncertainty" if fact["why"]["NotConverged"]["at_rounding"] == true => {
            Some("AtRounding".to_owned())
        }
        "no_uncertainty" => name(&fact["why"]),
        "unit" if fact["hardness"].is_array() => Some("odd_hardness".to_owned()),
        _ => None,
    };
    inner.unwrap_or(kind)
}

/// How numbers are spread: their order and what is read off it.
pub(crate) struct Quantiles {
    pub sorted: Vec<f64>,
}

impl Quantiles {
    /// Of the finite ones; `None` if there are none.
    pub(crate) fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        (!sorted.is_empty()).then_some(Self { sorted })
    }

    /// The number below which the share `part` of them lies: straight between neighbours
    /// (Hyndman and Fan 1996, definition 7, doi:10.1080/00031305.1996.10473566).
    pub(crate) fn quantile(&self, part: f64) -> f64 {
        let place = part.clamp(0.0, 1.0) * (self.sorted.len() - 1) as f64;
        let below = place.floor() as usize;
        let above = (below + 1).min(self.sorted.len() - 1);
        let (a, b) = (self.sorted[below], self.sorted[above]);
        a + (b - a) * (place - below as f64)
    }

    pub(crate) fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// "median 1, 10th–90th percentile 0.2 to 3".
    pub(crate) fn words(&self, shown: impl Fn(f64) -> String) -> String {
        let [low, median, high] = [0.1, 0.5, 0.9].map(|part| shown(self.quantile(part)));
        format!("median {median}, 10th–90th percentile {low} to {high}")
    }

    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.sorted[0], self.sorted[self.sorted.len() - 1]]
    }

    /// True if a logarithmic axis suits them: all positive, and over more than a factor of eight.
    pub(crate) fn is_wide(&self) -> bool {
        let [low, high] = self.ends();
        low > 0.0 && high > 8.0 * low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_r() {
        // quantile(c(1, 2, 4, 8, 16), c(0, .1, .25, .5, .9, 1)) of R 4: 1, 1.4, 2, 4, 12.8, 16
        let spread = Quantiles::of([8.0, 1.0, f64::NAN, 16.0, 2.0, 4.0].into_iter()).unwrap();
        for (part, value) in
            [(0.0, 1.0), (0.1, 1.4), (0.25, 2.0), (0.5, 4.0), (0.9, 12.8), (1.0, 16.0)]
        {
            assert!((spread.quantile(part) - value).abs() < 1e-12, "{part}");
        }
        assert!(spread.is_wide() && Quantiles::of([f64::NAN].into_iter()).is_none());
    }

    #[test]
    fn the_headline_is_read_off_its_own_load() {
        let surface = json!({
            "statistics": { "rms_height": 1e-7 }, "headline_pressure": 2e6,
            "deterministic": { "modulus": 1e11, "points": [
                { "mean_pressure": 1e6, "area_fraction": 0.01, "seconds": 1.0 },
                { "mean_pressure": 2e6, "area_fraction": 0.02, "seconds": 2.0 },
            ] },
            "models": [{ "model": "gw", "area_error": { "headline": -0.2, "mean_absolute": 0.3 }, "verdict": "caution" }],
            "findings": [{ "weight": "check", "claim": "It jumps.", "fact": { "edge_jump": 3.5 } }, { "weight": "note" }],
        });
        let row = digest(&surface);
        assert_eq!(row["area_fraction"], 0.02);
        assert_eq!(row["seconds"], 3.0);
        assert_eq!(row["to_check"], 1);
        assert_eq!(row["checks"], json!([{ "kind": "edge_jump", "claim": "It jumps." }]));
        let why = |at_rounding: bool| json!({ "NotConverged": { "at_rounding": at_rounding } });
        for (fact, expected) in [
            (json!({ "no_uncertainty": { "loads": 1, "why": why(false) } }), "NotConverged"),
            (json!({ "no_uncertainty": { "loads": 1, "why": why(true) } }), "AtRounding"),
            (json!({ "unit": { "hardness": null } }), "unit"),
            (json!({ "unit": { "hardness": [1, 2, 3] } }), "odd_hardness"),
            (json!({ "warned": { "Flat": { "rms_height": 0.0 } } }), "Flat"),
            (json!({ "warned": { "Flat": { "rms_height": 1e-12 } } }), "Rounding"),
            (json!({ "warned": { "Noisy": { "step": null } } }), "Noisy"),
            (json!({ "warned": { "Noisy": { "step": 1e-8 } } }), "Stepped"),
        ] {
            assert_eq!(kind(&json!({ "fact": fact })), expected);
        }
        assert_eq!(row["models"]["gw"]["area_error"], -0.2);
        assert_eq!(row["curve"], json!([[1e6, 0.01], [2e6, 0.02]]));
    }
}
