//! The four ends of the parameter uncertainty intervals, and what may be claimed about each.

use boundfit_exact::Rational;

use crate::printed::Printed;

/// An end of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// The minimum.
    Lower,
    /// The maximum.
    Upper,
}

impl End {
    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            End::Lower => "lower",
            End::Upper => "upper",
        }
    }
}

/// One of the four ends of the parameter uncertainty intervals (PUI), and the linear program behind it: the minimum or the
/// maximum of one parameter over the feasible parameter set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PuiEnd {
    /// The smallest θ1.
    Theta1Min,
    /// The largest θ1.
    Theta1Max,
    /// The smallest θ2.
    Theta2Min,
    /// The largest θ2.
    Theta2Max,
}

impl PuiEnd {
    /// All four, in the order of claims and reports.
    pub const ALL: [PuiEnd; 4] = [PuiEnd::Theta1Min, PuiEnd::Theta1Max, PuiEnd::Theta2Min, PuiEnd::Theta2Max];

    /// The name of the program and of its file: `theta1-min`.
    pub fn name(self) -> &'static str {
        match self {
            PuiEnd::Theta1Min => "theta1-min",
            PuiEnd::Theta1Max => "theta1-max",
            PuiEnd::Theta2Min => "theta2-min",
            PuiEnd::Theta2Max => "theta2-max",
        }
    }

    /// The name of the program's objective: `theta1_min`, which MPS and LP files take as one word.
    pub fn objective_name(self) -> &'static str {
        match self {
            PuiEnd::Theta1Min => "theta1_min",
            PuiEnd::Theta1Max => "theta1_max",
            PuiEnd::Theta2Min => "theta2_min",
            PuiEnd::Theta2Max => "theta2_max",
        }
    }

    /// The end that a text names last, as `theta1-min` or `theta1_min`, with the text before and after it.
    pub fn find(text: &str) -> Option<(&str, PuiEnd, &str)> {
        let names = PuiEnd::ALL.into_iter().flat_map(|end| [(end, end.name()), (end, end.objective_name())]);
        let found = names.filter_map(|(end, name)| Some((text.rfind(name)?, end, name)));
        let (place, end, name) = found.max_by_key(|(place, ..)| *place)?;
        let (before, rest) = text.split_at_checked(place)?;
        Some((before, end, rest.strip_prefix(name)?))
    }

    /// The parameter: 0 for θ1, 1 for θ2.
    pub fn axis(self) -> usize {
        match self {
            PuiEnd::Theta1Min | PuiEnd::Theta1Max => 0,
            PuiEnd::Theta2Min | PuiEnd::Theta2Max => 1,
        }
    }

    /// Returns which end of the parameter's interval.
    pub fn end(self) -> End {
        match self {
            PuiEnd::Theta1Min | PuiEnd::Theta2Min => End::Lower,
            PuiEnd::Theta1Max | PuiEnd::Theta2Max => End::Upper,
        }
    }

    /// The form that its program minimises: θ1, -θ1, θ2 or -θ2.
    pub fn objective(self) -> [Rational; 2] {
        let unit = |theta1: i64, theta2: i64| [Rational::from(theta1), Rational::from(theta2)];
        match self {
            PuiEnd::Theta1Min => unit(1, 0),
            PuiEnd::Theta1Max => unit(-1, 0),
            PuiEnd::Theta2Min => unit(0, 1),
            PuiEnd::Theta2Max => unit(0, -1),
        }
    }

    /// Returns what both intervals have at this end: of things by parameter, then lower and upper end.
    pub fn of<T>(self, [theta1, theta2]: &[[T; 2]; 2]) -> &T {
        let [lower, upper] = if self.axis() == 0 { theta1 } else { theta2 };
        if self.end() == End::Lower { lower } else { upper }
    }

    /// A thing for each end, by parameter, then lower and upper end.
    ///
    /// # Errors
    /// The first of those of `make`.
    pub fn try_each<T, E>(mut make: impl FnMut(PuiEnd) -> Result<T, E>) -> Result<[[T; 2]; 2], E> {
        Ok([
            [make(PuiEnd::Theta1Min)?, make(PuiEnd::Theta1Max)?],
            [make(PuiEnd::Theta2Min)?, make(PuiEnd::Theta2Max)?],
        ])
    }

    /// A thing for each end, by parameter, then lower and upper end.
    pub fn each<T>(mut make: impl FnMut(PuiEnd) -> T) -> [[T; 2]; 2] {
        [
            [make(PuiEnd::Theta1Min), make(PuiEnd::Theta1Max)],
            [make(PuiEnd::Theta2Min), make(PuiEnd::Theta2Max)],
        ]
    }
}

/// The claim about one end.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundClaim {
    /// The claim itself.
    pub claimed: Claimed,
    /// The point at which the end is said to be attained.
    pub point: Option<[Printed; 2]>,
    /// The solver's multiplier of each row.
    pub duals: Option<Vec<f64>>,
}

/// A claimed end or status.
#[derive(Debug, Clone, PartialEq)]
pub enum Claimed {
    /// The parameter ends here.
    Value(Printed),
    /// No feasible point.
    Infeasible,
    /// The parameter goes on without end.
    Unbounded,
    /// One of the two.
    InfeasibleOrUnbounded,
    /// Nothing, for this reason.
    Nothing(String),
}

impl BoundClaim {
    /// A claim without a point or multipliers to show for it.
    pub fn bare(claimed: Claimed) -> Self {
        BoundClaim { claimed, point: None, duals: None }
    }

    /// No claim, for a reason.
    pub fn nothing(reason: &str) -> Self {
        BoundClaim::bare(Claimed::Nothing(reason.to_owned()))
    }

    /// The claim of a solver that calls a point optimal: the end is the point's own parameter.
    pub fn attained(end: PuiEnd, point: [Printed; 2], duals: Option<Vec<f64>>) -> Self {
        let [theta1, theta2] = &point;
        let value = if end.axis() == 0 { theta1 } else { theta2 }.clone();
        BoundClaim { claimed: Claimed::Value(value), point: Some(point), duals }
    }

    /// This claim with every number meant exactly, however it was printed.
    #[must_use]
    pub fn without_precision(self) -> Self {
        let claimed = match self.claimed {
            Claimed::Value(value) => Claimed::Value(value.without_precision()),
            other => other,
        };
        let point = self.point.map(|point| point.map(Printed::without_precision));
        BoundClaim { claimed, point, duals: self.duals }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_name_counts() {
        assert_eq!(
            PuiEnd::find("out/glpk-theta2-max.mps.sol"),
            Some(("out/glpk-", PuiEnd::Theta2Max, ".mps.sol"))
        );
        assert_eq!(PuiEnd::find("theta1-min/theta1_max"), Some(("theta1-min/", PuiEnd::Theta1Max, "")));
        assert_eq!(PuiEnd::find("theta3-min theta1 min"), None);
    }

    #[test]
    fn each_end_finds_what_was_made_for_it() {
        let made = PuiEnd::each(|end| end);
        for end in PuiEnd::ALL {
            assert_eq!(*end.of(&made), end);
        }
        assert_eq!(made.as_flattened(), PuiEnd::ALL);
    }
}
