//! What is asked, and the way to its answer.

use boundfit_formats::Source;
use boundfit_report::{Origin, Style};
use serde::Deserialize;
use serde_json::Value;

use crate::asked::Asked;
use crate::fit::Fit;
use crate::fleet::Fleet;
use crate::form::{Form, Paper, Written};
use crate::linearity::Linearity;
use crate::next::Next;
use crate::outliers::Outliers;
use crate::predict::Predict;
use crate::question::Ask;
use crate::range::Range;
use crate::refusal::Refusal;
use crate::status::Status;
use crate::window::Window;
use crate::x_errors::FitXErrors;

/// One form of an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Answer {
    /// The text.
    pub text: String,
    /// What is said beside it.
    pub written: Written,
}

/// From a table to the text of an answer.
fn ask<Q: Ask>(
    question: &Q,
    asked: &Asked,
    source: Source,
    form: Form,
    origin: Option<Origin<'_>>,
    style: &Style,
) -> Result<Answer, Refusal> {
    if !Q::FORMS.contains(&form) {
        return Err(Q::no_form(form));
    }
    let name = source.name().to_owned();
    let own = || Origin {
        file: Some(boundfit_exact::Foreign::of(name.raw())),
        reading: asked.options.table.reading,
        is_stored: source.is_stored(),
    };
    let paper = Paper { origin: origin.unwrap_or_else(own), style: *style };
    let problem = question.read(asked, source, form.shows())?;
    let answer = question.answer(&problem)?;
    let mut text = Vec::new();
    let written = question.write(&problem, &answer, form, &paper, &mut text)?;
    Ok(Answer { text: String::from_utf8_lossy(&text).into_owned(), written })
}

macro_rules! questions {
    ($($question:ident),* $(,)?) => {
        /// Every question, as JSON says it: `{"ask": "range", "by": "row"}`.
        #[derive(Debug, Clone, Deserialize)]
        #[serde(tag = "ask", rename_all = "kebab-case", rename_all_fields = "snake_case")]
        pub enum Request {
            $(#[doc = concat!("See [`", stringify!($question), "`].")] $question($question)),*
        }

        impl Request {
            /// The names of all questions.
            pub const NAMES: &'static [&'static str] = &[$($question::NAME),*];

            /// All questions by their names, with the forms of their answers.
            pub const FORMS: &'static [(&'static str, &'static [Form])] =
                &[$(($question::NAME, $question::FORMS)),*];

            /// The name of this one.
            pub fn name(&self) -> &'static str {
                match self { $(Request::$question(_) => $question::NAME),* }
            }

            /// The forms of its answer.
            pub fn forms(&self) -> &'static [Form] {
                match self { $(Request::$question(_) => $question::FORMS),* }
            }

            /// One form of the answer about a table, said to come from `origin`, or from the source itself.
            ///
            /// # Errors
            /// Why there is none.
            pub fn answer(
                &self,
                asked: &Asked,
                source: Source,
                form: Form,
                origin: Option<Origin<'_>>,
                style: &Style,
            ) -> Result<Answer, Refusal> {
                match self { $(Request::$question(own) => ask(own, asked, source, form, origin, style)),* }
            }
        }
    };
}

questions!(Fit, FitXErrors, Fleet, Linearity, Next, Outliers, Predict, Range, Status, Window);

impl Request {
    /// Reads a request as JSON says it.
    ///
    /// # Errors
    /// With the key that is missing, not known, or of another type.
    pub fn parse(json: &str) -> Result<Self, Refusal> {
        serde_json::from_str(json).map_err(|error| Refusal::Request(format!("request: {error}")))
    }

    /// As [`Request::parse`], of what is parsed.
    ///
    /// # Errors
    /// Those of [`Request::parse`].
    pub fn of_json(json: Value) -> Result<Self, Refusal> {
        serde_json::from_value(json).map_err(|error| Refusal::Request(format!("request: {error}")))
    }
}
