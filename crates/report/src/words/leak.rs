//! What must be known of a leak, in words.

use compare::typical_hardness;
use contact_accuracy::Leaks;

/// A sentence for each thing that limits the leaks of a study with this contact modulus (Pa).
pub fn leak_notes<'a>(
    leaks: impl Iterator<Item = &'a Leaks> + Clone,
    modulus: f64,
    yields: bool,
) -> Vec<&'static str> {
    let is = |name: &str| {
        leaks
            .clone()
            .flat_map(|l| &l.along)
            .any(|(_, l)| l.as_ref().is_ok_and(|l| l.channel() == name))
    };
    let notes = [
        (
            is("sealed"),
            "sealed: sealed at this resolution; a channel finer than a point is not seen",
        ),
        (
            is("narrow"),
            "narrow: fewer than 4 points across the bottleneck: no rate, a bound; measure on a finer grid",
        ),
        (
            !yields && typical_hardness(modulus).is_some(),
            "leak of an elastic gap: metals are flattened where they touch, and without a hardness their leak is \
             meaningless",
        ),
    ];
    notes.into_iter().filter_map(|(holds, note)| holds.then_some(note)).collect()
}
