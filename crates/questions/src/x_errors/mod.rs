//! Errors in x: the lines that agree with readings of which both coordinates are known up to a bound only.
//!
//! The errors obey |error of x_i| ≤ δ_i and |error of y_i| ≤ ε_i. A line agrees *weakly* with a reading when it meets
//! its box x_i ± δ_i, y_i ± ε_i, that is |y_i - θ1·x_i - θ2| ≤ ε_i + |θ1|·δ_i. It agrees *strongly* when it passes
//! between the lower and the upper side of the box all along: |y_i - θ1·x_i - θ2| ≤ ε_i - |θ1|·δ_i. Weak agreement
//! with all readings has two convex sets: one of lines that do not fall, θ1 ≥ 0, and one of lines that do not rise.
//! Strong agreement has one convex set. Sources: Cerone, "Feasible parameter set for linear models with bounded
//! errors in all variables", *Automatica* 29, 1993, and Shary's united and tolerable solution sets of interval
//! systems.

mod deciding;
mod demands;
mod factor;
mod half_planes;
mod row;
mod rows;

use boundfit_estimation::{
    BoundName, Central, Measurement, Model, ParameterBound, ParameterInterval, Problem, Ties, central_of,
    parameter_intervals,
};
use boundfit_exact::{Endpoint, Foreign, Interval, Rational};
use boundfit_geometry::{Farkas, Multiplier, Polyhedron, ProofError, System, envelope};
use thiserror::Error;

pub use demands::{Demand, SlopeDemand};
pub use factor::{LeastFactor, NoLeastFactor};
pub use half_planes::{BoxBound, Corner, Side};

/// The bounds on the errors of x.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum XBounds {
    /// One for all readings; not negative.
    Uniform(Rational),
    /// One for each reading, from a column of this name; none is negative.
    PerRow {
        /// The column.
        column: Foreign,
        /// The bounds in the order of the readings in memory.
        bounds: Vec<Rational>,
    },
}

/// The lines that agree with a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Agreement {
    /// Lines that agree with some x and y within the bounds: they meet the box of the reading.
    Weak,
    /// Lines that agree, for every x within its bounds, with some y within its own.
    Strong,
}

/// Readings with bounds on the errors of both coordinates, and which lines agree with them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct XErrorProblem {
    problem: Problem,
    bounds: XBounds,
    agreement: Agreement,
}

/// The reason why readings cannot have errors in x.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NoXErrors {
    /// The model has two regressors.
    #[error("errors in x are about a line: of two regressors it is not known how their errors go together")]
    TwoRegressors,
    /// Memory does not hold every reading that may decide.
    #[error(
        "with errors in x every reading has to be in memory, or every one on a hull under bounds that all have"
    )]
    NotAll,
    /// The number of bounds differs from the number of readings.
    #[error("{bounds} bounds for {readings} readings")]
    Count {
        /// The number of bounds.
        bounds: usize,
        /// The number of readings.
        readings: usize,
    },
    /// A bound is negative.
    #[error("a bound on an error in x is negative")]
    Negative,
}

/// The lines of one side that agree with all readings.
#[derive(Debug, Clone)]
pub struct SideSet {
    /// The side of the lines in this set.
    pub side: Side,
    /// The half-planes with their intersection.
    pub polyhedron: Polyhedron,
    /// The name of each half-plane, in order.
    pub names: Vec<BoxBound>,
    /// The parameter uncertainty intervals with their proofs; `None` when the set is empty.
    pub pui: Option<[ParameterInterval; 2]>,
    /// The positions of the half-planes that make the set empty: those of the readings that ask for the largest
    /// factor, where these alone leave nothing.
    reason: Vec<usize>,
    /// The readings that the readings with these half-planes stand for.
    ties: Ties,
}

/// The role of the line at an end of the slopes of a set of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SlopeEnd {
    /// All slopes have one sign, and its own is the farthest from 0.
    Steepest,
    /// All slopes have one sign, and its own is the nearest to 0.
    Shallowest,
    /// The set has no other slope.
    Only,
    /// The set has falling lines too, and no line rises more.
    RisesMost,
    /// The set has rising lines too, and no line falls more.
    FallsMost,
}

/// The answer about lines under errors in x.
#[derive(Debug, Clone)]
pub struct XErrorFit {
    /// The sets of lines. Weak agreement has the lines that do not fall and then those that do not rise. Strong
    /// agreement, and readings without errors in x, have one set.
    pub sides: Vec<SideSet>,
    /// The middle of the box of all sets together; `None` unless it is bounded.
    pub central: Option<Central>,
    /// The least factor on all bounds that leaves anything.
    pub least: Result<LeastFactor, NoLeastFactor>,
}

impl SlopeEnd {
    /// Returns the roles of the lines at the two ends of these slopes, each with whether it is at the upper end;
    /// nothing where there is neither end.
    pub fn of(slopes: &Interval) -> Vec<(SlopeEnd, bool)> {
        let zero = Rational::zero();
        match (slopes.lower().value(), slopes.upper().value()) {
            (None, None) => Vec::new(),
            (Some(lower), Some(upper)) if lower == upper => vec![(SlopeEnd::Only, true)],
            (Some(lower), _) if *lower >= zero => {
                vec![(SlopeEnd::Steepest, true), (SlopeEnd::Shallowest, false)]
            }
            (_, Some(upper)) if *upper <= zero => {
                vec![(SlopeEnd::Steepest, false), (SlopeEnd::Shallowest, true)]
            }
            _ => vec![(SlopeEnd::RisesMost, true), (SlopeEnd::FallsMost, false)],
        }
    }
}

impl XBounds {
    /// The bound of the reading at a position.
    ///
    /// # Panics
    /// When there is no bound for it.
    pub fn of(&self, position: usize) -> &Rational {
        match self {
            XBounds::Uniform(bound) => bound,
            XBounds::PerRow { bounds, .. } => &bounds[position],
        }
    }

    /// Every bound that is given.
    pub fn all(&self) -> &[Rational] {
        match self {
            XBounds::Uniform(bound) => std::slice::from_ref(bound),
            XBounds::PerRow { bounds, .. } => bounds,
        }
    }

    /// Returns whether every x is exact.
    pub fn are_zero(&self) -> bool {
        self.all().iter().all(Rational::is_zero)
    }
}

impl XErrorProblem {
    /// Readings of a line with bounds on the errors of x. All are in memory, or those on the hulls where all have the same
    /// bounds: the others decide nothing.
    ///
    /// # Errors
    /// Why there is no such problem.
    pub fn new(problem: Problem, bounds: XBounds, agreement: Agreement) -> Result<Self, NoXErrors> {
        if matches!(problem.measurements.model(), Model::TwoRegressors { .. }) {
            return Err(NoXErrors::TwoRegressors);
        }
        let (measurements, readings) = (&problem.measurements, problem.measurements.kept().len());
        match &bounds {
            // Bounds that all have move both hulls as they are.
            XBounds::Uniform(_) if !measurements.has_every_hull() => Err(NoXErrors::NotAll),
            XBounds::PerRow { .. } if measurements.every().is_none() => Err(NoXErrors::NotAll),
            XBounds::PerRow { bounds, .. } if bounds.len() != readings => {
                Err(NoXErrors::Count { bounds: bounds.len(), readings })
            }
            _ if bounds.all().iter().any(Rational::is_negative) => Err(NoXErrors::Negative),
            _ => Ok(XErrorProblem { problem, bounds, agreement }),
        }
    }

    /// The readings and conditions, as they are without errors in x.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The bounds on the errors of x.
    pub fn bounds(&self) -> &XBounds {
        &self.bounds
    }

    /// Returns the lines that agree with a reading.
    pub fn agreement(&self) -> Agreement {
        self.agreement
    }

    /// The readings in memory, each with the bound on the error of its x.
    pub fn readings(&self) -> impl Iterator<Item = (&Measurement, &Rational)> {
        let rows = self.problem.measurements.kept();
        rows.iter().enumerate().map(|(position, row)| (row, self.bounds.of(position)))
    }

    /// The sides that have a set of their own.
    pub fn sides(&self) -> Vec<Side> {
        match self.agreement {
            Agreement::Weak if !self.bounds.are_zero() => vec![Side::Rising, Side::Falling],
            _ => vec![Side::Both],
        }
    }

    /// Computes everything. Exact. Cost: O(n log n) for the sets and the rows that decide at some factor, which alone each of the few
    /// steps to the least factor looks at.
    pub fn fit(&self) -> XErrorFit {
        let mut sides: Vec<SideSet> = self.sides().into_iter().map(|side| SideSet::new(self, side)).collect();
        let central = union_box(&sides).and_then(|own| central_of(&own));
        let factors = LeastFactor::of_sides(self);
        for set in sides.iter_mut().filter(|set| set.is_empty()) {
            let known = factors.iter().flatten().flatten();
            let own = known.filter(|own| set.side == Side::Both || set.side == own.side);
            let deciding: Vec<BoundName> = own.flat_map(|own| own.fixed_by.clone()).collect();
            set.explain_by(&deciding);
        }
        let [rising, falling] = factors;
        let least = rising.and_then(|rising| LeastFactor::best(rising, falling?));
        XErrorFit { sides, central, least }
    }
}

impl SideSet {
    /// The lines of one side that agree with all readings and meet all conditions. Exact. Cost: O(n log n).
    pub fn new(problem: &XErrorProblem, side: Side) -> Self {
        let (names, inequalities): (Vec<BoxBound>, Vec<_>) = half_planes::of_side(problem, side).unzip();
        let polyhedron = Polyhedron::intersect(inequalities.into_iter().collect());
        let pui = parameter_intervals(&polyhedron);
        let reason = (0..names.len()).collect();
        let ties = problem.problem().measurements.ties().cloned().unwrap_or_default();
        SideSet { side, polyhedron, names, pui, reason, ties }
    }

    /// Returns the bounds that are active where these half-planes are, those of equal readings included: at most so
    /// many by name, sorted, and the number of the others.
    ///
    /// # Panics
    /// When a position is out of range.
    pub fn active(&self, indices: &[usize], most: usize) -> (Vec<BoxBound>, usize) {
        let mut own: Vec<BoxBound> = indices.iter().map(|&index| self.names[index]).collect();
        own.sort_unstable();
        own.dedup();
        let (mut names, mut count) = (Vec::new(), 0);
        for bound in own {
            let row = bound.row();
            count += row.map_or(1, |row| self.ties.count(row));
            match row {
                Some(row) => names.extend(self.ties.rows(row).take(most).map(|row| bound.of_row(row))),
                None => names.push(bound),
            }
        }
        names.sort_unstable();
        names.truncate(most);
        let more = count - names.len();
        (names, more)
    }

    /// Takes the bounds of these readings and conditions for the reason of emptiness, if they are one.
    fn explain_by(&mut self, deciding: &[BoundName]) {
        let is_deciding = |index: &usize| match self.names[*index] {
            BoxBound::Bound(name, _) => deciding.contains(&name),
            BoxBound::Slope(_) => true,
        };
        let own: Vec<usize> = (0..self.names.len()).filter(is_deciding).collect();
        let inequalities = self.polyhedron.system().inequalities();
        let system = own.iter().map(|&index| inequalities[index].clone()).collect();
        if envelope::intersect(&system).is_empty() {
            self.reason = own;
        }
    }

    /// Returns, for an empty set, at most three of its half-planes whose positive multiples add up to `0 ≤ negative`.
    /// Exact.
    pub fn farkas(&self) -> Option<Vec<Multiplier>> {
        self.polyhedron.region().certificate()?;
        let inequalities = self.polyhedron.system().inequalities();
        let system: System = self.reason.iter().map(|&index| inequalities[index].clone()).collect();
        let region = envelope::intersect(&system);
        let multipliers = region.certificate()?.multipliers().iter();
        let own = |own: &Multiplier| Multiplier { index: self.reason[own.index], value: own.value.clone() };
        Some(multipliers.map(own).collect())
    }

    /// Returns whether no line of this side agrees.
    pub fn is_empty(&self) -> bool {
        self.polyhedron.region().is_empty()
    }

    /// Returns whether the set has lines with θ1 = 0 only, which the set of the other side has as well.
    pub fn is_level_only(&self) -> bool {
        let level = Interval::around(&Rational::zero(), &Rational::zero());
        self.side != Side::Both && self.slopes().is_some_and(|slopes| Some(slopes) == level)
    }

    /// Returns whether lines with θ1 = 0 are among them.
    fn reaches_level(&self) -> bool {
        self.slopes().is_some_and(|slopes| slopes.contains(&Rational::zero()))
    }

    /// The PUI of θ1; `None` when the set is empty.
    fn slopes(&self) -> Option<Interval> {
        self.pui.as_ref().map(|[slopes, _]| slopes.interval())
    }

    /// Recomputes every proof of the set. Exact.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self) -> Result<(), ProofError> {
        let system = self.polyhedron.system();
        if let Some(multipliers) = self.farkas() {
            Farkas::new(multipliers).verify(system)?;
        }
        for interval in self.pui.iter().flatten() {
            for end in [&interval.lower, &interval.upper] {
                match end {
                    ParameterBound::Bounded { proof, .. } => proof.verify(system)?,
                    ParameterBound::Unbounded(proof) => proof.verify(system)?,
                }
            }
        }
        Ok(())
    }
}

impl XErrorFit {
    /// Returns whether no line agrees.
    pub fn is_empty(&self) -> bool {
        self.sides.iter().all(SideSet::is_empty)
    }

    /// The sets that make up all of it: those that are not empty, without one that another one contains.
    pub fn pieces(&self) -> Vec<&SideSet> {
        let own: Vec<&SideSet> = self.sides.iter().filter(|side| !side.is_empty()).collect();
        match own.as_slice() {
            // Both have the same level lines.
            [one, other] if one.is_level_only() => vec![other],
            [one, other] if other.is_level_only() => vec![one],
            _ => own,
        }
    }

    /// Returns whether two pieces have the lines with θ1 = 0 in common; `None` unless there are two.
    pub fn are_joined(&self) -> Option<bool> {
        match self.pieces().as_slice() {
            [one, _] => Some(one.reaches_level()),
            _ => None,
        }
    }

    /// The parameter uncertainty intervals of all pieces together; `None` when there is none.
    pub fn pui(&self) -> Option<[Interval; 2]> {
        union_box(&self.sides)
    }

    /// The piece in which a parameter, 0 or 1, reaches an end of its interval, with the proof; the first of several. `None` when
    /// there is no piece.
    pub fn end(&self, axis: usize, is_upper: bool) -> Option<(&SideSet, &ParameterBound)> {
        let pieces = self.pieces();
        let ends = pieces.into_iter().filter_map(|side| {
            let ParameterInterval { lower, upper } = &side.pui.as_ref()?[axis];
            Some((side, if is_upper { upper } else { lower }))
        });
        ends.reduce(|best, next| {
            let is_beyond = match (best.1.endpoint(), next.1.endpoint()) {
                (Endpoint::Unbounded, _) => false,
                (_, Endpoint::Unbounded) => true,
                (Endpoint::Finite(best), Endpoint::Finite(next)) if is_upper => next > best,
                (Endpoint::Finite(best), Endpoint::Finite(next)) => next < best,
            };
            if is_beyond { next } else { best }
        })
    }

    /// Returns whether a line agrees with all readings and meets all conditions. Exact. Cost: linear.
    pub fn contains(&self, theta: &[Rational; 2]) -> bool {
        self.sides.iter().any(|side| side.polyhedron.membership(theta).is_inside())
    }
}

/// The smallest box around sets; `None` when all are empty.
fn union_box(sides: &[SideSet]) -> Option<[Interval; 2]> {
    let boxes: Vec<[Interval; 2]> = sides
        .iter()
        .filter_map(|side| Some(side.pui.as_ref()?.each_ref().map(ParameterInterval::interval)))
        .collect();
    let union = |axis: usize| {
        let end = |of: &dyn Fn(&Interval) -> Endpoint, is_beyond: &dyn Fn(&Rational, &Rational) -> bool| {
            boxes.iter().map(|own| of(&own[axis])).reduce(|best, next| match (best, next) {
                (Endpoint::Finite(best), Endpoint::Finite(next)) => {
                    Endpoint::Finite(if is_beyond(&next, &best) { next } else { best })
                }
                _ => Endpoint::Unbounded,
            })
        };
        let lower = end(&|own| own.lower().clone(), &|next, best| next < best)?;
        let upper = end(&|own| own.upper().clone(), &|next, best| next > best)?;
        Interval::new(lower, upper)
    };
    Some([union(0)?, union(1)?])
}
