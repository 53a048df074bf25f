//! Numbers of a JSON report: exact forms, and decimals rounded as documented.

use boundfit_exact::{Limits, Rational, Reading};
use num_bigint::{BigInt, Sign};
use serde_json::Value;

/// In which direction a decimal is rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    Down,
    Up,
    Nearest,
}

/// A number as written.
pub fn rational(text: &str) -> Rational {
    let limits = Limits { digits: 100_000, exponent: 100_000 };
    Reading::Decimal.read(text, &limits).unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

/// A small whole number.
pub fn whole(value: i64) -> Rational {
    Rational::from(value)
}

/// The exact form of a number of a report.
pub fn exact(number: &Value) -> Rational {
    rational(number["exact"].as_str().unwrap_or_else(|| panic!("not a number: {number}")))
}

/// The exact forms of a pair.
pub fn pair(numbers: &Value) -> [Rational; 2] {
    [exact(&numbers[0]), exact(&numbers[1])]
}

/// The exact form of a number that may be null.
pub fn exact_or_null(number: &Value) -> Option<Rational> {
    (!number.is_null()).then(|| exact(number))
}

/// Checks every number of a report whose decimals have so many digits: lower ends of intervals are rounded down,
/// upper ends and error bounds up, all others to nearest. Returns how many numbers there are.
pub fn check_numbers(report: &Value, digits: usize) -> usize {
    check_below(report, &mut Vec::new(), digits)
}

fn check_below(value: &Value, path: &mut Vec<String>, digits: usize) -> usize {
    match value {
        Value::Object(fields) if fields.contains_key("exact") => {
            assert_eq!(fields.len(), 3, "{path:?}: {value}");
            let (number, decimal) = (value["exact"].as_str().unwrap(), value["decimal"].as_str().unwrap());
            assert_eq!(rational(number).to_string(), number, "{path:?}: not in lowest terms");
            assert_eq!(value["value"], nearest_double(number), "{path:?}: {value}");
            let mut directions = directions(path).iter();
            assert!(
                directions.any(|direction| is_rounded(number, decimal, digits, *direction)),
                "{path:?}: {value}"
            );
            1
        }
        Value::Object(fields) => {
            let mut count = 0;
            for (name, value) in fields {
                path.push(name.clone());
                count += check_below(value, path, digits);
                path.pop();
            }
            count
        }
        Value::Array(items) => items.iter().map(|item| check_below(item, path, digits)).sum(),
        _ => 0,
    }
}

/// The double nearest to an exact number as JSON has it, from the digits of a long decimal; null beyond the largest one.
fn nearest_double(exact: &str) -> Value {
    let (numerator, denominator) = exact.split_once('/').unwrap_or((exact, "1"));
    let [numerator, denominator] = [numerator, denominator].map(|part| part.parse::<BigInt>().unwrap());
    // 800 digits and a 1 behind them where more are cut off decide how any number is rounded to 53 bits.
    let scale = BigInt::from(10).pow(1200);
    let scaled = numerator * scale;
    let (quotient, rest) = (&scaled / &denominator, &scaled % &denominator);
    let sticky = if rest.sign() == Sign::NoSign { "0" } else { "1" };
    let double: f64 = format!("{quotient}{sticky}e-1201").parse().unwrap();
    if double.is_finite() { double.into() } else { Value::Null }
}

/// The direction that the reports document for a number, by what it is. How they repeat the error bound that was
/// asked for is left open here.
fn directions(path: &[String]) -> &'static [Direction] {
    let names: Vec<&str> = path.iter().map(String::as_str).collect();
    match names.as_slice() {
        ["input", "epsilon"] => &[Direction::Nearest, Direction::Up],
        [.., "lower"] | [.., "lower", "value"] => &[Direction::Down],
        [.., "upper"] | [.., "upper", "value"] => &[Direction::Up],
        [.., "guaranteed_error" | "epsilon_min" | "epsilon" | "epsilon_factor" | "distance"] => {
            &[Direction::Up]
        }
        [.., "deviation" | "percent" | "hysteresis" | "repeatability"]
        | [.., "hysteresis_percent" | "repeatability_percent"] => &[Direction::Up],
        _ => &[Direction::Nearest],
    }
}

/// Whether a decimal is the exact value when so many digits hold it, and else its rounding to so many digits.
pub fn is_rounded(exact: &str, decimal: &str, digits: usize, direction: Direction) -> bool {
    let (value, shown) = (rational(exact), rational(decimal));
    let (mantissa, last_digit) = parts(decimal);
    let written = mantissa.replace('.', "").trim_start_matches('0').to_owned();
    if shown == value {
        // The zeros that end a whole number are no significant digits; a fraction ends without zeros.
        let is_short = !mantissa.contains('.') || !mantissa.ends_with('0');
        return is_short && written.trim_end_matches('0').len() <= digits;
    }
    let steps = value.checked_div(&last_digit).unwrap();
    let could_be_exact = steps == Rational::from(steps.numerator());
    let error = &shown - &value;
    let is_right_way = match direction {
        Direction::Down => error.is_negative() && error > -last_digit,
        Direction::Up => error.is_positive() && error < last_digit,
        Direction::Nearest => {
            let twice = (&error + &error).abs();
            let even = shown.checked_div(&last_digit).unwrap().numerator().is_even();
            twice < last_digit || (twice == last_digit && even)
        }
    };
    written.len() == digits && !could_be_exact && is_right_way
}

/// The digits of a decimal, point included, and what the last one weighs: `-1.50e-3` gives `1.50` and 1/100000.
fn parts(decimal: &str) -> (&str, Rational) {
    let magnitude = decimal.trim_start_matches('-');
    let (mantissa, exponent) = magnitude.split_once('e').unwrap_or((magnitude, "0"));
    let fraction = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i64);
    let exponent: i64 = exponent.parse().unwrap();
    (mantissa, rational(&format!("1e{}", exponent - fraction)))
}
