//! `boundfit plot`, started as a user would start it.

mod counted;
mod generated;
mod geometry;
mod golden;
mod look;
mod pictures;
mod refusals;
mod several;

use std::process::{Command, Output};

use boundfit_tests::program::{binary, root};

/// The transducer's fit.
pub const TRANSDUCER: &str = "fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \
    --x-unit V --y-unit m";

/// A small fit for each kind of set, and the exit status: 3 for an empty set.
pub const KINDS: [(&str, &str, i32); 10] = [
    ("empty", "contradicting.csv --x x --y y --eps 0.3", 3),
    ("point", "on-a-line.csv --x x --y y --eps 0", 0),
    ("segment", "twice-at-zero.csv --x x --y y --eps 0.1", 0),
    ("ray", "one-reading.csv --x x --y y --eps 0 --where theta1>=0.25", 0),
    ("line", "one-reading.csv --x x --y y --eps 0", 0),
    ("polygon", "two-readings.csv --x x --y y --eps 0.1", 0),
    (
        "unbounded-polygon",
        "one-reading.csv --x x --y y --eps 0.1 --where theta1>=0.2 --where 3*theta1-theta2>=0",
        0,
    ),
    ("strip", "one-reading.csv --x x --y y --eps 0.1", 0),
    ("half-plane", "nothing.csv --x u,v --y y --eps 1 --where theta1+2*theta2<=3", 0),
    ("plane", "nothing.csv --x u,v --y y --eps 1", 0),
];

/// The arguments of one of [`KINDS`].
pub fn of_kind(fit: &str) -> String {
    format!("fixtures/figures/{fit}")
}

/// Runs `boundfit plot` with the words of a line at the top of the repository.
pub fn plot(line: &str) -> Output {
    Command::new(binary()).arg("plot").args(line.split_whitespace()).current_dir(root()).output().unwrap()
}

/// Returns the standard output of a run that must end with this status, and write nothing else.
pub fn picture(line: &str, status: i32) -> Vec<u8> {
    let output = plot(line);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), stderr.as_ref()), (Some(status), ""), "{line}");
    output.stdout
}

/// The same as text.
pub fn svg(line: &str, status: i32) -> String {
    String::from_utf8(picture(line, status)).unwrap()
}
