//! The simplex method as it is seen in the plane: from vertex to vertex along edges on which the objective grows.

use boundfit_exact::Rational;

use crate::program::Row;

/// The steps of the simplex method from one basis to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pivot {
    /// The row of the basis whose boundary is left: its multiplier is negative.
    pub leaving: usize,
    /// The direction in which it is left, along the boundary of the other one, such that its slack grows by 1.
    pub direction: [Rational; 2],
    /// The row that stops the way, and how many times the direction the way is long; `None` where nothing stops it. A length of
    /// 0 is a degenerate pivot: the basis changes and the vertex stays.
    pub stop: Option<(usize, Rational)>,
}

/// Two rows whose boundaries meet in a vertex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Basis {
    /// Both rows; the one that entered last stands where the one that left stood.
    pub rows: [usize; 2],
    /// The vertex.
    pub theta: [Rational; 2],
    /// The objective there.
    pub value: Rational,
    /// The multiples of both rows, in the same order, that add up to the objective. None negative proves the optimum.
    pub multipliers: [Rational; 2],
    /// The step that followed; `None` at the optimum.
    pub pivot: Option<Pivot>,
}

/// Returns the path of the simplex method that maximises `objective·θ` from the vertex of two rows, by Bland's rule
/// (1977). The first row with a negative multiplier leaves, and the first of the rows that stop the way enters. It
/// cannot cycle. The last pivot has no stop where the objective grows without end; `None` where both rows do not meet
/// in a point that satisfies all.
///
/// Exact. Cost: linear in the number of rows per pivot.
///
/// ```
/// use boundfit_lp::{Row, simplex_path};
///
/// let rows = [[-1, 0, 0], [0, -1, 0], [2, 3, 6]].map(|[a1, a2, b]: [i64; 3]| Row { a: [a1.into(), a2.into()], b: b.into() });
/// let path = simplex_path(&rows, &[1.into(), 1.into()], [0, 1]).unwrap();
/// let values: Vec<String> = path.iter().map(|basis| basis.value.to_string()).collect();
/// assert_eq!(values, ["0", "3"]);
/// ```
pub fn simplex_path(rows: &[Row], objective: &[Rational; 2], start: [usize; 2]) -> Option<Vec<Basis>> {
    let mut path = Vec::new();
    let mut basis = basis(rows, objective, start)?;
    if rows.iter().any(|row| row.slack(&basis.theta).is_negative()) {
        return None;
    }
    while let Some(place) = leaving(&basis) {
        let pivot = pivot(rows, &basis, place)?;
        let next = pivot.stop.as_ref().map(|(entering, _)| match place {
            Place::First => [*entering, basis.rows[1]],
            Place::Second => [basis.rows[0], *entering],
        });
        path.push(Basis { pivot: Some(pivot), ..basis });
        // Rows that stop the way are not parallel to it.
        match next {
            Some(next) => basis = self::basis(rows, objective, next)?,
            None => return Some(path),
        }
    }
    path.push(basis);
    Some(path)
}

/// One of the two rows of a basis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    First,
    Second,
}

/// The basis of two rows by Cramer's rule, unless their boundaries are parallel.
fn basis(rows: &[Row], objective: &[Rational; 2], indices: [usize; 2]) -> Option<Basis> {
    let [first, second] = indices;
    let (f, g) = (rows.get(first)?, rows.get(second)?);
    let determinant = minor(&f.a, &g.a);
    let over = |value: Rational| value.checked_div(&determinant);
    let theta = [
        over(minor(&[f.b.clone(), f.a[1].clone()], &[g.b.clone(), g.a[1].clone()]))?,
        over(minor(&[f.a[0].clone(), f.b.clone()], &[g.a[0].clone(), g.b.clone()]))?,
    ];
    let multipliers = [over(minor(objective, &g.a))?, over(minor(&f.a, objective))?];
    let value = dot(objective, &theta);
    Some(Basis { rows: indices, theta, value, multipliers, pivot: None })
}

/// The first of the rows with a negative multiplier.
fn leaving(basis: &Basis) -> Option<Place> {
    let [first, second] = &basis.rows;
    match basis.multipliers.each_ref().map(Rational::is_negative) {
        [false, false] => None,
        [true, false] => Some(Place::First),
        [false, true] => Some(Place::Second),
        [true, true] => Some(if first < second { Place::First } else { Place::Second }),
    }
}

/// The way along the boundary of the row that stays, and where it ends.
fn pivot(rows: &[Row], basis: &Basis, place: Place) -> Option<Pivot> {
    let [first, second] = basis.rows;
    let (leaving, staying) = if place == Place::First { (first, second) } else { (second, first) };
    let (gone, kept) = (rows.get(leaving)?, rows.get(staying)?);
    // Along the boundary of the row that stays: a·d = 0 for it, and -1 for the one that is left.
    let along = [-&kept.a[1], kept.a[0].clone()];
    let speed = -dot(&gone.a, &along);
    let [first, second] = along;
    let direction = [first.checked_div(&speed)?, second.checked_div(&speed)?];
    let mut stop: Option<(usize, Rational)> = None;
    for (index, row) in rows.iter().enumerate() {
        let approach = dot(&row.a, &direction);
        let Some(length) = row.slack(&basis.theta).checked_div(&approach).filter(|_| approach.is_positive())
        else {
            continue;
        };
        if stop.as_ref().is_none_or(|(_, least)| length < *least) {
            stop = Some((index, length));
        }
    }
    Some(Pivot { leaving, direction, stop })
}

fn dot(u: &[Rational; 2], v: &[Rational; 2]) -> Rational {
    &u[0] * &v[0] + &u[1] * &v[1]
}

fn minor(u: &[Rational; 2], v: &[Rational; 2]) -> Rational {
    &u[0] * &v[1] - &u[1] * &v[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(rows: &[[i64; 3]]) -> Vec<Row> {
        rows.iter().map(|&[a1, a2, b]| Row { a: [a1.into(), a2.into()], b: b.into() }).collect()
    }

    fn path(rows: &[Row], objective: [i64; 2], start: [usize; 2]) -> Option<Vec<Basis>> {
        simplex_path(rows, &objective.map(Rational::from), start)
    }

    #[test]
    fn it_stays_in_a_degenerate_vertex_until_the_basis_shows_the_way() {
        // y ≥ 0 only touches the corner of x ≥ 0 and x ≤ y: the way along it has length 0.
        let rows = rows(&[[-1, 0, 0], [0, -1, 0], [1, -1, 0], [1, 0, 4]]);
        let path = path(&rows, [1, 0], [0, 1]).unwrap();
        let bases: Vec<[usize; 2]> = path.iter().map(|basis| basis.rows).collect();
        let length = |basis: &Basis| Some(basis.pivot.as_ref()?.stop.as_ref()?.1.to_string());
        let lengths: Vec<String> = path.iter().filter_map(length).collect();
        assert_eq!(bases, [[0, 1], [2, 1], [2, 3]]);
        assert_eq!(lengths, ["0", "4"]);
    }

    #[test]
    fn where_nothing_stops_the_way_it_is_the_last() {
        let quadrant = rows(&[[-1, 0, 0], [0, -1, 0]]);
        let path = path(&quadrant, [1, 0], [0, 1]).unwrap();
        let pivot = path.last().unwrap().pivot.clone().unwrap();
        assert_eq!((path.len(), pivot.stop), (1, None));
        assert_eq!(pivot.direction, [1, 0].map(Rational::from));
    }

    #[test]
    fn two_rows_that_do_not_meet_in_the_set_are_no_start() {
        let rows = rows(&[[-1, 0, 0], [0, -1, 0], [1, 1, -1], [-2, 0, 5]]);
        for start in [[0, 1], [0, 3], [0, 0], [0, 4]] {
            assert_eq!(path(&rows, [1, 0], start), None, "{start:?}");
        }
    }
}
