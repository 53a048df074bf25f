//! Answers about groups that follow from two hulls, without a fit.

use boundfit_exact::Rational;

use super::{Fleet, lane};
use crate::files::counts::Counts;
use crate::group_fit::{GroupAnswer, GroupFit, GroupLine};
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::summary::Keep;

/// Readings of a line under one error bound, as integers.
struct Plain<'a> {
    first_row: Option<usize>,
    x: Counts<'a>,
    y: Counts<'a>,
    epsilon: &'a Rational,
}

impl Fleet {
    /// Returns what a line says of a group under no conditions: [`GroupFit::of`] its fit. Returns `None` where only
    /// the fit can answer. The short way needs a line with an intercept, decimals of usual lengths, one error bound
    /// for all readings, and an FPS that is a polygon. Exact. Cost: O(N log N), a tenth of that of the fit.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn group_fit(&self, group: usize) -> Option<GroupFit> {
        let Plain { first_row, x, y, epsilon } = self.plain(group)?;
        Some(GroupFit { first_row, ..lane::group_fit(&x, &y, epsilon)? })
    }

    /// Returns what [`Fleet::group_fit`] does, to be rounded only: as quotients that nobody has reduced. Returns `None` where that does.
    /// Exact. Cost: O(N log N), a third of that of [`Fleet::group_fit`].
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn group_line(&self, group: usize) -> Option<GroupLine> {
        let Plain { first_row, x, y, epsilon } = self.plain(group)?;
        Some(GroupLine { first_row, ..lane::group_line(&x, &y, epsilon)? })
    }

    /// Returns what a whole report says of a group under no conditions: [`GroupAnswer::of`] its fit. Returns `None` where
    /// [`Fleet::group_fit`] does, and for readings that the two hulls do not tell all of. Exact. Cost: O(N log N), half of that of
    /// the fit.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn group_answer(&self, group: usize) -> Option<GroupAnswer> {
        let rows = self.groups.rows(group);
        if self.counted_groups.rows(group).len() > 0 || rows.len() > Keep::MOST_ROWS {
            return None;
        }
        let Plain { first_row, x, y, epsilon } = self.plain(group)?;
        let rows: Vec<usize> = rows.map(|row| self.rows.get(row)).collect();
        let answer = lane::group_answer(x, y, epsilon, &|position| rows[position])?;
        Some(GroupAnswer { fit: GroupFit { first_row, ..answer.fit }, ..answer })
    }

    /// The row of the first reading of a group.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn first_row(&self, group: usize) -> Option<usize> {
        let first = self.groups.rows(group).next().map(|row| self.rows.get(row));
        let kinds = self.counted_groups.rows(group);
        first.into_iter().chain(kinds.map(|kind| self.counted.tally(kind).first() as usize)).min()
    }

    /// The readings of a group of which the two hulls tell all.
    fn plain(&self, group: usize) -> Option<Plain<'_>> {
        let Meaning { model, has_response, error_bound, uniform_law, form, multiple_of_least, .. } =
            &self.meaning;
        let (plain, kinds) = (self.groups.rows(group), self.counted_groups.rows(group));
        let columns = if kinds.len() == 0 { &self.columns } else { self.counted.columns().get(1..)? };
        let (Model::Line { .. }, ErrorBound::Uniform(epsilon), [x, y]) = (model, error_bound, columns) else {
            return None;
        };
        let is_plain = *has_response
            && uniform_law.is_none()
            && multiple_of_least.is_none()
            && !form.through_origin
            && form.x_origin.is_zero();
        if !is_plain || self.stream(group).is_some() {
            return None;
        }
        if kinds.len() == 0 {
            let counts = |column: usize| match self.groups.run(group) {
                Some(run) => columns[column].counts_of_run(run),
                None => columns[column].counts(plain.clone()),
            };
            let [x, y] = [counts(0)?, counts(1)?];
            return Some(Plain { first_row: plain.map(|row| self.rows.get(row)).next(), x, y, epsilon });
        }
        let first_row = kinds.clone().map(|kind| self.counted.tally(kind).first() as usize).min();
        let count = |kind: usize| self.counted.tally(kind).count() as usize;
        if plain.len() > 0 || kinds.clone().map(count).sum::<usize>() > Keep::MOST_ROWS {
            return None;
        }
        let rows: Vec<usize> = kinds.flat_map(|kind| std::iter::repeat_n(kind, count(kind))).collect();
        let [x, y] = [x.counts(rows.iter().copied())?, y.counts(rows.iter().copied())?];
        Some(Plain { first_row, x, y, epsilon })
    }
}
