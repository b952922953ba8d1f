//! What is written as JSON.

use contact_types::ModelError;

/// NaN, which JSON has not, is what an error most often reports.
#[test]
fn an_error_keeps_the_value_that_was_refused() {
    let error = ModelError::InvalidInput {
        model: "mine".into(),
        quantity: "mean pressure".into(),
        value: f64::NAN,
        requirement: "must be finite".into(),
    };
    let text = serde_json::to_string(&error).unwrap();
    assert!(text.contains(r#""kind":"invalid_input""#), "{text}");
    assert!(text.contains(r#""value":"NaN""#), "{text}");
}
