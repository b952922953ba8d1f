//! validate compares with exact solutions; at what order the errors fall is tested in `fft-bem-solver`.

use crate::cli::{folder, list, number};
use serde_json::Value;

#[test]
fn every_case_is_compared() {
    let at = &folder();
    let object = at.answer("validate --quiet --finest 64");
    for case in ["Hertz", "Westergaard", "bi-sinusoid", "full contact"] {
        let named = |row: &&Value| {
            row["case"].to_string().contains(case) || row["source"].to_string().contains(case)
        };
        let finest = list(&object["rows"]).iter().rfind(named);
        let finest = finest.unwrap_or_else(|| panic!("no {case}"));
        assert!(number(&finest["error"]).abs() < 0.01, "{finest}");
    }
    at.refuses("validate --finest 4", &["4", "32"]);
}
