//! The texts of the libraries, which name no option or button of a surface.

use std::fs;

use boundfit_tests::program::root;

use super::sources::lines_of_code;

/// Returns whether an option of the command line stands in a line.
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
