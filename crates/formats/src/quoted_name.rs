//! Names of columns, sheets and blocks that are asked for in quotes.

/// Returns the name within the quotes of a text: a name also where it looks like a number.
pub(crate) fn in_quotes(text: &str) -> Option<&str> {
    ['"', '\''].into_iter().find_map(|quote| {
        let name = text.trim().strip_prefix(quote)?.strip_suffix(quote)?;
        (!name.trim().is_empty()).then_some(name)
    })
}
