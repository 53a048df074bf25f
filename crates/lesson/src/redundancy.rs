//! The reason why a half-plane changes nothing, with numbers as the document has them.

use boundfit_exact::Rational;
use boundfit_geometry::Multiplier;
use boundfit_geometry::clipping::StepRedundancy;
use serde::Serialize;

/// The multiple of a half-plane.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct MultiplierJson<N> {
    half_plane: usize,
    multiplier: N,
}

/// The reason why a half-plane changes nothing: positive multiples of others add up to it, with a right-hand side
/// smaller by the slack.
#[derive(Debug, Serialize)]
pub(crate) struct RedundantJson<N> {
    why: &'static str,
    by: Vec<MultiplierJson<N>>,
    slack: Option<N>,
}

pub(crate) fn multipliers<N>(
    terms: &[Multiplier],
    number: impl Fn(&Rational) -> N,
) -> Vec<MultiplierJson<N>> {
    let term = |m: &Multiplier| MultiplierJson { half_plane: m.index, multiplier: number(&m.value) };
    terms.iter().map(term).collect()
}

impl<N> RedundantJson<N> {
    /// A reason that takes no other half-plane.
    pub(crate) fn alone(why: &'static str) -> Self {
        RedundantJson { why, by: Vec::new(), slack: None }
    }

    pub(crate) fn by(
        why: &'static str,
        terms: &[Multiplier],
        slack: &Rational,
        number: impl Fn(&Rational) -> N,
    ) -> Self {
        RedundantJson { why, slack: Some(number(slack)), by: multipliers(terms, number) }
    }

    /// The reason why a step of clipping changes nothing.
    pub(crate) fn of_step(redundancy: &StepRedundancy, number: impl Fn(&Rational) -> N) -> Self {
        match redundancy {
            StepRedundancy::Always => RedundantJson::alone("always"),
            StepRedundancy::AlreadyEmpty => RedundantJson::alone("already-empty"),
            StepRedundancy::Dominated { by, slack } => RedundantJson::by("dominated", by, slack, number),
        }
    }
}
