//! Options are written under the names that commands and files use, and read back.

use contact_types::Named;
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;
use surface_stats::clean::Form;
use surface_stats::{Edges, Level};

fn is<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T, text: &str) {
    assert_eq!(serde_json::to_string(value).unwrap(), text);
    assert_eq!(&serde_json::from_str::<T>(text).unwrap(), value);
}

#[test]
fn names_are_those_of_the_command() {
    for level in Level::all() {
        is(&level, &format!("\"{}\"", level.name()));
    }
    for edges in Edges::all() {
        is(&edges, &format!("\"{}\"", edges.name()));
    }
    is(&Form::Polynomial(1), "\"plane\"");
    is(&Form::Polynomial(4), "\"polynomial:4\"");
    assert!(serde_json::from_str::<Level>("\"Plane\"").is_err());
    assert!(serde_json::from_str::<Form>("\"polynomial:13\"").is_err());
}
