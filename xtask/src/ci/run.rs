//! Runs the scripts of steps, takes their times and counts the tests.

use std::env;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::time::Instant;

use super::programs::{self, Installation};
use super::steps::Step;
use crate::root;

/// The result of a step, or the problem.
type Outcome = Result<(), String>;

/// The numbers of tests that passed and failed according to `cargo test`.
#[derive(Debug, Default, PartialEq, Eq)]
struct Tests {
    passed: u64,
    failed: u64,
}

impl Tests {
    /// Adds the tests of a line such as `test result: ok. 12 passed; 0 failed; …`.
    fn add(&mut self, line: &str) {
        let Some(result) = line.strip_prefix("test result:") else { return };
        let words: Vec<&str> = result.split_whitespace().collect();
        for pair in words.windows(2) {
            let count = || pair[0].parse().unwrap_or(0);
            match pair[1] {
                "passed;" => self.passed += count(),
                "failed;" => self.failed += count(),
                _ => {}
            }
        }
    }
}

impl fmt::Display for Tests {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} passed, {} failed", self.passed, self.failed)
    }
}

/// The shell that runs a script from the top of the repository and stops at its first failure; `$built` is cargo's folder.
fn shell(script: &str) -> Command {
    let mut shell = Command::new("bash");
    shell.env("built", env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| root().join("target").into()));
    shell.args(["-euo", "pipefail", "-c", script]).current_dir(root()).stdin(Stdio::null());
    shell
}

/// An error if a script has failed.
fn outcome(status: io::Result<ExitStatus>) -> Outcome {
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(status.to_string()),
        Err(error) => Err(format!("bash: {error}")),
    }
}

/// Runs a script and shows what it prints as it comes; its tests are counted if it has any.
fn run_script(script: &str, tests: &mut Tests) -> Outcome {
    let mut counted = Tests::default();
    let failed = |error: io::Error| format!("bash: {error}");
    let mut child = shell(script).stdout(Stdio::piped()).spawn().map_err(failed)?;
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).lines() {
            let line = line.map_err(failed)?;
            println!("{line}");
            counted.add(&line);
        }
    }
    if counted != Tests::default() {
        *tests = counted;
    }
    outcome(child.wait())
}

/// A script that runs beside other steps until it is its turn.
#[derive(Debug)]
struct Beside {
    step: &'static str,
    child: Child,
}

impl Beside {
    /// The file that has what the script prints.
    fn log(step: &str) -> String {
        format!("target/{step}.log")
    }

    /// Starts the script of a step.
    fn start(step: &Step) -> Result<Self, String> {
        let path = Self::log(step.name);
        let failed = |error| format!("{path}: {error}");
        let log = File::create(root().join(&path)).map_err(failed)?;
        let errors = log.try_clone().map_err(failed)?;
        let child = shell(step.script).stdout(log).stderr(errors).spawn().map_err(failed)?;
        Ok(Self { step: step.name, child })
    }

    /// Waits for the end of the script and prints what it has printed.
    fn finish(mut self) -> Outcome {
        let status = self.child.wait();
        let log = fs::read_to_string(root().join(Self::log(self.step))).unwrap_or_default();
        print!("{log}");
        outcome(status)
    }
}

impl Drop for Beside {
    /// Ends the script if a step has failed before it.
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The steps while they run.
struct Run<'a> {
    steps: &'a [&'static Step],
    installation: Option<Installation>,
    beside: Vec<Beside>,
    tests: Tests,
    times: Vec<String>,
}

impl Run<'_> {
    /// Runs one step, and starts those that are to run beside it.
    fn step(&mut self, step: &'static Step) -> Outcome {
        if let Some(installation) = self.installation.as_mut().filter(|_| !step.needs.is_empty()) {
            installation.finish()?;
        }
        programs::check(step)?;
        for other in self.steps.iter().filter(|other| other.beside == Some(step.name)) {
            self.beside.push(Beside::start(other)?);
        }
        match self.beside.iter().position(|beside| beside.step == step.name) {
            Some(place) => self.beside.swap_remove(place).finish(),
            None => run_script(step.script, &mut self.tests),
        }
    }

    /// Runs all steps up to the first that fails.
    fn all(&mut self, install: bool) -> Outcome {
        fs::create_dir_all(root().join("target")).map_err(|error| format!("target: {error}"))?;
        if install {
            self.installation = Some(Installation::start(self.steps)?);
        }
        for step in self.steps {
            println!("\n== {}: {}", step.name, step.holds);
            let started = Instant::now();
            let outcome = self.step(step);
            self.times.push(format!("{:5} s  {}", started.elapsed().as_secs(), step.name));
            outcome.map_err(|message| {
                format!("{message}\nstep {0} failed; `cargo xtask ci {0}` runs it alone", step.name)
            })?;
        }
        Ok(())
    }
}

/// Runs some steps. The last line counts the tests of the last step that has some; a step that fails otherwise counts as one.
pub(super) fn run(steps: &[&'static Step], install: bool) -> ExitCode {
    let started = Instant::now();
    let (tests, times) = (Tests::default(), Vec::new());
    let mut run = Run { steps, installation: None, beside: Vec::new(), tests, times };
    let outcome = run.all(install);
    println!("\n== time of each step, {} s in all", started.elapsed().as_secs());
    let times = run.times.join("\n");
    println!("{times}");
    let _ = fs::write(root().join("target/ci-times.log"), times + "\n");
    let _ = io::stdout().flush();
    if let Err(message) = &outcome {
        eprintln!("\n{message}");
        run.tests.failed = run.tests.failed.max(1);
    }
    println!("\n{}", run.tests);
    ExitCode::from(u8::from(outcome.is_err()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_of_cargo_test_are_added() {
        let mut tests = Tests::default();
        tests.add(
            "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 3 filtered out; finished in 0.1s",
        );
        tests.add("test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out");
        tests.add("test a::b ... ok");
        assert_eq!(tests.to_string(), "15 passed, 2 failed");
    }

    #[test]
    fn a_script_stops_at_its_first_failure() {
        let mut tests = Tests::default();
        assert_eq!(run_script("true | cat", &mut tests), Ok(()));
        assert!(run_script("false | cat\ntrue", &mut tests).is_err());
        assert!(run_script("echo \"$undefined_name\"", &mut tests).is_err());
    }

    #[test]
    fn a_failed_step_is_named_and_the_next_one_does_not_run() {
        const STEP: Step =
            Step { name: "s", holds: "", changes: "", needs: &[], beside: None, script: "exit 3" };
        static STEPS: [Step; 2] = [STEP, Step { name: "t", ..STEP }];
        let steps: Vec<&'static Step> = STEPS.iter().collect();
        let (tests, times) = (Tests::default(), Vec::new());
        let mut run = Run { steps: &steps, installation: None, beside: Vec::new(), tests, times };
        let message = run.all(false).unwrap_err();
        assert!(message.contains("3") && message.contains("step s failed"), "{message}");
        assert_eq!(run.times.len(), 1);
    }
}
