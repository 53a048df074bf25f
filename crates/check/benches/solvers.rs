//! The PUI by four linear programs in every solver of this build, beside the exact engine.

use std::time::Duration;

use boundfit_check::{ProgramRows, answer_of, source_names};
use boundfit_estimation::{ErrorBound, Fps, Measurement, Measurements, Model, Problem};
use boundfit_exact::Rational;
use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};

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

fn solvers(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("pui");
    group.sample_size(10).sampling_mode(SamplingMode::Flat).measurement_time(Duration::from_secs(2));
    for count in [23, 1_000, 100_000] {
        let problem = noisy_line(count);
        let rows = ProgramRows::new(&problem);
        group.bench_with_input(BenchmarkId::new("polygon", count), &problem, |bencher, problem| {
            bencher.iter(|| Fps::new(&problem.measurements, &[]).polyhedron().bounding_box());
        });
        for name in source_names() {
            group.bench_with_input(BenchmarkId::new(&name, count), &rows, |bencher, rows| {
                bencher.iter(|| answer_of(&name, rows, Duration::from_secs(600)));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, solvers);
criterion_main!(benches);
