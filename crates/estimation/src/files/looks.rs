//! Further looks at readings that have been read once.

use boundfit_exact::{Column, Rational};
use boundfit_formats::{
    Batch, ColumnSelector, InputError, InputErrorKind, RowNumbers, ScanOptions, Source, scan, threads,
};
use boundfit_geometry::grid::{RoundedStrips, in_range};
use boundfit_geometry::{Region, System, envelope};

use super::fixed::{FixedBounds, FixedSupport};
use super::kept_columns::{KeptColumns, KeptPart};
use super::reach::{SignedSums, Weights, merged_or_reason};
use super::sums::column_totals;
use super::vertices::AtVertices;
use crate::condition::Condition;
use crate::fps::{conditions_by_name, half_planes};
use crate::least_squares::LeastSquares;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::moments::Sums;
use crate::reduction::{NoEui, Reach};
use crate::rounded::may_be_tightest;
use crate::scale::Scale;
use crate::ties::Ties;

/// The source in which readings can be seen again.
pub(super) struct Looks<'a> {
    pub(super) kept: &'a KeptColumns,
    /// The file that the readings come from, and the number of its bytes that were read.
    pub(super) file: Option<(&'a str, u64)>,
    pub(super) options: &'a ScanOptions,
    pub(super) selectors: &'a [ColumnSelector],
    /// The number of rows there are, and the sum of each column.
    pub(super) count: usize,
    pub(super) totals: &'a [Rational],
}

/// The findings of the look that follows least squares.
pub(super) struct Reached {
    pub(super) reach: Result<Reach, NoEui>,
    /// The first of the readings that the estimate misses most, or else comes nearest to missing.
    pub(super) tightest: Option<Measurement>,
    /// Some readings that the least factor so far is not enough for.
    pub(super) missing: Vec<Measurement>,
}

impl Looks<'_> {
    /// Returns whether the readings can be seen again.
    pub(super) fn are_possible(&self) -> bool {
        self.kept.parts().is_some() || self.file.is_some()
    }

    /// Calls `work` for the columns of some rows and their numbers, on the threads of the current pool, and `take`
    /// with its results, in order. The columns come from memory, or else from a file that is still the same.
    pub(super) fn look<T: Send + 'static>(
        &self,
        work: impl Fn(&[Column], &RowNumbers) -> T + Sync + Send,
        mut take: impl FnMut(T),
    ) -> Result<(), InputError> {
        /// Parts that are unpacked at a time.
        const PARTS: usize = 64;
        if let Some(parts) = self.kept.parts() {
            for parts in parts.chunks(PARTS) {
                let seen = |part: &KeptPart| work(&part.columns(), &part.rows);
                threads::map(parts.iter().collect(), seen).into_iter().for_each(&mut take);
            }
            return Ok(());
        }
        let Some((path, bytes)) = self.file else { return Ok(()) };
        let options = ScanOptions { hash: false, list_rows: false, ..self.options.clone() };
        let (mut count, mut totals) = (0, vec![Rational::zero(); self.totals.len()]);
        let look = |batch: Batch| {
            (batch.rows.len(), column_totals(&batch.columns), work(&batch.columns, &batch.rows))
        };
        let again = Source::open(path)?.limited(bytes);
        scan(again, self.selectors, &options, look, |(rows, part, made)| {
            count += rows;
            totals.iter_mut().zip(part).for_each(|(total, part)| *total = &*total + part);
            take(made);
        })
        // A file that was right the first time has changed if it is wrong now.
        .map_err(|error| match error.kind {
            InputErrorKind::Io(_) | InputErrorKind::Interrupted => error,
            _ => InputError::of_file(path, InputErrorKind::Changed),
        })?;
        let is_same = count == self.count && totals == self.totals;
        if is_same { Ok(()) } else { Err(InputError::of_file(path, InputErrorKind::Changed)) }
    }

    /// Returns how far least squares may move, and the first of the readings that the estimate misses most, or else comes nearest to
    /// missing. The least factor of some readings may not be enough for others: those that miss its point most come along, so that it
    /// takes fewer looks. One look.
    pub(super) fn reach_and_tightest(
        &self,
        meaning: &Meaning,
        sums: &Sums,
        least: Option<&(Scale, [Rational; 2])>,
    ) -> Result<Reached, InputError> {
        let weights = Weights::new(sums);
        let theta = LeastSquares::theta_of(sums);
        let least = least.and_then(|(scale, theta)| {
            let factor = match (scale, meaning.error_bound.uniform()) {
                (Scale::Within(epsilon), Some(stated)) => epsilon.checked_div(stated)?,
                (Scale::Times(factor), _) => factor.clone(),
                _ => return None,
            };
            Some((factor.to_f64(), theta.each_ref().map(Rational::to_f64)))
        });
        let bounds = FixedBounds::new(meaning, &Scale::AsStated, 1);
        let mut total = Ok(SignedSums::default());
        let mut tightest: Option<(Rational, Measurement)> = None;
        let mut missing = Vec::new();
        let work = |columns: &[Column], rows: &RowNumbers| {
            let number = |k| rows.get(k);
            let strips = bounds.strips(columns, &number);
            let reading = |row: usize| meaning.of_columns(columns, row, number(row));
            let tightest = theta.as_ref().and_then(|theta| first_tightest(reading, &strips, theta));
            let missing = least.iter().flat_map(|(factor, theta)| missed_most(&strips, *theta, *factor));
            let missing: Vec<Measurement> = missing.map(reading).collect();
            (weights.of_columns(meaning, columns, &strips.phi, &number), tightest, missing)
        };
        self.look(work, |(sums, part, missed)| {
            let so_far = std::mem::replace(&mut total, Err(NoEui::NotAsked));
            total = merged_or_reason(so_far, sums);
            let is_tighter =
                |(slack, _): &(Rational, _)| tightest.as_ref().is_none_or(|(least, _)| slack < least);
            if let Some(part) = part.filter(is_tighter) {
                tightest = Some(part);
            }
            missing.extend(missed);
        })?;
        let reach = total.map(|total| weights.reach(meaning, total));
        Ok(Reached { reach, tightest: tightest.map(|(_, reading)| reading), missing })
    }

    /// The readings that touch an envelope under some bounds. One look.
    pub(super) fn touching(&self, bounds: &FixedBounds) -> Result<(Vec<Measurement>, Ties), InputError> {
        let mut support = FixedSupport::default();
        let work = |columns: &[Column], rows: &RowNumbers| {
            (rows.len(), bounds.of_columns(columns, &|k| rows.get(k)))
        };
        self.look(work, |(rows, part)| support.merge(part, rows, bounds))?;
        Ok(support.into_rows(bounds))
    }

    /// Returns bounds that find the readings that prove the set. A set that is a point or empty takes readings that
    /// others represent: the first reading with a bound through the point, and the readings that face it.
    pub(super) fn proving_bounds<'a>(
        &self,
        bounds: &FixedBounds<'a>,
        conditions: &[Condition],
        (rows, ties): &(Vec<Measurement>, Ties),
    ) -> Option<FixedBounds<'a>> {
        if ties.is_empty() || !self.are_possible() {
            return None;
        }
        let readings = rows.iter().flat_map(half_planes);
        let system: System = readings.chain(conditions_by_name(conditions)).map(|(_, own)| own).collect();
        let region = envelope::intersect(&system);
        let keep = match (&region, region.vertices()) {
            (Region::Empty(_), _) => AtVertices::Each,
            (Region::Point(_), [point]) => {
                let first = *point.active().first()?;
                AtVertices::Opposite(system.inequalities()[first].a.clone())
            }
            _ => return None,
        };
        Some(bounds.again(keep)?.knowing(rows))
    }

    /// Finds the readings that decide the least factor on the error bounds, from some that may not. The readings that
    /// touch at the least factor of these are complete as soon as that factor leaves a point for all readings. A look
    /// for each attempt, of which two or three suffice in practice.
    pub(super) fn deciding_minimax(
        &self,
        meaning: &Meaning,
        conditions: &[Condition],
        mut known: Vec<Measurement>,
    ) -> Result<Vec<Measurement>, InputError> {
        loop {
            known.sort_by_key(|reading| reading.row);
            known.dedup_by_key(|reading| reading.row);
            let Some(scale) = Scale::least(known.iter(), meaning.error_bound.is_uniform(), conditions) else {
                return Ok(known);
            };
            let bounds = FixedBounds::new(meaning, &scale, 1).telling_vertices_as_one().knowing(&known);
            let (touching, _) = self.touching(&bounds)?;
            if scale.is_enough(touching.iter(), conditions) {
                return Ok(touching);
            }
            known.extend(touching);
        }
    }
}

/// Returns a few positions of readings that miss a point most at a factor on the widths of their bounds, as far as floats tell. Cost:
/// linear.
fn missed_most(strips: &RoundedStrips, [theta1, theta2]: [f64; 2], factor: f64) -> Vec<usize> {
    /// The most positions.
    const FEW: usize = 8;
    /// The rows that are looked at together, without a branch.
    const BLOCK: usize = 64;
    let shrinks = (1.0 - factor) / 2.0;
    let slack = |(((phi1, phi2), lower), upper): (((&f64, &f64), &f64), &f64)| {
        let value = phi1 * theta1 + phi2 * theta2;
        let (above, below) = (upper - value, value - lower);
        // A reading with one bound has no width.
        let width = above + below;
        let less = if width == f64::INFINITY { 0.0 } else { width * shrinks };
        (if above < below { above } else { below }) - less
    };
    let [phi1, phi2] = strips.phi.each_ref().map(|phi| phi.chunks(BLOCK));
    let blocks = phi1.zip(phi2).zip(strips.lower.chunks(BLOCK)).zip(strips.upper.chunks(BLOCK));
    let mut missed: Vec<(f64, usize)> = Vec::new();
    for (block, (((phi1, phi2), lower), upper)) in blocks.enumerate() {
        let slacks = || phi1.iter().zip(phi2).zip(lower).zip(upper).map(slack);
        if slacks().fold(f64::INFINITY, |least, own| if own < least { own } else { least }) < 0.0 {
            let rows = slacks().zip(BLOCK * block..);
            missed.extend(rows.filter(|(slack, _)| *slack < 0.0));
        }
    }
    missed.sort_unstable_by(|(one, _), (other, _)| one.total_cmp(other));
    missed.into_iter().take(FEW).map(|(_, row)| row).collect()
}

/// Returns the first reading with the least slack at a point, with that slack. Exact. Cost: linear.
fn first_tightest(
    reading: impl Fn(usize) -> Measurement,
    strips: &RoundedStrips,
    theta: &[Rational; 2],
) -> Option<(Rational, Measurement)> {
    let point = theta.each_ref().map(|number| in_range(number.to_f64()));
    let with_slack = |row: usize| {
        let reading = reading(row);
        let slack = Scale::AsStated.half_planes(&reading).map(|own| own.slack(theta)).min()?;
        Some((slack, reading))
    };
    let candidates = may_be_tightest(strips, point).into_iter().filter_map(with_slack);
    candidates.reduce(|best, next| if next.0 < best.0 { next } else { best })
}
