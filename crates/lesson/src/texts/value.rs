//! Texts with their values, as the document has them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A text of the table by its key, with what stands in its places.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Message {
    text: String,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    values: BTreeMap<String, Value>,
}

/// The value in a place of a text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub(crate) enum Value {
    /// A count, or the number of a row.
    Count(usize),
    /// A value that is written as it is, in every language.
    Plain(String),
    /// Another text.
    Text(Message),
    /// A number, with the decimal mark of the language.
    Number {
        /// The number with a point.
        number: String,
    },
    /// A condition or half-plane as it was given, its decimals with the mark of the language.
    Formula {
        /// The formula with points.
        formula: String,
    },
    /// Several values: "a, b and c".
    List {
        /// The values.
        list: Vec<Value>,
        /// The key of what stands between them, where that is the same everywhere.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        by: Option<String>,
        /// The number of further items.
        #[serde(default, skip_serializing_if = "is_zero")]
        more: usize,
    },
}

/// Returns whether nothing is left out, for serde.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn is_zero(more: &usize) -> bool {
    *more == 0
}

/// The number of items that a list names before it only counts the rest.
const MOST: usize = 8;

impl Message {
    /// A text without values.
    pub(crate) fn new(text: &str) -> Self {
        Message { text: text.to_owned(), values: BTreeMap::new() }
    }

    /// The text with one more value.
    pub(crate) fn with(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.values.insert(name.to_owned(), value.into());
        self
    }

    pub(super) fn key(&self) -> &str {
        &self.text
    }

    pub(super) fn value(&self, name: &str) -> Option<&Value> {
        self.values.get(name)
    }
}

impl Value {
    /// A number as decimals are written, with a point.
    pub(crate) fn number(number: impl Into<String>) -> Self {
        Value::Number { number: number.into() }
    }

    /// A condition as it was given, with points before decimals.
    pub(crate) fn formula(formula: impl Into<String>) -> Self {
        Value::Formula { formula: formula.into() }
    }

    /// Values within a sentence: "a, b and c"; of more than eight the first seven.
    pub(crate) fn listed<T: Into<Value>>(values: impl IntoIterator<Item = T>) -> Self {
        let mut list: Vec<Value> = values.into_iter().map(Into::into).collect();
        let more = if list.len() > MOST { list.len() - (MOST - 1) } else { 0 };
        list.truncate(list.len() - more);
        Value::List { list, by: None, more }
    }

    /// Values with the text of a key between each two of them.
    pub(crate) fn joined<T: Into<Value>>(values: impl IntoIterator<Item = T>, by: &str) -> Self {
        let list = values.into_iter().map(Into::into).collect();
        Value::List { list, by: Some(by.to_owned()), more: 0 }
    }

    /// Returns the number of things that a value is.
    pub(super) fn count(&self) -> usize {
        match self {
            Value::Count(count) => *count,
            Value::List { list, more, .. } => list.len() + more,
            Value::Plain(_) | Value::Text(_) | Value::Number { .. } | Value::Formula { .. } => 1,
        }
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Value::Count(count)
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Value::Plain(text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Value::Plain(text.to_owned())
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Value::Text(message)
    }
}

/// A text by its key with named values: `text!("bound.upper", row: 14)`.
macro_rules! text {
    ($key:expr $(, $name:ident: $value:expr)* $(,)?) => {
        $crate::texts::Message::new($key)$(.with(stringify!($name), $value))*
    };
}
pub(crate) use text;
