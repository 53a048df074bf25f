//! Rows that the filter must keep, and how few it may.

use super::super::doubles::touching_of_places;
use super::super::{GridPoint, touching};
use super::*;

/// All rows by their positions.
const LISTING: Listing = Listing { row: &|row| row as u64, most: usize::MAX };

/// Pseudo-random bits, of which the first are the best.
fn numbers(seed: u64) -> impl FnMut() -> u64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state
    }
}

/// Rows all over a parallelogram, the same ones every time.
fn rows(count: usize) -> (Vec<i64>, Vec<i64>) {
    let mut numbers = numbers(0x2545_f491_4f6c_dd1d);
    let mut next = || (numbers() >> 34) as i64 % 1_000_000;
    (0..count)
        .map(|_| {
            let (x, above) = (next(), next());
            (x - 300_000, 3 * x + above)
        })
        .unzip()
}

fn plan(division: Option<Division>) -> Plan {
    Plan { sample: 4_000, division, exact: 256 }
}

#[test]
fn of_rows_all_over_the_place_few_survive_whatever_their_type_and_unit() {
    let (x, y) = rows(40_000);
    for division in [None, Some(Division::Equal), Some(Division::Corners)] {
        let kept = survivors(&x, &y, Some(&plan(division))).unwrap();
        assert!(kept.len() < 300, "{division:?}: {}", kept.len());
        let wide = [&x, &y].map(|column| column.iter().map(|&value| value.into()).collect::<Vec<i128>>());
        let of_words = kept;
        let kept = survivors(&wide[0], &wide[1], Some(&plan(division))).unwrap();
        // Where a cell has a corner in it, a strip, which only words have, may know better.
        assert!(of_words.iter().all(|row| kept.binary_search(row).is_ok()), "{division:?}");
        assert!(kept.len() < 300 && kept.len() - of_words.len() < 10, "{division:?}: {}", kept.len());
        // Products with powers of two are exact.
        for (x_power, y_power) in [(0, 0), (-60, -60), (0, -60), (-60, 0), (300, 0), (0, 300)] {
            let doubles = |column: &[i64], power: i32| -> Vec<f64> {
                column.iter().map(|&value| value as f64 * 2_f64.powi(power)).collect()
            };
            let (x, mut y) = (doubles(&x, x_power), doubles(&y, y_power));
            assert!(survivors(&x, &y, Some(&plan(division))).unwrap() == kept, "{x_power} {y_power}");
            // A row that has no place is in the sample, and spoils nothing.
            y[0] = f64::INFINITY;
            let others = survivors(&x, &y, Some(&plan(division))).unwrap();
            assert!(others.len() < 300 && others[0] == 0, "{division:?}: {}", others.len());
        }
    }
    // Another round, with a sample of what was left.
    assert!(2 * places(&x, &y, LISTING).len() < survivors(&x, &y, None).unwrap().len());
}

#[test]
fn the_division_that_suits_the_sample_is_taken() {
    let [equal, corners] = [Some(Division::Equal), Some(Division::Corners)];
    let by = |x: &[i64], y: &[i64], division| survivors(x, y, Some(&plan(division))).unwrap();
    let (mut x, mut y) = rows(40_000);
    assert!(by(&x, &y, equal) != by(&x, &y, corners));
    assert!(by(&x, &y, None) == by(&x, &y, equal));
    // All but one row in the same of the equal cells.
    (x[0], y[0]) = (1_000_000_000_000, 3_000_000_000_000);
    assert!(by(&x, &y, equal).len() > 2 * by(&x, &y, corners).len());
    assert!(by(&x, &y, None) == by(&x, &y, corners));
}

#[test]
fn without_rows_between_the_hulls_there_is_nothing_to_filter() {
    let x: Vec<i64> = (0..10_000).collect();
    let parabola: Vec<i64> = x.iter().map(|x| x * x).collect();
    assert_eq!(survivors(&x, &parabola, None), None);
    let all: Vec<u64> = places(&x, &parabola, LISTING).iter().map(|place| place.rows.first()).collect();
    assert_eq!(all, (0..10_000).collect::<Vec<u64>>());
    // A third of them would not be worth it either.
    let third: Vec<i64> = x.iter().map(|&x| if x % 3 == 0 { x * x + 100_000 } else { x * x }).collect();
    assert_eq!(survivors(&x, &third, None), None);
    let forced = survivors(&x, &third, Some(&plan(Some(Division::Corners)))).unwrap();
    assert!(forced.len() < 7_000, "{}", forced.len());
}

/// Plans that force every path: no filter, tiny samples, a sample of everything, both divisions.
fn plans(count: usize) -> Vec<Plan> {
    let mut plans = vec![Plan { sample: 1, division: None, exact: usize::MAX }];
    for sample in [1, 2, 3, 7, count / 2, count] {
        for division in [None, Some(Division::Equal), Some(Division::Corners)] {
            plans.push(Plan { sample, division, exact: 0 });
        }
    }
    plans
}

/// Columns that are each hard for some reason; so many styles there are.
const STYLES: u64 = 9;

fn integers(next: &mut impl FnMut() -> u64, style: u64, count: usize) -> (Vec<i64>, Vec<i64>) {
    let mut below = |size: i64| (next() >> 2) as i64 % size;
    let (slope, noise, levels) = (below(11) - 5, [1, 2, 1_000][below(3) as usize], 1 + below(6));
    let edges = [i64::MIN, -(1 << 62), -(1 << 61), -1, 0, 1 << 61, 1 << 62, i64::MAX - 1];
    let point = |k: usize| match style {
        // Ties; all on a line; a line with noise; a parabola; two clusters; a cluster and an outlier.
        0 => (below(levels), below(levels)),
        1 => (k as i64 % 50, slope * (k as i64 % 50)),
        2 => with_noise(below(100_000), slope, below(noise)),
        3 => (k as i64 - 50, (k as i64 - 50).pow(2)),
        4 => with_noise(below(1_000) + (k as i64 % 2) * 1_000_000_000_000, slope, below(noise)),
        5 => with_noise(below(1_000) + i64::from(k == count / 2) * 1_000_000_000_000, slope, below(noise)),
        // Many powers of two; the ends of 62 and 64 bits; what no float sees.
        6 => with_noise(below(1 << 50) >> below(50), slope, below(noise)),
        7 => (edges[below(8) as usize] + below(2), edges[below(8) as usize] + below(2)),
        _ => with_noise(below(1 << 58), slope, below(3)),
    };
    (0..count).map(point).unzip()
}

fn with_noise(x: i64, slope: i64, noise: i64) -> (i64, i64) {
    (x, slope * x + noise)
}

#[test]
fn by_every_plan_every_touching_point_is_left() {
    let mut next = numbers(4);
    for round in 0..60 * STYLES {
        let count = (next() >> 33) as usize % 400;
        let (x, y) = integers(&mut next, round % STYLES, count);
        let points = (0..count).map(|row| GridPoint::of_row(x[row], y[row], row as u64)).collect();
        let expected = touching(points, LISTING.most);
        for plan in plans(count) {
            let left = places_by(&x, &y, LISTING, Some(&plan)).into_iter();
            let left = left.map(|Place { x, y, rows }| GridPoint { x, y, rows }).collect();
            assert_eq!(touching(left, LISTING.most), expected, "{plan:?} {x:?} {y:?}");
        }
    }
}

/// Columns of doubles that are hard in their own ways, besides those of integers.
fn doubles(next: &mut impl FnMut() -> u64, style: u64, count: usize) -> (Vec<f64>, Vec<f64>) {
    let shape = (next() >> 33) % STYLES;
    let (x, y) = integers(next, shape, count);
    let mut below = |size: u64| (next() >> 2) % size;
    let units = [1.0, 0.1, 1e-5, 1e280, 1e-162, 1e-290, 1e-323];
    let [x_unit, y_unit] = [below(7), below(7)].map(|unit| units[unit as usize]);
    let least = [6, 100, 10_000][below(3) as usize];
    let slope = below(4_000) as f64 / 1_000.0 - 2.0;
    let point = |(&x, &y): (&i64, &i64)| {
        let (x, y) = (x as f64 * x_unit, y as f64 * y_unit);
        let mut any = |exponents: u64| {
            let mantissa = below(1 << 53) as f64 / 2_f64.powi(51) - 2.0;
            mantissa * 10_f64.powi(below(2 * exponents) as i32 - exponents as i32)
        };
        let (x, y) = match style {
            // Collinear but for the roundings; any exponents; next to zero, and both zeros; a line of such numbers; the ends.
            0 => (x / 3.0, slope * (x / 3.0) + 0.7 * x_unit),
            1 => (any(308), any(308)),
            2 => {
                let mut tiny = || f64::from_bits(below(least) | below(2) << 63);
                (tiny(), tiny())
            }
            3 => {
                let x = below(least);
                (f64::from_bits(x), f64::from_bits(3 * x / 7 + below(3)))
            }
            4 if below(20) == 0 => (f64::MAX, if below(2) == 0 { f64::MIN } else { y }),
            _ => (x, y),
        };
        (x.clamp(f64::MIN, f64::MAX), y.clamp(f64::MIN, f64::MAX))
    };
    x.iter().zip(&y).map(point).unzip()
}

#[test]
fn by_every_plan_every_touching_double_is_left() {
    let mut next = numbers(6);
    for round in 0..1_500 {
        let count = if round % 10 == 0 { 120 } else { 15 };
        let (x, y) = doubles(&mut next, round % 6, count);
        let place = |row: usize| Place { x: x[row], y: y[row], rows: Tally::one(row as u64) };
        let expected = touching_of_places((0..count).map(place).collect(), LISTING.most);
        for plan in plans(count) {
            let left = places_by(&x, &y, LISTING, Some(&plan));
            assert_eq!(touching_of_places(left, LISTING.most), expected, "{plan:?} {x:?} {y:?}");
        }
    }
}
