//! Texts from outside as cells of CSV that spreadsheets may open.

use std::borrow::Cow;

use boundfit_exact::Foreign;

/// Returns the text as a cell that no spreadsheet takes for a formula. A text that begins with `=`, `+`, `-`, `@`, a
/// tab or a line end, and is no plain number such as `-5`, gets an apostrophe in front. So does what begins with
/// apostrophes and goes on like that, so that one apostrophe less is always the text itself.
///
/// Source: OWASP, "CSV Injection", which names these characters, those of full width among them.
pub(crate) fn csv_text<'a>(text: Foreign<&'a str>) -> Cow<'a, str> {
    let raw: &'a str = text.into_inner();
    let begins_formula = raw
        .trim_start_matches('\'')
        .starts_with(['=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}']);
    let text = without_controls(raw);
    if begins_formula && !is_number(raw) { Cow::Owned(format!("'{text}")) } else { text }
}

/// Appends a cell to a row of CSV, in quotes where it needs them.
pub(crate) fn push_quoted(row: &mut String, cell: &str) {
    if !cell.contains([',', '"', '\r', '\n']) {
        return row.push_str(cell);
    }
    row.push('"');
    row.extend(cell.split('"').enumerate().flat_map(|(at, part)| [if at == 0 { "" } else { "\"\"" }, part]));
    row.push('"');
}

/// The text with control characters as `\u{1b}`, so that no terminal runs them; tabs and line ends stay.
fn without_controls(text: &str) -> Cow<'_, str> {
    let is_run = |character: char| character.is_control() && !matches!(character, '\t' | '\n' | '\r');
    if !text.contains(is_run) {
        return Cow::Borrowed(text);
    }
    let shown = |character: char| match is_run(character) {
        true => character.escape_unicode().to_string(),
        false => character.to_string(),
    };
    Cow::Owned(text.chars().map(shown).collect())
}

/// Returns whether a text is a decimal with a sign or without, which no spreadsheet computes anything from.
fn is_number(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).unwrap_or((unsigned, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let exponent = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    are_digits(whole)
        && are_digits(fraction)
        && !(whole.is_empty() && fraction.is_empty())
        && are_digits(exponent)
        && !exponent.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The length before the cell was written.
    fn read_back(cell: &str) -> &str {
        let shorter = cell.strip_prefix('\'').filter(|text| csv_text(Foreign::of(text)) != *text);
        shorter.unwrap_or(cell)
    }

    #[test]
    fn cells_are_quoted_as_the_library_for_csv_quotes_them() {
        for cell in ["", "a", " a b ", "a,b", "\"", "a\"\"b\"", "l\nf", "c\rr", "#", "'=1", "\u{e4},", ";\t|"]
        {
            let mut row = String::new();
            push_quoted(&mut row, cell);
            let mut writer = csv::Writer::from_writer(Vec::new());
            writer.write_record([cell, "1"]).unwrap();
            let expected = String::from_utf8(writer.into_inner().unwrap()).unwrap();
            assert_eq!(row + ",1\n", expected, "{cell:?}");
        }
    }

    #[test]
    fn no_terminal_runs_what_a_cell_holds() {
        for (text, cell) in [
            ("a\u{1b}[2Jb", "a\\u{1b}[2Jb"),
            ("=\u{7}\u{9b}1", "'=\\u{7}\\u{9b}1"),
            ("a\tb\nc\rd \u{e4}", "a\tb\nc\rd \u{e4}"),
        ] {
            assert_eq!(csv_text(Foreign::of(text)), cell, "{text:?}");
        }
    }

    #[test]
    fn no_text_is_a_formula_and_numbers_stay_numbers() {
        for (text, cell) in [
            ("=cmd|1", "'=cmd|1"),
            ("+1+1", "'+1+1"),
            ("-2+3", "'-2+3"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("\t=1", "'\t=1"),
            ("\r=1", "'\r=1"),
            ("\n=1", "'\n=1"),
            ("＝1", "'＝1"),
            ("'=1", "''=1"),
            ("''=1", "'''=1"),
            ("-", "'-"),
            ("-1/2", "'-1/2"),
            ("-.", "'-."),
            ("-1e", "'-1e"),
            ("-5", "-5"),
            ("+1.5e-3", "+1.5e-3"),
            ("-.5", "-.5"),
            ("", ""),
            ("a=b", "a=b"),
            ("'tis", "'tis"),
            ("sensor 7", "sensor 7"),
        ] {
            assert_eq!(csv_text(Foreign::of(text)), cell, "{text:?}");
            assert_eq!(read_back(cell), text);
        }
    }
}
