//! The whole fit, proofs included, of readings in memory.

use boundfit_estimation::{Problem, fit};
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

criterion_group!(benches, whole_fit);
criterion_main!(benches);
