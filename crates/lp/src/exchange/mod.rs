//! Linear programs as files that other solvers read. Every number is exact.
//!
//! Sources: the MPS format as in the HiGHS, GLPK and CPLEX manuals (free form, the parts that all of them read: no
//! OBJSENSE, no RANGES, no negative right-hand side of the objective); the LP format as in "CPLEX file formats" (IBM).

mod lp_format;
mod mps;
mod number;

use boundfit_exact::{Integer, Rational};

use crate::program::Row;
use number::finite_decimal;

/// A format of linear programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExchangeFormat {
    /// Free MPS.
    Mps,
    /// CPLEX's LP format.
    Lp,
}

impl ExchangeFormat {
    /// Both of them.
    pub const ALL: [ExchangeFormat; 2] = [ExchangeFormat::Mps, ExchangeFormat::Lp];

    /// The name on the command line, and the end of a file's name: `mps` or `lp`.
    pub fn name(self) -> &'static str {
        match self {
            ExchangeFormat::Mps => "mps",
            ExchangeFormat::Lp => "lp",
        }
    }

    /// What the name stands for.
    pub fn title(self) -> &'static str {
        match self {
            ExchangeFormat::Mps => "Free-format MPS",
            ExchangeFormat::Lp => "CPLEX LP format",
        }
    }
}

/// How a row `a·θ ≤ b` is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// As `a·θ ≤ b`.
    AtMost,
    /// As `-a·θ ≥ -b`.
    AtLeast,
    /// As `a·θ = b`, where the opposite row belongs to the program as well.
    Equal,
}

/// A row as it stands in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExchangeRow {
    name: String,
    sense: Sense,
    numbers: Numbers,
}

/// The exact numbers of a row.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Numbers {
    /// The coefficients of θ1 and θ2.
    a: [String; 2],
    /// The right-hand side.
    b: String,
    /// What all of them were multiplied with, where not all are finite decimals.
    scale: Option<Integer>,
    /// Whether all of them are representable in binary64 at least roughly: none overflows or becomes 0.
    is_in_range: bool,
}

impl Numbers {
    /// The decimals of three numbers; where one has none, three whole numbers in their ratio.
    fn new(a: &[Rational; 2], b: &Rational) -> Self {
        let [a1, a2] = a;
        let in_range = |value: &Rational| {
            let double = value.to_f64();
            double.is_finite() && (double != 0.0 || value.is_zero())
        };
        if let (Some(first), Some(second), Some(right)) =
            (finite_decimal(a1), finite_decimal(a2), finite_decimal(b))
        {
            let is_in_range = [a1, a2, b].into_iter().all(in_range);
            return Numbers { a: [first, second], b: right, scale: None, is_in_range };
        }
        let ([first, second, right], scale) = Rational::over_common_denominator([a1, a2, b]);
        let is_in_range = [&first, &second, &right].into_iter().all(|value| in_range(&Rational::from(value)));
        let a = [first.to_string(), second.to_string()];
        Numbers { a, b: right.to_string(), scale: Some(scale), is_in_range }
    }

    fn longest(&self) -> usize {
        self.a.iter().chain([&self.b]).map(String::len).max().unwrap_or_default()
    }
}

impl ExchangeRow {
    /// A row under a name of letters, digits and `_`. Its numbers become decimals where all of them are finite; else the
    /// row is multiplied with the least number that makes them whole.
    pub fn new(name: String, row: &Row, sense: Sense) -> Self {
        let numbers = match sense {
            Sense::AtMost | Sense::Equal => Numbers::new(&row.a, &row.b),
            Sense::AtLeast => Numbers::new(&row.a.each_ref().map(|a| -a), &-&row.b),
        };
        ExchangeRow { name, sense, numbers }
    }
}

/// A program `min objective·θ` with free variables `theta1` and `theta2`, ready to be written.
#[derive(Debug, Clone)]
pub struct ExchangeProgram<'a> {
    /// The name of the program.
    pub name: &'a str,
    /// The name of the objective, of letters, digits and `_`.
    pub objective_name: &'a str,
    /// The form to be minimised.
    pub objective: [Rational; 2],
    /// The rows.
    pub rows: &'a [ExchangeRow],
    /// What is said about it at the top. Characters other than printable ASCII are escaped.
    pub comments: &'a [String],
}

impl ExchangeProgram<'_> {
    /// The file. Exact: whoever reads its decimals as such has the same program, up to the scale of rows that it names
    /// in comments. Cost: linear in the result.
    pub fn text(&self, format: ExchangeFormat) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = match format {
            ExchangeFormat::Mps => mps::write(&mut text, self),
            ExchangeFormat::Lp => lp_format::write(&mut text, self),
        };
        text
    }

    fn objective(&self) -> Numbers {
        Numbers::new(&self.objective, &Rational::zero())
    }

    /// The lines at the top: what the caller says, and what a reader has to know about the numbers.
    fn remarks(&self) -> Vec<String> {
        /// The longest that GLPK reads.
        const LONGEST_NUMBER: usize = 255;
        let escaped =
            |line: &String| line.escape_default().to_string().replace("\\'", "'").replace("\\\"", "\"");
        let mut remarks: Vec<String> = self.comments.iter().map(escaped).collect();
        let objective = self.objective();
        let named = self.rows.iter().map(|row| (row.name.as_str(), &row.numbers));
        for (name, numbers) in std::iter::once((self.objective_name, &objective)).chain(named) {
            if let Some(scale) = &numbers.scale {
                remarks.push(format!("{name} is multiplied by {scale}: its numbers have no finite decimals"));
            }
            if numbers.longest() > LONGEST_NUMBER {
                remarks.push(format!(
                    "{name} has a number of {} characters; GLPK reads at most {LONGEST_NUMBER}",
                    numbers.longest()
                ));
            }
            if !numbers.is_in_range {
                remarks.push(format!("{name} has a number that is beyond the range of doubles"));
            }
        }
        remarks
    }
}
