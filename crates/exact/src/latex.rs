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

/// Appends what LaTeX shows as a character of a name, in which no two make another one, as two hyphens make a dash.
pub fn escape_in_name(character: char, result: &mut String) {
    match character {
        '-' | '\'' | '`' | ',' => result.extend(['{', character, '}']),
        other => escape(other, result),
    }
}
