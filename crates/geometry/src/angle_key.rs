//! Sorting by angle with one comparison of machine words where that is enough.

use std::cmp::Ordering;

use crate::bounds::Facet;
use crate::half_plane::HalfPlane;
use crate::predicates::{by_angle, by_tightness};

/// The number of half-planes from which on keys are made. A key costs a division, and saves a look at two
/// half-planes, which are anywhere in memory, in each comparison.
const FEWEST_FOR_KEYS: usize = 256;

/// Half-planes sorted by angle, those of the same direction by tightness, and equal ones by index.
pub(crate) fn sorted<'a>(half_planes: impl Iterator<Item = Facet<'a>> + Clone) -> Vec<Facet<'a>> {
    let are_few = half_planes.clone().nth(FEWEST_FOR_KEYS - 1).is_none();
    let keyed = |(index, half_plane): Facet<'a>| Some((key(half_plane)?, (index, half_plane)));
    let keyed: Option<Vec<(u64, Facet)>> =
        if are_few { None } else { half_planes.clone().map(keyed).collect() };
    match keyed {
        None => {
            let mut sorted: Vec<Facet> = half_planes.collect();
            sorted.sort_unstable_by(compare);
            sorted
        }
        Some(mut keyed) => {
            // Readings sorted by x come as few runs, which a stable sort merges.
            keyed.sort_by(|(k, f), (l, g)| k.cmp(l).then_with(|| compare(f, g)));
            keyed.into_iter().map(|(_, facet)| facet).collect()
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
            let mut expected: Vec<Facet> = half_planes.iter().enumerate().collect();
            assert!(expected.len() >= FEWEST_FOR_KEYS);
            expected.sort_by(compare);
            assert_eq!(sorted(half_planes.iter().enumerate()), expected, "{largest}");
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
