//! A drawn figure: one picture, encoded as SVG, PNG, PDF or source for TikZ.

use std::sync::OnceLock;

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::outlines::Outlines;
use crate::render::Look;
use crate::text;

/// The format of a picture.
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

/// The encoding of a picture, beside its format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Encoding {
    /// `true` if texts of an SVG stay texts, which others can edit and search, instead of outlines that look the same everywhere.
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
    /// The formats, with the endings of their files, in words.
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

    /// Returns the kind of picture in this format, in words.
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
    /// Made when they are asked for: letters take most of the time of a picture.
    outlines: OnceLock<Outlines>,
    /// The document with its texts.
    source: String,
    drawing: Drawing,
    #[cfg_attr(not(feature = "tikz"), expect(dead_code, reason = "the SVG has it already"))]
    look: Look,
}

impl Picture {
    pub(crate) fn new(source: String, drawing: Drawing, look: Look) -> Self {
        Picture { outlines: OnceLock::new(), source, drawing, look }
    }

    /// The paths of the document; texts become outlines of the embedded font, with the feature `outlines`.
    fn outlines(&self) -> Result<&Outlines, FigureError> {
        if let Some(outlines) = self.outlines.get() {
            return Ok(outlines);
        }
        let made = Outlines::of(&text::drawable(&self.source))?;
        Ok(self.outlines.get_or_init(|| made))
    }

    /// The bytes of a file in this format.
    ///
    /// # Errors
    /// When the pixels of a PNG are too many, or cannot be encoded, and for PNG and PDF in a build without the feature `outlines`.
    pub fn encoded_as(&self, format: PictureFormat, encoding: &Encoding) -> Result<Vec<u8>, FigureError> {
        match format {
            PictureFormat::Svg => Ok(self.svg_document(encoding.real_text)?.into_bytes()),
            PictureFormat::Png => self.outlines()?.png(encoding.dpi),
            PictureFormat::Pdf => self.outlines()?.pdf(&self.drawing.title, &self.drawing.description),
            #[cfg(feature = "tikz")]
            PictureFormat::Tikz => Ok(crate::render::source(&self.drawing, &self.look, false)?.into_bytes()),
            #[cfg(feature = "tikz")]
            PictureFormat::Tex => Ok(crate::render::source(&self.drawing, &self.look, true)?.into_bytes()),
        }
    }

    /// A self-contained SVG document without fonts (with texts as texts in a build without the feature `outlines`), with title and description for those who cannot see it.
    /// Every call gives the same bytes.
    ///
    /// # Errors
    /// When the picture has no size.
    pub fn svg(&self) -> Result<String, FigureError> {
        self.svg_document(false)
    }

    fn svg_document(&self, real_text: bool) -> Result<String, FigureError> {
        // Where the embedded font is not installed, one like it.
        let with_texts = || {
            let font = format!("font-family=\"{}\"", text::FAMILY);
            self.source.replace(&font, &font.replace("Inter\"", "Inter, Helvetica, Arial, sans-serif\""))
        };
        let outlined = if real_text { None } else { self.outlines()?.svg() };
        let document = outlined.unwrap_or_else(with_texts);
        let Drawing { title, description, .. } = &self.drawing;
        let (title, description) = (text::escaped(title), text::escaped(description));
        let head =
            format!("<title>{title}</title>\n<desc>{description}</desc>\n<metadata>boundfit</metadata>\n");
        Ok(match document.split_once(">\n") {
            Some((opening, rest)) => {
                let view = match opening.contains("viewBox") {
                    true => String::new(),
                    false => self.outlines()?.view(),
                };
                format!("{opening} {view} role=\"img\">\n{head}{rest}\n")
            }
            None => document,
        })
    }

    /// A PNG of 192 dots per inch: 1600 pixels wide at the usual size. Every call gives the same bytes.
    ///
    /// # Errors
    /// When the pixels cannot be encoded, and in a build without the feature `outlines`.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        self.outlines()?.png(Encoding::default().dpi)
    }
}
