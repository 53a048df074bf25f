//! A check of a reduction's statements about all its readings against the rows that it keeps.

use std::collections::HashMap;

use boundfit_exact::{Column, Rational};
use boundfit_formats::{Batch, ReductionError, Reductions};

use super::outline::Outline;
use super::stated::Stated;
use crate::meaning::Meaning;
use crate::moments::Sums;
use crate::reduction::NoLeastSquares;

/// The sums and counts of the rows that reductions keep. Sums of parts add up.
#[derive(Debug)]
pub(super) struct KeptRows {
    count: usize,
    sums: Result<Sums, NoLeastSquares>,
    /// The rows that stand for others, equal ones once, with how many readings beside themselves: a file may have any number of
    /// equal rows.
    counted: HashMap<Numbers, u64>,
    have_widths: bool,
    /// True if the second regressor is 1.
    is_line: bool,
    /// Smallest and largest x and y.
    range: Option<[[Rational; 2]; 2]>,
}

/// The numbers of a row.
#[derive(Debug, PartialEq, Eq, Hash)]
struct Numbers {
    regressor: [Rational; 2],
    y: Rational,
}

impl Numbers {
    /// Returns what so many readings, all equal to this row, come to.
    fn sums(&self, readings: u64) -> Sums {
        let Numbers { regressor: [u, v], y } = self;
        let times = |left: &Rational, right: &Rational| left * right * Rational::from(readings);
        let count = usize::try_from(readings).unwrap_or(usize::MAX);
        Sums { count, uu: times(u, u), uv: times(u, v), vv: times(v, v), uy: times(u, y), vy: times(v, y) }
    }
}

impl Default for KeptRows {
    fn default() -> Self {
        KeptRows {
            count: 0,
            sums: Ok(Sums::default()),
            counted: HashMap::new(),
            have_widths: false,
            is_line: false,
            range: None,
        }
    }
}

impl KeptRows {
    /// Sums and counts the rows of one batch of these reductions, with numbers of this meaning and x as it is.
    pub(super) fn of_batch(meaning: &Meaning, batch: &Batch, reductions: &Reductions) -> Self {
        let columns = batch.columns.as_slice();
        let count = columns.first().map_or(0, Column::len);
        let ends = |column: &Column| {
            let numbers = || (0..column.len()).map(|row| column.get(row));
            numbers().min().zip(numbers().max()).map(|(least, most)| [least, most])
        };
        let range = match columns {
            [x, y, ..] => ends(x).zip(ends(y)).map(|(x, y)| [x, y]),
            _ => None,
        };
        let (sums, have_widths) = (Sums::of_readings(meaning, columns), meaning.have_widths(columns));
        let counted = |(position, others): (usize, u64)| {
            let reading = meaning.of_columns(columns, position, 0);
            let y = match meaning.has_response {
                true => columns.get(meaning.regressors())?.get(position),
                false => reading.value()?.into_owned(),
            };
            Some((Numbers { regressor: reading.regressor, y }, others))
        };
        let rows = (0..count).map(|position| batch.rows.get(position));
        let each = reductions.beside_themselves(rows).into_iter().filter_map(counted);
        let is_line = meaning.regressors() == 1;
        let mut own = KeptRows { count, sums, counted: HashMap::new(), have_widths, is_line, range };
        own.count_others(each);
        own
    }

    /// Counts readings beside rows with these numbers.
    fn count_others(&mut self, others: impl Iterator<Item = (Numbers, u64)>) {
        for (row, others) in others {
            let all = self.counted.entry(row).or_default();
            *all = all.saturating_add(others);
        }
    }

    /// These rows and others.
    pub(super) fn add(&mut self, other: KeptRows) {
        self.count += other.count;
        self.count_others(other.counted.into_iter());
        self.have_widths |= other.have_widths;
        self.is_line |= other.is_line;
        let own = std::mem::replace(&mut self.sums, Err(NoLeastSquares::NoResponse));
        self.sums = own.and_then(|own| Ok(own.merged(&other.sums?)));
        self.range = match (self.range.take(), other.range) {
            (Some(own), Some(other)) => Some(joined(own, other)),
            (own, other) => own.or(other),
        };
    }

    /// Refuses statements of reductions that no readings beside these rows could make true. Such statements have
    /// fewer readings than rows, sums that differ although no reading is missing, or sums of missing readings that no
    /// numbers have. A row stands for readings that equal it. Only a line under one bound for all readings has an
    /// outline, and there rows at its corners stand for equal readings, other rows for readings within an edge.
    /// Readings of such a line that no row counts lie strictly within the outline.
    ///
    /// # Errors
    /// The first contradiction.
    pub(super) fn check(&self, stated: &Stated, outline: Option<&Outline>) -> Result<(), ReductionError> {
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
        let equal = |(row, _): &(&Numbers, &u64)| {
            outline.is_none_or(|outline| outline.has_corner(&row.regressor[0], &row.y))
        };
        let (equal, on_edges): (Vec<_>, Vec<_>) = self.counted.iter().partition(equal);
        let known = equal.into_iter().fold(kept.clone(), |sum, (row, others)| sum.merged(&row.sums(*others)));
        let on_edges = on_edges.into_iter().fold(0_u64, |sum, (_, others)| sum.saturating_add(*others));
        // No row of any part stands for more readings than there were.
        let rest = Rest { count: stated.count.saturating_sub(known.count), sums: without(all, &known) };
        if rest.count == 0 {
            return match (rest.is_nothing(), left_out) {
                (true, _) => Ok(()),
                (false, 0) => {
                    refuse("it keeps every reading, but its sums are not those of the rows that follow")
                }
                (false, _) => refuse(
                    "the rows that follow stand for every reading, but its sums are not those of so many of each",
                ),
            };
        }
        if !rest.is_possible() {
            return refuse("no readings beside those that it keeps have the sums that are left for them");
        }
        let Some(outline) = outline else { return Ok(()) };
        let mean = rest.mean();
        if !outline.has_within(&mean, false) || !rest.is_within(self.range.as_ref()) {
            return refuse("its sums are those of readings beyond the rows that it keeps, which none can be");
        }
        if rest.count as u64 > on_edges && !outline.has_within(&mean, true) {
            return refuse(
                "its sums are those of readings on the hulls of the rows that it keeps, which no row counts",
            );
        }
        Ok(())
    }
}

/// The readings that reductions leave out.
struct Rest {
    count: usize,
    sums: Sums,
}

impl Rest {
    fn is_nothing(&self) -> bool {
        self.sums.parts().into_iter().all(Rational::is_zero)
    }

    /// Returns whether some readings have these sums. Σu² and Σv² must not be negative, and (Σuv)² ≤ Σu²·Σv² (Cauchy
    /// and Schwarz). Where the two sides are equal, au + bv is 0 for all readings, and so is a·Σuy + b·Σvy. Nothing
    /// else follows, since y may be anything.
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

    /// Returns the mean x and the mean y of the readings.
    fn mean(&self) -> [Rational; 2] {
        let Sums { uv: x, vy: y, .. } = &self.sums;
        let count = Rational::from(self.count);
        [x, y].map(|sum| sum.checked_div(&count).unwrap_or_default())
    }

    /// Returns whether readings of a line within these x and y have these sums: no product of distances to two sides is negative.
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

/// The sums over all readings but some.
fn without(all: &Sums, kept: &Sums) -> Sums {
    // A file may claim fewer readings than it keeps: then the sums disagree, too.
    let count = all.count.saturating_sub(kept.count);
    let [own, other] = [all.parts(), kept.parts()];
    Sums::new(count, std::array::from_fn(|part| own[part] - other[part]))
}

fn joined(own: [[Rational; 2]; 2], other: [[Rational; 2]; 2]) -> [[Rational; 2]; 2] {
    let [own_x, own_y] = own;
    let [x, y] = other;
    let both = |[least, most]: [Rational; 2], [other_least, other_most]: [Rational; 2]| {
        [least.min(other_least), most.max(other_most)]
    };
    [both(own_x, x), both(own_y, y)]
}
