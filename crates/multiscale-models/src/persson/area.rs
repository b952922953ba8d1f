//! Real area by Persson's law, its inverse, and the area seen at a magnification.

use super::reduced_diffusion;
use super::span::MODEL;
use super::theory::{AreaLaw, Persson};
use crate::answer::outside;
use crate::special::{erf, erf_inv, erfc, erfc_inv};
use crate::wide::Wide;
use contact_types::{ModelError, require};
use std::f64::consts::FRAC_2_SQRT_PI;

impl Persson {
    /// Real area fraction `A/A_0 = erf(p / (E* sqrt(m2)))` \[-\] at nominal pressure `p` \[Pa\].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn area_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        Ok(erf(self.area_argument(pressure)?))
    }

    /// Fraction of the nominal area out of contact, `1 - A/A_0 = erfc(p / (E* sqrt(m2)))` \[-\].
    /// Near full contact it has the digits that `1 - area_fraction` has lost.
    ///
    /// There one rounding of the argument x would be worth 2 x² roundings of the answer; what
    /// the argument lost is therefore computed and given back.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn open_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        let x = self.area_argument(pressure)?;
        let open = erfc(x);
        if self.area_law != AreaLaw::Diffusion || self.slope.is_zero() || pressure <= 0.0 {
            return Ok(open);
        }
        let modulus = Wide::from(self.modulus.pascals());
        let error = Wide::from(pressure).quotient_error(self.slope * modulus)
            - self.slope.product_error(modulus)
            - self.slope_error;
        // erfc(x (1 + error)), to first order; nothing is left of it where x is infinite
        let change = FRAC_2_SQRT_PI * error * (x * (-x * x).exp());
        Ok(if change.is_finite() { (open - change).max(0.0) } else { open })
    }

    /// The nominal pressure \[Pa\] at which the area fraction is `area_fraction`.
    ///
    /// ```math
    /// p = E^* \sqrt{m_2}\, \operatorname{erf}^{-1}\frac{A}{A_0}
    /// ```
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless `0 <= area_fraction <= 1`;
    /// [`ModelError::OutsideDomain`] for an area of 1, which no finite pressure reaches, and for
    /// any other area but 0 of a flat surface.
    pub fn pressure_at_area(&self, area_fraction: f64) -> Result<f64, ModelError> {
        require::fraction(MODEL, "area fraction", area_fraction)?;
        self.pressure_at_argument(erf_inv(area_fraction), area_fraction)
    }

    /// The nominal pressure \[Pa\] at which the fraction out of contact, `1 - A/A_0`, is
    /// `open_fraction`. Use it near full contact.
    ///
    /// # Errors
    /// As [`pressure_at_area`](Self::pressure_at_area).
    pub fn pressure_at_open_fraction(&self, open_fraction: f64) -> Result<f64, ModelError> {
        require::fraction(MODEL, "open fraction", open_fraction)?;
        self.pressure_at_argument(erfc_inv(open_fraction), 1.0 - open_fraction)
    }

    /// Area fraction seen when only roughness of wavenumbers up to `wavenumber` \[rad/m\] is
    /// resolved: `A(q) = erf(p / (E* sqrt(m2(q))))`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a pressure or wavenumber that is negative or not finite, or
    /// if the model was made from moments, which do not say how roughness is distributed over
    /// wavenumbers.
    pub fn area_fraction_up_to(&self, pressure: f64, wavenumber: f64) -> Result<f64, ModelError> {
        require::pressure(MODEL, pressure)?;
        require::not_negative(MODEL, "wavenumber", wavenumber)?;
        let part = self.spectrum()?.slope_fraction(wavenumber);
        Ok(erf(self.argument_for(pressure, self.slope * part)))
    }

    fn area_argument(&self, pressure: f64) -> Result<f64, ModelError> {
        require::pressure(MODEL, pressure)?;
        Ok(self.argument_for(pressure, self.slope))
    }

    /// Argument of the error function for the roughness of rms profile slope `slope`.
    fn argument_for(&self, pressure: f64, slope: Wide) -> f64 {
        let stiffness = slope * self.modulus.pascals();
        if stiffness.is_zero() {
            return if pressure > 0.0 { f64::INFINITY } else { 0.0 }; // flat: all or nothing
        }
        let x = Wide::from(pressure) / stiffness;
        match self.area_law {
            AreaLaw::Diffusion => x.value(),
            AreaLaw::ReducedDiffusion => reduced_diffusion::argument(x, self.gamma),
        }
    }

    fn pressure_at_argument(&self, argument: f64, area_fraction: f64) -> Result<f64, ModelError> {
        let unreachable = |reason| {
            let domain = 0.0..=1.0 - f64::EPSILON / 2.0;
            Err(outside(MODEL, "area fraction", area_fraction, domain, reason))
        };
        if argument <= 0.0 {
            return Ok(0.0);
        }
        if self.slope.is_zero() {
            return unreachable("a flat surface touches everywhere under any pressure");
        }
        if argument.is_infinite() {
            return unreachable("full contact is reached only as the pressure grows to infinity");
        }
        let x = match self.area_law {
            AreaLaw::Diffusion => Wide::from(argument),
            AreaLaw::ReducedDiffusion => reduced_diffusion::load(argument, self.gamma),
        };
        let pressure = x * self.slope * self.modulus.pascals();
        require::representable(MODEL, "mean pressure", pressure.value())
    }
}
