//! Models as files.

use std::collections::HashSet;

use boundfit_exact::Rational;

use super::escaped;
use super::number::decimal;
use super::rows::{INFINITE, LargeBounds, WrittenRows};
use super::written::{Written, WrittenColumn};
use crate::format::ExchangeFormat;
use crate::model::{Bounds, Model};
use crate::read::{ends_name, is_keyword};

impl Model {
    /// The file. Exact: read as it stands, it is this program again.
    ///
    /// Where a format cannot say something, the file states an equivalent program and says so in comments at the top.
    /// Rows with a number that has no finite decimal are multiplied with the least number that makes all of them
    /// whole. Rows with a bound from 10³⁰ on, which readers take for infinite, are multiplied with a power of ten;
    /// such a bound of a column becomes a row. In MPS, a row whose lower bound lies above the upper one becomes two.
    /// Names that the format does not allow, or that occur twice, become others. LP format has no name of the
    /// program. Cost: linear in the result.
    ///
    /// ```
    /// use boundfit_lp::{ExchangeFormat, ModelLimits, read_model};
    ///
    /// let model = read_model("max x st x <= 0.1 end", ExchangeFormat::Lp, &ModelLimits::default())?;
    /// let mps = model.text(ExchangeFormat::Mps);
    /// assert_eq!(read_model(&mps, ExchangeFormat::Mps, &ModelLimits::default())?, model);
    /// # Ok::<(), boundfit_lp::ModelError>(())
    /// ```
    pub fn text(&self, format: ExchangeFormat) -> String {
        let mut remarks = Vec::new();
        let mut rows = vec![(self.objective_name.raw().to_owned(), Form::Objective, Bounds::default())];
        for row in &self.rows {
            let row = (row.name.raw().to_owned(), Form::Row(&row.coefficients), row.bounds.clone());
            rows.extend(sayable(row, format, &mut remarks));
        }
        let names = self.columns.iter().map(|column| column.name.raw().to_owned()).collect();
        let mut columns = Vec::new();
        for (place, (column, name)) in
            self.columns.iter().zip(legal(names, format, "column", &mut remarks)).enumerate()
        {
            let Bounds { lower, upper } = &column.bounds;
            let is_readable = |bound: &Rational| {
                bound.is_finite_decimal()
                    && bound.decimal_exponent().is_none_or(|exponent| exponent < INFINITE)
            };
            if lower.iter().chain(upper).all(is_readable) {
                columns.push(WrittenColumn {
                    name,
                    lower: lower.as_ref().map(decimal),
                    upper: upper.as_ref().map(decimal),
                });
            } else {
                remarks.push(format!("{name}: its bounds are those of the row bound_{name}"));
                let row = (format!("bound_{name}"), Form::Column(place), column.bounds.clone());
                rows.extend(sayable(row, format, &mut remarks));
                columns.push(WrittenColumn { name, lower: None, upper: None });
            }
        }
        self.write(rows, &columns, remarks, format)
    }

    /// The file with these rows, the first of which is the objective.
    fn write(
        &self,
        rows: Vec<NamedRow<'_>>,
        columns: &[WrittenColumn],
        mut remarks: Vec<String>,
        format: ExchangeFormat,
    ) -> String {
        let names = rows.iter().map(|(name, _, _)| name.clone()).collect();
        let one = Rational::one();
        let (mut objective, mut written) = (WrittenRows::default(), WrittenRows::default());
        for (name, (_, form, bounds)) in legal(names, format, "row", &mut remarks).into_iter().zip(&rows) {
            match form {
                // A bound makes the constant one of the numbers that decide on the scale.
                Form::Objective => {
                    let costs: Vec<_> = self.columns.iter().map(|column| &column.cost).enumerate().collect();
                    let bounds = Bounds { lower: Some(self.constant.clone()), upper: None };
                    objective.push(name, &costs, &bounds, LargeBounds::Kept);
                }
                Form::Row(coefficients) => {
                    let coefficients: Vec<_> =
                        coefficients.iter().map(|(column, value)| (*column, value)).collect();
                    written.push(name, &coefficients, bounds, LargeBounds::Finite);
                }
                Form::Column(place) => written.push(name, &[(*place, &one)], bounds, LargeBounds::Finite),
            }
        }
        let remarks = remarks.iter().chain(objective.remarks()).chain(written.remarks());
        let remarks = remarks.map(String::as_str).collect();
        let Some(objective) = objective.iter().next() else { return String::new() };
        let constant = objective.lower.unwrap_or("0").to_owned();
        let opposite = match constant.strip_prefix('-') {
            Some(size) => size.to_owned(),
            None if constant == "0" => constant.clone(),
            None => format!("-{constant}"),
        };
        let is_odd = |character: char| character.is_control() && character != '\t';
        let name = if self.name.raw().contains(is_odd) { "" } else { self.name.raw().trim() };
        let constant = [constant, opposite];
        let program =
            Written { name, sense: self.sense, objective, constant, columns, rows: &written, remarks };
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = super::write(&mut text, &program, format);
        text
    }
}

/// A row under its name, with its bounds.
type NamedRow<'a> = (String, Form<'a>, Bounds);

/// A row as rows that the format can say: the RANGES of MPS always leave values, so that bounds that cross need two.
fn sayable<'a>(row: NamedRow<'a>, format: ExchangeFormat, remarks: &mut Vec<String>) -> Vec<NamedRow<'a>> {
    let (name, form, bounds) = &row;
    let is_crossed = matches!((&bounds.lower, &bounds.upper), (Some(lower), Some(upper)) if lower > upper);
    if !is_crossed || format != ExchangeFormat::Mps {
        return vec![row];
    }
    remarks.push(format!("{}: its bounds, which leave no value, are those of two rows", escaped(name)));
    let lower = (name.clone(), *form, Bounds { upper: None, ..bounds.clone() });
    let upper = (format!("{name}_upper"), *form, Bounds { lower: None, ..bounds.clone() });
    vec![lower, upper]
}

/// The place of the coefficients of a row.
#[derive(Clone, Copy)]
enum Form<'a> {
    Objective,
    Row(&'a [(usize, Rational)]),
    /// A column alone.
    Column(usize),
}

/// Names that the format allows, each once: those that it does not allow, or that were there before, become others.
fn legal(names: Vec<String>, format: ExchangeFormat, what: &str, remarks: &mut Vec<String>) -> Vec<String> {
    let is_legal = match format {
        ExchangeFormat::Mps => is_legal_in_mps,
        ExchangeFormat::Lp => is_legal_in_lp,
    };
    let mut used: HashSet<String> = HashSet::new();
    let kept: Vec<bool> = names.iter().map(|name| is_legal(name) && used.insert(name.clone())).collect();
    let mut renamed = |(place, (name, is_kept)): (usize, (String, bool))| {
        if is_kept {
            return name;
        }
        // Nameless objectives are called as CPLEX calls them.
        let is_nameless_objective = place == 0 && what == "row" && name.is_empty();
        let mut other = if is_nameless_objective { "obj".to_owned() } else { format!("{what}{}", place + 1) };
        while !used.insert(other.clone()) {
            other.push('_');
        }
        if !is_nameless_objective {
            remarks.push(format!("{other} is the {what} \"{}\"", escaped(&name)));
        }
        other
    };
    names.into_iter().zip(kept).enumerate().map(&mut renamed).collect()
}

fn is_legal_in_mps(name: &str) -> bool {
    let is_odd = |character: char| character.is_whitespace() || character.is_control();
    !name.is_empty() && !name.contains(is_odd) && !name.starts_with('$') && !name.contains("'MARKER'")
}

/// CPLEX reads names that begin like an exponent as such.
fn is_legal_in_lp(name: &str) -> bool {
    let is_odd =
        |character: char| character.is_whitespace() || character.is_control() || ends_name(character);
    let is_bad_start = |character: char| character.is_ascii_digit() || "./[]".contains(character);
    let is_exponent = |name: &str| {
        let rest = name.strip_prefix(['e', 'E']);
        rest.is_some_and(|rest| {
            rest.is_empty() || rest.starts_with(|next: char| next.is_ascii_digit() || "eE".contains(next))
        })
    };
    !name.is_empty()
        && !name.contains(is_odd)
        && !name.starts_with(is_bad_start)
        && !is_exponent(name)
        && !is_keyword(name)
}
