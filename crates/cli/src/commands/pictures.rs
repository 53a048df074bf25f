//! What the commands that draw have in common: formats by the names of files.

use boundfit_figures::PictureFormat;

use crate::arguments::ending;
use crate::exit::Failure;

/// What is said of a name that tells no format.
pub(super) const EXPECTED: &str =
    "a picture is SVG, PNG, PDF or TikZ (expected a name that ends in .svg, .png, .pdf, .tikz or .tex";

/// The format that the end of a file's name tells.
pub(super) fn told_by_name(file: &str) -> Option<PictureFormat> {
    let ending = ending(file)?;
    PictureFormat::ALL.into_iter().find(|format| format.name() == ending)
}

/// The format of a picture that an option names the file of; standard output has SVG.
pub(super) fn picture_format(option: &str, file: &str) -> Result<PictureFormat, Failure> {
    match told_by_name(file) {
        Some(format) => Ok(format),
        None if file == "-" => Ok(PictureFormat::Svg),
        None => Err(Failure::value(option, file, format!("{EXPECTED})"))),
    }
}
