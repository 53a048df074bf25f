//! Characters that LaTeX takes for commands.

/// Appends what LaTeX shows as a character of ASCII; others stay as they are.
///
/// ```
/// let mut shown = String::new();
/// "5 %_{U}".chars().for_each(|character| boundfit_exact::latex::escape(character, &mut shown));
/// assert_eq!(shown, r"5 \%\_\{U\}");
/// ```
pub fn escape(character: char, result: &mut String) {
    match character {
        '#' | '$' | '%' | '&' | '_' | '{' | '}' => result.extend(['\\', character]),
        '\\' => result.push_str(r"\textbackslash{}"),
        '~' => result.push_str(r"\textasciitilde{}"),
        '^' => result.push_str(r"\textasciicircum{}"),
        '<' => result.push_str(r"\textless{}"),
        '>' => result.push_str(r"\textgreater{}"),
        '|' => result.push_str(r"\textbar{}"),
        '"' => result.push_str("''"),
        other => result.push(other),
    }
}

/// Appends what LaTeX shows as a character of a name, in which no two make another one, as two hyphens make a dash. Greek letters,
/// signs, and raised or lowered digits become formulas; letters of other scripts stay as they are.
///
/// ```
/// let mut shown = String::new();
/// "ΔT₂ °C".chars().for_each(|character| boundfit_exact::latex::escape_in_name(character, &mut shown));
/// assert_eq!(shown, r"\ensuremath{\Delta}T\ensuremath{_{2}} \ensuremath{^\circ}C");
/// ```
pub fn escape_in_name(character: char, result: &mut String) {
    match character {
        '-' | '\'' | '`' | ',' => result.extend(['{', character, '}']),
        ascii if ascii.is_ascii() => escape(ascii, result),
        other => {
            if let Some(formula) = in_formula(other) {
                result.extend([r"\ensuremath{", formula.trim_end(), "}"]);
            } else if let Some((sign, letter)) = moved(other) {
                result.push_str(&format!(r"\ensuremath{{{sign}{{{letter}}}}}"));
            } else {
                match in_text(other) {
                    Some(text) => result.push_str(text),
                    None => result.push(other),
                }
            }
        }
    }
}

/// Returns the command for a sign or a Greek letter in a formula.
pub fn in_formula(character: char) -> Option<&'static str> {
    IN_FORMULAS.iter().find(|(own, _)| *own == character).map(|(_, formula)| *formula)
}

/// Returns the source of a character that is no letter in a text.
pub fn in_text(character: char) -> Option<&'static str> {
    IN_TEXTS.iter().find(|(own, _)| *own == character).map(|(_, text)| *text)
}

/// Returns how a character is moved, `^` or `_`, and the character in plain.
pub fn moved(character: char) -> Option<(char, char)> {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱ";
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎";
    const PLAIN: &str = "0123456789+-=()ni";
    let found = |all: &str, sign: char| {
        let place = all.chars().position(|own| own == character)?;
        Some((sign, PLAIN.chars().nth(place)?))
    };
    found(RAISED, '^').or_else(|| found(LOWERED, '_'))
}

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
