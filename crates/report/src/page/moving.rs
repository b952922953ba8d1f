//! The contact map at every load of the slider: what the script needs to draw it.
//!
//! Of one surface, the load of first contact is one grey picture; a point touches at a load if its grey is not above
//! `STEP` times the index of the load. Points that come off again at a higher load are listed. Its colours are the
//! pressures of that load, in dots that may cover more than one point: one picture a load.

use crate::draw::palette::{OkLab, PRESSURE_RAMP, ramp_table};
use crate::draw::png;
use crate::figures::maps::{self, MapPart, combined};
use crate::numbers::{METRES, PASCALS, quantity, unit_for};
use crate::page::shared::attribute;
use contact_compare::{
    DeterministicPoint, FirstContact, PressureMap, PressureMaps, SurfaceComparison, pressure_class,
    pressure_top,
};
use grid_fft::parallel::{self, join};
use serde_json::json;

/// Longest side drawn point by point; larger maps are reduced.
pub(crate) const LARGEST: usize = 1024;

/// Bytes that the pressures of all surfaces of a page may take.
const PRESSURES: usize = 750_000;

/// Steps of a scale of pressures, the finest that the page bears first; the fewest are those of the section.
const STEPS: [u8; 3] = [255, 63, maps::FEWEST_STEPS];

/// A class of 255 on a scale of fewer steps.
fn stepped(class: u8, steps: u8) -> u8 {
    let (part, steps) = (f64::from(class) / 255.0, f64::from(steps));
    let step = (part * steps).round().max(f64::from(class.min(1)));
    (step / steps * 255.0).round() as u8
}

/// The load of first contact, where the script has something to move.
pub(crate) fn moves(surface: &SurfaceComparison) -> Option<&FirstContact> {
    let all = surface.solved_map().grid().len();
    let contact = surface.first_contact.as_ref()?;
    (contact.first.len() == all && surface.deterministic.len() > 1).then_some(contact)
}

/// Hidden pictures and facts behind the whole map: relief, load of first contact, pressures. The page is of so many `surfaces`.
pub(crate) fn whole(
    surface: &SurfaceComparison,
    contact: &FirstContact,
    relief_limit: usize,
    surfaces: usize,
) -> String {
    let grid = surface.solved_map().grid();
    let [ny, nx] = grid.shape();
    let loads = surface.deterministic.len();
    let (first, shape) = reduced(&contact.first, [ny, nx], LARGEST);
    let step = 240 / loads.max(1); // FirstContact keeps at most so many loads
    let grey = |load: u8| if load == u8::MAX { 255 } else { load as usize * step };
    let first: Vec<u8> = first.iter().map(|&load| grey(load) as u8).collect();
    let (top, _) = pressure_top(&surface.pressure);
    let ((Pressures { block, tops, pictures }, headline), (first, relief)) = join(
        || join(|| pressures(surface, top, surfaces), || pressure(surface, top, shape)),
        || join(|| png::classes(shape, &first), || relief(surface, [0, 0, ny, nx], relief_limit)),
    );
    let lost: Vec<_> = if shape == [ny, nx] { contact.lost.clone() } else { Vec::new() };
    let points = grid.len();
    let title = |p: &DeterministicPoint| {
        let found = p.answer.as_ref().map(|a| &a.diagnostics);
        let (touching, highest) = found.map_or((0, 0.0), |d| (d.contact_pixels, d.max_pressure));
        let load = crate::messages::load(p.mean_pressure, surface.load_area);
        let highest = quantity(highest, PASCALS, 2);
        format!(
            "Contact map at {load}: {touching} of {points} points of the map carry pressure, at most {highest}."
        )
    };
    let titles: Vec<String> = surface.deterministic.iter().map(title).collect();
    let middle = ramp_table::<3>(&PRESSURE_RAMP)[1].to_rgb();
    let ramp: String = ramp_table::<256>(&PRESSURE_RAMP).map(OkLab::hex).concat();
    let unit = unit_for(grid.size()[1], METRES);
    let facts = attribute(&json!({
        "step": step, "lost": lost, "titles": titles, "colour": middle, "ramp": ramp,
        "across": grid.size()[1] / unit.scale, "unit": unit.name,
        "points": [ny, nx], "block": block, "tops": tops,
    }));
    format!(
        "<img class=\"first\" hidden alt=\"\" src=\"{first}\" data-facts='{facts}'>\
         <img class=\"pressure\" hidden alt=\"\" src=\"{headline}\">{pictures}{relief}"
    )
}

/// The pressure of the headline by dots: 0 where nothing touches, else 1 to 255 along the ramp, which ends at `top`.
fn pressure(surface: &SurfaceComparison, top: f64, shape: [usize; 2]) -> String {
    let pressure = &surface.pressure;
    let dots = combined(pressure, surface.solved_map().grid().shape(), shape, f64::max);
    let classes: Vec<u8> = dots.iter().map(|p| pressure_class(*p, top)).collect();
    png::classes(shape, &classes)
}

/// The relief of a window, and where it lies in the whole map.
pub(crate) fn relief(surface: &SurfaceComparison, window: MapPart, limit: usize) -> String {
    let map = surface.solved_map();
    let picture = maps::relief(map.heights(), map.grid(), window, limit);
    let part = |i: usize| (window[i] as f64 / map.grid().shape()[i % 2] as f64).to_string();
    let place = [0, 1, 2, 3].map(part).join(" ");
    format!(r#"<img class="relief" hidden alt="" src="{picture}" data-part="{place}">"#)
}

/// The pressures of the loads besides that of the headline.
#[derive(Default)]
struct Pressures {
    /// Points along the side of a dot.
    block: usize,
    /// Of each load that has a picture, the number at the end of its bar, in the unit of the headline.
    tops: Vec<Option<String>>,
    pictures: String,
}

/// In as many steps as a page of so many `surfaces` bears, else of fewer loads; the bar of the headline ends at `top`.
fn pressures(surface: &SurfaceComparison, top: f64, surfaces: usize) -> Pressures {
    let Some(maps) = &surface.pressure_maps else { return Pressures::default() };
    let most = PRESSURES / surfaces.max(1);
    let mut encoded = Vec::new();
    for steps in STEPS {
        encoded = encoded_until(maps, surface.headline, steps, most);
        if encoded.iter().map(String::len).sum::<usize>() <= most {
            break;
        }
    }
    let bytes: Vec<usize> = encoded.iter().map(String::len).collect();
    let unit = unit_for(top, PASCALS);
    let (mut tops, mut pictures) = (vec![None; maps.loads.len().max(1)], String::new());
    for load in within(&bytes, most).into_iter().filter(|load| *load != surface.headline) {
        let PressureMap { top, clipped, .. } = maps.loads[load];
        tops[load] = Some(maps::upper_end(top, clipped, unit));
        let picture = &encoded[load];
        pictures +=
            &format!(r#"<img class="pressed" hidden alt="" data-load="{load}" src="{picture}">"#);
    }
    Pressures { block: maps.block, tops, pictures }
}

const AT_ONCE: usize = 4;

/// The pictures of all loads but the headline, whose place stays empty. Ends early where they take more than `most`
/// bytes and there are coarser steps.
fn encoded_until(maps: &PressureMaps, headline: usize, steps: u8, most: usize) -> Vec<String> {
    let table: [u8; 256] = std::array::from_fn(|class| stepped(class as u8, steps));
    let picture = |load: usize| {
        if load == headline {
            return String::new();
        }
        let classes = maps.loads[load].classes.iter().map(|c| table[usize::from(*c)]);
        png::classes(maps.shape, &classes.collect::<Vec<u8>>())
    };
    let mut encoded: Vec<String> = Vec::new();
    // The heaviest, which take most, first: what does not fit is soon known.
    let heaviest_first: Vec<usize> = (0..maps.loads.len()).rev().collect();
    for loads in heaviest_first.chunks(AT_ONCE) {
        encoded.extend(parallel::map(loads, |load| picture(*load)));
        let bytes: usize = encoded.iter().map(String::len).sum();
        if bytes > most && steps > maps::FEWEST_STEPS {
            break;
        }
    }
    encoded.reverse();
    encoded
}

/// Of loads that take so many bytes all, or every second, every fourth, until they take no more than `most`; the
/// lightest and the heaviest in any case.
fn within(bytes: &[usize], most: usize) -> Vec<usize> {
    let last = bytes.len().saturating_sub(1);
    let every = |stride: usize| -> Vec<usize> {
        (0..bytes.len()).filter(|i| *i == 0 || (last - i).is_multiple_of(stride)).collect()
    };
    let strides = std::iter::successors(Some(1_usize), |s| s.checked_mul(2));
    let all = |loads: &[usize]| loads.iter().map(|i| bytes[*i]).sum::<usize>();
    strides.map(every).find(|kept| all(kept) <= most || kept.len() < 3).unwrap_or_default()
}

/// The lowest of the loads that each dot covers, with at most `limit` dots along the longer side.
fn reduced(first: &[u8], [ny, nx]: [usize; 2], limit: usize) -> (Vec<u8>, [usize; 2]) {
    if ny.max(nx) <= limit {
        return (first.to_vec(), [ny, nx]);
    }
    let small = [ny, nx].map(|n| (n * limit / ny.max(nx)).max(1));
    (combined(first, [ny, nx], small, u8::min), small)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fewer_steps_keep_contact_and_the_order_of_pressures() {
        for steps in STEPS {
            let all: Vec<u8> = (0..=255).map(|class| stepped(class, steps)).collect();
            assert!(all.is_sorted() && all[0] == 0 && all[1] > 0 && all[255] == 255);
            let half = 0.5 * 255.0 / f64::from(steps) + 0.5;
            let off = |(class, shown): (usize, &u8)| (class as f64 - f64::from(*shown)).abs();
            assert!(all.iter().enumerate().skip(5).all(|c| off(c) <= half), "{steps}");
        }
        assert!((0..=255).all(|class| stepped(class, 255) == class));
    }

    #[test]
    fn as_many_loads_as_the_page_bears() {
        let bytes = [10, 20, 30, 40, 50, 60];
        assert_eq!(within(&bytes, 210), [0, 1, 2, 3, 4, 5]);
        assert_eq!(within(&bytes, 209), [0, 1, 3, 5]);
        assert_eq!(within(&bytes, 90), [0, 1, 5]);
        assert_eq!(within(&bytes, 0), [0, 5]);
        assert_eq!((within(&[7], 0), within(&[], 0)), (vec![0], vec![]));
    }

    #[test]
    fn a_reduced_map_loses_no_contact() {
        let mut first = vec![u8::MAX; 7 * 10];
        first[6 * 10 + 9] = 3;
        first[6 * 10 + 8] = 5;
        let (small, shape) = reduced(&first, [7, 10], 5);
        assert_eq!(shape, [3, 5]);
        assert_eq!((small[14], small.iter().filter(|l| **l < 255).count()), (3, 1));
        assert_eq!(reduced(&first, [7, 10], 10), (first, [7, 10]));
    }
}
