//! The file of a theorem, as far as its rows and what it says of them.

use boundfit_exact::{Limits, Rational, Reading};

use super::sentences::{code, refuse_new_meanings};
use super::{Bounds, Stated, Theorem};
use crate::shape::NotAProof;

/// The line of the head that has the question.
const QUESTION: &str = "   The question: ";
const ROWS: &str = "Definition rows : list row := read ";
const CONDITIONS: &str = "(* Conditions: a, b, and the bounds of a*theta1 + b*theta2, as far as there are any. *)\n\
                          Definition conditions : list form := map form_of (read ";
const SAYS: &str = "(* What the rows say of p = (theta1, theta2). *)\nDefinition feasible (p : Q * Q) :=\n  ";

/// The question in the head, as JSON.
pub(super) fn question(text: &str) -> Result<&str, NotAProof> {
    let head = text.split_once("*)").map_or("", |(head, _)| head);
    head.lines().find_map(|line| line.strip_prefix(QUESTION)).ok_or_else(|| {
        NotAProof::new("the head of this theorem does not say how its rows were read from data")
    })
}

/// The bytes of the data, if the theorem holds them.
pub(super) fn data(text: &str) -> Result<Option<String>, NotAProof> {
    let mut parts = text.split("\nDefinition data : list text := [\"").skip(1);
    let (data, more) = (parts.next(), parts.next());
    match data.map(|own| own.split_once("\"]%text.\n")) {
        None => Ok(None),
        Some(Some((data, _))) if more.is_none() => Ok(Some(data.replace("\";\n\"", ""))),
        Some(_) => Err(other("the data")),
    }
}

/// The rows, and what the theorem says of them.
pub(super) fn theorem(text: &str) -> Result<Theorem, NotAProof> {
    for once in ["Definition rows ", "Definition feasible (p : Q * Q)"] {
        if text.matches(once).count() != 1 {
            return Err(NotAProof::new(format_args!("\"{once}\" is not there once")));
        }
    }
    let (before, rest) = text.split_once(ROWS).ok_or_else(|| other("the rows"))?;
    if code(before).is_none() {
        return Err(NotAProof::new("the rows stand in a comment"));
    }
    let from_rows = rest;
    let (rows, rest) = lines(rest).ok_or_else(|| other("the rows"))?;
    let rest = rest.strip_prefix(".\n").ok_or_else(|| other("the rows"))?;
    let (definitions, mut rest) = rest.split_once("\n\n").ok_or_else(|| other("the columns"))?;
    let columns: Option<Vec<Column>> = definitions.lines().map(Column::read).collect();
    let columns = columns.ok_or_else(|| other("the columns"))?;
    let mut conditions = None;
    if let Some(own) = rest.strip_prefix(CONDITIONS) {
        let (found, after) = lines(own).ok_or_else(|| other("the conditions"))?;
        rest = after.strip_prefix(").\n\n").ok_or_else(|| other("the conditions"))?;
        conditions = Some(found);
    }
    let said = rest.strip_prefix(SAYS).and_then(|rest| rest.split_once(".\n"));
    if let Some((_, behind)) = said {
        let definitions = from_rows.strip_suffix(behind).unwrap_or(from_rows);
        refuse_new_meanings(&[ROWS, definitions].concat(), behind)?;
    }
    let says = said.map(|(says, _)| says);
    let shape = Shape::of(&columns, conditions.is_some(), says).ok_or_else(|| other("what the rows say"))?;
    let rows = rows.iter().map(|row| shape.row(row).ok_or_else(|| NotAProof::new("a row with other cells")));
    let condition = |row: &&str| cells(row)?.try_into().ok();
    let conditions: Option<Vec<_>> = conditions.iter().flatten().map(condition).collect();
    Ok(Theorem {
        rows: rows.collect::<Result<_, _>>()?,
        conditions: conditions.ok_or_else(|| other("the conditions"))?,
    })
}

fn other(what: &str) -> NotAProof {
    NotAProof::new(format_args!("{what} of this theorem are not written as boundfit writes them"))
}

/// The lines of pieces of text, and what follows the pieces.
fn lines(text: &str) -> Option<(Vec<&str>, &str)> {
    let (pieces, rest) = text.strip_prefix("[\"")?.split_once("\"]%text")?;
    let mut lines = Vec::new();
    for piece in pieces.split("\";\n\"") {
        if !piece.is_empty() {
            lines.extend(piece.strip_suffix('\n')?.split('\n'));
        }
    }
    Some((lines, rest))
}

/// The cells of a line, of which some are empty.
fn cells(line: &str) -> Option<Vec<Option<Rational>>> {
    line.split(',').map(|cell| if cell.is_empty() { Some(None) } else { number(cell).map(Some) }).collect()
}

/// A number that Coq reads as the same one: digits, and a point or a slash.
fn number(text: &str) -> Option<Rational> {
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'.' | b'/'));
    let is_one = !(text.contains('.') && text.contains('/'));
    let limits = Limits { digits: text.len(), exponent: 0 };
    Reading::Decimal.read(text, &limits).ok().filter(|_| is_plain && is_one)
}

/// The definition of a column.
struct Column<'a> {
    name: &'a str,
    from: From,
}

enum From {
    /// A number of the row.
    Number(usize),
    /// A number that may be missing.
    Entry(usize),
    /// The same in all rows.
    Constant(Rational),
}

impl<'a> Column<'a> {
    fn read(line: &'a str) -> Option<Self> {
        let (name, body) = line.strip_prefix("Definition ")?.split_once(" (r : row) : ")?;
        let place = |text: &str| text.strip_suffix(" r.")?.parse().ok();
        let from = if let Some(own) = body.strip_prefix("Q := number ") {
            From::Number(place(own)?)
        } else if let Some(own) = body.strip_prefix("option Q := entry ") {
            From::Entry(place(own)?)
        } else {
            let own = body.strip_prefix("Q := (")?.strip_suffix(").")?;
            From::Constant(number(&own.replace(" # ", "/"))?)
        };
        Some(Column { name, from })
    }
}

/// The meaning of the cells of a row.
struct Shape {
    /// The names of the cells.
    cells: &'static [&'static str],
    /// The error bound of all rows.
    epsilon: Option<Rational>,
}

/// Names of columns, of which a `?` marks those that may be missing and a `=` those that are constant; what a theorem says.
const SHAPES: [(&[&str], &str); 7] = [
    (&["x", "y", "eps="], "Qabs (y r - (fst p * x r + snd p)) <= eps r"),
    (&["x", "y", "eps"], "Qabs (y r - (fst p * x r + snd p)) <= eps r"),
    (&["x", "u", "y", "eps="], "Qabs (y r - (fst p * x r + snd p * u r)) <= eps r"),
    (&["x", "u", "y", "eps"], "Qabs (y r - (fst p * x r + snd p * u r)) <= eps r"),
    (
        &["x", "least?", "most?"],
        "at_least (least r) (fst p * x r + snd p) /\\ at_most (fst p * x r + snd p) (most r)",
    ),
    (
        &["x", "u", "least?", "most?"],
        "at_least (least r) (fst p * x r + snd p * u r) /\\ at_most (fst p * x r + snd p * u r) (most r)",
    ),
    (&["a", "b", "c"], "fst p * a r + snd p * b r <= c r"),
];

impl Shape {
    fn of(columns: &[Column], has_conditions: bool, says: Option<&str>) -> Option<Self> {
        let mut epsilon = None;
        let mut names = Vec::new();
        for (index, Column { name, from }) in columns.iter().enumerate() {
            let (mark, place) = match from {
                From::Number(place) => ("", *place),
                From::Entry(place) => ("?", *place),
                From::Constant(own) => {
                    epsilon = Some(own.clone());
                    ("=", index)
                }
            };
            if place != index {
                return None;
            }
            names.push(format!("{name}{mark}"));
        }
        let (cells, expected) = SHAPES.iter().find(|(own, _)| names == **own)?;
        let expected = format!("forall r, In r rows -> {expected}");
        let expected = match has_conditions {
            true => format!("({expected}) /\\ (forall c, In c conditions -> keeps c p)"),
            false => expected,
        };
        (says? == expected).then_some(Shape { cells, epsilon })
    }

    fn row(&self, line: &str) -> Option<Stated> {
        let found = cells(line)?;
        if found.len() + usize::from(self.epsilon.is_some()) != self.cells.len() {
            return None;
        }
        let at = |index: usize| found.get(index).cloned().flatten();
        let one = ("factor of theta2", Rational::one());
        Some(match *self.cells {
            ["x", "y", _] => Stated {
                phi: [("x", at(0)?), one],
                bounds: Bounds::Around([at(1)?, self.epsilon.clone().or_else(|| at(2))?]),
            },
            ["x", "u", "y", _] => Stated {
                phi: [("x", at(0)?), ("u", at(1)?)],
                bounds: Bounds::Around([at(2)?, self.epsilon.clone().or_else(|| at(3))?]),
            },
            ["x", _, _] => Stated {
                phi: [("x", at(0)?), one],
                bounds: Bounds::Between([("least", at(1)), ("most", at(2))]),
            },
            ["x", "u", _, _] => Stated {
                phi: [("x", at(0)?), ("u", at(1)?)],
                bounds: Bounds::Between([("least", at(2)), ("most", at(3))]),
            },
            _ => Stated {
                phi: [("a", at(0)?), ("b", at(1)?)],
                bounds: Bounds::Between([("lower bound", None), ("c", Some(at(2)?))]),
            },
        })
    }
}
