//! `--eps min`: the number that it comes to stands in every format, and there is none under conditions that contradict each other.

use boundfit_tests::cli::{boundfit, directory_with, printed, unbroken};

/// ε_min is 1/8.
const TABLE: &[u8] = b"x,y\n1,2\n2,3.1\n3,3.9\n4,5.2\n";
const FIT: &str = "data.csv --x x --y y --eps 1.2*min";

#[test]
fn the_bound_stands_in_every_format() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    let here = directory.path();
    let csv = printed(here, &format!("fit {FIT} --format csv"));
    assert_eq!(csv.lines().nth(2), Some("error_bound,,,,0.15000000000000002,,,3/20"));
    let words = "|e| <= 3/20, 6/5 times eps_min of these very readings";
    let script = printed(here, &format!("fit {FIT} --format m"));
    let own = format!(
        "% The error bound: {words}.\nerror_bound_exact = {{\n  '3/20'\n}};\nerror_bound = [\n  1.5000000000000002e-1\n];\n"
    );
    assert!(script.contains(&own), "{script}");
    for (format, start) in [("ine", "H-representation"), ("ext", "V-representation")] {
        let text = printed(here, &format!("fit {FIT} --format {format}"));
        assert!(text.starts_with(&format!("* {words}\n{start}\n")), "{text}");
        let line = format!("fit {FIT} --format {format} -o set.{format} --force");
        assert_eq!(boundfit(here, &line).status, 0);
        let read = printed(here, &format!("polygon set.{format}"));
        assert!(read.contains("polygon with 3 vertices"), "{read}");
    }
    let check: serde_json::Value =
        serde_json::from_str(&printed(here, &format!("check {FIT} --solver exact-simplex --format json")))
            .unwrap();
    let found = &check["input"]["epsilon_from_least"];
    assert_eq!((&found["factor"]["exact"], &found["epsilon_min"]["exact"]), (&"6/5".into(), &"1/8".into()));
    // These formats have no place for it.
    for line in [
        "fit DATA --format wkt",
        "fit DATA --format csv --vertices",
        "predict DATA --at 2 --format csv",
        "status DATA --format csv",
        "range DATA --format csv",
        "outliers DATA --format csv",
        "next DATA --within 0..5 --format csv",
    ] {
        let run = boundfit(here, &line.replace("DATA", FIT));
        assert_eq!((run.status, run.stderr), (0, format!("note: data.csv: {words}\n")), "{line}");
    }
    let windows = boundfit(here, &format!("fit {FIT} --window 3 --format csv"));
    let assumed = "Assumed: no error is larger than 6/5 times eps_min of all readings, a bound found from these very readings: 3/20\n";
    assert!(windows.stderr.ends_with(assumed), "{windows:?}");
    let one = boundfit(here, "fit data.csv --x x --y y --eps min --format wkt");
    assert_eq!(one.stderr, "note: data.csv: |e| <= 1/8, which is eps_min of these very readings\n");
}

#[test]
fn there_is_no_least_bound_under_conditions_that_contradict_each_other() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    let problem = "error: '--eps' asks for a multiple of eps_min, and there is none: the conditions on theta1 and theta2 contradict \
                   each other, so that no error bound, however large, is enough\n";
    let conditions =
        ["--where theta1>=5 --where theta1<=4", "--through-origin --where theta2>=1", "--where 0*theta1>=1"];
    for line in [
        "fit data.csv",
        "fit data.csv --format json",
        "fit data.csv --by x --format csv",
        "predict data.csv --at 2",
        "next data.csv --within 0..5",
        "check data.csv",
        "status data.csv",
        "convert data.csv --to lp --objective theta1-min",
        "plot data.csv -o fps.svg",
        "lesson data.csv -o lesson.html",
    ] {
        for own in conditions {
            let run = boundfit(directory.path(), &format!("{line} --x x --y y --eps 2*min {own}"));
            assert!(run.status == 2 && run.stderr.starts_with(problem), "{line} {own}: {run:?}");
        }
    }
    // A set of one point is no contradiction.
    let line = "fit data.csv --x x --y y --eps min --where theta1=1 --where theta2=1 --format wkt";
    assert_eq!(boundfit(directory.path(), line).stdout, "POINT (1 1)\n");
}

#[test]
fn figures_of_several_fits_name_the_bound_of_each() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    for (options, described) in [
        ("--eps 1 --eps 2*min", "ε = 1: polygon with 6 vertices; ε = 2*min (|e| ≤ 0.25): polygon with "),
        ("--eps min --by y", "all with the same axes: 2 (|e| ≤ 0); 3.1 (|e| ≤ 0); "),
    ] {
        let svg = printed(directory.path(), &format!("plot data.csv --x x --y y {options}"));
        assert!(svg.contains(described), "{options}: {svg}");
    }
}

#[test]
fn less_than_the_least_bound_fits_nothing() {
    let directory = directory_with(&[("data.csv", TABLE), ("exact.csv", b"x,y\n1,2\n2,3\n3,4\n")]);
    let run = boundfit(directory.path(), "fit data.csv --x x --y y --eps 1/2*min");
    let words = unbroken(&run.stdout);
    assert!(run.status == 3 && words.contains("Under a smaller one none does."), "{run:?}");
    assert!(!words.contains("intervals below"), "{words}");
    // ε_min is 0, and so is the half of it.
    let run = boundfit(directory.path(), "fit exact.csv --x x --y y --eps 1/2*min");
    assert!(run.status == 0 && !run.stdout.contains("Under a smaller one"), "{run:?}");
}
