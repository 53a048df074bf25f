//! The steps of continuous integration, one by one: `cargo xtask ci [STEP…]`.
//!
//! - `steps` lists the steps in their order: what each holds, which changes need it, and its script;
//! - `programs` finds the programs that a step needs, and installs missing ones;
//! - `run` runs scripts, takes times and counts tests.

mod programs;
mod run;
mod steps;

use std::process::ExitCode;

use steps::{STEPS, Step};

/// The text that explains the options.
const USAGE: &str = "\
cargo xtask ci [--install] [STEP…]    run these steps, or all of them, in the order of the list
cargo xtask ci --list                 explain each step: what it holds, and which changes need it
cargo xtask ci --show STEP            print the script of a step

  --install    as root on Debian: install missing programs while other steps run";

/// The task that the arguments ask for.
#[derive(Debug, PartialEq)]
enum Asked {
    Help,
    List,
    Show(&'static Step),
    Run { steps: Vec<&'static Step>, install: bool },
}

/// Returns the step of a name.
fn named(name: &str) -> Result<&'static Step, String> {
    let known = || format!("there is no step {name:?}; `cargo xtask ci --list` lists them");
    STEPS.iter().find(|step| step.name == name).ok_or_else(known)
}

/// Reads the arguments. Steps are run in the order of the list, each once.
fn asked(arguments: &[String]) -> Result<Asked, String> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["-h" | "--help"] => return Ok(Asked::Help),
        ["--list"] => return Ok(Asked::List),
        ["--show", name] => return Ok(Asked::Show(named(name)?)),
        _ => {}
    }
    let (mut install, mut chosen) = (false, Vec::new());
    for word in words {
        match word {
            "--install" => install = true,
            option if option.starts_with('-') => {
                return Err(format!("there is no option {option}\n\n{USAGE}"));
            }
            name => chosen.push(named(name)?.name),
        }
    }
    let is_chosen = |step: &&Step| chosen.is_empty() || chosen.contains(&step.name);
    Ok(Asked::Run { steps: STEPS.iter().filter(is_chosen).collect(), install })
}

/// Prints the steps, aligned.
fn list() {
    let width = STEPS.iter().map(|step| step.name.len()).max().unwrap_or_default();
    for Step { name, holds, changes, .. } in STEPS {
        println!("{name:width$}  {holds}\n{:width$}  - {changes}", "");
    }
}

/// Does what the arguments say; the exit status is 1 if a step fails and 2 if the arguments are wrong.
pub(crate) fn main(arguments: &[String]) -> ExitCode {
    match asked(arguments) {
        Ok(Asked::Help) => println!("{USAGE}"),
        Ok(Asked::List) => list(),
        Ok(Asked::Show(step)) => println!("{}", step.script),
        Ok(Asked::Run { steps, install }) => return run::run(&steps, install),
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &[&str]) -> Result<Asked, String> {
        asked(&words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn steps_run_in_the_order_of_the_list() {
        let Ok(Asked::Run { steps, install: false }) = of(&["lints", "format", "lints"]) else { panic!() };
        assert_eq!(steps.iter().map(|step| step.name).collect::<Vec<_>>(), ["format", "lints"]);
    }

    #[test]
    fn no_name_means_every_step() {
        let Ok(Asked::Run { steps, install: true }) = of(&["--install"]) else { panic!() };
        assert_eq!(steps.len(), STEPS.len());
    }

    #[test]
    fn unknown_names_and_options_are_refused() {
        assert!(of(&["formats"]).unwrap_err().contains("\"formats\""));
        assert!(of(&["--quick"]).unwrap_err().starts_with("there is no option --quick"));
        assert!(of(&["--show", "nothing"]).is_err());
    }
}
