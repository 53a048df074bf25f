//! Supports, bounding boxes and widths.

use boundfit_exact::{Endpoint, Rational};
use boundfit_geometry::{Direction, Face, Inequality, Point, Polyhedron, Support};
use boundfit_tests::generate::{form, rational_system, seeded};
use boundfit_tests::shape::{Tally, combined, growth, recession, value};

type Form = [Rational; 2];

fn axes() -> [Form; 2] {
    [[Rational::one(), Rational::zero()], [Rational::zero(), Rational::one()]]
}

fn negative(form: &Form) -> Form {
    [-&form[0], -&form[1]]
}

#[test]
fn the_maximum_of_a_form_is_proved_and_attained_on_the_right_face() {
    let mut rng = seeded(1);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        for _ in 0..4 {
            tally.count(check_support(&polyhedron, &form(&mut rng, polyhedron.system())));
        }
    }
    tally.assert_each(300, &["empty", "unbounded", "vertex", "segment", "ray", "line", "whole"]);
}

fn check_support(polyhedron: &Polyhedron, form: &Form) -> &'static str {
    let (system, region) = (polyhedron.system(), polyhedron.region());
    let question = (form, system.inequalities());
    let grows = recession(region).iter().any(|direction| growth(form, direction).is_positive());
    match polyhedron.support(form) {
        Support::Empty(certificate) => {
            assert!(region.is_empty(), "{question:?}");
            assert_eq!(certificate.verify(system), Ok(()), "{question:?}");
            "empty"
        }
        Support::Unbounded(proof) => {
            assert!(!region.is_empty() && grows, "{question:?}");
            assert_eq!(proof.verify(system), Ok(()), "{question:?}");
            assert_eq!(proof.form, *form, "{question:?}");
            assert!(recession(region).contains(&proof.ray), "{question:?}");
            "unbounded"
        }
        Support::Bounded { proof, face } => {
            assert!(!region.is_empty() && !grows, "{question:?}");
            assert_eq!(proof.verify(system), Ok(()), "{question:?}");
            assert_eq!(proof.form, *form, "{question:?}");
            assert!(proof.multipliers.len() <= 2, "{question:?}");
            assert!(proof.multipliers.iter().all(|m| m.value.is_positive()), "{question:?}");
            let [a1, a2] = form.clone();
            let bound = Inequality::new(a1, a2, proof.value.clone());
            assert_eq!(combined(system, &proof.multipliers), bound, "{question:?}");
            let highest = region.vertices().iter().map(|vertex| value(form, vertex.point())).max();
            assert!(highest.is_none_or(|highest| highest == proof.value), "{question:?}");
            assert_eq!(value(form, &proof.attained_at), proof.value, "{question:?}");
            check_face(polyhedron, form, &proof.value, &face)
        }
    }
}

/// The face is exactly where the form has its maximum: the vertices that attain it, and the recession directions
/// that keep it.
fn check_face(polyhedron: &Polyhedron, form: &Form, maximum: &Rational, face: &Face) -> &'static str {
    let region = polyhedron.region();
    let question = (form, polyhedron.system().inequalities());
    let attaining: Vec<&Point> = region
        .vertices()
        .iter()
        .map(|vertex| vertex.point())
        .filter(|point| value(form, point) == *maximum)
        .collect();
    let keeping: Vec<Direction> =
        region.rays().into_iter().filter(|ray| growth(form, ray).is_zero()).collect();
    let zero = form.iter().all(Rational::is_zero);
    assert_eq!(matches!(face, Face::Whole), zero, "{question:?}");
    match face {
        Face::Whole => {
            assert_eq!(*maximum, Rational::zero(), "{question:?}");
            "whole"
        }
        Face::Vertex(point) => {
            assert_eq!((attaining, keeping), (vec![point], vec![]), "{question:?}");
            "vertex"
        }
        Face::Segment(ends) => {
            assert_eq!(attaining.len(), 2, "{question:?}");
            assert!(ends[0] != ends[1] && ends.iter().all(|end| attaining.contains(&end)), "{question:?}");
            "segment"
        }
        Face::Ray { apex, direction } => {
            assert_eq!((attaining, keeping), (vec![apex], vec![direction.clone()]), "{question:?}");
            "ray"
        }
        Face::Line { point, direction } => {
            assert_eq!(region.lines(), std::slice::from_ref(direction), "{question:?}");
            assert_eq!(growth(form, direction), Rational::zero(), "{question:?}");
            assert_eq!(value(form, point), *maximum, "{question:?}");
            assert!(polyhedron.membership(&point.coordinates()).is_inside(), "{question:?}");
            assert_eq!(growth(&point.coordinates(), direction), Rational::zero(), "{question:?}");
            "line"
        }
    }
}

/// The maximum according to [`Polyhedron::support`]; `None` for an empty region.
fn maximum(polyhedron: &Polyhedron, form: &Form) -> Option<Endpoint> {
    match polyhedron.support(form) {
        Support::Empty(_) => None,
        Support::Unbounded(_) => Some(Endpoint::Unbounded),
        Support::Bounded { proof, .. } => Some(Endpoint::Finite(proof.value)),
    }
}

#[test]
fn the_bounding_box_has_the_supports_of_the_axes() {
    let mut rng = seeded(2);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let (region, rows) = (polyhedron.region(), polyhedron.system().inequalities());
        tally.count(region.kind().name());
        let Some(sides) = polyhedron.bounding_box() else {
            assert!(region.is_empty(), "{rows:?}");
            continue;
        };
        for (axis, side) in axes().iter().zip(&sides) {
            let lower = maximum(&polyhedron, &negative(axis)).map(|end| match end {
                Endpoint::Finite(value) => Endpoint::Finite(-value),
                Endpoint::Unbounded => Endpoint::Unbounded,
            });
            assert_eq!(Some(side.upper()), maximum(&polyhedron, axis).as_ref(), "{rows:?}");
            assert_eq!(Some(side.lower()), lower.as_ref(), "{rows:?}");
            // Without going through the supports: the extreme vertices are the ends, unless a ray goes beyond.
            let values: Vec<Rational> = region.vertices().iter().map(|v| value(axis, v.point())).collect();
            assert!(values.iter().all(|value| side.contains(value)), "{rows:?}");
            if region.is_bounded() {
                assert_eq!(side.ends(), values.iter().min().zip(values.iter().max()), "{rows:?}");
            }
            let goes_up = recession(region).iter().any(|d| growth(axis, d).is_positive());
            let goes_down = recession(region).iter().any(|d| growth(axis, d).is_negative());
            assert_eq!(*side.upper() == Endpoint::Unbounded, goes_up, "{rows:?}");
            assert_eq!(*side.lower() == Endpoint::Unbounded, goes_down, "{rows:?}");
        }
    }
    tally.assert_each_kind(50);
}

#[test]
fn the_width_is_the_sum_of_two_opposite_supports() {
    let mut rng = seeded(3);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let form = form(&mut rng, polyhedron.system());
        let question = (&form, polyhedron.system().inequalities());
        let width = polyhedron.width(&form);
        let ends = maximum(&polyhedron, &form).zip(maximum(&polyhedron, &negative(&form)));
        let expected = match &ends {
            Some((Endpoint::Finite(upper), Endpoint::Finite(lower))) => Some(upper + lower),
            _ => None,
        };
        assert_eq!(width, expected, "{question:?}");
        let region = polyhedron.region();
        if region.is_bounded() {
            let values = region.vertices().iter().map(|vertex| value(&form, vertex.point()));
            let range = values.clone().max().zip(values.min()).map(|(highest, lowest)| highest - lowest);
            assert_eq!(width, range, "{question:?}");
        }
        tally.count(match width {
            None => "none",
            Some(width) if width.is_zero() => "zero",
            Some(_) => "positive",
        });
    }
    tally.assert_each(1000, &["none", "zero", "positive"]);
}
