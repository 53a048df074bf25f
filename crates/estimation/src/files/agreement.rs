//! Whether what a reduction says of all its readings can be true beside the rows that it keeps.

use boundfit_exact::{Column, Rational};
use boundfit_formats::ReductionError;

use super::stated::Stated;
use crate::least_squares::NoLeastSquares;
use crate::meaning::Meaning;
use crate::summary::Sums;

/// What the rows that reductions keep come to. Those of parts add up.
#[derive(Debug)]
pub(super) struct KeptRows {
    count: usize,
    sums: Result<Sums, NoLeastSquares>,
    have_widths: bool,
    /// Whether the second regressor is 1.
    is_line: bool,
    /// Smallest and largest x and y.
    range: Option<[[Rational; 2]; 2]>,
}

impl Default for KeptRows {
    fn default() -> Self {
        KeptRows { count: 0, sums: Ok(Sums::default()), have_widths: false, is_line: false, range: None }
    }
}

impl KeptRows {
    /// Those of one batch, with numbers of this meaning, x as it is.
    pub(super) fn of_columns(meaning: &Meaning, columns: &[Column]) -> Self {
        let count = columns.first().map_or(0, Column::len);
        let ends = |column: &Column| {
            let numbers = || (0..column.len()).map(|row| column.get(row));
            numbers().min().zip(numbers().max()).map(|(least, most)| [least, most])
        };
        let range = match columns {
            [x, y, ..] => ends(x).zip(ends(y)).map(|(x, y)| [x, y]),
            _ => None,
        };
        let (sums, have_widths) = (meaning.sums(columns), meaning.have_widths(columns));
        KeptRows { count, sums, have_widths, is_line: meaning.regressors() == 1, range }
    }

    /// These rows and others.
    pub(super) fn add(&mut self, other: KeptRows) {
        self.count += other.count;
        self.have_widths |= other.have_widths;
        self.is_line |= other.is_line;
        let own = std::mem::replace(&mut self.sums, Err(NoLeastSquares::NoResponse));
        self.sums = own.and_then(|own| Ok(own.merged(&other.sums?)));
        self.range = match (self.range.take(), other.range) {
            (Some(own), Some(other)) => Some(joined(own, other)),
            (own, other) => own.or(other),
        };
    }

    /// Refuses what reductions say, if no readings beside these rows could make it true: fewer readings than rows, sums that are
    /// not those of the rows where nothing was left out, and sums over what was left out that no numbers have. Of a line under one
    /// bound for all readings nothing that was left out lies beyond the rows that are kept.
    ///
    /// # Errors
    /// The first contradiction.
    pub(super) fn check(&self, stated: &Stated) -> Result<(), ReductionError> {
        let refuse = |what| Err(ReductionError::Contradiction { what });
        let Some(left_out) = stated.count.checked_sub(self.count) else {
            return refuse("it keeps more readings than it says there were");
        };
        if self.have_widths && !stated.has_widths {
            return refuse("it says that no reading has two bounds, but one that it keeps has");
        }
        let Ok(all) = &stated.sums else { return Ok(()) };
        let Ok(kept) = &self.sums else {
            return refuse(
                "it has sums for least squares, but a reading that it keeps has nothing to add to them",
            );
        };
        if self.is_line && all.vv != Rational::from(stated.count) {
            return refuse("one of its sums is the number of readings, and another number");
        }
        let rest = Rest { count: left_out, sums: without(all, kept) };
        match left_out {
            0 if rest.is_nothing() => Ok(()),
            0 => refuse("it keeps every reading, but its sums are not those of the rows that follow"),
            _ if !rest.is_possible() => {
                refuse("no readings beside those that it keeps have the sums that are left for them")
            }
            _ if stated.is_hull && !rest.is_within(self.range.as_ref()) => {
                refuse("its sums are those of readings beyond the rows that it keeps, which none can be")
            }
            _ => Ok(()),
        }
    }
}

/// What reductions leave out.
struct Rest {
    count: usize,
    sums: Sums,
}

impl Rest {
    fn is_nothing(&self) -> bool {
        let Sums { uu, uv, vv, uy, vy, .. } = &self.sums;
        [uu, uv, vv, uy, vy].into_iter().all(Rational::is_zero)
    }

    /// Whether some readings have these sums: Σu² and Σv² are not negative and (Σuv)² ≤ Σu²·Σv² (Cauchy and Schwarz); where
    /// these are equal, au + bv is 0 for all readings, and so is a·Σuy + b·Σvy. Nothing else follows, since y may be anything.
    fn is_possible(&self) -> bool {
        let Sums { uu, uv, vv, uy, vy, .. } = &self.sums;
        let determinant = uu * vv - uv * uv;
        if uu.is_negative() || vv.is_negative() || determinant.is_negative() {
            return false;
        }
        if !determinant.is_zero() {
            return true;
        }
        // With a = Σuv and b = -Σu², or with a = Σv² and b = -Σuv, Σ(au + bv)² is 0.
        (uv * uy == uu * vy) && (vv * uy == uv * vy)
    }

    /// Whether readings of a line within these x and y have these sums: no product of distances to two sides is negative.
    fn is_within(&self, range: Option<&[[Rational; 2]; 2]>) -> bool {
        let Some([[x_least, x_most], [y_least, y_most]]) = range else { return true };
        let Sums { uu: xx, uv: x, uy: xy, vy: y, .. } = &self.sums;
        let count = Rational::from(self.count);
        // Σ(x - a)·(y - b).
        let product = |a: &Rational, b: &Rational| xy - a * y - b * x + a * b * &count;
        let is_between = |sum: &Rational, least: &Rational, most: &Rational| {
            &count * least <= *sum && *sum <= &count * most
        };
        let spread = xx - (x_least + x_most) * x + x_least * x_most * &count;
        is_between(x, x_least, x_most)
            && is_between(y, y_least, y_most)
            && !spread.is_positive()
            && !product(x_least, y_least).is_negative()
            && !product(x_most, y_most).is_negative()
            && !product(x_least, y_most).is_positive()
            && !product(x_most, y_least).is_positive()
    }
}

fn without(all: &Sums, kept: &Sums) -> Sums {
    Sums {
        count: all.count.saturating_sub(kept.count),
        uu: &all.uu - &kept.uu,
        uv: &all.uv - &kept.uv,
        vv: &all.vv - &kept.vv,
        uy: &all.uy - &kept.uy,
        vy: &all.vy - &kept.vy,
    }
}

fn joined(own: [[Rational; 2]; 2], other: [[Rational; 2]; 2]) -> [[Rational; 2]; 2] {
    let [own_x, own_y] = own;
    let [x, y] = other;
    let both = |[least, most]: [Rational; 2], [other_least, other_most]: [Rational; 2]| {
        [least.min(other_least), most.max(other_most)]
    };
    [both(own_x, x), both(own_y, y)]
}
