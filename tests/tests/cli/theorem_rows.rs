//! `boundfit verify FILE.v DATA`: the rows of a theorem are those of the data, or the place where they are not.

use std::fs;

use boundfit_estimation::fit;
use boundfit_exact::{Limits, Reading};
use boundfit_report::{Theory, kernel_fit};
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with};
use boundfit_tests::generate::seeded;
use boundfit_tests::proofs::{Question, bounded, generated, questions};
use boundfit_verify::{DataLimits, Failure, Falsehood, Found, Proof, Statement, THEORIES};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use sha2::{Digest, Sha256};

const DATA: &str = "x,y,e,lo,up,w\n1,2,1,1.5,2.5,0\n2,3.1,1/2,NA,3.5,1\n3,3.9,0.25,3,,2\n4,5,1,4,6,1\n";

/// The theorem about a fit, without the theory.
fn theorem(question: &Question) -> Option<String> {
    let problem = question.problem().ok()?;
    kernel_fit(&problem, &fit(&problem), question.options.reading, Some(&question.data), Theory::Installed)
}

fn verified(text: &str, data: &[u8]) -> Result<Statement, Failure> {
    let proof = Proof::read(text.as_bytes(), &Limits::default()).unwrap();
    proof.verify(|| Ok(data), &DataLimits::default())
}

/// The text between the quotes of the rows, and the places around it.
fn rows(text: &str) -> [&str; 3] {
    let start = text.find("Definition rows : list row := read [\"").unwrap() + 37;
    let end = start + text[start..].find("\"]%text").unwrap();
    [&text[..start], &text[start..end], &text[end..]]
}

/// The theorem with its rows changed: a number, or a row dropped, repeated or exchanged with another one.
fn forged(rng: &mut ChaCha8Rng, text: &str) -> String {
    let [before, rows, after] = rows(text);
    let joined = rows.replace("\";\n\"", "");
    let mut lines: Vec<String> = joined.lines().map(ToOwned::to_owned).collect();
    let (one, other) = (rng.random_range(0..lines.len()), rng.random_range(0..lines.len()));
    match rng.random_range(0..6) {
        0 => drop(lines.remove(one)),
        1 => lines.insert(other, lines[one].clone()),
        2 => lines.swap(one, other),
        _ => {
            let mut cells: Vec<String> = lines[one].split(',').map(ToOwned::to_owned).collect();
            let cell = rng.random_range(0..cells.len());
            cells[cell] = match rng.random_range(0..3) {
                0 => "7/3".to_owned(),
                1 if cells[cell].starts_with('-') => cells[cell][1..].to_owned(),
                1 => format!("-{}", cells[cell]),
                _ => "0".to_owned(),
            };
            lines[one] = cells.join(",");
        }
    }
    format!("{before}{}{after}", lines.into_iter().map(|line| line + "\n").collect::<String>())
}

/// The cells as numbers.
fn numbers(text: &str) -> Vec<String> {
    let cell = |cell: &str| match Reading::Decimal.read(cell, &Limits::default()) {
        Ok(number) => number.to_string(),
        Err(_) => format!("?{cell}"),
    };
    rows(text)[1]
        .replace("\";\n\"", "")
        .lines()
        .map(|line| line.split(',').map(cell).collect::<Vec<_>>().join(","))
        .collect()
}

#[test]
fn rows_of_every_theorem_agree_and_of_no_forgery() {
    let mut rng = seeded(3104);
    let more: Vec<Question> = std::iter::repeat_with(|| generated(&mut rng)).take(60).collect();
    let (mut agree, mut refused) = (0, 0);
    for question in questions().into_iter().chain(bounded()).chain(more) {
        let Some(text) = theorem(&question) else { continue };
        let count = numbers(&text).len();
        let statement =
            verified(&text, &question.data).unwrap_or_else(|error| panic!("{}: {error}", question.name));
        assert_eq!(statement.found, Found::Rows(count), "{}", question.name);
        agree += 1;
        for _ in 0..10 {
            let forgery = forged(&mut rng, &text);
            // Another spelling of the same numbers is no forgery.
            if numbers(&forgery) == numbers(&text) {
                continue;
            }
            let is_refused = match Proof::read(forgery.as_bytes(), &Limits::default()) {
                Err(_) => true,
                Ok(proof) => matches!(
                    proof.verify(|| Ok(&question.data[..]), &DataLimits::default()),
                    Err(Failure::False(Falsehood::OtherNumber(_) | Falsehood::OtherCount { .. }))
                ),
            };
            assert!(is_refused, "{}: {}", question.name, rows(&forgery)[1]);
            refused += 1;
        }
    }
    assert!(agree > 120 && refused > 700, "{agree} {refused}");
}

#[test]
fn what_agrees_and_where_it_does_not_is_said_in_a_line() {
    let directory = directory_with(&[("a.csv", DATA.as_bytes())]);
    let run = boundfit(
        directory.path(),
        "fit a.csv --x x --y y --eps 0.2 --rows 2..4 --where theta1<=3 --proof a.v",
    );
    assert_eq!(run.status, 0, "{run:?}");
    let run =
        boundfit(directory.path(), "verify a.v a.csv --x x --y y --eps 0.2 --rows 2..4 --where theta1<=3");
    assert_eq!(run.status, 0, "{run:?}");
    assert!(
        run.stdout.starts_with("verified: a.v is about a.csv\n  model   y = theta1*x + theta2 + e\n"),
        "{}",
        run.stdout
    );
    let last = "  agrees  3 rows and all conditions of the theorem, exactly\n          only coqc checks what the theorem concludes\n";
    assert!(run.stdout.ends_with(last), "{}", run.stdout);
    let other = boundfit(directory.path(), "verify a.v a.csv --x x --y y --eps 0.3");
    assert_eq!(other.status, 4, "{other:?}");
    let json = boundfit(directory.path(), "verify a.v a.csv --format json").stdout;
    assert!(json.contains("\"theorem_rows\": 3"), "{json}");

    let text = fs::read_to_string(directory.path().join("a.v")).unwrap();
    let data = "Definition data : list text := [\"x,y,e,lo,up,w\n1,2,";
    let other = text.replace(data, &data.replace("1,2,", "1,3,"));
    let run = boundfit_with_input(directory.path(), "verify - a.csv", other.as_bytes());
    assert!(run.status == 1 && other != text, "{run:?}");
    let message = "the data in this theorem do not have the SHA-256 of its head";
    assert!(run.stderr.contains(message), "{run:?}");

    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        let run =
            boundfit_with_input(directory.path(), "verify - a.csv", text.replacen(from, to, 1).as_bytes());
        (run.status, format!("{}{}", run.stdout, run.stderr))
    };
    for (from, to, place) in [
        ("3,3.9\n", "3,3.8\n", "row 3, y: 19/5 in the theorem, 39/10 in the data"),
        ("3,3.9\n", "2.5,3.9\n", "row 3, x: 5/2 in the theorem, 3 in the data"),
        (":= (1 # 5).", ":= (1 # 4).", "row 2, eps: 1/4 in the theorem, 1/5 in the data"),
        ("4,5.0\n", "", "rows: 2 in the theorem, 3 in the data"),
        ("4,5.0\n", "4,5.0\n4,5.0\n", "rows: 4 in the theorem, 3 in the data"),
        ("2,3.1\n3,3.9\n", "3,3.9\n2,3.1\n", "row 2, x: 3 in the theorem, 2 in the data"),
        ("1,0,,3\n", "1,0,,4\n", "condition 1: is not that of the question"),
        ("\"rows\":[2,4]", "\"rows\":[1,3]", "row 1, x: 2 in the theorem, 1 in the data"),
        ("The data have", "No data have", "verified: "),
    ] {
        let (status, said) = changed(from, to);
        assert!(said.contains(place), "{from}: {said}");
        assert_eq!(status, if place == "verified: " { 0 } else { 4 }, "{from}: {said}");
    }
    for (from, to, problem) in [
        ("Definition rows :", "(* \"\nDefinition rows :", "the rows stand in a comment"),
        (
            "<= eps r",
            "<= 2 * eps r",
            "(expected what the rows say of p, as boundfit writes it of columns like these)",
        ),
        (
            "   The question: ",
            "   A question: ",
            "the comment at the head of this theorem has no line \"The question: {...}\", which says how",
        ),
        ("3,3.9\n", "3,3.9,1\n", ": \"3,3.9,1\" (expected a row of the numbers x, y)\n"),
        (
            "1,0,,3\n",
            "1,0,3\n",
            "1,0,3\" (expected the numbers a and b, and two bounds that may be missing)\n",
        ),
        (
            "Definition y (r : row) : Q := number 1 r.",
            "Definition y (r : row) : Q := number 0 r.",
            "what the rows say",
        ),
        (
            "Definition y (r : row) : Q := number 1 r.",
            "Definition y (r : row) : Q := 7.",
            "Q := 7.\" (expected \"Definition NAME (r : row) : Q := number N r.\")\n",
        ),
        ("*)", "", "the rows stand in a comment"),
    ] {
        let (status, said) = changed(from, to);
        assert!(status == 1 && said.contains(problem), "{from}: {said}");
    }
    let line = 1 + text.lines().position(|line| line == "3,3.9").unwrap();
    let (_, said) = changed("3,3.9\n", "3,3.9,1\n");
    assert!(said.contains(&format!("not a proof: line {line}: ")), "{said}");
    let (head, behind) = text.split_once("*)").unwrap();
    let run = boundfit_with_input(directory.path(), "verify - a.csv", head.as_bytes());
    assert!(run.status == 1 && run.stderr.contains("the comment at its head does not end\n"), "{run:?}");
    let run = boundfit_with_input(directory.path(), "verify - a.csv", behind.as_bytes());
    let problem =
        "not a proof: a theorem without its head: it does not begin with the comment in which boundfit";
    assert!(run.status == 1 && run.stderr.contains(problem), "{run:?}");
    let moved = DATA.replace("4,5,1,4,6,1\n", "4,5,1,4,6,1\n5,6,1,1,1,1\n");
    fs::write(directory.path().join("more.csv"), moved).unwrap();
    let run = boundfit(directory.path(), "verify a.v more.csv");
    assert!(run.status == 4 && run.stdout.contains("sha256: is not that of the data"), "{run:?}");
}

#[test]
fn half_planes_of_a_table_are_compared() {
    const PLANES: &str = "b;note;a2;a1\n0;x;0;-1\n\n1/2;y;-1;0\n6;z;3;2\n";
    let directory = directory_with(&[
        ("planes.csv", PLANES.as_bytes()),
        ("blanks.txt", b"-1 0 0\n0 -1 0\n2 3 6\n"),
        ("best.lp", b"max\nobj: 3 x + 2 y\nst\n c1: x + y <= 4\nend\n"),
    ]);
    let theorem = |line: &str| {
        let run = boundfit(directory.path(), &format!("{line} --proof a.v --force"));
        assert_eq!(run.status, 0, "{run:?}");
        fs::read_to_string(directory.path().join("a.v")).unwrap()
    };
    let verified = |text: &str, data: &str| {
        let run = boundfit_with_input(directory.path(), &format!("verify - {data}"), text.as_bytes());
        (run.status, run.stdout + &run.stderr)
    };
    let text = theorem("polygon planes.csv");
    let (status, said) = verified(&text, "planes.csv");
    assert_eq!(status, 0, "{said}");
    for line in
        ["  upper   column 1 (\"b\")\n", "  from    3 half-planes\n", "  agrees  3 rows and all conditions"]
    {
        assert!(said.contains(line), "{said}");
    }
    for (from, to, place) in [
        ("2,3,6.0\n", "2,3,6.1\n", "row 3, c: 61/10 in the theorem, 6 in the data"),
        ("2,3,6.0\n", "2,4,6.0\n", "row 3, b: 4 in the theorem, 3 in the data"),
        ("2,3,6.0\n", "1,3,6.0\n", "row 3, a: 1 in the theorem, 2 in the data"),
        ("2,3,6.0\n", "", "rows: 2 in the theorem, 3 in the data"),
        ("\"rows\":[1,3]", "\"rows\":[1,2]", "rows: 3 in the theorem, 2 in the data"),
        ("[null,1]", "[1,null]", "row 1, lower bound: "),
    ] {
        assert!(text.contains(from), "{from}: {text}");
        let (status, said) = verified(&text.replacen(from, to, 1), "planes.csv");
        assert!(status == 4 && said.contains(place), "{from}: {said}");
    }
    // The checker has no reader of other files.
    boundfit(directory.path(), "polygon planes.csv --format ine -o planes.ine");
    for (line, data) in [
        ("polygon blanks.txt", "blanks.txt"),
        ("polygon planes.ine", "planes.ine"),
        ("judge best.lp", "best.lp"),
    ] {
        let (status, said) = verified(&theorem(line), data);
        let problem = "the comment at the head of this theorem has no line \"The question: {...}\"";
        assert!(status == 1 && said.contains(problem), "{line}: {said}");
    }
}

#[test]
fn theorems_about_parts_of_the_rows_are_compared() {
    let directory = directory_with(&[("a.csv", DATA.as_bytes())]);
    for command in ["predict --at 5", "outliers", "range", "status"] {
        let line = format!(
            "{command} a.csv --x x --y y --eps 0.15 --rows 2..4 --where theta1<=3 --proof a.v --force"
        );
        let run = boundfit(directory.path(), &line);
        assert_eq!(run.status, 0, "{line}: {run:?}");
        let run = boundfit(
            directory.path(),
            "verify a.v a.csv --x x --y y --eps 0.15 --rows 2..4 --where theta1<=3",
        );
        assert_eq!(run.status, 0, "{line}: {run:?}");
        let text = fs::read_to_string(directory.path().join("a.v")).unwrap();
        let forged = text.replacen("3,3.9\n", "3,3.8\n", 1);
        let run = boundfit_with_input(directory.path(), "verify - a.csv", forged.as_bytes());
        let place = "row 3, y: 19/5 in the theorem, 39/10 in the data";
        assert!(run.status == 4 && run.stdout.contains(place), "{line}: {run:?}");
    }
}

#[test]
fn what_stands_before_the_rows_is_the_theory_of_this_version() {
    let directory = directory_with(&[("a.csv", DATA.as_bytes())]);
    let verified = |text: &str| {
        let run = boundfit_with_input(directory.path(), "verify - a.csv", text.as_bytes());
        (run.status, run.stdout + &run.stderr)
    };
    let kinds = ["fit", "status", "fit --proof-library", "status --proof-library"];
    for (kind, known) in kinds.into_iter().zip(THEORIES) {
        let line = format!("{kind} a.csv --x x --y y --eps 0.2 --proof a.v --force");
        assert_eq!(boundfit(directory.path(), &line).status, 0, "{line}");
        let text = fs::read_to_string(directory.path().join("a.v")).unwrap();
        let theory = text.split_once("*)\n").unwrap().1.split_once("\n(* Rows: ").unwrap().0;
        let hash: String = Sha256::digest(theory).iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(hash, known, "{kind}");
        assert_eq!(verified(&text).0, 0, "{kind}");
        // A definition that gives a name another meaning, wherever it stands, and a changed theory.
        let evil = "Definition Qabs (q : Q) : Q := Qabs.Qabs q * (2 # 3).\n";
        for (from, to) in [
            ("\nFrom ", format!("{evil}\nFrom ")),
            ("Open Scope Q_scope.\n", format!("Open Scope Q_scope.\n{evil}")),
            ("Definition rows ", format!("{evil}Definition rows ")),
            ("(* Rows: ", format!("(* Rows: *) {evil}(* ")),
            ("(* Rows: ", format!("(* Rows: *) {evil}(* Rows: ")),
            ("(* What is proved", format!("(* What *) {evil}(* What is proved")),
            ("(* What is proved", format!("{evil}(* What is proved")),
            ("Require", "Require  ".to_owned()),
        ] {
            let forged = text.replacen(from, &to, 1);
            let (status, said) = verified(&forged);
            assert!(status == 1 && forged != text, "{kind}, {from:?}: {said}");
        }
        let (_, said) = verified(&text.replacen("Require", "Require ", 1));
        assert!(said.contains("is not the theory of this version of boundfit. "), "{said}");
        let (status, said) = verified(&text.replace('\n', "\r\n"));
        assert!(status == 1 && said.contains("its lines end with a carriage return"), "{said}");
    }
}
