//! Statuses and repair by their definitions: a set for each question, by trying every pair of half-planes, in `i128`.
//! It shares no code with the engine; numbers must stay small.

use boundfit_exact::Rational;

use crate::oracle::{Row, solve};

/// lower ≤ φ·θ ≤ upper, as far as there are bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reading {
    /// φ.
    pub regressor: [i128; 2],
    /// The lower bound.
    pub lower: Option<i128>,
    /// The upper bound.
    pub upper: Option<i128>,
}

/// Leverage, residual and the name of the status.
pub type Standing = (Option<Rational>, Option<Rational>, &'static str);

impl Reading {
    /// Returns the half-planes of the set.
    pub fn rows(&self) -> impl Iterator<Item = Row> {
        let [u, v] = self.regressor;
        let upper = self.upper.map(|upper| [u, v, upper]);
        upper.into_iter().chain(self.lower.map(|lower| [-u, -v, -lower]))
    }
}

fn fraction(numerator: i128, denominator: i128) -> Rational {
    let whole = |number: i128| i64::try_from(number).expect("small numbers");
    Rational::ratio(whole(numerator), whole(denominator))
}

/// The largest value of a form over a set that is not empty; `None` where there is none. By duality it is the least right-hand
/// side of a combination of at most two rows that adds up to the form.
pub fn most(rows: &[Row], form: [i128; 2]) -> Option<Rational> {
    let [u, v] = form;
    if form == [0, 0] {
        return Some(Rational::zero());
    }
    let mut least: Option<Rational> = None;
    let mut take = |value: Rational| {
        if least.as_ref().is_none_or(|least| value < *least) {
            least = Some(value);
        }
    };
    for [a, b, c] in rows {
        let along = a * u + b * v;
        if a * v == b * u && along > 0 {
            take(fraction(c * (u * u + v * v), along));
        }
        for [d, e, f] in rows {
            let determinant = a * e - b * d;
            let (s, t) = (u * e - v * d, a * v - b * u);
            if determinant != 0 && s * determinant >= 0 && t * determinant >= 0 {
                take(fraction(c * s + f * t, determinant));
            }
        }
    }
    least
}

/// A reading against the set of some rows; `None` when that is empty.
pub fn standing(reading: &Reading, rows: &[Row]) -> Option<Standing> {
    if solve(rows).kind == "empty" {
        return None;
    }
    let [u, v] = reading.regressor;
    let (most, least) = (most(rows, [u, v]), most(rows, [-u, -v]).map(|least| -least));
    let (lower, upper) = (reading.lower.map(whole), reading.upper.map(whole));
    let one = Rational::one();
    if let (Some(most), Some(least), Some(lower), Some(upper)) = (&most, &least, &lower, &upper)
        && upper > lower
    {
        let over = |number: Rational| number.checked_div(&(upper - lower)).expect("a width");
        let (leverage, residual) = (over(most - least), over(lower + upper - most - least));
        let far = residual.abs();
        let status = if far > &one + &leverage {
            "outlier"
        } else if far < &one - &leverage {
            "inner"
        } else if far == &one - &leverage {
            "boundary"
        } else if leverage > one {
            "strictly outer"
        } else {
            "outer"
        };
        return Some((Some(leverage), Some(residual), status));
    }
    // By what is left of the set, and by the intervals.
    let with: Vec<Row> = rows.iter().copied().chain(reading.rows()).collect();
    let negative = |number: &Option<Rational>| number.as_ref().map(|number| -number);
    let sides = [(upper.clone(), most.clone()), (negative(&lower), negative(&least))];
    let holds = |is_kept: fn(&Rational, &Rational) -> bool| {
        sides.iter().all(|(bound, end)| {
            bound.as_ref().is_none_or(|bound| end.as_ref().is_some_and(|end| is_kept(end, bound)))
        })
    };
    let status = if solve(&with).kind == "empty" {
        "outlier"
    } else if holds(|end, bound| end < bound) {
        "inner"
    } else if holds(|end, bound| end <= bound) {
        "boundary"
    } else if lower.is_none() || upper.is_none() {
        "outer"
    } else {
        // Both bounds: either without a width, or the values go on for ever.
        "strictly outer"
    };
    Some((None, None, status))
}

fn whole(number: i128) -> Rational {
    fraction(number, 1)
}

/// Each reading against the set of all, and against that of the others.
pub fn statuses(readings: &[Reading], conditions: &[Row]) -> Vec<[Option<Standing>; 2]> {
    let rows_but = |left_out: Option<usize>| -> Vec<Row> {
        let kept = readings.iter().enumerate().filter(|(position, _)| Some(*position) != left_out);
        kept.flat_map(|(_, reading)| reading.rows()).chain(conditions.iter().copied()).collect()
    };
    let all = rows_but(None);
    let both = |(position, reading): (usize, &Reading)| {
        [standing(reading, &all), standing(reading, &rows_but(Some(position)))]
    };
    readings.iter().enumerate().map(both).collect()
}

/// The least sum of factors of the readings that have a width, by trying every crossing of two lines; `None` where what holds as it
/// is leaves nothing.
pub fn least_total(readings: &[Reading], conditions: &[Row]) -> Option<Rational> {
    let width = |reading: &Reading| Some(reading.upper? - reading.lower?).filter(|width| *width > 0);
    let (soft, other): (Vec<&Reading>, Vec<&Reading>) = readings.iter().partition(|own| width(own).is_some());
    let hard: Vec<Row> = other.iter().flat_map(|own| own.rows()).chain(conditions.iter().copied()).collect();
    let lines: Vec<Row> = soft.iter().flat_map(|own| own.rows()).chain(hard.iter().copied()).collect();
    let mut points: Vec<[i128; 3]> = vec![[0, 0, 1]];
    for [a, b, c] in &lines {
        points.push([a * c, b * c, a * a + b * b]);
        points.extend(lines.iter().map(|[d, e, f]| [c * e - f * b, a * f - d * c, a * e - b * d]));
    }
    let total = |[x, y, w]: [i128; 3]| -> Rational {
        let factor = |own: &&Reading| {
            let [u, v] = own.regressor;
            let (lower, upper) = (own.lower.expect("a width"), own.upper.expect("a width"));
            fraction((2 * (u * x + v * y) - (lower + upper) * w).abs(), (upper - lower) * w.abs())
        };
        soft.iter().map(|own| factor(own).max(Rational::one())).sum()
    };
    let allowed =
        |[x, y, w]: [i128; 3]| hard.iter().all(|[a, b, c]| (c * w - a * x - b * y) * w.signum() >= 0);
    points.into_iter().filter(|point| point[2] != 0 && allowed(*point)).map(total).min()
}
