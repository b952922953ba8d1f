//! Papers that the page cites beside those of the models.

use contact_types::Citation;

/// The deterministic solution.
pub(crate) const DETERMINISTIC: Citation = Citation {
    authors: "Stanley & Kato",
    year: 1997,
    title: "An FFT-based method for rough surface contact",
    journal: "J. Tribol. 119, 481",
    doi: "10.1115/1.2833523",
};

/// The correction of counted areas.
pub(crate) const AREA_CORRECTION: Citation = Citation {
    authors: "Yastrebov, Anciaux & Molinari",
    year: 2017,
    title: "On the accurate computation of the true contact-area in mechanical contact of random \
            rough surfaces",
    journal: "Tribol. Int. 114, 161",
    doi: "10.1016/j.triboint.2017.04.023",
};
