//! The half-planes of readings as functions of their error bounds.

use boundfit_exact::Rational;

use crate::bound_name::BoundName;
use crate::condition::Condition;
use crate::fps::{conditions_by_name, growing_half_planes};
use crate::least_growth::GrowingInequality;
use crate::measurement::Measurement;

/// The half-planes of readings and conditions as functions of the error bound.
pub(crate) struct Growing {
    pub(crate) names: Vec<BoundName>,
    pub(crate) inequalities: Vec<GrowingInequality>,
}

impl Growing {
    pub(crate) fn with(mut self, conditions: &[Condition]) -> Self {
        for (name, at_zero) in conditions_by_name(conditions) {
            self.names.push(name);
            self.inequalities.push(GrowingInequality { at_zero, growth: Rational::zero() });
        }
        self
    }

    /// Collects half-planes that grow; under a uniform bound the factor is the bound itself, so that every reading
    /// grows by 1.
    pub(crate) fn of_rows<'a>(rows: impl Iterator<Item = &'a Measurement>, is_uniform: bool) -> Self {
        let (names, mut inequalities): (_, Vec<GrowingInequality>) =
            rows.flat_map(growing_half_planes).unzip();
        if is_uniform {
            inequalities.iter_mut().for_each(|inequality| inequality.growth = Rational::one());
        }
        Growing { names, inequalities }
    }
}
