//! Theorems that rows are read from bytes. The reader is run on changed bytes, rows and columns, and of what it accepts a reader
//! of this file says that it is true.

use std::collections::BTreeMap;

use boundfit_estimation::{EpsilonColumn, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Header, TableOptions};
use boundfit_report::{Theory, kernel_fit};
use boundfit_tests::generate::seeded;
use boundfit_tests::proofs::{Question, generated};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::claim::changed;
use crate::coq::compiled;

/// The text between two others.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    Some(text.split_once(start)?.1.split_once(end)?.0)
}

fn pieces(text: &str) -> String {
    text.replace("\";\n\"", "")
}

/// The statement about the bytes of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Reads {
    data: String,
    delimiter: String,
    header: bool,
    ranges: Vec<[usize; 2]>,
    columns: Vec<usize>,
    rows: Vec<Vec<String>>,
}

impl Reads {
    /// `None` if the theorem says nothing about bytes.
    fn of(text: &str) -> Option<Self> {
        let says = between(text, "  same_rows (rows_of Byte.", "%nat data) rows.\n")?;
        let (words, columns) = says.split_once("]%Z [").unwrap();
        let (words, ranges) = words.split_once(" [").unwrap();
        let (delimiter, header) = words.split_once(' ').unwrap();
        let number = |own: &str| own.trim_matches(['(', ')', ']']).parse::<usize>().unwrap();
        let range = |own: &str| own.split_once(", ").map(|(a, b)| [number(a), number(b)]).unwrap();
        let rows = pieces(between(text, "Definition rows : list row := read [\"", "\"]%text.\n").unwrap());
        Some(Reads {
            data: pieces(between(text, "Definition data : list text := [\"", "\"]%text.\n").unwrap()),
            delimiter: delimiter.to_owned(),
            header: header == "true",
            ranges: ranges.split("; ").map(range).collect(),
            columns: columns.split("; ").map(number).collect(),
            rows: rows.lines().map(|line| line.split(',').map(ToOwned::to_owned).collect()).collect(),
        })
    }

    /// A computation by the reader, which prints whether it accepts.
    fn computation(&self) -> String {
        let ranges: Vec<String> = self.ranges.iter().map(|[a, b]| format!("({a}, {b})")).collect();
        let columns: Vec<String> = self.columns.iter().map(ToString::to_string).collect();
        let rows: String = self.rows.iter().map(|row| row.join(",") + "\n").collect();
        format!(
            "Eval vm_compute in test_rows (rows_of Byte.{} {} [{}]%Z [{}]%nat [\"{}\"]%text) (read [\"{rows}\"]%text).\n",
            self.delimiter,
            self.header,
            ranges.join("; "),
            columns.join("; "),
            self.data.replace('"', "\"\""),
        )
    }

    fn is_true(&self) -> bool {
        let delimiter = match self.delimiter.as_str() {
            "x2c" => ',',
            "x3b" => ';',
            "x09" => '\t',
            own => panic!("{own}"),
        };
        let (whole, rest) = self.data.rsplit_once('\n').unwrap_or(("", &self.data));
        let ended = whole.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line));
        let mut lines: Vec<&str> = ended.chain([rest]).filter(|line| !line.is_empty()).collect();
        if self.header && !lines.is_empty() {
            lines.remove(0);
        }
        let number = |text: &str| match text {
            "" => Some(None),
            text => Reading::Decimal.read(text, &Limits::default()).ok().map(Some),
        };
        let mut found = Vec::new();
        for (index, line) in lines.iter().enumerate() {
            if self.ranges.iter().any(|[from, to]| (*from..=*to).contains(&(index + 1))) {
                let cells: Vec<&str> = line.split(delimiter).collect();
                let cell = |&column: &usize| match column {
                    0 => Some(None),
                    own => number(cells.get(own - 1)?),
                };
                let Some(row) = self.columns.iter().map(cell).collect::<Option<Vec<Option<Rational>>>>()
                else {
                    return false;
                };
                found.push(row);
            }
        }
        let rows: Vec<Vec<_>> =
            self.rows.iter().map(|row| row.iter().map(|cell| number(cell).unwrap()).collect()).collect();
        !self.data.contains('"') && found == rows
    }
}

/// The theorem about a fit, with the bytes of its data.
fn theorem(question: &Question) -> String {
    let problem = question.problem().unwrap();
    let (data, reading) = (Some(&question.data[..]), question.options.reading);
    kernel_fit(&problem, &fit(&problem), reading, data, Theory::Installed).unwrap()
}

/// Plain text in its forms.
fn plain() -> Vec<Question> {
    let line = |name: &str, data: &str| Question::line(name, data.as_bytes(), ["x", "y"], "1/2");
    let bounds = |lower: Option<&str>, upper: Option<&str>| {
        let column = |own: &str| ColumnSelector::name_or_number(own);
        EpsilonColumn::Interval { lower: lower.map(column), upper: upper.map(column) }
    };
    let text =
        "x,y,e,lo,up,day\n1,2,1,1.5,2.5,Mon\n2,3.10,1/2,,3.5,Tue\n+3,39e-1,0.25,3,,Wed\n4,5.,1,-4,6,Thu\n";
    let numbers = Question::line("no header", b"1;2\n2;3.1\n3;3.9\n", ["1", "2"], "1");
    let numbers = Question { options: TableOptions { header: Header::Absent, ..numbers.options }, ..numbers };
    vec![
        line("text", text),
        line("rows", text).rows(2, 4),
        line("bounds of their own", text).epsilon_column("e"),
        line("intervals", text).within(bounds(Some("lo"), Some("up"))),
        line("only upper bounds", text).rows(1, 2).within(bounds(None, Some("up"))),
        line("two regressors", text).regressors(["x", "e"]),
        line("carriage returns", &text.replace('\n', "\r\n")),
        line("semicolons", &text.replace(',', ";")),
        line("tabulators", &text.replace(',', "\t")),
        line("blank lines", &text.replace('\n', "\n\n")),
        line("no last line feed", text.trim_end()),
        line("empty", "x,y\n0,0\n0,3\n"),
        line("carriage returns after numbers", "x,y\r\n1,2\r\n2,3.1\r\n3,3.9"),
        numbers,
    ]
}

fn forged(rng: &mut ChaCha8Rng, truth: &Reads) -> Reads {
    let mut forged = truth.clone();
    let place = rng.random_range(0..forged.data.len());
    let byte = char::from(b"0123456789+-./,;\n\r\t x\""[rng.random_range(0..22)]);
    match rng.random_range(0..10) {
        0..=2 => forged.data.replace_range(place..=place, &byte.to_string()),
        3 => forged.data.insert(place, byte),
        4 => drop(forged.data.remove(place)),
        5 | 6 => {
            let row = rng.random_range(0..forged.rows.len());
            let cell = rng.random_range(0..forged.rows[row].len());
            changed(rng, &mut forged.rows[row][cell]);
        }
        7 => {
            let (one, other) =
                (rng.random_range(0..forged.rows.len()), rng.random_range(0..forged.rows.len()));
            if rng.random_bool(0.5) { forged.rows.swap(one, other) } else { drop(forged.rows.remove(one)) }
        }
        8 => {
            let column = rng.random_range(0..forged.columns.len());
            forged.columns[column] = rng.random_range(0..7);
        }
        _ if rng.random_bool(0.5) => forged.header = !forged.header,
        _ => {
            let range = rng.random_range(0..forged.ranges.len());
            forged.ranges[range][rng.random_range(0..2)] = rng.random_range(0..6);
        }
    }
    forged
}

#[test]
fn rows_are_read_from_bytes_and_from_no_others() {
    let mut rng = seeded(3107);
    let mut read: Vec<(String, Reads)> = plain()
        .iter()
        .map(|own| (own.name.clone(), Reads::of(&theorem(own)).unwrap_or_else(|| panic!("{}", own.name))))
        .collect();
    while read.len() < 40 {
        let question = generated(&mut rng);
        if question.problem().is_ok() && question.data.len() < 1500 {
            read.extend(Reads::of(&theorem(&question)).map(|own| (question.name, own)));
        }
    }
    let mut cases = Vec::new();
    for (name, truth) in &read {
        assert!(truth.is_true(), "{name}: {truth:?}");
        cases.push((name, truth.clone(), true));
        let forgeries = std::iter::repeat_with(|| forged(&mut rng, truth)).filter(|own| own != truth);
        cases.extend(forgeries.take(25).map(|own| (name, own, false)));
    }
    let imports = "From Coq Require Import Init.Byte ZArith QArith List.\nFrom Boundfit Require Import Reader Bytes.\n\
                   Import ListNotations.\nOpen Scope Q_scope.\n";
    let text: String = cases.iter().map(|(_, case, _)| case.computation()).collect();
    let output = compiled("forged_bytes", &format!("{imports}{text}")).unwrap();
    let verdicts: Vec<&str> = output.lines().filter_map(|line| line.trim().strip_prefix("= ")).collect();
    assert_eq!(verdicts.len(), cases.len());
    let mut counts = BTreeMap::<_, usize>::new();
    for ((name, case, is_original), verdict) in cases.iter().zip(verdicts) {
        let is_accepted = verdict == "true";
        assert!(is_accepted || !is_original, "refused, and true ({name}): {case:?}");
        assert!(!is_accepted || case.is_true(), "accepted, and false ({name}): {case:?}");
        *counts.entry((is_original, is_accepted)).or_default() += 1;
    }
    println!("bytes, by (true theorem, accepted): {counts:?}");
    assert!(counts[&(&false, false)] > 700 && counts[&(&false, true)] > 20, "{counts:?}");
}

#[test]
fn whole_files_with_changed_bytes_or_rows_are_refused() {
    let text = theorem(&plain()[6]);
    assert!(compiled("bytes", &text).is_ok(), "{:?}", compiled("bytes", &text));
    let [rows, data] = ["Definition rows", "Definition data"].map(|own| text.find(own).unwrap());
    for (from, old, new) in
        [(rows, "2,3.1\n", "2,3.2\n"), (data, "2,3.10,", "2,3.11,"), (data, "\r\n4,", "\n\n5,")]
    {
        let (before, after) = text.split_at(from);
        assert!(after.contains(old), "{after}");
        let changed = format!("{before}{}", after.replacen(old, new, 1));
        let refusal = compiled("bytes_changed", &changed).unwrap_err();
        assert!(refusal.contains("has type") || refusal.contains("Unable to unify"), "{refusal}");
    }
}
