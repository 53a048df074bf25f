//! Every document keeps to its JSON Schema: the golden ones, and what the program answers about sets of every kind. The schema of requests
//! allows what the reader of requests takes.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use boundfit::ask::Request;
use boundfit_tests::cli::fits::{Case, all};
use boundfit_tests::cli::{FIT_TRANSDUCER, boundfit, directory_with};
use boundfit_tests::program::root;
use boundfit_tests::schemas::{schemas, violations};
use serde_json::{Map, Value, json};

use crate::matrix::{about, list};

/// The schema of what programs ask.
const REQUEST: &str = "boundfit/request/1";

/// The ten kinds of sets.
const KINDS: [&str; 10] = [
    "empty",
    "half-plane",
    "line",
    "plane",
    "point",
    "polygon",
    "ray",
    "segment",
    "strip",
    "unbounded-polygon",
];

/// Documents by their schemas, as they are checked.
struct Seen {
    schemas: BTreeMap<String, Value>,
    kinds: BTreeMap<String, BTreeSet<String>>,
}

impl Seen {
    fn new() -> Self {
        Seen { schemas: schemas(), kinds: BTreeMap::new() }
    }

    /// Checks a document, and remembers which kind of set it is about.
    fn see(&mut self, document: &Value, place: &str) {
        let name = document["schema"].as_str().unwrap_or_else(|| panic!("{place}: no schema"));
        let schema = self.schemas.get(name).unwrap_or_else(|| panic!("{place}: no file for {name}"));
        assert_eq!(violations(document, schema), Vec::<String>::new(), "{place}: {name}");
        let set = ["fps", "set", "region", "longest_fit"].map(|part| &document[part]["kind"]);
        let kind = set.into_iter().find_map(Value::as_str).unwrap_or_default();
        self.kinds.entry(name.to_owned()).or_default().insert(kind.to_owned());
    }

    /// Checks what a command answers, one document or one a line; a refusal is none.
    fn run(&mut self, folder: &Path, line: &str) {
        let run = boundfit(folder, line);
        if [1, 2].contains(&run.status) {
            assert!(run.stdout.is_empty(), "{line}");
            return;
        }
        let documents = serde_json::Deserializer::from_str(&run.stdout).into_iter::<Value>();
        for document in documents {
            self.see(&document.unwrap_or_else(|error| panic!("{line}: {error}")), line);
        }
    }
}

/// The documents among the files of a folder and its folders.
fn golden(folder: &Path, found: &mut Vec<(String, Value)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            golden(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "json") {
            let document =
                fs::read(&path).ok().and_then(|bytes| serde_json::from_slice::<Value>(&bytes).ok());
            // Documents are about an input; other fixtures have schemas of their own.
            let is_own = |document: &Value| document["schema"].is_string() && document["input"].is_object();
            if let Some(document) = document.filter(is_own) {
                found.push((path.display().to_string(), document));
            }
        }
    }
}

#[test]
fn golden_documents_keep_to_their_schemas() {
    let (mut seen, mut found) = (Seen::new(), Vec::new());
    golden(&root().join("fixtures"), &mut found);
    for (place, document) in &found {
        seen.see(document, place);
    }
    assert!(found.len() >= 10, "only {} documents", found.len());
}

/// The commands about the readings of a case, on its table.
fn questions(case: &Case) -> Vec<String> {
    let of = |command: &str| case.command_line().replacen("fit ", command, 1);
    let at = match (case.x.contains(','), case.epsilon) {
        (true, _) => "--at '2;-1'",
        (false, Some(_)) => "--at 2 --from 3",
        // A further reading would need a bound.
        (false, None) => "--at 2",
    };
    vec![
        of("fit ") + " --sweep 0..3 --format json",
        of("fit ") + " --confidence 0.9 --format json",
        of("fit ") + " --no-lp --proof - -o /dev/null",
        of("fit ") + " --x-eps 1/4 --format json",
        of("fit ") + " --x-eps 1/4 --strong --format json",
        of("fit ") + " --by y --format json",
        of("fit ") + " --window 1 --format json",
        of("fit ") + " --window 3 --format json",
        of("status ") + " --new data.csv --format json",
        of("status ") + " --repair --format json",
        of("status ") + " --proof - -o /dev/null",
        of("predict ") + &format!(" {at} --format json"),
        of("next ") + " --within -1..9 --new-eps 1 --format json",
        of("outliers ") + " --format json",
        of("outliers ") + " --proof - -o /dev/null",
        of("range ") + " --format json",
        of("check ") + " --directions 8 --format json",
    ]
}

#[test]
fn answers_about_sets_of_every_kind_keep_to_their_schemas() {
    let mut seen = Seen::new();
    for case in all() {
        let folder = directory_with(&[("data.csv", case.csv.as_bytes())]);
        for line in questions(&case) {
            seen.run(folder.path(), &line);
        }
        boundfit(folder.path(), &(case.command_line() + " --no-lp --proof p.json"));
        seen.run(folder.path(), "verify p.json data.csv --format json");
        boundfit(folder.path(), &(case.command_line().replacen("fit ", "outliers ", 1) + " --proof o.json"));
        seen.run(folder.path(), "verify o.json data.csv --format json");
    }
    for fixture in ["house.ine", "cone.ext", "empty-by-lrs.ext", "segment.ine", "upper-half-by-cdd.ext"] {
        seen.run(&root(), &format!("polygon fixtures/polygon/{fixture} --format json"));
    }
    let linearity = "linearity fixtures/linearity/cycles.csv --x x_mm --y mV --direction direction";
    seen.run(&root(), &format!("{linearity} --format json"));
    let claims =
        "check fixtures/claims/strip.csv --x x --y y --eps 1 --claim fixtures/claims/strip-null.json";
    seen.run(&root(), &format!("{claims} --format json"));
    seen.run(&root(), "judge fixtures/tiny-lp/maximise.mps --solution fixtures/solutions/tiny-lp/maximise.cbc.sol --format json");
    let is_missing = |name: &&String| *name != REQUEST && !seen.kinds.contains_key(*name);
    let missing: Vec<&String> = seen.schemas.keys().filter(is_missing).collect();
    assert!(missing.is_empty(), "no document of {missing:?}");
    for name in ["boundfit/fit/2", "boundfit/status/1", "boundfit/predict/1"] {
        let kinds: Vec<&str> = seen.kinds[name].iter().map(String::as_str).collect();
        assert_eq!(kinds, KINDS, "{name}");
    }
}

/// Every change of one value, with where it is.
fn changed(document: &Value, place: &str, change: &mut dyn FnMut(Value, &str)) {
    match document {
        Value::Object(fields) => {
            for (key, value) in fields {
                let place = format!("{place}.{key}");
                let with = |value: Value| {
                    let mut fields = fields.clone();
                    fields.insert(key.clone(), value);
                    Value::Object(fields)
                };
                changed(value, &place, &mut |value, place| change(with(value), place));
            }
            let mut more = fields.clone();
            more.insert("unheard_of".to_owned(), 1.into());
            change(more.into(), &format!("{place}.unheard_of"));
        }
        Value::Array(values) => {
            for (index, value) in values.iter().enumerate() {
                changed(value, &format!("{place}[{index}]"), &mut |value, place| {
                    let mut values = values.clone();
                    values[index] = value;
                    change(values.into(), place);
                });
            }
        }
        // No field is a text here and a truth there.
        Value::Bool(_) => change("true".into(), place),
        _ => change(true.into(), place),
    }
}

#[test]
fn a_document_with_one_wrong_value_does_not_keep_to_its_schema() {
    let line = format!("{FIT_TRANSDUCER} --sweep 1..2 --confidence 1/2 --format json");
    let document: Value = serde_json::from_str(&boundfit(&root(), &line).stdout).unwrap();
    let schema = &schemas()["boundfit/fit/2"];
    assert_eq!(violations(&document, schema), Vec::<String>::new());
    let mut changes = 0;
    changed(&document, "document", &mut |wrong, place| {
        assert!(!violations(&wrong, schema).is_empty(), "{place}");
        changes += 1;
    });
    assert!(changes > 300, "{changes}");
}

/// Returns whether the reader of requests takes one.
fn is_taken(request: &Value) -> bool {
    Request::with_readings(&request.to_string()).is_ok()
}

#[test]
fn requests_of_every_question_keep_to_the_schema_and_wrong_ones_do_not() {
    let (list, schema) = (list(), &schemas()[REQUEST]);
    let mut changes = 0;
    for (name, own) in list["questions"].as_object().unwrap() {
        for line in about(&list, own) {
            let mut request = own["request"].clone();
            request["ask"] = json!(name);
            let words: Vec<&str> = line.split(' ').skip(1).collect();
            for option in words.chunks(2) {
                let key = option[0].trim_start_matches("--").replace('-', "_");
                let two = option[1].split_once(',').filter(|_| key == "x");
                request[key] = two.map_or(json!(option[1]), |(one, other)| json!([one, other]));
            }
            assert_eq!(violations(&request, schema), Vec::<String>::new(), "{request}");
            assert!(is_taken(&request), "{request}");
            changed(&request, "request", &mut |wrong, place| {
                assert!(!violations(&wrong, schema).is_empty(), "{place}: {wrong}");
                assert!(!is_taken(&wrong), "{place}: {wrong}");
                changes += 1;
            });
        }
    }
    assert!(changes > 500, "{changes}");
}

/// Every key of every question, and one that there is not, with values of every type.
#[test]
fn the_schema_of_requests_allows_what_the_reader_takes() {
    let schema = &schemas()[REQUEST];
    let values = json!([
        true, 0, 7, -7, 1.5, 70_000, "7", {}, [], ["7"], ["7", "7"], ["7", "7", "7"], [7], [-7], [[1, 7]], [[1, null]],
        [[1, 7, 9]], { "exact": "7" }, { "exact": 7 }, { "exact": "7", "text": "7" }, { "digits": 7 }, { "digits": -7 },
        [{ "exact": "7" }], [{ "exact": "7" }, 7]
    ]);
    let keys = |schema: &Value| -> BTreeSet<String> {
        let keys = schema["properties"].as_object().into_iter().flat_map(Map::keys).cloned();
        keys.filter(|key| key != "ask").collect()
    };
    let questions = schema["anyOf"].as_array().unwrap();
    let own: BTreeSet<String> = questions.iter().flat_map(keys).collect();
    let (mut taken, mut refused) = (BTreeSet::new(), 0);
    for question in questions {
        // It has a question's other required keys, too.
        let required = question["required"].as_array().unwrap().iter().filter_map(Value::as_str);
        let mut request: Map<String, Value> = required.map(|key| (key.to_owned(), json!("7"))).collect();
        request["ask"] = question["properties"]["ask"]["const"].clone();
        for key in own.iter().chain(&keys(schema)).chain([&"unheard_of".to_owned()]) {
            for value in values.as_array().unwrap() {
                let mut request = request.clone();
                request.insert(key.clone(), value.clone());
                let request = Value::Object(request);
                let found = violations(&request, schema);
                assert_eq!(found.is_empty(), is_taken(&request), "{request}: {found:?}");
                if found.is_empty() {
                    taken.insert(key.clone());
                } else {
                    refused += 1
                };
            }
        }
    }
    assert_eq!(taken, own.union(&keys(schema)).cloned().collect());
    assert!(refused > 1_000, "{refused}");
    let names: Vec<&Value> = questions.iter().map(|own| &own["properties"]["ask"]["const"]).collect();
    assert_eq!(names, Request::NAMES);
}
