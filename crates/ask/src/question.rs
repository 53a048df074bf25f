//! The interface of every question.

use boundfit_estimation::{Measurements, MultipleOfLeast};
use boundfit_exact::Reading;
use boundfit_formats::{Source, TableNotes};
use boundfit_report::{Document, Origin, Style, Theory};

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::{Answer, Paper};
use crate::refusal::Refusal;

/// The facts that a theorem for Coq needs beside the answer.
#[derive(Debug, Clone, Copy)]
pub struct AskedTheorem<'a> {
    /// The reading of numbers.
    pub reading: Reading,
    /// The source of the theory.
    pub theory: Theory,
    /// The bytes of the data and their SHA-256, which the theorem may hold; then it says that its rows are read from them.
    pub data: Option<(&'a [u8], &'a str)>,
}

/// The subject of a question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// Readings with bounds on their errors.
    BoundedReadings,
    /// Readings alone: bounds on the errors have no say in the question.
    Readings,
    /// Half-planes, or the generators of a set, without readings.
    HalfPlanes,
    /// A linear program, without readings.
    LinearProgram,
}

/// A question about readings, about half-planes or about a linear program.
pub trait Ask {
    /// The name of the question: the value of `ask`, and the command.
    const NAME: &'static str;
    /// The forms of its answer.
    const FORMS: &'static [Form];
    /// The subject of the question.
    const SUBJECT: Subject = Subject::BoundedReadings;
    /// `true` if the question looks at errors in x. Others are refused beside them.
    const LOOKS_AT_X_ERRORS: bool = false;
    /// The readings, half-planes or linear program, read as the question needs them.
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
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal>;

    /// Writes one form of the answer as [`Ask::write`] does, to memory.
    ///
    /// # Errors
    /// The errors of [`Ask::write`].
    fn text(
        &self,
        problem: &Self::Problem,
        answer: &Self::Answer,
        form: Form,
        origin: Origin<'_>,
        style: Style,
    ) -> Result<Answer, Refusal> {
        let mut text = Vec::new();
        let written = self.write(problem, answer, &mut Paper { form, origin, style, out: &mut text })?;
        Ok(Answer { text: String::from_utf8_lossy(&text).into_owned(), written })
    }

    /// Returns the main statement of the answer as a theorem for Coq, about a problem that was read with [`Shows::Readings`]. Exact.
    ///
    /// # Errors
    /// When the answer has no theorem.
    fn theorem(&self, _: &Self::Problem, _: &Self::Answer, _: AskedTheorem<'_>) -> Result<String, Refusal> {
        Err(Refusal::NoProof(NoProof::NoTheorem))
    }

    /// Refuses keys that an answer in this form has no place for. A proof stands beside a report, which has.
    ///
    /// # Errors
    /// With the first such key.
    fn refuse_vain(&self, _form: Form) -> Result<(), Refusal> {
        Ok(())
    }

    /// Refuses a style of decimals that an answer in this form has no place for.
    ///
    /// # Errors
    /// With the first key that would say nothing.
    fn refuse_vain_style(&self, form: Form, style: &Style) -> Result<(), Misuse> {
        form.refuse_vain_style(style)
    }

    /// Writes the answer in one of the forms that every document has. Text, which may have a line for each of a million vertices, is
    /// written in parts.
    ///
    /// # Errors
    /// When the form is another one, or cannot be written.
    fn report<'d>(paper: &mut Paper<'_>, document: impl FnOnce() -> Document<'d>) -> Result<(), Refusal> {
        match paper.form {
            Form::Text => document().write_text(&mut *paper.out).map_err(Refusal::Output),
            Form::Latex => paper.put(document().to_latex()),
            Form::Markdown => paper.put(document().to_markdown()),
            form => Err(Self::no_form(form)),
        }
    }

    /// Refuses a form.
    fn no_form(form: Form) -> Refusal {
        Refusal::Form { ask: Self::NAME, form, forms: Self::FORMS }
    }
}
