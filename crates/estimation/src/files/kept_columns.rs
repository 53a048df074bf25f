//! Columns of all readings in little memory, for further looks at them.

use std::borrow::Cow;

use boundfit_exact::{Column, Rational, Unit};
use boundfit_formats::RowNumbers;

use crate::summary::{Spread, Thresholds};

/// All numbers of some columns seen so far, until they would take more memory than allowed; from then on none. Where
/// the numbers of each column of a part lie within 32 bits of each other, each takes four bytes.
#[derive(Debug)]
pub(super) struct KeptColumns {
    /// `None` once there were too many.
    parts: Option<Vec<KeptPart>>,
    bytes: usize,
    most_bytes: usize,
}

/// Consecutive rows.
#[derive(Debug)]
pub(super) struct KeptPart {
    pub(super) rows: RowNumbers,
    columns: Stored,
}

/// The columns of one part.
#[derive(Debug)]
enum Stored {
    /// All of them within 32 bits.
    Offsets(Vec<Offsets>),
    Any(Vec<Column>),
}

/// A column whose numbers are `base + offset` units each.
#[derive(Debug)]
struct Offsets {
    unit: Unit,
    base: i64,
    offsets: Vec<u32>,
}

impl Offsets {
    /// Returns the offsets of a column; `None` where they take more than 32 bits.
    fn new(column: &Column) -> Option<Self> {
        let Column::Narrow(x) = column else { return None };
        let ends = |[least, most]: [i64; 2], &count: &i64| [least.min(count), most.max(count)];
        let [base, most] = x.counts().iter().fold([i64::MAX, i64::MIN], ends);
        // The ends of no numbers are the wrong way round, and too far apart.
        u32::try_from(most.checked_sub(base)?).ok()?;
        let offsets = x.counts().iter().map(|count| count.wrapping_sub(base) as u32).collect();
        Some(Offsets { unit: x.unit(), base, offsets })
    }

    fn column(&self) -> Column {
        Column::of_offsets(self.base, &self.offsets, self.unit)
    }

    fn spread(&self, thresholds: &Thresholds) -> Spread {
        let Offsets { unit, base, offsets } = self;
        let base = *base;
        Spread::of_counts(thresholds.in_units(*unit).map(|threshold| {
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
        Column::Scattered(scattered) => size_of_val(scattered.numbers()),
        Column::Fractions(numbers) => size_of_val(numbers.as_slice()),
    }
}

impl KeptPart {
    pub(super) fn new(columns: &[Column], rows: RowNumbers) -> Self {
        let offsets = columns.iter().map(Offsets::new).collect();
        let columns = match offsets {
            Some(offsets) => Stored::Offsets(offsets),
            None => Stored::Any(columns.to_vec()),
        };
        KeptPart { rows, columns }
    }

    pub(super) fn bytes(&self) -> usize {
        match &self.columns {
            Stored::Offsets(columns) => columns.iter().map(|own| size_of_val(own.offsets.as_slice())).sum(),
            Stored::Any(columns) => columns.iter().map(bytes_of).sum(),
        }
    }

    /// The columns as they were read.
    pub(super) fn columns(&self) -> Cow<'_, [Column]> {
        match &self.columns {
            Stored::Offsets(columns) => columns.iter().map(Offsets::column).collect(),
            Stored::Any(columns) => Cow::Borrowed(columns),
        }
    }

    /// Returns what of the first column lies above each threshold.
    fn spread(&self, thresholds: &Thresholds) -> Option<Spread> {
        match &self.columns {
            Stored::Offsets(columns) => columns.first().map(|x| x.spread(thresholds)),
            Stored::Any(columns) => columns.first().map(|x| thresholds.of_column(x)),
        }
    }
}

impl KeptColumns {
    pub(super) fn new(most_bytes: usize) -> Self {
        KeptColumns { parts: Some(Vec::new()), bytes: 0, most_bytes }
    }

    /// Keeps some more rows, or from now on none.
    pub(super) fn push(&mut self, part: KeptPart) {
        let Some(parts) = &mut self.parts else { return };
        self.bytes = self.bytes.saturating_add(part.bytes());
        if self.bytes > self.most_bytes {
            self.parts = None;
        } else {
            parts.push(part);
        }
    }

    /// Every part; `None` unless all were kept, and where none was.
    pub(super) fn parts(&self) -> Option<&[KeptPart]> {
        self.parts.as_deref().filter(|parts| !parts.is_empty())
    }

    /// Returns what of the first columns lies above each threshold; `None` unless all numbers were kept.
    pub(super) fn spread(&self, thresholds: &Thresholds) -> Option<Spread> {
        let spreads = self.parts.as_ref()?.iter().filter_map(|part| part.spread(thresholds));
        Some(spreads.fold(Spread::default(), |total, part| total.merged(&part)))
    }
}
