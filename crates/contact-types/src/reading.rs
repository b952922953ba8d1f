//! Reading what a file says through the constructors, so that no file can break an invariant.

use crate::{
    AmplitudeSpectrum, ContactModulus, Elastic, Grid, HeightMap, RoughnessSpectrum, Shell, Wave,
};
use serde::{Deserialize, Deserializer, de::Error};

/// Reads the fields, then asks the constructor.
macro_rules! checked {
    ($($name:ident { $($field:ident: $kind:ty),+ } => $make:expr;)+) => { $(
        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                #[derive(Deserialize)]
                #[serde(deny_unknown_fields)]
                struct Fields { $($field: $kind),+ }
                let Fields { $($field),+ } = Fields::deserialize(from)?;
                $make($($field),+).map_err(D::Error::custom)
            }
        }
    )+ };
}

checked! {
    Grid { shape: [usize; 2], pixel: [f64; 2] } => Grid::new;
    HeightMap { grid: Grid, heights: Vec<f64> } => HeightMap::new;
    Elastic { young: f64, poisson: f64 } => Elastic::new;
    RoughnessSpectrum { shells: Vec<Shell> } => RoughnessSpectrum::new;
    AmplitudeSpectrum { waves: Vec<Wave>, record_length: f64 } => AmplitudeSpectrum::new;
}

impl<'de> Deserialize<'de> for ContactModulus {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Self::from_pascals(f64::deserialize(from)?).map_err(D::Error::custom)
    }
}
