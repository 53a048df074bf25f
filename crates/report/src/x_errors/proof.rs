//! The proof of lines under errors in x, schema `boundfit/proof/2`.

use boundfit_exact::{Rational, Reading};
use boundfit_questions::{Agreement, BoxBound, Corner, Side, SideSet, XBounds, XErrorFit, XErrorProblem};

use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, multiples, statements_json};

/// Returns, for each side, the walk around its set with the ends of both parameters, or the proof of its emptiness.
/// `None` when the readings do not come from delimited text that the checkers read.
pub fn x_error_proof(problem: &XErrorProblem, answer: &XErrorFit, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(problem.problem(), reading)?;
    let question = match problem.bounds() {
        XBounds::Uniform(bound) => question.with_x_error(0, bound),
        XBounds::PerRow { .. } => {
            let column = *problem.problem().measurements.layout()?.columns.last()?;
            question.with_x_error(column, &Rational::one())
        }
    };
    let is_strong = |side: &SideSet| problem.agreement() == Agreement::Strong || side.side == Side::Both;
    let statements: Vec<Statement> =
        answer.sides.iter().flat_map(|side| of_side(side, is_strong(side))).collect();
    Some(statements_json(&question, &statements))
}

fn of_side(side: &SideSet, is_strong: bool) -> Vec<Statement> {
    let scope = || Scope { side: Some(side.side), ..Scope::default() };
    let name = |index: usize| match side.names[index] {
        BoxBound::Bound(name, corner) if is_strong && name.row().is_some() => {
            // Without an error both corners are one.
            BoxBound::Bound(name, corner.or(Some(Corner::Right)))
        }
        BoxBound::Bound(name, _) => name.into(),
        side => side,
    };
    if let Some(multipliers) = side.farkas() {
        return vec![Statement::empty(scope(), multiples(&multipliers, &name))];
    }
    let forms = [[1, 0], [0, 1]].map(|form| form.map(Rational::from));
    let forms = forms.iter().filter_map(|form| Statement::form(scope(), &side.polyhedron, &name, form));
    [Statement::set(scope(), &side.polyhedron, &name)].into_iter().chain(forms).collect()
}
