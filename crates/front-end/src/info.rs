//! What a surface file holds: what `rough-contact info` answers.

use serde_json::{Value, json};
use surface_io::Measurement;

/// Points, unit, channels and what else the file says, without the heights.
pub fn info(m: &Measurement) -> Value {
    let summary = m.height_summary();
    let channels: Vec<Value> = m
        .channels
        .iter()
        .map(|c| {
            json!({
                "name": c.name, "unit": c.unit, "is_height": c.is_height, "shape": c.shape,
                "pixel": c.pixel, "is_trace": c.is_trace, "fault": c.fault,
            })
        })
        .collect();
    json!({
        "format": m.format,
        "shape": m.grid().shape(),
        "pixel": m.grid().pixel(),
        "missing": m.missing(),
        "height_min": summary.map(|s| s.0),
        "height_max": summary.map(|s| s.1),
        "height_mean": summary.map(|s| s.2),
        "channel": m.channel,
        "channels": channels,
        "is_profile": m.is_profile(),
        "uneven_steps": m.uneven,
        "ambiguity": m.ambiguity.map(|a| a.what),
        "metadata": m.metadata,
    })
}
