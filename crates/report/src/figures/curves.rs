//! The figures over the load: real area, real pressure, error of each closed form.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, ROOM, draw_end_labels};
use crate::draw::palette::{BAND, DETERMINISTIC, DETERMINISTIC_STYLE, INK, INK2, Stroke};
use crate::draw::svg::{COLUMN, Canvas, Figure, KEY, Text, num};
use crate::lines::{LoadLine, LoadLines, compared, load_axis, load_ends, min_max, range_words};
use crate::messages::load;
use crate::numbers::{PASCALS, counted, signed_range, unit_for};
use contact_compare::Comparison;

const LEFT: f64 = 44.0;
const RIGHT: f64 = COLUMN - ROOM;
const TOP: f64 = 12.0;
/// Height of a figure, whatever notes it carries, so that neighbours stay level.
const HEIGHT: f64 = 262.0;
const BOTTOM_MARGIN: f64 = 36.0;
/// Height of one line of notes above the frame.
const NOTE: f64 = 12.0;

/// Fig. 1 of the source paper: real contact area over nominal pressure; `on_page` with the line that the slider moves.
pub(crate) fn area(lines: &LoadLines, on_page: bool) -> Figure {
    let describe = |reference: &[Option<f64>]| {
        let loads = counted(lines.pressures.len(), "load");
        let (range, compared) = (range_words(reference, " %"), compared(lines));
        format!("Log-log plot over {loads}. Deterministic area: {range}. {compared}")
    };
    let of = |_: f64, area: f64| Some(100.0 * area);
    let titles = ["Real contact area over the load", "Real contact area (% of nominal)"];
    Plot::logarithmic(lines, of, 100.0, 'a', titles, describe).draw(on_page)
}

/// Fig. 2 of the source paper: mean real pressure over nominal pressure.
pub(crate) fn pressure(lines: &LoadLines, on_page: bool) -> Figure {
    let real = |p: f64, area: f64| (area > 0.0).then(|| p / area);
    let known = lines.pressures.iter().zip(&lines.area);
    let mut known: Vec<f64> = known.filter_map(|(&p, a)| real(p, (*a)?)).collect();
    known.sort_by(f64::total_cmp);
    let unit = unit_for(known.get(known.len() / 2).copied().unwrap_or(lines.pressures[0]), PASCALS);
    let describe = |reference: &[Option<f64>]| {
        format!(
            "Log-log plot. Deterministic mean real pressure: {} while load rises {:.0} times.",
            range_words(reference, &format!(" {}", unit.name)),
            lines.pressures[lines.pressures.len() - 1] / lines.pressures[0]
        )
    };
    let of = |p: f64, area: f64| Some(real(p, area)? / unit.scale);
    let titles =
        ["Mean real pressure over the load", &format!("Mean real pressure ({})", unit.name)];
    Plot::logarithmic(lines, of, f64::INFINITY, 'p', titles, describe).draw(on_page)
}

/// A plot over the loads of one quantity of the reference and of every model; of errors, on a linear axis, the
/// reference is the line at 0.
struct Plot<'a> {
    lines: &'a LoadLines,
    /// Empty of errors.
    reference: Vec<Option<f64>>,
    band: Vec<Option<[f64; 2]>>,
    models: Vec<Vec<Option<f64>>>,
    y: PlotAxis,
    /// Models that leave the axis, with what is said of them above the frame.
    notes: Vec<(&'a LoadLine, String)>,
    /// Letter of what the slider lists.
    cells: char,
    title: String,
    y_title: String,
    description: String,
}

impl<'a> Plot<'a> {
    /// Of a quantity that follows from a pressure and an area fraction, at most `ceiling`.
    fn logarithmic(
        lines: &'a LoadLines,
        of: impl Fn(f64, f64) -> Option<f64>,
        ceiling: f64,
        cells: char,
        [title, y_title]: [&str; 2],
        describe: impl FnOnce(&[Option<f64>]) -> String,
    ) -> Self {
        let over = |areas: &[Option<f64>]| -> Vec<Option<f64>> {
            lines.pressures.iter().zip(areas).map(|(&p, a)| of(p, (*a)?)).collect()
        };
        let reference = over(&lines.area);
        let models: Vec<_> = lines.models.iter().map(|m| over(&m.values)).collect();
        let ends = |(&p, i): (&f64, &Option<[f64; 2]>)| {
            let [a, b] = (*i)?.map(|area| of(p, area));
            Some([a?.min(b?), a?.max(b?)])
        };
        let band: Vec<_> = lines.pressures.iter().zip(&lines.interval).map(ends).collect();
        let all = reference.iter().flatten().chain(band.iter().flatten().flatten());
        let beside = models.iter().flat_map(|values| values.iter().zip(&reference));
        let y = PlotAxis::log(log_limits(all, beside, ceiling));
        let notes = load_notes(lines, &models, y.data);
        let (title, y_title, description) = (title.into(), y_title.into(), describe(&reference));
        Self { lines, reference, band, models, y, notes, cells, title, y_title, description }
    }

    fn draw(self, on_page: bool) -> Figure {
        let lines = self.lines;
        let is_error = !self.y.is_log;
        let (unit, x_title) = load_axis(&lines.pressures, lines.load_area);
        let x: Vec<f64> = lines.pressures.iter().map(|p| p / unit.scale).collect();
        let [lo, hi] = self.y.data;
        let notes = NOTE * self.notes.len() as f64;
        let top = TOP + if is_error || self.notes.is_empty() { notes } else { notes - 2.0 };
        let bottom = HEIGHT - BOTTOM_MARGIN;
        let axes = [PlotAxis::log(load_ends(x[0], x[x.len() - 1])), self.y];
        let frame = PlotFrame::new([LEFT, top, RIGHT, bottom], axes, [&x_title, &self.y_title]);
        let mut canvas = Canvas::default();
        let tolerance = [LEFT, frame.y.at(10.0), RIGHT, frame.y.at(-10.0)];
        if is_error {
            canvas.rect(tolerance, BAND, 1.0);
        }
        let sign = |v: f64| if is_error && v > 0.0 { "+" } else { "" };
        let y_ticks = frame.y.ticks_as(|v| format!("{}{}", sign(v), frame.y.tick_text(v)));
        frame.draw_with(&mut canvas, &frame.x.ticks(), &y_ticks);
        for (row, (model, note)) in self.notes.iter().enumerate() {
            let at = [LEFT + 4.0, 10.0 + NOTE * row as f64];
            let text = Text::start(at, note, model.look.colour).small();
            canvas.series(&model.name, |canvas| canvas.label(&text));
        }
        if on_page {
            cursor(&mut canvas, lines, &frame, &x, self.cells);
        }
        let placed = |values: &[Option<f64>]| -> Vec<Option<[f64; 2]>> {
            x.iter().zip(values).map(|(x, v)| Some(frame.at([*x, (*v)?]))).collect()
        };
        let end = |y: f64| frame.y.at(y).clamp(top, bottom);
        let mut ends = Vec::new();
        // A little wider than the frame, for markers on its edge.
        let clip = [LEFT - 4.0, top - 4.0, RIGHT + 4.0, bottom];
        canvas.clipped("c", clip, |canvas| {
            let [low, high] = [0, 1]
                .map(|k| self.band.iter().map(|b| b.map(|b| b[k].clamp(lo, hi))).collect())
                .map(|side: Vec<Option<f64>>| runs(&placed(&side)));
            for (mut outline, high) in low.into_iter().zip(high) {
                outline.extend(high.into_iter().rev());
                canvas.area(&outline, DETERMINISTIC, if is_error { 0.28 } else { 0.16 });
            }
            if is_error {
                let zero = [LEFT, RIGHT].map(|x| [x, frame.y.at(0.0)]);
                canvas.line(zero[0], zero[1], Stroke::solid(DETERMINISTIC, 1.6));
                ends.push(EndLabel::deterministic(frame.y.at(0.0)));
            }
            for (model, values) in lines.models.iter().zip(&self.models) {
                draw_model(canvas, &frame, values, &placed(values), model);
                let last = values.iter().flatten().last();
                if let Some(y) = last.filter(|y| !is_error || (lo..=hi).contains(*y)) {
                    ends.push(EndLabel::of(end(*y), model));
                }
            }
            let positive: Vec<Option<f64>> =
                self.reference.iter().map(|v| v.filter(|v| *v > 0.0)).collect();
            for run in runs(&placed(&positive)) {
                canvas.polyline(&run, DETERMINISTIC_STYLE.stroke());
                for point in run {
                    canvas.marker(point, 2.6, DETERMINISTIC_STYLE);
                }
            }
            let last = positive.iter().flatten().last();
            ends.extend(last.map(|y| EndLabel::deterministic(end(*y))));
        });
        // A band too narrow for its name is named in the caption alone.
        if is_error && tolerance[3] - tolerance[1] > 26.0 {
            let at = [LEFT + 4.0, tolerance[1] + 9.5];
            canvas.text(&Text::start(at, "within 10\u{202F}%", INK2).small().halo());
        }
        draw_end_labels(&mut canvas, &frame, 2.0, &ends);
        canvas.figure(self.title, self.description, [COLUMN, HEIGHT])
    }
}

/// "▲ MB off scale from 400 MPa" of each model that leaves the axis.
fn load_notes<'a>(
    lines: &'a LoadLines,
    models: &[Vec<Option<f64>>],
    [lo, hi]: [f64; 2],
) -> Vec<(&'a LoadLine, String)> {
    let note = |(model, values): (&'a LoadLine, &Vec<Option<f64>>)| {
        let off = |i: &usize| values[*i].is_some_and(|v| v < lo || v > hi * (1.0 + 1e-9));
        let loads: Vec<usize> = (0..lines.pressures.len()).filter(off).collect();
        let (&first, &last) = (loads.first()?, loads.last()?);
        let at = |i: usize| load(lines.pressures[i], lines.load_area);
        let whole = loads.len() == lines.pressures.len();
        let range = match (first, last + 1 == lines.pressures.len()) {
            _ if whole => "at every load".into(),
            _ if first == last => format!("at {}", at(first)),
            (0, _) => format!("up to {}", at(last)),
            (_, true) => format!("from {}", at(first)),
            _ => format!("between {} and {}", at(first), at(last)),
        };
        let sign = if values[first].is_some_and(|v| v > hi) { '▲' } else { '▼' };
        Some((model, format!("{sign} {} off scale {range}", model.label)))
    };
    lines.models.iter().zip(models).filter_map(note).collect()
}

/// Limits of a logarithmic axis: all of the reference, and every model value within a factor of
/// 12 of the reference beside it; one bad model does not flatten the rest.
pub(crate) fn log_limits<'a>(
    reference: impl Iterator<Item = &'a f64> + Clone,
    models: impl Iterator<Item = (&'a Option<f64>, &'a Option<f64>)>,
    ceiling: f64,
) -> [f64; 2] {
    let has_reference = reference.clone().any(|v| *v > 0.0);
    let near = |(v, r): (&Option<f64>, &Option<f64>)| match (v, r) {
        (Some(v), Some(r)) if *r > 0.0 => (1.0 / 12.0..12.0).contains(&(v / r)).then_some(*v),
        (Some(v), _) => (!has_reference).then_some(*v),
        (None, _) => None,
    };
    let all = reference.copied().chain(models.filter_map(near));
    let drawn = all.filter(|v| *v > 0.0 && v.is_finite());
    let Some((lo, hi)) = min_max(drawn) else { return [0.1, 1.0] };
    let room = (hi / lo).powf(0.04).max(1.1);
    [lo / room, (hi * room).min(ceiling).max(1.01 * lo)]
}

/// Error (%) that the axis of errors never exceeds: what lies beyond is named above the frame.
const MOST_ERROR: f64 = 150.0;

/// Fig. 3: signed error of the area of each closed form against the deterministic solution.
pub(crate) fn error(lines: &LoadLines) -> Figure {
    let percent = |e: &f64| 100.0 * e;
    let in_percent =
        |m: &LoadLine| lines.errors(m).iter().map(|e| e.as_ref().map(percent)).collect();
    let errors: Vec<Vec<Option<f64>>> = lines.models.iter().map(in_percent).collect();
    let worst = |e: &[Option<f64>]| e.iter().flatten().fold(0.0_f64, |w, e| w.max(e.abs()));
    // The axis holds every model that stays within 60 %; if none does, the best of them and
    // those that are little worse.
    let mut worsts: Vec<f64> = errors.iter().map(|e| worst(e)).filter(|w| *w > 0.0).collect();
    worsts.sort_by(f64::total_cmp);
    let within = worsts.iter().rfind(|w| **w <= 60.0).copied();
    let limit = within.or(worsts.first().map(|best| 1.3 * best)).unwrap_or(15.0).max(15.0);
    let extent = |sign: f64| {
        let held = errors.iter().filter(|e| worst(e) <= limit).flatten().flatten();
        held.fold(12.0_f64, |w, e| w.max((sign * e).min(MOST_ERROR)))
    };
    let (lo, hi) = (-1.06 * extent(-1.0), 1.06 * extent(1.0));
    // "▲ Stacked off scale: +141 to +434 %".
    let note = |(model, errors): (&'_ LoadLine, &Vec<Option<f64>>)| {
        errors.iter().flatten().find(|e| **e < lo || **e > hi)?;
        let (low, high) = min_max(lines.errors(model).into_iter().flatten())?;
        let sign = if high + low > 0.0 { '▲' } else { '▼' };
        Some(format!("{sign} {} off scale: {}", model.label, signed_range(low, high)))
    };
    let each = lines.models.iter().zip(&errors);
    let notes = each.filter_map(|of| Some((of.0, note(of)?))).collect();
    let between = |(i, a): (&Option<[f64; 2]>, &Option<f64>)| {
        Some((*i)?.map(|v| 100.0 * (v / a.unwrap_or(v) - 1.0)))
    };
    let band = lines.interval.iter().zip(&lines.area).map(between).collect();
    let plot = Plot {
        lines,
        reference: Vec::new(),
        band,
        models: errors,
        y: PlotAxis::linear([lo, hi]),
        notes,
        cells: 'e',
        title: "Signed error of each closed form against load".into(),
        y_title: "Error in area (%)".into(),
        description: format!(
            "Per cent error of the area relative to the deterministic solution of the same map. {}",
            compared(lines)
        ),
    };
    plot.draw(true)
}

/// The dotted line at the load read off; the report's script moves it, and lists beside it what `cells` of
/// the slider's data begin with the letter of the figure.
fn cursor(canvas: &mut Canvas, lines: &LoadLines, frame: &PlotFrame, x: &[f64], cells: char) {
    let places: Vec<String> = x.iter().map(|x| num(frame.x.at(*x))).collect();
    let (of, all, here) = (lines.of, places.join(" "), &places[lines.headline]);
    let moved = format!(
        r#"class="cur" data-v="{cells}" data-of="{of}" data-x="{all}" transform="translate({here} 0)""#
    );
    let [bottom, top] = frame.y.units;
    let stroke = Stroke { colour: INK2, width: 0.8, dash: "1.5 1.5" };
    canvas.group(&moved, |canvas| canvas.line([0.0, top], [0.0, bottom], stroke));
}

fn draw_model(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    values: &[Option<f64>],
    placed: &[Option<[f64; 2]>],
    model: &LoadLine,
) {
    let look = model.look;
    let is_short = placed.iter().flatten().count() < 3;
    canvas.series(&model.name, |canvas| {
        for run in runs(placed) {
            canvas.polyline(&run, look.stroke());
        }
        for (i, (v, at)) in values.iter().zip(placed).enumerate() {
            let (Some(v), Some(at)) = (v, at) else { continue };
            if (i % 4 == look.marker_offset || is_short) && frame.y.holds(*v) {
                canvas.marker(*at, 2.6, look);
            }
        }
    });
}

fn runs(points: &[Option<[f64; 2]>]) -> Vec<Vec<[f64; 2]>> {
    let all = points.split(Option::is_none).filter(|run| !run.is_empty());
    all.map(|run| run.iter().copied().flatten().collect()).collect()
}

/// A file 85 mm wide: a panel per surface, two of bodies that yield, below each other; in two columns from four.
pub(crate) fn panels(
    comparison: &Comparison,
    key: &str,
    draw: fn(&LoadLines, bool) -> Figure,
) -> String {
    const NAME: f64 = 18.0;
    let figures = comparison.surfaces.iter().flat_map(|surface| {
        let panels = LoadLines::panels(surface).into_iter();
        panels.map(|lines| (surface.name.clone() + &lines.whose(), draw(&lines, false)))
    });
    let figures: Vec<(String, Figure)> = figures.collect();
    if let [(_, one)] = &figures[..] {
        return one.standalone(&format!("{key}0"));
    }
    let columns = if figures.len() > 3 { 2 } else { 1 };
    let height = figures.iter().map(|(_, f)| f.size[1]).fold(0.0, f64::max) + NAME;
    let mut canvas = Canvas::default();
    for (i, (name, figure)) in figures.iter().enumerate() {
        let (x, y) = ((i % columns) as f64 * COLUMN, (i / columns) as f64 * height);
        let letter = char::from(b'a' + (i % 26) as u8);
        let name = format!("({letter}) {name}");
        canvas.text(&Text::start([x + 10.0, y + 12.0], &name, INK).bold());
        let moved = format!(r#"transform="translate({x} {})""#, y + NAME);
        canvas.group(&moved, |canvas| canvas.raw(&figure.body.replace(KEY, &format!("{KEY}{i}"))));
    }
    let rows = figures.len().div_ceil(columns).max(1);
    let described: Vec<String> =
        figures.iter().map(|(name, f)| format!("{name}: {}", f.description)).collect();
    let title = figures.first().map_or("", |(_, f)| &f.title);
    let size = [columns as f64 * COLUMN, rows as f64 * height];
    canvas.figure(title, described.join(" "), size).standalone(key)
}
