//! The share of further readings in the band of the least error bound, without any bound on their errors.

use boundfit_estimation::Measurements;
use boundfit_exact::{Integer, Rational};

/// The number of shares that are told apart: the answer is a whole number of 10⁻¹⁸.
const SHARES: u64 = 1_000_000_000_000_000_000;
/// Bits behind the point of powers, beside those of 1 - confidence.
const BITS: u64 = 256;

/// Returns the share of further readings that lie in the band of the least error bound, with this confidence. For
/// every source of independent readings, the chance that its band holds at least this share of all other readings is
/// at least `confidence`. 0 where the readings are fewer than the unknowns. `None` unless 0 < confidence < 1.
///
/// The band has `unknowns` parameters, with its width: 3 for θ1, θ2 and ε, 2 for lines through the origin. With d of them and N
/// readings, the chance V that a further reading misses the band satisfies
///
/// P(V > p) ≤ Σ_{i<d} C(N, i)·p^i·(1 − p)^(N − i)
///
/// (Campi and Garatti, "The exact feasibility of randomized solutions of uncertain convex programs", *SIAM J. Optim.*
/// 19, 2008; of such bands Campi, Calafiore and Garatti, "Interval predictor models: identification and reliability",
/// *Automatica* 45, 2009), with equality where d readings fix the band almost surely. The share is 1 − p for a p at
/// which the sum is not above 1 − confidence. Sums and powers are rounded up on 256 bits and more, so that the share
/// is never too large. It is at most 2·10⁻¹⁸ below the largest one. Cost: some 60·log N products.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_questions::guaranteed_share;
///
/// let share = guaranteed_share(23, 3, &Rational::ratio(99, 100)).expect("a confidence between 0 and 1");
/// assert!(share > Rational::ratio(68, 100) && share < Rational::ratio(69, 100));
/// ```
pub fn guaranteed_share(readings: usize, unknowns: u32, confidence: &Rational) -> Option<Rational> {
    let doubt = Rational::one() - confidence;
    if !confidence.is_positive() || !doubt.is_positive() {
        return None;
    }
    // So small a doubt has to be told from 0.
    let small = doubt.denominator().bits().saturating_sub(doubt.numerator().bits());
    let tail = Tail { readings: readings as u64, unknowns: unknowns.into(), bits: BITS + small };
    let doubt = (doubt.numerator() * Integer::power_of_two(tail.bits)).div_rem_floor(&doubt.denominator()).0;
    // Nothing is left of the sum when all are missed, unless the readings are too few.
    let (mut too_few, mut enough) = (0, SHARES);
    while enough - too_few > 1 {
        let middle = too_few + (enough - too_few) / 2;
        if tail.above(middle) <= doubt {
            enough = middle;
        } else {
            too_few = middle;
        }
    }
    Rational::new(Integer::from(SHARES - enough), Integer::from(SHARES))
}

/// The guarantee of the band of the least error bound for further readings from the same source.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Guarantee {
    /// The chance that the guarantee is true, at least, over all sets of so many readings.
    pub confidence: Rational,
    /// The share of further readings that lie in the band, at least; rounded down, and 0 where nothing is guaranteed.
    pub covered: Rational,
    /// The number of readings.
    pub readings: usize,
    /// The number of parameters of the band, its width among them.
    pub unknowns: u32,
}

impl Guarantee {
    /// The guarantee for readings that were fitted; `None` unless 0 < confidence < 1. Conditions on the parameters do not
    /// count: they cannot make the band worse. Cost: as of [`guaranteed_share`].
    pub fn new(measurements: &Measurements, confidence: &Rational) -> Option<Self> {
        let readings = measurements.fitted();
        let unknowns = if measurements.line_form().through_origin { 2 } else { 3 };
        let covered = guaranteed_share(readings, unknowns, confidence)?;
        Some(Guarantee { confidence: confidence.clone(), covered, readings, unknowns })
    }
}

/// The sum as a function of p.
struct Tail {
    readings: u64,
    unknowns: u64,
    /// All numbers are whole numbers of 2^-bits.
    bits: u64,
}

impl Tail {
    /// A number that is not below the sum for p = `missed`·10⁻¹⁸.
    fn above(&self, missed: u64) -> Integer {
        let share = |count: u64| {
            rounded_up(&(Integer::from(count) * Integer::power_of_two(self.bits)), &Integer::from(SHARES))
        };
        let (miss, hit) = (share(missed), share(SHARES - missed));
        let terms = self.unknowns.min(self.readings + 1);
        // The power of the last term, and from there on backwards one factor more for each.
        let mut power = self.power(&hit, self.readings + 1 - terms);
        let mut sum = Integer::zero();
        for index in (0..terms).rev() {
            let term = self.product(&self.power(&miss, index), &power);
            sum = sum + term * combinations(self.readings, index);
            power = self.product(&power, &hit);
        }
        sum
    }

    /// Returns a number that is not below the product.
    fn product(&self, one: &Integer, other: &Integer) -> Integer {
        rounded_up(&(one * other), &Integer::power_of_two(self.bits))
    }

    /// Returns a number that is not below the power of a number that is not negative.
    fn power(&self, base: &Integer, exponent: u64) -> Integer {
        let mut power = Integer::power_of_two(self.bits);
        for bit in (0..u64::BITS - exponent.leading_zeros()).rev() {
            power = self.product(&power, &power);
            if exponent >> bit & 1 == 1 {
                power = self.product(&power, base);
            }
        }
        power
    }
}

/// The quotient, rounded up.
fn rounded_up(dividend: &Integer, divisor: &Integer) -> Integer {
    -(-dividend).div_rem_floor(divisor).0
}

/// Returns the number of choices.
fn combinations(of: u64, chosen: u64) -> Integer {
    (0..chosen).fold(Integer::one(), |count, index| {
        (count * Integer::from(of - index)).quotient(&Integer::from(index + 1))
    })
}
