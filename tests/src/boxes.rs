//! Lines among boxes, straight from the definition of weak and strong agreement: every crossing of the lines through the
//! corners is tried. Fractions of `num-rational`; nothing of the engine.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A fraction.
pub type Q = BigRational;
/// θ1 and θ2.
pub type Theta = [Q; 2];

/// A reading: its box, of which a side may be missing.
#[derive(Debug, Clone)]
pub struct BoxReading {
    /// x.
    pub x: Q,
    /// δ.
    pub width: Q,
    /// The least value of y.
    pub lower: Option<Q>,
    /// The largest value of y.
    pub upper: Option<Q>,
}

/// Readings and conditions a1·θ1 + a2·θ2 ≤ b.
#[derive(Debug, Clone)]
pub struct Boxes {
    /// The readings.
    pub readings: Vec<BoxReading>,
    /// The conditions.
    pub conditions: Vec<[Q; 3]>,
    /// True if a line must agree with a reading for all x in its box, and not only for some.
    pub is_strong: bool,
}

/// A line a1·θ1 + a2·θ2 = b.
type Boundary = [Q; 3];

impl BoxReading {
    /// Returns the reading with all bounds multiplied; a reading without both bounds on y, or with bounds that cross,
    /// keeps its bounds.
    fn times(&self, factor: &Q) -> BoxReading {
        let mut own = BoxReading { width: &self.width * factor, ..self.clone() };
        if let (Some(lower), Some(upper)) = (&self.lower, &self.upper)
            && lower <= upper
        {
            let two = Q::from_integer(2.into());
            let (middle, half) = ((lower + upper) / &two, (upper - lower) / &two);
            own.lower = Some(&middle - &half * factor);
            own.upper = Some(middle + half * factor);
        }
        own
    }
}

impl Boxes {
    /// Returns the boxes with all bounds multiplied.
    pub fn times(&self, factor: &Q) -> Boxes {
        let readings = self.readings.iter().map(|reading| reading.times(factor)).collect();
        Boxes { readings, ..self.clone() }
    }

    /// The definition: |y - θ1·x - θ2| ≤ ε ± |θ1|·δ.
    pub fn contain(&self, [theta1, theta2]: &Theta) -> bool {
        let meets = |reading: &BoxReading| {
            let value = theta1 * &reading.x + theta2;
            let slack =
                if self.is_strong { -theta1.abs() * &reading.width } else { theta1.abs() * &reading.width };
            reading.lower.as_ref().is_none_or(|lower| lower - &slack <= value)
                && reading.upper.as_ref().is_none_or(|upper| value <= upper + &slack)
        };
        let holds = |[a1, a2, b]: &[Q; 3]| &(a1 * theta1 + a2 * theta2) <= b;
        self.readings.iter().all(meets) && self.conditions.iter().all(holds)
    }

    /// The boundaries that matter to lines whose slope has this sign; with 0 to any.
    fn boundaries(&self, sign: i64) -> Vec<Boundary> {
        let one = Q::from_integer(1.into());
        let mut all = self.conditions.clone();
        for BoxReading { x, width, lower, upper } in &self.readings {
            // The bound moves with |θ1|·δ: out where lines meet the box, and in where they keep to it all along.
            let outward = if self.is_strong { -1 } else { 1 };
            for (bound, outward) in [(upper, outward), (lower, -outward)] {
                let Some(bound) = bound else { continue };
                let both = [1, -1];
                let signs: &[i64] = if sign == 0 { &both } else { &[sign] };
                for sign in signs {
                    let direction = Q::from_integer((sign * outward).into());
                    all.push([x - direction * width, one.clone(), bound.clone()]);
                }
            }
        }
        if sign != 0 {
            all.push([one, Q::zero(), Q::zero()]);
        }
        all
    }

    /// Every corner of the set of lines whose slope has this sign or is 0; with 0 of the set of all lines, where that is convex.
    pub fn corners(&self, sign: i64) -> BTreeSet<Theta> {
        let boundaries = self.boundaries(sign);
        let mut corners = BTreeSet::new();
        for (index, [a, b, c]) in boundaries.iter().enumerate() {
            for [d, e, f] in &boundaries[index + 1..] {
                let determinant = a * e - b * d;
                if determinant.is_zero() {
                    continue;
                }
                let theta = [(c * e - b * f) / &determinant, (a * f - c * d) / &determinant];
                if is_on_side(sign, &theta[0]) && !corners.contains(&theta) && self.contain(&theta) {
                    corners.insert(theta);
                }
            }
        }
        corners
    }

    /// Returns whether some line agrees. Each side has a corner if it has a point, since no boundary that matters to a reading is vertical.
    pub fn have_a_line(&self) -> bool {
        [1, -1].iter().any(|sign| !self.corners(*sign).is_empty())
    }

    /// Returns whether the lines of one side, of which there must be one, go on for ever so that this form of θ grows.
    pub fn are_endless(&self, sign: i64, form: [i64; 2]) -> bool {
        let boundaries = self.boundaries(sign);
        let form = form.map(|own| Q::from_integer(own.into()));
        let directions = boundaries
            .iter()
            .flat_map(|[a, b, _]| [[-b, a.clone()], [b.clone(), -a], [a.clone(), b.clone()], [-a, -b]]);
        let leaves = |[d1, d2]: &[Q; 2]| {
            let zero = |own: &BoxReading| BoxReading {
                lower: own.lower.as_ref().map(|_| Q::zero()),
                upper: own.upper.as_ref().map(|_| Q::zero()),
                ..own.clone()
            };
            let cone = Boxes {
                readings: self.readings.iter().map(zero).collect(),
                conditions: self
                    .conditions
                    .iter()
                    .map(|[a, b, _]| [a.clone(), b.clone(), Q::zero()])
                    .collect(),
                is_strong: self.is_strong,
            };
            !cone.contain(&[d1.clone(), d2.clone()])
        };
        let mut directions = directions.filter(|own| {
            is_on_side(sign, &own[0]) && (&own[0] * &form[0] + &own[1] * &form[1]).is_positive()
        });
        directions.any(|own| !leaves(&own))
    }
}

fn is_on_side(sign: i64, slope: &Q) -> bool {
    match sign {
        0 => true,
        1 => !slope.is_negative(),
        _ => !slope.is_positive(),
    }
}
