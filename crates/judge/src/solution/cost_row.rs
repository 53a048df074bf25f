//! The objective among the rows: HiGHS writes GLPK's files so, with numbers as it always prints them.

use boundfit_exact::{Integer, Rational};
use boundfit_lp::{Model, ModelRow, NumberFormat, ObjectiveSense, Printed};

use super::{Entry, Figure, Reference, SolutionFile};

impl SolutionFile {
    /// This file without the row of the objective, which HiGHS adds in the style of GLPK; `None` for other files. Of a model in MPS
    /// that row stands where its N row does, of any other model it is the last. Where several rows have the objective's value, that
    /// one is taken beside which the others fit the model best. Cost: linear in the model.
    pub fn without_cost_row(&self, model: &Model) -> Option<SolutionFile> {
        let (objective, line) = self.objective.as_ref()?;
        if self.announced.is_none() || self.rows.len() != model.rows.len() + 1 {
            return None;
        }
        // HiGHS writes 0 for the objective of a model without costs, and the constant as the value of its row.
        let has_costs = model.columns.iter().any(|column| !column.cost.is_zero());
        let value = if has_costs { &objective.finite()?.value } else { &model.constant };
        let place = cost_row(self, model, value)?;
        let is_highs = numbers(self).all(is_short);
        let of_model = |(place, row): (usize, &Entry)| Entry { of: Reference::Place(place), ..row.clone() };
        let others = self.rows.iter().enumerate().filter(|(own, _)| *own != place).map(|(_, row)| row);
        // Any other number is what the file claims.
        let is_blank = !has_costs && objective.finite().is_some_and(|own| own.value.is_zero());
        let own_value = self.rows.get(place).and_then(|row| row.value.clone()).filter(|_| is_blank);
        let file = SolutionFile {
            rows: others.enumerate().map(of_model).collect(),
            objective: Some((own_value.unwrap_or_else(|| objective.clone()), *line)),
            ..self.clone()
        };
        Some(if is_highs { by_highs(file) } else { file })
    }
}

/// The place of the objective among the rows of a file with one row more than the model.
fn cost_row(file: &SolutionFile, model: &Model, value: &Rational) -> Option<usize> {
    let near = Rational::scientific(1, -12) * Rational::one().max(value.abs());
    let is_near = |entry: &Entry| {
        let own = entry.value.as_ref().and_then(Figure::finite);
        let is_free = entry.price != Some(Figure::NotFinite) && number(&entry.price).is_zero();
        own.is_some_and(|own| (&own.value - value).abs() <= near) && is_free
    };
    let mut misfit = Misfit::new(model, &file.columns);
    // Without the first row, each row of the model has the next one of the file.
    for (row, entry) in model.rows.iter().zip(file.rows.iter().skip(1)) {
        misfit.change(row, entry, Change::Put);
    }
    let mut best: Option<(Rational, usize)> = None;
    for (place, entry) in file.rows.iter().enumerate() {
        if is_near(entry) && best.as_ref().is_none_or(|(least, _)| misfit.size < *least) {
            best = Some((misfit.size.clone(), place));
        }
        // Without the next one, the row of the model here has this one.
        if let Some((row, next)) = model.rows.get(place).zip(file.rows.get(place + 1)) {
            misfit.change(row, next, Change::Take);
            misfit.change(row, entry, Change::Put);
        }
    }
    best.map(|(_, place)| place)
}

/// The finite numbers of columns and rows.
fn numbers(file: &SolutionFile) -> impl Iterator<Item = &Rational> {
    let entries = file.columns.iter().chain(&file.rows);
    let figures = entries.flat_map(|entry| entry.value.iter().chain(&entry.price));
    figures.filter_map(Figure::finite).map(|number| &number.value)
}

/// Returns whether a number has no digit beyond the last one that HiGHS prints. GLPK, which lists the objective of a MathProg model,
/// prints more digits of small numbers.
fn is_short(value: &Rational) -> bool {
    let last = 10_i64.pow(13);
    (value * &Rational::from(last)).denominator() == Integer::one()
}

/// The file with its numbers as HiGHS prints them.
fn by_highs(file: SolutionFile) -> SolutionFile {
    SolutionFile {
        writer: "HiGHS",
        rows: file.rows.into_iter().map(coarser_entry).collect(),
        columns: file.columns.into_iter().map(coarser_entry).collect(),
        objective: file.objective.map(|(objective, line)| (coarser(&objective), line)),
        ..file
    }
}

/// How far entries of rows are from the optimality of a model: the costs that prices do not explain, and the prices of bounds that
/// are not there or not attained.
struct Misfit<'a> {
    model: &'a Model,
    /// The values of the columns, and what the prices leave of their costs.
    values: Vec<Rational>,
    unexplained: Vec<Rational>,
    size: Rational,
}

/// An entry comes to a row, or goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Change {
    Put,
    Take,
}

impl<'a> Misfit<'a> {
    fn new(model: &'a Model, columns: &[Entry]) -> Self {
        let unexplained: Vec<Rational> = model.columns.iter().map(|column| column.cost.clone()).collect();
        let size = unexplained.iter().map(Rational::abs).sum();
        let mut misfit =
            Misfit { model, values: vec![Rational::zero(); unexplained.len()], unexplained, size };
        for entry in columns {
            if let Reference::Place(place) = entry.of {
                misfit.explain(place, &number(&entry.price));
                if let Some(value) = misfit.values.get_mut(place) {
                    *value = number(&entry.value);
                }
            }
        }
        misfit
    }

    /// Takes so much off a column's cost.
    fn explain(&mut self, column: usize, part: &Rational) {
        let Some(left) = self.unexplained.get_mut(column) else { return };
        let less = &*left - part;
        self.size = &self.size - left.abs() + less.abs();
        *left = less;
    }

    fn change(&mut self, row: &ModelRow, entry: &Entry, change: Change) {
        let price = number(&entry.price);
        if price.is_zero() {
            return;
        }
        let signed = |number: Rational| if change == Change::Put { number } else { -number };
        let mut activity = Rational::zero();
        for (column, coefficient) in &row.coefficients {
            self.explain(*column, &signed(coefficient * &price));
            activity = activity + coefficient * self.values.get(*column).cloned().unwrap_or_default();
        }
        let is_lower = price.is_positive() == (self.model.sense == ObjectiveSense::Minimize);
        let distance = match if is_lower { &row.bounds.lower } else { &row.bounds.upper } {
            Some(bound) => (activity - bound).abs(),
            None => Rational::one() + activity.abs(),
        };
        self.size = &self.size + signed(price.abs() * distance);
    }
}

/// A number; 0 where there is none.
fn number(figure: &Option<Figure>) -> Rational {
    figure.as_ref().and_then(Figure::finite).map_or_else(Rational::zero, |number| number.value.clone())
}

fn coarser_entry(entry: Entry) -> Entry {
    Entry { value: entry.value.as_ref().map(coarser), price: entry.price.as_ref().map(coarser), ..entry }
}

/// A number with the precision of HiGHS.
fn coarser(figure: &Figure) -> Figure {
    let Figure::Finite(printed) = figure else { return Figure::NotFinite };
    let value = printed.value.clone();
    // The digits that a text has beyond those that are printed are not there.
    Figure::Finite(Printed::by_writer("0", value, NumberFormat::HIGHS))
}
