//! The statements of ARCHITECTURE.md about the size of the parts.

use std::collections::BTreeSet;
use std::fs;

use boundfit_tests::program::root;

use super::sources::lines_of_code;

/// A row of the table: the crates, and how many lines they are said to have.
fn row(line: &str) -> Option<(Vec<&str>, usize)> {
    let mut cells = line.strip_prefix("| `")?.split(" | ");
    let (crates, lines) = (cells.next()?, cells.next()?);
    let crates = crates.trim_end_matches('`').split("`, `").collect();
    Some((crates, lines.replace(',', "").parse().ok()?))
}

#[test]
fn the_table_of_lines_is_true_to_the_hundred() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let (_, text) = text.split_once("## Why so many lines?").unwrap();
    let (text, _) = text.split_once("\n## ").unwrap();
    let mut counted = BTreeSet::new();
    for (crates, said) in text.lines().filter_map(row) {
        let lines = |own: &&str| lines_of_code(&root().join("crates").join(own).join("src")).len();
        let found: usize = crates.iter().map(lines).sum();
        assert!(found.abs_diff(said) <= 100, "{crates:?}: {said} are said, {found} are there");
        counted.extend(crates);
    }
    let all = fs::read_dir(root().join("crates")).unwrap();
    let all: BTreeSet<String> =
        all.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    assert!(all.iter().map(String::as_str).eq(counted), "{all:?}");
}
