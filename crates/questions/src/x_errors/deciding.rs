//! The rows that decide where a line is at some factor.
//!
//! Rows with equal `offset`, `of_y` and `of_x` differ by `slope·t - bound·τ` alone, whatever the factor is. The largest of these decides,
//! and it belongs to a row on the hull of the points (slope, -bound), seen from t ≥ 0, τ ≥ 0. The other rows of a million readings
//! would be looked at in every step for nothing.

use std::cmp::Ordering;

use boundfit_estimation::BoundName;
use boundfit_exact::Sign;

use super::row::Row;

/// The number of rows that are kept before some are left out.
const FEWEST: usize = 1024;

/// A row with its name and its position among all rows.
struct Placed(usize, BoundName, Row);

/// The rows that decide, in their order, with their names; the first of several equal ones. Exact. Cost: O(n log n) comparisons; memory
/// for about twice as many rows as decide.
pub(super) fn of(rows: impl Iterator<Item = (BoundName, Row)>) -> (Vec<BoundName>, Vec<Row>) {
    let mut kept: Vec<Placed> = Vec::new();
    let mut room = FEWEST;
    for (place, (name, row)) in rows.enumerate() {
        kept.push(Placed(place, name, row));
        if kept.len() >= room {
            kept = hulls(kept);
            room = FEWEST.max(2 * kept.len());
        }
    }
    kept = hulls(kept);
    kept.sort_unstable_by_key(|own| own.0);
    kept.into_iter().map(|Placed(_, name, row)| (name, row)).unzip()
}

/// The rows on the hulls of those that move alike.
fn hulls(mut rows: Vec<Placed>) -> Vec<Placed> {
    rows.sort_unstable_by(in_order);
    let mut kept: Vec<Placed> = Vec::new();
    let mut begin = 0;
    for own in rows {
        if kept.last().is_some_and(|last| moves_alike(&last.2, &own.2) != Ordering::Equal) {
            begin = kept.len();
        }
        // Slopes fall from row to row. A row whose bound does not fall with them decides nowhere.
        if kept.len() > begin && kept.last().is_some_and(|last| own.2.bound >= last.2.bound) {
            continue;
        }
        while let Some([before, last]) = kept.get(begin..).and_then(<[Placed]>::last_chunk)
            && !is_beyond(&before.2, &last.2, &own.2)
        {
            kept.pop();
        }
        kept.push(own);
    }
    kept
}

/// Compares rows for sorting: rows that move alike together, then by falling slope, rising bound and place.
fn in_order(one: &Placed, other: &Placed) -> Ordering {
    let (row, next) = (&one.2, &other.2);
    moves_alike(row, next)
        .then_with(|| next.slope.cmp(&row.slope))
        .then_with(|| row.bound.cmp(&next.bound))
        .then(one.0.cmp(&other.0))
}

/// Orders rows by how they move; equal are those whose difference no factor changes.
fn moves_alike(one: &Row, other: &Row) -> Ordering {
    let of_bounds = || one.of_y.cmp(&other.of_y).then_with(|| one.of_x.cmp(&other.of_x));
    one.offset.cmp(&other.offset).then_with(of_bounds)
}

/// Returns whether the middle one of three rows, in their order, lies beyond the line through the other two.
fn is_beyond(first: &Row, middle: &Row, last: &Row) -> bool {
    let [along, up] = [&first.slope - &middle.slope, &first.bound - &middle.bound];
    let [further, higher] = [&middle.slope - &last.slope, &middle.bound - &last.bound];
    (up * further - higher * along).sign() == Sign::Positive
}
