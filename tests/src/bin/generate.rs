//! Writes generated tables as CSV to standard output: `generate KIND COUNT [SEED]`.
//!
//! The same arguments give the same bytes. `benches/side-by-side` measures on these tables; 10⁷ rows take about a
//! second.

use std::io::{self, BufWriter, ErrorKind, StdoutLock, Write};
use std::process::ExitCode;

use boundfit_tests::generate::{seeded, shuffled};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const USAGE: &str = "usage: generate noise|intervals|regressors|extreme|ties|fleet|fleet-mixed COUNT [SEED]
COUNT is the number of rows, of a fleet the number of sensors.";

type Out<'a> = BufWriter<StdoutLock<'a>>;
type WriteRows = fn(usize, &mut ChaCha8Rng, &mut Out<'_>) -> io::Result<()>;

const KINDS: [(&str, WriteRows); 7] = [
    ("noise", noise),
    ("intervals", intervals),
    ("regressors", regressors),
    ("extreme", extreme),
    ("ties", ties),
    ("fleet", fleet),
    ("fleet-mixed", fleet_mixed),
];

/// Rows of one sensor of a fleet.
const ROWS_OF_A_SENSOR: usize = 23;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (name, count, seed) = match words[..] {
        [name, count] => (name, count.parse(), Ok(7)),
        [name, count, seed] => (name, count.parse(), seed.parse()),
        _ => return usage(),
    };
    let (Some(&(_, write_rows)), Ok(count), Ok(seed)) =
        (KINDS.iter().find(|(kind, _)| *kind == name), count, seed)
    else {
        return usage();
    };
    let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    match write_rows(count, &mut seeded(seed), &mut out).and_then(|()| out.flush()) {
        Ok(()) => ExitCode::SUCCESS,
        // The reader has seen enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("generate: {error}");
            ExitCode::FAILURE
        }
    }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}

/// y = 0.7·x + 12.5 + e with |e| ≤ 0.25, uniform.
fn noise(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"x,y\n")?;
    let mut line = Line::default();
    for _ in 0..count {
        let x: i64 = rng.random_range(0..1_000_000);
        let y = 70 * x + 12_500_000 + rng.random_range(-250_000..=250_000);
        line.write(out, &[(x, 4), (y, 6)])?;
    }
    Ok(())
}

/// Intervals that have 0.7·x + 12.5 between 0.05 and 0.55 below their upper and above their lower ends.
fn intervals(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"x,lower,upper\n")?;
    let mut line = Line::default();
    for _ in 0..count {
        let x: i64 = rng.random_range(0..1_000_000);
        let middle = 70 * x + 12_500_000;
        let [below, above] = [0; 2].map(|_| rng.random_range(50_000..=550_000));
        line.write(out, &[(x, 4), (middle - below, 6), (middle + above, 6)])?;
    }
    Ok(())
}

/// y = 0.7·u + 12.5·v + e with |e| ≤ 0.25, uniform.
fn regressors(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"u,v,y\n")?;
    let mut line = Line::default();
    for _ in 0..count {
        let u: i64 = rng.random_range(0..1_000_000);
        let v: i64 = rng.random_range(-500..=500);
        let y = 70 * u + 125_000 * v + rng.random_range(-250_000..=250_000);
        line.write(out, &[(u, 4), (v, 2), (y, 6)])?;
    }
    Ok(())
}

/// Points of two parabolas that bulge up and down, in random order: all of them are corners of the hull, and under
/// ε = 3 every row bounds the polygon.
fn extreme(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    if count > 2_000_000 {
        return Err(io::Error::other("at most 2000000 rows: further ones would not be extreme"));
    }
    out.write_all(b"x,y\n")?;
    let mut line = Line::default();
    for k in shuffled(rng, count) {
        let x = k as i64 - count as i64 / 2;
        let y = 1_000_000_000_000 - x * x;
        line.write(out, &[(x, 6), (if k % 2 == 0 { y } else { -y }, 12)])?;
    }
    Ok(())
}

/// Sixteen places and readings in steps of 0.01, as from a coarse converter: nearly every row repeats another one.
fn ties(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"x,y\n")?;
    let mut line = Line::default();
    for _ in 0..count {
        let x: i64 = rng.random_range(0..16);
        let y = 70 * x + 1250 + rng.random_range(-25..=25);
        line.write(out, &[(x, 0), (y, 2)])?;
    }
    Ok(())
}

/// Slope and offset of a sensor.
fn sensor(rng: &mut ChaCha8Rng) -> [i64; 2] {
    [rng.random_range(500..1500), rng.random_range(1_000_000..9_000_000)]
}

/// The reading of a sensor at its next place, with an error of up to 0.5.
fn reading(sensor: [i64; 2], step: usize, rng: &mut ChaCha8Rng) -> [(i64, usize); 2] {
    let x = 5 * step as i64 + rng.random_range(0..5);
    let y = sensor[0] * x * 10 + sensor[1] + rng.random_range(-500_000..=500_000);
    [(x, 2), (y, 6)]
}

/// One sensor after the other.
fn fleet(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"sensor,x,y\n")?;
    let mut line = Line::default();
    for number in 0..count {
        let sensor = sensor(rng);
        for step in 0..ROWS_OF_A_SENSOR {
            line.name(number);
            line.write(out, &reading(sensor, step, rng))?;
        }
    }
    Ok(())
}

/// All sensors take turns.
fn fleet_mixed(count: usize, rng: &mut ChaCha8Rng, out: &mut Out<'_>) -> io::Result<()> {
    out.write_all(b"sensor,x,y\n")?;
    let mut line = Line::default();
    let sensors: Vec<[i64; 2]> = (0..count).map(|_| sensor(rng)).collect();
    for step in 0..ROWS_OF_A_SENSOR {
        for (number, &sensor) in sensors.iter().enumerate() {
            line.name(number);
            line.write(out, &reading(sensor, step, rng))?;
        }
    }
    Ok(())
}

/// One line of text, put together without formatting machinery.
#[derive(Default)]
struct Line {
    text: Vec<u8>,
}

impl Line {
    /// Begins the line with the name of a sensor.
    fn name(&mut self, number: usize) {
        self.text.push(b's');
        self.decimal(number as i64, 0);
        self.text.push(b',');
    }

    /// Ends the line with numbers, given as integers and how many of their digits are decimals.
    fn write(&mut self, out: &mut Out<'_>, numbers: &[(i64, usize)]) -> io::Result<()> {
        for (position, &(number, decimals)) in numbers.iter().enumerate() {
            if position > 0 {
                self.text.push(b',');
            }
            self.decimal(number, decimals);
        }
        self.text.push(b'\n');
        let result = out.write_all(&self.text);
        self.text.clear();
        result
    }

    fn decimal(&mut self, number: i64, decimals: usize) {
        if number < 0 {
            self.text.push(b'-');
        }
        let mut digits = [b'0'; 20];
        let mut rest = number.unsigned_abs();
        let mut first = digits.len();
        while rest > 0 || digits.len() - first <= decimals {
            first -= 1;
            digits[first] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        let point = digits.len() - decimals;
        self.text.extend_from_slice(&digits[first..point]);
        if decimals > 0 {
            self.text.push(b'.');
            self.text.extend_from_slice(&digits[point..]);
        }
    }
}
