//! The types of columns.

/// A column's type: numbers with an exact order and a rounded value.
pub(super) trait Coordinate: Copy + PartialOrd {
    /// The nearest binary64.
    fn value(self) -> f64;
    /// The nearest binary64 to `self - origin`, for numbers from `origin` to one within its [reach](Self::reaches).
    fn offset(self, origin: Self) -> f64;
    /// Returns whether all numbers up to `end` have finite offsets from this one.
    fn reaches(self, end: Self) -> bool;
    /// Returns whether a number is from `origin` to `end`, one within its reach.
    fn is_within(self, origin: Self, end: Self) -> bool;
    /// Bits that tell it from most others.
    fn bits(self) -> u64;
    /// The number as a word, if its type is one.
    fn word(self) -> Option<i64> {
        None
    }
}

macro_rules! integer_coordinate {
    ($integer:ty, $unsigned:ty, $word:expr) => {
        impl Coordinate for $integer {
            fn value(self) -> f64 {
                self as f64
            }

            fn offset(self, origin: Self) -> f64 {
                // Wraps beyond its reach only.
                self.wrapping_sub(origin) as f64
            }

            fn reaches(self, end: Self) -> bool {
                end.checked_sub(self).is_some()
            }

            #[inline]
            fn is_within(self, origin: Self, end: Self) -> bool {
                // One comparison: what is before the origin wraps to beyond the end.
                self.wrapping_sub(origin) as $unsigned <= end.wrapping_sub(origin) as $unsigned
            }

            #[inline]
            fn bits(self) -> u64 {
                self as u64
            }

            #[inline]
            fn word(self) -> Option<i64> {
                $word(self)
            }
        }
    };
}

integer_coordinate!(i64, u64, Some);
integer_coordinate!(i128, u128, |_| None);

impl Coordinate for f64 {
    fn value(self) -> f64 {
        self
    }

    fn offset(self, origin: Self) -> f64 {
        self - origin
    }

    fn reaches(self, end: Self) -> bool {
        (end - self).is_finite()
    }

    #[inline]
    fn is_within(self, origin: Self, end: Self) -> bool {
        (self >= origin) & (self <= end)
    }

    #[inline]
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_reaches_as_far_as_its_offsets_are_finite() {
        assert!(Coordinate::reaches(-f64::MAX, 0.0) && Coordinate::reaches(1.0, f64::MAX));
        assert!(!Coordinate::reaches(-f64::MAX, f64::MAX));
        assert!(Coordinate::reaches(0, i64::MAX) && Coordinate::reaches(i64::MIN, -1));
        assert!(!Coordinate::reaches(-1, i64::MAX) && !Coordinate::reaches(i64::MIN, 0));
        assert!(Coordinate::reaches(0, i128::MAX) && !Coordinate::reaches(i128::MIN, 0));
    }
}
