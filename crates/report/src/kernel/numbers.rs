//! Numbers as the theory reads them from text, and as literals of Coq.

use boundfit_exact::{Integer, Rational};

/// Digits behind the point beyond which a number is written as a fraction.
const MOST_DECIMALS: u32 = 30;

/// Bytes of text in one literal; Coq's own recursion ends where one literal is much longer.
const PIECE: usize = 2000;

/// The fewest digits behind the point that write a number; `None` if it is no decimal, or a very long one.
fn decimals(value: &Rational) -> Option<u32> {
    let denominator = value.denominator();
    (0..=MOST_DECIMALS).find(|&digits| Integer::power_of_ten(digits).div_rem_floor(&denominator).1.is_zero())
}

/// A number with so many digits behind the point.
fn fixed(value: &Rational, digits: u32) -> String {
    let units = value.numerator() * Integer::power_of_ten(digits).quotient(&value.denominator());
    let (sign, mut text) = (if units.is_negative() { "-" } else { "" }, units.abs().to_string());
    let digits = digits as usize;
    if digits > 0 {
        let missing = (digits + 1).saturating_sub(text.len());
        text.insert_str(0, &"0".repeat(missing));
        text.insert(text.len() - digits, '.');
    }
    format!("{sign}{text}")
}

/// Returns a column of numbers, some of which may be missing. Decimals have one number of digits if all numbers are
/// decimals, so that the checker has one denominator; otherwise numbers are fractions.
pub(super) fn column(values: &[Option<Rational>]) -> Vec<String> {
    let needed: Option<Vec<u32>> = values.iter().flatten().map(decimals).collect();
    let digits = needed.map(|needed| needed.into_iter().max().unwrap_or(0));
    let text = |value: &Option<Rational>| match (value, digits) {
        (None, _) => String::new(),
        (Some(value), Some(digits)) => fixed(value, digits),
        (Some(value), None) => value.to_string(),
    };
    values.iter().map(text).collect()
}

/// A fraction of Coq's `Q`.
pub(super) fn literal(value: &Rational) -> String {
    format!("({} # {})", value.numerator(), value.denominator())
}

/// Rows of cells as a list of literals, each of which ends with the end of a line.
pub(super) fn pieces(rows: impl IntoIterator<Item = String>) -> String {
    let mut pieces = vec![String::new()];
    for row in rows {
        if pieces.last().is_some_and(|last| !last.is_empty() && last.len() + row.len() > PIECE) {
            pieces.push(String::new());
        }
        if let Some(last) = pieces.last_mut() {
            last.push_str(&row);
            last.push('\n');
        }
    }
    quoted(&pieces)
}

/// Text as a list of literals, which end with the end of a line where they can.
pub(super) fn literals(mut text: &str) -> String {
    let mut pieces = Vec::new();
    while text.len() > PIECE {
        let most = (0..=PIECE).rev().find(|&end| text.is_char_boundary(end)).unwrap_or_default();
        let (head, _) = text.split_at(most);
        let (piece, rest) = text.split_at(head.rfind('\n').map_or(most, |end| end + 1));
        pieces.push(piece);
        text = rest;
    }
    pieces.push(text);
    quoted(&pieces)
}

/// The lines in the literals of [`pieces`].
pub(super) fn read_literals(text: &str) -> Option<Vec<String>> {
    let pieces = text.strip_prefix("[\"")?.strip_suffix("\"]%text")?;
    Some(pieces.replace("\";\n\"", "").lines().map(ToOwned::to_owned).collect())
}

fn quoted<S: AsRef<str>>(pieces: &[S]) -> String {
    let pieces: Vec<&str> = pieces.iter().map(AsRef::as_ref).collect();
    format!("[\"{}\"]%text", pieces.join("\";\n\""))
}
