//! `fit --confidence`: the share of further readings in the band of ε_min, and what is refused.

use boundfit_tests::cli::{FIT_TRANSDUCER, boundfit, directory_with};
use boundfit_tests::program::root;
use serde_json::Value;

#[test]
fn the_guarantee_has_a_part_of_its_own_in_every_document() {
    let line = format!("{FIT_TRANSDUCER} --confidence 0.99");
    let text = boundfit(&root(), &line).stdout;
    assert!(text.contains("At least 68.187 % of further readings lie in the band of eps_min"), "{text}");
    assert!(text.contains("0.00039444 off the minimax estimate"), "{text}");
    for format in ["latex", "markdown"] {
        let document = boundfit(&root(), &format!("{line} --format {format}"));
        assert!(document.status == 0 && document.stdout.contains("Guarantee for further readings"));
    }
    let report: Value =
        serde_json::from_str(&boundfit(&root(), &format!("{line} --format json")).stdout).unwrap();
    let guarantee = &report["guarantee"];
    assert_eq!(guarantee["confidence"]["exact"], "99/100");
    assert!(guarantee["covered"]["decimal"].as_str().unwrap().starts_with("0.68187"), "{guarantee}");
    assert_eq!((&guarantee["readings"], &guarantee["unknowns"]), (&23.into(), &3.into()));
    // The rows were chosen.
    assert_eq!(guarantee["assumes"].as_array().unwrap().len(), 2);
    // Without the option nothing of it.
    let report: Value =
        serde_json::from_str(&boundfit(&root(), &format!("{FIT_TRANSDUCER} --format json")).stdout).unwrap();
    assert_eq!(report.get("guarantee"), None);
}

#[test]
fn few_readings_guarantee_nothing_and_say_so() {
    let directory =
        directory_with(&[("two.csv", b"x,y\n1,2\n2,3\n"), ("three.csv", b"x,y,e\n1,2,1\n2,3,0\n3,5,2\n")]);
    for (line, words) in [
        (
            "fit two.csv --x x --y y --eps 1 --confidence 0.9",
            "None: 2 readings do not fix a band of 3 unknowns.",
        ),
        ("fit two.csv --x x --y y --eps 1 --through-origin --confidence 0.9", "At least 5.1316 %"),
        ("fit three.csv --x x --y y --eps 1 --confidence 9e-1", "At least 3.4510 %"),
        (
            "fit three.csv --x x --y y --eps 1 --where 'theta1 >= 1' --where 'theta1 <= 0' --confidence 1/2",
            "None: there is no eps_min",
        ),
    ] {
        let run = boundfit(directory.path(), &format!("{line} --no-lp"));
        assert!(run.stdout.contains(words), "{line}: {run:?}");
    }
    let run = boundfit(
        directory.path(),
        "fit three.csv --x x --y y --eps 1 --where 'theta1 >= 1' --where 'theta1 <= 0' --confidence 1/2 --format json",
    );
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((run.status, &report["reasons"]["guarantee"]), (3, &"see minimax".into()));
}

#[test]
fn what_is_no_confidence_or_has_no_place_is_refused() {
    let directory = directory_with(&[("data.csv", b"x,y,lo,up,e\n1,2,1,3,1\n2,3,2,4,0\n")]);
    let fit = "fit data.csv --x x --y y --eps 1";
    for (line, message) in [
        (format!("{fit} --confidence 0"), "expected a number between 0 and 1, such as 0.99"),
        (format!("{fit} --confidence 1"), "expected a number between 0 and 1, such as 0.99"),
        (format!("{fit} --confidence -1"), "expected a number between 0 and 1, such as 0.99"),
        (format!("{fit} --confidence 99%"), "expected a number between 0 and 1, such as 0.99"),
        (format!("{fit} --confidence often"), "not a number"),
        (format!("{fit} --confidence 0.{}", "9".repeat(101)), "closer to 1 than 1e-100"),
        (format!("{fit} --confidence 0.9 --format csv"), "other formats have no place for a guarantee"),
        (format!("{fit} --confidence 0.9 --by x"), "cannot be used with"),
        (format!("{fit} --confidence 0.9 --brief"), "goes with none of '--full', '--sweep'"),
        (
            "fit data.csv --x x --lower lo --upper up --confidence 0.9".to_owned(),
            "is about error bounds that reach as far above y as below: intervals need not",
        ),
        (
            "fit data.csv --x x --y y --eps-column e --confidence 0.9".to_owned(),
            "is about error bounds above 0: a reading with the bound 0 leaves no room for another one",
        ),
    ] {
        let run = boundfit(directory.path(), &line);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}: {}", run.stderr);
    }
}
