//! Whether the bodies stick, in words: claim and text.

use crate::numbers::{METRES, PASCALS, chosen, length, percent, quantity, significant};
use contact_compare::{Adhesion, NO_PULL_OFF};

pub(crate) fn verdict(found: &Adhesion) -> [String; 2] {
    let claim = if found.negligible {
        "Adhesion is negligible (dry).".to_owned()
    } else {
        "Adhesion is not negligible: this program does not model it.".to_owned()
    };
    if found.given.work <= 0.0 {
        return [claim, "The work of adhesion is 0.".to_owned()];
    }
    let joules = |w: f64| {
        let (scale, unit) = if w.abs() < 1.0 { (1e3, "mJ/m²") } else { (1.0, "J/m²") };
        format!("{} {unit}", significant(scale * w, 2))
    };
    let mut parts = vec![match found.fuller_tabor {
        Some(theta) => format!(
            "Fuller and Tabor’s parameter is {} (pull-off below about {NO_PULL_OFF:.0}; 1975)",
            significant(theta, 2)
        ),
        None => "Fuller and Tabor’s parameter cannot be said without summits".to_owned(),
    }];
    if let Some(criterion) = found.pastewka_robbins {
        parts.push(format!(
            "Pastewka and Robbins’s {} (light contact sticks below {}; 2014, disputed)",
            significant(criterion, 2),
            significant(found.sticky, 3)
        ));
    }
    if let Some((left, energy)) = found.effective_work.zip(found.full_contact_energy) {
        let what = if left > 0.0 { "could hold" } else { "does not hold" };
        let energy = joules(energy);
        parts.push(format!(
            "full contact takes {energy} and {what} by itself (Persson and Tosatti 2001)"
        ));
    }
    if let Some(share) = found.attraction {
        let load = found.at.map(|p| format!("the load of {}", chosen(p, PASCALS)));
        let (share, load) = (percent(share), load.unwrap_or_else(|| "a light load".to_owned()));
        parts.push(format!("the attraction is {share} of {load} (5\u{202F}% is little)"));
    }
    let shortest = found.shortest.map(|wave| format!(", the shortest wave being {}", length(wave)));
    let (parts, shortest) = (parts.join("; "), shortest.unwrap_or_default());
    let (work, range) = (joules(found.given.work), quantity(found.given.range, METRES, 2));
    let gradient = significant(found.gradient, 2);
    let text = format!(
        "With {work} over {range}: {parts}. All of it depends on the shortest waves measured (rms gradient \
         {gradient}{shortest}). Water is not in it: in humid air it condenses where the gap is below about 1.5\u{202F}nm \
         (Kelvin, 50\u{202F}% humidity) and pulls by capillary forces."
    );
    [claim, text]
}
