//! Nothing that is printed deceives: not by what somebody else wrote into names and files, and not by rounding.

use std::fs;
use std::path::Path;

use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_tests::cli::refusals::check_refusal;
use boundfit_tests::cli::{
    boundfit, boundfit_with_input, command, directory_with, finish, printed, unbroken,
};

/// Wipes the line above and begins a new one, turns text round, and shows nothing.
const HOSTILE: &str = "y\u{1b}[1A\u{1b}[2K\rexact\nWorst verdict: exact\u{202e}\u{200b}\u{2028}z";
const DATA: &str = "x,y\n1,2\n2,3.1\n3,3.9\n4,5\n";

/// Checks that every character that a program prints can be seen, but for line ends and spaces.
fn is_plain([stdout, stderr]: [&str; 2], about: &str) {
    for text in [stdout, stderr] {
        for line in text.split('\n') {
            assert_eq!(Foreign::of(line).to_string(), line, "{about}");
        }
    }
}

#[test]
fn names_in_a_table_cannot_wipe_or_forge_lines() {
    let cell = HOSTILE.replace('"', "\"\"");
    let table = format!("x\u{1b}[31m,\"{cell}\",g\n1,2,\"{cell}\"\n2,3,b\n3,5,b\n");
    let directory = directory_with(&[("data.csv", table.as_bytes()), ("other.csv", DATA.as_bytes())]);
    for line in [
        "fit data.csv --x 1 --y 2 --eps 1",
        "fit data.csv --x 1 --y 2 --eps 1 --brief",
        "fit data.csv --x 1 --y 2 --eps 1 --format latex",
        "fit data.csv --x 1 --y 2 --eps 1 --format markdown",
        "fit data.csv --x 1 --y 1 --eps-column 2",
        "fit data.csv --x 1 --y 1 --lower 1 --upper 2",
        "fit data.csv --x 1,2 --y 1 --eps 1",
        "fit data.csv --x 1 --y 2 --eps 1 --by g",
        "fit data.csv --x 1 --y g --eps 1",
        "fit data.csv --x 1 --y nothing --eps 1",
        "check data.csv --x 1 --y 2 --eps 1",
        "convert data.csv --x 1 --y 2 --eps 1 --to mps --objective theta1-min",
        "plot data.csv --x 1 --y 2 --eps 1",
    ] {
        let run = boundfit(directory.path(), line);
        is_plain([&run.stdout, &run.stderr], line);
    }
    let text = printed(directory.path(), "fit data.csv --x 1 --y 2 --eps 1 --no-lp");
    let name = r"y\u{1b}[1A\u{1b}[2K\rexact\nWorst verdict: exact\u{202e}\u{200b}\u{2028}z";
    let text = unbroken(&text);
    assert!(text.contains(&format!("{name} = theta1*x\\u{{1b}}[31m + theta2 + e error")), "{text}");
    // JSON has the name itself.
    let json: serde_json::Value =
        serde_json::from_str(&printed(directory.path(), "fit data.csv --x 1 --y 2 --eps 1 --format json"))
            .unwrap();
    assert_eq!(json["input"]["y"], HOSTILE);
}

#[test]
fn what_was_typed_is_on_one_line() {
    let directory = directory_with(&[("data.csv", DATA.as_bytes())]);
    let with = |arguments: &[&str]| finish(command(directory.path()).args(arguments), b"");
    for arguments in [
        &["fit", HOSTILE, "--x", "x", "--y", "y", "--eps", "1"][..],
        &["fit", "data.csv", "--x", HOSTILE, "--y", "y", "--eps", "1"],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", HOSTILE],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--where", HOSTILE],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--where-row", HOSTILE],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--format", HOSTILE],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", &format!("--{HOSTILE}")],
        &["fit", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "-o", &format!("none/{HOSTILE}")],
        &["fit", "data.csv", HOSTILE],
        &[HOSTILE],
        &["man", HOSTILE],
        &["judge", HOSTILE],
        &["polygon", HOSTILE],
        &["reduce", HOSTILE, "--x", "x", "--y", "y"],
        &["check", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--claim", HOSTILE],
        &["check", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--solver", HOSTILE],
        &["check", "data.csv", "--x", "x", "--y", "y", "--eps", "1", "--claim-pui", HOSTILE],
    ] {
        let run = with(arguments);
        assert!(matches!(run.status, 1 | 2) && run.stdout.is_empty(), "{arguments:?} {run:?}");
        is_plain([&run.stdout, &run.stderr], &format!("{arguments:?}"));
        assert!(!run.stderr.contains("\nWorst verdict"), "{arguments:?} {run:?}");
    }
}

#[test]
fn a_claim_cannot_forge_its_verdict() {
    let claim = serde_json::json!({"source": HOSTILE, "pui": [[0.9, 1.1], [0.8, 1.2]]});
    let named = serde_json::json!({"status": HOSTILE});
    let unknown = serde_json::json!({HOSTILE: 1});
    let directory = directory_with(&[
        ("data.csv", DATA.as_bytes()),
        ("claim.json", claim.to_string().as_bytes()),
        ("status.json", named.to_string().as_bytes()),
        ("field.json", unknown.to_string().as_bytes()),
    ]);
    let check = "check data.csv --x x --y y --eps 0.2 --claim";
    let run = boundfit(directory.path(), &format!("{check} claim.json"));
    assert_eq!((run.status, run.stderr.as_str()), (4, ""));
    is_plain([&run.stdout, &run.stderr], "claim.json");
    let worst: Vec<&str> = run.stdout.lines().filter(|line| line.starts_with("Worst verdict")).collect();
    assert_eq!(worst, ["Worst verdict: unsafe; refuted"]);
    for file in ["status.json", "field.json"] {
        let run = boundfit(directory.path(), &format!("{check} {file}"));
        assert_eq!((run.status, run.stderr.lines().count()), (1, 1), "{run:?}");
        is_plain([&run.stdout, &run.stderr], file);
    }
}

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// The points that a report calls feasible, as it prints them.
fn feasible_points(report: &str) -> Vec<[Rational; 2]> {
    let report = report.split_whitespace().collect::<Vec<_>>().join(" ");
    let before = report.match_indices(") is feasible").map(|(end, _)| &report[..end]);
    let points = before.map(|text| &text[text.rfind('(').unwrap() + 1..]);
    points.map(|point| point.split_once(", ").unwrap()).map(|(one, two)| [number(one), number(two)]).collect()
}

#[test]
fn points_called_feasible_are_feasible_as_printed() {
    let directory = directory_with(&[("data.csv", DATA.as_bytes())]);
    let readings = [("1", "2"), ("2", "3.1"), ("3", "3.9"), ("4", "5")].map(|(x, y)| [number(x), number(y)]);
    for digits in ["", "--digits 1", "--digits 3", "--digits 9"] {
        let line = format!("check data.csv --x x --y y --eps 0.2 --claim-pui=0.99,1,0.99,1 {digits}");
        let run = boundfit(directory.path(), &line);
        assert_eq!(run.status, 4, "{line} {run:?}");
        let points = feasible_points(&run.stdout);
        assert!(points.len() >= 4, "{line} {run:?}");
        for [theta1, theta2] in points {
            for [x, y] in &readings {
                let error = y - &(x * &theta1 + &theta2);
                assert!(error.abs() <= number("0.2"), "{line} ({theta1}, {theta2}) at {x}");
            }
        }
    }
}

#[test]
fn claims_below_the_smallest_double_are_compared_exactly() {
    let directory = directory_with(&[("data.csv", b"x,y\n0,0\n1,0\n")]);
    let check = |claimed: &str| {
        boundfit(directory.path(), &format!("check data.csv --x x --y y --eps 1e-400 --claim-pui={claimed}"))
    };
    let run = check("-1e-400,2e-400,-1e-401,1e-330");
    assert_eq!(run.status, 4, "{run:?}");
    let text = unbroken(&run.stdout);
    for found in ["theta1 min: unsafe", "theta2 min: unsafe", "theta2 max: loose"] {
        assert!(text.contains(&format!("claimed PUI, decimal: {found}")), "{text}");
    }
    assert!(!text.contains("claimed PUI, decimal: theta1 max"), "{text}");
    assert_eq!(check("-2e-400,2e-400,-1e-400,1e-400").status, 0);
    assert_eq!(check("0,0,0,0").status, 4);
}

#[test]
fn duals_that_are_none_are_said_to_be() {
    let directory = directory_with(&[("data.csv", DATA.as_bytes())]);
    for (duals, said) in [
        ("[1, 2, 3]", "the 3 duals are not looked at: the program has 8 rows, each with one"),
        ("[0, 0, -0.5, 0, 1, 0, 0, 0]", "dual 3 is -0.5, and none below 0 is looked at"),
        ("[\"0\", \"0\", 0, \"-1/2\", 1, 0, 0, 0]", "dual 4 is -0.5, and none below 0 is looked at"),
    ] {
        let claim = format!("{{\"pui\": [[0.9, 1.1], [0.8, 1.2]], \"duals\": [{duals}, null, null, null]}}");
        fs::write(directory.path().join("claim.json"), claim).unwrap();
        let line = "check data.csv --x x --y y --eps 0.2 --claim claim.json";
        let run = boundfit(directory.path(), line);
        let text = run.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(said), "{}", run.stdout);
        let run = boundfit(directory.path(), &format!("{line} --format json"));
        assert!(run.stdout.contains(said), "{}", run.stdout);
    }
}

#[test]
fn reductions_that_contradict_themselves_are_refused() {
    let record = |rows: &str, sums: &str| {
        format!(
            "# boundfit/reduced/1 {{\"rows\":{rows},\"kept\":4,\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
             \"epsilon\":null,\"sums\":[{sums}]}}\nx,y\n1,2\n2,3.1\n3,3.9\n4,5\n"
        )
    };
    let counted = |rows: &str, sums: &str, [first, second]: [&str; 2]| {
        let text = record(rows, sums)
            .replace("reduced/1", "reduced/3")
            .replace("\n1,2\n", &format!("\n{first} 1,2\n"));
        text.replace("\n2,3.1\n3,", &format!("\n{second} 2,3.1\n1 3,")).replace("\n4,5", "\n1 4,5")
    };
    let directory = directory_with(&[]);
    let both = |text: &str| {
        ["fit - --x x --y y --eps 1 --no-lp", "reduce - --x x --y y"]
            .map(|line| boundfit_with_input(directory.path(), line, text.as_bytes()))
    };
    let is_true = [
        record("4", "\"10\",\"14\",\"30\",\"399/10\""),
        // A fifth reading that is equal to the first.
        counted("5", "\"11\",\"16\",\"31\",\"419/10\"", ["2", "1"]),
        // Two more readings within those that are kept.
        record("6", "\"15\",\"20.9\",\"42.5\",\"57.15\"")
            .replace("20.9", "209/10")
            .replace("42.5", "85/2")
            .replace("57.15", "1143/20"),
    ];
    for text in is_true {
        for run in both(&text) {
            assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{text}");
        }
    }
    let edited = record("4", "\"10\",\"14\",\"30\",\"399/10\"").replace("1,2\n", "1,2.05\n");
    let every = "it keeps every reading, but its sums are not those of the rows that follow";
    let so_many =
        "the rows that follow stand for every reading, but its sums are not those of so many of each";
    let beyond = "its sums are those of readings beyond the rows that it keeps, which none can be";
    let on_hulls =
        "its sums are those of readings on the hulls of the rows that it keeps, which no row counts";
    let none = "no readings beside those that it keeps have the sums that are left for them";
    for (text, message) in [
        (edited, every),
        (record("4", "\"0\",\"0\",\"0\",\"0\""), every),
        (record("4", "\"10\",\"14\",\"25\",\"1\""), every),
        (record("3", "\"10\",\"14\",\"30\",\"399/10\""), "it keeps more readings than it says there were"),
        (record("5", "\"12\",\"17\",\"33\",\"46\""), none),
        (record("1000000000", "\"10\",\"14\",\"30\",\"399/10\""), beyond),
        // x of the fifth reading is 1 and its y is 2, like those of the first row, which says that it stands for itself.
        (record("5", "\"11\",\"16\",\"31\",\"419/10\""), on_hulls),
        (counted("5", "\"11\",\"16\",\"31\",\"419/10\"", ["1", "2"]), so_many),
        // The remainder is a sixth reading without x and y.
        (counted("6", "\"11\",\"16\",\"31\",\"419/10\"", ["2", "1"]), beyond),
        // x of the fifth reading is 2 and its y is 9; or its x is 5.
        (record("5", "\"12\",\"23\",\"34\",\"579/10\""), beyond),
        (record("5", "\"15\",\"17\",\"55\",\"549/10\""), beyond),
    ] {
        for run in both(&text) {
            assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{text} {run:?}");
            assert!(
                run.stderr.contains(&format!("the reduction contradicts itself: {message}")),
                "{text} {run:?}"
            );
        }
    }
}

#[test]
fn groups_are_told_apart_as_their_names_are_written() {
    let table = "g,x,y\n\"a\",1,2\n\" a\",2,3\n\"a \",3,9\n\"a\n\",4,4\n a ,5,5\na,6,6\n";
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let text = boundfit(directory.path(), "fit data.csv --x x --y y --eps 1 --by g --format csv").stdout;
    let counts: Vec<(&str, &str)> = text
        .split("\n")
        .filter_map(|line| line.split_once(','))
        .map(|(group, rest)| (group, rest.split(',').next().unwrap()))
        .collect();
    // The line end in a name is part of its cell.
    assert_eq!(counts, [("group", "rows"), ("a", "3"), (" a", "1"), ("a ", "1"), ("\"", "1")], "{text}");
}

#[test]
fn no_cell_of_csv_is_a_formula() {
    let table = "g,x,y\n=cmd|1,1,2\n@SUM(A1),2,3\n-5,3,9\n'=1,4,4\n+1-2,5,5\n";
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let text = boundfit(directory.path(), "fit data.csv --x x --y y --eps 1 --by g --format csv").stdout;
    let groups: Vec<&str> = text.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(groups, ["'=cmd|1", "'@SUM(A1)", "-5", "''=1", "'+1-2"]);
}

#[cfg(unix)]
#[test]
fn links_in_a_circle_are_not_replaced() {
    let directory = directory_with(&[("data.csv", DATA.as_bytes())]);
    let link = |from: &str, to: &str| std::os::unix::fs::symlink(to, directory.path().join(from)).unwrap();
    link("one", "two");
    link("two", "one");
    let (of_data, loops) = ("data.csv --x x --y y --eps 1", "error: one: cannot write: ");
    for (line, message) in [
        (format!("fit {of_data} -o one"), loops),
        (format!("fit {of_data} --by x --format csv -o one"), loops),
        (format!("fit {of_data} --proof one"), loops),
        (format!("plot {of_data} --format svg -o one"), loops),
        (format!("plot {of_data} --figure all -o one"), "error: one: cannot create: "),
        (format!("check {of_data} -o one"), loops),
        (format!("lesson {of_data} -o one"), loops),
        (format!("convert {of_data} --to mps --objective theta1-min -o one"), loops),
        (format!("convert {of_data} --to mps -o one"), "error: one: cannot create: "),
        ("reduce data.csv --x x --y y -o one".to_owned(), loops),
        ("man -o one".to_owned(), loops),
        ("completions bash -o one".to_owned(), loops),
    ] {
        let run = boundfit(directory.path(), &line);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{line}");
        assert!(run.stderr.starts_with(message), "{line} {run:?}");
        assert_eq!(fs::read_link(directory.path().join("one")).unwrap(), Path::new("two"), "{line}");
    }
}

/// A factor multiplies the widths of intervals about their middles, which are not y where a law allows more error above than below.
#[test]
fn factors_say_what_they_multiply() {
    let directory = directory_with(&[("a.csv", b"x,y,e\n1,1,1\n2,2.4,1/2\n")]);
    let said = |options: &str| {
        let run = boundfit(directory.path(), &format!("fit a.csv --x x --y y --through-origin {options}"));
        unbroken(&run.stdout)
    };
    let grow = "would have to grow about their middles by a factor of at least 2.3334 (exactly 7/3).";
    let report = said("--eps +0.1/-0");
    assert!(report.contains(&format!("All intervals {grow}")), "{report}");
    let report = said("--eps +0.5/-0");
    let least = "eps_min 0.2 times the width of each interval, about its middle";
    assert!(report.contains(least) && report.contains("distance from the middles"), "{report}");
    assert!(said("--eps +0.5/-0 --brief").contains("eps_min 0.2 times the widths"));
    let swept = said("--eps +0.5/-0 --sweep 1/2..1");
    assert!(swept.contains("s multiplies the width of each interval, about its middle."), "{swept}");
    let own = said("--eps-column e");
    assert!(own.contains(" times each row's bound") && !own.contains("middles"), "{own}");
    let factor = |options: &str| said(&format!("{options} --format csv")).contains("least_factor,");
    assert_eq!([factor("--eps-column e"), factor("--eps 1")], [true, false]);
    let json = said("--eps +0.5/-0 --format json");
    assert!(json.contains("\"epsilon_min\": \"every reading has its own interval\""), "{json}");
    let refused = boundfit(directory.path(), "fit a.csv --x x --y y --eps +0.5/-0 --confidence 0.5");
    assert!(refused.status == 2 && refused.stderr.contains("intervals need not"), "{refused:?}");
}

/// Windows of x are told apart by x, which is that of the data.
#[test]
fn windows_and_runs_of_x_are_named_by_the_x_of_the_data() {
    let directory = directory_with(&[("w.csv", b"x,y\n3,1\n1,2\n2,3\n2,5\n1,9\n")]);
    let text = boundfit(directory.path(), "fit w.csv --x x --y y --eps 1 --window-x 1 --x-origin 2").stdout;
    let names: Vec<&str> = text.lines().map(|line| line.split(' ').next().unwrap()).collect();
    assert!(text.starts_with("x     count") && names.contains(&"1..2"), "{text}");
    assert!(text.contains("The first empty one is that of x 1..2\n"), "{text}");
    let csv =
        boundfit(directory.path(), "fit w.csv --x x --y y --eps 1 --window 2 --x-origin 2 --format csv")
            .stdout;
    assert!(csv.contains("\n1,2,2,3,1,"), "{csv}");
    let range = boundfit(directory.path(), "range w.csv --x x --y y --eps 1 --x-origin 2").stdout;
    assert!(range.contains("x from 2 to 3"), "{range}");
    let own = boundfit(directory.path(), "range w.csv --x x --y y --eps 1").stdout;
    let runs =
        |text: &str| text.lines().filter(|line| line.contains(" to ")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(runs(&range), runs(&own));
}

/// Options without an effect are refused, and a recommended command does what it is for.
#[test]
fn accepted_options_are_effective() {
    let directory = directory_with(&[("a.csv", b"x,y\n1,0\n2,123456789\n4,0\n9,1\n")]);
    let folder = directory.path();
    printed(folder, "reduce a.csv --x x --y y -o r.csv");
    let fit = "fit a.csv --x x --y y --eps 1e8";
    for (line, message) in [
        (
            format!("{fit} --window 2 --confidence 0.9"),
            "the argument '--window <N>' cannot be used with '--confidence <NUM>'",
        ),
        (
            format!("{fit} --sweep 0..2 --format csv"),
            "'--sweep' needs the format text, latex, markdown or json; other formats have no place for many sets",
        ),
        (
            format!("{fit} --x-eps 1 --full"),
            "'--full' is about a single set: with errors in x ('--x-eps') there may be two, one for each sign of theta1",
        ),
        (
            "plot r.csv --x x --y y --eps 1e8 --figure range -o p.svg".to_owned(),
            "'range' is about every reading, and the data are a reduction: ask about the table that it was made from",
        ),
        (
            "plot r.csv --x x --y y --eps 1e8 --figure status -o p.svg".to_owned(),
            "'status' is about every reading, and the data are a reduction: ask about the table that it was made from",
        ),
    ] {
        check_refusal(&boundfit(folder, &line), &line, 2, message);
    }
    let empty = boundfit(folder, "fit a.csv --x x --y y --eps 1 --rounding nearest").stdout;
    let step = empty.lines().find(|line| line.contains("boundfit fit ... --eps ")).unwrap();
    let least = step.split("--eps ").nth(1).unwrap().split(' ').next().unwrap();
    let again = boundfit(folder, &format!("fit a.csv --x x --y y --eps {least}"));
    assert_eq!(again.status, 0, "{step}");
}
