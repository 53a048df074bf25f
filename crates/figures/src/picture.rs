//! A drawn figure: one picture, encoded as SVG or PNG.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Indent, Options, Tree, WriteOptions};
use thiserror::Error;

use crate::text;

/// Pixels of the PNG per unit of the SVG.
const PNG_SCALE: f32 = 2.0;

/// Why a figure could not be drawn. Data cannot be the reason; only the libraries underneath can.
#[derive(Debug, Error)]
#[error("the figure cannot be drawn: {0}")]
pub struct FigureError(pub(crate) String);

/// How a picture is encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// Lines and letters as paths.
    Svg,
    /// Pixels.
    Png,
}

impl PictureFormat {
    /// Both of them.
    pub const ALL: [PictureFormat; 2] = [PictureFormat::Svg, PictureFormat::Png];

    /// The name on the command line, and the end of a file's name: `svg` or `png`.
    pub fn name(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
        }
    }
}

/// A drawn figure.
#[derive(Debug, Clone)]
pub struct Picture {
    tree: Tree,
    title: String,
    description: String,
}

impl Picture {
    /// Takes an SVG document apart into paths; texts become outlines of the embedded font.
    pub(crate) fn new(svg: &str, title: String, description: String) -> Result<Self, FigureError> {
        static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
            let mut fonts = Database::new();
            fonts.load_font_data(text::FONT.to_vec());
            Arc::new(fonts)
        });
        let options =
            Options { font_family: text::FAMILY.to_owned(), fontdb: FONTS.clone(), ..Options::default() };
        let tree = Tree::from_str(svg, &options).map_err(|error| FigureError(error.to_string()))?;
        Ok(Picture { tree, title, description })
    }

    /// The bytes of a file in this format.
    ///
    /// # Errors
    /// When the pixels of a PNG cannot be encoded.
    pub fn encoded(&self, format: PictureFormat) -> Result<Vec<u8>, FigureError> {
        match format {
            PictureFormat::Svg => Ok(self.svg().into_bytes()),
            PictureFormat::Png => self.png(),
        }
    }

    /// A self-contained SVG document without fonts, with title and description for those who cannot see it.
    /// Every call gives the same bytes.
    pub fn svg(&self) -> String {
        let options = WriteOptions {
            coordinates_precision: 0,
            transforms_precision: 4,
            indent: Indent::None,
            ..WriteOptions::default()
        };
        let document = self.tree.to_string(&options).replace("><", ">\n<");
        let (title, description) = (text::escaped(&self.title), text::escaped(&self.description));
        let head =
            format!("<title>{title}</title>\n<desc>{description}</desc>\n<metadata>boundfit</metadata>\n");
        match document.split_once(">\n") {
            Some((opening, rest)) => {
                let size = self.tree.size();
                let view = format!("viewBox=\"0 0 {} {}\"", size.width(), size.height());
                format!("{opening} {view} role=\"img\">\n{head}{rest}\n")
            }
            None => document,
        }
    }

    /// A PNG of twice the nominal size: 1600 pixels wide. Every call gives the same bytes.
    ///
    /// # Errors
    /// When the pixels cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        let size = self.tree.size().to_int_size().scale_by(PNG_SCALE);
        let pixmap = size.and_then(|size| Pixmap::new(size.width(), size.height()));
        let mut pixmap = pixmap.ok_or_else(|| FigureError("a picture without pixels".to_owned()))?;
        resvg::render(&self.tree, Transform::from_scale(PNG_SCALE, PNG_SCALE), &mut pixmap.as_mut());
        let pixels = pixmap.encode_png().map_err(|error| FigureError(error.to_string()))?;
        Ok(with_mark(&pixels))
    }
}

/// A PNG with a text chunk `Software` behind its header, by which the program knows its own pictures (PNG, third edition,
/// 11.3.3.2).
fn with_mark(png: &[u8]) -> Vec<u8> {
    /// Signature, and the header with its length, type and checksum.
    const HEADER_END: usize = 8 + 4 + 4 + 13 + 4;
    let text = b"tEXtSoftware\0boundfit";
    let Some((header, rest)) = png.split_at_checked(HEADER_END) else { return png.to_vec() };
    let length = (text.len() as u32 - 4).to_be_bytes();
    [header, &length, text, &crc32(text).to_be_bytes(), rest].concat()
}

/// The checksum of a chunk of PNG (ISO 3309), bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    let bit = |sum: u32, _| if sum & 1 == 1 { 0xedb8_8320 ^ (sum >> 1) } else { sum >> 1 };
    !bytes.iter().fold(!0, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), bit))
}

#[cfg(test)]
mod tests {
    use super::crc32;

    #[test]
    fn checksums_are_those_of_the_standard() {
        assert_eq!((crc32(b"123456789"), crc32(b"IEND")), (0xcbf4_3926, 0xae42_6082));
    }
}
