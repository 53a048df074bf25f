//! The library `boundfit`: every type of number that goes in gives the answer that the program gives for the file.

use std::fs;

use boundfit::check::check;
use boundfit::num_rational::{BigRational, Ratio};
use boundfit::questions::{Best, Goal, Next, NextReading};
use boundfit::verify::{Extent, Falsehood, Found, VerifyError, verify};
use boundfit::{
    Endpoint, Error, Fit, Interval, Number, NumberError, Observations, Problem, Rational, Reading,
};
use boundfit_tests::cli::numbers::{exact, exact_or_null, pair, rational};
use boundfit_tests::cli::report;
use boundfit_tests::program::{root, run};
use serde_json::Value;

/// The parts of an answer that are compared.
#[derive(Debug, PartialEq, Eq)]
struct Answer {
    kind: String,
    vertices: Vec<[Rational; 2]>,
    pui: Option<[Interval; 2]>,
    eui: Option<[Interval; 2]>,
    central: Option<[Rational; 2]>,
    least_squares: Option<[Rational; 2]>,
    /// The least factor on all error bounds, if each row has one.
    epsilon_min: Option<Rational>,
}

impl Answer {
    fn of_library(fit: &Fit) -> Self {
        Answer {
            kind: fit.fps.polyhedron().region().kind().name().to_owned(),
            vertices: fit.vertices(),
            pui: fit.pui_intervals(),
            eui: fit.eui().cloned(),
            central: fit.central.as_ref().map(|central| central.theta.clone()),
            least_squares: fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone()),
            epsilon_min: fit.minimax.as_ref().map(|minimax| minimax.least.clone()),
        }
    }

    fn of_program(line: &str) -> Self {
        let report = report(&root(), line, b"");
        let theta = |part: &Value| (!part.is_null()).then(|| pair(&part["theta"]));
        let intervals = |part: &Value, end: fn(&Value) -> Option<Rational>| {
            let interval = |interval: &Value| {
                let [lower, upper] = ["lower", "upper"].map(|side| Endpoint::from(end(&interval[side])));
                Interval::new(lower, upper).unwrap()
            };
            (!part.is_null()).then(|| [interval(&part[0]), interval(&part[1])])
        };
        let vertices = report["fps"]["vertices"].as_array().unwrap();
        Answer {
            kind: report["fps"]["kind"].as_str().unwrap().to_owned(),
            vertices: vertices.iter().map(|vertex| pair(&vertex["theta"])).collect(),
            pui: intervals(&report["pui"], exact_or_null),
            eui: intervals(&report["eui"], |end| Some(exact(end))),
            central: theta(&report["central"]),
            least_squares: theta(&report["least_squares"]),
            epsilon_min: exact_or_null(&report["epsilon_min"])
                .or_else(|| exact_or_null(&report["minimax"]["epsilon_factor"])),
        }
    }
}

/// The cells of columns of a fixture, by their names.
fn columns<const N: usize>(path: &str, names: [&str; N]) -> [Vec<String>; N] {
    let text = fs::read_to_string(root().join(path)).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let rows: Vec<Vec<&str>> = lines.collect();
    names.map(|name| {
        let column = header.iter().position(|cell| *cell == name).unwrap();
        rows.iter().map(|row| row[column].trim().to_owned()).collect()
    })
}

fn numbers(cells: &[String]) -> Vec<Rational> {
    cells.iter().map(|cell| rational(cell)).collect()
}

fn doubles(cells: &[String]) -> Vec<f64> {
    cells.iter().map(|cell| cell.parse().unwrap()).collect()
}

fn answer(problem: &Problem) -> Answer {
    let fit = problem.fit();
    assert_eq!(fit.verify(problem), Ok(()));
    Answer::of_library(&fit)
}

fn of_line<N: Number>(x: &[N], y: &[N], epsilon: impl Number) -> Answer {
    answer(&Observations::line(x, y).unwrap().error_bound(epsilon).unwrap())
}

#[test]
fn a_line_is_that_of_the_program_from_every_type() {
    for (path, x, y, rows, epsilon) in [
        ("fixtures/transducer/transducer.csv", "Vz", "z", 14..=36, "0.5e-3"),
        ("fixtures/norris/norris.csv", "x", "y", 1..=36, "3"),
        ("fixtures/norris/norris.csv", "x", "y", 1..=36, "1/2"),
    ] {
        let range = format!("{}..{}", rows.start(), rows.end());
        let line = format!("fit {path} --x {x} --y {y} --rows {range} --eps {epsilon}");
        let kept = |cells: Vec<String>| cells[rows.start() - 1..*rows.end()].to_vec();
        let [x, y] = columns(path, [x, y]).map(kept);

        let expected = Answer::of_program(&line);
        assert_eq!(of_line(&x, &y, epsilon), expected, "text: {line}");
        let exact = [&x, &y].map(|cells| numbers(cells));
        assert_eq!(of_line(&exact[0], &exact[1], rational(epsilon)), expected, "Rational: {line}");
        let [x_big, y_big] =
            exact.each_ref().map(|column| column.iter().map(BigRational::from).collect::<Vec<_>>());
        assert_eq!(of_line(&x_big, &y_big, epsilon), expected, "BigRational: {line}");
        let words = |column: &Vec<Rational>| -> Vec<Ratio<i64>> {
            column.iter().map(|number| Ratio::try_from(number).unwrap()).collect()
        };
        assert_eq!(of_line(&words(&exact[0]), &words(&exact[1]), epsilon), expected, "Ratio: {line}");

        let in_binary64 = Answer::of_program(&format!("{line} --reading binary64"));
        assert_ne!(in_binary64, expected, "{line}");
        let epsilon = rational(epsilon).to_f64();
        assert_eq!(of_line(&doubles(&x), &doubles(&y), epsilon), in_binary64, "f64: {line}");
    }
}

#[test]
fn every_type_of_integer_is_a_number() {
    let signed: [&dyn Number; 6] = [&-7_i8, &-7_i16, &-7_i32, &-7_i64, &-7_i128, &-7_isize];
    let unsigned: [&dyn Number; 6] = [&7_u8, &7_u16, &7_u32, &7_u64, &7_u128, &7_usize];
    for (numbers, value) in [(signed, -7), (unsigned, 7)] {
        for number in numbers {
            assert_eq!(number.exact(), Ok(Rational::from(value)));
        }
    }
    assert_eq!(u128::MAX.exact().unwrap().to_string(), u128::MAX.to_string());
    // A fraction that is not needed any more goes by value, too.
    let third: BigRational = rational("1/3").into();
    assert_eq!(third, BigRational::new(1.into(), 3.into()));
}

#[test]
fn the_next_reading_is_that_of_the_program() {
    let line = "next fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";
    let told = report(&root(), line, b"");
    let [x, y] =
        columns("fixtures/transducer/transducer.csv", ["Vz", "z"]).map(|cells| cells[13..36].to_vec());
    let problem = Observations::line(&x, &y).unwrap().error_bound("0.5e-3").unwrap();
    let (fit, epsilon) = (problem.fit(), rational("0.5e-3"));
    let next = NextReading::of(&problem, &fit, &epsilon, None, &[Goal::Theta1]).unwrap();
    let unsure = next.unsure.unwrap();
    let [below, above] = [unsure.lower(), unsure.upper()].map(|end| end.value().cloned());
    assert_eq!(below, exact_or_null(&told["certain"][0]["upper"]));
    assert_eq!(above, exact_or_null(&told["certain"][1]["lower"]));
    let best: &Best = &next.best[0];
    let now = Next::new(fit.fps.polyhedron(), epsilon).unwrap().now(Goal::Theta1);
    assert_eq!(best.now, now);
}

#[test]
fn integers_bounds_per_row_and_conditions_are_those_of_the_program() {
    let path = "fixtures/steam-generator/steam_generator.csv";
    let line = format!("fit {path} --x x --y y --eps-column eps --where 'theta1 >= 12.5'");
    let expected = Answer::of_program(&line);
    let cells = columns(path, ["x", "y", "eps"]);
    let integers =
        cells.each_ref().map(|column| column.iter().map(|cell| cell.parse().unwrap()).collect::<Vec<i64>>());
    let [x, y, eps] = &integers;
    let observations = Observations::line(x, y).unwrap();
    let problem = observations.error_bounds(eps).unwrap().condition("theta1 >= 12.5").unwrap();
    assert_eq!(answer(&problem), expected);

    // The constant as a regressor of its own is the same model, without an inverse line.
    let ones = vec![1; x.len()];
    let observations = Observations::regressors(x, &ones, y).unwrap();
    let problem = observations.error_bounds(eps).unwrap().condition("theta1 >= 12.5").unwrap();
    assert_eq!(answer(&problem), expected);
    assert!(problem.fit().inverse(problem.measurements.model()).is_none());
}

#[test]
fn half_planes_are_those_of_the_program() {
    let expected = report(&root(), "polygon fixtures/polygon/house.csv", b"");
    let [a1, a2, b] = columns("fixtures/polygon/house.csv", ["a1", "a2", "b"]);
    let rows: Vec<[&str; 3]> = (0..b.len()).map(|row| [&*a1[row], &a2[row], &b[row]]).collect();
    let house = boundfit::polygon(&rows).unwrap();
    let vertices: Vec<[Rational; 2]> =
        house.region().vertices().iter().map(|vertex| vertex.point().coordinates()).collect();
    let told = expected["region"]["vertices"].as_array().unwrap();
    assert_eq!(vertices, told.iter().map(|vertex| pair(&vertex["theta"])).collect::<Vec<_>>());
}

#[test]
fn claims_are_judged_as_by_the_program() {
    let line = "check fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \
                --claim-pui 1.7909e-3,1.8484e-3,2.2596e-2,2.2807e-2";
    let program = run(&line.split_whitespace().chain(["--format", "json"]).collect::<Vec<_>>());
    let report: Value = serde_json::from_str(&program.stdout).unwrap();
    let [x, y] =
        columns("fixtures/transducer/transducer.csv", ["Vz", "z"]).map(|cells| cells[13..36].to_vec());
    let problem = Observations::line(&x, &y).unwrap().error_bound("0.5e-3").unwrap();
    let claimed = [["1.7909e-3", "1.8484e-3"], ["2.2596e-2", "2.2807e-2"]];
    let judged = check(&problem, &claimed).unwrap();
    let verdicts = judged.map(|ends| ends.map(|end| end.verdict.name()));
    let told = report["claims"][0]["bounds"].as_array().unwrap();
    assert_eq!(report["claims"][0]["reading"], "decimal");
    let told: Vec<&str> = told.iter().map(|bound| bound["verdict"].as_str().unwrap()).collect();
    assert_eq!(verdicts.concat(), told);
    let error = check(&problem, &[["1", "2"], ["x", "3"]]).unwrap_err();
    assert!(error.to_string().starts_with("theta2-min: \"x\" is not a number"), "{error}");
}

#[test]
fn a_proof_of_the_program_is_true_of_its_table_alone() {
    let line = "fit fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o /dev/null --proof -";
    let proof = run(&line.split_whitespace().collect::<Vec<_>>()).stdout;
    let data = fs::read(root().join("fixtures/transducer/transducer.csv")).unwrap();
    let statement = verify(&proof, &data).unwrap();
    let Found::Set(set) = statement.found else { panic!("{:?}", statement.found) };
    assert_eq!((set.extent, set.vertices, statement.half_planes), (Extent::Bounded, 6, 46));
    let other = verify(&proof, &data[1..]);
    assert!(matches!(other, Err(VerifyError::False(Falsehood::OtherData))), "{other:?}");
    let cut = verify(&proof[1..], &data);
    assert!(matches!(cut, Err(VerifyError::NotAProof(_))), "{cut:?}");
}

/// Few readings and more than are kept, of few digits and of all, with both readings.
#[test]
fn slices_of_doubles_are_fitted_like_their_texts_or_their_values() {
    let mut state = 11_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64
    };
    for (rows, divisor) in [(0, 10.0), (1, 10.0), (23, 1e3), (23, 3.0), (11_000, 1e3), (11_000, 7.0)] {
        let x: Vec<f64> = (0..rows).map(|_| (next() % 10_000.0) / divisor).collect();
        let y: Vec<f64> = x.iter().map(|x| (2.0 * x).round() + (next() % 800.0) / divisor / 1e3).collect();
        for reading in [Reading::Decimal, Reading::Binary64] {
            let problem = boundfit::problem_of_doubles(&x, &y, "1.25", reading).unwrap();
            let fitted = problem.fit();
            let expected = match reading {
                Reading::Decimal => {
                    let texts =
                        |column: &[f64]| column.iter().map(|value| format!("{value:e}")).collect::<Vec<_>>();
                    boundfit::fit(&texts(&x), &texts(&y), "1.25").unwrap()
                }
                Reading::Binary64 => boundfit::fit(&x, &y, "1.25").unwrap(),
            };
            assert_eq!(
                Answer::of_library(&fitted),
                Answer::of_library(&expected),
                "{rows} {divisor} {reading:?}"
            );
            assert_eq!(problem.measurements.fitted(), rows);
            assert_eq!(fitted.verify(&problem), Ok(()));
        }
    }
}

#[test]
fn slices_of_doubles_that_are_no_readings_are_refused_with_their_place() {
    let message = |x: &[f64], y: &[f64], epsilon: &str, reading| {
        boundfit::fit_doubles(x, y, epsilon, reading).unwrap_err().to_string()
    };
    for reading in [Reading::Decimal, Reading::Binary64] {
        assert_eq!(
            message(&[0.0, f64::NAN], &[1.0; 2], "1", reading),
            "row 2 of x: NaN is not a finite number"
        );
        assert_eq!(message(&[0.0], &[f64::INFINITY], "1", reading), "row 1 of y: inf is not a finite number");
        assert_eq!(message(&[0.0, 1.0], &[1.0], "1", reading), "x has 2 rows, but y has 1");
        assert_eq!(message(&[0.0], &[1.0], "-1/2", reading), "the error bound is negative");
    }
}

#[test]
fn what_is_no_problem_is_refused_with_its_place() {
    let fit = |x: &[f64], y: &[&str], epsilon: &str| boundfit::fit(x, y, epsilon).unwrap_err();
    for (error, message) in [
        (fit(&[0.0, f64::NAN], &["1", "2"], "1"), "row 2 of x: NaN is not a finite number"),
        (fit(&[0.0, f64::INFINITY], &["1", "2"], "1"), "row 2 of x: inf is not a finite number"),
        (fit(&[0.0, 1.0], &["1"], "1"), "x has 2 rows, but y has 1"),
        (fit(&[0.0], &["1"], "-1/2"), "the error bound is negative"),
        (fit(&[0.0, 1.0], &["1", "1,5"], "1"), "row 2 of y: \"1,5\" is not a number: "),
        (fit(&[0.0], &["1"], ""), "the error bound: \"\" is not a number: "),
        (fit(&[0.0], &["1e999999999"], "1"), "row 1 of y: \"1e999999999\" is not a number: "),
    ] {
        assert!(error.to_string().starts_with(message), "{error}");
    }
    let law = fit(&[0.0], &["1"], "1%*|y|").to_string();
    let ways = " (a law is for error_bounds, a multiple of the least bound for with_multiple_of_least)";
    assert!(law.ends_with(ways), "{law}");
    let line = || Observations::line(&[0, 1], &[0, 1]).unwrap();
    let bounds = line().error_bounds(&[1, -1]).unwrap_err();
    assert_eq!(bounds, Error::NegativeBound { row: Some(2) });
    assert_eq!(bounds.to_string(), "the error bound of row 2 is negative");
    assert_eq!(line().error_bounds(&[1]).unwrap_err().to_string(), "y has 2 rows, but eps has 1");
    let condition = line().error_bound(1).unwrap().condition("theta3 >= 0");
    assert!(Error::from(condition.unwrap_err()).to_string().starts_with("neither a number"));
    let half_planes = boundfit::polygon(&[[0.0, 1.0, 2.0], [1.0, f64::NEG_INFINITY, 2.0]]).unwrap_err();
    let problem = NumberError::NotFinite(f64::NEG_INFINITY);
    assert_eq!(half_planes, Error::Number { column: "a2", row: 2, problem });
}

/// No reading at all, one reading, the same one twice: nothing of this panics.
#[test]
fn few_readings_leave_sets_without_end() {
    let none: [i64; 0] = [];
    let kinds = [(&none[..], "plane"), (&[1], "strip"), (&[1, 1], "strip"), (&[1, 2], "polygon")];
    for (numbers, kind) in kinds {
        let answer = of_line(numbers, numbers, "1/3");
        assert_eq!(answer.kind, kind, "{numbers:?}");
    }
}
