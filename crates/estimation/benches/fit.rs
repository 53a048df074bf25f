//! The whole fit, proofs included, of readings in memory.

use boundfit_estimation::{ErrorBound, Measurement, Measurements, Model, Problem, fit};
use boundfit_exact::Rational;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// A line sampled with four decimals, with uniform noise below the error bound.
fn noisy_line(count: i64) -> Problem {
    let mut state: u64 = 7;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as i64 % 4001 - 2000
    };
    let epsilon = Rational::ratio(1, 4);
    let rows = (0..count).map(|k| {
        let x = (k - count / 2) * 100_000 / count;
        Measurement {
            row: k as usize + 1,
            regressor: [Rational::ratio(x, 10_000), Rational::one()],
            response: Rational::ratio(18 * x + 227_000 + noise(), 10_000),
            epsilon: epsilon.clone(),
        }
    });
    let model = Model::Line { x: "x".to_owned() };
    let bound = ErrorBound::Uniform(epsilon.clone());
    Problem {
        measurements: Measurements::new(model, "y".to_owned(), bound, rows.collect()),
        conditions: Vec::new(),
    }
}

fn whole_fit(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fit");
    group.sample_size(10);
    for count in [23, 10_000] {
        let problem = noisy_line(count);
        group.bench_with_input(BenchmarkId::new("noisy line", count), &problem, |bencher, problem| {
            bencher.iter(|| fit(problem));
        });
    }
    group.finish();
}

criterion_group!(benches, whole_fit);
criterion_main!(benches);
