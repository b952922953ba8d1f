//! What must be known of a leak, in words.

use crate::messages::conduction::scientific;
use crate::numbers::relative_interval;
use contact_accuracy::{Axis, Leak, Leaks};
use contact_compare::{LeakRequest, SurfaceComparison, typical_hardness};
use contact_types::Named;

/// A sentence for each thing that limits the leaks of a study with this contact modulus (Pa).
pub fn leak_notes(leaks: &[&Leaks], modulus: f64, yields: bool) -> Vec<&'static str> {
    let along = || leaks.iter().flat_map(|l| &l.along);
    let is = |name: &str| along().any(|(_, l)| l.as_ref().is_ok_and(|l| l.channel() == name));
    let notes = [
        (
            is("sealed"),
            "sealed: sealed at this resolution; a channel finer than a point is not seen",
        ),
        (
            is("narrow"),
            "narrow: fewer than 4 points across the bottleneck, or more than twice the leak on every second point: no rate, a \
             bound; measure on a finer grid",
        ),
        (
            !yields && typical_hardness(modulus).is_some(),
            "leak of an elastic gap: metals are flattened where they touch, and without a hardness their leak is \
             meaningless",
        ),
    ];
    notes.into_iter().filter_map(|(holds, note)| holds.then_some(note)).collect()
}

/// K, or what is known of it.
pub(crate) fn known(leak: &Leak, unit: &str, of: impl Fn(f64) -> f64) -> String {
    match (leak.permeability(), leak.interval()) {
        (Some(k), ends) => {
            let spread = ends.filter(|_| k > 0.0).map(|ends| relative_interval(k, ends));
            let spread = spread.map_or_else(String::new, |text| format!(" {text}"));
            scientific(of(k), unit) + &spread
        }
        (None, Some([_, most])) => format!("at most {}", scientific(of(most), unit)),
        (None, None) => "–".into(),
    }
}

/// Rows of the key numbers: the leak rate, or the permeability where no seal is given.
pub(crate) fn key_rows(asked: &LeakRequest, surface: &SurfaceComparison) -> Vec<[String; 3]> {
    let leaks = surface.leaks.get(surface.headline).and_then(Option::as_ref);
    let row = |(axis, leak): &(Axis, Result<Leak, _>)| {
        let leak = leak.as_ref().ok()?;
        let k = known(leak, "m³", |k| k);
        let name = axis.name();
        Some(match asked.seal {
            None => [format!("Permeability along {name}"), k, leak.channel().into()],
            Some(seal) => {
                [format!("Leak rate along {name}"), known(leak, "m³/s", |k| seal.rate(k)), k]
            }
        })
    };
    leaks.iter().flat_map(|leaks| &leaks.along).filter_map(row).collect()
}
