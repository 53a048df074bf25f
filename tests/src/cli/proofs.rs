//! Half-planes made from a file by the test itself, and the sums that proofs claim to be.

use std::collections::BTreeSet;

use boundfit_exact::Rational;
use serde_json::Value;

use super::numbers::{exact, exact_or_null, pair, whole};

/// `a·θ ≤ b`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HalfPlane {
    pub a: [Rational; 2],
    pub b: Rational,
}

impl HalfPlane {
    /// `b - a·θ`.
    pub fn slack(&self, theta: &[Rational; 2]) -> Rational {
        &self.b - self.along(theta)
    }

    /// `a·d`.
    pub fn along(&self, direction: &[Rational; 2]) -> Rational {
        &self.a[0] * &direction[0] + &self.a[1] * &direction[1]
    }

    /// Returns whether `a` is zero: all or nothing of the plane.
    pub fn is_trivial(&self) -> bool {
        self.a.iter().all(Rational::is_zero)
    }
}

/// A half-plane with the names that a report gives it.
#[derive(Debug, Clone)]
pub struct Named {
    /// The name of the half-plane in a proof: `{"row": 14, "bound": "upper"}`.
    pub in_proofs: Value,
    /// The name of the half-plane in a list of active half-planes.
    pub in_lists: Value,
    /// The half-plane itself.
    pub half_plane: HalfPlane,
}

/// All half-planes of a file and its options, in the order of the file.
#[derive(Debug, Default)]
pub struct System(pub Vec<Named>);

impl System {
    /// Returns whether θ satisfies all half-planes.
    pub fn contains(&self, theta: &[Rational; 2]) -> bool {
        self.0.iter().all(|named| !named.half_plane.slack(theta).is_negative())
    }

    /// The names of the half-planes whose boundary passes through θ, in the order of the file, each once.
    pub fn active(&self, theta: &[Rational; 2]) -> Vec<Value> {
        let tight =
            |named: &&Named| !named.half_plane.is_trivial() && named.half_plane.slack(theta).is_zero();
        let mut names: Vec<Value> = self.0.iter().filter(tight).map(|named| named.in_lists.clone()).collect();
        names.dedup();
        names
    }

    /// The half-plane with a name in lists.
    pub fn listed(&self, name: &Value) -> &HalfPlane {
        &self.0.iter().find(|named| named.in_lists == *name).unwrap_or_else(|| panic!("no {name}")).half_plane
    }

    /// The sum of a proof: at most so many different half-planes, each times a positive number.
    pub fn sum(&self, proof: &Value, most: usize) -> HalfPlane {
        let terms = proof.as_array().unwrap();
        assert!(terms.len() <= most, "{proof}");
        let mut names = BTreeSet::new();
        let mut sum = HalfPlane { a: [whole(0), whole(0)], b: whole(0) };
        for term in terms {
            let mut name = term.clone();
            let multiplier = exact(&name.as_object_mut().unwrap().remove("multiplier").unwrap());
            assert!(multiplier.is_positive() && names.insert(name.to_string()), "{proof}");
            let named = self.0.iter().find(|named| named.in_proofs == name);
            let HalfPlane { a, b } = &named.unwrap_or_else(|| panic!("no {name}")).half_plane;
            sum.a = [&sum.a[0] + &a[0] * &multiplier, &sum.a[1] + &a[1] * &multiplier];
            sum.b = sum.b + b * &multiplier;
        }
        sum
    }

    /// Checks a proof of emptiness: the sum is `0 ≤ negative`.
    pub fn check_farkas(&self, proof: &Value) {
        let sum = self.sum(proof, 3);
        assert!(sum.is_trivial() && sum.b.is_negative(), "{proof}: {sum:?}");
    }

    /// Checks the intervals of θ1 and θ2 of a region that is not empty. Every end is the sum of its proof and
    /// attained, or the region goes on for ever that way. Null stands for no bounded end at all.
    pub fn check_bounds(&self, bounds: &Value, region: &Value) {
        for axis in [0, 1] {
            for (end, sign) in [("lower", -1), ("upper", 1)] {
                let end = if bounds.is_null() { &Value::Null } else { &bounds[axis][end] };
                let mut form = [whole(0), whole(0)];
                form[axis] = whole(sign);
                match exact_or_null(end) {
                    None => {
                        assert!(bounds.is_null() || end["active"].as_array().unwrap().is_empty(), "{end}");
                        assert!(grows(region, axis, sign), "{region} bounds axis {axis} towards {sign}");
                    }
                    Some(value) => {
                        let claimed = HalfPlane { a: form, b: value * whole(sign) };
                        assert_eq!(self.sum(&end["active"], 2), claimed, "{end}");
                        assert!(self.is_attained(&claimed, &end["active"], region), "{end}");
                    }
                }
            }
        }
    }

    /// Returns whether a half-plane that contains the region touches it.
    fn is_attained(&self, claimed: &HalfPlane, proof: &Value, region: &Value) -> bool {
        let vertices = region["vertices"].as_array().unwrap();
        if !vertices.is_empty() {
            return vertices.iter().any(|vertex| claimed.slack(&pair(&vertex["theta"])).is_zero());
        }
        // Without vertices it is the region's own boundary line.
        let boundaries = region["boundaries"].as_array().unwrap();
        let terms = proof.as_array().unwrap();
        let name = self.0.iter().find(|named| {
            terms.len() == 1 && ["row", "bound"].iter().all(|key| named.in_proofs[key] == terms[0][key])
        });
        let name = &name.unwrap_or_else(|| panic!("{proof} is not one half-plane")).in_lists;
        boundaries.iter().any(|boundary| boundary["active"].as_array().unwrap().contains(name))
    }
}

/// Returns whether a region goes on for ever along an axis, this way.
fn grows(region: &Value, axis: usize, sign: i64) -> bool {
    let along = |direction: &Value| exact(&direction[axis]) * whole(sign);
    let mut rays = region["rays"].as_array().unwrap().iter();
    let mut lines = region["lines"].as_array().unwrap().iter();
    rays.any(|ray| along(ray).is_positive()) || lines.any(|line| !along(line).is_zero())
}
