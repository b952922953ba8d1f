//! Writing SVG: marks with literal colours and a class, texts with a known box.
//!
//! One unit is 0.25 mm in a figure file 85 mm wide, so 10 units of type are 7.1 pt.

use crate::draw::palette::{Colour, Marker, PAPER, Stroke, Style};

/// Width of a one-column figure in units.
pub(crate) const COLUMN: f64 = 340.0;
/// Millimetres per unit.
const MM: f64 = 0.25;
/// The type of every figure.
const FONT: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans',sans-serif";

/// Stands in ids where the page that shows a figure puts its key; no text has it, see [`escape`].
pub(crate) const KEY: &str = "\u{1}";

/// A rectangle `[left, top, right, bottom]` in figure units.
pub(crate) type Rect = [f64; 4];

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
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

/// Where a text hangs on its point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

#[derive(Debug, Clone, Copy)]
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
    /// Ten-unit text that begins at a point.
    pub(crate) fn start(at: [f64; 2], content: &'a str, colour: Colour) -> Self {
        let anchor = Anchor::Start;
        Self { at, content, colour, anchor, size: 10.0, bold: false, halo: false }
    }

    /// The same with its middle there.
    pub(crate) fn middle(at: [f64; 2], content: &'a str, colour: Colour) -> Self {
        Self { anchor: Anchor::Middle, ..Self::start(at, content, colour) }
    }

    /// The same with its end there.
    pub(crate) fn end(at: [f64; 2], content: &'a str, colour: Colour) -> Self {
        Self { anchor: Anchor::End, ..Self::start(at, content, colour) }
    }

    pub(crate) fn halo(self) -> Self {
        Self { halo: true, ..self }
    }

    pub(crate) fn small(self) -> Self {
        Self { size: 9.0, ..self }
    }

    pub(crate) fn bold(self) -> Self {
        Self { bold: true, ..self }
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

fn attributes(Stroke { colour, width, dash }: Stroke) -> String {
    let dash =
        if dash.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{dash}""#) };
    format!(r#"stroke="{}" stroke-width="{}"{dash}"#, colour.light, num(width))
}

/// Marks and texts of a figure, in drawing order.
#[derive(Debug, Clone, Default)]
pub(crate) struct Canvas {
    pub(crate) body: String,
}

impl Canvas {
    /// Anything else; the caller vouches for its form.
    pub(crate) fn raw(&mut self, element: &str) {
        self.body.push_str(element);
    }

    /// The finished figure: `title` says what it shows, `description` what it finds, with numbers.
    pub(crate) fn figure(
        self,
        title: impl Into<String>,
        description: String,
        size: [f64; 2],
    ) -> Figure {
        Figure { title: title.into(), description, size, body: self.body }
    }

    /// What belongs together, in an element `g` with these attributes.
    pub(crate) fn group<T>(&mut self, attributes: &str, draw: impl FnOnce(&mut Self) -> T) -> T {
        self.raw(&format!("<g {attributes}>"));
        let drawn = draw(self);
        self.raw("</g>");
        drawn
    }

    /// What belongs to one series of the study, by its name, so that a page can follow it through all its
    /// figures; marks of none if the name is empty.
    pub(crate) fn series<T>(&mut self, name: &str, draw: impl FnOnce(&mut Self) -> T) -> T {
        if name.is_empty() {
            return draw(self);
        }
        self.group(&format!(r#"data-m="{}""#, escape(name)), draw)
    }

    /// What is drawn only inside a rectangle; `id` is unique in the figure.
    pub(crate) fn clipped(&mut self, id: &str, inside: Rect, draw: impl FnOnce(&mut Self)) {
        let rect = rectangle(inside);
        self.raw(&format!(r#"<clipPath id="{KEY}-{id}"><rect {rect}/></clipPath>"#));
        self.group(&format!(r#"clip-path="url(#{KEY}-{id})""#), draw);
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: Stroke) {
        let [[x1, y1], [x2, y2]] = [from, to].map(|at| at.map(num));
        let (class, look) = (stroke.colour.class, attributes(stroke));
        self.raw(&format!(
            r#"<line class="s-{class}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" {look}/>"#
        ));
    }

    /// Many short lines of one kind, as one element.
    pub(crate) fn ticks(&mut self, lines: &[[f64; 4]], stroke: Stroke) {
        let line = |ends: &[f64; 4]| {
            let [x1, y1, x2, y2] = ends.map(num);
            format!("M{x1} {y1}L{x2} {y2}")
        };
        if !lines.is_empty() {
            self.path(&lines.iter().map(line).collect::<String>(), stroke);
        }
    }

    pub(crate) fn path(&mut self, data: &str, stroke: Stroke) {
        let (class, look) = (stroke.colour.class, attributes(stroke));
        self.raw(&format!(
            r#"<path class="s-{class}" d="{data}" fill="none" {look} stroke-linejoin="round"/>"#
        ));
    }

    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        if points.len() > 1 {
            self.path(&path_data(points), stroke);
        }
    }

    pub(crate) fn area(&mut self, points: &[[f64; 2]], colour: Colour, opacity: f64) {
        if points.len() > 2 {
            self.filled(&(path_data(points) + "Z"), colour, opacity, r#" stroke="none""#);
        }
    }

    pub(crate) fn rect(&mut self, rect: Rect, colour: Colour, opacity: f64) {
        let (Colour { class, light, .. }, rect) = (colour, rectangle(rect));
        let opacity = num(opacity);
        self.raw(&format!(
            r#"<rect class="f-{class}" {rect} fill="{light}" fill-opacity="{opacity}"/>"#
        ));
    }

    pub(crate) fn bars(&mut self, bars: &[Rect], colour: Colour, opacity: f64) {
        let bar = |bar: &Rect| {
            let [left, top, right, bottom] = bar.map(num);
            format!("M{left} {bottom}V{top}H{right}V{bottom}Z")
        };
        self.filled(&bars.iter().map(bar).collect::<String>(), colour, opacity, "");
    }

    fn filled(
        &mut self,
        data: &str,
        Colour { class, light, .. }: Colour,
        opacity: f64,
        more: &str,
    ) {
        let opacity = num(opacity);
        self.raw(&format!(
            r#"<path class="f-{class}" d="{data}" fill="{light}" fill-opacity="{opacity}"{more}/>"#
        ));
    }

    pub(crate) fn text(&mut self, text: &Text<'_>) {
        self.write_text(text, "", "");
    }

    /// A direct label, which may overlap no other; its class says so.
    pub(crate) fn label(&mut self, text: &Text<'_>) {
        self.write_text(text, " label", "");
    }

    pub(crate) fn upright(&mut self, text: &Text<'_>) {
        let [x, y] = text.at.map(num);
        self.write_text(text, "", &format!(r#" transform="rotate(-90 {x} {y})""#));
    }

    fn write_text(&mut self, text: &Text<'_>, kind: &str, turn: &str) {
        let ([x, y], content) = (text.at.map(num), escape(text.content));
        let anchor = match text.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let size = if (text.size - 10.0).abs() > 1e-9 {
            format!(r#" font-size="{}""#, num(text.size))
        } else {
            String::new()
        };
        let weight = if text.bold { r#" font-weight="700""# } else { "" };
        let common = format!(r#"x="{x}" y="{y}"{anchor}{size}{weight}{turn}"#);
        if text.halo {
            let paper = PAPER.light;
            self.raw(&format!(
                r#"<text class="s-paper" {common} fill="none" stroke="{paper}" stroke-width="3" stroke-linejoin="round" aria-hidden="true">{content}</text>"#
            ));
        }
        let Colour { class, light, .. } = text.colour;
        self.raw(&format!(
            r#"<text class="f-{class}{kind}" {common} fill="{light}">{content}</text>"#
        ));
    }

    pub(crate) fn marker(&mut self, [x, y]: [f64; 2], r: f64, look: Style) {
        let (Colour { class, light, .. }, paper) = (look.colour, PAPER.light);
        let crossed = |a: f64, b: f64| {
            let (a, b) = (r * a, r * b);
            [[x - a, y - b, x + a, y + b], [x - b, y + a, x + b, y - a]]
        };
        let circle = |class: &str, r: f64, fill: &str| {
            let [x, y, r] = [x, y, r].map(num);
            format!(r#"<circle class="{class}" cx="{x}" cy="{y}" r="{r}" fill="{fill}""#)
        };
        let thin = Stroke::solid(look.colour, 1.3);
        let corners: &[[f64; 2]] = match look.marker {
            Marker::Dot => {
                return self.raw(&(circle(&format!("f-{class}"), 0.72 * r, light) + "/>"));
            }
            Marker::Ring => {
                let circle = circle(&format!("f-paper s-{class}"), 0.85 * r, paper);
                return self.raw(&format!(r#"{circle} stroke="{light}" stroke-width="1.1"/>"#));
            }
            Marker::Cross => return self.ticks(&crossed(0.85, 0.85), thin),
            Marker::Plus => return self.ticks(&crossed(1.1, 0.0), thin),
            Marker::Square => &[[-0.88, -0.88], [0.88, -0.88], [0.88, 0.88], [-0.88, 0.88]],
            Marker::TriangleUp => &[[0.0, -1.15], [1.1, 0.8], [-1.1, 0.8]],
            Marker::TriangleDown => &[[0.0, 1.15], [1.1, -0.8], [-1.1, -0.8]],
            Marker::Diamond => &[[0.0, -1.25], [1.1, 0.0], [0.0, 1.25], [-1.1, 0.0]],
            Marker::Hexagon => &[
                [1.05, 0.0],
                [0.53, 0.91],
                [-0.53, 0.91],
                [-1.05, 0.0],
                [-0.53, -0.91],
                [0.53, -0.91],
            ],
        };
        let points: Vec<_> = corners.iter().map(|[dx, dy]| [x + r * dx, y + r * dy]).collect();
        let data = path_data(&points);
        self.raw(&format!(
            r#"<path class="f-paper s-{class}" d="{data}Z" fill="{paper}" stroke="{light}" stroke-width="1.1"/>"#
        ));
    }
}

fn rectangle([left, top, right, bottom]: Rect) -> String {
    let [x, y, width, height] = [left, top, right - left, bottom - top].map(num);
    format!(r#"x="{x}" y="{y}" width="{width}" height="{height}""#)
}

fn path_data(points: &[[f64; 2]]) -> String {
    let point = |(i, [x, y]): (usize, &[f64; 2])| {
        format!("{}{} {}", if i == 0 { 'M' } else { 'L' }, num(*x), num(*y))
    };
    points.iter().enumerate().map(point).collect()
}

pub(crate) struct Figure {
    pub(crate) title: String,
    /// What it finds, with numbers.
    pub(crate) description: String,
    pub(crate) size: [f64; 2],
    pub(crate) body: String,
}

impl Figure {
    /// With ids that begin with `key`, unique in the page.
    fn element(&self, key: &str, extra: &str, ground: &str) -> String {
        let ([width, height], body) = (self.size.map(num), self.body.replace(KEY, key));
        let [title, description] = [&self.title, &self.description].map(|text| escape(text));
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"{extra} role="img" aria-labelledby="{key}-t {key}-d" font-family="{FONT}" font-size="10"><title id="{key}-t">{title}</title><desc id="{key}-d">{description}</desc>{ground}{body}</svg>"#
        )
    }

    /// The element for a page whose stylesheet knows the classes.
    pub(crate) fn inline(&self, key: &str) -> String {
        self.element(key, "", "")
    }

    /// The text of a file of its own: size in millimetres, white ground.
    pub(crate) fn standalone(&self, key: &str) -> String {
        let [width, height] = self.size.map(|units| num(MM * units));
        let size = format!(r#" width="{width}mm" height="{height}mm""#);
        let ([width, height], paper) = (self.size.map(num), PAPER.light);
        let ground = format!(r#"<rect width="{width}" height="{height}" fill="{paper}"/>"#);
        self.element(key, &size, &ground) + "\n"
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
        let escaped = escape("<a href=\"x\">&'\u{1}");
        assert_eq!(escaped, "&lt;a href=&quot;x&quot;&gt;&amp;&#39;\u{FFFD}");
    }
}
