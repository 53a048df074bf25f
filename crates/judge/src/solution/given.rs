//! The entries of a solution file, by columns and rows of a model.

use std::collections::HashMap;

use boundfit_exact::Rational;
use boundfit_lp::{Model, Printed};

use super::error::{SolutionError, quoted};
use super::{Entry, Figure, Reference, SolutionFile, SolverStatus};
use crate::answer::Item;

/// A number of a solution file, and the line that says so, from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Given {
    /// The number.
    pub number: Printed,
    /// The line.
    pub line: usize,
}

/// The part of a solution that a number belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The optimum that is claimed.
    Objective,
    /// The point.
    Point,
    /// The duals of rows.
    Duals,
    /// The reduced costs of columns.
    ReducedCosts,
    /// The ray.
    Ray,
    /// The multipliers of rows.
    Farkas,
}

/// A number of a solution that is `inf`, `nan` or a relative of theirs: nothing is said by its part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotFinite {
    /// The part.
    pub part: Part,
    /// The column or row; `None` for the objective.
    pub item: Option<Item>,
    /// The line, from 1.
    pub line: usize,
}

/// A solution with an entry for each column and row of a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solution {
    /// The program that writes such files.
    pub writer: &'static str,
    /// The end of the solver.
    pub status: SolverStatus,
    /// The line of the status, from 1.
    pub status_line: usize,
    /// The optimum that is claimed.
    pub objective: Option<Given>,
    /// The value of each column; `None` where there is no point, or one that is not finite.
    pub point: Option<Vec<Given>>,
    /// The dual of each row.
    pub duals: Option<Vec<Given>>,
    /// The reduced cost of each column; `None` for a column that a list without small values leaves out.
    pub reduced_costs: Option<Vec<Option<Given>>>,
    /// An entry for each column.
    pub ray: Option<Vec<Given>>,
    /// A multiplier for each row.
    pub farkas: Option<Vec<Given>>,
    /// The first number of each part that is not finite: that part has no numbers then.
    pub not_finite: Vec<NotFinite>,
    /// True if the file has activities or slacks of rows, which are passed over.
    pub has_activities: bool,
    /// The number of rows with a dual in the file, where the model has another one: the duals are passed over.
    pub other_rows: Option<usize>,
}

impl Solution {
    /// Gives what the file says to the columns and rows that it names. Values of a status other than optimal are left out:
    /// they mean nothing. Cost: a look-up for each entry.
    ///
    /// # Errors
    /// With names and places that the model has not, with two values for one of them, and with columns left out by a
    /// writer that leaves none out. Rows without a price may be any: files list free rows, which a model has not.
    pub fn new(file: &SolutionFile, model: &Model) -> Result<Self, SolutionError> {
        let by_highs = file.without_cost_row(model);
        let file = by_highs.as_ref().unwrap_or(file);
        let columns = Names::new("column", model.columns.iter().map(|column| column.name.raw()));
        let rows = Names::new("row", model.rows.iter().map(|row| row.name.raw()));
        if let Some(announced) = file.announced.as_ref().filter(|own| own.columns != model.columns.len()) {
            return Err(SolutionError::Unknown {
                line: announced.line,
                of: format!("{:?}", quoted(&announced.text)).into(),
                kind: "solution",
                available: columns.available(),
            });
        }
        let is_optimal = file.status == SolverStatus::Optimal;
        let (own_columns, own_rows) = split(file, &columns, &rows);
        let values = columns.fill(own_columns.iter().copied(), Entry::value_at)?;
        let reduced = columns.fill(own_columns.iter().copied(), Entry::price_at)?;
        let point = point(file, model, &values)?;
        // A list without small values leaves the reduced costs of such columns out, too.
        let is_known = values
            .iter()
            .zip(&reduced)
            .map(|slots| file.omits_zero_duals || !matches!(slots, (Slot::Missing, Slot::Missing)));
        let has_prices = reduced.iter().any(|price| matches!(price, Slot::Given(_)));
        let by_number = own_rows.iter().any(|row| matches!(row.of, Reference::Place(_)));
        let is_other = by_number && file.announced.is_some() && own_rows.len() != model.rows.len();
        let duals = if is_other { None } else { rows.duals(file, &own_rows)? };
        let listed = duals.iter().flatten().filter(|slot| !matches!(slot, Slot::Missing)).count();
        let is_short = duals.is_some() && listed < model.rows.len() && !file.omits_zero_duals;
        let other_rows = if is_short { Some(listed) } else { is_other.then_some(own_rows.len()) };
        let duals = duals.filter(|_| !is_short);
        let ray = file.ray.as_ref().map(|ray| columns.fill(ray.iter(), Entry::value_at)).transpose()?;
        let farkas = file.farkas.as_ref().map(|rays| rows.fill(rays.iter(), Entry::value_at)).transpose()?;
        let lists = [
            (Part::Point, Some(&values).filter(|_| is_optimal)),
            (Part::Duals, duals.as_ref().filter(|_| is_optimal)),
            (Part::ReducedCosts, Some(&reduced).filter(|_| is_optimal)),
            (Part::Ray, ray.as_ref()),
            (Part::Farkas, farkas.as_ref()),
        ];
        let not_finite = lists.into_iter().filter_map(|(part, slots)| first_not_finite(part, slots?));
        let zero = |_| Given { number: Rational::zero().into(), line: file.status_line };
        Ok(Solution {
            writer: file.writer,
            status: file.status.clone(),
            status_line: file.status_line,
            objective: file.objective.as_ref().and_then(|(figure, line)| given(figure, *line)),
            point,
            duals: duals.as_ref().and_then(|duals| all(duals, zero)).filter(|_| is_optimal),
            reduced_costs: all(&reduced, zero).filter(|_| is_optimal && has_prices).map(|prices| {
                prices.into_iter().zip(is_known).map(|(price, is)| is.then_some(price)).collect()
            }),
            ray: ray.as_ref().and_then(|ray| all(ray, zero)),
            farkas: farkas.as_ref().and_then(|farkas| all(farkas, zero)),
            not_finite: not_finite.chain(objective_not_finite(file)).collect(),
            has_activities: is_optimal && (file.has_slacks || own_rows.iter().any(|row| row.value.is_some())),
            other_rows: other_rows.filter(|_| is_optimal),
        })
    }

    /// Refuses a solution that another program has: each of its lists has an entry for each column, or for each row, of the model. A
    /// solution that [`Solution::new`] made has them. Cost: nothing.
    ///
    /// # Errors
    /// [`SolutionError::Count`] with the first list of another length.
    pub fn of_size(self, model: &Model) -> Result<Self, SolutionError> {
        let (columns, rows) = (("column", model.columns.len()), ("row", model.rows.len()));
        let length = |given: &Option<Vec<Given>>| given.as_ref().map(Vec::len);
        let lists = [
            ("the point", length(&self.point), columns),
            ("the list of duals", length(&self.duals), rows),
            ("the list of reduced costs", self.reduced_costs.as_ref().map(Vec::len), columns),
            ("the ray", length(&self.ray), columns),
            ("the list of multipliers", length(&self.farkas), rows),
        ];
        let counts = lists.into_iter().filter_map(|(list, count, of)| Some((list, count?, of)));
        for (list, count, (kind, expected)) in counts {
            if count != expected {
                return Err(SolutionError::Count { list, count, expected, kind });
            }
        }
        Ok(self)
    }
}

impl Entry {
    /// The value and its line.
    fn value_at(&self) -> Option<(&Figure, usize)> {
        self.value.as_ref().map(|value| (value, self.line))
    }

    /// The price and its line.
    fn price_at(&self) -> Option<(&Figure, usize)> {
        self.price.as_ref().map(|price| (price, self.price_line))
    }
}

fn given(figure: &Figure, line: usize) -> Option<Given> {
    figure.finite().map(|number| Given { number: number.clone(), line })
}

/// The entries of a file about one column or row.
#[derive(Debug, Clone)]
enum Slot {
    Missing,
    /// The line.
    NotFinite(usize),
    Given(Given),
}

/// All numbers, if they are finite, with something in place of what is missing.
fn all(slots: &[Slot], missing: impl Fn(()) -> Given) -> Option<Vec<Given>> {
    let number = |slot: &Slot| match slot {
        Slot::Missing => Some(missing(())),
        Slot::NotFinite(_) => None,
        Slot::Given(given) => Some(given.clone()),
    };
    slots.iter().map(number).collect()
}

/// The objective of an optimum, if it is not finite.
fn objective_not_finite(file: &SolutionFile) -> Option<NotFinite> {
    let (figure, line) = file.objective.as_ref().filter(|_| file.status == SolverStatus::Optimal)?;
    let not_finite = NotFinite { part: Part::Objective, item: None, line: *line };
    figure.finite().is_none().then_some(not_finite)
}

/// The first number of a list that is not finite.
fn first_not_finite(part: Part, slots: &[Slot]) -> Option<NotFinite> {
    let numbers = slots.iter().enumerate();
    let mut lines = numbers.filter_map(|(place, slot)| match slot {
        Slot::NotFinite(line) => Some((place, *line)),
        _ => None,
    });
    let (place, line) = lines.next()?;
    let is_row = matches!(part, Part::Duals | Part::Farkas);
    Some(NotFinite { part, item: Some(if is_row { Item::Row(place) } else { Item::Column(place) }), line })
}

/// The point of an optimum; `None` where the file has none.
fn point(file: &SolutionFile, model: &Model, values: &[Slot]) -> Result<Option<Vec<Given>>, SolutionError> {
    let is_missing = |value: &Slot| matches!(value, Slot::Missing);
    let has_none = file.left_out.is_none() && values.iter().any(is_missing) && values.iter().all(is_missing);
    if file.status != SolverStatus::Optimal || has_none {
        return Ok(None);
    }
    let missing = model.columns.iter().zip(values).find(|(_, value)| is_missing(value));
    if let (None, Some((column, _))) = (&file.left_out, missing) {
        return Err(SolutionError::NoValue { format: file.writer, column: column.name.clone() });
    }
    let left_out = |_| Given {
        number: Printed::left_out(file.left_out.clone().unwrap_or_default()),
        line: file.status_line,
    };
    Ok(all(values, left_out))
}

/// The entries of columns and of rows. CBC lists rows alone where no column is above zero, and Gurobi adds a column for each row in
/// RANGES.
fn split<'a>(
    file: &'a SolutionFile,
    columns: &Names<'_>,
    rows: &Names<'_>,
) -> (Vec<&'a Entry>, Vec<&'a Entry>) {
    const ADDED: &str = "MPS_Rg";
    let other_name = |entry: &&'a Entry| match &entry.of {
        Reference::Name(name) if file.left_out.is_some() && !columns.has(name) => Some(name.as_str()),
        _ => None,
    };
    let is_row = |entry: &&'a Entry| other_name(entry).is_some_and(|name| rows.has(name));
    let is_added = |entry: &&'a Entry| {
        other_name(entry).and_then(|name| name.strip_prefix(ADDED)).is_some_and(|row| rows.has(row))
    };
    let of_model = file.columns.iter().filter(|entry| !is_added(entry));
    let (of_rows, of_columns): (Vec<&Entry>, Vec<&Entry>) = of_model.partition(is_row);
    (of_columns, file.rows.iter().chain(of_rows).collect())
}

/// Columns or rows by name.
struct Names<'a> {
    kind: &'static str,
    names: Vec<&'a str>,
    places: HashMap<&'a str, usize>,
}

impl<'a> Names<'a> {
    fn new(kind: &'static str, names: impl Iterator<Item = &'a str>) -> Self {
        let names: Vec<&str> = names.collect();
        let places = names.iter().enumerate().map(|(place, name)| (*name, place)).collect();
        Names { kind, names, places }
    }

    fn has(&self, name: &str) -> bool {
        self.places.contains_key(name)
    }

    fn place(&self, of: &Reference) -> Option<usize> {
        match of {
            Reference::Name(name) => self.places.get(name.as_str()).copied(),
            Reference::Place(place) => Some(*place).filter(|place| *place < self.names.len()),
        }
    }

    fn available(&self) -> String {
        const FEW: usize = 5;
        let some =
            self.names.iter().take(FEW).map(|name| quoted(name).to_string()).collect::<Vec<_>>().join(", ");
        match self.names.len() {
            0 => "nothing, the model has none".to_owned(),
            count if count > FEW => format!("{some} or another of {count}"),
            _ => some,
        }
    }

    fn unknown(&self, entry: &Entry) -> SolutionError {
        let of = match &entry.of {
            Reference::Name(name) => quoted(name),
            Reference::Place(place) => format!("number {}", place + 1).into(),
        };
        SolutionError::Unknown { line: entry.line, of, kind: self.kind, available: self.available() }
    }

    /// Returns what the entries say of each.
    fn fill<'e>(
        &self,
        entries: impl Iterator<Item = &'e Entry>,
        figure: impl Fn(&Entry) -> Option<(&Figure, usize)>,
    ) -> Result<Vec<Slot>, SolutionError> {
        let mut slots = vec![Slot::Missing; self.names.len()];
        let mut lines: Vec<Option<usize>> = vec![None; self.names.len()];
        for entry in entries {
            let place = self.place(&entry.of).ok_or_else(|| self.unknown(entry))?;
            let (Some(slot), Some(line)) = (slots.get_mut(place), lines.get_mut(place)) else { continue };
            let Some((figure, own)) = figure(entry) else { continue };
            if let Some(first) = line.replace(own) {
                let of = self.names.get(place).map(|name| quoted(name)).unwrap_or_default();
                return Err(SolutionError::Twice { line: own, of, first });
            }
            *slot = given(figure, own).map_or(Slot::NotFinite(own), Slot::Given);
        }
        Ok(slots)
    }

    /// The duals of rows; `None` where the file has none.
    fn duals(&self, file: &SolutionFile, rows: &[&Entry]) -> Result<Option<Vec<Slot>>, SolutionError> {
        let priced = |entry: &&&Entry| {
            let price = entry.price.as_ref();
            price.is_some_and(|price| price.finite().is_none_or(|price| !price.value.is_zero()))
        };
        let has_any = file.has_duals || rows.iter().any(|row| row.price.is_some());
        let known = rows.iter().filter(|row| self.place(&row.of).is_some() || priced(row));
        let filled = self.fill(known.copied(), Entry::price_at)?;
        // A program without rows has all its duals.
        Ok((has_any || self.names.is_empty()).then_some(filled))
    }
}
