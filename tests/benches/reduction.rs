//! Measures the way from columns to touching points, beside the time of merely summing the columns.

use std::hint::black_box;

use boundfit_geometry::grid::{GridPoint, touching, touching_doubles, touching_of_columns};
use criterion::{Criterion, criterion_group, criterion_main};

/// Two columns.
type Columns = (Vec<i64>, Vec<i64>);

/// The number of rows that are listed for each point.
const MOST: usize = 1000;

/// Pseudo-random numbers below 2³¹.
fn numbers() -> impl FnMut() -> i64 {
    let mut state: u64 = 1;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as i64
    }
}

/// Seven digits of x, a line, noise of a thousandth of its rise.
fn noisy_line(rows: usize) -> Columns {
    let mut next = numbers();
    (0..rows)
        .map(|_| {
            let x = next() % 10_000_000;
            (x, 12_345 + 3 * x / 4 + next() % 7_500)
        })
        .unzip()
}

fn sorted(columns: &Columns) -> Columns {
    let mut rows: Vec<(i64, i64)> = columns.0.iter().copied().zip(columns.1.iter().copied()).collect();
    rows.sort_unstable();
    rows.into_iter().unzip()
}

/// Few levels of x and of y.
fn ties(rows: usize) -> Columns {
    let mut next = numbers();
    (0..rows)
        .map(|_| {
            let x = next() % 20;
            (1_000 * x, 2_000 * x + next() % 10)
        })
        .unzip()
}

/// x over ten decades.
fn decades(rows: usize) -> Columns {
    let mut next = numbers();
    (0..rows)
        .map(|_| {
            let x = 10_f64.powf(next() as f64 / 2_f64.powi(31) * 10.0) as i64;
            (x, 3 * x + next() % 1_000)
        })
        .unzip()
}

/// Every point is a corner of the lower hull; in shuffled order.
fn parabola(rows: i64) -> Columns {
    // Steps of a number without common divisors visit every point once.
    (0..rows).map(|k| k * 61_803 % rows - rows / 2).map(|x| (x, x * x)).unzip()
}

/// Every point is a corner, half of them of the upper hull: steps in all coprime directions; in shuffled order.
fn round(rows: usize) -> Columns {
    fn gcd(a: i64, b: i64) -> i64 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    let size = (rows as f64 * 0.41).sqrt() as i64 + 1;
    let directions = (1..=size).flat_map(|dx| (-size..=size).map(move |dy| (dx, dy)));
    let mut steps: Vec<(i64, i64)> = directions.filter(|&(dx, dy)| gcd(dx, dy) == 1).collect();
    steps.sort_by(|a, b| (a.1 * b.0).cmp(&(b.1 * a.0)));
    let mut at = (0, 0);
    let mut corners: Vec<(i64, i64)> = Vec::new();
    for (dx, dy) in steps.into_iter().take(rows / 2) {
        at = (at.0 + dx, at.1 + dy);
        // The mirror image, far above.
        corners.extend([at, (at.0, 100_000_000 - at.1)]);
    }
    (0..corners.len()).map(|k| corners[k * 61_803 % corners.len()]).unzip()
}

fn points((x, y): &Columns) -> Vec<GridPoint> {
    let point = |(row, (&x, &y)): (usize, (&i64, &i64))| GridPoint::of_row(x, y, row as u64);
    x.iter().zip(y).enumerate().map(point).collect()
}

fn reduction(criterion: &mut Criterion) {
    const ROWS: usize = 1_000_000;
    let mut group = criterion.benchmark_group("reduction");
    group.sample_size(30);
    let noise = noisy_line(ROWS);
    group.bench_function("sum of both columns, 10^6", |bencher| {
        let sum =
            |column: &[i64]| black_box(column).iter().fold(0_i64, |sum, value| sum.wrapping_add(*value));
        bencher.iter(|| (sum(&noise.0), sum(&noise.1)));
    });
    for (name, columns) in [
        ("uniform noise", &noise),
        ("sorted", &sorted(&noise)),
        ("heavy ties", &ties(ROWS)),
        ("ten decades", &decades(ROWS)),
        ("every point extreme", &parabola(ROWS as i64)),
        ("constant x", &(vec![5; ROWS], noise.1.clone())),
        ("constant y", &(noise.0.clone(), vec![5; ROWS])),
    ] {
        group.bench_function(format!("touching points of columns, {name}, 10^6"), |bencher| {
            bencher.iter(|| touching_of_columns(&columns.0, &columns.1, &|row| row as u64, MOST));
        });
    }
    let doubles = |column: &[i64]| column.iter().map(|&value| value as f64 / 1e4).collect::<Vec<f64>>();
    let (x, y) = (doubles(&noise.0), doubles(&noise.1));
    group.bench_function("touching points of doubles, uniform noise, 10^6", |bencher| {
        bencher.iter(|| touching_doubles(&x, &y, &|row| row as u64, MOST));
    });
    group.finish();
}

fn all_extreme(criterion: &mut Criterion) {
    const ROWS: i64 = 100_000;
    let mut group = criterion.benchmark_group("every point extreme, 10^5");
    group.sample_size(20);
    for (name, columns) in [("parabola", parabola(ROWS)), ("round", round(ROWS as usize))] {
        let points = points(&columns);
        group.bench_function(format!("{name}, sorting and hulls"), |bencher| {
            bencher.iter(|| touching(points.clone(), MOST));
        });
    }
    group.finish();
}

criterion_group!(benches, reduction, all_extreme);
criterion_main!(benches);
