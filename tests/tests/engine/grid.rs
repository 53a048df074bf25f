//! Touching points on the integer grid: against the definition and against the general algorithms.

use boundfit_exact::{Integer, Rational, Sign};
use boundfit_geometry::grid::{self, GridPoint, Sieve, candidates_of_columns};
use boundfit_geometry::predicates::{lexicographic, orientation};
use boundfit_geometry::{Hulls, Point};
use boundfit_tests::columns::{Columns, Shape, points};
use boundfit_tests::generate::seeded;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Finds touching points by the definition. A point is above the lower hull if another point is below it. It is also
/// above if the line from a point on its left to a point on its right passes below it. The upper hull is the mirror
/// image.
fn touching_by_definition(points: &[GridPoint]) -> Vec<u64> {
    let wide = |value: i64| Integer::from(value);
    // Positive when the line from p to q passes below r.
    let height = |p: &GridPoint, q: &GridPoint, r: &GridPoint| {
        ((wide(q.x) - wide(p.x)) * (wide(r.y) - wide(p.y))
            - (wide(q.y) - wide(p.y)) * (wide(r.x) - wide(p.x)))
        .sign()
    };
    let is_beyond = |r: &GridPoint, side: Sign| {
        points.iter().any(|p| p.x == r.x && Sign::from(r.y.cmp(&p.y)) == side)
            || points
                .iter()
                .filter(|p| p.x < r.x)
                .any(|p| points.iter().filter(|q| q.x > r.x).any(|q| height(p, q, r) == side))
    };
    let is_touching = |r: &&GridPoint| !(is_beyond(r, Sign::Positive) && is_beyond(r, Sign::Negative));
    let mut touching: Vec<u64> = points.iter().filter(is_touching).map(|point| point.rows.first()).collect();
    touching.sort_unstable();
    touching
}

/// The numbers of all rows that touching points stand for, each of which is there once.
fn rows_of(touching: &[GridPoint]) -> Vec<u64> {
    let mut rows: Vec<u64> = touching.iter().flat_map(|point| point.rows.rows()).collect();
    rows.sort_unstable();
    assert_eq!(rows.len() as u64, touching.iter().map(|point| point.rows.count()).sum::<u64>());
    rows
}

/// The touching points of all, with all rows listed.
fn touching(points: Vec<GridPoint>) -> Vec<GridPoint> {
    grid::touching(points, usize::MAX)
}

fn touching_of_columns(x: &[i64], y: &[i64], first: u64) -> Vec<GridPoint> {
    grid::touching_of_columns(x, y, &|row| first + row as u64, usize::MAX)
}

/// The positions of doubles that touch a hull.
fn touching_doubles(x: &[f64], y: &[f64]) -> Vec<usize> {
    let touching = grid::touching_doubles(x, y, &|row| row as u64, usize::MAX);
    let mut rows: Vec<usize> =
        touching.iter().flat_map(|place| place.rows.rows()).map(|row| row as usize).collect();
    rows.sort_unstable();
    rows
}

/// Positions, ascending, of the touching ones by the hulls of rational points.
fn touching_by_rationals(points: &[Point]) -> Vec<usize> {
    let mut sorted = points.to_vec();
    sorted.sort_by(lexicographic);
    let Hulls { lower, upper } = Hulls::of_sorted(&sorted);
    let is_on = |hull: &[usize], r: &Point| {
        let corner = |place: usize| &sorted[hull[place]];
        (0..hull.len()).any(|place| corner(place) == r)
            || (1..hull.len()).any(|place| {
                let (p, q) = (corner(place - 1), corner(place));
                orientation(p, q, r) == Sign::Zero
                    && lexicographic(p, r).is_lt()
                    && lexicographic(r, q).is_lt()
            })
    };
    (0..points.len()).filter(|&k| is_on(&lower, &points[k]) || is_on(&upper, &points[k])).collect()
}

/// Generated sets of every shape.
fn cases(seed: u64, rounds: usize, largest: usize) -> impl Iterator<Item = (Shape, Columns, ChaCha8Rng)> {
    let mut rng = seeded(seed);
    (0..rounds).flat_map(move |_| {
        Shape::ALL.map(|shape| {
            let count = rng.random_range(0..=largest);
            (shape, shape.columns(&mut rng, count), rng.clone())
        })
    })
}

#[test]
fn touching_points_are_those_of_the_definition() {
    for (shape, columns, _) in cases(1, 2_000, 9) {
        let points = points(&columns);
        assert_eq!(
            rows_of(&touching(points.clone())),
            touching_by_definition(&points),
            "{shape:?} {columns:?}"
        );
    }
}

#[test]
fn touching_points_are_those_of_the_general_hulls() {
    for (shape, columns, _) in cases(2, 150, 60) {
        let points = points(&columns);
        let rational = |point: &GridPoint| Point::new(&point.x.into(), &point.y.into());
        let rationals: Vec<Point> = points.iter().map(rational).collect();
        let expected: Vec<u64> =
            touching_by_rationals(&rationals).into_iter().map(|position| position as u64).collect();
        assert_eq!(rows_of(&touching(points)), expected, "{shape:?} {columns:?}");
    }
}

#[test]
fn points_above_each_other_at_the_ends_touch_only_at_top_and_bottom() {
    let columns = (vec![0, 0, 0, 1, 1, 2, 2, 2, 2], vec![0, 5, 9, -4, 7, 3, 4, 4, 4]);
    let ids = rows_of(&touching(points(&columns)));
    // In the middle, 7 is on the line from 9 to 4 only if that were lower; at the right end, 4 is there three times.
    assert_eq!(ids, [0, 2, 3, 4, 5, 6, 7, 8]);
    let above = (vec![3; 5], vec![2, 1, 2, 3, 1]);
    assert_eq!(rows_of(&touching(points(&above))), [1, 3, 4]);
}

#[test]
fn parts_reduced_first_reduce_to_the_same() {
    for (shape, columns, mut rng) in cases(3, 400, 80) {
        let points = points(&columns);
        let whole = touching(points.clone());
        let parts = rng.random_range(1..=5);
        let mut split = vec![Vec::new(); parts];
        for point in points {
            split[rng.random_range(0..parts)].push(point);
        }
        let reduced: Vec<GridPoint> = split.into_iter().flat_map(touching).collect();
        assert_eq!(touching(reduced), whole, "{shape:?} {columns:?}");
        assert_eq!(touching(whole.clone()), whole);
    }
}

#[test]
fn columns_have_the_touching_points_of_their_points() {
    for (shape, columns, _) in cases(4, 60, 400) {
        let (x, y) = &columns;
        assert_eq!(touching_of_columns(x, y, 0), touching(points(&columns)), "{shape:?}");
    }
}

#[test]
fn long_columns_have_the_same_touching_points() {
    for shape in Shape::ALL {
        let columns = shape.columns(&mut seeded(5), 200_000);
        let (x, y) = &columns;
        assert_eq!(touching_of_columns(x, y, 0), touching(points(&columns)), "{shape:?}");
    }
}

#[test]
fn wide_columns_keep_every_touching_point_and_few_others() {
    let (mut rows, mut kept) = (0, 0);
    for (shape, (x, y), mut rng) in cases(73, 30, 3000) {
        // Growing and moving the plane changes no hull.
        let factors = [0; 2].map(|_| 1_i128 << rng.random_range(0..=60));
        let grown = |column: &[i64], factor: i128| -> Vec<i128> {
            column.iter().map(|&value| i128::from(value) * factor + 12_345_678_901_234_567_890).collect()
        };
        let row = |row: usize| row as u64;
        let candidates =
            candidates_of_columns(&grown(&x, factors[0]), &grown(&y, factors[1]), &row, usize::MAX);
        let mut candidates: Vec<u64> = candidates.iter().flat_map(|place| place.rows.rows()).collect();
        candidates.sort_unstable();
        for row in rows_of(&touching_of_columns(&x, &y, 0)) {
            assert!(candidates.binary_search(&row).is_ok(), "{shape:?} {row}");
        }
        if shape == Shape::NoisyLine && x.len() > 1000 {
            rows += x.len();
            kept += candidates.len();
        }
    }
    // Some are lines of two levels, on which every point touches.
    assert!(3 * kept < 2 * rows, "{kept} of {rows}");
}

#[test]
fn a_sieve_of_the_first_rows_loses_nothing_of_the_others() {
    let mut sieves = 0;
    for (shape, columns, mut rng) in cases(74, 60, 1500) {
        let (x, y) = &columns;
        let first = rng.random_range(0..=x.len());
        let known = touching_of_columns(&x[..first], &y[..first], 0);
        let Some(sieve) = Sieve::new(&known) else { continue };
        sieves += 1;
        let mut all = known;
        let row = |row: usize| (first + row) as u64;
        all.extend(sieve.touching_of_columns(&x[first..], &y[first..], &row, usize::MAX));
        assert_eq!(touching(all), touching(points(&columns)), "{shape:?} {first} {columns:?}");
    }
    assert!(sieves > 300, "{sieves}");
}

/// Differences of these coordinates just fit into 64 bits or just do not.
#[test]
fn coordinates_at_the_limit_of_narrow_arithmetic_are_exact() {
    const LIMIT: i64 = 1 << 62;
    for (x, y, inner) in [
        // The point next to the origin is inside, by one unit.
        (vec![-LIMIT, 0, 0, LIMIT], vec![-LIMIT / 2, 1, LIMIT / 2, LIMIT / 2], Some(1)),
        (vec![1 - LIMIT, 0, 0, LIMIT - 1], vec![-LIMIT / 2, 1, LIMIT / 2, LIMIT / 2 - 1], Some(1)),
        (vec![i64::MIN, 0, 0, i64::MAX], vec![-LIMIT, 1, LIMIT, LIMIT], Some(1)),
        (vec![i64::MIN, i64::MIN + 1, i64::MIN + 1, i64::MAX], vec![0, 5, 10, 0], Some(1)),
        // All three are corners.
        (vec![-LIMIT / 2, 0, LIMIT / 2], vec![-LIMIT, -1, LIMIT], None),
        (vec![-LIMIT / 2, 0, LIMIT / 2], vec![1 - LIMIT, -1, LIMIT - 1], None),
        (vec![-1, 0, 1], vec![-LIMIT, -LIMIT, LIMIT], None),
        (vec![-1, 0, 1], vec![i64::MIN, i64::MIN, i64::MAX], None),
    ] {
        let points = points(&(x, y));
        let rows = points.iter().map(|point| point.rows.first());
        let expected: Vec<u64> = rows.filter(|row| Some(*row) != inner).collect();
        assert_eq!(touching_by_definition(&points), expected, "{points:?}");
        assert_eq!(rows_of(&touching(points.clone())), expected, "{points:?}");
    }
    // As numbers of binary64, all in units of the last place of 1.
    let limit = LIMIT as f64;
    assert_eq!(touching_doubles(&[-limit, 1.0, 0.0, limit], &[-limit, 2.0, limit / 2.0, limit]), [0, 2, 3]);
}

/// Products next to the least binary64, of differences that are rounded: their order is the wrong one.
#[test]
fn a_turn_that_underflow_hides_is_found() {
    let unit = 2_f64.powi(-537);
    let last = f64::EPSILON / 2.0;
    let [left, inner, right, top] =
        [(-0.875 * last, -1.375 * last), (0.5 - last, 0.5 - last), (1.0, 1.0), (0.25, 5.0)]
            .map(|(x, y)| (x * unit, y * unit));
    // The line from left to right passes below the inner point.
    let rounded = (inner.0 - left.0) * (right.1 - left.1) - (inner.1 - left.1) * (right.0 - left.0);
    assert_eq!(rounded, f64::from_bits(1));
    let (x, y): (Vec<f64>, Vec<f64>) = [left, inner, right, top].into_iter().unzip();
    assert_eq!(touching_doubles(&x, &y), [0, 2, 3]);
}

#[test]
fn ids_count_from_the_first() {
    let ids = |first: u64| rows_of(&touching_of_columns(&[0, 1, 2], &[0, 9, 0], first));
    assert_eq!(ids(1 << 40), [1 << 40, (1 << 40) + 1, (1 << 40) + 2]);
}

/// Columns of doubles that are hard in their own ways, besides the shapes.
fn doubles(rng: &mut ChaCha8Rng, count: usize) -> (Vec<f64>, Vec<f64>) {
    let shape = Shape::ALL[rng.random_range(0..Shape::ALL.len())];
    let (x, y) = shape.columns(rng, count);
    let [x_unit, y_unit] =
        [(); 2].map(|()| [1.0, 0.1, 1e-5, 1e280, 1e-162, 1e-290, 1e-323][rng.random_range(0..7)]);
    let style = rng.random_range(0..6);
    let slope = rng.random_range(-2.0..2.0_f64);
    let least = [6, 100, 10_000][rng.random_range(0..3)];
    x.iter()
        .zip(&y)
        .map(|(&x, &y)| {
            let (x, y) = (x as f64 * x_unit, y as f64 * y_unit);
            match style {
                // Collinear but for the roundings.
                0 => (x / 3.0, slope * (x / 3.0) + 0.7 * x_unit),
                // Any exponents.
                1 => {
                    let mut any =
                        || rng.random_range(-2.0..2.0_f64) * 10_f64.powi(rng.random_range(-308..308));
                    (any(), any())
                }
                // The numbers next to zero, and both zeros.
                2 => {
                    let mut any =
                        || f64::from_bits(rng.random_range(0..least) | u64::from(rng.random_bool(0.5)) << 63);
                    (any(), any())
                }
                // A line with noise, of such numbers.
                3 => {
                    let x = rng.random_range(0..least);
                    (f64::from_bits(x), f64::from_bits(3 * x / 7 + rng.random_range(0..3)))
                }
                4 if rng.random_bool(0.05) => (f64::MAX, if rng.random_bool(0.5) { f64::MIN } else { y }),
                _ => (x, y),
            }
        })
        .map(|(x, y)| (x.clamp(f64::MIN, f64::MAX), y.clamp(f64::MIN, f64::MAX)))
        .unzip()
}

#[test]
fn doubles_have_the_touching_points_of_their_exact_values() {
    let mut rng = seeded(6);
    for round in 0..1_500 {
        let count = if round % 10 == 0 { 120 } else { 15 };
        let (x, y) = doubles(&mut rng, count);
        let exact = |value: f64| Rational::from_f64(value).unwrap();
        let points: Vec<Point> = x.iter().zip(&y).map(|(&x, &y)| Point::new(&exact(x), &exact(y))).collect();
        let expected = touching_by_rationals(&points);
        assert_eq!(touching_doubles(&x, &y), expected, "{x:?} {y:?}");
    }
}

#[test]
fn whole_numbers_touch_alike_as_integers_and_as_doubles() {
    for shape in [Shape::Levels, Shape::NoisyLine, Shape::Parabola, Shape::Outlier] {
        let (x, y) = shape.columns(&mut seeded(7), 100_000);
        let double = |column: &[i64]| column.iter().map(|&value| value as f64).collect::<Vec<f64>>();
        let rows = rows_of(&touching_of_columns(&x, &y, 0)).into_iter().map(|row| row as usize);
        assert_eq!(touching_doubles(&double(&x), &double(&y)), rows.collect::<Vec<_>>(), "{shape:?}");
    }
}

#[test]
fn rows_without_a_place_are_kept_and_change_nothing() {
    let mut x: Vec<f64> = (0..2_000).map(|k| f64::from(k * 37 % 2_000)).collect();
    let mut y: Vec<f64> = (0..2_000).map(|k| f64::from(k * 53 % 1_999)).collect();
    let without = touching_doubles(&x, &y);
    let nowhere =
        [(f64::NAN, 0.0), (5.0, f64::INFINITY), (f64::NEG_INFINITY, f64::NAN), (f64::INFINITY, 1.0)];
    for (nowhere_x, nowhere_y) in nowhere {
        x.push(nowhere_x);
        y.push(nowhere_y);
    }
    let expected: Vec<usize> = without.into_iter().chain(2_000..2_004).collect();
    assert_eq!(touching_doubles(&x, &y), expected);
}
