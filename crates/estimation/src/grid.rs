//! The readings as machine integers: decimals are integers on a common denominator.

use boundfit_exact::{Integer, Rational};

use crate::measurements::{ErrorBound, Measurement, Measurements, Model};

/// Numbers `mantissas[i] / scale`.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    pub(crate) mantissas: Vec<i64>,
    scale: i64,
    /// The denominator of the number before, and how often the scale is a multiple of it.
    last: (i64, i64),
}

impl Column {
    /// Beyond this a difference of two mantissas would not fit into 64 bits, nor a product of two such into 127.
    const LIMIT: u64 = 1 << 62;

    fn with_capacity(count: usize) -> Self {
        Column { mantissas: Vec::with_capacity(count), scale: 1, last: (1, 1) }
    }

    /// Numbers on their least common denominator; `None` when mantissas or denominator do not stay below 2⁶².
    pub(crate) fn new<'a>(numbers: impl ExactSizeIterator<Item = &'a Rational>) -> Option<Self> {
        let mut column = Column::with_capacity(numbers.len());
        for number in numbers {
            column.push(number)?;
        }
        Some(column)
    }

    fn push(&mut self, number: &Rational) -> Option<()> {
        let (numerator, denominator) = number.to_words()?;
        if denominator != self.last.0 {
            if self.scale % denominator != 0 {
                self.refine(denominator)?;
            }
            self.last = (denominator, self.scale / denominator);
        }
        self.mantissas.push(within_limit(numerator.checked_mul(self.last.1)?)?);
        Some(())
    }

    /// Makes the scale a multiple of a denominator. It doubles at least, so this happens at most 61 times.
    #[cold]
    fn refine(&mut self, denominator: i64) -> Option<()> {
        let scale = within_limit(Integer::from(self.scale).lcm(&Integer::from(denominator)).to_i64()?)?;
        let factor = scale / self.scale;
        for mantissa in &mut self.mantissas {
            *mantissa = within_limit(mantissa.checked_mul(factor)?)?;
        }
        self.scale = scale;
        Some(())
    }

    /// The common denominator.
    pub(crate) fn scale(&self) -> Integer {
        Integer::from(self.scale)
    }
}

fn within_limit(mantissa: i64) -> Option<i64> {
    (mantissa.unsigned_abs() < Column::LIMIT).then_some(mantissa)
}

/// The columns of the readings. What is the same for every reading, φ2 of a line and a uniform ε, has none.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) phi1: Column,
    pub(crate) phi2: Option<Column>,
    pub(crate) response: Column,
    pub(crate) epsilon: Option<Column>,
}

impl Grid {
    /// The readings on grids of their own for each column; `None` when one does not fit. Cost: linear.
    pub(crate) fn new(measurements: &Measurements) -> Option<Self> {
        let rows = measurements.kept();
        let of = |number: fn(&Measurement) -> &Rational| Column::new(rows.iter().map(number));
        let phi2 = match measurements.model() {
            Model::Line { .. } => None,
            Model::TwoRegressors { .. } => Some(of(|row| &row.regressor[1])?),
        };
        let epsilon = match measurements.error_bound() {
            ErrorBound::Uniform(_) => None,
            ErrorBound::PerRow(_) => Some(of(|row| &row.epsilon)?),
        };
        Some(Grid { phi1: of(|row| &row.regressor[0])?, phi2, response: of(|row| &row.response)?, epsilon })
    }

    /// How many readings there are.
    pub(crate) fn len(&self) -> usize {
        self.response.mantissas.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(numbers: &[(i64, i64)]) -> Option<Column> {
        let numbers: Vec<Rational> = numbers.iter().map(|&(n, d)| Rational::ratio(n, d)).collect();
        Column::new(numbers.iter())
    }

    #[test]
    fn decimals_share_a_denominator() {
        let column = column(&[(1, 2), (-3, 5), (7, 1), (1, 1000), (1, 5)]).unwrap();
        assert_eq!(column.mantissas, [500, -600, 7000, 1, 200]);
        assert_eq!(column.scale(), Integer::from(1000));
        assert_eq!(self::column(&[]).unwrap().scale(), Integer::one());
    }

    #[test]
    fn what_leaves_62_bits_has_no_column() {
        let largest = (1 << 62) - 1;
        assert_eq!(column(&[(largest, 1), (-largest, 1)]).unwrap().mantissas, [largest, -largest]);
        assert!(column(&[(largest + 1, 1)]).is_none());
        assert!(column(&[(-largest - 1, 1)]).is_none());
        assert!(column(&[(largest, 1), (1, 2)]).is_none(), "the number before no longer fits");
        assert!(column(&[(1, 2), (largest, 1)]).is_none());
        assert!(column(&[(1, 3), (1, 1 << 61)]).is_none(), "the denominator does not fit");
        assert!(column(&[(0, 1), (1, i64::MAX)]).is_none());
        let beyond_words = Rational::from(1_i128 << 64);
        assert!(Column::new([beyond_words].iter()).is_none());
    }
}
