//! The words about a value of another type than its key has, without the names of Rust's types.

/// Returns what is wrong with a value, from the words of serde: `"3": expected an integer that is at least 0`.
pub(crate) fn wrong_type(error: &serde_json::Error) -> String {
    let words = error.to_string();
    let parts = ["invalid type: ", "invalid value: ", "invalid length "]
        .into_iter()
        .find_map(|start| words.strip_prefix(start)?.split_once(", expected "));
    match parts {
        Some((found, expected)) => format!("{}: expected {}", found_words(found), expected_words(expected)),
        // What an enumeration expects is all that it says.
        None if words.contains("expected") => words,
        None => format!("expected {words}"),
    }
}

/// The value that is there, as JSON has it. Of an array with another length serde says the length.
fn found_words(found: &str) -> String {
    let shown = ["integer ", "floating point ", "boolean ", "string "]
        .into_iter()
        .find_map(|kind| found.strip_prefix(kind))
        .map(|text| text.trim_matches('`').to_owned());
    shown.unwrap_or_else(|| match found {
        "sequence" => "an array".to_owned(),
        "map" => "an object".to_owned(),
        count if count.bytes().all(|byte| byte.is_ascii_digit()) => format!("an array of {count}"),
        other => other.to_owned(),
    })
}

fn expected_words(expected: &str) -> &str {
    match expected {
        "a string" => "a text",
        "a boolean" => "true or false",
        "a sequence" => "an array",
        "a map" => "an object",
        "an array of length 2" => "an array of two",
        "fewer elements in array" => "fewer elements",
        "u16" => "an integer from 0 to 65535",
        "u32" | "u64" | "usize" => "an integer that is at least 0",
        "i64" => "an integer",
        other => other,
    }
}
