//! The ways in which tables write numbers: decimal marks, grouped digits, and the words for what is missing.

/// The mark between the whole part of a decimal and the digits after it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum DecimalMark {
    /// A point: `1.5`.
    #[default]
    Point,
    /// A comma: `1,5`.
    Comma,
}

impl DecimalMark {
    /// Both of them.
    pub const ALL: [DecimalMark; 2] = [DecimalMark::Point, DecimalMark::Comma];

    /// The name used on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            DecimalMark::Point => "point",
            DecimalMark::Comma => "comma",
        }
    }

    /// The mark itself.
    pub fn byte(self) -> u8 {
        match self {
            DecimalMark::Point => b'.',
            DecimalMark::Comma => b',',
        }
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            DecimalMark::Point => DecimalMark::Comma,
            DecimalMark::Comma => DecimalMark::Point,
        }
    }
}

/// The way in which a text writes its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Notation {
    /// The decimal mark.
    pub decimal: DecimalMark,
    /// The mark that may stand between groups of three digits; digits are not grouped when `None`.
    pub thousands: Option<Thousands>,
}

/// The mark between groups of three digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Thousands {
    /// `1,234,567`.
    Comma,
    /// `1.234.567`.
    Point,
    /// `1 234 567`, with a blank or a space that does not break.
    Blank,
    /// `1'234'567`, with a straight or a curved apostrophe.
    Apostrophe,
}

impl Thousands {
    /// All four.
    pub const ALL: [Thousands; 4] =
        [Thousands::Comma, Thousands::Point, Thousands::Blank, Thousands::Apostrophe];

    /// The mark as it is asked for on the command line.
    pub fn mark(self) -> &'static str {
        match self {
            Thousands::Comma => ",",
            Thousands::Point => ".",
            Thousands::Blank => " ",
            Thousands::Apostrophe => "'",
        }
    }

    /// A number without the marks between its groups of digits.
    ///
    /// ```
    /// use boundfit_exact::Thousands;
    ///
    /// assert_eq!(Thousands::Point.taken_out_of("1.234,50"), "1234,50");
    /// ```
    pub fn taken_out_of(self, number: &str) -> String {
        number.chars().filter(|&character| !self.is(character)).collect()
    }

    fn is(self, character: char) -> bool {
        match self {
            Thousands::Comma => character == ',',
            Thousands::Point => character == '.',
            Thousands::Blank => character == ' ' || SPACES.contains(&character),
            Thousands::Apostrophe => matches!(character, '\'' | '\u{2019}'),
        }
    }

    /// Returns how many bytes the mark takes at the start of a text; 0 where it does not stand.
    pub(crate) fn length_in(self, text: &str) -> usize {
        text.chars().next().filter(|&first| self.is(first)).map_or(0, char::len_utf8)
    }
}

/// White space beyond ASCII that spreadsheets and typesetters put around numbers and between their digits. The
/// characters are the space without a break, the space as wide as a digit, the thin space, and the thin space without
/// a break.
pub(crate) const SPACES: [char; 4] = ['\u{a0}', '\u{2007}', '\u{2009}', '\u{202f}'];

/// A text without the white space around it that numbers may have.
pub fn trim_number(text: &str) -> &str {
    text.trim_matches(|character: char| character.is_ascii_whitespace() || SPACES.contains(&character))
}

/// The words in a cell whose value is missing, beside nothing: in any letters, small or large. The last ones are what
/// spreadsheets in other languages have for `#N/A`.
pub const MISSING_WORDS: [&str; 14] =
    ["NA", "N/A", "#N/A", "NaN", "null", "none", "-", "--", ".", "?", "#NV", "#N/D", "#N/B", "#GETTING_DATA"];

/// Returns whether a text says that a value is missing: nothing but white space, one of [`MISSING_WORDS`], or an error of a
/// spreadsheet, such as `#DIV/0!`, `#NAME?` or `Err:502`. No number is written so.
///
/// ```
/// use boundfit_exact::is_missing;
///
/// assert!(["", "  ", "NA", " nan", "#N/A", "-", "#DIV/0!", "#name?", "#WERT!", "Err:502"].into_iter().all(is_missing));
/// assert!(!["0", "-1", "inf", "error", "#1", "#!", "# no!", "Err:", "Err:x"].into_iter().any(is_missing));
/// ```
pub fn is_missing(text: &str) -> bool {
    // Most texts are numbers, and no word begins with a digit, nor with a sign and a digit.
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    if unsigned.starts_with(|first: char| first.is_ascii_digit()) {
        return false;
    }
    let text = trim_number(text);
    text.is_empty()
        || MISSING_WORDS.iter().any(|word| word.eq_ignore_ascii_case(text))
        || is_sheet_error(text)
}

/// `#` and a word that ends with `!` or `?`, in whatever language; LibreOffice's `Err:` and a number.
fn is_sheet_error(text: &str) -> bool {
    let word = text.strip_prefix('#').and_then(|rest| rest.strip_suffix(['!', '?']));
    let number = text.split_at_checked(4).filter(|(start, _)| start.eq_ignore_ascii_case("err:"));
    word.is_some_and(|word| !word.is_empty() && !word.contains(' '))
        || number
            .is_some_and(|(_, number)| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}
