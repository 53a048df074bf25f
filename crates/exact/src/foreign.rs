//! Texts that the program did not write.

use std::borrow::Cow;
use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A text from outside: from a file or an argument, such as a name, a cell or the name of a file.
///
/// Its author may want the text to pass for the program's own. A line end begins a line of the report, an escape sequence
/// wipes one from a terminal, and a bidirectional override reverses the order of the text behind it. Its `Display`
/// form is therefore on one line and visible: `\n`, `\u{1b}`, `\u{202e}`. The text itself comes out of
/// [`raw`](Foreign::raw) only, for what compares and for writers with rules of their own (JSON, CSV, XML), so that
/// `format!("{name}")` cannot be wrong.
///
/// The visible form replaces these characters:
/// - control characters, and separators of lines and paragraphs;
/// - blanks other than the space;
/// - format characters: bidirectional marks, soft hyphens, characters without width;
/// - characters of private use or without a meaning;
/// - letters and selectors that show nothing.
///
/// Marks that combine with the letter before them stay, except at the beginning of the text, where they would combine
/// with ours. A backslash stays as it is.
///
/// ```
/// use boundfit_exact::Foreign;
///
/// let name = Foreign::from("x\u{1b}[2K\r\u{202e}y");
/// assert_eq!(name.to_string(), r"x\u{1b}[2K\r\u{202e}y");
/// assert_eq!(name.raw().len(), 10);
/// assert_eq!(format!("{:?}", Foreign::of("a \"b\"\n")), r#""a \"b\"\n""#);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Foreign<T = String>(T);

impl<'a> Foreign<&'a str> {
    /// A text from outside where it stands.
    pub fn of(text: &'a str) -> Self {
        Foreign(text)
    }

    /// The text as it is, for as long as it stands there; see [`raw`](Foreign::raw).
    pub fn into_inner(self) -> &'a str {
        self.0
    }
}

impl<T: AsRef<str>> Foreign<T> {
    /// The text as it is. Nothing prints it without escaping it by rules of its own.
    pub fn raw(&self) -> &str {
        self.0.as_ref()
    }

    /// Returns whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.raw().is_empty()
    }

    /// The text where it stands.
    pub fn borrowed(&self) -> Foreign<&str> {
        Foreign(self.raw())
    }

    /// The text on its own.
    pub fn to_owned(&self) -> Foreign {
        Foreign(self.raw().to_owned())
    }

    /// The text in quotes, as a message repeats it: cut after 40 characters.
    ///
    /// ```
    /// use boundfit_exact::Foreign;
    ///
    /// assert_eq!(Foreign::of("1\t2").quoted(), r#""1\t2""#);
    /// assert_eq!(Foreign::of(&"7".repeat(41)).quoted(), format!("{:?}...", "7".repeat(40)));
    /// ```
    pub fn quoted(&self) -> String {
        /// The longest piece of a text that a message repeats.
        const LONGEST: usize = 40;
        match self.raw().char_indices().nth(LONGEST) {
            Some((end, _)) => format!("{:?}...", Foreign(self.raw().get(..end).unwrap_or_default())),
            None => format!("{self:?}"),
        }
    }

    /// The text as a label of a picture or a page shows it, on one line. A space stands for blanks of any kind. Soft hyphens and the
    /// selectors behind emoji are not there: text from other programs has them without anybody's intention.
    ///
    /// ```
    /// use boundfit_exact::Foreign;
    ///
    /// assert_eq!(Foreign::of("U\u{a0}in\n V \u{1f321}\u{fe0f}").label(), "U in V \u{1f321}");
    /// assert_eq!(Foreign::of("x\u{202e}y").label(), r"x\u{202e}y");
    /// ```
    pub fn label(&self) -> String {
        let says_nothing = |character: char| matches!(character, '\u{ad}' | '\u{fe00}'..='\u{fe0f}');
        let text = self.raw().replace(says_nothing, "");
        let words: Vec<&str> = text.split_whitespace().collect();
        Foreign(words.join(" ")).to_string()
    }

    /// The text, made visible.
    fn visible(&self) -> Cow<'_, str> {
        let text = self.raw();
        // Almost every text.
        if text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
            return Cow::Borrowed(text);
        }
        let mut visible = String::with_capacity(text.len());
        for (position, character) in text.char_indices() {
            push(character, position == 0, &mut visible);
        }
        Cow::Owned(visible)
    }
}

impl Foreign {
    /// The text as it is, on its own.
    pub fn into_raw(self) -> String {
        self.0
    }
}

impl From<String> for Foreign {
    fn from(text: String) -> Self {
        Foreign(text)
    }
}

impl From<&str> for Foreign {
    fn from(text: &str) -> Self {
        Foreign(text.to_owned())
    }
}

impl From<&String> for Foreign {
    fn from(text: &String) -> Self {
        Foreign(text.clone())
    }
}

impl From<&Foreign> for Foreign {
    fn from(text: &Foreign) -> Self {
        text.clone()
    }
}

impl From<Foreign<&str>> for Foreign {
    fn from(text: Foreign<&str>) -> Self {
        text.to_owned()
    }
}

impl<T: AsRef<str>> PartialEq<str> for Foreign<T> {
    fn eq(&self, other: &str) -> bool {
        self.raw() == other
    }
}

impl<T: AsRef<str>> PartialEq<&str> for Foreign<T> {
    fn eq(&self, other: &&str) -> bool {
        self.raw() == *other
    }
}

/// The text on one line, with all of it visible.
impl<T: AsRef<str>> fmt::Display for Foreign<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.visible())
    }
}

/// The text in quotes, on one line, with all of it visible. Quotes and backslashes within have a backslash before them.
impl<T: AsRef<str>> fmt::Debug for Foreign<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut quoted = String::from("\"");
        for (position, character) in self.raw().char_indices() {
            if matches!(character, '"' | '\\') {
                quoted.push('\\');
            }
            push(character, position == 0, &mut quoted);
        }
        quoted.push('"');
        f.pad(&quoted)
    }
}

/// The text as it is: such formats escape it themselves.
impl<T: AsRef<str>> Serialize for Foreign<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.raw())
    }
}

/// Any text.
impl<'de> Deserialize<'de> for Foreign {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer).map(Foreign)
    }
}

#[cfg(feature = "schema")]
impl<T> schemars::JsonSchema for Foreign<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        String::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        String::json_schema(generator)
    }
}

/// Appends a character, made visible.
fn push(character: char, is_first: bool, visible: &mut String) {
    if is_visible(character, is_first) {
        visible.push(character);
    } else if shows_nothing(character) {
        visible.extend(character.escape_unicode());
    } else {
        visible.extend(character.escape_debug());
    }
}

/// Returns whether a character shows as itself, and nothing else.
fn is_visible(character: char, is_first: bool) -> bool {
    if character.is_ascii() {
        return !character.is_ascii_control();
    }
    // The standard library leaves alone what its table of Unicode calls printable, and marks that combine if they are not the first.
    let before = if is_first { "" } else { "a" };
    let text = format!("{before}{character}");
    !shows_nothing(character) && text.escape_debug().eq(text.chars())
}

/// Letters, signs and selectors that Unicode counts as printable although they show nothing ("default ignorable code points"),
/// and the empty pattern of Braille.
fn shows_nothing(character: char) -> bool {
    matches!(
        character,
        '\u{34f}'
            | '\u{115f}' | '\u{1160}'
            | '\u{17b4}' | '\u{17b5}'
            | '\u{180b}'..='\u{180f}'
            | '\u{2800}'
            | '\u{3164}'
            | '\u{fe00}'..='\u{fe0f}'
            | '\u{ffa0}'
            | '\u{e0100}'..='\u{e01ef}'
    )
}

#[cfg(test)]
mod tests {
    use super::Foreign;

    #[test]
    fn what_moves_or_hides_text_is_made_visible() {
        let controls = (0..=0x1f).chain(0x7f..=0x9f);
        let bidirectional = [0x61c, 0x200e, 0x200f].into_iter().chain(0x202a..=0x202e).chain(0x2066..=0x2069);
        let line_ends = [0x2028, 0x2029];
        let invisible =
            [0xad, 0x34f, 0x200b, 0x200c, 0x200d, 0x2060, 0x2800, 0x3164, 0xfe0f, 0xfeff, 0xffa0, 0xe0041];
        let blanks = [0xa0, 0x2003, 0x202f, 0x3000];
        for code in controls.chain(bidirectional).chain(line_ends).chain(invisible).chain(blanks) {
            let character = char::from_u32(code).unwrap();
            let shown = Foreign::from(format!("a{character}b")).to_string();
            assert!(shown.starts_with("a\\") && shown.ends_with('b'), "{code:x}: {shown:?}");
            assert!(shown.bytes().all(|byte| (b' '..=b'~').contains(&byte)), "{code:x}: {shown:?}");
            let quoted = format!("{:?}", Foreign::of(&format!("a{character}b")));
            assert_eq!(quoted, format!("\"{shown}\""));
        }
        assert_eq!(Foreign::of("\r\n\t\0\u{1b}\u{ad}\u{3164}").to_string(), r"\r\n\t\0\u{1b}\u{ad}\u{3164}");
    }

    #[test]
    fn what_can_be_seen_stays() {
        for text in [
            "",
            "x",
            "U (mV)",
            "a'b\"c",
            r"C:\data\x.csv",
            "θ₁ ≤ Δ°",
            "e\u{301}",
            "速度",
            "שלום",
            "🎈",
            "\u{fffd}",
        ] {
            assert_eq!(Foreign::of(text).to_string(), text);
        }
        assert_eq!(
            Foreign::of("\u{338}x").to_string(),
            r"\u{338}x",
            "it would strike out what we print before"
        );
        assert_eq!(format!("[{:>3}|{:<4}]", Foreign::of("a"), Foreign::of("\n")), "[  a|\\n  ]");
        assert_eq!(format!("{:?}", Foreign::of("a\"\\")), r#""a\"\\""#);
    }

    #[test]
    fn writers_with_rules_of_their_own_have_the_text_itself() {
        let name = Foreign::from("a\n\u{202e}");
        assert_eq!((name.raw(), name.borrowed().raw()), ("a\n\u{202e}", "a\n\u{202e}"));
        let json = serde_json::to_string(&name).unwrap();
        assert_eq!(serde_json::from_str::<Foreign>(&json).unwrap().into_raw(), "a\n\u{202e}");
    }
}
