//! The statements of a proof `boundfit/proof/2`: claims about sets that rows of the data leave, each of which can be
//! checked by itself (docs/proof.md).

use boundfit_estimation::BoundName;
use boundfit_exact::Rational;
use boundfit_geometry::predicates::{Turn, normal_turn};
use boundfit_geometry::{BoundProof, Multiplier, Polyhedron, Support, UnboundedProof};
use boundfit_questions::{BoxBound, Corner, Side};
use boundfit_verify::ErrorScale;

use crate::answer::proof::{
    EndProofJson, MultipleJson, ScopeJson, StatedJson, StatementJson, StatementsJson, VectorJson,
};
use crate::json::to_text;
use crate::proof_question::ProofQuestion;
use crate::table_json::row_ranges;

/// A claim about the set of a scope.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The half-planes that make the set.
    pub scope: Scope,
    /// The claim.
    pub claim: StatedJson,
}

/// The half-planes of a part of the rows and conditions that a proof is about, at another size of the errors perhaps. The
/// default takes all of them as they are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scope {
    /// The first and the last of rows that follow each other, then those of the next ones; all when `None`.
    pub rows: Option<Vec<[usize; 2]>>,
    /// Rows that are left out.
    pub without: Vec<usize>,
    /// The numbers of the conditions that hold, from 1; all when `None`.
    pub conditions: Option<Vec<usize>>,
    /// The size of the errors.
    pub errors: ErrorScale,
    /// The side of the set, if x has errors as well; exactly then it is present. Both sides are the lines that agree
    /// for every x that the errors allow.
    pub side: Option<Side>,
}

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
    let statements = statements.iter().map(|own| StatementJson {
        kind: own.claim.kind(),
        scope: scope_json(&own.scope),
        claim: &own.claim,
    });
    to_text(&StatementsJson { schema: StatementsJson::SCHEMA, question, statements: statements.collect() })
}

impl Statement {
    /// The range of a linear form over the set of a scope, which these half-planes make; `None` for an empty set.
    /// Cost: two binary searches.
    pub fn form(
        scope: Scope,
        polyhedron: &Polyhedron,
        name: &impl Fn(usize) -> BoxBound,
        form: &[Rational; 2],
    ) -> Option<Self> {
        let opposite = form.each_ref().map(|part| -part);
        let end = |form: &[Rational; 2]| match polyhedron.support(form) {
            Support::Empty(_) => None,
            Support::Unbounded(proof) => Some(end_beyond(&proof)),
            Support::Bounded { proof, .. } => Some(end_at(&proof, name)),
        };
        let claim = StatedJson::Form { lower: end(&opposite)?, upper: end(form)?, form: vector(form) };
        Some(Statement { scope, claim })
    }

    /// States that a point is in the set of a scope.
    pub fn point(scope: Scope, point: &[Rational; 2]) -> Self {
        Statement { scope, claim: StatedJson::Point { point: vector(point) } }
    }

    /// States that nothing is in the set of a scope: at most three half-planes add up to 0 ≤ a negative number.
    pub fn empty(scope: Scope, multipliers: Vec<MultipleJson>) -> Self {
        Statement { scope, claim: StatedJson::Empty { multipliers } }
    }

    /// States the set of a scope that these half-planes make: the walk around it, or the reason why it is empty.
    pub fn set(scope: Scope, polyhedron: &Polyhedron, name: &impl Fn(usize) -> BoxBound) -> Self {
        let region = polyhedron.region();
        let (None, Some(point)) = (region.certificate(), region.witness()) else {
            let multipliers = region.certificate().map(|farkas| farkas.multipliers()).unwrap_or_default();
            return Statement::empty(scope, multiples(multipliers, name));
        };
        let vertices = region.vertices().iter().map(|vertex| vector(&vertex.point().coordinates()));
        let claim = StatedJson::Set {
            point: vector(&point.coordinates()),
            vertices: vertices.collect(),
            sides: walk(polyhedron, name),
        };
        Statement { scope, claim }
    }

    /// States that the scaled errors of a scope are the least that leave this point. At most three half-planes add up to
    /// 0 ≤ 0, and would add up to less with smaller errors; none where the errors are 0.
    pub fn least(scope: Scope, point: &[Rational; 2], proof: &[(BoundName, Rational)]) -> Self {
        Statement { scope, claim: StatedJson::Least { point: vector(point), multipliers: of_bounds(proof) } }
    }
}

impl Scope {
    /// All rows but these.
    pub fn without(rows: &[usize]) -> Self {
        Scope { without: rows.to_vec(), ..Scope::default() }
    }

    /// These rows alone, which ascend.
    pub fn of_rows(rows: impl IntoIterator<Item = usize>) -> Self {
        Scope { rows: Some(row_ranges(rows)), ..Scope::default() }
    }
}

/// Multiples of a system's inequalities by their names.
pub fn multiples(multipliers: &[Multiplier], name: &impl Fn(usize) -> BoxBound) -> Vec<MultipleJson> {
    multipliers.iter().map(|own| (half_plane(name(own.index)), own.value.to_string())).collect()
}

/// Multiples of half-planes of readings and conditions.
pub(crate) fn of_bounds(multiples: &[(BoundName, Rational)]) -> Vec<MultipleJson> {
    multiples.iter().map(|(name, times)| (name.to_string(), times.to_string())).collect()
}

/// The sides of a set in order of angle, each with the index of the vertex where it meets the next one, if it does.
pub(crate) fn walk(
    polyhedron: &Polyhedron,
    name: &impl Fn(usize) -> BoxBound,
) -> Vec<(String, Option<usize>)> {
    let sides = polyhedron.irredundant_by_angle().iter().map(|&index| half_plane(name(index)));
    sides.zip(corners(polyhedron)).collect()
}

/// Returns, for each side in order of angle, the index of the vertex where it meets the next one; `None` where they
/// do not meet. Cost: linear in the number of sides and logarithmic in that of half-planes through a vertex.
pub(crate) fn corners(polyhedron: &Polyhedron) -> Vec<Option<usize>> {
    let sides = polyhedron.irredundant_by_angle();
    let vertices = polyhedron.region().vertices();
    let system = polyhedron.system();
    let mut at = 0;
    let corner = |(&side, &next): (&usize, &usize)| {
        let (f, g) = (system.half_plane(side)?, system.half_plane(next)?);
        if normal_turn(f, g) != Turn::Left {
            return None;
        }
        // Vertices come in the order of the sides: the search goes around once, after the first side.
        let through_both = |index: &usize| {
            vertices.get(*index).is_some_and(|vertex| {
                [side, next].iter().all(|own| vertex.active().binary_search(own).is_ok())
            })
        };
        at = (at..vertices.len()).chain(0..at).find(through_both)?;
        Some(at)
    };
    sides.iter().zip(sides.iter().cycle().skip(1)).map(corner).collect()
}

/// The attained end of a form, and at most two half-planes that add up to the form, at a lower end to its opposite. The ray is
/// zero.
pub(crate) fn end_at(proof: &BoundProof, name: &impl Fn(usize) -> BoxBound) -> EndProofJson {
    let point = vector(&proof.attained_at.coordinates());
    (multiples(&proof.multipliers, name), point, ["0", "0"].map(ToOwned::to_owned))
}

/// A point of the set, and a direction that does not leave it, along which a form grows, or for a lower end falls.
pub(crate) fn end_beyond(proof: &UnboundedProof) -> EndProofJson {
    let ray = [proof.ray.dx(), proof.ray.dy()].map(ToString::to_string);
    (Vec::new(), vector(&proof.point.coordinates()), ray)
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
pub(crate) fn sorted(numbers: &[usize]) -> Vec<usize> {
    let mut numbers = numbers.to_vec();
    numbers.sort_unstable();
    numbers
}

/// A pair of exact numbers as text.
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
