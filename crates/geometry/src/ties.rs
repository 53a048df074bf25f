//! The points on a hull that are told as one: those at one place, and those strictly within one edge.
//!
//! The bounds of readings strictly within an edge are active in the same point only: the one that is dual to the
//! edge. They are never corners of a hull of more points, and leave it together. So one of them stands for all, in
//! whatever way points are split, and so does one of several at one place.

use boundfit_exact::Sign;

use crate::hull::{Hull, HullSide, Site};
use crate::tally::Tally;

/// A point that stands for readings.
pub trait Tied: Site {
    /// The readings.
    fn rows(&self) -> &Tally;
    /// The same place with other readings.
    fn with_rows(self, rows: Tally) -> Self;
}

/// Returns the points, sorted by x, then y, that are on the lower or the upper hull, each corner once. The point with
/// the least number stands for all points strictly within an edge. In the same order; at most so many numbers are
/// listed of each.
///
/// As exact as `orientation`. It depends on the points alone, so that parts can be reduced first. Cost: linear.
pub fn touching_as_one<P: Tied>(
    sorted: Vec<P>,
    orientation: impl Fn(&P, &P, &P) -> Sign,
    most: usize,
) -> Vec<P> {
    touching(sorted, orientation, most, true)
}

/// [`touching_as_one`] with each of the points strictly within an edge.
pub fn touching_each<P: Tied>(
    sorted: Vec<P>,
    orientation: impl Fn(&P, &P, &P) -> Sign,
    most: usize,
) -> Vec<P> {
    touching(sorted, orientation, most, false)
}

fn touching<P: Tied>(
    sorted: Vec<P>,
    orientation: impl Fn(&P, &P, &P) -> Sign,
    most: usize,
    edges_as_one: bool,
) -> Vec<P> {
    let points = at_one_place(sorted, most);
    // Who stands for each point: itself, another one, or none.
    let mut speaker: Vec<Option<usize>> = Vec::new();
    for side in [HullSide::Lower, HullSide::Upper] {
        let hull = Hull::new(side, &points, &orientation);
        // All points are corners, as those of a smooth curve: the other hull has only their ends.
        if hull.corners().count() == points.len() {
            return points;
        }
        speaker.resize(points.len(), None);
        for edge in hull.corners_and_edges() {
            let first = edge.clone().min_by_key(|&position| points[position].rows().first());
            edge.for_each(|position| speaker[position] = if edges_as_one { first } else { Some(position) });
        }
    }
    // No second list where each point stands for itself, as on a smooth curve.
    if speaker.iter().enumerate().all(|(position, speaker)| *speaker == Some(position)) {
        return points;
    }
    let mut kept: Vec<Option<P>> = Vec::with_capacity(points.len());
    let mut others: Vec<(usize, Tally)> = Vec::new();
    for (position, (point, speaker)) in points.into_iter().zip(speaker).enumerate() {
        match speaker {
            Some(speaker) if speaker != position => {
                others.push((speaker, point.rows().clone()));
                kept.push(None);
            }
            Some(_) => kept.push(Some(point)),
            None => kept.push(None),
        }
    }
    // Each edge is merged at once, so that its rows are sorted once.
    others.sort_by_key(|(speaker, _)| *speaker);
    let mut others = others.into_iter().peekable();
    while let Some((speaker, rows)) = others.next() {
        let mut all = vec![rows];
        while let Some((_, rows)) = others.next_if(|(next, _)| *next == speaker) {
            all.push(rows);
        }
        kept[speaker] = kept[speaker].take().map(|point| with_all(point, all, most));
    }
    kept.into_iter().flatten().collect()
}

/// Neighbours at one place as one point.
fn at_one_place<P: Tied>(sorted: Vec<P>, most: usize) -> Vec<P> {
    if sorted.windows(2).all(|pair| !pair[0].coincides(&pair[1])) {
        return sorted;
    }
    let mut points: Vec<P> = Vec::with_capacity(sorted.len());
    let mut same: Vec<Tally> = Vec::new();
    for point in sorted {
        match points.last() {
            Some(last) if last.coincides(&point) => same.push(point.rows().clone()),
            _ => {
                settle(&mut points, &mut same, most);
                points.push(point);
            }
        }
    }
    settle(&mut points, &mut same, most);
    points
}

/// Gives the last point the readings of those that were at its place.
fn settle<P: Tied>(points: &mut Vec<P>, same: &mut Vec<Tally>, most: usize) {
    if !same.is_empty()
        && let Some(last) = points.pop()
    {
        points.push(with_all(last, std::mem::take(same), most));
    }
}

fn with_all<P: Tied>(point: P, others: Vec<Tally>, most: usize) -> P {
    let all = Tally::merged([point.rows().clone()].into_iter().chain(others), most);
    point.with_rows(all)
}
