//! Clipping against the two envelopes, on half-planes that all bound the region and on random ones.

use boundfit_geometry::{Inequality, System, clipping, envelope};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// Tangents of the parabola θ2 = θ1²: every one is an edge.
fn all_extreme(count: i64) -> System {
    let tangent = |k: i64| Inequality::new((2 * k).into(), (-1).into(), (k * k).into());
    (-count / 2..count - count / 2).map(tangent).collect()
}

/// Half-planes with pseudo-random normals around the origin: few are edges.
fn few_extreme(count: i64) -> System {
    let mut state: u64 = 1;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as i64 % 2001 - 1000
    };
    (0..count)
        .map(|_| {
            let (a1, a2, offset) = (next(), next(), next().abs());
            Inequality::new(a1.into(), a2.into(), (a1.abs() + a2.abs() + offset).into())
        })
        .collect()
}

fn intersection(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("intersection");
    group.sample_size(10);
    for (name, systems) in [("all extreme", all_extreme as fn(i64) -> System), ("few extreme", few_extreme)] {
        for count in [46, 1_000, 10_000] {
            let system = systems(count);
            group.bench_with_input(
                BenchmarkId::new(format!("fast, {name}"), count),
                &system,
                |bencher, system| {
                    bencher.iter(|| envelope::intersect(system));
                },
            );
            // Clipping takes time proportional to half-planes times vertices.
            if count <= 1_000 || name == "few extreme" {
                let id = BenchmarkId::new(format!("clipping, {name}"), count);
                group.bench_with_input(id, &system, |bencher, system| {
                    bencher.iter(|| clipping::intersect(system));
                });
            }
        }
    }
    group.finish();
}

criterion_group!(benches, intersection);
criterion_main!(benches);
