//! Whole pictures, compared byte for byte with files in `fixtures/figures`. `SNAPSHOTS=overwrite cargo test` rewrites
//! them.

use boundfit_tests::program::root;
use snapbox::{Assert, Data};

use super::{KINDS, TRANSDUCER, of_kind, svg};

fn check(name: &str, line: &str, status: i32) {
    let file = root().join("fixtures/figures").join(format!("{name}.svg"));
    Assert::new().action_env("SNAPSHOTS").eq(svg(line, status), Data::read_from(&file, None));
}

#[test]
fn statuses_of_the_transducer() {
    check("transducer-status", &format!("{TRANSDUCER} --figure status"), 0);
}

#[test]
fn where_the_next_reading_of_the_transducer_helps() {
    check("transducer-next", &format!("{TRANSDUCER} --figure next"), 0);
    check("kind-strip-next", &of_kind("one-reading.csv --x x --y y --eps 0.1 --figure next"), 0);
}

#[test]
fn the_six_figures_of_the_transducer() {
    for figure in ["data", "eui", "pui", "fps", "corridor", "directions"] {
        check(&format!("transducer-{figure}"), &format!("{TRANSDUCER} --figure {figure}"), 0);
    }
}

#[test]
fn runs_that_fit_below_the_line_of_the_longest() {
    let transducer = "fixtures/transducer/transducer.csv --x Vz --y z --eps 0.5e-3";
    check("transducer-range", &format!("{transducer} --figure range"), 0);
    check("two-regressors-range", &of_kind("two-regressors.csv --x u,v --y y --eps 0.01 --figure range"), 0);
}

#[test]
fn a_set_of_each_kind() {
    for (kind, fit, status) in KINDS {
        check(&format!("kind-{kind}"), &of_kind(fit), status);
    }
}

#[test]
fn what_is_left_without_outliers() {
    check("outliers-two", "fixtures/worst-line/current.csv --x U --y I --eps 1.5 --figure outliers", 0);
    check("outliers-one", "fixtures/norris/norris.csv --x x --y y --eps 0.8 --figure outliers", 0);
}

#[test]
fn two_regressors_row_by_row() {
    check(
        "two-regressors-corridor",
        &of_kind("two-regressors.csv --x u,v --y y --eps 0.3 --figure corridor"),
        0,
    );
}

#[test]
fn contradicting_readings_in_the_data() {
    check("contradicting-data", &of_kind("contradicting.csv --x x --y y --eps 0.3 --figure data --flip"), 3);
}

#[test]
fn thin_sets_in_principal_axes() {
    let hard = |name: &str, eps: &str| format!("fixtures/hard-lp/{name}.csv --x x --y y --eps {eps}");
    check("thin-fps", &hard("ptp-nanoseconds", "0.00000005"), 0);
    check("thin-empty", &hard("parallel-empty", "0.00009588"), 3);
}

#[test]
fn boxes_of_errors_in_x_and_their_sets() {
    let current = "fixtures/worst-line/current.csv --x U --y I";
    check("x-errors-data", &format!("{current} --eps 2 --x-eps 0.2 --figure data"), 0);
    check("x-errors-fps", &format!("{current} --eps 30 --x-eps 0.5"), 0);
    check("x-errors-empty", &format!("{current} --eps 1.5 --x-eps 0.15"), 3);
}
