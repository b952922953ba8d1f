//! A continuous self-affine spectrum with a plateau.

use super::span::{Range, check_span};
use crate::special::gauss_legendre;
use crate::wide::Wide;
use contact_types::{ModelError, SpectralMoments, require};

/// Name of the spectrum in errors.
pub(super) const MODEL: &str = "self-affine spectrum";

/// Two-dimensional isotropic PSD of a self-affine surface:
///
/// ```math
/// C(q) = C_0 \text{ for } q_L \le q \le q_r, \qquad
/// C(q) = C_0 (q/q_r)^{-2-2H} \text{ for } q_r \le q \le q_s,
/// ```
///
/// with `m0 = 2 pi int q C dq`. All moments are elementary; where a power turns into a logarithm (H = 0 for m0,
/// H = 1 for m2) they are continuous, without loss of digits.
///
/// ```
/// use multiscale_models::SelfAffineSpectrum;
/// // H = 0.8, roll-off 100 um, cut-off 1 um, 0.5 um rms
/// let spectrum = SelfAffineSpectrum::from_wavelengths(0.8, 100e-6, 1e-6, 0.25e-12)?;
/// assert!((spectrum.moments().m0 - 0.25e-12).abs() < 1e-27);
/// # Ok::<(), contact_types::ModelError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SelfAffineSpectrum {
    pub(super) hurst: f64,
    /// `[q_L, q_r, q_s]`.
    pub(super) wavenumbers: [f64; 3],
    pub(super) m0: f64,
    /// `q_L / q_r`, at most 1.
    plateau: f64,
    /// `ln(q_s / q_r)`, at least 0.
    decades: f64,
    /// `1 - q_L/q_r` without cancellation.
    plateau_width: f64,
}

impl SelfAffineSpectrum {
    /// From the Hurst exponent, the wavenumbers `[q_L, q_r, q_s]` (rad/m: lower end, roll-off,
    /// cut-off) and the mean square height `m0` (m²).
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `0 <= hurst <= 1` and `q_L <= q_r <= q_s` with
    /// `q_L < q_s <= 1e18 q_L`; [`ModelError::InvalidInput`] for a wavenumber that is not
    /// positive or an `m0` that is negative, or either not finite.
    pub fn from_wavenumbers(
        hurst: f64,
        wavenumbers: [f64; 3],
        m0: f64,
    ) -> Result<Self, ModelError> {
        if !(0.0..=1.0).contains(&hurst) {
            let reason = "a self-affine surface has a Hurst exponent between 0 and 1";
            return Err(require::outside(MODEL, "Hurst exponent", hurst, 0.0..=1.0, reason));
        }
        let [lower, rolloff, cutoff] = wavenumbers;
        require::positive(MODEL, "lower wavenumber", lower)?;
        require::positive(MODEL, "roll-off wavenumber", rolloff)?;
        require::positive(MODEL, "cut-off wavenumber", cutoff)?;
        require::not_negative(MODEL, "m0", m0)?;
        if rolloff < lower || rolloff > cutoff {
            let reason = "the roll-off lies between the lower end and the cut-off";
            let (quantity, domain) = ("roll-off wavenumber", lower..=cutoff);
            return Err(require::outside(MODEL, quantity, rolloff, domain, reason));
        }
        let span = (Wide::from(cutoff) / Wide::from(lower)).value().min(f64::MAX);
        let quantity = "cut-off over lower end";
        if cutoff <= lower {
            let reason = "a continuous spectrum needs a band; a single wavenumber is a \
                          RoughnessSpectrum of one shell";
            return Err(require::outside(MODEL, quantity, span, 1.0..=1e18, reason));
        }
        check_span(MODEL, quantity, span)?;
        Ok(Self {
            hurst,
            wavenumbers,
            m0,
            plateau: lower / rolloff,
            decades: ((cutoff - rolloff) / rolloff).ln_1p(),
            plateau_width: (rolloff - lower) / rolloff,
        })
    }

    /// Without plateau, from the roll-off and cut-off *wavelengths* (m): `q = 2 pi / wavelength`.
    ///
    /// # Errors
    /// As [`from_wavenumbers`](Self::from_wavenumbers).
    pub fn from_wavelengths(
        hurst: f64,
        rolloff: f64,
        cutoff: f64,
        m0: f64,
    ) -> Result<Self, ModelError> {
        let wavenumber = |quantity, length| {
            require::positive(MODEL, quantity, length)
                .map(|length| (std::f64::consts::TAU / length).min(f64::MAX))
        };
        let lower = wavenumber("roll-off wavelength", rolloff)?;
        let upper = wavenumber("cut-off wavelength", cutoff)?;
        if cutoff > rolloff {
            let (quantity, reason) = ("cut-off wavelength", "it is shorter than the roll-off");
            return Err(require::outside(MODEL, quantity, cutoff, f64::MIN..=rolloff, reason));
        }
        Self::from_wavenumbers(hurst, [lower, lower, upper], m0)
    }

    /// Profile spectral moments: `m0`, `m2 = pi int q^3 C dq`, `m4 = (3 pi / 4) int q^5 C dq`.
    /// A moment beyond the range of a double is infinite or 0.
    pub fn moments(&self) -> SpectralMoments {
        let q2 = Wide::from(self.wavenumbers[1]) * self.wavenumbers[1];
        let m2 = q2 * self.m0 * (0.5 * self.integral(2) / self.integral(0));
        let m4 = q2 * q2 * self.m0 * (0.375 * self.integral(4) / self.integral(0));
        SpectralMoments { m0: self.m0, m2: m2.value(), m4: m4.value() }
    }

    /// `sqrt(m2)`.
    pub(super) fn slope(&self) -> Wide {
        let shape = 0.5 * self.integral(2) / self.integral(0);
        Wide::from(self.m0).sqrt() * self.wavenumbers[1] * shape.sqrt()
    }

    /// `int q^(n+1) C dq / (C0 q_r^(n+2))` over the whole spectrum, n = 0, 2, 4.
    pub(super) fn integral(&self, n: i32) -> f64 {
        let (a, width) = (self.plateau, self.plateau_width);
        // (1 - a^(n+2))/(n + 2), factored
        let flat = match n {
            0 => width * (1.0 + a) / 2.0,
            2 => self.plateau_slope(),
            _ => width * (1.0 + a) * (1.0 + a * a + a.powi(4)) / 6.0,
        };
        flat + self.power_of_cutoff(n)
    }

    /// `power` at the cut-off. A power of the ratio itself keeps the digits that the exponential
    /// of a large logarithm loses.
    fn power_of_cutoff(&self, n: i32) -> f64 {
        let e = f64::from(n) - 2.0 * self.hurst;
        let ratio = self.wavenumbers[2] / self.wavenumbers[1];
        if (e * self.decades).abs() > 1.0 {
            (ratio.powf(e) - 1.0) / e
        } else {
            self.power(self.decades, n)
        }
    }

    /// `(1 - a^4)/4`, the plateau's share of m2.
    fn plateau_slope(&self) -> f64 {
        let a = self.plateau;
        self.plateau_width * (1.0 + a) * (1.0 + a * a) / 4.0
    }

    /// `int_1^y y^(n-1-2H) dy = (y^e - 1)/e`, `e = n - 2H`, at `ln y`; `ln y` itself for e = 0.
    fn power(&self, log_y: f64, n: i32) -> f64 {
        let e = f64::from(n) - 2.0 * self.hurst;
        if (e * log_y).abs() < 1e-300 { log_y } else { (e * log_y).exp_m1() / e }
    }

    /// `int_0^1 f(rho) q_L/q(rho) d rho` for an integrand of the given range.
    ///
    /// Up to twice the lowest wavenumber in `rho` itself, where `q` hardly changes; above in
    /// ln q, where `rho` hardly changes.
    pub(super) fn integrate(&self, range: Range, f: &impl Fn(f64) -> f64) -> f64 {
        let total = self.integral(2);
        let rho_at = |log_y: f64| {
            let below = if log_y < 0.0 {
                let ratio = (log_y - self.plateau.ln()).exp_m1(); // y/a - 1
                let a = self.plateau;
                a.powi(4) * ratio * (2.0 + ratio) * (1.0 + (1.0 + ratio) * (1.0 + ratio)) / 4.0
            } else {
                self.plateau_slope() + self.power(log_y, 2)
            };
            (below / total).sqrt().min(1.0)
        };
        let log_a = self.plateau.ln();
        let middle = (log_a + std::f64::consts::LN_2).min(self.decades);

        // Lower part, in rho. The kink at the roll-off is a limit of integration.
        let flat_end = (self.plateau_slope() / total).sqrt().min(1.0);
        let rho_middle = if middle < self.decades { rho_at(middle) } else { 1.0 };
        let weight = |rho: f64| f(rho) * (log_a - self.log_wavenumber(rho * rho * total)).exp();
        let mut sum = 0.0;
        if flat_end < rho_middle {
            sum += range.integrate(flat_end, rho_middle, weight);
        }
        sum += range.integrate(0.0, flat_end.min(rho_middle), weight);

        // Upper part, in ln y from the top down; the kink is a panel boundary.
        let mut b = self.decades;
        while b > middle && !range.is_negligible(rho_at(b)) {
            let mut a = middle.max(b - std::f64::consts::LN_2);
            if a < 0.0 && b > 0.0 {
                a = 0.0;
            }
            while range.steepness(rho_at(a), rho_at(b)) > 8.0 {
                a = 0.5 * (a + b);
            }
            if a >= b {
                break;
            }
            sum += gauss_legendre(a, b, 1.0, |log_y| {
                // d rho / d ln y = y^4 C/C0 / (2 rho total)
                let rho = rho_at(log_y);
                let log_density =
                    if log_y < 0.0 { 4.0 * log_y } else { (2.0 - 2.0 * self.hurst) * log_y };
                f(rho) * (log_a - log_y + log_density).exp() / (2.0 * rho * total)
            });
            b = a;
        }
        sum
    }

    /// `ln(q / q_r)` at which `int y^3 C/C0 dy` from the lower end has reached `below`.
    fn log_wavenumber(&self, below: f64) -> f64 {
        let flat = self.plateau_slope();
        if below <= flat {
            let a = self.plateau;
            return a.ln() + 0.25 * (4.0 * below / a.powi(4)).ln_1p();
        }
        let e = 2.0 - 2.0 * self.hurst;
        let u = below - flat;
        if (e * u).abs() < 1e-300 { u } else { (e * u).ln_1p() / e }
    }
}
