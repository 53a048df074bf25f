//! Whole reports, compared byte for byte with files beside the fixtures. `SNAPSHOTS=overwrite cargo test` rewrites them.

use boundfit_tests::program::{root, run};
use snapbox::{Assert, Data};

fn check(expected: &str, arguments: &[&str], status: i32) {
    let run = run(arguments);
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{arguments:?}");
    let file = root().join("fixtures").join(expected);
    Assert::new().action_env("SNAPSHOTS").eq(run.stdout, Data::read_from(&file, None));
}

#[test]
fn transducer() {
    let fit = ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let fit = [&fit[..], &["--eps", "0.5e-3"]].concat();
    check("transducer/fit.txt", &fit, 0);
    check("transducer/fit.json", &[&fit[..], &["--format", "json"]].concat(), 0);
    check("transducer/fit-exact.txt", &[&fit[..], &["--exact"]].concat(), 0);
    check("transducer/fit-sweep.txt", &[&fit[..], &["--sweep", "0.5..2"]].concat(), 0);
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
    check("norris/fit.json", &[&fit[..], &["--format", "json"]].concat(), 3);
}
