//! The page that ties theory to code: what it names exists.

use std::fs;

use boundfit_tests::program::root;

/// The texts between backticks in the tables, with the line they are on.
fn names(page: &str) -> Vec<(usize, &str)> {
    let rows = (1..).zip(page.lines()).filter(|(_, line)| line.starts_with("| "));
    rows.flat_map(|(number, line)| line.split('`').skip(1).step_by(2).map(move |name| (number, name)))
        .collect()
}

/// Returns whether a Rust file defines a function, type or test of this name.
fn defines(text: &str, name: &str) -> bool {
    ["fn", "struct", "enum"].iter().any(|keyword| {
        text.match_indices(&format!("{keyword} {name}")).any(|(at, found)| {
            text[at + found.len()..].starts_with(|next: char| !next.is_alphanumeric() && next != '_')
        })
    })
}

#[test]
fn every_function_and_fixture_of_the_theory_page_exists() {
    let page = fs::read_to_string(root().join("docs/theory.md")).unwrap();
    let mut checked = 0;
    for (line, name) in names(&page).into_iter().filter(|(_, name)| name.contains('/')) {
        let (path, item) = name.split_once("::").map_or((name, None), |(path, item)| (path, Some(item)));
        let path = root().join(path);
        assert!(path.exists(), "docs/theory.md:{line}: there is no {name}");
        if let Some(item) = item {
            let text = fs::read_to_string(&path).unwrap();
            assert!(defines(&text, item), "docs/theory.md:{line}: {name} is not defined");
        }
        checked += 1;
    }
    assert!(checked > 60, "only {checked} names were found on the page");
}

#[test]
fn every_row_of_the_theory_page_has_function_fixture_and_source() {
    let page = fs::read_to_string(root().join("docs/theory.md")).unwrap();
    for (line, row) in (1..).zip(page.lines()).filter(|(_, line)| line.starts_with("| ")) {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").map(str::trim).collect();
        let [_, function, shown, source] = cells.as_slice() else {
            panic!("docs/theory.md:{line}: {} cells", cells.len());
        };
        if function == &"function" {
            continue;
        }
        assert!(function.starts_with("`crates/"), "docs/theory.md:{line}: no function");
        assert!(
            shown.contains("`tests/") || shown.contains("`fixtures/") || shown.contains("`crates/"),
            "docs/theory.md:{line}"
        );
        assert!(!source.is_empty(), "docs/theory.md:{line}: no source");
    }
}
