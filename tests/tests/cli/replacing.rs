//! The program's writing never destroys: not its input, not a read-only file, and nothing that somebody else made.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, files_in};

const DATA: &str = "x,y,g\n1,2,a\n2,3,a\n3,5,b\n4,6,b\n";
const FIT: &str = "fit data.csv --x x --y y --eps 1";

/// Every command that writes, with its formats and without `-o`.
const WRITERS: [(&str, &str); 33] = [
    (FIT, "text"),
    (FIT, "json"),
    (FIT, "latex"),
    (FIT, "markdown"),
    (FIT, "csv"),
    (FIT, "m"),
    ("fit data.csv --x x --y y --eps 1 --by g", "text"),
    ("fit data.csv --x x --y y --eps 1 --by g", "json"),
    ("fit data.csv --x x --y y --eps 1 --by g", "csv"),
    ("polygon planes.csv", "text"),
    ("polygon planes.csv", "json"),
    ("polygon planes.csv", "latex"),
    ("polygon planes.csv", "markdown"),
    ("polygon planes.csv", "csv"),
    ("polygon planes.csv", "m"),
    ("judge model.mps", "text"),
    ("judge model.mps", "json"),
    ("judge model.mps", "latex"),
    ("judge model.mps", "markdown"),
    ("check data.csv --x x --y y --eps 1", "text"),
    ("check data.csv --x x --y y --eps 1", "json"),
    ("verify proof.json data.csv", "text"),
    ("verify proof.json data.csv", "json"),
    ("plot data.csv --x x --y y --eps 1", "svg"),
    ("plot data.csv --x x --y y --eps 1", "png"),
    ("lesson data.csv --x x --y y --eps 1", ""),
    ("reduce data.csv --x x --y y", ""),
    ("convert data.csv --x x --y y --eps 1 --to mps --objective theta1-min", ""),
    ("convert data.csv --x x --y y --eps 1 --to lp --objective theta2-max", ""),
    ("completions bash", ""),
    ("completions fish", ""),
    ("man", ""),
    ("man fit", ""),
];

/// Formats that look the same whoever wrote them.
const NEEDS_FORCE: [(&str, &str); 5] =
    [(FIT, "wkt"), (FIT, "ine"), (FIT, "ext"), ("polygon planes.csv", "ine"), ("polygon planes.csv", "wkt")];

fn directory() -> TempDir {
    let directory = directory_with(&[
        ("data.csv", DATA.as_bytes()),
        ("planes.csv", b"a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n"),
        ("model.mps", b"ROWS\n N cost\n G need\nCOLUMNS\n x cost 1 need 1\nRHS\n RHS need 2\nENDATA\n"),
        ("notes", b"what boundfit said: Set-membership fit\n"),
    ]);
    fs::create_dir(directory.path().join("cases")).unwrap();
    assert_eq!(boundfit(directory.path(), &format!("{FIT} --no-lp --proof proof.json")).status, 0);
    directory
}

fn line(command: &str, format: &str, rest: &str) -> String {
    let format = if format.is_empty() { String::new() } else { format!("--format {format}") };
    format!("{command} {format} {rest}")
}

/// Checks that a command line is refused with this message and that every file is as before.
fn destroys_nothing(directory: &Path, line: &str, message: &str) {
    let contents = || -> Vec<(String, Option<Vec<u8>>)> {
        let names = files_in(directory).into_iter();
        names.map(|name| (name.clone(), fs::read(directory.join(name)).ok())).collect()
    };
    let before = contents();
    let run = boundfit(directory, line);
    assert_eq!(
        (run.status, run.stdout.as_str(), run.stderr),
        (1, "", format!("error: {message}\n")),
        "{line}"
    );
    assert!(contents() == before, "{line}");
}

const FOREIGN: &str = "it is there and does not look as if boundfit wrote it (--force replaces it)";

#[test]
fn every_command_keeps_what_somebody_else_made() {
    let directory = directory();
    for (command, format) in WRITERS.into_iter().chain(NEEDS_FORCE) {
        let line = line(command, format, "-o notes");
        destroys_nothing(directory.path(), &line, &format!("notes: not written: {FOREIGN}"));
    }
    destroys_nothing(
        directory.path(),
        &format!("{FIT} --proof notes"),
        &format!("notes: not written: {FOREIGN}"),
    );
    fs::create_dir(directory.path().join("folder")).unwrap();
    for (command, taken) in [
        ("plot data.csv --x x --y y --eps 1 --figure all", "fps.svg"),
        ("convert data.csv --x x --y y --eps 1 --to lp", "theta2-max.lp"),
    ] {
        fs::write(directory.path().join("folder").join(taken), "mine").unwrap();
        let message = format!("folder/{taken}: not written: {FOREIGN}");
        destroys_nothing(directory.path(), &format!("{command} -o folder"), &message);
        assert_eq!(files_in(&directory.path().join("folder")), [taken]);
        let run = boundfit(directory.path(), &format!("{command} -o folder --force"));
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{command}");
        fs::remove_dir_all(directory.path().join("folder")).unwrap();
        fs::create_dir(directory.path().join("folder")).unwrap();
    }
}

#[test]
fn an_older_answer_and_an_empty_file_are_replaced() {
    let directory = directory();
    let file = directory.path().join("answer");
    for (command, format) in WRITERS {
        let line = line(command, format, "-o answer");
        fs::write(&file, "").unwrap();
        for _ in 0..2 {
            let run = boundfit(directory.path(), &line);
            assert!(matches!(run.status, 0 | 3 | 4) && run.stdout.is_empty(), "{line}: {run:?}");
            assert!(!fs::read(&file).unwrap().is_empty(), "{line}");
        }
        fs::write(&file, "mine").unwrap();
        let run = boundfit(directory.path(), &format!("{line} --force"));
        assert!(matches!(run.status, 0 | 3 | 4), "{line}: {run:?}");
        assert_ne!(fs::read(&file).unwrap(), b"mine", "{line}");
        fs::remove_file(&file).unwrap();
    }
    for (command, format) in NEEDS_FORCE {
        let line = line(command, format, "-o answer");
        assert_eq!(boundfit(directory.path(), &line).status, 0, "{line}");
        destroys_nothing(directory.path(), &line, &format!("answer: not written: {FOREIGN}"));
        assert_eq!(boundfit(directory.path(), &format!("{line} --force")).status, 0, "{line}");
        fs::remove_file(&file).unwrap();
    }
    for _ in 0..2 {
        assert_eq!(boundfit(directory.path(), &format!("{FIT} --no-lp --proof p.json")).status, 0);
    }
}

#[test]
fn what_is_read_is_never_replaced() {
    let directory = directory();
    for force in ["", " --force"] {
        for (command, format) in WRITERS.into_iter().filter(|(command, _)| command.contains("data.csv")) {
            let line = line(command, format, &format!("-o ./cases/../data.csv{force}"));
            let message = "./cases/../data.csv: not written: it is data.csv, which is read";
            destroys_nothing(directory.path(), &line, message);
        }
        for (command, input) in [
            (FIT.to_owned() + " --proof data.csv", "data.csv"),
            ("polygon planes.csv -o planes.csv".to_owned(), "planes.csv"),
            ("verify proof.json data.csv -o proof.json".to_owned(), "proof.json"),
            (
                "check data.csv --x x --y y --eps 1 --claim planes.csv --format text -o planes.csv"
                    .to_owned(),
                "planes.csv",
            ),
        ] {
            let message = format!("{input}: not written: it is {input}, which is read");
            destroys_nothing(directory.path(), &format!("{command}{force}"), &message);
        }
    }
    // An answer that is read is an input too.
    assert_eq!(boundfit(directory.path(), "reduce data.csv --x x --y y -o reduced.csv").status, 0);
    let message = "reduced.csv: not written: it is reduced.csv, which is read";
    destroys_nothing(directory.path(), "reduce reduced.csv --x x --y y -o reduced.csv", message);
}

#[test]
fn report_and_proof_are_two_files() {
    let directory = directory();
    fs::write(directory.path().join("old.json"), "").unwrap();
    fs::hard_link(directory.path().join("old.json"), directory.path().join("other.json")).unwrap();
    for outputs in ["-o r --proof r", "-o r --proof ./cases/../r", "-o old.json --proof other.json"] {
        let run = boundfit(directory.path(), &format!("{FIT} {outputs}"));
        let message =
            "error: '--proof' and '--output' name the same file\n\nFor more information, try '--help'.\n";
        assert_eq!((run.status, run.stderr.as_str()), (2, message), "{outputs}");
        assert!(!directory.path().join("r").exists());
    }
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    #[test]
    fn another_name_of_what_is_read_is_known() {
        let directory = directory();
        symlink("data.csv", directory.path().join("link.csv")).unwrap();
        fs::hard_link(directory.path().join("data.csv"), directory.path().join("hard.csv")).unwrap();
        for name in ["link.csv", "hard.csv"] {
            for (read, written) in [("data.csv", name), (name, "data.csv")] {
                let line = format!("fit {read} --x x --y y --eps 1 --format text -o {written} --force");
                let message = format!("{written}: not written: it is {read}, which is read");
                destroys_nothing(directory.path(), &line, &message);
            }
        }
    }

    #[test]
    fn a_file_in_a_folder_may_be_what_is_read() {
        let directory = directory();
        fs::create_dir(directory.path().join("folder")).unwrap();
        let of_data = "data.csv --x x --y y --eps 1";
        for (command, file) in [
            (format!("plot {of_data} --figure all"), "fps.svg"),
            (format!("convert {of_data} --to mps"), "theta2-min.mps"),
            (format!("convert {of_data} --to lp"), "theta1-max.lp"),
        ] {
            symlink("../data.csv", directory.path().join("folder").join(file)).unwrap();
            let message = format!("folder/{file}: not written: it is data.csv, which is read");
            destroys_nothing(directory.path(), &format!("{command} -o folder --force"), &message);
            assert_eq!(files_in(&directory.path().join("folder")), [file]);
            fs::remove_file(directory.path().join("folder").join(file)).unwrap();
        }
    }

    #[test]
    fn answers_and_models_that_are_judged_are_read_by_any_name() {
        let directory = directory();
        fs::write(directory.path().join("answer.json"), "{\"pui\":[[0,1],[0,1]]}").unwrap();
        for (name, read) in [("first", "model.mps"), ("second", "answer.json"), ("third", "proof.json")] {
            symlink(read, directory.path().join(name)).unwrap();
        }
        let claim = "check data.csv --x x --y y --eps 1 --claim answer.json --format json";
        for (line, read) in [
            ("judge model.mps -o first", "model.mps"),
            ("judge model.mps --solution answer.json -o second", "answer.json"),
            (&format!("{claim} -o second"), "answer.json"),
            ("verify proof.json data.csv -o third", "proof.json"),
        ] {
            let output = line.rsplit(' ').next().unwrap();
            let message = format!("{output}: not written: it is {read}, which is read");
            destroys_nothing(directory.path(), &format!("{line} --force"), &message);
        }
    }

    #[test]
    fn standard_input_is_an_input_too() {
        let directory = directory();
        let mut command = boundfit_tests::cli::command(directory.path());
        let line = "fit - --x x --y y --eps 1 --format text -o data.csv --force";
        command.args(boundfit_tests::cli::words(line));
        command.stdin(fs::File::open(directory.path().join("data.csv")).unwrap());
        let output = command.output().unwrap();
        let message = "error: data.csv: not written: it is standard input, which is read\n";
        assert_eq!(
            (output.status.code(), String::from_utf8(output.stderr).unwrap().as_str()),
            (Some(1), message)
        );
        assert_eq!(fs::read_to_string(directory.path().join("data.csv")).unwrap(), DATA);
        let run = boundfit_with_input(directory.path(), "fit - --x x --y y --eps 1 -o new", DATA.as_bytes());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    }

    #[test]
    fn what_is_read_only_stays() {
        let directory = directory();
        let file = directory.path().join("old.txt");
        fs::write(&file, "Set-membership fit\n").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
        for force in ["", " --force"] {
            for option in ["-o", "--proof"] {
                let message = "old.txt: not written: it is read-only (--force does not change that)";
                destroys_nothing(directory.path(), &format!("{FIT} {option} old.txt{force}"), message);
            }
        }
    }

    #[test]
    fn devices_and_pipes_are_written_to() {
        let directory = directory();
        let run = boundfit(directory.path(), &format!("{FIT} -o /dev/null --proof /dev/stdout"));
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        assert!(run.stdout.starts_with("{\n  \"schema\": \"boundfit/proof/1\""), "{}", run.stdout);
        // The program may fill a file that the shell has emptied.
        let shell = format!("\"$0\" {FIT} -o /dev/stdout > redirected");
        let mut command = std::process::Command::new("sh");
        command.args(["-c", &shell]).arg(boundfit_tests::program::binary()).current_dir(directory.path());
        let output = command.output().unwrap();
        assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
        assert!(
            fs::read_to_string(directory.path().join("redirected"))
                .unwrap()
                .starts_with("Set-membership fit\n")
        );
    }
}
