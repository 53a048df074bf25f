//! The help and the manual pages, as a reader meets them.

use boundfit_tests::cli::printed;
use boundfit_tests::program::root;

const COMMANDS: [&str; 18] = [
    "fit",
    "status",
    "predict",
    "next",
    "linearity",
    "range",
    "outliers",
    "reduce",
    "check",
    "convert",
    "verify",
    "judge",
    "polygon",
    "plot",
    "lesson",
    "playground",
    "completions",
    "man",
];

/// The lines of the help below a heading, up to the next one.
fn section<'a>(help: &'a str, heading: &str) -> Vec<&'a str> {
    let lines = help.lines().skip_while(|line| *line != heading).skip(1);
    lines.take_while(|line| line.is_empty() || line.starts_with(' ')).collect()
}

/// The long names of the options that a section explains.
fn options<'a>(section: &[&'a str]) -> Vec<&'a str> {
    let option = |line: &&'a str| {
        let explained = line.trim_start();
        let is_option = line.len() - explained.len() < 8 && explained.starts_with('-');
        let name = explained.split_whitespace().find(|word| word.starts_with("--"));
        name.filter(|_| is_option)
    };
    section.iter().filter_map(option).collect()
}

/// The commands of the examples, each as many lines as it has.
fn examples(help: &str) -> Vec<&str> {
    let lines = section(help, "Examples:");
    let commands = lines.into_iter().take_while(|line| !line.is_empty());
    commands.filter_map(|line| line.strip_prefix("    ")).collect()
}

#[test]
fn what_is_no_limit_stands_under_options() {
    for command in COMMANDS {
        let help = printed(&root(), &format!("{command} --help"));
        let limits = options(&section(&help, "Limits:"));
        let is_limit = |option: &str| option == "--limit";
        assert!(limits.iter().all(|option| is_limit(option)), "{command}: {limits:?}");
        let main = options(&section(&help, "Options:"));
        assert!(main.contains(&"--help") && main.contains(&"--output"), "{command}: {main:?}");
        assert!(!main.iter().any(|option| is_limit(option)), "{command}: {main:?}");
    }
    let help = printed(&root(), "fit --help");
    let main = options(&section(&help, "Options:"));
    for option in ["--x", "--sweep", "--by", "--proof", "--format", "--digits", "--exact"] {
        assert!(main.contains(&option), "{option}: {main:?}");
    }
    assert_eq!(options(&section(&help, "Limits:")), ["--limit"]);
}

#[test]
fn the_short_help_leaves_limits_out() {
    for command in COMMANDS.into_iter().filter(|command| *command != "lesson") {
        let help = printed(&root(), &format!("{command} -h"));
        assert!(!help.contains("--limit") && !help.contains("Limits:"), "{help}");
    }
    // Everybody who writes a page meets the limit on its readings.
    assert_eq!(options(&section(&printed(&root(), "lesson -h"), "Limits:")), ["--limit"]);
}

/// The lines of a text on a screen of 80 columns.
fn screen_lines(text: &str) -> usize {
    text.lines().map(|line| line.chars().count().div_ceil(80).max(1)).sum()
}

#[test]
fn the_short_help_fits_a_screen_in_groups() {
    let program = printed(&root(), "-h");
    assert!(screen_lines(&program) <= 40, "{program}");
    assert!(program.contains("\n  boundfit fit readings.csv --x V --y z --eps 0.5e-3\n"), "{program}");
    assert!(printed(&root(), "playground --help").contains("\n  1  the page cannot be written\n"));
    for command in COMMANDS {
        let help = printed(&root(), &format!("{command} -h"));
        assert!(screen_lines(&help) <= 40, "{command}: {} lines\n{help}", screen_lines(&help));
        assert!(help.contains(&format!("'boundfit {command} --help' explains every option.")), "{help}");
        assert!(program.contains(&format!("\n  {command} ")), "{program}");
    }
    let help = printed(&root(), "fit -h");
    for (heading, option) in [("Options:", "--eps"), ("Question:", "--sweep"), ("Output:", "--format")] {
        assert!(options(&section(&help, heading)).contains(&option), "{heading} {option}: {help}");
    }
}

#[test]
fn every_value_of_a_format_is_explained() {
    let help = printed(&root(), "fit --help");
    for value in ["text", "json", "latex", "markdown", "csv", "wkt", "m", "ine", "ext"] {
        assert!(help.contains(&format!("\n          - {value}:")), "{value}: {help}");
    }
    for command in ["check", "verify"] {
        let help = printed(&root(), &format!("{command} --help"));
        assert!(help.contains("\n          - text: ") && help.contains("\n          - json: "), "{help}");
    }
    assert!(!help.contains("Text for people or JSON"), "{help}");
}

/// A text as roff writes it.
fn in_roff(text: &str) -> String {
    text.replace('\\', "\\\\").replace('-', "\\-").replace('\'', "\\*(Aq")
}

#[test]
fn the_examples_of_a_manual_page_can_be_copied() {
    for command in COMMANDS {
        let page = printed(&root(), &format!("man {command}"));
        assert!(page.contains("\n.nh\n") && !page.contains(".SH EXTRA"), "{page}");
        let (_, endings) = page.split_once("\n.SH EXAMPLES\n").expect("examples");
        let (endings, _) = endings.split_once("\n.SH \"EXIT STATUS\"\n").unwrap_or((endings, ""));
        let verbatim: Vec<&str> = endings
            .split("\n.nf\n")
            .skip(1)
            .flat_map(|part| part.split("\n.fi\n").next().unwrap_or_default().lines())
            .collect();
        let help = printed(&root(), &format!("{command} --help"));
        let expected: Vec<String> = examples(&help).into_iter().map(in_roff).collect();
        assert!(!expected.is_empty(), "{help}");
        // That the lines are the same also says that the help has broken none.
        assert_eq!(verbatim, expected, "{command}");
    }
}

#[test]
fn the_synopsis_of_a_manual_page_names_values() {
    let page = printed(&root(), "man fit");
    let synopsis = "\n.SH SYNOPSIS\n\\fBboundfit fit\\fR [OPTIONS] \\-\\-x <COL[,COL2]> \
                    <\\-\\-eps <NUM>|\\-\\-eps\\-column <COL>|\\-\\-lower <COL>|\\-\\-upper <COL>> <DATA>\n";
    assert!(page.contains(synopsis), "{page}");
    let limit = "\n.TP\n\\fB\\-\\-limit\\fR \\fI<NAME=N>\\fR\n";
    assert!(page.contains(limit) && page.contains("columns (100000): columns of a table of text"), "{page}");
    assert!(page.contains("\n.SH \"EXIT STATUS\"\n.TP\n\\fB0\\fR\nan answer was found\n"), "{page}");
}

/// A proof cannot be compared with options that depend on the readings: `verify` refuses them.
#[test]
fn verify_describes_no_option_that_it_always_refuses() {
    let help = printed(&root(), "verify --help");
    assert!(!help.contains("--where-row") && !help.contains("'1.2*min'"), "{help}");
    assert!(help.contains("For 'min' and range(y) give the number"), "{help}");
}
