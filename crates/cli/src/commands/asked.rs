//! Questions about readings: all go the same way.

use std::io::{self, Write};

use boundfit_ask::{Ask, Form, Paper, Refusal};
use boundfit_report::Style;

use super::proof_file;
use crate::CommandResult;
use crate::arguments::{DataArguments, ReplaceArguments, XErrorArguments};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output::{self, Guard, Output, Stop};
use crate::progress::while_working;

/// What is asked about, and where the answer goes.
pub(super) struct Job<'a> {
    pub(super) data: &'a DataArguments,
    pub(super) x_errors: Option<&'a XErrorArguments>,
    pub(super) form: Form,
    pub(super) style: Style,
    pub(super) output: Option<&'a str>,
    pub(super) proof: Option<&'a str>,
}

impl Job<'_> {
    /// What is not to be written over, once it is known that the answer may be written where it is to go.
    pub(super) fn guard(&self, replace: &ReplaceArguments) -> Result<Guard, Failure> {
        let guard = replace.guard([self.data.path()]);
        guard.check(self.output)?;
        guard.check(self.proof)?;
        proof_file::check(self.proof, self.output)?;
        Ok(guard)
    }

    /// Reads the data, finds the answer and writes it.
    pub(super) fn run<Q: Ask>(&self, question: &Q, guard: &mut Guard) -> CommandResult {
        let Job { data, x_errors, form, style, output, proof } = *self;
        let file = data.file_name();
        let failed = |refusal: Refusal| Failure::of(&refusal, file);
        if !Q::FORMS.contains(&form) {
            return Err(failed(Q::no_form(form)));
        }
        let opened = data.open();
        let paper = Paper { origin: opened.origin(), style };
        let (asked, source) = opened.asked_with(x_errors)?;
        let shows_data = form.shows_data() || proof.is_some();
        let problem = question.read(&asked, source, shows_data).map_err(failed)?;
        if !form.has_input() {
            input::say_table(file, question.measurements(&problem).table());
        }
        let answer = while_working(Q::NAME, || question.answer(&problem)).map_err(failed)?;
        let write = |form, out: &mut dyn Write| question.write(&problem, &answer, form, &paper, out);
        let written = match proof {
            Some(proof_file) => {
                let (mut report, mut text) = (Vec::new(), Vec::new());
                let written = write(form, &mut report).map_err(failed)?;
                write(Form::Proof, &mut text).map_err(failed)?;
                output::write_together(&[(&text, Some(proof_file)), (&report, output)], guard)?;
                written
            }
            None => {
                let mut stream = Stream { output: Output::open(output, guard)?, stop: None };
                let written = write(form, &mut stream);
                match (written, stream.stop) {
                    (_, Some(Stop::Closed)) => return Ok(Exit::Answer),
                    (_, Some(Stop::Failed(failure))) => return Err(failure),
                    (written, None) => {
                        let written = written.map_err(failed)?;
                        stream.output.finish()?;
                        written
                    }
                }
            }
        };
        // The answer is written, whether or not somebody reads the summary.
        let _ = io::stderr().write_all(written.summary.as_bytes());
        Ok(if written.is_empty { Exit::Empty } else { Exit::Answer })
    }
}

/// An answer that is written as it is found.
struct Stream {
    output: Output,
    /// Why no more is written.
    stop: Option<Stop>,
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.output.write(bytes) {
            Ok(()) => Ok(bytes.len()),
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
