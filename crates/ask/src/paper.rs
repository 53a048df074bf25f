//! The paper that an answer is written on.

use std::io::Write;

use boundfit_report::{Origin, Style};

use crate::form::{Form, Written};
use crate::refusal::Refusal;

/// One form of an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Answer {
    /// The text.
    pub text: String,
    /// The words beside the answer.
    pub written: Written,
}

/// The place where an answer is written.
pub type Out<'a> = dyn Write + Send + 'a;

/// The paper of an answer: its form and its place, with the facts that forms need beside the answer.
pub struct Paper<'a> {
    /// The form.
    pub form: Form,
    /// The source of the readings.
    pub origin: Origin<'a>,
    /// The style of numbers.
    pub style: Style,
    /// The place.
    pub out: &'a mut Out<'a>,
}

impl Paper<'_> {
    /// Writes a text.
    pub(crate) fn put(&mut self, text: impl AsRef<[u8]>) -> Result<(), Refusal> {
        put(self.out, text)
    }
}

/// Writes a text.
pub(crate) fn put(out: &mut Out<'_>, text: impl AsRef<[u8]>) -> Result<(), Refusal> {
    out.write_all(text.as_ref()).map_err(Refusal::Output)
}
