//! The proof of independent linearity.

use boundfit_estimation::{BoundName, Columns, EpsilonColumn, LineForm, Measurements, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_formats::{ColumnSelector, InputError, InputErrorKind, Source, TableOptions};
use boundfit_questions::{CalibrationColumns, CalibrationResponse, Linearity};
use boundfit_verify::ErrorScale;

use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, statements_json};

/// The question that a proof of linearity is about, from data that are read once more, twice where there are two columns, of
/// which the mean is the characteristic. `None` where they are no delimited text of which each row is a point.
///
/// # Errors
/// The first thing wrong with the data.
pub fn linearity_question(
    columns: &CalibrationColumns,
    options: &TableOptions,
    reading: Reading,
    open: impl Fn() -> Result<Source, InputError>,
) -> Result<Option<ProofQuestion>, InputError> {
    let measurements = |response: &ColumnSelector| {
        let columns = Columns {
            first: columns.x.clone(),
            second: None,
            response: Some(response.clone()),
            epsilon: EpsilonColumn::Uniform(Rational::zero()),
            form: LineForm::default(),
        };
        Measurements::read(open()?, &columns, options)
    };
    let question =
        |measurements| ProofQuestion::new(&Problem { measurements, conditions: Vec::new() }, reading);
    Ok(match &columns.response {
        CalibrationResponse::One(y) => question(measurements(y)?),
        CalibrationResponse::Directed { .. } => None,
        CalibrationResponse::Two { up, down } => {
            // A point with one reading is no mean of two.
            let both = [measurements(up), measurements(down)];
            let lacks = |error: &InputError| {
                matches!(error.kind, InputErrorKind::Missing { .. } | InputErrorKind::AllMissing { .. })
            };
            if both.iter().any(|own| own.as_ref().is_err_and(lacks)) {
                return Ok(None);
            }
            let [up, down] = both;
            let both = [up?, down?];
            if both[0].fitted_rows() != both[1].fitted_rows() {
                return Ok(None);
            }
            let column = |own: &Measurements| own.layout()?.columns.get(1).copied();
            let half = |own: &Measurements| Some((column(own)?, Rational::ratio(1, 2)));
            let halves = both.each_ref().map(half);
            let [up, _] = both;
            match halves {
                [Some(first), Some(second)] => question(up).map(|own| own.with_response(&[first, second])),
                _ => None,
            }
        }
    })
}

/// The proof that no line is nearer to the characteristic than the independent linearity says, schema `boundfit/proof/2`: the
/// least error bound of these readings. `None` where a point of the characteristic is not one row.
pub fn linearity_proof(linearity: &Linearity, question: &ProofQuestion) -> Option<String> {
    let average = &linearity.average;
    if average.points.iter().any(|point| point.rows.count() != 1) {
        return None;
    }
    let proof = average.proof.iter().map(|point| {
        let row = average.points.get(point.position)?.rows.first() as usize;
        // A reading below the line keeps it from being lower only by its upper bound.
        let name = if point.deviation.is_negative() { BoundName::Upper(row) } else { BoundName::Lower(row) };
        Some((name, point.weight.clone()))
    });
    let proof = proof.collect::<Option<Vec<_>>>()?;
    let line = &average.independent;
    let scope = Scope { errors: ErrorScale::Within(line.deviation.clone()), ..Scope::default() };
    Some(statements_json(question, &[Statement::least(scope, &line.theta, &proof)]))
}
