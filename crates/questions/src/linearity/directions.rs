//! The words of a column that stand for rising x, and the words for falling x.

use super::Pass;
use boundfit_exact::{Foreign, Rational};

/// Words that need no explanation, in small letters.
const KNOWN: [(&str, Pass); 22] = [
    ("up", Pass::Up),
    ("upscale", Pass::Up),
    ("upward", Pass::Up),
    ("rising", Pass::Up),
    ("increasing", Pass::Up),
    ("ascending", Pass::Up),
    ("loading", Pass::Up),
    ("u", Pass::Up),
    ("+", Pass::Up),
    ("1", Pass::Up),
    ("+1", Pass::Up),
    ("down", Pass::Down),
    ("downscale", Pass::Down),
    ("downward", Pass::Down),
    ("falling", Pass::Down),
    ("decreasing", Pass::Down),
    ("descending", Pass::Down),
    ("unloading", Pass::Down),
    ("d", Pass::Down),
    ("-", Pass::Down),
    ("-1", Pass::Down),
    ("0", Pass::Down),
];

/// The words of a column of directions, as they are met.
#[derive(Debug, Default)]
pub(super) struct Directions {
    known: [Vec<Foreign>; 2],
    /// Other words, in the order in which they are met.
    others: Vec<Foreign>,
}

/// A word of a column of directions.
#[derive(Debug, Clone, Copy)]
pub(super) enum Word {
    Known(Pass),
    /// One of the other words, by its number.
    Other(usize),
}

impl Word {
    /// A number for the word.
    pub(super) fn number(self) -> i128 {
        match self {
            Word::Known(Pass::Up) => 0,
            Word::Known(Pass::Down) => 1,
            Word::Other(other) => 2 + other as i128,
        }
    }
}

impl Directions {
    /// Returns the direction of the word with a number, when all words have been met.
    pub(super) fn pass_of(&self, number: &Rational) -> Option<Pass> {
        let number = usize::try_from(number.numerator().to_i128()?).ok()?;
        let word = match number {
            0 => Word::Known(Pass::Up),
            1 => Word::Known(Pass::Down),
            more => Word::Other(more - 2),
        };
        Some(self.pass(word))
    }

    /// Takes note of a word in a row.
    pub(super) fn word(&mut self, text: &str, row: usize) -> Result<Word, String> {
        let text = text.trim();
        // A minus sign as typesetters write it is one.
        let small = text.replace('\u{2212}', "-").to_lowercase();
        let word = if let Some((_, pass)) = KNOWN.iter().find(|(word, _)| *word == small) {
            let known = of_pass(&mut self.known, *pass);
            if !known.iter().any(|own| own.raw() == text) {
                known.push(text.into());
            }
            Word::Known(*pass)
        } else if text.is_empty() {
            return Err(format!("data row {row}: the direction is missing (expected up or down)"));
        } else {
            let position = self.others.iter().position(|own| own.raw() == text);
            if position.is_none() {
                self.others.push(text.into());
            }
            Word::Other(position.unwrap_or(self.others.len() - 1))
        };
        let directions = self.others.len() + self.known.iter().filter(|words| !words.is_empty()).count();
        if directions <= 2 {
            return Ok(word);
        }
        let before = self.known.iter().flatten().chain(&self.others).filter(|own| own.raw() != text);
        let before: Vec<String> = before.map(Foreign::quoted).collect();
        Err(format!(
            "data row {row}: {} is a third direction beside {} (expected up and down, or two words of which the first one met \
             is up)",
            Foreign::of(text).quoted(),
            before.join(" and ")
        ))
    }

    /// Returns whether the other words are up or down: what is left of both beside a known one, else the first is up.
    fn of_other(&self, other: usize) -> Pass {
        match [&self.known[0], &self.known[1]].map(|words| !words.is_empty()) {
            [true, _] => Pass::Down,
            [false, true] => Pass::Up,
            [false, false] if other == 0 => Pass::Up,
            [false, false] => Pass::Down,
        }
    }

    /// Returns the direction of a word, when all words have been met.
    pub(super) fn pass(&self, word: Word) -> Pass {
        match word {
            Word::Known(pass) => pass,
            Word::Other(other) => self.of_other(other),
        }
    }

    /// The words for up and for down.
    pub(super) fn words(&self) -> [Vec<Foreign>; 2] {
        let mut words = self.known.clone();
        for (position, other) in self.others.iter().enumerate() {
            of_pass(&mut words, self.of_other(position)).push(other.clone());
        }
        words
    }
}

/// Returns the entry for up, or the entry for down.
fn of_pass<T>([up, down]: &mut [T; 2], pass: Pass) -> &mut T {
    match pass {
        Pass::Up => up,
        Pass::Down => down,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The directions of some words.
    fn passes(words: &[&str]) -> Result<String, String> {
        let mut directions = Directions::default();
        let met: Result<Vec<Word>, String> =
            words.iter().zip(1..).map(|(word, row)| directions.word(word, row)).collect();
        let letter = |word: Word| if directions.pass(word) == Pass::Up { 'u' } else { 'd' };
        Ok(met?.into_iter().map(letter).collect())
    }

    #[test]
    fn words_are_known_or_told_by_their_order() {
        for (words, expected) in [
            (&["up", "Down", "UPSCALE", "falling"][..], "udud"),
            (&["1", "-1", "0"], "udd"),
            (&["+", "-", "\u{2212}1"], "udd"),
            (&["in", "out", "in"], "udu"),
            (&["dn", "up", "dn"], "dud"),
            (&["down", "hoch"], "du"),
            (&["2", "1"], "du"),
            (&["only"], "u"),
        ] {
            assert_eq!(passes(words).as_deref(), Ok(expected), "{words:?}");
        }
        for (words, message) in [
            (
                &["in", "out", "over"][..],
                "data row 3: \"over\" is a third direction beside \"in\" and \"out\"",
            ),
            (&["up", "down", "over"], "data row 3: \"over\" is a third direction beside \"up\" and \"down\""),
            (&["up", " "], "data row 2: the direction is missing"),
        ] {
            assert!(passes(words).unwrap_err().starts_with(message), "{words:?}");
        }
    }

    #[test]
    fn a_known_word_that_comes_late_does_not_make_a_third_direction_pass() {
        assert!(passes(&["in", "out", "up"]).is_err());
    }
}
