//! A second reader of MPS and LP files, exact and as plain as can be; it shares no code with the writers.

use std::collections::BTreeMap;

use boundfit_exact::Rational;
use boundfit_lp::Row;
use boundfit_tests::lp_cases::{number, times};

/// A program as it stands in a file.
#[derive(Debug, PartialEq, Eq)]
pub struct ReadProgram {
    /// The name of the row; LP files have none.
    pub name: Option<String>,
    /// The name and the form that is minimised.
    pub objective: (String, [Rational; 2]),
    /// The rows by name in ≤ form, with the scale of their comment taken back; an equation is two of them.
    pub rows: Vec<(String, Row)>,
}

/// Returns the multipliers of rows that comments state.
fn scales(text: &str, mark: &str) -> BTreeMap<String, Rational> {
    let comments = text.lines().filter_map(|line| line.strip_prefix(mark)?.split_once(" is multiplied by "));
    comments.map(|(name, rest)| (name.trim().to_owned(), number(rest.split(':').next().unwrap()))).collect()
}

fn rows_of(
    name: &str,
    a: [Rational; 2],
    sense: &str,
    b: Rational,
    scale: Option<&Rational>,
) -> Vec<(String, Row)> {
    let signs: &[i64] = match sense {
        "L" | "<=" => &[1],
        "G" | ">=" => &[-1],
        "E" | "=" => &[1, -1],
        other => panic!("{other}"),
    };
    let row = Row { a, b };
    let factor = |&sign: &i64| Rational::from(sign).checked_div(scale.unwrap_or(&Rational::one())).unwrap();
    signs.iter().map(|sign| (name.to_owned(), times(&row, &factor(sign)))).collect()
}

/// Reads free MPS.
pub fn read_mps(text: &str) -> ReadProgram {
    let scales = scales(text, "* ");
    let (mut section, mut name) = (String::new(), None);
    let mut rows: Vec<(String, String)> = Vec::new();
    let mut coefficients: BTreeMap<(String, usize), Rational> = BTreeMap::new();
    let mut right: BTreeMap<String, Rational> = BTreeMap::new();
    let mut free = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('*')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if !line.starts_with(' ') {
            section = words[0].to_owned();
            name = if section == "NAME" { Some(words[1].to_owned()) } else { name };
            continue;
        }
        match (section.as_str(), words.as_slice()) {
            ("ROWS", [sense, name]) => rows.push(((*name).to_owned(), (*sense).to_owned())),
            ("COLUMNS", [column, row, value]) => {
                let axis = ["theta1", "theta2"].iter().position(|known| known == column).unwrap();
                let old = coefficients.insert(((*row).to_owned(), axis), number(value));
                assert_eq!(old, None, "{line}");
            }
            ("RHS", ["RHS", row, value]) => {
                assert_eq!(right.insert((*row).to_owned(), number(value)), None, "{line}");
            }
            ("BOUNDS", ["FR", _, column]) => free.push((*column).to_owned()),
            _ => panic!("{section}: {line}"),
        }
    }
    assert_eq!((section.as_str(), free), ("ENDATA", vec!["theta1".to_owned(), "theta2".to_owned()]));
    let mut form =
        |name: &str| [0, 1].map(|axis| coefficients.remove(&(name.to_owned(), axis)).unwrap_or_default());
    let (objective, kind) = rows.remove(0);
    assert_eq!(kind, "N");
    let objective = (objective.clone(), form(&objective));
    let mut read = Vec::new();
    for (name, sense) in rows {
        let b = right.remove(&name).unwrap_or_default();
        read.extend(rows_of(&name, form(&name), &sense, b, scales.get(&name)));
    }
    assert!(coefficients.is_empty() && right.is_empty());
    ReadProgram { name, objective, rows: read }
}

/// Reads CPLEX's LP format.
pub fn read_lp(text: &str) -> ReadProgram {
    let scales = scales(text, "\\ ");
    let plain: Vec<&str> = text.lines().filter(|line| !line.starts_with('\\')).collect();
    let plain = plain.join(" ");
    let between = |start: &str, end: &str| {
        let (_, rest) = plain.split_once(start).unwrap();
        rest.split_once(end).unwrap().0.split_whitespace().map(ToOwned::to_owned).collect::<Vec<_>>()
    };
    assert!(plain.starts_with("Minimize"), "{plain}");
    let objective = statements(&between("Minimize", "Subject To")).remove(0);
    assert_eq!(between("Bounds", "End").join(" "), "theta1 free theta2 free");
    let rows = statements(&between("Subject To", "Bounds")).into_iter().flat_map(|(name, mut words)| {
        let b = number(&words.pop().unwrap());
        let sense = words.pop().unwrap();
        rows_of(&name, form(&words), &sense, b, scales.get(&name))
    });
    let rows = rows.collect();
    ReadProgram { name: None, objective: (objective.0, form(&objective.1)), rows }
}

/// `name: words` one after the other.
fn statements(words: &[String]) -> Vec<(String, Vec<String>)> {
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for word in words {
        match word.strip_suffix(':') {
            Some(name) => found.push((name.to_owned(), Vec::new())),
            None => found.last_mut().unwrap().1.push(word.clone()),
        }
    }
    found
}

/// `- 3 theta1 + 0.5 theta2`.
fn form(words: &[String]) -> [Rational; 2] {
    let mut form = [Rational::zero(), Rational::zero()];
    let (mut sign, mut size) = (Rational::one(), None);
    for word in words {
        match word.as_str() {
            "+" => sign = Rational::one(),
            "-" => sign = -Rational::one(),
            "theta1" | "theta2" => {
                let axis = usize::from(word == "theta2");
                form[axis] = &form[axis] + &sign * size.take().unwrap_or_else(Rational::one);
                sign = Rational::one();
            }
            value => size = Some(number(value)),
        }
    }
    assert_eq!(size, None, "{words:?}");
    form
}
