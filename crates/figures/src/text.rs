//! The embedded font and what may be written in it.

use std::borrow::Cow;
use std::sync::Once;

use boundfit_exact::Foreign;
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

/// A text from outside, fit for one line of a figure: with all of it visible but the blanks between words, and not longer than
/// `most` characters.
pub(crate) fn one_line(text: &Foreign, most: usize) -> String {
    let words = text.label();
    if words.chars().count() <= most {
        return words;
    }
    words.chars().take(most.saturating_sub(1)).chain(['…']).collect()
}

/// Returns the text on one line like [`one_line`], but cut in its middle: paths of one folder differ at their ends.
pub(crate) fn one_line_of_ends(text: &Foreign, most: usize) -> String {
    let words = text.label();
    let letters: Vec<char> = words.chars().collect();
    if letters.len() <= most {
        return words;
    }
    let last = most / 2;
    let first = most.saturating_sub(last + 1);
    let (start, end) = (letters.iter().take(first), letters.iter().skip(letters.len() - last));
    start.chain(&['…']).chain(end).collect()
}

/// The characters that [`FONT`] has.
const IN_FONT: [(char, char); 33] = [
    (' ', '~'),
    ('\u{a0}', '\u{148}'),
    ('\u{14a}', '\u{17f}'),
    ('\u{370}', '\u{377}'),
    ('\u{37a}', '\u{37f}'),
    ('\u{384}', '\u{38a}'),
    ('\u{38c}', '\u{38c}'),
    ('\u{38e}', '\u{3a1}'),
    ('\u{3a3}', '\u{3e1}'),
    ('\u{3f0}', '\u{45f}'),
    ('\u{2010}', '\u{2015}'),
    ('\u{2018}', '\u{201e}'),
    ('\u{2020}', '\u{2022}'),
    ('\u{2026}', '\u{2026}'),
    ('\u{2030}', '\u{2030}'),
    ('\u{2032}', '\u{2033}'),
    ('\u{2044}', '\u{2044}'),
    ('\u{2070}', '\u{2071}'),
    ('\u{2074}', '\u{208e}'),
    ('\u{20ac}', '\u{20ac}'),
    ('\u{2103}', '\u{2103}'),
    ('\u{2109}', '\u{2109}'),
    ('\u{2126}', '\u{2126}'),
    ('\u{2190}', '\u{2193}'),
    ('\u{2202}', '\u{2202}'),
    ('\u{2206}', '\u{2206}'),
    ('\u{2211}', '\u{2212}'),
    ('\u{221a}', '\u{221a}'),
    ('\u{221e}', '\u{221e}'),
    ('\u{2248}', '\u{2248}'),
    ('\u{2260}', '\u{2260}'),
    ('\u{2264}', '\u{2265}'),
    ('\u{25ca}', '\u{25ca}'),
];

/// The replacement of a character that the font lacks.
const MISSING: char = '\u{25ca}';

/// The note below a figure with a character that the font lacks.
pub(crate) const NOTE_OF_MISSING: &str =
    "◊ stands for letters that the font Inter lacks, wherever letters are drawn as paths.";

/// Returns whether the font has a character, or whether it ends a line of a document.
fn has(character: char) -> bool {
    character == '\n' || IN_FONT.iter().any(|&(first, last)| (first..=last).contains(&character))
}

/// Returns whether the font lacks a character of a document. Lines of coordinates, which are most of it, are passed over.
pub(crate) fn has_missing(document: &str) -> bool {
    let is_plain = |line: &str| line.bytes().all(|byte| (b' '..=b'~').contains(&byte));
    document.split('\n').any(|line| !is_plain(line) && !line.chars().all(has))
}

/// A text as the font can show it: a lozenge for each character that it lacks, which would vanish otherwise.
pub(crate) fn drawable(text: &str) -> Cow<'_, str> {
    match has_missing(text) {
        true => text.chars().map(|c| if has(c) { c } else { MISSING }).collect::<String>().into(),
        false => text.into(),
    }
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
        assert_eq!(one_line(&"a\nb \t c".into(), 9), "a b c");
        assert_eq!(one_line(&"a\u{1}\u{ffff}\u{202e}b".into(), 99), r"a\u{1}\u{ffff}\u{202e}b");
        assert_eq!(one_line(&"abcdef".into(), 4), "abc…");
        assert_eq!(one_line_of_ends(&"abcdef".into(), 4), "a…ef");
        assert_eq!(one_line_of_ends(&"abcd".into(), 4), "abcd");
        assert_eq!(escaped("a<b & c"), "a&lt;b &amp; c");
    }

    #[cfg(feature = "outlines")]
    #[test]
    fn no_character_vanishes() {
        use resvg::usvg::{Options, Tree, WriteOptions};

        use crate::outlines::FONTS;

        assert_eq!(drawable("λ ⁻² 温度 \u{1F600}"), "λ ⁻² ◊◊ ◊");
        let blank = |c: char| c.is_whitespace() || matches!(c, '\u{ad}');
        for c in IN_FONT.iter().flat_map(|&(first, last)| first..=last).filter(|&c| !blank(c)) {
            let text = escaped(&c.to_string());
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><text y='9' font-size='9'>{text}</text></svg>"
            );
            let font_family = FAMILY.to_owned();
            let options = Options { font_family, fontdb: FONTS.clone(), ..Options::default() };
            let drawn = Tree::from_str(&svg, &options).unwrap().to_string(&WriteOptions::default());
            assert!(drawn.contains("<path"), "U+{:04X}", u32::from(c));
        }
    }
}
