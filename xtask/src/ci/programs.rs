//! The programs that steps need beside cargo, and how missing ones are installed.

use std::fs::{self, File};
use std::process::{Child, Command, Stdio};

use super::steps::Step;
use crate::root;

/// A program that a step starts.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Program {
    /// The name that people use.
    name: &'static str,
    /// A line of shell that succeeds where it is installed.
    is_there: &'static str,
    /// The packages of Debian that have it.
    packages: &'static [&'static str],
}

/// A program that is known by its own name.
const fn command(name: &'static str, is_there: &'static str, packages: &'static [&'static str]) -> Program {
    Program { name, is_there, packages }
}

pub(super) const LRS: Program = command("lrs", "command -v lrs", &["lrslib"]);
pub(super) const CDD: Program = command("cddexec_gmp", "command -v cddexec_gmp", &["libcdd-tools"]);
pub(super) const COQ: Program = command("coqc", "command -v coqc", &["coq"]);
pub(super) const GLPK: Program = command("glpsol", "command -v glpsol", &["glpk-utils"]);
pub(super) const CBC: Program = command("cbc", "command -v cbc", &["coinor-cbc"]);
pub(super) const OCTAVE: Program = command("octave-cli", "command -v octave-cli", &["octave"]);
pub(super) const LATEX: Program =
    command("pdflatex", "command -v pdflatex", &["texlive-latex-base", "texlive-latex-recommended"]);
pub(super) const TIKZ: Program = command("tikz.sty", "kpsewhich tikz.sty", &["texlive-pictures"]);
pub(super) const PYTHON: Program = command("python3", "command -v python3", &["python3"]);
pub(super) const VENV: Program =
    command("python3's venv", "python3 -c 'import ensurepip'", &["python3", "python3-venv"]);
pub(super) const VALGRIND: Program = command("valgrind", "command -v valgrind", &["valgrind"]);
// Pages of the one without windows take a third of the time; the other will do.
pub(super) const CHROMIUM: Program = command(
    "chromium-headless-shell",
    "command -v chromium-headless-shell || command -v chromium",
    &["chromium-headless-shell"],
);
pub(super) const NODE: Program = command("npm", "command -v node && command -v npm", &["nodejs", "npm"]);
pub(super) const CMAKE: Program = command("cmake", "command -v cmake", &["cmake"]);
pub(super) const CXX: Program = command("g++", "command -v g++", &["g++"]);
// libclang.so or libclang-14.so; libclang-cpp is another library.
pub(super) const LIBCLANG: Program =
    command("libclang", "ls /usr/lib/llvm*/lib/libclang[.-][s0-9]*", &["libclang-dev"]);

impl Program {
    /// Returns whether the program is installed.
    fn is_installed(&self) -> bool {
        let mut shell = Command::new("bash");
        shell.args(["-c", self.is_there]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        shell.status().is_ok_and(|status| status.success())
    }
}

/// Returns the programs of some steps that are not installed, each once.
fn missing<'a>(steps: impl Iterator<Item = &'a Step>) -> Vec<&'static Program> {
    let mut missing: Vec<&'static Program> = Vec::new();
    for program in steps.flat_map(|step| step.needs) {
        if !missing.contains(&program) && !program.is_installed() {
            missing.push(program);
        }
    }
    missing
}

/// Returns the packages of some programs, for a command line.
fn packages(programs: &[&Program]) -> String {
    let names = programs.iter().flat_map(|program| program.packages.iter().copied());
    names.collect::<Vec<_>>().join(" ")
}

/// Returns an error that names the programs of a step that are missing.
pub(super) fn check(step: &Step) -> Result<(), String> {
    let missing = missing(std::iter::once(step));
    if missing.is_empty() {
        return Ok(());
    }
    let names: Vec<&str> = missing.iter().map(|program| program.name).collect();
    let (names, packages) = (names.join(", "), packages(&missing));
    Err(format!("missing: {names}\non Debian as root: apt-get install --no-install-recommends {packages}"))
}

/// An installation that runs beside the steps.
#[derive(Debug)]
pub(super) struct Installation {
    apt: Option<Child>,
}

impl Installation {
    /// The file for the words of apt, which are printed if it fails.
    const LOG: &str = "target/packages.log";

    /// Starts to install what some steps need and is missing.
    pub(super) fn start(steps: &[&Step]) -> Result<Self, String> {
        let packages = packages(&missing(steps.iter().copied()));
        if packages.is_empty() {
            return Ok(Self { apt: None });
        }
        let script = format!(
            "command -v apt-get && [ \"$(id -u)\" = 0 ] || {{ echo 'missing: {packages}' >&2; exit 1; }}\n\
             export DEBIAN_FRONTEND=noninteractive\n\
             apt-get update -qq && apt-get install -y -qq --no-install-recommends {packages}"
        );
        let failed = |error| format!("{}: {error}", Self::LOG);
        let log = File::create(root().join(Self::LOG)).map_err(failed)?;
        let errors = log.try_clone().map_err(failed)?;
        let mut shell = Command::new("bash");
        shell.args(["-euc", &script]).stdin(Stdio::null()).stdout(log).stderr(errors);
        let apt = shell.spawn().map_err(|error| format!("bash: {error}"))?;
        Ok(Self { apt: Some(apt) })
    }

    /// Waits for the end of the installation.
    pub(super) fn finish(&mut self) -> Result<(), String> {
        let Some(mut apt) = self.apt.take() else { return Ok(()) };
        match apt.wait() {
            Ok(status) if status.success() => Ok(()),
            _ => Err(fs::read_to_string(root().join(Self::LOG)).unwrap_or_else(|error| error.to_string())),
        }
    }
}

impl Drop for Installation {
    /// Ends the installation if a step has failed before it.
    fn drop(&mut self) {
        if let Some(mut apt) = self.apt.take() {
            let _ = apt.kill();
            let _ = apt.wait();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHELL: Program = command("bash", "command -v bash", &["bash"]);
    const ABSENT: Program =
        command("absent", "command -v there-is-no-such-program", &["absent-1", "absent-2"]);

    #[test]
    fn a_missing_program_is_named_with_its_packages() {
        let step = Step {
            name: "s",
            holds: "",
            changes: "",
            needs: &[SHELL, ABSENT, ABSENT],
            beside: false,
            script: "",
        };
        let message = check(&step).unwrap_err();
        assert_eq!(
            message,
            "missing: absent\non Debian as root: apt-get install --no-install-recommends absent-1 absent-2"
        );
        assert_eq!(check(&Step { needs: &[SHELL], ..step }), Ok(()));
    }
}
