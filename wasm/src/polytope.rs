//! Half-planes without readings.

use boundfit::lesson::{PolytopeOptions, polytope as answer};

/// Returns the facts about half-planes, or the fault.
pub(crate) fn polytope(text: Vec<u8>, options: &str) -> Result<String, String> {
    let text = String::from_utf8(text).map_err(|_| "the half-planes are no text in UTF-8")?;
    let options: PolytopeOptions =
        serde_json::from_str(options).map_err(|error| format!("options: {error}"))?;
    answer(&text, &options).map_err(|problem| problem.to_string())
}
