//! The proof of predictions.

use std::collections::HashSet;

use boundfit_exact::{Rational, Reading};
use boundfit_questions::Predictor;

use super::Prediction;
use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, statements_json};

/// Returns the proof of predictions, schema `boundfit/proof/2`. It has the range of the model at each value asked
/// for, and at each x where readings end. An empty set has the proof of its emptiness. `None` where the readings are
/// not those of plain delimited text.
pub fn prediction_proof(prediction: &Prediction, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(prediction.problem, reading)?;
    let set = prediction.fit.fps.polyhedron();
    let name = |index: usize| prediction.fit.fps.name(index).into();
    let Some(predictor) = prediction.predictor() else {
        return Some(statements_json(&question, &[Statement::set(Scope::default(), set, &name)]));
    };
    let forms = proved_forms(prediction, &predictor);
    let statement = |form: &[Rational; 2]| Statement::form(Scope::default(), set, &name, form);
    let mut statements: Vec<Statement> = forms.iter().filter_map(statement).collect();
    if statements.is_empty() {
        // Where no line comes near any of the readings, the set says so.
        statements.push(Statement::set(Scope::default(), set, &name));
    }
    Some(statements_json(&question, &statements))
}

/// The forms whose ranges are proved, each once: the model at each value asked for, and at each x where readings end.
pub(crate) fn proved_forms(prediction: &Prediction, predictor: &Predictor) -> Vec<[Rational; 2]> {
    let mut forms: Vec<[Rational; 2]> =
        (prediction.at.values)().map(|value| prediction.form(&value)).collect();
    let of = prediction.sources(predictor);
    for [y, _] in (prediction.from.values)() {
        let ends = of(&y).into_iter().flat_map(|own| [own.lower, own.upper]).flatten();
        forms.extend(ends.map(|end| prediction.form(&[end.x, Rational::one()])));
    }
    let mut seen = HashSet::new();
    forms.retain(|form| seen.insert(form.clone()));
    forms
}
