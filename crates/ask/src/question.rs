//! The interface of every question.

use std::io::Write;

use boundfit_estimation::{Measurements, MultipleOfLeast};
use boundfit_exact::Reading;
use boundfit_formats::{Source, TableNotes};
use boundfit_report::{Document, Theory};

use crate::asked::Asked;
use crate::form::{Form, Paper, Shows, Written};
use crate::misuse::NoProof;
use crate::refusal::Refusal;

/// The place where an answer is written.
pub type Out<'a> = dyn Write + Send + 'a;

/// A question about readings.
pub trait Ask {
    /// The name of the question: the value of `ask`, and the command.
    const NAME: &'static str;
    /// The forms of its answer.
    const FORMS: &'static [Form];
    /// `true` if bounds on the errors have a say in the question.
    const HAS_BOUNDS: bool = true;
    /// `true` if the question looks at errors in x. Others are refused beside them.
    const LOOKS_AT_X_ERRORS: bool = false;
    /// The subject of the question: readings, read as the question needs them.
    type Problem;
    /// The answer, from which every form is written.
    type Answer;

    /// Reads the data, and refuses what would take too much work. Forms that show the data themselves say what of them.
    ///
    /// # Errors
    /// Why there is no answer.
    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Self::Problem, Refusal>;

    /// The readings, from which follows what is said beside every answer; `None` where they are no longer there, or are those of groups.
    fn measurements<'a>(&self, problem: &'a Self::Problem) -> Option<&'a Measurements>;

    /// Returns the detected format of the table.
    fn table<'a>(&self, problem: &'a Self::Problem) -> Option<&'a TableNotes> {
        self.measurements(problem)?.table()
    }

    /// The number of rows that are left out since they lack a number; 0 where the answer itself says so in every form.
    fn rows_missing(&self, problem: &Self::Problem) -> usize {
        self.measurements(problem).map_or(0, Measurements::rows_missing)
    }

    /// The multiple of ε_min that bounds the errors, if it was asked for; `None` where the answer itself says so in this form.
    fn multiple_of_least<'a>(&self, problem: &'a Self::Problem, _form: Form) -> Option<&'a MultipleOfLeast> {
        self.measurements(problem)?.multiple_of_least()
    }

    /// Finds the answer. Exact.
    ///
    /// # Errors
    /// Why there is none.
    fn answer(&self, problem: &Self::Problem) -> Result<Self::Answer, Refusal>;

    /// Writes one form of the answer. Nothing is computed but what is rounded, and what an answer that is a stream has of each reading
    /// or group as it is written.
    ///
    /// # Errors
    /// When the form is none of this answer's, or cannot be written.
    fn write(
        &self,
        problem: &Self::Problem,
        answer: &Self::Answer,
        form: Form,
        paper: &Paper<'_>,
        out: &mut Out<'_>,
    ) -> Result<Written, Refusal>;

    /// Returns the main statement of the answer as a theorem for Coq, about a problem that was read with [`Shows::Readings`]. Exact. With
    /// the bytes of the data and their SHA-256, the theorem may hold the bytes and say that its rows are read from them.
    ///
    /// # Errors
    /// When the answer has no theorem.
    fn theorem(
        &self,
        _problem: &Self::Problem,
        _answer: &Self::Answer,
        _reading: Reading,
        _theory: Theory,
        _data: Option<(&[u8], &str)>,
    ) -> Result<String, Refusal> {
        Err(Refusal::NoProof(NoProof::NoTheorem))
    }

    /// Refuses keys that an answer in this form has no place for. A proof stands beside a report, which has.
    ///
    /// # Errors
    /// With the first such key.
    fn refuse_vain(&self, _form: Form) -> Result<(), Refusal> {
        Ok(())
    }

    /// Refuses a form.
    fn no_form(form: Form) -> Refusal {
        Refusal::Form { ask: Self::NAME, form, forms: Self::FORMS }
    }
}

/// Writes a text.
pub(crate) fn put(out: &mut Out<'_>, text: impl AsRef<[u8]>) -> Result<(), Refusal> {
    out.write_all(text.as_ref()).map_err(Refusal::Output)
}

/// A document in one of the forms that every document has.
pub(crate) fn document(form: Form, document: impl FnOnce() -> Document) -> Option<String> {
    match form {
        Form::Text => Some(document().to_text()),
        Form::Latex => Some(document().to_latex()),
        Form::Markdown => Some(document().to_markdown()),
        _ => None,
    }
}
