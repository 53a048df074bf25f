//! boundfit's answers for people and for programs: documents in plain text, LaTeX and Markdown, and JSON.
//!
//! Every printed decimal is rounded from an exact value in a direction that [`Style`] fixes: interval ends outward, error
//! bounds upward, all other numbers to nearest. JSON carries the exact value beside every decimal.
//!
//! | to | modules |
//! |---|---|
//! | answer as data (JSON) | `answer`, `json`, `json_line`, `number` |
//! | build a document: text, LaTeX, Markdown | `document`, `align`, `style`, `scale`, `formula` |
//! | report each question | `fit`, `predict`, `next_reading`, `status`, `outliers`, `range`, `linearity`, `window`, `x_errors`, `sweep`, `polygon`, `judge`, `check`, `verify` |
//! | write proofs and theorems | `proof_json`, `statements`, `kernel` |
//! | report many sensors | `fleet_text`, `fleet_csv`, `fleet_json`, `fleet_summary` |
//! | write sets for other programs | `cdd`, `wkt`, `script`, `fit_script`, `vertices_csv`, `generators` |
//!
//! ```
//! use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem, fit};
//! use boundfit_exact::{Rational, Reading};
//! use boundfit_formats::{ColumnSelector, Source, TableOptions};
//! use boundfit_report::proof_json;
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
//! let proof = proof_json(&problem, &fit(&problem), Reading::Decimal).expect("a table of text");
//! assert!(proof.contains(r#""schema": "boundfit/proof/1""#));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod advice;
mod align;
pub mod answer;
mod cdd;
mod check;
mod check_json;
mod csv_text;
mod document;
mod feasible;
mod findings;
mod fit;
mod fit_csv;
mod fit_json;
mod fit_script;
mod fleet_csv;
mod fleet_json;
mod fleet_summary;
mod fleet_text;
mod formula;
mod generators;
mod guarantee;
mod input_json;
mod json;
mod json_line;
mod judge;
#[cfg(feature = "files")]
mod kernel;
mod linearity;
mod next_reading;
mod number;
mod origin;
mod outliers;
#[cfg(feature = "files")]
mod polygon;
mod predict;
#[cfg(feature = "files")]
mod proof_json;
#[cfg(feature = "files")]
mod proof_question;
mod range;
mod region;
mod scale;
mod script;
mod slope_lines;
#[cfg(feature = "files")]
mod statements;
mod status;
mod style;
mod sweep;
mod sweep_json;
mod table_json;
mod verify;
mod verify_claims;
mod verify_json;
mod vertices_csv;
mod window;
mod wkt;
mod x_errors;

pub use answer::{ActiveJson, FitJson, JudgeJson, RangeJson, SolutionJson, SweepJson, TableJson};
pub use cdd::{h_representation, v_representation};
pub use check::{check_document, verdict_line};
pub use check_json::check_json;
pub use document::{Document, in_page_width};
pub use findings::{solutions_document, solutions_json, solutions_junit, solutions_sarif};
pub use fit::{
    InverseLine, NextStep, bound_found, brief_document, fit_document, full_fit_document, next_document,
    next_steps,
};
pub use fit_csv::fit_csv;
pub use fit_json::fit_json;
pub use fit_script::fit_script;
pub use fleet_csv::FleetCsv;
pub use fleet_json::write_group_json;
pub use fleet_summary::FleetSummary;
pub use fleet_text::{FleetTable, GroupCells};
pub use generators::ActiveNames;
pub use guarantee::guarantee_document;
pub use json_line::LineInput;
pub use judge::{judge_document, judge_json};
#[cfg(feature = "files")]
pub use kernel::{
    MOST_THEOREM_BYTES, THEORY, Theory, kernel_fit, kernel_half_planes, kernel_outliers, kernel_prediction,
    kernel_program, kernel_range, kernel_status,
};
pub use linearity::{linearity_csv, linearity_document, linearity_json};
#[cfg(feature = "files")]
pub use linearity::{linearity_proof, linearity_question};
pub use next_reading::{NextReadingReport, next_reading_csv, next_reading_document, next_reading_json};
pub use number::{Number, Reader};
pub use origin::Origin;
#[cfg(feature = "files")]
pub use outliers::{NoOutliersProof, outliers_proof};
pub use outliers::{OutliersReport, outliers_csv, outliers_document, outliers_json};
#[cfg(feature = "files")]
pub use polygon::{polygon_document, polygon_json};
#[cfg(feature = "files")]
pub use predict::prediction_proof;
pub use predict::{
    AskedValues, Prediction, prediction_document, write_prediction_csv, write_prediction_json,
};
#[cfg(feature = "files")]
pub use proof_json::proof_json;
#[cfg(feature = "files")]
pub use proof_question::ProofQuestion;
#[cfg(feature = "files")]
pub use range::range_proof;
pub use range::{RangeReport, range_csv, range_document, range_json};
pub use script::region_script;
#[cfg(feature = "files")]
pub use statements::{Scope, Statement, multiples, statements_json};
#[cfg(feature = "files")]
pub use status::status_proof;
pub use status::{NewReadings, StatusCsv, StatusJson, StatusReport, status_document};
pub use style::{EndRounding, LONGEST_FRACTION, Style};
pub use sweep::sweep_document;
#[cfg(feature = "files")]
pub use table_json::table_line;
pub use table_json::{row_ranges, rows_left_out};
pub use verify::{Verdict, condition as condition_text, verify_text};
pub use verify_claims::rows as rows_text;
pub use verify_json::verify_json;
pub use vertices_csv::{active_names, vertices_csv};
pub use window::{WindowReport, WindowSummary, write_window_json};
pub use wkt::region_wkt;
#[cfg(feature = "files")]
pub use x_errors::x_error_proof;
pub use x_errors::{x_error_csv, x_error_document, x_error_json, x_error_wkt};
