//! The documentation as a whole: links lead somewhere, the contents are complete, the README is short.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

use boundfit_tests::program::root;

use crate::pages::{Page, pages};

/// A path without `.` and `..`.
fn tidy(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut tidy, part| {
        match part {
            Component::ParentDir => assert!(tidy.pop(), "{} leaves the repository", path.display()),
            Component::CurDir => {}
            part => tidy.push(part),
        }
        tidy
    })
}

/// The file that a link of a page points to, and the anchor in it.
fn target(page: &Page, link: &str) -> (PathBuf, Option<String>) {
    let (path, anchor) = link.split_once('#').map_or((link, None), |(path, anchor)| (path, Some(anchor)));
    let file = match path {
        "" => page.path.clone(),
        path => tidy(&page.path.with_file_name("").join(path)),
    };
    (file, anchor.map(ToOwned::to_owned))
}

#[test]
fn every_link_leads_to_a_file_and_a_heading() {
    let mut checked = 0;
    for page in pages() {
        for link in page.links() {
            let place = format!("{}: {link}", page.path.display());
            let (file, anchor) = target(&page, &link);
            assert!(root().join(&file).exists(), "{place}: there is no {}", file.display());
            if let Some(anchor) = anchor {
                assert!(Page::read(&file).anchors().contains(&anchor), "{place}: there is no such heading");
            }
            // Files outside the folder are outside the book.
            let in_docs = |path: &Path| path.starts_with("docs");
            assert!(!in_docs(&page.path) || in_docs(&file), "{place}: leads out of the book");
            checked += 1;
        }
    }
    assert!(checked > 50, "only {checked} links");
}

#[test]
fn both_lists_of_contents_name_every_page() {
    let all: BTreeSet<PathBuf> =
        pages().into_iter().map(|page| page.path).filter(|path| path.starts_with("docs")).collect();
    for contents in ["docs/SUMMARY.md", "docs/README.md"] {
        let page = Page::read(Path::new(contents));
        let mut named: BTreeSet<PathBuf> = page.links().iter().map(|link| target(&page, link).0).collect();
        named.extend(["docs/README.md", "docs/SUMMARY.md"].map(PathBuf::from));
        assert_eq!(named, all, "{contents}");
    }
}

#[test]
fn the_figures_in_the_book_are_those_that_plot_draws() {
    for name in
        ["transducer-fps.svg", "transducer-corridor.svg", "transducer-range.svg", "transducer-next.svg"]
    {
        let golden = fs::read(root().join("fixtures/figures").join(name)).unwrap();
        assert!(
            fs::read(root().join("docs/pictures").join(name)).unwrap() == golden,
            "{name}: copy it again"
        );
    }
}

#[test]
fn the_readme_is_short() {
    let lines = Page::read(Path::new("README.md")).text.lines().count();
    assert!(lines <= 215, "{lines} lines: the rest belongs in docs");
}

#[test]
fn a_long_page_says_why_it_is_long() {
    for page in pages().iter().filter(|page| page.path.parent() == Some(Path::new("docs"))) {
        let words = page.text.split_whitespace().count();
        let first: Vec<&str> = page.text.split_whitespace().take(90).collect();
        let says = first.join(" ").to_lowercase().contains("the page is long because");
        assert_eq!(words > 1500, says, "{}: {words} words", page.path.display());
    }
}
