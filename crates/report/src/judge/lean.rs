//! An exact answer as theorems of Lean 4.

use std::fmt::Write;

use boundfit_exact::{Foreign, Rational};
use boundfit_judge::{Answer, Item, Side};
use boundfit_lp::{Bounds, End, Model, ObjectiveSense};

use super::priced;

/// The answer to the model of a file of this name as a file for Lean 4 with Mathlib: that no feasible point is better than
/// the optimum, and that one attains it; that the rows and bounds contradict each other; or that the objective improves for ever
/// along a ray. Every multiplier is given, so that `linarith` has only to add up. Cost: linear in the size of the model.
pub fn lean_theorems(model: &Model, answer: &Answer, name: Foreign<&str>) -> String {
    let lean = Lean { model };
    let mut text = lean.preamble(name);
    match answer {
        Answer::Optimal { value, face, prices, .. } => {
            let terms = priced(model, &prices.rows, &prices.columns);
            let terms: Vec<_> = terms.map(|(side, price)| (side, price.abs())).collect();
            text += &lean.bound(value, &terms);
            let point = face.vertices.iter().chain(&face.points).next();
            text += &lean.attained(value, point.map_or(&[], Vec::as_slice));
        }
        Answer::Infeasible { multipliers } => {
            let terms: Vec<_> = multipliers.iter().map(|term| (term.side, term.value.clone())).collect();
            text += &lean.contradiction(&terms);
        }
        Answer::Unbounded { point, ray } => text += &lean.unbounded(point, ray),
    }
    text
}

struct Lean<'a> {
    model: &'a Model,
}

/// A bound as a statement: a name, and what it says about given texts for the columns.
struct Statement {
    name: String,
    says: String,
}

impl Lean<'_> {
    /// What is imported, and which name stands for what.
    fn preamble(&self, file: Foreign<&str>) -> String {
        let mut text = "import Mathlib.Tactic\n\n".to_owned();
        // Writing to a String never fails.
        let _ =
            writeln!(text, "-- Written by boundfit from {file}: exact, with every multiplier of the proof.");
        let columns = self.model.columns.iter().map(|column| &column.name);
        let rows = self.model.rows.iter().map(|row| &row.name);
        for (letter, names) in [("x", columns.collect::<Vec<_>>()), ("r", rows.collect())] {
            for (number, name) in (1..).zip(names) {
                let what = if letter == "x" { "column" } else { "row" };
                let _ = writeln!(text, "-- {letter}{number}: {what} {name}");
            }
        }
        text
    }

    fn variables(&self) -> Vec<String> {
        (1..=self.model.columns.len()).map(|number| format!("x{number}")).collect()
    }

    /// `(x1 x2 : ℚ)`, or nothing without columns.
    fn binder(&self) -> String {
        let names = self.variables().join(" ");
        if names.is_empty() { names } else { format!(" ({names} : ℚ)") }
    }

    /// All rows and bounds about these texts in place of the columns.
    fn statements(&self, columns: &[String]) -> Vec<Statement> {
        let mut all = Vec::new();
        let mut push = |name: String, form: &str, bounds: &Bounds| {
            if let Some(lower) = &bounds.lower {
                all.push(Statement {
                    name: format!("{name}_lower"),
                    says: format!("({lower} : ℚ) ≤ {form}"),
                });
            }
            if let Some(upper) = &bounds.upper {
                all.push(Statement {
                    name: format!("{name}_upper"),
                    says: format!("{form} ≤ ({upper} : ℚ)"),
                });
            }
        };
        for (number, row) in (1..).zip(&self.model.rows) {
            let terms = row.coefficients.iter().map(|(column, value)| (value, columns.get(*column)));
            push(format!("r{number}"), &sum(terms, &Rational::zero()), &row.bounds);
        }
        for ((number, column), text) in (1..).zip(&self.model.columns).zip(columns) {
            push(format!("x{number}"), text, &column.bounds);
        }
        all
    }

    fn objective(&self, columns: &[String]) -> String {
        let costs = self.model.columns.iter().map(|column| &column.cost);
        sum(costs.zip(columns).map(|(cost, text)| (cost, Some(text))), &self.model.constant)
    }

    /// The hypotheses of a theorem, a line each.
    fn hypotheses(&self) -> String {
        let line = |Statement { name, says }: Statement| format!("\n    ({name} : {says})");
        self.statements(&self.variables()).into_iter().map(line).collect()
    }

    /// The step that adds up multiplied hypotheses.
    fn added_up(&self, terms: &[(Side, Rational)]) -> String {
        if terms.is_empty() {
            return "norm_num".to_owned();
        }
        let term = |(Side { item, end }, value): &(Side, Rational)| {
            let name = match item {
                Item::Row(row) => format!("r{}", row + 1),
                Item::Column(column) => format!("x{}", column + 1),
            };
            let end = if *end == End::Lower { "lower" } else { "upper" };
            format!("mul_le_mul_of_nonneg_left {name}_{end} (by norm_num : (0 : ℚ) ≤ {value})")
        };
        let terms: Vec<String> = terms.iter().map(term).collect();
        format!("linarith only [\n    {}]", terms.join(",\n    "))
    }

    fn bound(&self, value: &Rational, terms: &[(Side, Rational)]) -> String {
        let objective = self.objective(&self.variables());
        let (words, goal) = match self.model.sense {
            ObjectiveSense::Minimize => ("less", format!("({value} : ℚ) ≤ {objective}")),
            ObjectiveSense::Maximize => ("more", format!("{objective} ≤ ({value} : ℚ)")),
        };
        let (binder, hypotheses, step) = (self.binder(), self.hypotheses(), self.added_up(terms));
        format!(
            "\n/-- Where all rows and bounds hold, the objective is not {words} than {value}. -/\n\
             theorem optimum_bound{binder}{hypotheses} :\n    {goal} := by\n  {step}\n"
        )
    }

    fn attained(&self, value: &Rational, point: &[Rational]) -> String {
        let variables = self.variables();
        let mut says: Vec<String> = self.statements(&variables).into_iter().map(|own| own.says).collect();
        says.push(format!("{} = ({value} : ℚ)", self.objective(&variables)));
        let says = says.join(" ∧\n    ");
        let (exists, proof) = if variables.is_empty() {
            (String::new(), "by\n  norm_num".to_owned())
        } else {
            let values: Vec<String> = point.iter().map(ToString::to_string).collect();
            (format!("∃ {} : ℚ,\n    ", variables.join(" ")), format!("⟨{}, by norm_num⟩", values.join(", ")))
        };
        format!(
            "\n/-- Some point fulfils all rows and bounds, and there the objective is {value}. -/\n\
             theorem optimum_attained :\n    {exists}{says} :=\n  {proof}\n"
        )
    }

    fn contradiction(&self, terms: &[(Side, Rational)]) -> String {
        let (binder, hypotheses, step) = (self.binder(), self.hypotheses(), self.added_up(terms));
        format!(
            "\n/-- No point fulfils all rows and bounds. -/\ntheorem infeasible{binder}{hypotheses} :\n    False := by\n  {step}\n"
        )
    }

    fn unbounded(&self, point: &[Rational], ray: &[Rational]) -> String {
        let places: Vec<String> = point.iter().zip(ray).map(|(p, r)| format!("({p} + {r} * t)")).collect();
        let mut says: Vec<String> = self.statements(&places).into_iter().map(|own| own.says).collect();
        let costs = || self.model.columns.iter().map(|column| &column.cost);
        let start: Rational = costs().zip(point).map(|(cost, entry)| cost * entry).sum();
        let change: Rational = costs().zip(ray).map(|(cost, entry)| cost * entry).sum();
        let start = start + &self.model.constant;
        says.push(format!("{} = {start} + {change} * t", self.objective(&places)));
        let steps: Vec<&str> = says.iter().map(|_| "by linarith only [ht]").collect();
        let steps = if says.len() == 1 { steps.concat() } else { format!("⟨{}⟩", steps.join(", ")) };
        format!(
            "\n/-- From a feasible point along a ray all rows and bounds hold, and each step adds {change} to the objective. -/\n\
             theorem unbounded (t : ℚ) (ht : 0 ≤ t) :\n    {} :=\n  {steps}\n",
            says.join(" ∧\n    ")
        )
    }
}

/// `2 * x1 - x2 + 1/2`, without terms that are 0; `(0 : ℚ)` if nothing is left.
fn sum<'a>(terms: impl Iterator<Item = (&'a Rational, Option<&'a String>)>, constant: &Rational) -> String {
    let mut text = String::new();
    let terms = terms.filter_map(|(value, name)| Some((value, Some(name?))));
    for (value, name) in terms.chain([(constant, None)]).filter(|(value, _)| !value.is_zero()) {
        let sign = match (text.is_empty(), value.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = value.abs();
        let _ = match name {
            Some(name) if size == Rational::one() => write!(text, "{sign}{name}"),
            Some(name) => write!(text, "{sign}{size} * {name}"),
            None => write!(text, "{sign}{size}"),
        };
    }
    match text.is_empty() {
        true => "(0 : ℚ)".to_owned(),
        false => text,
    }
}
