//! Counts how the cost of each command grows with the rows: `cargo xtask growth`.
//!
//! - `cases` lists the commands;
//! - `data` writes their files;
//! - `table` keeps the counts in `xtask/growth.txt` and says what is wrong with new ones.

mod cases;
mod data;
mod table;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use crate::root;
use cases::{CASES, Case, SIZES, STEP, STEPS};
use table::{Counts, Table};

/// The text that explains the options.
const USAGE: &str = "\
cargo xtask growth            count the instructions of each command at some rows, twice and four times as many
cargo xtask growth NAME…      count these commands of xtask/growth.txt only
cargo xtask growth --bless    store the counts, of all commands or of these, in xtask/growth.txt

It fails where the second half of the rows adds more than 2.6 times what the first half adds, or more than is stored, or
where a count is more than 5 % above the stored one. Counted is the program of `cargo build --release --locked`, by valgrind.";

/// The program that is counted, and the folder of its files.
struct Counter {
    program: PathBuf,
    folder: PathBuf,
}

impl Counter {
    /// The program that is installed, and a folder beside it.
    fn new() -> Result<Self, String> {
        let built = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
        let program = built.join("release/boundfit");
        if !program.is_file() {
            return Err(format!(
                "{}: not there; `cargo build --release --locked` builds it",
                program.display()
            ));
        }
        let folder = built.join("growth");
        fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        Ok(Self { program, folder })
    }

    /// The counts of a case at some sizes.
    fn counts(&self, case: &Case, sizes: &[usize]) -> Result<Counts, String> {
        sizes.iter().map(|&rows| self.count(case, rows)).collect::<Result<_, _>>().map(Counts)
    }

    /// Millions of instructions of a case at a size.
    fn count(&self, case: &Case, rows: usize) -> Result<f64, String> {
        let data = self.folder.join(format!("{:?}-{rows}.{}", case.data, case.data.ending()));
        fs::write(&data, case.data.text(rows)).map_err(|error| format!("{}: {error}", data.display()))?;
        let out = self.folder.join("out");
        // A file that is there is another command than a new one.
        let _ = fs::remove_file(&out);
        if !case.first.is_empty() {
            run(Command::new(&self.program), case.first, &data, &out)?;
        }
        let mut counted = Command::new("valgrind");
        counted.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]);
        counted.arg(&self.program);
        let said = run(counted, case.command, &data, &out)?;
        let total = said
            .lines()
            .find_map(|line| line.split_once("refs:"))
            .map(|(_, own)| own.trim().replace(',', ""));
        let total: Option<u32> = total.and_then(|own| (own.parse::<u64>().ok()? / 1000).try_into().ok());
        total.map(|own| f64::from(own) / 1000.0).ok_or_else(|| format!("valgrind counted nothing:\n{said}"))
    }
}

/// Runs a command on one thread and returns what it says beside its answer.
fn run(mut program: Command, words: &str, data: &Path, out: &Path) -> Result<String, String> {
    for word in words.split_whitespace() {
        match word {
            "DATA" => program.arg(data),
            "OUT" => program.arg(out),
            word => program.arg(word),
        };
    }
    program.env("RAYON_NUM_THREADS", "1").stdin(Stdio::null()).stdout(Stdio::null());
    let done = program.output().map_err(|error| format!("{program:?}: {error}"))?;
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    if done.status.success() { Ok(said) } else { Err(format!("{words}: {}\n{said}", done.status)) }
}

/// Counts the commands of these names, or all, and prints each row as it is known.
fn counted(names: &[&str]) -> Result<Table, String> {
    let counter = Counter::new()?;
    let every = CASES.iter().map(|case| (case, &SIZES[..])).chain(STEPS.iter().map(|case| (case, &STEP[..])));
    let mut found = Table::default();
    for (case, sizes) in every.filter(|(case, _)| names.is_empty() || names.contains(&case.name)) {
        let counts = counter.counts(case, sizes)?;
        println!("{:18} {:?}  growth {:.2}", case.name, counts.0, counts.growth());
        found.0.insert(case.name.to_owned(), counts);
    }
    if found.0.is_empty() {
        Err(format!("there is no command {names:?} in xtask/growth.txt"))
    } else {
        Ok(found)
    }
}

/// Compares the counts with the stored ones, or stores them; returns the faults.
fn compared(names: &[&str], bless: bool) -> Result<Vec<String>, String> {
    let path = root().join("xtask/growth.txt");
    let failed = |error| format!("{}: {error}", path.display());
    let mut stored = Table::read(&fs::read_to_string(&path).map_err(failed)?)?;
    let found = counted(names)?;
    if bless {
        if names.is_empty() {
            stored.0.clear();
        }
        stored.0.extend(found.0.clone());
        fs::write(&path, stored.to_string()).map_err(failed)?;
    }
    Ok(stored.faults(&found))
}

/// Does what the arguments say; the exit status is 1 if something grows and 2 if it cannot be counted.
pub(crate) fn main(options: &[String]) -> ExitCode {
    let words: Vec<&str> = options.iter().map(String::as_str).collect();
    let (options, names): (Vec<&str>, Vec<&str>) = words.into_iter().partition(|word| word.starts_with('-'));
    let bless = match options[..] {
        [] => false,
        ["--bless"] => true,
        _ => {
            println!("{USAGE}");
            return ExitCode::from(if options == ["--help"] { 0 } else { 2 });
        }
    };
    match compared(&names, bless) {
        Ok(faults) if faults.is_empty() => ExitCode::SUCCESS,
        Ok(faults) => {
            eprintln!("{}", faults.join("\n"));
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}
