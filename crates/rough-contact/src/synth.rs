//! `rough-contact synth`: a random self-affine surface from a recipe and a seed.

use crate::args::{self, Common};
use crate::export::Format;
use crate::outcome::{Failure, Reply};
use crate::output;
use crate::text::{self, Table};
use clap::Args;
use contact_types::{Grid, HeightMap};
use serde_json::json;
use std::path::PathBuf;
use surface_stats::synthesis::{Scale, SelfAffine};

#[derive(Args)]
pub(crate) struct Synth {
    /// Rows and columns
    #[arg(long, value_name = "NY,NX", value_parser = args::shape)]
    shape: [usize; 2],
    /// Distance of neighbouring points
    #[arg(long, value_name = "DX[,DY]", value_parser = args::pixel, allow_hyphen_values = true)]
    pixel: [f64; 2],
    /// Hurst exponent, above 0 and at most 1
    #[arg(long, value_name = "H", value_parser = args::number, allow_hyphen_values = true)]
    hurst: f64,
    /// Wavelength above which the spectrum is flat
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    rolloff: f64,
    /// Shortest wavelength
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    cutoff: f64,
    /// Rms height to scale to
    #[arg(long, value_name = "S", value_parser = args::length, allow_hyphen_values = true)]
    #[arg(required_unless_present = "rms_gradient", conflicts_with = "rms_gradient")]
    rms_height: Option<f64>,
    /// Rms gradient to scale to, instead of --rms-height
    #[arg(long, value_name = "G", value_parser = args::number, allow_hyphen_values = true)]
    rms_gradient: Option<f64>,
    /// Seed of the random phases: the same seed gives the same surface everywhere
    #[arg(long, value_name = "N")]
    seed: u64,
    /// Round the heights to multiples of this step, as an instrument does
    #[arg(long, value_name = "DZ", value_parser = args::length, allow_hyphen_values = true)]
    quantise: Option<f64>,
    /// File to write; its ending chooses the format: .npy (metres, f64), .x3p, .sdf, .txt, .vti or .h5
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

impl Synth {
    pub(crate) fn run(&self, common: &Common) -> Result<Reply, Failure> {
        let format = Format::of(&self.out)?;
        output::check(&self.out, common.force)?;
        let map = self.surface()?;
        output::write(&self.out, |writer| format.write(writer, &map, &self.comment()))?;
        Ok(self.reply(&map))
    }

    fn surface(&self) -> Result<HeightMap, Failure> {
        let grid = Grid::new(self.shape, self.pixel).map_err(|e| Failure::from_error(&e))?;
        let scale = match (self.rms_height, self.rms_gradient) {
            (_, Some(gradient)) => Scale::RmsGradient(gradient),
            (height, None) => Scale::RmsHeight(height.unwrap_or(f64::NAN)),
        };
        let recipe = SelfAffine {
            grid,
            hurst: self.hurst,
            rolloff: self.rolloff,
            cutoff: self.cutoff,
            scale,
            seed: self.seed,
            quantise: self.quantise,
        };
        recipe.generate().map_err(|e| Failure::from_error(&e))
    }

    /// The recipe, for people who find the file.
    fn comment(&self) -> String {
        format!(
            "rough-contact synth: Hurst {}, roll-off {} m, cut-off {} m, seed {}",
            self.hurst, self.rolloff, self.cutoff, self.seed
        )
    }

    fn reply(&self, map: &HeightMap) -> Reply {
        let [ny, nx] = self.shape;
        let (low, high) = map.range();
        let mut table = Table::default();
        table.row("wrote", self.out.display().to_string());
        table.row("points", format!("{ny} rows × {nx} columns"));
        table.row("heights", format!("{} to {}", text::length(low), text::length(high)));
        let json = json!({
            "path": self.out.to_string_lossy(),
            "shape": self.shape,
            "pixel": self.pixel,
            "height_min": low,
            "height_max": high,
            "seed": self.seed,
        });
        Reply::new(table.to_string(), json)
    }
}
