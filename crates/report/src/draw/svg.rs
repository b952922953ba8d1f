//! Writing SVG: marks with literal colours and a class, texts with a known box.
//!
//! One unit is 0.25 mm in a figure file 85 mm wide, so 10 units of type are 7.1 pt.

use crate::draw::palette::{Colour, INK, Marker, PAPER, Stroke, Style};
use std::fmt::Write as _;
use std::io;

/// Width of a one-column figure in units.
pub(crate) const COLUMN: f64 = 340.0;
/// Millimetres per unit.
const MM: f64 = 0.25;
/// The type of every figure.
const FONT: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans',sans-serif";

/// A rectangle `[left, top, right, bottom]` in figure units.
pub(crate) type Rect = [f64; 4];

/// True if two rectangles share more than an edge.
pub(crate) fn overlap(a: Rect, b: Rect) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Escapes text for element content and attributes of HTML and XML.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML 1.0 has no other control characters, not even as references.
            c if (c as u32) < 0x20 && !matches!(c, '\t' | '\n' | '\r') => out.push('\u{FFFD}'),
            '\u{FFFE}' | '\u{FFFF}' => out.push('\u{FFFD}'),
            c => out.push(c),
        }
    }
    out
}

/// A coordinate: two decimals, no trailing zeros, never "-0".
pub(crate) fn num(value: f64) -> String {
    let mut text = format!("{value:.2}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".into() } else { text }
}

/// Where a text hangs on its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Anchor {
    #[default]
    Start,
    Middle,
    End,
}

/// A text to place.
#[derive(Debug, Clone)]
pub(crate) struct Text<'a> {
    /// Position of the anchor on the base line.
    pub(crate) at: [f64; 2],
    pub(crate) content: &'a str,
    pub(crate) colour: Colour,
    pub(crate) anchor: Anchor,
    pub(crate) size: f64,
    pub(crate) bold: bool,
    /// A page-coloured rim, for texts that cross lines.
    pub(crate) halo: bool,
}

impl<'a> Text<'a> {
    /// Ten-unit text in ink, beginning at `at`.
    pub(crate) fn new(at: [f64; 2], content: &'a str) -> Self {
        Self {
            at,
            content,
            colour: INK,
            anchor: Anchor::Start,
            size: 10.0,
            bold: false,
            halo: false,
        }
    }

    /// The rectangle the text covers, from average widths of Helvetica.
    pub(crate) fn bounds(&self) -> Rect {
        let width = text_width(self.content, self.size, self.bold);
        let left = match self.anchor {
            Anchor::Start => self.at[0],
            Anchor::Middle => self.at[0] - width / 2.0,
            Anchor::End => self.at[0] - width,
        };
        [left, self.at[1] - 0.78 * self.size, left + width, self.at[1] + 0.22 * self.size]
    }
}

/// Width of a text in units: Helvetica's advance widths by class of character.
pub(crate) fn text_width(content: &str, size: f64, bold: bool) -> f64 {
    let ems: f64 = content
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '\'' | '|' => 0.23,
            '.' | ',' | ':' | ';' | ' ' | 'I' | '/' | '!' | 'f' | 't' => 0.28,
            '\u{202F}' => 0.2,
            '(' | ')' | 'r' | '-' | '[' | ']' | '⁰'..='⁹' | '⁻' | '¹' | '²' | '³' => 0.34,
            's' | 'c' | 'k' | 'x' | 'y' | 'z' | 'v' | 'J' => 0.5,
            'w' | 'A' | 'B' | 'E' | 'K' | 'P' | 'S' | 'V' | 'X' | 'Y' => 0.68,
            'C' | 'D' | 'H' | 'N' | 'R' | 'U' => 0.72,
            'G' | 'O' | 'Q' | 'm' | 'M' => 0.82,
            '%' | 'W' | '▲' | '▼' => 0.92,
            _ => 0.57,
        })
        .sum();
    ems * size * if bold { 1.07 } else { 1.0 }
}

/// The attributes of a stroke.
fn attributes(stroke: Stroke) -> String {
    let mut text =
        format!("stroke=\"{}\" stroke-width=\"{}\"", stroke.colour.light, num(stroke.width));
    if !stroke.dash.is_empty() {
        let _ = write!(text, " stroke-dasharray=\"{}\"", stroke.dash);
    }
    text
}

/// Marks and texts of a figure, in drawing order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Canvas {
    body: String,
}

// Writing to a String cannot fail, so the results of `write!` are dropped here.
impl Canvas {
    /// The elements written so far.
    pub(crate) fn body(&self) -> &str {
        &self.body
    }

    /// Anything else; the caller vouches for its form.
    pub(crate) fn raw(&mut self, element: &str) {
        self.body.push_str(element);
    }

    /// The finished figure: `title` says what it shows, `description` what it finds, with numbers.
    pub(crate) fn figure(
        self,
        key: &str,
        title: impl Into<String>,
        description: String,
        size: [f64; 2],
    ) -> Figure {
        Figure { key: key.into(), title: title.into(), description, size, canvas: self }
    }

    /// What belongs to one series of the study, by its name, so that a page can follow it through all its
    /// figures; marks of none if the name is empty.
    pub(crate) fn series<T>(&mut self, name: &str, draw: impl FnOnce(&mut Self) -> T) -> T {
        if !name.is_empty() {
            let _ = write!(self.body, "<g data-m=\"{}\">", escape(name));
        }
        let drawn = draw(self);
        if !name.is_empty() {
            self.body.push_str("</g>");
        }
        drawn
    }

    /// What is drawn only inside a rectangle; `id` is unique in the page.
    pub(crate) fn clipped(
        &mut self,
        id: &str,
        [left, top, right, bottom]: Rect,
        draw: impl FnOnce(&mut Self),
    ) {
        let _ = write!(
            self.body,
            "<clipPath id=\"{id}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\
             <g clip-path=\"url(#{id})\">",
            num(left),
            num(top),
            num(right - left),
            num(bottom - top)
        );
        draw(self);
        self.body.push_str("</g>");
    }

    pub(crate) fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], stroke: Stroke) {
        let _ = write!(
            self.body,
            "<line class=\"s-{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>",
            stroke.colour.class,
            num(x1),
            num(y1),
            num(x2),
            num(y2),
            attributes(stroke)
        );
    }

    /// Many short lines of one kind, as one element.
    pub(crate) fn ticks(&mut self, lines: &[[f64; 4]], stroke: Stroke) {
        if lines.is_empty() {
            return;
        }
        let path: String = lines
            .iter()
            .map(|[x1, y1, x2, y2]| format!("M{} {}L{} {}", num(*x1), num(*y1), num(*x2), num(*y2)))
            .collect();
        self.path(&path, stroke);
    }

    /// An unfilled path from path data.
    pub(crate) fn path(&mut self, data: &str, stroke: Stroke) {
        let _ = write!(
            self.body,
            "<path class=\"s-{}\" d=\"{data}\" fill=\"none\" {} stroke-linejoin=\"round\"/>",
            stroke.colour.class,
            attributes(stroke)
        );
    }

    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        if points.len() > 1 {
            self.path(&path_data(points), stroke);
        }
    }

    /// A filled area without outline.
    pub(crate) fn area(&mut self, points: &[[f64; 2]], colour: Colour, opacity: f64) {
        if points.len() > 2 {
            let _ = write!(
                self.body,
                "<path class=\"f-{}\" d=\"{}Z\" fill=\"{}\" fill-opacity=\"{}\" stroke=\"none\"/>",
                colour.class,
                path_data(points),
                colour.light,
                num(opacity)
            );
        }
    }

    pub(crate) fn rect(&mut self, [left, top, right, bottom]: Rect, colour: Colour, opacity: f64) {
        let _ = write!(
            self.body,
            "<rect class=\"f-{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" \
             fill-opacity=\"{}\"/>",
            colour.class,
            num(left),
            num(top),
            num(right - left),
            num(bottom - top),
            colour.light,
            num(opacity)
        );
    }

    /// Many filled rectangles of one kind, as one element.
    pub(crate) fn bars(&mut self, bars: &[Rect], colour: Colour, opacity: f64) {
        let path: String = bars
            .iter()
            .map(|bar| {
                let [left, top, right, bottom] = bar.map(num);
                format!("M{left} {bottom}V{top}H{right}V{bottom}Z")
            })
            .collect();
        let _ = write!(
            self.body,
            "<path class=\"f-{}\" d=\"{path}\" fill=\"{}\" fill-opacity=\"{}\"/>",
            colour.class,
            colour.light,
            num(opacity)
        );
    }

    pub(crate) fn text(&mut self, text: &Text<'_>) {
        self.write_text(text, "", "");
    }

    /// A direct label, which may overlap no other; its class says so.
    pub(crate) fn label(&mut self, text: &Text<'_>) {
        self.write_text(text, " label", "");
    }

    /// A text reading upwards, centred on its point.
    pub(crate) fn upright(&mut self, text: &Text<'_>) {
        let turn = format!(" transform=\"rotate(-90 {} {})\"", num(text.at[0]), num(text.at[1]));
        self.write_text(&Text { anchor: Anchor::Middle, ..text.clone() }, "", &turn);
    }

    fn write_text(&mut self, text: &Text<'_>, kind: &str, turn: &str) {
        let mut common = format!("x=\"{}\" y=\"{}\"", num(text.at[0]), num(text.at[1]));
        match text.anchor {
            Anchor::Start => {}
            Anchor::Middle => common.push_str(" text-anchor=\"middle\""),
            Anchor::End => common.push_str(" text-anchor=\"end\""),
        }
        if (text.size - 10.0).abs() > 1e-9 {
            let _ = write!(common, " font-size=\"{}\"", num(text.size));
        }
        if text.bold {
            common.push_str(" font-weight=\"700\"");
        }
        common.push_str(turn);
        let content = escape(text.content);
        if text.halo {
            let _ = write!(
                self.body,
                "<text class=\"s-paper\" {common} fill=\"none\" stroke=\"{}\" stroke-width=\"3\" \
                 stroke-linejoin=\"round\" aria-hidden=\"true\">{content}</text>",
                PAPER.light
            );
        }
        let _ = write!(
            self.body,
            "<text class=\"f-{}{kind}\" {common} fill=\"{}\">{content}</text>",
            text.colour.class, text.colour.light
        );
    }

    /// A marker of nominal radius `r`.
    pub(crate) fn marker(&mut self, [x, y]: [f64; 2], r: f64, look: Style) {
        let polygon = |corners: &[(f64, f64)]| {
            let points: Vec<[f64; 2]> =
                corners.iter().map(|(dx, dy)| [x + r * dx, y + r * dy]).collect();
            format!("{}Z", path_data(&points))
        };
        let cross = |a: f64, b: f64| {
            format!(
                "M{} {}L{} {}M{} {}L{} {}",
                num(x - r * a),
                num(y - r * b),
                num(x + r * a),
                num(y + r * b),
                num(x - r * b),
                num(y + r * a),
                num(x + r * b),
                num(y - r * a)
            )
        };
        let data = match look.marker {
            Marker::Dot => {
                let _ = write!(
                    self.body,
                    "<circle class=\"f-{}\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>",
                    look.colour.class,
                    num(x),
                    num(y),
                    num(0.72 * r),
                    look.colour.light
                );
                return;
            }
            Marker::Ring => {
                let _ = write!(
                    self.body,
                    "<circle class=\"f-paper s-{}\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" \
                     stroke=\"{}\" stroke-width=\"1.1\"/>",
                    look.colour.class,
                    num(x),
                    num(y),
                    num(0.85 * r),
                    PAPER.light,
                    look.colour.light
                );
                return;
            }
            Marker::Cross => return self.path(&cross(0.85, 0.85), Stroke::solid(look.colour, 1.3)),
            Marker::Plus => return self.path(&cross(1.1, 0.0), Stroke::solid(look.colour, 1.3)),
            Marker::Square => {
                polygon(&[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)])
            }
            Marker::TriangleUp => polygon(&[(0.0, -1.15), (1.1, 0.8), (-1.1, 0.8)]),
            Marker::TriangleDown => polygon(&[(0.0, 1.15), (1.1, -0.8), (-1.1, -0.8)]),
            Marker::Diamond => polygon(&[(0.0, -1.25), (1.1, 0.0), (0.0, 1.25), (-1.1, 0.0)]),
            Marker::Hexagon => polygon(&[
                (1.05, 0.0),
                (0.53, 0.91),
                (-0.53, 0.91),
                (-1.05, 0.0),
                (-0.53, -0.91),
                (0.53, -0.91),
            ]),
        };
        let _ = write!(
            self.body,
            "<path class=\"f-paper s-{}\" d=\"{data}\" fill=\"{}\" stroke=\"{}\" \
             stroke-width=\"1.1\"/>",
            look.colour.class, PAPER.light, look.colour.light
        );
    }
}

fn path_data(points: &[[f64; 2]]) -> String {
    points
        .iter()
        .enumerate()
        .map(|(i, [x, y])| format!("{}{} {}", if i == 0 { 'M' } else { 'L' }, num(*x), num(*y)))
        .collect()
}

/// A finished figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Unique key: prefix of every id inside.
    pub(crate) key: String,
    /// What it shows.
    pub(crate) title: String,
    /// What it finds, with numbers.
    pub(crate) description: String,
    /// Width and height in units.
    pub(crate) size: [f64; 2],
    /// What is drawn.
    pub(crate) canvas: Canvas,
}

impl Figure {
    fn open(&self, extra: &str) -> String {
        let Self { key, size: [width, height], .. } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\"{extra} role=\"img\" \
             aria-labelledby=\"{key}-t {key}-d\" font-family=\"{FONT}\" font-size=\"10\">\
             <title id=\"{key}-t\">{}</title><desc id=\"{key}-d\">{}</desc>",
            num(*width),
            num(*height),
            escape(&self.title),
            escape(&self.description)
        )
    }

    /// The element for a page whose stylesheet knows the classes.
    pub fn inline(&self) -> String {
        format!("{}{}</svg>", self.open(""), self.canvas.body)
    }

    /// A file of its own: size in millimetres, white ground.
    pub(crate) fn write_standalone(&self, out: &mut impl io::Write) -> io::Result<()> {
        let [width, height] = self.size;
        let size = format!(" width=\"{}mm\" height=\"{}mm\"", num(MM * width), num(MM * height));
        let ground = format!(
            "<rect width=\"{}\" height=\"{}\" fill=\"{}\"/>",
            num(width),
            num(height),
            PAPER.light
        );
        writeln!(out, "{}{ground}{}</svg>", self.open(&size), self.canvas.body)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short() {
        assert_eq!([num(1.0), num(-0.001), num(12.3456), num(10.0)], ["1", "0", "12.35", "10"]);
    }

    #[test]
    fn text_is_escaped_in_content_and_attributes() {
        assert_eq!(
            escape("<a href=\"x\">&'\u{1}"),
            "&lt;a href=&quot;x&quot;&gt;&amp;&#39;\u{FFFD}"
        );
    }

    #[test]
    fn rectangles_that_touch_do_not_overlap() {
        assert!(!overlap([0.0, 0.0, 1.0, 1.0], [1.0, 0.0, 2.0, 1.0]));
        assert!(overlap([0.0, 0.0, 1.1, 1.0], [1.0, 0.5, 2.0, 1.0]));
    }
}
