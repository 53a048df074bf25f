//! Runs the scripts of steps, takes their times and counts the tests.

use std::env;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Write};
use std::iter;
use std::path::PathBuf;
use std::process::{Command, ExitCode, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

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

/// A file of a step below cargo's folder of this repository.
fn file_of(step: &Step, extension: &str) -> PathBuf {
    root().join("target").join(step.name).with_extension(extension)
}

/// The shell that runs the script of a step from the top of the repository and stops at its first failure; `$built` is cargo's
/// folder. It writes down its times.
fn shell(step: &Step) -> Command {
    let mut shell = Command::new("bash");
    let script = format!("trap 'times > \"$times\"' EXIT\n{}", step.script);
    shell.env("built", env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| root().join("target").into()));
    shell.env("times", file_of(step, "times"));
    shell.args(["-euo", "pipefail", "-c", &script]).current_dir(root()).stdin(Stdio::null());
    shell
}

/// The processor time in seconds of what a shell has started: the second line of its times, such as `1m2.345s 0m6.789s`.
fn processor_time(times: &str) -> Option<f64> {
    let of_children = times.lines().nth(1)?.split_whitespace();
    let seconds = of_children.map(|time| {
        let (minutes, seconds) = time.strip_suffix('s')?.split_once('m')?;
        Some(60.0 * minutes.parse::<f64>().ok()? + seconds.parse::<f64>().ok()?)
    });
    seconds.sum()
}

/// An error if a script has failed.
fn outcome(status: io::Result<ExitStatus>) -> Outcome {
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(status.to_string()),
        Err(error) => Err(format!("bash: {error}")),
    }
}

/// Runs the script of a step and shows what it prints as it comes; its tests are counted if it has any.
fn run_script(step: &Step, tests: &mut Tests) -> Outcome {
    let mut counted = Tests::default();
    let failed = |error: io::Error| format!("bash: {error}");
    let mut child = shell(step).stdout(Stdio::piped()).spawn().map_err(failed)?;
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

/// Runs the script of a step beside others, and prints what it has printed when it ends. It ends early if another step has failed.
fn run_beside(step: &Step, has_failed: &AtomicBool) -> Outcome {
    let path = file_of(step, "log");
    let failed = |error: io::Error| format!("{}: {error}", path.display());
    let log = File::create(&path).map_err(failed)?;
    let errors = log.try_clone().map_err(failed)?;
    let mut child = shell(step).stdout(log).stderr(errors).spawn().map_err(failed)?;
    let status = loop {
        match child.try_wait() {
            Ok(None) if has_failed.load(Ordering::Relaxed) => {
                let _ = child.kill();
            }
            Ok(None) => thread::sleep(Duration::from_millis(100)),
            Ok(Some(status)) => break Ok(status),
            Err(error) => break Err(error),
        }
    };
    print!("\n== beside: {}: {}\n{}", step.name, step.holds, fs::read_to_string(&path).unwrap_or_default());
    outcome(status)
}

/// Lanes of steps that run beside others. Such a step often waits: for a browser, a compiler's lock, a download. Two lanes of them
/// keep both processors busy.
const LANES_BESIDE: usize = 2;

/// The steps while they run, in lanes.
struct Run {
    installation: Mutex<Option<Installation>>,
    times: Mutex<Vec<String>>,
    has_failed: AtomicBool,
}

impl Run {
    fn new(installation: Option<Installation>) -> Self {
        let (installation, times) = (Mutex::new(installation), Mutex::default());
        Self { installation, times, has_failed: AtomicBool::new(false) }
    }

    /// Waits until the programs of a step are installed.
    fn wait_for_programs(&self, step: &Step) -> Outcome {
        let mut installation = self.installation.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(installation) = installation.as_mut().filter(|_| !step.needs.is_empty()) {
            installation.finish()?;
        }
        programs::check(step)
    }

    /// Runs the steps of a lane one after the other, up to the first of any lane that fails.
    fn lane<'a>(
        &self,
        mut steps: impl Iterator<Item = &'a Step>,
        mut run: impl FnMut(&Step) -> Outcome,
    ) -> Outcome {
        while !self.has_failed.load(Ordering::Relaxed)
            && let Some(step) = steps.next()
        {
            let started = Instant::now();
            let _ = fs::remove_file(file_of(step, "times"));
            let outcome = self.wait_for_programs(step).and_then(|()| run(step));
            let times = fs::read_to_string(file_of(step, "times")).unwrap_or_default();
            // A step that was stopped has not written its times.
            let processors = processor_time(&times).map_or("?".to_owned(), |seconds| format!("{seconds:.0}"));
            let time = format!("{:5} s {processors:>6} s  {}", started.elapsed().as_secs(), step.name);
            self.times.lock().unwrap_or_else(PoisonError::into_inner).push(time);
            outcome.map_err(|message| {
                self.has_failed.store(true, Ordering::Relaxed);
                format!("{message}\nstep {0} failed; `cargo xtask ci {0}` runs it alone", step.name)
            })?;
        }
        Ok(())
    }

    /// Runs all steps up to the first that fails. Steps that run beside others have lanes of their own; the other lane takes of them
    /// what has not begun when it has no more steps.
    fn all(&self, steps: &[&Step], tests: &mut Tests) -> Outcome {
        let (beside, others): (Vec<&Step>, Vec<&Step>) = steps.iter().partition(|step| step.beside);
        let shown = |step: &Step| {
            println!("\n== {}: {}", step.name, step.holds);
            run_script(step, tests)
        };
        if others.is_empty() {
            return self.lane(beside.into_iter(), shown);
        }
        let beside = Mutex::new(beside.into_iter());
        let next = || beside.lock().unwrap_or_else(PoisonError::into_inner).next();
        thread::scope(|scope| {
            let run_next = || self.lane(iter::from_fn(next), |step| run_beside(step, &self.has_failed));
            let lanes = [(); LANES_BESIDE].map(|()| scope.spawn(run_next));
            let outcome = self.lane(others.into_iter().chain(iter::from_fn(next)), shown);
            lanes.into_iter().fold(outcome, |outcome, lane| {
                outcome.and(lane.join().unwrap_or_else(|_| Err("a thread has failed".to_owned())))
            })
        })
    }
}

/// Runs some steps. The last line counts the tests of the last step that has some; a step that fails otherwise counts as one.
pub(super) fn run(steps: &[&'static Step], install: bool) -> ExitCode {
    let started = Instant::now();
    let mut tests = Tests::default();
    let installation = fs::create_dir_all(root().join("target"))
        .map_err(|error| format!("target: {error}"))
        .and_then(|()| install.then(|| Installation::start(steps)).transpose());
    let (outcome, times) = match installation {
        Ok(installation) => {
            let run = Run::new(installation);
            let outcome = run.all(steps, &mut tests);
            (outcome, run.times.into_inner().unwrap_or_else(PoisonError::into_inner))
        }
        Err(message) => (Err(message), Vec::new()),
    };
    println!("\n== time and processor time of each step, {} s in all", started.elapsed().as_secs());
    let times = times.join("\n");
    println!("{times}");
    let _ = fs::write(root().join("target/ci-times.log"), times + "\n");
    let _ = io::stdout().flush();
    if let Err(message) = &outcome {
        eprintln!("\n{message}");
        tests.failed = tests.failed.max(1);
    }
    println!("\n{tests}");
    ExitCode::from(u8::from(outcome.is_err()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: Step =
        Step { name: "s", holds: "", changes: "", needs: &[], beside: false, script: "exit 3" };

    fn lane(steps: &[&Step]) -> (Outcome, usize) {
        let run = Run::new(None);
        let outcome = run.all(steps, &mut Tests::default());
        (outcome, run.times.into_inner().unwrap().len())
    }

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
        let run = |script| run_script(&Step { name: "script", script, ..STEP }, &mut Tests::default());
        assert_eq!(run("true | cat"), Ok(()));
        assert!(run("false | cat\ntrue").is_err());
        assert!(run("echo \"$undefined_name\"").is_err());
    }

    #[test]
    fn the_processor_time_is_that_of_what_a_shell_starts() {
        assert_eq!(processor_time("0m9.000s 0m9.000s\n1m2.250s 0m0.500s\n"), Some(62.75));
        assert_eq!(processor_time(""), None);
    }

    #[test]
    fn a_failed_step_is_named_and_the_next_one_does_not_run() {
        let (outcome, count) = lane(&[&STEP, &Step { name: "t", ..STEP }]);
        let message = outcome.unwrap_err();
        assert!(message.contains("3") && message.contains("step s failed"), "{message}");
        assert_eq!(count, 1);
    }

    /// The path of an empty place below cargo's folder, for scripts that wait for each other.
    fn mark(name: &str) -> PathBuf {
        let path = root().join("target").join(name);
        fs::create_dir_all(root().join("target")).unwrap();
        let _ = fs::remove_file(&path);
        path
    }

    #[test]
    fn a_step_that_fails_ends_those_beside_it() {
        let (begun, ended) = (mark("ends-1.log"), mark("ends-1.ended"));
        mark("ends-2.log");
        let beside =
            Step { name: "ends-1", beside: true, script: "sleep 60; touch target/ends-1.ended", ..STEP };
        let others = ["ends-2", "ends-3"].map(|name| Step { name, ..beside });
        let waits = "until [ -e target/ends-1.log ] && [ -e target/ends-2.log ]; do sleep 0.05; done; exit 3";
        let fails = Step { script: waits, ..STEP };
        let (outcome, count) = lane(&[&beside, &others[0], &others[1], &fails]);
        assert!(outcome.unwrap_err().contains("step s failed"));
        assert_eq!((count, begun.exists(), ended.exists()), (3, true, false));
    }

    #[test]
    fn a_step_beside_others_fails_for_all() {
        let begun = mark("fails.begun");
        let waits = "until [ -e target/fails.begun ]; do sleep 0.05; done; exit 3";
        let beside = Step { name: "fails", beside: true, script: waits, ..STEP };
        let (outcome, count) = lane(&[&beside, &Step { script: "touch target/fails.begun", ..STEP }]);
        assert!(outcome.unwrap_err().contains("step fails failed"));
        assert_eq!((count, begun.exists()), (2, true));
    }

    #[test]
    fn a_lane_without_steps_takes_those_of_the_lanes_beside() {
        mark("taken.begun");
        let waits = "for _ in {1..600}; do [ -e target/taken.begun ] && exit; sleep 0.05; done; exit 3";
        let waiting = ["waits-1", "waits-2"].map(|name| Step { name, beside: true, script: waits, ..STEP });
        let taken = Step { name: "taken", script: "touch target/taken.begun", ..waiting[0] };
        let own = Step { script: "true", ..STEP };
        assert_eq!(lane(&[&waiting[0], &waiting[1], &taken, &own]), (Ok(()), 4));
    }
}
