//! What the libraries say is said in no surface's own words.

use std::fs;
use std::path::Path;

use boundfit_tests::program::root;

/// The lines of a folder's sources outside comments and unit tests, with where they stand.
fn lines_of_code(folder: &Path) -> Vec<(String, String)> {
    let mut lines = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("tests") {
            lines.extend(lines_of_code(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") && !path.ends_with("tests.rs") {
            let text = fs::read_to_string(&path).unwrap();
            let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
            let is_code = |line: &&str| !line.trim_start().starts_with("//");
            let place =
                |(number, line): (usize, &str)| (format!("{}:{number}", path.display()), line.to_owned());
            lines.extend((1..).zip(code.lines()).filter(|(_, line)| is_code(line)).map(place));
        }
    }
    lines
}

/// Whether an option of the command line stands in a line.
fn names_an_option(line: &str) -> bool {
    line.split("--").skip(1).any(|behind| behind.starts_with(|first: char| first.is_ascii_lowercase()))
}

#[test]
fn no_crate_below_the_surfaces_names_an_option_of_the_command_line() {
    let mut crates = 0;
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        if folder.ends_with("cli") {
            continue;
        }
        crates += 1;
        let named: Vec<_> = lines_of_code(&folder.join("src"))
            .into_iter()
            .filter(|(_, line)| names_an_option(line))
            .collect();
        assert!(named.is_empty(), "{named:#?}");
    }
    assert!(crates > 10);
    assert!(names_an_option("\"raised by --limit\"") && !names_an_option("a -- b"));
}
