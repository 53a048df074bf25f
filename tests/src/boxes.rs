//! Lines among boxes, straight from the definition of weak and strong agreement: every crossing of the lines through the
//! corners is tried. Fractions of `num-rational`; nothing of the engine.

use std::collections::BTreeSet;

use num_bigint::BigInt;
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

/// The point (x/w, y/w), w > 0, as x, y, w: no fraction is reduced until a point is a corner.
type Point = [BigInt; 3];

/// Readings and conditions multiplied by what makes them integers.
struct Definition {
    readings: Vec<WholeReading>,
    conditions: Vec<[BigInt; 3]>,
}

/// A reading, times `unit`.
struct WholeReading {
    x: BigInt,
    /// δ, negative under strong agreement.
    width: BigInt,
    bounds: [Option<BigInt>; 2],
    unit: BigInt,
}

impl Definition {
    fn holds(&self, [x, y, w]: &Point) -> bool {
        let meets = |WholeReading { x: own, width, bounds: [lower, upper], unit }: &WholeReading| {
            let value = x * own + y * unit;
            let slack = if x.is_negative() { -x * width } else { x * width };
            lower.as_ref().is_none_or(|lower| lower * w - &slack <= value)
                && upper.as_ref().is_none_or(|upper| value <= upper * w + &slack)
        };
        self.readings.iter().all(meets) && self.conditions.iter().all(|[a1, a2, b]| a1 * x + a2 * y <= b * w)
    }
}

/// Fractions times their least common denominator, and that denominator.
fn whole<const N: usize>(fractions: [&Q; N]) -> ([BigInt; N], BigInt) {
    // A unit over a denominator, reduced, has the denominator's factors that the unit lacks.
    let lacking = |unit: &BigInt, own: &Q| Q::new(unit.clone(), own.denom().clone()).denom().clone();
    let unit = fractions.iter().fold(BigInt::from(1), |unit, own| &unit * lacking(&unit, own));
    (fractions.map(|own| own.numer() * (&unit / own.denom())), unit)
}

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
        let ([x, y], w) = whole([theta1, theta2]);
        self.definition().holds(&[x, y, w])
    }

    /// The definition in integers.
    fn definition(&self) -> Definition {
        let reading = |BoxReading { x, width, lower, upper }: &BoxReading| {
            let zero = Q::zero();
            let bounds = [lower, upper].map(|bound| bound.as_ref().unwrap_or(&zero));
            let ([x, width, low, high], unit) = whole([x, width, bounds[0], bounds[1]]);
            let bounds = [lower.is_some().then_some(low), upper.is_some().then_some(high)];
            let width = if self.is_strong { -width } else { width };
            WholeReading { x, width, bounds, unit }
        };
        Definition {
            readings: self.readings.iter().map(reading).collect(),
            conditions: self.conditions.iter().map(|condition| whole(condition.each_ref()).0).collect(),
        }
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
        let mut corners = BTreeSet::new();
        self.each_corner(sign, |[x, y, w]| {
            corners.insert([Q::new(x, w.clone()), Q::new(y, w)]);
            true
        });
        corners
    }

    /// Visits the corners, some more than once, until a visit says that it is enough.
    fn each_corner(&self, sign: i64, mut goes_on: impl FnMut(Point) -> bool) {
        let definition = self.definition();
        let boundaries = self.boundaries(sign);
        let boundaries: Vec<[BigInt; 3]> =
            boundaries.iter().map(|boundary| whole(boundary.each_ref()).0).collect();
        for (index, [a, b, c]) in boundaries.iter().enumerate() {
            for [d, e, f] in &boundaries[index + 1..] {
                let meet = [c * e - b * f, a * f - c * d, a * e - b * d];
                let meet = if meet[2].is_negative() { meet.map(|own| -own) } else { meet };
                let is_corner =
                    meet[2].is_positive() && is_on_side(sign, &meet[0]) && definition.holds(&meet);
                if is_corner && !goes_on(meet) {
                    return;
                }
            }
        }
    }

    /// Returns whether some line agrees. Each side has a corner if it has a point, since no boundary that matters to a reading is vertical.
    pub fn have_a_line(&self) -> bool {
        [1, -1].iter().any(|sign| {
            let mut is_empty = true;
            self.each_corner(*sign, |_| {
                is_empty = false;
                false
            });
            !is_empty
        })
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

fn is_on_side(sign: i64, slope: &impl Signed) -> bool {
    match sign {
        0 => true,
        1 => !slope.is_negative(),
        _ => !slope.is_positive(),
    }
}
