//! Whole reports, compared byte for byte with files beside the fixtures. `SNAPSHOTS=overwrite cargo test` rewrites them.

use boundfit_tests::program::{root, run};
use snapbox::{Assert, Data};

fn check(expected: &str, arguments: &[&str], status: i32) {
    let run = run(arguments);
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{arguments:?}");
    let file = root().join("fixtures").join(expected);
    // A backslash is one, not part of a path.
    Assert::new().action_env("SNAPSHOTS").normalize_paths(false).eq(run.stdout, Data::read_from(&file, None));
}

#[test]
fn transducer() {
    let fit = ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let fit = [&fit[..], &["--eps", "0.5e-3"]].concat();
    check("transducer/fit.txt", &fit, 0);
    check("transducer/fit-full.txt", &[&fit[..], &["--full"]].concat(), 0);
    check("transducer/fit.json", &[&fit[..], &["--format", "json"]].concat(), 0);
    let range = ["range", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--eps", "0.5e-3"];
    check("transducer/range.txt", &range, 0);
    check("transducer/range.csv", &[&range[..], &["--format", "csv"]].concat(), 0);
    check("transducer/range.json", &[&range[..], &["--format", "json"]].concat(), 0);
    let next = [&["next"][..], &fit[1..], &["--within", "-20..20", "--format", "json"]].concat();
    check("transducer/next.json", &next, 0);
    check("transducer/fit-exact.txt", &[&fit[..], &["--exact", "--full"]].concat(), 0);
    check("transducer/fit-sweep.txt", &[&fit[..], &["--sweep", "0.5..2"]].concat(), 0);
}

#[test]
fn the_usual_report_fits_a_screen() {
    let fit = ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let report = run(&[&fit[..], &["--eps", "0.5e-3"]].concat()).stdout;
    assert!(report.lines().count() <= 40, "{report}");
    assert!(report.lines().all(|line| line.chars().count() <= 80), "{report}");
}

#[test]
fn steam_generator() {
    let fit = ["fit", "fixtures/steam-generator/steam_generator.csv", "--x", "x", "--y", "y"];
    let fit = [&fit[..], &["--eps-column", "eps", "--where", "theta1 >= 0"]].concat();
    check("steam-generator/fit.txt", &fit, 0);
    check("steam-generator/fit.json", &[&fit[..], &["--format", "json"]].concat(), 0);
}

#[test]
fn norris_is_empty_at_one_unit() {
    let fit = ["fit", "fixtures/norris/norris.csv", "--x", "x", "--y", "y", "--eps", "1"];
    check("norris/fit.txt", &fit, 3);
    check("norris/fit-full.txt", &[&fit[..], &["--full"]].concat(), 3);
    check("norris/fit.json", &[&fit[..], &["--format", "json"]].concat(), 3);
}

#[test]
fn statuses() {
    let transducer =
        ["status", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let decided = [&transducer[..], &["--eps", "0.5e-3"]].concat();
    check("transducer/status.txt", &decided, 0);
    check("transducer/status.json", &[&decided[..], &["--format", "json"]].concat(), 0);
    check("transducer/status.csv", &[&decided[..], &["--format", "csv"]].concat(), 0);
    let norris = ["status", "fixtures/norris/norris.csv", "--x", "x", "--y", "y", "--repair"];
    check("norris/status.txt", &[&norris[..], &["--eps", "1.5"]].concat(), 3);
    check("norris/status.json", &[&norris[..], &["--eps", "1.5", "--format", "json"]].concat(), 3);
    let further = ["--eps", "2.2", "--new", "fixtures/norris/norris.csv"];
    check("norris/status-new.txt", &[&norris[..], &further].concat(), 0);
}

#[test]
fn outliers() {
    let transducer = ["outliers", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z"];
    let transducer = [&transducer[..], &["--eps", "0.5e-3", "--most", "23"]].concat();
    check("transducer/outliers.txt", &transducer, 0);
    check("transducer/outliers.json", &[&transducer[..], &["--format", "json"]].concat(), 0);
    let norris = ["outliers", "fixtures/norris/norris.csv", "--x", "x", "--y", "y", "--eps", "0.8"];
    check("norris/outliers.txt", &norris, 0);
    let current = ["outliers", "fixtures/worst-line/current.csv", "--x", "U", "--y", "I", "--eps", "1.5"];
    check("worst-line/outliers.txt", &current, 0);
    check("worst-line/outliers.json", &[&current[..], &["--format", "json"]].concat(), 0);
}

#[test]
fn intervals_and_laws() {
    let clock = ["fit", "fixtures/clock/offset.csv", "--x", "t", "--lower", "at_least", "--upper", "at_most"];
    check("clock/fit.txt", &clock, 0);
    check("clock/fit.json", &[&clock[..], &["--format", "json"]].concat(), 0);
    let law = ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    check("transducer/fit-law.txt", &[&law[..], &["--eps", "1%*|y| + 3e-4"]].concat(), 0);
}

#[test]
fn lines_through_the_origin_and_from_another_origin() {
    let steam = ["fit", "fixtures/steam-generator/steam_generator.csv", "--x", "x", "--y", "y"];
    let through_origin = [&steam[..], &["--eps", "1.2*min", "--through-origin"]].concat();
    check("steam-generator/fit-through-origin.txt", &through_origin, 0);
    let transducer =
        ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let x_origin = [&transducer[..], &["--eps", "0.5e-3", "--x-origin", "-3"]].concat();
    check("transducer/fit-x-origin.txt", &x_origin, 0);
}

#[test]
fn documents() {
    let transducer =
        ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let transducer = [&transducer[..], &["--eps", "0.5e-3", "--sweep", "0.75..0.9", "--full"]].concat();
    let empty = ["fit", "fixtures/hard-lp/empty-by-1e-9.csv", "--x", "x", "--y", "y", "--eps", "0.373923265"];
    let unbounded = ["fit", "fixtures/claims/strip.csv", "--x", "x", "--y", "y", "--eps", "0.2", "--exact"];
    let house = ["polygon", "fixtures/polygon/house.ine"];
    let cases = [
        ("transducer", &transducer[..], 0),
        ("empty", &empty, 3),
        ("strip", &unbounded, 0),
        ("house", &house, 0),
    ];
    for (name, arguments, status) in cases {
        for (format, ending) in [("latex", "tex"), ("markdown", "md")] {
            let file = format!("documents/{name}.{ending}");
            check(&file, &[arguments, &["--format", format]].concat(), status);
        }
    }
}

#[test]
fn predictions() {
    let fit = ["predict", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let asked = [&fit[..], &["--eps", "0.5e-3", "--at", "3.7,9/2", "--from", "0.012,1"]].concat();
    check("transducer/predict.txt", &[&asked[..], &["--proofs"]].concat(), 0);
    check("transducer/predict.json", &[&asked[..], &["--format", "json"]].concat(), 0);
    check("transducer/predict.md", &[&asked[..], &["--format", "markdown"]].concat(), 0);
    let grid = [&fit[..], &["--eps", "0.5e-3", "--grid", "-6..6/24", "--format", "csv"]].concat();
    check("transducer/corridor.csv", &grid, 0);
}

#[test]
fn linearity() {
    let lvdt =
        ["linearity", "fixtures/linearity/lvdt.csv", "--x", "x_mm", "--up", "up_mV", "--down", "down_mV"];
    check("linearity/linearity.txt", &lvdt, 0);
    check("linearity/linearity-exact.txt", &[&lvdt[..], &["--exact"]].concat(), 0);
    check("linearity/linearity.json", &[&lvdt[..], &["--format", "json"]].concat(), 0);
    check("linearity/linearity.csv", &[&lvdt[..], &["--format", "csv"]].concat(), 0);
    check("linearity/linearity.tex", &[&lvdt[..], &["--format", "latex"]].concat(), 0);
    let cycles = [
        "linearity",
        "fixtures/linearity/cycles.csv",
        "--x",
        "x_mm",
        "--y",
        "mV",
        "--direction",
        "direction",
    ];
    check("linearity/cycles.txt", &cycles, 0);
}
