//! Readings and conditions on machine integers, a first box from pairs of readings, and walls in θ.

use boundfit_estimation::{Bounds, Measurement, Ties};
use boundfit_exact::{Integer, Rational, multiples};
use boundfit_geometry::Inequality;

use super::place::{FORBIDDEN, MOST_BITS, Place, Side, bits};

/// The number of pairs that are looked at.
const MOST_PAIRS: usize = 2048;

/// The number of pairs of which every point that is looked for may miss one.
const MISSED_PAIRS: usize = 4;

/// A reading or a condition on integers: `form·τ` lies between two values.
struct Row {
    form: [i128; 2],
    lower: Option<i128>,
    upper: Option<i128>,
    weight: u64,
    /// The position of a reading; beyond all readings that of a condition.
    owner: usize,
}

/// Readings and conditions on integers. The parameters τ are multiples of θ, sheared so that the forms lie about the axes.
pub(super) struct Counted {
    rows: Vec<Row>,
    /// Readings that every θ meets, or none.
    pub(super) others: Vec<usize>,
    /// τ1 as a form in θ, then τ2.
    forms: [[Rational; 2]; 2],
}

impl Counted {
    pub(super) fn new(measurements: &[Measurement], ties: &Ties, conditions: &[Inequality]) -> Option<Self> {
        let of_regressor = |k: usize| {
            let own = measurements.iter().map(move |own| &own.regressor[k]);
            own.chain(conditions.iter().map(move |own| &own.a[k]))
        };
        let of_bounds = measurements.iter().flat_map(|own| numbers(&own.bounds)).flatten();
        let of_bounds = of_bounds.chain(conditions.iter().map(|own| &own.b));
        let [first, second] = [multiples(of_regressor(0))?, multiples(of_regressor(1))?];
        let bounds = multiples(of_bounds.clone())?;
        let units =
            [unit(of_regressor(0), &first)?, unit(of_regressor(1), &second)?, unit(of_bounds, &bounds)?];
        let shear = Shear::of(&first, &second)?;
        let (mut rows, mut others) = (Vec::with_capacity(first.len()), Vec::new());
        let mut forms = first.iter().zip(&second).map(|(one, other)| shear.form([*one, *other]));
        let mut bounds = bounds.into_iter().map(i128::from);
        for (owner, own) in measurements.iter().enumerate() {
            let mut next = |number: &Option<&Rational>| number.is_some().then(|| bounds.next()).flatten();
            let [one, other] = numbers(&own.bounds).each_ref().map(&mut next);
            let (lower, upper) = match own.bounds {
                Bounds::Around { .. } => (Some(one? - other?), Some(one? + other?)),
                Bounds::Between { .. } => (one, other),
            };
            let form = forms.next()?;
            let crosses = lower.zip(upper).is_some_and(|(lower, upper)| lower > upper);
            if crosses || form == [0, 0] {
                others.push(owner);
            } else {
                rows.push(Row { form, lower, upper, weight: ties.count(own.row) as u64, owner });
            }
        }
        for (owner, (form, upper)) in (measurements.len()..).zip(forms.zip(bounds)) {
            if form != [0, 0] {
                rows.push(Row { form, lower: None, upper: Some(upper), weight: FORBIDDEN, owner });
            }
        }
        Some(Counted { rows, others, forms: shear.of_theta(&units)? })
    }

    /// A box around every point that misses fewer than some pairs of readings.
    pub(super) fn place(&self) -> Option<Place> {
        let is_rising = |row: &&Row| (row.form[0] < 0) == (row.form[1] < 0);
        let has_both = |row: &&Row| {
            row.lower.is_some() && row.upper.is_some() && row.weight < FORBIDDEN && !row.form.contains(&0)
        };
        let (rising, falling): (Vec<&Row>, Vec<&Row>) =
            self.rows.iter().filter(has_both).partition(is_rising);
        let pairs = rising.len().min(falling.len()).min(MOST_PAIRS);
        let certain = pairs / MISSED_PAIRS;
        let last = certain.checked_sub(1)?;
        let spread = |rows: &[&Row], k: usize| k * rows.len() / pairs;
        let mut ends: [[Vec<Rational>; 2]; 2] = Default::default();
        for k in 0..pairs {
            let ranges = ranges([rising.get(spread(&rising, k))?, falling.get(spread(&falling, k))?])?;
            for (own, range) in ends.iter_mut().zip(ranges) {
                own.iter_mut().zip(range).for_each(|(ends, end)| ends.push(end));
            }
        }
        let ranges = ends.map(|[mut lower, mut upper]| {
            let (_, lower, _) = lower.select_nth_unstable_by(last, |one, other| other.cmp(one));
            let (_, upper, _) = upper.select_nth_unstable(last);
            [lower.clone(), upper.clone()]
        });
        Place::around(&ranges, certain as u64)
    }

    /// The bounds of all rows in the units of a place.
    pub(super) fn sides(&self, place: &Place) -> Option<Vec<Side>> {
        let widest = |parts: &mut dyn Iterator<Item = i128>| parts.map(bits).max().unwrap_or(0);
        let form = widest(&mut self.rows.iter().flat_map(|row| row.form));
        let bound = widest(&mut self.rows.iter().flat_map(|row| [row.lower, row.upper]).flatten());
        let corners = place.from.iter().zip(place.widths);
        let corner = widest(&mut corners.flat_map(|(from, width)| [from - width, from + 2 * width]));
        if form + corner > MOST_BITS || bound + place.scale > MOST_BITS {
            return None;
        }
        let mut sides = Vec::with_capacity(2 * self.rows.len());
        for row in &self.rows {
            let &Row { form, lower, upper, weight, owner } = row;
            let side = |form: [i128; 2], most: i128, is_lower: bool| Side {
                form,
                most: most << place.scale,
                weight,
                owner,
                is_lower,
            };
            sides.extend(upper.map(|upper| side(form, upper, false)));
            sides.extend(lower.map(|lower| side(form.map(|part| -part), -lower, true)));
        }
        Some(sides)
    }

    /// The half-planes of a convex polygon by its corners, counter-clockwise.
    pub(super) fn walls(&self, corners: &[[i128; 2]], scale: u32) -> Vec<Inequality> {
        let next = corners.iter().cycle().skip(1);
        let wall = |([x, y], [next_x, next_y]): (&[i128; 2], &[i128; 2])| {
            let [along, up] = [next_y - y, x - next_x].map(Integer::from);
            let end = &along * &Integer::from(*x) + &up * &Integer::from(*y);
            let [along, up] = [along, up].map(|part| Rational::from(&part));
            let part = |k: usize| &along * &self.forms[0][k] + &up * &self.forms[1][k];
            Inequality::new(part(0), part(1), Rational::binary(end, -i64::from(scale)))
        };
        corners.iter().zip(next).map(wall).collect()
    }
}

/// The numbers that a reading's bounds are made of.
fn numbers(bounds: &Bounds) -> [Option<&Rational>; 2] {
    match bounds {
        Bounds::Around { response, epsilon } => [Some(response), Some(epsilon)],
        Bounds::Between { lower, upper, .. } => [lower.as_ref(), upper.as_ref()],
    }
}

/// The number that some numbers are multiples of.
fn unit<'a>(numbers: impl Iterator<Item = &'a Rational>, counts: &[i64]) -> Option<Rational> {
    let (number, count) = numbers.zip(counts).find(|(_, count)| **count != 0)?;
    number.checked_div(&Rational::from(*count))
}

/// The shear: `c1·θ1 + c2·θ2 = (c1·2^BITS - shift·c2)·τ1 + c2·τ2`.
struct Shear {
    shift: i128,
}

impl Shear {
    const BITS: u32 = 8;

    /// The shear after which the first parts add up to about zero, where the second parts are positive.
    fn of(first: &[i64], second: &[i64]) -> Option<Self> {
        let along: i128 =
            first.iter().zip(second).map(|(one, other)| i128::from(*one) * i128::from(other.signum())).sum();
        let up: i128 = second.iter().map(|other| i128::from(other.unsigned_abs())).sum();
        let shift = (along << Shear::BITS).checked_div(up)?;
        (bits(shift) <= 60).then_some(Shear { shift })
    }

    fn form(&self, [one, other]: [i64; 2]) -> [i128; 2] {
        let [one, other] = [one, other].map(i128::from);
        [(one << Shear::BITS) - self.shift * other, other]
    }

    /// The parameters τ as forms in θ; `None` for no units.
    fn of_theta(&self, [first, second, bound]: &[Rational; 3]) -> Option<[[Rational; 2]; 2]> {
        let part = first.checked_div(&(bound * Rational::from(1_i64 << Shear::BITS)))?;
        let shift = Rational::from(i64::try_from(self.shift).ok()?);
        let along = &part * &shift;
        Some([[part, Rational::zero()], [along, second.checked_div(bound)?]])
    }
}

/// The ranges of both parameters where two readings are met, which are not parallel and have both bounds.
fn ranges(pair: [&Row; 2]) -> Option<[[Rational; 2]; 2]> {
    let number = |value: i128| Integer::from(value);
    let [[p, q], [r, s]] = pair.map(|row| row.form.map(number));
    let determinant = &p * &s - &q * &r;
    let mut sums: [Integer; 2] = Default::default();
    let mut widths: [Integer; 2] = Default::default();
    for (k, row) in pair.iter().enumerate() {
        let (lower, upper) = row.lower.zip(row.upper)?;
        sums[k] = number(lower + upper);
        widths[k] = number(upper - lower);
    }
    let [[sum, other], [width, breadth]] = [&sums, &widths].map(|own| own.each_ref());
    let doubled = Integer::from(2) * &determinant;
    let range = |middle: Integer, reach: Integer| {
        let middle = Rational::new(middle, doubled.clone())?;
        let reach = Rational::new(reach, doubled.abs())?;
        Some([&middle - &reach, middle + reach])
    };
    Some([
        range(sum * &s - other * &q, width * s.abs() + breadth * q.abs())?,
        range(&p * other - &r * sum, p.abs() * breadth + r.abs() * width)?,
    ])
}
