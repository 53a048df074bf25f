//! The image of a region in terms of gain and offset of the inverse line.

use std::collections::HashSet;

use boundfit_exact::Rational;
use boundfit_geometry::constructions::foot;
use boundfit_geometry::{Branch, Point, Polyhedron, inverse_line_image};
use boundfit_tests::generate::{rational, rational_system, seeded};
use boundfit_tests::shape::{Tally, recession};

const CASES: usize = 15_000;
const BRANCHES: [Branch; 2] = [Branch::Positive, Branch::Negative];

fn is_on(branch: Branch, number: &Rational) -> bool {
    match branch {
        Branch::Positive => number.is_positive(),
        Branch::Negative => number.is_negative(),
    }
}

/// (θ1, θ2) → (1/θ1, -θ2/θ1), which is its own inverse; `None` where it does not exist.
fn mapped([theta1, theta2]: &[Rational; 2]) -> Option<[Rational; 2]> {
    Some([theta1.recip()?, -theta2.checked_div(theta1)?])
}

/// Points that show how far θ1 reaches, unless a ray or line shows it.
fn landmarks(polyhedron: &Polyhedron) -> Vec<Point> {
    let region = polyhedron.region();
    let mut points: Vec<Point> = region.vertices().iter().map(|vertex| vertex.point().clone()).collect();
    points.extend(region.witness());
    points.extend(region.boundaries().iter().map(|b| foot(b.half_plane())));
    points
}

/// Returns whether the region has a point with that sign of θ1. One of its vertices has that sign, a direction of the
/// region leads there, or a vertical line bounds the region there.
fn reaches(polyhedron: &Polyhedron, branch: Branch) -> bool {
    landmarks(polyhedron).iter().any(|point| is_on(branch, &point.theta1()))
        || recession(polyhedron.region()).iter().any(|d| is_on(branch, &Rational::from(d.dx())))
}

#[test]
fn an_image_exists_exactly_for_the_signs_that_occur() {
    let mut rng = seeded(41);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let rows = polyhedron.system().inequalities();
        let images = BRANCHES.map(|branch| inverse_line_image(&polyhedron, branch).is_some());
        assert_eq!(images, BRANCHES.map(|branch| reaches(&polyhedron, branch)), "{rows:?}");
        tally.count(match images {
            [true, true] => "both",
            [true, false] => "positive",
            [false, true] => "negative",
            [false, false] => "neither",
        });
    }
    tally.assert_each(500, &["both", "positive", "negative", "neither"]);
}

#[test]
fn points_belong_to_the_image_exactly_when_they_come_from_the_region() {
    let mut rng = seeded(42);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        for branch in BRANCHES {
            let Some(image) = inverse_line_image(&polyhedron, branch) else { continue };
            let own = landmarks(&polyhedron).into_iter().map(|point| point.coordinates());
            let of_image = landmarks(&image).into_iter().filter_map(|point| mapped(&point.coordinates()));
            let random = [[rational(&mut rng), rational(&mut rng)]];
            for theta in own.chain(of_image).chain(random) {
                let question = (branch, &theta, polyhedron.system().inequalities());
                if let Some(gain_and_offset) = mapped(&theta).filter(|_| is_on(branch, &theta[0])) {
                    let inside = polyhedron.membership(&theta).is_inside();
                    assert_eq!(image.membership(&gain_and_offset).is_inside(), inside, "{question:?}");
                    tally.count(if inside { "inside" } else { "outside" });
                } else if let Some(gain_and_offset) = mapped(&theta) {
                    let inside = image.membership(&gain_and_offset).is_inside();
                    assert!(!inside, "the image has no gain of the other sign: {question:?}");
                    tally.count("other sign");
                }
            }
            let rows = polyhedron.system().inequalities();
            assert!(!image.region().is_empty(), "{rows:?}");
            assert_eq!(image.region().check_invariants(image.system()), Ok(()), "{rows:?}");
        }
    }
    tally.assert_each(1000, &["inside", "outside", "other sign"]);
}

#[test]
fn a_bounded_region_away_from_zero_is_mapped_vertex_by_vertex() {
    let mut rng = seeded(43);
    let mut tally = Tally::default();
    for _ in 0..2 * CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let region = polyhedron.region();
        for branch in BRANCHES {
            let keeps_sign = region.vertices().iter().all(|vertex| is_on(branch, &vertex.point().theta1()));
            if !region.is_bounded() || region.is_empty() || !keeps_sign {
                continue;
            }
            let rows = polyhedron.system().inequalities();
            let image = inverse_line_image(&polyhedron, branch).unwrap();
            let expected: HashSet<[Rational; 2]> =
                region.vertices().iter().filter_map(|v| mapped(&v.point().coordinates())).collect();
            let vertices = image.region().vertices();
            let found: HashSet<[Rational; 2]> = vertices.iter().map(|v| v.point().coordinates()).collect();
            assert_eq!(found, expected, "{rows:?}");
            assert_eq!(vertices.len(), region.vertices().len(), "{rows:?}");
            assert_eq!(image.region().kind(), region.kind(), "{rows:?}");
            tally.count(region.kind().name());
        }
    }
    tally.assert_each(100, &["point", "segment", "polygon"]);
}
