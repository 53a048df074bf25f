//! Words and numbers of figures as LaTeX sets them, in text and in formulas.

use boundfit_exact::latex::{self, escape_in_name, in_text};

/// A text of one line as LaTeX shows it with any encoding of its fonts. Letters of other scripts stay as they are, for documents
/// that have them; any other character without a command is a lozenge.
pub(crate) fn text(text: &str) -> String {
    let mut result = String::new();
    // The state: an open formula, and in it a group that is raised or lowered.
    let (mut in_formula, mut group) = (false, None);
    // A second raised or lowered group of one nucleus is an error of TeX: it gets an empty nucleus.
    let mut nucleus = Nucleus::default();
    for character in text.chars() {
        let moved = latex::moved(character);
        if group.is_some() && group != moved.map(|(sign, _)| sign) {
            result.push('}');
            group = None;
        }
        let formula = latex::in_formula(character);
        if (moved.is_some() || formula.is_some()) != in_formula {
            result.push('$');
            in_formula = !in_formula;
            nucleus = Nucleus::default();
        }
        match (moved, formula) {
            (Some((sign, letter)), _) => {
                if group.is_none() {
                    nucleus.take(sign, &mut result);
                    result.extend([sign, '{']);
                    group = Some(sign);
                }
                result.push(letter);
            }
            (None, Some(formula)) => {
                match formula.starts_with(['^', '\'']) {
                    true => nucleus.take('^', &mut result),
                    false => nucleus = Nucleus::default(),
                }
                result.push_str(formula);
            }
            (None, None) => in_words(character, &mut result),
        }
    }
    if group.is_some() {
        result.push('}');
    }
    if in_formula {
        result.push('$');
    }
    result
}

/// The groups that the last nucleus of a formula has.
#[derive(Default)]
struct Nucleus {
    is_raised: bool,
    is_lowered: bool,
}

impl Nucleus {
    /// Notes one more group, behind an empty nucleus if the last one has such a group.
    fn take(&mut self, sign: char, result: &mut String) {
        let is_raised = sign == '^';
        if if is_raised { self.is_raised } else { self.is_lowered } {
            result.push_str("{}");
            *self = Nucleus::default();
        }
        match is_raised {
            true => self.is_raised = true,
            false => self.is_lowered = true,
        }
    }
}

fn in_words(character: char, result: &mut String) {
    match in_text(character) {
        Some(text) => result.push_str(text),
        None if character.is_ascii() => escape_in_name(character, result),
        None if character.is_alphabetic() => result.push(character),
        None => result.push_str(r"\ensuremath{\diamond}"),
    }
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn names_and_numbers_are_shown_as_they_are() {
        for (given, expected) in [
            ("θ₁ [m/V]", r"$\theta _{1}$ [m/V]"),
            (
                "V_z & 5 % of #1 {a} ~b^c\\d $",
                r"V\_z \& 5 \% of \#1 \{a\} \textasciitilde{}b\textasciicircum{}c\textbackslash{}d \$",
            ),
            ("|e| ≤ 5×10⁻⁴", r"$|$e$|$ $\le $ 5$\times $10$^{-4}$"),
            ("a--b 'c' ``d''", "a{-}{-}b {'}c{'} {`}{`}d{'}{'}"),
            ("ε_min, µV ±2 °C", r"$\varepsilon $\_min{,} $\mu $V $\pm $2 $^\circ $C"),
            ("x₁² é ж \u{1F600}", r"x$_{1}^{2}$ é ж \ensuremath{\diamond}"),
            ("mV·°⁻¹", r"mV$\cdot ^\circ {}^{-1}$"),
            ("V/°², 5°′ x²′", r"V/$^\circ {}^{2}${,} 5$^\circ {}'$ x$^{2}{}'$"),
            ("x²₁³₂ a₁b₁", r"x$^{2}_{1}{}^{3}_{2}$ a$_{1}$b$_{1}$"),
            ("", ""),
        ] {
            assert_eq!(text(given), expected);
        }
    }
}
