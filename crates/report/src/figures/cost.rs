//! Fig. 4: what accuracy costs, error against time.

use crate::draw::axes::{Frame, PlotAxis};
use crate::draw::labels::place_near;
use crate::draw::palette::{BAND, DETERMINISTIC_STYLE, INK2, LINE, Style};
use crate::draw::svg::{COLUMN, Canvas, Figure, Rect, Stroke, Text, text_width};
use crate::figures::front::front;
use crate::numbers::{duration, percent, time_tick};

/// One way to an answer.
#[derive(Debug, Clone)]
pub(crate) struct Route {
    /// Short name.
    pub label: String,
    /// The series it is, see [`Canvas::series`]; may be empty.
    pub series: String,
    /// How it is drawn.
    pub look: Style,
    /// Seconds.
    pub seconds: f64,
    /// Seconds from typed numbers, where nothing has to be prepared, if it can be asked so.
    pub typed: Option<f64>,
    /// Size of its relative error.
    pub error: f64,
    /// Bold label.
    pub bold: bool,
}

/// Error against a time. `floor` is the uncertainty of the reference; `None` if it has
/// no bar.
pub(crate) fn figure(
    routes: &[Route],
    floor: Option<f64>,
    (of, at): (&str, &str),
    time: &str,
    key: &str,
) -> Figure {
    const FRAME: Rect = [44.0, 12.0, COLUMN - 14.0, 226.0];
    let seconds: Vec<f64> =
        routes.iter().flat_map(|r| [r.typed.unwrap_or(r.seconds), r.seconds]).collect();
    let fastest = seconds.iter().copied().fold(f64::INFINITY, f64::min).max(1e-9);
    let slowest = seconds.iter().copied().fold(0.0, f64::max).max(10.0 * fastest);
    let (mut lo, mut hi) = (f64::INFINITY, 1e-3);
    // An error of 0, as the reference has, is drawn below all others.
    for e in routes.iter().map(|r| r.error).chain(floor).filter(|e| *e > 0.0) {
        lo = lo.min(100.0 * e.max(1e-5));
        hi = f64::max(hi, 100.0 * e);
    }
    lo = lo.min(hi);
    hi = hi.max(10.0 * lo);
    let frame = Frame {
        x: PlotAxis::log([fastest / 3.0, slowest * 4.0], [FRAME[0], FRAME[2]]),
        y: PlotAxis::log([lo / 6.0, hi * 1.8], [FRAME[3], FRAME[1]]),
        x_title: time.into(),
        y_title: format!("|Error| in {of} at {at} (%)"),
    };
    let mut canvas = Canvas::default();
    let mut taken: Vec<Rect> = Vec::new();
    if let Some(floor) = floor {
        canvas.rect([FRAME[0], frame.y.at(100.0 * floor), FRAME[2], FRAME[3]], BAND, 1.0);
    }
    let x_ticks: Vec<_> = frame.x.major().into_iter().map(|s| (s, time_tick(s))).collect();
    let y_ticks: Vec<_> = frame.y.major().into_iter().map(|v| (v, frame.y.tick_text(v))).collect();
    frame.draw_with(&mut canvas, &x_ticks, &y_ticks);
    if let Some(floor) = floor {
        let note = format!("within the solver’s own ±{}: not ranked", percent(floor));
        let text =
            Text { colour: INK2, size: 9.0, ..Text::new([FRAME[0] + 4.0, FRAME[3] - 5.0], &note) };
        taken.push(text.bounds());
        canvas.label(&text);
    }
    let place = |r: &Route| {
        let y = frame.y.at((100.0 * r.error).max(lo / 2.5));
        [frame.x.at(r.seconds.max(fastest / 3.0)), y]
    };
    let costs: Vec<[f64; 2]> = routes.iter().map(|r| [r.seconds, r.error]).collect();
    let steps: Vec<[f64; 2]> = front(&costs, floor.unwrap_or(0.0))
        .windows(2)
        .flat_map(|w| {
            let (a, b) = (place(&routes[w[0]]), place(&routes[w[1]]));
            [a, [b[0], a[1]], b]
        })
        .collect();
    canvas.polyline(&steps, Stroke { colour: LINE, width: 1.1, dash: "3 2" });
    for route in routes {
        let [x, y] = place(route);
        canvas.series(&route.series, |canvas| {
            if let Some(typed) = route.typed {
                let end = frame.x.at(typed.max(fastest / 3.0));
                let stroke = Stroke { colour: route.look.colour, width: 0.7, dash: "" };
                canvas.polyline(&[[x, y], [end, y]], stroke);
                canvas.polyline(&[[end, y - 3.0], [end, y + 3.0]], stroke);
            }
            canvas.marker([x, y], 3.4, route.look);
        });
        taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
    }
    for route in routes {
        // A little room beside it, so that neighbours do not read as one word.
        let size = [text_width(&route.label, 10.0, route.bold) + 4.0, 10.0];
        let inside = [FRAME[0], FRAME[1] - 8.0, COLUMN - 2.0, FRAME[3]];
        if let Some(r) = place_near(place(route), size, &taken, inside) {
            taken.push(r);
            let text = Text {
                colour: route.look.colour,
                bold: route.bold,
                halo: true,
                ..Text::new([r[0], r[1] + 7.8], &route.label)
            };
            canvas.series(&route.series, |canvas| canvas.label(&text));
        }
    }
    let listed: Vec<String> = routes
        .iter()
        .map(|r| {
            let typed = r.typed.map(|s| format!(" ({} from typed numbers)", duration(s)));
            let (error, time) = (percent(r.error), duration(r.seconds));
            format!("{} {error} in {time}{}", r.label, typed.unwrap_or_default())
        })
        .collect();
    Figure {
        key: key.into(),
        title: format!("Error against {}", time.to_lowercase()),
        description: format!(
            "Log-log plot of the size of the error in {of} at {at} against computing time: {}.",
            listed.join("; ")
        ),
        size: [COLUMN, 262.0],
        canvas,
    }
}

/// The deterministic solution, by which the others are judged.
pub(crate) fn deterministic(seconds: f64) -> Route {
    Route {
        label: "Deterministic (0)".into(),
        series: String::new(),
        look: DETERMINISTIC_STYLE,
        seconds,
        typed: None,
        error: 0.0,
        bold: true,
    }
}
