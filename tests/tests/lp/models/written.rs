//! Generated programs are written in every format and read back as they were.

use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_lp::{
    Bounds, ExchangeFormat, Model, ModelColumn, ModelLimits, ModelRow, ObjectiveSense, read_model,
};
use boundfit_tests::generate::share;
use boundfit_tests::lp_cases::number;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::naive;

/// A finite decimal: small and whole, short, tiny, huge, or a double with all its digits.
fn decimal(rng: &mut ChaCha8Rng) -> Rational {
    let whole = rng.random_range(-9..=9_i64);
    match rng.random_range(0..12) {
        0..=5 => Rational::ratio(whole, 1),
        6 | 7 => Rational::ratio(rng.random_range(-9999..=9999), 1000),
        8 => Rational::scientific(whole, rng.random_range(-30..=-10_i64)),
        9 => Rational::scientific(whole, rng.random_range(8..=28_i64)),
        10 => Rational::ratio(whole, 1 << rng.random_range(0..12)),
        _ => Reading::Binary64
            .read(&format!("{}.1e-7", rng.random_range(0..99)), &ModelLimits::default().number)
            .unwrap(),
    }
}

fn bounds(rng: &mut ChaCha8Rng, may_cross: bool) -> Bounds {
    let (first, second) = (decimal(rng), decimal(rng));
    let (lower, upper) = if may_cross || first <= second { (first, second) } else { (second, first) };
    match rng.random_range(0..7) {
        0 => Bounds { lower: None, upper: None },
        1 => Bounds { lower: Some(Rational::zero()), upper: None },
        2 => Bounds { lower: Some(lower.clone()), upper: Some(lower) },
        3 => Bounds { lower: None, upper: Some(upper) },
        4 => Bounds { lower: Some(lower), upper: None },
        5 if may_cross => Bounds { lower: Some(Rational::zero()), upper: Some(upper) },
        _ => Bounds { lower: Some(lower), upper: Some(upper) },
    }
}

/// A program in at most two columns; every tenth has more, of which all but two are fixed.
fn model(rng: &mut ChaCha8Rng) -> Model {
    let is_wide = rng.random_range(0..10) == 0;
    let count = if is_wide { rng.random_range(3..6) } else { rng.random_range(0..=2) };
    let mut columns: Vec<ModelColumn> = Vec::new();
    for place in 0..count {
        let cost = if rng.random_range(0..3) == 0 { Rational::zero() } else { decimal(rng) };
        let fixed = decimal(rng);
        let bounds = if place < 2 {
            bounds(rng, true)
        } else {
            Bounds { lower: Some(fixed.clone()), upper: Some(fixed) }
        };
        columns.push(ModelColumn { name: format!("x_{place}").into(), cost, bounds });
    }
    let row = |rng: &mut ChaCha8Rng, place: usize| {
        let used: Vec<usize> = (0..count).filter(|_| rng.random_range(0..4) > 0).collect();
        let coefficients = used.into_iter().map(|column| (column, decimal(rng)));
        let coefficients = coefficients.filter(|(_, value)| !value.is_zero()).collect();
        ModelRow { name: format!("row_{place}").into(), coefficients, bounds: bounds(rng, false) }
    };
    let rows = (0..rng.random_range(0..6)).map(|place| row(rng, place)).collect();
    let is_maximum = rng.random_range(0..2) == 0;
    Model {
        name: "a_model".into(),
        sense: if is_maximum { ObjectiveSense::Maximize } else { ObjectiveSense::Minimize },
        objective_name: "the_cost".into(),
        constant: if rng.random_range(0..3) == 0 { decimal(rng) } else { Rational::zero() },
        columns,
        rows,
    }
}

/// Free MPS in the columns of the fixed one, with blanks for `_` in names; `None` where a number is too long for them.
fn fixed(text: &str) -> Option<String> {
    let mut section = "";
    let mut fixed = String::new();
    for line in text.lines() {
        let words: Vec<String> = line.split_whitespace().map(|word| word.replace('_', " ")).collect();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        if !line.starts_with(' ') {
            section = line.split_whitespace().next().unwrap();
            fixed.push_str(&words.join("          "));
            fixed.push('\n');
            continue;
        }
        let fields = match (section, words.as_slice()) {
            ("OBJSENSE", [sense]) => ["", sense, "", ""],
            ("ROWS", [kind, name]) => [*kind, *name, "", ""],
            ("BOUNDS", [kind, vector, column]) => [*kind, *vector, *column, ""],
            ("BOUNDS", [kind, vector, column, value]) => [*kind, *vector, *column, *value],
            (_, [name, row, value]) => ["", *name, *row, *value],
            _ => unreachable!("{line}"),
        };
        if fields[3].len() > 12 {
            return None;
        }
        let [code, name, row, value] = fields;
        fixed.push_str(format!(" {code:<2} {name:<8}  {row:<8}  {value}").trim_end());
        fixed.push('\n');
    }
    Some(fixed)
}

fn with_blanks(model: &Model) -> Model {
    let mut model = model.clone();
    let columns = model.columns.iter_mut().map(|column| &mut column.name);
    let rows = model.rows.iter_mut().map(|row| &mut row.name);
    columns.chain(rows).chain([&mut model.name, &mut model.objective_name]).for_each(|name| {
        *name = name.raw().replace('_', " ").into();
    });
    model
}

#[test]
fn generated_programs_are_read_back_in_every_format() {
    let mut rng = ChaCha8Rng::seed_from_u64(1_204);
    let read = |text: &str, format| {
        read_model(text, format, &ModelLimits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
    };
    let (mut in_fixed, mut ranged) = (0, 0);
    for _ in 0..share(20_000) {
        let model = model(&mut rng);
        let mps = model.text(ExchangeFormat::Mps);
        assert_eq!(read(&mps, ExchangeFormat::Mps), model, "{mps}");
        if !model.columns.is_empty() {
            assert_eq!(naive::read(&mps), model, "{mps}");
        }
        let lp = model.text(ExchangeFormat::Lp);
        assert_eq!(
            read(&lp, ExchangeFormat::Lp),
            Model { name: Foreign::default(), ..model.clone() },
            "{lp}"
        );
        if let Some(text) = fixed(&mps) {
            assert_eq!(read(&text, ExchangeFormat::Mps), with_blanks(&model), "{text}");
            in_fixed += 1;
        }
        ranged += usize::from(mps.contains("RANGES"));
    }
    assert!(in_fixed > share(5_000) && ranged > share(5_000), "{in_fixed} {ranged}");
}

#[test]
fn numbers_without_decimals_are_scaled_with_their_rows() {
    let mut rng = ChaCha8Rng::seed_from_u64(77);
    for _ in 0..2_000 {
        let mut model = model(&mut rng);
        let scale = Rational::ratio(1, [3, 7, 9, 11][rng.random_range(0..4)]);
        for row in &mut model.rows {
            row.coefficients.iter_mut().for_each(|(_, value)| *value = &*value * &scale);
        }
        for format in ExchangeFormat::ALL {
            let text = model.text(format);
            let back = read_model(&text, format, &ModelLimits::default()).unwrap();
            for (row, back) in model.rows.iter().zip(&back.rows) {
                let remark = format!("{} is multiplied by ", row.name);
                let scale = text.lines().find_map(|line| line[2..].strip_prefix(&remark));
                let scale = scale.map_or(Rational::one(), |rest| number(rest.split(':').next().unwrap()));
                let times = |value: &Rational| value * &scale;
                let coefficients: Vec<_> =
                    row.coefficients.iter().map(|(column, value)| (*column, times(value))).collect();
                assert_eq!(back.coefficients, coefficients, "{text}");
                assert_eq!(back.bounds.lower, row.bounds.lower.as_ref().map(times), "{text}");
                assert_eq!(back.bounds.upper, row.bounds.upper.as_ref().map(times), "{text}");
            }
        }
    }
}
