//! Reductions of which one number was changed: refused, or a fit of just what they say.

use std::fmt::Write;

use boundfit_estimation::{
    Columns, EpsilonColumn, Fit, Keep, LineForm, Measurements, Problem, ReducedTable, fit,
};
use boundfit_exact::{Limits, Rational, Reading, Sign};
use boundfit_formats::{ColumnSelector, InputError, ScanOptions, Source};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::tables::TableKind;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

type Place = [Rational; 2];

fn number(text: &str) -> Option<Rational> {
    Reading::Decimal.read(text, &Limits::default()).ok()
}

fn columns(epsilon: &str) -> Columns {
    Columns {
        first: ColumnSelector::name_or_number("x"),
        second: None,
        response: Some(ColumnSelector::name_or_number("y")),
        epsilon: EpsilonColumn::Uniform(number(epsilon).unwrap()),
        form: LineForm::default(),
    }
}

fn source(text: &str) -> Source {
    Source::new("reduced", std::io::Cursor::new(text.as_bytes().to_vec()))
}

fn reduced(text: &str) -> Result<String, InputError> {
    let table = ReducedTable::scan(source(text), &columns("0"), &ScanOptions::default())?;
    let mut text = Vec::new();
    table.write(&mut text).unwrap();
    Ok(String::from_utf8(text).unwrap())
}

fn fitted(text: &str, epsilon: &str) -> Result<(Problem, Fit), InputError> {
    let scan =
        Measurements::scan(source(text), &columns(epsilon), &[], &ScanOptions::default(), Keep::default());
    let problem = Problem { measurements: scan?, conditions: Vec::new() };
    let fit = fit(&problem);
    fit.verify(&problem).unwrap();
    Ok((problem, fit))
}

/// The statements of a reduction, read without any code of the program.
#[derive(Debug, PartialEq)]
struct Said {
    rows: usize,
    /// Σx², Σx, N, Σxy and Σy.
    sums: [Rational; 5],
    /// The numbers of readings, with their places.
    kept: Vec<(usize, Place)>,
}

impl Said {
    /// `None` where a number is none.
    fn of(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        let (mark, record) = lines.next()?.split_once(" {")?;
        let record: serde_json::Value = serde_json::from_str(&format!("{{{record}")).ok()?;
        let rows = record["rows"].as_u64()?.try_into().ok()?;
        let sums: Vec<Rational> =
            record["sums"].as_array()?.iter().map(|sum| number(sum.as_str()?)).collect::<Option<_>>()?;
        // Σx, Σy, Σx² and Σxy, as the file has them.
        let [x, y, xx, xy] = sums.try_into().ok()?;
        let is_counted = mark.ends_with('3');
        let kept = lines.skip(1).map(|line| {
            let (count, cells) = if is_counted { line.split_once(' ')? } else { ("1", line) };
            let (x, y) = cells.split_once(',')?;
            Some((count.parse().ok()?, [number(x)?, number(y)?]))
        });
        Some(Said { rows, sums: [xx, x, Rational::from(rows), xy, y], kept: kept.collect::<Option<_>>()? })
    }

    /// Returns whether a place is a corner of the hull of all places: in no triangle of three others.
    fn is_corner(&self, place: &Place) -> bool {
        let others: Vec<&Place> = self.kept.iter().map(|(_, own)| own).filter(|own| *own != place).collect();
        let turn = |[p, q]: [&Place; 2]| {
            (&q[0] - &p[0]) * (&place[1] - &p[1]) - (&q[1] - &p[1]) * (&place[0] - &p[0])
        };
        let between = |p: &Place, q: &Place, axis: usize| {
            (&p[axis]).min(&q[axis]) <= &place[axis] && &place[axis] <= (&p[axis]).max(&q[axis])
        };
        !others.iter().any(|p| {
            others.iter().any(|q| {
                if turn([p, q]).is_zero() && between(p, q, 0) && between(p, q, 1) {
                    return true;
                }
                others.iter().any(|r| {
                    let turns = [[*p, *q], [*q, *r], [*r, *p]].map(turn);
                    turns.iter().all(Rational::is_positive) || turns.iter().all(Rational::is_negative)
                })
            })
        })
    }

    /// Returns the rest for the readings that are not known: their number, and their sums.
    fn left(&self) -> (i64, [Rational; 5]) {
        let mut count = self.rows as i64;
        let mut left = self.sums.clone();
        for (own, [x, y]) in &self.kept {
            let own = if self.is_corner(&[x.clone(), y.clone()]) { *own } else { 1 };
            count -= own as i64;
            let times = Rational::from(own);
            let terms = [x * x, x.clone(), Rational::one(), x * y, y.clone()];
            left.iter_mut().zip(terms).for_each(|(sum, term)| *sum = &*sum - term * &times);
        }
        (count, left)
    }

    /// Returns whether readings can be left. The spread of their x must be possible for x between the ends. Their
    /// mean must lie strictly between the kept places, or on an edge that has all of them.
    fn is_possible(&self) -> bool {
        let (count, sums) = self.left();
        if count <= 0 {
            return count == 0 && sums.iter().all(Rational::is_zero);
        }
        let [xx, x, _, _, y] = sums.map(|sum| sum.checked_div(&Rational::from(count)).unwrap());
        let ends = |axis: usize| {
            let all = || self.kept.iter().map(|(_, own)| &own[axis]);
            [all().min().unwrap().clone(), all().max().unwrap().clone()]
        };
        let on_edges: usize =
            self.kept.iter().filter(|(_, own)| !self.is_corner(own)).map(|(own, _)| own - 1).sum();
        let is_strict = count > on_edges as i64;
        let [[x_least, x_most], [y_least, y_most]] = [ends(0), ends(1)];
        let spread = xx - &x * &x;
        // Numbers within an interval spread at most as far as numbers at its ends.
        let most = (&x_most - &x) * (&x - &x_least);
        let beyond = |sign: Sign, side: Sign| sign == side || (is_strict && sign == Sign::Zero);
        // No line through two places with all others on one side has the mean on the other side.
        let is_inside = self.kept.iter().all(|(_, [px, py])| {
            self.kept.iter().filter(|(_, [qx, _])| qx > px).all(|(_, [qx, qy])| {
                let above = |x: &Rational, y: &Rational| ((qx - px) * (y - py) - (qy - py) * (x - px)).sign();
                let all = || self.kept.iter().map(|(_, [x, y])| above(x, y));
                let (none_below, none_above) =
                    (all().all(|sign| sign != Sign::Negative), all().all(|sign| sign != Sign::Positive));
                let mean = above(&x, &y);
                !(none_below && beyond(mean, Sign::Negative) || none_above && beyond(mean, Sign::Positive))
            })
        });
        let is_between = if x_least == x_most && is_strict {
            y_least < y && y < y_most
        } else {
            y_least <= y && y <= y_most
        };
        is_inside && is_between && !spread.is_negative() && spread <= most
    }

    /// Least squares from the sums; `None` where they leave it open.
    fn least_squares(&self) -> Option<Place> {
        let [xx, x, n, xy, y] = &self.sums;
        let determinant = xx * n - x * x;
        let solved = [n * xy - x * y, xx * y - x * xy];
        let [theta1, theta2] = solved.map(|own| own.checked_div(&determinant));
        Some([theta1?, theta2?])
    }

    /// The rows as a table of readings.
    fn table(&self) -> String {
        self.kept.iter().fold("x,y\n".to_owned(), |mut text, (_, [x, y])| {
            writeln!(text, "{x},{y}").unwrap();
            text
        })
    }
}

/// Everything that rows alone decide.
fn of_rows((_, fit): &(Problem, Fit)) -> String {
    let region = fit.fps.polyhedron().region();
    let corners: Vec<_> = region.vertices().iter().map(|own| own.point().coordinates()).collect();
    let least = fit.minimax.as_ref().map(|minimax| (minimax.least.clone(), minimax.theta.clone()));
    format!("{:?} {corners:?} {:?} {:?} {least:?}", region.kind(), region.rays(), region.lines())
}

/// A text with one of its numbers changed to another one.
fn edited(rng: &mut ChaCha8Rng, text: &str) -> String {
    let bytes = text.as_bytes();
    let starts = |at: &usize| bytes[*at].is_ascii_digit() && (*at == 0 || !bytes[*at - 1].is_ascii_digit());
    // Not the number of the format.
    let places: Vec<usize> = (0..bytes.len()).filter(starts).skip(1).collect();
    let at = places[rng.random_range(0..places.len())];
    let digits = bytes[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let own = &text[at..at + digits];
    let other = match rng.random_range(0..5) {
        0 => own.parse().map_or_else(|_| "7".to_owned(), |own: u64| own.saturating_add(1).to_string()),
        1 => own.parse().map_or_else(|_| "5".to_owned(), |own: u64| own.saturating_sub(1).to_string()),
        2 => format!("{own}0"),
        3 => format!("-{own}"),
        _ => rng.random_range(0..100).to_string(),
    };
    format!("{}{other}{}", &text[..at], &text[at + digits..])
}

#[test]
fn a_reduction_with_one_number_changed_is_refused_or_says_what_it_now_says() {
    let mut rng = seeded(1521);
    let kinds =
        [TableKind::Ties, TableKind::Noise, TableKind::Extreme, TableKind::Collinear, TableKind::Vertical];
    let (mut refused, mut accepted, mut known) = (0, 0, 0);
    for case in 0..share(1500) {
        let kind = kinds[rng.random_range(0..kinds.len())];
        let count = rng.random_range(1..=14);
        let rows = kind.rows(&mut rng, count);
        let table = rows.iter().fold("x,y\n".to_owned(), |text, [x, y]| text + x + "," + y + "\n");
        let text = reduced(&table).unwrap();
        let said = Said::of(&text).unwrap();
        assert!(said.is_possible(), "{case}: {text}");
        let is_known = said.left().0 == 0;
        known += usize::from(is_known);
        let (other, epsilon) = (edited(&mut rng, &text), ["0", "1", "30"][rng.random_range(0..3)]);
        let own = match (fitted(&other, epsilon), reduced(&other)) {
            (Err(error), Err(again)) => {
                assert_eq!(error.to_string(), again.to_string(), "{case}: {other}");
                refused += 1;
                continue;
            }
            (Ok(own), Ok(_)) => own,
            both => panic!("{case}: {other}: {:?}", both.1.err()),
        };
        accepted += 1;
        let now = Said::of(&other).unwrap();
        assert!(now.is_possible(), "{case}: from\n{text}to\n{other}");
        assert_eq!(own.0.measurements.fitted(), now.rows, "{case}: {other}");
        let theta = own.1.least_squares.as_ref().map(|own| own.theta.clone()).ok();
        assert_eq!(theta, now.least_squares(), "{case}: {other}");
        assert_eq!(of_rows(&own), of_rows(&fitted(&now.table(), epsilon).unwrap()), "{case}: {other}");
        // Where every reading is known, nothing else can be true.
        assert!(!is_known || said == now, "{case}: from\n{text}to\n{other}");
    }
    assert!(
        refused > share(500) && accepted > share(100) && known > share(100),
        "{refused} {accepted} {known}"
    );
}
