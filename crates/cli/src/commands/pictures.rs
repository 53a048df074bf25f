//! The code that the commands that draw share: formats by the names of files.

use boundfit_figures::PictureFormat;

use crate::exit::Failure;
use crate::options::ending;

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
        None => Err(Failure::value(option, file, format!("{})", PictureFormat::EXPECTED))),
    }
}
