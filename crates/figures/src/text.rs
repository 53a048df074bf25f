//! The embedded font and what may be written in it.

use std::sync::Once;

use plotters::style::{FontStyle, register_font};

/// The family name inside [`FONT`].
pub(crate) const FAMILY: &str = "Inter";
/// Inter Regular, a subset; see `fonts/README.md`.
pub(crate) const FONT: &[u8] = include_bytes!("../fonts/Inter-Regular-subset.otf");

/// Makes the font known to plotters, which measures texts with it.
pub(crate) fn register() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        // A font that plotters cannot read shows as an error at the first text that is measured.
        let _ = register_font(FAMILY, FontStyle::Normal, FONT);
    });
}

/// A text from outside, fit for one line of a figure: without control characters and not longer than `most` characters.
pub(crate) fn one_line(text: &str, most: usize) -> String {
    let printable = |c: char| if c.is_control() || is_forbidden_in_xml(c) { ' ' } else { c };
    let cleaned: String = text.chars().map(printable).collect();
    let words = cleaned.split_whitespace().collect::<Vec<_>>().join(" ");
    if words.chars().count() <= most {
        return words;
    }
    words.chars().take(most.saturating_sub(1)).chain(['…']).collect()
}

fn is_forbidden_in_xml(c: char) -> bool {
    matches!(c, '\u{fffe}' | '\u{ffff}')
}

/// A text between XML tags.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_from_outside_fit_on_one_line() {
        assert_eq!(one_line("a\n\u{1}b  c", 9), "a b c");
        assert_eq!(one_line("abcdef", 4), "abc…");
        assert_eq!(escaped("a<b & c"), "a&lt;b &amp; c");
    }
}
