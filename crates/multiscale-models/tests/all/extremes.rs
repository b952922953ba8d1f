//! Every model at the ends of its inputs, against `fixtures/reference/extremes_multiscale.csv` of 20 digits.

use crate::common::{self, Case, ReferenceRow, reference_rows};
use contact_types::{
    AmplitudeSpectrum, ContactModel, ContactModulus, FractalParameters, ModelError,
    RoughnessSpectrum, Shell, SpectralMoments, Wave,
};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, PlasticSpots, SelfAffineSpectrum,
    SphereLevel, Stacked, YanKomvopoulos,
};

fn cases() -> Vec<Case> {
    let ask = |row: &ReferenceRow| Case {
        place: format!("{}, {}", row.text("question"), row.text("inputs")),
        reference: (row.text("reference") != "refused").then(|| row.number("reference")),
        answer: answer(&Question { row }).ok(),
        least: 0.0,
    };
    reference_rows("extremes_multiscale.csv").iter().map(ask).collect()
}

struct Question<'a> {
    row: &'a ReferenceRow,
}

impl Question<'_> {
    fn text(&self, key: &str) -> Option<&str> {
        let entries = self.row.text("inputs").split(';').filter_map(|e| e.split_once('='));
        entries.filter(|(k, _)| *k == key).map(|(_, value)| value).next()
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

    fn persson(&self) -> Result<Persson, ModelError> {
        let moments = SpectralMoments { m0: 1.0, m2: self.number("m2"), m4: 1.0 };
        Persson::from_moments(moments, self.modulus())
    }

    fn majumdar_bhushan(&self) -> Result<MajumdarBhushan, ModelError> {
        let surface =
            FractalParameters { dimension: self.number("D"), roughness: self.number("G") };
        let plastic = match self.text("critical") {
            Some(_) => PlasticSpots::Below(self.number("critical")),
            None => PlasticSpots::None,
        };
        MajumdarBhushan::new(surface, 1.0, self.modulus(), plastic)
    }

    fn area(&self, model: &dyn ContactModel) -> Result<f64, ModelError> {
        Ok(model.at_pressure(self.number("p"))?.area_fraction)
    }

    fn gap(&self, model: &Persson) -> Result<f64, ModelError> {
        let state = model.at_pressure(self.number("p"))?;
        Ok(state.mean_gap.expect("a spectrum has a gap"))
    }
}

fn answer(q: &Question<'_>) -> Result<f64, ModelError> {
    match q.row.text("question") {
        "persson area" => q.area(&q.persson()?),
        "persson gap of one line" => {
            let shell = Shell { wavenumber: q.number("q"), variance: q.number("S") };
            let spectrum = RoughnessSpectrum::new(vec![shell]).expect("one line");
            q.gap(&Persson::from_spectrum(spectrum, q.modulus())?.with_gamma(1.0)?)
        }
        "persson gap of a self-affine surface" => {
            let wavenumbers = ["qL", "qr", "qs"].map(|key| q.number(key));
            let spectrum =
                SelfAffineSpectrum::from_wavenumbers(q.number("H"), wavenumbers, q.number("m0"))?;
            let model = Persson::from_self_affine(spectrum, q.modulus());
            q.gap(&model.with_gamma(q.number("gamma"))?)
        }
        "stacked" => q.area(&Stacked::new(q.number("B"), q.modulus())?),
        "jackson-streator" => {
            let wave = |(frequency, amplitude)| Wave { frequency, amplitude };
            let waves = q.pairs("waves").into_iter().map(wave).collect();
            let spectrum = AmplitudeSpectrum::new(waves, 1.0).expect("rising frequencies");
            q.area(&JacksonStreator::new(spectrum, q.modulus()))
        }
        "archard" => {
            let level = |(radius, density)| SphereLevel { radius, density };
            let levels: Vec<_> = q.pairs("levels").into_iter().map(level).collect();
            q.area(&Archard::new(&levels, q.modulus())?)
        }
        "majumdar-bhushan area" => q.area(&q.majumdar_bhushan()?),
        "yan-komvopoulos area" => {
            let (d, g) = (q.number("D"), q.number("G"));
            let plastic = PlasticSpots::Below(q.number("critical"));
            q.area(&YanKomvopoulos::new(d, g, 1.0, q.modulus(), plastic)?)
        }
        other => panic!("the table asks {other:?}, which nobody answers"),
    }
}

#[test]
fn answers_at_the_extremes() {
    let cases = cases();
    common::print("multiscale-models", &cases);
    let mut questions = std::collections::BTreeSet::new();
    for case in cases {
        let place = &case.place;
        let Some(reference) = case.reference else {
            assert!(case.answer.is_none(), "{place}: should be refused");
            continue;
        };
        let error = case.error().unwrap_or_else(|| panic!("{place}: {:?}", case.answer));
        // The exponential e^{-x^2} of a gap turns one rounding of x into 2 x^2 roundings: 1e-13 at
        // x = 20.
        let question = place.split(',').next().unwrap_or_default();
        // A power that is 1e-300 turns one rounding of its exponent into 690.
        let limit = match question {
            q if q.contains("gap") => 3e-13,
            "majumdar-bhushan area" if reference < 1e-200 => 1e-14,
            _ => 3e-15,
        };
        assert!(error <= limit, "{place}: {error:e}");
        questions.insert(question.to_owned());
    }
    assert!(questions.len() >= 8, "only {questions:?}");
}
