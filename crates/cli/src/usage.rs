//! The messages about a command line that is not understood.

use std::path::Path;

use boundfit_exact::{Foreign, Limit};
use boundfit_formats::nearest;
use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, FromArgMatches};

use crate::commands::{Arguments, alone, with_short_help};

/// The options that short options may be meant for. There are none for these, since a table may have columns of any
/// name.
const MEANT: [(&str, &str); 3] = [("-x", "--x"), ("-y", "--y"), ("-e", "--eps")];

/// The answer to a request for y at other x.
const PREDICTED: &str = "'boundfit predict ... --at X' answers this";

/// The answer to a range of x where none is asked for.
const WITHIN: &str = "'--x-range LO..HI' is the x that a figure shows; 'boundfit next ... --within LO..HI' looks for the best x";

/// The answer to a format of linear programs.
const PROGRAMS: &str = "'boundfit convert ... --to lp' and '--to mps' write the linear programs behind a fit";

/// The answer to a fit without an error bound.
const UNBOUNDED: &str = "--eps 0.5 says that no error exceeds 0.5; if you know no bound, --eps '1.2*min' takes one from the readings, \
                         which guarantees nothing";

/// The program's arguments; ends the program where they are not understood.
pub(crate) fn parse() -> Arguments {
    // The short help has lines and groups of its own.
    let is_short = std::env::args_os().any(|word| word == "-h");
    let named = || std::env::args_os().nth(1).and_then(|name| alone(name.to_str()?));
    let command = match is_short {
        true => with_short_help(Arguments::command()),
        false => named().unwrap_or_else(Arguments::command),
    };
    let parsed = command.try_get_matches().and_then(|matches| Arguments::from_arg_matches(&matches));
    parsed.unwrap_or_else(|error| visible(with_tips(error)).exit())
}

/// An error in which what was typed is on one line, with all of it visible.
fn visible(mut error: clap::Error) -> clap::Error {
    let typed = [
        ContextKind::InvalidArg,
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidValue,
        ContextKind::PriorArg,
        ContextKind::TrailingArg,
    ];
    let shown = |text: &String| Foreign::of(text).to_string();
    // The suggestion of clap repeats the text.
    if matches!(error.get(ContextKind::InvalidArg), Some(ContextValue::String(text)) if shown(text) != *text)
    {
        error.remove(ContextKind::Suggested);
    }
    for kind in typed {
        let value = match error.get(kind) {
            Some(ContextValue::String(text)) => ContextValue::String(shown(text)),
            Some(ContextValue::Strings(texts)) => ContextValue::Strings(texts.iter().map(shown).collect()),
            _ => continue,
        };
        error.insert(kind, value);
    }
    error
}

/// The limit that an option was named after before all had one.
fn limit_of(name: &str) -> &str {
    match name {
        "proof-size" | "claim-size" | "solution-size" => Limit::Text.name(),
        name => name,
    }
}

/// Gives an error this tip in the place of others about values.
fn suggest(error: &mut clap::Error, tip: &str) {
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![StyledStr::from(tip.to_owned())]));
}

/// The name that was meant. The measure of clap does not know exchanged neighbours: it takes `--esp` for `--help`.
fn meant(typed: &str, names: impl Iterator<Item = String>) -> Option<String> {
    let names: Vec<Foreign> = names.map(Foreign::from).collect();
    nearest(typed, &names).map(|name| name.raw().to_owned())
}

/// Suggests the option of this command that is nearest to the one that was typed.
fn suggest_option(error: &mut clap::Error, typed: &str) {
    let name = typed.trim_start_matches('-').split('=').next().unwrap_or_default();
    let command = std::env::args_os().nth(1).and_then(|command| alone(command.to_str()?));
    let Some(mut command) = command else { return };
    command.build();
    let Some(command) = command.get_subcommands_mut().next() else { return };
    let shown = command.get_arguments().filter(|argument| !argument.is_hide_set());
    let options = shown.filter_map(|argument| argument.get_long().map(str::to_owned));
    let is_help = |value: &ContextValue| matches!(value, ContextValue::String(option) if option == "--help");
    match meant(name, options) {
        Some(option) => error.insert(ContextKind::SuggestedArg, ContextValue::String(format!("--{option}"))),
        // Nobody means the help.
        None if error.get(ContextKind::SuggestedArg).is_some_and(is_help) => {
            error.remove(ContextKind::SuggestedArg)
        }
        None => return,
    };
    // The usage of clap contains its own suggestion.
    error.insert(ContextKind::Usage, ContextValue::StyledStr(command.render_usage()));
}

/// Suggests the command that is nearest to the one that was typed.
fn suggest_command(error: &mut clap::Error, typed: &str) {
    let commands = Arguments::command();
    let names = commands.get_subcommands().map(|command| command.get_name().to_owned());
    if let Some(name) = meant(typed, names) {
        error.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(vec![name]));
    }
}

/// An error with tips that lead on, in place of those that do not.
fn with_tips(mut error: clap::Error) -> clap::Error {
    let asked = |kind: ContextKind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    match error.kind() {
        ErrorKind::UnknownArgument => {
            let asked = asked(ContextKind::InvalidArg).unwrap_or_default();
            if asked.starts_with("--") {
                // The suggestion of clap to take an option for a value: no command has such values.
                error.remove(ContextKind::Suggested);
                suggest_option(&mut error, &asked);
            }
            if let Some((_, meant)) = MEANT.iter().find(|(short, _)| *short == asked) {
                // Nobody wants such a value.
                error.remove(ContextKind::Suggested);
                error.insert(ContextKind::SuggestedArg, ContextValue::String((*meant).to_owned()));
            }
            if let Some(name) =
                asked.strip_prefix("--max-").map(|name| name.split('=').next().unwrap_or(name))
            {
                error.remove(ContextKind::SuggestedArg);
                let tip = format!("limits have one option: '--limit {}=N'", Foreign::of(limit_of(name)));
                suggest(&mut error, &tip);
            }
            // An option of `next`, which `plot` has not.
            if asked == "--within" || asked.starts_with("--within=") {
                error.remove(ContextKind::SuggestedArg);
                suggest(&mut error, WITHIN);
            }
            if asked.starts_with("--predict") {
                error.remove(ContextKind::SuggestedArg);
                suggest(&mut error, PREDICTED);
            }
        }
        ErrorKind::InvalidValue => {
            let is_program =
                asked(ContextKind::InvalidValue).is_some_and(|value| value == "lp" || value == "mps");
            let is_format =
                asked(ContextKind::InvalidArg).is_some_and(|option| option.starts_with("--format"));
            if is_program && is_format {
                error.remove(ContextKind::SuggestedValue);
                suggest(&mut error, PROGRAMS);
            }
        }
        ErrorKind::InvalidSubcommand => {
            let asked = asked(ContextKind::InvalidSubcommand).unwrap_or_default();
            if asked.contains(['.', '/', '\\']) || Path::new(&asked).exists() {
                error.remove(ContextKind::SuggestedSubcommand);
                let tip = format!(
                    "a table is fitted by 'boundfit fit {} --x COL --y COL --eps NUM'",
                    Foreign::of(&asked)
                );
                suggest(&mut error, &tip);
            } else {
                suggest_command(&mut error, &asked);
            }
        }
        ErrorKind::MissingRequiredArgument => {
            let is_bound = |name: &String| name.starts_with("<--eps ");
            if matches!(error.get(ContextKind::InvalidArg), Some(ContextValue::Strings(names)) if names.iter().any(is_bound))
            {
                suggest(&mut error, UNBOUNDED);
            }
        }
        _ => {}
    }
    error
}
