//! The oracle of outliers, by definitions: every crossing of two boundaries is tried, and the plane is cut into columns at all of
//! them. It shares no code with the engine; numbers are fractions.

use std::collections::BTreeSet;

use boundfit_exact::Rational;

/// The statement of a reading: lower ≤ a1·θ1 + a2·θ2 ≤ upper, as far as the bounds exist.
#[derive(Debug, Clone)]
pub struct Strip {
    /// a1 and a2.
    pub a: [i64; 2],
    /// The lower bound.
    pub lower: Option<i64>,
    /// The upper bound.
    pub upper: Option<i64>,
}

/// Readings, and conditions that nobody may miss.
#[derive(Debug, Clone)]
pub struct Case {
    /// The readings.
    pub rows: Vec<Strip>,
    /// The conditions.
    pub conditions: Vec<Strip>,
}

/// The form of the q-relaxed set.
#[derive(Debug, PartialEq, Eq)]
pub struct Relaxed {
    /// The number of its connected parts.
    pub pieces: usize,
    /// The number of bounded parts of its complement.
    pub holes: usize,
    /// The ends of both ranges.
    pub ranges: Option<[[Option<Rational>; 2]; 2]>,
    /// `None` when it is infinite.
    pub area: Option<Rational>,
}

type Point = [Rational; 2];

fn value(a: [i64; 2], [x, y]: &Point) -> Rational {
    Rational::from(a[0]) * x + Rational::from(a[1]) * y
}

impl Strip {
    fn is_met(&self, point: &Point) -> bool {
        let value = value(self.a, point);
        self.lower.is_none_or(|lower| Rational::from(lower) <= value)
            && self.upper.is_none_or(|upper| value <= Rational::from(upper))
    }

    /// a1, a2, b of its boundaries.
    fn lines(&self) -> Vec<[i64; 3]> {
        let ends = [self.lower, self.upper].into_iter().flatten();
        ends.filter(|_| self.a != [0, 0]).map(|b| [self.a[0], self.a[1], b]).collect()
    }
}

impl Case {
    fn lines(&self) -> Vec<[i64; 3]> {
        self.rows.iter().chain(&self.conditions).flat_map(Strip::lines).collect()
    }

    /// The rows that a point misses; `None` where it misses a condition.
    fn missed(&self, point: &Point) -> Option<BTreeSet<usize>> {
        let allowed = self.conditions.iter().all(|condition| condition.is_met(point));
        let missed = || (0..self.rows.len()).filter(|&row| !self.rows[row].is_met(point)).collect();
        allowed.then(missed)
    }

    /// Crossings of boundaries, a point of each boundary, and the origin: what is left without some rows, if anything, has one of
    /// these.
    fn places(&self) -> Vec<Point> {
        let lines = self.lines();
        let mut places = vec![[Rational::zero(), Rational::zero()]];
        for (index, &[a, b, c]) in lines.iter().enumerate() {
            let square = a * a + b * b;
            places.push([Rational::ratio(a * c, square), Rational::ratio(b * c, square)]);
            for &[d, e, f] in &lines[..index] {
                let weight = a * e - b * d;
                if weight != 0 {
                    places.push([
                        Rational::ratio(c * e - f * b, weight),
                        Rational::ratio(a * f - d * c, weight),
                    ]);
                }
            }
        }
        places
    }

    /// Returns, over all subsets of the rows, the size of the least subset whose removal leaves a point, and all
    /// subsets of that size.
    pub fn least(&self) -> Option<(usize, BTreeSet<Vec<usize>>)> {
        let missed: Vec<u32> = self
            .places()
            .iter()
            .filter_map(|place| self.missed(place))
            .map(|rows| rows.iter().map(|row| 1 << row).sum())
            .collect();
        let leaves = |set: &u32| missed.iter().any(|missed| missed & !set == 0);
        let sets: Vec<u32> = (0..1 << self.rows.len()).filter(leaves).collect();
        let least = sets.iter().map(|set| set.count_ones()).min()?;
        let rows = |set: &u32| (0..self.rows.len()).filter(|row| set & (1 << row) != 0).collect();
        let sets = sets.iter().filter(|set| set.count_ones() == least).map(rows).collect();
        Some((least as usize, sets))
    }
}

/// A vertical line through the plane. It has the places where boundaries cross it, and tells whether each gap and
/// crossing belongs to the set, from the lowest gap to the highest.
struct Column {
    x: Rational,
    heights: Vec<Rational>,
    is_in: Vec<bool>,
}

/// All columns: through every crossing, between any two, and outside of all, so that every other one is at a crossing.
struct Columns {
    columns: Vec<Column>,
    /// a1, a2, b with a2 ≠ 0.
    lines: Vec<[i64; 3]>,
}

fn height([a, b, c]: [i64; 3], x: &Rational) -> Rational {
    (Rational::from(c) - Rational::from(a) * x).checked_div(&Rational::from(b)).unwrap()
}

fn middle(one: &Rational, other: &Rational) -> Rational {
    (one + other).half()
}

/// Points between and outside of numbers, each number in its place.
fn between(numbers: &[Rational]) -> Vec<Rational> {
    let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else { return vec![Rational::zero()] };
    let mut points = vec![first - Rational::one()];
    for pair in numbers.windows(2) {
        points.extend([pair[0].clone(), middle(&pair[0], &pair[1])]);
    }
    points.extend([last.clone(), last + Rational::one()]);
    points
}

impl Columns {
    fn new(case: &Case, most: usize) -> Self {
        let (vertical, lines): (Vec<_>, Vec<_>) = case.lines().into_iter().partition(|line| line[1] == 0);
        let mut crossings: BTreeSet<Rational> =
            vertical.iter().map(|&[a, _, c]| Rational::ratio(c, a)).collect();
        for &[a, b, c] in &lines {
            for &[d, e, f] in &lines {
                if a * e != b * d {
                    crossings.insert(Rational::ratio(c * e - f * b, a * e - b * d));
                }
            }
        }
        let crossings: Vec<Rational> = crossings.into_iter().collect();
        let column = |x: Rational| {
            let heights: BTreeSet<Rational> = lines.iter().map(|&line| height(line, &x)).collect();
            let heights: Vec<Rational> = heights.into_iter().collect();
            let is_in = |y: Rational| case.missed(&[x.clone(), y]).is_some_and(|rows| rows.len() <= most);
            let is_in = between(&heights).into_iter().map(is_in).collect();
            Column { x, heights, is_in }
        };
        Columns { columns: between(&crossings).into_iter().map(column).collect(), lines }
    }

    /// Returns where a part of a column between crossings ends up in a column at one.
    fn beside(&self, from: &Column, to: &Column, part: usize) -> usize {
        let place = |group: usize| {
            let own = self.lines.iter().find(|line| height(**line, &from.x) == from.heights[group]).unwrap();
            to.heights.iter().position(|other| *other == height(*own, &to.x)).unwrap()
        };
        let group = part / 2;
        match part {
            _ if part % 2 == 1 => 2 * place(group) + 1,
            0 => 0,
            _ if group == from.heights.len() => 2 * to.heights.len(),
            _ if place(group - 1) == place(group) => 2 * place(group) + 1,
            _ => 2 * place(group),
        }
    }

    /// Returns how many connected parts those have that belong to the set, or do not; with whether each goes on without end.
    fn parts(&self, belongs: bool) -> Vec<bool> {
        let starts: Vec<usize> = self
            .columns
            .iter()
            .scan(0, |next, column| {
                let start = *next;
                *next += column.is_in.len();
                Some(start)
            })
            .collect();
        let count = starts.last().unwrap() + self.columns.last().unwrap().is_in.len();
        let mut root: Vec<usize> = (0..count).collect();
        fn find(root: &[usize], mut part: usize) -> usize {
            while root[part] != part {
                part = root[part];
            }
            part
        }
        let mut join = |one: usize, other: usize| {
            let (one, other) = (find(&root, one), find(&root, other));
            root[one] = other;
        };
        for (index, column) in self.columns.iter().enumerate() {
            for part in 1..column.is_in.len() {
                if column.is_in[part - 1] == belongs && column.is_in[part] == belongs {
                    join(starts[index] + part - 1, starts[index] + part);
                }
            }
            for other in [index.wrapping_sub(1), index + 1] {
                let Some(to) = self.columns.get(other).filter(|_| index % 2 == 0) else { continue };
                for part in 0..column.is_in.len() {
                    let beside = self.beside(column, to, part);
                    if column.is_in[part] == belongs && to.is_in[beside] == belongs {
                        join(starts[index] + part, starts[other] + beside);
                    }
                }
            }
        }
        let mut endless: Vec<Option<bool>> = vec![None; count];
        for (index, column) in self.columns.iter().enumerate() {
            for part in (0..column.is_in.len()).filter(|&part| column.is_in[part] == belongs) {
                let is_endless = index == 0
                    || index + 1 == self.columns.len()
                    || part == 0
                    || part + 1 == column.is_in.len();
                let own = &mut endless[find(&root, starts[index] + part)];
                *own = Some(own.unwrap_or(false) || is_endless);
            }
        }
        endless.into_iter().flatten().collect()
    }

    fn area(&self) -> Option<Rational> {
        let mut area = Rational::zero();
        for (index, column) in self.columns.iter().enumerate().step_by(2) {
            for part in (0..column.is_in.len()).step_by(2).filter(|&part| column.is_in[part]) {
                let is_inside = index > 0 && index + 1 < self.columns.len();
                let group = part / 2;
                if !is_inside || group == 0 || group == column.heights.len() {
                    return None;
                }
                let width = &self.columns[index + 1].x - &self.columns[index - 1].x;
                area = area + width * (&column.heights[group] - &column.heights[group - 1]);
            }
        }
        Some(area)
    }

    fn ranges(&self) -> Option<[[Option<Rational>; 2]; 2]> {
        let mut values: [Vec<Rational>; 2] = [Vec::new(), Vec::new()];
        let mut endless = [[false; 2]; 2];
        let last = self.columns.len() - 1;
        for (index, column) in self.columns.iter().enumerate() {
            for part in (0..column.is_in.len()).filter(|&part| column.is_in[part]) {
                if index % 2 == 1 {
                    values[0].push(column.x.clone());
                    if part % 2 == 1 {
                        values[1].push(column.heights[part / 2].clone());
                    }
                }
                endless[1][0] |= part == 0;
                endless[1][1] |= part + 1 == column.is_in.len();
                let (below, above) = ((part.wrapping_sub(1)) / 2, part / 2);
                let slope = |group: usize| {
                    let y = column.heights.get(group)?;
                    let [a, b, _] = *self.lines.iter().find(|line| height(**line, &column.x) == *y)?;
                    Some(Rational::ratio(-a, b))
                };
                for (is_edge, to_the_right) in [(index == 0, false), (index == last, true)] {
                    if !is_edge {
                        continue;
                    }
                    endless[0][usize::from(to_the_right)] = true;
                    let lower =
                        if part % 2 == 1 { slope(part / 2) } else { slope(below).filter(|_| part > 0) };
                    let upper = if part % 2 == 1 { slope(part / 2) } else { slope(above) };
                    let falls = |slope: &Rational| {
                        if to_the_right { slope.is_negative() } else { slope.is_positive() }
                    };
                    let rises = |slope: &Rational| falls(&-slope);
                    endless[1][0] |= lower.as_ref().is_some_and(falls);
                    endless[1][1] |= upper.as_ref().is_some_and(rises);
                    for level in [lower, upper].into_iter().flatten().filter(Rational::is_zero) {
                        let _ = level;
                        let group = if part % 2 == 1 { part / 2 } else { above };
                        values[1].extend(column.heights.get(group).cloned().filter(|_| part % 2 == 1));
                    }
                }
            }
        }
        if !self.columns.iter().any(|column| column.is_in.contains(&true)) {
            return None;
        }
        Some([0, 1].map(|axis| {
            let own = &values[axis];
            let ends = [own.iter().min().cloned(), own.iter().max().cloned()];
            let [lower, upper] = ends;
            [lower.filter(|_| !endless[axis][0]), upper.filter(|_| !endless[axis][1])]
        }))
    }
}

/// The set of all points that miss at most so many rows.
pub fn relaxed(case: &Case, most: usize) -> Relaxed {
    let columns = Columns::new(case, most);
    Relaxed {
        pieces: columns.parts(true).len(),
        holes: columns.parts(false).into_iter().filter(|is_endless| !is_endless).count(),
        ranges: columns.ranges(),
        area: columns.area(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(a: [i64; 2], lower: i64, upper: i64) -> Strip {
        Strip { a, lower: Some(lower), upper: Some(upper) }
    }

    #[test]
    fn three_strips_around_a_triangle_leave_a_hole() {
        let rows = vec![strip([0, 1], 0, 1), strip([1, 1], 20, 21), strip([1, -1], -21, -20)];
        let case = Case { rows, conditions: Vec::new() };
        let (least, sets) = case.least().unwrap();
        assert_eq!((least, sets.len()), (1, 3));
        let all = relaxed(&case, 2);
        assert_eq!((all.pieces, all.holes, all.area), (1, 1, None));
        let crossings = relaxed(&case, 1);
        assert_eq!((crossings.pieces, crossings.holes, crossings.area), (3, 0, Some(Rational::ratio(5, 2))));
    }
}
