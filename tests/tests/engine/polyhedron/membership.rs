//! Membership of points and the witness.

use boundfit_exact::Rational;
use boundfit_geometry::{Membership, Point, Polyhedron, System};
use boundfit_tests::generate::{rational, rational_system, seeded};
use boundfit_tests::shape::{Tally, growth, recession};

const CASES: usize = 12_000;

/// The smallest slack and the first row that has it, by a plain loop.
fn slack_by_hand(system: &System, theta: &[Rational; 2]) -> Option<(Rational, usize)> {
    let mut smallest: Option<(Rational, usize)> = None;
    for (index, row) in system.inequalities().iter().enumerate() {
        let slack = row.b.clone() - (&row.a[0] * &theta[0] + &row.a[1] * &theta[1]);
        if smallest.as_ref().is_none_or(|(best, _)| slack < *best) {
            smallest = Some((slack, index));
        }
    }
    smallest
}

#[test]
fn membership_is_the_smallest_slack() {
    let mut rng = seeded(21);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let (system, region) = (polyhedron.system(), polyhedron.region());
        let corners = region.vertices().iter().map(|vertex| vertex.point().coordinates());
        for theta in corners.chain([[rational(&mut rng), rational(&mut rng)]]) {
            let question = (&theta, system.inequalities());
            let membership = polyhedron.membership(&theta);
            let (slack, tightest) = slack_by_hand(system, &theta).unzip();
            assert_eq!(membership, Membership { slack: slack.clone(), tightest }, "{question:?}");
            let inside = slack.as_ref().is_none_or(|slack| *slack >= Rational::zero());
            assert_eq!(membership.is_inside(), inside, "{question:?}");
            tally.count(match slack {
                None => "no inequality",
                Some(slack) if slack.is_zero() => "on the boundary",
                Some(_) if inside => "inside",
                Some(_) => "outside",
            });
        }
    }
    tally.assert_each(100, &["no inequality", "on the boundary", "inside", "outside"]);
}

#[test]
fn the_witness_lies_in_the_relative_interior() {
    let mut rng = seeded(22);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let (region, rows) = (polyhedron.region(), polyhedron.system().inequalities());
        tally.count(region.kind().name());
        let Some(witness) = region.witness() else {
            assert!(region.is_empty(), "{rows:?}");
            continue;
        };
        assert!(!region.is_empty(), "{rows:?}");
        assert!(polyhedron.membership(&witness.coordinates()).is_inside(), "{rows:?}");
        let has_interior = !matches!(region.kind().name(), "point" | "segment" | "ray" | "line");
        for (index, _) in polyhedron.system().half_planes() {
            // In the relative interior only those are active that are active everywhere.
            let slack_at = |point: &Point| rows[index].slack(&point.coordinates());
            if slack_at(&witness).is_zero() {
                assert!(!has_interior, "{rows:?}");
                assert!(region.vertices().iter().all(|v| slack_at(v.point()).is_zero()), "{rows:?}");
                assert!(recession(region).iter().all(|d| growth(&rows[index].a, d).is_zero()), "{rows:?}");
            }
        }
    }
    tally.assert_each_kind(50);
}
