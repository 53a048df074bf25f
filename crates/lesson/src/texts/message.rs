//! A text of the table, taken apart.

/// A piece of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Part {
    /// Words.
    Plain(String),
    /// A value: its name, how it is written, and the forms to choose from by count, if it is that.
    Value { name: String, written: Vec<Written>, forms: Vec<Vec<Part>> },
    /// Mark-up around parts.
    Tag { tag: String, parts: Vec<Part> },
}

/// The form of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Written {
    /// A count in words, up to ten.
    Words,
    /// The first letter large.
    Capital,
}

impl Written {
    fn named(name: &str) -> Option<Written> {
        match name {
            "words" => Some(Written::Words),
            "capital" => Some(Written::Capital),
            _ => None,
        }
    }
}

/// The parts of a text. A tag or brace that stays open ends with the text, and one without its beginning is passed
/// over: tests find such texts.
pub(super) fn parts(text: &str) -> Vec<Part> {
    let mut rest = text;
    sequence(&mut rest, false)
}

/// The parts up to the end of a form, if these belong to one, of a value or of mark-up.
fn sequence(rest: &mut &str, in_form: bool) -> Vec<Part> {
    let mut parts = Vec::new();
    let is_end = |letter: char| letter == '{' || letter == '<' || in_form && (letter == '|' || letter == '}');
    loop {
        let plain = rest.split(is_end).next().unwrap_or_default();
        if !plain.is_empty() {
            parts.push(Part::Plain(plain.to_owned()));
            *rest = rest.strip_prefix(plain).unwrap_or_default();
        }
        if let Some(after) = rest.strip_prefix('{') {
            *rest = after;
            parts.push(value(rest));
        } else if rest.starts_with("</") || !rest.starts_with('<') {
            return parts;
        } else {
            parts.push(tag(rest, in_form));
        }
    }
}

fn value(rest: &mut &str) -> Part {
    let head = rest.split(['|', '}']).next().unwrap_or_default();
    let mut words = head.split(':');
    let name = words.next().unwrap_or_default().to_owned();
    let written = words.filter_map(Written::named).collect();
    *rest = rest.strip_prefix(head).unwrap_or_default();
    let mut forms = Vec::new();
    while let Some(after) = rest.strip_prefix('|') {
        *rest = after;
        forms.push(sequence(rest, true));
    }
    *rest = rest.strip_prefix('}').unwrap_or(rest);
    Part::Value { name, written, forms }
}

fn tag(rest: &mut &str, in_form: bool) -> Part {
    let (name, after) = rest.trim_start_matches('<').split_once('>').unwrap_or_default();
    let tag = name.to_owned();
    *rest = after;
    let parts = sequence(rest, in_form);
    if let Some(after) = rest.strip_prefix("</") {
        *rest = after.split_once('>').map_or("", |(_, after)| after);
    }
    Part::Tag { tag, parts }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(text: &str) -> Part {
        Part::Plain(text.to_owned())
    }

    fn of(name: &str, written: &[Written], forms: Vec<Vec<Part>>) -> Part {
        Part::Value { name: name.to_owned(), written: written.to_vec(), forms }
    }

    #[test]
    fn values_forms_and_tags_are_told_apart() {
        assert_eq!(parts("a | b"), [plain("a | b")]);
        let forms = vec![vec![plain("one")], vec![of("n", &[Written::Words], vec![]), plain(" of them")]];
        assert_eq!(
            parts("It has {n|one|{n:words} of them}, <i>{who:words:capital}</i>."),
            [
                plain("It has "),
                of("n", &[], forms),
                plain(", "),
                Part::Tag {
                    tag: "i".to_owned(),
                    parts: vec![of("who", &[Written::Words, Written::Capital], vec![])]
                },
                plain("."),
            ]
        );
    }

    #[test]
    fn what_is_left_open_ends() {
        assert_eq!(parts("{"), [of("", &[], vec![])]);
        assert_eq!(parts("a{n|b"), [plain("a"), of("n", &[], vec![vec![plain("b")]])]);
        assert_eq!(parts("<i>a"), [Part::Tag { tag: "i".to_owned(), parts: vec![plain("a")] }]);
        assert_eq!(parts("a</i>b"), [plain("a")]);
    }
}
