//! Half-planes without readings.

use boundfit::ask::take_key;
use boundfit::lesson::{PolytopeOptions, polytope as answer};

use crate::options::{object, refuse_unknown};
use crate::refusal::Refusal;

/// Returns the facts about half-planes, or the fault.
pub(crate) fn polytope(text: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let text = String::from_utf8(text)
        .map_err(|_| Refusal::of_words("the half-planes are no text in UTF-8".to_owned()))?;
    let mut keys = object(options)?;
    let options = PolytopeOptions {
        objective: take_key(&mut keys, "objective")?,
        start: take_key(&mut keys, "start")?,
    };
    refuse_unknown(keys.keys(), || "objective, start".to_owned())?;
    answer(&text, &options).map_err(|error| Refusal::of_half_planes(&error))
}
