//! validate compares with exact solutions and says at what order the error falls.

use crate::cli::{folder, list, number};
use serde_json::Value;

#[test]
fn errors_fall_at_the_expected_order() {
    let at = &folder();
    let object = at.answer("validate --quiet");
    let rows = list(&object["rows"]);
    for case in ["Hertz", "Westergaard", "bi-sinusoid", "full contact"] {
        let named = |row: &&Value| {
            row["case"].to_string().contains(case) || row["source"].to_string().contains(case)
        };
        let finest = rows.iter().rfind(named).unwrap_or_else(|| panic!("no {case}"));
        assert!(number(&finest["error"]).abs() < 0.01, "{finest}");
    }
    let is_finest = |row: &&Value| row["shape"][1] == 256 || row["shape"][1] == 4096;
    let ordered = rows.iter().filter(is_finest).filter(|row| !row["expected_order"].is_null());
    assert!(ordered.clone().count() > 8);
    for row in ordered {
        let (observed, expected) = (number(&row["observed_order"]), number(&row["expected_order"]));
        // At least: an error that happens to change sign on the finest grid falls faster.
        assert!(observed > expected - 0.3, "{row}");
    }
    at.refuses("validate --finest 4", &["4", "32"]);
}
