//! What a validation answers.

use fft_bem_solver::validation::ValidationRow;
use serde_json::{Value, json};

/// The rows of a validation: `{"rows": [...]}`.
pub fn validated(rows: &[ValidationRow]) -> Value {
    json!({ "rows": rows.iter().map(object).collect::<Vec<_>>() })
}

fn object(row: &ValidationRow) -> Value {
    json!({
        "case": row.case,
        "source": row.source,
        "quantity": row.quantity,
        "shape": row.shape,
        "computed": row.computed,
        "exact": row.exact,
        "error": row.error,
        "uncertainty": row.uncertainty,
        "observed_order": row.observed_order,
        "expected_order": row.expected_order,
        "transforms": row.transforms,
    })
}
