//! Short reports, tables of intervals, and names of files.

use boundfit_exact::Rational;
use boundfit_tests::cli::numbers::rational;
use boundfit_tests::cli::{
    FIT_TRANSDUCER, boundfit, boundfit_with_input, directory_with, printed, report, unbroken,
};
use boundfit_tests::program::root;
use serde_json::{Value, json};

#[test]
fn the_brief_report_has_ten_lines() {
    let text = printed(&root(), &format!("{FIT_TRANSDUCER} --brief"));
    let expected = "Set-membership fit
  model    z = theta1*Vz + theta2 + e
  error    |e| <= 0.0005
  data     fixtures/transducer/transducer.csv, rows 14..36: 23 of 46
  reading  decimal: numbers exactly as written
  set      polygon with 6 vertices
  theta1   in [0.0017908, 0.0018484]; central 0.001819636 +-0.000028745
  theta2   in [0.022595, 0.022808]; central 0.02270164 +-0.00010578
  eps_min  0.00039444, fixed by 14 upper, 24 lower, 34 upper
           least squares 0.001819424 and 0.02279063, not feasible
";
    assert_eq!(text, expected);
    let markdown = printed(&root(), &format!("{FIT_TRANSDUCER} --brief --format markdown"));
    assert!(markdown.contains("| set | polygon with 6 vertices |"), "{markdown}");
    let run = boundfit(&root(), "fit fixtures/norris/norris.csv --x x --y y --eps 1 --brief");
    assert_eq!((run.status, run.stderr.as_str()), (3, ""));
    for part in ["set empty", "contradict each other: 4 lower, 29 upper, 34 upper.", "to at least 1.9847"] {
        assert!(unbroken(&run.stdout).contains(part), "{part}: {}", run.stdout);
    }
}

#[test]
fn options_that_a_format_has_no_use_for_are_refused() {
    for (options, message) in [
        ("--vertices", "'--vertices' needs '--format csv'; other formats contain the vertices anyway"),
        (
            "--brief --format json",
            "'--brief', '--full' and '--inverse' need the format text, latex or markdown; other formats contain everything",
        ),
        (
            "--inverse --format csv",
            "'--brief', '--full' and '--inverse' need the format text, latex or markdown; other formats contain everything",
        ),
        (
            "--brief --full",
            "'--brief' reports ten lines: it goes with none of '--full', '--sweep', '--inverse' and '--confidence'",
        ),
    ] {
        let run = boundfit(&root(), &format!("{FIT_TRANSDUCER} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.starts_with(&format!("error: {message}\n")), "{}", run.stderr);
    }
}

/// Every bound as a double encloses the exact one beside it, which is that of JSON.
#[test]
fn the_table_of_a_fit_has_its_intervals_and_estimates() {
    let json = report(&root(), FIT_TRANSDUCER, b"");
    let csv = printed(&root(), &format!("{FIT_TRANSDUCER} --format csv"));
    let mut lines = csv.lines();
    let header = "quantity,parameter,lower,upper,value,lower_exact,upper_exact,value_exact";
    assert_eq!(lines.next(), Some(header));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let row = |quantity: &str, parameter: &str| {
        let own = rows.iter().filter(|row| row[..2] == [quantity, parameter]).collect::<Vec<_>>();
        assert_eq!(own.len(), 1, "{quantity} {parameter}");
        own[0].clone()
    };
    for (axis, parameter) in ["theta1", "theta2"].into_iter().enumerate() {
        let pui = row("pui", parameter);
        let [lower, upper] = ["lower", "upper"].map(|end| &json["pui"][axis][end]["exact"]);
        assert_eq!([pui[5], pui[6]], [lower.as_str().unwrap(), upper.as_str().unwrap()]);
        let central = row("central", parameter);
        assert_eq!(central[7], json["central"]["theta"][axis]["exact"]);
        assert_eq!(central[4].parse::<f64>().unwrap(), json["central"]["theta"][axis]["value"]);
        assert_eq!(row("guaranteed_error", parameter)[7], json["central"]["guaranteed_error"][axis]["exact"]);
        assert_eq!(row("minimax", parameter)[7], json["minimax"]["theta"][axis]["exact"]);
    }
    assert_eq!(row("set", "kind")[2..], ["", "", "", "", "", "polygon"]);
    for parameter in ["gain", "offset"] {
        for (quantity, range) in [("pui", "box_range"), ("fps", "exact_range"), ("eui", "eui_range")] {
            let range = &json["inverse"][parameter][range][0];
            assert_eq!(row(quantity, parameter)[5], range["lower"]["exact"], "{quantity} {parameter}");
            assert_eq!(row(quantity, parameter)[6], range["upper"]["exact"], "{quantity} {parameter}");
        }
    }
    assert_eq!(row("least_error_bound", "")[7], json["epsilon_min"]["exact"]);
    for row in &rows {
        let double = |cell: &str| Rational::from_f64(cell.parse().unwrap()).unwrap();
        if !row[2].is_empty() {
            assert!(double(row[2]) <= rational(row[5]) && rational(row[6]) <= double(row[3]), "{row:?}");
        }
    }
    let strip = printed(&root(), "fit fixtures/claims/strip.csv --x x --y y --eps 0.2 --format csv");
    assert!(strip.contains("\npui,theta1,-inf,inf,,,,\n"), "{strip}");
    let empty = boundfit(&root(), "fit fixtures/norris/norris.csv --x x --y y --eps 1 --format csv").stdout;
    assert!(empty.contains("\nset,kind,,,,,,empty\n") && !empty.contains("\npui,"), "{empty}");
}

#[test]
fn json_names_the_file() {
    let table = b"x,y\n0,0\n1,1\n2,2\n";
    let directory = directory_with(&[("a b.csv", table)]);
    let own = report(directory.path(), "fit 'a b.csv' --x x --y y --eps 1", b"");
    assert_eq!(own["input"]["file"], "a b.csv");
    let input = |line: &str, table: &[u8]| -> Value {
        serde_json::from_str(&boundfit_with_input(directory.path(), line, table).stdout).unwrap()
    };
    assert_eq!(input("fit - --x x --y y --eps 1 --format json", table)["input"]["file"], Value::Null);
    let checked = &input("check - --x x --y y --eps 1 --format json", table)["input"];
    assert_eq!(checked, &json!({"file": null, "table": own["input"]["table"]}));
    assert_eq!(input("polygon - --format json", b"a1,a2,b\n1,0,1\n")["input"]["file"], Value::Null);
    let house = report(&root(), "polygon fixtures/polygon/house.csv", b"");
    assert_eq!(house["input"]["file"], "fixtures/polygon/house.csv");
}

#[test]
fn an_empty_set_says_which_row_would_mend_it() {
    let fit = |table: &str, options: &str| {
        let line = format!("fit - --x x --y y --eps 1/4 {options}");
        boundfit_with_input(&root(), &line, table.as_bytes()).stdout
    };
    let outlier = "x,y\n0,0\n1,1\n2,2\n3,30\n4,4\n";
    let said = "Without row 4 the set is not empty; no other single row has this effect.";
    assert!(unbroken(&fit(outlier, "")).contains(said), "{}", fit(outlier, ""));
    let json: Value = serde_json::from_str(&fit(outlier, "--format json")).unwrap();
    assert_eq!((&json["mended_without"], &json["reasons"]["mended_without"]), (&json!([4]), &Value::Null));
    let three = "x,y\n0,0\n1,1\n2,0\n";
    let said = "Without any one of the rows 1, 2 and 3 the set is not empty; no other row has this effect.";
    assert!(unbroken(&fit(three, "")).contains(said), "{}", fit(three, ""));
    let two = "x,y\n0,0\n0,1\n1,0\n1,1\n";
    assert!(
        unbroken(&fit(two, ""))
            .contains("No single row is to blame: without any one of them the set stays empty."),
        "{}",
        fit(two, "")
    );
    // Nobody can mend it by leaving readings out, so no next step says so.
    let conditions = fit(three, "--where theta1<=0 --where theta1>=1");
    let said = "No reading is to blame: the conditions contradict each other whatever the readings are.";
    assert!(unbroken(&conditions).contains(said), "{conditions}");
    assert!(!conditions.contains("Next steps"), "{conditions}");
    let json: Value = serde_json::from_str(&fit("x,y\n0,0\n1,1\n", "--format json")).unwrap();
    assert_eq!(json["mended_without"], Value::Null);
    // Above ten thousand rows those that bound nothing now are not at hand.
    let many: String = (0..10_001).map(|x| format!("{x},{}\n", if x == 5 { 9 } else { 0 })).collect();
    let many = fit(&format!("x,y\n{many}"), "--format json --no-eui");
    let json: Value = serde_json::from_str(&many).unwrap();
    assert_eq!(json["mended_without"], Value::Null);
    assert_eq!(json["reasons"]["mended_without"], "since not every reading is kept in memory");
}

#[test]
fn a_double_is_repeated_as_it_was_typed() {
    let fit = format!("{FIT_TRANSDUCER} --reading binary64 --brief").replace("0.5e-3", "0.1");
    assert!(printed(&root(), &fit).contains("\n  error    |e| <= 0.1 (as a double)\n"));
}

#[test]
fn a_solver_is_known_by_the_name_that_is_printed() {
    let line = FIT_TRANSDUCER.replacen("fit", "check", 1);
    let check = |name: &str| boundfit(&root(), &format!("{line} --solver '{name}'"));
    let (named, printed) = (check("microlp"), check("microlp 0.7"));
    assert_eq!((named.status, &named.stdout), (printed.status, &printed.stdout));
    assert!(named.stdout.contains("microlp 0.7"));
    assert!(
        check("microlp 9")
            .stderr
            .contains("there is no solver \"microlp 9\" in this build; it has microlp, ")
    );
}
