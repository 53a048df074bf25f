//! The reference of the options.

use std::collections::BTreeMap;

use clap::{Arg, ArgAction, Command};

use super::markdown::{anchor, cell, plain};

/// The heading of arguments that have none.
const ARGUMENTS: &str = "Arguments";

/// A page with every option of every command.
pub(super) fn reference(program: &Command) -> String {
    let mut program = program.clone();
    program.build();
    let mut text = "# Options\n\n*Reference.* This page lists every option of every command. Read it to look up an option; `boundfit help COMMAND` prints the same in a\nterminal. `cargo xtask generate` makes this page from the command line itself.\n\n| command | |\n|---|---|\n".to_owned();
    let commands: Vec<&Command> =
        program.get_subcommands().filter(|own| !own.is_hide_set() && own.get_name() != "help").collect();
    for command in &commands {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        let name = command.get_name();
        text.push_str(&format!(
            "| [`{name}`](#{}) | {} |\n",
            anchor(&format!("boundfit {name}")),
            cell(&plain(&about))
        ));
    }
    commands.iter().for_each(|command| text.push_str(&section(command)));
    text
}

fn section(command: &Command) -> String {
    let about = command.get_long_about().or_else(|| command.get_about()).map(ToString::to_string);
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ");
    let mut text = format!(
        "\n## boundfit {}\n\n{}\n\n```text\n{usage}\n```\n",
        command.get_name(),
        plain(&about.unwrap_or_default())
    );
    // Headings in the order of the help.
    let mut order: Vec<&str> = Vec::new();
    let mut groups: BTreeMap<&str, Vec<&Arg>> = BTreeMap::new();
    for argument in command.get_arguments().filter(|own| !own.is_hide_set() && own.get_id() != "help") {
        let heading = argument.get_help_heading().unwrap_or(ARGUMENTS);
        if !order.contains(&heading) {
            order.push(heading);
        }
        groups.entry(heading).or_default().push(argument);
    }
    for heading in order {
        text.push_str(&format!("\n**{heading}**\n\n| option | meaning |\n|---|---|\n"));
        for argument in groups.get(heading).into_iter().flatten() {
            text.push_str(&format!("| {} | {} |\n", name(argument), meaning(argument)));
        }
    }
    text
}

/// `-o`, `--output FILE`.
fn name(argument: &Arg) -> String {
    let takes_value = matches!(argument.get_action(), ArgAction::Set | ArgAction::Append);
    let names = argument.get_value_names().into_iter().flatten().map(ToString::to_string);
    let value = names.collect::<Vec<_>>().join(" ");
    let short = argument.get_short().map(|short| format!("-{short}"));
    let long = argument.get_long().map(|long| format!("--{long}"));
    let names: Vec<String> = short.into_iter().chain(long).collect();
    let text = match (names.is_empty(), takes_value) {
        (true, _) => format!("`{value}`"),
        (false, true) => format!("`{} {value}`", names.join("`, `")),
        (false, false) => format!("`{}`", names.join("`, `")),
    };
    cell(&text)
}

fn meaning(argument: &Arg) -> String {
    let help = argument.get_long_help().or_else(|| argument.get_help()).map(ToString::to_string);
    // Items of a list stand on lines of their own.
    let one_line = |item: &str| plain(&item.split_whitespace().collect::<Vec<_>>().join(" "));
    let items: Vec<String> = help.unwrap_or_default().split("\n- ").map(one_line).collect();
    let mut parts = vec![items.join("<br>")];
    let defaults: Vec<String> =
        argument.get_default_values().iter().map(|value| format!("`{}`", value.to_string_lossy())).collect();
    if !defaults.is_empty() && argument.get_action().takes_values() && !argument.is_hide_default_value_set() {
        parts.push(format!("Default: {}.", defaults.join(", ")));
    }
    let values = argument.get_possible_values();
    if argument.get_action().takes_values() && !argument.is_hide_possible_values_set() && !values.is_empty() {
        let values = values.iter().filter(|value| !value.is_hide_set()).map(|value| match value.get_help() {
            Some(help) => format!("`{}` ({})", value.get_name(), plain(&help.to_string())),
            None => format!("`{}`", value.get_name()),
        });
        parts.push(format!("Values: {}.", values.collect::<Vec<_>>().join(", ")));
    }
    let text = parts
        .into_iter()
        .filter(|part| !part.is_empty())
        .map(|part| ended(&part))
        .collect::<Vec<_>>()
        .join(" ");
    cell(&text)
}

fn ended(text: &str) -> String {
    if text.ends_with(['.', ':', '?', '!']) { text.to_owned() } else { format!("{text}.") }
}
