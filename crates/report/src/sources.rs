//! Papers that the page cites beside those of the models.

use contact_types::Citation;
use std::borrow::Cow;

/// The deterministic solution.
pub(crate) const DETERMINISTIC: Citation = Citation {
    authors: Cow::Borrowed("Stanley & Kato"),
    year: 1997,
    title: Cow::Borrowed("An FFT-based method for rough surface contact"),
    journal: Cow::Borrowed("J. Tribol. 119, 481"),
    doi: Cow::Borrowed("10.1115/1.2833523"),
};

/// Conductance from stiffness.
pub(crate) const CONDUCTANCE: Citation = Citation {
    authors: Cow::Borrowed("Barber"),
    year: 2003,
    title: Cow::Borrowed(
        "Bounds on the electrical resistance between contacting elastic rough bodies",
    ),
    journal: Cow::Borrowed("Proc. R. Soc. A 459, 53"),
    doi: Cow::Borrowed(""),
};

/// The correction of counted areas.
pub(crate) const AREA_CORRECTION: Citation = Citation {
    authors: Cow::Borrowed("Yastrebov, Anciaux & Molinari"),
    year: 2017,
    title: Cow::Borrowed(
        "On the accurate computation of the true contact-area in mechanical contact of random \
            rough surfaces",
    ),
    journal: Cow::Borrowed("Tribol. Int. 114, 161"),
    doi: Cow::Borrowed("10.1016/j.triboint.2017.04.023"),
};
