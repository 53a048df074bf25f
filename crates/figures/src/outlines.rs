//! The outlines of a picture: its lines and letters as paths, which PNG, PDF and most SVG are made of.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Indent, Options, Tree, WriteOptions};

use crate::error::FigureError;
use crate::{pdf, text};

/// Units of the SVG in an inch.
const PIXELS_PER_INCH: f32 = 96.0;
/// The largest number of pixels that are drawn: 400 MB of memory.
const MOST_PIXELS: f32 = 1e8;

/// The embedded font alone, for the library that makes outlines of letters.
pub(crate) static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
    let mut fonts = Database::new();
    fonts.load_font_data(text::FONT.to_vec());
    Arc::new(fonts)
});

/// The paths of a picture.
#[derive(Debug, Clone)]
pub(crate) struct Outlines {
    tree: Tree,
}

impl Outlines {
    /// Takes an SVG document apart.
    pub(crate) fn of(svg: &str) -> Result<Self, FigureError> {
        let font_family = text::FAMILY.to_owned();
        let options = Options { font_family, fontdb: FONTS.clone(), ..Options::default() };
        let tree = Tree::from_str(svg, &options).map_err(|error| FigureError(error.to_string()))?;
        Ok(Outlines { tree })
    }

    /// The document of paths.
    pub(crate) fn svg(&self) -> Option<String> {
        let options = WriteOptions {
            coordinates_precision: 0,
            transforms_precision: 4,
            indent: Indent::None,
            ..WriteOptions::default()
        };
        Some(joined(&self.tree.to_string(&options).replace("><", ">\n<")))
    }

    /// The attribute that says how large the document is.
    pub(crate) fn view(&self) -> String {
        let size = self.tree.size();
        format!("viewBox=\"0 0 {} {}\"", size.width(), size.height())
    }

    /// A PNG of some dots per inch.
    pub(crate) fn png(&self, dpi: u16) -> Result<Vec<u8>, FigureError> {
        let scale = f32::from(dpi) / PIXELS_PER_INCH;
        let [width, height] =
            [self.tree.size().width(), self.tree.size().height()].map(|length| length * scale);
        if width * height > MOST_PIXELS {
            let problem = format!(
                "{width:.0} by {height:.0} pixels are too many; a smaller picture, or one of fewer dots per inch, is drawn"
            );
            return Err(FigureError(problem));
        }
        let pixmap = Pixmap::new(width.round().max(1.0) as u32, height.round().max(1.0) as u32);
        let mut pixmap = pixmap.ok_or_else(|| FigureError("a picture without pixels".to_owned()))?;
        resvg::render(&self.tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
        let pixels = pixmap.encode_png().map_err(|error| FigureError(error.to_string()))?;
        Ok(with_mark(&pixels, dpi))
    }

    /// A PDF of one page.
    pub(crate) fn pdf(&self, title: &str, description: &str) -> Result<Vec<u8>, FigureError> {
        Ok(pdf::document(&self.tree, title, description))
    }
}

/// A document whose neighbouring paths of the same opaque look are one path each.
fn joined(document: &str) -> String {
    let mut joined = String::with_capacity(document.len());
    // The open path: the texts before and behind its points.
    let mut open: Option<(&str, &str)> = None;
    for line in document.split('\n') {
        let parts = line.split_once(" d=\"").and_then(|(before, rest)| {
            let (points, behind) = rest.split_once('"')?;
            (line.starts_with("<path") && !line.contains("opacity")).then_some((before, points, behind))
        });
        let look = parts.map(|(before, _, behind)| (before, behind));
        if let (Some(shown), Some((_, points, _)), true) = (open, parts, look == open) {
            // Before the end of the path.
            joined.truncate(joined.len() - shown.1.len() - 2);
            joined.push(' ');
            joined.push_str(points);
            joined.push('"');
            joined.push_str(shown.1);
            joined.push('\n');
            continue;
        }
        joined.push_str(line);
        joined.push('\n');
        open = look;
    }
    joined.truncate(joined.trim_end_matches('\n').len());
    joined
}

/// Returns a PNG that states its size. It has a text chunk `Software` behind its header, by which the program
/// recognises its own pictures (PNG, third edition, 11.3.3.2 and 11.3.4.3).
fn with_mark(png: &[u8], dpi: u16) -> Vec<u8> {
    /// Signature, and the header with its length, type and checksum.
    const HEADER_END: usize = 8 + 4 + 4 + 13 + 4;
    /// An inch in units of a millionth of a metre.
    const INCH: u32 = 25_400;
    let Some((header, rest)) = png.split_at_checked(HEADER_END) else { return png.to_vec() };
    let per_metre = ((u32::from(dpi) * 1_000_000 + INCH / 2) / INCH).to_be_bytes();
    let size = [&b"pHYs"[..], &per_metre, &per_metre, &[1]].concat();
    [header, &chunk(b"tEXtSoftware\0boundfit"), &chunk(&size), rest].concat()
}

/// A chunk with its length and checksum, from its type and data.
fn chunk(content: &[u8]) -> Vec<u8> {
    let length = (content.len() as u32 - 4).to_be_bytes();
    [&length, content, &crc32(content).to_be_bytes()].concat()
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
