//! Describes the dialect of a text table.

use boundfit_exact::{DecimalMark, Limits, Notation, Rational, Reading, Thousands, is_missing, trim_number};

/// The delimiter that stands for runs of blanks and tabs.
pub const BLANKS: u8 = b' ';

/// The bytes that may separate cells, with the names used on the command line.
pub const DELIMITERS: [(&str, u8); 5] =
    [("comma", b','), ("semicolon", b';'), ("tab", b'\t'), ("space", BLANKS), ("pipe", b'|')];

/// The mark that begins a comment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CommentMark {
    /// Lines that start with `#` or `%`, where leaving them out takes nothing away from the table. That holds before
    /// its header, in a table that such lines precede, and in a table whose columns blanks separate. It also holds
    /// where the lines have another number of cells than a row.
    #[default]
    Auto,
    /// None.
    None,
    /// All that start with this byte.
    Mark(u8),
}

impl CommentMark {
    /// Reads `auto`, `none` or a mark; a letter, a digit or a blank is no mark.
    pub fn parse(text: &str) -> Option<Self> {
        match (text, text.as_bytes()) {
            ("auto", _) => Some(CommentMark::Auto),
            ("none", _) => Some(CommentMark::None),
            (_, [mark]) if mark.is_ascii_punctuation() => Some(CommentMark::Mark(*mark)),
            _ => None,
        }
    }
}

/// The treatment of rows that have no number in a cell that is asked for, but nothing or a word for a missing value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Missing {
    /// Missing values are an error.
    #[default]
    Refuse,
    /// Rows with missing values are left out. They keep their row numbers.
    Skip,
}

impl Missing {
    /// Both of them.
    pub const ALL: [Missing; 2] = [Missing::Refuse, Missing::Skip];

    /// The name used on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Missing::Refuse => "refuse",
            Missing::Skip => "skip",
        }
    }
}

/// Words that mark a missing value, beside the built-in ones.
///
/// ```
/// use boundfit_formats::MissingWords;
///
/// let words = MissingWords::new(["OVLD".to_owned(), "-999".to_owned()]);
/// assert!(["OVLD", " -999.00", "NA"].iter().all(|cell| words.are_in(cell)));
/// assert!(!words.are_in("999"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct MissingWords {
    texts: Vec<String>,
    /// The words that are numbers: a cell with such a number, in any notation that the table may have, is no reading.
    numbers: Vec<Rational>,
    /// The decimal mark of the table, if it is given, and the text between groups of digits.
    notation: (Option<DecimalMark>, Option<Thousands>),
}

impl MissingWords {
    /// These texts.
    pub fn new(texts: impl IntoIterator<Item = String>) -> Self {
        let texts: Vec<String> = texts.into_iter().map(|text| trim_number(&text).to_owned()).collect();
        let numbers = texts.iter().filter_map(|text| numbers_of(text, (None, None)).next()).collect();
        MissingWords { texts, numbers, notation: (None, None) }
    }

    /// These words in a table of this dialect.
    #[must_use]
    pub fn in_dialect(self, dialect: &AskedDialect) -> Self {
        MissingWords { notation: (dialect.given_mark(), dialect.thousands), ..self }
    }

    /// The words, without blanks around them.
    pub(crate) fn texts(&self) -> &[String] {
        &self.texts
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }

    /// Returns whether a cell says that its value is missing.
    pub fn are_in(&self, cell: &str) -> bool {
        is_missing(cell) || self.lists(cell)
    }

    /// Returns whether a cell says so by one of these words.
    pub(crate) fn lists(&self, cell: &str) -> bool {
        if self.is_empty() {
            return false;
        }
        let cell = trim_number(cell);
        self.texts.iter().any(|text| text == cell)
            || (!self.numbers.is_empty()
                && numbers_of(cell, self.notation).any(|number| self.numbers.contains(&number)))
    }
}

/// The numbers that a text may stand for, with the given decimal mark, or else with a point or a comma.
fn numbers_of(
    text: &str,
    (mark, thousands): (Option<DecimalMark>, Option<Thousands>),
) -> impl Iterator<Item = Rational> {
    let marks = DecimalMark::ALL.into_iter().filter(move |decimal| mark.is_none_or(|mark| mark == *decimal));
    marks.filter_map(move |decimal| {
        let notation = Notation { decimal, thousands };
        Reading::Decimal.read_written(text, notation, &Limits::default()).ok()
    })
}

/// The bytes of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// UTF-8, with a byte order mark or not.
    #[default]
    Utf8,
    /// UTF-16, the low byte of two first.
    Utf16Le,
    /// UTF-16, the high byte of two first.
    Utf16Be,
    /// Windows-1252, which Excel's "CSV" is in western Europe.
    Windows1252,
    /// ISO 8859-1.
    Iso8859Part1,
    /// ISO 8859-15.
    Iso8859Part15,
}

impl Encoding {
    /// All of them.
    pub const ALL: [Encoding; 6] = [
        Encoding::Utf8,
        Encoding::Windows1252,
        Encoding::Iso8859Part1,
        Encoding::Iso8859Part15,
        Encoding::Utf16Le,
        Encoding::Utf16Be,
    ];

    /// The encoding with this name, in small or large letters, or with a usual other one: `utf8`, `cp1252`, `latin-1`.
    pub fn named(name: &str) -> Option<Self> {
        let letters = |name: &str| -> String {
            name.chars().filter(|letter| !"-_ ".contains(*letter)).flat_map(char::to_lowercase).collect()
        };
        let wanted = match letters(name).as_str() {
            "cp1252" | "ansi" => "windows1252".to_owned(),
            "latin1" => "iso88591".to_owned(),
            "latin9" => "iso885915".to_owned(),
            other => other.to_owned(),
        };
        Encoding::ALL.into_iter().find(|encoding| letters(encoding.name()) == wanted)
    }

    /// The name that reports and proofs use.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 => "UTF-8",
            Encoding::Utf16Le => "UTF-16LE",
            Encoding::Utf16Be => "UTF-16BE",
            Encoding::Windows1252 => "Windows-1252",
            Encoding::Iso8859Part1 => "ISO-8859-1",
            Encoding::Iso8859Part15 => "ISO-8859-15",
        }
    }
}

/// The dialect of a text table, as far as it is known before the table is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AskedDialect {
    /// The encoding of the bytes. With `None` it is detected: UTF-8, UTF-16, or else Windows-1252.
    pub encoding: Option<Encoding>,
    /// The separator of cells, [`BLANKS`] for runs of blanks and tabs; found out from the first lines when `None`.
    pub delimiter: Option<u8>,
    /// The decimal mark; found out when `None`, unless commas separate cells.
    pub decimal: Option<DecimalMark>,
    /// The text between groups of three digits, if anything.
    pub thousands: Option<Thousands>,
    /// The mark that begins a comment.
    pub comment: CommentMark,
    /// The number of lines before the table.
    pub skip_lines: u64,
    /// `true` if the row after the header has units.
    pub units_row: bool,
}

impl AskedDialect {
    /// Returns the decimal mark that this leaves no choice about: the one that is asked for, or the one that does not group digits.
    pub(crate) fn given_mark(&self) -> Option<DecimalMark> {
        self.decimal.or(match self.thousands {
            Some(Thousands::Comma) => Some(DecimalMark::Point),
            Some(Thousands::Point) => Some(DecimalMark::Comma),
            _ => None,
        })
    }
}

/// The dialect in which a text table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dialect {
    /// The separator of cells, [`BLANKS`] for runs of blanks and tabs.
    pub delimiter: u8,
    /// The notation of numbers.
    pub notation: Notation,
    /// The bytes that begin a comment anywhere in the table.
    pub comment: Option<[u8; 2]>,
    /// The number of lines before the table.
    pub skip_lines: u64,
    /// The number of records before the first data row that are no comments: a header, units.
    pub records_before: usize,
    /// `true` if each row begins with a name of its own, for which the header has no cell.
    pub has_row_names: bool,
    /// The bytes of the text.
    pub encoding: Encoding,
    /// Says whether rows without all their numbers are skipped.
    pub missing: Missing,
}

impl Dialect {
    /// Returns whether a reader that knows quotes, one delimiter and a header, and numbers with points, reads the table alike.
    pub fn is_plain(&self) -> bool {
        self.delimiter != BLANKS
            && self.notation == Notation::default()
            && self.comment.is_none()
            && self.skip_lines == 0
            && self.records_before <= 1
            && !self.has_row_names
            && self.encoding == Encoding::Utf8
    }
}
