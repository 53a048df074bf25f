//! Answers to the four programs behind the PUI.

use boundfit_exact::Foreign;
use boundfit_lp::BoundClaim;

/// The claim of a source about the intervals of θ1 and θ2: lower and upper end of each.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The source that claims it.
    pub source: Foreign,
    /// True if the source worked on the exact rows, so that their rounding is no excuse.
    pub exact_input: bool,
    /// The claims, by parameter, then lower and upper.
    pub claims: [[BoundClaim; 2]; 2],
}

impl Answer {
    /// Returns whether the answer has multipliers, which are about rows by their place among all of them.
    pub fn has_duals(&self) -> bool {
        self.claims.iter().flatten().any(|claim| claim.duals.is_some())
    }

    /// This answer with every number meant exactly, however it was printed.
    #[must_use]
    pub fn without_precision(self) -> Self {
        let claims = self.claims.map(|ends| ends.map(BoundClaim::without_precision));
        Answer { claims, ..self }
    }
}
