//! The whole fit, proofs included, of readings in memory.

use boundfit_estimation::fit;
use boundfit_tests::readings::noisy_line;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

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
