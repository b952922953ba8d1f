//! What the sections of a page share: numbers of its figures and sources, tables, phrases.

use crate::draw::svg::Figure;
use crate::figures::maps::limited;
use crate::numbers::{percent, power_of_ten, significant};
use contact_compare::{Comparison, Section, SurfaceComparison};
use contact_types::Citation;

pub(crate) const DETERMINISTIC: Citation = Citation::new(
    "The discrete problem, whose iteration its row names: Stanley & Kato",
    1997,
    "An FFT-based method for rough surface contact",
    "J. Tribol. 119, 481",
    "10.1115/1.2833523",
);

pub(crate) const CONDUCTANCE: Citation = Citation::new(
    "Barber",
    2003,
    "Bounds on the electrical resistance between contacting elastic rough bodies",
    "Proc. R. Soc. A 459, 53",
    "",
);

pub(crate) const AREA_CORRECTION: Citation = Citation::new(
    "Yastrebov, Anciaux & Molinari",
    2017,
    "On the accurate computation of the true contact-area in mechanical contact of random rough surfaces",
    "Tribol. Int. 114, 161",
    "10.1016/j.triboint.2017.04.023",
);

/// Figures and sources of a page, numbered as they come.
#[derive(Default)]
pub(crate) struct Numbering {
    figures: usize,
    pub(crate) sources: Vec<Citation>,
}

impl Numbering {
    pub(crate) fn next_figure(&mut self) -> usize {
        self.figures += 1;
        self.figures
    }

    /// The next figure of the part `id`; its number is taken also where nothing is drawn. Its caption is HTML and opens
    /// with the rest of a bold subject.
    pub(crate) fn figure(
        &mut self,
        id: &str,
        drawn: impl Into<Option<Figure>>,
        caption: &str,
    ) -> String {
        let n = self.next_figure();
        let caption = format!("<b>Fig. {n}. {caption}");
        let shown = |drawn: Figure| figure(&drawn.inline(&format!("{id}-f{n}")), &caption);
        drawn.into().map_or_else(String::new, shown)
    }

    pub(crate) fn source(&mut self, citation: Citation) -> usize {
        let known = self.sources.iter().position(|c| *c == citation);
        known.unwrap_or_else(|| {
            self.sources.push(citation);
            self.sources.len() - 1
        }) + 1
    }
}

pub(crate) fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>{svg}<figcaption>{caption}</figcaption></figure>\n")
}

/// The same across the page, which scrolls where it is narrow.
pub(crate) fn wide(figure: &str) -> String {
    figure.replacen("<figure>", "<figure class=\"wide scroll\" tabindex=\"0\">", 1)
}

/// The part of a page on one surface.
pub(crate) struct SurfacePart<'a> {
    pub(crate) comparison: &'a Comparison,
    pub(crate) surface: &'a SurfaceComparison,
    /// With which its ids begin.
    pub(crate) id: &'a str,
    /// Tag of its headings.
    pub(crate) h: &'a str,
    /// The load of the headline.
    pub(crate) p: &'a str,
    pub(crate) numbers: &'a mut Numbering,
    /// Longest side of a map picture in pixels.
    pub(crate) map_limit: usize,
}

impl SurfacePart<'_> {
    /// Its next figure, see [`Numbering::figure`].
    pub(crate) fn figure(&mut self, drawn: impl Into<Option<Figure>>, caption: &str) -> String {
        self.numbers.figure(self.id, drawn, caption)
    }
}

pub(crate) fn levelled(surface: &SurfaceComparison) -> &'static str {
    match surface.statistics.level {
        // Statistics say what was chosen.
        surface_stats::Level::Plane | surface_stats::Level::Auto => "least-squares plane removed",
        surface_stats::Level::Quadratic => "least-squares paraboloid removed",
        surface_stats::Level::Mean => "mean removed",
        _ if surface.origin.cleaned().is_empty() => "as given",
        _ => "cleaned, not levelled",
    }
}

/// A tolerance, as a power of ten if it is one.
pub(crate) fn tolerance_words(tolerance: f64) -> String {
    let e = tolerance.log10();
    let is_power = (e - e.round()).abs() < 1e-9;
    if is_power { power_of_ten(e.round() as i32) } else { significant(tolerance, 2) }
}

/// How much of the row touches at each load, as the caption says it.
pub(crate) fn touching(surface: &SurfaceComparison) -> Vec<String> {
    let share = |section: &Option<Section>| {
        let Section { pressure, .. } = section.as_ref()?;
        let touching = pressure.iter().filter(|p| **p > 0.0).count();
        Some(percent(touching as f64 / pressure.len().max(1) as f64))
    };
    surface.sections.iter().map(share).collect::<Option<_>>().unwrap_or_default()
}

/// JSON inside an attribute in single quotes.
pub(crate) fn attribute(data: &serde_json::Value) -> String {
    data.to_string().replace('&', "&amp;").replace('\'', "&#39;").replace('<', "&lt;")
}

/// A table: its attributes, a caption that may be empty, names of its columns between `|` (after `#` of numbers), its rows.
pub(crate) fn table(attributes: &str, caption: &str, columns: &str, rows: &str) -> String {
    let caption = match caption {
        "" => String::new(),
        words => format!("<caption>{words}</caption>"),
    };
    let column = |name: &str| match name.strip_prefix('#') {
        Some(name) => format!(r#"<th scope="col" class="n">{name}</th>"#),
        None => format!(r#"<th scope="col">{name}</th>"#),
    };
    let head = columns.split('|').map(column).collect::<String>();
    let head = format!("<thead><tr>{head}</tr></thead>");
    let head = if columns.is_empty() { "" } else { &head };
    format!("<table {attributes}>{caption}{head}<tbody>\n{rows}</tbody></table>\n")
}

/// A row of a table: its head, cells of numbers, and others behind them.
pub(crate) fn row<const N: usize>(head: &str, numbers: [String; N], others: &str) -> String {
    let cells: String = numbers.map(|text| format!(r#"<td class="n">{text}</td>"#)).concat();
    format!("<tr><th scope=\"row\">{head}</th>{cells}{others}</tr>\n")
}

pub(crate) fn why(text: &str) -> String {
    format!(r#"<td class="why">{text}</td>"#)
}

/// A table of a name, its value and a note in each row; the caption may be empty.
pub(crate) fn key_table(caption: &str, rows: &[[String; 3]]) -> String {
    let one = |[name, value, note]: &[String; 3]| row(name, [value.clone()], &why(note));
    table(r#"class="key""#, caption, "", &rows.iter().map(one).collect::<String>())
}

pub(crate) fn terms(rows: &[(String, String)]) -> String {
    let row = |(term, text): &(String, String)| format!("<dt>{term}</dt><dd>{text}</dd>\n");
    format!("<dl>{}</dl>\n", rows.iter().map(row).collect::<String>())
}

/// " Downsampled to 640 × 640."
pub(crate) fn reduced_words(shape: [usize; 2], limit: usize) -> String {
    let [ny, nx] = limited(shape, limit);
    if [ny, nx] == shape { String::new() } else { format!(" Downsampled to {nx} × {ny}.") }
}

/// Date of a Unix time (s) as "21 November 2026" in UTC: days to civil date after Hinnant.
pub(crate) fn date(unix: u64) -> String {
    let z = unix / 86_400 + 719_468;
    let (era, day_of_era) = (z / 146_097, z % 146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + u64::from(month <= 2);
    let mut names =
        "January February March April May June July August September October November December"
            .split(' ');
    format!("{day} {} {year}", names.nth(month as usize - 1).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates() {
        assert_eq!(date(0), "1 January 1970");
        assert_eq!(date(951_782_400), "29 February 2000");
        assert_eq!(date(1_795_219_200), "21 November 2026");
    }
}
