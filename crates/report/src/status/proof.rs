//! The proof of statuses.

use boundfit_estimation::{BoundName, Problem};
use boundfit_exact::Reading;
use boundfit_questions::Statuses;

use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, statements_json};

/// Returns the proof of statuses, schema `boundfit/proof/2`. The set of all readings proves the status of every
/// reading that does not decide. Each reading that decides has the values of the model at it over the set of the
/// others, or the reason why that set is empty. `None` where the readings are not those of plain delimited text.
pub fn status_proof(problem: &Problem, statuses: &Statuses, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(problem, reading)?;
    let fps = statuses.fps();
    let mut statements =
        vec![Statement::set(Scope::default(), fps.polyhedron(), &|index| fps.name(index).into())];
    for own in statuses.deciding_readings() {
        let (set, names): (_, Vec<BoundName>) = statuses.set_without(own.row);
        let name = |index: usize| names[index].into();
        let scope = Scope::without(&[own.row]);
        let form = Statement::form(scope.clone(), &set, &name, &own.regressor);
        statements.push(form.unwrap_or_else(|| Statement::set(scope, &set, &name)));
    }
    Some(statements_json(&question, &statements))
}
