//! The questions of `fixtures/reference/extremes_multiscale.csv`, put to the crate.

use super::{Row, Table};
use contact_types::{
    AmplitudeSpectrum, Caveat, ContactModel, ContactModulus, FractalParameters, ModelError,
    RoughnessSpectrum, Shell, SpectralMoments, Wave,
};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, SelfAffineSpectrum, SphereLevel, Stacked,
    YanKomvopoulos, critical_area,
};

/// What came back, with what the model remarked.
pub(crate) type Answer = Result<(f64, Option<Caveat>), ModelError>;

/// One row of the table and the crate's answer to it.
pub(crate) struct Case {
    pub(crate) question: String,
    pub(crate) inputs: String,
    /// `None`: a typed error is the answer.
    pub(crate) reference: Option<f64>,
    pub(crate) answer: Answer,
}

impl Case {
    /// Relative error, absolute where the reference is 0; `None` if there is nothing to compare.
    pub(crate) fn error(&self) -> Option<f64> {
        let (found, _) = self.answer.as_ref().ok()?;
        let expected = self.reference?;
        Some(if expected == 0.0 { found.abs() } else { ((found - expected) / expected).abs() })
    }
}

/// All cases.
pub(crate) fn cases() -> Vec<Case> {
    let ask = |row: Row<'_>| Case {
        question: row.text("question").to_owned(),
        inputs: row.text("inputs").to_owned(),
        reference: (row.text("reference") != "refused").then(|| row.number("reference")),
        answer: answer(&Question { row }),
    };
    Table::read("extremes_multiscale.csv").rows().map(ask).collect()
}

struct Question<'a> {
    row: Row<'a>,
}

impl Question<'_> {
    fn text(&self, key: &str) -> Option<&str> {
        let entry = |e: &&str| e.split_once('=').is_some_and(|(k, _)| k == key);
        self.row.text("inputs").split(';').find(entry).and_then(|e| e.split_once('=')).map(|e| e.1)
    }

    fn number(&self, key: &str) -> f64 {
        let text = self.text(key).unwrap_or_else(|| panic!("no input {key}"));
        text.parse().unwrap_or_else(|e| panic!("{key}: {e}"))
    }

    fn modulus(&self) -> ContactModulus {
        ContactModulus::from_pascals(self.number("E")).expect("the table has valid moduli")
    }

    /// Pairs `a:b|c:d`.
    fn pairs(&self, key: &str) -> Vec<(f64, f64)> {
        let pair = |text: &str| {
            let (a, b) = text.split_once(':').expect("two numbers");
            (a.parse().expect("a number"), b.parse().expect("a number"))
        };
        self.text(key).expect("a list").split('|').map(pair).collect()
    }

    fn surface(&self) -> FractalParameters {
        FractalParameters { dimension: self.number("D"), roughness: self.number("G") }
    }

    fn persson(&self) -> Result<Persson, ModelError> {
        let moments = SpectralMoments { m0: 1.0, m2: self.number("m2"), m4: 1.0 };
        Persson::from_moments(moments, self.modulus())
    }

    fn majumdar_bhushan(&self) -> Result<MajumdarBhushan, ModelError> {
        let model = MajumdarBhushan::new(self.surface(), 1.0, self.modulus())?;
        match self.text("critical") {
            Some(_) => model.with_critical_area(self.number("critical")),
            None => Ok(model),
        }
    }

    fn area(&self, model: &dyn ContactModel) -> Answer {
        let state = model.at_pressure(self.number("p"))?;
        Ok((state.area_fraction, state.caveat))
    }
}

fn answer(q: &Question<'_>) -> Answer {
    let plain = |value: Result<f64, ModelError>| value.map(|v| (v, None));
    match q.row.text("question") {
        "persson area" => q.area(&q.persson()?),
        "persson open fraction" => plain(q.persson()?.open_fraction(q.number("p"))),
        "persson pressure" => plain(q.persson()?.pressure_at_area(q.number("a"))),
        "persson pressure at open fraction" => {
            plain(q.persson()?.pressure_at_open_fraction(q.number("b")))
        }
        "persson gap of one line" => {
            let shell = Shell { wavenumber: q.number("q"), variance: q.number("S") };
            let spectrum = RoughnessSpectrum::new(vec![shell]).expect("one line");
            gap(&Persson::from_spectrum(spectrum, q.modulus())?.with_gamma(1.0)?, q)
        }
        "persson gap of a self-affine surface" => {
            let wavenumbers = [q.number("qL"), q.number("qr"), q.number("qs")];
            let spectrum =
                SelfAffineSpectrum::from_wavenumbers(q.number("H"), wavenumbers, q.number("m0"))?;
            let model = Persson::from_self_affine(spectrum, q.modulus())?;
            gap(&model.with_gamma(q.number("gamma"))?, q)
        }
        "stacked" => q.area(&Stacked::new(q.number("B"), q.modulus())?),
        "jackson-streator" => {
            let wave = |(frequency, amplitude)| Wave { frequency, amplitude };
            let waves = q.pairs("waves").into_iter().map(wave).collect();
            let spectrum = AmplitudeSpectrum::new(waves, 1.0).expect("rising frequencies");
            q.area(&JacksonStreator::new(spectrum, q.modulus())?)
        }
        "archard" => {
            let level = |(radius, density)| SphereLevel { radius, density };
            let levels: Vec<_> = q.pairs("levels").into_iter().map(level).collect();
            q.area(&Archard::new(&levels, q.modulus())?)
        }
        "majumdar-bhushan pressure" => plain(q.majumdar_bhushan()?.pressure_at_area(q.number("a"))),
        "majumdar-bhushan area" => q.area(&q.majumdar_bhushan()?),
        "critical area" => plain(critical_area(q.surface(), q.modulus(), q.number("H"))),
        "yan-komvopoulos pressure" => {
            let (d, g) = (q.number("D"), q.number("G"));
            let model = YanKomvopoulos::new(d, g, 1.0, q.modulus())?;
            let model = model.with_critical_area(q.number("critical"))?;
            plain(model.pressure_at_largest_spot(q.number("largest")))
        }
        other => panic!("the table asks {other:?}, which nobody answers"),
    }
}

fn gap(model: &Persson, q: &Question<'_>) -> Answer {
    let state = model.at_pressure(q.number("p"))?;
    Ok((state.mean_gap.expect("a spectrum has a gap"), state.caveat))
}
