//! Command lines that ask further questions about a table: statuses, predictions, outliers, ranges, windows, errors in x,
//! guarantees and linearity.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::numbers::{bound, digits, number, written};
use super::one_of;
use crate::cli::words;

/// A value for an option: a number as columns have them, or one of very many digits.
fn value(rng: &mut ChaCha8Rng) -> String {
    if rng.random_bool(0.2) {
        let (above, below) = (rng.random_range(1..2000), rng.random_range(1..2000));
        return format!("{}/{}", digits(rng, above), digits(rng, below));
    }
    let kind = written(rng);
    number(rng, kind, 2)
}

/// A question about the table that a fit is asked for with these words, and the check of its proof where it writes one.
pub(super) fn asked_of_table(rng: &mut ChaCha8Rng, file: &str, fit: &[String]) -> Vec<Vec<String>> {
    if rng.random_range(0..8) == 0 {
        let line = linearity(rng, file);
        return with_proof(rng, line, file);
    }
    let (command, options) = match rng.random_range(0..7) {
        0 => ("status", status(rng, file)),
        1 => ("predict", predict(rng, file)),
        2 => {
            ("outliers", words(one_of(rng, &["", "--most 1", "--most 5", "--most 100", "--most 4000000000"])))
        }
        3 => {
            match one_of(rng, &["", "--by-row", "--by-x", "--within -3..9", "--within 0..1/3 --new-eps 1e-9"])
            {
                own if own.starts_with("--within") => ("next", words(own)),
                own => ("range", words(own)),
            }
        }
        4 => ("fit", window(rng)),
        5 => ("fit", x_errors(rng)),
        _ => {
            let figure = one_of(rng, &["status", "outliers", "range", "next"]);
            let line = words(&format!("plot {file} --figure {figure} -o a.svg"));
            return vec![[line, fit.to_vec()].concat()];
        }
    };
    let format = words(one_of(rng, &["", "--format json", "--format csv", "--digits 1000"]));
    let line = [words(command), vec![file.to_owned()], fit.to_vec(), options, format].concat();
    if command == "next" || line.iter().any(|word| word.starts_with("--window")) {
        return vec![line];
    }
    with_proof(rng, line, file)
}

/// Adds a proof at times, and the check of the proof.
fn with_proof(rng: &mut ChaCha8Rng, line: Vec<String>, file: &str) -> Vec<Vec<String>> {
    if rng.random_bool(0.3) {
        let with_proof = [line, words("-o r.txt --proof p.json")].concat();
        return vec![with_proof, words(&format!("verify p.json {file}"))];
    }
    vec![line]
}

fn status(rng: &mut ChaCha8Rng, file: &str) -> Vec<String> {
    match rng.random_range(0..4) {
        0 => words(&format!("--new {file}")),
        1 => Vec::new(),
        2 => words("--repair"),
        _ => words("--repair --all"),
    }
}

fn predict(rng: &mut ChaCha8Rng, file: &str) -> Vec<String> {
    let mut options = match rng.random_range(0..6) {
        0 => vec!["--at".to_owned(), value(rng)],
        1 => vec!["--from".to_owned(), value(rng)],
        2 => vec!["--at".to_owned(), format!("{file}:x")],
        3 => vec!["--from".to_owned(), format!("{file}:y")],
        4 => words(one_of(rng, &["--grid 0..10/400", "--grid -1e900..1/7/1000", "--grid 1/3..1e9000/50"])),
        _ => vec!["--grid".to_owned(), format!("0..{}/200", value(rng).replace('-', ""))],
    };
    match rng.random_range(0..4) {
        0 => options.extend(["--new-eps".to_owned(), bound(rng).replace("min", "1")]),
        1 => options.push("--proofs".to_owned()),
        _ => {}
    }
    options
}

fn window(rng: &mut ChaCha8Rng) -> Vec<String> {
    if rng.random_bool(0.5) {
        words(one_of(
            rng,
            &["--window 2", "--window 3", "--window 20", "--window 100 --step 7", "--window 1000000"],
        ))
    } else {
        vec!["--window-x".to_owned(), value(rng).replace('-', "")]
    }
}

/// Errors in x, or a guarantee.
fn x_errors(rng: &mut ChaCha8Rng) -> Vec<String> {
    if rng.random_bool(0.2) {
        let nines = one_of(rng, &[1, 50, 99, 4_000]);
        return vec!["--confidence".to_owned(), format!("0.{}", "9".repeat(nines))];
    }
    let width = one_of(rng, &["0", "1/7", "0.01", "u", "x"]).to_owned();
    let width = if rng.random_bool(0.4) { value(rng).replace('-', "") } else { width };
    let strong = words(one_of(rng, &["", "--strong"]));
    [vec!["--x-eps".to_owned(), width], strong].concat()
}

fn linearity(rng: &mut ChaCha8Rng, file: &str) -> Vec<String> {
    let columns = one_of(
        rng,
        &["--x x --y y", "--x x --up y --down u", "--x u --up x --down y", "--x x --y y --direction u"],
    );
    let mut line = words(&format!("linearity {file} {columns}"));
    match rng.random_range(0..5) {
        0 => line.push(format!("--through={},{}", value(rng), value(rng))),
        1 => line.push(format!("--full-scale={}", value(rng))),
        2 => line.extend(words("--figure l.svg")),
        _ => line.extend(words(one_of(rng, &["", "--format json", "--digits 1000"]))),
    }
    line
}
