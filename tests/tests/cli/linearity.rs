//! `boundfit linearity`: answers to every digit, directions, what is null, refusals.

use std::fs;

use boundfit_tests::cli::numbers::{check_numbers, exact};
use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, unbroken};
use boundfit_tests::lp_cases::number;
use boundfit_tests::program::root;
use serde_json::Value;

const LVDT: &str = "linearity fixtures/linearity/lvdt.csv --x x_mm --up up_mV --down down_mV";
const CYCLES: &str = "linearity fixtures/linearity/cycles.csv --x x_mm --y mV --direction direction";

fn report(directory: &std::path::Path, line: &str) -> Value {
    let run = boundfit(directory, &format!("{line} --format json"));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{line}");
    serde_json::from_str(&run.stdout).unwrap()
}

/// Deviation and percent of the four ways, in the order of the course's table.
fn ways(report: &Value) -> Vec<(String, String)> {
    let of = |name: &str| {
        let text = |part: &str| report[name][part]["exact"].as_str().unwrap_or("null").to_owned();
        (text("deviation"), text("percent"))
    };
    ["independent", "terminal", "least_squares", "zero_based"].map(of).into()
}

fn pairs(expected: [(&str, &str); 4]) -> Vec<(String, String)> {
    expected.map(|(deviation, percent)| (deviation.to_owned(), percent.to_owned())).into()
}

/// A deviation in a data sheet must not be below the true one, so it is rounded up as in JSON.
#[test]
fn deviations_and_percentages_in_csv_are_rounded_up() {
    let data = b"x,y\n8,-9\n5.41,-7.54\n-5.01,-3.7\n";
    let run = boundfit_with_input(&root(), "linearity - --x x --y y --format csv", data);
    let lines: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines[1][1..4], ["independent", "0.2024442736356649", "3.8197032761446206"]);
    let numbers = lines[1..].iter().flat_map(|row| [(row[2], row[6]), (row[3], row[7])]);
    for (double, exact) in numbers.filter(|(double, _)| !double.is_empty()) {
        let double: f64 = double.parse().unwrap();
        assert_eq!(double, number(exact).ceil_to_f64(), "{exact}");
    }
}

#[test]
fn the_sensor_of_the_course_to_every_digit() {
    let report = report(&root(), LVDT);
    assert_eq!(report["schema"], "boundfit/linearity/1");
    let average =
        [("21/200", "140/51"), ("21/100", "280/51"), ("503/4130", "201200/63189"), ("1/5", "800/153")];
    assert_eq!(ways(&report), pairs(average));
    let up = [("7/50", "40/11"), ("7/25", "80/11"), ("613/4130", "122600/31801"), ("1/5", "400/77")];
    assert_eq!(ways(&report["up"]), pairs(up));
    let down = [("1/12", "125/57"), ("7/50", "70/19"), ("23/236", "2875/1121"), ("1/5", "100/19")];
    assert_eq!(ways(&report["down"]), pairs(down));
    let text = |value: &Value| value["exact"].as_str().unwrap().to_owned();
    assert_eq!(text(&report["full_scale"]), "153/40");
    assert_eq!((text(&report["hysteresis"]), &report["repeatability"]), ("3/20".into(), &Value::Null));
    assert_eq!(text(&report["independent"]["theta"][0]), "153/400");
    assert_eq!(text(&report["least_squares"]["theta"][0]), "155/413");
    assert_eq!(report["independent"]["rows"], serde_json::json!([1, 5, 6]));
    let proof: Vec<(Value, String, String)> = report["proof"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| (point["rows"].clone(), text(&point["residual"]), text(&point["weight"])))
        .collect();
    let expected = [(1, "21/200", "1/10"), (5, "-21/200", "1/2"), (6, "21/200", "2/5")];
    let expected =
        expected.map(|(row, own, weight)| (serde_json::json!([row]), own.to_owned(), weight.to_owned()));
    assert_eq!(proof, expected);
    assert!(check_numbers(&report, 5) > 50);
}

#[test]
fn readings_below_each_other_are_averaged_by_direction() {
    let report = report(&root(), CYCLES);
    // Two upscale readings at 0, 4 and 10: averaged before the mean of both directions.
    let text = |value: &Value| value["exact"].as_str().unwrap().to_owned();
    assert_eq!(text(&report["repeatability"]), "1/20");
    assert_eq!(text(&report["hysteresis"]), "1/8");
    assert_eq!(report["input"]["direction"]["up"], serde_json::json!(["up"]));
    assert_eq!(report["input"]["points"], 6);
    assert_eq!(report["repeatability_at"].as_array().unwrap().len(), 2);
    assert_eq!(report["repeatability_at"][0]["rows"], serde_json::json!([1, 13]));
}

#[test]
fn the_same_numbers_in_two_columns_and_below_each_other() {
    let directory = directory_with(&[]);
    let two = fs::read_to_string(root().join("fixtures/linearity/lvdt.csv")).unwrap();
    let mut below = String::from("x;y;d\n");
    for line in two.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        below += &format!("{};{};Rising\n{};{};falling\n", cells[0], cells[1], cells[0], cells[2]);
    }
    fs::write(directory.path().join("two.csv"), &two).unwrap();
    fs::write(directory.path().join("below.csv"), below).unwrap();
    let one = report(directory.path(), "linearity two.csv --x x_mm --up up_mV --down down_mV");
    let other = report(directory.path(), "linearity below.csv --x x --y y --direction d");
    for part in [&one, &one["up"], &one["down"]].into_iter().zip([&other, &other["up"], &other["down"]]) {
        assert_eq!(ways(part.0), ways(part.1));
    }
    assert_eq!(one["hysteresis"], other["hysteresis"]);
}

/// Far from x = 0 each digit of the slope moves the line by much.
#[test]
fn lines_have_the_digits_of_their_deviations() {
    let report = |table: &[u8]| {
        let run = boundfit_with_input(&root(), "linearity - --x t --y y", table);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        unbroken(&run.stdout)
    };
    let straight = report(b"t,y\n1764288000,5\n1764288600,5.6\n1764289800,6.8\n");
    assert!(straight.contains("independent 0 0 0.001 -1764283 1, 2, 3 "), "{straight}");
    // The slope is 1/900.
    let bent = report(b"t,y\n1764288000,5\n1764288600,5.6\n1764289800,7\n");
    let [slope, intercept] = ["0.001111111111", "-1960315.033"];
    let line = format!("independent 0.033334 1.6667 {slope} {intercept} 1, 2, 3 ");
    assert!(bent.contains(&line), "{bent}");
    let deviations = [("1764288000", "5"), ("1764288600", "5.6"), ("1764289800", "7")]
        .map(|(t, y)| (number(y) - (number(slope) * number(t) + number(intercept))).abs());
    assert!(deviations.into_iter().max() <= Some(number("1/30") * number("1.05")));
    // No two readings look the same in the proof.
    let proof = "1.764288e9 1 +0.033333 1/3 1.7642886e9 2 -0.033333 1/2 1.7642898e9 3 +0.033333 1/6 ";
    assert!(bent.contains(proof), "{bent}");
}

#[test]
fn readings_without_directions_are_taken_as_they_are() {
    let directory = directory_with(&[("twice.csv", b"x,y\n0,0\n1,1\n1,3\n2,2\n")]);
    let report = report(directory.path(), "linearity twice.csv --x x --y y");
    // As the least bound of a fit of the same four readings.
    let run = boundfit(directory.path(), "fit twice.csv --x x --y y --eps min --format json");
    let fit: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(exact(&report["independent"]["deviation"]), exact(&fit["epsilon_min"]));
    assert_eq!(report["independent"]["deviation"]["exact"], "1");
    assert_eq!((&report["hysteresis"], &report["up"]), (&Value::Null, &Value::Null));
    assert_eq!(report["repeatability"]["exact"], "2");
}

#[test]
fn what_there_is_not_is_null_with_a_reason() {
    let directory = directory_with(&[
        ("one.csv", b"x,y\n3,4\n"),
        ("vertical.csv", b"x,y\n3,4\n3,6\n3,5\n"),
        ("level.csv", b"x,y\n0,4\n1,4\n2,4\n"),
        ("sides.csv", b"x,up,down\n0,1,\n1,,2\n2,5,3\n"),
    ]);
    let one = report(directory.path(), "linearity one.csv --x x --y y");
    assert_eq!((&one["terminal"], &one["least_squares"]), (&Value::Null, &Value::Null));
    assert_eq!(one["independent"]["deviation"]["exact"], "0");
    assert_eq!(
        (&one["independent"]["percent"], &one["independent"]["unique"]),
        (&Value::Null, &Value::Bool(false))
    );
    assert!(one["reasons"]["percent"].as_str().unwrap().contains("full scale is 0"));
    assert!(one["reasons"]["terminal"].as_str().unwrap().contains("the same x"));
    let vertical = report(directory.path(), "linearity vertical.csv --x x --y y --through 3,0");
    assert_eq!(vertical["independent"]["percent"]["exact"], "50");
    assert_eq!(vertical["zero_based"]["deviation"]["exact"], "6");
    assert_eq!(vertical["proof"].as_array().unwrap().len(), 2);
    let level = report(directory.path(), "linearity level.csv --x x --y y");
    assert_eq!((&level["terminal"]["percent"], &level["proof"]), (&Value::Null, &serde_json::json!([])));
    let given = report(directory.path(), "linearity level.csv --x x --y y --full-scale 8");
    assert_eq!(given["zero_based"]["percent"]["exact"], "50");
    let sides = report(directory.path(), "linearity sides.csv --x x --up up --down down");
    assert_eq!((&sides["hysteresis"]["exact"], &sides["input"]["points"]), (&"2".into(), &3.into()));
    for file in ["one", "vertical", "level"] {
        let run =
            boundfit(directory.path(), &format!("linearity {file}.csv --x x --y y --figure {file}.svg"));
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{file}");
    }
    let text = unbroken(&boundfit(directory.path(), "linearity one.csv --x x --y y").stdout);
    assert!(text.contains("No terminal linearity: all readings have the same x"), "{text}");
    assert!(text.contains("No percentages: full scale is 0"), "{text}");
}

#[test]
fn every_format_is_written_and_recognised_as_ours() {
    let directory = directory_with(&[]);
    let data = root().join("fixtures/linearity/lvdt.csv");
    let line = format!("linearity '{}' --x x_mm --up up_mV --down down_mV", data.display());
    for ending in ["txt", "json", "csv", "md", "tex"] {
        for _ in 0..2 {
            // The second time it replaces what it wrote.
            let run = boundfit(directory.path(), &format!("{line} -o out.{ending} --figure picture.svg"));
            assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""), "{ending}");
        }
    }
    let csv = fs::read_to_string(directory.path().join("out.csv")).unwrap();
    assert!(csv.contains(
        "\naverage,independent,0.10500000000000001,2.7450980392156863,0.3825,0.095,21/200,140/51,153/400,19/200,1 5 6\n"
    ));
    let png = boundfit(directory.path(), &format!("{line} -o a.txt --figure a.png"));
    assert_eq!(png.status, 0);
    assert!(fs::read(directory.path().join("a.png")).unwrap().starts_with(b"\x89PNG"));
    let pdf = boundfit(directory.path(), &format!("{line} -o b.txt --figure b.pdf"));
    assert_eq!(pdf.status, 0);
    assert!(fs::read(directory.path().join("b.pdf")).unwrap().starts_with(b"%PDF-"));
}

#[test]
fn the_picture_in_the_book_is_the_one_that_is_drawn() {
    let directory = directory_with(&[]);
    let data = root().join("fixtures/linearity/lvdt.csv");
    let line = format!("linearity '{}' --x x_mm --up up_mV --down down_mV", data.display());
    let run = boundfit(directory.path(), &format!("{line} --x-unit mm --y-unit mV --figure linearity.svg"));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let [drawn, printed] =
        [directory.path().join("linearity.svg"), root().join("docs/pictures/linearity.svg")].map(fs::read);
    assert!(drawn.unwrap() == printed.unwrap(), "copy it again");
}

#[test]
fn bad_usage_is_refused() {
    let cases = [
        (
            "--full-scale 0",
            "invalid value '0' for '--full-scale <NUM>': expected a number above 0, such as 4 or 153/40",
        ),
        (
            "--full-scale -4",
            "invalid value '-4' for '--full-scale <NUM>': expected a number above 0, such as 4 or 153/40",
        ),
        (
            "--full-scale x",
            "invalid value 'x' for '--full-scale <NUM>': not a number: unexpected character 'x' at character 1 (expected a \
             number above 0, such as 4 or 153/40)",
        ),
        (
            "--through 3",
            "invalid value '3' for '--through <X,Y>': expected two numbers X,Y such as 0,0 or 2.5,-1/3",
        ),
        (
            "--figure a.gif",
            "invalid value 'a.gif' for '--figure <FILE>': a picture is SVG, PNG, PDF or TikZ (expected a name that ends in .svg, .png, .pdf, .tikz or .tex)",
        ),
    ];
    for (options, message) in cases {
        refuses(&root(), &format!("{LVDT} {options}"), 2, message);
    }
    let y = "linearity fixtures/linearity/lvdt.csv --x x_mm --y up_mV";
    let other = "linearity fixtures/linearity/lvdt.csv --x x_mm";
    for line in [
        format!("{y} --up up_mV --down down_mV"),
        format!("{y} --down down_mV"),
        format!("{other} --up up_mV"),
        format!("{other} --up up_mV --down down_mV --direction up_mV"),
    ] {
        let message = "expected '--y', or '--y' and '--direction', or '--up' and '--down'";
        refuses(&root(), &line, 2, message);
    }
}

#[test]
fn bad_data_is_refused_with_its_row() {
    let directory = directory_with(&[
        ("words.csv", b"x,y,d\n0,1,in\n1,2,out\n2,3,over\n"),
        ("none.csv", b"x,y,d\n0,1,up\n1,2,\n"),
        ("empty.csv", b"x,up,down\n0,1,2\n1,,\n"),
        ("text.csv", b"x,y\n0,1\n1,two\n"),
    ]);
    let directions = "--x x --y y --direction d";
    refuses(
        directory.path(),
        &format!("linearity words.csv {directions}"),
        1,
        "words.csv: data row 3: \"over\" is a third direction beside \"in\" and \"out\" (expected up and down, or two words of \
         which the first one met is up)",
    );
    refuses(
        directory.path(),
        &format!("linearity none.csv {directions}"),
        1,
        "none.csv: data row 2: the direction is missing (expected up or down)",
    );
    refuses(
        directory.path(),
        "linearity empty.csv --x x --up up --down down",
        1,
        "empty.csv: data row 2 has a reading in neither direction",
    );
    let skipped = report(directory.path(), "linearity empty.csv --x x --up up --down down --missing skip");
    assert_eq!((&skipped["input"]["rows"], &skipped["input"]["rows_missing"]), (&1.into(), &1.into()));
    refuses(
        directory.path(),
        "linearity text.csv --x x --y y",
        1,
        "text.csv: line 3, column 2 (y): \"two\": not a number: unexpected character 't' at character 1 (expected a decimal such as \
         1.30e-2 or a fraction such as 7/19)",
    );
}

#[test]
fn proofs_of_linearity_are_true_of_the_data() {
    let directory = directory_with(&[
        ("plain.csv", b"x,y\n0,0\n1,1\n1,3\n2,2\n5,5\n"),
        ("line.csv", b"x,y\n0,1\n1,2\n2,3\n"),
        ("one.csv", b"x,y\n3,4\n"),
        ("sides.csv", b"x,up,down\n0,1,2\n1,2,2\n2,5,3\n"),
        ("twice.csv", b"x,up,down\n0,1,2\n1,2,2\n1,5,3\n"),
    ]);
    let verifies = |file: &str, options: &str| {
        let run = boundfit(
            directory.path(),
            &format!("linearity {file} --x x {options} --proof p.json -o out.txt"),
        );
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{file}");
        let verified = boundfit(directory.path(), &format!("verify p.json {file}"));
        assert_eq!((verified.status, verified.stderr.as_str()), (0, ""), "{file}");
        // The proof is not true of changed data.
        let other = std::fs::read_to_string(directory.path().join(file)).unwrap() + "9,9,9\n";
        std::fs::write(directory.path().join("other.csv"), other).unwrap();
        assert_eq!(boundfit(directory.path(), "verify p.json other.csv").status, 4, "{file}");
    };
    for file in ["plain.csv", "line.csv", "one.csv"] {
        verifies(file, "--y y");
    }
    verifies("sides.csv", "--up up --down down");
    let twice = boundfit(directory.path(), "linearity twice.csv --x x --up up --down down --proof p.json");
    assert_eq!(twice.status, 2);
    assert!(twice.stderr.contains("of which each is a point of its own"), "{}", twice.stderr);
    for (options, problem) in [
        ("twice.csv --x x --y up --direction down", "'--proof' is about rows of which each is a point"),
        ("- --x x --y y", "'--proof' reads the data once more"),
    ] {
        let run = boundfit(directory.path(), &format!("linearity {options} --proof p.json"));
        assert!(run.status == 2 && run.stderr.starts_with(&format!("error: {problem}")), "{}", run.stderr);
    }
    let same = boundfit(directory.path(), "linearity plain.csv --x x --y y --proof p.json -o p.json");
    assert!(same.stderr.starts_with("error: '--proof' needs a file of its own"), "{}", same.stderr);
}

/// A point with one of its two readings has a mean in the report, and none that a proof could state.
#[test]
fn a_proof_needs_both_readings_of_a_point() {
    let directory = directory_with(&[("a.csv", b"x,u,d\n0,0,0.1\n1,1,1.1\n2,2.2,\n3,3,3.1\n")]);
    let line = "linearity a.csv --x x --up u --down d";
    assert_eq!(boundfit(directory.path(), line).status, 0);
    for options in ["", "--missing skip"] {
        let run = boundfit(directory.path(), &format!("{line} {options} --proof p.json"));
        let message = "error: '--proof' is about the rows of delimited text of which each is a point of its own, with a reading in every column";
        assert!(run.status == 2 && run.stderr.starts_with(message), "{run:?}");
    }
}
