//! The limits on inputs. Each limit is tried from just below to just above, and its message names the option that
//! raises it. That option works, and hostile input costs neither memory nor time.

use std::path::Path;
use std::process::{Command, Stdio};

use boundfit_tests::program::{Run, binary};

use boundfit_tests::cli::refusals::check_refusal;
use boundfit_tests::cli::{boundfit, directory_with, finish, printed};

/// Every command that reads data, with the options that make it read columns x and y of `data.csv`.
const COMMANDS: [&str; 6] = [
    "fit data.csv --x x --y y --eps 1",
    "fit data.csv --x x --y y --eps 1 --by x",
    "reduce data.csv --x x --y y",
    "check data.csv --x x --y y --eps 1 --solver microlp",
    "plot data.csv --x x --y y --eps 1",
    "lesson data.csv --x x --y y --eps 1",
];

/// Checks that a command refuses a table, and accepts it with an option more.
fn refused_until(line: &str, table: &str, message: &str, option: &str) {
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    check_refusal(&boundfit(directory.path(), line), line, 1, message);
    let raised = boundfit(directory.path(), &format!("{line} {option}"));
    assert!([0, 4].contains(&raised.status), "{line} {option}: {raised:?}");
}

#[test]
fn a_digit_too_many_is_accepted_when_the_limit_is_raised() {
    for command in COMMANDS {
        let (at, over) = ("7".repeat(50), "7".repeat(51));
        let directory = directory_with(&[("data.csv", format!("x,y\n1,2\n2,{at}\n").as_bytes())]);
        let run = boundfit(directory.path(), &format!("{command} --limit digits=50"));
        assert!([0, 4].contains(&run.status), "{command}: {run:?}");
        let quoted = format!("\"{}\"...", "7".repeat(40));
        let message = format!(
            "data.csv: line 3, column 2 (y): {quoted}: refused: more than 50 digits (the limit) at character 51; \
             --limit digits=N raises it"
        );
        let line = format!("{command} --limit digits=50");
        let table = format!("x,y\n1,2\n2,{over}\n");
        let directory = directory_with(&[("data.csv", table.as_bytes())]);
        check_refusal(&boundfit(directory.path(), &line), &line, 1, &message);
        let raised = boundfit(directory.path(), &format!("{command} --limit digits=51"));
        assert!([0, 4].contains(&raised.status), "{command}: {raised:?}");
    }
}

#[test]
fn digits_up_to_the_usual_limit_and_beyond_it() {
    let at = format!("x,y\n1,0.{}\n2,3\n", "7".repeat(9_999));
    let directory = directory_with(&[("data.csv", at.as_bytes())]);
    printed(directory.path(), "fit data.csv --x x --y y --eps 1 --no-lp");
    let over = format!("x,y\n1,1/1{}\n2,3\n", "0".repeat(10_000));
    let message = "data.csv: line 2, column 2 (y): \"1/10000000000000000000000000000000000000\"...: refused: more than \
                   10000 digits (the limit) at character 10003; --limit digits=N raises it";
    refused_until("fit data.csv --x x --y y --eps 1 --no-lp", &over, message, "--limit digits=10001");
}

#[test]
fn an_exponent_is_accepted_when_the_limit_is_raised() {
    for command in COMMANDS {
        let accepted = directory_with(&[("data.csv", b"x,y\n1,2\n2,1e-6\n")]);
        let run = boundfit(accepted.path(), &format!("{command} --limit exponent=6"));
        assert!([0, 4].contains(&run.status), "{command}: {run:?}");
        let line = format!("{command} --limit exponent=5");
        let message = "data.csv: line 3, column 2 (y): \"1e-6\": refused: exponent beyond 5 (the limit) at character 4; \
                       --limit exponent=N raises it";
        check_refusal(&boundfit(accepted.path(), &line), &line, 1, message);
    }
    let message = "data.csv: line 2, column 2 (y): \"1e10001\": refused: exponent beyond 10000 (the limit) at character 3; \
                   --limit exponent=N raises it";
    let line = "fit data.csv --x x --y y --eps 1 --no-lp --no-eui";
    refused_until(line, "x,y\n1,1e10001\n2,3\n", message, "--limit exponent=10001");
}

#[test]
fn numbers_on_the_command_line_have_the_same_limits() {
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3\n3,5\n")]);
    let cases = [
        (
            "--eps 1e11",
            "1e11",
            "--eps <NUM>",
            "refused: exponent beyond 10 (the limit) at character 3; --limit exponent=N",
        ),
        (
            "--eps 1 --where 'theta1 <= 1e11'",
            "theta1 <= 1e11",
            "--where <CONDITION>",
            "refused: exponent beyond 10 (the limit) at character 13; --limit exponent=N",
        ),
        (
            "--eps 1 --sweep 1..1e11",
            "1..1e11",
            "--sweep <FROM..TO>",
            "\"1e11\": refused: exponent beyond 10 (the limit) at character 3; --limit exponent=N",
        ),
        (
            "--eps 123456",
            "123456",
            "--eps <NUM>",
            "refused: more than 5 digits (the limit) at character 6; --limit digits=N",
        ),
        (
            "--eps 1 --sweep 1..1.00001",
            "1..1.00001",
            "--sweep <FROM..TO>",
            "\"1.00001\": refused: more than 5 digits (the limit) at character 7; --limit digits=N",
        ),
    ];
    for (options, value, option, problem) in cases {
        let line = format!("fit data.csv --x x --y y {options} --limit digits=5 --limit exponent=10");
        let message = format!("invalid value '{value}' for '{option}': {problem} raises it");
        check_refusal(&boundfit(directory.path(), &line), &line, 2, &message);
        printed(
            directory.path(),
            &format!("fit data.csv --x x --y y {options} --limit digits=6 --limit exponent=11"),
        );
    }
    // The program reports a text that is no number.
    let line = "fit data.csv --x x --y y --eps 1 --sweep 1..x";
    let message = "invalid value '1..x' for '--sweep <FROM..TO>': \"x\": not a number: unexpected character 'x' at character 1 \
                   (expected FROM..TO with numbers 0 <= FROM <= TO, such as 0.5..2)";
    check_refusal(&boundfit(directory.path(), line), line, 2, message);
}

#[test]
fn half_planes_have_the_same_limits() {
    let table = b"a1,a2,b\n1,0,1e7\n-1,0,0\n0,1,1\n0,-1,0\n";
    let directory = directory_with(&[("square.csv", table)]);
    let line = "polygon square.csv --limit exponent=6";
    let message = "square.csv: line 2, column 3 (b): \"1e7\": refused: exponent beyond 6 (the limit) at character 3; \
                   --limit exponent=N raises it";
    check_refusal(&boundfit(directory.path(), line), line, 1, message);
    printed(directory.path(), "polygon square.csv --limit exponent=7");
}

#[test]
fn a_line_is_as_long_as_it_may_be_and_no_longer() {
    // The line feed counts.
    let table = |length: usize| format!("x,y\n1,2\n2,{}3\n", " ".repeat(length - 4));
    for command in COMMANDS {
        let directory = directory_with(&[("data.csv", table(64).as_bytes())]);
        let run = boundfit(directory.path(), &format!("{command} --limit line=64"));
        assert!([0, 4].contains(&run.status), "{command}: {run:?}");
        let line = format!("{command} --limit line=63");
        let message =
            "data.csv: line 3: the line is longer than 63 bytes (the limit); --limit line=N raises it";
        check_refusal(&boundfit(directory.path(), &line), &line, 1, message);
    }
    let directory = directory_with(&[("table.csv", format!("a1,a2,b\n1,0,{}\n", "1".repeat(60)).as_bytes())]);
    let line = "polygon table.csv --limit line=64";
    let message = "table.csv: line 2: the line is longer than 64 bytes (the limit); --limit line=N raises it";
    check_refusal(&boundfit(directory.path(), line), line, 1, message);
    printed(directory.path(), "polygon table.csv --limit line=65");
}

#[test]
fn a_row_over_several_lines_has_the_limit_of_a_line() {
    // Between quotes a row goes on, so that no line of it is long.
    let row = format!("2,3,\"{}\"\n", "note\n".repeat(20));
    let table = format!("x,y,n\n\n\n1,2,\n{row}3,4,\n");
    for command in COMMANDS {
        let directory = directory_with(&[("data.csv", table.as_bytes())]);
        let run = boundfit(directory.path(), &format!("{command} --limit line={}", row.len()));
        assert!([0, 4].contains(&run.status), "{command}: {run:?}");
        let limit = row.len() - 1;
        let line = format!("{command} --limit line={limit}");
        let message = format!(
            "data.csv: line 5: the row is longer than {limit} bytes (the limit); are its quotes closed?; --limit line=N raises it"
        );
        check_refusal(&boundfit(directory.path(), &line), &line, 1, &message);
    }
}

#[test]
fn a_table_has_as_many_columns_as_it_may() {
    let table = "x,y,a,b\n1,2,3,4\n2,3,4,5\n";
    for command in COMMANDS {
        let line = format!("{command} --limit columns=3");
        let directory = directory_with(&[("data.csv", table.as_bytes())]);
        let message =
            "data.csv: line 1: there are more than 3 columns (the limit); --limit columns=N raises it";
        check_refusal(&boundfit(directory.path(), &line), &line, 1, message);
        let run = boundfit(directory.path(), &format!("{command} --limit columns=4"));
        assert!([0, 4].contains(&run.status), "{command}: {run:?}");
    }
}

#[test]
fn a_lesson_of_more_readings_is_written_when_asked_for() {
    let rows: String = (0..5).map(|x| format!("{x},{}\n", 2 * x)).collect();
    let message = "data.csv: more than 4 readings are too many for a lesson; choose some with --rows FIRST..LAST, or \
                   raise it with --limit readings=N";
    let line = "lesson data.csv --x x --y y --eps 1";
    let directory = directory_with(&[("data.csv", format!("x,y\n{rows}").as_bytes())]);
    check_refusal(&boundfit(directory.path(), &format!("{line} --limit readings=4")), line, 1, message);
    printed(directory.path(), &format!("{line} --limit readings=5"));
}

#[test]
fn a_sum_in_a_reduction_may_have_ten_times_the_digits_of_a_reading() {
    let record = |digits: usize| {
        // Σy is 5, in so many digits.
        let sum = format!("5{0}/1{0}", "0".repeat(digits - 1));
        format!(
            "# boundfit/reduced/1 {{\"rows\":2,\"kept\":2,\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
             \"epsilon\":null,\"sums\":[\"3\",\"{sum}\",\"5\",\"8\"]}}\nx,y\n1,2\n2,3\n"
        )
    };
    let directory = directory_with(&[("data.csv", record(30).as_bytes())]);
    for command in ["fit data.csv --x x --y y --eps 1", "reduce data.csv --x x --y y"] {
        printed(directory.path(), &format!("{command} --limit digits=3"));
        let line = format!("{command} --limit digits=2");
        let message = "data.csv: a sum in the line in front of a reduction: more than 20 digits (the limit) at character 21; \
                       --limit digits=N raises it";
        check_refusal(&boundfit(directory.path(), &line), &line, 1, message);
    }
}

#[test]
fn limits_have_ceilings_of_their_own() {
    for (name, value, expected) in [
        ("digits", "1000001", "an integer from 1 to 1000000"),
        ("digits", "0", "an integer from 1 to 1000000"),
        ("digits", "many", "an integer from 1 to 1000000"),
        ("exponent", "1000001", "an integer from 0 to 1000000"),
        ("columns", "4294967297", "an integer from 1 to 4294967296"),
        ("rows", "4294967297", "an integer from 1 to 4294967296"),
        ("elements", "4294967297", "an integer from 1 to 4294967296"),
        ("nesting", "121", "an integer from 1 to 120"),
        (
            "line",
            "0",
            "a size in bytes above 0, with k, M, G (1000) or KiB, MiB, GiB (1024) behind it, such as 512MiB, at most \
             4294967296",
        ),
    ] {
        for command in ["fit data.csv --x x --y y --eps 1", "polygon square.csv"] {
            let line = format!("{command} --limit {name}={value}");
            let message = format!(
                "invalid value '{name}={value}' for '--limit <NAME=N>': {value:?} is no value of the limit {name} (expected {expected})"
            );
            check_refusal(&boundfit(Path::new("."), &line), &line, 2, &message);
        }
    }
}

#[test]
fn a_limit_that_a_command_has_not_is_refused_with_its_names() {
    const NAMES: &str = "digits, exponent, line, columns, rows, elements, unpacked, ratio, workbook, work, text, nesting, \
                         memory";
    for (line, option, problem) in [
        (
            "reduce data.csv --x x --y y --limit sets=5",
            "sets=5",
            format!("there is no limit \"sets\" for this command (expected one of {NAMES})"),
        ),
        (
            "polygon square.csv --limit size=5",
            "size=5",
            format!("there is no limit \"size\" (expected one of {NAMES}, fraction)"),
        ),
        (
            "polygon square.csv --limit 5",
            "5",
            "expected NAME=N, such as digits=20000 or memory=4GiB; --help lists the names".to_owned(),
        ),
    ] {
        let message = format!("invalid value '{option}' for '--limit <NAME=N>': {problem}");
        check_refusal(&boundfit(Path::new("."), line), line, 2, &message);
    }
}

#[test]
fn an_option_of_former_versions_is_refused_with_the_one_of_now() {
    for (line, name) in [
        ("fit data.csv --x x --y y --eps 1 --max-digits 5", "digits"),
        ("outliers data.csv --x x --y y --eps 1 --max-sets=5", "sets"),
        ("verify p.json data.csv --max-proof-size 5", "text"),
    ] {
        let run = boundfit(Path::new("."), line);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{line}");
        let tip = format!("limits have one option: '--limit {name}=N'");
        assert!(run.stderr.contains(&tip), "{line}: {}", run.stderr);
    }
}

/// Numbers near the end of what can be counted, which come from the command line or from a file.
#[test]
fn counts_near_the_end_of_what_can_be_counted_overflow_nothing() {
    let most = usize::MAX;
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3\n")]);
    for rows in [format!("{most}..{most}"), format!("1..{most}")] {
        for command in &COMMANDS[3..] {
            let run = boundfit(directory.path(), &format!("{command} --rows {rows}"));
            assert_eq!(run.status, 1, "{command} {rows}: {run:?}");
            assert!(run.stderr.ends_with("but the file has 2 data rows\n"), "{run:?}");
        }
        let run = boundfit(directory.path(), &format!("{} --rows {rows}", COMMANDS[0]));
        assert!(run.status == 1 && run.stderr.ends_with("but the file has 2 data rows\n"), "{run:?}");
    }
    for column in [most.to_string(), "99999999999999999999999999".to_owned()] {
        let run = boundfit(directory.path(), &format!("fit data.csv --x {column} --y y --eps 1"));
        assert!(run.status == 1 && run.stderr.contains("there is no column"), "{run:?}");
    }
    // Two reductions whose readings together cannot be counted.
    let part = |rows: usize| {
        // All but the three that are kept are at (1, 1), strictly within their hull.
        let more = rows.saturating_sub(3) as u128;
        let [x, y, xx, xy] = [3 + more, 3 + more, 9 + more, more];
        format!(
            "# boundfit/reduced/1 {{\"rows\":{rows},\"kept\":3,\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
             \"epsilon\":null,\"sums\":[\"{x}\",\"{y}\",\"{xx}\",\"{xy}\"]}}\nx,y\n0,0\n0,3\n3,0\n"
        )
    };
    let directory = directory_with(&[("data.csv", format!("{}{}", part(most), part(3)).as_bytes())]);
    for command in ["fit data.csv --x x --y y --eps 2", "reduce data.csv --x x --y y"] {
        let message = format!("data.csv: the reductions stand for more than {most} readings");
        check_refusal(&boundfit(directory.path(), command), command, 1, &message);
    }
    let directory = directory_with(&[("data.csv", part(most).as_bytes())]);
    for command in ["fit data.csv --x x --y y --eps 2", "fit data.csv --x x --y y --eps 2 --format json"] {
        printed(directory.path(), command);
    }
}

#[test]
fn a_long_condition_does_not_exhaust_the_stack() {
    let sum = format!("theta1 <= {}", vec!["1"; 20_000].join(" - "));
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3\n")]);
    let mut command = boundfit_tests::cli::command(directory.path());
    command.args(["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--where", &sum]);
    assert_eq!(finish(&mut command, b"").status, 3);
}

/// Runs the program with this many kilobytes of address space beside its own code, which grows with what it can do.
#[cfg(unix)]
fn within(kilobytes: u64, line: &str, input: &[u8]) -> Run {
    let kilobytes = kilobytes + std::fs::metadata(binary()).unwrap().len() / 1024;
    let mut command = Command::new("sh");
    command.args(["-c", &format!("ulimit -v {kilobytes} && exec \"$0\" \"$@\"")]).arg(binary());
    command
        .args(boundfit_tests::cli::words(line))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    finish(&mut command, input)
}

/// Runs with one thread, since the program then needs only about 10 MB of address space for its own.
#[cfg(unix)]
#[test]
fn hostile_numbers_cost_no_memory() {
    for cell in ["1e999999999", "1e-999999999", "1e99999999999999999999", &"7".repeat(1_000_000)] {
        let table = format!("x,y\n1,{cell}\n2,3\n");
        for line in ["fit - --x x --y y --eps 1 --threads 1", "check - --x x --y y --eps 1"] {
            let run = within(165_000, line, table.as_bytes());
            let refused = run.status == 1 && run.stderr.contains("(the limit)");
            assert!(refused && run.stderr.ends_with(" raises it\n"), "{line}: {run:?}");
        }
    }
    for eps in ["1e999999999", "1e-999999999"] {
        let run = within(165_000, &format!("fit - --x x --y y --threads 1 --eps {eps}"), b"x,y\n1,2\n");
        assert!(run.status == 2 && run.stderr.contains("--limit exponent=N raises it"), "{run:?}");
    }
}

#[cfg(unix)]
#[test]
fn hostile_tables_cost_no_memory() {
    let open_quote = format!("x,y\n1,\"{}", "2\n".repeat(48 << 20));
    let blank_lines = format!("x,y\n{}\"1\",2\n2,3\n", "\n".repeat(48 << 20));
    let no_line_end = "7".repeat(48 << 20);
    let many_columns = format!("{}\n", ",".repeat(15 << 20));
    for (table, line, problem) in [
        (&open_quote, "fit - --x x --y y --eps 1 --threads 1", "line 2: the row is longer than"),
        (&open_quote, "check - --x x --y y --eps 1", "line 2: the row is longer than"),
        (&no_line_end, "fit - --x 1 --y 2 --eps 1 --threads 1", "line 1: the line is longer than"),
        (&no_line_end, "check - --x 1 --y 2 --eps 1", "line 1: the line is longer than"),
    ] {
        let run = within(265_000, line, table.as_bytes());
        assert!(run.status == 1 && run.stderr.contains(problem), "{line}: {run:?}");
    }
    let run = within(265_000, "reduce - --x x --y y --threads 1", blank_lines.as_bytes());
    assert_eq!(run.status, 0, "{run:?}");
    let run = within(265_000, "check - --x x --y y --eps 1 --solver exact-simplex", blank_lines.as_bytes());
    assert_eq!(run.status, 0, "{run:?}");
    let run = within(765_000, "fit - --x x --y y --eps 1 --threads 1", many_columns.as_bytes());
    assert!(run.status == 1 && run.stderr.contains("more than 100000 columns (the limit)"), "{run:?}");
}

#[test]
fn every_command_that_reads_data_lists_the_limits() {
    for command in ["fit", "check", "plot", "lesson", "reduce", "polygon"] {
        let help = printed(Path::new("."), &format!("{command} --help"));
        assert!(help.contains("\nLimits:\n"), "{command}: {help}");
        for name in ["digits", "exponent", "line", "columns", "rows", "elements", "work", "nesting", "memory"]
        {
            assert!(help.contains(&format!("\n          - {name} (")), "{command}: {name}\n{help}");
        }
    }
}
