//! Everything a user can choose about a study, and `run.toml`, from which it can be repeated.

use crate::{
    Card, GapGas, Joint, MaterialUse, Origin, Registry, StudyError, Theory, WorkOfAdhesion,
};
use contact_accuracy::{Axis, Setup};
use contact_types::{ContactModulus, Named};
use fft_bem_solver::{Method, Precision, Solver, SolverBuilder};
use serde::{Deserialize, Serialize};
use surface_stats::Level;

/// Settings of a study. SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Contact modulus E* (Pa).
    pub modulus: f64,
    /// Hardness of the softer body (Pa), the highest pressure it bears: the contact is then that of bodies
    /// that yield there. Absent: elastic bodies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardness: Option<f64>,
    /// Electrical resistivity of both bodies (Ω m): what the contact conducts is found too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resistivities: Option<[f64; 2]>,
    /// Thermal conductivity of both bodies (W/m/K): the same for heat.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub conductivities: Option<[f64; 2]>,
    /// A gas in the gap, whose conductance is added to that of the contact; absent: vacuum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gas: Option<GapGas>,
    /// The leak through the gap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub leak: Option<LeakRequest>,
    /// Work of adhesion: whether the bodies stick is said, by formulas.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adhesion: Option<WorkOfAdhesion>,
    /// Weight γ of partial contact in Persson's mean gap, 0.01 to 1; absent: that of Yang and Persson, 0.45.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gamma: Option<f64>,
    /// Materials of the [table](crate::materials()) whose numbers are among these.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub materials: Vec<MaterialUse>,
    /// The elastic bodies it is made of, if they are known: one against a rigid flat, or two.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<Body>,
    /// Nominal pressures (Pa); absent: chosen per surface, see [`loads_of_study`](crate::loads_of_study).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressures: Option<Vec<f64>>,
    /// Nominal area that the pressures carry (m²), if they were given as forces on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_area: Option<f64>,
    /// Pressure the headline and the maps are for (Pa), one of the pressures computed; absent:
    /// the one whose contact is nearest to 2 % of the surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub headline: Option<f64>,
    /// Form removed before everything else: `none`, `mean`, `plane` or `quadratic`.
    pub level: Level,
    /// What lies beyond the edges of a map: `periodic`, the map again, or `mirrored`, its mirror
    /// images.
    #[serde(default)]
    pub edges: EdgesName,
    /// Solver method: `auto`, `chord`, `polonsky-keer` or `stanley-kato`.
    pub method: Method,
    /// Uncertainty of the area to stay within, relative to it, as 0.02. If given, grid, precision and
    /// tolerance are chosen for each surface, and the two below are not used.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<f64>,
    /// Every second point of the map at once, with its wider uncertainty.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub fast: bool,
    /// Floating-point precision of the solver: `f64` or `f32`.
    pub precision: Precision,
    /// Relative rms pressure error at which the solver stops.
    pub tolerance: f64,
    /// Threads that the study may use, its solvers among them.
    pub threads: usize,
    /// Names of the models to ask, of the [`Registry`] of the study; absent: every one that a height
    /// map gives all it needs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub models: Option<Vec<String>>,
    /// Wavelengths `[shortest, longest]` between which the fractal dimension is fitted (m);
    /// absent: chosen from the spectrum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fractal_range: Option<[f64; 2]>,
}

impl Default for Settings {
    /// Steel on steel, plane removed from maps that do not repeat, loads chosen from the surface.
    fn default() -> Self {
        Self {
            modulus: STEEL_ON_STEEL,
            hardness: None,
            resistivities: None,
            conductivities: None,
            gas: None,
            leak: None,
            adhesion: None,
            gamma: None,
            materials: Vec::new(),
            bodies: Vec::new(),
            pressures: None,
            load_area: None,
            headline: None,
            level: Level::default(),
            edges: EdgesName::Periodic,
            method: Method::Auto,
            accuracy: None,
            fast: false,
            precision: Precision::Double,
            tolerance: 1e-4,
            threads: 1,
            models: None,
            fractal_range: None,
        }
    }
}

impl Settings {
    /// What is asked of the conduction.
    pub fn joint(&self) -> Joint {
        Joint {
            resistivities: self.resistivities,
            conductivities: self.conductivities,
            gas: self.gas,
            area: self.load_area,
            hardness: self.hardness,
        }
    }

    /// The solver that is asked for, of bodies that yield if a hardness is given.
    pub fn solver(&self) -> SolverBuilder {
        let builder = Solver::builder().method(self.method).precision(self.precision);
        builder.tolerance(self.tolerance).hardness(self.hardness.unwrap_or(f64::INFINITY))
    }

    /// How a map is solved by this solver, with all that is asked.
    pub fn setup(&self, solver: SolverBuilder, modulus: ContactModulus) -> Setup {
        Setup {
            mirrored: self.edges == EdgesName::Mirrored,
            jump: self.gas.map(|gas| gas.jump()),
            leak: self.leak.map_or_else(Vec::new, |leak| leak.along.axes().to_vec()),
            stiffness: self.joint().is_asked(),
            ..Setup::new(solver, modulus)
        }
    }

    /// The theories to ask, in the order of the registry.
    pub(crate) fn asked_models<'a>(
        &'a self,
        registry: &'a Registry,
    ) -> impl Iterator<Item = &'a dyn Theory> {
        let asked =
            |name: &str| self.models.as_ref().is_none_or(|names| names.iter().any(|n| n == name));
        // A theory of bodies that yield has no place beside elastic ones, unless it was named.
        let has_use =
            |card: &Card| !card.yields || self.hardness.is_some() || self.models.is_some();
        registry
            .of_studies()
            .filter(move |theory| asked(&theory.card().name) && has_use(theory.card()))
    }
}

/// Poisson's ratio of bodies, the mean of two \[-\]; 0.3 if they are not known.
pub fn poisson(bodies: &[Body]) -> f64 {
    match bodies {
        [] => 0.3,
        bodies => bodies.iter().map(|b| b.poisson).sum::<f64>() / bodies.len() as f64,
    }
}

/// An elastic body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Young's modulus (Pa).
    pub young: f64,
    /// Poisson's ratio (-).
    pub poisson: f64,
}

/// Steel.
pub const STEEL: Body = Body { young: 210e9, poisson: 0.3 };

/// E* of two steel bodies, `E / (2 (1 - nu^2))` with E = 210 GPa and nu = 0.3 (Pa).
pub(crate) const STEEL_ON_STEEL: f64 = 210e9 / (2.0 * (1.0 - 0.3 * 0.3));

/// What the solver puts beyond the edges of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EdgesName {
    /// The map again, with the jump of one that does not repeat.
    #[default]
    Periodic,
    /// Its mirror images: no jump, four times the points.
    Mirrored,
}

impl Named for EdgesName {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Periodic, "periodic"), (Self::Mirrored, "mirrored")];
}

/// Directions of the pressure drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Along {
    /// From the first column to the last.
    X,
    /// From the first row to the last.
    Y,
    /// Each of the two.
    Both,
}

impl Named for Along {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::X, "x"), (Self::Y, "y"), (Self::Both, "both")];
}

impl Along {
    /// The axes.
    pub fn axes(self) -> &'static [Axis] {
        match self {
            Self::X => &[Axis::X],
            Self::Y => &[Axis::Y],
            Self::Both => &[Axis::X, Axis::Y],
        }
    }
}

/// What is asked of the leak.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LeakRequest {
    /// Directions of the pressure drop.
    pub along: Along,
    /// The seal and its fluid, for a rate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seal: Option<Seal>,
}

/// A seal and its fluid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seal {
    /// Viscosity η (Pa s).
    pub viscosity: f64,
    /// Pressure drop Δp (Pa).
    pub pressure_drop: f64,
    /// Length L of the way through the seal (m).
    pub length: f64,
    /// Width W across the flow (m).
    pub width: f64,
}

impl Seal {
    /// Leak rate Q = K W Δp/(12 η L) (m³/s) of a permeability (m³).
    pub fn rate(&self, permeability: f64) -> f64 {
        permeability * self.width * self.pressure_drop / (12.0 * self.viscosity * self.length)
    }
}

/// Nominal pressures for a surface nobody chose loads for, in Pa, rising.
///
/// The load that matters is `p / (E* h'_rms)`: the real area fraction is about twice it while
/// contact is light. The loads run from 4e-4 (about 0.1 % of the surface touches) to 0.4 (about
/// half of it), five to a decade, and are the preferred numbers 1, 1.6, 2.5, 4, 6.3 of ISO 3
/// (series R5), so that a reader meets 10 MPa and not 9.73 MPa: 15 loads, log-spaced within 1 %.
///
/// A flat surface has no scale of its own; it is asked at one pressure, 1e-3 E*.
pub(crate) fn default_pressures(modulus: f64, rms_gradient: f64) -> Vec<f64> {
    const R5: [f64; 5] = [1.0, 1.6, 2.5, 4.0, 6.3];
    let scale = modulus * rms_gradient;
    if !(scale.is_finite() && scale > 0.0) {
        return vec![1e-3 * modulus];
    }
    let first = (4e-4 * scale).log10().floor() as i32;
    let last = (0.4 * scale).log10().ceil() as i32;
    // Rounded for the decimal that a reader would type.
    let decimal = |mantissa: f64, decade: i32| format!("{mantissa}e{decade}").parse::<f64>().ok();
    (first..=last)
        .flat_map(|decade| R5.iter().filter_map(move |&mantissa| decimal(mantissa, decade)))
        .filter(|p| (4e-4 * scale..0.4 * scale).contains(p))
        .collect()
}

/// The content of `run.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunFile {
    /// Version of the program that wrote it.
    pub program: String,
    /// Settings of the study.
    pub settings: Settings,
    /// The surfaces in order.
    #[serde(rename = "surface")]
    pub surfaces: Vec<RunSurface>,
}

/// One surface of `run.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunSurface {
    /// Name in the report.
    pub name: String,
    /// Where it comes from.
    pub origin: Origin,
}

impl RunFile {
    /// Of a study of these surfaces, by name and origin, with this program.
    pub fn of<'a>(
        settings: &Settings,
        surfaces: impl IntoIterator<Item = (&'a String, &'a Origin)>,
    ) -> Self {
        let surface = |(name, origin): (&String, &Origin)| RunSurface {
            name: name.clone(),
            origin: origin.clone(),
        };
        Self {
            program: env!("CARGO_PKG_VERSION").to_owned(),
            settings: settings.clone(),
            surfaces: surfaces.into_iter().map(surface).collect(),
        }
    }

    /// Reads a run file.
    ///
    /// # Errors
    /// [`StudyError::Syntax`], [`StudyError::Given`] and [`StudyError::NoSurface`].
    pub fn parse(text: &str) -> Result<Self, StudyError> {
        let file: Self = toml::from_str(text)?;
        if file.surfaces.is_empty() {
            return Err(StudyError::NoSurface);
        }
        let is_given = |s: &&RunSurface| s.origin.is_given();
        if let Some(given) = file.surfaces.iter().find(is_given) {
            return Err(StudyError::Given(given.name.clone()));
        }
        Ok(file)
    }

    /// The file as text.
    ///
    /// # Errors
    /// If a value has no TOML form, as an integer beyond 2^63 - 1 for a seed.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_loads_are_round_rising_and_span_three_decades() {
        for (modulus, gradient) in [(115e9, 0.1), (2e6, 0.3), (70e9, 1e-3), (1.0, 1.0)] {
            let loads = default_pressures(modulus, gradient);
            assert!(loads.len() == 15, "{} loads", loads.len());
            assert!(loads.windows(2).all(|w| (1.5..1.61).contains(&(w[1] / w[0]))));
            assert!(loads[0] / (modulus * gradient) < 6.4e-4);
            assert!(loads[14] / (modulus * gradient) > 0.249);
        }
        assert!(default_pressures(115e9, 0.1).contains(&1e7));
        assert_eq!(default_pressures(1e9, 0.0), [1e6]);
    }
}
