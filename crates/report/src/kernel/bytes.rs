//! The bytes of plain delimited text in the file of a theorem, and the theorem that the rows are read from them. The reader is
//! `kernel/Bytes.v`; here is what it reads, so that nothing is written that it refuses.

use boundfit_exact::{Limits, Rational, Reading};

use super::numbers::{literals, read_literals};
use crate::proof_question::ProofQuestion;

/// The most bytes of data that a theorem holds. Coq reads them in about a second.
pub const MOST_THEOREM_BYTES: usize = 100_000;

/// The most ranges of rows that the reader chooses from.
const MOST_RANGES: usize = 20;

/// The most digits of an exponent.
const MOST_EXPONENT_DIGITS: usize = 3;

/// Returns the definition of the data and the theorem that `rows`, the literals of a statement, are read from them. `None` where
/// the reader of the theory reads something else.
pub(super) fn the_bytes(question: &ProofQuestion, rows: &str, data: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(data).ok()?;
    let stated: Vec<Vec<Option<Rational>>> =
        read_literals(rows)?.iter().map(|row| row.split(',').map(cell).collect()).collect::<Option<_>>()?;
    let (delimiter, name) = delimiter(question.delimiter())?;
    let ranges = question.ranges();
    let mut columns = question.columns()?;
    // An error bound that is the same in all rows is none of their cells.
    let width = stated.first()?.len();
    columns.truncate(width);
    let lines = lines(text, question.delimiter())?;
    let lines = lines.get(usize::from(question.has_header())..)?;
    let is_chosen = |number: usize| ranges.iter().any(|[from, to]| (*from..=*to).contains(&number));
    let chosen = lines.iter().enumerate().filter(|(index, _)| is_chosen(index + 1));
    let picked: Option<Vec<Vec<Option<Rational>>>> = chosen
        .map(|(_, line)| {
            let pick = |&column: &usize| match column.checked_sub(1) {
                None => Some(None),
                Some(index) => cell(line.get(index)?),
            };
            columns.iter().map(pick).collect()
        })
        .collect();
    if data.len() > MOST_THEOREM_BYTES || ranges.len() > MOST_RANGES || picked? != stated {
        return None;
    }
    let ranges: Vec<String> = ranges.iter().map(|[from, to]| format!("({from}, {to})")).collect();
    let columns: Vec<String> = columns.iter().map(ToString::to_string).collect();
    Some(format!(
        "(* The bytes of the data. *)\n\
         Definition data : list text := {}.\n\n\
         (* Lines of cells between {name}s{}; the lines of these ranges, of each the cells of these columns. *)\n\
         Theorem the_rows_are_the_bytes :\n  same_rows (rows_of Byte.{delimiter} {} [{}]%Z [{}]%nat data) rows.\n\
         Proof. apply same_rows_of. vm_cast_no_check (eq_refl true). Qed.\n\
         Print Assumptions the_rows_are_the_bytes.\n\n",
        literals(text),
        if question.has_header() { " behind a header line" } else { "" },
        question.has_header(),
        ranges.join("; "),
        columns.join("; "),
    ))
}

/// The byte of a delimiter in Coq, and its name; `None` if the reader does not know it.
fn delimiter(own: char) -> Option<(&'static str, &'static str)> {
    match own {
        ',' => Some(("x2c", "comma")),
        ';' => Some(("x3b", "semicolon")),
        '\t' => Some(("x09", "tabulator")),
        '|' => Some(("x7c", "bar")),
        _ => None,
    }
}

/// The cells of the lines; `None` for text with quotes. Lines without a byte do not count.
fn lines(text: &str, delimiter: char) -> Option<Vec<Vec<&str>>> {
    if text.contains('"') {
        return None;
    }
    let ends = text.split_inclusive('\n');
    let line = |own: &'_ str| match own.strip_suffix('\n') {
        Some(line) => line.strip_suffix('\r').unwrap_or(line).len(),
        None => own.len(),
    };
    let lines = ends.map(|own| own.get(..line(own)).unwrap_or_default()).filter(|own| !own.is_empty());
    Some(lines.map(|own| own.split(delimiter).collect()).collect())
}

/// Reads a cell: nothing, or a number. `None` if it is no number to the reader.
fn cell(text: &str) -> Option<Option<Rational>> {
    if text.is_empty() {
        return Some(None);
    }
    is_plain_number(text).then(|| Reading::Decimal.read(text, &Limits::default()).ok()).flatten().map(Some)
}

/// Returns true for digits with a sign, a point and an exponent, or a fraction of two whole numbers.
fn is_plain_number(text: &str) -> bool {
    let is_digits = |own: &str| own.bytes().all(|byte| byte.is_ascii_digit());
    let text = text.strip_prefix(['+', '-']).unwrap_or(text);
    if let Some((above, below)) = text.split_once('/') {
        return !above.is_empty() && !below.is_empty() && is_digits(above) && is_digits(below);
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    is_digits(whole)
        && is_digits(part)
        && whole.len() + part.len() > 0
        && is_digits(exponent)
        && (1..=MOST_EXPONENT_DIGITS).contains(&exponent.len())
}
