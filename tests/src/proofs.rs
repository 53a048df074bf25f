//! Proofs of fits, made and judged without the program: what the tests of both checkers share.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::io::Cursor;

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, ErrorBound, Fit, Measurement, Measurements, Problem, fit,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Header, InputError, RowRange, Source, TableOptions};
use boundfit_geometry::{Inequality, Polyhedron, System};
use boundfit_report::proof_json;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::generate::half_planes;
use crate::program::root;
use crate::readings::{parse_condition, problem};
use crate::tables::TableKind;

/// Data and how they are to be fitted.
#[derive(Debug, Clone)]
pub struct Question {
    /// What it is about.
    pub name: String,
    /// The bytes of the file.
    pub data: Vec<u8>,
    /// Names or numbers of the regressors' columns.
    pub x: Vec<String>,
    /// That of the response.
    pub y: String,
    /// The error bound, or else its column.
    pub epsilon: Result<Rational, String>,
    /// Conditions as text.
    pub conditions: Vec<String>,
    /// How the table is read.
    pub options: TableOptions,
}

impl Question {
    /// A line through two columns under an error bound.
    ///
    /// # Panics
    /// When the bound is no number.
    pub fn line(name: &str, data: &[u8], [x, y]: [&str; 2], epsilon: &str) -> Self {
        Question {
            name: name.to_owned(),
            data: data.to_vec(),
            x: vec![x.to_owned()],
            y: y.to_owned(),
            epsilon: Ok(Reading::Decimal.read(epsilon, &Limits::default()).expect("a number")),
            conditions: Vec::new(),
            options: TableOptions::default(),
        }
    }

    /// The same with two regressors.
    pub fn regressors(self, x: [&str; 2]) -> Self {
        Question { x: x.map(ToOwned::to_owned).to_vec(), ..self }
    }

    /// The same with an error bound per row.
    pub fn epsilon_column(self, column: &str) -> Self {
        Question { epsilon: Err(column.to_owned()), ..self }
    }

    /// The same under conditions.
    pub fn when(self, conditions: &[&str]) -> Self {
        Question { conditions: conditions.iter().map(|&text| text.to_owned()).collect(), ..self }
    }

    /// The same of some rows.
    pub fn rows(self, first: usize, last: usize) -> Self {
        let options = TableOptions { rows: RowRange::new(first, last), ..self.options };
        Question { options, ..self }
    }

    /// The same with numbers read in another way.
    pub fn reading(self, reading: Reading) -> Self {
        Question { options: TableOptions { reading, ..self.options }, ..self }
    }

    /// What is to be fitted.
    ///
    /// # Errors
    /// When the data cannot be read so.
    pub fn problem(&self) -> Result<Problem, InputError> {
        let column = |name: &String| ColumnSelector::name_or_number(name);
        let columns = Columns {
            first: column(&self.x[0]),
            second: self.x.get(1).map(column),
            response: column(&self.y),
            epsilon: match &self.epsilon {
                Ok(epsilon) => EpsilonColumn::Uniform(epsilon.clone()),
                Err(name) => EpsilonColumn::Column(column(name)),
            },
        };
        let source = Source::new("data", Cursor::new(self.data.clone()));
        let measurements = Measurements::read(source, &columns, &self.options)?;
        let conditions: Vec<Condition> = self.conditions.iter().map(|text| parse_condition(text)).collect();
        Ok(Problem { measurements, conditions })
    }

    /// The proof of the fit.
    ///
    /// # Panics
    /// When the data cannot be read.
    pub fn proof(&self) -> String {
        let problem = self.problem().unwrap_or_else(|error| panic!("{}: {error}", self.name));
        proof_json(&problem, &fit(&problem), self.options.reading).expect("delimited text")
    }
}

/// SHA-256 in hexadecimal.
pub fn sha256(data: &[u8]) -> String {
    Sha256::digest(data).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The exit status that the checker in Rust stands for: 0 true, 4 false, 1 no proof.
pub fn verdict(proof: &str, data: &[u8]) -> i32 {
    let value: Value = serde_json::from_str(proof).expect("JSON");
    match serde_json::from_str::<boundfit_verify::Proof>(proof) {
        Err(_) => 1,
        Ok(_) if value["schema"] != "boundfit/proof/1" => 1,
        Ok(proof) => proof.verify(data, &sha256(data), &Limits::default()).map_or(4, |_| 0),
    }
}

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

/// One table in every form that is accepted.
fn texts() -> Vec<Question> {
    let line =
        |name: &str, text: &str, columns: [&str; 2]| Question::line(name, text.as_bytes(), columns, "1/2");
    let tall: String = (0..30).fold("x,y\n".to_owned(), |text, x| text + &format!("{x},{}\n", 2 * x % 7));
    vec![
        line("quotes", "\"x\",\"say \"\"y\"\"\",\"a,b\"\n\"1\",\"2\",\"p\nq\"\n2,\"3\",\"\"\n", ["x", "2"]),
        line("semicolons", "x;y\n1;2\n2;3,5\n\n3;4\n", ["x", "1"]),
        line("tabs without a header", "1\t2\n2\t3\n3\t4", ["1", "2"]),
        line(
            "CRLF, blank lines and a byte order mark",
            "\u{feff}x,y\r\n\r\n1,2\r\n  \r\n2,3\r\n",
            ["x", "y"],
        ),
        line("CR", "x,y\r1,2\r2,3\r\r3,4", ["x", "y"]),
        line("a quote within a cell", "x,y,z\n1,2,5\"\n2,3,\"6\"\"\"\n3,\"4\"0,\n", ["x", "y"]),
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
    for Measurement { regressor: [u, v], response, epsilon, .. } in problem.measurements.rows() {
        let _ = writeln!(text, "{u},{v},{response},{epsilon}");
    }
    let question = Question {
        conditions: problem.conditions.iter().map(|condition| condition.text().to_owned()).collect(),
        ..Question::line("generated", text.as_bytes(), ["u", "y"], "0").regressors(["u", "v"])
    };
    match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => Question { epsilon: Ok(epsilon.clone()), ..question },
        ErrorBound::PerRow(column) => question.epsilon_column(column),
    }
}

/// Every proof that differs from this one in one place, with what was changed.
pub fn tampered(proof: &Value) -> Vec<(String, Value)> {
    let mut all = Vec::new();
    let mut places = Vec::new();
    collect(proof, String::new(), &mut places);
    for place in places {
        let old = proof.pointer(&place).expect("a place of the proof");
        let mut add = |what: &str, new: Value| {
            let mut changed = proof.clone();
            *changed.pointer_mut(&place).expect("a place of the proof") = new;
            all.push((format!("{place}: {what}"), changed));
        };
        for new in replacements(old) {
            add(&format!("{old} to {new}"), new);
        }
    }
    all
}

fn collect(value: &Value, place: String, places: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            items
                .iter()
                .enumerate()
                .for_each(|(index, item)| collect(item, format!("{place}/{index}"), places));
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(name, field)| collect(field, format!("{place}/{name}"), places));
        }
        _ => {}
    }
    places.push(place);
}

fn replacements(old: &Value) -> Vec<Value> {
    match old {
        Value::Null => vec![json!(0), json!(1), json!("1")],
        Value::Bool(value) => vec![json!(!value), json!(1)],
        Value::Number(number) => {
            let number = number.as_u64().expect("an index");
            let less = number.checked_sub(1).map(|less| json!(less));
            [json!(number + 1), json!(null), json!(number as f64 + 0.5)].into_iter().chain(less).collect()
        }
        Value::String(text) => match Reading::Decimal.read(text, &Limits::default()) {
            Ok(number) => {
                let other =
                    [&number + Rational::one(), &number * Rational::ratio(1_000_001, 1_000_000), -&number];
                let other = other.into_iter().filter(|other| *other != number);
                other
                    .map(|other| json!(other.to_string()))
                    .chain([json!(format!("{text}/1")), json!(1)])
                    .collect()
            }
            Err(_) => {
                let other =
                    ["upper", "lower", "where:1", "where:2", "theta1", "theta2", "decimal", "binary64"];
                let other = other
                    .into_iter()
                    .chain(["1 upper", "2 lower", ";", "point", "segment", "polygon", "empty", "0"]);
                other.filter(|other| other != text).map(|other| json!(other)).collect()
            }
        },
        Value::Array(items) => {
            let without = (0..items.len()).map(|index| {
                let mut items = items.clone();
                items.remove(index);
                items
            });
            let twice = items.iter().map(|item| [items.as_slice(), std::slice::from_ref(item)].concat());
            let swapped = (1..items.len()).map(|index| {
                let mut items = items.clone();
                items.swap(index - 1, index);
                items
            });
            let changed = without.chain(twice).chain(swapped).filter(|changed| changed != items);
            changed.map(Value::from).chain([json!(null)]).collect()
        }
        Value::Object(fields) => {
            let without = fields.keys().map(|name| {
                let mut fields = fields.clone();
                fields.remove(name);
                Value::from(fields)
            });
            let mut more = fields.clone();
            more.insert("more".to_owned(), json!(1));
            without.chain([Value::from(more)]).collect()
        }
    }
}

/// Whether every statement of a proof of the right shape is true, as the engine sees it: the same question is asked again.
pub fn is_true(proof: &Value, data: &[u8]) -> bool {
    let model = proof["model"].as_array().expect("sources");
    let [first, second, y, epsilon] = model.as_slice() else { return false };
    let column = |value: &Value| value.to_string();
    let x = match (first.is_u64(), second.is_u64()) {
        (true, true) => vec![column(first), column(second)],
        (true, false) if number(second) == Rational::one() => vec![column(first)],
        _ => return false,
    };
    if !y.is_u64() {
        return false;
    }
    let rows = [0, 1].map(|end| proof["rows"][end].as_u64().unwrap_or_default() as usize);
    let question = Question {
        name: "again".to_owned(),
        data: data.to_vec(),
        x,
        y: column(y),
        epsilon: if epsilon.is_u64() { Err(column(epsilon)) } else { Ok(number(epsilon)) },
        conditions: proof["conditions"].as_array().expect("conditions").iter().map(condition).collect(),
        options: TableOptions {
            header: if proof["header"] == json!(true) { Header::Present } else { Header::Absent },
            delimiter: proof["delimiter"].as_str().map(|text| text.as_bytes()[0]),
            rows: RowRange::new(rows[0], rows[1]),
            reading: if proof["reading"] == "binary64" { Reading::Binary64 } else { Reading::Decimal },
            ..TableOptions::default()
        },
    };
    let Ok(problem) = question.problem() else { return false };
    let fit = fit(&problem).with_every_half_plane(&problem);
    let truth: Value =
        serde_json::from_str(&proof_json(&problem, &fit, question.options.reading).expect("text"))
            .expect("JSON");
    proof["sha256"] == truth["sha256"]
        && proof["kind"] == truth["kind"]
        && vertices(proof) == vertices(&truth)
        && bounds_are_true(proof, &truth, &fit)
        && sides_are_true(proof, &fit)
}

fn condition(condition: &Value) -> String {
    let [a1, a2, b] = [0, 1, 2].map(|part| number(&condition[part]));
    let sign = if a2.is_negative() { "-" } else { "+" };
    format!("{a1}*theta1 {sign} {}*theta2 <= {b}", a2.abs())
}

fn number(value: &Value) -> Rational {
    Reading::Decimal.read(value.as_str().expect("a text"), &Limits::default()).expect("a number")
}

fn pair(value: &Value) -> [Rational; 2] {
    [0, 1].map(|part| number(&value[part]))
}

/// The vertices, each with the set of what is active there.
fn vertices(proof: &Value) -> Vec<(String, BTreeSet<String>)> {
    let list = |value: &Value| value.as_array().expect("a list").clone();
    let theta = |theta: &Value| pair(theta).map(|number| number.to_string()).join(",");
    let vertex =
        |vertex: &Value| (theta(&vertex[0]), list(&vertex[1]).iter().map(|name| name.to_string()).collect());
    list(&proof["vertices"]).iter().map(vertex).collect()
}

fn named<'a>(fit: &'a Fit, name: &Value) -> Option<&'a Inequality> {
    let text = name.as_str()?;
    let index = fit.fps.names().iter().position(|name| name.to_string() == text)?;
    fit.fps.polyhedron().system().inequalities().get(index)
}

/// The sum of the multiples that a list of terms takes.
fn sum(terms: &Value, fit: &Fit) -> Option<([Rational; 2], Rational)> {
    let mut sum = ([Rational::zero(), Rational::zero()], Rational::zero());
    for term in terms.as_array()? {
        let (inequality, times) = (named(fit, &term[0])?, number(&term[1]));
        if !times.is_positive() {
            return None;
        }
        sum.0 = [0, 1].map(|part| &sum.0[part] + &inequality.a[part] * &times);
        sum.1 = sum.1 + &inequality.b * &times;
    }
    Some(sum)
}

fn bounds_are_true(proof: &Value, truth: &Value, fit: &Fit) -> bool {
    let (bounds, true_bounds) =
        (proof["bounds"].as_array().expect("a list"), truth["bounds"].as_array().expect("a list"));
    if proof["kind"] == "empty" {
        let is_contradiction =
            |(a, b): ([Rational; 2], Rational)| a.iter().all(Rational::is_zero) && b.is_negative();
        return bounds.is_empty() && sum(&proof["farkas"], fit).is_some_and(is_contradiction);
    }
    let polyhedron = fit.fps.polyhedron();
    let is_true = |(index, (bound, truth)): (usize, (&Value, &Value))| {
        let sign = Rational::from(if index % 2 == 0 { -1 } else { 1 });
        let form =
            if index < 2 { [sign.clone(), Rational::zero()] } else { [Rational::zero(), sign.clone()] };
        let same = bound["value"].is_string() == truth["value"].is_string()
            && (bound["value"].is_null() || number(&bound["value"]) == number(&truth["value"]));
        let proved = if bound["value"].is_string() {
            bound["point"].is_null()
                && bound["ray"].is_null()
                && sum(&bound["multipliers"], fit) == Some((form, sign * number(&bound["value"])))
        } else {
            let (point, ray) = (pair(&bound["point"]), pair(&bound["ray"]));
            let stays = |row: &Inequality| !(&row.a[0] * &ray[0] + &row.a[1] * &ray[1]).is_positive();
            polyhedron.membership(&point).is_inside()
                && polyhedron.system().inequalities().iter().all(stays)
                && (&form[0] * &ray[0] + &form[1] * &ray[1]).is_positive()
        };
        same && proved
    };
    bounds.len() == 4
        && bounds.iter().zip(true_bounds).enumerate().all(is_true)
        && proof["farkas"] == json!([])
}

/// Whether the sides are half-planes of the set that make it, each with the vertex where the next one begins.
fn sides_are_true(proof: &Value, fit: &Fit) -> bool {
    let sides = proof["sides"].as_array().expect("a list");
    if proof["kind"] == "empty" {
        return sides.is_empty();
    }
    let Some(own): Option<Vec<&Inequality>> = sides.iter().map(|side| named(fit, &side[0])).collect() else {
        return false;
    };
    let system: System = own.iter().map(|&side| side.clone()).collect();
    let of_sides = Polyhedron::intersect(system);
    let (region, whole) = (of_sides.region(), fit.fps.polyhedron().region());
    let points = |region: &boundfit_geometry::Region| -> Vec<_> {
        region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
    };
    let corner = |(index, side): (usize, &Value)| {
        let (this, next) = (own[index], own[(index + 1) % own.len()]);
        let turn = &this.a[0] * &next.a[1] - &this.a[1] * &next.a[0];
        match side[1].as_u64() {
            None => !turn.is_positive(),
            Some(vertex) => {
                let theta = pair(&proof["vertices"][vertex as usize][0]);
                turn.is_positive() && this.slack(&theta).is_zero() && next.slack(&theta).is_zero()
            }
        }
    };
    region.kind() == whole.kind()
        && points(region) == points(whole)
        && region.rays() == whole.rays()
        && region.lines() == whole.lines()
        && sides.iter().enumerate().all(corner)
}
