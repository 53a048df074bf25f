//! Words and numbers of figures as LaTeX sets them, in text and in formulas.

use boundfit_exact::latex::escape_in_name;

/// The replacements of characters in a formula.
const IN_FORMULAS: &[(char, &str)] = &[
    ('<', "<"),
    ('>', ">"),
    ('|', "|"),
    ('−', "-"),
    ('±', r"\pm "),
    ('×', r"\times "),
    ('·', r"\cdot "),
    ('÷', r"\div "),
    ('≤', r"\le "),
    ('≥', r"\ge "),
    ('≈', r"\approx "),
    ('≠', r"\ne "),
    ('∞', r"\infty "),
    ('√', r"\surd "),
    ('∂', r"\partial "),
    ('∆', r"\Delta "),
    ('∑', r"\Sigma "),
    ('¬', r"\neg "),
    ('′', "'"),
    ('″', "''"),
    ('←', r"\leftarrow "),
    ('↑', r"\uparrow "),
    ('→', r"\rightarrow "),
    ('↓', r"\downarrow "),
    ('•', r"\bullet "),
    ('◊', r"\diamond "),
    ('°', r"^\circ "),
    ('µ', r"\mu "),
    ('Ω', r"\Omega "),
    ('Ω', r"\Omega "),
    ('Γ', r"\Gamma "),
    ('Δ', r"\Delta "),
    ('Θ', r"\Theta "),
    ('Λ', r"\Lambda "),
    ('Ξ', r"\Xi "),
    ('Π', r"\Pi "),
    ('Σ', r"\Sigma "),
    ('Υ', r"\Upsilon "),
    ('Φ', r"\Phi "),
    ('Ψ', r"\Psi "),
    ('α', r"\alpha "),
    ('β', r"\beta "),
    ('γ', r"\gamma "),
    ('δ', r"\delta "),
    ('ε', r"\varepsilon "),
    ('ζ', r"\zeta "),
    ('η', r"\eta "),
    ('θ', r"\theta "),
    ('ι', r"\iota "),
    ('κ', r"\kappa "),
    ('λ', r"\lambda "),
    ('μ', r"\mu "),
    ('ν', r"\nu "),
    ('ξ', r"\xi "),
    ('ο', "o"),
    ('π', r"\pi "),
    ('ρ', r"\rho "),
    ('ς', r"\varsigma "),
    ('σ', r"\sigma "),
    ('τ', r"\tau "),
    ('υ', r"\upsilon "),
    ('φ', r"\varphi "),
    ('χ', r"\chi "),
    ('ψ', r"\psi "),
    ('ω', r"\omega "),
    ('ϑ', r"\vartheta "),
    ('ϕ', r"\phi "),
    ('ϵ', r"\epsilon "),
];

/// The replacements of characters that are no letters in a text.
const IN_TEXTS: &[(char, &str)] = &[
    ('\u{a0}', "~"),
    ('\u{ad}', r"\-"),
    ('¡', "!`"),
    ('¿', "?`"),
    ('§', r"\S{}"),
    ('¶', r"\P{}"),
    ('©', r"\copyright{}"),
    ('£', r"\pounds{}"),
    ('€', r"\texteuro{}"),
    ('‰', r"\textperthousand{}"),
    ('…', r"\ldots{}"),
    ('⁄', "/"),
    ('‐', "{-}"),
    ('‑', "{-}"),
    ('‒', "--"),
    ('–', "--"),
    ('—', "---"),
    ('―', "---"),
    ('‘', "`"),
    ('’', "'"),
    ('‚', ","),
    ('“', "``"),
    ('”', "''"),
    ('„', ",,"),
    ('†', r"\dag{}"),
    ('‡', r"\ddag{}"),
    ('℃', r"\ensuremath{^\circ}C"),
    ('℉', r"\ensuremath{^\circ}F"),
    ('¼', "1/4"),
    ('½', "1/2"),
    ('¾', "3/4"),
];

/// A raised or a lowered character in plain.
fn plain(character: char) -> Option<(char, char)> {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱ";
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎";
    const PLAIN: &str = "0123456789+-=()ni";
    let found = |all: &str, sign: char| {
        let place = all.chars().position(|own| own == character)?;
        Some((sign, PLAIN.chars().nth(place)?))
    };
    found(RAISED, '^').or_else(|| found(LOWERED, '_'))
}

/// A text of one line as LaTeX shows it with any encoding of its fonts. Letters of other scripts stay as they are, for documents
/// that have them; any other character without a command is a lozenge.
pub(crate) fn text(text: &str) -> String {
    let mut result = String::new();
    // The state: an open formula, and in it a group that is raised or lowered.
    let (mut in_formula, mut group) = (false, None);
    // A second raised or lowered group of one nucleus is an error of TeX: it gets an empty nucleus.
    let mut nucleus = Nucleus::default();
    for character in text.chars() {
        let moved = plain(character);
        if group.is_some() && group != moved.map(|(sign, _)| sign) {
            result.push('}');
            group = None;
        }
        let formula = IN_FORMULAS.iter().find(|(own, _)| *own == character).map(|(_, formula)| *formula);
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
    let known = IN_TEXTS.iter().find(|(own, _)| *own == character);
    match known {
        Some((_, text)) => result.push_str(text),
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
