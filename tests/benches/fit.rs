//! The whole fit, proofs included, of readings in memory.

use boundfit_estimation::{Problem, fit, fit_bounds};
use boundfit_tests::readings::{noisy_line, parabola};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

fn whole_fit(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fit");
    group.sample_size(10);
    let noisy = [23, 10_000, 100_000].map(|count| ("noisy line", count, noisy_line as fn(i64) -> Problem));
    for (name, count, problem) in noisy.into_iter().chain([("parabola", 100_000, parabola as _)]) {
        group.bench_function(BenchmarkId::new(name, count), |bencher| {
            let problem = problem(count);
            bencher.iter(|| fit(&problem));
        });
    }
    group.finish();
}

/// What a fleet of sensors computes for each.
fn bounds_alone(criterion: &mut Criterion) {
    criterion.bench_function("fit_bounds/noisy line/23", |bencher| {
        let problem = noisy_line(23);
        bencher.iter(|| fit_bounds(&problem));
    });
}

criterion_group!(benches, whole_fit, bounds_alone);
criterion_main!(benches);
