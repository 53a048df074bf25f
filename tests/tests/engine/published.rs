//! Data sets with published or independently computed exact answers, compared with `==`.

use std::fs;

use boundfit_estimation::{Columns, EpsilonColumn, Fit, LineForm, Measurements, Problem, fit};
use boundfit_exact::{Interval, Limits, Rational, Reading, Rounding};
use boundfit_formats::{ColumnSelector, RowRange, Source, TableOptions};
use boundfit_geometry::Point;
use boundfit_geometry::predicates::lexicographic;
use boundfit_tests::definitions::contains;
use boundfit_tests::program::{root, run};
use boundfit_tests::readings::parse_condition;
use serde_json::Value;

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).expect(text)
}

fn read_json(path: &str) -> Value {
    let path = root().join("fixtures").join(path);
    serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap()
}

/// Reads a fixture with columns `x` and `y` or those named.
fn problem(path: &str, [x, y]: [&str; 2], epsilon: EpsilonColumn, rows: Option<RowRange>) -> Problem {
    let path = root().join("fixtures").join(path);
    let source = Source::open(path.to_str().unwrap()).unwrap();
    let column = ColumnSelector::name_or_number;
    let columns = Columns {
        first: column(x),
        second: None,
        response: Some(column(y)),
        epsilon,
        form: LineForm::default(),
    };
    let options = TableOptions { rows: rows.into(), ..TableOptions::default() };
    let measurements = Measurements::read(source, &columns, &options).unwrap();
    Problem { measurements, conditions: Vec::new() }
}

/// A decimal as papers print it.
fn decimal(value: &Rational) -> String {
    value.decimal(5, Rounding::Nearest).compact().to_string()
}

/// The digits of a published decimal without its power of ten, as reports print it.
fn without_power(published: &str) -> String {
    let Some((digits, power)) = published.split_once("e-") else { return published.to_owned() };
    let zeros = "0".repeat(power.parse::<usize>().unwrap() - 1);
    format!("0.{zeros}{}", digits.replace('.', ""))
}

/// The decimals of an interval as papers print them.
fn nearest(interval: &Interval) -> [String; 2] {
    let (lower, upper) = interval.ends().unwrap();
    [lower, upper].map(decimal)
}

fn strings(value: &Value) -> Vec<String> {
    value.as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

#[test]
fn the_transducer_reproduces_every_published_figure() {
    let published = read_json("transducer/published.json");
    let epsilon = EpsilonColumn::Uniform(number(published["epsilon"].as_str().unwrap()));
    let problem = problem("transducer/transducer.csv", ["Vz", "z"], epsilon, RowRange::new(14, 36));
    let fit = fit(&problem);
    let inverse = fit.inverse(problem.measurements.model()).unwrap();
    let mut figures = 0;
    let mut check = |found: &[String], section: &str, key: &str| {
        let expected = match &published[section][key] {
            Value::String(text) => vec![text.clone()],
            array => strings(array),
        };
        assert_eq!(found, expected, "{section} {key}");
        figures += found.len();
    };

    let least_squares = fit.least_squares.as_ref().unwrap();
    check(&least_squares.theta.each_ref().map(decimal), "least_squares", "theta");
    check(&[decimal(inverse.gain.least_squares.as_ref().unwrap())], "least_squares", "Kt");
    check(&[decimal(inverse.offset.least_squares.as_ref().unwrap())], "least_squares", "Vo");
    check(&nearest(&least_squares.eui.as_ref().unwrap()[0]), "eui", "theta1");
    check(&nearest(&least_squares.eui.as_ref().unwrap()[1]), "eui", "theta2");
    check(&nearest(&inverse.gain.eui_range.as_ref().unwrap()[0]), "eui", "Kt");
    check(&nearest(&inverse.offset.eui_range.as_ref().unwrap()[0]), "eui", "Vo");
    let pui = fit.pui_intervals().unwrap();
    check(&nearest(&pui[0]), "pui", "theta1");
    check(&nearest(&pui[1]), "pui", "theta2");
    check(&nearest(&inverse.gain.box_range[0]), "pui", "Kt");
    check(&nearest(&inverse.offset.box_range[0]), "pui", "Vo");
    check(&fit.central.as_ref().unwrap().theta.each_ref().map(decimal), "central", "theta");
    check(&[decimal(inverse.gain.central.as_ref().unwrap())], "central", "Kt");
    check(&[decimal(inverse.offset.central.as_ref().unwrap())], "central", "Vo");
    assert_eq!(figures, 24);

    // The set itself is tighter than its box, and least squares lies outside it.
    assert!(contains(&inverse.offset.box_range[0], &inverse.offset.exact_range[0]));
    assert_ne!(inverse.offset.box_range, inverse.offset.exact_range);
    assert!(fit.least_squares_slack().unwrap().0.is_negative());
    assert_eq!(fit.fps.polyhedron().region().vertices().len(), 6);
    assert_eq!(fit.verify(&problem), Ok(()));
}

#[test]
fn the_program_prints_every_published_figure() {
    let reported = |figures: &Value| -> Vec<String> {
        strings(figures).iter().map(|figure| without_power(figure)).collect()
    };
    let arguments =
        ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36"];
    let text =
        run(&[&arguments[..], &["--eps", "0.5e-3", "--rounding", "nearest", "--full", "--no-lp"]].concat())
            .stdout;
    let published = read_json("transducer/published.json");
    // Parameters and the inverse line have a table each.
    let row = |label: &str| {
        let rows: Vec<&str> = text.lines().filter(|line| line.trim_start().starts_with(label)).collect();
        rows.join("  ")
    };
    for (section, label) in
        [("least_squares", "least squares"), ("eui", "EUI"), ("pui", "PUI"), ("central", "central")]
    {
        let row = row(label);
        for (key, figures) in published[section].as_object().unwrap() {
            let printed = match figures {
                Value::String(figure) => without_power(figure),
                pair if key == "theta" => reported(pair).join("  "),
                interval => format!("[{}]", reported(interval).join(", ")),
            };
            let squeezed: Vec<&str> =
                row.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
            assert!(squeezed.join("  ").contains(&printed), "{section} {key}: {printed} in {row}");
        }
    }
}

#[test]
fn norris_reproduces_the_certified_least_squares() {
    let problem = problem("norris/norris.csv", ["x", "y"], EpsilonColumn::Uniform(Rational::one()), None);
    let [slope, intercept] = fit(&problem).least_squares.unwrap().theta;
    assert_eq!(slope.to_decimal(15, Rounding::Nearest), "1.00211681802045");
    assert_eq!(intercept.to_decimal(15, Rounding::Nearest), "-0.262323073774029");
}

#[test]
fn the_steam_generator_has_the_published_vertices() {
    let epsilon = EpsilonColumn::Column(ColumnSelector::name_or_number("eps"));
    let mut problem = problem("steam-generator/steam_generator.csv", ["x", "y"], epsilon, None);
    problem.conditions.push(parse_condition("theta1 >= 0"));
    let fit = fit(&problem);
    let region = fit.fps.polyhedron().region();
    let expected =
        [["85/8", "13/2"], ["12", "-21"], ["49/4", "-25"], ["119/8", "-113/2"], ["107/8", "-53/2"]];
    assert_eq!(vertices(&fit), expected.map(|pair| pair.map(number)));
    assert_eq!(region.area(), Some(number("527/16")));
    let centroid = region.area_centroid().unwrap().coordinates();
    assert_eq!(centroid, [number("53759/4216"), number("-79061/3162")]);
    assert_eq!(fit.verify(&problem), Ok(()));
}

fn vertices(fit: &Fit) -> Vec<[Rational; 2]> {
    fit.fps.polyhedron().region().vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
}

/// A pair of numbers, or a list of pairs.
fn pair(value: &Value) -> [Rational; 2] {
    let numbers: Vec<Rational> = strings(value).iter().map(|text| number(text)).collect();
    numbers.try_into().unwrap()
}

/// Vertices as listed, from the lexicographically smallest; the files list them counter-clockwise.
fn expected_vertices(expected: &Value) -> Vec<[Rational; 2]> {
    let mut vertices: Vec<[Rational; 2]> =
        expected["vertices"].as_array().unwrap().iter().map(pair).collect();
    let point = |[theta1, theta2]: &[Rational; 2]| Point::new(theta1, theta2);
    let start = (0..vertices.len())
        .min_by(|&i, &j| lexicographic(&point(&vertices[i]), &point(&vertices[j])))
        .unwrap_or(0);
    vertices.rotate_left(start);
    vertices
}

/// Compares everything that an `expected` object gives; returns how many of its keys were compared.
fn check_expected(problem: &Problem, expected: &Value, name: &str) {
    let fit = fit(problem);
    let region = fit.fps.polyhedron().region();
    assert_eq!(fit.verify(problem), Ok(()), "{name}");
    let ends = |intervals: [Interval; 2]| {
        intervals.map(|interval| interval.ends().map(|(lower, upper)| [lower.clone(), upper.clone()]))
    };
    let pairs = |value: &Value| [0, 1].map(|axis| Some(pair(&value[axis])));
    for (key, value) in expected.as_object().unwrap() {
        match key.as_str() {
            "kind" => assert_eq!(region.kind().name(), value.as_str().unwrap(), "{name}"),
            "vertices" => assert_eq!(vertices(&fit), expected_vertices(expected), "{name}"),
            "pui" if value.is_null() => {
                assert_eq!(ends(fit.pui_intervals().unwrap()), [None, None], "{name}")
            }
            "pui" => assert_eq!(ends(fit.pui_intervals().unwrap()), pairs(value), "{name}"),
            "central" => assert_eq!(fit.central.as_ref().unwrap().theta, pair(value), "{name}"),
            "area" => assert_eq!(region.area(), Some(number(value.as_str().unwrap())), "{name}"),
            "least_squares" => assert_eq!(fit.least_squares.as_ref().unwrap().theta, pair(value), "{name}"),
            "eui" => assert_eq!(ends(fit.eui().cloned().unwrap()), pairs(value), "{name}"),
            "epsilon_min" => {
                assert_eq!(fit.minimax.as_ref().unwrap().least, number(value.as_str().unwrap()), "{name}");
            }
            "lines" => {
                let lines: Vec<String> = region
                    .lines()
                    .iter()
                    .flat_map(|line| [line.dx().to_string(), line.dy().to_string()])
                    .collect();
                assert_eq!(lines, strings(&value[0]), "{name}");
            }
            other => panic!("{name}: nothing compares {other}"),
        }
    }
}

#[test]
fn the_golden_cases_come_out_exactly() {
    let golden = read_json("golden/golden.json");
    let cases = golden["cases"].as_array().unwrap();
    for case in cases {
        let mut table = "x,y\n".to_owned();
        for (x, y) in strings(&case["x"]).iter().zip(strings(&case["y"])) {
            table.push_str(&format!("{x},{y}\n"));
        }
        let column = ColumnSelector::name_or_number;
        let epsilon = EpsilonColumn::Uniform(number(case["eps"].as_str().unwrap()));
        let columns = Columns {
            first: column("x"),
            second: None,
            response: Some(column("y")),
            epsilon,
            form: LineForm::default(),
        };
        let source = Source::new("golden", std::io::Cursor::new(table.into_bytes()));
        let measurements = Measurements::read(source, &columns, &TableOptions::default()).unwrap();
        let problem = Problem { measurements, conditions: Vec::new() };
        check_expected(&problem, &case["expected"], case["name"].as_str().unwrap());
    }
    assert_eq!(cases.len(), 11);
}

#[test]
fn the_fits_on_which_float_solvers_fail_come_out_exactly() {
    let mut cases = 0;
    for entry in fs::read_dir(root().join("fixtures/hard-lp")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap();
        let case = read_json(&format!("hard-lp/{name}.json"));
        let epsilon = EpsilonColumn::Uniform(number(case["eps"].as_str().unwrap()));
        let problem = problem(&format!("hard-lp/{name}.csv"), ["x", "y"], epsilon, None);
        check_expected(&problem, &case["expected"], name);
        cases += 1;
    }
    assert_eq!(cases, 12);
}
