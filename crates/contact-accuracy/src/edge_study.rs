//! What a study (commit adc1dd6) found about maps that do not repeat, and what it says of a map whose
//! strip along the edge carries contact like theirs.

use crate::table::quantile;
use std::sync::OnceLock;

/// A crop at one load, solved as if it repeated, against itself in its natural surroundings.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct EdgeRow {
    /// Number of the large map it was cut from.
    pub surface: usize,
    /// Mean pressure over E* h'_rms.
    pub load: f64,
    /// Signed relative error of the area.
    pub error: f64,
    /// [`direct_effect`](crate::EdgeShare::direct_effect) of its strip.
    pub direct: f64,
}

/// The error of the area on crops like the map asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct EdgeExperience {
    /// Signed relative error that 5 % of the crops are below.
    pub low: f64,
    /// Signed relative error that 5 % of the crops are above.
    pub high: f64,
    /// Crops behind the range.
    pub crops: usize,
}

/// Fewest crops a range may stand on.
const FEWEST: usize = 10;
/// Largest factor between loads that count as alike.
const LOAD: f64 = 4.0;
/// Largest difference of direct effects that count as alike: absolute, or as a part of the one
/// asked for.
const DIRECT: [f64; 2] = [0.01, 0.5];

/// The table of the study.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeStudy {
    rows: Vec<EdgeRow>,
}

impl EdgeStudy {
    /// The study this version was built with.
    #[allow(clippy::missing_panics_doc, reason = "a test reads the committed table")]
    pub fn built_in() -> &'static Self {
        static STUDY: OnceLock<EdgeStudy> = OnceLock::new();
        STUDY.get_or_init(|| {
            Self::parse(include_str!("../data/edges.csv"))
                .expect("a test reads the committed table")
        })
    }

    /// Reads the table: `surface, Hurst exponent, side over roll-off, load, error, direct`, after
    /// lines that begin with `#` and a head; `None` if a line is not one of its rows.
    pub fn parse(table: &str) -> Option<Self> {
        let row = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |k: usize| cells.get(k)?.parse::<f64>().ok();
            Some(EdgeRow {
                surface: cells.first()?.parse().ok()?,
                load: number(3)?,
                error: number(4)?,
                direct: number(5)?,
            })
        };
        let lines = table.lines().filter(|line| !line.starts_with('#'));
        Some(Self { rows: lines.skip(1).map(row).collect::<Option<_>>()? })
    }

    /// All rows.
    pub fn rows(&self) -> &[EdgeRow] {
        &self.rows
    }

    /// The range of nine in ten errors of crops at a like load whose strip had a like direct effect; `None`
    /// if there are fewer than ten.
    pub fn ask(&self, load: f64, direct: f64) -> Option<EdgeExperience> {
        self.ask_without(load, direct, None)
    }

    /// The same without the crops of one large map, to see whether the others would have told
    /// their error.
    pub fn ask_without(
        &self,
        load: f64,
        direct: f64,
        left_out: Option<usize>,
    ) -> Option<EdgeExperience> {
        let [absolute, part] = DIRECT;
        let alike = self.rows.iter().filter(|row| {
            Some(row.surface) != left_out
                && (row.load / load).ln().abs() <= LOAD.ln()
                && (row.direct - direct).abs() <= absolute.max(part * direct.abs())
        });
        let mut errors: Vec<f64> = alike.map(|row| row.error).collect();
        errors.sort_by(f64::total_cmp);
        let [low, high] = [0.05, 0.95].map(|part| quantile(&errors, part));
        let seen = EdgeExperience { low: low?, high: high?, crops: errors.len() };
        (seen.crops >= FEWEST).then_some(seen)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_like_crops_speak_and_only_enough_of_them() {
        let alike = |i: usize| format!("{},0.8,2,0.01,{},-0.02\n", i / 5, 0.001 * i as f64);
        let rows: String = (0..10).map(alike).collect();
        let other = "7,0.8,2,0.01,-0.4,-0.2\n7,0.8,2,0.3,-0.5,-0.02\n";
        let table = format!("# origin\nsurface,hurst,waves,load,error,direct\n{rows}{other}");
        let study = EdgeStudy::parse(&table).unwrap();
        assert_eq!(study.rows().len(), 12);
        let seen = study.ask(0.02, -0.025).unwrap();
        assert_eq!(seen.crops, 10);
        // Errors 0, 0.001 … 0.009: half a step from each end.
        assert!((seen.low - 0.00045).abs() < 1e-12 && (seen.high - 0.00855).abs() < 1e-12);
        assert_eq!(study.ask_without(0.02, -0.025, Some(0)), None);
        assert_eq!(study.ask(0.02, 0.02), None);
        assert!(EdgeStudy::parse("head\n1,2\n").is_none());
    }

    /// The committed table speaks at every load of the study, and a strip that takes much more
    /// load than area goes with areas lower by more than 3 % at the low end of the range.
    #[test]
    fn the_built_in_study_is_whole() {
        let study = EdgeStudy::built_in();
        assert!(study.rows().len() > 200);
        for load in [0.003, 0.01, 0.03, 0.1, 0.3] {
            let (even, steep) = (study.ask(load, 0.0).unwrap(), study.ask(load, -0.1).unwrap());
            assert!(even.low < even.high && even.high < 0.1, "{load}: {even:?}");
            assert!(steep.low < even.low - 0.03, "{load}: {steep:?}");
        }
    }
}
