//! The contact map at every load of the slider: what the script needs to draw it.
//!
//! Of one surface, the load of first contact is one grey picture; a point touches at a load if its grey is not above
//! `STEP` times the index of the load. Points that come off again at a higher load are listed.

use crate::draw::palette::{PRESSURE_RAMP, ramp_table};
use crate::draw::png::Grey;
use crate::error::ReportError;
use crate::figures::maps::{self, Window};
use crate::numbers::{METRES, PASCALS, chosen, unit_for};
use crate::page::phrases::attribute;
use compare::{FirstContact, SurfaceComparison};
use serde_json::json;

/// Longest side drawn point by point; larger maps are reduced.
pub(crate) const LARGEST: usize = 1024;

/// The loads of a surface as the script draws them; `None` where there is nothing to move.
pub(crate) struct Moving<'a> {
    surface: &'a SurfaceComparison,
    contact: &'a FirstContact,
}

impl<'a> Moving<'a> {
    pub(crate) fn of(surface: &'a SurfaceComparison) -> Option<Self> {
        let contact = surface.first_contact.as_ref()?;
        let grid = surface.solved_map().grid();
        let fits = contact.first.len() == grid.len() && surface.deterministic.len() > 1;
        fits.then_some(Self { surface, contact })
    }

    /// Hidden pictures and facts behind the whole map: relief, and load of first contact.
    ///
    /// # Errors
    /// If a picture cannot be encoded.
    pub(crate) fn whole(&self, relief_limit: usize) -> Result<String, ReportError> {
        let grid = self.surface.solved_map().grid();
        let [ny, nx] = grid.shape();
        let loads = self.surface.deterministic.len();
        let (first, shape) = reduced(&self.contact.first, [ny, nx], LARGEST);
        let step = 240 / loads.max(1); // FirstContact keeps at most so many loads
        let grey = |load: u8| if load == FirstContact::NEVER { 255 } else { load as usize * step };
        let picture = Grey {
            width: shape[1],
            height: shape[0],
            values: first.iter().map(|&load| grey(load) as u8).collect(),
        };
        let lost: Vec<_> = if shape == [ny, nx] { self.contact.lost.clone() } else { Vec::new() };
        let points = grid.len();
        let titles: Vec<String> = self
            .surface
            .deterministic
            .iter()
            .map(|p| {
                let touching = p.answer.as_ref().map_or(0, |a| a.contact_pixels);
                let load = chosen(p.mean_pressure, PASCALS);
                format!("Contact map at {load}: {touching} of {points} points of the map carry pressure.")
            })
            .collect();
        let [r, g, b] = ramp_table::<3>(&PRESSURE_RAMP)[1].to_rgb();
        let ramp: String = ramp_table::<256>(&PRESSURE_RAMP)
            .iter()
            .flat_map(|c| c.to_rgb())
            .map(|v| format!("{v:02X}"))
            .collect();
        let unit = unit_for(grid.size()[1], METRES);
        let facts = json!({
            "step": step, "lost": lost, "titles": titles, "colour": [r, g, b], "ramp": ramp,
            "across": grid.size()[1] / unit.scale, "unit": unit.name,
        });
        let whole = [0, 0, ny, nx];
        Ok(format!(
            "<img class=\"first\" hidden alt=\"\" src=\"{}\" data-facts='{}'>\
             <img class=\"pressure\" hidden alt=\"\" src=\"{}\">{}",
            picture.data_address()?,
            attribute(&facts),
            self.pressure(shape)?,
            self.relief(whole, whole, relief_limit)?
        ))
    }

    /// The pressure of the headline in the dots of the contact: 0 where nothing touches, else 1 to 255 along the
    /// ramp.
    fn pressure(&self, [height, width]: [usize; 2]) -> Result<String, ReportError> {
        let grid = self.surface.solved_map().grid();
        let [ny, nx] = grid.shape();
        let (top, _) = maps::pressure_top(&self.surface.pressure);
        let dots = combined(&self.surface.pressure, [ny, nx], [height, width], f64::max);
        let class = |p: &f64| {
            if *p > 0.0 { ((p / top).min(1.0) * 255.0).round().max(1.0) as u8 } else { 0 }
        };
        let picture = Grey { width, height, values: dots.iter().map(class).collect() };
        Ok(picture.data_address()?)
    }

    /// The relief of a window, and where it lies in the whole map.
    ///
    /// # Errors
    /// If the picture cannot be encoded.
    pub(crate) fn relief(
        &self,
        window: Window,
        whole: Window,
        limit: usize,
    ) -> Result<String, ReportError> {
        let map = self.surface.solved_map();
        let picture = maps::relief(map.heights(), map.grid(), window, limit);
        let part = |i: usize| window[i] as f64 / whole[2 + i % 2] as f64;
        let place: Vec<String> = (0..4).map(|i| part(i).to_string()).collect();
        Ok(format!(
            "<img class=\"relief\" hidden alt=\"\" src=\"{}\" data-part=\"{}\">",
            picture.data_address()?,
            place.join(" ")
        ))
    }
}

/// The lowest of the loads that each dot covers, with at most `limit` dots along the longer side.
fn reduced(first: &[u8], [ny, nx]: [usize; 2], limit: usize) -> (Vec<u8>, [usize; 2]) {
    if ny.max(nx) <= limit {
        return (first.to_vec(), [ny, nx]);
    }
    let small = [ny, nx].map(|n| (n * limit / ny.max(nx)).max(1));
    (combined(first, [ny, nx], small, u8::min), small)
}

/// One value for the points that each dot covers; where a dot is less than a point wide, two share it.
fn combined<T: Copy>(
    field: &[T],
    [ny, nx]: [usize; 2],
    small: [usize; 2],
    both: impl Fn(T, T) -> T,
) -> Vec<T> {
    let span = |j: usize, n: usize, m: usize| j * n / m..((j + 1) * n).div_ceil(m);
    let dot = |y: usize, x: usize| {
        let rows = span(y, ny, small[0]).map(|iy| &field[iy * nx..][span(x, nx, small[1])]);
        rows.flatten().copied().reduce(&both).expect("a dot covers a point")
    };
    (0..small[0] * small[1]).map(|i| dot(i / small[1], i % small[1])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reduced_map_loses_no_contact() {
        let mut first = vec![FirstContact::NEVER; 7 * 10];
        first[6 * 10 + 9] = 3;
        first[6 * 10 + 8] = 5;
        let (small, shape) = reduced(&first, [7, 10], 5);
        assert_eq!(shape, [3, 5]);
        assert_eq!((small[14], small.iter().filter(|l| **l < 255).count()), (3, 1));
        assert_eq!(reduced(&first, [7, 10], 10), (first, [7, 10]));
    }
}
