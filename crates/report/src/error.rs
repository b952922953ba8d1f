//! What may go wrong while a report is written.

/// Why a report could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The writer failed.
    #[error("the report could not be written: {0}")]
    Io(#[from] std::io::Error),
    /// A picture could not be encoded.
    #[error("a picture of the report could not be encoded: {0}")]
    Picture(#[from] ::png::EncodingError),
    /// A value has no JSON form.
    #[error("the results could not be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
