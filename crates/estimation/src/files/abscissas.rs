//! The x of all readings in little memory, for a second look at them.

use boundfit_exact::{Column, Rational, Scaled, Unit};

use crate::summary::{Spread, Thresholds};

/// All x seen so far, at four bytes each where those of a part lie within 32 bits of each other, until they
/// would take more memory than allowed; from then on none.
#[derive(Debug)]
pub(super) struct Abscissas {
    parts: Vec<StoredPart>,
    bytes: usize,
    most_bytes: usize,
}

/// The x of one part.
#[derive(Debug)]
pub(super) enum StoredPart {
    /// `base + offset` units each.
    Offsets {
        unit: Unit,
        base: i64,
        offsets: Vec<u32>,
    },
    Any(Column),
}

impl StoredPart {
    pub(super) fn new(x: &Column) -> Self {
        let offsets = |x: &Scaled<i64>| {
            let base = x.counts().iter().copied().min()?;
            let offset = |count: &i64| u32::try_from(count.checked_sub(base)?).ok();
            let offsets = x.counts().iter().map(offset).collect::<Option<_>>()?;
            Some(StoredPart::Offsets { unit: x.unit(), base, offsets })
        };
        let narrow = if let Column::Narrow(x) = x { offsets(x) } else { None };
        narrow.unwrap_or_else(|| StoredPart::Any(x.clone()))
    }

    fn bytes(&self) -> usize {
        match self {
            StoredPart::Offsets { offsets, .. } => size_of_val(offsets.as_slice()),
            StoredPart::Any(Column::Narrow(scaled)) => size_of_val(scaled.counts()),
            StoredPart::Any(Column::Wide(scaled)) => size_of_val(scaled.counts()),
            StoredPart::Any(Column::Doubles(doubles)) => size_of_val(doubles.as_slice()),
            StoredPart::Any(Column::Fractions(numbers)) => size_of_val(numbers.as_slice()),
        }
    }

    fn spread(&self, thresholds: &Thresholds) -> Spread {
        let (unit, base, offsets) = match self {
            StoredPart::Offsets { unit, base, offsets } => (*unit, *base, offsets),
            StoredPart::Any(column) => return thresholds.of_column(column),
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

impl Abscissas {
    pub(super) fn new(most_bytes: usize) -> Self {
        Abscissas { parts: Vec::new(), bytes: 0, most_bytes }
    }

    /// Keeps the x of one more part.
    pub(super) fn push(&mut self, part: StoredPart) {
        self.bytes = self.bytes.saturating_add(part.bytes());
        if self.bytes > self.most_bytes {
            self.parts = Vec::new();
        } else {
            self.parts.push(part);
        }
    }

    /// What lies above each threshold; `None` unless every x was kept.
    pub(super) fn spread(&self, thresholds: &Thresholds) -> Option<Spread> {
        (self.bytes <= self.most_bytes).then(|| {
            let spreads = self.parts.iter().map(|part| part.spread(thresholds));
            spreads.fold(Spread::default(), |total, part| total.merged(&part))
        })
    }
}
