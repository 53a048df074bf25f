//! The cells of a lesson: readings as they are written in the file.

use boundfit_estimation::{Columns, EpsilonColumn, Law, LineForm, Measurements, Problem};
use boundfit_exact::{Limits, Reading, Thousands};
use boundfit_formats::{AskedDialect, ColumnSelector, RowRange, Source, TableOptions};
use boundfit_tests::program::root;
use serde_json::{Value, json};

use crate::document::Lesson;

/// A lesson about a table whose cells are kept.
fn lesson(source: Source, [x, y]: [&str; 2], epsilon: EpsilonColumn, table: TableOptions) -> Value {
    let column = ColumnSelector::name_or_number;
    let columns = Columns {
        first: column(x),
        second: None,
        response: Some(column(y)),
        epsilon,
        form: LineForm::default(),
    };
    let options = TableOptions { keep_others: true, keep_cells: true, ..table };
    let measurements = Measurements::read(source, &columns, &options).unwrap();
    Lesson::of(x, Problem { measurements, conditions: Vec::new() }).data
}

fn law(text: &str) -> EpsilonColumn {
    EpsilonColumn::Law(Law::parse(text, Reading::Decimal, &Limits::default()).unwrap())
}

fn cells(readings: &Value) -> Vec<Value> {
    readings.as_array().unwrap().iter().map(|reading| reading["cells"].clone()).collect()
}

#[test]
fn cells_keep_zeros_and_commas_and_the_law_about_them_stays_a_law() {
    let path = root().join("fixtures/lesson/trailing-zeros.tsv");
    let source = Source::open(path.to_str().unwrap()).unwrap();
    let table = TableOptions { rows: RowRange::new(2, 4).into(), ..TableOptions::default() };
    let data = lesson(source, ["U", "I"], law("written"), table);
    assert_eq!(
        cells(&data["readings"]),
        [json!(["1,00", "2,10"]), json!(["1,50", "3,00"]), json!(["2,00", "4,10"])]
    );
    assert_eq!(cells(&data["others"]), [json!(["0,50", "1,00"])]);
    let asked = &data["asked"];
    assert_eq!([&asked["eps"], &asked["decimal"], &asked["delimiter"]], ["written", "comma", "semicolon"]);
    assert_eq!(data["readings"][0]["epsilon"]["exact"], "1/200");
}

#[test]
fn fractions_stay_digits_are_not_grouped_and_missing_bounds_are_empty() {
    let text = "x;y;low;high\n1.000,50;2/4;0,10;NA\n2.000;1;;1,5\n";
    let dialect = AskedDialect { thousands: Some(Thousands::Point), ..AskedDialect::default() };
    let side = |name: &str| Some(ColumnSelector::name_or_number(name));
    let epsilon = EpsilonColumn::Interval { lower: side("low"), upper: side("high") };
    let source = Source::new("bounds.csv", text.as_bytes());
    let data = lesson(source, ["x", "y"], epsilon, TableOptions { dialect, ..TableOptions::default() });
    assert_eq!(
        cells(&data["readings"]),
        [json!(["1000,50", "2/4", "0,10", ""]), json!(["2000", "1", "", "1,5"])]
    );
}

#[test]
fn where_no_cells_are_kept_the_law_about_digits_is_a_column() {
    let source = Source::new("plain.csv", "x,y\n1,2.0\n2,3.10\n".as_bytes());
    let column = ColumnSelector::name_or_number;
    let columns = Columns {
        first: column("x"),
        second: None,
        response: Some(column("y")),
        epsilon: law("written"),
        form: LineForm::default(),
    };
    let measurements = Measurements::read(source, &columns, &TableOptions::default()).unwrap();
    let data = Lesson::of("plain", Problem { measurements, conditions: Vec::new() }).data;
    assert_eq!(cells(&data["readings"]), [Value::Null, Value::Null]);
    assert_eq!((&data["asked"]["eps"], &data["asked"]["eps_column"]), (&Value::Null, &json!("written")));
}
