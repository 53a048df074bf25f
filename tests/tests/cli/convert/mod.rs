//! `boundfit convert`: the programs of a fit as files, read back exactly.

mod reader;

use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::time::Duration;

use boundfit_check::{ProgramRows, exchange_rows};
use boundfit_estimation::{
    BoundName, Columns, Condition, EpsilonColumn, LineForm, Measurements, Problem, fit,
};
use boundfit_exact::{Endpoint, Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, RowRange, Source, TableOptions};
use boundfit_lp::{ExactOutcome, ExchangeFormat, Program, PuiEnd, Row, exact_simplex};
use boundfit_tests::cli::directory_with;
#[cfg(unix)]
use boundfit_tests::hostile::{Cost, run_limited};
use boundfit_tests::lp_cases::{hard_cases, number, ten_to};
use boundfit_tests::program::{Run, root, run};
use boundfit_tests::readings::{line, problem, with_error_bound};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use reader::{ReadProgram, read_lp, read_mps};

fn boundfit(line: &str) -> Run {
    let mut words: Vec<&str> = Vec::new();
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 { words.push(part) } else { words.extend(part.split_whitespace()) }
    }
    run(&words)
}

/// A fit on the command line, with the same one read by the library.
struct Case {
    line: String,
    problem: Problem,
}

fn case(
    file: &str,
    x: &str,
    y: &str,
    epsilon: &str,
    rows: Option<(usize, usize)>,
    more: &[(&str, &str)],
) -> Case {
    let option =
        |name: &str| more.iter().filter(|(key, _)| *key == name).map(|(_, value)| *value).collect::<Vec<_>>();
    let reading = if option("--reading").is_empty() { Reading::Decimal } else { Reading::Binary64 };
    let mut regressors = x.split(',').map(ColumnSelector::name_or_number);
    let columns = Columns {
        first: regressors.next().unwrap(),
        second: regressors.next(),
        response: Some(ColumnSelector::name_or_number(y)),
        epsilon: match epsilon.strip_prefix("column ") {
            Some(name) => EpsilonColumn::Column(ColumnSelector::name_or_number(name)),
            None => EpsilonColumn::Uniform(reading.read(epsilon, &Limits::default()).unwrap()),
        },
        form: LineForm::default(),
    };
    let range = rows.and_then(|(first, last)| RowRange::new(first, last));
    let options = TableOptions { rows: range.into(), reading, ..TableOptions::default() };
    let source = Source::open(&root().join(file).to_string_lossy()).unwrap();
    let measurements = Measurements::read(source, &columns, &options).unwrap();
    let condition = |text: &&str| Condition::parse(text, reading, &Limits::default()).unwrap();
    let conditions = option("--where").iter().map(condition).collect();
    let bound = match epsilon.strip_prefix("column ") {
        Some(name) => format!("--eps-column {name}"),
        None => format!("--eps {epsilon}"),
    };
    let rows = rows.map(|(first, last)| format!(" --rows {first}..{last}")).unwrap_or_default();
    let more: String = more.iter().map(|(key, value)| format!(" {key} '{value}'")).collect();
    Case {
        line: format!("{file} --x {x} --y {y} {bound}{rows}{more}"),
        problem: Problem { measurements, conditions },
    }
}

fn cases() -> Vec<Case> {
    let binary64 = ("--reading", "binary64");
    let transducer = "fixtures/transducer/transducer.csv";
    let steam = "fixtures/steam-generator/steam_generator.csv";
    let conditions = [("--where", "theta1 >= 0"), ("--where", "0 <= 1")];
    let mut cases = vec![
        case(transducer, "Vz", "z", "0.5e-3", Some((14, 36)), &[]),
        case(transducer, "Vz", "z", "0.5e-3", Some((14, 36)), &[binary64]),
        case(transducer, "Vz", "z", "1/1500", None, &[("--where", "2/3*theta1 - theta2 <= 1/7")]),
        case(steam, "x", "y", "column eps", None, &conditions),
        case("fixtures/norris/norris.csv", "x", "y", "1/2", None, &[]),
        case("fixtures/figures/two-regressors.csv", "1,2", "3", "1/4", None, &[binary64]),
        case("fixtures/claims/strip.csv", "x", "y", "0.2", None, &[]),
        // Readings of a line that wait in their columns, others than those on a hull.
        case("fixtures/tables/faithful.csv", "eruptions", "waiting", "20", Some((14, 250)), &conditions),
        case("fixtures/tables/faithful.csv", "eruptions", "waiting", "1/3", None, &[binary64]),
    ];
    for hard in hard_cases() {
        let file = format!("fixtures/hard-lp/{}.csv", hard.name);
        cases.push(case(&file, "x", "y", &hard.epsilon, None, &[]));
        cases.push(case(&file, "x", "y", &hard.epsilon, None, &[binary64]));
    }
    cases
}

fn name_in_file(name: BoundName) -> String {
    match name {
        BoundName::Upper(row) => format!("row{row}_upper"),
        BoundName::Lower(row) => format!("row{row}_lower"),
        BoundName::Where(number) | BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
            format!("where_{number}")
        }
    }
}

/// Compares a program that was read back with the exact one, and its optimum with the end of the PUI.
fn check(read: &ReadProgram, target: PuiEnd, problem: &Problem, context: &str) {
    let rows = ProgramRows::new(problem);
    let plain = rows.plain();
    let expected: Vec<(String, Row)> =
        rows.names().iter().map(|name| name_in_file(*name)).zip(plain).collect();
    assert_eq!(read.rows, expected, "{context}");
    assert_eq!(read.objective, (target.objective_name().to_owned(), target.objective()), "{context}");
    let rows: Vec<Row> = read.rows.iter().map(|(_, row)| row.clone()).collect();
    let outcome = exact_simplex(&Program { rows: &rows, objective: read.objective.1.clone() });
    let bounds = fit(problem).pui.map(|pui| pui[target.axis()].clone());
    let is_minimum = target.name().ends_with("min");
    let end = bounds.map(|bounds| if is_minimum { bounds.lower.endpoint() } else { bounds.upper.endpoint() });
    match outcome {
        ExactOutcome::Optimal { theta, .. } => {
            assert_eq!(end, Some(Endpoint::Finite(theta[target.axis()].clone())), "{context}");
        }
        ExactOutcome::Unbounded { .. } => assert!(!matches!(end, Some(Endpoint::Finite(_))), "{context}"),
        ExactOutcome::Infeasible { .. } => {
            assert!(fit(problem).fps.polyhedron().region().is_empty(), "{context}")
        }
    }
}

#[test]
fn files_read_back_as_the_exact_programs() {
    for case in cases() {
        for format in ["mps", "lp"] {
            let folder = tempfile::tempdir().unwrap();
            let made = folder.path().join("made");
            let run = boundfit(&format!("convert {} --to {format} -o {}", case.line, made.display()));
            assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""), "{}", case.line);
            let mut files: Vec<_> =
                fs::read_dir(&made).unwrap().map(|entry| entry.unwrap().file_name()).collect();
            files.sort();
            let mut expected =
                PuiEnd::ALL.map(|target| std::ffi::OsString::from(format!("{}.{format}", target.name())));
            expected.sort();
            assert_eq!(files, expected, "{}", case.line);
            for target in PuiEnd::ALL {
                let text = fs::read_to_string(made.join(format!("{}.{format}", target.name()))).unwrap();
                let read = if format == "mps" { read_mps(&text) } else { read_lp(&text) };
                assert!(format == "lp" || read.name.as_deref() == Some(target.name()));
                check(&read, target, &case.problem, &format!("{} {format} {}", case.line, target.name()));
                // One program alone is the same file.
                let alone = format!("convert {} --to {format} --objective {}", case.line, target.name());
                assert_eq!(boundfit(&alone).stdout, text, "{alone}");
            }
        }
    }
}

#[test]
fn generated_programs_read_back_exactly() {
    let mut rng = ChaCha8Rng::seed_from_u64(6031);
    let (mut scaled, mut plain) = (0, 0);
    for index in 0..300 {
        let mut problem = problem(&mut rng);
        if index % 3 == 0 {
            let bound = Rational::ratio(rng.random_range(0..9), 7) * ten_to(rng.random_range(-20..=20));
            problem = with_error_bound(&problem, &bound);
        }
        let rows = exchange_rows(&problem);
        for target in PuiEnd::ALL {
            let mps = rows.text(target, ExchangeFormat::Mps, &[]);
            let lp = rows.text(target, ExchangeFormat::Lp, &[]);
            if mps.contains(" is multiplied by ") {
                scaled += 1
            } else {
                plain += 1
            }
            check(&read_mps(&mps), target, &problem, &format!("{index} mps"));
            check(&read_lp(&lp), target, &problem, &format!("{index} lp"));
        }
    }
    assert!(scaled >= 100 && plain >= 100, "{scaled} {plain}");
}

#[test]
fn long_and_far_numbers_stay_exact_and_are_remarked_upon() {
    let xs = [ten_to(-320), Rational::from_f64(3e-300).unwrap(), ten_to(400)];
    let problem = line(xs.map(|x| (x.clone(), &x + &x)), number("1/8"));
    let rows = exchange_rows(&problem);
    let text = rows.text(PuiEnd::Theta2Max, ExchangeFormat::Lp, &["two\nlines, and \u{3b8}".to_owned()]);
    assert!(text.starts_with("\\ two\\nlines, and \\u{3b8}\n"), "{text}");
    assert!(text.contains("row3_upper has a number that is beyond the range of doubles"), "{text}");
    assert!(text.contains("row2_lower has a number of "), "{text}");
    assert!(text.lines().filter(|line| line.len() > 600).count() <= 6, "{text}");
    check(&read_lp(&text), PuiEnd::Theta2Max, &problem, "lp");
    check(
        &read_mps(&rows.text(PuiEnd::Theta1Min, ExchangeFormat::Mps, &[])),
        PuiEnd::Theta1Min,
        &problem,
        "mps",
    );
}

/// A reading of a line takes no more than its numbers in columns and its two rows as text.
#[cfg(unix)]
#[test]
fn many_readings_are_written_in_little_memory() {
    let rows: String = (0..200_000).map(|row| format!("{row},{}\n", row % 997)).collect();
    let directory = directory_with(&[("many.csv", format!("x,y\n{rows}").as_bytes())]);
    let words = "convert many.csv --x x --y y --eps 600 --to mps --objective theta1-min -o made.mps";
    let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
    let cost = Cost { cpu: Duration::from_secs(60), data: 88 << 20 };
    let ended = run_limited(directory.path(), &words, cost);
    assert_eq!(ended.status, Some(0), "{}", ended.messages);
}

const STEAM: &str = "fixtures/steam-generator/steam_generator.csv --x x --y y --eps-column eps";

/// Some readers take a side from 10²⁰ on for infinite, our own from 10³⁰ on.
#[test]
fn no_side_is_infinite_for_any_reader() {
    let directory = directory_with(&[
        (
            "doubles.csv",
            "x,y\n0.23796462709189137,1.4847750992429731\n1.3699551665480794,3.7606943408153977\n\
              2.625720304108054,6.1645463800640705\n3.013167991554874,7.09382979952904\n\
              4.259354014328007,9.465574220865355\n5.995644835510463,12.985342372525416\n"
                .as_bytes(),
        ),
        ("large.csv", "x,lo,up\n1,-1,1e30\n2,-2,3e30\n".as_bytes()),
    ]);
    for (line, target) in [
        ("doubles.csv --x x --y y --eps 1.2*min", "theta1-max"),
        ("large.csv --x x --lower lo --upper up", "theta1-max"),
    ] {
        for format in ["mps", "lp"] {
            let run = |line: String| {
                let run = boundfit_tests::cli::boundfit(directory.path(), &line);
                assert_eq!(run.status, 0, "{line}: {run:?}");
                run.stdout
            };
            let text = run(format!("convert {line} --to {format} --objective {target}"));
            assert!(text.contains(" is multiplied by "), "{text}");
            std::fs::write(directory.path().join(format!("program.{format}")), text).unwrap();
            let json = |line: String| -> serde_json::Value {
                serde_json::from_str(&run(format!("{line} --format json"))).unwrap()
            };
            let (fit, judged) = (json(format!("fit {line}")), json(format!("judge program.{format}")));
            let end = fit["pui"][0]["upper"]["exact"].as_str().unwrap().to_owned();
            let least = judged["objective"]["exact"].as_str().unwrap().trim_start_matches('-').to_owned();
            assert_eq!(least, end, "{line} {format}");
        }
    }
}

#[test]
fn what_a_file_looks_like() {
    let line = format!("convert {STEAM} --where '3*theta1 >= 1/3' --objective theta1-max");
    let mps = "\
* theta1-max: the largest theta1, as the smallest -theta1, that agrees with every reading
* model: y = theta1*x + theta2 + e, |e| <= eps
* data: fixtures/steam-generator/steam_generator.csv, every row of them
* reading: decimal; no number is rounded
* where_1: 3*theta1 >= 1/3
* where_1 is multiplied by 3: its numbers have no finite decimals
NAME theta1-max
ROWS
 N theta1_max
 L row1_upper
";
    let run = boundfit(&format!("{line} --to mps"));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.starts_with(mps), "{}", run.stdout);
    assert!(
        run.stdout.contains(" G row3_lower\n L where_1\nCOLUMNS\n theta1 theta1_max -1\n"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("\n RHS where_1 -1\nBOUNDS\n FR BOUND theta1\n FR BOUND theta2\nENDATA\n"));
    let lp = boundfit(&format!("{line} --to lp")).stdout;
    assert!(lp.contains("\nMinimize\n theta1_max: - 1 theta1 + 0 theta2\nSubject To\n row1_upper: "), "{lp}");
    assert!(lp.ends_with("\n where_1: - 9 theta1 <= -1\nBounds\n theta1 free\n theta2 free\nEnd\n"), "{lp}");
}

#[test]
fn refusals_write_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let refused = |line: &str, status: i32, message: &str| {
        let run = boundfit(line);
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{line}");
        assert!(run.stderr.starts_with(&format!("error: {message}")), "{line}: {}", run.stderr);
    };
    let four = "a fit makes four programs: name a folder for them with '--output <DIR>', or one of them with '--objective'\n";
    refused(&format!("convert {STEAM} --to mps"), 2, four);
    refused(&format!("convert {STEAM} --to lp -o -"), 2, four);
    let file = path("programs.mps");
    let message = "(expected a folder for them, or '--objective' for one of them)";
    let run = boundfit(&format!("convert {STEAM} --to mps -o {file}"));
    assert!(run.status == 2 && run.stderr.contains(message), "{run:?}");
    refused(
        &format!("convert {STEAM} -o {}", path("none")),
        2,
        "'--to <TO>' is missing: the format of the programs, mps or lp\n",
    );
    refused(&format!("convert {STEAM} --to sol -o {file}"), 2, "invalid value 'sol' for '--to <TO>'");
    refused(&format!("convert {STEAM} --to lp --objective theta3-min"), 2, "invalid value 'theta3-min'");
    let bad =
        format!("convert fixtures/bad-input/numbers.csv --x 1 --y 2 --eps 1 --to mps -o {}", path("none"));
    refused(&bad, 1, "fixtures/bad-input/numbers.csv: ");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    fs::write(path("file"), "kept").unwrap();
    refused(
        &format!("convert {STEAM} --to mps -o {}", path("file")),
        1,
        &format!("{}: cannot create: ", path("file")),
    );
    fs::create_dir_all(Path::new(&path("made")).join("theta2-max.lp")).unwrap();
    let message = format!("{}/theta2-max.lp: cannot write: is a directory\n", path("made"));
    refused(&format!("convert {STEAM} --to lp -o {}", path("made")), 1, &message);
    assert_eq!(fs::read_dir(path("made")).unwrap().count(), 1);
    assert_eq!(fs::read_to_string(path("file")).unwrap(), "kept");
}
