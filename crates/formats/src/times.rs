//! Dates, times and numbers with units, which are no numbers: what stands in such a cell is said, rather than which character is none
//! of a number.

use boundfit_exact::ParseNumberErrorKind;

use crate::error::InputErrorKind;

/// The problem with a cell, which is another one where the cell has a date or a time.
pub(crate) fn or_time(problem: InputErrorKind, cell: &[u8]) -> InputErrorKind {
    match problem {
        // Fractions that look like dates have an error of their own.
        InputErrorKind::NotANumber(error) if error.kind != ParseNumberErrorKind::Date && is_time(cell) => {
            InputErrorKind::Time
        }
        InputErrorKind::NotANumber(error) if !error.kind.is_limit() && has_unit(cell) => {
            InputErrorKind::UnitBehind
        }
        problem => problem,
    }
}

/// Returns whether a cell has a number and a unit: `10 V`, `1,05 mm/s`, `-3.2°C`. Letters of exponents and bases are none.
fn has_unit(cell: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(cell) else { return false };
    let text = text.trim();
    let is_of_number = |own: char| own.is_ascii_digit() || matches!(own, '.' | ',' | '+' | '-');
    let unit = text.trim_start_matches(is_of_number);
    let number = &text[..text.len() - unit.len()];
    let is_apart = unit.starts_with(' ');
    let unit = unit.trim_start();
    let starts_as_one = |first: char| first.is_alphabetic() || matches!(first, '°' | '%' | '‰');
    let is_other_number =
        !is_apart && unit.starts_with(['e', 'E', 'd', 'D', 'x', 'X', 'b', 'o', 'O']) && unit.len() < 3;
    number.bytes().any(|byte| byte.is_ascii_digit())
        && unit.starts_with(starts_as_one)
        && !unit.contains(|own: char| own.is_whitespace() || own.is_ascii_digit())
        && !is_other_number
}

/// Returns whether a cell looks like a date or a time: `2024-01-31T12:00`, `31.01.2024`, `12:30`, `31-Jan-24`, `2024Q1`.
pub(crate) fn is_time(cell: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(cell) else { return false };
    let text = text.trim();
    if text.len() > LONGEST || !text.bytes().any(|byte| byte.is_ascii_digit()) {
        return false;
    }
    let parts: Vec<&str> =
        text.split(|mark: char| " -/.:,T".contains(mark)).filter(|part| !part.is_empty()).collect();
    let is_digits = |part: &&str| part.bytes().all(|byte| byte.is_ascii_digit());
    let has_month = parts.len() > 1 && parts.iter().any(|part| is_month(part)) && parts.iter().any(is_digits);
    has_month || is_clock(text) || is_date(text) || is_quarter(text) || is_duration(text)
}

/// A text as long as this is neither.
const LONGEST: usize = 64;

/// Returns whether a word is the name of a month in English, or its first three letters.
fn is_month(word: &str) -> bool {
    const MONTHS: [&str; 12] = [
        "january",
        "february",
        "march",
        "april",
        "may",
        "june",
        "july",
        "august",
        "september",
        "october",
        "november",
        "december",
    ];
    let word = word.to_ascii_lowercase();
    MONTHS.iter().any(|month| *month == word || month.get(..3) == Some(&*word))
}

/// `00:10`, `12:30:05.5`, also behind a date.
fn is_clock(text: &str) -> bool {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let rest = text.get(digits..).unwrap_or_default();
    (1..=4).contains(&digits)
        && rest.strip_prefix(':').is_some_and(|rest| rest.starts_with(|next: char| next.is_ascii_digit()))
}

/// Three groups of digits with one mark between them, one of them a year; or a year and a month.
fn is_date(text: &str) -> bool {
    let end = text.find([' ', 'T', ',']).unwrap_or(text.len());
    let day = text.get(..end).unwrap_or_default();
    ['-', '.', '/'].into_iter().any(|mark| {
        let parts: Vec<&str> = day.split(mark).collect();
        let lengths: Vec<usize> = parts.iter().map(|part| part.len()).collect();
        let are_digits = parts.iter().all(|part| part.bytes().all(|byte| byte.is_ascii_digit()));
        are_digits && matches!(*lengths.as_slice(), [4, 1..=2, 1..=2] | [1..=2, 1..=2, 2 | 4])
            || are_digits && mark == '-' && matches!(*lengths.as_slice(), [4, 2])
    })
}

/// `PT1H`, `PT12H30M05S`, `P1DT2H`: how OpenDocument stores a time.
fn is_duration(text: &str) -> bool {
    let rest = text.strip_prefix("PT").or_else(|| text.strip_prefix('P')).unwrap_or_default();
    rest.starts_with(|first: char| first.is_ascii_digit())
        && rest.ends_with(['D', 'H', 'M', 'S'])
        && rest.bytes().all(|byte| byte.is_ascii_digit() || b"DTHMS.,".contains(&byte))
}

/// `2024Q1`, `2024-Q1`.
fn is_quarter(text: &str) -> bool {
    let Some((year, quarter)) = text.split_once(['Q', 'q']) else { return false };
    let year = year.trim_end_matches([' ', '-']);
    year.len() == 4
        && year.bytes().all(|byte| byte.is_ascii_digit())
        && matches!(quarter.as_bytes(), [b'1'..=b'4'])
}

#[cfg(test)]
mod tests {
    use super::is_time;

    #[test]
    fn dates_and_times_are_told_from_other_texts() {
        for text in [
            "2024-01-01 00:00:10",
            "2024-01-31T12:00:00Z",
            "00:10",
            "12:30:05.5",
            "01.02.2024",
            "1/2/24",
            "2012/01/01",
            "Jan-1-1995",
            "31 January 2024",
            "12-May-95",
            "1974Q1",
            "1974-Q1",
            "2024-01",
            "8:05 PM",
            "PT1H",
            "PT12H30M05.5S",
            "P1DT2H",
        ] {
            assert!(is_time(text.as_bytes()), "{text}");
        }
        for text in [
            "", "x", "1.5", "-1.5", "1.2.3", "1_000", "12 mV", "0x10", "1-2", "3:a", "Q1", "maybe 1",
            "2024Q5", "10.0.0.1", "P1", "PTH", "P5x",
        ] {
            assert!(!is_time(text.as_bytes()), "{text}");
        }
    }
}
