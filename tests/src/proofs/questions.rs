//! The questions that are proved: published data, every kind of set, text in every form, and generated fits.

use std::fmt::Write;
use std::fs;

use boundfit_estimation::{AskedBound, EpsilonColumn, ErrorBound, LineForm};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::ColumnSelector;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use super::Question;
use crate::generate::half_planes;
use crate::program::root;
use crate::readings::{problem, y_and_epsilon};
use crate::tables::TableKind;

/// Fits of the published data, of every kind of set, and of text in every form that is accepted.
///
/// # Panics
/// When a fixture is missing.
pub fn questions() -> Vec<Question> {
    let file = |path: &str| fs::read(root().join("fixtures").join(path)).expect(path);
    let (transducer, steam) =
        (file("transducer/transducer.csv"), file("steam-generator/steam_generator.csv"));
    let interval = Question::line("transducer", &transducer, ["Vz", "z"], "0.5e-3").rows(14, 36);
    let steam = Question::line("steam generator", &steam, ["x", "y"], "0").epsilon_column("eps");
    let norris = Question::line("norris", &file("norris/norris.csv"), ["x", "y"], "1");
    let mut questions = vec![
        interval.clone(),
        interval.clone().reading(Reading::Binary64),
        Question::line("transducer, all rows", &transducer, ["Vz", "z"], "0.5"),
        interval.when(&["2*theta1 - theta2 <= 1/3", "theta1 >= 0"]),
        steam.clone(),
        steam.clone().when(&["theta1 >= 0"]),
        steam.when(&["theta1 >= 11", "theta2 <= -20"]).reading(Reading::Binary64),
        norris.clone(),
        Question { epsilon: Ok(Rational::from(3)), ..norris },
    ];
    for entry in fs::read_dir(root().join("fixtures/hard-lp")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|extension| extension == "csv") {
            let case = fs::read_to_string(path.with_extension("json")).expect("its error bound");
            let case: Value = serde_json::from_str(&case).expect("JSON");
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            let data = fs::read(&path).expect("a file");
            let epsilon = case["eps"].as_str().expect("a bound");
            questions.push(Question::line(&name, &data, ["x", "y"], epsilon));
            questions.push(Question::line(&name, &data, ["x", "y"], epsilon).reading(Reading::Binary64));
        }
    }
    questions.sort_by(|one, other| one.name.cmp(&other.name));
    questions.extend(golden());
    questions.extend(kinds());
    questions.extend(texts());
    questions
}

fn golden() -> Vec<Question> {
    let text = fs::read_to_string(root().join("fixtures/golden/golden.json")).expect("a fixture");
    let golden: Value = serde_json::from_str(&text).expect("JSON");
    let question = |case: &Value| {
        let text = |value: &Value| value.as_str().expect("a text").to_owned();
        let cells = |name: &str| case[name].as_array().expect("a list").iter().map(text).collect::<Vec<_>>();
        let mut csv = "x,y\n".to_owned();
        for (x, y) in cells("x").iter().zip(cells("y")) {
            let _ = writeln!(csv, "{x},{y}");
        }
        Question::line(&text(&case["name"]), csv.as_bytes(), ["x", "y"], &text(&case["eps"]))
    };
    golden["cases"].as_array().expect("cases").iter().map(question).collect()
}

/// Sets of all ten kinds, most of them in several ways.
fn kinds() -> Vec<Question> {
    let line =
        |name: &str, csv: &str, epsilon: &str| Question::line(name, csv.as_bytes(), ["x", "y"], epsilon);
    let zero = |name: &str, epsilon: &str| {
        Question::line(name, b"a,b,y\n0,0,0\n", ["a", "y"], epsilon).regressors(["a", "b"])
    };
    vec![
        line("polygon", "x,y\n0.5,1.02\n1,1.97\n1.5,3.05\n2,3.98\n2.5,5.01\n", "0.1"),
        Question::line(
            "polygon of two regressors",
            b"a,b,y\n1,0,3\n0,1,2\n1,1,6\n0,0,0\n",
            ["a", "y"],
            "3/2",
        )
        .regressors(["a", "b"]),
        line("polygon with a row that touches", "x,y\n0,0\n1,0\n-1,0\n0,1\n1,1\n-1,1\n0,0\n", "1"),
        line("triangle", "x,y\n1,0\n", "1").when(&["theta1 >= 0", "theta2 >= 0"]),
        line("strip", "x,y\n5,2\n5,2.5\n5,1.5\n", "1"),
        line("line", "x,y\n5,2\n5,4\n", "1"),
        line("point", "x,y\n1,2\n2,3\n4,5\n", "0"),
        line("point of three half-planes", "x,y\n1,2\n", "1").when(&[
            "theta1 <= 1",
            "theta2 <= 0",
            "theta1 + theta2 >= 1",
        ]),
        line("segment", "x,y,eps\n1,2,0\n2,3,1\n3,4,5\n", "0").epsilon_column("eps"),
        line("ray", "x,y\n1,2\n", "0").when(&["theta1 >= 0"]),
        line("segment of an equation", "x,y\n1,1\n2,2.5\n", "1").when(&["theta2 = 0"]),
        line("point of two equations", "x,y\n1,2\n", "1").when(&["theta1 = 2", "2*theta2 == theta1 - 2"]),
        line("line of an equation", "x,y\n0,2\n", "3").when(&["theta2 = 1/3"]),
        line("ray of an equation", "x,y\n0,2\n", "3").when(&["theta1 >= 1", "theta1 = theta2"]),
        line("polygon beside an equation of nothing", "x,y\n1,2\n2,3\n", "1").when(&["0*theta1 = 0"]),
        line("empty by an equation alone", "x,y\n1,2\n", "1").when(&["theta1 >= 0", "0*theta1 = 1"]),
        line("empty by an equation and two rows", "x,y\n1,2\n2,3\n", "1/8").when(&["theta2 = 0"]),
        line("empty by two equations", "x,y\n1,2\n", "1").when(&["theta2 = 0", "theta2 = 1"]),
        line("half-strip", "x,y\n1,2\n", "1").when(&["theta1 >= 0"]),
        zero("wedge", "1").when(&["theta1 >= 0", "theta1 + theta2 >= 1"]),
        zero("three sides and a gap", "1").when(&["theta1 >= 0", "theta2 >= 0", "theta1 + theta2 >= 1"]),
        zero("half-plane", "1").when(&["2*theta1 - theta2 <= 1"]),
        zero("half-plane along an axis", "1").when(&["theta1 <= 1", "2*theta1 <= 2"]),
        zero("plane", "0").when(&["0*theta1 <= 0"]),
        Question::line("empty by a row alone", b"a,b,y\n0,0,5\n", ["a", "y"], "1").regressors(["a", "b"]),
        line("empty by two rows", "x,y\n3,1\n3,2\n", "1/3"),
        line("empty by three rows", "x,y,eps\n1,0,1\n2,9,1/2\n3,0,1/4\n", "0").epsilon_column("eps"),
        line("empty by conditions", "x,y\n1,2\n", "1").when(&["theta1 >= 1", "theta1 <= 0"]),
    ]
}

/// Fits between columns of bounds, under laws, from another origin and through the origin.
///
/// # Panics
/// When a law cannot be read.
pub fn bounded() -> Vec<Question> {
    let law = |text: &str| match AskedBound::parse(text, Reading::Decimal, &Limits::default()) {
        Ok(AskedBound::Law(law)) => EpsilonColumn::Law(*law),
        other => panic!("{text}: {other:?}"),
    };
    let column = |name: &str| Some(ColumnSelector::name_or_number(name));
    let between = |lower: Option<&str>, upper: Option<&str>| EpsilonColumn::Interval {
        lower: lower.and_then(column),
        upper: upper.and_then(column),
    };
    let table = "x,y,lo,up\n1,2.10,1.5,2.5\n2,3.0,NA,3.25\n4,4.75,4,\n5,6.5e0,5.5,7/1\n";
    // A question with one column alone needs a bound in every cell.
    let whole = table.replace("NA", "-1").replace("4,\n", "4,1e1\n");
    let line = |name: &str| Question::line(name, table.as_bytes(), ["x", "y"], "0");
    let whole = |name: &str| Question::line(name, whole.as_bytes(), ["x", "y"], "0");
    let origin = LineForm { x_origin: Rational::ratio(7, 2), through_origin: false };
    let mut bounded = vec![
        line("between columns").within(between(Some("lo"), Some("up"))),
        whole("above a column").within(between(Some("lo"), None)),
        whole("below a column").within(between(None, Some("up"))).when(&["theta1 >= -5"]),
        line("written and a share of y").within(law("10%*|y| + 3*written + 0.1")),
        line("more above than below").within(law("+0.5/-5%*|x|")).when(&["theta2 = 1"]),
        line("a share of the range").within(law("5%*range(y) + written")),
        Question { form: origin.clone(), ..line("from another origin").within(law("1/3 + 1%*|y|")) },
        Question {
            epsilon: Ok(Rational::ratio(1, 2)),
            form: origin,
            ..line("from another origin, one bound")
        },
    ];
    let through_origin = LineForm { through_origin: true, ..LineForm::default() };
    bounded.push(Question {
        form: through_origin,
        epsilon: Ok(Rational::from(2)),
        ..line("through the origin")
    });
    bounded
}

/// One table in every form that is accepted.
fn texts() -> Vec<Question> {
    let line =
        |name: &str, text: &str, columns: [&str; 2]| Question::line(name, text.as_bytes(), columns, "1/2");
    let tall: String = (0..30).fold("x,y\n".to_owned(), |text, x| text + &format!("{x},{}\n", 2 * x % 7));
    vec![
        line("quotes", "\"x\",\"say \"\"y\"\"\",\"a,b\"\n\"1\",\"2\",\"p\nq\"\n2,\"3\",\"\"\n", ["x", "2"]),
        line("semicolons", "x;y;z\n1;2;1\n2;3,5;2\n\n3;4;3\n", ["x", "3"]),
        line("tabs without a header", "1\t2\n2\t3\n3\t4", ["1", "2"]),
        line(
            "CRLF, blank lines and a byte order mark",
            "\u{feff}x,y\r\n\r\n1,2\r\n  \r\n2,3\r\n",
            ["x", "y"],
        ),
        line("CR", "x,y\r1,2\r2,3\r\r3,4", ["x", "y"]),
        line("a quote within a cell", "x,y,z\n1,2,5\"\n2,3,\"6\"\"\"\n3,40,\"4\"0\n", ["x", "y"]),
        line(
            "quotes and delimiters within quotes",
            "x,note,y\n1,\"say \"\"a, b\"\"\",2\n2,5\" pipe,3\n3,\"\n,\",4\n",
            ["x", "y"],
        ),
        line("a row of blank cells is a row", "x,y\n,\n1,2\n2,3\n", ["x", "y"]).rows(2, 3),
        line("spaces, signs and fractions", "x,y\n +1 , 2e0\n-.5,\t7/3\n1.,0.250\n", ["x", "y"]),
        line("a blank cell in quotes is a blank line", "x,y\n1,2\n\"\"\n\" \"\n2,3\n", ["x", "y"]),
        Question::line("many ties", tall.as_bytes(), ["x", "y"], "20"),
    ]
}

/// A generated fit: degenerate more often than not.
pub fn generated(rng: &mut ChaCha8Rng) -> Question {
    if rng.random_bool(0.3) {
        let kind = TableKind::ALL[rng.random_range(0..TableKind::ALL.len())];
        let count = rng.random_range(1..=30);
        let rows = kind.rows(rng, count);
        let text = rows.iter().fold("x,y\n".to_owned(), |text, [x, y]| text + &format!("{x},{y}\n"));
        let epsilon = ["0", "1/2", "2", "1000"][rng.random_range(0..4)];
        return Question::line(&format!("{kind:?}"), text.as_bytes(), ["x", "y"], epsilon);
    }
    if rng.random_bool(0.3) {
        let condition = |&[a1, a2, b]: &[i128; 3]| {
            format!("{a1}*theta1 {} {}*theta2 <= {b}", if a2 < 0 { '-' } else { '+' }, a2.abs())
        };
        let conditions = half_planes(rng).iter().map(condition).collect();
        let question =
            Question::line("half-planes", b"u,v,y\n0,0,0\n", ["u", "y"], "1").regressors(["u", "v"]);
        return Question { conditions, ..question };
    }
    let problem = problem(rng);
    let mut text = "u,v,y,eps\n".to_owned();
    for row in problem.measurements.kept() {
        let ([u, v], (response, epsilon)) = (&row.regressor, y_and_epsilon(row));
        let _ = writeln!(text, "{u},{v},{response},{epsilon}");
    }
    let question = Question {
        conditions: problem.conditions.iter().map(|condition| condition.text().raw().to_owned()).collect(),
        ..Question::line("generated", text.as_bytes(), ["u", "y"], "0").regressors(["u", "v"])
    };
    match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => Question { epsilon: Ok(epsilon.clone()), ..question },
        ErrorBound::Column(column) => question.epsilon_column(column.raw()),
        ErrorBound::Interval { .. } | ErrorBound::Law(_) => question,
    }
}
