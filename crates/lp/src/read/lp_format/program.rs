//! The program that expressions add up to.

use boundfit_exact::{Foreign, Rational};

use crate::claim::End;
use crate::model::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};
use crate::read::ModelLimits;
use crate::read::bounds::{Extended, StatedBounds};
use crate::read::error::{ModelError, ModelErrorKind};
use crate::read::names::Names;
use crate::read::text::Field;

/// The program as far as it is known.
pub(super) struct Program<'a> {
    pub(super) sense: ObjectiveSense,
    pub(super) objective_name: &'a str,
    constant: Rational,
    column_names: Names<'a>,
    columns: Vec<Column<'a>>,
    row_names: Names<'a>,
    /// The lines of rows that have a name, in the order of the names.
    row_lines: Vec<u64>,
    rows: Vec<Row<'a>>,
    /// The number of coefficients there are.
    entries: usize,
    limits: &'a ModelLimits,
}

struct Column<'a> {
    /// The first place of its name.
    named: Field<'a>,
    cost: Rational,
    bounds: StatedBounds,
    /// The last expression with a term of it, and its line: 0 for the objective, then the rows.
    last: (usize, u64),
}

struct Row<'a> {
    name: Option<&'a str>,
    coefficients: Vec<(usize, Rational)>,
    bounds: Bounds,
}

impl<'a> Program<'a> {
    pub(super) fn new(limits: &'a ModelLimits) -> Self {
        Program {
            sense: ObjectiveSense::Minimize,
            // As CPLEX calls it.
            objective_name: "obj",
            constant: Rational::zero(),
            column_names: Names::default(),
            columns: Vec::new(),
            row_names: Names::default(),
            row_lines: Vec::new(),
            rows: Vec::new(),
            entries: 0,
            limits,
        }
    }

    /// Adds a term of the objective; one without a variable is its constant, or a part of it.
    pub(super) fn add_cost(
        &mut self,
        is_negative: bool,
        number: Option<Field<'a>>,
        name: Option<Field<'a>>,
    ) -> Result<(), ModelError> {
        let value = self.coefficient(is_negative, number)?;
        let Some(name) = name else {
            self.constant = &self.constant + &value;
            return Ok(());
        };
        let place = self.column(name)?;
        self.columns.get_mut(place).into_iter().for_each(|column| column.cost = value.clone());
        Ok(())
    }

    /// Begins a row, with or without a name.
    pub(super) fn begin_row(&mut self, name: Option<Field<'a>>, place: Field<'a>) -> Result<(), ModelError> {
        if self.rows.len() >= self.limits.rows {
            return Err(place.error(ModelErrorKind::TooManyRows { limit: self.limits.rows }));
        }
        if let Some(name) = name {
            if let Err(place) = self.row_names.add(name.text) {
                let first = self.row_lines.get(place).copied().unwrap_or_default();
                return Err(name.error(ModelErrorKind::RowTwice { first }));
            }
            self.row_lines.push(name.line.number);
        }
        let name = name.map(|name| name.text);
        self.rows.push(Row { name, coefficients: Vec::new(), bounds: Bounds::default() });
        Ok(())
    }

    /// Adds a term of the last row. A number without a variable can only be 0: readers differ on which side others belong to.
    pub(super) fn add_entry(
        &mut self,
        is_negative: bool,
        number: Option<Field<'a>>,
        name: Option<Field<'a>>,
    ) -> Result<(), ModelError> {
        let value = self.coefficient(is_negative, number)?;
        let Some(name) = name else {
            let refused = number.filter(|_| !value.is_zero());
            let expected = "a variable behind the number; numbers alone belong to the right side";
            return refused.map_or(Ok(()), |number| Err(number.error(ModelErrorKind::Unexpected(expected))));
        };
        let place = self.column(name)?;
        if let Some(row) = self.rows.last_mut().filter(|_| !value.is_zero()) {
            row.coefficients.push((place, value));
        }
        Ok(())
    }

    /// Sets a side of the last row.
    pub(super) fn set_side(&mut self, side: End, value: Extended) {
        if let Some(row) = self.rows.last_mut() {
            match side {
                End::Lower => row.bounds.lower = value.finite(),
                End::Upper => row.bounds.upper = value.finite(),
            }
        }
    }

    /// Sets a bound; of several the last one counts (CPLEX).
    pub(super) fn set_bound(&mut self, column: usize, side: End, value: Extended) {
        if let Some(column) = self.columns.get_mut(column) {
            *column.bounds.of(side) = Some(value);
        }
    }

    /// The place of a variable that has a bound. HiGHS and SCIP write bounds of variables without a term, too: their
    /// coefficients are 0. A name like that of another variable is refused, unless they differ in digits alone.
    pub(super) fn bounded_column(&mut self, name: Field<'a>) -> Result<usize, ModelError> {
        if let Some(place) = self.column_names.find(name.text) {
            return Ok(place);
        }
        let letters = |text: &str| text.replace(|c: char| c.is_ascii_digit(), "");
        match self.column_names.nearest(name.text) {
            Some(meant) if letters(meant) != letters(name.text) => {
                Err(name.error(ModelErrorKind::UnknownColumn { meant: Some(meant.into()) }))
            }
            _ => self.column(name),
        }
    }

    fn coefficient(&self, is_negative: bool, number: Option<Field<'a>>) -> Result<Rational, ModelError> {
        let size = number.map_or(Ok(Rational::one()), |number| number.number(self.limits))?;
        Ok(if is_negative { -size } else { size })
    }

    /// The place of a variable, for a term of the last expression.
    fn column(&mut self, name: Field<'a>) -> Result<usize, ModelError> {
        if self.entries >= self.limits.entries {
            return Err(name.error(ModelErrorKind::TooManyEntries { limit: self.limits.entries }));
        }
        self.entries += 1;
        let here = (self.rows.len(), name.line.number);
        match self.column_names.find(name.text) {
            None if self.columns.len() >= self.limits.columns => {
                Err(name.error(ModelErrorKind::TooManyColumns { limit: self.limits.columns }))
            }
            None => {
                // The name is new, as was just seen.
                let (Ok(place) | Err(place)) = self.column_names.add(name.text);
                let bounds = StatedBounds::default();
                self.columns.push(Column { named: name, cost: Rational::zero(), bounds, last: here });
                Ok(place)
            }
            Some(place) => {
                let last =
                    self.columns.get_mut(place).map(|column| std::mem::replace(&mut column.last, here));
                match last {
                    Some((row, first)) if row == here.0 => {
                        Err(name.error(ModelErrorKind::TermTwice { first }))
                    }
                    _ => Ok(place),
                }
            }
        }
    }

    /// Returns the variable that a name may be a term of: `x/3` and `(x)` are names, and x is a variable, too.
    fn taken_for_term(&self, name: &str) -> Option<&'a str> {
        let is_column = |text: &str| self.column_names.find(text).is_some();
        let is_number =
            |text: &str| !text.is_empty() && text.bytes().all(|byte| b"0123456789.".contains(&byte));
        let in_brackets = || name.strip_prefix('(')?.strip_suffix(')');
        let divided = || name.split_once('/').filter(|(_, by)| is_number(by) || is_column(by));
        let variable = divided().map(|(variable, _)| variable).or_else(in_brackets)?;
        let place = self.column_names.find(variable)?;
        self.columns.get(place).map(|column| column.named.text)
    }

    /// The program that all expressions make. Rows without a name are called after their place, as CPLEX does.
    ///
    /// # Errors
    /// With a name that may be a term of another variable.
    pub(super) fn finish(self) -> Result<Model, ModelError> {
        for Column { named, .. } in &self.columns {
            if let Some(of) = self.taken_for_term(named.text) {
                return Err(named.error(ModelErrorKind::MayBeTerm { of: of.into() }));
            }
        }
        let named = self.row_names;
        let column = |(name, column): (&str, Column<'_>)| ModelColumn {
            name: name.into(),
            cost: column.cost,
            bounds: column.bounds.meant(),
        };
        let row = |(number, row): (usize, Row<'_>)| {
            let mut name = row.name.map_or_else(|| format!("c{number}"), str::to_owned);
            while row.name.is_none() && named.find(&name).is_some() {
                name.push('_');
            }
            let mut coefficients = row.coefficients;
            coefficients.sort_by_key(|(column, _)| *column);
            ModelRow { name: name.into(), coefficients, bounds: row.bounds }
        };
        Ok(Model {
            name: Foreign::default(),
            sense: self.sense,
            objective_name: self.objective_name.into(),
            constant: self.constant,
            columns: self.column_names.into_order().zip(self.columns).map(column).collect(),
            rows: (1..).zip(self.rows).map(row).collect(),
        })
    }
}
