//! Proofs can fail: every field of a genuine proof is changed so that the statement becomes false, and `verify` says
//! what is wrong with it.

use boundfit_exact::Rational;
use boundfit_geometry::{
    BoundProof, Direction, Farkas, Inequality, Multiplier, Point, Polyhedron, ProofError, Support, System,
    UnboundedProof,
};
use boundfit_tests::generate::{form, rational_system, seeded};
use boundfit_tests::shape::{Tally, growth, value};

trait Proof: Clone + std::fmt::Debug {
    fn check(&self, system: &System) -> Result<(), ProofError>;
}

impl Proof for BoundProof {
    fn check(&self, system: &System) -> Result<(), ProofError> {
        self.verify(system)
    }
}

impl Proof for UnboundedProof {
    fn check(&self, system: &System) -> Result<(), ProofError> {
        self.verify(system)
    }
}

impl Proof for Vec<Multiplier> {
    fn check(&self, system: &System) -> Result<(), ProofError> {
        Farkas::new(self.clone()).verify(system)
    }
}

/// A proof that holds for a system, to be tampered with.
struct Genuine<'a, P> {
    proof: &'a P,
    system: &'a System,
}

impl<P: Proof> Genuine<'_, P> {
    /// The changed proof fails with that error; `why` says what makes the changed statement false.
    fn fails(&self, why: &str, expected: ProofError, change: impl FnOnce(&mut P)) {
        let mut tampered = self.proof.clone();
        change(&mut tampered);
        let rows = self.system.inequalities();
        assert_eq!(tampered.check(self.system), Err(expected), "{why}: {tampered:?}, {rows:?}");
    }

    /// Each multiplier in turn is changed so that the sum is not the claimed one. A normal that is zero in the proof
    /// is the only one, and dropping or exchanging it is up to the caller.
    fn fails_for_changed_multipliers(&self, of: fn(&mut P) -> &mut Vec<Multiplier>, most: usize) {
        let rows = self.system.inequalities();
        let multipliers = of(&mut self.proof.clone()).clone();
        for (position, Multiplier { index, value }) in multipliers.iter().enumerate() {
            self.fails("beyond the system", ProofError::UnknownInequality(rows.len()), |proof| {
                of(proof)[position].index = rows.len();
            });
            for not_positive in [Rational::zero(), -value] {
                let why = "a multiplier that is not positive proves nothing";
                self.fails(why, ProofError::NotPositive(*index), |proof| {
                    of(proof)[position].value = not_positive.clone();
                });
            }
            let a = &rows[*index].a;
            if a.iter().any(|coefficient| !coefficient.is_zero()) {
                let why = "a non-zero normal is missing from the sum or too much";
                self.fails(why, ProofError::WrongForm, |proof| of(proof)[position].value = value + value);
                self.fails(why, ProofError::WrongForm, |proof| of(proof)[position].value = value.half());
                self.fails(why, ProofError::WrongForm, |proof| drop(of(proof).remove(position)));
            }
            for (other, row) in rows.iter().enumerate().filter(|(_, row)| row.a != *a) {
                let why = "the sum changes by a multiple of the difference of two normals";
                self.fails(why, ProofError::WrongForm, |proof| of(proof)[position].index = other);
                if multipliers.len() < most && row.a.iter().any(|coefficient| !coefficient.is_zero()) {
                    let extra = Multiplier { index: other, value: Rational::one() };
                    let why = "a non-zero normal too much";
                    self.fails(why, ProofError::WrongForm, |proof| of(proof).push(extra.clone()));
                }
            }
        }
        let why = "the sum may be right, but the statement says at most so many";
        if let Some(first) = multipliers.first() {
            self.fails(why, ProofError::TooManyMultipliers(most + 1), |proof| {
                let split = of(proof);
                split[0].value = split[0].value.half();
                split.resize(most + 1, Multiplier { index: first.index, value: first.value.half() });
            });
        }
    }
}

/// The system with another right-hand side in one row.
fn with_side(system: &System, index: usize, b: Rational) -> System {
    let mut rows = system.inequalities().to_vec();
    rows[index].b = b;
    rows.into_iter().collect()
}

/// A point beyond the boundary of an inequality with a non-zero normal.
fn beyond(Inequality { a, b }: &Inequality, from: &Point) -> Option<Point> {
    let square = &a[0] * &a[0] + &a[1] * &a[1];
    let steps = (b - value(a, from)).checked_div(&square)? + Rational::one();
    Some(Point::new(&(from.theta1() + &a[0] * &steps), &(from.theta2() + &a[1] * &steps)))
}

/// The first inequality that excludes a point.
fn excluded_by(system: &System, point: &Point) -> usize {
    system.inequalities().iter().position(|row| row.slack(&point.coordinates()).is_negative()).unwrap()
}

#[test]
fn a_tampered_certificate_of_emptiness_fails() {
    let mut rng = seeded(51);
    let mut tally = Tally::default();
    for _ in 0..15_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let Some(certificate) = polyhedron.region().certificate() else { continue };
        let (system, multipliers) = (polyhedron.system(), certificate.multipliers().to_vec());
        assert_eq!(certificate.verify(system), Ok(()));
        let genuine = Genuine { proof: &multipliers, system };
        genuine.fails_for_changed_multipliers(|multipliers| multipliers, 3);
        genuine.fails("the empty sum is 0 ≤ 0, which is true", ProofError::WrongValue, Vec::clear);
        let rows = system.inequalities();
        let total: Rational = multipliers.iter().map(|m| &rows[m.index].b * &m.value).sum();
        for Multiplier { index, value } in &multipliers {
            // With as much more room as the sum is negative, it is 0 ≤ 0 and proves nothing.
            let room = (-&total).checked_div(value).unwrap();
            let relaxed = with_side(system, *index, &rows[*index].b + room);
            assert_eq!(certificate.verify(&relaxed), Err(ProofError::WrongValue), "{relaxed:?}");
        }
        tally.count(["", "zero normal", "two rows", "three rows"][multipliers.len()]);
    }
    tally.assert_each(200, &["zero normal", "two rows", "three rows"]);
}

#[test]
fn a_tampered_bound_fails() {
    let mut rng = seeded(52);
    let mut tally = Tally::default();
    for _ in 0..10_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let form = form(&mut rng, polyhedron.system());
        let Support::Bounded { proof, .. } = polyhedron.support(&form) else { continue };
        let system = polyhedron.system();
        assert_eq!(proof.verify(system), Ok(()));
        check_tampered_bound(&polyhedron, &proof, &mut tally);
        tally.count(["none", "one multiplier", "two multipliers"][proof.multipliers.len()]);
    }
    let cases = ["none", "one multiplier", "two multipliers", "same normal", "outside", "not attained"];
    tally.assert_each(200, &cases);
}

fn check_tampered_bound(polyhedron: &Polyhedron, proof: &BoundProof, tally: &mut Tally) {
    let system = polyhedron.system();
    let rows = system.inequalities();
    let genuine = Genuine { proof, system };
    genuine.fails_for_changed_multipliers(|proof| &mut proof.multipliers, 2);
    for component in [0, 1] {
        let why = "the multipliers add up to another form";
        genuine.fails(why, ProofError::WrongForm, |proof| {
            proof.form[component] = &proof.form[component] + Rational::one();
        });
    }
    for step in [Rational::one(), -Rational::one()] {
        let why = "the maximum has one value";
        genuine.fails(why, ProofError::WrongValue, |proof| proof.value = &proof.value + &step);
    }
    for (position, Multiplier { index, .. }) in proof.multipliers.iter().enumerate() {
        let parallel = |row: &Inequality| row.a == rows[*index].a && row.b != rows[*index].b;
        if let Some(other) = rows.iter().position(parallel) {
            let why = "the same form with another right-hand side gives another value";
            genuine.fails(why, ProofError::WrongValue, |proof| proof.multipliers[position].index = other);
            tally.count("same normal");
        }
        let raised = with_side(system, *index, &rows[*index].b + Rational::one());
        assert_eq!(proof.verify(&raised), Err(ProofError::WrongValue), "the value was of another system");
    }
    if let Some(outside) = rows.iter().find_map(|row| beyond(row, &proof.attained_at)) {
        let expected = ProofError::PointOutside(excluded_by(system, &outside));
        genuine.fails("not a point of the region", expected, |proof| proof.attained_at = outside);
        tally.count("outside");
    }
    let vertices = polyhedron.region().vertices().iter().map(|vertex| vertex.point().clone());
    for inside in vertices.chain(polyhedron.region().witness()) {
        if value(&proof.form, &inside) != proof.value {
            let why = "the form is smaller at this point of the region";
            genuine.fails(why, ProofError::NotAttained, |proof| proof.attained_at = inside);
            tally.count("not attained");
        }
    }
    // A true bound that is not the maximum: every row of the proof with room of 1, and the value that follows.
    let room = |multipliers: &[Multiplier]| multipliers.iter().map(|m| m.value.clone()).sum::<Rational>();
    let loose = proof.multipliers.iter().fold(system.clone(), |system, multiplier| {
        let b = &rows[multiplier.index].b + Rational::one();
        with_side(&system, multiplier.index, b)
    });
    if !proof.multipliers.is_empty() {
        Genuine { proof, system: &loose }.fails("a bound above", ProofError::NotAttained, |proof| {
            proof.value = &proof.value + room(&proof.multipliers);
        });
    }
}

#[test]
fn a_tampered_proof_of_unboundedness_fails() {
    let mut rng = seeded(53);
    let mut tally = Tally::default();
    for _ in 0..15_000 {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let system = polyhedron.system();
        let form = form(&mut rng, system);
        let Support::Unbounded(proof) = polyhedron.support(&form) else { continue };
        assert_eq!(proof.verify(system), Ok(()));
        check_tampered_unboundedness(system, &proof, &mut tally);
    }
    tally.assert_each(500, &["form", "outside", "leaves", "falls"]);
}

fn check_tampered_unboundedness(system: &System, proof: &UnboundedProof, tally: &mut Tally) {
    let rows = system.inequalities();
    let genuine = Genuine { proof, system };
    let why = "the form falls or stays along the ray";
    let across = [-Rational::from(proof.ray.dy()), Rational::from(proof.ray.dx())];
    let zero = [Rational::zero(), Rational::zero()];
    for form in [[-&proof.form[0], -&proof.form[1]], across, zero] {
        genuine.fails(why, ProofError::NotGrowing, |proof| proof.form = form);
        tally.count("form");
    }
    if let Some(outside) = rows.iter().find_map(|row| beyond(row, &proof.point)) {
        let expected = ProofError::PointOutside(excluded_by(system, &outside));
        genuine.fails("not a point of the region", expected, |proof| proof.point = outside);
        tally.count("outside");
    }
    let left_by = |ray: &Direction| rows.iter().position(|row| growth(&row.a, ray).is_positive());
    for normal in rows.iter().filter_map(|row| Direction::from_rational(&row.a)) {
        let expected = ProofError::RayLeaves(left_by(&normal).unwrap());
        genuine.fails("along a normal leads beyond its boundary", expected, |proof| proof.ray = normal);
        tally.count("leaves");
    }
    for ray in [proof.ray.reversed(), proof.ray.turned_left(), proof.ray.turned_right()] {
        if !growth(&proof.form, &ray).is_positive() {
            let expected = left_by(&ray).map_or(ProofError::NotGrowing, ProofError::RayLeaves);
            genuine.fails(why, expected, |proof| proof.ray = ray);
            tally.count("falls");
        }
    }
}
