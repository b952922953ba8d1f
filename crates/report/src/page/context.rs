//! What the sections of a page share.

use crate::provenance::Provenance;
use contact_compare::Comparison;
use contact_types::Citation;

/// What the sections share while the page is written.
pub(crate) struct Page<'a> {
    /// The study.
    pub comparison: &'a Comparison,
    /// Circumstances.
    pub provenance: &'a Provenance,
    /// Figures so far.
    pub(crate) figures: usize,
    /// Sources so far, in the order of their numbers.
    pub(crate) sources: Vec<Citation>,
    /// Longest side of a map picture in pixels.
    pub map_limit: usize,
}

impl Page<'_> {
    /// Number of the next figure.
    pub(crate) fn next_figure(&mut self) -> usize {
        self.figures += 1;
        self.figures
    }

    /// Number of a source in the list of references.
    pub(crate) fn source(&mut self, citation: Citation) -> usize {
        let known = self.sources.iter().position(|c| *c == citation);
        known.unwrap_or_else(|| {
            self.sources.push(citation);
            self.sources.len() - 1
        }) + 1
    }

    /// Several surfaces: sections move one heading level down.
    pub(crate) fn several(&self) -> bool {
        self.comparison.surfaces.len() > 1
    }

    /// Heading tag of a section of one surface.
    pub(crate) fn heading(&self) -> &'static str {
        if self.several() { "h3" } else { "h2" }
    }
}
