//! A drawn figure: one picture, encoded as SVG, PNG, PDF or source for TikZ.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Indent, Options, Tree, WriteOptions};

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::render::{self, Look};
use crate::{pdf, text};

/// Units of the SVG in an inch.
const PIXELS_PER_INCH: f32 = 96.0;
/// What is drawn at most: 400 MB of memory.
const MOST_PIXELS: f32 = 1e8;

/// How a picture is encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// Lines and letters as paths.
    Svg,
    /// Pixels.
    Png,
    /// Lines and letters as paths, on one page of the picture's size.
    Pdf,
    /// Source for LaTeX's TikZ, a picture for `\\input`: letters are those of the document.
    #[cfg(feature = "tikz")]
    Tikz,
    /// A document for LaTeX of one page with that picture.
    #[cfg(feature = "tikz")]
    Tex,
}

/// How a picture is encoded, beside its format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Encoding {
    /// Whether texts of an SVG stay texts, which others can edit and search, instead of outlines that look the same everywhere.
    pub real_text: bool,
    /// Dots per inch of a PNG.
    pub dpi: u16,
}

impl Default for Encoding {
    /// Outlines; 192 dots per inch.
    fn default() -> Self {
        Encoding { real_text: false, dpi: 192 }
    }
}

impl PictureFormat {
    /// All of this build.
    pub const ALL: [PictureFormat; if cfg!(feature = "tikz") { 5 } else { 3 }] = [
        PictureFormat::Svg,
        PictureFormat::Png,
        PictureFormat::Pdf,
        #[cfg(feature = "tikz")]
        PictureFormat::Tikz,
        #[cfg(feature = "tikz")]
        PictureFormat::Tex,
    ];
    /// What they are, and how the names of their files end, in words.
    pub const EXPECTED: &str = if cfg!(feature = "tikz") {
        "a picture is SVG, PNG, PDF or TikZ (expected a name that ends in .svg, .png, .pdf, .tikz or .tex"
    } else {
        "a picture is SVG, PNG or PDF (expected a name that ends in .svg, .png or .pdf"
    };

    /// The name on the command line, and the end of a file's name: `svg`, `png`, `pdf`, `tikz` or `tex`.
    pub fn name(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
            #[cfg(feature = "tikz")]
            PictureFormat::Tikz => "tikz",
            #[cfg(feature = "tikz")]
            PictureFormat::Tex => "tex",
        }
    }

    /// What a picture in this format is, in words.
    pub fn words(self) -> &'static str {
        match self {
            PictureFormat::Svg => "an SVG",
            PictureFormat::Png => "a PNG",
            PictureFormat::Pdf => "a PDF",
            #[cfg(feature = "tikz")]
            PictureFormat::Tikz | PictureFormat::Tex => "source for TikZ",
        }
    }
}

/// A drawn figure.
#[derive(Debug, Clone)]
pub struct Picture {
    tree: Tree,
    /// The document with its texts.
    source: String,
    drawing: Drawing,
    look: Look,
}

impl Picture {
    /// Takes an SVG document apart into paths; texts become outlines of the embedded font.
    pub(crate) fn new(svg: &str, drawing: Drawing, look: Look) -> Result<Self, FigureError> {
        let options = Options {
            font_family: text::FAMILY.to_owned(),
            fontdb: text::FONTS.clone(),
            ..Options::default()
        };
        let tree = Tree::from_str(svg, &options).map_err(|error| FigureError(error.to_string()))?;
        Ok(Picture { tree, source: svg.to_owned(), drawing, look })
    }

    /// The bytes of a file in this format.
    ///
    /// # Errors
    /// When the pixels of a PNG cannot be encoded.
    pub fn encoded(&self, format: PictureFormat) -> Result<Vec<u8>, FigureError> {
        self.encoded_as(format, &Encoding::default())
    }

    /// The bytes of a file in this format, encoded in a way of its own.
    ///
    /// # Errors
    /// When the pixels of a PNG are too many, or cannot be encoded.
    pub fn encoded_as(&self, format: PictureFormat, encoding: &Encoding) -> Result<Vec<u8>, FigureError> {
        match format {
            PictureFormat::Svg => Ok(self.svg_document(encoding.real_text).into_bytes()),
            PictureFormat::Png => self.pixels(encoding.dpi),
            PictureFormat::Pdf => {
                Ok(pdf::document(&self.tree, &self.drawing.title, &self.drawing.description))
            }
            #[cfg(feature = "tikz")]
            PictureFormat::Tikz => Ok(render::source(&self.drawing, &self.look, false)?.into_bytes()),
            #[cfg(feature = "tikz")]
            PictureFormat::Tex => Ok(render::source(&self.drawing, &self.look, true)?.into_bytes()),
        }
    }

    /// A self-contained SVG document without fonts, with title and description for those who cannot see it.
    /// Every call gives the same bytes.
    pub fn svg(&self) -> String {
        self.svg_document(false)
    }

    fn svg_document(&self, real_text: bool) -> String {
        let options = WriteOptions {
            coordinates_precision: 0,
            transforms_precision: 4,
            indent: Indent::None,
            ..WriteOptions::default()
        };
        let document = if real_text {
            // Where the embedded font is not installed, one like it.
            let font = format!("font-family=\"{}\"", text::FAMILY);
            self.source.replace(&font, &font.replace("Inter\"", "Inter, Helvetica, Arial, sans-serif\""))
        } else {
            joined(&self.tree.to_string(&options).replace("><", ">\n<"))
        };
        let Drawing { title, description, .. } = &self.drawing;
        let (title, description) = (text::escaped(title), text::escaped(description));
        let head =
            format!("<title>{title}</title>\n<desc>{description}</desc>\n<metadata>boundfit</metadata>\n");
        match document.split_once(">\n") {
            Some((opening, rest)) => {
                let size = self.tree.size();
                let view = match opening.contains("viewBox") {
                    true => String::new(),
                    false => format!("viewBox=\"0 0 {} {}\"", size.width(), size.height()),
                };
                format!("{opening} {view} role=\"img\">\n{head}{rest}\n")
            }
            None => document,
        }
    }

    /// A PNG of 192 dots per inch: 1600 pixels wide at the usual size. Every call gives the same bytes.
    ///
    /// # Errors
    /// When the pixels cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        self.pixels(Encoding::default().dpi)
    }

    fn pixels(&self, dpi: u16) -> Result<Vec<u8>, FigureError> {
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
}

/// A document whose neighbouring paths of the same opaque look are one path each.
fn joined(document: &str) -> String {
    let mut joined = String::with_capacity(document.len());
    // Of the path that is open: what stands before and behind its points.
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

/// A PNG that says how large it is, and with a text chunk `Software` behind its header, by which the program knows its own
/// pictures (PNG, third edition, 11.3.3.2 and 11.3.4.3).
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
