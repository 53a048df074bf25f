//! The statements of a proof `boundfit/proof/2`: claims about sets that rows of the data leave, each of which can be
//! checked by itself (docs/proof.md).

use boundfit_estimation::{BoundName, Minimax};
use boundfit_exact::Rational;
use boundfit_geometry::{BoundProof, Multiplier, Polyhedron, Support, UnboundedProof};
use boundfit_questions::{BoxBound, Side};

use crate::proof_json::corners;

/// A claim about the set of a scope.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The half-planes that make the set.
    pub scope: Scope,
    /// The claim.
    pub claim: Claim,
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

/// The size of the errors in a scope.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum ErrorScale {
    /// The errors of the question.
    #[default]
    AsStated,
    /// A multiple of the errors of the question, about the middle of each reading's bounds; for errors in x a
    /// multiple of their bounds. Readings with one bound stay as they are.
    Times(Rational),
    /// Each reading with two bounds goes so far from their middle; errors in x stay as they are.
    Within(Rational),
}

/// A positive multiple of a half-plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Multiple {
    /// The name of the half-plane. A corner is told in the set of both sides only: in the others it follows from the
    /// side.
    pub name: BoxBound,
    /// The multiple of the half-plane.
    pub times: Rational,
}

/// A claim about a set.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "proofs are short")]
pub enum Claim {
    /// The range of a linear form over the set.
    Form {
        /// The form f of f·θ.
        form: [Rational; 2],
        /// The least value of the form.
        lower: FormEnd,
        /// The largest value of the form.
        upper: FormEnd,
    },
    /// A point is in it.
    Point([Rational; 2]),
    /// Nothing is in it: at most three half-planes add up to 0 ≤ a negative number.
    Empty(Vec<Multiple>),
    /// The scaled errors of the scope are the least that leave a point. The claim has such a point, and at most three
    /// half-planes that add up to 0 ≤ 0 and would add up to less with smaller errors.
    Least {
        /// A point in the set.
        point: [Rational; 2],
        /// None where the errors are 0.
        multiples: Vec<Multiple>,
    },
    /// The exact set: the walk around it.
    Set {
        /// A point in it.
        point: [Rational; 2],
        /// The vertices of the set.
        vertices: Vec<[Rational; 2]>,
        /// The sides of the set in order of angle, each with the index of the vertex where it meets the next one, if
        /// it does.
        sides: Vec<(BoxBound, Option<usize>)>,
    },
    /// Nothing is in it while fewer rows than this are left out.
    LeftOut {
        /// The least number of rows.
        least: usize,
        /// The sets of so many rows whose removal leaves a point, and no others, each with a statement about the
        /// remaining set; `None` when they are not stated.
        sets: Option<Vec<Vec<usize>>>,
        /// The contradictions: for sets of removed rows, the empty one first, half-planes of the other rows that
        /// contradict each other. One of their rows must be left out as well, which leads to the next entry.
        contradictions: Vec<(Vec<usize>, Vec<Multiple>)>,
    },
}

/// One end of a form's range: its largest value, or with the opposite sign its least one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FormEnd {
    /// The end is attained, and at most two half-planes add up to it.
    At {
        /// The half-planes; they add up to the form, at a lower end to its opposite.
        multiples: Vec<Multiple>,
        /// The point where the end is attained.
        point: [Rational; 2],
    },
    /// The form goes on without end.
    Beyond {
        /// A point of the set.
        point: [Rational; 2],
        /// A direction that does not leave it, along which the form grows, or for a lower end falls.
        ray: [Rational; 2],
    },
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
        let lower = FormEnd::of_support(&polyhedron.support(&opposite), name)?;
        let upper = FormEnd::of_support(&polyhedron.support(form), name)?;
        Some(Statement { scope, claim: Claim::Form { form: form.clone(), lower, upper } })
    }

    /// States the set of a scope that these half-planes make: the walk around it, or the reason why it is empty.
    pub fn set(scope: Scope, polyhedron: &Polyhedron, name: &impl Fn(usize) -> BoxBound) -> Self {
        let region = polyhedron.region();
        let claim = match (region.certificate(), region.witness()) {
            (None, Some(point)) => Claim::Set {
                point: point.coordinates(),
                vertices: region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect(),
                sides: polyhedron
                    .irredundant_by_angle()
                    .iter()
                    .map(|&index| name(index))
                    .zip(corners(polyhedron))
                    .collect(),
            },
            (certificate, _) => {
                let multipliers = certificate.map(|farkas| farkas.multipliers()).unwrap_or_default();
                Claim::Empty(Multiple::named(multipliers, name))
            }
        };
        Statement { scope, claim }
    }

    /// States that the least bound on all errors, or the least factor on the bounds, is this one.
    pub fn least(scope: Scope, minimax: &Minimax, is_uniform: bool) -> Self {
        let least = minimax.least.clone();
        let errors = if is_uniform { ErrorScale::Within(least) } else { ErrorScale::Times(least) };
        let multiples = minimax.proof.multipliers.iter().map(Multiple::of_bound).collect();
        let claim = Claim::Least { point: minimax.theta.clone(), multiples };
        Statement { scope: Scope { errors, ..scope }, claim }
    }
}

impl Scope {
    /// All rows but these.
    pub fn without(rows: &[usize]) -> Self {
        Scope { without: rows.to_vec(), ..Scope::default() }
    }

    /// These rows alone, which ascend.
    pub fn of_rows(rows: impl IntoIterator<Item = usize>) -> Self {
        let mut ranges: Vec<[usize; 2]> = Vec::new();
        for row in rows {
            match ranges.last_mut() {
                Some([_, last]) if *last + 1 == row => *last = row,
                _ => ranges.push([row, row]),
            }
        }
        Scope { rows: Some(ranges), ..Scope::default() }
    }
}

impl Multiple {
    /// Multiples of a system's inequalities by their names.
    pub fn named(multipliers: &[Multiplier], name: &impl Fn(usize) -> BoxBound) -> Vec<Self> {
        let named = |own: &Multiplier| Multiple { name: name(own.index), times: own.value.clone() };
        multipliers.iter().map(named).collect()
    }

    /// A multiple of the half-plane of a reading or a condition.
    pub fn of_bound((name, times): &(BoundName, Rational)) -> Self {
        Multiple { name: (*name).into(), times: times.clone() }
    }
}

impl FormEnd {
    /// The end where a form is largest; `None` for an empty set.
    pub fn of_support(support: &Support, name: &impl Fn(usize) -> BoxBound) -> Option<Self> {
        match support {
            Support::Empty(_) => None,
            Support::Unbounded(proof) => Some(FormEnd::beyond(proof)),
            Support::Bounded { proof, .. } => Some(FormEnd::at(proof, name)),
        }
    }

    fn at(proof: &BoundProof, name: &impl Fn(usize) -> BoxBound) -> Self {
        let multiples = Multiple::named(&proof.multipliers, name);
        FormEnd::At { multiples, point: proof.attained_at.coordinates() }
    }

    fn beyond(proof: &UnboundedProof) -> Self {
        let ray = [proof.ray.dx(), proof.ray.dy()].map(Rational::from);
        FormEnd::Beyond { point: proof.point.coordinates(), ray }
    }
}
