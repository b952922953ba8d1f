//! Direct labels: names beside the ends of lines, pushed apart until all can be read.

use crate::draw::axes::PlotFrame;
use crate::draw::palette::{Colour, DETERMINISTIC, Stroke};
use crate::draw::svg::{Canvas, Rect, Text};
use crate::lines::LoadLine;

/// Distance between base lines of neighbouring labels, in units.
pub(crate) const PITCH: f64 = 11.5;
/// What is left for them beside a figure, in units: the longest, bold, has room in fonts wider than those asked for.
pub(crate) const ROOM: f64 = 90.0;

pub(crate) struct EndLabel {
    pub(crate) y: f64,
    pub(crate) text: String,
    pub(crate) colour: Colour,
    pub(crate) bold: bool,
    /// The series it names; may be empty.
    pub(crate) series: String,
}

impl EndLabel {
    pub(crate) fn of(y: f64, line: &LoadLine) -> Self {
        let (text, series) = (line.label.clone(), line.name.clone());
        Self { y, text, colour: line.look.colour, bold: false, series }
    }

    pub(crate) fn deterministic(y: f64) -> Self {
        let (text, series) = ("Deterministic".into(), String::new());
        Self { y, text, colour: DETERMINISTIC, bold: true, series }
    }
}

/// Moves `wanted` positions apart to at least `pitch`, within `[lo, hi]`, staying as near as
/// they can: neighbours that collide form a block, and each block sits at the mean of what its
/// members want (pool-adjacent-violators). The order of the input is kept in the output.
pub(crate) fn push_apart(wanted: &[f64], pitch: f64, [lo, hi]: [f64; 2]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    // In coordinates y_k - k pitch the labels need only be non-decreasing.
    let mut blocks: Vec<(f64, usize)> = Vec::new(); // (mean, members)
    for (k, &i) in order.iter().enumerate() {
        blocks.push((wanted[i] - k as f64 * pitch, 1));
        while blocks.len() > 1 && blocks[blocks.len() - 2].0 > blocks[blocks.len() - 1].0 {
            let (mean, n) = blocks.pop().unwrap_or_default();
            if let Some(last) = blocks.last_mut() {
                let total = (last.1 + n) as f64;
                *last = ((last.0 * last.1 as f64 + mean * n as f64) / total, last.1 + n);
            }
        }
    }
    let top = hi - (wanted.len().saturating_sub(1)) as f64 * pitch;
    let mut placed = vec![0.0; wanted.len()];
    let levels = blocks.iter().flat_map(|&(mean, n)| std::iter::repeat_n(mean, n));
    for (k, (&i, level)) in order.iter().zip(levels).enumerate() {
        placed[i] = level.clamp(lo, top.max(lo)) + k as f64 * pitch;
    }
    placed
}

/// Draws the labels right of a frame with hairline leaders, so far from its corners.
pub(crate) fn draw_end_labels(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    margin: f64,
    labels: &[EndLabel],
) {
    let ([_, x], [bottom, top]) = (frame.x.units, frame.y.units);
    let wanted: Vec<f64> = labels.iter().map(|l| l.y).collect();
    for (label, y) in labels.iter().zip(push_apart(&wanted, PITCH, [top + margin, bottom - margin]))
    {
        let leader = [[x + 1.5, label.y], [x + 9.0, y]];
        canvas.series(&label.series, |canvas| {
            canvas.polyline(&leader, Stroke::solid(label.colour, 0.6));
            let text = Text::start([x + 11.0, y + 3.4], &label.text, label.colour);
            canvas.label(&Text { bold: label.bold, ..text });
        });
    }
}

/// A free place for a label around a point: the first of right, left, above, below and the
/// diagonals that stays inside `frame` and clear of everything in `taken`.
pub(crate) fn place_near(
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
    taken: &[Rect],
    frame: Rect,
) -> Option<Rect> {
    let gap = 5.0;
    let (up, middle, down) = (y - gap - height, y - height / 2.0, y + gap);
    let (left, centre, right) = (x - gap - width, x - width / 2.0, x + gap);
    let places = [
        [right, middle],
        [left, middle],
        [centre, up],
        [centre, down],
        [right - 2.0, up + 3.0],
        [right - 2.0, down - 3.0],
        [left + 2.0, up + 3.0],
        [left + 2.0, down - 3.0],
        [right + 6.0, up - 4.0],
        [right + 6.0, down + 4.0],
        [left - 6.0, up - 4.0],
        [left - 6.0, down + 4.0],
    ];
    let inside =
        |r: &Rect| r[0] >= frame[0] && r[1] >= frame[1] && r[2] <= frame[2] && r[3] <= frame[3];
    let mut boxes = places.into_iter().map(|[l, t]| [l, t, l + width, t + height]);
    let overlap = |a: &Rect, b: &Rect| a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
    boxes.find(|r| inside(r) && !taken.iter().any(|t| overlap(t, r)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Labels keep their order, their distance and the frame, if it is tall enough.
        #[test]
        fn pushed_apart(wanted in prop::collection::vec(0.0..200.0f64, 1..12)) {
            let placed = push_apart(&wanted, PITCH, [0.0, 200.0]);
            let mut pairs: Vec<_> = wanted.iter().zip(&placed).collect();
            pairs.sort_by(|a, b| a.1.total_cmp(b.1));
            for w in pairs.windows(2) {
                prop_assert!(w[1].1 - w[0].1 >= PITCH - 1e-9);
                prop_assert!(w[0].0 <= w[1].0);
            }
            prop_assert!(placed.iter().all(|y| (-1e-9..=200.0 + 1e-9).contains(y)));
        }
    }

    #[test]
    fn labels_with_room_stay_where_they_are() {
        assert_eq!(push_apart(&[50.0, 20.0, 80.0], 11.5, [0.0, 100.0]), [50.0, 20.0, 80.0]);
        // Two that want the same place share the displacement.
        assert_eq!(push_apart(&[50.0, 50.0], 10.0, [0.0, 100.0]), [45.0, 55.0]);
    }
}
