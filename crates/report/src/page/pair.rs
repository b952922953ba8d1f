//! Two bodies on the page: how they lie, what each adds.

use crate::draw::svg::escape;
use crate::messages::pair::{lying, moments};
use crate::numbers::{METRES, quantity, signed_percent, significant};
use contact_compare::{PairFound, PairOrigin};
use contact_types::SpectralMoments;

/// What the section on the surface opens with: the sum of two bodies is no surface one could see.
pub(crate) fn opening(pair: &PairOrigin) -> String {
    let [first, second] = pair.names.each_ref().map(|name| escape(name));
    let whose =
        moments(pair).map_or_else(String::new, |text| format!(" Moments: {}.", escape(&text)));
    format!(
        "<p>Neither of the two: the heights below are those of {first} and {second} added at each place, the \
         rough surface that touches a smooth flat as the two touch each other. {}.{whose}</p>\n{}",
        escape(&lying(pair)),
        pair.found.as_ref().map_or_else(String::new, |found| table(pair, found))
    )
}

fn table(pair: &PairOrigin, found: &PairFound) -> String {
    let independence = &found.independence;
    let row = |name: &str, m: &SpectralMoments| {
        format!(
            "<tr><th scope=\"row\">{name}</th><td class=\"n\">{}</td><td class=\"n\">{}</td>\
             <td class=\"n\">{}</td><td class=\"n\">{} m⁻²</td></tr>\n",
            quantity(m.rms_height(), METRES, 3),
            significant(m.rms_gradient(), 3),
            significant(m.m2, 3),
            significant(m.m4, 3)
        )
    };
    let [first, second] = pair.names.each_ref().map(|name| escape(name));
    let [_, m2, m4] = independence.excess.map(signed_percent);
    // The gradient is the root of m2.
    let of_root = |excess: f64| signed_percent((1.0 + excess).max(0.0).sqrt() - 1.0);
    let [height, gradient] = [independence.excess[0], independence.excess[1]].map(of_root);
    format!(
        "<table class=\"stat\"><caption>What each body adds</caption><thead><tr><td></td>\
         <th scope=\"col\" class=\"n\">rms height</th><th scope=\"col\" class=\"n\">rms gradient</th>\
         <th scope=\"col\" class=\"n\"><i>m</i><sub>2</sub></th>\
         <th scope=\"col\" class=\"n\"><i>m</i><sub>4</sub></th></tr></thead><tbody>\n{}{}{}{}\
         <tr><th scope=\"row\">both as one, over that</th><td class=\"n\">{height}</td>\
         <td class=\"n\">{gradient}</td><td class=\"n\">{m2}</td><td class=\"n\">{m4}</td></tr>\n\
         </tbody></table>\n",
        row(&first, &independence.bodies[0]),
        row(&second, &independence.bodies[1]),
        row("if independent: sums of <i>m</i>", &independence.sum()),
        row("both as one, in the models", &independence.composite),
    )
}
