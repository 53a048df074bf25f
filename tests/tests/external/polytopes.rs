//! lrs and cddlib (`cddexec_gmp`, Debian packages `lrslib` and `libcdd-tools`) on generated sets, from half-planes to
//! generators and back: the same sets as ours, exactly, up to order and scale.
//!
//! A reader of its own reads the output of the two programs, and ours.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::{Cursor, Read, Write};
use std::process::{Command, Stdio};

use boundfit_exact::Rational;
use boundfit_formats::{Source, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_report::{h_representation, v_representation};
use boundfit_tests::generate::{rational_system, seeded};
use boundfit_tests::representations::generator_rows;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Generated sets in each of the two representations.
const CASES: usize = 1_250;

type Row = [Rational; 3];

/// A set up to the order and scale of its rows. A flat set, or a set with lines, has many equivalent matrices. This
/// has one form: `linear` in reduced echelon form, the other rows reduced by it, so that equal sets are equal.
#[derive(Debug, PartialEq, Eq)]
struct Canonical {
    linear: BTreeSet<Vec<String>>,
    rows: BTreeSet<Vec<String>>,
}

/// A matrix as a program wrote it.
#[derive(Debug)]
struct Matrix {
    is_v: bool,
    rows: Vec<Row>,
    linear: BTreeSet<usize>,
}

fn number(text: &str) -> Rational {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let whole = |text: &str| {
        let digits = text.strip_prefix('-').unwrap_or(text);
        let value = digits.bytes().fold(Rational::zero(), |value, digit| {
            assert!(digit.is_ascii_digit(), "{text:?}");
            value * Rational::from(10) + Rational::from(i64::from(digit - b'0'))
        });
        if text.starts_with('-') { -value } else { value }
    };
    whole(numerator).checked_div(&whole(denominator)).unwrap()
}

/// Reads the first matrix of a program's output.
fn read(text: &str) -> Option<Matrix> {
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    let begin = lines.iter().position(|words| words == &["begin"])?;
    let end = lines.iter().position(|words| words == &["end"])?;
    let head = &lines[..begin];
    let is_v = head.iter().any(|words| words == &["V-representation"]);
    let listed = head.iter().find(|words| words.first() == Some(&"linearity"));
    let linear = listed.iter().flat_map(|words| &words[2..]).map(|row| row.parse::<usize>().unwrap() - 1);
    let rows: Vec<Row> =
        lines[begin + 2..end].iter().map(|words| [0, 1, 2].map(|column| number(words[column]))).collect();
    Some(Matrix { is_v, rows, linear: linear.collect() })
}

/// The row times a positive number such that its first non-zero number is 1 or -1.
fn scaled(row: &Row) -> Vec<String> {
    let size = row.iter().find(|number| !number.is_zero()).map_or_else(Rational::one, Rational::abs);
    row.iter().map(|number| number.checked_div(&size).unwrap().to_string()).collect()
}

fn minus_multiple(row: &Row, times: &Rational, other: &Row) -> Row {
    [0, 1, 2].map(|column| &row[column] - times * &other[column])
}

impl Matrix {
    fn canonical(&self) -> Canonical {
        let mut basis: Vec<(usize, Row)> = Vec::new();
        // Echelon form from the last column on: of points, the first number stays what it is.
        let reduce = |row: &Row, basis: &[(usize, Row)]| {
            basis
                .iter()
                .fold(row.clone(), |row, (pivot, other)| minus_multiple(&row, &row[*pivot].clone(), other))
        };
        for &index in &self.linear {
            let row = reduce(&self.rows[index], &basis);
            let Some(pivot) = (0..3).rev().find(|&column| !row[column].is_zero()) else { continue };
            let row = row.clone().map(|number| number.checked_div(&row[pivot]).unwrap());
            for (_, other) in &mut basis {
                *other = minus_multiple(other, &other[pivot].clone(), &row);
            }
            basis.push((pivot, row));
        }
        let mut rows = BTreeSet::new();
        for (index, row) in self.rows.iter().enumerate() {
            let row = reduce(row, &basis);
            let is_zero = row.iter().all(Rational::is_zero);
            // `1 0 0` says nothing in an H-representation; it may lie hidden behind equations.
            let always = !self.is_v && row[1..].iter().all(Rational::is_zero) && row[0].is_positive();
            if !self.linear.contains(&index) && !is_zero && !always {
                rows.insert(scaled(&row));
            }
        }
        if self.is_v && !(rows.is_empty() && basis.is_empty()) && !rows.iter().any(|row| row[0] == "1") {
            // cdd leaves out the origin of a cone.
            rows.insert(["1", "0", "0"].map(ToOwned::to_owned).to_vec());
        }
        Canonical { linear: basis.iter().map(|(_, row)| scaled(row)).collect(), rows }
    }
}

/// Runs a program on a text; what it prints.
fn run(program: &str, arguments: &[&str], input: &str) -> String {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let started = command.spawn();
    let mut child = started.unwrap_or_else(|error| {
        panic!("{program} does not start: {error} (Debian: apt-get install lrslib libcdd-tools)")
    });
    // Shorter than a pipe's buffer. A program that refuses it may be gone already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let mut output = String::new();
    child.stdout.take().unwrap().read_to_string(&mut output).unwrap();
    child.stderr.take().unwrap().read_to_string(&mut output).unwrap();
    child.wait().unwrap();
    output
}

fn lrs(input: &str) -> String {
    run("lrs", &[], input)
}

fn cdd(input: &str) -> String {
    run("cddexec_gmp", &["--rep"], input)
}

/// The half-planes of [`rational_system`] as an H-representation, in one of three ways to write numbers, for us and for
/// the programs, which read no decimals.
fn half_planes(rng: &mut ChaCha8Rng) -> (&'static str, String, String) {
    let system = rational_system(rng);
    let style = ["integer", "rational", "real"][rng.random_range(0..3)];
    let mut rows = String::new();
    let mut for_programs = String::new();
    let mut linear = Vec::new();
    for (index, row) in system.inequalities().iter().enumerate() {
        let numbers = [row.b.clone(), -&row.a[0], -&row.a[1]];
        let common = numbers.iter().fold(1.into(), |common, number| number.denominator().lcm(&common));
        let whole = numbers.each_ref().map(|number| number * Rational::from(&common));
        let tenth = Rational::ratio(1, 10);
        for number in 0..3 {
            let (ours, theirs) = match style {
                "integer" => (whole[number].to_string(), whole[number].to_string()),
                "rational" => (numbers[number].to_string(), numbers[number].to_string()),
                _ => (format!("{}e-1", whole[number]), (&whole[number] * &tenth).to_string()),
            };
            write!(rows, "{ours} ").unwrap();
            write!(for_programs, "{theirs} ").unwrap();
        }
        rows.push('\n');
        for_programs.push('\n');
        if rng.random_bool(0.08) {
            linear.push(index + 1);
        }
    }
    let listed: String = linear.iter().map(|row| format!(" {row}")).collect();
    let linearity =
        if linear.is_empty() { String::new() } else { format!("linearity {}{listed}\n", linear.len()) };
    let text = |kind: &str, rows: &str| {
        format!("H-representation\n{linearity}begin\n{} 3 {kind}\n{rows}end\n", system.len())
    };
    let their_kind = if style == "real" { "rational" } else { style };
    (style, text(style, &rows), text(their_kind, &for_programs))
}

/// The generators of [`generator_rows`] as a V-representation, homogeneous or with fractions.
fn generators(rng: &mut ChaCha8Rng) -> (&'static str, String) {
    let rows = generator_rows(rng);
    let homogeneous = rng.random_bool(0.3);
    let mut text = String::new();
    for row in &rows {
        let [w, x, y] = row.numbers;
        match w {
            0 | 1 => writeln!(text, "{w} {x} {y}").unwrap(),
            _ if homogeneous => writeln!(text, "{w} {x} {y}").unwrap(),
            _ => writeln!(text, "1 {x}/{w} {y}/{w}").unwrap(),
        }
    }
    let linear: Vec<String> = (1..)
        .zip(&rows)
        .filter(|(_, row)| row.linear)
        .map(|(index, _): (usize, _)| index.to_string())
        .collect();
    let linearity = if linear.is_empty() {
        String::new()
    } else {
        format!("linearity {} {}\n", linear.len(), linear.join(" "))
    };
    let style = if homogeneous { "homogeneous" } else { "fractions" };
    (style, format!("V-representation\n{linearity}begin\n{} 3 rational\n{text}end\n", rows.len()))
}

fn ours(text: &str) -> Polyhedron {
    let source = Source::new("generated", Cursor::new(text.to_owned()));
    let file =
        read_half_planes(source, &TableOptions::default()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    Polyhedron::intersect(file.system)
}

/// The answer of a program about a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Same,
    SaysEmpty,
    RefusesNoRows,
}

/// Compares a program's answer with our other representation of the same set.
fn compare(program: &str, input: &str, output: &str, expected: &str, is_empty: bool) -> Outcome {
    if input.contains("\n0 3 ")
        && ["no input given", "V-representation is empty"].iter().any(|refusal| output.contains(refusal))
    {
        return Outcome::RefusesNoRows;
    }
    let found = read(output);
    if is_empty {
        let says_so = output.contains("No feasible solution")
            || found.as_ref().is_some_and(|matrix| matrix.is_v && matrix.rows.is_empty());
        assert!(says_so, "{program} finds a point:\n{input}\n{output}");
        return Outcome::SaysEmpty;
    }
    let found = found.unwrap_or_else(|| panic!("{program} has no answer:\n{input}\n{output}"));
    let expected_matrix = read(expected).unwrap();
    assert_eq!(found.is_v, expected_matrix.is_v, "{program}:\n{input}\n{output}");
    let difference = format!("{program}:\n{input}\n{output}\nours:\n{expected}");
    assert_eq!(found.canonical(), expected_matrix.canonical(), "{difference}");
    // The output of the program reads as the same set.
    let again = ours(output);
    let same = [h_representation, v_representation].map(|write| read(&write(&again)).unwrap().canonical());
    let set = ours(expected);
    let own = [h_representation, v_representation].map(|write| read(&write(&set)).unwrap().canonical());
    assert_eq!(same, own, "{difference}");
    Outcome::Same
}

type Counts = BTreeMap<(&'static str, &'static str, &'static str, &'static str, Outcome), usize>;

/// One set through both programs, both ways.
fn check(style: &'static str, text: &str, for_programs: &str) -> Counts {
    let polyhedron = ours(text);
    let (kind, is_empty) = (polyhedron.region().kind().name(), polyhedron.region().is_empty());
    let (h, v) = (h_representation(&polyhedron), v_representation(&polyhedron));
    let other = if text.starts_with("V-") { &h } else { &v };
    let mut counts = Counts::new();
    for (name, program) in [("lrs", lrs as fn(&str) -> String), ("cdd", cdd)] {
        for (way, input, expected) in
            [("as generated", for_programs, other), ("our H", &*h, &v), ("our V", &*v, &h)]
        {
            let outcome = compare(name, input, &program(input), expected, is_empty);
            let style = if way == "as generated" { style } else { "" };
            *counts.entry((name, way, style, kind, outcome)).or_default() += 1;
        }
    }
    counts
}

#[test]
fn lrs_and_cddlib_find_the_same_sets() {
    let mut rng = seeded(701);
    let mut cases: Vec<(&'static str, String, String)> = (0..CASES).map(|_| half_planes(&mut rng)).collect();
    cases.extend((0..CASES).map(|_| generators(&mut rng)).map(|(style, text)| (style, text.clone(), text)));
    let counts = cases.par_iter().map(|(style, text, for_programs)| check(style, text, for_programs)).reduce(
        Counts::new,
        |mut all, some| {
            some.into_iter().for_each(|(key, count)| *all.entry(key).or_default() += count);
            all
        },
    );
    for ((program, way, style, kind, outcome), count) in &counts {
        println!("{program} {way:12} {style:11} {kind:17} {outcome:?} {count}");
    }
    let refused = counts.keys().filter(|(.., outcome)| *outcome == Outcome::RefusesNoRows);
    // Nothing but matrices without rows is refused.
    let kinds: BTreeSet<&str> = refused.map(|(_, _, _, kind, _)| *kind).collect();
    assert!(kinds.is_subset(&["empty", "plane"].into()), "{kinds:?}");
    for program in ["lrs", "cdd"] {
        for kind in boundfit_geometry::RegionKind::ALL.map(boundfit_geometry::RegionKind::name) {
            let of_kind = |way: &str| -> usize {
                let these =
                    counts.iter().filter(|((p, w, _, k, _), _)| *p == program && *w == way && *k == kind);
                these.map(|(_, count)| count).sum()
            };
            assert!(of_kind("as generated") >= 20, "{program} {kind}");
        }
        let all = counts.iter().filter(|((p, w, ..), _)| *p == program && *w == "as generated");
        assert_eq!(all.map(|(_, count)| count).sum::<usize>(), 2 * CASES);
    }
}
