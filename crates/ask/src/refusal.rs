//! Reasons why there is no answer, as data. Sentences name keys and limits as the surface does where they are read.

use std::io;

use boundfit_exact::english::{counted, in_words};
use boundfit_exact::{Foreign, Limit, TooMuchWork};
use boundfit_formats::{InputError, Way};
use boundfit_questions::{NoFurtherError, NoOutliers};

use crate::form::Form;
use crate::misuse::{Misuse, NoProof};
use crate::surface::Surface;

pub use crate::value_problem::ValueProblem;

/// A reason why there is no answer.
#[derive(Debug)]
pub enum Refusal {
    /// The request is none: what JSON says of it.
    Request(String),
    /// A key is of another type, or not known.
    Key {
        /// The key.
        key: String,
        /// The problem: the value, and what was expected.
        problem: String,
    },
    /// The value of a key makes no sense.
    Value {
        /// The key.
        key: &'static str,
        /// The value.
        text: String,
        /// The problem with it.
        problem: ValueProblem,
    },
    /// Keys exclude or need each other.
    Misuse(Misuse),
    /// The table cannot be read.
    Input(InputError),
    /// The table has other columns than half-planes have.
    NoHalfPlanes(InputError),
    /// Numbers are too long.
    Work(TooMuchWork),
    /// The question is about every reading, and the data are a reduction.
    Reduction {
        /// The question.
        ask: &'static str,
    },
    /// The errors of x are none.
    XErrors(String),
    /// The readings, or the linear program, are none that the question can be asked about: why.
    Readings(String),
    /// Nothing is known of the error of a reading, of which it is asked where it comes from: why.
    FurtherError(NoFurtherError),
    /// Nothing bounds the error of the next reading, which the question is about: why.
    NextError(String),
    /// The text is no linear program: why, in words for the same reason as a claim.
    Model {
        /// The problem.
        problem: String,
        /// The limit that it passes, if that is the problem.
        limit: Option<Limit>,
        /// `true` if the text does not even begin as one: most such texts are tables.
        is_other: bool,
    },
    /// A text beside the data is no claim or solution: why. These are words, so that a build without claims need not have the sentences of
    /// their errors.
    Claim {
        /// The problem.
        problem: String,
        /// The limit that it passes, if that is the problem.
        limit: Option<Limit>,
    },
    /// A file beside the data is at fault.
    OfFile {
        /// The file.
        file: Foreign,
        /// The fault.
        why: Box<Refusal>,
    },
    /// A theorem is about linear programs in two columns.
    ColumnsOfTheorem {
        /// The file.
        file: Foreign,
        /// The number of columns in it.
        count: usize,
    },
    /// Outliers are not found.
    Outliers {
        /// The reason.
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
    /// The answer has no proof.
    NoProof(NoProof),
    /// The answer cannot be written.
    Output(io::Error),
}

impl Refusal {
    /// Returns whether the request is at fault, and not what was found in the data.
    pub fn is_misuse(&self) -> bool {
        match self {
            Refusal::NoProof(NoProof::TooMany { .. }) => false,
            Refusal::Request(_)
            | Refusal::Key { .. }
            | Refusal::Value { .. }
            | Refusal::Misuse(_)
            | Refusal::Reduction { .. }
            | Refusal::Form { .. }
            | Refusal::FurtherError(_)
            | Refusal::NextError(_)
            | Refusal::ColumnsOfTheorem { .. }
            | Refusal::NoProof(_) => true,
            _ => false,
        }
    }

    /// Returns whether the sentence names the file that is at fault.
    pub fn names_file(&self) -> bool {
        matches!(self, Refusal::Input(_) | Refusal::NoHalfPlanes(_) | Refusal::OfFile { .. })
    }

    /// Returns what can be set so that the request is not refused.
    pub fn ways(&self) -> Vec<Way> {
        match self {
            Refusal::Input(error) | Refusal::NoHalfPlanes(error) => error.ways(),
            Refusal::Work(_) => vec![Way::raises(Limit::Work)],
            Refusal::Claim { limit, .. } | Refusal::Model { limit, .. } => {
                limit.map(Way::raises).into_iter().collect()
            }
            Refusal::OfFile { why, .. } => why.ways(),
            Refusal::Value { problem, .. } => problem.limit().map(Way::raises).into_iter().collect(),
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
        let meaning = "a row a1,a2,b means a1*theta1 + a2*theta2 <= b";
        let meaning = matches!(self, Refusal::NoHalfPlanes(_)).then(|| meaning.to_owned());
        let ways = (!ways.is_empty()).then(|| ways.join(", "));
        [Some(sentence), ways, meaning].into_iter().flatten().collect::<Vec<_>>().join("; ")
    }

    /// The sentence alone.
    pub fn sentence(&self, surface: &dyn Surface) -> String {
        match self {
            Refusal::Request(problem)
            | Refusal::Claim { problem, .. }
            | Refusal::Model { problem, .. }
            | Refusal::XErrors(problem)
            | Refusal::Wkt(problem)
            | Refusal::Readings(problem) => problem.clone(),
            Refusal::Key { key, problem } => format!("{}: {problem}", surface.key(key)),
            Refusal::Value { key, text, problem } => {
                let column = match *key == "eps" && problem.may_name_a_column(text) {
                    true => format!("; {} names a column of bounds", surface.key("eps_column")),
                    false => String::new(),
                };
                format!("{}: {}{column}", surface.value(key, text), problem.words())
            }
            Refusal::Misuse(misuse) => misuse.words(surface),
            Refusal::Input(error) | Refusal::NoHalfPlanes(error) => error.to_string(),
            Refusal::OfFile { file, why } => format!("{file}: {}", why.sentence(surface)),
            Refusal::ColumnsOfTheorem { file, count } => format!(
                "{} is about linear programs in two columns, and {file} has {}: there is no theorem about its answer",
                surface.key("proof"),
                in_words(*count)
            ),
            Refusal::Work(error) => error.to_string(),
            Refusal::Reduction { ask } => {
                let subject = match *ask {
                    "fit-x-errors" => "a fit with errors in x".to_owned(),
                    "window" => "a fit of windows".to_owned(),
                    ask => format!("'{ask}'"),
                };
                format!(
                    "{subject} is about every reading, and the data are a reduction: ask about the table that it was made from"
                )
            }
            Refusal::FurtherError(reason) => format!(
                "{} needs the error bound of the reading, but {reason}; state it with {}",
                surface.key("from"),
                surface.key("new_eps")
            ),
            Refusal::NextError(reason) => {
                format!("{reason}; state the error bound of the next reading with {}", surface.key("new_eps"))
            }
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
            format!("the set has more than 100000 corners (expected a smaller {})", surface.key("most"))
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
