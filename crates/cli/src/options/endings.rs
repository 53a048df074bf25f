//! The formats of answers, which the end of a file's name may tell.

use std::path::Path;

use boundfit_ask::Form;
use clap::ValueEnum;

use crate::exit::Failure;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum Format {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
}

/// Formats of an answer that is a document or a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum TableFormat {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
    /// The report's tables in LaTeX (booktabs)
    Latex,
    /// The report's tables in Markdown
    Markdown,
    /// The answer as a table
    Csv,
}

impl From<TableFormat> for Form {
    fn from(format: TableFormat) -> Self {
        match format {
            TableFormat::Text => Form::Text,
            TableFormat::Json => Form::Json,
            TableFormat::Latex => Form::Latex,
            TableFormat::Markdown => Form::Markdown,
            TableFormat::Csv => Form::Csv,
        }
    }
}

/// Formats of a fit or a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum ReportFormat {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
    /// The report's tables in LaTeX (booktabs)
    Latex,
    /// The report's tables in Markdown
    Markdown,
    /// A table: of 'fit' intervals and estimates (--vertices: the vertices), with --by a row per group; of 'polygon'
    /// the vertices
    Csv,
    /// The set as well-known text, in decimals of at least 17 digits; bounded sets only
    Wkt,
    /// A MATLAB or Octave script that defines the vertices
    M,
    /// The irredundant half-planes as cdd's and lrs's H-representation
    Ine,
    /// The vertices, rays and lines as cdd's and lrs's V-representation
    Ext,
}

impl From<ReportFormat> for Form {
    fn from(format: ReportFormat) -> Self {
        match format {
            ReportFormat::Text => Form::Text,
            ReportFormat::Json => Form::Json,
            ReportFormat::Latex => Form::Latex,
            ReportFormat::Markdown => Form::Markdown,
            ReportFormat::Csv => Form::Csv,
            ReportFormat::Wkt => Form::Wkt,
            ReportFormat::M => Form::M,
            ReportFormat::Ine => Form::Ine,
            ReportFormat::Ext => Form::Ext,
        }
    }
}

/// A format of answers that a file's name may tell.
pub(crate) trait NamedFormat: Copy + Default + 'static {
    /// The ends of names, in small letters, and what they tell.
    const ENDINGS: &'static [(&'static str, Self)];
}

impl NamedFormat for Format {
    const ENDINGS: &'static [(&'static str, Self)] = &[("json", Format::Json), ("txt", Format::Text)];
}

impl NamedFormat for TableFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", TableFormat::Json),
        ("tex", TableFormat::Latex),
        ("md", TableFormat::Markdown),
        ("markdown", TableFormat::Markdown),
        ("csv", TableFormat::Csv),
        ("txt", TableFormat::Text),
    ];
}

impl NamedFormat for ReportFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", ReportFormat::Json),
        ("ndjson", ReportFormat::Json),
        ("jsonl", ReportFormat::Json),
        ("tex", ReportFormat::Latex),
        ("md", ReportFormat::Markdown),
        ("markdown", ReportFormat::Markdown),
        ("csv", ReportFormat::Csv),
        ("wkt", ReportFormat::Wkt),
        ("m", ReportFormat::M),
        ("ine", ReportFormat::Ine),
        ("ext", ReportFormat::Ext),
        ("txt", ReportFormat::Text),
    ];
}

/// Ends of names that are those of one format, so that nothing else belongs in such a file.
const TELLING: [&str; 42] = [
    "arrow", "bmp", "csv", "doc", "docx", "eps", "ext", "feather", "gif", "htm", "html", "ine", "ipynb",
    "jpeg", "jpg", "json", "jsonl", "lp", "m", "markdown", "mat", "md", "mps", "ndjson", "npy", "npz", "ods",
    "odt", "parquet", "pdf", "png", "ps", "py", "svg", "tex", "tikz", "tsv", "webp", "wkt", "xls", "xlsx",
    "xml",
];

/// The format that the end of a file's name tells, among those that a command has; `None` where it tells nothing.
/// `instead` is the option that tells the format, if there is one.
///
/// # Errors
/// When the name tells a format that the command does not have.
pub(crate) fn told_by_name<F: Copy>(
    file: Option<&str>,
    endings: &[(&str, F)],
    instead: Option<&str>,
) -> Result<Option<F>, Failure> {
    let Some((file, ending)) = file.and_then(|file| Some((file, ending(file)?))) else { return Ok(None) };
    if let Some((_, format)) = endings.iter().find(|(name, _)| *name == ending) {
        return Ok(Some(*format));
    }
    if !TELLING.contains(&ending.as_str()) {
        return Ok(None);
    }
    let names: Vec<String> = endings.iter().map(|(name, _)| format!(".{name}")).collect();
    let instead = instead.map(|option| format!(", or {option}")).unwrap_or_default();
    let problem = format!(
        "this command writes no .{ending} (expected a name that ends in {}{instead})",
        names.join(", ")
    );
    Err(Failure::value("--output <FILE>", file, problem))
}

/// The end of a file's name in small letters.
pub(crate) fn ending(file: &str) -> Option<String> {
    Some(Path::new(file).extension()?.to_str()?.to_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ending_of_a_format_is_telling() {
        let names =
            |endings: &[&'static str]| endings.iter().all(|name| *name == "txt" || TELLING.contains(name));
        assert!(names(&TableFormat::ENDINGS.iter().map(|(name, _)| *name).collect::<Vec<_>>()));
        assert!(names(&Format::ENDINGS.iter().map(|(name, _)| *name).collect::<Vec<_>>()));
        assert!(names(&ReportFormat::ENDINGS.iter().map(|(name, _)| *name).collect::<Vec<_>>()));
        assert!(TELLING.is_sorted());
    }
}
