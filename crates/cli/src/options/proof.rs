//! The options about a proof beside the answer.

use clap::Args;
use clap::builder::NonEmptyStringValueParser;

/// A proof, and where the theory of a theorem is.
#[derive(Debug, Args)]
pub(crate) struct ProofArguments {
    /// Also write a proof of the answer to this file; 'boundfit verify' checks it against the data. In FILE.v it is a
    /// theorem for the kernel of Coq instead. - means standard output if the report goes to a file
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    pub(crate) proof_library: bool,
}
