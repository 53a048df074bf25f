//! Why there is no answer, as data. Sentences name keys and limits as the surface does where they are read.

use std::io;

use boundfit_estimation::{ParseBoundError, ParseConditionError};
use boundfit_exact::english::counted;
use boundfit_exact::{Limit, ParseNumberError, ParseNumberErrorKind, TooMuchWork};
use boundfit_formats::{InputError, Way};
use boundfit_questions::{NoFurtherError, NoOutliers};

use crate::form::Form;
use crate::misuse::{Misuse, NoProof};
use crate::surface::Surface;

/// Why there is no answer.
#[derive(Debug)]
pub enum Refusal {
    /// The request is none: what JSON says of it.
    Request(String),
    /// What a key asks for makes no sense.
    Value {
        /// The key.
        key: &'static str,
        /// What it asks for.
        text: String,
        /// What is wrong with it.
        problem: ValueProblem,
    },
    /// Keys exclude or need each other.
    Misuse(Misuse),
    /// The table cannot be read.
    Input(InputError),
    /// Numbers are too long.
    Work(TooMuchWork),
    /// The question is about every reading, and the data are a reduction.
    Reduction {
        /// The question.
        ask: &'static str,
    },
    /// The errors of x are none.
    XErrors(String),
    /// The readings are none that the question can be asked about: why.
    Readings(String),
    /// Nothing is known of the error of a reading, of which it is asked where it comes from: why.
    FurtherError(NoFurtherError),
    /// Nothing bounds the error of the next reading, which the question is about: why.
    NextError(String),
    /// Outliers are not found.
    Outliers {
        /// Why.
        why: NoOutliers,
        /// The limit on crossings, where it can be raised.
        steps: Option<u64>,
    },
    /// The answer is not written like that.
    Form {
        /// The question.
        ask: &'static str,
        /// The form.
        form: Form,
        /// The forms there are.
        forms: &'static [Form],
    },
    /// Well-known text has no such set: why.
    Wkt(String),
    /// There is no proof.
    NoProof(NoProof),
    /// The answer cannot be written.
    Output(io::Error),
}

/// What is wrong with a value.
#[derive(Debug)]
pub enum ValueProblem {
    /// It is no number, or one beyond a limit.
    Number {
        /// What is wrong with it.
        error: ParseNumberError,
        /// What was expected.
        expected: &'static str,
    },
    /// A part of it is no number, or one beyond a limit.
    Part {
        /// The part.
        part: String,
        /// What is wrong with it.
        error: ParseNumberError,
        /// What was expected.
        expected: &'static str,
    },
    /// It is no error bound.
    Bound(ParseBoundError),
    /// It is no condition.
    Condition(ParseConditionError),
    /// It is something else than this.
    Expected(&'static str),
    /// It asks for more than a limit allows.
    TooMany {
        /// How many are allowed.
        most: usize,
        /// The limit.
        limit: Limit,
    },
    /// Something else.
    Other(String),
}

impl Refusal {
    /// Whether the request is at fault, and not what was found in the data.
    pub fn is_misuse(&self) -> bool {
        match self {
            Refusal::NoProof(NoProof::TooMany { .. }) => false,
            Refusal::Request(_)
            | Refusal::Value { .. }
            | Refusal::Misuse(_)
            | Refusal::Reduction { .. }
            | Refusal::Form { .. }
            | Refusal::FurtherError(_)
            | Refusal::NextError(_)
            | Refusal::NoProof(_) => true,
            _ => false,
        }
    }

    /// What can be set so that it is not refused.
    pub fn ways(&self) -> Vec<Way> {
        match self {
            Refusal::Input(error) => error.kind.ways(),
            Refusal::Work(_) => vec![Way::raises(Limit::Work)],
            Refusal::Value {
                problem: ValueProblem::Number { error, .. } | ValueProblem::Part { error, .. },
                ..
            } => Limit::of_number(&error.kind).map(Way::raises).into_iter().collect(),
            Refusal::Value { problem: ValueProblem::TooMany { limit, .. }, .. } => vec![Way::raises(*limit)],
            Refusal::Outliers {
                why: NoOutliers::Steps { .. } | NoOutliers::GrowthSteps { .. },
                steps: Some(_),
            } => {
                vec![Way::raises(Limit::Steps)]
            }
            _ => Vec::new(),
        }
    }

    /// A sentence with the names of a surface, and its ways out.
    pub fn words(&self, surface: &dyn Surface) -> String {
        let sentence = self.sentence(surface);
        let ways: Vec<String> = self.ways().iter().map(|way| surface.way(way)).collect();
        if ways.is_empty() { sentence } else { format!("{sentence}; {}", ways.join(", ")) }
    }

    fn sentence(&self, surface: &dyn Surface) -> String {
        match self {
            Refusal::Request(problem)
            | Refusal::XErrors(problem)
            | Refusal::Wkt(problem)
            | Refusal::Readings(problem) => problem.clone(),
            Refusal::Value { key, text, problem } => {
                format!("{}: {}", surface.value(key, text), problem.words())
            }
            Refusal::Misuse(misuse) => misuse.words(surface),
            Refusal::Input(error) => error.to_string(),
            Refusal::Work(error) => error.to_string(),
            Refusal::Reduction { ask } => format!(
                "'{ask}' is about every reading, and the data are a reduction: ask about the table that it was made from"
            ),
            Refusal::FurtherError(reason) => format!(
                "{} needs the error bound of the reading, and {reason}: say it with {}",
                surface.key("from"),
                surface.key("new_eps")
            ),
            Refusal::NextError(reason) => format!(
                "the error bound of the next reading is needed, and {reason}: say it with {}",
                surface.key("new_eps")
            ),
            Refusal::Outliers { why, steps } => of_outliers(why, *steps, surface),
            Refusal::Form { ask, form, forms } => {
                let forms: Vec<&str> = forms.iter().map(|form| form.name()).collect();
                format!("'{ask}' is not written as {} (expected {})", form.name(), forms.join(", "))
            }
            Refusal::NoProof(why) => why.words(surface),
            Refusal::Output(error) => format!("cannot write: {error}"),
        }
    }
}

impl ValueProblem {
    fn words(&self) -> String {
        match self {
            ValueProblem::Number { error, expected } => number_problem(error, expected),
            ValueProblem::Part { part, error, expected } => {
                format!("{part:?}: {}", number_problem(error, expected))
            }
            ValueProblem::Bound(error) => error.to_string(),
            ValueProblem::Condition(error) => error.to_string(),
            ValueProblem::Expected(expected) => (*expected).to_owned(),
            ValueProblem::TooMany { most, .. } => format!("refused: more than {most} values"),
            ValueProblem::Other(problem) => problem.clone(),
        }
    }
}

/// What is wrong with a number: that it is none, with what was expected, or that it passes a limit.
fn number_problem(error: &ParseNumberError, expected: &str) -> String {
    match &error.kind {
        kind if kind.is_limit() => format!("refused: {error}"),
        ParseNumberErrorKind::Comma => {
            format!(
                "not a number: {error} (a point comes before decimals, whatever the data have: 1.5, not 1,5)"
            )
        }
        _ => format!("not a number: {error} ({expected})"),
    }
}

fn of_outliers(why: &NoOutliers, steps: Option<u64>, surface: &dyn Surface) -> String {
    let crossings = |needed: &u64| match steps {
        Some(steps) => format!("takes {needed} crossings of bounds, more than {steps}"),
        None => format!("takes {needed} crossings of bounds, too many for a figure"),
    };
    match why {
        NoOutliers::NotInMemory => Refusal::Reduction { ask: "outliers" }.sentence(surface),
        NoOutliers::Conditions(_) => "the conditions contradict each other".to_owned(),
        NoOutliers::Steps { at_least, enough, needed } => {
            let least = counted(*at_least, "reading has", "readings have");
            let enough = enough.map(|enough| format!(", and {enough} are enough")).unwrap_or_default();
            format!("at least {least} to be left out{enough}; to find the least number {}", crossings(needed))
        }
        NoOutliers::GrowthSteps { needed } => format!(
            "to see how the set grows {}, and a smaller {} takes fewer",
            crossings(needed),
            surface.key("most")
        ),
        NoOutliers::Corners => {
            format!("the set has more than 150000 corners (expected a smaller {})", surface.key("most"))
        }
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Self {
        Refusal::Input(error)
    }
}

impl From<TooMuchWork> for Refusal {
    fn from(error: TooMuchWork) -> Self {
        Refusal::Work(error)
    }
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Refusal::Output(error)
    }
}
