//! Every question × every form × fits of the fixtures: the library says what the program writes, byte for byte, or both refuse. The
//! tests of Python and of WebAssembly go through the same list, `tests/questions.json`; here it is held equal to the registry.

use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;

use boundfit::Reading;
use boundfit::ask::{Answer, Asked, AskedXBounds, Files, Form, Readings, Refusal, Request, XErrors};
use boundfit::engine::exact::Foreign;
use boundfit::files::{ColumnSelector, EpsilonColumn, Question, RowRange, RowSet, ScanOptions, Source};
use boundfit::questions::Agreement;
use boundfit::report::{Origin, Style};
use boundfit_tests::cli::boundfit;
use boundfit_tests::program::root;
use serde_json::{Value, json};

/// The list that all surfaces go through.
pub fn list() -> Value {
    serde_json::from_str(&fs::read_to_string(root().join("tests/questions.json")).unwrap()).unwrap()
}

#[test]
fn the_list_of_questions_is_the_registry() {
    let list = list();
    let listed: BTreeMap<&str, Value> = list["questions"]
        .as_object()
        .unwrap()
        .iter()
        .map(|(name, own)| (&**name, own["forms"].clone()))
        .collect();
    let names = |forms: &[Form]| json!(forms.iter().map(|form| form.name()).collect::<Vec<_>>());
    let registered: BTreeMap<&str, Value> =
        Request::FORMS.iter().map(|(name, forms)| (*name, names(forms))).collect();
    assert_eq!(listed, registered, "tests/questions.json, which the tests of Python and WebAssembly read");
    assert_eq!(Request::NAMES, Request::FORMS.iter().map(|(name, _)| *name).collect::<Vec<_>>());
}

/// The tables that a question is asked about.
pub fn about<'a>(list: &'a Value, question: &Value) -> impl Iterator<Item = &'a str> {
    let name = question["about"].as_str().unwrap_or("about");
    list[name].as_array().unwrap().iter().map(|line| line.as_str().unwrap())
}

/// A question about a table, in the words of the program.
struct Words<'a> {
    file: &'a str,
    options: BTreeMap<&'a str, &'a str>,
}

impl<'a> Words<'a> {
    fn of(line: &'a str) -> Self {
        let words: Vec<&str> = line.split(' ').collect();
        let options = words[1..].chunks(2).map(|own| (own[0], own[1])).collect();
        Words { file: words[0], options }
    }

    fn column(&self, option: &str) -> Option<ColumnSelector> {
        self.options.get(option).map(|name| ColumnSelector::name_or_number(name))
    }

    /// The same for the library.
    fn asked(&self, x_eps: bool, is_stored: bool) -> Asked {
        let is_binary = is_stored || self.options.get("--reading") == Some(&"binary64");
        let reading = if is_binary { Reading::Binary64 } else { Reading::Decimal };
        let x: Vec<ColumnSelector> =
            self.options["--x"].split(',').map(ColumnSelector::name_or_number).collect();
        let y = self.column("--y");
        let question = match <[ColumnSelector; 2]>::try_from(x) {
            Ok([first, second]) => Question::regressors(first, second, y),
            Err(mut one) => Question::line(one.remove(0), y),
        };
        let question = match (self.options.get("--eps"), self.column("--eps-column")) {
            (Some(eps), _) => question.within(eps, reading).unwrap(),
            (None, Some(column)) => question.within_columns(EpsilonColumn::Column(column)),
            (None, None) => {
                let (lower, upper) = (self.column("--lower"), self.column("--upper"));
                question.within_columns(EpsilonColumn::Interval { lower, upper })
            }
        };
        let mut options = ScanOptions::default();
        options.table.reading = reading;
        if let Some(rows) = self.options.get("--rows") {
            let (first, last) = rows.split_once("..").unwrap();
            let range = RowRange::new(first.parse().unwrap(), last.parse().unwrap()).unwrap();
            options.table.rows = RowSet::new(&[range], &[]).unwrap();
        }
        let bounds = AskedXBounds::Uniform(reading.read("1/10", &options.table.limits).unwrap());
        let x_errors = x_eps.then_some(XErrors { bounds, agreement: Agreement::Weak });
        let tables = Some(Arc::new(Files(options.clone())) as Arc<_>);
        Asked { x_errors, options, tables, ..Asked::new(question) }
    }
}

/// Returns the library's answer.
fn library(words: &Words<'_>, request: &Value, form: Form) -> Result<Answer, Refusal> {
    let source = Source::open(root().join("fixtures").join(words.file).to_str().unwrap()).unwrap();
    let is_stored = source.is_stored();
    let own = Request::parse(&request.to_string())?;
    let asked = match request["ask"].as_str() {
        Some("judge" | "polygon") => own.resolve(&Readings::default(), Reading::Decimal)?,
        name => words.asked(name == Some("fit-x-errors"), is_stored),
    };
    let origin =
        Origin { file: Some(Foreign::of(words.file)), reading: asked.options.table.reading, is_stored };
    own.answer(&asked, source, form, Some(origin), &Style::default())
}

/// Returns the document that the program writes, where it writes an answer.
fn program(words: &Words<'_>, command: &str, form: Form) -> Option<String> {
    let (name, own) = command.split_once(' ').unwrap_or((command, ""));
    // Linearity has no bounds on the errors.
    let is_taken =
        |option: &str| name != "linearity" || ["--x", "--y", "--rows", "--reading"].contains(&option);
    let asked = words.options.iter().filter(|(option, _)| is_taken(option));
    let asked: Vec<String> = asked.map(|(option, value)| format!("{option} {value}")).collect();
    let folder = tempfile::tempdir().unwrap();
    let proof = folder.path().join("p.json");
    let proof = proof.to_str().unwrap();
    let format = match form {
        Form::Vertices => "--vertices --format csv".to_owned(),
        Form::Proof => format!("--proof {proof}"),
        form => format!("--format {}", form.name()),
    };
    let run = boundfit(
        &root().join("fixtures"),
        &format!("{name} {} {} {own} {format}", words.file, asked.join(" ")),
    );
    assert!((0..=4).contains(&run.status), "{run:?}");
    let text = if form == Form::Proof { fs::read_to_string(proof).unwrap_or_default() } else { run.stdout };
    matches!(run.status, 0 | 3 | 4).then_some(text)
}

#[test]
fn the_library_says_what_the_program_writes() {
    let list = list();
    for (name, own) in list["questions"].as_object().unwrap() {
        let mut request = own["request"].clone();
        request["ask"] = json!(name);
        let (command, mut answers) = (own["command"].as_str().unwrap(), 0);
        for line in about(&list, own) {
            let words = Words::of(line);
            for form in own["forms"].as_array().unwrap() {
                let form = Form::ALL.into_iter().find(|own| own.name() == form).unwrap();
                let (told, written) = (library(&words, &request, form), program(&words, command, form));
                match (told, written) {
                    (Ok(told), Some(written)) => {
                        // Next steps are commands, which the library has none of.
                        let written = written.split("\nNext steps").next().unwrap();
                        assert!(
                            told.text == written,
                            "{name} as {} of {line}: {}\n{written}",
                            form.name(),
                            told.text
                        );
                        answers += 1;
                    }
                    (Err(_), None) => {}
                    (told, written) => panic!("{name} as {} of {line}: {told:?}, {written:?}", form.name()),
                }
            }
        }
        assert!(answers > own["forms"].as_array().unwrap().len(), "{name}");
    }
}
