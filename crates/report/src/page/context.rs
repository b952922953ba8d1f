//! What the sections of a page share.

use crate::draw::svg::Figure;
use crate::provenance::Provenance;
use contact_compare::Comparison;
use contact_types::Citation;

/// Figures and sources of a page, numbered as they come.
#[derive(Default)]
pub(crate) struct Numbering {
    figures: usize,
    /// In the order of their numbers.
    pub(crate) sources: Vec<Citation>,
}

impl Numbering {
    /// Number of the next figure.
    pub(crate) fn next_figure(&mut self) -> usize {
        self.figures += 1;
        self.figures
    }

    /// The next figure of the part `id`, with its key. Its caption is HTML and opens with the rest of a bold
    /// subject.
    pub(crate) fn figure(
        &mut self,
        id: &str,
        draw: impl FnOnce(&str) -> Figure,
        caption: &str,
    ) -> String {
        let n = self.next_figure();
        figure(&draw(&format!("{id}-f{n}")).inline(), &format!("<b>Fig. {n}. {caption}"))
    }

    /// Number of a source in the list of references.
    pub(crate) fn source(&mut self, citation: Citation) -> usize {
        let known = self.sources.iter().position(|c| *c == citation);
        known.unwrap_or_else(|| {
            self.sources.push(citation);
            self.sources.len() - 1
        }) + 1
    }
}

/// A figure with its caption, both HTML.
pub(crate) fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>{svg}<figcaption>{caption}</figcaption></figure>\n")
}

/// The same across the page, which scrolls where it is narrow.
pub(crate) fn wide(figure: &str) -> String {
    figure.replacen("<figure>", "<figure class=\"wide scroll\" tabindex=\"0\">", 1)
}

/// What the sections share while the page is written.
pub(crate) struct ReportPage<'a> {
    /// The study.
    pub comparison: &'a Comparison,
    /// Circumstances.
    pub provenance: &'a Provenance,
    /// Figures and sources so far.
    pub(crate) numbers: Numbering,
    /// Longest side of a map picture in pixels.
    pub map_limit: usize,
}

impl ReportPage<'_> {
    /// Several surfaces: sections move one heading level down.
    pub(crate) fn several(&self) -> bool {
        self.comparison.surfaces.len() > 1
    }

    /// Heading tag of a section of one surface.
    pub(crate) fn heading(&self) -> &'static str {
        if self.several() { "h3" } else { "h2" }
    }
}
