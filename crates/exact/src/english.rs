//! Counts and lists in English, for the texts of every crate: all stand on this one.

use std::fmt::{Display, Write as _};

/// The most items that a [`list`] names before it only counts the rest.
pub const MOST: usize = 8;

/// `1 vertex`, `2 vertices`.
pub fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// A count, in words up to ten.
pub fn in_words(count: usize) -> String {
    const WORDS: [&str; 11] =
        ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    WORDS.get(count).map_or_else(|| count.to_string(), |word| (*word).to_owned())
}

/// A size in bytes: `1 GiB`, `1.5 GiB`, `512 MiB`, `100 bytes`; what is not whole is rounded up to a tenth.
///
/// ```
/// use boundfit_exact::english::size_text;
///
/// assert_eq!([1 << 30, (3 << 29) + 1, 700, 1 << 20].map(size_text), ["1 GiB", "1.6 GiB", "700 bytes", "1 MiB"]);
/// ```
pub fn size_text(bytes: u64) -> String {
    let unit = [(30, "GiB"), (20, "MiB"), (10, "KiB")].into_iter().find(|(bits, _)| bytes >> bits > 0);
    let Some((bits, name)) = unit else { return counted(bytes as usize, "byte", "bytes") };
    let tenths = (u128::from(bytes) * 10).div_ceil(1 << bits);
    match tenths % 10 {
        0 => format!("{} {name}", tenths / 10),
        part => format!("{}.{part} {name}", tenths / 10),
    }
}

/// A name and the unit behind it in parentheses or brackets: `U (mV)`, `U [mV]`.
///
/// ```
/// use boundfit_exact::english::split_unit;
///
/// assert_eq!(split_unit("U (mV)"), ("U", Some("mV")));
/// assert_eq!(split_unit("flow rate[m/s]"), ("flow rate", Some("m/s")));
/// assert_eq!(split_unit("f(x)"), ("f(x)", None));
/// ```
pub fn split_unit(name: &str) -> (&str, Option<&str>) {
    let parts = [('(', ')'), ('[', ']')].into_iter().find_map(|(open, close)| {
        let (before, unit) = name.trim_end().strip_suffix(close)?.rsplit_once(open)?;
        let unit = unit.trim();
        // Without a blank, parentheses belong to a name such as f(x), and a number in brackets is an index.
        let is_unit = (open == '[' || before.ends_with(char::is_whitespace))
            && !unit.is_empty()
            && !unit.bytes().all(|byte| byte.is_ascii_digit());
        let before = before.trim();
        (is_unit && !before.is_empty()).then_some((before, unit))
    });
    parts.map_or((name, None), |(name, unit)| (name, Some(unit)))
}

/// A unit by another one: `m/V`, `mV/(m/s)`.
pub fn unit_by(unit: &str, by: &str) -> String {
    let whole = |unit: &str| unit.chars().all(char::is_alphanumeric);
    let [unit, by] = [unit, by].map(|unit| if whole(unit) { unit.to_owned() } else { format!("({unit})") });
    format!("{unit}/{by}")
}

/// A list in a table or behind a colon: `a, b, c`; of more than eight items the first ones, `…, and 3 more`.
pub fn list(items: impl ExactSizeIterator<Item = String>) -> String {
    list_of(items, 0)
}

/// A [`list`] of the first of some items, beside which there are so many more.
pub fn list_of<T: Display>(first: impl ExactSizeIterator<Item = T>, more: usize) -> String {
    let count = first.len();
    let beyond = count.saturating_sub(MOST) + more;
    // One text for all: a million vertices have lists of names. Writing into a string never fails.
    let mut list = String::new();
    for (position, item) in first.take(MOST).enumerate() {
        list.push_str(if position > 0 { ", " } else { "" });
        let _ = write!(list, "{item}");
    }
    if beyond > 0 {
        list.push_str(if count > 0 { ", " } else { "" });
        let _ = write!(list, "and {beyond} more");
    }
    list
}

/// A list within a sentence: `a`, `a and b`, `a, b and c`; of more than eight items seven, `… and 3 more`.
pub fn listed(items: &[String]) -> String {
    match items {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] if items.len() <= MOST => format!("{} and {last}", first.join(", ")),
        _ => {
            let (shown, more) = items.split_at(MOST - 1);
            format!("{} and {} more", shown.join(", "), more.len())
        }
    }
}

/// The text as a sentence begins: its first letter large.
pub fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Ascending numbers, three or more that follow each other as a range: `1..11, 34, 35 and 39..46`.
pub fn ranges(numbers: &[usize]) -> String {
    let follows = |one: &usize, next: &usize| one + 1 == *next;
    let range = |run: &[usize]| match run {
        [first, _, .., last] if run.len() > 2 => vec![format!("{first}..{last}")],
        run => run.iter().map(ToString::to_string).collect(),
    };
    let items: Vec<String> = numbers.chunk_by(follows).flat_map(range).collect();
    match items.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => items.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_like_english() {
        let items = |count: usize| (1..=count).map(|i| i.to_string()).collect::<Vec<_>>();
        assert_eq!(listed(&items(0)), "");
        assert_eq!(listed(&items(1)), "1");
        assert_eq!(listed(&items(2)), "1 and 2");
        assert_eq!(listed(&items(3)), "1, 2 and 3");
        assert_eq!(listed(&items(8)), "1, 2, 3, 4, 5, 6, 7 and 8");
        assert_eq!(listed(&items(12)), "1, 2, 3, 4, 5, 6, 7 and 5 more");
        assert_eq!(list(items(2).into_iter()), "1, 2");
        assert_eq!(list(items(8).into_iter()), "1, 2, 3, 4, 5, 6, 7, 8");
        assert_eq!(list(items(12).into_iter()), "1, 2, 3, 4, 5, 6, 7, 8, and 4 more");
    }

    #[test]
    fn lists_name_the_first_items_and_count_the_others() {
        let named = |count: usize, more: usize| {
            list_of(["", "b", "c"].into_iter().cycle().take(count).collect::<Vec<_>>().into_iter(), more)
        };
        for (count, more, expected) in [
            (0, 0, ""),
            (0, 2, "and 2 more"),
            (1, 0, ""),
            (1, 1, ", and 1 more"),
            (3, 0, ", b, c"),
            (3, 5, ", b, c, and 5 more"),
            (8, 0, ", b, c, , b, c, , b"),
            (11, 4, ", b, c, , b, c, , b, and 7 more"),
        ] {
            assert_eq!(named(count, more), expected, "{count} {more}");
        }
    }

    #[test]
    fn units_of_quotients_are_not_ambiguous() {
        assert_eq!(unit_by("m", "V"), "m/V");
        assert_eq!(unit_by("mV", "m/s"), "mV/(m/s)");
        assert_eq!(unit_by("°C", "10⁻³"), "(°C)/(10⁻³)");
    }

    #[test]
    fn counts_agree_with_their_nouns() {
        assert_eq!(counted(1, "vertex", "vertices"), "1 vertex");
        assert_eq!(counted(0, "vertex", "vertices"), "0 vertices");
        assert_eq!([0, 10, 11].map(in_words), ["no", "ten", "11"]);
        assert_eq!(sentence("the end"), "The end");
    }
}
