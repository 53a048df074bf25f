//! The common parts of both references.

/// A text in a cell of a table.
pub(super) fn cell(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

/// A text without markup as Markdown.
pub(super) fn plain(text: &str) -> String {
    text.chars()
        .flat_map(|letter| "*_<[`\\".contains(letter).then_some('\\').into_iter().chain([letter]))
        .collect()
}

/// The anchor of a heading, as repository viewers and mdBook make it.
pub(super) fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).flat_map(char::to_lowercase).collect()
}
