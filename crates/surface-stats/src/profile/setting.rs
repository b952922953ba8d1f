//! Settings of ISO 21920-3: which waves are roughness, and how much of a trace is evaluated.

/// A setting class of ISO 21920-3:2021: what is measured how, by the roughness it is for.
pub(super) struct SettingClass {
    /// Sc1 to Sc5.
    pub(super) number: u8,
    /// λc (m): waves longer than this are not roughness. Also the section length.
    pub(super) cutoff: f64,
    /// λs (m): waves shorter than this are not roughness. It acts on points a fifth of it apart at most.
    short: f64,
    /// Largest Ra it is for (m).
    pub(super) most_ra: f64,
}

const fn class(number: u8, cutoff: f64, short: f64, most_ra: f64) -> SettingClass {
    SettingClass { number, cutoff, short, most_ra }
}

/// The five classes, from fine to coarse.
pub(super) const SETTING_CLASSES: [SettingClass; 5] = [
    class(1, 0.08e-3, 2.5e-6, 0.02e-6),
    class(2, 0.25e-3, 2.5e-6, 0.1e-6),
    class(3, 0.8e-3, 2.5e-6, 2e-6),
    class(4, 2.5e-3, 8e-6, 10e-6),
    class(5, 8e-3, 25e-6, 80e-6),
];

/// Where a setting comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SettingSource {
    /// λc was asked for.
    Asked,
    /// The finest class whose Ra is not exceeded with its own λc.
    Class(u8),
    /// The coarsest class that the trace is long enough for, although Ra exceeds it; the class
    /// that Ra asks for is not known, being coarser.
    Longest(u8),
}

/// Which waves are roughness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// λc (m), the section length.
    pub cutoff: f64,
    /// λs (m), if it is applied.
    pub short: Option<f64>,
    /// λs of the class (m), if the points stand too far apart for it.
    pub short_unresolved: Option<f64>,
    /// Why these.
    pub source: SettingSource,
}

impl Setting {
    /// λc and, if it is not `None`, λs as asked for.
    pub(crate) fn asked(cutoff: f64, short: Option<f64>) -> Self {
        Self { cutoff, short, short_unresolved: None, source: SettingSource::Asked }
    }

    /// A λc that was asked for, on points at this spacing: with λs as asked for, else that of the class
    /// with this λc if there is one and the points resolve it.
    pub(crate) fn of_cutoff(cutoff: f64, short: Option<f64>, spacing: f64) -> Self {
        let known = SETTING_CLASSES.iter().find(|c| (c.cutoff / cutoff - 1.0).abs() < 1e-6);
        match (short, known) {
            (None, Some(class)) => {
                let source = SettingSource::Asked;
                Self { cutoff, source, ..Self::of_class(class, None, spacing) }
            }
            _ => Self::asked(cutoff, short),
        }
    }

    /// That of a class on points at this spacing, with λs if one was asked for.
    pub(super) fn of_class(class: &SettingClass, short: Option<f64>, spacing: f64) -> Self {
        let resolved = spacing <= class.short / 5.0 * (1.0 + 1e-6);
        Self {
            cutoff: class.cutoff,
            short: short.or(resolved.then_some(class.short)),
            short_unresolved: (short.is_none() && !resolved).then_some(class.short),
            source: SettingSource::Class(class.number),
        }
    }

    /// Shortest trace that has one section length of roughness, with half a cut-off at each end (m).
    pub(crate) fn least_length(&self) -> f64 {
        2.0 * self.cutoff
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lambda_s_that_the_points_do_not_resolve_is_left_out_and_said() {
        let wide = Setting::of_cutoff(0.8e-3, None, 2e-6);
        assert_eq!((wide.short, wide.short_unresolved), (None, Some(2.5e-6)));
        let fine = Setting::of_cutoff(0.8e-3, None, 0.5e-6);
        assert_eq!(fine.short, Some(2.5e-6));
        assert_eq!(Setting::of_cutoff(0.7e-3, None, 0.5e-6).short, None);
        assert_eq!(Setting::of_cutoff(0.8e-3, Some(8e-6), 0.5e-6).short, Some(8e-6));
    }
}
