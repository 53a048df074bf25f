//! The forms of answers.

use boundfit_report::{EndRounding, Style};

use crate::misuse::Misuse;

/// The form of an answer.
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
    /// The vertices, rays and lines of the set, as a table.
    Vertices,
    /// The vertices as a script for MATLAB and Octave.
    M,
    /// The irredundant half-planes as cdd and lrs read them.
    Ine,
    /// The vertices, rays and lines as cdd and lrs read them.
    Ext,
    /// The findings about solutions as SARIF, for code hosts.
    Sarif,
    /// The findings about solutions as JUnit XML, for continuous integration.
    Junit,
    /// The proof.
    Proof,
}

impl Form {
    /// Every form.
    pub const ALL: [Form; 13] = [
        Form::Text,
        Form::Latex,
        Form::Markdown,
        Form::Json,
        Form::Csv,
        Form::Wkt,
        Form::Vertices,
        Form::M,
        Form::Ine,
        Form::Ext,
        Form::Sarif,
        Form::Junit,
        Form::Proof,
    ];

    /// Returns the name of the form: that of its variant, in small letters.
    pub const fn name(self) -> &'static str {
        match self {
            Form::Text => "text",
            Form::Latex => "latex",
            Form::Markdown => "markdown",
            Form::Json => "json",
            Form::Csv => "csv",
            Form::Wkt => "wkt",
            Form::Vertices => "vertices",
            Form::M => "m",
            Form::Ine => "ine",
            Form::Ext => "ext",
            Form::Sarif => "sarif",
            Form::Junit => "junit",
            Form::Proof => "proof",
        }
    }

    /// Returns the part of the data that the answer shows.
    pub fn shows(self) -> Shows {
        match self {
            Form::Json => Shows::Hash,
            Form::Proof => Shows::Rows,
            _ => Shows::Nothing,
        }
    }

    /// Returns whether the answer is a report for people.
    pub(crate) fn is_document(self) -> bool {
        matches!(self, Form::Text | Form::Latex | Form::Markdown)
    }

    /// Refuses a style of decimals where an answer about one set has none.
    ///
    /// # Errors
    /// With the first key that would say nothing.
    pub fn refuse_vain_style(self, style: &Style) -> Result<(), Misuse> {
        let has_decimals = self.is_document() || matches!(self, Form::Json | Form::Proof);
        let has_digits = has_decimals || matches!(self, Form::Vertices | Form::Wkt);
        let vain = if style.digits.is_some() && !has_digits {
            Misuse::VainDigits
        } else if style.ends != EndRounding::Outward && !has_decimals {
            Misuse::VainRounding
        } else if style.exact && !has_decimals {
            Misuse::VainExact
        } else {
            return Ok(());
        };
        Err(vain)
    }

    /// Returns whether the answer states the detected format of the table.
    pub fn has_input(self) -> bool {
        matches!(self, Form::Text | Form::Latex | Form::Markdown | Form::Json)
    }
}

/// The part of the data themselves that an answer shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shows {
    /// Nothing that takes memory for each row.
    Nothing,
    /// A hash.
    Hash,
    /// A hash, and which rows are fitted.
    Rows,
    /// The same, and every reading: a theorem states all of them.
    Readings,
}

/// The facts that a form reports about the answer beside its text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    /// `true` if the set is empty.
    pub is_empty: bool,
    /// `true` if a claim is refuted.
    pub is_refuted: bool,
    /// A summary for people, where the form itself has no place for it.
    pub summary: String,
}

impl Written {
    /// Returns the facts about an answer that is one set.
    pub(crate) fn of_set(is_empty: bool) -> Self {
        Written { is_empty, ..Written::default() }
    }
}
