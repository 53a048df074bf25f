//! The runs of readings that a line agrees with, and windows that move on by one reading, in memory.

use boundfit_estimation::Problem;
use boundfit_exact::Rational;
use boundfit_questions::{LinearRange, Order, Window};
use boundfit_tests::readings::{noisy_line, with_error_bound};
use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// Error bounds, as parts of 10,000: noise is up to 2,000, so that one run has all, few runs are long, or many are short.
const BOUNDS: [(&str, i64); 4] =
    [("one run", 2_500), ("long runs", 1_990), ("runs of tens", 1_500), ("short runs", 500)];

fn noise(count: i64, bound: i64) -> Problem {
    with_error_bound(&noisy_line(count), &Rational::ratio(bound, 10_000))
}

fn ranges(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("range");
    group.sample_size(10);
    for count in [1_000, 10_000, 100_000, 1_000_000] {
        group.throughput(Throughput::Elements(count as u64));
        for (name, bound) in BOUNDS {
            let problem = noise(count, bound);
            group.bench_function(BenchmarkId::new(name, count), |bencher| {
                bencher.iter(|| LinearRange::of(&problem, Order::X));
            });
        }
    }
    group.finish();
}

/// Steps of a window in a sample: a reading goes and one comes, in turn through all rows.
const STEPS: usize = 100_000;

fn windows(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("window");
    group.sample_size(10);
    for size in [100, 1_000, 10_000, 100_000] {
        let problem = noise((size + STEPS) as i64, 2_500);
        let rows = problem.measurements.kept();
        let filled = || {
            let mut window = Window::new(&[]);
            rows[..size].iter().for_each(|row| window.push(row.clone()));
            window
        };
        group.throughput(Throughput::Elements(STEPS as u64));
        group.bench_function(BenchmarkId::new("pop and push", size), |bencher| {
            let steps = |mut window: Window| {
                for row in &rows[size..] {
                    window.pop();
                    window.push(row.clone());
                }
                window
            };
            bencher.iter_batched(filled, steps, BatchSize::LargeInput);
        });
        let window = filled();
        group.throughput(Throughput::Elements(1));
        group.bench_function(BenchmarkId::new("an answer", size), |bencher| bencher.iter(|| window.fit()));
    }
    group.finish();
}

criterion_group!(benches, ranges, windows);
criterion_main!(benches);
