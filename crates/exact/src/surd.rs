//! Numbers a + b·√d with rational a, b and d: what quadratic equations with rational coefficients have as roots.

use std::cmp::Ordering;

use crate::decimal::Rounding;
use crate::number::{Integer, Rational, Sign};

/// A number a + b·√d, exactly: either rational, or the root of a quadratic equation that has no rational one.
///
/// Numbers can be compared with any others, and added and multiplied with rational numbers and those of one √d, from which
/// they come.
#[derive(Debug, Clone)]
pub struct Surd {
    rational: Rational,
    /// b; 0 for a rational number.
    times: Rational,
    /// d: positive and no square; 0 for a rational number.
    radicand: Rational,
}

impl From<Rational> for Surd {
    fn from(rational: Rational) -> Self {
        Surd { rational, times: Rational::zero(), radicand: Rational::zero() }
    }
}

impl Surd {
    /// The roots of a·z² + b·z + c, the smaller first; nothing where there is none, or every number is one. Exact.
    pub fn roots([a, b, c]: &[Rational; 3]) -> Vec<Surd> {
        let Some(over_a) = a.recip() else {
            return b.recip().map(|over_b| (-c * over_b).into()).into_iter().collect();
        };
        let middle = -(b * &over_a).half();
        // z = m ± √(m² - c/a)
        let radicand = &middle * &middle - c * over_a;
        if radicand.is_negative() {
            return Vec::new();
        }
        match square_root(&radicand) {
            Some(root) if root.is_zero() => vec![middle.into()],
            Some(root) => vec![(&middle - &root).into(), (middle + root).into()],
            None => {
                let with =
                    |times: Rational| Surd { rational: middle.clone(), times, radicand: radicand.clone() };
                vec![with(-Rational::one()), with(Rational::one())]
            }
        }
    }

    /// The number itself, where it is rational.
    pub fn rational(&self) -> Option<&Rational> {
        self.times.is_zero().then_some(&self.rational)
    }

    /// Whether it is negative, zero or positive. Exact.
    pub fn sign(&self) -> Sign {
        match (self.rational.sign(), self.times.sign()) {
            (own, Sign::Zero) => own,
            (Sign::Zero, times) => times,
            (own, times) if own == times => own,
            (own, times) => {
                let root = &self.times * &self.times * &self.radicand;
                // No square is such a root, so that neither side is the other.
                if &self.rational * &self.rational > root { own } else { times }
            }
        }
    }

    /// Σ factor·number of numbers of one √d and rational ones. Exact.
    ///
    /// # Panics
    /// When there are two different √d.
    pub fn sum<'a>(terms: impl IntoIterator<Item = (&'a Rational, &'a Surd)>) -> Surd {
        let mut sum = Surd::from(Rational::zero());
        for (factor, number) in terms {
            sum.radicand = common_radicand(&sum, number).clone();
            sum.rational = sum.rational + factor * &number.rational;
            sum.times = sum.times + factor * &number.times;
        }
        sum.settled()
    }

    /// The product of two numbers, of one √d or rational. Exact.
    ///
    /// # Panics
    /// When there are two different √d.
    pub fn product(&self, other: &Surd) -> Surd {
        let radicand = common_radicand(self, other).clone();
        let rational = &self.rational * &other.rational + &self.times * &other.times * &radicand;
        let times = &self.rational * &other.times + &self.times * &other.rational;
        Surd { rational, times, radicand }.settled()
    }

    /// 1 / number; `None` for 0. Exact.
    pub fn recip(&self) -> Option<Surd> {
        // The norm of a number is 0 for 0 only.
        let norm = &self.rational * &self.rational - &self.times * &self.times * &self.radicand;
        let over = norm.recip()?;
        Some(Surd {
            rational: &self.rational * &over,
            times: -(&self.times * over),
            radicand: self.radicand.clone(),
        })
    }

    fn settled(mut self) -> Surd {
        if self.times.is_zero() {
            self.radicand = Rational::zero();
        }
        self
    }

    /// Coprime integers a, b, c, the first that is not 0 positive, with a·z² + b·z + c = 0 for this number: b·z + c for a
    /// rational one, and else a polynomial that no other number of rational coefficients has a shorter one than.
    pub fn polynomial(&self) -> [Integer; 3] {
        let zero = Rational::zero();
        let [a, b, c] = match self.rational() {
            Some(value) => [zero, Rational::one(), -value],
            None => {
                let norm = &self.rational * &self.rational - &self.times * &self.times * &self.radicand;
                [Rational::one(), -(&self.rational + &self.rational), norm]
            }
        };
        let (integers, _) = Rational::over_common_denominator([&a, &b, &c]);
        let [a, b, c] = &integers;
        let divisor = a.gcd(b).gcd(c);
        integers.map(|integer| integer.quotient(&divisor))
    }

    /// Whether it is the larger one of the roots of its polynomial, where that has two.
    pub fn is_larger_root(&self) -> bool {
        self.times.is_positive()
    }

    /// Two rational numbers, one of them not above and the other not below, that differ by less than 2^-bits times
    /// what the number is made of; equal for a rational number. Exact. Cost: a root of so many bits.
    pub fn enclosure(&self, bits: u64) -> [Rational; 2] {
        if let Some(value) = self.rational() {
            return [value.clone(), value.clone()];
        }
        let squared = &self.times * &self.times * &self.radicand;
        let (numerator, denominator) = (squared.numerator(), squared.denominator());
        // √(n/m) = √(n·m)/m
        let scale = Integer::power_of_two(bits);
        let floor = floor_root(&(&numerator * &denominator * &scale * &scale));
        let ends = [floor.clone(), floor + Integer::one()];
        let part = |end: Integer| Rational::new(end, &denominator * &scale).unwrap_or_default();
        let [low, high] = ends.map(part);
        if self.times.is_negative() {
            [&self.rational - high, &self.rational - low]
        } else {
            [&self.rational + low, &self.rational + high]
        }
    }

    /// A rational number that is rounded like this one, to so many significant digits and to binary64; the number itself where it
    /// is rational. Exact.
    pub fn alike(&self, digits: usize, rounding: Rounding) -> Rational {
        let mut bits = 64;
        loop {
            let [low, high] = self.enclosure(bits);
            let becomes = |end: &Rational| (end.rounded(digits, rounding), end.to_finite_f64());
            if becomes(&low) == becomes(&high) {
                return high;
            }
            bits *= 2;
        }
    }

    /// The number rounded to so many significant digits. Exact: the decimal is the right one.
    pub fn rounded(&self, digits: usize, rounding: Rounding) -> Rational {
        self.alike(digits, rounding).rounded(digits, rounding)
    }
}

impl PartialEq for Surd {
    /// Whether they are one number, whatever it is made of.
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Surd {}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Surd {
    /// Exact, also of numbers that have nothing to do with each other.
    fn cmp(&self, other: &Self) -> Ordering {
        // a + b·√d against a' + b'·√d': the sign of (a - a' + b·√d) - b'·√d'.
        let left = Surd { rational: &self.rational - &other.rational, ..self.clone() };
        let squared = &other.times * &other.times * &other.radicand;
        let signs = (left.sign(), other.times.sign());
        match signs {
            (Sign::Zero, Sign::Zero) => Ordering::Equal,
            (left, right) if left != right => order(left).cmp(&order(right)),
            (sign, _) => {
                let difference = left.product(&left);
                let difference = Surd { rational: &difference.rational - squared, ..difference }.sign();
                if sign == Sign::Positive { order(difference).cmp(&0) } else { 0.cmp(&order(difference)) }
            }
        }
    }
}

fn order(sign: Sign) -> i8 {
    match sign {
        Sign::Negative => -1,
        Sign::Zero => 0,
        Sign::Positive => 1,
    }
}

fn common_radicand<'a>(one: &'a Surd, other: &'a Surd) -> &'a Rational {
    match (one.times.is_zero(), other.times.is_zero()) {
        (true, _) => &other.radicand,
        (_, true) => &one.radicand,
        _ => {
            assert!(one.radicand == other.radicand, "two different square roots");
            &one.radicand
        }
    }
}

/// The root of a number that is the square of a rational one.
fn square_root(number: &Rational) -> Option<Rational> {
    let root = |integer: &Integer| {
        let root = floor_root(integer);
        (&root * &root == *integer).then_some(root)
    };
    Rational::new(root(&number.numerator())?, root(&number.denominator())?)
}

/// The root of an integer that is not negative, rounded down, by Newton's method from above.
fn floor_root(number: &Integer) -> Integer {
    if number.is_zero() {
        return Integer::zero();
    }
    let two = Integer::from(2);
    let mut root = Integer::power_of_two(number.bits().div_ceil(2));
    loop {
        let next = (&root + number.div_rem_floor(&root).0).div_rem_floor(&two).0;
        if next >= root {
            return root;
        }
        root = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(a: i64, b: i64, c: i64) -> [Rational; 3] {
        [a, b, c].map(Rational::from)
    }

    #[test]
    fn roots_are_those_of_their_polynomial() {
        for a in -4_i64..=4 {
            for b in -6..=6 {
                for c in -5..=5 {
                    let roots = Surd::roots(&polynomial(a, b, c));
                    let expected = match (a, b) {
                        (0, 0) => 0,
                        (0, _) => 1,
                        _ => ((b * b - 4 * a * c).signum() + 1) as usize,
                    };
                    assert_eq!(roots.len(), expected, "{a} {b} {c}");
                    assert!(roots.windows(2).all(|pair| pair[0] < pair[1]));
                    for root in &roots {
                        let one = Surd::from(Rational::one());
                        let [a, b, c] = polynomial(a, b, c);
                        let value = Surd::sum([(&a, &root.product(root)), (&b, root), (&c, &one)]);
                        assert_eq!(value, Surd::from(Rational::zero()));
                        let [a, b, c] = root.polynomial().map(|integer| Rational::from(&integer));
                        assert!(Surd::roots(&[a, b, c]).contains(root) || root.rational().is_some());
                        if let Some(inverse) = root.recip() {
                            assert_eq!(inverse.product(root), one);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn order_sign_and_decimals_agree_with_doubles() {
        let mut all: Vec<Surd> = Vec::new();
        for (a, b, c) in
            [(1, 0, -2), (1, 0, -3), (1, -1, -1), (2, -3, -7), (3, 5, 1), (0, 3, -4), (4, -4, 1), (1, 0, -8)]
        {
            all.extend(Surd::roots(&polynomial(a, b, c)));
        }
        for one in &all {
            let double = one.alike(5, Rounding::Up).to_f64();
            assert_eq!(order(one.sign()), double.signum() as i8 * i8::from(double != 0.0));
            let [low, high] = one.enclosure(80);
            assert!(low <= high && Surd::from(low) <= *one && *one <= Surd::from(high));
            for other in &all {
                assert_eq!(
                    one.cmp(other),
                    double.partial_cmp(&other.alike(5, Rounding::Up).to_f64()).unwrap()
                );
            }
        }
        let golden = &Surd::roots(&polynomial(1, -1, -1))[1];
        let text = |rounding| golden.rounded(12, rounding).to_decimal(12, Rounding::Nearest);
        assert_eq!(
            (text(Rounding::Down), text(Rounding::Up)),
            ("1.61803398874".into(), "1.61803398875".into())
        );
        assert!(golden.is_larger_root());
        // √8 is 2·√2, which no radicand shows.
        assert_eq!(all[all.len() - 1].cmp(&Surd::sum([(&Rational::from(2), &all[1])])), Ordering::Equal);
    }

    #[test]
    fn roots_of_integers_are_rounded_down() {
        for number in (0_u64..2000).chain([u64::MAX, u64::MAX - 1, (1 << 52) - 1]) {
            let root = floor_root(&Integer::from(i128::from(number))).to_u64().unwrap();
            assert_eq!(root, number.isqrt());
        }
    }
}
