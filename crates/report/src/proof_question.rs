//! The question that a proof answers, as it stands at the head of every proof (docs/proof.md).

use boundfit_estimation::{Condition, ErrorBound, Model, Problem};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_formats::HalfPlaneFile;
use serde::Serialize;
use serde_json::json;

/// The question of a proof: which rows of which bytes are read, how, and what they say about the parameters. Numbers are exact
/// fractions as text.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProofQuestion {
    /// SHA-256 of the bytes of the data.
    sha256: String,
    /// The character between cells.
    delimiter: char,
    /// True if the first row names the columns.
    header: bool,
    /// First and last row of each range, one after the other.
    rows: Vec<usize>,
    /// The reading of numbers: exactly as written, or as the nearest doubles.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    reading: &'static str,
    /// φ1, φ2, y and ε: the number of a column, and by how much it is multiplied. Column 0 holds 1 in every row.
    model: [(usize, String); 4],
    /// The columns of lower and of upper bounds that take the place of y and ε; absent if there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    interval: Option<[Option<usize>; 2]>,
    /// The bounds above and below y beside ε: a quantity, `abs` or `written`, the number of a column, and by how much it is
    /// multiplied. Absent without a law.
    #[serde(skip_serializing_if = "Option::is_none")]
    law: Option<[Vec<LawTermJson>; 2]>,
    /// The number that is taken from the column of φ1 before it is multiplied; absent if it is 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    x_origin: Option<String>,
    /// The column of bounds on the errors of x, and by how much it is multiplied; absent where x is exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    x_error: Option<(usize, String)>,
    /// The columns whose sum takes the place of y, and by how much each is multiplied; absent if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    response: Vec<(usize, String)>,
    /// The conditions a1·θ1 + a2·θ2 ≤ b as a1, a2 and b; a fourth text `=` makes an equation.
    conditions: Vec<Vec<String>>,
}

/// A quantity of a law, the column that it is taken from, and how many times.
type LawTermJson = (&'static str, usize, String);

impl ProofQuestion {
    /// The question that a problem asks. `None` when the readings do not come from delimited text that has a row for each
    /// of them, or which rows were fitted was not kept, or the text is not written as the checkers read it.
    pub fn new(problem: &Problem, reading: Reading) -> Option<Self> {
        let measurements = &problem.measurements;
        let x_origin = &measurements.line_form().x_origin;
        let layout = measurements.layout().filter(|layout| layout.dialect.is_plain())?;
        if measurements.fitted_rows().is_empty() {
            return None;
        }
        let column = |&column: &usize| (column, "1".to_owned());
        let is_line = matches!(measurements.model(), Model::Line { .. });
        let (regressors, others) = layout.columns.split_at_checked(if is_line { 1 } else { 2 })?;
        // Column 0 holds 1 in every row.
        let [x1, x2] = [regressors.first()?, regressors.get(1).unwrap_or(&0)].map(column);
        let (y, others) = match others.split_first() {
            Some((y, others)) if measurements.has_response() => (column(y), others),
            _ => ((0, "0".to_owned()), others),
        };
        let mut epsilon = (0, "0".to_owned());
        let (mut interval, mut law) = (None, None);
        match measurements.error_bound() {
            ErrorBound::Uniform(bound) => epsilon.1 = bound.to_string(),
            ErrorBound::Column(_) => epsilon = column(others.first()?),
            ErrorBound::Interval { lower, upper } => {
                // Behind each bound stands, from the same column, whether it is there.
                let mut columns = others.iter().step_by(2).copied();
                let mut next = |side: &Option<Foreign>| side.as_ref().and_then(|_| columns.next());
                interval = Some([next(lower), next(upper)]);
            }
            ErrorBound::Law(bound) => {
                let range = measurements.range_of_response();
                let term = |(name, times): (&'static str, Rational)| {
                    let from = if name == "x" { x1.0 } else { y.0 };
                    (if name == "written" { name } else { "abs" }, from, times.to_string())
                };
                let side = |(constant, terms): (Rational, Vec<(&'static str, Rational)>)| {
                    let fixed = (!constant.is_zero()).then(|| ("abs", 0, constant.to_string()));
                    fixed.into_iter().chain(terms.into_iter().map(term)).collect()
                };
                law = Some(bound.terms(&range).map(side));
            }
        }
        Some(ProofQuestion {
            sha256: measurements.sha256()?.to_owned(),
            delimiter: char::from(layout.dialect.delimiter),
            header: layout.dialect.records_before > 0,
            rows: measurements.fitted_rows().concat(),
            reading: reading.name(),
            model: [x1, x2, y, epsilon],
            interval,
            law,
            x_origin: (!x_origin.is_zero()).then(|| x_origin.to_string()),
            x_error: None,
            response: Vec::new(),
            conditions: problem.conditions.iter().map(condition_json).collect(),
        })
    }

    /// The question that a table of half-planes asks: at most b for the sum of a1 and a2, each times its parameter. `None` when the
    /// file is no delimited text, or is not written as the checkers read it.
    pub fn of_half_planes(file: &HalfPlaneFile, reading: Reading) -> Option<Self> {
        let layout = file.layout.as_ref().filter(|layout| layout.dialect.is_plain())?;
        let &[first, second, bound] = layout.columns.as_slice() else { return None };
        let mut rows: Vec<usize> = Vec::new();
        for origin in &file.origins {
            match rows.last_mut() {
                Some(last) if *last + 1 == origin.row => *last = origin.row,
                _ => rows.extend([origin.row; 2]),
            }
        }
        if rows.is_empty() {
            return None;
        }
        let nothing = || (0, "0".to_owned());
        Some(ProofQuestion {
            sha256: file.sha256.clone(),
            delimiter: char::from(layout.dialect.delimiter),
            header: layout.dialect.records_before > 0,
            rows,
            reading: reading.name(),
            model: [(first, "1".to_owned()), (second, "1".to_owned()), nothing(), nothing()],
            interval: Some([None, Some(bound)]),
            law: None,
            x_origin: None,
            x_error: None,
            response: Vec::new(),
            conditions: Vec::new(),
        })
    }

    pub(crate) fn delimiter(&self) -> char {
        self.delimiter
    }

    pub(crate) fn has_header(&self) -> bool {
        self.header
    }

    /// First and last row of each range.
    pub(crate) fn ranges(&self) -> Vec<[usize; 2]> {
        self.rows.chunks_exact(2).filter_map(|own| own.try_into().ok()).collect()
    }

    /// The columns, from 1, of the numbers of a row: φ1, φ2 unless it is 1, y, and ε unless it is the same in all rows. In place
    /// of y and ε the lower and the upper bound, 0 for none. `None` when a number is not the one in a cell.
    pub(crate) fn columns(&self) -> Option<Vec<usize>> {
        let is_cell = |own: &(usize, String)| own.1 == "1" && own.0 > 0;
        let [x1, x2, y, epsilon] = &self.model;
        let is_computed = self.law.is_some()
            || self.x_origin.is_some()
            || self.x_error.is_some()
            || !self.response.is_empty()
            || self.reading != Reading::Decimal.name();
        if is_computed || !is_cell(x1) || x2.1 != "1" {
            return None;
        }
        let mut columns = vec![x1.0];
        columns.extend(Some(x2.0).filter(|&column| column > 0));
        match self.interval {
            Some(bounds) => columns.extend(bounds.map(Option::unwrap_or_default)),
            None if is_cell(y) && (epsilon.0 == 0 || is_cell(epsilon)) => {
                columns.push(y.0);
                columns.extend(Some(epsilon.0).filter(|&column| column > 0));
            }
            None => return None,
        }
        Some(columns)
    }

    /// The question on one line, as JSON of a schema that has nothing else.
    pub(crate) fn to_line(&self, schema: &str) -> String {
        let mut fields = json!(self);
        fields["schema"] = json!(schema);
        fields.to_string()
    }

    /// With errors in x: the column of their bounds, from 1, and how many times each is taken; column 0 holds 1 in every row.
    /// Only statements of `boundfit/proof/2` can be about them.
    #[must_use]
    pub fn with_x_error(self, column: usize, times: &Rational) -> Self {
        ProofQuestion { x_error: Some((column, times.to_string())), ..self }
    }

    /// With the sum of these columns, from 1, each so many times, as y. Only statements of `boundfit/proof/2` can be about it.
    #[must_use]
    pub fn with_response(self, columns: &[(usize, Rational)]) -> Self {
        let [x1, x2, _, epsilon] = self.model;
        let response = columns.iter().map(|(column, times)| (*column, times.to_string())).collect();
        ProofQuestion { model: [x1, x2, (0, "0".to_owned()), epsilon], response, ..self }
    }
}

/// a1, a2 and b, and the sign of an equation.
fn condition_json(condition: &Condition) -> Vec<String> {
    let inequality = condition.inequality();
    let numbers = [&inequality.a[0], &inequality.a[1], &inequality.b].map(Rational::to_string);
    numbers.into_iter().chain(condition.is_equation().then(|| "=".to_owned())).collect()
}
