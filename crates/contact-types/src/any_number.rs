//! Numbers that may be no number, in files that cannot hold those.
//!
//! An error reports the value that was refused, and that may be NaN or infinite. JSON has neither;
//! they are written as the texts `NaN`, `inf` and `-inf`.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
pub(crate) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() { to.serialize_f64(*value) } else { to.serialize_str(&value.to_string()) }
}

/// A number, or the name of what is none.
#[derive(Deserialize)]
#[serde(untagged)]
enum AnyNumber {
    Finite(f64),
    Text(String),
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    match AnyNumber::deserialize(from)? {
        AnyNumber::Finite(value) => Ok(value),
        AnyNumber::Text(text) => match text.as_str() {
            "NaN" => Ok(f64::NAN),
            "inf" => Ok(f64::INFINITY),
            "-inf" => Ok(f64::NEG_INFINITY),
            _ => Err(D::Error::custom(format!("{text:?} is no number"))),
        },
    }
}
