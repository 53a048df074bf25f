//! The proof of a linear range.

use boundfit_estimation::{Fps, Problem};
use boundfit_exact::Reading;
use boundfit_questions::{Contradiction, Run};

use super::RangeReport;
use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, of_bounds, statements_json};

/// Returns the proof of a linear range, schema `boundfit/proof/2`. Each run has parameters that agree with all of its
/// readings, and the reasons why it goes on neither way. Each reading that no parameters agree with has the reason.
/// `None` where the readings are not those of plain delimited text. Cost: a fit of each run.
pub fn range_proof(report: &RangeReport, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(report.problem, reading)?;
    let mut statements = Vec::new();
    for run in &report.range.runs {
        let rows = rows(report, run);
        let Problem { measurements, conditions } = report.range.problem_of(run, report.problem, false);
        let fps = Fps::new(&measurements, &conditions);
        let point = fps.polyhedron().region().witness()?.coordinates();
        statements.push(Statement::point(Scope::of_rows(rows), &point));
        statements.extend([&run.before, &run.after].into_iter().flatten().map(empty));
    }
    statements.extend(report.range.alone.iter().map(|(_, contradiction)| empty(contradiction)));
    Some(statements_json(&question, &statements))
}

/// The rows of a run, ascending.
fn rows(report: &RangeReport, run: &Run) -> Vec<usize> {
    let mut rows: Vec<usize> = (run.first..=run.last).map(|position| report.row(position)).collect();
    rows.sort_unstable();
    rows
}

/// These rows, or the conditions alone, contradict each other.
fn empty(contradiction: &Contradiction) -> Statement {
    let rows = contradiction.rows();
    let scope = if rows.is_empty() { Scope::default() } else { Scope::of_rows(rows) };
    Statement::empty(scope, of_bounds(&contradiction.terms))
}
