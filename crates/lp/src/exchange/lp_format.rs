//! CPLEX's LP format.

use std::fmt::Write;

use super::{ExchangeProgram, Numbers, Sense};

/// The longest line; CPLEX stops at 560 characters.
const LONGEST_LINE: usize = 500;

/// The program in LP format. Both variables stand in the objective, so that every reader numbers them alike.
pub(super) fn write(text: &mut String, program: &ExchangeProgram<'_>) -> std::fmt::Result {
    for remark in program.remarks() {
        writeln!(text, "\\ {remark}")?;
    }
    let [first, second] = terms(&program.objective(), true);
    writeln!(text, "Minimize\n {}: {first} {second}\nSubject To", program.objective_name)?;
    for row in program.rows {
        let sense = match row.sense {
            Sense::AtMost => "<=",
            Sense::AtLeast => ">=",
            Sense::Equal => "=",
        };
        let is_constant = row.numbers.a.iter().all(|a| a == "0");
        let [first, second] = terms(&row.numbers, is_constant);
        let parts: Vec<String> = [first, second].into_iter().filter(|term| !term.is_empty()).collect();
        let length = row.name.len() + parts.iter().map(String::len).sum::<usize>() + row.numbers.b.len();
        let separator = if length > LONGEST_LINE { "\n  " } else { " " };
        let left = parts.join(separator);
        writeln!(text, " {}: {left}{separator}{sense} {}", row.name, row.numbers.b)?;
    }
    writeln!(text, "Bounds\n theta1 free\n theta2 free\nEnd")
}

/// The terms of θ1 and θ2 with their signs; one with the coefficient 0 is empty unless zeros are wanted.
fn terms(numbers: &Numbers, zeros: bool) -> [String; 2] {
    let [a1, a2] = &numbers.a;
    let shown = |a: &str| zeros || a != "0";
    let has_first = shown(a1);
    let term = |a: &str, variable: &str, leads: bool| match a.strip_prefix('-') {
        _ if !shown(a) => String::new(),
        Some(size) => format!("- {size} {variable}"),
        None if leads => format!("{a} {variable}"),
        None => format!("+ {a} {variable}"),
    };
    [term(a1, "theta1", true), term(a2, "theta2", !has_first)]
}
