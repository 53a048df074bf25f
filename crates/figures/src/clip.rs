//! Cutting lines and convex areas to the unit square, in which every panel's coordinates run. For drawing only.

/// A point or a vector in fractions of a view.
pub(crate) type Place = [f64; 2];

/// Returns how far along `from + t·direction`, `t` in `[first, last]`, the unit square is entered and left (Liang and
/// Barsky 1984); `None` when it is missed. Also `None` when a coordinate is not a number.
pub(crate) fn crossing(from: Place, direction: Place, first: f64, last: f64) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (first, last);
    for axis in 0..2 {
        let (at, step) = (from[axis], direction[axis]);
        if step == 0.0 {
            if !(0.0..=1.0).contains(&at) {
                return None;
            }
            continue;
        }
        let (near, far) = ((0.0 - at) / step, (1.0 - at) / step);
        enter = enter.max(near.min(far));
        leave = leave.min(near.max(far));
    }
    (enter <= leave).then_some((enter, leave))
}

/// `from + t·direction`.
pub(crate) fn along(from: Place, direction: Place, t: f64) -> Place {
    [from[0] + t * direction[0], from[1] + t * direction[1]]
}

/// [`along`] where the unit square is entered or left. If a step is longer than the square by more digits than a
/// double has, rounding could give any place at all. A line from there would take more dashes than memory holds.
pub(crate) fn cut(from: Place, direction: Place, t: f64) -> Place {
    inside(along(from, direction, t))
}

fn inside(place: Place) -> Place {
    place.map(|coordinate| coordinate.clamp(0.0, 1.0))
}

/// The pieces of a polyline inside the unit square.
pub(crate) fn polyline(points: &[Place]) -> Vec<Vec<Place>> {
    let mut pieces: Vec<Vec<Place>> = Vec::new();
    for pair in points.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let direction = [to[0] - from[0], to[1] - from[1]];
        let Some((enter, leave)) = crossing(from, direction, 0.0, 1.0) else { continue };
        let start = if enter == 0.0 { inside(from) } else { cut(from, direction, enter) };
        let end = if leave == 1.0 { inside(to) } else { cut(from, direction, leave) };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&start) => piece.push(end),
            _ => pieces.push(vec![start, end]),
        }
    }
    pieces
}

/// The part of a convex area where `form·p ≤ bound` (Sutherland and Hodgman 1974).
pub(crate) fn half_plane(area: &[Place], form: Place, bound: f64) -> Vec<Place> {
    let excess = |p: &Place| form[0] * p[0] + form[1] * p[1] - bound;
    let mut kept = Vec::new();
    for (index, point) in area.iter().enumerate() {
        let next = &area[(index + 1) % area.len()];
        let (here, there) = (excess(point), excess(next));
        if here <= 0.0 {
            kept.push(*point);
        }
        if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
            let t = here / (here - there);
            kept.push(along(*point, [next[0] - point[0], next[1] - point[1]], t));
        }
    }
    kept
}

/// The corners of the unit square.
pub(crate) const SQUARE: [Place; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// The part of an area inside the unit square.
pub(crate) fn area(points: &[Place]) -> Vec<Place> {
    let sides = [([-1.0, 0.0], 0.0), ([1.0, 0.0], 1.0), ([0.0, -1.0], 0.0), ([0.0, 1.0], 1.0)];
    sides.iter().fold(points.to_vec(), |area, &(form, bound)| half_plane(&area, form, bound))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_where_they_leave() {
        assert_eq!(crossing([0.5, 0.5], [1.0, 0.0], 0.0, f64::INFINITY), Some((0.0, 0.5)));
        assert_eq!(crossing([-1.0, 0.5], [1.0, 0.0], 0.0, 1.5), Some((1.0, 1.5)));
        assert_eq!(crossing([-1.0, 2.0], [1.0, 0.0], 0.0, 9.0), None);
        let bent = [[-0.5, 0.5], [0.5, 0.5], [0.5, 2.0]];
        assert_eq!(polyline(&bent), vec![vec![[0.0, 0.5], [0.5, 0.5], [0.5, 1.0]]]);
        let twice = [[0.25, -1.0], [0.25, 2.0], [0.75, 2.0], [0.75, -1.0]];
        assert_eq!(polyline(&twice).len(), 2);
        // Steps that hide the square in their last digit leave no place outside it.
        for far in [1e30, 1e200, 1e308] {
            let pieces = polyline(&[[-far, -far / 3.0], [far, far / 7.0], [0.5, 0.5]]);
            assert!(pieces.iter().flatten().flatten().all(|coordinate| (0.0..=1.0).contains(coordinate)));
        }
    }

    #[test]
    fn areas_are_cut_to_the_square() {
        let large = [[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]];
        let mut cut = area(&large);
        cut.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(cut, vec![[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]]);
        assert_eq!(half_plane(&SQUARE, [1.0, 1.0], 1.0), vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert!(area(&[[2.0, 2.0], [3.0, 2.0], [3.0, 3.0]]).is_empty());
    }
}
