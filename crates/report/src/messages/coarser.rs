//! What a coarser grid would have cost in accuracy: its place in Fig. 4 and on the first screen.

use crate::draw::palette::{DETERMINISTIC_STYLE, INK2, Style};
use crate::figures::cost::CostRoute;
use crate::lines::WANTED;
use crate::numbers::{duration, signed_percent};
use contact_compare::{Coarser, SurfaceComparison};

/// A filled dot as the deterministic solution has, in the grey of notes.
const LOOK: Style = Style { colour: INK2, ..DETERMINISTIC_STYLE };

/// "½ grid": half as many points along each side.
fn label(factor: usize) -> String {
    match factor {
        2 => "½ grid".into(),
        4 => "¼ grid".into(),
        8 => "⅛ grid".into(),
        other => format!("1/{other} grid"),
    }
}

/// The coarser grids as routes to an answer.
pub(crate) fn routes(surface: &SurfaceComparison) -> impl Iterator<Item = CostRoute> {
    surface.coarser.iter().map(|c| CostRoute::new(label(c.factor), LOOK, c.seconds, c.error))
}

/// The coarsest grid that is within the wanted error together with all finer ones: a coarse grid
/// that is near while a finer one is not is near by chance.
fn cheapest(grids: &[Coarser]) -> Option<&Coarser> {
    grids.iter().take_while(|c| c.error.abs() <= WANTED).last()
}

/// That grid with its error and time; `None` if no coarser grid comes that near.
pub(crate) fn cheapest_words(surface: &SurfaceComparison) -> Option<[String; 2]> {
    let grid = cheapest(&surface.coarser)?;
    let [ny, nx] = grid.shape;
    let words = format!("{}, {}", signed_percent(grid.error), duration(grid.seconds));
    Some([format!("Solver on {nx} × {ny} points"), words])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(factor: usize, error: f64) -> Coarser {
        Coarser {
            factor,
            shape: [512 / factor; 2],
            touching_fraction: 0.02,
            area_fraction: 0.02,
            error,
            seconds: 1.0,
        }
    }

    #[test]
    fn a_grid_that_is_near_by_chance_is_not_recommended() {
        let chosen = |errors: [f64; 3]| {
            let grids = [2, 4, 8].into_iter().zip(errors).map(|(f, e)| grid(f, e));
            cheapest(&grids.collect::<Vec<_>>()).map(|c| c.factor)
        };
        assert_eq!(chosen([0.01, 0.05, 0.30]), Some(4));
        assert_eq!(chosen([-0.01, -0.05, 0.09]), Some(8));
        assert_eq!(chosen([0.12, 0.05, 0.02]), None);
    }
}
