//! A proof as its file has it.

use boundfit_exact::Limits;

use crate::about::About;
use crate::data::Data;
use crate::shape::{NotAProof, Shape, needed};
use crate::statements::Statement;
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
}

impl Proof {
    /// Reads a proof from its file, whose numbers may have ten times as many digits as those of the data: they are computed
    /// from several of these. Cost: linear in the file but for very long numbers.
    ///
    /// # Errors
    /// What keeps it from being a proof.
    pub fn read(text: &[u8], limits: &Limits) -> Result<Self, NotAProof> {
        let mut shape = Shape::read(text, limits.digits.saturating_mul(10))?;
        let body = match shape.schema.raw() {
            "boundfit/proof/1" => Body::Whole(WholeSet::read(&mut shape)?),
            "boundfit/proof/2" => {
                let statements = needed(shape.statements.take(), "statements")?;
                if statements.is_empty() {
                    return Err(NotAProof::new("it states nothing"));
                }
                Body::Statements(statements.into_iter().map(Statement::read).collect::<Result<_, _>>()?)
            }
            _ => return Err(NotAProof::new("another schema")),
        };
        if shape.has_more(matches!(body, Body::Statements(_))) {
            return Err(NotAProof::new("a field of another version"));
        }
        let sha256 = shape.sha256.raw().to_owned();
        Ok(Proof { data: Data { sha256, about: About::read(shape) }, body })
    }

    /// Returns what it is about, whether it is true or not.
    pub fn about(&self) -> &About {
        &self.data.about
    }
}
