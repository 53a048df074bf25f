//! The file of a theorem, as far as its rows and what it says of them.

use boundfit_exact::{Limits, Rational, Reading};

use super::sentences::{code, refuse_new_meanings};
use super::theory::refuse_another_theory;
use super::{Bounds, Stated, Theorem};
use crate::shape::{NotAProof, beginning};

/// The line of the head that has the question.
const QUESTION: &str = "   The question: ";
pub(super) const ROWS: &str = "Definition rows : list row := read ";
const DATA: &str = "\nDefinition data : list text := [\"";
const CONDITIONS: &str = "(* Conditions: a, b, and the bounds of a*theta1 + b*theta2, as far as there are any. *)\n\
                          Definition conditions : list form := map form_of (read ";
const SAYS: &str = "(* What the rows say of p = (theta1, theta2). *)\nDefinition feasible (p : Q * Q) :=\n  ";

/// The question in the head, as JSON.
pub(super) fn question(text: &str) -> Result<&str, NotAProof> {
    let (head, _) =
        text.split_once("*)").ok_or_else(|| NotAProof::new("the comment at its head does not end"))?;
    head.lines().find_map(|line| line.strip_prefix(QUESTION)).ok_or_else(|| {
        NotAProof::new(
            "the comment at the head of this theorem has no line \"The question: {...}\", which says how its rows were read from \
             delimited text (theorems about other data have none)",
        )
    })
}

/// The bytes of the data, if the theorem holds them.
pub(super) fn data(text: &str) -> Result<Option<String>, NotAProof> {
    let mut parts = text.split(DATA).skip(1);
    let (data, more) = (parts.next(), parts.next());
    if let Some(more) = more {
        return Err(unexpected(text, more, "the data once"));
    }
    let Some(own) = data else { return Ok(None) };
    match own.split_once("\"]%text.\n") {
        Some((data, _)) => Ok(Some(data.replace("\";\n\"", ""))),
        None => Err(unexpected(text, own, "data that end with \"]%text.")),
    }
}

/// The rows, and what the theorem says of them.
pub(super) fn theorem(text: &str) -> Result<Theorem, NotAProof> {
    for once in ["Definition rows ", "Definition feasible (p : Q * Q)"] {
        let count = text.matches(once).count();
        if count != 1 {
            return Err(NotAProof::new(format_args!("\"{once}\" is there {count} times (expected once)")));
        }
    }
    let (before, rest) = text
        .split_once(ROWS)
        .ok_or_else(|| NotAProof::new(format_args!("no \"{ROWS}\", behind which the rows stand")))?;
    if code(before).is_none() {
        return Err(NotAProof::new("the rows stand in a comment"));
    }
    refuse_another_theory(before)?;
    let from_rows = rest;
    let (rows, rest) = lines(text, rest)?;
    let rest = stripped(text, rest, ".\n")?;
    let (definitions, mut rest) = rest
        .split_once("\n\n")
        .ok_or_else(|| unexpected(text, rest, "definitions of columns, and a blank line behind them"))?;
    let columns = definitions.lines().map(|line| {
        Column::read(line)
            .ok_or_else(|| unexpected(text, line, "\"Definition NAME (r : row) : Q := number N r.\""))
    });
    let columns: Vec<Column> = columns.collect::<Result<_, _>>()?;
    let mut conditions = None;
    if let Some(own) = rest.strip_prefix(CONDITIONS) {
        let (found, after) = lines(text, own)?;
        rest = stripped(text, after, ").\n\n")?;
        conditions = Some(found);
    }
    let said = rest.strip_prefix(SAYS).and_then(|rest| rest.split_once(".\n"));
    let (says, behind) =
        said.ok_or_else(|| unexpected(text, rest, "what the rows say of p, as boundfit writes it"))?;
    let definitions = from_rows.strip_suffix(behind).unwrap_or(from_rows);
    refuse_new_meanings(&[ROWS, definitions].concat(), behind)?;
    let shape = Shape::of(&columns, conditions.is_some(), says).ok_or_else(|| {
        unexpected(text, says, "what the rows say of p, as boundfit writes it of columns like these")
    })?;
    let row = |row: &&str| {
        let names = shape.names();
        shape.row(row).ok_or_else(|| unexpected(text, row, &format!("a row of the numbers {names}")))
    };
    let condition = |row: &&str| {
        let numbers: Option<[_; 4]> = cells(row).and_then(|own| own.try_into().ok());
        numbers
            .ok_or_else(|| unexpected(text, row, "the numbers a and b, and two bounds that may be missing"))
    };
    Ok(Theorem {
        rows: rows.iter().map(row).collect::<Result<_, _>>()?,
        conditions: conditions.iter().flatten().map(condition).collect::<Result<_, _>>()?,
    })
}

/// The problem with a part of a text that is not what is expected there: its line, and how it begins.
fn unexpected(text: &str, part: &str, expected: &str) -> NotAProof {
    let place = part.as_ptr().addr().saturating_sub(text.as_ptr().addr());
    let line = 1 + text.get(..place).unwrap_or_default().matches('\n').count();
    let start = beginning(part.lines().next().unwrap_or_default());
    NotAProof::new(format_args!("line {line}: {start:?} (expected {expected})"))
}

/// The rest of a text behind this.
fn stripped<'a>(text: &str, rest: &'a str, expected: &str) -> Result<&'a str, NotAProof> {
    rest.strip_prefix(expected).ok_or_else(|| unexpected(text, rest, &format!("{expected:?}")))
}

/// The lines of pieces of text, and what follows the pieces.
fn lines<'a>(text: &str, rest: &'a str) -> Result<(Vec<&'a str>, &'a str), NotAProof> {
    let inside = stripped(text, rest, "[\"")?;
    let (pieces, rest) = inside
        .split_once("\"]%text")
        .ok_or_else(|| unexpected(text, inside, "rows that end with \"]%text"))?;
    let mut lines = Vec::new();
    for piece in pieces.split("\";\n\"").filter(|piece| !piece.is_empty()) {
        let whole = piece.strip_suffix('\n').ok_or_else(|| {
            unexpected(text, piece.lines().last().unwrap_or_default(), "a row that ends with its line")
        })?;
        lines.extend(whole.split('\n'));
    }
    Ok((lines, rest))
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
    fn of(columns: &[Column], has_conditions: bool, says: &str) -> Option<Self> {
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
        (says == expected).then_some(Shape { cells, epsilon })
    }

    /// The names of the cells of a row.
    fn names(&self) -> String {
        let in_rows = self.cells.iter().filter(|name| !name.ends_with('='));
        in_rows.map(|name| name.trim_end_matches('?')).collect::<Vec<_>>().join(", ")
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
