//! Parts of the rows of a fit, as certificates of theorems name them: rows by their places from 1.

use std::collections::{BTreeSet, HashMap};

use boundfit_estimation::{Condition, Fit, Measurement, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_geometry::{Inequality, Polyhedron, System};

use super::evidence::{Evidence, by_place, contradicting};
use super::numbers::literal;
use super::rows::{Statement, every_row};
use super::theorem::{Head, Theory};
use super::theorem_of_fit;

/// The rows of a theorem, by place.
pub(super) struct Parts<'a> {
    rows: Vec<(usize, Measurement)>,
    places: HashMap<usize, usize>,
    conditions: &'a [Condition],
}

/// The names of one field of numbers in the theory.
pub(super) struct Field {
    /// The end of names.
    pub(super) real: &'static str,
    /// The type of points, and what a row says of one.
    points: &'static str,
    /// A point of the file as one of these.
    at_point: &'static str,
    /// The lemmas about contradictions, points and sets.
    nothing: &'static str,
    meets_point: &'static str,
    set: [&'static str; 2],
}

/// The rational and the real numbers.
pub(super) const FIELDS: [Field; 2] = [
    Field {
        real: "",
        points: "(Q * Q) meets_q",
        at_point: "(fun v => v)",
        nothing: "empty",
        meets_point: "point_meets_q",
        set: ["set_of", "set_sound"],
    },
    Field {
        real: "R",
        points: "(R * R) meets_r",
        at_point: "real_point",
        nothing: "emptyR",
        meets_point: "point_meets_r",
        set: ["set_ofR", "set_soundR"],
    },
];

impl Field {
    /// The arguments of a lemma about contradictions.
    pub(super) fn of_contradictions(&self) -> String {
        format!("{} {} {}", self.points, self.nothing, self.of_parts())
    }

    /// The arguments of a lemma about points.
    pub(super) fn of_points(&self) -> String {
        format!("{} {} {} {}", self.points, self.at_point, self.meets_point, self.of_parts())
    }

    /// The arguments of a lemma about both.
    pub(super) fn of_both(&self) -> String {
        let Field { points, at_point, nothing, meets_point, .. } = self;
        format!("{points} {at_point} {nothing} {meets_point} {}", self.of_parts())
    }

    /// The arguments of a lemma about sets.
    pub(super) fn of_sets(&self) -> String {
        let [set, set_sound] = self.set;
        format!("{} {set} {set_sound} {}", self.points, self.of_parts())
    }

    /// The arguments of a lemma about sets and points.
    pub(super) fn of_sets_and_points(&self) -> String {
        let Field { points, at_point, meets_point, set: [set, set_sound], .. } = self;
        format!("{points} {set} {at_point} {set_sound} {meets_point} {}", self.of_parts())
    }

    /// The name of the statement of a row about a point.
    pub(super) fn meets(&self) -> &'static str {
        if self.real.is_empty() { "meets_q" } else { "meets_r" }
    }

    /// The rows, and the lemma about parts of them.
    fn of_parts(&self) -> String {
        format!("rows row_form always feasible_part{0} part_forms{0}", self.real)
    }
}

/// The theorem about a fit with the definitions of parts, and its rows. `None` when some readings are not in memory.
pub(super) fn with_parts<'a>(
    (problem, fit): (&'a Problem, &Fit),
    asked: (Reading, Theory),
    subject: &'static str,
) -> Option<(String, Parts<'a>)> {
    let (statement, numbers) = Statement::of_problem(problem)?;
    let head = Head { subject: Some(subject), has_parts: true, ..Head::default() };
    let text = theorem_of_fit((problem, fit), (&statement, &numbers), asked, head)?;
    let rows = every_row(&problem.measurements)?;
    let places = rows.iter().zip(1..).map(|((row, _), place)| (*row, place)).collect();
    Some((text + &statement.parts(), Parts { rows, places, conditions: &problem.conditions }))
}

impl Parts<'_> {
    /// The place of a row of the data.
    pub(super) fn place(&self, row: usize) -> Option<usize> {
        self.places.get(&row).copied()
    }

    /// The places of rows of the data, ascending, each once.
    pub(super) fn sorted(&self, rows: impl IntoIterator<Item = usize>) -> Option<Vec<usize>> {
        let places: Option<BTreeSet<usize>> = rows.into_iter().map(|row| self.place(row)).collect();
        Some(places?.into_iter().collect())
    }

    /// The half-planes of these rows and of the conditions, as the checker numbers them.
    fn polyhedron(&self, places: &[usize]) -> Option<Polyhedron> {
        let mut system = System::default();
        for place in places {
            let (_, own) = self.rows.get(place.checked_sub(1)?)?;
            let [a, b] = &own.regressor;
            if let Some(lower) = own.lower() {
                system.push(Inequality::new(-a, -b, -lower));
            }
            if let Some(upper) = own.upper() {
                system.push(Inequality::new(a.clone(), b.clone(), upper));
            }
        }
        for condition in self.conditions {
            let Inequality { a: [a, b], b: bound } = condition.inequality();
            if condition.is_equation() {
                system.push(Inequality::new(-a, -b, -bound));
            }
            system.push(Inequality::new(a.clone(), b.clone(), bound.clone()));
        }
        Some(Polyhedron::intersect(system))
    }

    /// A term of the type `contradiction`: rows that contradict each other with the conditions. `None` if they do not.
    pub(super) fn contradiction(&self, rows: impl IntoIterator<Item = usize>) -> Option<String> {
        let places = self.sorted(rows)?;
        let numbers = contradicting(&self.polyhedron(&places)?, &by_place)?;
        Some(format!("({}, {})", whole(&places), whole(&numbers)))
    }

    /// The evidence for the set of a part of the rows and the conditions; `None` if it is empty.
    pub(super) fn evidence(&self, places: &[usize]) -> Option<Evidence> {
        Evidence::new(&self.polyhedron(places)?, &by_place)
    }
}

/// Whole numbers as a list of Coq.
pub(super) fn whole(numbers: &[usize]) -> String {
    let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
    format!("[{}]%Z", numbers.join("; "))
}

/// A pair of fractions.
pub(super) fn pair([a, b]: [&Rational; 2]) -> String {
    format!("({}, {})", literal(a), literal(b))
}

/// Terms as a list of Coq, one on a line.
pub(super) fn lines(terms: &[String]) -> String {
    format!("[{}]", terms.join(";\n  "))
}
