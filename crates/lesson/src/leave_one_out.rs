//! The set without each of the readings.

use std::ops::Range;

use boundfit_estimation::{Fit, Problem, bounds_of_reading};
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{LeavingOut, Region};
use boundfit_lp::End;
use boundfit_report::{Number, RangeJson, Style};
use serde::Serialize;

use crate::half_planes::irredundant;
use crate::number::STYLE;
use crate::points::Points;
use crate::region::{IndexedRegion, same_set};

/// The remaining set without one reading.
#[derive(Debug)]
pub(crate) struct Without {
    /// The reading.
    pub(crate) row: usize,
    /// `true` if the set is another one than with it.
    pub(crate) matters: bool,
    /// The set.
    pub(crate) region: Region,
    /// The half-planes of the whole system that are not among those by which the set counts.
    lacking: Range<usize>,
    /// The parameter uncertainty intervals; `None` when the set is empty.
    pub(crate) pui: Option<[Interval; 2]>,
    /// The ends of the intervals that move; none when the set with the reading is empty.
    pub(crate) moved: Vec<Moved>,
}

/// An end of an interval that moves outward.
#[derive(Debug)]
pub(crate) struct Moved {
    /// The parameter, from 0.
    pub(crate) axis: usize,
    /// The end of its interval.
    pub(crate) end: End,
    /// The distance and the new end; `None` when nothing stops it.
    pub(crate) by_and_to: Option<(Rational, Rational)>,
}

/// The set without each reading in turn. Exact. Cost: O(N log N), and for each reading the number of vertices; where it has an
/// irredundant half-plane of a set that is no polygon, O(N log N).
pub(crate) fn leave_one_out(problem: &Problem, fit: &Fit) -> Vec<Without> {
    let rows = problem.measurements.kept();
    let needed = irredundant(problem, fit);
    let whole = fit.fps.polyhedron();
    let (pui, leaving_out) = (whole.bounding_box(), LeavingOut::new(whole));
    let without_one = |position: usize| {
        let bounds = bounds_of_reading(rows, position);
        if needed.iter().any(|index| bounds.contains(index)) {
            return without(fit, &leaving_out, rows[position].row, bounds);
        }
        // The irredundant half-planes are all there, and leave the same.
        Without {
            row: rows[position].row,
            matters: false,
            region: whole.region().clone(),
            lacking: 0..0,
            pui: pui.clone(),
            moved: Vec::new(),
        }
    };
    (0..rows.len()).map(without_one).collect()
}

fn without(fit: &Fit, leaving_out: &LeavingOut, row: usize, bounds: Range<usize>) -> Without {
    let (region, pui) = leaving_out.without(bounds.clone());
    let moved = match (fit.pui_intervals(), &pui) {
        (Some(before), Some(after)) => moved(&before, after),
        _ => Vec::new(),
    };
    let matters = !same_set(&region, fit.fps.polyhedron().region());
    Without { row, matters, region, lacking: bounds, pui, moved }
}

fn moved(before: &[Interval; 2], after: &[Interval; 2]) -> Vec<Moved> {
    let ends = [0, 1].into_iter().flat_map(|axis| [(axis, End::Lower), (axis, End::Upper)]);
    ends.filter_map(|(axis, end)| {
        let of = |interval: &Interval| -> Endpoint {
            if end == End::Lower { interval.lower().clone() } else { interval.upper().clone() }
        };
        let by_and_to = match (of(&before[axis]), of(&after[axis])) {
            (Endpoint::Finite(old), Endpoint::Finite(new)) if old != new => Some(((&new - &old).abs(), new)),
            (Endpoint::Finite(_), Endpoint::Unbounded) => None,
            _ => return None,
        };
        Some(Moved { axis, end, by_and_to })
    })
    .collect()
}

#[derive(Debug, Serialize)]
pub(crate) struct WithoutJson {
    row: usize,
    matters: bool,
    #[serde(flatten)]
    region: IndexedRegion,
    pui: Option<[RangeJson; 2]>,
    moved: Vec<MovedJson>,
}

#[derive(Debug, Serialize)]
struct MovedJson {
    parameter: &'static str,
    end: &'static str,
    by: Option<Number>,
}

/// The sets as JSON. The boundaries of a set are counted in its own system, so they are turned into the whole one's.
pub(crate) fn to_json(all: &[Without], styles: &[Style; 2], points: &mut Points) -> Vec<WithoutJson> {
    let moved = |moved: &Moved| MovedJson {
        parameter: PARAMETERS[moved.axis],
        end: moved.end.name(),
        by: moved.by_and_to.as_ref().map(|(by, _)| STYLE.upper_number(by)),
    };
    all.iter()
        .map(|without| WithoutJson {
            row: without.row,
            matters: without.matters,
            region: IndexedRegion::new(&without.region, points).skipping(without.lacking.clone()),
            pui: without.pui.as_ref().map(|pui| [0, 1].map(|axis| RangeJson::new(&pui[axis], &styles[axis]))),
            moved: without.moved.iter().map(moved).collect(),
        })
        .collect()
}

/// The names of the parameters in the data.
pub(crate) const PARAMETERS: [&str; 2] = ["theta1", "theta2"];
