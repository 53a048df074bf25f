//! Pieces of a file in messages.

/// The longest piece of a file that an error message repeats.
const LONGEST_QUOTE: usize = 40;

/// A text in quotes, cut where it is long, with control characters made visible.
pub(super) fn quote(text: &str) -> String {
    match text.char_indices().nth(LONGEST_QUOTE) {
        Some((end, _)) => format!("{:?}...", text.get(..end).unwrap_or_default()),
        None => format!("{text:?}"),
    }
}
