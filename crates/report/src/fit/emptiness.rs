//! The reason why a set is empty, and the remedies.

use std::borrow::Cow;

use boundfit_estimation::{BoundName, ErrorBound, Measurement, mending_rows};
use boundfit_exact::Rational;
use boundfit_exact::english::{counted, listed};

use super::Report;
use crate::document::Text;
use crate::fit_json::not_every_reading;
use crate::formula::{absurdity, products};

impl Report<'_> {
    /// Says of an empty set which rows contradict each other, and what would help.
    pub(super) fn emptiness(&self) -> Vec<Text> {
        let (style, error_bound) = (self.style, self.problem.measurements.error_bound());
        let terms = self.fit.contradiction(error_bound).unwrap_or_default();
        let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
        let verb = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
        let contradiction = format!("No theta meets every bound. These {verb}: {}.", names.join(", "));
        let products = products(terms.iter().map(|(name, m)| (style.proof(m), name.to_string())));
        let proof = absurdity(Text::from("Proof: ").then(products), &self.sum_of(&terms), style);
        let help = match (&self.fit.minimax, error_bound) {
            (None, _) if !self.problem.measurements.has_widths() => {
                "No row has both bounds, so there is no width that could grow.".into()
            }
            (None, _) => "A larger error bound would not help.".into(),
            (Some(minimax), ErrorBound::Uniform(epsilon)) => {
                let growth = Text::from("The error bound would have to grow by ")
                    .number(style.upper(&(&minimax.least - epsilon)));
                growth.words(", to at least ").then(style.upper_with_exact(&minimax.least)).words(".")
            }
            (Some(minimax), _) => {
                let what = match error_bound.has_middles() {
                    true => "All intervals would have to grow about their middles by a factor of at least ",
                    false => "All error bounds would have to grow by a factor of at least ",
                };
                Text::from(what).then(style.upper_with_exact(&minimax.least)).words(".")
            }
        };
        let is_known = self.problem.measurements.unknown_minimax().is_none();
        let help = self.swapped().map_or_else(|| is_known.then_some(help), |why| Some(why.into()));
        let mending = self.mending().into();
        [contradiction.into(), proof.words(".")].into_iter().chain(help).chain([mending]).collect()
    }

    /// Counts the rows whose lower bound is above the upper one.
    fn swapped(&self) -> Option<String> {
        let measurements = &self.problem.measurements;
        let is_swapped = |row: &Cow<'_, Measurement>| {
            row.lower().zip(row.upper()).is_some_and(|(lower, upper)| lower > upper)
        };
        let count = measurements.each_shown().filter(is_swapped).count();
        let shown = measurements.shown();
        // Rows that are not kept may or may not contradict each other.
        let kept = if shown == measurements.fitted() { "" } else { " kept" };
        let rows = counted(shown, "row", "rows");
        (count > 0)
            .then(|| format!("In {count} of {rows}{kept} the lower bound is above the upper one: swapped?"))
    }

    /// Names the single rows without which the set is not empty.
    fn mending(&self) -> String {
        if self.fit.contradiction_of_conditions().is_some() {
            return "No reading is to blame: the conditions contradict each other whatever the readings are."
                .to_owned();
        }
        match mending_rows(self.problem, self.fit).as_deref() {
            None => {
                let reason = not_every_reading(&self.problem.measurements);
                format!("The single row to leave out is not known, {reason}.")
            }
            Some([]) => "No single row is to blame: without any one of them the set stays empty.".to_owned(),
            Some([row]) => {
                format!("Without row {row} the set is not empty; no other single row has this effect.")
            }
            Some(rows) => {
                let rows: Vec<String> = rows.iter().map(ToString::to_string).collect();
                format!(
                    "Without any one of the rows {} the set is not empty; no other row has this effect.",
                    listed(&rows)
                )
            }
        }
    }

    /// The right-hand side of a combination of half-planes.
    fn sum_of(&self, terms: &[(BoundName, Rational)]) -> Rational {
        let inequalities = self.fit.fps.polyhedron().system().inequalities();
        let right_hand_side = |name: &BoundName| {
            (0..inequalities.len())
                .find(|&index| self.fit.fps.name(index) == *name)
                .map(|index| &inequalities[index].b)
        };
        terms.iter().filter_map(|(name, multiplier)| Some(right_hand_side(name)? * multiplier)).sum()
    }
}
