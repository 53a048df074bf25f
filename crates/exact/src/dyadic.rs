//! Doubles as machine integers, for sums of many of them.

use crate::binary64::{LEAST_EXPONENT, power_of_two, significand_and_exponent};

/// Bits of a count at most: more than the 53 of a significand, so that doubles down to a 2⁹th of the largest one have counts.
const COUNT_BITS: i32 = 62;
/// Powers of two from here on have inverses that are doubles too.
const LEAST_UNIT: i32 = -1000;

/// Finite doubles as integers on a power of two that suits the largest of them: number `k` is `counts[k] · 2^exponent`
/// unless `k` is among the others. Exact.
#[derive(Debug)]
pub struct Dyadic<'a> {
    values: &'a [f64],
    counts: Vec<i64>,
    exponent: i32,
    /// Positions, ascending, of numbers that are no multiples of the unit; their counts are 0.
    others: Vec<usize>,
}

impl<'a> Dyadic<'a> {
    /// The number of doubles that stay in a first-level cache at a time; their sums and those of their products stay
    /// in [`DoubleSum`](crate::DoubleSum).
    pub const CHUNK: usize = 1024;

    /// Takes at most [`Dyadic::CHUNK`] finite numbers; numbers beyond are ignored. Cost: linear.
    pub fn new(values: &'a [f64]) -> Self {
        const BLOCK: usize = u64::BITS as usize;
        let values = values.get(..Self::CHUNK).unwrap_or(values);
        let exponent = unit_of(largest(values));
        let (unit, inverse) = (power_of_two(exponent.into()), power_of_two((-exponent).into()));
        let mut counts = Vec::with_capacity(values.len());
        let mut others = Vec::new();
        for (block, values) in values.chunks(BLOCK).enumerate() {
            // One bit per number, so that numbers are tested without a branch.
            let mut odd = 0_u64;
            counts.extend(values.iter().zip(0..).map(|(&value, bit): (&f64, u32)| {
                // A product with a power of two is only rounded where it underflows; the way back tells.
                let count = (value * inverse) as i64;
                let is_exact = count as f64 * unit == value;
                odd |= u64::from(!is_exact) << bit;
                count & -i64::from(is_exact)
            }));
            while odd != 0 {
                others.push(block * BLOCK + odd.trailing_zeros() as usize);
                odd &= odd - 1;
            }
        }
        Dyadic { values, counts, exponent, others }
    }

    /// All numbers.
    pub fn values(&self) -> &'a [f64] {
        self.values
    }

    /// Returns how many units each number is; 0 for the others.
    pub fn counts(&self) -> &[i64] {
        &self.counts
    }

    /// The unit is 2 to this power.
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The numbers that are no multiples of the unit, with their positions.
    pub fn others(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.others.iter().filter_map(|&position| Some((position, *self.values.get(position)?)))
    }
}

/// The largest magnitude.
fn largest(values: &[f64]) -> f64 {
    let (fours, rest) = values.as_chunks::<4>();
    let larger = |most: f64, value: f64| if value.abs() > most { value.abs() } else { most };
    // Four at a time, which the processor compares together.
    let mut most = [0.0; 4];
    for four in fours {
        most.iter_mut().zip(four).for_each(|(most, &value)| *most = larger(*most, value));
    }
    most.iter().chain(rest).fold(0.0, |most, &value| larger(most, value))
}

/// The least power of two of which a magnitude, and hence all that are less, are less than 2^62.
fn unit_of(magnitude: f64) -> i32 {
    const _: () = assert!(LEAST_UNIT > LEAST_EXPONENT as i32);
    let (significand, exponent) = significand_and_exponent(magnitude);
    let bits = (i64::BITS - significand.leading_zeros()) as i32;
    (exponent + bits - COUNT_BITS).max(LEAST_UNIT)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Integer, Rational};

    #[test]
    fn every_number_is_a_count_or_one_of_the_others() {
        let mut state: u64 = 0x9e37_79b9_7f4a_7c15;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state
        };
        for spread in [1, 5, 40, 2046] {
            for center in [1, 30, 1000, 1023, 2046 - spread] {
                let mut values: Vec<f64> = (0..1000)
                    .map(|_| {
                        let bits = next();
                        let biased = (center + (bits >> 20) % spread).min(2046);
                        f64::from_bits(bits >> 63 << 63 | biased << 52 | next() >> 12)
                    })
                    .collect();
                values.extend([0.0, -0.0, f64::from_bits(center << 52)]);
                let dyadic = Dyadic::new(&values);
                let others: Vec<usize> = dyadic.others().map(|(position, _)| position).collect();
                let unit = Rational::from_f64(power_of_two(dyadic.exponent().into())).unwrap();
                for (position, &value) in values.iter().enumerate() {
                    let exact = Rational::from_f64(value).unwrap();
                    let count = dyadic.counts()[position];
                    if others.contains(&position) {
                        assert_eq!(count, 0);
                        assert_ne!(exact.checked_div(&unit).unwrap().denominator(), Integer::one());
                    } else {
                        assert_eq!(Rational::from(count) * &unit, exact);
                        assert!(count.unsigned_abs() >> COUNT_BITS == 0);
                    }
                }
            }
        }
    }

    #[test]
    fn nothing_but_zeros_and_the_ends_of_the_format_have_counts() {
        let counts = |values: &[f64]| {
            let dyadic = Dyadic::new(values);
            (dyadic.counts().to_vec(), dyadic.others().count())
        };
        assert_eq!(counts(&[]), (vec![], 0));
        assert_eq!(counts(&[0.0, -0.0]), (vec![0, 0], 0));
        assert_eq!(counts(&[f64::MAX, f64::from_bits(1)]), (vec![((1 << 53) - 1) << 9, 0], 1));
        assert_eq!(counts(&[f64::from_bits(1)]), (vec![0], 1));
        assert_eq!(counts(&[1.0; 2000]).0.len(), Dyadic::CHUNK);
    }
}
