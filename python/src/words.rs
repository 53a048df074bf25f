//! The faults of a table in the words of this package.

use boundfit::engine::exact::Limit;
use boundfit::files::{InputError, Setting, Way};

/// Returns the fault of a table, in the words of this package, to a call that has an argument `limits` or not.
pub(crate) fn in_words(error: &InputError, has_limits: bool) -> String {
    // Columns in memory have this name, and no header.
    let text = error
        .to_string()
        .replace("readings: the file has a header but no data rows", "readings: the columns are empty");
    let ways: Vec<String> = error.ways().iter().filter_map(|way| as_argument(way, has_limits)).collect();
    if ways.is_empty() { text } else { format!("{text}; {}", ways.join(", ")) }
}

/// A way out as this package has it: `decimal="comma" reads 1,5`; none where the call has no such argument.
pub(crate) fn as_argument(way: &Way, has_limits: bool) -> Option<String> {
    let Way { setting, value, effect } = way;
    Some(match setting {
        // It has an argument of its own.
        Setting::Limit(Limit::Steps) => format!("max_steps=... {effect}"),
        Setting::Limit(_) if !has_limits => return None,
        Setting::Limit(limit) => format!("limits={{\"{}\": ...}} {effect}", limit.name()),
        setting => {
            let value = match *value {
                "" => "True".to_owned(),
                number @ "N" => number.to_owned(),
                quoted if quoted.starts_with('"') => quoted.to_owned(),
                text => format!("\"{}\"", text.trim_matches('\'')),
            };
            format!("{}={value} {effect}", setting.name().replace(' ', "_"))
        }
    })
}
