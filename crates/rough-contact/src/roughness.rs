//! What a model is made from: typed numbers, or the statistics of a surface file.

use crate::args::{self, List};
use crate::input::Complete;
use crate::outcome::Failure;
use clap::{Args, ValueEnum};
use compare::Inputs;
use compare::Level;
use contact_types::{
    AsperityStatistics, ContactModulus, FractalParameters, ModelError, SpectralMoments,
};
use multiscale_models::{SelfAffineSpectrum, SphereLevel};
use std::f64::consts::TAU;
use std::path::Path;

/// Roughness typed in.
#[derive(Args)]
#[command(next_help_heading = "Roughness, typed in instead of FILE")]
pub(crate) struct Source {
    /// Mean square height (profile moment), such as 0.2um^2
    #[arg(long, value_name = "M0", value_parser = args::area, allow_hyphen_values = true)]
    m0: Option<f64>,
    /// Mean square slope of a profile, a pure number
    #[arg(long, value_name = "M2", value_parser = args::number, allow_hyphen_values = true)]
    m2: Option<f64>,
    /// Mean square second derivative of a profile, such as 1e9m^-2
    #[arg(long, value_name = "M4", value_parser = args::per_area, allow_hyphen_values = true)]
    m4: Option<f64>,
    /// Asperities per area, such as 3e10m^-2
    #[arg(long, value_name = "N", value_parser = args::per_area, allow_hyphen_values = true)]
    asperity_density: Option<f64>,
    /// Radius of the asperities
    #[arg(long, value_name = "R", value_parser = args::length, allow_hyphen_values = true)]
    asperity_radius: Option<f64>,
    /// Standard deviation of the asperity heights
    #[arg(long, value_name = "S", value_parser = args::length, allow_hyphen_values = true)]
    asperity_height_std: Option<f64>,
    /// Mean asperity height above the mean plane of the surface [default: 0]
    #[arg(long, value_name = "Y", value_parser = args::length, allow_hyphen_values = true)]
    mean_offset: Option<f64>,
    /// Hurst exponent of a self-affine spectrum
    #[arg(long, value_name = "H", value_parser = args::number, allow_hyphen_values = true)]
    hurst: Option<f64>,
    /// Longest wavelength of its power law
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    rolloff: Option<f64>,
    /// Shortest wavelength
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    cutoff: Option<f64>,
    /// Longest wavelength, of a plateau above --rolloff [default: no plateau]
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    longest: Option<f64>,
    /// Weight of partial contact in Persson's mean gap: 1 (2007) or 0.45 (2008)
    #[arg(long, value_name = "G", value_parser = args::number, allow_hyphen_values = true)]
    gamma: Option<f64>,
    /// Largest amplitude over wavelength, B_max
    #[arg(long, value_name = "B", value_parser = args::number, allow_hyphen_values = true)]
    max_amplitude_ratio: Option<f64>,
    /// Length of the profiles whose amplitudes are taken [default: longest wavelength]
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    record_length: Option<f64>,
    /// Fractal dimension of a profile, between 1 and 2
    #[arg(long, value_name = "D", value_parser = args::number, allow_hyphen_values = true)]
    dimension: Option<f64>,
    /// Fractal roughness G
    #[arg(long, value_name = "G", value_parser = args::length, allow_hyphen_values = true)]
    roughness: Option<f64>,
    /// Nominal area; with --load the area that carries it
    #[arg(long, value_name = "A", value_parser = args::area, allow_hyphen_values = true)]
    area: Option<f64>,
    /// Spots larger than this are elastic, smaller ones are not counted
    #[arg(long, value_name = "A", value_parser = args::area, allow_hyphen_values = true)]
    critical_area: Option<f64>,
    /// Hardness of the softer body, for models of bodies that yield
    #[arg(long, value_name = "H", value_parser = args::pressure, allow_hyphen_values = true)]
    hardness: Option<f64>,
    /// Radii of the spheres of each level, coarse to fine, such as 1mm,10um
    #[arg(long, value_name = "LIST", value_parser = args::lengths, allow_hyphen_values = true)]
    sphere_radius: Option<List>,
    /// Spheres per area of each level, coarse to fine, such as 1mm^-2,1e4mm^-2
    #[arg(long, value_name = "LIST", value_parser = args::per_areas, allow_hyphen_values = true)]
    sphere_density: Option<List>,
    /// Form to remove from a FILE by least squares first [default: plane]
    #[arg(long, value_name = "FORM", value_parser = args::level())]
    level: Option<Level>,
    /// What lies beyond the edges of a FILE [default: open]
    #[arg(long, value_enum)]
    boundary: Option<Edges>,
}

/// What lies beyond the edges when slopes and curvatures are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Edges {
    Open,
    Periodic,
}

impl Edges {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Periodic => "periodic",
        }
    }

    pub(crate) fn rule(self) -> surface_stats::Edges {
        match self {
            Self::Open => surface_stats::Edges::Open,
            Self::Periodic => surface_stats::Edges::Periodic,
        }
    }
}

const MOMENTS: &str = "--m0 --m2 --m4";
const SELF_AFFINE: &str = "--hurst --rolloff --cutoff --m0 [--longest]";
const ASPERITIES: &str =
    "--asperity-density --asperity-radius --asperity-height-std [--mean-offset]";

/// The sets of options a model can be made from, the first the usual one.
pub(crate) fn options_of(model: &str) -> Vec<&'static str> {
    match model {
        "gw" => vec![MOMENTS, ASPERITIES, SELF_AFFINE],
        "persson" => vec!["--hurst --rolloff --cutoff --m0 [--longest] [--gamma]", "--m2"],
        "stacked" => vec![
            "--max-amplitude-ratio",
            "--hurst --rolloff --cutoff --m0 [--longest] [--record-length]",
        ],
        "multiscale" => vec!["--hurst --rolloff --cutoff --m0 [--longest] [--record-length]"],
        "archard" => vec!["--sphere-radius --sphere-density"],
        "majumdar-bhushan" => vec!["--dimension --roughness --area [--critical-area]"],
        "ceb" => vec![
            "--hardness --m0 --m2 --m4",
            "--hardness --asperity-density --asperity-radius --asperity-height-std [--mean-offset]",
            "--hardness --hurst --rolloff --cutoff --m0 [--longest]",
        ],
        "persson-yield" => vec![
            "--hardness --m0 --m2 --m4",
            "--hardness --hurst --rolloff --cutoff --m0 [--longest]",
        ],
        _ => vec![MOMENTS, SELF_AFFINE],
    }
}

impl Source {
    /// The inputs of `model` from the numbers typed in.
    pub(crate) fn typed(&self, model: &str, modulus: ContactModulus) -> Result<Inputs, Failure> {
        let mut inputs = Inputs::new(modulus);
        inputs.gamma = self.gamma;
        inputs.max_amplitude_ratio = self.max_amplitude_ratio;
        inputs.nominal_area = self.area;
        inputs.critical_area = self.critical_area;
        inputs.hardness = self.hardness;
        inputs.asperities = self.asperities()?;
        inputs.spheres = self.spheres()?;
        inputs.fractal = self.fractal()?;
        if let Some(spectrum) = self.self_affine()? {
            let refused = |e: ModelError| Failure::from_error(&e);
            inputs.self_affine = Some(spectrum);
            inputs.moments = Some(spectrum.moments());
            if matches!(model, "stacked" | "multiscale") && self.max_amplitude_ratio.is_none() {
                let longest = self.longest.or(self.rolloff).unwrap_or(f64::NAN);
                let record = self.record_length.unwrap_or(longest);
                inputs.amplitudes = Some(spectrum.profile_amplitudes(record).map_err(refused)?);
            }
        } else {
            inputs.moments = self.moments(model)?;
        }
        Ok(inputs)
    }

    /// All three moments; of them Persson needs m2 only.
    fn moments(&self, model: &str) -> Result<Option<SpectralMoments>, Failure> {
        match (self.m0, self.m2, self.m4) {
            (None, None, None) => Ok(None),
            (Some(m0), Some(m2), Some(m4)) => Ok(Some(SpectralMoments { m0, m2, m4 })),
            (m0, Some(m2), m4) if model == "persson" => {
                Ok(Some(SpectralMoments { m0: m0.unwrap_or(0.0), m2, m4: m4.unwrap_or(0.0) }))
            }
            _ => Err(incomplete(
                "moments",
                &[("--m0", self.m0), ("--m2", self.m2), ("--m4", self.m4)],
            )),
        }
    }

    fn asperities(&self) -> Result<Option<AsperityStatistics>, Failure> {
        match (self.asperity_density, self.asperity_radius, self.asperity_height_std) {
            (None, None, None) if self.mean_offset.is_none() => Ok(None),
            (Some(density), Some(radius), Some(height_std)) => {
                let mean_offset = self.mean_offset.unwrap_or(0.0);
                Ok(Some(AsperityStatistics { density, radius, height_std, mean_offset }))
            }
            (density, radius, height_std) => Err(incomplete(
                "asperities",
                &[
                    ("--asperity-density", density),
                    ("--asperity-radius", radius),
                    ("--asperity-height-std", height_std),
                ],
            )),
        }
    }

    fn self_affine(&self) -> Result<Option<SelfAffineSpectrum>, Failure> {
        match (self.hurst, self.rolloff, self.cutoff) {
            (None, None, None) if self.longest.is_none() => Ok(None),
            (Some(hurst), Some(rolloff), Some(cutoff)) if self.m0.is_some() => {
                let m0 = self.m0.unwrap_or(f64::NAN);
                let spectrum = match self.longest {
                    None => SelfAffineSpectrum::from_wavelengths(hurst, rolloff, cutoff, m0),
                    Some(longest) => {
                        let wavenumbers = [longest, rolloff, cutoff].map(|l| TAU / l);
                        SelfAffineSpectrum::from_wavenumbers(hurst, wavenumbers, m0)
                    }
                };
                spectrum.map(Some).map_err(|e| Failure::from_error(&e))
            }
            (hurst, rolloff, cutoff) => Err(incomplete(
                "self-affine spectrum",
                &[
                    ("--hurst", hurst),
                    ("--rolloff", rolloff),
                    ("--cutoff", cutoff),
                    ("--m0", self.m0),
                ],
            )),
        }
    }

    fn fractal(&self) -> Result<Option<FractalParameters>, Failure> {
        match (self.dimension, self.roughness) {
            (None, None) => Ok(None),
            (Some(dimension), Some(roughness)) => {
                Ok(Some(FractalParameters { dimension, roughness }))
            }
            (dimension, roughness) => Err(incomplete(
                "fractal",
                &[("--dimension", dimension), ("--roughness", roughness)],
            )),
        }
    }

    fn spheres(&self) -> Result<Vec<SphereLevel>, Failure> {
        let list = |list: &Option<List>| list.as_ref().map_or(Vec::new(), |l| l.0.clone());
        let (radii, densities) = (list(&self.sphere_radius), list(&self.sphere_density));
        if radii.len() != densities.len() {
            let message = format!(
                "--sphere-radius has {} levels and --sphere-density {}; give both for each level, \
                 coarse to fine",
                radii.len(),
                densities.len()
            );
            return Err(Failure::refused("usage", message));
        }
        let level = |(radius, density)| SphereLevel { radius, density };
        Ok(radii.into_iter().zip(densities).map(level).collect())
    }

    /// The nominal area given (m²).
    pub(crate) fn area(&self) -> Option<f64> {
        self.area
    }

    /// The form taken off a FILE.
    pub(crate) fn level(&self) -> Level {
        self.level.unwrap_or(Level::Auto)
    }

    /// Inputs from profiles, with what no file says.
    pub(crate) fn for_profile(&self, inputs: Inputs) -> Inputs {
        let Self { gamma, critical_area, hardness, .. } = *self;
        Inputs { gamma, critical_area, hardness, ..inputs }
    }

    /// What the model needs of a measured surface without this form, and nothing else.
    pub(crate) fn measured(
        &self,
        model: &str,
        modulus: ContactModulus,
        path: &Path,
        surface: Complete,
        form: Level,
    ) -> Result<Inputs, Failure> {
        let given = Inputs {
            gamma: self.gamma,
            critical_area: self.critical_area,
            hardness: self.hardness,
            ..Inputs::new(modulus)
        };
        let edges = self.boundary.unwrap_or(Edges::Open).rule();
        let Complete { map, missing, .. } = surface;
        answers::model::measured(model, given, path, map, missing, (form, edges))
    }

    /// An option that the model does not use is a mistake, not a wish.
    /// With a load, --area has a use beside that.
    pub(crate) fn refuse_unused(
        &self,
        model: &str,
        file: Option<&Path>,
        is_loaded: bool,
    ) -> Result<(), Failure> {
        let used = options_of(model).join(" ");
        let used = |name: &str| used.split([' ', '[', ']']).any(|option| option == name);
        for (name, is_given) in self.given() {
            let of_file = matches!(name, "--level" | "--boundary");
            let extra = matches!(name, "--gamma" | "--critical-area" | "--hardness");
            let fits = match file {
                Some(_) => of_file || (extra && used(name)),
                None => !of_file && (used(name) || (model == "persson" && name == "--m4")),
            };
            let carries = is_loaded && name == "--area";
            if is_given && !fits && !carries {
                let message = match file {
                    Some(path) => format!(
                        "{name} and {} both say what the surface is; give one of them",
                        path.display()
                    ),
                    None if of_file => format!("{name} is for a surface FILE, and none is given"),
                    None => format!(
                        "{name} is no input of {model}, which takes {}",
                        options_of(model).join(", or ")
                    ),
                };
                return Err(Failure::refused("usage", message));
            }
        }
        Ok(())
    }

    fn given(&self) -> [(&'static str, bool); 23] {
        [
            ("--m0", self.m0.is_some()),
            ("--m2", self.m2.is_some()),
            ("--m4", self.m4.is_some()),
            ("--asperity-density", self.asperity_density.is_some()),
            ("--asperity-radius", self.asperity_radius.is_some()),
            ("--asperity-height-std", self.asperity_height_std.is_some()),
            ("--mean-offset", self.mean_offset.is_some()),
            ("--hurst", self.hurst.is_some()),
            ("--rolloff", self.rolloff.is_some()),
            ("--cutoff", self.cutoff.is_some()),
            ("--longest", self.longest.is_some()),
            ("--gamma", self.gamma.is_some()),
            ("--max-amplitude-ratio", self.max_amplitude_ratio.is_some()),
            ("--record-length", self.record_length.is_some()),
            ("--dimension", self.dimension.is_some()),
            ("--roughness", self.roughness.is_some()),
            ("--area", self.area.is_some()),
            ("--critical-area", self.critical_area.is_some()),
            ("--hardness", self.hardness.is_some()),
            ("--sphere-radius", self.sphere_radius.is_some()),
            ("--sphere-density", self.sphere_density.is_some()),
            ("--level", self.level.is_some()),
            ("--boundary", self.boundary.is_some()),
        ]
    }
}

/// Some options of a set were given, others not.
fn incomplete(set: &str, options: &[(&str, Option<f64>)]) -> Failure {
    let named = |is_given: bool| -> Vec<&str> {
        options.iter().filter(|o| o.1.is_some() == is_given).map(|o| o.0).collect()
    };
    let message = format!(
        "the {set} are incomplete: {} given, {} missing",
        named(true).join(" "),
        named(false).join(" ")
    );
    Failure::refused("missing_input", message)
}
