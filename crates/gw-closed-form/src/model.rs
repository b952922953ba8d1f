//! The Greenwood-Williamson model with units.

use crate::inverse;
use crate::partial_moments::{self, Order};
use crate::products::{Quotient, factors, powers, product};
use contact_types::{
    AsperityStatistics, Caveat, Citation, ContactModel, ContactModulus, ContactState, ModelError,
    SeparationModel, SpectralMoments, require,
};
use core::f64::consts::PI;

const MODEL: &str = "Greenwood-Williamson";

/// Spherical summits of one radius and Gaussian heights, each in Hertz contact on its own.
///
/// With `a = d - y_s` (flat to mean summit plane) and α = a/σ_s:
///
/// ```math
/// \frac{p}{E^*} = \tfrac43\, \eta \sqrt R \int_a^\infty (z-a)^{3/2} \phi(z)\,dz, \qquad
/// \frac{A_r}{A_n} = \pi \eta R \int_a^\infty (z-a)\, \phi(z)\,dz
/// ```
///
/// Area and pressure fall with the separation to the last bit. They are right to the rounding of
/// `d - y_s` and α (3e-15 at α = 5, growing with α²); the area at a pressure is right to 2e-15.
///
/// # Validity
/// Summits must not feel each other: a [`Caveat::BeyondModel`] is attached above an area fraction
/// of 0.1, and if the moments belong to no isotropic Gaussian surface (bandwidth below 3/2). The
/// area fraction is not clipped and exceeds 1 at large overlap.
///
/// ```
/// use contact_types::{AsperityStatistics, ContactModel, ContactModulus};
/// use gw_closed_form::GreenwoodWilliamson;
///
/// // Typed in by hand: 3e10 summits per m², radius 8 µm, deviation 0.3 µm, mean height 0.2 µm.
/// let asperities =
///     AsperityStatistics { density: 3e10, radius: 8e-6, height_std: 0.3e-6, mean_offset: 0.2e-6 };
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// let contact = GreenwoodWilliamson::new(asperities, modulus)?.at_pressure(50e6)?;
/// assert!((contact.area_fraction - 0.006_581_328_111_413).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Greenwood & Williamson (1966), doi:10.1098/rspa.1966.0242; Jackson & Green, IJTC2009-15106,
/// eqs. (1) and (2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodWilliamson {
    asperities: AsperityStatistics,
    modulus: ContactModulus,
    /// Only known if the model was made from moments.
    bandwidth: Option<f64>,
}

impl GreenwoodWilliamson {
    /// From asperity statistics typed in or measured.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless density, radius and height deviation are finite and
    /// positive and the mean offset is finite.
    pub fn new(
        asperities: AsperityStatistics,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        for (quantity, value) in [
            ("asperity density", asperities.density),
            ("asperity radius", asperities.radius),
            ("asperity height deviation", asperities.height_std),
        ] {
            require::positive(MODEL, quantity, value)?;
        }
        require::finite(MODEL, "mean offset", asperities.mean_offset)?;
        Ok(Self { asperities, modulus, bandwidth: None })
    }

    /// From the moments of a surface, by [`AsperityStatistics::from_moments`].
    ///
    /// # Errors
    /// As [`AsperityStatistics::from_moments`].
    pub fn from_moments(
        moments: SpectralMoments,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let model = Self::new(AsperityStatistics::from_moments(moments)?, modulus)?;
        Ok(Self { bandwidth: Some(moments.bandwidth()), ..model })
    }

    /// Normal stiffness per nominal area, -dp/dd [Pa/m], at `separation` (m):
    /// `2 E* η √R √σ_s J_1/2(α)`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the separation is not finite,
    /// [`ModelError::OutsideDomain`] if the result exceeds the largest double.
    pub fn stiffness(&self, separation: f64) -> Result<f64, ModelError> {
        let a = self.height_above_summit_mean(separation)?;
        // -dI_ep/da = (3/2) σ_s^{1/2} J_1/2(α)
        let [_, root, j] = factors(Order::Half, a, self.asperities.height_std);
        let stiffness = self.scaled(Order::ThreeHalves, [1.5, root, j]);
        require::answer(MODEL, stiffness, "separation", separation)
    }

    /// a = d - y_s [m].
    fn height_above_summit_mean(&self, separation: f64) -> Result<f64, ModelError> {
        Ok(require::finite(MODEL, "separation", separation)? - self.asperities.mean_offset)
    }

    /// What an integral is multiplied by: (4/3) E* η √R of order 3/2 for the pressure \[Pa\], π η R of order 1
    /// for the area \[-\].
    fn scale(&self, order: Order) -> [f64; 4] {
        let AsperityStatistics { density, radius, .. } = self.asperities;
        if order == Order::One {
            return [PI, density, radius, 1.0];
        }
        // Hertz: F = (4/3) E* R^(1/2) overlap^(3/2)
        [4.0 / 3.0, self.modulus.pascals(), density, libm::sqrt(radius)]
    }

    /// That scale times an integral given by its factors.
    fn scaled(&self, order: Order, [i, j, k]: [f64; 3]) -> f64 {
        let [a, b, c, d] = self.scale(order);
        product(&[a, b, c, d, i, j, k])
    }

    fn state(&self, mean_pressure: f64, area_fraction: f64, separation: f64) -> ContactState {
        let state = ContactState::of_isolated_summits(mean_pressure, area_fraction, separation);
        let narrow = self.bandwidth.filter(|&b| b < 1.5 - 1e-12);
        match (&state.caveat, narrow) {
            (Some(Caveat::Underflow { .. }), _) | (_, None) => state,
            (_, Some(value)) => ContactState {
                caveat: Some(Caveat::BeyondModel {
                    quantity: "bandwidth".into(),
                    value,
                    limit: 1.5,
                    reason: "no isotropic Gaussian surface has so narrow a spectrum".into(),
                }),
                ..state
            },
        }
    }
}

impl ContactModel for GreenwoodWilliamson {
    fn citation(&self) -> Citation {
        let title = "Contact of nominally flat surfaces";
        let journal = "Proceedings of the Royal Society of London A 295, 300-319";
        Citation::new("Greenwood & Williamson", 1966, title, journal, "10.1098/rspa.1966.0242")
    }

    /// The contact at a mean pressure. At 0 nothing touches and there is no finite separation.
    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        if mean_pressure <= 0.0 {
            return Ok(ContactState::default());
        }
        let AsperityStatistics { height_std: s, mean_offset, .. } = self.asperities;
        let answer = |result| require::answer(MODEL, result, "mean pressure", mean_pressure);
        let ([a, b, c, d], [i, j]) =
            (self.scale(Order::ThreeHalves), powers(Order::ThreeHalves, s));
        let load = Quotient::of(mean_pressure, &[a, b, c, d, i, j]);
        let alpha = alpha_of(load)?;
        let separation = answer(mean_offset + alpha * s)?;
        let [i, j] = powers(Order::One, s);
        let area = answer(self.scaled(Order::One, [i, j, area_at(alpha, load.value)]))?;
        Ok(self.state(mean_pressure, area, separation))
    }
}

impl SeparationModel for GreenwoodWilliamson {
    fn at_separation(&self, separation: f64) -> Result<ContactState, ModelError> {
        let a = self.height_above_summit_mean(separation)?;
        let [pressure, area] = [Order::ThreeHalves, Order::One].map(|order| {
            let integral = factors(order, a, self.asperities.height_std);
            require::answer(MODEL, self.scaled(order, integral), "separation", separation)
        });
        Ok(self.state(pressure?, area?, separation))
    }
}

/// J_1 at the α where J_3/2 is `load`.
///
/// α is a rounded number, and both change by α² times its rounding. What the load still lacks
/// at this α can be computed, so the area is moved along with it.
fn area_at(alpha: f64, load: f64) -> f64 {
    let j = partial_moments::value(Order::ThreeHalves, alpha);
    let representable = load.is_normal() && j.is_normal();
    let missing = if representable { load / j - 1.0 } else { 0.0 };
    let elasticity = partial_moments::ln_derivative(Order::One, alpha)
        / partial_moments::ln_derivative(Order::ThreeHalves, alpha);
    partial_moments::value(Order::One, alpha) * (1.0 + missing * elasticity)
}

/// α where J_3/2(α) is the quotient, also where no double can hold that.
fn alpha_of(load: Quotient) -> Result<f64, ModelError> {
    let found = if load.value.is_normal() {
        inverse::from_value(load.value)
    } else {
        inverse::from_ln(load.logarithm)
    };
    found.ok_or_else(|| {
        require::refused(MODEL, "ln of the dimensionless load", load.logarithm, "must be below 708")
    })
}
