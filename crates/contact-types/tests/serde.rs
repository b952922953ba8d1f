//! What is written is read back; what breaks an invariant is refused when read.

use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, Caveat, Citation, ContactModulus, ContactState, Elastic,
    FractalParameters, Grid, HeightMap, ModelError, RoughnessSpectrum, Shell, SpectralMoments,
    Wave,
};
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;

fn returns<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("a value of ours can be written");
    let back = serde_json::from_str::<T>(&text).expect("what was written can be read");
    assert_eq!(&back, value, "{text}");
}

#[test]
fn everything_comes_back() {
    let grid = Grid::new([2, 3], [1e-6, 2e-6]).unwrap();
    returns(&grid);
    returns(&HeightMap::new(grid, vec![0.1, -0.2, 1e-300, 3.0, f64::MAX, 0.0]).unwrap());
    returns(&ContactModulus::from_pascals(110e9).unwrap());
    returns(&Elastic::new(210e9, 0.3).unwrap());
    returns(&SpectralMoments { m0: 1e-12, m2: 0.02, m4: 1e9 });
    let summits =
        AsperityStatistics { density: 3e10, radius: 8e-6, height_std: 3e-7, mean_offset: 2e-7 };
    returns(&summits);
    returns(&FractalParameters { dimension: 1.3, roughness: 1e-11 });
    let shells = vec![Shell { wavenumber: 1.0, variance: 0.5 }];
    returns(&RoughnessSpectrum::new(shells).unwrap());
    let waves = vec![Wave { frequency: 1.0, amplitude: 0.5 }];
    returns(&AmplitudeSpectrum::new(waves, 2.0).unwrap());
    returns(&Citation {
        authors: String::from("Somebody").into(), // made at run time
        year: 2026,
        title: "A model".into(),
        journal: "J. 1, 2".into(),
        doi: "".into(),
    });
    returns(&ContactState {
        mean_pressure: 1e6,
        area_fraction: 0.2,
        separation: Some(1e-6),
        mean_gap: None,
        caveat: Some(Caveat::BeyondModel {
            quantity: "area fraction".into(),
            value: f64::INFINITY,
            limit: 0.1,
            reason: "contacts are no longer isolated".into(),
        }),
    });
    returns(&ModelError::OutsideDomain {
        model: String::from("mine").into(),
        quantity: "D".into(),
        value: f64::NEG_INFINITY,
        domain: 1.0..=f64::MAX,
        reason: "none".into(),
    });
    returns(&ModelError::NotConverged { model: "mine".into(), residual: 2.0, iterations: 3 });
}

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
    let back: ModelError = serde_json::from_str(&text).unwrap();
    assert!(matches!(&back, ModelError::InvalidInput { value, .. } if value.is_nan()));
    assert_eq!(back.to_string(), error.to_string());
}

#[test]
fn no_file_breaks_an_invariant() {
    for text in [
        r#"{"shape": [0, 3], "pixel": [1.0, 1.0]}"#,
        r#"{"shape": [2, 3], "pixel": [1.0, -1.0]}"#,
        r#"{"shape": [2, 3], "pixel": [1.0, 1.0], "extra": 1}"#,
    ] {
        assert!(serde_json::from_str::<Grid>(text).is_err(), "{text}");
    }
    let short = r#"{"grid": {"shape": [2, 3], "pixel": [1.0, 1.0]}, "heights": [1.0]}"#;
    let message = serde_json::from_str::<HeightMap>(short).unwrap_err().to_string();
    assert!(message.contains("6 pixels"), "{message}");
    assert!(serde_json::from_str::<ContactModulus>("-1.0").is_err());
    assert!(serde_json::from_str::<Elastic>(r#"{"young": 1e9, "poisson": 0.6}"#).is_err());
    let falling = r#"{"shells": [{"wavenumber": 2.0, "variance": 1.0},
                                 {"wavenumber": 1.0, "variance": 1.0}]}"#;
    assert!(serde_json::from_str::<RoughnessSpectrum>(falling).is_err());
}
