//! The program on more readings than it keeps, and on input that does not behave.

use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, Read, Write};
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use boundfit_tests::generate::seeded;
use boundfit_tests::program::{Run, root, run, run_with_input};
use rand::RngExt;
use serde_json::Value;

use boundfit_tests::cli::{command, files_in};

/// A line with noise: more readings than are kept.
fn many_readings(count: usize) -> String {
    let mut rng = seeded(61);
    let mut text = "x,y\n".to_owned();
    for _ in 0..count {
        let x = rng.random_range(-100_000..=100_000_i64);
        let y = 3 * x + rng.random_range(-5000..=5000_i64);
        text.push_str(&format!("{}.{:03},{y}e-3\n", x / 1000, (x % 1000).abs()));
    }
    text
}

fn fit(file: &Path, more: &[&str]) -> Run {
    let file = file.to_str().unwrap();
    run(&[&["fit", file, "--x", "x", "--y", "y", "--eps", "8"], more].concat())
}

#[test]
fn the_same_bytes_for_any_number_of_threads_and_from_standard_input() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("many.csv");
    let text = many_readings(250_000);
    fs::write(&file, &text).unwrap();
    let one = fit(&file, &["--format", "json", "--threads", "1"]);
    assert_eq!((one.status, one.stderr.as_str()), (0, ""));
    for threads in ["2", "8"] {
        assert_eq!(fit(&file, &["--format", "json", "--threads", threads]).stdout, one.stdout, "{threads}");
    }
    let arguments = ["fit", "-", "--x", "x", "--y", "y", "--eps", "8", "--format", "json"];
    let named = format!("\"file\": {:?}", file.to_str().unwrap());
    let unnamed = one.stdout.replacen(&named, "\"file\": null", 1);
    assert_eq!(run_with_input(&arguments, text.as_bytes()).stdout, unnamed);
    let report: Value = serde_json::from_str(&one.stdout).unwrap();
    assert_eq!(report["input"]["rows"], 250_000);
    assert!(report["eui"][0]["lower"]["exact"].is_string());
    assert_eq!(report["fps"]["kind"], "polygon");
}

#[test]
fn without_eui_nothing_else_changes() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("many.csv");
    fs::write(&file, many_readings(120_000)).unwrap();
    let [with, without] = [&[][..], &["--no-eui"]].map(|more| {
        let run = fit(&file, &[&["--format", "json"], more].concat());
        serde_json::from_str::<Value>(&run.stdout).unwrap()
    });
    assert!(with["eui"].is_array() && without["eui"].is_null());
    assert_eq!(without["reasons"]["eui"], "not asked for");
    for key in ["least_squares", "fps", "pui", "central", "epsilon_min", "minimax", "tightness"] {
        assert_eq!(with[key], without[key], "{key}");
    }
}

/// Columns x, z, lo, y, e and up, where both bounds of a row are about as far from the truth.
fn many_intervals(count: usize) -> String {
    let mut rng = seeded(62);
    let mut text = "x,z,lo,y,e,up\n".to_owned();
    for _ in 0..count {
        let [x, z] = [0; 2].map(|_| rng.random_range(-1000..=1000_i64));
        let y = 3 * x - 2 * z + rng.random_range(-50..=50_i64);
        let e = rng.random_range(60..=90_i64);
        let lower = if rng.random_bool(0.01) { String::new() } else { format!("{}e-2", y - e) };
        text.push_str(&format!("{x}e-2,{z}e-2,{lower},{y}e-2,{e}e-2,{}e-2\n", y + e));
    }
    text
}

#[test]
fn bounds_per_row_and_two_regressors_are_the_same_for_any_threads_and_from_standard_input() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("many.csv");
    let text = many_intervals(30_000);
    fs::write(&file, &text).unwrap();
    let name = file.to_str().unwrap();
    for options in [
        "--x x,z --y y --eps 0.9",
        "--x x,z --y y --eps-column e",
        "--x x,z --lower lo --upper up",
        "--x x --y y --eps-column e",
        "--x x --y y --lower lo --upper up",
    ] {
        let arguments = |file, more: &[&'static str]| -> Vec<String> {
            let all = ["fit", file].into_iter().chain(options.split(' ')).chain(["--format", "json"]);
            all.chain(more.iter().copied()).map(ToOwned::to_owned).collect()
        };
        let fit = |more: &[&'static str]| {
            let arguments = arguments(name, more);
            run(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
        };
        let one = fit(&["--threads", "1"]);
        assert_eq!(one.stderr, "", "{options}");
        for threads in [&["--threads", "2"], &["--threads", "8"]] {
            assert_eq!(fit(threads).stdout, one.stdout, "{options}");
        }
        let stream = arguments("-", &[]);
        let stream = run_with_input(&stream.iter().map(String::as_str).collect::<Vec<_>>(), text.as_bytes());
        let value = |run: &Run| serde_json::from_str::<Value>(&run.stdout).unwrap();
        let (whole, stream, once) = (value(&one), value(&stream), value(&fit(&["--no-eui"])));
        for key in ["least_squares", "fps", "pui", "central", "eui", "minimax", "tightness"] {
            assert_eq!(whole[key], stream[key], "{options} {key}");
        }
        assert!(whole["minimax"].is_object(), "{options}");
        assert!(once["minimax"].is_null() && once["eui"].is_null(), "{options}");
        assert_eq!(once["reasons"]["minimax"], "not asked for", "{options}");
        for key in ["pui", "central", "tightness"] {
            assert_eq!(whole[key], once[key], "{options} {key}");
        }
    }
}

#[test]
fn a_bad_row_near_the_end_of_ten_million_is_named_and_nothing_is_written() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("long.csv");
    let mut out = BufWriter::new(File::create(&file).unwrap());
    out.write_all(b"x,y\n").unwrap();
    for line in 2..=10_000_000_u32 {
        let row: &[u8] = if line == 9_999_999 { b"1,2;3\n" } else { b"1,2\n" };
        out.write_all(row).unwrap();
    }
    out.flush().unwrap();
    let answer = directory.path().join("answer");
    let run = fit(&file, &["-o", answer.to_str().unwrap()]);
    let expected = format!(
        "error: {}: line 9999999, column 2 (y): \"2;3\": not a number: unexpected character ';' at character 2 (expected a \
         decimal such as 1.30e-2 or a fraction such as 7/19)\n",
        file.display()
    );
    assert_eq!((run.status, run.stdout.as_str(), run.stderr), (1, "", expected));
    assert_eq!(files_in(directory.path()), ["long.csv"]);
}

#[test]
fn a_file_cut_within_a_row_is_refused_with_its_line() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("cut.csv");
    let text = many_readings(120_000);
    let last_line = text.trim_end().rfind('\n').unwrap() + 1;
    // Before the separator the row is too short; after it the number is missing.
    let separator = last_line + text[last_line..].find(',').unwrap();
    for (end, problem) in [
        (
            separator,
            "the row has 1 cell where the first row has 2 (expected as many cells in every row, also where a value is missing)",
        ),
        (separator + 1, "column 2 (y): \"\": the value is missing, in this row only"),
    ] {
        fs::write(&file, &text[..end]).unwrap();
        let run = fit(&file, &[]);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""));
        assert!(run.stderr.contains("line 120001") && run.stderr.contains(problem), "{}", run.stderr);
    }
    // A row that ends where a number may end cannot be told from a whole one.
    fs::write(&file, text.trim_end()).unwrap();
    assert_eq!(fit(&file, &[]).status, 0);
}

#[test]
fn of_a_file_that_grows_the_readings_that_were_there_are_fitted() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("growing.csv");
    // A file grows by pages while it is written: rows of 16 bytes end where pages do, so that no half of one is ever seen.
    let row = |k: u32| {
        let x = f64::from(k * 7919 % 1_000_000) / 1000.0;
        format!("{x:08.3},{:06.2}\n", x / 2.0 + f64::from(k % 13) / 2.0)
    };
    let head = ["x,y\n".to_owned(), "0000.50,001\n".to_owned()];
    let lines: Vec<String> = head.into_iter().chain((1..400_000).map(row)).collect();
    assert_eq!(lines[0].len() + lines[1].len(), 16);
    assert!(lines[2..].iter().all(|line| line.len() == 16));
    let (start, rest) = lines.split_at(200_001);
    fs::write(&file, start.concat()).unwrap();
    let stop = Arc::new(AtomicBool::new(false));
    let writer = {
        let (file, stop) = (file.clone(), Arc::clone(&stop));
        let rest: Vec<String> = rest.chunks(500).map(|lines| lines.concat()).collect();
        thread::spawn(move || {
            let mut out = OpenOptions::new().append(true).open(file).unwrap();
            for lines in rest {
                if stop.load(Ordering::Relaxed) {
                    break;
                }
                out.write_all(lines.as_bytes()).unwrap();
                thread::sleep(Duration::from_micros(200));
            }
        })
    };
    let run = fit(&file, &["--format", "json"]);
    stop.store(true, Ordering::Relaxed);
    writer.join().unwrap();
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let rows = report["input"]["rows"].as_u64().unwrap() as usize;
    assert!((200_000..=400_000).contains(&rows), "{rows}");
    fs::write(&file, lines[..=rows].concat()).unwrap();
    assert_eq!(fit(&file, &["--format", "json"]).stdout, run.stdout);
}

/// The program reading from a pipe that stays open.
fn waiting(arguments: &[&str]) -> Child {
    let mut child = command(&root());
    child.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = child.spawn().unwrap();
    child.stdin.as_mut().unwrap().write_all(b"x,y\n1,2\n").unwrap();
    child
}

fn signalled(mut child: Child, signal: &str) -> (Option<i32>, String, String) {
    // The handler is set before anything is read; a moment is enough for a program that has nothing else to do.
    thread::sleep(Duration::from_millis(300));
    // Held open: at its end the program would answer.
    let stdin = child.stdin.take();
    let kill = std::process::Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let status = child.wait().unwrap();
    drop(stdin);
    let [mut stdout, mut stderr] = [String::new(), String::new()];
    child.stdout.take().unwrap().read_to_string(&mut stdout).unwrap();
    child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
    (status.code(), stdout, stderr)
}

#[cfg(unix)]
#[test]
fn an_interruption_ends_the_program_and_leaves_nothing_behind() {
    let directory = tempfile::tempdir().unwrap();
    let answer = directory.path().join("answer");
    for signal in ["-INT", "-TERM"] {
        for line in ["fit - --x x --y y --eps 1", "reduce - --x x --y y"] {
            let arguments: Vec<&str> = line.split(' ').chain(["-o", answer.to_str().unwrap()]).collect();
            let ended = signalled(waiting(&arguments), signal);
            assert_eq!(ended, (Some(130), String::new(), "interrupted\n".to_owned()), "{line} {signal}");
            assert!(files_in(directory.path()).is_empty());
        }
    }
}

#[test]
fn nobody_is_shown_progress_who_does_not_watch_a_terminal() {
    let mut child = waiting(&["fit", "-", "--x", "x", "--y", "y", "--eps", "1"]);
    let mut stdin = child.stdin.take().unwrap();
    thread::sleep(Duration::from_millis(1200));
    stdin.write_all(b"2,3\n3,5\n").unwrap();
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}
