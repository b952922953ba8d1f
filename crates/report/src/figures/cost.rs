//! Fig. 4: what accuracy costs, error against time.

use crate::draw::labels::place_near;
use crate::draw::palette::{DETERMINISTIC_STYLE, Stroke, Style};
use crate::draw::svg::{COLUMN, Figure, Rect, Text, text_width};
use crate::figures::cost_plot::CostPlot;
use crate::numbers::{duration, percent};

pub(crate) struct CostRoute {
    pub label: String,
    /// The series it is, see [`Canvas::series`](crate::draw::svg::Canvas::series); may be empty.
    pub series: String,
    pub look: Style,
    pub seconds: f64,
    /// Seconds from typed numbers, where nothing has to be prepared, if it can be asked so.
    pub typed: Option<f64>,
    /// Size of its relative error.
    pub error: f64,
    pub bold: bool,
}

/// Error against a time. `floor` is the uncertainty of the reference, if it has one.
pub(crate) fn figure(
    routes: &[CostRoute],
    floor: Option<f64>,
    (of, at): (&str, &str),
    time: &str,
) -> Figure {
    const FRAME: Rect = [44.0, 12.0, COLUMN - 14.0, 226.0];
    let seconds = || routes.iter().flat_map(|r| [r.typed.unwrap_or(r.seconds), r.seconds]);
    let fastest = seconds().fold(f64::INFINITY, f64::min).max(1e-9);
    let slowest = seconds().fold(0.0, f64::max).max(10.0 * fastest);
    // An error of 0, as the reference has, is drawn below all others.
    let errors = || routes.iter().map(|r| r.error).chain(floor).filter(|e| *e > 0.0);
    let hi = errors().fold(1e-3, |hi, e| f64::max(hi, 100.0 * e));
    let lo = errors().fold(hi, |lo, e| lo.min(100.0 * e.max(1e-5)));
    let hi = hi.max(10.0 * lo);
    let limits = [[fastest / 3.0, slowest * 4.0], [lo / 6.0, hi * 1.8]];
    let titles = [time, &format!("|Error| in {of} at {at} (%)")];
    let whose = floor.map(|floor| (floor, "solver’s"));
    let mut plot = CostPlot::framed(FRAME, limits, titles, whose);
    let place = |r: &CostRoute| {
        plot.frame.at([r.seconds.max(fastest / 3.0), (100.0 * r.error).max(lo / 2.5)])
    };
    let places: Vec<[f64; 2]> = routes.iter().map(place).collect();
    let costs: Vec<[f64; 2]> = routes.iter().map(|r| [r.seconds, r.error]).collect();
    plot.front(&costs, &places, floor.unwrap_or(0.0), 1.1);
    let CostPlot { frame, mut canvas, mut taken, .. } = plot;
    for (route, &[x, y]) in routes.iter().zip(&places) {
        canvas.series(&route.series, |canvas| {
            if let Some(typed) = route.typed {
                let end = frame.x.at(typed.max(fastest / 3.0));
                let stroke = Stroke::solid(route.look.colour, 0.7);
                canvas.polyline(&[[x, y], [end, y]], stroke);
                canvas.polyline(&[[end, y - 3.0], [end, y + 3.0]], stroke);
            }
            canvas.marker([x, y], 3.4, route.look);
        });
        taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
    }
    for (route, place) in routes.iter().zip(places) {
        // A little room beside it, so that neighbours do not read as one word.
        let size = [text_width(&route.label, 10.0, route.bold) + 4.0, 10.0];
        let inside = [FRAME[0], FRAME[1] - 8.0, COLUMN - 2.0, FRAME[3]];
        if let Some(r) = place_near(place, size, &taken, inside) {
            taken.push(r);
            let text = Text::start([r[0], r[1] + 7.8], &route.label, route.look.colour).halo();
            let text = Text { bold: route.bold, ..text };
            canvas.series(&route.series, |canvas| canvas.label(&text));
        }
    }
    let way = |r: &CostRoute| {
        let typed = r.typed.map(|s| format!(" ({} from typed numbers)", duration(s)));
        let (error, time) = (percent(r.error), duration(r.seconds));
        format!("{} {error} in {time}{}", r.label, typed.unwrap_or_default())
    };
    let listed: Vec<String> = routes.iter().map(way).collect();
    let description = format!(
        "Log-log plot of the size of the error in {of} at {at} against computing time: {}.",
        listed.join("; ")
    );
    let title = format!("Error against {}", time.to_lowercase());
    canvas.figure(title, description, [COLUMN, 262.0])
}

impl CostRoute {
    pub(crate) fn new(label: impl Into<String>, look: Style, seconds: f64, error: f64) -> Self {
        let (label, series) = (label.into(), String::new());
        Self { label, series, look, seconds, typed: None, error: error.abs(), bold: false }
    }

    pub(crate) fn deterministic(seconds: f64) -> Self {
        let route = Self::new("Deterministic (0)", DETERMINISTIC_STYLE, seconds, 0.0);
        Self { bold: true, ..route }
    }
}
