//! Texts in a language.

use serde_json::Value as Json;

use super::message::{Part, Written, parts};
use super::value::{Message, Value};
use super::{Language, text_of};

/// A message of the document as a sentence in a language: what the page's script makes of it. Text that is none stays.
#[must_use]
pub fn said(message: &Json, language: Language) -> String {
    match serde_json::from_value::<Value>(message.clone()) {
        Ok(value) => Speaker { language, is_html: false }.value(&value),
        Err(_) => String::new(),
    }
}

/// A message as plain text.
pub(crate) fn say(message: &Message, language: Language) -> String {
    Speaker { language, is_html: false }.message(message)
}

/// A message as HTML: with its mark-up, and values as text.
pub(crate) fn html(message: &Message, language: Language) -> String {
    Speaker { language, is_html: true }.message(message)
}

/// Text as HTML.
pub(crate) fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\'' => html.push_str("&#39;"),
            _ => html.push(letter),
        }
    }
    html
}

/// The speaker of a text.
#[derive(Debug, Clone, Copy)]
struct Speaker {
    language: Language,
    is_html: bool,
}

impl Speaker {
    fn message(self, message: &Message) -> String {
        self.parts(&parts(text_of(message.key(), self.language)), message)
    }

    fn parts(self, parts: &[Part], message: &Message) -> String {
        let mut said = String::new();
        for part in parts {
            match part {
                Part::Plain(text) => said.push_str(&self.plain(text)),
                Part::Value { name, written, forms } => {
                    said.push_str(&self.place(name, written, forms, message));
                }
                Part::Tag { tag, parts } => {
                    let inner = self.parts(parts, message);
                    let name = tag.split(' ').next().unwrap_or_default();
                    said += &if self.is_html { format!("<{tag}>{inner}</{name}>") } else { inner };
                }
            }
        }
        said
    }

    fn place(self, name: &str, written: &[Written], forms: &[Vec<Part>], message: &Message) -> String {
        let Some(value) = message.value(name) else { return String::new() };
        if !forms.is_empty() {
            return self.parts(form(forms, value.count()), message);
        }
        let mut said = match value {
            Value::Count(count) if written.contains(&Written::Words) => self.in_words(*count),
            value => self.value(value),
        };
        if written.contains(&Written::Capital) {
            said = capital(&said);
        }
        said
    }

    fn value(self, value: &Value) -> String {
        match value {
            Value::Count(count) => count.to_string(),
            Value::Plain(text) => self.plain(text),
            Value::Text(message) => self.message(message),
            Value::Number { number } => number.replace('.', self.language.decimal_mark()),
            Value::Formula { formula } => self.plain(&self.formula(formula)),
            Value::List { list, by, more } => self.list(list, by.as_deref(), *more),
        }
    }

    /// A formula with the decimal mark of the language in place of the points before digits.
    fn formula(self, formula: &str) -> String {
        let mut rest = formula.chars().peekable();
        let mut said = String::with_capacity(formula.len());
        while let Some(letter) = rest.next() {
            match letter {
                '.' if rest.peek().is_some_and(char::is_ascii_digit) => said += self.language.decimal_mark(),
                letter => said.push(letter),
            }
        }
        said
    }

    fn list(self, list: &[Value], by: Option<&str>, more: usize) -> String {
        let mut items: Vec<String> = list.iter().map(|value| self.value(value)).collect();
        if more > 0 {
            items.push(self.message(&Message::new("list.more").with("count", more)));
        }
        let [between, last] = match by {
            Some(key) => [key, key],
            None => ["list.comma", "list.and"],
        };
        let [between, last] = [between, last].map(|key| text_of(key, self.language));
        match items.split_last() {
            Some((end, start)) if !start.is_empty() => format!("{}{last}{end}", start.join(between)),
            _ => items.concat(),
        }
    }

    /// A count, in words up to ten.
    fn in_words(self, count: usize) -> String {
        let words = text_of("number.words", self.language);
        words.split(' ').nth(count).map_or_else(|| count.to_string(), str::to_owned)
    }

    fn plain(self, text: &str) -> String {
        if self.is_html { escaped(text) } else { text.to_owned() }
    }
}

/// The form for a count: of two one and several, of three none as well.
fn form(forms: &[Vec<Part>], count: usize) -> &[Part] {
    let from_end = match count {
        0 if forms.len() > 2 => 3,
        1 => 2,
        _ => 1,
    };
    forms.len().checked_sub(from_end).and_then(|index| forms.get(index)).map_or(&[], Vec::as_slice)
}

/// The text as a sentence begins.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
