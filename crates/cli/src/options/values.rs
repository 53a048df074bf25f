//! The values of options that are more than a text or a number.

use std::iter;

use boundfit_ask::Regressors;
use boundfit_exact::{Limits, Rational, Reading};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The parser of an option whose value is one of these words, or leaves the choice to the file. Help and completions list them.
pub(crate) fn words_or_auto<const N: usize>(words: [&'static str; N]) -> PossibleValuesParser {
    iter::once("auto").chain(words).into()
}

/// The parser of an option that takes one of these names. Help and completions list them.
pub(crate) fn named<T: Clone + Send + Sync + 'static>(
    values: impl IntoIterator<Item = (&'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    explained(values.into_iter().map(|(name, value)| (PossibleValue::new(name), value)))
}

/// The parser of an option that takes one of these names, of which each may carry a line of help.
pub(crate) fn explained<T: Clone + Send + Sync + 'static>(
    values: impl IntoIterator<Item = (PossibleValue, T)>,
) -> impl TypedValueParser<Value = T> {
    let values: Vec<(PossibleValue, T)> = values.into_iter().collect();
    let names: Vec<PossibleValue> = values.iter().map(|(name, _)| name.clone()).collect();
    PossibleValuesParser::new(names).try_map(move |text| {
        let named = values.iter().find(|(name, _)| name.get_name() == text);
        // The names are the parser's own: it lets no other text through.
        named.map(|(_, value)| value.clone()).ok_or("expected one of the names")
    })
}

/// The parser of an option that takes a whole number, in words for people.
pub(crate) fn whole<T: TryFrom<u64> + 'static>(
    least: u64,
    most: u64,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text: &str| {
        let number = text.trim().parse::<u64>().ok().filter(|number| (least..=most).contains(number));
        number.and_then(|number| T::try_from(number).ok()).ok_or_else(|| match most {
            u64::MAX => format!("expected a whole number, at least {least}"),
            most => format!("expected a whole number from {least} to {most}"),
        })
    }
}

/// Bytes: `1500000`, `512MiB`, `2G`, `1.5GiB`.
pub(crate) fn parse_size(text: &str) -> Option<u64> {
    const UNITS: [(&str, u64); 9] = [
        ("KiB", 1 << 10),
        ("MiB", 1 << 20),
        ("GiB", 1 << 30),
        ("kB", 1_000),
        ("MB", 1_000_000),
        ("GB", 1_000_000_000),
        ("k", 1_000),
        ("M", 1_000_000),
        ("G", 1_000_000_000),
    ];
    let with_unit = UNITS.into_iter().find_map(|(unit, times)| Some((text.strip_suffix(unit)?, times)));
    let (number, times) = with_unit.unwrap_or((text, 1));
    let number = Reading::Decimal.read(number.trim_end(), &Limits { digits: 20, exponent: 0 }).ok()?;
    let bytes = number * Rational::from(times);
    let (whole, rest) = bytes.numerator().div_rem_floor(&bytes.denominator());
    (rest.is_zero() && bytes.is_positive()).then(|| u64::try_from(whole.to_i128()?).ok()).flatten()
}

/// A column as it is asked for.
pub(crate) fn column_text(text: &str) -> Result<String, String> {
    match text.trim() {
        "" => Err("expected a header name or a column number".to_owned()),
        _ => Ok(text.to_owned()),
    }
}

pub(crate) fn parse_regressors(text: &str) -> Result<Regressors, String> {
    match split_at_commas(text).as_slice() {
        [x] => column_text(x).map(Regressors::One),
        [first, second] => Ok(Regressors::Two([column_text(first)?, column_text(second)?])),
        _ => Err("expected one column, or two separated by a comma".to_owned()),
    }
}

/// The parts between commas; those within parentheses, as in `M(:,2)`, or within the quotes around a name are not between.
fn split_at_commas(text: &str) -> Vec<&str> {
    let mut depth = 0_usize;
    let (mut quote, mut is_at_start) = (None, true);
    text.split(|character| {
        let is_between = character == ',' && depth == 0 && quote.is_none();
        match character {
            '"' | '\'' if quote == Some(character) => quote = None,
            '"' | '\'' if quote.is_none() && is_at_start => quote = Some(character),
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        is_at_start = is_between || (is_at_start && character == ' ');
        is_between
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::{parse_size, split_at_commas};

    #[test]
    fn sizes_have_units() {
        for (text, bytes) in [
            ("1", Some(1)),
            ("1024", Some(1024)),
            ("3k", Some(3_000)),
            ("3kB", Some(3_000)),
            ("512MiB", Some(512 << 20)),
            ("1.5GiB", Some(3 << 29)),
            ("2 G", Some(2_000_000_000)),
            ("0", None),
            ("-1M", None),
            ("1.5", None),
            ("GiB", None),
            ("1TiB", None),
            ("99999999999999999999", None),
        ] {
            assert_eq!(parse_size(text), bytes, "{text}");
        }
    }

    #[test]
    fn commas_within_parentheses_do_not_separate() {
        for (text, parts) in [
            ("x", &["x"][..]),
            ("x,y", &["x", "y"]),
            ("M(:,1)", &["M(:,1)"]),
            ("M(:,1),M(:,2)", &["M(:,1)", "M(:,2)"]),
            ("x),y", &["x)", "y"]),
            ("x,y,z", &["x", "y", "z"]),
        ] {
            assert_eq!(split_at_commas(text), parts, "{text}");
        }
    }
}
