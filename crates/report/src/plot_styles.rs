//! What the report knows of each closed form: how it is drawn, and the symbols of its inputs. Both
//! by the name of the model; one that is not in this list is drawn in a reserve.

use crate::draw::palette::{
    BGT, DETERMINISTIC, DETERMINISTIC_STYLE, ELLIPTICAL, EQUATION, GW, INK2, MAJUMDAR_BHUSHAN,
    MULTISCALE, Marker, PERSSON, STACKED, Style, WARN,
};
use crate::draw::svg::escape;
use contact_compare::Card;

/// Name, look, and inputs as HTML symbols.
const STYLES: [(&str, Style, &str); 14] = [
    ("gw", Style::model(GW, "6 2.5", Marker::Square, 1), MOMENTS),
    ("bgt", Style::model(BGT, "2 2", Marker::TriangleUp, 2), MOMENTS),
    ("greenwood-elliptical", Style::model(ELLIPTICAL, "", Marker::Diamond, 3), MOMENTS),
    ("persson", Style::model(PERSSON, "8 2 1.5 2", Marker::TriangleDown, 0), M2),
    ("stacked", Style::model(STACKED, "4 2 1 2 1 2", Marker::Cross, 2), "<i>B</i><sub>max</sub>"),
    ("multiscale", Style::model(MULTISCALE, "10 2 2 2", Marker::Hexagon, 3), "<i>Δ</i>(<i>f</i>)"),
    ("archard", Style::model(STACKED, "1 3", Marker::Diamond, 0), "<i>R</i>, <i>m</i>"),
    ("majumdar-bhushan", Style::model(MAJUMDAR_BHUSHAN, "1 2.5", Marker::Plus, 1), FRACTAL),
    ("yan-komvopoulos", Style::model(MAJUMDAR_BHUSHAN, "6 1 1 1", Marker::Square, 2), FRACTAL),
    ("equation", Style::model(EQUATION, "", Marker::Hexagon, 1), MOMENTS),
    ("ceb", Style::model(GW, "3 1.5", Marker::Plus, 3), CEB),
    ("persson-yield", Style::model(PERSSON, "3 1.5 1 1.5", Marker::Hexagon, 2), M2_H),
    ("cmy", Style::model(BGT, "6 1 1 1", Marker::Diamond, 1), "<i>σ</i>, <i>m</i>, <i>H</i>"),
    ("mikic", Style::model(BGT, "9 3", Marker::Cross, 3), "<i>σ</i>, <i>m</i>, <i>E</i>*"),
];

const MOMENTS: &str = "<i>m</i><sub>0</sub>, <i>m</i><sub>2</sub>, <i>m</i><sub>4</sub>";
const CEB: &str =
    "<i>m</i><sub>0</sub>, <i>m</i><sub>2</sub>, <i>m</i><sub>4</sub>, <i>H</i>, <i>ν</i>";
const M2: &str = "<i>m</i><sub>2</sub>";
const M2_H: &str = "<i>m</i><sub>2</sub>, <i>H</i>";
const FRACTAL: &str = "<i>D</i>, <i>G</i>";

/// Methods of the solver by precision, and the area as its pixels are counted.
const SOLVER: [(&str, Style); 7] = [
    ("chord f64", DETERMINISTIC_STYLE),
    ("chord f32", Style { width: 1.2, ..Style::model(DETERMINISTIC, "3 2", Marker::Ring, 0) }),
    ("chord counted", Style::model(INK2, "4 2", Marker::Ring, 0)),
    ("polonsky-keer f64", Style::model(INK2, "", Marker::Square, 0)),
    ("polonsky-keer f32", Style::model(INK2, "3 2", Marker::Diamond, 0)),
    ("stanley-kato f64", Style::model(WARN, "", Marker::TriangleUp, 0)),
    ("stanley-kato f32", Style::model(WARN, "3 2", Marker::TriangleDown, 0)),
];

/// For models that are not in the list, in their order in the study.
const RESERVE: [Style; 4] = [
    Style::model(INK2, "5 2", Marker::Square, 1),
    Style::model(INK2, "2 3", Marker::TriangleUp, 2),
    Style::model(INK2, "9 3", Marker::Diamond, 3),
    Style::model(INK2, "1 1.5", Marker::TriangleDown, 0),
];

/// How a model, or a method of the solver with its precision, is drawn; one of the reserve by its `place` in the study if
/// its name is not known.
pub(crate) fn plot_style(name: &str, place: usize) -> Style {
    let mut known = STYLES.iter().map(|row| (row.0, row.1)).chain(SOLVER);
    known.find(|row| row.0 == name).map_or(RESERVE[place % RESERVE.len()], |row| row.1)
}

/// What a model is made of, as HTML symbols; in its own words if its name is not known.
pub(crate) fn inputs_html(card: &Card) -> String {
    let known = STYLES.iter().find(|row| row.0 == card.name);
    known.map_or_else(|| escape(&card.needs), |row| row.2.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Models that have a look are drawn in a way of their own; strangers differ from all of them.
    #[test]
    fn every_model_has_its_own_look() {
        let looks: Vec<Style> = STYLES.iter().map(|row| row.1).chain(RESERVE).collect();
        for (i, look) in looks.iter().enumerate() {
            assert!(!looks[..i].contains(look), "{i}");
        }
    }
}
