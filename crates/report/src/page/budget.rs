//! The error budget of the headline by source, and choices that move it.

use crate::draw::svg::escape;
use crate::messages::{self, edge_words};
use crate::numbers::{
    METRES, PASCALS, SPACE, quantity, quantity_within, relative_interval, signed_percent,
    significant,
};
use crate::page::shared::{row, table, tolerance_words, why};
use contact_accuracy::{Estimate, Parts};
use contact_compare::{ChoiceKind, DeterministicAnswer, SurfaceComparison};

fn ends(value: f64, half: Option<f64>) -> Option<[f64; 2]> {
    half.filter(|h| h.is_finite()).map(|half| [(value - half).max(0.0), value + half])
}

fn shares(value: f64, ends: Option<[f64; 2]>) -> String {
    let ends = ends.filter(|_| value > 0.0);
    ends.map_or("–".into(), |ends| escape(&relative_interval(value, ends)))
}

pub(crate) fn sources(
    answer: &DeterministicAnswer,
    surface: &SurfaceComparison,
    at: &str,
    correction: usize,
) -> String {
    let budget = &answer.budget;
    let mut rows = String::new();
    let micro = 1e-6; // Pa per metre -> Pa per micrometre
    let value = |e: Option<Estimate>, scale: f64, units| {
        e.map_or("–".into(), |e| {
            let stated = e.stated().map(|ends| ends.map(|end| end * scale));
            quantity_within(e.value * scale, stated, units)
        })
    };
    let values = [
        messages::area(answer),
        messages::real_pressure(answer),
        value(budget.mean_gap, 1.0, METRES),
        value(budget.stiffness, micro, PASCALS) + "/µm",
    ];
    let of_stiffness = "stiffness −d<i>p</i>/d(mean gap) at fixed contact area";
    rows.push_str(&row("Value", values, &why(of_stiffness)));
    let mut add = |name: &str, part: &dyn Fn(&Estimate) -> Option<[f64; 2]>, how: &str| {
        // No source moves a number farther than it can go.
        let within =
            |([low, high], [least, most]): ([f64; 2], [f64; 2])| [low.max(least), high.min(most)];
        let part = |e: &Estimate| part(e).zip(e.stated()).map(within);
        let of = |e: Option<Estimate>| e.map_or("–".into(), |e| shares(e.value, part(&e)));
        let turned = part(&budget.area).map(|[low, high]| [1.0 / high, 1.0 / low]);
        let pressure = shares(1.0 / budget.area.value, turned);
        let cells = [of(Some(budget.area)), pressure, of(budget.mean_gap), of(budget.stiffness)];
        let row = row(name, cells, &why(how));
        // Sums stand out.
        let is_sum = name.ends_with('±');
        rows += &if is_sum { row.replacen("<tr>", "<tr class=\"sum\">", 1) } else { row };
    };
    let part = |e: &Estimate, of: fn(&Parts) -> f64| ends(e.value, Some(of(&e.uncertainty.ok()?)));
    let read: Vec<String> = answer.coarser.iter().map(|n| significant(100.0 * n.area, 3)).collect();
    let how = match read.join(" and ") {
        none if none.is_empty() => "not solved".into(),
        areas => format!("they read {areas}{SPACE}%"),
    };
    add("Half the points", &|e| part(e, |p| p.coarser), &how);
    let how = format!(
        "a tenth of the perimeter correction [<a href=\"#r{correction}\">{correction}</a>], and counting"
    );
    add("Contact line", &|e| part(e, |p| p.contact_line.hypot(p.counting)), &how);
    if let Some(finer) = answer.finer {
        let how = format!("they read {}{SPACE}%", significant(100.0 * finer.area, 3));
        add("Twice the points", &|e| part(e, |p| p.finer), &how);
    }
    let left = tolerance_words(answer.diagnostics.residuals.preconditioned.max(1e-16));
    add("Iteration", &|e| part(e, |p| p.iteration), &format!("rms pressure error {left}"));
    add("Of this map ±", &|e| e.interval().ok(), "");
    if budget.area.sampling.is_some() {
        let how = "8 × 8 blocks, and the long waves";
        add("Sampling variability", &|e| ends(e.value, e.sampling), how);
    }
    if budget.area.materials > 0.0 {
        let part = |e: &Estimate| ends(e.value, Some(e.materials).filter(|m| *m > 0.0));
        add("Materials", &part, "range of modulus and hardness");
    }
    add("Of the surface ±", &Estimate::prediction, "");
    rows += &format!(
        "<tr><th scope=\"row\">Edges, in no ±</th><td class=\"why\" colspan=\"5\">{}</td></tr>\n",
        edge_words(surface)
    );
    let caption = format!("Uncertainty at {at}, relative, 95{SPACE}%");
    let columns = "Source|#Area|#Real pressure|#Mean gap|#Stiffness|How obtained";
    table(r#"class="bud""#, &caption, columns, &rows)
}

/// What other choices in preparing the map do to the area, largest first; only what was computed.
pub(crate) fn choices(surface: &SurfaceComparison) -> String {
    let Some(choices) = &surface.choices else { return String::new() };
    let mut list: Vec<(f64, String)> =
        choices.iter().map(|(kind, effect)| (*effect, choice(*kind))).collect();
    if let Some(answer) = surface.headline_answer()
        && answer.area_fraction > 0.0
    {
        let counted = answer.touching_fraction / answer.area_fraction - 1.0;
        list.push((counted, "perimeter not corrected".into()));
    }
    list.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let one = |(effect, what): &(f64, String)| row(what, [signed_percent(*effect)], "");
    let rows: String = list.iter().map(one).collect();
    table(r#"class="key""#, "Choices that move the answer: area", "", &rows)
}

fn choice(kind: ChoiceKind) -> String {
    match kind {
        ChoiceKind::Paraboloid => "paraboloid removed, not a plane".into(),
        ChoiceKind::Cutoff(shortest) => {
            format!("waves shorter than {} removed", quantity(shortest, METRES, 2))
        }
        ChoiceKind::WithoutSpikes(1) => "1 spike removed".into(),
        ChoiceKind::WithoutSpikes(count) => format!("{count} spikes removed"),
        ChoiceKind::Mirrored => "mirror images at the edges".into(),
    }
}
