//! Stored doubles as text.

use boundfit_exact::Shortest;

/// The shortest text that reads back as the same double, as MATLAB spells what is not finite.
pub(crate) fn double_text(double: f64) -> String {
    let usual = 1e-5..1e16;
    match double.abs() {
        size if size.is_nan() => "NaN".to_owned(),
        size if size.is_infinite() => if double > 0.0 { "Inf" } else { "-Inf" }.to_owned(),
        size if size == 0.0 || usual.contains(&size) => double.in_shortest_digits(double.to_string()),
        _ => double.in_shortest_digits(format!("{double:e}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_read_back() {
        for (double, text) in [(0.0, "0"), (0.1, "0.1"), (-1.5e300, "-1.5e300"), (f64::NEG_INFINITY, "-Inf")]
        {
            assert_eq!(double_text(double), text);
        }
    }
}
