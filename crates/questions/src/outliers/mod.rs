//! Outliers: the least number of readings whose removal leaves a parameter that agrees with all others. Lists every
//! set of that many readings that does it, the set that remains, and its growth when more readings may be missed.
//!
//! The *q-relaxed* set has the θ that miss at most q readings and meet all conditions. Source: Lahanier, Walter, Gomeni,
//! "OMNE: a new robust membership-set estimator for the parameters of nonlinear models", *J. Pharmacokinet. Biopharm.* 15
//! (1987), which minimises the number of readings that are missed; Jaulin and Walter, "Guaranteed robust nonlinear minimax
//! estimation", *IEEE Trans. Autom. Control* 47 (2002).
//!
//! At the least q no two sets of what is left have a common point: it would miss only readings that both leave out, and these
//! are fewer than q. So the q-relaxed set is as many convex polygons, apart from each other, as there are minimal sets.

mod growth;
mod kept;
mod lines;
mod near;
mod search;

use std::collections::BTreeSet;

use boundfit_estimation::{
    BoundName, Condition, Fps, Measurement, Measurements, Problem, conditions_by_name, contradiction_among,
    half_planes,
};
use boundfit_exact::{Endpoint, Fraction, Integer, Interval, LongSum, Rational};
use boundfit_geometry::{Boundary, Inequality, LayerOf, Point, RegionKind, Support, Vertex};

pub use growth::Growth;
use kept::Kept;

/// Limits on the search for outliers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutlierLimits {
    /// The number of minimal sets that are listed.
    pub sets: usize,
    /// The largest number of crossings of two boundaries that the search looks at. A million take about a second.
    pub steps: u64,
}

impl Default for OutlierLimits {
    fn default() -> Self {
        OutlierLimits { sets: 1000, steps: 20_000_000 }
    }
}

/// The readings to leave out.
#[derive(Debug, Clone)]
pub struct Outliers {
    /// The least number of readings without which some parameter is left.
    pub least: usize,
    /// The minimal sets of so many, in lexicographic order, each with what is left without it.
    pub pieces: Vec<Piece>,
    /// `true` if these are all of them.
    pub is_complete: bool,
}

/// A minimal set of outliers, and what is left without them.
#[derive(Debug, Clone)]
pub struct Piece {
    /// The data rows that are left out, ascending.
    pub rows: Vec<usize>,
    /// The remaining convex set, from the half-planes that can bound it.
    pub left: Fps,
}

/// The reason why the least number of outliers is not known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoOutliers {
    /// Memory does not hold every reading.
    NotInMemory,
    /// The conditions contradict each other, whatever is left out: at most three of them with multipliers whose sum is
    /// `0 ≤ negative`.
    Conditions(Vec<(BoundName, Rational)>),
    /// The search needs more crossings than the limit.
    Steps {
        /// The number of readings that must be left out at least.
        at_least: usize,
        /// A number that is enough, if known.
        enough: Option<usize>,
        /// The number of crossings that the search would look at.
        needed: u64,
    },
    /// The growth of the set needs more crossings than the limit.
    GrowthSteps {
        /// The number of crossings that the search would look at.
        needed: u64,
    },
    /// The set has more corners than are kept in memory.
    Corners,
}

impl Outliers {
    /// The outliers among the readings of a problem, which must be in memory. Exact.
    ///
    /// Cost: O(n) on machine integers for the box in which the fewest are missed. For rows that no box leaves out, O(n log n +
    /// n·q) for the first q + 1 convex layers, of which alone the answer depends. Then, as long as
    /// there are few, the search tries the sets of a tree. A contradiction of at most three readings needs one of
    /// them left out (Matoušek, "On geometric optimization with few violated constraints", *Discrete Comput. Geom.*
    /// 14, 1995). Where these are more than the crossings of the boundaries of m rows, all crossings are looked
    /// at along every boundary: O(m² log m).
    ///
    /// # Errors
    /// When there is no such number, or it takes more than the limits allow.
    pub fn new(problem: &Problem, limits: &OutlierLimits) -> Result<Self, NoOutliers> {
        let Problem { measurements, conditions } = problem;
        let (rows, ties) = measurements.every().ok_or(NoOutliers::NotInMemory)?;
        if let Some(contradiction) = contradiction_among(conditions_by_name(conditions)) {
            return Err(NoOutliers::Conditions(contradiction));
        }
        Outliers::of_kept(&Kept::near_the_fewest(rows, ties, conditions), problem, limits)
    }

    /// The outliers among the readings that are kept of a problem.
    fn of_kept(kept: &Kept, problem: &Problem, limits: &OutlierLimits) -> Result<Self, NoOutliers> {
        let Problem { measurements, conditions } = problem;
        let found = search::least(kept, limits)?;
        let is_complete = found.is_complete && found.sets.len() <= limits.sets;
        let least = found.least + kept.never.len();
        // Everything whose boundary can touch what is left.
        let near = kept.in_layers(LayerOf::Touching, found.least);
        let piece = |set: &Vec<u32>| {
            let own = near.iter().filter(|&&own| set.binary_search(&own).is_err());
            let rest = own.map(|&own| kept.rows[own as usize].measurement.clone()).collect();
            let left = active_only(measurements, rest, conditions);
            Piece { rows: kept.data_rows(set), left }
        };
        let mut pieces: Vec<Piece> = found.sets.iter().take(limits.sets).map(piece).collect();
        pieces.sort_by(|one, other| one.rows.cmp(&other.rows));
        Ok(Outliers { least, pieces, is_complete })
    }

    /// Returns the ranges of both parameters over all listed pieces. Exact.
    pub fn pui(&self) -> Option<[Interval; 2]> {
        let mut boxes = self.pieces.iter().filter_map(|piece| piece.left.polyhedron().bounding_box());
        let first = boxes.next()?;
        Some(boxes.fold(first, |all, own| [0, 1].map(|axis| hull(&all[axis], &own[axis]))))
    }

    /// The sum of the areas of all pieces listed, which are apart from each other; `None` when it is infinite. Exact.
    pub fn area(&self) -> Option<LongSum> {
        let region = |piece: &Piece| piece.left.polyhedron().region().kind();
        let is_infinite = |kind: RegionKind| {
            matches!(
                kind,
                RegionKind::UnboundedPolygon | RegionKind::Strip | RegionKind::HalfPlane | RegionKind::Plane
            )
        };
        if self.pieces.iter().any(|piece| is_infinite(region(piece))) {
            return None;
        }
        let polygons = self.pieces.iter().filter(|piece| region(piece) == RegionKind::Polygon);
        let edges = polygons.flat_map(|piece| {
            let vertices = piece.left.polyhedron().region().vertices();
            let next = vertices.iter().cycle().skip(1);
            vertices.iter().zip(next).filter_map(|(p, q)| triangle(p.point(), q.point(), false))
        });
        Some(edges.collect())
    }

    /// Returns the growth of the q-relaxed set: for each q from 0 to `most` its number of pieces, its ranges and its
    /// area. Exact. Cost: O(m² log m) for the m rows of the first `most + 1` convex layers; nothing but the pieces
    /// for the least q.
    ///
    /// # Errors
    /// When it takes more than the limits allow.
    pub fn growth(
        &self,
        problem: &Problem,
        most: usize,
        limits: &OutlierLimits,
    ) -> Result<Vec<Growth>, NoOutliers> {
        let Problem { measurements, conditions } = problem;
        let (rows, ties) = measurements.every().ok_or(NoOutliers::NotInMemory)?;
        // More than all readings cannot be left out.
        let most = most.min(measurements.fitted());
        let mut growth: Vec<Growth> = (0..=most.min(self.least)).map(Growth::none).collect();
        if most == self.least && self.is_complete {
            growth[most] = self.as_growth();
        } else if most >= self.least {
            growth.truncate(self.least);
            let kept = Kept::new(rows, ties, conditions);
            growth.extend(growth::of(&kept, self.least, most, limits)?);
        }
        Ok(growth)
    }

    /// Returns the pieces at the least q.
    fn as_growth(&self) -> Growth {
        Growth { most: self.least, pieces: self.pieces.len(), holes: 0, pui: self.pui(), area: self.area() }
    }
}

/// Returns the feasible set of `rows`, built only from the rows that bound it.
fn active_only(measurements: &Measurements, rows: Vec<Measurement>, conditions: &[Condition]) -> Fps {
    let all = Fps::of_every_half_plane(&measurements.of_kept(rows.clone()), conditions);
    let region = all.polyhedron().region();
    let vertices = region.vertices().iter().flat_map(Vertex::active);
    let active = vertices.chain(region.boundaries().iter().flat_map(Boundary::active));
    let named: BTreeSet<usize> = active.filter_map(|&index| all.name(index).row()).collect();
    let rows = rows.into_iter().filter(|row| named.contains(&row.row)).collect();
    Fps::of_every_half_plane(&measurements.of_kept(rows), conditions)
}

/// The smallest interval with two others in it.
fn hull(one: &Interval, other: &Interval) -> Interval {
    let lower = one.lower().value().zip(other.lower().value()).map(|(p, q)| p.min(q).clone());
    let upper = one.upper().value().zip(other.upper().value()).map(|(p, q)| p.max(q).clone());
    Interval::new(lower.into(), upper.into()).unwrap_or_else(|| one.clone())
}

/// The area of the triangle of the origin and two points, seen counter-clockwise, or with the sign turned.
fn triangle(p: &Point, q: &Point, turned: bool) -> Option<Fraction> {
    let ((px, py, pw), (qx, qy, qw)) = (p.homogeneous(), q.homogeneous());
    let doubled = if turned { py * qx - px * qy } else { px * qy - py * qx };
    Fraction::new(doubled, Integer::from(2) * (pw * qw))
}

impl Piece {
    /// Returns the range of amounts, from least to most, by which a removed reading is missed, and the bound that is
    /// missed. Returns `None` for a reading that no parameter meets, and for a reading that is not left out. Exact.
    ///
    /// Nobody in the piece meets a reading that is left out: fewer could be left out otherwise.
    pub fn missed_by(&self, reading: &Measurement) -> Option<(BoundName, Interval)> {
        let reach = |form: &[Rational; 2]| match self.left.polyhedron().support(form) {
            Support::Bounded { proof, .. } => Endpoint::Finite(proof.value),
            Support::Empty(_) | Support::Unbounded(_) => Endpoint::Unbounded,
        };
        half_planes(reading).find_map(|(name, Inequality { a, b })| {
            let opposite = a.each_ref().map(|part| -part);
            let Endpoint::Finite(turned) = reach(&opposite) else { return None };
            let least = -turned - &b;
            let most = reach(&a).value().map(|value| value - &b);
            let by = Interval::new(Endpoint::Finite(least.clone()), most.into())?;
            least.is_positive().then_some((name, by))
        })
    }
}
