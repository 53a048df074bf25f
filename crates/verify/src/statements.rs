//! The statements of version 2 (section 9), as they stand in a proof and as they are once they are known to be true.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::Rational;

use crate::found::Extent;
use crate::half_planes::{End, Multiples, end, multiples, names, vector};
use crate::name::{Name, Named};
use crate::plane::Vector;
use crate::scope::{ErrorScale, Scope, Side};
use crate::shape::{NotAProof, Number, StatementShape, needed};

/// A statement about the set of a scope.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// The half-planes that make the set.
    pub scope: Scope,
    /// The content of the statement.
    pub kind: ClaimKind,
}

/// A claim about a set.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClaimKind {
    /// The range of a form f·θ in the set; an end is `None` where nothing bounds it.
    Form {
        /// f.
        form: [Rational; 2],
        /// The lower and the upper end.
        range: [Option<Rational>; 2],
    },
    /// A point is in it.
    Point([Rational; 2]),
    /// Nothing is.
    Empty,
    /// Smaller errors than those of the scope would leave no point.
    Least,
    /// All of it is known.
    Set {
        /// The extent of the set.
        extent: Extent,
        /// The number of vertices it has.
        vertices: usize,
        /// The number of sides.
        sides: usize,
    },
    /// Nothing is in it while fewer rows than this are left out.
    LeftOut {
        /// The least number.
        least: u64,
        /// The sets of so many rows whose removal leaves a point, and no others, where they are stated.
        sets: Option<BTreeSet<BTreeSet<u64>>>,
    },
}

/// A statement whose truth is to be checked.
#[derive(Debug, Clone)]
pub(crate) struct Statement {
    pub(crate) scope: Scope,
    pub(crate) kind: Kind,
}

#[derive(Debug, Clone)]
#[allow(clippy::large_enum_variant, reason = "most statements are forms")]
pub(crate) enum Kind {
    Form { form: Vector, ends: [End; 2] },
    Point(Vector),
    Empty(Multiples),
    Least { point: Vector, multiples: Multiples },
    Set { point: Vector, vertices: Vec<Vector>, sides: Vec<(Named, Option<u64>)> },
    LeftOut { least: u64, sets: Option<Vec<Vec<u64>>>, contradictions: Contradictions },
}

/// The half-planes of other rows that contradict each other, for rows that are left out.
pub(crate) type Contradictions = BTreeMap<BTreeSet<u64>, Multiples>;

impl Statement {
    /// Takes the scope and the fields of the kind; there are no others.
    pub(crate) fn read(mut shape: StatementShape) -> Result<Self, NotAProof> {
        let scope = scope(&mut shape)?;
        let fields = &mut shape;
        let kind = match fields.kind.raw() {
            "form" => Kind::Form {
                form: vector(needed(fields.form.take(), "form")?),
                ends: [
                    end(needed(fields.lower.take(), "lower")?),
                    end(needed(fields.upper.take(), "upper")?),
                ],
            },
            "point" => Kind::Point(vector(needed(fields.point.take(), "point")?)),
            "empty" => Kind::Empty(multiples(needed(fields.multipliers.take(), "multipliers")?)),
            "least" => Kind::Least {
                point: vector(needed(fields.point.take(), "point")?),
                multiples: multiples(needed(fields.multipliers.take(), "multipliers")?),
            },
            "set" => Kind::Set {
                point: vector(needed(fields.point.take(), "point")?),
                vertices: needed(fields.vertices.take(), "vertices")?.into_iter().map(vector).collect(),
                sides: needed(fields.sides.take(), "sides")?,
            },
            "left out" => Kind::LeftOut {
                least: needed(fields.least.take(), "least")?,
                sets: fields.sets.take(),
                contradictions: needed(fields.contradictions.take(), "contradictions")?
                    .into_iter()
                    .map(|(rows, terms)| (rows.into_iter().collect(), multiples(terms)))
                    .collect(),
            },
            kind => {
                return Err(NotAProof::new(format_args!(
                    "no kind of statement: {kind:?} (expected \"form\", \"point\", \"empty\", \"least\", \"set\" or \"left out\")"
                )));
            }
        };
        match fields.other_field() {
            Some(field) => {
                let kind = fields.kind.borrowed().quoted();
                Err(NotAProof::new(format_args!("a statement of the kind {kind} has no field {field:?}")))
            }
            None => Ok(Statement { scope, kind }),
        }
    }

    /// The half-planes that it names.
    pub(crate) fn names(&self) -> BTreeSet<Name> {
        match &self.kind {
            Kind::Form { ends: [(lower, ..), (upper, ..)], .. } => {
                names(lower.iter().chain(upper).map(|(name, _)| name))
            }
            Kind::Point(_) => BTreeSet::new(),
            Kind::Empty(own) | Kind::Least { multiples: own, .. } => names(own.iter().map(|(name, _)| name)),
            Kind::Set { sides, .. } => names(sides.iter().map(|(name, _)| name)),
            Kind::LeftOut { contradictions, .. } => {
                names(contradictions.values().flatten().map(|(name, _)| name))
            }
        }
    }

    /// The points that it has in its set, then the rays.
    pub(crate) fn points_and_rays(&self) -> [Vec<&Vector>; 2] {
        match &self.kind {
            Kind::Form { ends: [(_, low, low_ray), (_, high, high_ray)], .. } => {
                let is_one = |ray: &&Vector| !ray.iter().all(Rational::is_zero);
                [vec![low, high], [low_ray, high_ray].into_iter().filter(is_one).collect()]
            }
            Kind::Point(point) | Kind::Least { point, .. } | Kind::Set { point, .. } => {
                [vec![point], Vec::new()]
            }
            Kind::Empty(_) | Kind::LeftOut { .. } => [Vec::new(), Vec::new()],
        }
    }
}

fn scope(shape: &mut StatementShape) -> Result<Scope, NotAProof> {
    let errors = match (shape.factor.take(), shape.epsilon.take()) {
        (None, None) => ErrorScale::AsStated,
        (Some(Number(factor)), None) => ErrorScale::Times(factor),
        (None, Some(Number(bound))) => ErrorScale::Within(bound),
        (Some(_), Some(_)) => return Err(NotAProof::new("\"factor\" and \"epsilon\" exclude each other")),
    };
    let side = match shape.side.take() {
        None => None,
        Some(side) => Some(match side.raw() {
            "+" => Side::Rising,
            "-" => Side::Falling,
            "strong" => Side::Strong,
            side => {
                return Err(NotAProof::new(format_args!(
                    "no side: {side:?} (expected \"+\", \"-\" or \"strong\")"
                )));
            }
        }),
    };
    Ok(Scope {
        rows: shape.rows.take(),
        without: shape.without.take().unwrap_or_default().into_iter().collect(),
        conditions: shape.conditions.take().map(|numbers| numbers.into_iter().collect()),
        errors,
        side,
    })
}
