//! Two bodies pressed together, in words.

use crate::numbers::{
    METRES, PASCALS, SPACE, chosen, percent, points_of, quantity, signed_percent, significant,
};
use contact_compare::{Body, Flip, Independence, PairOrigin, Settings};

fn turned(flip: Flip) -> &'static str {
    match flip {
        Flip::Columns => "turned over as a book is closed, its first column on the last",
        Flip::Rows => "turned over as a page of a wall calendar, its first row on the last",
        Flip::None => "laid on as its map stands, not turned over",
    }
}

fn moved(way: f64) -> String {
    if way == 0.0 { "0".to_owned() } else { quantity(way, METRES, 4) }
}

/// How the bodies lie, as plain text.
pub(crate) fn lying(pair: &PairOrigin) -> String {
    let [first, second] = &pair.names;
    let mut text = format!("{second} lies on {first}, {}", turned(pair.placing.flip));
    let Some((placed, _)) = &pair.found else { return text };
    let [dy, dx] = placed.shift;
    if dy != 0.0 || dx != 0.0 {
        text += &format!(", moved by {} along x and {} along y", moved(dx), moved(dy));
        text += if placed.is_rolled {
            " (what leaves on one side comes in on the other)"
        } else {
            " (in whole points; only the part in common is kept)"
        };
    }
    let differs = |(is, asked): (&f64, f64)| (is - asked).abs() > 1e-9 * asked.abs();
    if placed.shift.iter().zip(pair.placing.shift).any(differs) {
        let [dy, dx] = pair.placing.shift;
        text += &format!("; {} and {} were asked for", moved(dx), moved(dy));
    }
    text += &format!("; {} in common", points_of(placed.common));
    let shares = placed.shares;
    if shares.iter().any(|share| *share < 0.999) {
        let [a, b] = shares.map(percent);
        text += &format!(", {a} of {first} and {b} of {second}");
    }
    for (name, is_new) in pair.names.iter().zip(placed.resampled) {
        if is_new {
            text += &format!("; {name} interpolated at the points of the other");
        }
    }
    text
}

/// "m0 +0.3 %, m2 −0.1 %, m4 +0.0 %".
pub(crate) fn excess(found: &Independence) -> String {
    let one = |(name, value): (&str, &f64)| format!("{name} {}", signed_percent(*value));
    ["m₀", "m₂", "m₄"].into_iter().zip(&found.excess).map(one).collect::<Vec<_>>().join(", ")
}

fn chance(found: &Independence) -> String {
    let [a, b, c] = found.chance.map(|x| significant(100.0 * x, 2));
    format!("standard deviation by chance {a}, {b} and {c}{SPACE}%")
}

/// Whose moments the models have, as plain text.
pub(crate) fn moments(pair: &PairOrigin) -> Option<String> {
    let (_, found) = pair.found.as_ref()?;
    let whose = "every model has those of the sum of both surfaces";
    if found.bodies.iter().any(|body| body.m0 <= 0.0) {
        return Some(whose.to_owned());
    }
    let (excess, chance) = (excess(found), chance(found));
    Some(format!(
        "{whose}; they differ from the sums of the moments of the two by {excess} ({chance})"
    ))
}

pub(crate) fn dependent([first, second]: &[String; 2], found: &Independence) -> [String; 2] {
    let how = if found.excess[1] < 0.0 { "fit into each other" } else { "meet high on high" };
    let (excess, chance) = (excess(found), chance(found));
    [
        format!("{first} and {second} {how}."),
        format!(
            "Moments of the sum differ from the sums of those of the two by {excess}; {chance}. The two are not \
             independent where they lie: another place (shifted, or flipped otherwise) gives another area."
        ),
    ]
}

pub(crate) fn pixels_differ(names: &[String; 2], pixels: [[f64; 2]; 2]) -> [String; 2] {
    let sizes = pixels.map(|p| p[0].max(p[1]));
    let (fine, coarse) = if sizes[0] < sizes[1] { (0, 1) } else { (1, 0) };
    let [first, second] = sizes.map(|size| quantity(size, METRES, 3));
    let (fine, coarse, wave) =
        (&names[fine], &names[coarse], quantity(2.0 * sizes[coarse], METRES, 2));
    [
        format!("The bodies were measured at different point spacings: {first} and {second}."),
        format!(
            "{coarse} was interpolated at the points of {fine}, which adds no wave: its waves shorter than {wave} are \
             not in the sum, and the area depends on the shortest waves."
        ),
    ]
}

pub(crate) fn common_part(names: &[String; 2], shares: [f64; 2]) -> [String; 2] {
    let [a, b] = shares.map(percent);
    [
        format!("{a} of {} and {b} of {} lie on each other.", names[0], names[1]),
        "Only the common part is solved, and a load is one on its area.".to_owned(),
    ]
}

/// "E = 210 GPa, ν = 0.3".
pub(crate) fn of_body(body: &Body) -> String {
    let poisson = format!("{}", body.poisson).replace('-', "\u{2212}");
    format!("E = {}, ν = {poisson}", chosen(body.young, PASCALS))
}

/// What each body of a pair is made of, with the modulus of both.
pub(crate) fn bodies(names: [&str; 2], bodies: &[Body], modulus: f64) -> String {
    let [first, second] = names;
    let modulus = quantity(modulus, PASCALS, 4);
    match bodies {
        [a, b] => format!("{first} {}; {second} {} (E* = {modulus})", of_body(a), of_body(b)),
        [a] => format!("{first} {}; {second} rigid (E* = {modulus})", of_body(a)),
        _ => format!("E* = {modulus} as given, without saying what each body is made of"),
    }
}

/// E*, and which bodies press on each other, as plain text.
pub fn bodies_line(modulus: f64, bodies: &[Body]) -> String {
    let modulus = quantity(modulus, PASCALS, 4);
    let line = match bodies {
        [] => format!("E* = {modulus} as given: of one body against a rigid flat, or of two"),
        [body] => format!("E* = {modulus}: {}, against a rigid flat", of_body(body)),
        [a, b, ..] => format!("E* = {modulus}: {}, against {}", of_body(a), of_body(b)),
    };
    line.replace(SPACE, " ")
}

/// The lines of a terminal on a pair: how it lies, what it is made of, whose moments count.
pub fn pair_lines(pair: &PairOrigin, settings: Option<&Settings>) -> Vec<String> {
    let mut lines = vec![format!("pair: {}", lying(pair))];
    let names = pair.names.each_ref().map(String::as_str);
    lines.extend(settings.map(|s| format!("bodies: {}", bodies(names, &s.bodies, s.modulus))));
    lines.extend(moments(pair).map(|text| format!("moments: {text}")));
    lines.into_iter().map(|line| line.replace(SPACE, " ")).collect()
}
