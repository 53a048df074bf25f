//! Files that follow from the types of answers and requests, and from the options of the command line. Nobody edits them: `cargo xtask generate`
//! writes them, and `cargo xtask generate --check` names those that are stale.

mod markdown;
mod model;
mod options;
mod output;
mod python;
mod request;
mod typescript;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use boundfit_ask::Request;
use boundfit_report::answer::documents;
use model::Document;

/// The command that mends stale files.
const COMMAND: &str = "cargo xtask generate";

/// The comment above the types of documents.
const ANSWERS: &str = "// The documents that boundfit writes, of which `run` of boundfit.mjs answers with the first; made by `cargo xtask generate`.\n\
     // `JSON.parse(run(table, options))` is a `FitDocument`.\n";

/// The comment above the types of requests.
const REQUEST: &str = "// What `run` of boundfit.mjs takes; made by `cargo xtask generate`.\n";

/// A file that is generated.
struct Generated {
    /// The path from the top of the repository.
    path: PathBuf,
    text: String,
}

impl Generated {
    fn new(path: impl Into<PathBuf>, text: String) -> Self {
        Generated { path: path.into(), text }
    }

    /// Returns whether the repository has another text there, or none.
    fn is_stale(&self) -> bool {
        fs::read_to_string(root().join(&self.path)).ok().as_ref() != Some(&self.text)
    }
}

/// Writes stale files, or with `--check` names them; an exit status other than 0 says that there were some to be named.
pub fn run(options: &[String]) -> ExitCode {
    let result = match options {
        [] => write(),
        [option] if option == "--check" => match stale() {
            message if message.is_empty() => Ok(()),
            message => Err(io::Error::other(message)),
        },
        _ => Err(io::Error::other(format!("{COMMAND} [--check]"))),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nobody is left to be told where this cannot be written.
            writeln!(io::stderr(), "{error}").unwrap_or_default();
            ExitCode::FAILURE
        }
    }
}

/// Names the files that are stale or have no type any more, with the command that mends them; nothing where all are as they should be.
pub fn stale() -> String {
    let generated = generated();
    let stale = generated.iter().filter(|file| file.is_stale()).map(|file| file.path.clone());
    let mut paths: Vec<PathBuf> = stale.chain(left_over(&generated)).collect();
    paths.sort();
    paths.iter().map(|path| format!("{} is stale: {COMMAND}\n", path.display())).collect()
}

fn write() -> io::Result<()> {
    let generated = generated();
    for file in generated.iter().filter(|file| file.is_stale()) {
        let path = root().join(&file.path);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(path, &file.text)?;
        writeln!(io::stdout(), "wrote {}", file.path.display())?;
    }
    for path in left_over(&generated) {
        fs::remove_file(root().join(&path))?;
        writeln!(io::stdout(), "removed {}", path.display())?;
    }
    Ok(())
}

/// Every generated file.
fn generated() -> Vec<Generated> {
    let documents: Vec<Document> = documents().into_iter().map(Document::new).collect();
    let request = [Document::new(Request::schema())];
    let schemas = documents.iter().chain(&request).map(|document| {
        let path = format!("schema/{}.json", document.name.replace('/', "-"));
        Generated::new(path, format!("{:#}\n", document.schema))
    });
    schemas
        .chain([
            Generated::new(
                "crates/lesson/engine/answers.d.mts",
                typescript::declarations(ANSWERS, &documents),
            ),
            Generated::new("crates/lesson/engine/request.d.mts", typescript::declarations(REQUEST, &request)),
            Generated::new("python/boundfit/documents.py", python::declarations(&documents)),
            Generated::new("docs/reference/output.md", output::reference(&documents)),
            Generated::new("docs/reference/request.md", request.iter().map(request::reference).collect()),
            Generated::new("docs/reference/options.md", options::reference(&boundfit_cli::command())),
        ])
        .collect()
}

/// Schemas that no document has.
fn left_over(generated: &[Generated]) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("schema")).into_iter().flatten().flatten();
    let paths = entries.map(|entry| Path::new("schema").join(entry.file_name()));
    paths.filter(|path| generated.iter().all(|file| file.path != *path)).collect()
}

/// The top of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}
