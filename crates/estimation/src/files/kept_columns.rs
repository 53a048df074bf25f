//! Columns of all readings in little memory, for further looks at them.

use boundfit_exact::{Column, Rational, Scaled, Unit};
use boundfit_formats::RowNumbers;

use crate::summary::{Spread, Thresholds};

/// All numbers of some columns seen so far, at four bytes each where those of a part lie within 32 bits of each other, until
/// they would take more memory than allowed; from then on none.
#[derive(Debug)]
pub(super) struct KeptColumns {
    parts: Vec<KeptPart>,
    bytes: usize,
    most_bytes: usize,
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
            StoredColumn::Any(Column::Narrow(scaled)) => size_of_val(scaled.counts()),
            StoredColumn::Any(Column::Wide(scaled)) => size_of_val(scaled.counts()),
            StoredColumn::Any(Column::Doubles(doubles)) => size_of_val(doubles.as_slice()),
            StoredColumn::Any(Column::Fractions(numbers)) => size_of_val(numbers.as_slice()),
        }
    }

    fn column(&self) -> Column {
        match self {
            StoredColumn::Any(column) => column.clone(),
            StoredColumn::Offsets { unit, base, offsets } => {
                let count = |offset: &u32| i128::from(*base) + i128::from(*offset);
                Column::of_counts(offsets.iter().map(count), *unit)
            }
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

impl KeptPart {
    pub(super) fn new(columns: &[Column], rows: RowNumbers) -> Self {
        KeptPart { rows, columns: columns.iter().map(StoredColumn::new).collect() }
    }

    /// The columns as they were read.
    pub(super) fn columns(&self) -> Vec<Column> {
        self.columns.iter().map(StoredColumn::column).collect()
    }
}

impl KeptColumns {
    pub(super) fn new(most_bytes: usize) -> Self {
        KeptColumns { parts: Vec::new(), bytes: 0, most_bytes }
    }

    /// Keeps one more part.
    pub(super) fn push(&mut self, part: KeptPart) {
        let bytes = part.columns.iter().map(StoredColumn::bytes).sum();
        self.bytes = self.bytes.saturating_add(bytes);
        if self.bytes > self.most_bytes {
            self.parts = Vec::new();
        } else {
            self.parts.push(part);
        }
    }

    /// Every part; `None` unless all were kept.
    pub(super) fn parts(&self) -> Option<&[KeptPart]> {
        (self.bytes <= self.most_bytes).then_some(&self.parts)
    }

    /// What of the first columns lies above each threshold; `None` unless all parts were kept.
    pub(super) fn spread(&self, thresholds: &Thresholds) -> Option<Spread> {
        let spreads = self.parts()?.iter().filter_map(|part| part.columns.first());
        let spreads = spreads.map(|x| x.spread(thresholds));
        Some(spreads.fold(Spread::default(), |total, part| total.merged(&part)))
    }
}
