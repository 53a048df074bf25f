//! Tables as other programs write them: each is read as its writer meant it, to the last digit, or refused with a way out.
//!
//! `fixtures/foreign/make.py` writes the tables and the manifest, which has the numbers that the writers were given.

use std::collections::BTreeSet;
use std::fs;

use boundfit_exact::{DecimalMark, Limits, Rational, Reading, Thousands};
use boundfit_formats::{
    AskedBlock, AskedDialect, ColumnSelector, CommentMark, DELIMITERS, Encoding, Header, Missing,
    MissingWords, Source, TableOptions, Way, read_table,
};
use serde_json::Value;

use crate::program::root;

/// The texts of a list.
fn words(list: &Value) -> Vec<String> {
    list.as_array().unwrap().iter().map(|words| words.as_str().unwrap().to_owned()).collect()
}

/// Returns the options for a table beside its columns.
fn options(case: &Value) -> TableOptions {
    let text = |key: &str| case.get(key).map(|value| value.as_str().unwrap());
    let dialect = AskedDialect {
        encoding: text("encoding").map(|name| Encoding::named(name).unwrap()),
        delimiter: text("delimiter")
            .map(|name| DELIMITERS.into_iter().find(|(known, _)| *known == name).unwrap().1),
        decimal: text("decimal")
            .map(|name| DecimalMark::ALL.into_iter().find(|mark| mark.name() == name).unwrap()),
        thousands: text("thousands")
            .map(|mark| Thousands::ALL.into_iter().find(|known| known.mark() == mark).unwrap()),
        comment: text("comment").map_or(CommentMark::Auto, |mark| CommentMark::parse(mark).unwrap()),
        skip_lines: case.get("skip_lines").map_or(0, |lines| lines.as_u64().unwrap()),
        units_row: case.get("units_row").is_some(),
    };
    TableOptions {
        dialect,
        header: text("header").map_or(Header::Auto, |answer| {
            Header::ALL.into_iter().find(|header| header.name() == answer).unwrap()
        }),
        missing: text("missing").map_or(Missing::Refuse, |_| Missing::Skip),
        sheet: text("sheet").map(str::to_owned),
        block: text("block").map(|block| AskedBlock::parse(block).unwrap()),
        missing_as: MissingWords::new(case.get("missing_as").into_iter().flat_map(words)),
        ..TableOptions::default()
    }
}

/// Returns the fault in the reading of a table, if there is one.
fn fault(case: &Value) -> Option<String> {
    let text = |key: &str| case[key].as_str().unwrap();
    let path = root().join("fixtures/foreign").join(text("file"));
    let columns = ["x", "y"].map(|key| ColumnSelector::name_or_number(text(key)));
    let source = Source::open(path.to_str().unwrap()).unwrap();
    let read = read_table(source, &columns, &options(case));
    match (read, case.get("refused")) {
        (Ok(table), None) => {
            let number =
                |text: &Value| Reading::Decimal.read(text.as_str().unwrap(), &Limits::default()).unwrap();
            let rows = case["rows"].as_array().unwrap().iter();
            let expected: Vec<Vec<Rational>> =
                rows.map(|row| row.as_array().unwrap().iter().map(number).collect()).collect();
            let found: Vec<Vec<Rational>> = table.rows.into_iter().map(|row| row.numbers).collect();
            (found != expected).then(|| format!("read as {found:?}"))
        }
        (Ok(table), Some(_)) => Some(format!("read as {:?}", table.rows)),
        (Err(error), None) => Some(error.to_string()),
        (Err(error), Some(expected)) => {
            let way = |way: Way| format!("{} {} {}", way.setting.name(), way.value, way.effect);
            let ways: Vec<String> = error.ways().into_iter().map(way).collect();
            let message = format!("{error}; {}", ways.join(", "));
            let lacking: Vec<String> =
                words(expected).into_iter().filter(|words| !message.contains(words)).collect();
            (!lacking.is_empty()).then(|| format!("{message}, without {lacking:?}"))
        }
    }
}

/// Checks all tables but those that are for a build with the feature `arrow`, or for one without it.
pub fn check(has_arrow: bool) {
    let manifest = fs::read_to_string(root().join("fixtures/foreign/manifest.json")).unwrap();
    let cases: Vec<Value> = serde_json::from_str(&manifest).unwrap();
    let files: BTreeSet<&str> = cases.iter().map(|case| case["file"].as_str().unwrap()).collect();
    assert!(files.len() >= 150, "{} files", files.len());
    let is_for_here = |case: &&Value| match (case.get("feature"), case.get("without")) {
        (Some(_), _) => has_arrow,
        (_, Some(_)) => !has_arrow,
        _ => true,
    };
    let faults: Vec<String> = cases
        .iter()
        .filter(is_for_here)
        .filter_map(|case| fault(case).map(|fault| format!("{case}: {fault}")))
        .collect();
    assert!(faults.is_empty(), "{} of {} cases:\n{}", faults.len(), cases.len(), faults.join("\n"));
}
