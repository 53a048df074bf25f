//! An estimate and its error bound, rounded so that they belong together, from the leading bits of both.

use super::words::{self, bits_beyond};
use crate::{Wide, powers_of_ten};

/// The absolute values of a centre, of its error and of their common denominator, from below; above them by less than `slack`.
pub(super) struct Terms {
    least: [u128; 3],
    slack: u128,
}

/// A centre and its error in units of a place, as absolute values.
pub(super) struct Enclosing {
    pub(super) centre: u64,
    pub(super) error: u64,
    /// The weight of a unit, as a power of ten.
    pub(super) place: i64,
    pub(super) is_exact: bool,
    pub(super) is_error_exact: bool,
}

impl Terms {
    /// Shortens the terms so that they can be multiplied within 128 bits. The longest has `bits` bits. `leading(n)` is
    /// the terms without their lowest n bits.
    pub(super) fn new(
        bits: u64,
        digits: usize,
        leading: impl FnOnce(u64) -> [Option<u128>; 3],
    ) -> Option<Self> {
        /// A centre may have more digits than its error.
        const MORE_DIGITS: usize = 4;
        let beyond = bits_beyond(bits, digits + MORE_DIGITS);
        let [centre, error, denominator] = leading(beyond);
        Some(Terms { least: [centre?, error?, denominator?], slack: u128::from(beyond > 0) })
    }

    /// The same of terms in fixed memory.
    pub(super) fn of_wide(terms: [Wide; 3], digits: usize) -> Option<Self> {
        let bits = terms.map(Wide::bits).into_iter().max()?;
        Terms::new(bits.into(), digits, |beyond| terms.map(|term| term.leading(beyond as u32)))
    }

    /// Returns the decimals that enclose the terms. The error is rounded to this number of digits, the first of which weighs
    /// `10^exponent`.
    pub(super) fn enclosing(&self, exponent: i64, digits: usize) -> Option<Enclosing> {
        let mut place = exponent + 1 - digits as i64;
        let most = *powers_of_ten::OF_U64.get(digits)?;
        loop {
            let found = self.at(place)?;
            // Covering the rounding may carry into one more digit.
            if found.error < most {
                return Some(found);
            }
            place += 1;
        }
    }

    /// The centre rounded to nearest, and the error rounded up so that it covers what that changes.
    fn at(&self, place: i64) -> Option<Enclosing> {
        let power = *powers_of_ten::OF_U128.get(usize::try_from(place.unsigned_abs()).ok()?)?;
        let [above, below] = if place < 0 { [power, 1] } else { [1, power] };
        let factors = [above, above, below];
        let mut least = self.least;
        for (term, factor) in least.iter_mut().zip(factors) {
            *term = term.checked_mul(factor)?;
        }
        let [centre, error, unit] = least;
        if self.slack == 0 {
            return exactly(centre, error, unit, place);
        }
        // Each term is at least this, and less than that.
        let most = |term: u128, factor: u128| term.checked_add(factor);
        within([centre, error, unit], [most(centre, above)?, most(error, above)?, most(unit, below)?], place)
    }
}

fn exactly(centre: u128, error: u128, unit: u128, place: i64) -> Option<Enclosing> {
    let (floor, rest) = divided(centre, unit)?;
    let is_up = rest > unit - rest || (rest == unit - rest && floor % 2 == 1);
    let changed = if is_up { unit - rest } else { rest };
    let covering = error.checked_add(changed)?;
    let (error, beyond) = divided(covering, unit)?;
    Some(Enclosing {
        centre: u64::try_from(floor + u128::from(is_up)).ok()?,
        error: u64::try_from(error + u128::from(beyond > 0)).ok()?,
        place,
        is_exact: rest == 0,
        is_error_exact: beyond == 0,
    })
}

/// The enclosing decimals of all numbers between these; `None` where they are not the same for all. Nothing is a multiple of the unit then.
fn within(least: [u128; 3], most: [u128; 3], place: i64) -> Option<Enclosing> {
    let ([centre, error, unit], [most_centre, most_error, most_unit]) = (least, most);
    let (floor, rest) = divided(centre, most_unit)?;
    let (most_floor, most_rest) = divided(most_centre, unit)?;
    if floor != most_floor || rest == 0 {
        return None;
    }
    // The rest of a division of the numbers themselves is between both.
    let is_up = rest.checked_mul(2)? > most_unit;
    if !is_up && most_rest.checked_mul(2)? >= unit {
        return None;
    }
    let [changed, most_changed] = if is_up {
        let next = floor + 1;
        [unit.checked_mul(next)?.checked_sub(most_centre)?, most_unit.checked_mul(next)?.checked_sub(centre)?]
    } else {
        [rest, most_rest]
    };
    let (covering, beyond) = divided(error.checked_add(changed)?, most_unit)?;
    let (most_covering, _) = divided(most_error.checked_add(most_changed)?, unit)?;
    if covering != most_covering || beyond == 0 {
        return None;
    }
    Some(Enclosing {
        centre: u64::try_from(floor + u128::from(is_up)).ok()?,
        error: u64::try_from(covering + 1).ok()?,
        place,
        is_exact: false,
        is_error_exact: false,
    })
}

fn divided(dividend: u128, divisor: u128) -> Option<(u128, u128)> {
    (divisor != 0).then(|| words::divided(dividend, divisor))
}
