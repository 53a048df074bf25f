//! The estimate of the work on long numbers, made before the work: the refusals, the questions that are never
//! refused, and the option in the message, which raises the limit.

use std::fmt::Write;

use boundfit_tests::cli::refusals::check_refusal;
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, printed};
use boundfit_tests::hostile::{LIMITS, run_limited};
use boundfit_tests::program::Run;

/// A table of powers of ten that are far apart: 14 characters and 20,000 digits a row.
fn far_apart(rows: usize) -> String {
    let exponent = |row: usize| (row * 7_919) % 20_000;
    (0..rows).fold("x,y\n".to_owned(), |mut table, row| {
        let (x, y) = (exponent(row) as i64 - 10_000, exponent(3 * row + 1) as i64 - 10_000);
        let _ = writeln!(table, "{}e{x},{}e{y}", row % 9 + 1, (row + 4) % 9 + 1);
        table
    })
}

/// A table of fractions with denominators that differ.
fn fractions(rows: usize) -> String {
    (0..rows).fold("x,y\n".to_owned(), |mut table, row| {
        let denominator = |k: usize| 500_000 + (row * 104_729 + k * 15_485_863) % 499_979;
        let _ = writeln!(table, "{}/{},{}/{}", row + 1, denominator(0), 3 * row + 2, denominator(1));
        table
    })
}

const COMMANDS: [&str; 9] = [
    "fit data.csv --x x --y y --eps 1",
    "fit data.csv --x x --y y --eps 1 --format csv",
    "fit data.csv --x x --y y --eps 1 --by x",
    "fit data.csv --x x --y y --eps 2*min",
    "fit data.csv --x x --y y --eps 1 --sweep 0..2",
    "reduce data.csv --x x --y y",
    "check data.csv --x x --y y --eps 1",
    "plot data.csv --x x --y y --eps 1 --figure all -o figures",
    "lesson data.csv --x x --y y --eps 1",
];

#[test]
fn powers_of_ten_far_apart_are_refused_where_they_pass_the_limit() {
    let directory = directory_with(&[("data.csv", far_apart(5_000).as_bytes())]);
    for line in COMMANDS {
        let run = boundfit(directory.path(), line);
        let place = "error: data.csv: line ";
        assert!(run.status == 1 && run.stderr.starts_with(place), "{line}: {run:?}");
        let problem = "refused: exact arithmetic on ";
        let limit = " products of machine words, more than 400000000 (the limit); --limit work=N raises it\n";
        assert!(run.stderr.contains(problem) && run.stderr.ends_with(limit), "{line}: {run:?}");
    }
}

#[test]
fn a_long_bound_counts_in_every_row() {
    let directory = directory_with(&[("data.csv", far_apart(15).as_bytes())]);
    let line = "fit data.csv --x x --y y --eps 1e9999 --no-lp --format csv";
    let run = boundfit(directory.path(), line);
    let start = "error: data.csv: refused: exact arithmetic on 15 rows of up to ";
    assert!(run.status == 1 && run.stderr.starts_with(start), "{run:?}");
    assert!(run.stderr.ends_with(" (the limit); --limit work=N raises it\n"), "{run:?}");
    for line in [
        &format!("{line} --limit work=100000000000"),
        "fit data.csv --x x --y y --eps 1e400 --no-lp --format csv",
    ] {
        let run = boundfit(directory.path(), line);
        assert!([0, 3].contains(&run.status), "{line}: {run:?}");
    }
}

/// Programs of LPs have the bound in each row, and the least bound may have all digits of a condition.
#[test]
fn a_long_bound_is_written_in_every_row() {
    let same = format!("x,y\n1,2\n2,3\n{}", "1,1\n".repeat(16_384));
    let directory = directory_with(&[("data.csv", same.as_bytes())]);
    let line = |bound: &str| {
        format!("convert data.csv --x x --y y --to lp --objective theta1-max -o made.lp {bound}")
    };
    let (nines, sevens) = ("9".repeat(250), "7".repeat(250));
    for bound in [
        format!("--eps {nines}/{sevens}1"),
        format!("--eps 1*min --where 3*theta1-2*theta2<=-{sevens}/{nines}1"),
        "--eps 1*min --where 3*theta1-2*theta2<=-4e-10000".to_owned(),
    ] {
        let run = boundfit(directory.path(), &line(&bound));
        let start = "error: data.csv: refused: exact arithmetic on ";
        assert!(run.status == 1 && run.stderr.starts_with(start), "{bound}: {run:?}");
        assert!(run.stderr.contains("6 rows of up to "), "{bound}: {run:?}");
    }
    for bound in ["--eps 1e-200", "--eps 1/3"] {
        let words: Vec<_> = line(bound).split(' ').map(str::to_owned).collect();
        let ended = run_limited(directory.path(), &words, LIMITS);
        assert_eq!(ended.status, Some(0), "{bound}: {ended:?}");
    }
}

#[test]
fn many_different_denominators_are_refused_and_few_in_many_rows_are_not() {
    let directory = directory_with(&[("data.csv", fractions(20_000).as_bytes())]);
    let line = "fit data.csv --x x --y y --eps 1000000 --no-lp --format csv";
    let run = boundfit(directory.path(), line);
    assert!(
        run.status == 1 && run.stderr.contains(": refused: exact arithmetic on fractions with "),
        "{run:?}"
    );
    assert!(run.stderr.ends_with(" (the limit); --limit work=N raises it\n"), "{run:?}");
    let inches = (0..20_000)
        .fold("x,y\n".to_owned(), |table, row| table + &format!("{row},{}/{}\n", row, 1 + row % 64));
    let directory = directory_with(&[("data.csv", inches.as_bytes())]);
    printed(directory.path(), "fit data.csv --x x --y y --eps 1000000 --no-lp --limit work=0");
}

#[test]
fn numbers_of_usual_length_need_no_work() {
    let wide: String =
        (1..500).map(|row| format!("{row}.{},-{}e-300\n", "7".repeat(200), row * row)).collect();
    let directory = directory_with(&[("data.csv", format!("x,y\n{wide}").as_bytes())]);
    for line in [COMMANDS[0], COMMANDS[1], COMMANDS[5]] {
        printed(directory.path(), &format!("{line} --limit work=0"));
    }
}

#[test]
fn half_planes_models_and_claims_count_too() {
    let rows = |line: &str, count: usize| line.repeat(count);
    let ine = format!("begin\n300 3 rational\n{}end\n", rows("1e9000 1e-8000 7e-9000\n", 300));
    let lp = format!("min x + y\nst\n{}end\n", rows("1e9000 x + 7e-8000 y >= 1\n", 300));
    let claims = format!("{{\"pui\": [{}1]}}", rows("1e9000,", 400));
    let directory = directory_with(&[
        ("data.ine", ine.as_bytes()),
        ("data.csv", b"x,y\n1,2\n2,3\n3,5\n"),
        ("model.lp", lp.as_bytes()),
        ("short.lp", b"min x + y\nst\n x + y >= 1\n x - y >= 1\nend\n"),
        ("claims.json", claims.as_bytes()),
    ]);
    for (line, place) in [
        ("polygon data.ine", "data.ine: line "),
        ("judge model.lp", "model.lp: refused: exact arithmetic on "),
        (
            "judge short.lp --solution claims.json",
            "claims.json: refused: exact arithmetic on 400 numbers of up to 9001 digits",
        ),
        (
            "check data.csv --x x --y y --eps 1 --claim claims.json",
            "claims.json: refused: exact arithmetic on 400 numbers of up to 9001 digits",
        ),
    ] {
        let run = boundfit(directory.path(), line);
        assert!(run.status == 1 && run.stderr.starts_with(&format!("error: {place}")), "{line}: {run:?}");
        assert!(run.stderr.ends_with(" (the limit); --limit work=N raises it\n"), "{line}: {run:?}");
    }
}

/// Many short numbers are no long one, also where they become one constant.
#[test]
fn columns_that_are_fixed_may_be_many() {
    let columns: String = (1..=5000).map(|column| format!(" x{column} r {column}.5\n")).collect();
    let bounds: String = (1..=5000).map(|column| format!(" FX x{column} 1.25\n")).collect();
    let model = format!(
        "ROWS\n N c\n G r\nCOLUMNS\n u c 1 r 1\n v c 1 r 2\n{columns}RHS\n r 20000000\nBOUNDS\n{bounds}ENDATA\n"
    );
    let directory = directory_with(&[("model.mps", model.as_bytes())]);
    let run = boundfit(directory.path(), "judge model.mps --format json");
    assert_eq!(run.status, 0, "{run:?}");
    // 20,000,000 less 1.25 times the sum of 1.5 to 5000.5, half of it for the cheaper column.
    let constant = 1.25 * (5000.0 * 5001.0 / 2.0 + 2500.0);
    let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(report["objective"]["value"].as_f64(), Some((20_000_000.0 - constant) / 2.0));
}

/// A word of the limit that is none.
#[test]
fn the_limit_is_a_number() {
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n")]);
    let line = "fit data.csv --x x --y y --eps 1 --limit work=lots";
    check_refusal(
        &boundfit(directory.path(), line),
        line,
        2,
        "invalid value 'work=lots' for '--limit <NAME=N>': \"lots\" is no value of the limit work (expected an integer from 0)",
    );
}

/// Every command about long numbers that are just allowed or just refused ends in time.
#[cfg(target_os = "linux")]
#[test]
fn what_is_not_refused_is_done_in_time() {
    for table in [far_apart(3), far_apart(150), fractions(200)] {
        let directory = directory_with(&[("data.csv", table.as_bytes())]);
        for line in COMMANDS {
            for epsilon in ["1", "1e9999"] {
                let line = line.replace("--eps 1", &format!("--eps {epsilon}"));
                let ended = run_limited(directory.path(), &boundfit_tests::cli::words(&line), LIMITS);
                assert!(ended.is_well(), "{line}: {ended:?}\n{}", &table[..60]);
            }
        }
    }
}

/// A proof is a list of numbers that are written in full, and data are compared with them row by row.
#[test]
fn long_numbers_count_in_proofs_and_in_what_they_are_compared_with() {
    let directory = directory_with(&[("data.csv", far_apart(12).as_bytes())]);
    let all = "--limit work=100000000000";
    let fit = "fit data.csv --x x --y y --eps 1e9999 --no-lp --proof p.json";
    assert_eq!(boundfit(directory.path(), &format!("{fit} {all}")).status, 0);
    let limit = " products of machine words, more than 400000000 (the limit); --limit work=N raises it\n";
    let verify = "verify p.json data.csv";
    let run = boundfit(directory.path(), &format!("{verify} --limit work=10000000"));
    let start = "error: p.json: refused: exact arithmetic on ";
    let small_limit = limit.replace("400000000", "10000000");
    assert!(
        run.status == 1 && run.stderr.starts_with(start) && run.stderr.ends_with(&small_limit),
        "{}",
        run.stderr
    );
    assert_eq!(boundfit(directory.path(), verify).status, 0);
    // Data of long numbers beside a short proof: those that it is about have another hash, which is not waited for.
    let long = format!("x,y\n{}", "7e-9999,1e9999\n".repeat(2_000));
    std::fs::write(directory.path().join("few.csv"), "x,y\n1,2\n2,3\n").unwrap();
    std::fs::write(directory.path().join("data.csv"), long).unwrap();
    let fit = "fit few.csv --x x --y y --eps 1 --no-lp --proof q.json";
    assert_eq!(boundfit(directory.path(), fit).status, 0);
    let proof = std::fs::read_to_string(directory.path().join("q.json")).unwrap();
    let proof = proof.replacen("    1,\n    2\n", "    1,\n    2000\n", 1);
    std::fs::write(directory.path().join("q.json"), proof).unwrap();
    let run = boundfit(directory.path(), "verify q.json data.csv");
    let start = "error: data.csv: refused: exact arithmetic on ";
    assert!(
        run.status == 1 && run.stderr.starts_with(start) && run.stderr.ends_with(limit),
        "{}",
        run.stderr
    );
}

#[test]
fn ten_rows_of_powers_far_apart_are_answered() {
    let directory = directory_with(&[("data.csv", far_apart(10).as_bytes())]);
    for line in ["fit data.csv --x x --y y --eps 1e9999", "fit data.csv --x x --y y --eps 1"] {
        let ended = run_limited(directory.path(), &boundfit_tests::cli::words(line), LIMITS);
        assert!(matches!(ended.status, Some(0 | 3)), "{line}: {ended:?}");
    }
}

/// A table of 270 decimals of 900 places, which no fit finds too long.
fn many_places() -> String {
    (0..270).fold("x,y,u\n".to_owned(), |mut table, row: usize| {
        let _ = writeln!(table, "{row},{}e-{},1", row * 37 % 89 + 10, 900 - row);
        table
    })
}

#[test]
fn words_that_are_free_in_one_fit_count_where_it_is_done_for_each_reading_or_crossing() {
    let table = many_places();
    assert!(table.len() < 4_096);
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let question = "data.csv --x x --y y --eps 1";
    printed(directory.path(), &format!("fit {question} --no-lp"));
    for line in [
        format!("outliers {question}"),
        format!("outliers {question} --most 100"),
        format!("plot {question} --figure outliers -o a.svg"),
        format!("status {question} --proof p.json"),
        format!("fit {question} --x-eps 1/7"),
        format!("fit {question} --x-eps u --strong"),
    ] {
        let run = boundfit(directory.path(), &line);
        let place = "error: data.csv: refused: exact arithmetic on ";
        assert!(run.status == 1 && run.stderr.starts_with(place), "{line}: {run:?}");
        assert!(run.stderr.ends_with(" (the limit); --limit work=N raises it\n"), "{line}: {run:?}");
        assert!(!directory.path().join("p.json").exists() && !directory.path().join("a.svg").exists());
    }
    printed(directory.path(), &format!("status {question}"));
}

#[test]
fn a_long_bound_on_errors_in_x_counts_for_each_short_row() {
    // Each reading is on a hull.
    let rows = (0..300).fold("x,y\n".to_owned(), |table, row: usize| format!("{table}{row},{}\n", row * row));
    assert!(rows.len() < 4_096);
    let directory = directory_with(&[("data.csv", rows.as_bytes())]);
    let ends = format!("{}/1{}3", "7".repeat(900), "0".repeat(900));
    let run = boundfit(directory.path(), &format!("fit data.csv --x x --y y --eps 0 --x-eps {ends}"));
    assert!(run.status == 1 && run.stderr.contains("refused: exact arithmetic on 300 rows"), "{run:?}");
    printed(directory.path(), "fit data.csv --x x --y y --eps 50000 --x-eps 1/7 --format json");
}

/// A short proof may ask for as many comparisons as it has points and the data rows.
#[test]
fn statements_compared_with_many_rows_are_refused_where_they_pass_the_limit() {
    let rows: String = (0..20_000).map(|row| format!("{row},{row}\n")).collect();
    let directory = directory_with(&[("data.csv", format!("x,y\n{rows}").as_bytes())]);
    boundfit(directory.path(), "fit data.csv --x x --y y --eps 1 --proof p.json");
    let proof = std::fs::read_to_string(directory.path().join("p.json")).unwrap();
    let proof: serde_json::Value = serde_json::from_str(&proof).unwrap();
    let of = |statement: &dyn Fn(usize) -> serde_json::Value, count: usize| {
        let mut own = proof.clone();
        let fields = own.as_object_mut().unwrap();
        for name in ["vertices", "active", "sides", "farkas", "bounds"] {
            fields.remove(name);
        }
        own["schema"] = "boundfit/proof/2".into();
        own["statements"] = (0..count).map(statement).collect();
        own.to_string()
    };
    let point = |index: usize| serde_json::json!({"kind": "point", "point": ["1", format!("{index}/10000")]});
    let view = |index: usize| serde_json::json!({"kind": "point", "point": ["1", "0"], "factor": format!("{}/10000", index + 1)});
    let verify = |proof: String, limit: &str| {
        boundfit_with_input(directory.path(), &format!("verify - data.csv {limit}"), proof.as_bytes())
    };
    let refused = |run: &Run, parts: usize, limit: u64| {
        let start = format!(
            "error: data.csv: refused: {parts} points, rays and sets compared with each of 20000 rows and conditions take about "
        );
        let end =
            format!(" products of machine words, more than {limit} (the limit); --limit work=N raises it\n");
        assert!(run.status == 1 && run.stderr.starts_with(&start) && run.stderr.ends_with(&end), "{run:?}");
    };
    refused(&verify(of(&point, 3_000), ""), 3_000, 400_000_000);
    refused(&verify(of(&view, 400), ""), 400, 400_000_000);
    let few = of(&point, 70);
    refused(&verify(few.clone(), "--limit work=1000"), 70, 1_000);
    assert_eq!(verify(few, "--limit work=10000000").status, 0);
    // A few take no longer than reading the rows.
    assert_eq!(verify(of(&point, 50), "--limit work=0").status, 0);
}
