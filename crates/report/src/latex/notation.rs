//! The words and formulas of text reports in LaTeX.

/// Words that stand for something in formulas.
const SYMBOLS: [(&str, &str); 8] = [
    ("theta1", r"\theta_1"),
    ("theta2", r"\theta_2"),
    ("eps_min", r"\varepsilon_{\min}"),
    ("eps", r"\varepsilon"),
    ("inf", r"\infty"),
    ("s^2", "s^2"),
    ("s", "s"),
    ("e", "e"),
];

/// Operators, the longest first.
const OPERATORS: [(&str, &str); 6] =
    [("+-", r"\pm "), (">=", r"\ge "), ("<=", r"\le "), ("*", r"\cdot "), ("=", "="), ("|", "|")];

enum Token {
    Math(String),
    Words(String),
    Space,
}

/// A text that LaTeX shows as it is.
pub(super) fn escaped(text: &str) -> String {
    let mut result = String::new();
    for character in text.chars() {
        match character {
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                result.push('\\');
                result.push(character);
            }
            '\\' => result.push_str(r"\textbackslash{}"),
            '~' => result.push_str(r"\textasciitilde{}"),
            '^' => result.push_str(r"\textasciicircum{}"),
            '<' => result.push_str(r"\textless{}"),
            '>' => result.push_str(r"\textgreater{}"),
            '|' => result.push_str(r"\textbar{}"),
            '"' => result.push_str("''"),
            // Two of these would be one dash.
            '-' => result.push_str("{-}"),
            '\'' | '`' | ',' => result.extend(['{', character, '}']),
            control if control.is_control() => result.push(' '),
            other => result.push(other),
        }
    }
    result
}

/// A text of a report, its numbers, symbols and intervals as formulas.
pub(super) fn formulas(text: &str) -> String {
    let mut result = String::new();
    let mut formula = String::new();
    let mut spaces = false;
    let mut tokens = Lexer { rest: text, before: None, groups: Vec::new() };
    while let Some(token) = tokens.next() {
        match token {
            Token::Space => spaces = true,
            Token::Math(math) => {
                if spaces && formula.is_empty() {
                    result.push(' ');
                } else if spaces && !formula.ends_with(' ') {
                    formula.push(' ');
                }
                formula.push_str(&math);
                spaces = false;
            }
            Token::Words(words) => {
                finish(&mut formula, &mut result);
                if spaces {
                    result.push(' ');
                }
                result.push_str(&words);
                spaces = false;
            }
        }
    }
    finish(&mut formula, &mut result);
    result
}

fn finish(formula: &mut String, result: &mut String) {
    if !formula.is_empty() {
        result.push_str(&format!("${}$", formula.trim_end()));
        formula.clear();
    }
}

/// Cuts a text of a report into tokens.
struct Lexer<'a> {
    rest: &'a str,
    /// The character before the rest.
    before: Option<char>,
    /// Whether each open bracket belongs to a formula.
    groups: Vec<bool>,
}

impl Lexer<'_> {
    fn next(&mut self) -> Option<Token> {
        let first = self.rest.chars().next()?;
        let within_word = self.before.is_some_and(is_of_word);
        if first == ' ' {
            self.take(1);
            return Some(Token::Space);
        }
        if !within_word && let Some((symbol, math)) = SYMBOLS.into_iter().find(|(word, _)| self.is_at(word)) {
            self.take(symbol.len());
            return Some(Token::Math(math.to_owned()));
        }
        if first.is_ascii_digit()
            && !within_word
            && let Some((length, math)) = number(self.rest)
        {
            self.take(length);
            return Some(Token::Math(math));
        }
        if let Some((operator, math)) = OPERATORS.into_iter().find(|(text, _)| self.rest.starts_with(text)) {
            self.take(operator.len());
            return Some(Token::Math(math.to_owned()));
        }
        if is_of_word(first) {
            let length = self.rest.find(|character| !is_of_word(character)).unwrap_or(self.rest.len());
            return Some(Token::Words(escaped(self.take(length))));
        }
        Some(self.punctuation(first))
    }

    fn punctuation(&mut self, first: char) -> Token {
        let before = self.before;
        let text = self.take(first.len_utf8()).to_owned();
        let after = self.rest.chars().next();
        let is_math = match first {
            '(' | '[' => {
                let is_math = first == '[' || is_formula(self.rest);
                self.groups.push(is_math);
                is_math
            }
            ')' | ']' => self.groups.pop().unwrap_or(false),
            ',' => self.groups.last().copied().unwrap_or(false),
            // Between two of something, or in front of one.
            '+' | '-' => {
                let is_apart = before.is_none_or(|before| matches!(before, ' ' | '(' | '['));
                is_apart && after.is_none_or(|after| after == ' ' || after.is_alphanumeric())
            }
            '/' => before.is_some_and(is_of_word) && after.is_some_and(char::is_alphanumeric),
            _ => false,
        };
        match first {
            _ if is_math => Token::Math(text),
            // The same as above.
            '"' => Token::Words("''".to_owned()),
            ',' | '-' | '\'' => Token::Words(text),
            _ => Token::Words(escaped(&text)),
        }
    }

    /// Whether the rest begins with a whole word.
    fn is_at(&self, word: &str) -> bool {
        self.rest.strip_prefix(word).is_some_and(|rest| !rest.starts_with(is_of_word))
    }

    fn take(&mut self, length: usize) -> &str {
        let (taken, rest) = self.rest.split_at_checked(length).unwrap_or((self.rest, ""));
        self.before = taken.chars().last().or(self.before);
        self.rest = rest;
        taken
    }
}

fn is_of_word(character: char) -> bool {
    character.is_alphanumeric() || matches!(character, '_' | ':' | '.' | '\'')
}

/// Whether what stands in a bracket has no words.
fn is_formula(text: &str) -> bool {
    let content = text.split([')', ']']).next().unwrap_or_default();
    let words = content.split(|character: char| !character.is_alphanumeric() && character != '.');
    words.filter(|word| !word.is_empty()).all(|word| {
        SYMBOLS.iter().any(|(symbol, _)| *symbol == word)
            || word.starts_with(|first: char| first.is_ascii_digit())
    })
}

/// The decimal that a text begins with: its length, and the number with its power of ten.
fn number(text: &str) -> Option<(usize, String)> {
    let digits = |text: &str| text.find(|character: char| !character.is_ascii_digit()).unwrap_or(text.len());
    let mut length = digits(text);
    if let Some(fraction) = text.get(length..)?.strip_prefix('.')
        && digits(fraction) > 0
    {
        length += 1 + digits(fraction);
    }
    let mantissa = text.get(..length)?;
    let mut math = mantissa.to_owned();
    if let Some(exponent) = text.get(length..)?.strip_prefix('e') {
        let sign = usize::from(exponent.starts_with('-'));
        let size = digits(exponent.get(sign..)?);
        if size > 0 {
            math = format!(r"{mantissa} \times 10^{{{}}}", exponent.get(..sign + size)?);
            length += 1 + sign + size;
        }
    }
    let is_whole = !text.get(length..)?.starts_with(|next: char| next.is_alphanumeric() || next == '_');
    is_whole.then_some((length, math))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_reports_become_formulas() {
        for (text, latex) in [
            ("1.8194e-3", r"$1.8194 \times 10^{-3}$"),
            ("-12.526", "$-12.526$"),
            ("[1.7e-3, 2]", r"$[1.7 \times 10^{-3}, 2]$"),
            ("(-inf, 85/8]", r"$(-\infty, 85/8]$"),
            ("+-17/8", r"$\pm 17/8$"),
            ("gain 1/theta1", r"gain $1/\theta_1$"),
            ("offset -theta2/theta1", r"offset $-\theta_2/\theta_1$"),
            ("1/8 * (14 upper) + 2 * (3 lower)", r"$1/8 \cdot$ ($14$ upper) $+ 2 \cdot$ ($3$ lower)"),
            ("theta1 >=", r"$\theta_1 \ge$"),
            ("eps_min", r"$\varepsilon_{\min}$"),
            ("50/7 - 5/3*s + s^2", r"$50/7 - 5/3\cdot s + s^2$"),
            ("\"", "''"),
            ("unbounded-polygon with 2 vertices", "unbounded-polygon with $2$ vertices"),
            ("14 upper, 24 lower", "$14$ upper, $24$ lower"),
            ("binary64: numbers exactly", "binary64: numbers exactly"),
            ("where:1", "where:1"),
            ("0.39445 (exactly 7/19)", "$0.39445$ (exactly $7/19$)"),
            ("both directions of (1, -2)", "both directions of $(1, -2)$"),
            ("gives 0 <= -1.5.", r"gives $0 \le -1.5$."),
            ("|e| <= 5e-4", r"$|e| \le 5 \times 10^{-4}$"),
        ] {
            assert_eq!(formulas(text), latex, "{text}");
        }
    }

    #[test]
    fn names_are_shown_as_they_are() {
        assert_eq!(escaped("V_z & 5%"), r"V\_z \& 5\%");
        assert_eq!(
            escaped("a\\b{^~}|<>--"),
            r"a\textbackslash{}b\{\textasciicircum{}\textasciitilde{}\}\textbar{}\textless{}\textgreater{}{-}{-}"
        );
    }
}
