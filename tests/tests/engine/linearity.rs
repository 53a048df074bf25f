//! The linearity of calibrations against all triples, pairs and slopes, in another library's fractions.

use boundfit_exact::Rational;
use boundfit_questions::{
    CalibrationReading, Characteristic, Linearity, LinearityLine, LinearityOptions, Pass,
};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::linearity::{self, Fraction, Reading, whole};
use num_traits::Signed;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const CASES: usize = 3_000;

/// One to eight readings: plain, or of one or both directions; repeated x, equal readings, all x equal, all on a line.
fn case(rng: &mut ChaCha8Rng) -> Vec<Reading> {
    let count = rng.random_range(1..=8);
    let size = [0, 1, 3, 20][rng.random_range(0..4)];
    let noise = [0, 1, 2, 30][rng.random_range(0..4)];
    let slope = rng.random_range(-3..=3);
    let style = rng.random_range(0..4);
    let reading = |_| {
        let x = rng.random_range(-size..=size);
        let y = slope * x + rng.random_range(-noise..=noise);
        let up = match style {
            0 | 1 => None,
            2 => Some(true),
            _ => Some(rng.random_bool(0.5)),
        };
        (x, y, up)
    };
    let mut readings: Vec<Reading> = (0..count).map(reading).collect();
    if rng.random_bool(0.3) {
        readings.push(readings[0]);
    }
    readings
}

fn calibration(readings: &[Reading]) -> Vec<CalibrationReading> {
    let reading = |(row, (x, y, up)): (usize, &Reading)| CalibrationReading {
        row,
        x: Rational::from(*x),
        y: Rational::from(*y),
        pass: up.map(|up| if up { Pass::Up } else { Pass::Down }),
        equal: None,
    };
    (1..).zip(readings).map(reading).collect()
}

fn fraction(number: &Rational) -> Fraction {
    number.into()
}

/// The line, what it deviates and where, as the definitions have them.
fn check_line(
    line: &LinearityLine,
    characteristic: &Characteristic,
    points: &[(Fraction, Fraction, std::collections::BTreeSet<usize>)],
    deviation: &Fraction,
    full_scale: &Fraction,
    what: &str,
) {
    let [slope, intercept] = line.theta.each_ref().map(fraction);
    assert_eq!(fraction(&line.deviation), *deviation, "{what}");
    assert_eq!(linearity::largest(points, &slope, &intercept), *deviation, "{what}");
    assert_eq!(line.rows(characteristic), linearity::rows(points, &slope, &intercept), "{what}");
    let percent = full_scale.is_positive().then(|| deviation * whole(100) / full_scale);
    assert_eq!(line.percent.as_ref().map(fraction), percent, "{what}");
}

fn check(
    characteristic: &Characteristic,
    readings: &[Reading],
    only: Option<bool>,
    options: &LinearityOptions,
    through: [i64; 2],
    what: &str,
) {
    let points = linearity::points(readings, only);
    assert_eq!(characteristic.points.len(), points.len(), "{what}");
    let full_scale = match &options.full_scale {
        Some(given) => fraction(given),
        None => linearity::span(&points),
    };
    assert_eq!(fraction(&characteristic.full_scale), full_scale, "{what}");
    assert_eq!(fraction(&characteristic.span), linearity::span(&points), "{what}");
    let own = |line: &LinearityLine, deviation: &Fraction, name: &str| {
        check_line(line, characteristic, &points, deviation, &full_scale, &format!("{what}: {name}"));
    };
    own(&characteristic.independent, &linearity::independent(&points), "independent");
    own(&characteristic.zero_based, &linearity::zero_based(&points, through), "zero-based");
    let [slope, intercept] = &characteristic.zero_based.theta;
    let [x, y] = through.map(Rational::from);
    assert_eq!(slope * x + intercept, y, "{what}: not through the point");
    for (line, expected, name) in [
        (&characteristic.terminal, linearity::terminal(&points), "terminal"),
        (&characteristic.least_squares, linearity::least_squares(&points), "least squares"),
    ] {
        assert_eq!(line.is_ok(), expected.is_some(), "{what}: {name}");
        if let (Ok(line), Some((deviation, theta))) = (line, expected) {
            own(line, &deviation, name);
            assert_eq!(line.theta.each_ref().map(fraction), theta, "{what}: {name}");
        }
    }
    check_proof(characteristic, what);
}

/// Weights that add up to 1, with which the signed deviations of no line depend on the line.
fn check_proof(characteristic: &Characteristic, what: &str) {
    let line = &characteristic.independent;
    let proof = &characteristic.proof;
    assert_eq!(proof.is_empty(), line.deviation.is_zero(), "{what}");
    if proof.is_empty() {
        return;
    }
    assert!(proof.len() == 2 || proof.len() == 3, "{what}");
    let mut sums = [const { None::<Rational> }; 4];
    let mut add = |index: usize, value: Rational| {
        let sum = sums[index].take().unwrap_or_default();
        sums[index] = Some(sum + value);
    };
    for point in proof {
        let place = &characteristic.points[point.position];
        assert!(point.weight.is_positive(), "{what}");
        assert_eq!(point.deviation.abs(), line.deviation, "{what}");
        let signed = if point.deviation.is_negative() { -&point.weight } else { point.weight.clone() };
        add(0, point.weight.clone());
        add(1, signed.clone());
        add(2, &signed * &place.x);
        add(3, &signed * &place.y);
    }
    let [weights, of_one, of_x, of_y] = sums.map(Option::unwrap_or_default);
    assert_eq!((weights, of_one, of_x), (Rational::one(), Rational::zero(), Rational::zero()), "{what}");
    assert_eq!(of_y, line.deviation, "{what}");
    if proof.len() == 3 {
        assert!(
            proof.windows(2).all(|pair| pair[0].deviation.is_negative() != pair[1].deviation.is_negative()),
            "{what}: no alternation"
        );
    }
}

#[test]
fn every_way_to_state_linearity_is_as_its_definition_says() {
    let mut rng = seeded(161);
    let [mut vertical, mut exact, mut both, mut several] = [0; 4];
    for number in 0..share(CASES) {
        let readings = case(&mut rng);
        let through = match rng.random_range(0..3) {
            0 => [0, 0],
            // One of the points themselves may be asked for.
            1 => [readings[0].0, readings[0].1],
            _ => [rng.random_range(-4..=4), rng.random_range(-4..=4)],
        };
        let full_scale = rng.random_bool(0.3).then(|| Rational::ratio(rng.random_range(1..=9), 7));
        let options = LinearityOptions { full_scale, through: through.map(Rational::from) };
        let found = Linearity::new(&calibration(&readings), &options).expect("readings");
        let what = format!("case {number}: {readings:?} through {through:?}");
        check(&found.average, &readings, None, &options, through, &what);
        for (own, up) in [(&found.up, true), (&found.down, false)] {
            let is_there = readings.iter().any(|(.., pass)| *pass == Some(up));
            assert_eq!(own.is_some(), is_there, "{what}");
            if let Some(own) = own {
                check(own, &readings, Some(up), &options, through, &what);
            }
        }
        let value = |difference: &Option<boundfit_questions::Difference>| {
            difference.as_ref().map(|difference| fraction(&difference.value))
        };
        assert_eq!(value(&found.hysteresis), linearity::hysteresis(&readings), "{what}");
        assert_eq!(value(&found.repeatability), linearity::repeatability(&readings), "{what}");
        vertical += usize::from(found.average.terminal.is_err());
        exact += usize::from(found.average.proof.is_empty());
        both += usize::from(found.hysteresis.is_some());
        several += usize::from(!found.average.zero_based.unique);
    }
    let seen = [vertical, exact, both, several];
    assert!(seen.iter().all(|count| *count > share(100)), "{seen:?}");
}

#[test]
fn the_sensor_of_the_course_to_every_digit() {
    let rows = [
        ("0", "0.20", "0.20"),
        ("2", "0.85", "0.95"),
        ("4", "1.65", "1.80"),
        ("5", "1.95", "2.05"),
        ("8", "3.00", "3.10"),
        ("10", "4.05", "4.00"),
    ];
    let number = boundfit_tests::cli::numbers::rational;
    let readings: Vec<CalibrationReading> = (1..)
        .zip(rows)
        .flat_map(|(row, (x, up, down))| {
            [(up, Pass::Up), (down, Pass::Down)].map(|(y, pass)| CalibrationReading {
                row,
                x: number(x),
                y: number(y),
                pass: Some(pass),
                equal: None,
            })
        })
        .collect();
    let found = Linearity::new(&readings, &LinearityOptions::default()).unwrap();
    let deviations = |own: &Characteristic| {
        let lines = [&own.independent, own.terminal.as_ref().unwrap(), own.least_squares.as_ref().unwrap()];
        [lines[0], lines[1], lines[2], &own.zero_based].map(|line| line.deviation.to_string())
    };
    assert_eq!(deviations(&found.average), ["21/200", "21/100", "503/4130", "1/5"]);
    assert_eq!(deviations(found.up.as_ref().unwrap()), ["7/50", "7/25", "613/4130", "1/5"]);
    assert_eq!(deviations(found.down.as_ref().unwrap()), ["1/12", "7/50", "23/236", "1/5"]);
    let slopes = [&found.average.independent, found.average.terminal.as_ref().unwrap()];
    assert!(slopes.iter().all(|line| line.theta[0] == Rational::ratio(153, 400)));
    assert_eq!(found.average.least_squares.as_ref().unwrap().theta[0], Rational::ratio(155, 413));
    assert_eq!(found.average.full_scale, Rational::ratio(153, 40));
    assert_eq!(found.hysteresis.unwrap().value, Rational::ratio(3, 20));
    assert_eq!(found.average.independent.percent, Some(Rational::ratio(140, 51)));
}
