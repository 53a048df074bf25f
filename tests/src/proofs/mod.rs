//! Proofs of fits, made and judged without the program: what the tests of both checkers share.

mod judge;
mod questions;
mod tampering;

use std::io::Cursor;

use boundfit_estimation::{Columns, Condition, EpsilonColumn, LineForm, Measurements, Problem, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, InputError, RowRange, Source, TableOptions};
use boundfit_report::proof_json;
use serde_json::Value;
use sha2::{Digest, Sha256};

pub use judge::is_true;
pub use questions::{generated, questions};
pub use tampering::tampered;

use crate::readings::parse_condition;

/// Data and how they are to be fitted.
#[derive(Debug, Clone)]
pub struct Question {
    /// What it is about.
    pub name: String,
    /// The bytes of the file.
    pub data: Vec<u8>,
    /// Names or numbers of the regressors' columns.
    pub x: Vec<String>,
    /// That of the response.
    pub y: String,
    /// The error bound, or else its column.
    pub epsilon: Result<Rational, String>,
    /// Conditions as text.
    pub conditions: Vec<String>,
    /// How the table is read.
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

    /// What is to be fitted.
    ///
    /// # Errors
    /// When the data cannot be read so.
    pub fn problem(&self) -> Result<Problem, InputError> {
        let column = |name: &String| ColumnSelector::name_or_number(name);
        let columns = Columns {
            first: column(&self.x[0]),
            second: self.x.get(1).map(column),
            response: Some(column(&self.y)),
            epsilon: match &self.epsilon {
                Ok(epsilon) => EpsilonColumn::Uniform(epsilon.clone()),
                Err(name) => EpsilonColumn::Column(column(name)),
            },
            form: LineForm::default(),
        };
        let source = Source::new("data", Cursor::new(self.data.clone()));
        let measurements = Measurements::read(source, &columns, &self.options)?;
        let conditions: Vec<Condition> = self.conditions.iter().map(|text| parse_condition(text)).collect();
        Ok(Problem { measurements, conditions })
    }

    /// The proof of the fit.
    ///
    /// # Panics
    /// When the data cannot be read.
    pub fn proof(&self) -> String {
        let problem = self.problem().unwrap_or_else(|error| panic!("{}: {error}", self.name));
        proof_json(&problem, &fit(&problem), self.options.reading).expect("delimited text")
    }
}

/// SHA-256 in hexadecimal.
pub fn sha256(data: &[u8]) -> String {
    Sha256::digest(data).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The exit status that the checker in Rust stands for: 0 true, 4 false, 1 no proof.
pub fn verdict(proof: &str, data: &[u8]) -> i32 {
    let value: Value = serde_json::from_str(proof).expect("JSON");
    match serde_json::from_str::<boundfit_verify::Proof>(proof) {
        Err(_) => 1,
        Ok(_) if value["schema"] != "boundfit/proof/1" => 1,
        Ok(proof) => proof.verify(data, &sha256(data), &Limits::default()).map_or(4, |_| 0),
    }
}
