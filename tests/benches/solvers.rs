//! The PUI by four linear programs in every solver of this build, beside the exact engine.

use std::time::Duration;

use boundfit_check::{ProgramRows, answer_of, source_names};
use boundfit_estimation::Fps;
use boundfit_tests::readings::noisy_line;
use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};

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
