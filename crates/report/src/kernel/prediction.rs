//! Predictions as a theorem: the values of the model at each x.

use std::fmt::Write;

use boundfit_exact::Reading;

use super::numbers::literal;
use super::rows::Statement;
use super::theorem::{Form, Head, Theory, range_of};
use super::theorem_of_fit;
use crate::predict::{Prediction, proved_forms};

/// The theorem about predictions: the set of the fit, and the range of the model's values on it at each value that the proof
/// for `boundfit verify` has. `None` when some of the readings are not in memory. Exact. Cost: linear in the readings, and in the
/// values times the vertices.
pub fn kernel_prediction(prediction: &Prediction, reading: Reading, theory: Theory) -> Option<String> {
    const SUBJECT: &str = "the values that the model takes on the set, at each x asked for and at each x where readings end.\n   \
                           The last one needs the definition of value";
    let (statement, numbers) = Statement::of_problem(prediction.problem)?;
    let asked = (prediction.problem, prediction.fit);
    let head = Head { subject: Some(SUBJECT), ..Head::default() };
    let mut text = theorem_of_fit(asked, (&statement, &numbers), (reading, theory), head)?;
    let Some(predictor) = prediction.predictor() else { return Some(text) };
    let (arguments, body, second) = match prediction.is_line() {
        true => ("x", "fst p * x + snd p", "1"),
        false => ("x u", "fst p * x + snd p * u", "u"),
    };
    let _ = write!(
        text,
        "\n(* The value of the model, where x is what it is in the rows. *)\n\
         Definition value ({arguments} : Q) (p : Q * Q) : Q := {body}.\n\
         Lemma value_is_linear {arguments} p : value {arguments} p == x * fst p + {second} * snd p.\n\
         Proof. unfold value. ring. Qed.\n"
    );
    let mut statements = Vec::new();
    let mut names = Vec::new();
    for (index, form) in proved_forms(prediction, &predictor).iter().enumerate() {
        let [first, second] = form.each_ref().map(literal);
        let (given, coefficients) = match prediction.is_line() {
            true => (first.clone(), format!("{first} 1")),
            false => (format!("{first} {second}"), format!("{first} {second}")),
        };
        let own = Form {
            name: &format!("value{}", index + 1),
            term: &format!("(value {given})"),
            linear: &format!("{coefficients} (value_is_linear {given})"),
        };
        let [lemmas, name, says] = range_of(&own, &prediction.at(&predictor, form).0);
        text.push_str(&lemmas);
        names.push(name);
        statements.push(says);
    }
    if statements.is_empty() {
        // No line comes near any of the readings, which follows from the set.
        return Some(text);
    }
    let _ = write!(
        text,
        "\nTheorem the_prediction :\n  {}.\nProof.\n  {}exact {}.\nQed.\n\nPrint Assumptions the_prediction.\n",
        statements.join("\n  /\\ "),
        names
            .iter()
            .rev()
            .skip(1)
            .rev()
            .map(|name| format!("split; [exact {name} |].\n  "))
            .collect::<String>(),
        names.last()?
    );
    Some(text)
}
