//! Readings that are not all kept: further looks at their data.

use std::sync::Arc;

use boundfit_estimation::{Columns, EpsilonColumn, Keep, Measurement, Measurements, Problem, Seen};
use boundfit_exact::{DecimalMark, Foreign};
use boundfit_formats::{Again, InputError, InputErrorKind, RowRange, RowSet, ScanOptions, Source};

use crate::asked::Asked;
use crate::form::Shows;
use crate::misuse::Misuse;
use crate::paper::{Out, put};
use crate::refusal::Refusal;
use crate::tables::Tables;

/// Readings whose lines are put together in memory.
const ROWS_AT_ONCE: usize = 4096;

/// A problem whose readings can be looked at once more.
pub struct Judgeable {
    /// The problem that the first look read.
    pub problem: Problem,
    columns: Columns,
    options: ScanOptions,
    name: Foreign,
    again: Option<Again>,
    tables: Option<Arc<dyn Tables>>,
}

impl Judgeable {
    pub(super) fn new(asked: &Asked, problem: Problem, name: Foreign, again: Option<Again>) -> Self {
        let columns = asked.question.columns.clone();
        // Under the error bound that was found from all readings, where it was.
        let columns = match problem.measurements.error_bound().uniform() {
            Some(epsilon) => Columns { epsilon: EpsilonColumn::Uniform(epsilon.clone()), ..columns },
            None => columns,
        };
        let options = asked.held(Asked::ROW_COST, Shows::Hash);
        Judgeable { problem, columns, options, name, again, tables: asked.tables.clone() }
    }

    /// Returns the place of further tables.
    pub(super) fn tables(&self) -> Result<&dyn Tables, Refusal> {
        self.tables.as_deref().ok_or(Refusal::Misuse(Misuse::NoTables))
    }

    /// Shows every reading: from memory, or as the data are read once more.
    pub(super) fn each<T: Send + 'static>(
        &self,
        see: impl Fn(&mut dyn Iterator<Item = Measurement>) -> T + Sync + Send,
        mut seen: impl FnMut(T),
    ) -> Result<(), Refusal> {
        match self.problem.measurements.all() {
            Some(all) => {
                let parts = all.chunks(ROWS_AT_ONCE);
                parts.for_each(|readings| seen(see(&mut readings.iter().cloned())));
                Ok(())
            }
            None => self.look(&[], |part| see(&mut part.readings()), seen).map(|_| ()),
        }
    }

    /// Another look at the data, without some rows.
    pub(super) fn look<T: Send + 'static>(
        &self,
        without: &[usize],
        see: impl Fn(&Seen<'_>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<Measurements, Refusal> {
        let changed = || Refusal::Input(InputError::of_file(self.name.raw(), InputErrorKind::Changed));
        let source = self.again.as_ref().ok_or_else(changed)?.open()?;
        let mut options = self.options.clone();
        let holes = without.iter().filter_map(|&row| RowRange::new(row, row));
        let holes: Vec<RowRange> = options.table.rows.without().iter().copied().chain(holes).collect();
        options.table.rows = RowSet::new(options.table.rows.named(), &holes).ok_or_else(changed)?;
        let first = &self.problem.measurements;
        // The row that tells it may be among those that are left out.
        let notation = first.table().map(|notes| notes.dialect.notation);
        if notation.is_some_and(|notation| notation.decimal == DecimalMark::Comma) {
            options.table.dialect.decimal = Some(DecimalMark::Comma);
        }
        let seen = self.scan(source, &options, see, seen)?;
        let is_same = seen.sha256() == first.sha256() && seen.fitted() + without.len() == first.fitted();
        if is_same { Ok(seen) } else { Err(changed()) }
    }

    /// Reads further readings.
    pub(super) fn see_new<T: Send + 'static>(
        &self,
        name: &str,
        see: impl Fn(&Seen<'_>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<(), Refusal> {
        let tables = self.tables()?;
        let (source, options) = tables.open(name)?;
        if matches!(&self.columns.epsilon, EpsilonColumn::Law(law) if law.needs_range()) {
            return Err(Refusal::Misuse(Misuse::NewOfRange));
        }
        if source.is_reduction() {
            return Err(Refusal::Misuse(Misuse::NewReduction));
        }
        let new = self.scan(source, &ScanOptions { hash: false, ..options }, see, seen)?;
        tables.was_read(name, new.table(), new.rows_missing());
        Ok(())
    }

    fn scan<T: Send + 'static>(
        &self,
        source: Source,
        options: &ScanOptions,
        see: impl Fn(&Seen<'_>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<Measurements, InputError> {
        let keep = Keep { eui: false, ..Keep::default() };
        let options = ScanOptions { list_rows: false, ..options.clone() };
        let conditions = &self.problem.conditions;
        Measurements::scan_and_see(source, &self.columns, conditions, &options, keep, see, seen)
    }
}

/// Lines on their way to an output.
pub(super) struct Parts<'a> {
    out: &'a mut Out<'a>,
    between: &'static str,
    has_part: bool,
    stop: Option<Refusal>,
}

impl<'a> Parts<'a> {
    pub(super) fn new(out: &'a mut Out<'a>, between: &'static str) -> Self {
        Parts { out, between, has_part: false, stop: None }
    }

    pub(super) fn take(&mut self, part: &str) {
        if self.stop.is_some() || part.is_empty() {
            return;
        }
        let between = if self.has_part { self.between } else { "" };
        self.has_part = true;
        self.stop = put(self.out, between).and_then(|()| put(self.out, part)).err();
    }

    pub(super) fn end(self) -> Result<(), Refusal> {
        self.stop.map_or(Ok(()), Err)
    }
}
