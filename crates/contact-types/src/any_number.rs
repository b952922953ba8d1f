//! The value that an error refuses may be NaN or infinite. JSON has neither: they are the texts `NaN`, `inf`, `-inf`.

use serde::Serializer;

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
pub(crate) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() { to.serialize_f64(*value) } else { to.serialize_str(&value.to_string()) }
}
