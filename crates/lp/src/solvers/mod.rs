//! Floating-point solvers behind one trait, one file each. A new solver is a file here and a line in [`solvers`].

mod clarabel;
#[cfg(feature = "highs")]
mod highs;
mod microlp;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use crate::outcome::Outcome;
use crate::program::FloatProgram;

/// A solver of programs in two free variables.
pub trait Solver: Send + Sync {
    /// The name on the command line.
    fn name(&self) -> &'static str;

    /// The version of the library behind it.
    fn version(&self) -> &'static str;

    /// Minimises. Rounded, as the solver works; it may fail, crash or never end: see [`solve_guarded`].
    fn solve(&self, program: &FloatProgram) -> Outcome;
}

/// All solvers of this build; the first is the default.
pub fn solvers() -> Vec<Box<dyn Solver>> {
    vec![
        Box::new(microlp::Microlp),
        Box::new(clarabel::Clarabel),
        #[cfg(feature = "highs")]
        Box::new(highs::Highs),
    ]
}

/// The solver with a name.
pub fn solver_named(name: &str) -> Option<Box<dyn Solver>> {
    solvers().into_iter().find(|solver| {
        // Reports print the name with the version.
        solver.name() == name || format!("{} {}", solver.name(), solver.version()) == name
    })
}

/// Lets a solver work on a thread of its own, for at most `limit`: a crash or an endless loop becomes
/// [`Outcome::Failed`]. A solver that does not end is left behind.
pub fn solve_guarded(name: &str, program: &FloatProgram, limit: Duration) -> Outcome {
    let Some(solver) = solver_named(name) else {
        return Outcome::Failed(format!("there is no solver {name}"));
    };
    if !program.is_finite() {
        return Outcome::Failed("the program does not fit into binary64".to_owned());
    }
    let program = program.clone();
    guarded(move || solver.solve(&program), limit)
}

fn guarded(work: impl FnOnce() -> Outcome + Send + 'static, limit: Duration) -> Outcome {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        let answer = catch_unwind(AssertUnwindSafe(work));
        // The receiver may have given up.
        let _ = sender.send(answer.unwrap_or_else(|_| Outcome::Failed("the solver crashed".to_owned())));
    });
    receiver.recv_timeout(limit).unwrap_or_else(|_| Outcome::Failed(format!("no answer within {limit:?}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crash_and_an_endless_loop_are_failures() {
        let crash = guarded(|| panic!("as a solver might"), Duration::from_secs(60));
        assert_eq!(crash, Outcome::Failed("the solver crashed".to_owned()));
        let endless = || loop {
            thread::sleep(Duration::from_secs(1));
        };
        let late = guarded(endless, Duration::from_millis(5));
        assert_eq!(late, Outcome::Failed("no answer within 5ms".to_owned()));
        assert_eq!(guarded(|| Outcome::Infeasible, Duration::from_secs(60)), Outcome::Infeasible);
    }
}
