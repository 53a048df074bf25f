//! The programs of `boundfit convert` as models, beside which solution files are read.

use boundfit_estimation::{BoundName, Problem};
use boundfit_exact::Rational;
use boundfit_judge::SolutionFile;
use boundfit_lp::{Bounds, Model, ModelColumn, ModelRow, PuiEnd};

use crate::rows::ProgramRows;

/// The rows of the four programs, with the objective of one of them.
#[derive(Debug)]
pub(super) struct Programs(Model);

impl Programs {
    /// All upper bounds, all lower bounds, all conditions; an equation is one row.
    pub(super) fn new(problem: &Problem) -> Self {
        let rows = ProgramRows::new(problem);
        let mut model = Model { rows: Vec::with_capacity(rows.rows().len()), ..Model::default() };
        for (name, row) in rows.names().iter().zip(rows.rows()) {
            let row = &row.row;
            let is_lower = matches!(name, BoundName::Lower(_));
            let signed = |number: &Rational| if is_lower { -number } else { number.clone() };
            let bound = Some(signed(&row.b));
            let bounds = match name {
                BoundName::WhereLower(_) => continue,
                BoundName::Lower(_) => Bounds { lower: bound, upper: None },
                BoundName::WhereUpper(_) => Bounds { lower: bound.clone(), upper: bound },
                BoundName::Upper(_) | BoundName::Where(_) => Bounds { lower: None, upper: bound },
            };
            let coefficients = row.a.iter().map(signed).enumerate().collect();
            model.rows.push(ModelRow { name: name.to_string().into(), coefficients, bounds });
        }
        model.columns = [0, 1].map(|_| ModelColumn::default()).into();
        Programs(model)
    }

    /// A file about one program without the row of its objective, if it has that row.
    pub(super) fn without_cost_row(&mut self, file: &SolutionFile, end: PuiEnd) -> Option<SolutionFile> {
        for (column, cost) in self.0.columns.iter_mut().zip(end.objective()) {
            column.cost = cost;
        }
        file.without_cost_row(&self.0)
    }

    /// A file's multipliers, one for each row of a file, as one for each side: an equation has two. In a program that minimises,
    /// a negative one belongs to the upper side. `None` where the file has another number of rows.
    pub(super) fn by_side(&self, duals: &[f64]) -> Option<Vec<f64>> {
        let rows = &self.0.rows;
        let sides = |(row, dual): (&ModelRow, &f64)| match row.bounds.fixed() {
            Some(_) => vec![(-dual).max(0.0), dual.max(0.0)],
            None => vec![dual.abs()],
        };
        (duals.len() == rows.len()).then(|| rows.iter().zip(duals).flat_map(sides).collect())
    }
}
