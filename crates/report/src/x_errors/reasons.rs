//! The reason why no line agrees, and the remedies.

use boundfit_exact::Rational;
use boundfit_exact::english::{list, listed};
use boundfit_questions::{
    BoxBound, Demand, LeastFactor, NoLeastFactor, Side, SideSet, SlopeDemand, XErrorFit,
};

use super::XErrorReport;
use crate::document::{Symbol, Text};
use crate::formula::{absurdity, products};
use crate::style::Style;

impl XErrorReport<'_> {
    /// Returns, for an empty set, the readings that contradict each other, side by side, and the remedies.
    pub(super) fn emptiness(&self) -> Vec<Text> {
        let first = if self.is_weak() {
            "No line meets the boxes of all readings."
        } else {
            "No line keeps within the bounds of all readings for every x that the errors allow."
        };
        let sides = self.answer.sides.iter().flat_map(|side| {
            let who = match side.side {
                Side::Rising => "Rising and level lines: ",
                Side::Falling => "Falling and level lines: ",
                Side::Both => "",
            };
            let lines = self.contradiction(side).into_iter().enumerate();
            lines.map(move |(number, line)| if number == 0 { Text::from(who).then(line) } else { line })
        });
        let help = match &self.answer.least {
            Err(NoLeastFactor::Never) => "Larger error bounds would not help.".into(),
            Err(reason @ NoLeastFactor::NotMonotone) => format!("No factor is told: {reason}.").into(),
            Ok(least) => {
                let said = match (least.exact(), &least.theta) {
                    (None, _) => "The least factor by which all bounds, of x and y, would have to grow is ",
                    (_, Some(_)) => "All bounds, of x and y, would have to grow by a factor of at least ",
                    (_, None) => "All bounds, of x and y, would have to grow by a factor of more than ",
                };
                Text::from(said).then(self.factor_text(least)).words(".")
            }
        };
        [first.into()].into_iter().chain(sides).chain([help]).collect()
    }

    /// Returns the reason why a side has no line: the demands of its bounds on the slope, and the proof.
    pub(super) fn contradiction(&self, side: &SideSet) -> Vec<Text> {
        let demands = side.slope_demands();
        let mut own: Vec<Text> = demands.iter().filter_map(|demand| self.demand(demand)).collect();
        if own.is_empty() {
            let names = side.contradiction().unwrap_or_default();
            let names = list(names.iter().map(|(name, _)| name.to_string()));
            own.push(format!("{names} contradict each other").into());
        }
        let mut line = Text::new();
        for (number, demand) in own.into_iter().enumerate() {
            line = if number == 0 { line } else { line.words("; ") }.then(demand);
        }
        let terms = side.contradiction().unwrap_or_default();
        let inequalities = side.polyhedron.system().inequalities();
        let farkas = side.farkas().unwrap_or_default();
        let sum: Rational = farkas.iter().map(|own| &inequalities[own.index].b * &own.value).sum();
        let products =
            products(terms.iter().map(|(name, times)| (self.style.proof(times), name.to_string())));
        vec![line.words("."), absurdity(Text::from("Proof: ").then(products), &sum, self.style).words(".")]
    }

    /// `2 upper left and 3 lower right ask for theta1 >= 8.3846`; nothing for what the side itself says.
    fn demand(&self, SlopeDemand { bounds, demand }: &SlopeDemand) -> Option<Text> {
        if let [BoxBound::Slope(_)] = bounds.as_slice() {
            return None;
        }
        let names: Vec<String> = bounds.iter().map(BoxBound::to_string).collect();
        let names = Text::from(listed(&names));
        let verb = if bounds.len() == 1 { " asks for " } else { " ask for " };
        let asks = |relation: Symbol| {
            names.clone().words(verb).symbol(Symbol::Theta1).mark(" ").symbol(relation).mark(" ")
        };
        Some(match demand {
            Demand::AtLeast(end) => asks(Symbol::AtLeast).number(self.style.lower(end)),
            Demand::AtMost(end) => asks(Symbol::AtMost).number(self.style.upper(end)),
            Demand::Impossible => names.words(" contradict each other at every slope"),
        })
    }

    /// The least factor: what it is exactly, or between which numbers it lies.
    fn factor_text(&self, least: &LeastFactor) -> Text {
        let shown = Style { exact: false, ..*self.style };
        match least.exact() {
            Some(value) => self.style.upper_with_exact(value),
            None => {
                let between = Text::from("between ").number(shown.lower(&least.lower));
                between.words(" and ").number(shown.upper(&least.upper))
            }
        }
    }

    /// The least factor on all bounds.
    pub(super) fn factor(&self) -> Vec<(Text, Text)> {
        let XErrorFit { least, .. } = self.answer;
        let label = Text::from("least factor");
        match least {
            Err(reason) => vec![(label, format!("none: {reason}").into())],
            Ok(least) => {
                let text = self.factor_text(least).words(" on the bounds of x and y");
                let names = list(least.fixed_by.iter().map(ToString::to_string));
                let text = if names.is_empty() { text } else { text.words(format!(", fixed by {names}")) };
                let mut lines = vec![(label, text)];
                if least.theta.is_none() {
                    let said = "it leaves no line itself; larger ones do, the closer the steeper";
                    lines.push((Text::new(), said.into()));
                }
                lines
            }
        }
    }
}
