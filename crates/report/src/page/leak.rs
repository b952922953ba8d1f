//! The leak through the gap, where it was asked for: closed forms beside the solution, and a map of the flow.

use crate::draw::palette::{DETERMINISTIC_STYLE, ELASTIC_LOOK};
use crate::figures::conduction::over_load;
use crate::figures::cost::{self, CostRoute};
use crate::figures::maps;
use crate::lines::{LoadLine, min_max};
use crate::messages::conduction::scientific;
use crate::messages::finding::capital;
use crate::messages::leak::{known, leak_notes};
use crate::numbers::{METRES, duration, quantity, signed_percent, signed_range};
use crate::page::shared::{SurfacePart, reduced_words, table};
use crate::page::tables::{cells, head};
use crate::plot_styles::plot_style;
use contact_accuracy::{Axis, Leak, Leaks};
use contact_compare::SurfaceComparison;
use contact_types::Named;

/// What closed forms are called, in their order.
const FORMS: [[&str; 2]; 2] = [["⟨<i>g</i>⟩³", "⟨g⟩³"], ["Bruggeman", "Bruggeman"]];

/// Error of each closed form over the loads, and permeability at each.
struct LeakCurves<'a> {
    axis: Axis,
    found: Vec<Option<&'a Leak>>,
    loads: Vec<Option<&'a Leaks>>,
}

impl<'a> LeakCurves<'a> {
    fn of(surface: &'a SurfaceComparison, k: usize, axis: Axis) -> Self {
        let loads: Vec<_> = surface.leaks.iter().map(Option::as_ref).collect();
        let found = loads.iter().map(|leaks| (*leaks)?.along.get(k)?.1.as_ref().ok()).collect();
        Self { axis, found, loads }
    }

    fn permeability(&self) -> Vec<Option<f64>> {
        self.found.iter().map(|leak| leak.as_ref()?.permeability()).collect()
    }

    fn form(&self, k: usize) -> Vec<Option<f64>> {
        self.loads.iter().map(|leaks| Some(leaks.as_ref()?.closed_forms()[k].1)).collect()
    }

    fn errors(&self, k: usize) -> Vec<Option<f64>> {
        let of = |(leak, form): (Option<&Leak>, Option<f64>)| leak?.error_of(form?);
        self.found.iter().copied().zip(self.form(k)).map(of).collect()
    }

    fn rows(&self, at: usize) -> String {
        let (Some(leaks), Some(leak)) = (self.loads[at], self.found[at]) else {
            return String::new();
        };
        let along = format!("along {}", self.axis.name());
        let bottleneck = leak.flow.bottleneck.map(|b| {
            let lowest = quantity(b.height, METRES, 3);
            format!("; lowest gap {lowest}, points across {}", b.width)
        });
        let channel = leak.channel().to_owned() + &bottleneck.unwrap_or_default();
        let row =
            |class: &str, head: String, [k, error, range, seconds]: [String; 4], dom: &str| {
                let cells = cells([
                    ("Permeability", "", k),
                    ("Error at load", "", error),
                    ("Error, all loads", "", range),
                    ("Time per load", "", seconds),
                ]);
                let channel = format!("<td data-l=\"Channel\" class=\"dom\">{dom}</td>");
                format!("<tr{class}>{head}{cells}{channel}</tr>\n")
            };
        let time = leaks.seconds[0] / leaks.along.len() as f64;
        let numbers = [known(leak, "m³", |k| k), "reference".into(), "–".into(), duration(time)];
        let reference = head(DETERMINISTIC_STYLE, "Reynolds on the gap", &along);
        let mut rows = row(" class=\"ref\"", reference, numbers, &channel);
        for (k, (name, permeability, seconds)) in leaks.closed_forms().into_iter().enumerate() {
            let errors = self.errors(k);
            let range = min_max(errors.iter().flatten().copied());
            let range = range.map_or_else(|| "–".into(), |(low, high)| signed_range(low, high));
            let error = errors[at].map_or_else(|| "–".into(), signed_percent);
            let numbers = [scientific(permeability, "m³"), error, range, duration(seconds)];
            rows += &row("", head(plot_style(name, k), FORMS[k][0], &along), numbers, "");
        }
        rows
    }

    fn routes(&self, at: usize) -> Option<(Vec<CostRoute>, Option<f64>)> {
        let (leaks, leak) = (self.loads[at]?, self.found[at]?);
        let k = leak.permeability()?;
        let route = |(k, (name, permeability, seconds)): (usize, (&str, f64, f64))| {
            let error = leak.error_of(permeability)?;
            Some(CostRoute::new(FORMS[k][1], plot_style(name, k), seconds, error))
        };
        let forms = leaks.closed_forms().into_iter().enumerate();
        let mut routes = forms.map(route).collect::<Option<Vec<_>>>()?;
        routes.push(CostRoute::deterministic(leaks.seconds[0] / leaks.along.len() as f64));
        Some((routes, leak.interval().map(|[_, high]| high / k - 1.0)))
    }
}

pub(crate) fn section(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, h, p, map_limit: limit, .. } = *part;
    let settings = &part.comparison.settings;
    let leaks = surface.leaks.get(surface.headline).and_then(Option::as_ref);
    let (Some(asked), Some(leaks)) = (settings.leak, leaks) else { return String::new() };
    let all: Vec<&Leaks> = surface.leaks.iter().flatten().collect();
    let notes = leak_notes(&all, settings.modulus, settings.hardness.is_some());
    let notes: String = notes.iter().map(|note| format!(" {}.", capital(note))).collect();
    let at = surface.headline;
    let axes = asked.along.axes().iter().enumerate();
    let curves: Vec<LeakCurves<'_>> =
        axes.map(|(k, &axis)| LeakCurves::of(surface, k, axis)).collect();
    let rows: String = curves.iter().map(|curves| curves.rows(at)).collect();
    let columns = "Model|#Permeability|#Error|#Error,<br>all loads|#Time<br>per load|Channel";
    let table = table(r#"class="models""#, "", columns, &rows);
    let mut out = format!(
        "<{h}>Leak at {p}</{h}>\n{table}<p class=\"why\"><i>Q</i> = <i>K W</i> Δ<i>p</i>/(12 <i>η L</i>). ± of this map.{notes}</p>\n<div class=\"two\">\n"
    );
    let first = &curves[0];
    let along = first.axis.name();
    let reference = first.permeability();
    if reference.iter().flatten().any(|k| *k > 0.0) {
        let line = |k: usize| {
            let look = plot_style(leaks.closed_forms()[k].0, k);
            LoadLine::new("", FORMS[k][1], look, first.form(k))
        };
        // It may end before the others: the caption has its name.
        let other = curves.get(1).map(|c| LoadLine::new("", "", ELASTIC_LOOK, c.permeability()));
        let lines: Vec<LoadLine> = other.into_iter().chain([0, 1].map(line)).collect();
        let rings = if curves.len() > 1 { "; rings: along y" } else { "" };
        let caption = format!("Permeability of the gap</b> along {along}. Dots: solver{rings}.");
        let drawn = over_load(surface, &reference, &lines, ("Permeability", "m³"));
        out += &part.figure(drawn, &caption);
    }
    if let Some((routes, floor)) = first.routes(at) {
        let caption = format!(
            "Error against time</b> of the permeability along {along}, once the gap is known."
        );
        let drawn = cost::figure(&routes, floor, ("permeability", p), "Time per load");
        out += &part.figure(drawn, &caption);
    }
    out.push_str("</div>\n<div class=\"two maps\">\n");
    let grid = surface.solved_map().grid();
    for (axis, leak) in &leaks.along {
        let Some(flow) = leak.as_ref().ok().map(|l| &l.flow) else { continue };
        if flow.flux.len() != grid.len() || surface.pressure.len() != grid.len() {
            continue;
        }
        let reduced = reduced_words(grid.shape(), limit);
        let caption =
            format!("Flow along {}.</b> Grey: contact; ring: bottleneck.{reduced}", axis.name());
        out += &part.figure(maps::flux(flow, &surface.pressure, grid, limit), &caption);
    }
    out + "</div>\n"
}
