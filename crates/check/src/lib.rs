//! The place where the two witnesses meet: a fit's half-planes as linear programs, solved the way a lab would, and every
//! answer judged exactly.
//!
//! [`check`] runs solvers and judges them together with [`Answer`]s brought from elsewhere ([`read_claims`],
//! [`parse_claim_pui`]), against the data as written and against the binary64 numbers that a float solver receives.
//! [`directions`] compares the hull of the optimisers of many programs with the set itself. [`exchange_rows`] are those of the four
//! programs ([`PuiEnd`](boundfit_lp::PuiEnd)) in files for solvers elsewhere.
//!
//! | to | modules |
//! |---|---|
//! | write the programs of a fit | `rows`, `exchange` |
//! | solve them | `sources`, `float`, `no_float` |
//! | read answers from elsewhere | `answer`, `claims` |
//! | judge | `judge`, `directions` |
//!
//! ```
//! use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem};
//! use boundfit_exact::{Rational, Reading};
//! use boundfit_formats::{ColumnSelector, Source, TableOptions};
//! use boundfit_check::{CheckOptions, check, parse_claim_pui};
//! use boundfit_lp::Verdict;
//!
//! let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
//! let columns = Columns {
//!     first: ColumnSelector::name_or_number("x"),
//!     second: None,
//!     response: Some(ColumnSelector::name_or_number("y")),
//!     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
//!     form: LineForm::default(),
//! };
//! let measurements = Measurements::read(table, &columns, &TableOptions::default())?;
//! let problem = Problem { measurements, conditions: Vec::new() };
//! // 1/2 <= theta1 <= 3/2 and -1/2 <= theta2 <= 1/2. The claim cuts off a part of the first interval.
//! let options = CheckOptions {
//!     solvers: vec!["exact-simplex".to_owned()],
//!     answers: vec![parse_claim_pui("0.6,1.5,-0.5,0.5")?],
//!     tolerance: Rational::ratio(1, 1_000_000),
//!     as_printed: true,
//!     time_limit: std::time::Duration::from_secs(60),
//!     directions: None,
//!     all_rows: false,
//! };
//! let judged = check(&problem, Reading::Decimal, &options)?.answers;
//! let worst: Vec<_> = judged.iter().filter(|own| own.reading == Reading::Decimal).map(|own| own.worst()).collect();
//! assert_eq!(worst, [Verdict::Unsafe, Verdict::Exact]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod answer;
mod claims;
mod directions;
mod exchange;
#[cfg_attr(not(feature = "float-solvers"), path = "no_float.rs")]
mod float;
mod judge;
mod rows;
mod sources;

pub use answer::Answer;
pub use claims::{
    ClaimError, ClaimFileError, ClaimLimits, ClaimText, Claims, is_solution_name, nested_beyond,
    parse_claim_pui, read_claims,
};
pub use directions::{Approximation, AskedDirections, Directions, Objectives, directions, directions_along};
pub use exchange::exchange_rows;
pub use judge::{AskedReadings, Check, CheckOptions, JudgedAnswer, MOST_READINGS, check};
pub use rows::ProgramRows;
pub use sources::{EXACT_SIMPLEX, SourceError, answer_of, source_names};
