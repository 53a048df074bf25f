//! Intervals, rows with one bound and laws, through the program.

use boundfit_tests::cli::{boundfit, directory_with, printed, report, unbroken};
use boundfit_tests::program::{Run, root};
use serde_json::Value;

const TABLE: &str = "t,y,lo,up,by,v\n0,1,0.5,1.5,a,1\n1,2,,3,b,0\n2,3,1.5,4,a,1\n3,4,3,,b,2\n4,4.5,3.9,5.2,a,1\n0,1,NA,1.4,b,3\n";
const BOTH: &str = "--x t --lower lo --upper up";

fn refused(table: &str, options: &str) -> String {
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let run = boundfit(directory.path(), &format!("fit data.csv {options}"));
    assert!(run.status == 1 || run.status == 2, "{options}: {run:?}");
    assert_eq!(run.stdout, "", "{options}");
    run.stderr.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

#[test]
fn what_is_no_bound_is_refused_with_advice() {
    let neither = "the row has neither a lower nor an upper bound (expected a number in a column of bounds, or the file without this row)";
    let table = "t,y,lo,up\n0,1,0,1\n1,1,,\n";
    let place = "data.csv: line 3, column 3 (lo): \"\"";
    for options in [BOTH, "--x t --lower lo", "--x t --lower lo --upper up --by y"] {
        assert_eq!(refused(table, options), format!("{place}: {neither}"));
        // Quotes and line ends do not matter.
        let quoted = table.replace("0,1,0,1", "\"0\",1,0,1").replace('\n', "\r\n");
        assert_eq!(refused(&quoted, options), format!("{place}: {neither}"));
    }
    let words = "t,lo,up\n0,N/A,1\n1,,2\n2,0,n/a\n3,NA,?\n";
    assert_eq!(refused(words, BOTH), format!("data.csv: line 5, column 2 (lo): \"NA\": {neither}"));
    // A word with a slash for what is missing is no fraction.
    let directory = directory_with(&[("data.csv", b"t,lo,up\n0,N/A,1\n1,1/2,2\n2,0,n/a\n")]);
    let fractions = &report(directory.path(), &format!("fit data.csv {BOTH}"), b"")["input"]["fractions"];
    assert!(fractions.as_array().unwrap().iter().all(|column| column["first"] == "1/2"), "{fractions}");
    let law = |text: &str| refused(TABLE, &format!("--x t --y y --eps '{text}'"));
    for (text, problem) in [
        (
            "2%",
            "2% of what? Write 2%*|y| for that share of each reading, 2%*range(y) for that share of the span of all readings; a share of a full scale is a number: 0.2 for 2% of 10",
        ),
        (
            "1%*|y| + 0.1%*10",
            "0.1% of what? Write 0.1%*|y| for that share of each reading, 0.1%*range(y) for that share of the span of all readings; a share of a full scale is a number: 0.2 for 2% of 10",
        ),
        (
            "1% + 3 digits",
            "the digits of a data sheet are units of the last digit written, and 'written' is half of one: 3 digits are \
             6*written, and \"1% + 3 digits\" is 1%*|y| + 6*written",
        ),
        (
            "|y| - 1",
            "a term that is subtracted at character 5: for another bound above than below write +ABOVE/-BELOW (expected a \
             number such as 0.5e-3, or a law such as \"0.05%*|y| + 2e-3\", \"written\" or \"+0.2/-0.1\")",
        ),
    ] {
        assert_eq!(law(text), format!("invalid value '{text}' for '--eps <NUM>': {problem}"));
    }
    assert_eq!(
        refused(TABLE, "--x t,v --y y --eps '1%*|x|'"),
        "invalid value '1%*|x|' for '--eps <NUM>': two regressors have no |x| (expected a law of |y|, range(y) and written)"
    );
    assert_eq!(
        refused("t,y\n0,1/3\n", "--x t --y y --eps written"),
        "data.csv: line 2, column 2 (y): \"1/3\": a fraction has no last digit, of which 'written' is half a unit \
         (expected a decimal such as 1.30e-2)"
    );
    let root = boundfit_tests::program::root();
    let stored = boundfit(&root, "fit fixtures/mat/transducer-v7.mat --x Vz --y z --eps written");
    let message = "'written' is half a unit of the last digit written, and a MATLAB file stores numbers without their \
                   digits (expected a bound as a number, such as 0.005, or a law without 'written')";
    assert!(stored.stderr.contains(message), "{stored:?}");
    assert!(refused(TABLE, "--x t --lower lo --eps 1").contains("the errors have one bound"));
    assert!(refused(TABLE, "--x t --eps 1").contains("required arguments were not provided"));
}

/// Proofs of both checkers for many ways to state bounds, and that a changed table is not what they are about.
#[test]
fn proofs_state_the_bounds_as_they_were_asked_for() {
    for options in [
        BOTH,
        "--x t --lower lo",
        "--x t --upper up",
        "--x t,v --lower lo --upper up",
        "--x t --y y --lower lo --upper up",
        "--x t --y y --eps 'written + 1%*|y|'",
        "--x t --y y --eps '10%*|x| + 1%*range(y) + written'",
        "--x t --y y --eps '+written/-0.7'",
        "--x t --y y --eps '40%*range(y)'",
        "--x t,v --y y --eps 'written + 90%*|y|' --reading binary64",
        "--x t --lower up --upper lo",
    ] {
        let rows = if options.contains("--lower up") {
            "t,lo,up\n0,1,2\n1,1,1\n".to_owned()
        } else if options == "--x t --lower lo" {
            TABLE.replace("1,2,,3,b,0\n", "").replace("0,1,NA,1.4,b,3\n", "")
        } else if options == "--x t --upper up" {
            TABLE.replace("3,4,3,,b,2\n", "")
        } else {
            TABLE.to_owned()
        };
        let directory = directory_with(&[("data.csv", rows.as_bytes())]);
        let fitted =
            boundfit(directory.path(), &format!("fit data.csv {options} --no-lp --proof proof.json"));
        assert!(fitted.status == 0 || fitted.status == 3, "{options}: {fitted:?}");
        let verified: Run = boundfit(directory.path(), "verify proof.json data.csv");
        assert_eq!(verified.status, 0, "{options}: {verified:?}");
        let judge = boundfit_tests::program::root().join("tests/verify.py");
        let judged = std::process::Command::new("python3")
            .args([judge.to_str().unwrap(), "proof.json", "data.csv"])
            .current_dir(directory.path())
            .output();
        if let Ok(judged) = judged {
            assert!(judged.stdout.starts_with(b"verified: {"), "{options}: {judged:?}");
        }
    }
}

#[test]
fn every_command_takes_intervals() {
    let directory = directory_with(&[("data.csv", TABLE.as_bytes())]);
    let here = directory.path();
    let fit = report(here, &format!("fit data.csv {BOTH}"), b"");
    assert_eq!(fit["input"]["interval"], serde_json::json!({"lower": "lo", "upper": "up"}));
    assert_eq!((&fit["input"]["y"], &fit["least_squares"]), (&Value::Null, &Value::Null));
    let reason = "no column of y was given, and a reading with one bound only has no middle to take instead";
    assert_eq!(fit["reasons"]["least_squares"], reason);
    let with_y = report(here, &format!("fit data.csv {BOTH} --y y"), b"");
    assert_eq!(with_y["pui"], fit["pui"]);
    assert!(with_y["least_squares"]["theta"].is_array());
    assert_eq!(
        with_y["reasons"]["eui"],
        "a reading has one bound only, so that nothing limits its error on the other side"
    );
    let upper = "0,1,,1.5\n1,2,,3\n";
    let one_sided = report(here, "fit - --x 1 --upper 4 --header no", upper.as_bytes());
    assert_eq!(
        one_sided["reasons"]["minimax"],
        "no row has both bounds, so there is no width that could grow"
    );
    assert_eq!(one_sided["fps"]["kind"], "unbounded-polygon");
    let law = report(here, "fit data.csv --x t --y y --eps '0.1 + 1%*|y|'", b"");
    assert_eq!(law["input"]["epsilon_law"], "0.1 + 1%*|y|");
    for line in [
        format!("check data.csv {BOTH} --solver microlp"),
        format!("convert data.csv {BOTH} --to mps --objective theta1-min"),
        format!("plot data.csv {BOTH} --figure data"),
        format!("plot data.csv {BOTH} --figure fps"),
        format!("lesson data.csv {BOTH}"),
        format!("fit data.csv {BOTH} --by by --format csv"),
        format!("fit data.csv {BOTH} --where 'theta1 >= 0' --sweep 0.5..2"),
        "plot data.csv --x t --y y --eps '+0.5/-written' --figure data".to_owned(),
        "fit data.csv --x t --y y --eps '50%*range(y)' --by by --format csv".to_owned(),
    ] {
        let run = boundfit(here, &line);
        assert!(run.status == 0 || run.status == 3, "{line}: {run:?}");
        assert!(!run.stdout.is_empty(), "{line}");
    }
    let converted = printed(here, &format!("convert data.csv {BOTH} --to lp --objective theta1-min"));
    assert!(converted.contains("row1_upper") && converted.contains("row4_lower"), "{converted}");
    assert!(!converted.contains("row2_lower") && !converted.contains("row4_upper"), "{converted}");
}

#[test]
fn bounds_of_one_row_that_cross_are_the_proof_of_an_empty_set() {
    let directory = directory_with(&[("data.csv", b"t,lo,up\n0,2,1\n1,0,9\n2,3,\n")]);
    let fit = report(directory.path(), &format!("fit data.csv {BOTH}"), b"");
    let farkas = &fit["fps"]["certificate"]["farkas"];
    let named: Vec<(u64, &str)> = farkas
        .as_array()
        .unwrap()
        .iter()
        .map(|term| (term["row"].as_u64().unwrap(), term["bound"].as_str().unwrap()))
        .collect();
    assert_eq!(named, [(1, "upper"), (1, "lower")]);
}

#[test]
fn bounds_that_were_swapped_are_counted() {
    for (columns, rows) in [("--lower hi --upper lo", 1), ("--lower lo --upper hi", 2)] {
        let line = format!("fit fixtures/guesses/reversed-bounds.csv --x x {columns} --no-lp");
        let run = boundfit(&root(), &line);
        assert_eq!((run.status, run.stderr.as_str()), (3, ""), "{line}");
        let said = format!("  In {rows} of 3 rows the lower bound is above the upper one: swapped?\n");
        assert!(run.stdout.contains(&said), "{line}: {}", run.stdout);
    }
    let directory = directory_with(&[("data.csv", TABLE.as_bytes())]);
    let all =
        unbroken(&boundfit(directory.path(), "fit data.csv --x t --lower up --upper lo --no-lp").stdout);
    assert!(all.contains("In 3 of 6 rows the lower bound is above the upper one: swapped?"), "{all}");
    let right = boundfit(directory.path(), "fit data.csv --x t --lower lo --upper up --no-lp").stdout;
    assert!(!right.contains("swapped?"), "{right}");
}

/// The columns are named y and x, so that |y| of the law is not |y| of the model.
#[test]
fn a_law_has_the_names_of_the_columns_if_they_are_those_of_others() {
    let directory = directory_with(&[("data.csv", b"y,x\n1,2\n2,3\n3,5\n")]);
    let line = |options: &str| boundfit(directory.path(), &format!("{options} data.csv --x y --y x")).stdout;
    let both = line("fit --eps +1%*|y|/-2%*abs(x)+3%*range(y)");
    assert!(both.contains("  error    x +1%*|x|/-2%*abs(y)+3%*range(x) of each row\n"), "{both}");
    let share = line("status --eps 20%*|y|");
    assert!(share.contains("  error    |e| <= 20%*|x| of each row\n"), "{share}");
    let range = line("fit --eps 50%*range(y)");
    assert!(range.contains("  error    |e| <= 50%*range(x) = 1.5\n"), "{range}");
    let further = line("predict --at 2 --eps 20%*|y|");
    assert!(!further.contains("|y|"), "{further}");
}
