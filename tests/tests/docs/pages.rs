//! The pages of the documentation: those at the top of the repository and those of `docs`.

use std::fs;
use std::path::{Path, PathBuf};

use boundfit_tests::program::root;

/// A page and its text.
pub struct Page {
    /// The path from the top of the repository: `docs/input.md`.
    pub path: PathBuf,
    pub text: String,
}

impl Page {
    pub fn read(path: &Path) -> Self {
        let text = fs::read_to_string(root().join(path)).unwrap();
        Page { path: path.to_owned(), text }
    }

    /// The text without code, neither blocks nor spans.
    pub fn prose(&self) -> String {
        let blocks = self.text.split("```").step_by(2);
        blocks.flat_map(|block| block.split('`').step_by(2)).collect()
    }

    /// Returns the targets of the page's links and pictures as they are written, without links to other sites.
    pub fn links(&self) -> Vec<String> {
        let prose = self.prose();
        let ends = [("](", ')'), ("src=\"", '"')];
        let found = ends.iter().flat_map(|(begin, end)| {
            prose.split(begin).skip(1).filter_map(move |rest| rest.split_once(*end).map(|(link, _)| link))
        });
        found.filter(|link| !link.contains("://")).map(ToOwned::to_owned).collect()
    }

    /// The anchors of its headings, as repository viewers and mdBook make them.
    pub fn anchors(&self) -> Vec<String> {
        let outside = self.text.split("```").step_by(2);
        let headings = outside
            .flat_map(str::lines)
            .filter_map(|line| Some(line.strip_prefix('#')?.trim_start_matches('#')));
        headings.map(anchor).collect()
    }
}

fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).flat_map(char::to_lowercase).collect()
}

/// The pages at the top of the repository, the changelog aside, and all of the folder `docs` and of the reference in it.
pub fn pages() -> Vec<Page> {
    let pages_of = |folder: &'static str| {
        let entries = fs::read_dir(root().join(folder)).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.ends_with(".md")).map(move |name| Path::new(folder).join(name))
    };
    let mut paths: Vec<PathBuf> = pages_of("docs").chain(pages_of("docs/reference")).collect();
    paths.extend(
        ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "SECURITY.md", "STYLE.md"].map(PathBuf::from),
    );
    paths.sort();
    paths.iter().map(|path| Page::read(path)).collect()
}
