//! One way from a request to an answer. The command line, Python and WebAssembly fill [`Readings`] with texts, as people say them; from there
//! on they share this crate.
//!
//! A question is one module. It implements [`Ask`]: what it reads of the data, what it costs, what it answers, and the forms of
//! that answer. One line in [`Request`] registers it, and every surface has it.
//!
//! | module | question |
//! |---|---|
//! | `check` | which ends of both intervals are right, of those that solvers find and others claim |
//! | `fit` | every parameter pair that agrees with all readings |
//! | `fleet` | the fit of each group of readings |
//! | `judge` | the exact answer to a linear program, and what is found about solutions of it |
//! | `linearity` | how far a sensor is from a straight line |
//! | `next` | where the next reading certainly helps |
//! | `outliers` | the fewest readings to leave out |
//! | `polygon` | the set of half-planes or generators, without readings |
//! | `predict` | where the line runs, and where further readings lie |
//! | `range` | every run of readings that some parameters agree with |
//! | `status` | what every reading and the set say of each other |
//! | `window` | the fits of the last readings as the window moves on |
//! | `x_errors` | the lines that agree with readings whose x have errors, too |
//!
//! [`Readings`] says of which readings, in the words of people; of half-planes it says how their file is written, and of a linear
//! program its limits alone. [`Request::resolve`] makes of it what the engine takes, [`Asked`], and refuses words that exclude each
//! other. [`Refusal`] says, as data, why there is no answer. A [`Surface`] knows how it names keys and limits, and [`Refusal::words`]
//! puts these names into the sentence.
//!
//! ```
//! use boundfit_ask::{Asked, Form, Refusal, Request};
//! use boundfit_estimation::Question;
//! use boundfit_exact::Reading;
//! use boundfit_formats::{ColumnSelector, Source};
//!
//! let [x, y] = ["x", "y"].map(ColumnSelector::name_or_number);
//! let asked = Asked::new(Question::line(x, Some(y)).within("1/2", Reading::Decimal)?);
//! let table = Source::new("readings.csv", "x,y\n0,0\n1,1\n2,2\n3,9\n".as_bytes());
//! let answer = Request::parse(r#"{"ask": "range"}"#)
//!     .and_then(|request| request.answer(&asked, table, Form::Csv, None, &Default::default()))
//!     .map_err(|refusal: Refusal| format!("{refusal:?}"))?;
//! assert!(answer.text.contains("\n1,3,3,"), "readings 1 to 3 lie on one line");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// Code that reads input never panics on it.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod asked;
mod check;
mod fit;
mod fleet;
mod form;
mod given;
mod judge;
mod linearity;
mod misuse;
mod next;
mod outliers;
mod paper;
mod polygon;
mod predict;
mod question;
mod range;
mod readings;
mod refusal;
mod request;
#[cfg(feature = "schema")]
mod schema;
mod status;
mod surface;
mod tables;
mod value_problem;
mod window;
mod wrong_type;
mod x_errors;

pub use asked::{Asked, AskedXBounds, XErrors};
pub use check::{Check, ClaimFile};
pub use fit::{Factors, Fit, Fittable, Fitted};
pub use fleet::{Fleet, Groups};
pub use form::{Form, Shows, Written};
pub use given::{Given, ends};
pub use judge::{Judge, Solvable, Solved};
pub use linearity::{Calibrated, Linearity, Through};
pub use misuse::{Misuse, NoProof};
pub use next::{Next, common_bound};
pub use outliers::Outliers;
pub use paper::{Answer, Out, Paper};
pub use polygon::Polygon;
pub use predict::{Predict, Predicted};
pub use question::{Ask, AskedTheorem, Subject};
pub use range::Range;
pub use readings::{
    AnswerWords, AskedLimits, Common, Digits, OfRows, Readings, Regressors, RowWords, Rows, TableWords,
    limits_of_files, named, range_of_limit, resolve_limits, take_key,
};
pub use refusal::{Refusal, ValueProblem};
pub use request::{Request, ask, question_of};
pub use status::{Judgeable, Judgement, Status};
pub use surface::Surface;
pub use tables::{Files, Held, Tables};
pub use window::Window;
pub use x_errors::FitXErrors;
