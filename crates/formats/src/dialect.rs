//! How a text table is written.

use boundfit_exact::{DecimalMark, Notation, Thousands};

/// The delimiter that stands for runs of blanks and tabs.
pub const BLANKS: u8 = b' ';

/// What may separate cells, with the names used on the command line.
pub const DELIMITERS: [(&str, u8); 5] =
    [("comma", b','), ("semicolon", b';'), ("tab", b'\t'), ("space", BLANKS), ("pipe", b'|')];

/// Which lines are comments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CommentMark {
    /// Those that start with `#` or `%`, where that does not take anything away from the table: before its header, in a table
    /// that such lines precede or whose columns blanks separate, and where their cells are not as many as those of a row.
    #[default]
    Auto,
    /// None.
    None,
    /// All that start with this byte.
    Mark(u8),
}

impl CommentMark {
    /// What `auto`, `none` or a mark asks for; a letter, a digit or a blank is no mark.
    pub fn parse(text: &str) -> Option<Self> {
        match (text, text.as_bytes()) {
            ("auto", _) => Some(CommentMark::Auto),
            ("none", _) => Some(CommentMark::None),
            (_, [mark]) if mark.is_ascii_punctuation() => Some(CommentMark::Mark(*mark)),
            _ => None,
        }
    }
}

/// What becomes of rows that have no number in a cell that is asked for, but nothing or a word for a missing value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Missing {
    /// They are an error.
    #[default]
    Refuse,
    /// They are left out. They keep their row numbers.
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
}

impl Encoding {
    /// The name that reports and proofs use.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 => "UTF-8",
            Encoding::Utf16Le => "UTF-16LE",
            Encoding::Utf16Be => "UTF-16BE",
        }
    }
}

/// How a text table is written, as far as that is known before it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AskedDialect {
    /// What separates cells, [`BLANKS`] for runs of blanks and tabs; found out from the first lines when `None`.
    pub delimiter: Option<u8>,
    /// The decimal mark; found out when `None`, unless commas separate cells.
    pub decimal: Option<DecimalMark>,
    /// What stands between groups of three digits, if anything.
    pub thousands: Option<Thousands>,
    /// Which lines are comments.
    pub comment: CommentMark,
    /// How many lines come before the table.
    pub skip_lines: u64,
    /// Whether the row after the header has units.
    pub units_row: bool,
}

/// How a text table turned out to be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dialect {
    /// What separates cells, [`BLANKS`] for runs of blanks and tabs.
    pub delimiter: u8,
    /// How numbers are written.
    pub notation: Notation,
    /// With which bytes a line starts that is a comment wherever it stands.
    pub comment: Option<[u8; 2]>,
    /// How many lines come before the table.
    pub skip_lines: u64,
    /// How many records that are no comments come before the first data row: a header, units.
    pub records_before: usize,
    /// The bytes of the text.
    pub encoding: Encoding,
    /// Whether rows without all their numbers are left out.
    pub missing: Missing,
}

impl Dialect {
    /// Whether a reader that knows quotes, one delimiter and a header, and numbers with points, reads the table alike.
    pub fn is_plain(&self) -> bool {
        self.delimiter != BLANKS
            && self.notation == Notation::default()
            && self.comment.is_none()
            && self.skip_lines == 0
            && self.records_before <= 1
            && self.encoding == Encoding::Utf8
    }

    /// What is unusual about the table, in words: nothing where commas, semicolons or tabs separate numbers with points.
    pub fn words(&self) -> Option<String> {
        let mut words = Vec::new();
        let (separator, is_usual) = match self.delimiter {
            b',' => ("commas", true),
            b';' => ("semicolons", true),
            b'\t' => ("tabs", true),
            b'|' => ("bars", false),
            BLANKS => ("blanks", false),
            _ => ("other characters", true),
        };
        if self.notation.decimal == DecimalMark::Comma {
            words.push("decimal comma".to_owned());
        }
        if let Some(thousands) = self.notation.thousands {
            words.push(format!("digits grouped by {:?}", thousands.mark()));
        }
        if !(words.is_empty() && is_usual) {
            words.push(format!("separated by {separator}"));
        }
        if self.encoding != Encoding::Utf8 {
            words.push(self.encoding.name().to_owned());
        }
        (!words.is_empty()).then(|| words.join(", "))
    }
}
