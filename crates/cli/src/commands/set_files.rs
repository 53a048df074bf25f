//! The files that commands about half-planes write beside the report: a picture of the set and a theorem about it.

use boundfit_figures::PictureFormat;
use boundfit_report::Theory;

use super::pictures::picture_format;
use super::proof_file;
use crate::exit::Failure;
use crate::options::PictureArguments;
use crate::output::{Guard, files_apart};

/// A picture of a set, and a theorem about it.
#[derive(Clone, Copy)]
pub(super) struct SetFiles<'a> {
    pub(super) plot: Option<&'a str>,
    pub(super) proof: Option<&'a str>,
    pub(super) proof_library: bool,
    pub(super) picture: &'a PictureArguments,
}

impl SetFiles<'_> {
    /// Refuses files that are not each for itself, and options without an effect. Returns the format of the picture and the
    /// source of the theory.
    pub(super) fn checked(
        &self,
        report: Option<&str>,
        proved: &str,
    ) -> Result<(Option<PictureFormat>, Option<Theory>), Failure> {
        let SetFiles { plot, proof, .. } = *self;
        files_apart(report, &[("--plot", plot), ("--proof", proof)])?;
        let theory = proof_file::only_theory(proof, self.proof_library, proved)?;
        self.picture.check("--plot", plot.is_some())?;
        let format = plot.map(|file| picture_format("--plot <FILE>", file)).transpose()?;
        format.map_or(Ok(()), |format| self.picture.check_format(format))?;
        Ok((format, theory))
    }

    /// Refuses to write over what is not ours.
    pub(super) fn check(&self, guard: &Guard) -> Result<(), Failure> {
        guard.check(self.plot)?;
        guard.check(self.proof)
    }
}
