//! The program that lines of data add up to.

use boundfit_exact::{Foreign, Rational};

use super::record::Record;
use super::section::Section;
use crate::claim::End;
use crate::model::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};
use crate::read::ModelLimits;
use crate::read::bounds::{Extended, StatedBounds};
use crate::read::error::{ModelError, ModelErrorKind};
use crate::read::names::Names;
use crate::read::text::Field;

/// The program as far as it is known.
pub(super) struct Program<'a> {
    pub(super) name: &'a str,
    pub(super) sense: Option<ObjectiveSense>,
    /// A comment that asks for a maximum, which only OBJSENSE can.
    pub(super) maximize_comment: Option<Field<'a>>,
    /// The row that OBJNAME names.
    pub(super) objective_name: Option<Field<'a>>,
    row_names: Names<'a>,
    rows: Vec<Row<'a>>,
    column_names: Names<'a>,
    columns: Vec<Column>,
    /// The number of coefficients there are.
    entries: usize,
    /// True if the columns to come are integer.
    is_integer: bool,
    /// The names of the vectors of right-hand sides, ranges and bounds; empty for none.
    vectors: [Option<&'a str>; 3],
    limits: &'a ModelLimits,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Free,
    AtMost,
    AtLeast,
    Equal,
}

struct Row<'a> {
    kind: Kind,
    /// The line that names it.
    line: u64,
    entries: Vec<(usize, Rational)>,
    /// The last column with a coefficient, and its line.
    last: Option<(usize, u64)>,
    side: Option<(Extended, Field<'a>)>,
    range: Option<(Extended, Field<'a>)>,
}

struct Column {
    bounds: StatedBounds,
    /// The lines that state them.
    lower_line: Option<u64>,
    upper_line: Option<u64>,
    /// The last line on which it has a coefficient.
    last: u64,
}

impl<'a> Program<'a> {
    pub(super) fn new(limits: &'a ModelLimits) -> Self {
        Program {
            name: "",
            sense: None,
            maximize_comment: None,
            objective_name: None,
            row_names: Names::default(),
            rows: Vec::new(),
            column_names: Names::default(),
            columns: Vec::new(),
            entries: 0,
            is_integer: false,
            vectors: [None; 3],
            limits,
        }
    }

    pub(super) fn columns(&self) -> &Names<'a> {
        &self.column_names
    }

    pub(super) fn set_integer(&mut self, is_integer: bool) {
        self.is_integer = is_integer;
    }

    /// Takes a line of data in.
    pub(super) fn add(&mut self, section: Section, record: Record<'a>) -> Result<(), ModelError> {
        match (section, record.code, record.name) {
            (Section::Rows, Some(code), Some(name)) => self.add_row(code, name),
            (Section::Columns, _, Some(name)) => {
                let column = self.column_to_fill(name)?;
                let pairs = record.pairs.into_iter().flatten();
                pairs
                    .filter_map(|(row, number)| Some((row, number?)))
                    .try_for_each(|(row, number)| self.add_entry(column, row, number))
            }
            (Section::Rhs | Section::Ranges, _, name) => {
                self.check_vector(section, name, record)?;
                let pairs = record.pairs.into_iter().flatten();
                pairs
                    .filter_map(|(row, number)| Some((row, number?)))
                    .try_for_each(|(row, number)| self.add_side(section, row, number))
            }
            (Section::Bounds, Some(code), name) => {
                self.check_vector(section, name, record)?;
                let [Some((column, number)), _] = record.pairs else { return Ok(()) };
                self.add_bound(code, column, number)
            }
            // No other record is made.
            _ => Ok(()),
        }
    }

    fn add_row(&mut self, code: Field<'a>, name: Field<'a>) -> Result<(), ModelError> {
        let kind = match code.text.to_ascii_uppercase().as_str() {
            "N" => Kind::Free,
            "L" => Kind::AtMost,
            "G" => Kind::AtLeast,
            "E" => Kind::Equal,
            _ => return Err(code.error(ModelErrorKind::RowType)),
        };
        if self.rows.len() >= self.limits.rows {
            return Err(name.error(ModelErrorKind::TooManyRows { limit: self.limits.rows }));
        }
        if name.text.starts_with('$') {
            return Err(name.error(ModelErrorKind::Dollar));
        }
        if let Err(place) = self.row_names.add(name.text) {
            let first = self.rows.get(place).map_or(0, |row| row.line);
            return Err(name.error(ModelErrorKind::RowTwice { first }));
        }
        let line = name.line.number;
        self.rows.push(Row { kind, line, entries: Vec::new(), last: None, side: None, range: None });
        Ok(())
    }

    /// The column that a line has coefficients of: the last one, or a new one.
    fn column_to_fill(&mut self, name: Field<'a>) -> Result<usize, ModelError> {
        let line = name.line.number;
        if self.is_integer {
            return Err(name.error(ModelErrorKind::Integer));
        }
        let known = self.column_names.find(name.text);
        match known {
            Some(place) if place + 1 == self.columns.len() => {
                self.columns.last_mut().into_iter().for_each(|column| column.last = line);
                return Ok(place);
            }
            Some(place) => {
                let last = self.columns.get(place).map_or(0, |column| column.last);
                return Err(name.error(ModelErrorKind::ColumnAgain { last }));
            }
            None => {}
        }
        if self.columns.len() >= self.limits.columns {
            return Err(name.error(ModelErrorKind::TooManyColumns { limit: self.limits.columns }));
        }
        if name.text.starts_with('$') {
            return Err(name.error(ModelErrorKind::Dollar));
        }
        // The name is new, as was just seen.
        let (Ok(place) | Err(place)) = self.column_names.add(name.text);
        let bounds = StatedBounds::default();
        self.columns.push(Column { bounds, lower_line: None, upper_line: None, last: line });
        Ok(place)
    }

    fn row(&mut self, name: Field<'a>) -> Result<&mut Row<'a>, ModelError> {
        let meant = || self.row_names.nearest(name.text).map(Foreign::from);
        let place = self.row_names.find(name.text);
        let place = place.ok_or_else(|| name.error(ModelErrorKind::UnknownRow { meant: meant() }))?;
        // Names and rows are added together.
        self.rows.get_mut(place).ok_or_else(|| name.error(ModelErrorKind::UnknownRow { meant: None }))
    }

    fn add_entry(&mut self, column: usize, name: Field<'a>, number: Field<'a>) -> Result<(), ModelError> {
        let limits = self.limits;
        if self.entries >= limits.entries {
            return Err(name.error(ModelErrorKind::TooManyEntries { limit: limits.entries }));
        }
        self.entries += 1;
        let row = self.row(name)?;
        if let Some((_, first)) = row.last.filter(|(last, _)| *last == column) {
            return Err(name.error(ModelErrorKind::EntryTwice { first }));
        }
        row.last = Some((column, name.line.number));
        let value = number.number(limits)?;
        if !value.is_zero() {
            row.entries.push((column, value));
        }
        Ok(())
    }

    /// Refuses a second vector of a section.
    fn check_vector(
        &mut self,
        section: Section,
        name: Option<Field<'a>>,
        record: Record<'a>,
    ) -> Result<(), ModelError> {
        let [rhs, ranges, bounds] = &mut self.vectors;
        let known = match section {
            Section::Ranges => ranges,
            Section::Bounds => bounds,
            _ => rhs,
        };
        let text = name.map_or("", |name| name.text);
        let first = *known.get_or_insert(text);
        if first == text {
            return Ok(());
        }
        let [pair, _] = record.pairs;
        let place = name.or(pair.map(|(row, _)| row)).or(record.code);
        let kind = ModelErrorKind::SecondVector { section: section.name(), first: first.into() };
        place.map_or(Ok(()), |place| Err(place.error(kind)))
    }

    fn add_side(&mut self, section: Section, name: Field<'a>, number: Field<'a>) -> Result<(), ModelError> {
        let limits = self.limits;
        let row = self.row(name)?;
        let (known, what) = match section {
            Section::Ranges => (&mut row.range, "range"),
            _ => (&mut row.side, "right-hand side"),
        };
        // A range, and the constant of an objective, are no bounds.
        let value = match (section, row.kind) {
            (Section::Rhs, Kind::AtMost | Kind::AtLeast | Kind::Equal) => number.extended(limits)?,
            (Section::Ranges, _) if let Some(infinity) = number.infinity() => infinity,
            _ => Extended::Finite(number.number(limits)?),
        };
        if let Some((_, first)) = known {
            return Err(name.error(ModelErrorKind::SideTwice { what, first: first.line.number }));
        }
        *known = Some((value, number));
        Ok(())
    }

    fn add_bound(
        &mut self,
        code: Field<'a>,
        name: Field<'a>,
        number: Option<Field<'a>>,
    ) -> Result<(), ModelError> {
        let sides: &[End] = match code.text.to_ascii_uppercase().as_str() {
            "LO" | "MI" => &[End::Lower],
            "UP" | "PL" => &[End::Upper],
            "FX" | "FR" => &[End::Lower, End::Upper],
            "BV" | "LI" | "UI" | "SI" => return Err(name.error(ModelErrorKind::Integer)),
            "SC" => return Err(name.error(ModelErrorKind::SemiContinuous)),
            _ => return Err(code.error(ModelErrorKind::BoundType)),
        };
        let value = number.map(|number| number.extended(self.limits)).transpose()?;
        let place = self.column_names.find(name.text).ok_or_else(|| {
            let meant = self.column_names.nearest(name.text).map(Foreign::from);
            name.error(ModelErrorKind::UnknownColumn { meant })
        })?;
        let is_number = ["LO", "UP", "FX"].iter().any(|known| code.text.eq_ignore_ascii_case(known));
        if is_number && value.is_none() {
            return Err(code.line.whole().error(ModelErrorKind::NoBound));
        }
        let Some(column) = self.columns.get_mut(place) else { return Ok(()) };
        for &side in sides {
            let line = match side {
                End::Lower => &mut column.lower_line,
                End::Upper => &mut column.upper_line,
            };
            if let Some(first) = line.replace(name.line.number) {
                return Err(name.error(ModelErrorKind::BoundTwice { side: side.name(), first }));
            }
            let stated = match (&value, number) {
                (Some(value), Some(number)) if is_number => {
                    if *value == Extended::impossible(side)
                        || sides.len() == 2 && !matches!(value, Extended::Finite(_))
                    {
                        return Err(number.error(ModelErrorKind::Impossible(side.name())));
                    }
                    value.clone()
                }
                _ => Extended::none(side),
            };
            *column.bounds.of(side) = Some(stated);
        }
        Ok(())
    }

    /// The program that all lines make.
    pub(super) fn finish(self) -> Result<Model, ModelError> {
        if let Some(comment) = self.maximize_comment.filter(|_| self.sense.is_none()) {
            return Err(comment.error(ModelErrorKind::SenseInComment));
        }
        let objective = match self.objective_name {
            None => self.rows.iter().position(|row| row.kind == Kind::Free),
            Some(name) => {
                let place = self.row_names.find(name.text).ok_or_else(|| {
                    let meant = self.row_names.nearest(name.text).map(Foreign::from);
                    name.error(ModelErrorKind::UnknownRow { meant })
                })?;
                if self.rows.get(place).is_none_or(|row| row.kind != Kind::Free) {
                    return Err(name.error(ModelErrorKind::NotAnObjective));
                }
                Some(place)
            }
        };
        let column = |(name, column): (&str, Column)| ModelColumn {
            name: name.into(),
            cost: Rational::zero(),
            bounds: column.bounds.meant_in_mps(),
        };
        let mut model = Model {
            name: self.name.into(),
            sense: self.sense.unwrap_or_default(),
            columns: self.column_names.into_order().zip(self.columns).map(column).collect(),
            ..Model::default()
        };
        for (place, (name, row)) in self.row_names.into_order().zip(self.rows).enumerate() {
            if row.kind != Kind::Free {
                let (coefficients, bounds) = row.finish()?;
                model.rows.push(ModelRow { name: name.into(), coefficients, bounds });
            } else if Some(place) == objective {
                row.set_objective(name, &mut model)?;
            } else if let Some((_, range)) = row.range {
                return Err(range.error(ModelErrorKind::RangeOfObjective));
            }
        }
        Ok(model)
    }
}

impl Row<'_> {
    /// Coefficients and bounds of a constraint.
    fn finish(self) -> Result<(Vec<(usize, Rational)>, Bounds), ModelError> {
        let (side, side_field) = match self.side {
            None => (Extended::Finite(Rational::zero()), None),
            Some((side, field)) => (side, Some(field)),
        };
        let impossible = match self.kind {
            Kind::AtMost => side == Extended::Minus,
            Kind::AtLeast => side == Extended::Plus,
            Kind::Equal | Kind::Free => !matches!(side, Extended::Finite(_)),
        };
        if let Some(field) = side_field.filter(|_| impossible) {
            let side = if side == Extended::Plus { End::Lower } else { End::Upper };
            return Err(field.error(ModelErrorKind::Impossible(side.name())));
        }
        let side = side.finite();
        let mut bounds = Bounds {
            lower: side.clone().filter(|_| self.kind != Kind::AtMost),
            upper: side.clone().filter(|_| self.kind != Kind::AtLeast),
        };
        if let Some((range, field)) = self.range {
            let side = side.ok_or_else(|| field.error(ModelErrorKind::RangeOfNothing))?;
            let goes_down = match self.kind {
                Kind::AtMost => true,
                Kind::AtLeast => false,
                Kind::Equal | Kind::Free => match &range {
                    Extended::Finite(range) => range.is_negative(),
                    infinite => *infinite == Extended::Minus,
                },
            };
            let size = range.finite().map(|range| range.abs());
            if goes_down {
                bounds.lower = size.and_then(|size| Extended::new(side - size).finite());
            } else {
                bounds.upper = size.and_then(|size| Extended::new(side + size).finite());
            }
        }
        Ok((self.entries, bounds))
    }

    /// Makes this the objective.
    fn set_objective(self, name: &str, model: &mut Model) -> Result<(), ModelError> {
        if let Some((_, range)) = self.range {
            return Err(range.error(ModelErrorKind::RangeOfObjective));
        }
        model.objective_name = name.into();
        let side = self.side.and_then(|(side, _)| side.finite());
        model.constant = -side.unwrap_or_else(Rational::zero);
        for (place, cost) in self.entries {
            model.columns.iter_mut().skip(place).take(1).for_each(|column| column.cost = cost.clone());
        }
        Ok(())
    }
}
