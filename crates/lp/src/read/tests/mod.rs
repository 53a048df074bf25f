//! The results of the readers, and their messages about refused texts.

mod lp_format;
mod mps;

use super::*;
use crate::model::{Bounds, ModelColumn, ModelRow, ObjectiveSense};
use boundfit_exact::{Foreign, Limit, Rational, Reading};

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// Bounds from texts; `-` for none.
fn bounds(lower: &str, upper: &str) -> Bounds {
    let bound = |text: &str| (text != "-").then(|| number(text));
    Bounds { lower: bound(lower), upper: bound(upper) }
}

fn read_once(text: &str, format: ExchangeFormat) -> Model {
    read_model(text, format, &ModelLimits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Reads a text; what it states is written in both formats and read again.
fn read(text: &str, format: ExchangeFormat) -> Model {
    let model = read_once(text, format);
    for format in ExchangeFormat::ALL {
        let written = model.text(format);
        let is_the_same = !["multiplied", " are those of "].iter().any(|remark| written.contains(remark));
        if is_the_same {
            assert_eq!(without_names(&read_once(&written, format)), without_names(&model), "{written}");
        }
    }
    model
}

/// The program with names after places: not every name is one in every format.
fn without_names(model: &Model) -> Model {
    let mut model = model.clone();
    model.name = Foreign::default();
    model.objective_name = Foreign::default();
    model.columns.iter_mut().enumerate().for_each(|(place, column)| column.name = place.to_string().into());
    model.rows.iter_mut().enumerate().for_each(|(place, row)| row.name = place.to_string().into());
    model
}

fn message(text: &str, format: ExchangeFormat) -> String {
    read_model(text, format, &ModelLimits::default()).expect_err(text).to_string()
}

#[test]
fn formats_are_written_as_solvers_read_them() {
    let lp = "\
max obj: 0.1 x - y + 0 z + 5/2
st
 r1: -1.5 <= x + 2 y <= 1e3
 free: x - y = 0.25
 empty: 0 z >= -1e30
 e5: 1/3 x <= 1/2
 crossed: 2 <= y <= 1
bounds
 x <= -1
 -3 <= y <= 2
 z = 0
end";
    let model = read(lp, ExchangeFormat::Lp);
    let mps = "\
* crossed: its bounds, which leave no value, are those of two rows
* e5 is multiplied by 6: its numbers have no finite decimals
NAME
OBJSENSE
    MAX
ROWS
 N obj
 G r1
 E free
 G empty
 L e5
 G crossed
 L crossed_upper
COLUMNS
 x obj 0.1
 x r1 1
 x free 1
 x e5 2
 y obj -1
 y r1 2
 y free -1
 y crossed 1
 y crossed_upper 1
 z obj 0
RHS
 RHS obj -2.5
 RHS r1 -1.5
 RHS free 0.25
 RHS empty -1e30
 RHS e5 3
 RHS crossed 2
 RHS crossed_upper 1
RANGES
 RANGE r1 1001.5
BOUNDS
 LO BOUND x 0
 UP BOUND x -1
 LO BOUND y -3
 UP BOUND y 2
 FX BOUND z 0
ENDATA
";
    assert_eq!(model.text(ExchangeFormat::Mps), mps);
    let written = "\
\\ row3 is the row \"free\"
\\ row5 is the row \"e5\"
\\ row5 is multiplied by 6: its numbers have no finite decimals
Maximize
 obj: 0.1 x - 1 y + 0 z + 2.5
Subject To
 r1: -1.5 <= 1 x + 2 y <= 1000
 row3: 1 x - 1 y = 0.25
 empty: 0 x + 0 y >= -1e30
 row5: 2 x <= 3
 crossed: 2 <= 1 y <= 1
Bounds
 0 <= x <= -1
 -3 <= y <= 2
 z = 0
End
";
    assert_eq!(model.text(ExchangeFormat::Lp), written);
    // A bound without a decimal is that of a row.
    let model = read("min x bounds 1/3 <= x <= 1/2 end", ExchangeFormat::Lp);
    let written = "\
\\ x: its bounds are those of the row bound_x
\\ bound_x is multiplied by 6: its numbers have no finite decimals
Minimize
 obj: 1 x
Subject To
 bound_x: 2 <= 6 x <= 3
Bounds
 x free
End
";
    assert_eq!(model.text(ExchangeFormat::Lp), written);
    // A bound that readers would take for infinite.
    let far = ModelRow {
        bounds: bounds("-3e30", "1"),
        coefficients: vec![(0, number("4e30"))],
        name: "far".into(),
    };
    let column = ModelColumn { name: "x".into(), cost: Rational::one(), bounds: bounds("-1e35", "-") };
    let model = Model { columns: vec![column], rows: vec![far], ..Model::default() };
    let written = "\
\\ x: its bounds are those of the row bound_x
\\ far is multiplied by 0.1: a bound would be taken for infinite
\\ bound_x is multiplied by 1e-6: a bound would be taken for infinite
Minimize
 obj: 1 x
Subject To
 far: -3e29 <= 4e29 x <= 0.1
 bound_x: 1e-6 x >= -1e29
Bounds
 x free
End
";
    assert_eq!(model.text(ExchangeFormat::Lp), written);
    // Names that are there already, and long lines.
    let column =
        |name: &str| ModelColumn { name: name.into(), cost: Rational::one(), bounds: bounds("0", "-") };
    let names = ["x", "x", "column2", "", "a b", "\u{e9}", "e1", "3x", "-"];
    let model = Model { columns: names.map(column).to_vec(), ..Model::default() };
    let written = model.text(ExchangeFormat::Lp);
    assert!(
        written.contains("obj: 1 x + 1 column2_ + 1 column2 + 1 column4 + 1 column5 + 1 \u{e9} + 1 column7"),
        "{written}"
    );
    assert!(written.contains("\\ column5 is the column \"a b\"\n"), "{written}");
    let long = "x".repeat(300);
    let model = Model { columns: [&long, "y", "z"].map(column).to_vec(), ..Model::default() };
    let twice = Model { columns: [&long, "y", &format!("{long}z")].map(column).to_vec(), ..Model::default() };
    assert!(model.text(ExchangeFormat::Lp).contains("+ 1 y + 1 z\n"));
    assert!(twice.text(ExchangeFormat::Lp).contains("\n  + 1 y\n  + 1 xxx"));
    assert_eq!(
        without_names(&read_once(&twice.text(ExchangeFormat::Lp), ExchangeFormat::Lp)),
        without_names(&twice)
    );
}

#[test]
fn bytes_that_are_no_text_are_refused_with_their_place() {
    let message = |bytes: &[u8]| model_text(bytes).unwrap_err().to_string();
    assert_eq!(
        message(b"NAME\nRO\xff"),
        "line 2, column 3: \"RO\": no valid UTF-8 behind this (expected text in UTF-8)"
    );
    assert_eq!(message(b"\xff\xfeN\0"), "the text is UTF-16 (expected text in UTF-8)");
    assert_eq!(model_text("\u{e9}".as_bytes()), Ok("\u{e9}"));
}
