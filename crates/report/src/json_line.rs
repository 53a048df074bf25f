//! JSON on one line, for answers of which there are many. Serde writes the same bytes in twice the time, because it looks for
//! characters to escape in each key and each digit. Tests compare both.

use std::borrow::Cow;
use std::fmt;

use boundfit_exact::Foreign;

use crate::answer::input::LineInputJson;
use crate::answer::parts::{
    BoundJson, CentralJson, CertificateJson, EndJson, FeasibleSetJson, IntervalJson, LeastSquaresJson,
    RangeJson, TermJson,
};
use crate::answer::table::TableJson;
use crate::answer::window::{GroupJson, GroupSetJson, WindowJson};
use crate::number::{Number, Reader};

/// A part of an answer that is written without blanks.
pub(crate) trait JsonLine {
    /// Appends the JSON that serde writes.
    fn write(&self, text: &mut Vec<u8>);
}

/// Parts that serde writes.
macro_rules! by_serde {
    ($($part:ty),*) => {$(
        impl JsonLine for $part {
            fn write(&self, text: &mut Vec<u8>) {
                // They hold strings, numbers and lists only, and memory takes whatever is written.
                serde_json::to_writer(text, self).expect("a part of an answer that is not JSON");
            }
        }
    )*};
}

by_serde!(bool, f64, usize, &str, Cow<'_, str>, Foreign<&str>);

/// The input that all lines have in common.
#[derive(Debug)]
pub struct LineInput {
    table: Option<TableJson>,
    written: String,
}

impl LineInput {
    /// A table that was taken for this, if it is one.
    pub fn new(table: Option<TableJson>) -> Self {
        let json = LineInputJson { table: table.as_ref(), written: "" };
        // As above.
        let written = serde_json::to_string(&json).expect("a table that is not JSON");
        LineInput { table, written }
    }

    pub(crate) fn json(&self) -> LineInputJson<'_> {
        LineInputJson { table: self.table.as_ref(), written: &self.written }
    }
}

impl JsonLine for LineInputJson<'_> {
    fn write(&self, text: &mut Vec<u8>) {
        text.extend_from_slice(self.written.as_bytes());
    }
}

/// Objects with these fields, which must be all that there are.
macro_rules! objects {
    ($($object:ident$(<$lifetime:lifetime>)? { $first:ident $(, $field:ident)* })*) => {$(
        impl JsonLine for $object$(<$lifetime>)? {
            fn write(&self, text: &mut Vec<u8>) {
                let $object { $first $(, $field)* } = self;
                text.extend_from_slice(concat!("{\"", stringify!($first), "\":").as_bytes());
                $first.write(text);
                $(
                    text.extend_from_slice(concat!(",\"", stringify!($field), "\":").as_bytes());
                    $field.write(text);
                )*
                text.push(b'}');
            }
        }
    )*};
}

objects! {
    CentralJson { theta, guaranteed_error }
    CertificateJson { farkas }
    FeasibleSetJson { kind, certificate }
    GroupJson<'_> {
        schema, input, group, rows, first_row, least_squares, eui, fps, pui, central, epsilon_min, epsilon_factor
    }
    GroupSetJson { kind, vertex_count, certificate }
    IntervalJson { lower, upper }
    LeastSquaresJson { theta, in_fps, guaranteed_error }
    RangeJson { lower, upper }
    TermJson { row, bound, multiplier }
    WindowJson<'_> { schema, input, first_row, last_row, rows, x, fps, pui, central, epsilon_min }
}

impl<T: JsonLine> JsonLine for Option<T> {
    fn write(&self, text: &mut Vec<u8>) {
        match self {
            Some(part) => part.write(text),
            None => text.extend_from_slice(b"null"),
        }
    }
}

impl<T: JsonLine> JsonLine for [T] {
    fn write(&self, text: &mut Vec<u8>) {
        text.push(b'[');
        for (position, part) in self.iter().enumerate() {
            if position > 0 {
                text.push(b',');
            }
            part.write(text);
        }
        text.push(b']');
    }
}

impl<T: JsonLine, const N: usize> JsonLine for [T; N] {
    fn write(&self, text: &mut Vec<u8>) {
        self.as_slice().write(text);
    }
}

impl<T: JsonLine> JsonLine for Vec<T> {
    fn write(&self, text: &mut Vec<u8>) {
        self.as_slice().write(text);
    }
}

/// The forms of the end and its proof are fields of one object.
impl JsonLine for BoundJson {
    fn write(&self, text: &mut Vec<u8>) {
        let BoundJson { end, active } = self;
        text.push(b'{');
        match end {
            EndJson::Bounded(number) => write_forms(number, text),
            EndJson::Unbounded(Reader::Program) => {
                text.extend_from_slice(br#""exact":null,"decimal":null,"value":null,"outward":null"#);
            }
            EndJson::Unbounded(Reader::Person) => text.extend_from_slice(br#""exact":null,"decimal":null"#),
        }
        text.extend_from_slice(br#","active":"#);
        active.write(text);
        text.push(b'}');
    }
}

impl JsonLine for Number {
    fn write(&self, text: &mut Vec<u8>) {
        text.push(b'{');
        write_forms(self, text);
        text.push(b'}');
    }
}

/// Appends the fields of a number.
fn write_forms(number: &Number, text: &mut Vec<u8>) {
    text.extend_from_slice(br#""exact":"#);
    match number.exact() {
        Some(value) => write_digits(text, |text| value.write_to(text)),
        None => text.extend_from_slice(b"null"),
    }
    text.extend_from_slice(br#","decimal":"#);
    write_digits(text, |text| number.write_decimal(text));
    if let Some((value, outward)) = number.doubles() {
        text.extend_from_slice(br#","value":"#);
        value.write(text);
        if let Some(outward) = outward {
            text.extend_from_slice(br#","outward":"#);
            outward.write(text);
        }
    }
}

/// Appends a string without a character that JSON escapes.
fn write_digits(text: &mut Vec<u8>, write: impl FnOnce(&mut Text<'_>) -> fmt::Result) {
    text.push(b'"');
    // Memory takes whatever is written.
    write(&mut Text(text)).expect("digits that memory does not take");
    text.push(b'"');
}

/// Text in UTF-8 that grows.
struct Text<'a>(&'a mut Vec<u8>);

impl fmt::Write for Text<'_> {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        self.0.extend_from_slice(part.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use boundfit_estimation::{GroupAnswer, Question};
    use boundfit_exact::{Rational, Reading};
    use boundfit_formats::{ColumnSelector, Source};
    use serde::Serialize;

    use super::*;
    use crate::fleet_json::group_json;
    use crate::style::Style;

    fn compare(answer: &(impl JsonLine + Serialize)) -> String {
        let mut text = Vec::new();
        answer.write(&mut text);
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text, serde_json::to_string(answer).unwrap());
        text
    }

    #[test]
    fn lines_are_those_of_serde() {
        let mut lines = String::new();
        for (rows, epsilon) in [
            // A polygon, a point, a segment, an empty set, two strips; and numbers of many digits, also beyond the largest double.
            ("0,0\n1,1.5\n2,2\n", "0.5"),
            ("0,0\n1,1\n2,2\n", "0"),
            ("0,0\n1,1\n2,1\n2,3", "1"),
            ("0,0\n1,9\n2,0\n", "0.5"),
            ("1,7\n", "1/3"),
            ("0,7\n", "1/3"),
            ("0.1234567890123456789,1\n-7,-1.5e-25\n9.75,3", "2"),
            ("0,0\n1e-9,1e400\n", "1"),
        ] {
            let table = format!("x,y\n{rows}");
            let [x, y] = ["x", "y"].map(ColumnSelector::name_or_number);
            let question = Question::line(x, Some(y)).within(epsilon, Reading::Decimal).unwrap();
            let source = Source::new("readings.csv", Cursor::new(table.into_bytes()));
            let problem = question.problem(source, &Default::default(), Default::default()).unwrap();
            let answer = GroupAnswer::of(&problem, &problem.fit());
            let input = LineInput::new(TableJson::of_measurements(&problem.measurements));
            for reader in [Reader::Program, Reader::Person] {
                let style = Style { reader, ..Style::default() };
                let group = group_json(Foreign::of("a \"\n\u{e9}"), &answer, &input, &style);
                lines += &compare(&group);
                lines += &compare(&WindowJson {
                    schema: WindowJson::SCHEMA,
                    input: group.input,
                    first_row: 1,
                    last_row: 7,
                    rows: 3,
                    x: Some(style.numbers(&[Rational::ratio(-1, 3), Rational::one()])),
                    fps: FeasibleSetJson { kind: group.fps.kind, certificate: group.fps.certificate },
                    pui: group.pui,
                    central: group.central,
                    epsilon_min: group.epsilon_min,
                });
            }
        }
        for part in
            [r#""value":null"#, r#""exact":null"#, r#""farkas":[{"#, r#""pui":null"#, r#""active":[]"#]
        {
            assert!(lines.contains(part), "{part}");
        }
    }
}
