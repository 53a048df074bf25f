//! The sources of the libraries and of the program.

use std::fs;
use std::path::Path;

/// The lines of a folder's sources outside comments, blank lines and unit tests, with where they stand.
pub(crate) fn lines_of_code(folder: &Path) -> Vec<(String, String)> {
    let mut lines = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("tests") {
            lines.extend(lines_of_code(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") && !path.ends_with("tests.rs") {
            let text = fs::read_to_string(&path).unwrap();
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            let is_code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
            let place =
                |(number, line): (usize, &str)| (format!("{}:{number}", path.display()), line.to_owned());
            lines.extend((1..).zip(code.lines()).filter(|(_, line)| is_code(line)).map(place));
        }
    }
    lines
}
