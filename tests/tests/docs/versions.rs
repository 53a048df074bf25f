//! The one version, which every file that names it repeats.

use std::fs;

use boundfit_tests::program::root;

#[test]
fn the_citation_and_the_changelog_name_this_version() {
    let version = env!("CARGO_PKG_VERSION");
    let citation = fs::read_to_string(root().join("CITATION.cff")).unwrap();
    assert!(citation.lines().any(|line| line == format!("version: {version}")), "{citation}");
    let changes = fs::read_to_string(root().join("CHANGELOG.md")).unwrap();
    let is_release = |name: &&str| !["Versions", "Unreleased"].contains(name);
    let newest = changes.lines().find_map(|line| line.strip_prefix("## ").filter(is_release));
    assert_eq!(newest, Some(version));
}

#[test]
fn crates_ask_for_each_other_in_this_version() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let own: Vec<&str> = manifest.lines().filter(|line| line.contains("{ path = \"crates/")).collect();
    let version = format!("version = \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(own.len() > 10 && own.iter().all(|line| line.contains(&version)), "{own:?}");
}

#[test]
fn the_packages_for_other_languages_have_this_version() {
    let version = format!("version = \"{}\"", env!("CARGO_PKG_VERSION"));
    for file in ["pyproject.toml", "python/Cargo.toml", "wasm/Cargo.toml", "wasm/pack/Cargo.toml"] {
        let text = fs::read_to_string(root().join(file)).unwrap();
        assert!(text.lines().any(|line| line == version), "{file}");
    }
}
