//! Sums over many vertices beside naive ones, and what they round to.

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Inequality, Measure, Region, RegionKind, System, Vertex, envelope};
use boundfit_tests::generate::{rational_system, seeded, share, system, tangents};
use boundfit_tests::shape::Tally;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Twice the signed area of each triangle of a fan around the first corner, with the sum of its corners.
fn doubled_triangles(corners: &[[Rational; 2]]) -> impl Iterator<Item = (Rational, [Rational; 2])> {
    (2..corners.len()).map(move |i| {
        let (p, q, r) = (&corners[0], &corners[i - 1], &corners[i]);
        let doubled = (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0]);
        (doubled, [&p[0] + &q[0] + &r[0], &p[1] + &q[1] + &r[1]])
    })
}

/// Area and centroid of a polygon, one reduced fraction added to the next.
fn naive(region: &Region) -> (Rational, [Rational; 2]) {
    let corners: Vec<[Rational; 2]> = region.vertices().iter().map(|v| v.point().coordinates()).collect();
    let area: Rational = doubled_triangles(&corners).map(|(doubled, _)| doubled).sum();
    let moment = [0, 1].map(|axis| {
        let moment: Rational = doubled_triangles(&corners).map(|(doubled, sum)| doubled * &sum[axis]).sum();
        moment.checked_div(&(&area * Rational::from(3))).unwrap()
    });
    (area.half(), moment)
}

/// Numbers that one measure is to be printed as.
fn assert_rounds_like(measure: &Measure, exact: &Rational, tally: &mut Tally) {
    assert_eq!(measure.exact(), *exact);
    for digits in [1, 5, 17, 40] {
        let alike = measure.rounding_alike(digits);
        let also = measure.rounding_alike_in_binary64(digits);
        assert_eq!(also.to_f64().to_bits(), exact.to_f64().to_bits(), "{exact}");
        for alike in [alike, also] {
            for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                for fewer in [digits, digits.div_ceil(2)] {
                    let printed = exact.to_decimal(fewer, rounding);
                    assert_eq!(alike.to_decimal(fewer, rounding), printed, "{exact} {digits} {fewer}");
                    let own = alike.exact_decimal(fewer).is_some();
                    assert_eq!(own, exact.exact_decimal(fewer).is_some(), "{exact} {fewer}");
                }
            }
        }
    }
    tally.count(if exact.exact_decimal(6).is_some() { "short" } else { "long" });
}

fn any_polygon(rng: &mut ChaCha8Rng) -> Region {
    let many_sided = rng.random_bool(0.005);
    loop {
        let count = rng.random_range(30..=60);
        let system = if many_sided { system(&tangents(rng, count)) } else { rational_system(rng) };
        let region = envelope::intersect(&system);
        if region.kind() == RegionKind::Polygon {
            return region;
        }
    }
}

#[test]
fn sums_over_vertices_are_the_naive_ones_and_round_like_them() {
    let mut rng = seeded(71);
    let mut tally = Tally::default();
    for _ in 0..share(3_000) {
        let region = any_polygon(&mut rng);
        let (area, centroid) = naive(&region);
        let measures = region.measures();
        assert_rounds_like(&measures.area().unwrap(), &area, &mut tally);
        let third = Rational::from(3);
        let share = area.checked_div(&third).unwrap();
        assert_rounds_like(&measures.share_of(&third).unwrap(), &share, &mut tally);
        for (measure, exact) in measures.centroid().unwrap().iter().zip(&centroid) {
            assert_rounds_like(measure, exact, &mut tally);
        }
        assert_eq!(region.area(), Some(area));
        assert_eq!(region.area_centroid().unwrap().coordinates(), centroid);
    }
    tally.assert_each(500, &["short", "long"]);
}

/// A rectangle along the axes from its lower left corner.
fn rectangle(corner: &[Rational; 2], width: &Rational, height: &Rational) -> Region {
    let sides = [(1, 0, &corner[0] + width), (-1, 0, -&corner[0]), (0, 1, &corner[1] + height)];
    let sides = sides.into_iter().chain([(0, -1, -&corner[1])]);
    let sides = sides.map(|(a1, a2, b)| Inequality::new(a1.into(), a2.into(), b));
    envelope::intersect(&sides.collect::<System>())
}

/// Tries numbers on, just below and just above decimals, middles between decimals, doubles, and middles between
/// doubles.
#[test]
fn next_to_a_boundary_of_rounding_the_digits_are_those_of_the_exact_number() {
    let mut tally = Tally::default();
    let double = Rational::from_f64(0.1).unwrap();
    let next = Rational::from_f64(f64::from_bits(0.1_f64.to_bits() + 1)).unwrap();
    let boundaries = [
        Rational::ratio(123_455, 1_000_000),
        Rational::ratio(12_345, 1_000),
        Rational::ratio(1, 1000),
        Rational::ratio(999_995, 10),
        (&double + next).half(),
        double,
    ];
    let sizes = [Rational::one(), Rational::ratio(1, 3), Rational::from(1_000_000_007)];
    for boundary in &boundaries {
        for exponent in [6, 12, 40, 50, 170, 200, 500] {
            for offset in [-1, 0, 1] {
                let value = boundary + Rational::scientific(offset, -exponent);
                for size in &sizes {
                    let height = value.checked_div(size).unwrap();
                    let of_this_area = rectangle(&[size.clone(), -size], size, &height);
                    assert_rounds_like(&of_this_area.measures().area().unwrap(), &value, &mut tally);
                    let double = size + size;
                    let around = rectangle(&[&value - size, -&value - size], &double, &double);
                    let measures = around.measures();
                    let [theta1, theta2] = measures.centroid().unwrap();
                    assert_rounds_like(&theta1, &value, &mut tally);
                    assert_rounds_like(&theta2, &-&value, &mut tally);
                }
            }
        }
    }
    tally.assert_each(100, &["short", "long"]);
}

/// The fraction is given where it has so many digits, and not where it has one more.
#[test]
fn fractions_are_given_up_to_a_number_of_digits() {
    let mut rng = seeded(72);
    for _ in 0..300 {
        let region = any_polygon(&mut rng);
        let measures = region.measures();
        let area = measures.area().unwrap();
        let exact = area.exact();
        let digits = exact.numerator().to_string().len().max(exact.denominator().to_string().len());
        assert_eq!(area.exact_within(10_000), Some(exact.clone()));
        assert_eq!(area.exact_within(digits - 1), None);
        let weights = region.vertices().iter().map(Vertex::point).map(|point| point.homogeneous().2.clone());
        // The common denominator of the sum has no more than that of all vertices, squared.
        let common = weights.fold(boundfit_exact::Integer::one(), |common, weight| common.lcm(&weight));
        let enough = digits.max(2 * common.to_string().len()) + 1;
        assert_eq!(area.exact_within(enough), Some(exact));
    }
}

#[test]
fn flat_sets_have_no_area_and_a_middle() {
    let flat = rectangle(&[Rational::one(), Rational::one()], &Rational::zero(), &Rational::ratio(1, 3));
    assert_eq!(flat.kind(), RegionKind::Segment);
    let measures = flat.measures();
    let area = measures.area().unwrap();
    assert_eq!((area.exact(), area.rounding_alike(5)), (Rational::zero(), Rational::zero()));
    assert!(measures.share_of(&Rational::zero()).is_none());
    let [theta1, theta2] = measures.centroid().unwrap();
    assert_eq!((theta1.exact(), theta2.exact()), (Rational::one(), Rational::ratio(7, 6)));
    assert_eq!(theta2.rounding_alike(5).to_decimal(5, Rounding::Nearest), "1.1667");
}
