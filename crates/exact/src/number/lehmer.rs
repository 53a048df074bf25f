//! The greatest common divisor of long integers.

use super::gcd::gcd;
use super::library::BigUint;

/// Computes by Lehmer's algorithm on the two leading words (Knuth, *The Art of Computer Programming* 2, section
/// 4.5.2, algorithm L, with the stopping rule of Collins). It finds some thirty of Euclid's steps from the leading
/// words, and applies them to the long numbers at once. Quadratic, as Stein's of the library, but with one pass for
/// sixty bits in place of one for one or two: ten times faster and more. `gcd(0, n) = n`.
pub(super) fn long_gcd(left: &BigUint, right: &BigUint) -> BigUint {
    let word = u64::from(u64::BITS);
    match (left.trailing_zeros(), right.trailing_zeros()) {
        // In sums of doubles most bits of the denominator are such zeros, and shorter numbers need fewer passes.
        (Some(of_left), Some(of_right)) if of_left.max(of_right) >= word => {
            gcd_by_steps(&(left >> of_left), &(right >> of_right)) << of_left.min(of_right)
        }
        _ => gcd_by_steps(left, right),
    }
}

fn gcd_by_steps(left: &BigUint, right: &BigUint) -> BigUint {
    let (mut large, mut small) = if left >= right { (left, right) } else { (right, left) };
    // Numbers of very different sizes come together by one division.
    let rest;
    if small.bits() > 0 && large.bits() - small.bits() > u64::from(u64::BITS) {
        rest = large % small;
        (large, small) = (small, &rest);
    }
    let (mut large, mut small) = (large.to_u64_digits(), small.to_u64_digits());
    loop {
        if let Some(divisor) = to_pair(&small) {
            return of_words(&divisor_of_pair(&large, divisor));
        }
        match Steps::from_leading(&large, &small) {
            Some(steps) => steps.take(&mut large, &mut small),
            None => {
                let rest = of_words(&large) % of_words(&small);
                large = std::mem::replace(&mut small, rest.to_u64_digits());
            }
        }
    }
}

/// The divisor of a long number and of one of two words.
fn divisor_of_pair(long: &[u64], pair: u128) -> Vec<u64> {
    if pair == 0 {
        return long.to_vec();
    }
    let rest = of_words(long) % pair;
    let divisor = gcd(to_pair(&rest.to_u64_digits()).unwrap_or_default(), pair);
    vec![divisor as u64, (divisor >> u64::BITS) as u64]
}

/// The value of at most two words, the first the lowest.
fn to_pair(words: &[u64]) -> Option<u128> {
    match *words {
        [] => Some(0),
        [low] => Some(low.into()),
        [low, high] => Some(u128::from(high) << u64::BITS | u128::from(low)),
        _ => None,
    }
}

fn of_words(words: &[u64]) -> BigUint {
    BigUint::new(words.iter().flat_map(|word| [*word as u32, (word >> u32::BITS) as u32]).collect())
}

/// The highest 128 bits of a number of at least two words, and what another of at most its size has in their place.
fn leading(large: &[u64], small: &[u64]) -> (u128, u128) {
    let word = |words: &[u64], place: usize| {
        let index = large.len().checked_sub(place);
        u128::from(index.and_then(|index| words.get(index)).copied().unwrap_or_default())
    };
    let empty = word(large, 1).leading_zeros() - u64::BITS;
    let top = |words: &[u64]| {
        let pair = word(words, 1) << u64::BITS | word(words, 2);
        pair << empty | (word(words, 3) << empty) >> u64::BITS
    };
    (top(large), top(small))
}

/// Quotient and remainder. Two of three quotients in Euclid's algorithm are below 4, and a division of 128 bits takes longer than
/// three subtractions.
fn divided(a: u128, b: u128) -> (u128, u128) {
    let mut rest = a;
    for quotient in 0..4 {
        if rest < b {
            return (quotient, rest);
        }
        rest -= b;
    }
    let quotient = a / b;
    (quotient, a - quotient * b)
}

/// Several of Euclid's steps at once: `(a, b)` becomes `(|u0·a - v0·b|, |u1·a - v1·b|)`.
struct Steps {
    of_large: [u64; 2],
    of_small: [u64; 2],
    /// True if their number is even: then u0·a is the larger term of the first, and otherwise u1·a of the second.
    is_even: bool,
}

impl Steps {
    /// The steps that the leading words decide; `None` where they decide none.
    fn from_leading(large: &[u64], small: &[u64]) -> Option<Self> {
        let (mut a, mut b) = leading(large, small);
        let mut steps = Steps { of_large: [1, 0], of_small: [0, 1], is_even: true };
        while b > 0 {
            let (quotient, rest) = divided(a, b);
            // A quotient beyond a word does not fit into the next `of_small`.
            let Ok(quotient) = u64::try_from(quotient) else { break };
            let next = |pair: [u64; 2]| Some([pair[1], quotient.checked_mul(pair[1])?.checked_add(pair[0])?]);
            let (Some(of_large), Some(of_small)) = (next(steps.of_large), next(steps.of_small)) else {
                break;
            };
            // Collins's condition: under it the quotients of all longer numbers that begin so are the same.
            let [before, last] = of_small.map(u128::from);
            if rest < last || b - rest < before + last {
                break;
            }
            (a, b) = (b, rest);
            steps = Steps { of_large, of_small, is_even: !steps.is_even };
        }
        (steps.of_small[0] > 0).then_some(steps)
    }

    /// Takes the steps. Neither number grows.
    fn take(&self, large: &mut Vec<u64>, small: &mut Vec<u64>) {
        small.resize(large.len(), 0);
        let [mut first, mut second] = [Difference::default(), Difference::default()];
        for (a, b) in large.iter_mut().zip(small.iter_mut()) {
            let ([u0, u1], [v0, v1]) = (self.of_large, self.of_small);
            (*a, *b) = if self.is_even {
                (first.next(u0, *a, v0, *b), second.next(v1, *b, u1, *a))
            } else {
                (first.next(v0, *b, u0, *a), second.next(u1, *a, v1, *b))
            };
        }
        for words in [large, small] {
            words.truncate(words.iter().rposition(|word| *word != 0).map_or(0, |last| last + 1));
        }
    }
}

/// `p·a - q·b` for long a and b, from the lowest word to the highest.
#[derive(Default)]
struct Difference {
    carries: [u64; 2],
    borrow: bool,
}

impl Difference {
    #[inline]
    fn next(&mut self, p: u64, a: u64, q: u64, b: u64) -> u64 {
        let plus = u128::from(p) * u128::from(a) + u128::from(self.carries[0]);
        let minus = u128::from(q) * u128::from(b) + u128::from(self.carries[1]);
        self.carries = [(plus >> u64::BITS) as u64, (minus >> u64::BITS) as u64];
        let (rest, passed) = (plus as u64).overflowing_sub(minus as u64);
        let (rest, passed_again) = rest.overflowing_sub(self.borrow.into());
        self.borrow = passed || passed_again;
        rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::library::DivisionAndGcd as _;

    /// Numbers of many lengths, from a fixed stream.
    fn numbers() -> impl FnMut(usize) -> BigUint {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        move |words| {
            let mut next = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                // Words with long runs of equal bits are where quotients are large.
                match state >> 61 {
                    0 => 0,
                    1 => u64::MAX,
                    2 => 1 << (state >> 32 & 63),
                    _ => state ^ state >> 29,
                }
            };
            of_words(&(0..words).map(|_| next()).collect::<Vec<_>>())
        }
    }

    #[test]
    fn it_is_that_of_the_library() {
        let mut number = numbers();
        for round in 0..4_000 {
            let (own, other, common) = (number(round % 13), number(round % 7), number(round % 5));
            let (left, right) = (own * &common, other * &common);
            assert_eq!(long_gcd(&left, &right), left.gcd(&right), "{left} {right}");
        }
        let (own, other, common) = (number(400), number(390), number(100));
        assert_eq!(
            long_gcd(&(&own * &common), &(&other * &common)),
            (&own * &common).gcd(&(&other * &common))
        );
    }

    #[test]
    fn neighbours_in_fibonaccis_sequence_take_the_most_steps() {
        let (mut last, mut next) = (BigUint::from(1_u32), BigUint::from(1_u32));
        for _ in 0..3_000 {
            (last, next) = (next.clone(), last + next);
        }
        assert_eq!(long_gcd(&last, &next), BigUint::from(1_u32));
        let common = BigUint::from(3_u32).pow(500);
        assert_eq!(long_gcd(&(&last * &common), &(next * &common)), common);
    }

    #[test]
    fn powers_and_their_neighbours() {
        let one = BigUint::from(1_u32);
        for (base, exponent) in [(2_u32, 64_u32), (2, 128), (2, 129), (2, 1_000), (10, 500), (3, 333)] {
            let power = BigUint::from(base).pow(exponent);
            for other in
                [&power - &one, power.clone(), &power + &one, &power * &power, &power * &power - &one]
            {
                assert_eq!(long_gcd(&power, &other), power.gcd(&other), "{base}^{exponent} {other}");
                assert_eq!(long_gcd(&other, &power), power.gcd(&other), "{base}^{exponent} {other}");
            }
            assert_eq!(long_gcd(&power, &BigUint::default()), power);
        }
    }
}
