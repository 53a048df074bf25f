//! The formats of answers, which the end of a file's name may tell.

use std::path::Path;

use crate::exit::Failure;

/// A format of answers that a file's name may tell.
pub(crate) trait NamedFormat: Copy + Default + 'static {
    /// The ends of names, in small letters, and what they tell.
    const ENDINGS: &'static [(&'static str, Self)];
}

/// Defines the formats of a command besides text, which is the default, each with its help and the ends of names that tell it.
macro_rules! formats {
    ($(#[$meaning:meta])* $name:ident { $($(#[$help:meta])* $format:ident: $($ending:literal),+;)* }) => {
        $(#[$meaning])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
        pub(crate) enum $name {
            /// A report for people
            #[default]
            Text,
            $($(#[$help])* $format,)*
        }

        impl $crate::options::NamedFormat for $name {
            const ENDINGS: &'static [(&'static str, Self)] =
                &[$($(($ending, $name::$format),)+)* ("txt", $name::Text)];
        }
    };
}
pub(crate) use formats;

/// States that formats are forms of the same names.
macro_rules! forms {
    ($format:ident: $($name:ident),+) => {
        impl From<$format> for boundfit_ask::Form {
            fn from(format: $format) -> Self {
                match format { $($format::$name => boundfit_ask::Form::$name),+ }
            }
        }
    };
}

formats! {
    /// Formats of an answer without tables.
    Format {
        /// Everything, for programs
        Json: "json";
    }
}

pub(crate) use forms;

forms!(Format: Text, Json);

formats! {
    /// Formats of an answer that is a document or a table.
    TableFormat {
        /// Everything, for programs
        Json: "json";
        /// The report's tables in LaTeX (booktabs)
        Latex: "tex";
        /// The report's tables in Markdown
        Markdown: "md", "markdown";
        /// The answer as a table
        Csv: "csv";
    }
}
forms!(TableFormat: Text, Json, Latex, Markdown, Csv);

formats! {
    /// Formats of a fit or a region.
    ReportFormat {
        /// Everything, for programs
        Json: "json", "ndjson", "jsonl";
        /// The report's tables in LaTeX (booktabs)
        Latex: "tex";
        /// The report's tables in Markdown
        Markdown: "md", "markdown";
        /// A table: of 'fit' intervals and estimates (--vertices: the vertices), with --by a row per group; of 'polygon'
        /// the vertices
        Csv: "csv";
        /// The set as well-known text, in decimals of at least 17 digits; bounded sets only
        Wkt: "wkt";
        /// A MATLAB or Octave script that defines the vertices
        M: "m";
        /// The irredundant half-planes as cdd's and lrs's H-representation
        Ine: "ine";
        /// The vertices, rays and lines as cdd's and lrs's V-representation
        Ext: "ext";
    }
}
forms!(ReportFormat: Text, Json, Latex, Markdown, Csv, Wkt, M, Ine, Ext);

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
