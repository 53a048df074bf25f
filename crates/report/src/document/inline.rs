//! Lines of a report: words, numbers and formulas, each known for what it is.

use std::borrow::Cow;
use std::fmt;

use boundfit_exact::Foreign;

/// A piece of a line. Its [`Display`](fmt::Display) form is that of plain text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Inline {
    /// English.
    Words(String),
    /// Text from outside: names of columns and files, conditions.
    Given(Foreign),
    /// A number in digits, perhaps with a sign and a power of ten, or a fraction: `-1.8194e-3`, `21/11726`.
    Number(String),
    /// A letter of formulas.
    Symbol(Symbol),
    /// An operator between two operands, with the space around it.
    Operator(Operator),
    /// A bracket, comma, bar, sign or power of a formula, which looks alike in all languages.
    Mark(&'static str),
    /// Sets a cell off from the one above, which it belongs to.
    Indent,
}

/// A letter of formulas, or a sign that stands by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Symbol {
    Theta1,
    Theta2,
    /// The error bound.
    Epsilon,
    /// The least error bound.
    LeastEpsilon,
    /// The factor on the error bounds.
    Factor,
    /// The error of a reading.
    Error,
    Infinity,
    PlusMinus,
    AtLeast,
    AtMost,
}

/// The parameters, by axis.
pub(crate) const THETA: [Symbol; 2] = [Symbol::Theta1, Symbol::Theta2];

/// An operator or relation between two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operator {
    Plus,
    Minus,
    /// A product with space around the sign, as between a multiplier and a name.
    Times,
    /// A product without, as within a term.
    Dot,
    AtMost,
    Equals,
}

impl fmt::Display for Inline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Inline::Given(text) => return text.fmt(f),
            // Ours are plain to see; if a text from outside came to be among them, it is, too.
            Inline::Words(text) => return Foreign::of(text).fmt(f),
            Inline::Number(text) => text,
            Inline::Mark(mark) => mark,
            Inline::Indent => "  ",
            Inline::Symbol(symbol) => symbol.forms().0,
            Inline::Operator(operator) => operator.forms().0,
        })
    }
}

impl Symbol {
    /// Returns the forms in plain text and in LaTeX.
    pub(super) fn forms(self) -> (&'static str, &'static str) {
        match self {
            Symbol::Theta1 => ("theta1", r"\theta_1"),
            Symbol::Theta2 => ("theta2", r"\theta_2"),
            Symbol::Epsilon => ("eps", r"\varepsilon"),
            Symbol::LeastEpsilon => ("eps_min", r"\varepsilon_{\min}"),
            Symbol::Factor => ("s", "s"),
            Symbol::Error => ("e", "e"),
            Symbol::Infinity => ("inf", r"\infty"),
            Symbol::PlusMinus => ("+-", r"\pm "),
            Symbol::AtLeast => (">=", r"\ge"),
            Symbol::AtMost => ("<=", r"\le"),
        }
    }
}

impl Operator {
    /// Returns the forms in plain text and in LaTeX.
    pub(super) fn forms(self) -> (&'static str, &'static str) {
        match self {
            Operator::Plus => (" + ", " + "),
            Operator::Minus => (" - ", " - "),
            Operator::Times => (" * ", r" \cdot "),
            Operator::Dot => ("*", r" \cdot "),
            Operator::AtMost => (" <= ", r" \le "),
            Operator::Equals => (" = ", " = "),
        }
    }
}

/// A line or cell. Its [`Display`](fmt::Display) form is that of plain text.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Text(pub(super) Vec<Inline>);

impl Text {
    /// Nothing yet.
    pub(crate) fn new() -> Self {
        Text::default()
    }

    pub(crate) fn words(self, words: impl Into<String>) -> Self {
        self.with(Inline::Words(words.into()))
    }

    pub(crate) fn given(self, text: impl Into<Foreign>) -> Self {
        self.with(Inline::Given(text.into()))
    }

    /// A number in digits, or a fraction.
    pub(crate) fn number(self, number: impl ToString) -> Self {
        self.with(Inline::Number(number.to_string()))
    }

    pub(crate) fn symbol(self, symbol: Symbol) -> Self {
        self.with(Inline::Symbol(symbol))
    }

    pub(crate) fn operator(self, operator: Operator) -> Self {
        self.with(Inline::Operator(operator))
    }

    pub(crate) fn mark(self, mark: &'static str) -> Self {
        self.with(Inline::Mark(mark))
    }

    pub(crate) fn with(mut self, inline: Inline) -> Self {
        // Most texts are cells with one piece, where a vector would reserve memory for four.
        if self.0.is_empty() {
            self.0.reserve_exact(1);
        }
        self.0.push(inline);
        self
    }

    pub(crate) fn then(mut self, other: Text) -> Self {
        self.0.extend(other.0);
        self
    }

    /// Texts with the same separator between every two.
    pub(crate) fn joined(texts: impl IntoIterator<Item = Text>, separator: &Inline) -> Self {
        texts.into_iter().enumerate().fold(Text::new(), |all, (index, text)| {
            if index == 0 { text } else { all.with(separator.clone()).then(text) }
        })
    }

    /// The plain text; no copy of a single number.
    pub(super) fn plain(&self) -> Cow<'_, str> {
        match self.0.as_slice() {
            [Inline::Number(number)] => Cow::Borrowed(number),
            [Inline::Words(words)] => plain_words(words),
            _ => Cow::Owned(self.to_string()),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Words as plain text; no copy of what is plain to see.
pub(super) fn plain_words(words: &str) -> Cow<'_, str> {
    match words.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        true => Cow::Borrowed(words),
        false => Cow::Owned(Foreign::of(words).to_string()),
    }
}

impl From<&str> for Text {
    fn from(words: &str) -> Self {
        Text::from(words.to_owned())
    }
}

impl From<String> for Text {
    fn from(words: String) -> Self {
        if words.is_empty() { Text::new() } else { Text::new().words(words) }
    }
}

impl From<Symbol> for Text {
    fn from(symbol: Symbol) -> Self {
        Text::new().symbol(symbol)
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|inline| inline.fmt(f))
    }
}
