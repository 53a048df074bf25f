//! What the readers make of texts, and what they say about those that they refuse.

mod lp_format;
mod mps;

use super::*;
use crate::model::Bounds;
use crate::model::ObjectiveSense;
use boundfit_exact::{Limit, Rational, Reading};

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// Bounds from texts; `-` for none.
fn bounds(lower: &str, upper: &str) -> Bounds {
    let bound = |text: &str| (text != "-").then(|| number(text));
    Bounds { lower: bound(lower), upper: bound(upper) }
}

fn read(text: &str, format: ExchangeFormat) -> Model {
    read_model(text, format, &ModelLimits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn message(text: &str, format: ExchangeFormat) -> String {
    read_model(text, format, &ModelLimits::default()).expect_err(text).to_string()
}

#[test]
fn bytes_that_are_no_text_are_refused_with_their_place() {
    let message = |bytes: &[u8]| model_text(bytes).unwrap_err().to_string();
    assert_eq!(
        message(b"NAME\nRO\xff"),
        "line 2, column 3: \"RO\": no valid UTF-8 behind this (expected text in UTF-8)"
    );
    assert_eq!(message(b"\xff\xfeN\0"), "the text is UTF-16 (expected text in UTF-8)");
    assert_eq!(model_text("\u{e9}".as_bytes()), Ok("\u{e9}"));
}
