//! Area, centroid and diameter.

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Point, Region, RegionKind, System, envelope};
use boundfit_tests::generate::{positive, rational, rational_system, seeded, system, tangents};
use boundfit_tests::shape::{Tally, with};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// A small system, or now and then one whose region has 50 to 200 sides.
fn any_system(rng: &mut ChaCha8Rng, many_sided: f64) -> System {
    if rng.random_bool(many_sided) {
        let count = rng.random_range(50..=200);
        system(&tangents(rng, count))
    } else {
        rational_system(rng)
    }
}

/// `area · centroid`.
fn moment(region: &Region) -> Option<[Rational; 2]> {
    let area = region.area()?;
    let [x, y] = if area.is_zero() { Default::default() } else { region.area_centroid()?.coordinates() };
    Some([&area * x, &area * y])
}

#[test]
fn area_and_moment_are_additive() {
    let mut rng = seeded(31);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let system = any_system(&mut rng, 0.002);
        // Near the region, so that the line often cuts it; sometimes through two of its vertices.
        let region = envelope::intersect(&system);
        let vertices = region.vertices();
        let cut = match vertices.len() {
            0 => [rational(&mut rng), rational(&mut rng), rational(&mut rng)],
            count => {
                let [x, y] = vertices[rng.random_range(0..count)].point().coordinates();
                let [p, q] = vertices[rng.random_range(0..count)].point().coordinates();
                let shift = if rng.random_bool(0.5) { Rational::zero() } else { rational(&mut rng).half() };
                let b = (&q - &y) * &x - (&p - &x) * &y + shift;
                [q - y, x - p, b]
            }
        };
        let [a1, a2, b] = cut;
        let left = envelope::intersect(&with(&system, Inequality::new(a1.clone(), a2.clone(), b.clone())));
        let right = envelope::intersect(&with(&system, Inequality::new(-&a1, -&a2, -&b)));
        let question = ([a1, a2, b], system.inequalities());
        let is_proper_cut = question.0[..2].iter().any(|coefficient| !coefficient.is_zero());
        if is_proper_cut && let Some(whole) = moment(&region) {
            let areas = [&left, &right].map(|part| part.area().unwrap());
            assert_eq!(&areas[0] + &areas[1], region.area().unwrap(), "{question:?}");
            let [[lx, ly], [rx, ry]] = [&left, &right].map(|part| moment(part).unwrap());
            assert_eq!([lx + rx, ly + ry], whole, "{question:?}");
            let parts = areas.iter().filter(|area| area.is_positive()).count();
            tally.count(["flat", "one part", "two parts"][parts]);
        }
    }
    tally.assert_each(200, &["flat", "one part", "two parts"]);
}

#[test]
fn measures_exist_exactly_where_they_are_finite() {
    let mut rng = seeded(32);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let system = rational_system(&mut rng);
        let (region, rows) = (envelope::intersect(&system), system.inequalities());
        let bounded = region.is_bounded() && !region.is_empty();
        let flat = matches!(
            region.kind(),
            RegionKind::Empty | RegionKind::Point | RegionKind::Segment | RegionKind::Ray | RegionKind::Line
        );
        match region.area() {
            None => assert!(!flat && !bounded, "{rows:?}"),
            Some(area) => assert_eq!((area.is_zero(), flat || bounded), (flat, true), "{rows:?}"),
        }
        assert_eq!(region.area_centroid().is_some(), bounded, "{rows:?}");
        assert_eq!(region.squared_diameter().is_some(), bounded, "{rows:?}");
        if let Some(centroid) = region.area_centroid() {
            let interior = region.kind() == RegionKind::Polygon;
            for (index, _) in system.half_planes() {
                let slack = rows[index].slack(&centroid.coordinates());
                assert!(slack.is_positive() || (!interior && slack.is_zero()), "{rows:?}");
            }
            if region.kind() == RegionKind::Segment {
                let [start, end] = [0, 1].map(|i| region.vertices()[i].point().coordinates());
                let middle = [0, 1].map(|i| (&start[i] + &end[i]).half());
                assert_eq!(centroid.coordinates(), middle, "{rows:?}");
            }
        }
        tally.count(region.kind().name());
    }
    tally.assert_each_kind(50);
}

fn squared_diameter_by_pairs(region: &Region) -> Option<Rational> {
    let corners: Vec<[Rational; 2]> = region.vertices().iter().map(|v| v.point().coordinates()).collect();
    let squared_distance = |p: &[Rational; 2], q: &[Rational; 2]| {
        let (dx, dy) = (&p[0] - &q[0], &p[1] - &q[1]);
        &dx * &dx + &dy * &dy
    };
    let pairs = corners.iter().enumerate().flat_map(|(i, p)| corners[i..].iter().map(move |q| (p, q)));
    pairs.map(|(p, q)| squared_distance(p, q)).max()
}

#[test]
fn the_diameter_is_the_largest_distance_of_two_vertices() {
    let mut rng = seeded(33);
    let mut tally = Tally::default();
    for _ in 0..10_000 {
        let system = any_system(&mut rng, 0.002);
        let region = envelope::intersect(&system);
        if region.is_bounded() {
            let by_pairs = squared_diameter_by_pairs(&region);
            assert_eq!(region.squared_diameter(), by_pairs, "{:?}", system.inequalities());
            tally.count(match region.vertices().len() {
                0 => "none",
                1 | 2 => "flat",
                3 => "triangle",
                4..=20 => "polygon",
                _ => "many sides",
            });
        }
    }
    tally.assert_each(10, &["none", "flat", "triangle", "polygon", "many sides"]);
}

/// `θ ↦ matrix·θ + shift`.
#[derive(Debug)]
struct Affine {
    matrix: [[Rational; 2]; 2],
    shift: [Rational; 2],
}

impl Affine {
    fn determinant(&self) -> Rational {
        let [[p, q], [r, s]] = &self.matrix;
        p * s - q * r
    }

    fn point(&self, point: &Point) -> Point {
        let theta = point.coordinates();
        let [x, y] =
            [0, 1].map(|i| &self.matrix[i][0] * &theta[0] + &self.matrix[i][1] * &theta[1] + &self.shift[i]);
        Point::new(&x, &y)
    }

    /// The inequality that the images of the points satisfy; the determinant must not be zero.
    fn inequality(&self, Inequality { a: [a1, a2], b }: &Inequality) -> Inequality {
        let [[p, q], [r, s]] = &self.matrix;
        let per_determinant = self.determinant().recip().unwrap();
        let [a1, a2] = [(a1 * s - a2 * r) * &per_determinant, (a2 * p - a1 * q) * &per_determinant];
        let b = b + &a1 * &self.shift[0] + &a2 * &self.shift[1];
        Inequality::new(a1, a2, b)
    }
}

#[test]
fn measures_follow_affine_maps() {
    let mut rng = seeded(34);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let system = any_system(&mut rng, 0.002);
        let [p, q] = [positive(&mut rng), rational(&mut rng)];
        let (zero, one) = (Rational::zero(), Rational::one());
        let (name, matrix) = match rng.random_range(0..4) {
            0 => ("translation", [[one.clone(), zero.clone()], [zero, one]]),
            1 => ("scaling", [[-&p, zero.clone()], [zero, -&p]]),
            2 => ("turn and scaling", [[p.clone(), -&q], [q, p]]),
            _ => ("shear and stretch", [[p, q], [zero, one]]),
        };
        let map = Affine { matrix, shift: [rational(&mut rng), rational(&mut rng)] };
        let region = envelope::intersect(&system);
        let image =
            envelope::intersect(&system.inequalities().iter().map(|row| map.inequality(row)).collect());
        let question = (name, &map, system.inequalities());
        let factor = map.determinant().abs();
        let times = |measure: Option<Rational>| measure.map(|measure| measure * &factor);
        assert_eq!(image.kind(), region.kind(), "{question:?}");
        assert_eq!(image.area(), times(region.area()), "{question:?}");
        let centroid = region.area_centroid().map(|centroid| map.point(&centroid));
        assert_eq!(image.area_centroid(), centroid, "{question:?}");
        // Only similarities keep the ratios of distances; the determinant is the square of theirs.
        if name != "shear and stretch" {
            assert_eq!(image.squared_diameter(), times(region.squared_diameter()), "{question:?}");
        }
        if region.kind() == RegionKind::Polygon {
            tally.count(name);
        }
    }
    tally.assert_each(150, &["translation", "scaling", "turn and scaling", "shear and stretch"]);
}
