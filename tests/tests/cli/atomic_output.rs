//! A file that the program writes is the old one or the new one, whole, whatever happens: a full disk, a quota, a kill.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use boundfit_tests::program::{Run, binary};
use tempfile::TempDir;

use boundfit_tests::cli::{boundfit, directory_with, files_in, finish, words};
use boundfit_tests::generate::one_in;

/// Readings that all shape the feasible set, so that its report is long: points of a parabola, with a group each.
fn parabola() -> String {
    let row = |k: i64| format!("{},{},group {k}\n", k - 150, (k - 150) * (k - 150));
    format!("x,y,g\n{}", (0..300).map(row).collect::<String>())
}

/// Commands that write one large file, or with a folder as output several.
const TO_FILE: [&str; 5] = [
    "fit data.csv --x x --y y --eps 200000 --format json --no-lp",
    "fit data.csv --x x --y y --eps 1 --by g --format json",
    "reduce data.csv --x x --y y",
    "plot data.csv --x x --y y --eps 200000 --format svg",
    "lesson data.csv --x x --y y --rows 145..155 --eps 500",
];
const TO_FOLDER: &str = "plot data.csv --x x --y y --eps 200000 --figure all";

/// An old answer, which a new one may replace.
const KEPT: &[u8] = b"Set-membership fit\nkept";

/// The name of the file that a command writes.
fn output_of(line: &str) -> &'static str {
    if line.starts_with("plot") { "out.svg" } else { "out" }
}

/// A directory with the data and an old file where the answer is to go.
fn prepared(line: &str) -> TempDir {
    directory_with(&[("data.csv", parabola().as_bytes()), (output_of(line), KEPT)])
}

/// Checks that a run failed for this reason and left everything as it was.
fn changed_nothing(run: &Run, reason: &str, directory: &Path, line: &str) {
    let output = output_of(line);
    let message = format!("error: {output}: cannot write: {reason}\n");
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (1, "", message.as_str()), "{line}");
    assert_eq!(files_in(directory), ["data.csv", output], "{line}");
    assert_eq!(fs::read(directory.join(output)).unwrap(), KEPT, "{line}");
}

/// The operating system's words for an error.
fn words_for(error: i32) -> String {
    std::io::Error::from_raw_os_error(error).to_string()
}

const NO_SPACE: i32 = 28;
const FILE_TOO_LARGE: i32 = 27;

#[test]
fn a_quota_for_the_size_of_files_leaves_the_old_file() {
    for line in TO_FILE {
        let directory = prepared(line);
        // Without the signal that would end the program, the write fails. The unit is 512 bytes or, for some shells, 1024.
        let mut command = Command::new("sh");
        command.args(["-c", "trap '' XFSZ && ulimit -f 4 && exec \"$0\" \"$@\""]).arg(binary());
        command.args(words(line)).args(["-o", output_of(line)]).current_dir(directory.path());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        changed_nothing(&finish(&mut command, b""), &words_for(FILE_TOO_LARGE), directory.path(), line);
    }
}

#[test]
fn a_proof_appears_with_its_report_or_not_at_all() {
    const OLD_PROOF: &[u8] = b"{\n  \"schema\": \"boundfit/proof/1\"";
    let table = b"x,y\n1,2\n2,3.1\n3,3.9\n";
    let fit = "fit data.csv --x x --y y --eps 1 --no-lp --format json";
    for (outputs, reason) in [
        ("-o out --proof proof.json", words_for(FILE_TOO_LARGE)),
        ("-o none/out --proof proof.json", String::new()),
        ("-o out --proof none/proof.json", String::new()),
    ] {
        let directory = directory_with(&[("data.csv", table), ("out", KEPT), ("proof.json", OLD_PROOF)]);
        let mut command = Command::new("sh");
        // The proof is within the quota, the report is not.
        command.args(["-c", "trap '' XFSZ && ulimit -f 6 && exec \"$0\" \"$@\""]).arg(binary());
        command.args(words(fit)).args(words(outputs)).current_dir(directory.path());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let run = finish(&mut command, b"");
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{outputs} {run:?}");
        assert!(run.stderr.contains(&reason), "{outputs} {run:?}");
        assert_eq!(files_in(directory.path()), ["data.csv", "out", "proof.json"], "{outputs}");
        assert_eq!(fs::read(directory.path().join("out")).unwrap(), KEPT, "{outputs}");
        assert_eq!(fs::read(directory.path().join("proof.json")).unwrap(), OLD_PROOF, "{outputs}");
    }
}

/// Runs a shell script in which `$FULL` is a folder on a disk of this many bytes. The test must be able to mount the
/// disk: as root or in a user namespace of its own.
fn on_a_small_disk(bytes: usize, directory: &Path, script: &str, arguments: &[String]) -> Option<Run> {
    let start = |options: &str, script: &str| {
        let mut command = Command::new("unshare");
        command.args([options, "sh", "-c", script]).arg(binary()).args(arguments).current_dir(directory);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    };
    fs::create_dir_all(directory.join("full")).unwrap();
    let mount = format!("mount -t tmpfs -o size={bytes} none full");
    let may = |options: &&str| start(options, &mount).output().is_ok_and(|run| run.status.success());
    let options = ["-m", "-rm"].into_iter().find(may)?;
    Some(finish(&mut start(options, &format!("{mount} && {script}")), b""))
}

#[test]
fn a_full_disk_leaves_the_old_file() {
    for line in TO_FILE {
        let directory = prepared(line);
        let output = output_of(line);
        // Status, message, what is in the old file, and which files there are.
        let script = format!(
            "printf 'Set-membership fit\\nkept' > full/{output} && {{ \"$0\" \"$@\" -o full/{output} 2> message; \
             printf '%s\\n' $?; cat message full/{output}; printf '\\n'; ls -A full; }}"
        );
        let Some(run) = on_a_small_disk(8_192, directory.path(), &script, &words(line)) else {
            eprintln!("no disk could be mounted");
            return;
        };
        let expected = format!(
            "1\nerror: full/{output}: cannot write: {}\nSet-membership fit\nkept\n{output}\n",
            words_for(NO_SPACE)
        );
        assert_eq!((run.stdout.as_str(), run.stderr.as_str()), (expected.as_str(), ""), "{line}");
    }
}

#[test]
fn a_disk_that_fills_up_leaves_every_figure_whole_or_as_it_was() {
    let whole = directory_with(&[("data.csv", parabola().as_bytes())]);
    assert_eq!(boundfit(whole.path(), &format!("{TO_FOLDER} -o all")).status, 0);
    let size = |name: &str| fs::metadata(whole.path().join("all").join(name)).unwrap().len() as usize;
    let names = files_in(&whole.path().join("all"));
    assert_eq!(names.len(), 6);
    // Room for the first two of them and not quite the third, in pages.
    let room: usize = ["data.svg", "eui.svg"].map(|name| size(name).next_multiple_of(4096)).iter().sum();
    let directory = directory_with(&[("data.csv", parabola().as_bytes())]);
    let script = "printf 'Set-membership fit\\nkept' > full/fps.svg && { \"$0\" \"$@\" -o full 2> message; printf '%s\\n' $?; mkdir found; \
                  cp -a full/. found; }";
    let Some(run) = on_a_small_disk(room + 2 * 4096, directory.path(), script, &words(TO_FOLDER)) else {
        eprintln!("no disk could be mounted");
        return;
    };
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("1\n", ""));
    let message = fs::read_to_string(directory.path().join("message")).unwrap();
    let expected = format!(
        "error: full/pui.svg: cannot write: {} (already written: full/data.svg, full/eui.svg)\n",
        words_for(NO_SPACE)
    );
    assert_eq!(message, expected);
    let found = directory.path().join("found");
    assert_eq!(files_in(&found), ["data.svg", "eui.svg", "fps.svg"]);
    assert_eq!(fs::read(found.join("fps.svg")).unwrap(), KEPT);
    for name in ["data.svg", "eui.svg"] {
        let expected = fs::read(whole.path().join("all").join(name)).unwrap();
        assert!(fs::read(found.join(name)).unwrap() == expected, "{name}");
    }
}

#[test]
fn a_device_that_is_full_is_an_error_too() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    for line in TO_FILE {
        if line.starts_with("plot") {
            continue;
        }
        let directory = prepared(line);
        let run = boundfit(directory.path(), &format!("{line} -o /dev/full"));
        let message = format!("error: /dev/full: cannot write: {}\n", words_for(NO_SPACE));
        assert_eq!((run.status, run.stdout.as_str(), run.stderr), (1, "", message), "{line}");
        let mut command = boundfit_tests::cli::command(directory.path());
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let run = finish(command.args(words(line)).stdout(full), b"");
        let message = format!("error: standard output: cannot write: {}\n", words_for(NO_SPACE));
        assert_eq!((run.status, run.stderr), (1, message), "{line}");
    }
}

/// Returns the contents of the files of a folder, without the temporary files that a killed program leaves.
fn contents(directory: &Path) -> Vec<(String, Vec<u8>)> {
    let is_temporary = |name: &String| name.starts_with(".boundfit-");
    let names = files_in(directory).into_iter().filter(|name| !is_temporary(name));
    names.map(|name| (name.clone(), fs::read(directory.join(name)).unwrap())).collect()
}

fn has_temporary(directory: &Path) -> bool {
    files_in(directory).iter().any(|name| name.starts_with(".boundfit-"))
}

/// Starts the program, waits for a moment, kills it and checks that each file is as before or as it is to become.
fn killed(line: &str, output: &str, new: &[(String, Vec<u8>)], moment: impl FnOnce(&Path)) {
    let directory = directory_with(&[("data.csv", parabola().as_bytes())]);
    let folder = directory.path().join("folder");
    fs::create_dir(&folder).unwrap();
    for (name, _) in new {
        fs::write(folder.join(name), KEPT).unwrap();
    }
    let mut command = boundfit_tests::cli::command(directory.path());
    command.args(words(line)).args(["-o", output]).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    moment(&folder);
    child.kill().unwrap();
    child.wait().unwrap();
    let found = contents(&folder);
    assert_eq!(found.len(), new.len(), "{line}");
    for ((name, found), (expected, new)) in found.iter().zip(new) {
        assert_eq!(name, expected, "{line}");
        assert!(found == KEPT || found == new, "{line}: {name} is neither old nor new");
    }
}

#[test]
fn a_killed_program_leaves_each_file_old_or_new() {
    const MOMENTS: u32 = 8;
    let moments = || (0..MOMENTS).step_by(one_in().min(4));
    for line in TO_FILE.into_iter().chain([TO_FOLDER]) {
        let whole = directory_with(&[("data.csv", parabola().as_bytes())]);
        fs::create_dir(whole.path().join("folder")).unwrap();
        let output =
            if line == TO_FOLDER { "folder".to_owned() } else { format!("folder/{}", output_of(line)) };
        let begun = Instant::now();
        let run = boundfit(whole.path(), &format!("{line} -o {output}"));
        let time = begun.elapsed();
        assert!([0, 3].contains(&run.status), "{line}: {run:?}");
        let new = contents(&whole.path().join("folder"));
        assert!(new.iter().all(|(_, bytes)| bytes.len() > 4096), "{line}");
        for k in moments() {
            killed(line, &output, &new, |_| sleep(time * k / (MOMENTS - 2)));
        }
        // Between the first byte and the last: as soon as there is a temporary file, and a little later.
        for pause in moments() {
            killed(line, &output, &new, |folder| {
                let patience = Instant::now();
                while !has_temporary(folder) && patience.elapsed() < 2 * time {
                    std::hint::spin_loop();
                }
                sleep(Duration::from_micros(u64::from(pause) * 200));
            });
        }
    }
}
