//! Statements as a proof that others can check, schema `boundfit/proof/2` (docs/proof.md).

use boundfit_exact::Rational;
use boundfit_questions::{BoxBound, Corner, Side};

use crate::answer::proof::{
    EndProofJson, MultipleJson, ScopeJson, StatedJson, StatementJson, StatementsJson, VectorJson,
};
use crate::json::to_text;
use crate::proof_question::ProofQuestion;
use crate::statements::{Claim, ErrorScale, FormEnd, Multiple, Scope, Statement};

/// Statements about a question as JSON, with a line end. All numbers are exact fractions as text.
///
/// ```
/// use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem, fit};
/// use boundfit_exact::{Rational, Reading};
/// use boundfit_formats::{ColumnSelector, Source, TableOptions};
/// use boundfit_report::{ProofQuestion, Scope, Statement, statements_json};
///
/// let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
/// let columns = Columns {
///     first: ColumnSelector::name_or_number("x"),
///     second: None,
///     response: Some(ColumnSelector::name_or_number("y")),
///     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
///     form: LineForm::default(),
/// };
/// let measurements = Measurements::read(table, &columns, &TableOptions::default())?;
/// let problem = Problem { measurements, conditions: Vec::new() };
/// let fit = fit(&problem);
///
/// // The line at x = 4.
/// let form = [4, 1].map(Rational::from);
/// let name = |index| fit.fps.name(index).into();
/// let statement = Statement::form(Scope::default(), fit.fps.polyhedron(), &name, &form);
/// let question = ProofQuestion::new(&problem, Reading::Decimal).expect("a table of text");
/// let proof = statements_json(&question, &[statement.expect("a set that is not empty")]);
/// assert!(proof.contains(r#""kind": "form""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn statements_json(question: &ProofQuestion, statements: &[Statement]) -> String {
    let statements = statements.iter().map(statement_json).collect();
    to_text(&StatementsJson { schema: StatementsJson::SCHEMA, question, statements })
}

fn statement_json(Statement { scope, claim }: &Statement) -> StatementJson {
    let (kind, claim) = match claim {
        Claim::Form { form, lower, upper } => {
            ("form", StatedJson::Form { form: vector(form), lower: end(lower), upper: end(upper) })
        }
        Claim::Point(point) => ("point", StatedJson::Point { point: vector(point) }),
        Claim::Empty(multipliers) => ("empty", StatedJson::Empty { multipliers: multiples(multipliers) }),
        Claim::Least { point, multiples: own } => {
            ("least", StatedJson::Least { point: vector(point), multipliers: multiples(own) })
        }
        Claim::Set { point, vertices, sides } => {
            let sides = sides.iter().map(|(name, vertex)| (half_plane(*name), *vertex)).collect();
            let vertices = vertices.iter().map(vector).collect();
            ("set", StatedJson::Set { point: vector(point), vertices, sides })
        }
        Claim::LeftOut { least, sets, contradictions } => {
            let contradictions = contradictions.iter().map(|(rows, own)| (sorted(rows), multiples(own)));
            let sets = sets.as_ref().map(|sets| sets.iter().map(|set| sorted(set)).collect());
            let claim = StatedJson::LeftOut { least: *least, sets, contradictions: contradictions.collect() };
            ("left out", claim)
        }
    };
    StatementJson { kind, scope: scope_json(scope), claim }
}

fn scope_json(Scope { rows, without, conditions, errors, side }: &Scope) -> ScopeJson {
    let (factor, epsilon) = match errors {
        ErrorScale::AsStated => (None, None),
        ErrorScale::Times(factor) => (Some(factor.to_string()), None),
        ErrorScale::Within(epsilon) => (None, Some(epsilon.to_string())),
    };
    let side = side.map(|side| match side {
        Side::Rising => "+",
        Side::Falling => "-",
        Side::Both => "strong",
    });
    let rows = rows.as_ref().map(|rows| rows.concat());
    let conditions = conditions.as_deref().map(sorted);
    ScopeJson { rows, without: sorted(without), conditions, factor, epsilon, side }
}

/// Returns the numbers in the order in which a proof has them.
fn sorted(numbers: &[usize]) -> Vec<usize> {
    let mut numbers = numbers.to_vec();
    numbers.sort_unstable();
    numbers
}

fn vector(vector: &[Rational; 2]) -> VectorJson {
    vector.each_ref().map(Rational::to_string)
}

/// The name of a half-plane in a proof: a corner of a reading's box by the sign of the error in x.
fn half_plane(name: BoxBound) -> String {
    match name {
        BoxBound::Bound(name, None) => name.to_string(),
        BoxBound::Bound(name, Some(Corner::Right)) => format!("{name} +"),
        BoxBound::Bound(name, Some(Corner::Left)) => format!("{name} -"),
        BoxBound::Slope(_) => "side".to_owned(),
    }
}

fn multiples(multiples: &[Multiple]) -> Vec<MultipleJson> {
    multiples.iter().map(|own| (half_plane(own.name), own.times.to_string())).collect()
}

/// Returns the end of a form's range; the ray is zero at a finite end, and there are no multipliers where there is no
/// end.
fn end(end: &FormEnd) -> EndProofJson {
    match end {
        FormEnd::At { multiples: own, point } => {
            (multiples(own), vector(point), ["0", "0"].map(ToOwned::to_owned))
        }
        FormEnd::Beyond { point, ray } => (Vec::new(), vector(point), vector(ray)),
    }
}
