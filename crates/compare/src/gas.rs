//! Gases that may fill the gap of a joint.

use asperity_models::thermal_conductance::temperature_jump;
use contact_types::{ModelError, Named, require};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// What of a gas the table has.
#[derive(Debug, Clone, Copy)]
struct GasProperties {
    /// Thermal conductivity at [`TEMPERATURES`] (W/m/K): Smirnov, *Fundamentals of Ionized Gases* (2012), table 4.6.
    conductivity: [f64; 7],
    /// Specific heat c_p (J/kg/K): Karniadakis, Beskok & Aluru, *Microflows and Nanoflows* (2005), table 1.1.
    heat: f64,
    /// Prandtl number μ c_p/k, of viscosity and conductivity at 298 K in the same table.
    prandtl: f64,
    /// Ratio of specific heats of an ideal gas: 7/5 of two atoms, 5/3 of one.
    heat_ratio: f64,
}

const TEMPERATURES: [f64; 7] = [100.0, 200.0, 300.0, 400.0, 600.0, 800.0, 1000.0];
const ATMOSPHERE: f64 = 101_325.0;

/// A gas of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs, reason = "their names say it")]
pub enum Gas {
    Air,
    Helium,
    Argon,
    Nitrogen,
}

impl Named for Gas {
    const NAMES: &'static [(Self, &'static str)] = &[
        (Self::Air, "air"),
        (Self::Helium, "helium"),
        (Self::Argon, "argon"),
        (Self::Nitrogen, "nitrogen"),
    ];
}

impl Gas {
    fn row(self) -> GasProperties {
        let (conductivity, heat, viscosity, at_298, heat_ratio) = match self {
            Self::Air => ([0.95, 1.83, 2.62, 3.28, 4.69, 5.73, 6.67], 1004.5, 1.85e-5, 0.0261, 1.4),
            Self::Helium => {
                ([7.2, 11.5, 15.1, 18.4, 25.0, 30.4, 35.4], 5233.5, 1.99e-5, 0.150, 5.0 / 3.0)
            }
            Self::Argon => {
                ([0.66, 1.26, 1.77, 2.22, 3.07, 3.74, 4.36], 515.0, 2.29e-5, 0.0177, 5.0 / 3.0)
            }
            Self::Nitrogen => {
                ([0.96, 1.83, 2.59, 3.27, 4.46, 5.48, 6.47], 1038.3, 1.80e-5, 0.0260, 1.4)
            }
        };
        let conductivity = conductivity.map(|k| 0.01 * k);
        GasProperties { conductivity, heat, prandtl: viscosity * heat / at_298, heat_ratio }
    }
}

/// A gas in the gap. SI units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GapGas {
    /// Which.
    pub gas: Gas,
    /// Its temperature (K).
    #[serde(default = "room")]
    pub temperature: f64,
    /// Its pressure (Pa).
    #[serde(default = "atmosphere")]
    pub pressure: f64,
    /// Accommodation coefficients of the two walls \[-\].
    #[serde(default = "full")]
    pub accommodation: [f64; 2],
}

impl GapGas {
    /// At 25 °C and 1 atm between walls of full accommodation, at which a gas conducts most.
    pub fn new(gas: Gas) -> Self {
        Self { gas, temperature: room(), pressure: atmosphere(), accommodation: full() }
    }

    /// Refuses what is no state of the gas.
    ///
    /// # Errors
    /// [`ModelError`] of a temperature that the table does not reach, of a pressure that is not positive, of an
    /// accommodation outside (0, 1].
    pub(crate) fn check(&self) -> Result<(), ModelError> {
        const MODEL: &str = "gas in the gap";
        require::positive(MODEL, "temperature", self.temperature)?;
        require::positive(MODEL, "gas pressure", self.pressure)?;
        let domain = TEMPERATURES[0]..=TEMPERATURES[6];
        if !domain.contains(&self.temperature) {
            let reason = "the table of thermal conductivities (K) ends there";
            return Err(require::outside(MODEL, "temperature", self.temperature, domain, reason));
        }
        self.jump_length().map(drop)
    }

    /// Thermal conductivity (W/m/K), a power of the temperature between those of the table.
    pub fn conductivity(&self) -> f64 {
        let list = self.gas.row().conductivity;
        let above = TEMPERATURES.iter().position(|t| *t >= self.temperature);
        let i = above.unwrap_or(TEMPERATURES.len() - 1).max(1);
        let [low, high] = [TEMPERATURES[i - 1], TEMPERATURES[i]];
        let part = (self.temperature / low).ln() / (high / low).ln();
        list[i - 1] * (list[i] / list[i - 1]).powf(part)
    }

    /// Mean free path (m) by the viscosity `μ = Pr k/c_p`: `Λ = (μ/p) √(π R T/2)`, with which gas in a gap far below it
    /// conducts as free molecules do.
    pub fn free_path(&self) -> f64 {
        let GasProperties { heat, prandtl, heat_ratio, .. } = self.gas.row();
        let gas_constant = heat * (1.0 - 1.0 / heat_ratio);
        let viscosity = prandtl * self.conductivity() / heat;
        viscosity / self.pressure * (FRAC_PI_2 * gas_constant * self.temperature).sqrt()
    }

    /// Length of the temperature jumps at both walls, M (m); NaN of a gas that is refused.
    pub fn jump(&self) -> f64 {
        self.jump_length().unwrap_or(f64::NAN)
    }

    fn jump_length(&self) -> Result<f64, ModelError> {
        let row = self.gas.row();
        temperature_jump(self.free_path(), row.prandtl, row.heat_ratio, self.accommodation)
    }
}

fn room() -> f64 {
    298.15
}

fn atmosphere() -> f64 {
    ATMOSPHERE
}

fn full() -> [f64; 2] {
    [1.0; 2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Air at 1 bar: M of about 0.4 µm at the usual accommodation; twice the gas, half the path.
    #[test]
    fn air_is_as_known() {
        let air = GapGas { accommodation: [0.88; 2], ..GapGas::new(Gas::Air) };
        assert!((air.conductivity() / 0.0261 - 1.0).abs() < 0.01, "{}", air.conductivity());
        // 2 (2 − 0.88)/0.88 × 2 × 1.4/(0.712 × 2.4)
        assert!((air.jump() / air.free_path() / 4.17 - 1.0).abs() < 0.01, "{}", air.jump());
        let dense = GapGas { pressure: 2.0 * ATMOSPHERE, ..air };
        assert!((dense.jump() * 2.0 / air.jump() - 1.0).abs() < 1e-14);
        // 67.3 nm at 25 °C, Jennings (1988), doi:10.1016/0021-8502(88)90219-4
        assert!((air.free_path() / 67.3e-9 - 1.0).abs() < 0.01, "{}", air.free_path());
        for (i, t) in TEMPERATURES.into_iter().enumerate() {
            for gas in Gas::all() {
                let found = GapGas { temperature: t, pressure: 1e-3, ..GapGas::new(gas) };
                let row = gas.row();
                assert!((found.conductivity() / row.conductivity[i] - 1.0).abs() < 1e-14);
                // Free molecules between walls of full accommodation: (γ + 1)/(γ − 1) p √(R/(8 π T)), Kennard (1938).
                let (ratio, r) = (row.heat_ratio, row.heat * (1.0 - 1.0 / row.heat_ratio));
                let free = (ratio + 1.0) / (ratio - 1.0) * 1e-3 * (r / (8.0 * PI * t)).sqrt();
                assert!((found.conductivity() / found.jump() / free - 1.0).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn no_state_of_a_gas_is_refused() {
        let air = GapGas::new(Gas::Air);
        assert!(air.check().is_ok());
        for wrong in [
            GapGas { temperature: 0.0, ..air },
            GapGas { temperature: -3.0, ..air },
            GapGas { temperature: 99.0, ..air },
            GapGas { temperature: 1001.0, ..air },
            GapGas { pressure: 0.0, ..air },
            GapGas { pressure: f64::NAN, ..air },
            GapGas { accommodation: [1.0, 0.0], ..air },
            GapGas { accommodation: [1.1, 1.0], ..air },
        ] {
            assert!(wrong.check().is_err(), "{wrong:?}");
        }
    }
}
