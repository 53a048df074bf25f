//! Questions about readings: all go the same way.

use std::io::{self, IsTerminal, Write};

use boundfit_ask::{Ask, AskedTheorem, Form, Out, Paper, Refusal, Shows, Written};
use boundfit_report::{Origin, Style, Theory};
use clap::ValueEnum;

use super::proof_file::{self, SmallFile};
use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::memory;
use crate::options::{NamedFormat, OutputArguments, ProofArguments, ReplaceArguments, TableFormat, Words};
use crate::output::{self, Guard, Output, Stop, files_apart};
use crate::progress::while_working;

/// The readings that are asked about, and the place where the answer goes.
pub(super) struct Job<'a> {
    pub(super) data: Words<'a>,
    pub(super) form: Form,
    pub(super) style: Style,
    pub(super) output: Option<&'a str>,
    pub(super) proof: Option<&'a str>,
    /// The source of a theorem's theory, where the proof is a theorem for Coq.
    pub(super) theory: Option<Theory>,
}

/// The addition of a command to an answer: bytes, and the file that they go to.
type Beside<'a> = Option<(Vec<u8>, &'a str)>;

impl<'a> Job<'a> {
    /// A job as the options about its output say.
    pub(super) fn of<F: NamedFormat + ValueEnum + Into<Form> + Send + Sync>(
        data: Words<'a>,
        output: &'a OutputArguments<F>,
        proof: Option<&'a str>,
    ) -> Result<Self, Failure> {
        let form = output.format()?.into();
        output.check_decimals(form)?;
        Ok(Self {
            data,
            form,
            style: output.style(),
            output: output.file.output.as_deref(),
            proof,
            theory: None,
        })
    }

    /// A job with a proof, which may be a theorem for Coq.
    pub(super) fn proving(
        data: Words<'a>,
        output: &'a OutputArguments<TableFormat>,
        ProofArguments { proof, proof_library }: &'a ProofArguments,
    ) -> Result<Self, Failure> {
        Job::of(data, output, proof.as_deref())?.with_theory(*proof_library)
    }

    /// The same job, whose proof may be a theorem for Coq.
    pub(super) fn with_theory(self, is_installed: bool) -> Result<Self, Failure> {
        Ok(Self { theory: proof_file::theory(self.proof, is_installed)?, ..self })
    }

    /// Returns the files that must not be written over, once the answer may be written to its file.
    pub(super) fn guard(&self, replace: &ReplaceArguments, beside: &[&str]) -> Result<Guard, Failure> {
        let guard = replace.guard([self.data.path].into_iter().chain(beside.iter().copied()));
        guard.check(self.output)?;
        guard.check(self.proof)?;
        if self.theory.is_none() {
            proof_file::refuse_theorem(self.proof)?;
        }
        files_apart(self.output, &[("--proof", self.proof)])?;
        Ok(guard)
    }

    /// Reads the data, finds the answer and writes it.
    pub(super) fn run<Q: Ask>(&self, question: &Q, guard: &mut Guard) -> CommandResult {
        self.run_with(question, guard, |_, _, _| Ok(None))
    }

    /// Runs as [`Job::run`] does, with the additions that only this program makes to an answer.
    pub(super) fn run_with<Q: Ask>(
        &self,
        question: &Q,
        guard: &mut Guard,
        add: impl FnOnce(&Q::Problem, &mut Q::Answer, &Origin<'_>) -> Result<Beside<'a>, Failure>,
    ) -> CommandResult {
        let Job { ref data, form, style, output, proof, theory } = *self;
        let file = data.file_name();
        let failed = |refusal: Refusal| Failure::of(&refusal, file);
        if !Q::FORMS.contains(&form) {
            return Err(failed(Q::no_form(form)));
        }
        question.refuse_vain(form).map_err(failed)?;
        let data = data.open_for(Q::SUBJECT)?.holding(memory::OF_A_READING);
        let origin = data.origin;
        let (asked, source) = data.scan();
        let shows = form.shows().max(match (proof, theory) {
            (None, _) => Shows::Nothing,
            (Some(_), None) => Shows::Rows,
            (Some(_), Some(_)) => Shows::Readings,
        });
        let problem = question.read(&asked, source, shows).map_err(failed)?;
        if !form.has_input() {
            input::say_table(file, question.table(&problem), question.rows_missing(&problem));
            input::say_bound(file, question.multiple_of_least(&problem, form));
        }
        let mut answer = while_working(Q::NAME, || question.answer(&problem)).map_err(failed)?;
        let beside = add(&problem, &mut answer, &origin)?;
        let write = |form, out: &mut Out<'_>| {
            question.write(&problem, &answer, &mut Paper { form, origin, style, out })
        };
        let written = match (proof, &beside) {
            (None, None) => {
                let mut stream = Stream { output: Output::open(output, guard)?, stop: None };
                // Lines that scroll by on a terminal are progress enough.
                let is_watched = output.is_none() && io::stdout().is_terminal();
                let mut all = || write(form, &mut stream);
                let written = if is_watched { all() } else { while_working(Q::NAME, all) };
                match (written, stream.stop) {
                    (Err(_), Some(Stop::Closed)) => return Ok(Exit::Answer),
                    (Ok(written), Some(Stop::Closed)) => written,
                    (_, Some(Stop::Failed(failure))) => return Err(failure),
                    (written, None) => {
                        let written = written.map_err(failed)?;
                        stream.output.finish()?;
                        written
                    }
                }
            }
            _ => {
                let (mut report, mut text) = (Vec::new(), Vec::new());
                let written = write(form, &mut report).map_err(failed)?;
                match (proof, theory) {
                    (None, _) => {}
                    (Some(_), None) => drop(write(Form::Proof, &mut text).map_err(failed)?),
                    (Some(_), Some(theory)) => {
                        let small = proof_file::small_file(self.data.path);
                        let data = small.as_ref().map(SmallFile::parts);
                        let asked = AskedTheorem { reading: origin.reading, theory, data };
                        text = question.theorem(&problem, &answer, asked).map_err(failed)?.into_bytes();
                    }
                }
                let proof = proof.map(|file| (text.as_slice(), Some(file)));
                let beside = beside.as_ref().map(|(bytes, file)| (bytes.as_slice(), Some(*file)));
                let parts: Vec<_> =
                    proof.into_iter().chain(beside).chain([(report.as_slice(), output)]).collect();
                output::write_together(&parts, guard)?;
                written
            }
        };
        // The answer is written, whether or not somebody reads the summary.
        let _ = io::stderr().write_all(written.summary.as_bytes());
        Ok(match written {
            Written { is_refuted: true, .. } => Exit::Refuted,
            Written { is_empty: true, .. } => Exit::Empty,
            _ => Exit::Answer,
        })
    }
}

/// An answer that is written as it is found. Parts after the first one that has no reader are not computed. That part
/// counts as written, so that an answer of one part keeps its exit status.
struct Stream {
    output: Output,
    /// The reason why no more is written.
    stop: Option<Stop>,
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.stop.is_some() {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        match self.output.write(bytes) {
            Ok(()) => Ok(bytes.len()),
            Err(Stop::Closed) => {
                self.stop = Some(Stop::Closed);
                Ok(bytes.len())
            }
            Err(stop) => {
                self.stop = Some(stop);
                Err(io::ErrorKind::BrokenPipe.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
