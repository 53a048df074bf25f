//! boundfit's answers as text for people and JSON for programs.
//!
//! Every printed decimal is rounded from an exact value in a direction that [`Style`] fixes: interval ends outward, error
//! bounds upward, all other numbers to nearest. JSON carries the exact value beside every decimal.
//!
//! ```
//! use boundfit_estimation::{Columns, EpsilonColumn, Measurements, Problem, fit};
//! use boundfit_exact::{Rational, Reading};
//! use boundfit_formats::{ColumnSelector, Source, TableOptions};
//! use boundfit_report::proof_json;
//!
//! let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
//! let columns = Columns {
//!     first: ColumnSelector::name_or_number("x"),
//!     second: None,
//!     response: ColumnSelector::name_or_number("y"),
//!     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
//! };
//! let measurements = Measurements::read(table, &columns, &TableOptions::default())?;
//! let problem = Problem { measurements, conditions: Vec::new() };
//! let proof = proof_json(&problem, &fit(&problem), Reading::Decimal).expect("a table of text");
//! assert!(proof.contains(r#""schema": "boundfit/proof/1""#));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod advice;
mod cdd;
mod check_json;
mod check_text;
mod document;
mod fit_blocks;
mod fit_json;
mod fit_text;
mod fleet_csv;
mod fleet_json;
mod fleet_summary;
mod fleet_text;
mod generators;
mod latex;
mod markdown;
mod markup;
mod polygon_json;
mod polygon_rows;
mod polygon_tables;
mod polygon_text;
mod proof_json;
mod region;
mod script;
mod style;
mod sweep_json;
mod sweep_text;
mod text;
mod verify;
mod vertices_csv;
mod wkt;

pub use cdd::{h_representation, v_representation};
pub use check_json::{check_json, conformance_json};
pub use check_text::{check_text, conformance_table, verdict_line};
pub use fit_json::fit_json;
pub use fit_text::{Origin, fit_text};
pub use fleet_csv::FleetCsv;
pub use fleet_json::write_group_json;
pub use fleet_summary::{FleetSummary, GroupReport};
pub use fleet_text::{FleetTable, GroupCells};
pub use markup::Markup;
pub use polygon_json::polygon_json;
pub use polygon_text::polygon_text;
pub use proof_json::proof_json;
pub use script::region_script;
pub use style::{EndRounding, Style};
pub use sweep_json::sweep_value;
pub use sweep_text::sweep_text;
pub use verify::{verify_json, verify_text};
pub use vertices_csv::vertices_csv;
pub use wkt::region_wkt;
