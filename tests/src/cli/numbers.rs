//! Numbers of a JSON report: exact forms, and decimals rounded as documented.

use boundfit_exact::{Limits, Rational, Reading};
use num_bigint::{BigInt, Sign};
use serde_json::Value;

/// The direction in which a decimal is rounded.
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
    // An end where nothing bounds has an exact form that is null.
    (!number.is_null() && !number["exact"].is_null()).then(|| exact(number))
}

/// Checks every number of a report whose decimals have so many digits: lower ends of intervals are rounded down,
/// upper ends and error bounds up, all others to nearest. Returns how many numbers there are.
pub fn check_numbers(report: &Value, digits: usize) -> usize {
    check_below(report, &mut Vec::new(), digits)
}

fn check_below(value: &Value, path: &mut Vec<String>, digits: usize) -> usize {
    match value {
        Value::Object(fields) if fields.contains_key("exact") => check_number(value, path, digits),
        Value::Object(fields) => {
            let mut count = 0;
            let is_bounded = fields.get("guaranteed_error").is_some_and(|errors| !errors.is_null());
            for (name, value) in fields {
                if is_bounded && ["theta", "guaranteed_error"].contains(&name.as_str()) {
                    continue;
                }
                path.push(name.clone());
                count += check_below(value, path, digits);
                path.pop();
            }
            if is_bounded {
                check_estimate(value, digits);
                count += 4;
            }
            count
        }
        Value::Array(items) => items.iter().map(|item| check_below(item, path, digits)).sum(),
        _ => 0,
    }
}

/// Checks a number, and what proves it where it is an end; one where nothing bounds has nulls alone.
fn check_number(value: &Value, path: &mut Vec<String>, digits: usize) -> usize {
    let fields = value.as_object().unwrap();
    let forms = ["exact", "decimal", "value", "outward"];
    assert!(fields.keys().all(|key| forms.contains(&key.as_str()) || key == "active"), "{path:?}: {value}");
    let mut count = 0;
    if let Some(active) = fields.get("active") {
        path.push("active".to_owned());
        count += check_below(active, path, digits);
        path.pop();
        if value["exact"].is_null() {
            assert!(forms.iter().all(|form| value[form].is_null()) && count == 0, "{path:?}: {value}");
            return 0;
        }
    }
    let (number, decimal) = (value["exact"].as_str().unwrap(), value["decimal"].as_str().unwrap());
    assert_eq!(rational(number).to_string(), number, "{path:?}: not in lowest terms");
    assert_eq!(value["value"], nearest_double(number), "{path:?}: {value}");
    let directions = directions(path);
    check_outward(value, directions, path);
    let mut directions = directions.iter();
    assert!(directions.any(|direction| is_rounded(number, decimal, digits, *direction)), "{path:?}: {value}");
    count + 1
}

/// Checks the double that is not inside: all that is rounded outward has one, next to the number.
fn check_outward(value: &Value, directions: &[Direction], path: &[String]) {
    let exact = exact(value);
    let is_end = directions.iter().any(|direction| *direction != Direction::Nearest);
    assert_eq!(value.get("outward").is_some(), is_end, "{path:?}: {value}");
    let Some(outward) = value.get("outward").and_then(Value::as_f64) else { return };
    let [own, below, above] =
        [outward, outward.next_down(), outward.next_up()].map(|double| Rational::from_f64(double).unwrap());
    let is_tight = match directions.contains(&Direction::Down) {
        true => own <= exact && above > exact,
        false => own >= exact && below < exact,
    };
    assert!(is_tight, "{path:?}: {value}");
}

/// Checks an estimate with its guaranteed error: decimals and doubles enclose what the exact numbers enclose, and are hardly wider.
fn check_estimate(estimate: &Value, digits: usize) {
    for axis in [0, 1] {
        let (theta, error) = (&estimate["theta"][axis], &estimate["guaranteed_error"][axis]);
        let (exact_theta, exact_error) = (exact(theta), exact(error));
        let decimals = [theta, error].map(|number| rational(number["decimal"].as_str().unwrap()));
        check_enclosed(&decimals, &exact_theta, &exact_error);
        let (mantissa, last) = parts(error["decimal"].as_str().unwrap());
        assert!(decimals[1] < &exact_error + &last + &last || decimals[1] == exact_error, "{estimate}");
        let written = mantissa.replace('.', "").trim_start_matches('0').trim_end_matches('0').len();
        assert!(written <= digits, "{estimate}");
        let doubles = [&theta["value"], &error["outward"]].map(Value::as_f64);
        if let [Some(theta), Some(error)] = doubles {
            let doubles = [theta, error].map(|double| Rational::from_f64(double).unwrap());
            check_enclosed(&doubles, &exact_theta, &exact_error);
        }
    }
}

/// Checks that an estimate and its error bound as they are shown enclose what the exact ones enclose.
pub fn check_enclosed([theta, error]: &[Rational; 2], exact_theta: &Rational, exact_error: &Rational) {
    let [lower, upper] = [theta - error, theta + error];
    let said = format!("{theta} +- {error} of {exact_theta} +- {exact_error}");
    assert!(lower <= exact_theta - exact_error && upper >= exact_theta + exact_error, "{said}");
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

/// The direction that the reports document for a number, by what it is. This function leaves open how reports repeat
/// the error bound that was asked for.
fn directions(path: &[String]) -> &'static [Direction] {
    let names: Vec<&str> = path.iter().map(String::as_str).collect();
    match names.as_slice() {
        ["input", "epsilon"] => &[Direction::Nearest, Direction::Up],
        [.., "lower"] => &[Direction::Down],
        [.., "upper"] => &[Direction::Up],
        [.., "guaranteed_error" | "epsilon_min" | "epsilon" | "epsilon_factor" | "distance"] => {
            &[Direction::Up]
        }
        [.., "deviation" | "percent" | "hysteresis" | "repeatability"]
        | [.., "hysteresis_percent" | "repeatability_percent"] => &[Direction::Up],
        _ => &[Direction::Nearest],
    }
}

/// Returns whether a decimal is the exact value when so many digits hold it, and else its rounding to so many digits.
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
