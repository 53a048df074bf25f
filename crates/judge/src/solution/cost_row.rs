//! The objective among the rows: HiGHS writes GLPK's files so, with numbers as it always prints them.

use boundfit_exact::Rational;
use boundfit_lp::{Model, ModelRow, NumberFormat, ObjectiveSense, Printed};

use super::{Entry, Figure, Reference, SolutionFile};

/// A file of HiGHS in the style of GLPK without the objective's row; `None` for other files. Of a model in MPS that row stands where
/// its N row does, of any other model it is the last. Where several rows have the objective's value, that one is taken beside which
/// the others fit the model best. Cost: linear in the model.
pub(super) fn without_cost_row(file: &SolutionFile, model: &Model) -> Option<SolutionFile> {
    let (objective, line) = file.objective.as_ref()?;
    let value = &objective.finite()?.value;
    let near = Rational::scientific(1, -12) * Rational::one().max(value.abs());
    let is_near = |entry: &Entry| {
        let own = entry.value.as_ref().and_then(Figure::finite);
        own.is_some_and(|own| (&own.value - value).abs() <= near) && price_of(entry).is_zero()
    };
    if file.announced.is_none() || file.rows.len() != model.rows.len() + 1 {
        return None;
    }
    let mut misfit = Misfit::new(model, &file.columns);
    // Without the first row, each row of the model has the next one of the file.
    for (row, entry) in model.rows.iter().zip(file.rows.iter().skip(1)) {
        misfit.change(row, entry, Change::Put);
    }
    let mut best: Option<(Rational, usize)> = None;
    for (place, entry) in file.rows.iter().enumerate() {
        if is_near(entry) && best.as_ref().is_none_or(|(least, _)| misfit.size() < *least) {
            best = Some((misfit.size(), place));
        }
        // Without the next one, the row of the model here has this one.
        if let Some((row, next)) = model.rows.get(place).zip(file.rows.get(place + 1)) {
            misfit.change(row, next, Change::Take);
            misfit.change(row, entry, Change::Put);
        }
    }
    let (_, place) = best?;
    let of_model =
        |(place, row): (usize, &Entry)| Entry { of: Reference::Place(place), ..coarser_entry(row) };
    let others = file.rows.iter().enumerate().filter(|(own, _)| *own != place).map(|(_, row)| row);
    Some(SolutionFile {
        writer: "HiGHS",
        rows: others.enumerate().map(of_model).collect(),
        columns: file.columns.iter().map(coarser_entry).collect(),
        objective: Some((coarser(objective), *line)),
        ..file.clone()
    })
}

/// How far entries of rows are from the optimality of a model: the costs that prices do not explain, and the prices of bounds that
/// are not there or not attained. Each is summed up for prices of either sign.
struct Misfit<'a> {
    model: &'a Model,
    /// The values of the columns, and what the prices leave of their costs.
    values: Vec<Rational>,
    unexplained: [Vec<Rational>; 2],
    sums: [Rational; 2],
}

/// An entry comes to a row, or goes.
#[derive(Clone, Copy)]
enum Change {
    Put,
    Take,
}

impl<'a> Misfit<'a> {
    fn new(model: &'a Model, columns: &[Entry]) -> Self {
        let costs: Vec<Rational> = model.columns.iter().map(|column| column.cost.clone()).collect();
        let mut misfit = Misfit {
            model,
            values: vec![Rational::zero(); costs.len()],
            sums: [0, 1].map(|_| costs.iter().map(Rational::abs).sum()),
            unexplained: [costs.clone(), costs],
        };
        for entry in columns {
            if let Reference::Place(place) = entry.of {
                misfit.explain(place, &price_of(entry));
                if let Some(value) = misfit.values.get_mut(place) {
                    *value = value_of(entry);
                }
            }
        }
        misfit
    }

    /// The sum for prices of the better sign.
    fn size(&self) -> Rational {
        let [one, other] = &self.sums;
        one.min(other).clone()
    }

    /// Takes so much off a column's cost.
    fn explain(&mut self, column: usize, part: &Rational) {
        for (sign, (unexplained, sum)) in self.unexplained.iter_mut().zip(&mut self.sums).enumerate() {
            let Some(left) = unexplained.get_mut(column) else { continue };
            let less = if sign == 0 { &*left - part } else { &*left + part };
            *sum = &*sum - left.abs() + less.abs();
            *left = less;
        }
    }

    fn change(&mut self, row: &ModelRow, entry: &Entry, change: Change) {
        let price = price_of(entry);
        if price.is_zero() {
            return;
        }
        let part = match change {
            Change::Put => price.clone(),
            Change::Take => -&price,
        };
        for (column, coefficient) in &row.coefficients {
            self.explain(*column, &(coefficient * &part));
        }
        let value_of_column = |column: usize| self.values.get(column).cloned().unwrap_or_default();
        let activity: Rational =
            row.coefficients.iter().map(|(column, coefficient)| coefficient * value_of_column(*column)).sum();
        let minimizes = self.model.sense == ObjectiveSense::Minimize;
        for (sign, sum) in self.sums.iter_mut().enumerate() {
            let is_lower = (price.is_positive() == minimizes) == (sign == 0);
            let bound = if is_lower { &row.bounds.lower } else { &row.bounds.upper };
            let distance = match bound {
                Some(bound) => (&activity - bound).abs(),
                None => Rational::one() + activity.abs(),
            };
            let off = &part.abs() * &distance;
            *sum = match change {
                Change::Put => &*sum + off,
                Change::Take => &*sum - off,
            };
        }
    }
}

/// The value; 0 where there is none.
fn value_of(entry: &Entry) -> Rational {
    entry.value.as_ref().and_then(Figure::finite).map_or_else(Rational::zero, |value| value.value.clone())
}

/// A price; 0 where there is none.
fn price_of(entry: &Entry) -> Rational {
    entry.price.as_ref().and_then(Figure::finite).map_or_else(Rational::zero, |price| price.value.clone())
}

fn coarser_entry(entry: &Entry) -> Entry {
    Entry {
        value: entry.value.as_ref().map(coarser),
        price: entry.price.as_ref().map(coarser),
        ..entry.clone()
    }
}

/// A number with the precision of HiGHS.
fn coarser(figure: &Figure) -> Figure {
    let Figure::Finite(printed) = figure else { return Figure::NotFinite };
    let value = printed.value.clone();
    // The digits that a text has beyond those that are printed are not there.
    Figure::Finite(Printed::by_writer("0", value, NumberFormat::HIGHS))
}
