//! The powers of ten that machine integers hold, from 1 on, as tables: a power for each number that is read takes longer.

macro_rules! powers {
    ($integer:ty, $count:literal) => {{
        let mut powers: [$integer; $count] = [1; $count];
        let mut exponent = 1;
        while exponent < powers.len() {
            #[allow(
                clippy::indexing_slicing,
                reason = "evaluated by the compiler, which would refuse an index out of range"
            )]
            {
                powers[exponent] = 10 * powers[exponent - 1];
            }
            exponent += 1;
        }
        powers
    }};
}

pub(crate) const OF_I64: [i64; 19] = powers!(i64, 19);
pub(crate) const OF_U64: [u64; 20] = powers!(u64, 20);
pub(crate) const OF_I128: [i128; 39] = powers!(i128, 39);
pub(crate) const OF_U128: [u128; 39] = powers!(u128, 39);

/// The exponent of the first of the rounded powers.
pub(crate) const LEAST_OF_F64: i64 = -40;

/// The powers of ten from [`LEAST_OF_F64`] on, rounded: quotients of integers of 128 bits lie between them.
pub(crate) const OF_F64: [f64; 81] = {
    let mut powers = [1.0; 81];
    let mut exponent = 1;
    while exponent <= 40 {
        #[allow(
            clippy::indexing_slicing,
            reason = "evaluated by the compiler, which would refuse an index out of range"
        )]
        {
            powers[40 + exponent] = 10.0 * powers[39 + exponent];
            powers[40 - exponent] = 1.0 / powers[40 + exponent];
        }
        exponent += 1;
    }
    powers
};
