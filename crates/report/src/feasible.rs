//! Points that a report calls feasible: they are feasible as they are printed.

use boundfit_exact::{Limits, Rational, Reading, Rounding};
use boundfit_lp::RefereeRow;

use crate::document::Text;
use crate::formula::pair;
use crate::style::Style;

/// Significant digits that are tried before a point is printed as fractions: those of the style, of a double, and of two.
const DIGITS: [usize; 3] = [9, 17, 34];

/// Returns a feasible point with the fewest digits with which it is feasible. Nearest decimals come first, and else
/// each coordinate is rounded to a feasible side. The point is exact where no rounding stays within the set, as in a
/// set of one point. Cost: linear in the rows, a few times.
pub(crate) fn feasible_point(theta: &[Rational; 2], rows: &[RefereeRow], style: &Style) -> Text {
    witness(theta, rows, |_| true, style)
}

/// Returns a feasible point like [`feasible_point`], with the digits with which it also is where it shows something, as the
/// point itself is.
pub(crate) fn witness(
    theta: &[Rational; 2],
    rows: &[RefereeRow],
    is_there: impl Fn(&[Rational; 2]) -> bool,
    style: &Style,
) -> Text {
    if style.exact {
        return pair(&theta[0], &theta[1]);
    }
    // A row that one rounding violates is likely to be violated by the next one, too.
    let mut suspects: Vec<usize> = Vec::new();
    let digits =
        std::iter::once(style.significant()).chain(DIGITS).filter(|&digits| digits >= style.significant());
    for digits in digits {
        for roundings in ROUNDINGS {
            let shown = [0, 1].map(|axis| theta[axis].to_decimal(digits, roundings[axis]));
            let Some(point) = read(&shown).filter(&is_there) else { continue };
            let is_violated = |row: &RefereeRow| row.row.slack(&point).is_negative();
            if suspects.iter().filter_map(|&row| rows.get(row)).any(is_violated) {
                continue;
            }
            match rows.iter().position(is_violated) {
                Some(row) => suspects.push(row),
                None => {
                    let [theta1, theta2] = shown;
                    return pair(theta1, theta2);
                }
            }
        }
    }
    pair(&theta[0], &theta[1])
}

/// The nearest decimals first.
const ROUNDINGS: [[Rounding; 2]; 5] = [
    [Rounding::Nearest, Rounding::Nearest],
    [Rounding::Down, Rounding::Down],
    [Rounding::Down, Rounding::Up],
    [Rounding::Up, Rounding::Down],
    [Rounding::Up, Rounding::Up],
];

/// The numbers that texts of decimals spell.
fn read(shown: &[String; 2]) -> Option<[Rational; 2]> {
    let number = |text: &String| {
        // They were printed from numbers within the limits that somebody else chose.
        let limits = Limits { digits: usize::MAX, exponent: u32::MAX };
        Reading::Decimal.read(text, &limits).ok()
    };
    Some([number(&shown[0])?, number(&shown[1])?])
}

#[cfg(test)]
mod tests {
    use boundfit_lp::Row;

    use super::*;

    fn rows(rows: &[[Rational; 3]]) -> Vec<RefereeRow> {
        let row = |[a1, a2, b]: &[Rational; 3]| RefereeRow {
            row: Row { a: [a1.clone(), a2.clone()], b: b.clone() },
            epsilon: None,
        };
        rows.iter().map(row).collect()
    }

    fn number(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn what_is_printed_is_feasible() {
        let corner = [number("13/15"), number("4/3")];
        // 4·θ1 + θ2 ≥ 4.8 holds with equality at the corner, and not at (0.86667, 1.3333).
        let touching = rows(&[["-4", "-1", "-4.8"].map(number)]);
        let shown = |theta: &[Rational; 2], rows: &[RefereeRow], style: &Style| {
            feasible_point(theta, rows, style).to_string()
        };
        let style = Style::default();
        assert_eq!(shown(&corner, &[], &style), "(0.86667, 1.3333)");
        assert_eq!(shown(&corner, &touching, &style), "(0.86666, 1.3334)");
        // Nothing but the corner itself, or what has few decimals.
        let point = rows(&[
            ["1", "0", "13/15"].map(number),
            ["-1", "0", "-13/15"].map(number),
            ["0", "1", "4/3"].map(number),
            ["0", "-1", "-4/3"].map(number),
        ]);
        assert_eq!(shown(&corner, &point, &style), "(13/15, 4/3)");
        assert_eq!(shown(&corner, &touching, &Style { exact: true, ..style }), "(13/15, 4/3)");
        let narrow = rows(&[["1", "0", "13/15"].map(number), ["-1", "0", "-0.86666666"].map(number)]);
        assert_eq!(shown(&corner, &narrow, &style), "(0.866666666, 1.33333333)");
        // Beyond a claimed end of 0.86666666.
        let is_beyond = |[theta1, _]: &[Rational; 2]| *theta1 > number("0.86666666");
        let beyond = witness(&corner, &touching, is_beyond, &style).to_string();
        assert_eq!(beyond, "(0.86667, 1.3334)");
    }
}
