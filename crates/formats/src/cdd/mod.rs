//! The files of half-planes and generators that cdd and lrs read and write.

mod ext;
mod ine;
mod words;

pub(crate) use ine::parse_cdd;
