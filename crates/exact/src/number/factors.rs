//! The powers of two and of five in integers, which decide whether a fraction is a finite decimal.

use super::Integer;
use super::library::{BigInt, BigUint};

/// `log2(5)`.
const BITS_OF_FIVE: f64 = 2.321_928_094_887_362;

impl Integer {
    /// The exponents of 2 and 5, if this positive integer is a product of their powers. Cost: that of the power of five.
    pub(crate) fn powers_of_two_and_five(&self) -> Option<(u32, u32)> {
        let magnitude = self.to_big().into_parts().1;
        let twos = magnitude.trailing_zeros()?;
        let odd = magnitude >> twos;
        // A power of five has floor(exponent · log2(5)) + 1 bits, so that at most one has as many.
        let fives = ((odd.bits() - 1) as f64 / BITS_OF_FIVE).ceil() as u32;
        // Most other numbers are told by one division by a word.
        let is_likely = fives == 0 || &odd % 5_u32 == BigUint::ZERO;
        (is_likely && BigUint::from(5_u32).pow(fives) == odd).then_some((u32::try_from(twos).ok()?, fives))
    }

    /// The product with a power of two and one of five.
    pub(crate) fn times_powers(&self, twos: u32, fives: u32) -> Self {
        Integer::from_big((self.to_big() * BigInt::from(5).pow(fives)) << twos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_those_that_were_multiplied() {
        for exponent in 0..2000 {
            let product = Integer::one().times_powers(exponent % 70, exponent);
            assert_eq!(product.powers_of_two_and_five(), Some((exponent % 70, exponent)));
            for other in [3, 7, 35] {
                assert_eq!((&product * Integer::from(other)).powers_of_two_and_five(), None, "{exponent}");
            }
            let beside = &product + Integer::one();
            if let Some((twos, fives)) = beside.powers_of_two_and_five() {
                assert_eq!(Integer::one().times_powers(twos, fives), beside);
            }
        }
    }
}
