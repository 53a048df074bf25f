//! The content of the rows, as a statement that a person reads: the readings of a fit, or half-planes.

use std::collections::HashMap;

use boundfit_estimation::{BoundName, Bounds, Condition, Measurement, Measurements, Model, Problem};
use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::{Inequality, System};
use boundfit_lp as lp;

use super::numbers::{column, literal, pieces};

/// A row `lower ≤ a·θ1 + b·θ2 ≤ upper` of a program, or the bounds of one of its columns.
pub(super) struct ProgramRow<'a> {
    pub(super) form: [Rational; 2],
    pub(super) bounds: &'a lp::Bounds,
}

impl ProgramRow<'_> {
    /// Adds a half-plane for each bound, the lower one first, as the checker numbers them.
    pub(super) fn push_to(&self, system: &mut System) {
        let [a, b] = &self.form;
        if let Some(lower) = &self.bounds.lower {
            system.push(Inequality::new(-a, -b, -lower));
        }
        if let Some(upper) = &self.bounds.upper {
            system.push(Inequality::new(a.clone(), b.clone(), upper.clone()));
        }
    }
}

/// Rows in text with the columns that a statement names, and what the statement says of each.
pub(super) struct Statement {
    /// Text of the rows as literals of Coq.
    pub(super) rows: String,
    /// Number of rows.
    pub(super) count: usize,
    /// The content of the columns.
    about: String,
    /// `Definition`s of the columns.
    columns: String,
    /// The statement of a row `r` about `p`, over the rational and over the real numbers.
    says: [String; 2],
    /// The row as the checker takes it.
    form: &'static str,
    /// The lemma that both are the same, with what it is applied to but `p`.
    lemma: [&'static str; 2],
    /// Text of the conditions, if there are any.
    conditions: Option<String>,
}

impl Statement {
    /// The readings and conditions of a problem, with the numbers of its half-planes from 1. `None` when some readings are
    /// not in memory.
    pub(super) fn of_problem(problem: &Problem) -> Option<(Self, HashMap<BoundName, usize>)> {
        let measurements = &problem.measurements;
        let rows = every_row(measurements)?;
        let mut numbers = HashMap::new();
        let mut number = |name| {
            let next = numbers.len() + 1;
            numbers.insert(name, next);
        };
        for (row, measurement) in &rows {
            let (lower, upper) = match &measurement.bounds {
                Bounds::Around { .. } => (true, true),
                Bounds::Between { lower, upper, .. } => (lower.is_some(), upper.is_some()),
            };
            lower.then(|| number(BoundName::Lower(*row)));
            upper.then(|| number(BoundName::Upper(*row)));
        }
        for (index, condition) in problem.conditions.iter().enumerate() {
            if condition.is_equation() {
                number(BoundName::WhereLower(index + 1));
                number(BoundName::WhereUpper(index + 1));
            } else {
                number(BoundName::Where(index + 1));
            }
        }
        let conditions = &problem.conditions;
        let conditions = (!conditions.is_empty()).then(|| pieces(conditions.iter().map(condition_row)));
        let is_line = matches!(measurements.model(), Model::Line { .. });
        let statement = readings(&rows, is_line)?;
        Some((Statement { conditions, ..statement }, numbers))
    }

    /// Half-planes, each of which is numbered by its place from 1.
    pub(super) fn of_half_planes(system: &System) -> Self {
        let part = |part: fn(&Inequality) -> &Rational| {
            let values: Vec<_> = system.inequalities().iter().map(|own| Some(part(own).clone())).collect();
            column(&values)
        };
        let columns = [part(|own| &own.a[0]), part(|own| &own.a[1]), part(|own| &own.b)];
        Statement {
            rows: joined(&columns),
            count: system.len(),
            about: "the half-planes a*theta1 + b*theta2 <= c, a row each: a, b, c".to_owned(),
            columns: columns_of(&["a", "b", "c"]),
            says: both("fst p * a r + snd p * b r <= c r"),
            form: "Form (a r) (b r) None (Some (c r))",
            lemma: ["at_most_is (a r) (b r) (c r)", "at_mostR_is (a r) (b r) (c r)"],
            conditions: None,
        }
    }

    /// The rows of a linear program, and the bounds of its two columns as the last two rows.
    pub(super) fn of_program(rows: &[ProgramRow], names: [&Foreign; 2]) -> Self {
        let part = |part: &dyn Fn(&ProgramRow) -> Option<Rational>| {
            let values: Vec<_> = rows.iter().map(part).collect();
            column(&values)
        };
        let columns = [
            part(&|own| Some(own.form[0].clone())),
            part(&|own| Some(own.form[1].clone())),
            part(&|own| own.bounds.lower.clone()),
            part(&|own| own.bounds.upper.clone()),
        ];
        let [theta1, theta2] = names.map(in_comment);
        Statement {
            rows: joined(&columns),
            count: rows.len(),
            about: format!(
                "the rows of the program, then the bounds of its two columns: a, b, and a lower and an upper bound of\n   \
                 a*theta1 + b*theta2 as far as there are any. theta1 is the first column{theta1}, theta2 the second one{theta2}"
            ),
            columns: format!("{}{}", columns_of(&["a", "b"]), bounds_from(2)),
            says: [
                "at_least (least r) (fst p * a r + snd p * b r) /\\ at_most (fst p * a r + snd p * b r) (most r)".to_owned(),
                "at_leastR (least r) (fst p * Q2R (a r) + snd p * Q2R (b r))%R /\\ \
                 at_mostR (fst p * Q2R (a r) + snd p * Q2R (b r))%R (most r)"
                    .to_owned(),
            ],
            form: "Form (a r) (b r) (least r) (most r)",
            lemma: ["between_is (a r) (b r) (least r) (most r)", "betweenR_is (a r) (b r) (least r) (most r)"],
            conditions: None,
        }
    }

    /// The definitions of the rows, of what they say, and of the set, and what ties them to the checker.
    pub(super) fn text(&self) -> String {
        let Statement { rows, about, columns, says: [says, real], form, conditions, .. } = self;
        let (set, real_set, forms, own) = match conditions {
            None => (String::new(), String::new(), String::new(), String::new()),
            Some(text) => (
                " /\\ (forall c, In c conditions -> keeps c p)".to_owned(),
                " /\\ (forall c, In c conditions -> keepsR c p)".to_owned(),
                " ++ conditions".to_owned(),
                format!(
                    "(* Conditions: a, b, and the bounds of a*theta1 + b*theta2, as far as there are any. *)\n\
                     Definition conditions : list form := map form_of (read {text}).\n\n"
                ),
            ),
        };
        let (open, close) = if conditions.is_some() { ("(", ")") } else { ("", "") };
        format!(
            "(* Rows: {about}. *)\n\
             Definition rows : list row := read {rows}.\n{columns}\n{own}\
             (* What the rows say of p = (theta1, theta2). *)\n\
             Definition feasible (p : Q * Q) :=\n  {open}forall r, In r rows -> {says}{close}{set}.\n\
             Definition feasibleR (p : R * R) :=\n  {open}forall r, In r rows -> {real}{close}{real_set}.\n\n\
             (* The rows as the checker takes them. *)\n\
             Definition forms : list form := map (fun r => {form}) rows{forms}.\n{}{}",
            self.tie("feasible_forms", "Q", "feasible", "feasible_q", 0),
            self.tie("feasible_formsR", "R", "feasibleR", "feasible_r", 1),
        )
    }

    /// The definitions of what a part of the rows says, and what ties them to the checker.
    pub(super) fn parts(&self) -> String {
        let conditions = if self.conditions.is_some() { "conditions" } else { "[]" };
        format!(
            "\n(* What the rows of a part say of p. Rows are numbered from 1, as they stand above. *)\n{}{}\
             (* A row as the checker takes it. *)\n\
             Definition row_form (r : row) : form := {}.\n\
             Definition always : list form := {conditions}.\n{}{}\n",
            self.part("Q", 0),
            self.part("R", 1),
            self.form,
            self.tie_part("Q", 0),
            self.tie_part("R", 1),
        )
    }

    fn part(&self, field: &str, which: usize) -> String {
        let real = if which == 1 { "R" } else { "" };
        let (open, close) = match self.conditions {
            Some(_) => ("(", format!(") /\\ (forall c, In c conditions -> keeps{real} c p)")),
            None => ("", String::new()),
        };
        let says = &self.says[which];
        format!(
            "Definition feasible_part{real} (part : Z -> row -> Prop) (p : {field} * {field}) :=\n  \
             {open}forall i r, In (i, r) (numbered rows) -> part i r -> {says}{close}.\n"
        )
    }

    fn tie_part(&self, field: &str, which: usize) -> String {
        let (real, meets) = if which == 1 { ("R", "meets_r") } else { ("", "meets_q") };
        let (says, lemma, form) = (&self.says[which], self.lemma[which], self.form);
        let (how, with) = match self.conditions {
            None => ("alone", ""),
            Some(_) => ("is", " conditions"),
        };
        format!(
            "Lemma part_forms{real} part (p : {field} * {field}) :\n  \
             feasible_part{real} part p <-> meets_part ({field} * {field}) {meets} rows row_form always part p.\n\
             Proof.\n  exact (part_{how}{real} rows (fun r p => {says}) (fun r => {form}){with} part p (fun r => {lemma} p)).\nQed.\n"
        )
    }

    /// The lemma that the set of the statement is the one that the checker is about.
    fn tie(&self, name: &str, field: &str, set: &str, checked: &str, which: usize) -> String {
        let real = if which == 1 { "R" } else { "" };
        let (says, lemma, form) = (&self.says[which], self.lemma[which], self.form);
        let (how, with) = match self.conditions {
            None => ("alone", ""),
            Some(_) => ("together", " conditions"),
        };
        format!(
            "Lemma {name} (p : {field} * {field}) : {set} p <-> {checked} forms p.\n\
             Proof.\n  exact ({how}{real} row rows (fun r p => {says}) (fun r => {form}){with} p (fun r => {lemma} p)).\nQed.\n"
        )
    }
}

/// Every reading with its row, equal ones too.
pub(super) fn every_row(measurements: &Measurements) -> Option<Vec<(usize, Measurement)>> {
    let (rows, ties) = measurements.every()?;
    if ties.is_empty() {
        return Some(rows.iter().map(|own| (own.row, own.clone())).collect());
    }
    let fitted: Vec<usize> = measurements.fitted_rows().iter().flat_map(|&[from, to]| from..=to).collect();
    let all = measurements.readings_of(&fitted);
    (all.len() == measurements.fitted())
        .then(|| all.into_iter().map(|(row, own)| (row, own.clone())).collect())
}

/// A column of the readings.
fn part(rows: &[(usize, Measurement)], part: impl Fn(&Measurement) -> Option<Rational>) -> Vec<String> {
    let values: Vec<_> = rows.iter().map(|(_, own)| part(own)).collect();
    column(&values)
}

fn readings(rows: &[(usize, Measurement)], is_line: bool) -> Option<Statement> {
    let mut columns = vec![part(rows, |own| Some(own.regressor[0].clone()))];
    let mut names = vec!["x"];
    if !is_line {
        columns.push(part(rows, |own| Some(own.regressor[1].clone())));
        names.push("u");
    }
    let around = |own: &Measurement| match &own.bounds {
        Bounds::Around { response, epsilon } => Some((response.clone(), epsilon.clone())),
        Bounds::Between { .. } => None,
    };
    let pairs: Option<Vec<(Rational, Rational)>> = rows.iter().map(|(_, own)| around(own)).collect();
    match pairs {
        Some(pairs) => readings_around(columns, names, &pairs),
        None => Some(readings_between(columns, &names, rows)),
    }
}

/// θ1·x + θ2, or θ1·x + θ2·u, over the rational and over the real numbers.
fn value(is_line: bool) -> [&'static str; 2] {
    if is_line {
        ["fst p * x r + snd p", "fst p * Q2R (x r) + snd p"]
    } else {
        ["fst p * x r + snd p * u r", "fst p * Q2R (x r) + snd p * Q2R (u r)"]
    }
}

/// Readings within eps of y.
fn readings_around(
    mut columns: Vec<Vec<String>>,
    mut names: Vec<&'static str>,
    pairs: &[(Rational, Rational)],
) -> Option<Statement> {
    let is_line = names.len() == 1;
    let [rational, real] = value(is_line);
    let (y, epsilon): (Vec<_>, Vec<_>) =
        pairs.iter().map(|(y, own)| (Some(y.clone()), Some(own.clone()))).unzip();
    columns.push(column(&y));
    names.push("y");
    let first = &pairs.first()?.1;
    let uniform = pairs.iter().all(|(_, own)| own == first);
    if !uniform {
        columns.push(column(&epsilon));
        names.push("eps");
    }
    let mut definitions = columns_of(&names);
    if uniform {
        definitions.push_str(&format!("Definition eps (r : row) : Q := {}.\n", literal(first)));
    }
    Some(Statement {
        rows: joined(&columns),
        count: pairs.len(),
        about: names.join(", "),
        columns: definitions,
        says: [
            format!("Qabs (y r - ({rational})) <= eps r"),
            format!("(Rabs (Q2R (y r) - ({real})) <= Q2R (eps r))%R"),
        ],
        form: if is_line { "around (x r) 1 (y r) (eps r)" } else { "around (x r) (u r) (y r) (eps r)" },
        lemma: if is_line {
            ["line_is (x r) (y r) (eps r)", "lineR_is (x r) (y r) (eps r)"]
        } else {
            ["within_is (x r) (u r) (y r) (eps r)", "withinR_is (x r) (u r) (y r) (eps r)"]
        },
        conditions: None,
    })
}

/// Readings with bounds of their own, of which some may be missing.
fn readings_between(
    mut columns: Vec<Vec<String>>,
    names: &[&'static str],
    rows: &[(usize, Measurement)],
) -> Statement {
    let (is_line, first) = (names.len() == 1, names.len());
    let [rational, real] = value(is_line);
    columns.push(part(rows, Measurement::lower));
    columns.push(part(rows, Measurement::upper));
    Statement {
        rows: joined(&columns),
        count: rows.len(),
        about: format!("{}, and a lower and an upper bound as far as there are any", names.join(", ")),
        columns: format!("{}{}", columns_of(names), bounds_from(first)),
        says: [
            format!("at_least (least r) ({rational}) /\\ at_most ({rational}) (most r)"),
            format!("at_leastR (least r) ({real})%R /\\ at_mostR ({real})%R (most r)"),
        ],
        form: if is_line { "Form (x r) 1 (least r) (most r)" } else { "Form (x r) (u r) (least r) (most r)" },
        lemma: if is_line {
            ["line_between_is (x r) (least r) (most r)", "line_betweenR_is (x r) (least r) (most r)"]
        } else {
            ["between_is (x r) (u r) (least r) (most r)", "betweenR_is (x r) (u r) (least r) (most r)"]
        },
        conditions: None,
    }
}

/// a, b, the lower bound of an equation, and the upper one.
fn condition_row(condition: &Condition) -> String {
    let Inequality { a: [a, b], b: bound } = condition.inequality();
    let lower = if condition.is_equation() { bound.to_string() } else { String::new() };
    format!("{a},{b},{lower},{bound}")
}

/// The same text over the rational and over the real numbers, where each number of a row is embedded.
fn both(says: &str) -> [String; 2] {
    let real = says.replace("a r", "Q2R (a r)").replace("b r", "Q2R (b r)").replace("c r", "Q2R (c r)");
    [says.to_owned(), format!("({real})%R")]
}

fn columns_of(names: &[&str]) -> String {
    let own =
        |(index, name): (usize, &&str)| format!("Definition {name} (r : row) : Q := number {index} r.\n");
    names.iter().enumerate().map(own).collect()
}

/// The definitions of a lower and an upper bound, which stand from a column on.
fn bounds_from(first: usize) -> String {
    format!(
        "Definition least (r : row) : option Q := entry {first} r.\n\
         Definition most (r : row) : option Q := entry {} r.\n",
        first + 1
    )
}

/// A name after a comma, if it is plain: nothing in it ends a comment of Coq.
fn in_comment(name: &Foreign) -> String {
    let is_plain = |own: char| own.is_ascii_alphanumeric() || matches!(own, '_' | '.' | '-' | '[' | ']');
    match !name.is_empty() && name.raw().len() <= 40 && name.raw().chars().all(is_plain) {
        true => format!(" ({})", name.raw()),
        false => String::new(),
    }
}

fn joined(columns: &[Vec<String>]) -> String {
    let count = columns.first().map_or(0, Vec::len);
    let row = |index: usize| {
        let cells: Vec<&str> = columns.iter().filter_map(|own| own.get(index)).map(String::as_str).collect();
        cells.join(",")
    };
    pieces((0..count).map(row))
}
