//! Half-planes: clipping, the fast intersection, brute force and the exact simplex.

use std::fmt::Write as _;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron, Region, System, clipping};
use boundfit_lp::PuiEnd;
use rand_chacha::ChaCha8Rng;

use super::placement::Placement;
use super::simplex::same_maximum;
use super::{Case, same};
use crate::generate::{form, rescaled};
use crate::oracle::{Row, solve};

/// Half-planes within the oracle's range, where they are placed and in which units.
#[derive(Debug, Clone)]
pub struct PlacedCase {
    rows: Vec<Row>,
    units: Vec<Rational>,
    placement: Placement,
    form: [Rational; 2],
}

impl PlacedCase {
    /// The case of these rows, each in a unit of its own, with a linear form that asks for ties.
    pub fn new(rows: Vec<Row>, units: Vec<Rational>, placement: Placement, rng: &mut ChaCha8Rng) -> Self {
        let mut case = PlacedCase { rows, units, placement, form: [Rational::zero(), Rational::zero()] };
        case.form = form(rng, &case.system());
        case
    }

    /// The case of these rows as they stand.
    pub fn in_place(rows: Vec<Row>) -> Self {
        let units = vec![Rational::one(); rows.len()];
        let form = [Rational::one(), Rational::from(-1)];
        PlacedCase { rows, units, placement: Placement::identity(), form }
    }

    fn system(&self) -> System {
        let placed = self.rows.iter().zip(&self.units);
        placed.map(|(&row, unit)| rescaled(&self.placement.inequality(row), unit)).collect()
    }
}

impl Case for PlacedCase {
    fn check(&self) -> Result<&'static str, String> {
        let (polyhedron, kind) = intersected(self.system())?;
        let answer = self.placement.answer(polyhedron.region());
        same("the region and brute force", &answer, &Some(solve(&self.rows)))?;
        let mut objectives = PuiEnd::ALL.map(PuiEnd::objective).to_vec();
        objectives.push(self.form.clone());
        objectives.extend(across(polyhedron.region()));
        objectives.into_iter().try_for_each(|objective| same_maximum(&polyhedron, objective))?;
        Ok(kind)
    }

    fn without(&self, index: usize) -> Option<Box<dyn Case>> {
        let mut smaller = self.clone();
        (index < smaller.rows.len()).then(|| (smaller.rows.remove(index), smaller.units.remove(index)))?;
        Some(Box::new(smaller))
    }

    fn fixture(&self) -> String {
        h_representation(&self.system())
    }
}

/// The polyhedron of a system by the fast algorithm, if clipping gives the same, and the name of its kind.
pub(super) fn intersected(system: System) -> Result<(Polyhedron, &'static str), String> {
    let clipped = clipping::intersect(&system);
    let polyhedron = Polyhedron::intersect(system);
    let region = polyhedron.region();
    same("the fast intersection and clipping", region, &clipped)?;
    region.check_invariants(polyhedron.system()).map_err(|violation| format!("{violation:?}"))?;
    if let Some(certificate) = region.certificate() {
        certificate.verify(polyhedron.system()).map_err(|error| format!("{certificate:?}: {error:?}"))?;
    }
    let kind = region.kind().name();
    Ok((polyhedron, kind))
}

/// Forms along the normals of the boundary lines: they tell where a region without vertices lies.
pub(super) fn across(region: &Region) -> impl Iterator<Item = [Rational; 2]> + '_ {
    region.boundaries().iter().flat_map(|boundary| {
        let normal = boundary.half_plane().normal();
        [normal.reversed(), normal].map(|normal| [Rational::from(normal.dx()), Rational::from(normal.dy())])
    })
}

/// A system as cdd's H-representation.
pub fn h_representation(system: &System) -> String {
    let mut text = format!("H-representation\nbegin\n{} 3 rational\n", system.len());
    for Inequality { a: [a1, a2], b } in system.inequalities() {
        let _ = writeln!(text, "{b} {} {}", -a1, -a2);
    }
    text + "end\n"
}
