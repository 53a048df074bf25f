//! Columns of all readings in little memory, for further looks at them.

use boundfit_exact::{Column, Rational, Scaled, Unit};
use boundfit_formats::{RowNumbers, threads};

use std::sync::Arc;

use crate::summary::{Brackets, Narrowed, Spread, Thresholds};

/// All numbers of some columns seen so far, at four bytes each where those of a part lie within 32 bits of each other, until
/// they would take more memory than allowed; from then on those x that may matter, or none.
#[derive(Debug)]
pub(super) struct KeptColumns {
    kept: Kept,
    bytes: usize,
    most_bytes: usize,
}

#[derive(Debug)]
enum Kept {
    Parts(Vec<KeptPart>),
    Narrowed(Arc<Brackets>, Narrowed),
    Nothing,
}

/// What is kept of some rows.
pub(super) enum KeptNumbers {
    /// All of it.
    Part(KeptPart),
    /// Those x that may matter.
    Narrowed(Narrowed),
}

/// Consecutive rows.
#[derive(Debug)]
pub(super) struct KeptPart {
    pub(super) rows: RowNumbers,
    columns: Vec<StoredColumn>,
}

/// A column of one part.
#[derive(Debug)]
enum StoredColumn {
    /// `base + offset` units each.
    Offsets {
        unit: Unit,
        base: i64,
        offsets: Vec<u32>,
    },
    Any(Column),
}

impl StoredColumn {
    fn new(x: &Column) -> Self {
        let offsets = |x: &Scaled<i64>| {
            let base = x.counts().iter().copied().min()?;
            let offset = |count: &i64| u32::try_from(count.checked_sub(base)?).ok();
            let offsets = x.counts().iter().map(offset).collect::<Option<_>>()?;
            Some(StoredColumn::Offsets { unit: x.unit(), base, offsets })
        };
        let narrow = if let Column::Narrow(x) = x { offsets(x) } else { None };
        narrow.unwrap_or_else(|| StoredColumn::Any(x.clone()))
    }

    fn bytes(&self) -> usize {
        match self {
            StoredColumn::Offsets { offsets, .. } => size_of_val(offsets.as_slice()),
            StoredColumn::Any(column) => bytes_of(column),
        }
    }

    fn column(&self) -> Column {
        match self {
            StoredColumn::Any(column) => column.clone(),
            StoredColumn::Offsets { unit, base, offsets } => Column::of_offsets(*base, offsets, *unit),
        }
    }

    fn spread(&self, thresholds: &Thresholds) -> Spread {
        let (unit, base, offsets) = match self {
            StoredColumn::Offsets { unit, base, offsets } => (*unit, *base, offsets),
            StoredColumn::Any(column) => return thresholds.of_column(column),
        };
        Spread::of_counts(thresholds.in_units(unit).map(|threshold| {
            // Offsets are compared as 64-bit integers and counted without branches: this loop sees every reading.
            let least = threshold.saturating_sub(base.into()).clamp(-1, u32::MAX.into()) as i64;
            let (mut count, mut sum) = (0_u64, 0_u64);
            for &offset in offsets {
                let is_above = u64::from(i64::from(offset) > least);
                count = count.wrapping_add(is_above);
                // A part has fewer than 2^32 readings.
                sum = sum.wrapping_add(is_above * u64::from(offset));
            }
            let sum = i128::from(base) * i128::from(count) + i128::from(sum);
            (count as usize, Rational::from(sum) * unit.value())
        }))
    }
}

/// Returns how many bytes the numbers of a column take.
fn bytes_of(column: &Column) -> usize {
    match column {
        Column::Narrow(scaled) => size_of_val(scaled.counts()),
        Column::Wide(scaled) => size_of_val(scaled.counts()),
        Column::Long(long) => long.len() * long.width() * size_of::<i64>(),
        Column::Doubles(doubles) => size_of_val(doubles.as_slice()),
        Column::Fractions(numbers) => size_of_val(numbers.as_slice()),
    }
}

impl KeptPart {
    pub(super) fn new(columns: &[Column], rows: RowNumbers) -> Self {
        KeptPart { rows, columns: columns.iter().map(StoredColumn::new).collect() }
    }

    fn bytes(&self) -> usize {
        self.columns.iter().map(StoredColumn::bytes).sum()
    }

    /// Returns what is kept of the first column within brackets.
    fn narrowed(&self, brackets: &Brackets) -> Narrowed {
        self.columns.first().map(|x| brackets.narrow(&x.column())).unwrap_or_default()
    }

    /// The columns as they were read.
    pub(super) fn columns(&self) -> Vec<Column> {
        self.columns.iter().map(StoredColumn::column).collect()
    }
}

impl KeptColumns {
    pub(super) fn new(most_bytes: usize) -> Self {
        KeptColumns { kept: Kept::Parts(Vec::new()), bytes: 0, most_bytes }
    }

    /// Keeps some more rows. When that becomes too much, `guess` tells which x of all rows may matter, if anything does.
    pub(super) fn push(&mut self, rows: KeptNumbers, guess: impl FnOnce() -> Option<Arc<Brackets>>) {
        match (&mut self.kept, rows) {
            (Kept::Parts(parts), KeptNumbers::Part(part)) => {
                self.bytes = self.bytes.saturating_add(part.bytes());
                let is_first = parts.is_empty();
                parts.push(part);
                if self.bytes > self.most_bytes {
                    let parts = std::mem::take(parts);
                    self.kept = Kept::Nothing;
                    // A single part is no ground for a guess.
                    if let Some(brackets) = (!is_first).then(guess).flatten() {
                        self.narrow(parts, brackets);
                    }
                }
            }
            (Kept::Narrowed(brackets, _), KeptNumbers::Part(part)) => {
                let narrowed = part.narrowed(brackets);
                self.add(narrowed);
            }
            (Kept::Narrowed(..), KeptNumbers::Narrowed(narrowed)) => self.add(narrowed),
            (Kept::Nothing, _) | (Kept::Parts(_), KeptNumbers::Narrowed(_)) => {}
        }
    }

    /// Keeps of these parts only what lies within brackets.
    fn narrow(&mut self, parts: Vec<KeptPart>, brackets: Arc<Brackets>) {
        let narrowed = threads::map(parts, |part: KeptPart| part.narrowed(&brackets));
        self.bytes = 0;
        self.kept = Kept::Narrowed(brackets, Narrowed::default());
        narrowed.into_iter().for_each(|narrowed| self.add(narrowed));
    }

    fn add(&mut self, narrowed: Narrowed) {
        self.bytes = self.bytes.saturating_add(narrowed.kept().iter().map(bytes_of).sum());
        match &mut self.kept {
            Kept::Narrowed(_, all) if self.bytes <= self.most_bytes => all.merge(narrowed),
            kept => *kept = Kept::Nothing,
        }
    }

    /// Every part; `None` unless all were kept, and where none was.
    pub(super) fn parts(&self) -> Option<&[KeptPart]> {
        match &self.kept {
            Kept::Parts(parts) if !parts.is_empty() => Some(parts),
            _ => None,
        }
    }

    /// Returns what of the first columns lies above each threshold; `None` unless enough was kept.
    pub(super) fn spread(&self, thresholds: &Thresholds) -> Option<Spread> {
        let parts = match &self.kept {
            Kept::Parts(parts) => parts,
            Kept::Narrowed(brackets, narrowed) => return narrowed.spread(brackets, thresholds),
            Kept::Nothing => return None,
        };
        let spreads = parts.iter().filter_map(|part| part.columns.first());
        let spreads = spreads.map(|x| x.spread(thresholds));
        Some(spreads.fold(Spread::default(), |total, part| total.merged(&part)))
    }
}
