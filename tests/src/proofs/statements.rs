//! Proofs of statements about parts of the rows, for what must treat all of them alike.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_estimation::{BoundName, Measurement, Minimax, Problem, conditions_by_name, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron, System};
use boundfit_questions::{BoxBound, Corner, Side};
use boundfit_report::answer::StatedJson;
use boundfit_report::{ProofQuestion, Scope, Statement, multiples, statements_json};
use boundfit_verify::ErrorScale;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::Question;

/// A scope's half-planes by name.
type Named = (Vec<BoxBound>, Polyhedron);

/// The largest distance of each x from the number that is read, if a question asks for it.
const X_ERROR: [i64; 2] = [1, 4];

impl Question {
    /// A proof of statements of every kind about the readings of this question, where x has errors as well perhaps.
    ///
    /// # Panics
    /// When the data cannot be read.
    pub fn statements(&self, has_x_error: bool, rng: &mut ChaCha8Rng) -> String {
        let problem = self.problem().unwrap_or_else(|error| panic!("{}: {error}", self.name));
        let question = ProofQuestion::new(&problem, self.options.reading).expect("delimited text");
        let x_error = if has_x_error { Rational::ratio(X_ERROR[0], X_ERROR[1]) } else { Rational::zero() };
        let question = if has_x_error { question.with_x_error(0, &x_error) } else { question };
        let statements = (0..4).flat_map(|_| {
            let scope = scope(&problem, has_x_error, rng);
            stated(&problem, scope, &x_error, rng)
        });
        let statements: Vec<Statement> = statements.collect();
        statements_json(&question, &statements)
    }
}

/// A few of the rows and conditions, under errors of another size perhaps.
fn scope(problem: &Problem, has_x_error: bool, rng: &mut ChaCha8Rng) -> Scope {
    let rows: Vec<usize> = problem.measurements.kept().iter().map(|row| row.row).collect();
    let sides = [Side::Rising, Side::Falling, Side::Both];
    let mut scope = match rng.random_range(0..4) {
        0 => Scope::of_rows(rows.iter().copied().filter(|_| rng.random_bool(0.5))),
        1 => Scope::without(&[rows[rng.random_range(0..rows.len())]]),
        _ => Scope::default(),
    };
    if scope.rows.as_ref().is_some_and(Vec::is_empty) {
        scope.rows = None;
    }
    let count = problem.conditions.len();
    if count > 0 && rng.random_bool(0.3) {
        scope.conditions = Some((1..=count).filter(|_| rng.random_bool(0.5)).collect());
    }
    let size = Rational::ratio(rng.random_range(0..5), rng.random_range(1..4));
    scope.errors = match rng.random_range(0..6) {
        0 => ErrorScale::Times(size),
        1 => ErrorScale::Within(size),
        _ => ErrorScale::AsStated,
    };
    scope.side = has_x_error.then(|| sides[rng.random_range(0..3)]);
    scope
}

/// The half-planes of a scope: the definitions, number by number.
fn system(problem: &Problem, scope: &Scope, x_error: &Rational, without: &BTreeSet<usize>) -> Named {
    let has_row = |row: &&Measurement| {
        let in_ranges =
            |ranges: &Vec<[usize; 2]>| ranges.iter().any(|[first, last]| (*first..=*last).contains(&row.row));
        scope.rows.as_ref().is_none_or(in_ranges)
            && !scope.without.contains(&row.row)
            && !without.contains(&row.row)
    };
    let x_error = match &scope.errors {
        ErrorScale::Times(factor) => x_error * factor,
        _ => x_error.clone(),
    };
    let mut all: Vec<(BoxBound, Inequality)> = Vec::new();
    for row in problem.measurements.kept().iter().filter(has_row) {
        let [lower, upper] = bounds(row, &scope.errors);
        let at = |sign: i64| {
            let phi1 = &row.regressor[0] + Rational::from(sign) * &x_error;
            Measurement::between(row.row, [phi1, row.regressor[1].clone()], lower.clone(), upper.clone())
        };
        let is_upper = |name: &BoundName| matches!(name, BoundName::Upper(_));
        let at_corner = |name, corner| BoxBound::Bound(name, Some(corner));
        match scope.side {
            None => {
                let plain = at(0);
                all.extend(half_planes(&plain).map(|(name, own)| (name.into(), own)));
            }
            Some(Side::Both) => {
                let plus = at(1);
                all.extend(half_planes(&plus).map(|(name, own)| (at_corner(name, Corner::Right), own)));
                let minus = at(-1);
                all.extend(half_planes(&minus).map(|(name, own)| (at_corner(name, Corner::Left), own)));
            }
            Some(side) => {
                let sign = if side == Side::Rising { -1 } else { 1 };
                let (above, below) = (at(sign), at(-sign));
                let chosen = half_planes(&above)
                    .filter(|(name, _)| is_upper(name))
                    .chain(half_planes(&below).filter(|(name, _)| !is_upper(name)));
                all.extend(chosen.map(|(name, own)| (name.into(), own)));
            }
        }
    }
    let holds = |name: &BoundName| {
        let number = name.condition().unwrap_or_default();
        scope.conditions.as_ref().is_none_or(|numbers| numbers.contains(&number))
    };
    let conditions = conditions_by_name(&problem.conditions).filter(|(name, _)| holds(name));
    all.extend(conditions.map(|(name, own)| (name.into(), own)));
    let side = match scope.side {
        Some(Side::Rising) => Some(-1),
        Some(Side::Falling) => Some(1),
        _ => None,
    };
    all.extend(side.map(|sign| {
        let zero = Rational::zero();
        (BoxBound::Slope(Side::Rising), Inequality::new(Rational::from(sign), zero.clone(), zero))
    }));
    let (names, inequalities): (Vec<_>, Vec<_>) = all.into_iter().unzip();
    (names, Polyhedron::intersect(System::new(inequalities)))
}

/// The bounds of a reading under errors of another size.
fn bounds(row: &Measurement, errors: &ErrorScale) -> [Option<Rational>; 2] {
    let (lower, upper) = (row.lower(), row.upper());
    match (lower, upper, errors) {
        (Some(lower), Some(upper), ErrorScale::Times(_) | ErrorScale::Within(_)) if lower <= upper => {
            let middle = (&lower + &upper) * Rational::ratio(1, 2);
            let width = match errors {
                ErrorScale::Times(factor) => (&upper - &lower) * Rational::ratio(1, 2) * factor,
                ErrorScale::Within(bound) => bound.clone(),
                ErrorScale::AsStated => Rational::zero(),
            };
            [Some(&middle - &width), Some(middle + width)]
        }
        (lower, upper, _) => [lower, upper],
    }
}

/// Returns what can be stated of a scope.
fn stated(problem: &Problem, scope: Scope, x_error: &Rational, rng: &mut ChaCha8Rng) -> Vec<Statement> {
    let (names, polyhedron) = system(problem, &scope, x_error, &BTreeSet::new());
    let name = |index: usize| names[index];
    let mut all = Vec::new();
    let small = |rng: &mut ChaCha8Rng| Rational::ratio(rng.random_range(-3..4), rng.random_range(1..3));
    if let Some(witness) = polyhedron.region().witness() {
        let form = [small(rng), small(rng)];
        all.extend(Statement::form(scope.clone(), &polyhedron, &name, &form));
        all.push(Statement::point(scope.clone(), &witness.coordinates()));
    } else if scope.side.is_none() || rng.random_bool(0.5) {
        all.extend(left_out(problem, &scope, x_error));
    }
    all.push(Statement::set(scope.clone(), &polyhedron, &name));
    let is_whole = scope.rows.is_none() && scope.without.is_empty() && scope.conditions.is_none();
    if is_whole
        && scope.side.is_none()
        && let Some(minimax) = Minimax::new(&problem.measurements, &problem.conditions)
    {
        let least = minimax.least.clone();
        let is_uniform = problem.measurements.error_bound().is_uniform();
        let errors = if is_uniform { ErrorScale::Within(least) } else { ErrorScale::Times(least) };
        let scope = Scope { errors, ..scope };
        all.push(Statement::least(scope, &minimax.theta, &minimax.proof.multipliers));
    }
    all
}

/// The least number of rows to leave out, up to 3, with all sets of so many, and what is left without each.
fn left_out(problem: &Problem, scope: &Scope, x_error: &Rational) -> Vec<Statement> {
    let mut contradictions: BTreeMap<BTreeSet<usize>, Vec<(String, String)>> = BTreeMap::new();
    let mut level: BTreeSet<BTreeSet<usize>> = [BTreeSet::new()].into();
    for least in 0..=3 {
        let (mut sets, mut left): (Vec<Vec<usize>>, Vec<Statement>) = Default::default();
        let mut next = BTreeSet::new();
        for rows in &level {
            let (names, polyhedron) = system(problem, scope, x_error, rows);
            let Some(certificate) = polyhedron.region().certificate() else {
                let without = scope.without.iter().copied().chain(rows.iter().copied()).collect();
                let scope = Scope { without, ..scope.clone() };
                left.push(Statement::set(scope, &polyhedron, &|index: usize| names[index]));
                sets.push(rows.iter().copied().collect());
                continue;
            };
            let own = certificate.multipliers().iter().filter_map(|own| names[own.index].row());
            next.extend(own.map(|row| rows.iter().copied().chain([row]).collect::<BTreeSet<_>>()));
            let multiples = multiples(certificate.multipliers(), &|index| names[index]);
            contradictions.insert(rows.clone(), multiples);
        }
        if !sets.is_empty() || next.is_empty() || least == 3 || next.len() > 12 {
            let contradictions =
                contradictions.into_iter().map(|(rows, own)| (rows.into_iter().collect(), own)).collect();
            let claim = StatedJson::LeftOut { least, sets: Some(sets), contradictions };
            return [Statement { scope: scope.clone(), claim }].into_iter().chain(left).collect();
        }
        level = next;
    }
    Vec::new()
}
