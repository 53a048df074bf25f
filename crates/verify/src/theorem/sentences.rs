//! The sentences of Coq behind the definitions of rows and of what they say, which must not give their names another meaning.

use std::collections::BTreeSet;

use crate::shape::NotAProof;

/// The words that begin boundfit's sentences outside proofs. Those that name something come first.
const BEGINNINGS: [&str; 6] = ["Definition", "Lemma", "Theorem", "Proof", "Qed", "Print"];
const NAMING: usize = 3;
/// The names that boundfit defines there. Another definition could give a name of the theory another meaning.
const DEFINED: &str = "against always bases beyond boundary boundary_base data deciding ends entries evidence feasibleR \
                       feasible_part feasible_partR feasible_without feasible_withoutR forms key lonely_rows objective \
                       outliers points rays row_form runs sets value vertices";

/// Refuses sentences that could change what a name stands for: Coq's kernel accepts a second definition, in a module or not, and the
/// theorems behind it would be about other rows. `definitions` are the sentences whose names must keep their meaning.
pub(super) fn refuse_new_meanings(definitions: &str, behind: &str) -> Result<(), NotAProof> {
    let open = || NotAProof::new("a comment or a quote does not end");
    let definitions = code(definitions).ok_or_else(open)?;
    let names: BTreeSet<&str> = words(&definitions).collect();
    for sentence in code(behind).ok_or_else(open)?.split(". ") {
        // Marks of parts of a proof stand before a sentence.
        let sentence =
            sentence.trim_start_matches(|mark: char| mark.is_whitespace() || "-+*{}".contains(mark));
        let mut words = words(sentence);
        let first = words.next().unwrap_or_default();
        let known = BEGINNINGS.iter().position(|own| *own == first);
        let is_tactic = first.starts_with(|letter: char| letter.is_ascii_lowercase());
        if !sentence.starts_with(first) || known.is_none() && !is_tactic && !sentence.is_empty() {
            let start: String = sentence.chars().take(20).collect();
            return Err(NotAProof::new(format_args!(
                "behind what the rows say {start:?} begins a sentence that could change it"
            )));
        }
        let name = words.next();
        if let Some(name) =
            name.filter(|name| known < Some(NAMING) && known.is_some() && names.contains(name))
        {
            return Err(NotAProof::new(format_args!(
                "{name:?} is defined once more behind what the rows say"
            )));
        }
        if let Some(name) =
            name.filter(|name| first == "Definition" && DEFINED.split(' ').all(|own| own != *name))
        {
            return Err(NotAProof::new(format_args!(
                "behind what the rows say {name:?} is defined, which boundfit does not do there"
            )));
        }
    }
    Ok(())
}

/// A text of Coq without comments and what stands in quotes, and with a blank for all white space; `None` where it ends within one of
/// both.
pub(super) fn code(text: &str) -> Option<String> {
    let mut code = String::new();
    let (mut depth, mut is_quoted) = (0_usize, false);
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match (character, characters.peek()) {
            ('"', _) => is_quoted = !is_quoted,
            ('(', Some('*')) if !is_quoted => {
                characters.next();
                depth += 1;
            }
            ('*', Some(')')) if !is_quoted && depth > 0 => {
                characters.next();
                depth -= 1;
                code.push(' ');
            }
            _ if is_quoted || depth > 0 => {}
            _ => code.push(if character.is_whitespace() { ' ' } else { character }),
        }
    }
    code.push(' ');
    (!is_quoted && depth == 0).then_some(code)
}

/// The names and numbers of a text.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let is_between = |character: char| !(character.is_alphanumeric() || matches!(character, '_' | '\''));
    text.split(is_between).filter(|word| !word.is_empty())
}
