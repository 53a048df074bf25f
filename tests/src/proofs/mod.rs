//! Proofs of fits, made and judged without the program: what the tests of both checkers share.

mod judge;
mod mutations;
mod python;
mod questions;
mod statements;
mod tampering;

use std::io::Cursor;

use boundfit_estimation::{Columns, Condition, EpsilonColumn, LineForm, Measurements, Problem, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, InputError, RowRange, Source, TableOptions};
use boundfit_report::proof_json;
use boundfit_verify::{DataLimits, Failure, Proof};
use sha2::{Digest, Sha256};

pub use judge::is_true;
pub use mutations::mutated;
pub use python::statuses_in_python;
pub use questions::{bounded, generated, questions};
pub use tampering::tampered;

use crate::readings::parse_condition;

/// Data and how they are to be fitted.
#[derive(Debug, Clone)]
pub struct Question {
    /// The name of the proof's subject.
    pub name: String,
    /// The bytes of the file.
    pub data: Vec<u8>,
    /// Names or numbers of the regressors' columns.
    pub x: Vec<String>,
    /// The name of the response.
    pub y: String,
    /// The error bound, or else its column.
    pub epsilon: Result<Rational, String>,
    /// Bounds in place of that.
    pub bounds: Option<EpsilonColumn>,
    /// The form of the lines.
    pub form: LineForm,
    /// Conditions as text.
    pub conditions: Vec<String>,
    /// The options for reading the table.
    pub options: TableOptions,
}

impl Question {
    /// A line through two columns under an error bound.
    ///
    /// # Panics
    /// When the bound is no number.
    pub fn line(name: &str, data: &[u8], [x, y]: [&str; 2], epsilon: &str) -> Self {
        Question {
            name: name.to_owned(),
            data: data.to_vec(),
            x: vec![x.to_owned()],
            y: y.to_owned(),
            epsilon: Ok(Reading::Decimal.read(epsilon, &Limits::default()).expect("a number")),
            bounds: None,
            form: LineForm::default(),
            conditions: Vec::new(),
            options: TableOptions::default(),
        }
    }

    /// The same with two regressors.
    pub fn regressors(self, x: [&str; 2]) -> Self {
        Question { x: x.map(ToOwned::to_owned).to_vec(), ..self }
    }

    /// The same with an error bound per row.
    pub fn epsilon_column(self, column: &str) -> Self {
        Question { epsilon: Err(column.to_owned()), ..self }
    }

    /// The same between bounds, or under a law.
    pub fn within(self, bounds: EpsilonColumn) -> Self {
        Question { bounds: Some(bounds), ..self }
    }

    /// The same under conditions.
    pub fn when(self, conditions: &[&str]) -> Self {
        Question { conditions: conditions.iter().map(|&text| text.to_owned()).collect(), ..self }
    }

    /// The same of some rows.
    pub fn rows(self, first: usize, last: usize) -> Self {
        let options = TableOptions { rows: RowRange::new(first, last).into(), ..self.options };
        Question { options, ..self }
    }

    /// The same with numbers read in another way.
    pub fn reading(self, reading: Reading) -> Self {
        Question { options: TableOptions { reading, ..self.options }, ..self }
    }

    /// Returns what is to be fitted.
    ///
    /// # Errors
    /// When the data cannot be read so.
    pub fn problem(&self) -> Result<Problem, InputError> {
        let column = |name: &String| ColumnSelector::name_or_number(name);
        let columns = Columns {
            first: column(&self.x[0]),
            second: self.x.get(1).map(column),
            response: Some(column(&self.y)),
            epsilon: match (&self.bounds, &self.epsilon) {
                (Some(bounds), _) => bounds.clone(),
                (None, Ok(epsilon)) => EpsilonColumn::Uniform(epsilon.clone()),
                (None, Err(name)) => EpsilonColumn::Column(column(name)),
            },
            form: self.form.clone(),
        };
        let source = Source::new("data", Cursor::new(self.data.clone()));
        let measurements = Measurements::read(source, &columns, &self.options)?;
        let conditions: Vec<Condition> = self.conditions.iter().map(|text| parse_condition(text)).collect();
        let problem = Problem { measurements, conditions };
        Ok(if self.form.through_origin { problem.through_origin() } else { problem })
    }

    /// The proof of the fit.
    ///
    /// # Panics
    /// When the data cannot be read.
    pub fn proof(&self) -> String {
        let problem = self.problem().unwrap_or_else(|error| panic!("{}: {error}", self.name));
        self.proof_of(&problem).expect("delimited text")
    }

    /// The proof of the fit of these readings; none where the table is not plain.
    pub fn proof_of(&self, problem: &Problem) -> Option<String> {
        proof_json(problem, &fit(problem), self.options.reading)
    }
}

/// SHA-256 in hexadecimal.
pub fn sha256(data: &[u8]) -> String {
    Sha256::digest(data).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The exit status that the checker in Rust stands for: 0 true, 4 false, 1 no proof, or data beyond a limit.
pub fn verdict(proof: &[u8], data: &[u8]) -> i32 {
    let Ok(proof) = Proof::read(proof, &Limits::default()) else { return 1 };
    match proof.verify(|| Ok(data), &DataLimits::default()) {
        Ok(_) => 0,
        Err(Failure::False(_)) => 4,
        Err(_) => 1,
    }
}
