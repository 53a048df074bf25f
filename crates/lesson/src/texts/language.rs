//! The languages of the page.

/// A language that the page speaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Italian.
    Italian,
    /// German.
    German,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 3] = [Language::English, Language::Italian, Language::German];

    /// The code of the language, as HTML has it: `en`, `it`, `de`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Italian => "it",
            Language::German => "de",
        }
    }

    /// The name of the language in it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Language::English => "English",
            Language::Italian => "Italiano",
            Language::German => "Deutsch",
        }
    }

    /// The text before the decimals of a number.
    pub(crate) const fn decimal_mark(self) -> &'static str {
        match self {
            Language::English => ".",
            Language::Italian | Language::German => ",",
        }
    }
}
