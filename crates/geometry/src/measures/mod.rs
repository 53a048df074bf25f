//! Area and centroid: what they round to, and their fractions, which are as long as all vertices together.

mod corners;
mod diameter;
mod exact;
mod rough;

use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;

use boundfit_exact::{Fraction, Integer, LongSum, Rational, Rounding};

use crate::constructions::mean;
use crate::point::Point;
use crate::region::{Region, RegionKind};
use corners::Corners;
use exact::ExactMoments;
use rough::RoughMoments;

impl Region {
    /// The area: 0 for everything within a line, `None` when it is infinite. Exact. Its fraction has about as many digits as
    /// all vertices together; [`Region::measures`] tells what it rounds to without it. Cost: some products of that length and
    /// a common divisor.
    pub fn area(&self) -> Option<Rational> {
        Some(self.measures().area()?.exact())
    }

    /// The centroid of a bounded region: of the area for a polygon, the mid-point of a segment, the point itself;
    /// `None` when the region is empty or unbounded. Exact. Cost: as of [`Region::area`].
    pub fn area_centroid(&self) -> Option<Point> {
        let measures = self.measures();
        let [theta1, theta2] = measures.centroid()?;
        Some(Point::new(&theta1.exact(), &theta2.exact()))
    }

    /// Area and centroid, of which nothing is computed before it is asked for, and nothing twice.
    pub fn measures(&self) -> Measures<'_> {
        Measures::new(self.kind(), Corners::Vertices(self.vertices()))
    }
}

/// Area and centroid of a region.
#[derive(Debug)]
pub struct Measures<'a> {
    kind: RegionKind,
    corners: Corners<'a>,
    /// Each with four times the bits of the one before.
    rough: [OnceCell<Option<RoughMoments>>; MOST_LEVELS],
    exact: OnceCell<ExactMoments>,
    is_on_grid: OnceCell<bool>,
}

const MOST_LEVELS: usize = 6;

/// Bits of the extent of a polygon. Products on the 40 bits of the first level fit into 128 bits.
fn bits_of(level: usize) -> u64 {
    40 << (2 * level)
}

impl<'a> Measures<'a> {
    /// Returns the measures of a region of this kind with these corners, which go around it. Where they are those of
    /// no convex polygon, the area counts each point as often as they go around it counter-clockwise.
    pub fn of(kind: RegionKind, corners: Vec<Cow<'a, Point>>) -> Self {
        Measures::new(kind, Corners::Points(corners))
    }

    fn new(kind: RegionKind, corners: Corners<'a>) -> Self {
        let rough = Default::default();
        Measures { kind, corners, rough, exact: OnceCell::new(), is_on_grid: OnceCell::new() }
    }

    /// The area: 0 for everything within a line, `None` when it is infinite.
    pub fn area(&self) -> Option<Measure<'_>> {
        match self.kind {
            RegionKind::Polygon => Some(Measure(Kind::Area { of: self, unit: Rational::one() })),
            RegionKind::UnboundedPolygon | RegionKind::Strip | RegionKind::HalfPlane | RegionKind::Plane => {
                None
            }
            _ => Some(Measure(Kind::Short(Rational::zero()))),
        }
    }

    /// The area that the corners go around, as of a polygon.
    pub fn polygon_area(&self) -> Measure<'_> {
        Measure(Kind::Area { of: self, unit: Rational::one() })
    }

    /// Returns how much the area is of another, positive one; `None` where either is not a finite positive number, except that no
    /// area is 0 of any.
    pub fn share_of(&self, whole: &Rational) -> Option<Measure<'_>> {
        let area = self.area()?;
        if !whole.is_positive() {
            return None;
        }
        Some(match area.0 {
            Kind::Area { of, .. } => Measure(Kind::Area { of, unit: whole.clone() }),
            short => Measure(short),
        })
    }

    /// The centroid of a bounded region: of the area for a polygon, the mid-point of a segment, the point itself;
    /// `None` when the region is empty or unbounded.
    pub fn centroid(&self) -> Option<[Measure<'_>; 2]> {
        match self.kind {
            RegionKind::Point | RegionKind::Segment => {
                let middle = mean(self.corners.iter());
                Some(middle.coordinates().map(|coordinate| Measure(Kind::Short(coordinate))))
            }
            RegionKind::Polygon => Some([0, 1].map(|axis| Measure(Kind::Centroid { of: self, axis }))),
            _ => None,
        }
    }

    fn exact(&self) -> &ExactMoments {
        self.exact.get_or_init(|| ExactMoments::new(&self.corners))
    }

    fn rough(&self, level: usize) -> Option<&RoughMoments> {
        let made = || RoughMoments::new(&self.corners, bits_of(level));
        self.rough.get(level)?.get_or_init(made).as_ref()
    }
}

/// A number about a region: what it rounds to is found without its fraction, which may be long.
#[derive(Debug)]
pub struct Measure<'a>(Kind<'a>);

#[derive(Debug)]
enum Kind<'a> {
    Short(Rational),
    Sum(&'a LongSum),
    /// The area in a unit.
    Area {
        of: &'a Measures<'a>,
        unit: Rational,
    },
    /// A coordinate of the centroid.
    Centroid {
        of: &'a Measures<'a>,
        axis: usize,
    },
}

impl<'a> Measure<'a> {
    /// Any other sum.
    pub fn of(sum: &'a LongSum) -> Self {
        Measure(Kind::Sum(sum))
    }

    /// The number itself. Cost: as of [`Region::area`].
    pub fn exact(&self) -> Rational {
        match &self.0 {
            Kind::Short(value) => value.clone(),
            Kind::Sum(sum) => sum.total().into(),
            Kind::Area { of, unit } => divided(of.exact().area().into(), unit),
            Kind::Centroid { of, axis } => Rational::from(of.exact().centroid(&of.corners, *axis)),
        }
    }

    /// The number itself where neither its fraction nor the common denominator of the sums that it is made of has more than
    /// so many decimal digits. Cost: common divisors of that length.
    pub fn exact_within(&self, digits: usize) -> Option<Rational> {
        let digits = u32::try_from(digits).ok()?;
        let bits = Integer::bits_of_power_of_ten(digits);
        let value = match &self.0 {
            Kind::Short(value) => value.clone(),
            Kind::Sum(sum) => sum.total_within(bits)?.into(),
            Kind::Area { of, unit } => divided(of.exact().area_within(bits)?.into(), unit),
            Kind::Centroid { of, axis } => {
                Rational::from(of.exact().centroid_within(&of.corners, *axis, bits)?)
            }
        };
        // The power itself is needed by the few numbers that have as many bits.
        let is_short = |part: Integer| match part.bits().cmp(&bits) {
            Ordering::Equal => part < Integer::power_of_ten(digits),
            order => order.is_lt(),
        };
        (is_short(value.numerator().abs()) && is_short(value.denominator())).then_some(value)
    }

    /// Returns a short number that is rounded to at most so many significant digits like this one, in every
    /// direction. It is itself a decimal of so many digits exactly where this one is that decimal. Exact in this
    /// sense: the number is enclosed ever more closely until no such decimal, nor the middle between two, is left
    /// within, and computed where one stays. Cost: linear in the vertices, unless the number is a short decimal.
    pub fn rounding_alike(&self, digits: usize) -> Rational {
        self.standing_in(digits, |_, _| true)
    }

    /// Returns a number as [`Measure::rounding_alike`] does, which also has the nearest binary64 of this one.
    pub fn rounding_alike_in_binary64(&self, digits: usize) -> Rational {
        const DIGITS_OF_BINARY64: usize = 17;
        self.standing_in(digits.max(DIGITS_OF_BINARY64), |lower, upper| lower.to_f64() == upper.to_f64())
    }

    fn standing_in(&self, digits: usize, is_alike: impl Fn(&Rational, &Rational) -> bool) -> Rational {
        // The next digit of a middle between two decimals is 5.
        let digits = digits.max(1) + 1;
        let is_settled = |(lower, upper): &(Rational, Rational)| {
            upper.rounded(digits, Rounding::Down) < *lower && is_alike(lower, upper)
        };
        let settled = self.enclosures(digits).find(is_settled);
        settled.map_or_else(|| self.among_decimals(digits), |(lower, _)| lower)
    }

    /// Ends that enclose this number, of which the first tell about so many digits, and the last almost surely all that can be
    /// told without the number itself.
    fn enclosures(&self, digits: usize) -> impl Iterator<Item = (Rational, Rational)> {
        // The number itself takes common divisors of the length of all corners: where that is long, every level is cheaper. On a
        // grid it takes less than another level does, and symmetric sets have centroids that are decimals.
        let more = match self {
            _ if self.is_long() => MOST_LEVELS,
            _ if self.is_on_grid() => 1,
            _ => 3,
        };
        let levels = match &self.0 {
            Kind::Short(_) => 0..1,
            Kind::Sum(_) | Kind::Area { .. } | Kind::Centroid { .. } => {
                // A decimal digit takes 3.33 bits; errors are a few units of the last one of these.
                let needed = 4 * digits as u64 + 12;
                let first = (0..=MOST_LEVELS).find(|level| bits_of(*level) >= needed).unwrap_or(MOST_LEVELS);
                first..MOST_LEVELS.min(first + more)
            }
        };
        levels.filter_map(|level| self.ends(level))
    }

    /// Returns whether it is made of corners of tens of thousands of bits.
    fn is_long(&self) -> bool {
        const LONG: u64 = 1 << 14;
        match &self.0 {
            Kind::Short(_) | Kind::Sum(_) => false,
            Kind::Area { of, .. } | Kind::Centroid { of, .. } => {
                of.corners.iter().any(|corner| corner.homogeneous().2.bits() > LONG)
            }
        }
    }

    /// Returns whether it is made of corners that share a short denominator.
    fn is_on_grid(&self) -> bool {
        match &self.0 {
            Kind::Short(_) | Kind::Sum(_) => false,
            Kind::Area { of, .. } | Kind::Centroid { of, .. } => {
                *of.is_on_grid.get_or_init(|| is_on_grid(&of.corners))
            }
        }
    }

    fn ends(&self, level: usize) -> Option<(Rational, Rational)> {
        match &self.0 {
            Kind::Short(value) => Some((value.clone(), value.clone())),
            Kind::Sum(sum) => Some(sum.between(bits_of(level))),
            Kind::Area { of, unit } => {
                let (lower, upper) = of.rough(level)?.area();
                Some((divided(lower, unit), divided(upper, unit)))
            }
            Kind::Centroid { of, axis } => of.rough(level)?.centroid(*axis),
        }
    }

    /// A short decimal that is this very number, or else the number.
    fn among_decimals(&self, digits: usize) -> Rational {
        let (value, unit) = match &self.0 {
            Kind::Short(value) => return value.clone(),
            Kind::Sum(sum) => (sum.total(), &Rational::one()),
            Kind::Area { of, unit } => (of.exact().area(), unit),
            Kind::Centroid { of, axis } => (of.exact().centroid(&of.corners, *axis), &Rational::one()),
        };
        let near = self.enclosures(digits).last().map(|(_, upper)| upper.rounded(digits, Rounding::Down));
        let is = |short: &Rational| Fraction::from(&(short * unit)) == value;
        near.into_iter()
            .chain([Rational::zero()])
            .find(is)
            .unwrap_or_else(|| divided(Rational::from(value), unit))
    }
}

/// Returns whether the coordinates of these points are multiples of one over a denominator of at most 64 bits.
fn is_on_grid(corners: &Corners) -> bool {
    let mut common = Integer::one();
    corners.iter().all(|corner| {
        common = common.lcm(corner.homogeneous().2);
        common.bits() <= u64::BITS.into()
    })
}

/// A quotient by a number that is not 0.
fn divided(value: Rational, unit: &Rational) -> Rational {
    value.checked_div(unit).unwrap_or_default()
}
