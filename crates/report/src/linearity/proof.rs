//! The proof of independent linearity.

use boundfit_estimation::BoundName;
use boundfit_questions::Linearity;

use crate::proof_question::ProofQuestion;
use crate::statements::{Claim, ErrorScale, HalfPlaneName, Multiple, Scope, Statement};
use crate::statements_json::statements_json;

/// The proof that no line is nearer to the characteristic than the independent linearity says, schema `boundfit/proof/2`: the
/// least error bound of these readings. `None` where a point of the characteristic is not one row.
pub fn linearity_proof(linearity: &Linearity, question: &ProofQuestion) -> Option<String> {
    let average = &linearity.average;
    if average.points.iter().any(|point| point.rows.len() != 1) {
        return None;
    }
    let multiples = average.proof.iter().map(|point| {
        let row = *average.points.get(point.position)?.rows.first()?;
        // A reading below the line keeps it from being lower only by its upper bound.
        let name = if point.deviation.is_negative() { BoundName::Upper(row) } else { BoundName::Lower(row) };
        Some(Multiple { name: HalfPlaneName::Bound(name), times: point.weight.clone() })
    });
    let multiples = multiples.collect::<Option<Vec<Multiple>>>()?;
    let line = &average.independent;
    let scope = Scope { errors: ErrorScale::Within(line.deviation.clone()), ..Scope::default() };
    let claim = Claim::Least { point: line.theta.clone(), multiples };
    Some(statements_json(question, &[Statement { scope, claim }]))
}
