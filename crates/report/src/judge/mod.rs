//! The report of the exact answer to a linear program.

mod json;
mod tables;

use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Rational};
use boundfit_judge::{Answer, BasisStatus, Item, Plane, Side};
use boundfit_lp::{End, Model, ObjectiveSense};

use crate::document::{Block, Document, Operator, Symbol, Text};
use crate::formula::products;
use crate::style::{Style, is_readable};

pub use json::judge_json;

/// The report of an answer to the model of a file of this name: status, optimum, all optimal points, prices and basis, or the
/// certificate; then the feasible set. Numbers are exact; `about` stands before those that are too long to read.
pub fn judge_document(
    model: &Model,
    plane: &Plane,
    answer: &Answer,
    name: Foreign<&str>,
    style: &Style,
) -> Document<'static> {
    let report = Report { model, plane, style };
    let sense = if model.sense == ObjectiveSense::Minimize { "minimize " } else { "maximize " };
    let size = format!(
        ", {}, {}",
        counted(model.rows.len(), "row", "rows"),
        counted(model.columns.len(), "column", "columns")
    );
    let lead = Text::from("Linear program of ").given(name).words(": ").words(sense);
    let lead = lead.then(report.objective()).words(size);
    let mut blocks = vec![Block::Lead(lead)];
    blocks.extend(match answer {
        Answer::Optimal { value, face, prices, basis } => report.optimal(value, face, prices, basis),
        Answer::Infeasible { multipliers } => report.infeasible(multipliers),
        Answer::Unbounded { point, ray } => report.unbounded(point, ray),
    });
    if !matches!(answer, Answer::Infeasible { .. }) {
        blocks.extend(report.feasible_set());
    }
    Document::new(blocks)
}

/// The material of all parts of the report.
struct Report<'a> {
    model: &'a Model,
    plane: &'a Plane,
    style: &'a Style,
}

impl Report<'_> {
    /// The objective by its name.
    fn objective(&self) -> Text {
        match &self.model.objective_name {
            none if none.is_empty() => "the objective".into(),
            name => Text::new().given(name),
        }
    }

    /// A number as it is; rounded behind `about` where it is too long to read.
    fn number(&self, value: &Rational) -> Text {
        const DIGITS: usize = 20;
        match value.exact_decimal(DIGITS.max(self.style.significant())) {
            Some(decimal) if !self.style.exact => Text::new().number(decimal),
            _ if self.style.exact || is_readable(value) => Text::new().number(value),
            _ => Text::from("about ").number(self.style.nearest(value)),
        }
    }

    /// `objective >= value`, as multiples of bounds prove it: each by its name and the sign that makes it point that way.
    fn proof<'b>(&self, terms: impl Iterator<Item = (Side, &'b Rational)>) -> Text {
        products(terms.map(|(side, times)| (self.number(&times.abs()), side_name(self.model, side))))
    }

    fn bound(&self, value: &Rational) -> Text {
        let relation = match self.model.sense {
            ObjectiveSense::Minimize => Symbol::AtLeast,
            ObjectiveSense::Maximize => Symbol::AtMost,
        };
        self.objective().words(" ").symbol(relation).words(" ").then(self.number(value))
    }

    fn value(&self, value: &Rational) -> Text {
        self.objective().operator(Operator::Equals).then(self.number(value))
    }
}

/// The name of a bound: `demand lower`.
pub(crate) fn side_name(model: &Model, side: Side) -> String {
    let end = side.end.name();
    let name = match side.item {
        Item::Row(row) => model.rows.get(row).map(|row| &row.name),
        Item::Column(column) => model.columns.get(column).map(|column| &column.name),
    };
    format!("{} {end}", name.map(Foreign::to_string).unwrap_or_default())
}

/// The bounds that prices are of, in the order of rows and columns, with the prices.
pub(crate) fn priced<'a>(
    model: &Model,
    rows: &'a [Rational],
    columns: &'a [Rational],
) -> impl Iterator<Item = (Side, &'a Rational)> {
    let is_minimum = model.sense == ObjectiveSense::Minimize;
    let rows = rows.iter().enumerate().map(|(index, price)| (Item::Row(index), price));
    let columns = columns.iter().enumerate().map(|(index, price)| (Item::Column(index), price));
    rows.chain(columns).filter(|(_, price)| !price.is_zero()).map(move |(item, price)| {
        let end = if price.is_positive() == is_minimum { End::Lower } else { End::Upper };
        (Side { item, end }, price)
    })
}

/// The name of a status.
pub(crate) fn basis_name(status: BasisStatus) -> &'static str {
    match status {
        BasisStatus::Basic => "basic",
        BasisStatus::AtLower => "lower",
        BasisStatus::AtUpper => "upper",
        BasisStatus::Free => "free",
    }
}
