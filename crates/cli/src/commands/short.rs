//! The short help, `-h`: of each command what is needed first, in groups, on a screen of 40 lines. `--help` has every option.

use clap::{Arg, Command};

use super::named;

/// A group of options with a line about each; the heading of the first is that of `-h` itself.
type Group = (Option<&'static str>, &'static [(&'static str, &'static str)]);

/// The options that the short help shows, in every command that has them.
const GROUPS: [Group; 3] = [
    (
        None,
        &[
            ("x", "Column of x, by header or number"),
            ("y", "Column of y"),
            ("up", "Column of y that was read upscale"),
            ("down", "Column of y that was read downscale"),
            ("direction", "Column that says up or down"),
            ("eps", "Error bound: 0.5e-3, '1%*|y|', written, min"),
            ("eps-column", "Column with the error bound of each reading"),
            ("lower", "Column with the smallest value of the model"),
            ("upper", "Column with the largest value of the model"),
            ("rows", "Use these rows only, such as 14..36"),
            ("where-row", "Use rows by a column, such as 'T >= 20'"),
            ("where", "Condition, such as 'theta1 >= 0'; repeatable"),
        ],
    ),
    (
        Some("Question"),
        &[
            ("x-eps", "Bound on the errors of x, too"),
            ("sweep", "Sets for factors of the bound, such as 0.5..2"),
            ("by", "Each group with the same text here on its own"),
            ("window", "Fit the last N readings, again and again"),
            ("inverse", "Also report the inverse line"),
            ("at", "Predict y at these x"),
            ("from", "Predict x from these y"),
            ("grid", "Predict y at N steps between two x"),
            ("within", "Best x in this range, such as -10..10"),
            ("goal", "Make theta1, theta2 or area small"),
            ("new", "Table of readings to judge by the set"),
            ("repair", "Find the least widening that leaves a set"),
            ("by-row", "Runs in the order of rows"),
            ("most", "Also sets that miss up to Q readings"),
            ("full-scale", "The full scale, in units of y"),
            ("through", "Point that the line goes through"),
            ("claim", "File with the claimed answer; repeatable"),
            ("claim-pui", "Claimed ends of both intervals"),
            ("solver", "LP solver to judge; repeatable"),
            ("tolerance", "Largest relative error that is excused"),
            ("to", "Format of the programs: mps or lp"),
            ("objective", "Write only this program, such as theta1-max"),
            ("solution", "Answer of a solver to judge; repeatable"),
            ("figure", "Picture to draw"),
        ],
    ),
    (
        Some("Output"),
        &[
            ("format", "Format of the answer"),
            ("output", "Write to this file"),
            ("proof", "Also write a proof to this file"),
            ("plot", "Also draw into this file"),
            ("digits", "Significant digits"),
            ("exact", "Fractions in place of decimals"),
            ("size", "Width of the picture, such as 85mm"),
            ("title", "Title of the page or picture"),
            ("language", "Language of the page"),
        ],
    ),
];

/// A line about the words of several commands that are no options.
const WORDS: [(&str, &str); 2] =
    [("data", "A table, or - for standard input"), ("more", "Further tables in the same picture")];

/// The program with the short help.
pub(crate) fn with_short_help(program: Command) -> Command {
    program.mut_subcommands(|command| {
        let name = command.get_name().to_owned();
        let more = format!("'boundfit {name} --help' explains every option.");
        let own = named(&name);
        let ending = match own.and_then(|own| own.notes.examples.first()) {
            Some((what, example)) => format!("{what}:\n  {example}\n{more}"),
            None => more,
        };
        let command = command.mut_args(shortened).after_help(ending);
        match own {
            Some(own) => command.about(own.short),
            None => command,
        }
    })
}

/// An argument with one line of help, or without any.
fn shortened(argument: Arg) -> Arg {
    let Some(name) = argument.get_long().map(str::to_owned) else {
        let word = WORDS.iter().find(|(id, _)| argument.get_id().as_str() == *id);
        return match word {
            Some((_, text)) => argument.help(*text),
            None => argument,
        };
    };
    // A limit is met by whoever writes a page; other commands hide it.
    if name == "limit" {
        return argument;
    }
    let line = |(heading, lines): &Group| {
        let (_, text) = lines.iter().find(|(own, _)| *own == name)?;
        Some((*heading, *text))
    };
    match GROUPS.iter().find_map(line) {
        Some((heading, text)) => {
            let argument = argument.help(text).help_heading(heading);
            // Flags have no values to hide.
            match argument.get_action().takes_values() {
                true => argument.hide_possible_values(true).hide_default_value(true),
                false => argument,
            }
        }
        None => argument.hide_short_help(true),
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;
    use crate::commands::Arguments;

    #[test]
    fn every_line_is_about_something_that_there_is() {
        let program = Arguments::command();
        let has = |name: &str| {
            let mut options = program.get_subcommands().flat_map(Command::get_arguments);
            options.any(|argument| argument.get_long() == Some(name))
        };
        let missing: Vec<&str> = GROUPS
            .iter()
            .flat_map(|(_, lines)| *lines)
            .map(|(name, _)| *name)
            .filter(|name| !has(name))
            .collect();
        assert!(missing.is_empty(), "{missing:?}");
    }
}
