//! validate compares with exact solutions and says at what order the error falls.

use crate::cli;

use cli::{folder, number, refused, rough_contact};

#[test]
fn errors_fall_at_the_expected_order() {
    let dir = folder();
    let object = rough_contact(dir.path(), "validate --quiet --json").answered();
    let rows = object["rows"].as_array().unwrap();
    for case in ["Hertz", "Westergaard", "bi-sinusoid", "full contact"] {
        let named = |row: &&serde_json::Value| {
            row["case"].to_string().contains(case) || row["source"].to_string().contains(case)
        };
        let finest = rows.iter().rfind(named).unwrap_or_else(|| panic!("no {case}"));
        assert!(number(&finest["error"]).abs() < 0.01, "{finest}");
    }
    let ordered: Vec<_> = rows
        .iter()
        .filter(|row| row["shape"][1] == 256 || row["shape"][1] == 4096)
        .filter(|row| !row["expected_order"].is_null())
        .collect();
    assert!(ordered.len() > 8);
    for row in ordered {
        let (observed, expected) = (number(&row["observed_order"]), number(&row["expected_order"]));
        // At least: an error that happens to change sign on the finest grid falls faster.
        assert!(observed > expected - 0.3, "{row}");
    }
    refused(dir.path(), "validate --finest 4", 2, &["4", "32"]);
}
