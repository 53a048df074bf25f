//! The statuses of all readings in memory: a set without each that decides, and the values at each reading.

use std::hint::black_box;

use boundfit_estimation::fit;
use boundfit_questions::Statuses;
use boundfit_tests::readings::noisy_line;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

fn statuses(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("status");
    group.sample_size(10);
    for count in [1_000, 10_000, 100_000, 1_000_000] {
        let problem = noisy_line(count);
        let fit = fit(&problem);
        group.bench_function(BenchmarkId::new("without each", count), |bencher| {
            bencher.iter(|| Statuses::of(&problem, &fit));
        });
        let statuses = Statuses::of(&problem, &fit).expect("all in memory");
        group.bench_function(BenchmarkId::new("every reading", count), |bencher| {
            bencher.iter(|| {
                for own in problem.measurements.kept() {
                    black_box(statuses.status(own));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, statuses);
criterion_main!(benches);
