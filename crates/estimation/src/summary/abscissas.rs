//! The x of all readings in little memory, for a second look at them.

use boundfit_exact::{Rational, Scaled};
use boundfit_formats::Column;

use super::columns::{LineColumns, WideColumn};
use super::spread::{Spread, Thresholds};
use super::sums::power_of_ten;

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
    /// (base + offset) · 10^exponent.
    Narrow {
        exponent: i32,
        base: i64,
        offsets: Vec<u32>,
    },
    Wide(WideColumn),
    Any(Column),
}

impl StoredPart {
    pub(super) fn new(columns: &LineColumns) -> Self {
        let x = columns.x;
        let narrow = |x: &Scaled| {
            let base = x.mantissas.iter().copied().min()?;
            let offset = |mantissa: &i64| u32::try_from(mantissa.checked_sub(base)?).ok();
            let offsets = x.mantissas.iter().map(offset).collect::<Option<_>>()?;
            Some(StoredPart::Narrow { exponent: x.exponent, base, offsets })
        };
        match x {
            Column::Scaled(scaled) => narrow(scaled).unwrap_or_else(|| StoredPart::Any(x.clone())),
            Column::Exact(_) | Column::Doubles(_) => match &columns.wide {
                Some([wide, _]) => StoredPart::Wide(wide.clone()),
                None => StoredPart::Any(x.clone()),
            },
        }
    }

    fn bytes(&self) -> usize {
        match self {
            StoredPart::Narrow { offsets, .. } => size_of_val(offsets.as_slice()),
            StoredPart::Wide(wide) => size_of_val(wide.mantissas.as_slice()),
            StoredPart::Any(Column::Scaled(scaled)) => size_of_val(scaled.mantissas.as_slice()),
            StoredPart::Any(Column::Doubles(doubles)) => size_of_val(doubles.as_slice()),
            StoredPart::Any(Column::Exact(numbers)) => size_of_val(numbers.as_slice()),
        }
    }

    fn spread(&self, thresholds: &Thresholds) -> Spread {
        let (exponent, base, offsets) = match self {
            StoredPart::Narrow { exponent, base, offsets } => (*exponent, *base, offsets),
            StoredPart::Wide(wide) => return thresholds.of_wide(wide),
            StoredPart::Any(column) => return thresholds.of_column(column),
        };
        let unit = power_of_ten(exponent);
        Spread::of_counts(thresholds.on_grid(exponent).map(|threshold| {
            // Offsets are compared as 64-bit integers and counted without branches: this loop sees every reading.
            let least = (threshold - i128::from(base)).clamp(-1, u32::MAX.into()) as i64;
            let (mut count, mut sum) = (0_u64, 0_u64);
            for &offset in offsets {
                let is_above = u64::from(i64::from(offset) > least);
                count = count.wrapping_add(is_above);
                // A part has fewer than 2^32 readings.
                sum = sum.wrapping_add(is_above * u64::from(offset));
            }
            (count as usize, Rational::from(i128::from(base) * i128::from(count) + i128::from(sum)) * &unit)
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
