//! Half-planes without readings.

use boundfit::lesson::{PolytopeOptions, polytope as answer};

use crate::refusal::Refusal;

/// Returns the facts about half-planes, or the fault.
pub(crate) fn polytope(text: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let text = String::from_utf8(text)
        .map_err(|_| Refusal::of_words("the half-planes are no text in UTF-8".to_owned()))?;
    let options: PolytopeOptions =
        serde_json::from_str(options).map_err(|error| Refusal::of_words(format!("options: {error}")))?;
    answer(&text, &options).map_err(|error| Refusal::of_half_planes(&error))
}
