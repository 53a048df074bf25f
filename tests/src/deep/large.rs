//! Hundreds of half-planes: clipping, the fast intersection and the exact simplex.

use boundfit_geometry::System;
use boundfit_lp::PuiEnd;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::Case;
use super::half_planes::{h_representation, intersected};
use super::simplex::same_maximum;
use crate::generate::Large;
use crate::shape::subsystem;

/// A large system, for which brute force is too slow.
#[derive(Debug, Clone)]
pub struct LargeCase {
    system: System,
}

impl LargeCase {
    /// A system of any of the large kinds.
    pub fn generated(rng: &mut ChaCha8Rng) -> Self {
        let kind = Large::ALL[rng.random_range(0..Large::ALL.len())];
        LargeCase { system: kind.system(rng) }
    }
}

impl Case for LargeCase {
    fn check(&self) -> Result<&'static str, String> {
        let (polyhedron, kind) = intersected(self.system.clone())?;
        PuiEnd::ALL
            .map(PuiEnd::objective)
            .into_iter()
            .try_for_each(|objective| same_maximum(&polyhedron, objective))?;
        Ok(kind)
    }

    fn without(&self, index: usize) -> Option<Box<dyn Case>> {
        let others: Vec<usize> = (0..self.system.len()).filter(|&other| other != index).collect();
        let is_there = index < self.system.len();
        is_there.then(|| Box::new(LargeCase { system: subsystem(&self.system, &others) }) as Box<dyn Case>)
    }

    fn fixture(&self) -> String {
        h_representation(&self.system)
    }
}
