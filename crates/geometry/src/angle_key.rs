//! Sorting by angle with one comparison of machine words where that is enough.

use std::cmp::Ordering;

use crate::bounds::Facet;
use crate::half_plane::HalfPlane;
use crate::predicates::{by_angle, by_tightness};

/// The number of half-planes from which on keys are made. A key costs a division, and saves a look at two
/// half-planes, which are anywhere in memory, in each comparison.
const FEWEST_FOR_KEYS: usize = 256;

/// Sorts half-planes by angle, those of the same direction by tightness, and equal ones by index.
pub(crate) fn sort(half_planes: &mut Vec<Facet>) {
    let keyed: Option<Vec<(u64, Facet)>> = if half_planes.len() < FEWEST_FOR_KEYS {
        None
    } else {
        half_planes.iter().map(|&(index, half_plane)| Some((key(half_plane)?, (index, half_plane)))).collect()
    };
    match keyed {
        None => half_planes.sort_unstable_by(compare),
        Some(mut keyed) => {
            // Readings sorted by x come as few runs, which a stable sort merges.
            keyed.sort_by(|(k, f), (l, g)| k.cmp(l).then_with(|| compare(f, g)));
            half_planes.clear();
            half_planes.extend(keyed.into_iter().map(|(_, facet)| facet));
        }
    }
}

fn compare((i, f): &Facet, (j, g): &Facet) -> Ordering {
    by_angle(f, g).then_with(|| by_tightness(f, g)).then(i.cmp(j))
}

/// A number that never falls as the angle of the normal in [0, 2π) grows; normals with equal keys are within 2⁻⁶⁰ of each
/// other. `None` for coefficients of 62 bits and more.
///
/// For a normal (x, y) with y ≥ 0 the key is ⌊2⁶²·(1 - x/(|x|+y))⌋, which is below 2⁶³, and 2⁶³ for the last of them,
/// (-1, 0). For a normal with y < 0 it is the key of the opposite normal, 2⁶³ later.
fn key(half_plane: &HalfPlane) -> Option<u64> {
    const LIMIT: u64 = 1 << 62;
    let (x, y) = (half_plane.a1().to_i64()?, half_plane.a2().to_i64()?);
    if x.unsigned_abs() >= LIMIT || y.unsigned_abs() >= LIMIT {
        return None;
    }
    let lower = y < 0;
    let (x, y) = if lower { (-x, -y) } else { (x, y) };
    let sum = x.abs() + y;
    let numerator = (i128::from(sum) - i128::from(x)) << 62;
    let within = u64::try_from(numerator / i128::from(sum)).ok()?;
    Some(within | u64::from(lower) << 63)
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Integer;

    use super::*;

    fn half_planes(largest: i64) -> Vec<HalfPlane> {
        let coefficients = [0, 1, -1, 2, -3, 5, largest, -largest, largest - 1, 1 - largest, largest / 2];
        let mut all = Vec::new();
        for a1 in coefficients {
            for a2 in coefficients {
                for b in [-1, 0, 4] {
                    all.extend(HalfPlane::new(Integer::from(a1), Integer::from(a2), Integer::from(b)));
                }
            }
        }
        all
    }

    #[test]
    fn keys_and_comparisons_sort_alike() {
        for (largest, keys) in [(1_i64 << 40, true), ((1 << 62) - 1, true), (i64::MAX, false)] {
            let half_planes = half_planes(largest);
            assert_eq!(half_planes.iter().all(|half_plane| key(half_plane).is_some()), keys, "{largest}");
            let mut sorted: Vec<Facet> = half_planes.iter().enumerate().collect();
            let mut expected = sorted.clone();
            assert!(sorted.len() >= FEWEST_FOR_KEYS);
            expected.sort_by(compare);
            sort(&mut sorted);
            assert_eq!(sorted, expected, "{largest}");
        }
    }

    #[test]
    fn keys_tell_directions_apart() {
        let directions = [(1, 0), (9, 1), (1, 1), (1, 9), (0, 1), (-1, 9), (-1, 1), (-9, 1)];
        let around = directions.into_iter().chain(directions.map(|(x, y)| (-x, -y)));
        let keys: Vec<Option<u64>> = around
            .map(|(x, y): (i64, i64)| key(&HalfPlane::new(x.into(), y.into(), Integer::zero()).unwrap()))
            .collect();
        assert!(keys.iter().all(Option::is_some) && keys.is_sorted_by(|own, next| own < next), "{keys:?}");
    }

    #[test]
    fn keys_never_fall_with_the_angle() {
        let half_planes = half_planes((1 << 62) - 1);
        for f in &half_planes {
            for g in &half_planes {
                let (own, other) = (key(f), key(g));
                assert!(by_angle(f, g).is_gt() || own <= other, "{f:?} {g:?}");
            }
        }
    }
}
