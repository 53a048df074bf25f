//! The way to tell files that this program wrote from all others: by their beginning.

/// The number of bytes at the start of a file that tell.
pub(super) const START: u64 = 4096;

/// The beginning of each format, and the text that is found in its first bytes.
const MARKS: &[(&str, &str)] = &[
    // Reports as text, Markdown and LaTeX.
    ("Set-membership fit\n", ""),
    ("Linear range\n  model ", ""),
    ("rows ", " eps_min\n"),
    ("first,last,readings,first_row,last_row,x_least,", ""),
    ("first_row,last_row,rows,x_first,x_last,kind,", ""),
    ("Outliers\n  model  ", ""),
    ("### Outliers\n", "| model"),
    ("set,rows,kind,vertices,theta1_lower,", ""),
    ("Half-planes of ", "\nRegion: "),
    ("Generators of ", "\nRegion: "),
    ("Linear program of ", ": m"),
    ("import Mathlib.Tactic\n\n-- Written by boundfit ", ""),
    (
        "(* What is proved: the last theorems of this file.",
        "'boundfit verify FILE DATA' compares both where the question stands here.\n",
    ),
    ("(* What is proved: the last theorems of this file.", "'boundfit verify FILE DATA' compares both.\n"),
    (
        "(* What is proved: the last theorems of this file.",
        "No question stands here, so that 'boundfit verify' cannot compare both.\n",
    ),
    ("LP answers about ", ", judged exactly\n"),
    ("verified: ", " is true of "),
    ("refuted: ", " is not true of "),
    ("group ", " theta2 "),
    ("| case | ", "|\n|---|"),
    ("### Set-membership fit\n", ""),
    ("Prediction\n  model ", ""),
    ("### Prediction\n", "reading"),
    ("Linearity\n  data ", ""),
    ("### Linearity\n", "full scale"),
    ("Half-planes of ", "\n### Region: "),
    ("Generators of ", "\n### Region: "),
    ("% needs \\usepackage{booktabs}\n{\\raggedright", ""),
    // Tables and scripts.
    ("kind,theta1,theta2,theta1_decimal,theta2_decimal,active\n", ""),
    ("quantity,parameter,lower,upper,value,lower_exact,upper_exact,value_exact\n", ""),
    ("group,rows,first_row,kind,theta1_lower,", ""),
    ("x,line_lower,line_upper,reading_lower,reading_upper,x_exact,", ""),
    ("x1,x2,model_lower,model_upper,reading_lower,reading_upper,x1_exact,", ""),
    ("y,x_lower,x_upper,lower_end,upper_end,y_exact,", ""),
    ("characteristic,method,deviation,percent,slope,intercept,deviation_exact,", ""),
    ("# boundfit/reduced/", ""),
    ("% A set of parameters (theta1, theta2), written by boundfit.\n", ""),
    ("* theta", ", that agrees with every reading\n"),
    ("\\ theta", ", that agrees with every reading\n"),
    // Pictures and pages.
    ("<svg ", "<metadata>boundfit</metadata>\n"),
    ("%PDF-", "(boundfit)"),
    ("% A figure written by boundfit", ""),
    ("<!doctype html>\n", "<meta name=\"generator\" content=\"boundfit\">\n"),
    // Completions and manual pages.
    ("_boundfit() {\n", ""),
    ("#compdef boundfit\n", ""),
    ("# Print an optspec for argparse", "__fish_boundfit_"),
    ("\nusing namespace System.Management.Automation\n", "'boundfit'"),
    ("\nuse builtin;\nuse str;\n", "[boundfit]"),
    (".ie \\n(.g", ".TH boundfit"),
];

/// Returns whether this program wrote a file that starts like this. Well-known text and the files of cdd and lrs look
/// the same whoever wrote them, and are not recognised.
pub(super) fn is_ours(start: &[u8]) -> bool {
    if start.starts_with(b"\x89PNG\r\n\x1a\n") {
        return contains(start, b"tEXtSoftware\0boundfit");
    }
    let without_space: Vec<u8> =
        start.iter().copied().filter(|byte| !byte.is_ascii_whitespace()).take(64).collect();
    without_space.starts_with(br#"{"schema":"boundfit/"#)
        || MARKS
            .iter()
            .any(|(begins, has)| start.starts_with(begins.as_bytes()) && contains(start, has.as_bytes()))
}

fn contains(start: &[u8], part: &[u8]) -> bool {
    part.is_empty() || start.windows(part.len()).any(|window| window == part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_only_speaks_of_boundfit_is_not_ours() {
        for start in [
            &b"boundfit fit data.csv --x x --y y --eps 1\n"[..],
            b"#!/bin/sh\nboundfit fit data.csv\n",
            b"x,y\n1,2\n",
            b"group,x,y\n",
            b"group theta1 theta2\n",
            b"{\"results\": {\"schema\": \"boundfit/fit/1\"}}",
            b"[{\"schema\": \"boundfit/fit/1\"}]",
            b"{\"schema\": \"other/1\", \"by\": \"boundfit/fit/1\"}",
            b"My notes\nSet-membership fit\n",
            b"# boundfit/reduced",
            b"<svg xmlns=\"http://www.w3.org/2000/svg\"><title>boundfit</title></svg>",
            b"<!doctype html>\n<title>boundfit</title>",
            b"\x89PNG\r\n\x1a\n boundfit",
            b"H-representation\nbegin\n",
            b"POLYGON ((0 0, 1 0, 0 1, 0 0))\n",
            b"",
        ] {
            assert!(!is_ours(start), "{}", String::from_utf8_lossy(start));
        }
    }
}
