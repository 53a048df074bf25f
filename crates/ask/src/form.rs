//! How answers are written.

use boundfit_report::{Origin, Style};

/// How an answer is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// A report for people.
    Text,
    /// The report's tables in LaTeX.
    Latex,
    /// The report's tables in Markdown.
    Markdown,
    /// Everything, for programs.
    Json,
    /// A table.
    Csv,
    /// The set as well-known text.
    Wkt,
    /// The proof.
    Proof,
}

impl Form {
    /// Every form.
    pub const ALL: [Form; 7] =
        [Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Wkt, Form::Proof];

    /// Its name: `text`, `latex`, `markdown`, `json`, `csv`, `wkt` or `proof`.
    pub const fn name(self) -> &'static str {
        match self {
            Form::Text => "text",
            Form::Latex => "latex",
            Form::Markdown => "markdown",
            Form::Json => "json",
            Form::Csv => "csv",
            Form::Wkt => "wkt",
            Form::Proof => "proof",
        }
    }

    /// Whether the answer shows a hash of the data and the rows that are fitted.
    pub fn shows_data(self) -> bool {
        matches!(self, Form::Json | Form::Proof)
    }

    /// Whether the answer says what the table was taken for.
    pub fn has_input(self) -> bool {
        matches!(self, Form::Text | Form::Latex | Form::Markdown | Form::Json)
    }
}

/// Where an answer is written, and how: what forms need beside the answer.
#[derive(Debug, Clone, Copy)]
pub struct Paper<'a> {
    /// Where the readings come from.
    pub origin: Origin<'a>,
    /// How numbers are shown.
    pub style: Style,
}

/// What a form says of the answer beside its text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    /// Whether nothing is left: the set is empty.
    pub is_empty: bool,
    /// A summary for people, where the form itself has no place for it.
    pub summary: String,
}

impl Written {
    /// What an answer says that is one set.
    pub(crate) fn of_set(is_empty: bool) -> Self {
        Written { is_empty, summary: String::new() }
    }
}
