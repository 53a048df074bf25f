//! Statements of theorems about sets, in whole numbers, and the oracle's judgement of them.

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_tests::oracle::{Row, solve};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Points `(x/w, y/w)` with `w > 0`, and directions.
pub struct Generators {
    points: Vec<[i128; 3]>,
    rays: Vec<[i128; 2]>,
}

/// An end of a form on a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct End {
    /// `lowest`, `highest`, `no_lowest` or `no_highest`.
    pub which: String,
    /// `fst` or `snd`.
    pub form: String,
    /// The bound, if there is one.
    pub bound: Option<String>,
}

impl Generators {
    pub fn new(points: &[Vec<String>], rays: &[Vec<String>]) -> Self {
        Generators {
            points: points.iter().map(|own| homogeneous(own)).collect(),
            rays: rays.iter().map(|own| homogeneous(own)).map(|[x, y, _]| [x, y]).collect(),
        }
    }

    /// Returns true if the rows leave just the convex hull of the points with the cone of the rays.
    pub fn are_the_set_of(&self, rows: &[Row]) -> bool {
        let Generators { points, rays } = self;
        let answer = solve(rows);
        let slack = |[a, b, c]: Row, [x, y, w]: [i128; 3]| c * w - a * x - b * y;
        let are_inside = rows.iter().all(|&row| {
            points.iter().all(|&point| slack(row, point) >= 0)
                && rays.iter().all(|[x, y]| slack(row, [*x, *y, 0]) >= 0)
        });
        let cross = |a: [i128; 2], b: [i128; 2]| a[0] * b[1] - a[1] * b[0];
        let in_cone = |d: [i128; 2]| {
            rays.iter().any(|&r| cross(r, d) == 0 && r[0] * d[0] + r[1] * d[1] > 0)
                || rays
                    .iter()
                    .any(|&r| rays.iter().any(|&s| cross(r, s) > 0 && cross(d, s) >= 0 && cross(r, d) >= 0))
        };
        let is_listed = |vertex: &[i128; 3]| {
            points
                .iter()
                .any(|p| p[0] * vertex[2] == vertex[0] * p[2] && p[1] * vertex[2] == vertex[1] * p[2])
        };
        // Without a vertex, each boundary line of the set has a point.
        let is_reached = |&row: &Row| {
            let [a, b, c] = row;
            let foot = [a * c, b * c, a * a + b * b];
            [a, b] == [0, 0]
                || rows.iter().any(|&other| slack(other, foot) < 0)
                || points.iter().any(|&point| slack(row, point) == 0)
        };
        let opposite = |[x, y]: [i128; 2]| [-x, -y];
        answer.kind != "empty"
            && are_inside
            && !points.is_empty()
            && answer.vertices.iter().all(|(vertex, _)| is_listed(vertex))
            && answer.rays.iter().all(|&ray| in_cone(ray))
            && answer.lines.iter().all(|&line| in_cone(line) && in_cone(opposite(line)))
            && (answer.lines.is_empty() || rows.iter().all(is_reached))
    }

    /// Returns true if an end of a parameter is right.
    pub fn has_end(&self, End { which, form, bound }: &End) -> bool {
        let form = if form == "snd" { ["0", "1", "0"] } else { ["1", "0", "0"] };
        self.has_end_of(&form.map(number), which, bound.as_deref())
    }

    /// Returns true if `a·x + b·y + c` has this bound at this end, and attains it, or has none.
    pub fn has_end_of(&self, [a, b, c]: &[Rational; 3], which: &str, bound: Option<&str>) -> bool {
        let bound = bound.map_or(Rational::zero(), number);
        let ([a, b, c, bound], _) = Rational::over_common_denominator([a, b, c, &bound]);
        let [a, b, c, bound] = [a, b, c, bound].map(|own| own.to_i128().unwrap());
        let sign = if which.ends_with("lowest") { 1 } else { -1 };
        let goes_on = self.rays.iter().any(|[x, y]| (a * x + b * y) * sign < 0);
        if which.starts_with("no_") {
            return goes_on;
        }
        let beyond = |[x, y, w]: &[i128; 3]| (a * x + b * y + (c - bound) * w) * sign;
        let is_bound = self.points.iter().all(|own| beyond(own) >= 0);
        !goes_on && is_bound && self.points.iter().any(|own| beyond(own) == 0)
    }
}

/// A number as the theory reads it: an empty cell is 0.
pub fn number(text: &str) -> Rational {
    if text.is_empty() { Rational::zero() } else { Reading::Decimal.read(text, &Limits::default()).unwrap() }
}

/// A point as integers x, y, w with w > 0.
fn homogeneous(cells: &[String]) -> [i128; 3] {
    let ([x, y], w) = Rational::over_common_denominator([&number(&cells[0]), &number(&cells[1])]);
    [x, y, w].map(|own| own.to_i128().unwrap())
}

pub fn cells(line: &str) -> Vec<String> {
    line.split(',').map(|cell| cell.trim().to_owned()).collect()
}

/// The first list of pairs in a text, `[(x, y); ...].`
pub fn pairs(text: &str) -> Vec<Vec<String>> {
    let own = &text[text.find('[').unwrap() + 1..text.find("].").unwrap()];
    own.split("; ").filter(|own| !own.is_empty()).map(|own| cells(own.trim_matches(['(', ')']))).collect()
}

/// The ends that the lemmas of a file state.
pub fn ends_of(text: &str) -> Vec<End> {
    let is_end = |line: &&str| line.starts_with("Lemma fst_") || line.starts_with("Lemma snd_");
    let end = |line: &str| {
        let says = line.split_once(" : ").unwrap().1.trim_end_matches('.');
        let mut words = says.splitn(4, ' ').map(ToOwned::to_owned);
        let mut word = || words.next().unwrap();
        let (which, _, form) = (word(), word(), word());
        let bound = words.next().map(|own| own.trim_matches(['(', ')']).replace(" # ", "/"));
        End { which, form, bound }
    };
    text.lines().filter(is_end).map(end).collect()
}

/// Changes a number in text.
pub fn changed(rng: &mut ChaCha8Rng, text: &mut String) {
    let value = number(text);
    let value = match rng.random_range(0..7) {
        0 => &value + &Rational::one(),
        1 => &value - &Rational::one(),
        2 => &value * &Rational::from(2),
        3 => -value,
        4 => Rational::zero(),
        5 => &value + &Rational::ratio(1, 7),
        _ => &value - &Rational::ratio(1, 1000),
    };
    *text = value.to_string();
}

/// Changes one thing of a list of rows.
pub fn tampered(rng: &mut ChaCha8Rng, rows: &mut Vec<Vec<String>>) {
    if rows.is_empty() {
        return;
    }
    let (one, other) = (rng.random_range(0..rows.len()), rng.random_range(0..rows.len()));
    match rng.random_range(0..10) {
        0 => drop(rows.remove(one)),
        1 => rows.insert(other, rows[one].clone()),
        2 => rows.swap(one, other),
        _ => {
            let cell = rng.random_range(0..rows[one].len());
            changed(rng, &mut rows[one][cell]);
        }
    }
}
