//! The request, and the way to its answer.

use boundfit_exact::Reading;
use boundfit_formats::Source;
use boundfit_report::{Origin, Style};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::asked::Asked;
use crate::check::Check;
use crate::fit::Fit;
use crate::fleet::Fleet;
use crate::form::Form;
use crate::judge::Judge;
use crate::linearity::Linearity;
use crate::misuse::Misuse;
use crate::next::Next;
use crate::outliers::Outliers;
use crate::paper::Answer;
use crate::polygon::Polygon;
use crate::predict::Predict;
use crate::question::Ask;
use crate::range::Range;
use crate::readings::{Common, Readings, take_key};
use crate::refusal::{Refusal, ValueProblem};
use crate::status::Status;
use crate::window::Window;
use crate::wrong_type::wrong_type;
use crate::x_errors::FitXErrors;

/// Goes from a table to the text of an answer of one kind of question, as [`Request::answer`] does of every kind.
///
/// # Errors
/// Why there is none.
pub fn ask<Q: Ask>(
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
    if asked.x_errors.is_some() && !Q::LOOKS_AT_X_ERRORS {
        return Err(Refusal::Misuse(Misuse::ExactX));
    }
    let name = source.name().to_owned();
    let own = || Origin {
        file: Some(boundfit_exact::Foreign::of(name.raw())),
        reading: asked.options.table.reading,
        is_stored: source.is_stored(),
    };
    let origin = origin.unwrap_or_else(own);
    let problem = question.read(asked, source, form.shows())?;
    question.text(&problem, &question.answer(&problem)?, form, origin, *style)
}

macro_rules! questions {
    ($($question:ident),* $(,)?) => {
        /// Every question, as JSON says it: `{"ask": "range", "by": "row"}`.
        #[derive(Debug, Clone)]
        pub enum Request {
            $(#[doc = concat!("See [`", stringify!($question), "`].")] $question($question)),*
        }

        #[cfg(feature = "schema")]
        impl schemars::JsonSchema for Request {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                "Request".into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let questions = [$(crate::schema::question::<$question>(generator)),*];
                crate::schema::any_of(&questions, generator)
            }
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

            /// Returns what is asked of readings whose numbers are read like that.
            ///
            /// # Errors
            /// When a value makes no sense, or values exclude or need each other.
            pub fn resolve(&self, readings: &Readings, reading: Reading) -> Result<Asked, Refusal> {
                let subject = match self { $(Request::$question(_) => $question::SUBJECT),* };
                readings.resolve_for(subject, reading)
            }

            /// Refuses keys and a style that an answer in this form has no place for.
            ///
            /// # Errors
            /// With the first of them.
            pub fn refuse_vain(&self, form: Form, style: &Style) -> Result<(), Refusal> {
                match self { $(Request::$question(own) => {
                    own.refuse_vain(form)?;
                    own.refuse_vain_style(form, style).map_err(Refusal::Misuse)
                })* }
            }

            /// The question of this name, with these keys.
            fn of_name(name: &str, keys: Map<String, Value>) -> Result<Self, Refusal> {
                match name {
                    $($question::NAME => question_of(keys).map(Request::$question),)*
                    _ => {
                        let names = Request::NAMES.iter().map(|name| (*name).to_owned()).collect();
                        Err(Refusal::Value { key: "ask", text: name.to_owned(), problem: ValueProblem::OneOf(names) })
                    }
                }
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

questions!(
    Check, Fit, FitXErrors, Fleet, Judge, Linearity, Next, Outliers, Polygon, Predict, Range, Status, Window,
);

impl Request {
    /// Reads a request as JSON says it.
    ///
    /// # Errors
    /// With the key that is missing, not known, or of another type.
    pub fn parse(json: &str) -> Result<Self, Refusal> {
        Request::of_keys(object(json)?)
    }

    /// Reads a request together with the readings that it is about, and how it is answered:
    /// `{"ask": "range", "by": "row", "x": "V", "y": "z", "eps": "1/2", "format": "csv"}`. The schema `boundfit/request/1` describes it.
    ///
    /// # Errors
    /// The errors of [`Request::parse`].
    pub fn with_readings(json: &str) -> Result<(Self, Common), Refusal> {
        let mut keys = object(json)?;
        let common = Common::take(&mut keys)?;
        Ok((Request::of_keys(keys)?, common))
    }

    /// Returns the JSON Schema of what [`Request::with_readings`] reads: every question, each with the keys of all. The schema is closed,
    /// and no key is null in it: a key that says nothing is left out.
    #[cfg(feature = "schema")]
    pub fn schema() -> boundfit_report::answer::DocumentSchema {
        crate::schema::of_requests::<Request>()
    }

    /// The question that an object asks, in which no other keys are.
    ///
    /// # Errors
    /// The errors of [`Request::parse`].
    pub fn of_keys(mut keys: Map<String, Value>) -> Result<Self, Refusal> {
        match take_key::<Option<String>>(&mut keys, "ask")? {
            Some(name) => Request::of_name(&name, keys),
            None => Err(Refusal::Key { key: "ask".to_owned(), problem: "it names the question".to_owned() }),
        }
    }
}

fn object(json: &str) -> Result<Map<String, Value>, Refusal> {
    serde_json::from_str(json).map_err(no_request)
}

/// Reads one kind of question from its keys, as [`Request::of_keys`] does of every kind.
///
/// # Errors
/// With the key that is missing, not known, or of another type: the one that alone is refused in the same words.
pub fn question_of<Q: Ask + DeserializeOwned>(keys: Map<String, Value>) -> Result<Q, Refusal> {
    const MISSING: &str = "missing field `";
    let keys = Value::Object(keys);
    let error = match Q::deserialize(&keys) {
        Ok(question) => return Ok(question),
        Err(error) => error,
    };
    let words = error.to_string();
    let is_refused = |(key, value): &(&String, &Value)| {
        let alone = Value::Object(Map::from_iter([((*key).clone(), (*value).clone())]));
        Q::deserialize(&alone).is_err_and(|own| own.to_string() == words)
    };
    let is_unknown = words.starts_with("unknown field");
    match keys.as_object().and_then(|keys| keys.iter().find(is_refused)).filter(|_| !is_unknown) {
        Some((key, _)) => Err(Refusal::Key { key: key.clone(), problem: wrong_type(&error) }),
        None if words.starts_with(MISSING) => {
            let key = words.split('`').nth(1).unwrap_or_default().to_owned();
            Err(Refusal::Key { key, problem: format!("it is missing: '{}' needs it", Q::NAME) })
        }
        None => Err(no_request(error)),
    }
}

fn no_request(error: serde_json::Error) -> Refusal {
    Refusal::Request(format!("request: {error}"))
}
