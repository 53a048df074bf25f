//! A proof as its file has it.

use boundfit_exact::Limits;

use crate::about::About;
use crate::data::Data;
use crate::shape::{NotAProof, Shape, check_digits, needed};
use crate::statements::Statement;
use crate::theorem::Theorem;
use crate::whole_set::WholeSet;

/// A proof, whose statements may be true or false.
#[derive(Debug, Clone)]
pub struct Proof {
    pub(crate) data: Data,
    pub(crate) body: Body,
}

/// The statement of a proof.
#[derive(Debug, Clone)]
pub(crate) enum Body {
    /// Version 1: all about one set.
    Whole(WholeSet),
    /// Version 2: statements, each by itself.
    Statements(Vec<Statement>),
    /// The rows of a theorem for Coq.
    Theorem(Theorem),
}

impl Proof {
    /// Reads a proof, or the rows of a theorem for Coq, from its file. Its numbers may have ten times as many digits as those
    /// of the data: they are computed from several of these. Cost: linear in the file but for very long numbers.
    ///
    /// # Errors
    /// An error for a text that is no proof.
    pub fn read(text: &[u8], limits: &Limits) -> Result<Self, NotAProof> {
        let most_digits = limits.digits.saturating_mul(10);
        if text.trim_ascii_start().starts_with(b"(*") {
            return Proof::of_theorem(text, most_digits);
        }
        if Theorem::is_without_head(text) {
            return Err(NotAProof::new(
                "a theorem without its head: it does not begin with the comment in which boundfit writes how the rows were read from \
                 data (expected the file as boundfit wrote it)",
            ));
        }
        let mut shape = Shape::read(text, most_digits)?;
        let body = match shape.schema.raw() {
            "boundfit/proof/1" => Body::Whole(WholeSet::read(&mut shape)?),
            "boundfit/proof/2" => {
                let statements = needed(shape.statements.take(), "statements")?;
                if statements.is_empty() {
                    return Err(NotAProof::new("it states nothing"));
                }
                let read =
                    |(number, own)| Statement::read(own).map_err(|problem| problem.in_statement(number));
                Body::Statements((1..).zip(statements).map(read).collect::<Result<_, _>>()?)
            }
            schema => return Err(NotAProof::unlike(format_args!("its schema is {schema:?}"))),
        };
        shape.refuse_others(matches!(body, Body::Statements(_)))?;
        let sha256 = shape.sha256.raw().to_owned();
        Ok(Proof { data: Data { sha256, about: About::read(shape) }, body })
    }

    /// Reads the file of a theorem, whose comments come first.
    fn of_theorem(text: &[u8], most_digits: usize) -> Result<Self, NotAProof> {
        check_digits(text, most_digits)?;
        let text = std::str::from_utf8(text).map_err(NotAProof::new)?;
        let (shape, theorem) = Theorem::read(text, most_digits)?;
        shape.refuse_others(false)?;
        let sha256 = shape.sha256.raw().to_owned();
        Ok(Proof { data: Data { sha256, about: About::read(shape) }, body: Body::Theorem(theorem) })
    }

    /// Returns what it is about, whether it is true or not.
    pub fn about(&self) -> &About {
        &self.data.about
    }
}
