//! Splits prose into sentences and says what is wrong with one.

use std::fmt;

/// The most words of a sentence.
const MOST_WORDS: usize = 30;

/// The words that no sentence begins with.
const STARTS: [&str; 7] = ["Of", "What", "So many", "Whether", "Those", "How", "Which"];

/// The words that are neither verb nor noun nor what stands before a noun.
const NEITHER: &str = " what whether how which who whom whose where wherever when whenever why \
    of in into on onto at by for from to toward towards with without within about above across after against along among \
    around as before behind below beneath beside besides between beyond despite during except inside like near off out \
    outside over past per since through throughout under until up upon via \
    so and or nor but if unless though although because while than then there here else not only also even just rather \
    thus hence once those that it its itself they them their he she we you ";

/// A fault of a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fault {
    /// More than 30 words.
    Long,
    /// A word at the beginning that makes readers wait for the subject.
    Start(&'static str),
    /// A comment of rustdoc that begins with neither a verb nor the name of the thing.
    Summary,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Long => write!(f, "more than {MOST_WORDS} words"),
            Fault::Start(word) => write!(f, "begins with {word}"),
            Fault::Summary => f.write_str("no verb or noun first"),
        }
    }
}

/// The sentences of a paragraph. A sentence ends with a full stop, a question mark or an exclamation mark before
/// a space and anything but a small letter.
pub(super) fn split(paragraph: &str) -> Vec<String> {
    let words: Vec<&str> = paragraph.split_whitespace().collect();
    let mut sentences = vec![Vec::new()];
    for (place, word) in words.iter().enumerate() {
        if let Some(sentence) = sentences.last_mut() {
            sentence.push(*word);
        }
        let end = word.trim_end_matches(['"', '\'', ')', '*', '_', ']', '”', '“']);
        let begins = |next: &&str| !next.starts_with(char::is_lowercase);
        if end.ends_with(['.', '?', '!', '…']) && !is_short(end) && words.get(place + 1).is_some_and(begins)
        {
            sentences.push(Vec::new());
        }
    }
    sentences.into_iter().map(|words| words.join(" ")).collect()
}

/// Returns whether a word with a full stop is a short form.
fn is_short(word: &str) -> bool {
    let known = ["e.g.", "i.e.", "cf.", "vs.", "p.", "pp.", "Fig.", "Eq.", "No.", "Thm.", "Prop.", "Sec."];
    known.contains(&word.trim_start_matches(['(', '[']))
}

/// The words of a sentence: whatever has a letter or a digit.
fn words(sentence: &str) -> impl Iterator<Item = &str> {
    let bare = |word: &'_ str| word.contains(char::is_alphanumeric);
    sentence.split_whitespace().filter(move |word| bare(word))
}

/// Returns what is wrong with a sentence, which may be the first of a comment of rustdoc.
pub(super) fn faults(sentence: &str, is_summary: bool) -> Vec<Fault> {
    let mut faults = Vec::new();
    if words(sentence).count() > MOST_WORDS {
        faults.push(Fault::Long);
    }
    let bare = sentence.trim_start_matches(|letter: char| !letter.is_alphanumeric() && letter != '`');
    let starts = |word: &&str| {
        let rest = bare.strip_prefix(*word);
        // A "How-to" begins with a noun.
        let is_of_word = |letter: char| letter.is_alphanumeric() || "'-".contains(letter);
        rest.is_some_and(|rest| !rest.starts_with(is_of_word))
    };
    if let Some(word) = STARTS.into_iter().find(starts) {
        faults.push(Fault::Start(word));
    }
    let first = bare.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or_default();
    if is_summary && !first.is_empty() && NEITHER.contains(&format!(" {} ", first.to_lowercase())) {
        faults.push(Fault::Summary);
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_end_before_a_capital_or_code() {
        let text = "It is 1.5 wide. The next (e.g. 2.5). `x` is third! Is it? yes, cf. Fourth.";
        let expected =
            ["It is 1.5 wide.", "The next (e.g. 2.5).", "`x` is third!", "Is it? yes, cf. Fourth."];
        assert_eq!(split(text), expected);
    }

    #[test]
    fn thirty_words_are_enough() {
        let sentence = |count: usize| vec!["word"; count].join(" – ");
        assert_eq!(faults(&sentence(30), true), []);
        assert_eq!(faults(&sentence(31), true), [Fault::Long]);
    }

    #[test]
    fn beginnings_are_whole_words() {
        for (sentence, fault) in [
            ("Of these.", Some("Of")),
            ("**What** is", Some("What")),
            ("So many rows", Some("So many")),
            ("So it is", None),
            ("Offsets", None),
            ("Those", Some("Those")),
            ("Which rows", Some("Which")),
            ("However", None),
            ("*How-to.* Use", None),
            ("what follows", None),
        ] {
            let expected: Vec<Fault> = fault.map(Fault::Start).into_iter().collect();
            assert_eq!(faults(sentence, false), expected, "{sentence}");
        }
    }

    #[test]
    fn a_summary_begins_with_a_verb_or_names_the_thing() {
        for sentence in
            ["Returns the vertex.", "A closed half-plane.", "`x` alone.", "Every row.", "Vertices."]
        {
            assert_eq!(faults(sentence, true), [], "{sentence}");
        }
        for sentence in ["Where it begins.", "In which file", "It fails.", "With all rows", "as a fraction"] {
            assert_eq!(faults(sentence, true), [Fault::Summary], "{sentence}");
        }
    }
}
