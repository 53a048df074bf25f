//! Counts what STYLE.md asks of prose and can be counted: `cargo xtask prose`.
//!
//! - `paragraphs` takes the prose out of Markdown and of comments of Rust;
//! - `sentences` splits it and says what is wrong with a sentence;
//! - `table` keeps a count per folder in `xtask/prose.txt`, which may only fall.

mod paragraphs;
mod sentences;
mod table;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use crate::root;
use paragraphs::{Kind, Paragraph};
use sentences::Fault;
use table::{Counts, Table};

/// The text that explains the options.
const USAGE: &str = "\
cargo xtask prose              compare the counts of each folder with xtask/prose.txt, where they may only fall
cargo xtask prose FOLDER…      list what is counted in these folders or files, with file and line
cargo xtask prose --bless      lower the counts of xtask/prose.txt to those of today

Counted are sentences of more than 30 words, sentences that begin with Of, What, So many, Whether, Those, How or Which,
and comments of rustdoc that do not begin with a verb or a noun. STYLE.md says why.";

/// Folders whose files are generated, fetched or not ours.
const SKIPPED: [&str; 7] = [".git", "target", "node_modules", "fixtures", "seeds", "corpus", "engine-target"];

/// A fault with its place.
struct Found {
    folder: String,
    place: String,
    fault: Fault,
    sentence: String,
}

/// The folder that a file is counted in: a crate's, or the first of its path.
fn folder(path: &str) -> String {
    let parts: Vec<&str> = path.split('/').collect();
    match parts[..] {
        ["crates", name, ..] => format!("crates/{name}"),
        [_] => ".".to_owned(),
        [first, ..] => first.to_owned(),
        [] => String::new(),
    }
}

/// Adds the Markdown and Rust files below a folder, from the top of the repository.
fn files(folder: &Path, found: &mut Vec<String>) -> Result<(), String> {
    let failed = |error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            if !SKIPPED.contains(&&*name) {
                files(&path, found)?;
            }
        } else if name.ends_with(".md") || name.ends_with(".rs") {
            let own = path.strip_prefix(root()).unwrap_or(&path);
            found.push(own.to_string_lossy().into_owned());
        }
    }
    Ok(())
}

/// The faults of a file's prose.
fn faults(path: &str, text: &str) -> Vec<Found> {
    let paragraphs = match path.ends_with(".rs") {
        true => paragraphs::of_rust(text),
        false => paragraphs::of_markdown(text),
    };
    let mut found = Vec::new();
    for Paragraph { line, kind, text } in paragraphs {
        for (number, sentence) in sentences::split(&text).into_iter().enumerate() {
            let is_summary = kind == Kind::Summary && number == 0;
            found.extend(sentences::faults(&sentence, is_summary).into_iter().map(|fault| Found {
                folder: folder(path),
                place: format!("{path}:{line}"),
                fault,
                sentence: sentence.clone(),
            }));
        }
    }
    found
}

/// The faults of every file of the repository.
fn all() -> Result<Vec<Found>, String> {
    let mut paths = Vec::new();
    files(&root(), &mut paths)?;
    paths.sort();
    let mut found = Vec::new();
    for path in paths {
        let text = fs::read_to_string(root().join(&path)).map_err(|error| format!("{path}: {error}"))?;
        found.extend(faults(&path, &text));
    }
    Ok(found)
}

/// The counts of each folder; those without any fault have none.
fn counts(found: &[Found]) -> BTreeMap<String, Counts> {
    let mut counts: BTreeMap<String, Counts> = BTreeMap::new();
    for fault in found {
        counts.entry(fault.folder.clone()).or_default().add(fault.fault);
    }
    counts
}

/// Compares counts with the table, or lowers it; the error names the folders that have more.
fn compare(bless: bool) -> Result<(), String> {
    let path = root().join("xtask/prose.txt");
    let counts = counts(&all()?);
    let table =
        Table::read(&fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?)?;
    let lowered = table.lowered(&counts);
    if bless {
        fs::write(&path, lowered.to_string()).map_err(|error| format!("{}: {error}", path.display()))?;
        print!("{lowered}");
    }
    let more = lowered.exceeded(&counts);
    match more.is_empty() {
        true if lowered != table && !bless => {
            println!(
                "There is less to mend than xtask/prose.txt says: `cargo xtask prose --bless` lowers it."
            );
        }
        true => {}
        false => return Err(more.join("\n")),
    }
    Ok(())
}

/// Lists the faults of some folders or files.
fn list(folders: &[String]) -> Result<(), String> {
    let found = all()?;
    // The folder "." has the files at the top alone.
    let is_asked = |found: &&Found| {
        let is_in = |folder: &str| found.place.starts_with(folder) || found.folder == folder;
        folders.iter().any(|folder| is_in(folder.trim_end_matches('/')))
    };
    for Found { place, fault, sentence, .. } in found.iter().filter(is_asked) {
        println!("{place}: {fault}: {sentence}");
    }
    Ok(())
}

/// Does what the arguments say; the exit status is 1 if a folder has more than the table says.
pub(crate) fn main(arguments: &[String]) -> ExitCode {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words[..] {
        [] => compare(false),
        ["--bless"] => compare(true),
        ["-h" | "--help"] => {
            println!("{USAGE}");
            Ok(())
        }
        [option, ..] if option.starts_with('-') => Err(format!("there is no option {option}\n\n{USAGE}")),
        _ => list(arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_belong_to_their_crate_or_first_folder() {
        assert_eq!(folder("crates/exact/src/lib.rs"), "crates/exact");
        assert_eq!(folder("docs/fit.md"), "docs");
        assert_eq!(folder("README.md"), ".");
    }

    #[test]
    fn a_fault_has_file_and_line() {
        let found = faults("crates/a/src/b.rs", "fn f() {}\n\n/// Whether it is. How so?\nfn g() {}\n");
        let places: Vec<String> =
            found.iter().map(|found| format!("{} {}", found.place, found.fault)).collect();
        let place = "crates/a/src/b.rs:3";
        let expected = ["begins with Whether", "no verb or noun first", "begins with How"];
        assert_eq!(places, expected.map(|fault| format!("{place} {fault}")));
    }

    /// The repository itself.
    #[test]
    fn no_folder_has_more_than_the_table_says() {
        assert_eq!(compare(false), Ok(()));
    }
}
