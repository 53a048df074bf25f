//! Generated tables of readings as text, the same on every run.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// The kind of readings in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableKind {
    /// A line with uniform noise, to a fixed number of decimals.
    Noise,
    /// Few distinct values: ties, repeated rows, runs within edges.
    Ties,
    /// All on one line.
    Collinear,
    /// One x only.
    Vertical,
    /// A convex chain: every row is extreme.
    Extreme,
    /// Decimals of different lengths, exponents and signs.
    MixedDecimals,
    /// A line with noise, all 16 or 17 digits of binary64 numbers printed.
    LongDecimals,
    /// A band of decimals of 3 to 70 digits, which no machine integers hold together.
    ManyDigits,
    /// Integers of 18 to 20 digits around the powers of two from 2^61 to 2^64.
    WideIntegers,
    /// 1e300 beside 1e-300.
    FarApart,
    /// Fractions among decimals.
    Fractions,
}

impl TableKind {
    /// All of them.
    pub const ALL: [TableKind; 11] = [
        TableKind::Noise,
        TableKind::Ties,
        TableKind::Collinear,
        TableKind::Vertical,
        TableKind::Extreme,
        TableKind::MixedDecimals,
        TableKind::LongDecimals,
        TableKind::ManyDigits,
        TableKind::WideIntegers,
        TableKind::FarApart,
        TableKind::Fractions,
    ];

    /// The cells of `count` rows.
    pub fn rows(self, rng: &mut ChaCha8Rng, count: usize) -> Vec<[String; 2]> {
        let own = rng.random_range(-50..=50_i64);
        (0..count).map(|row| self.row(rng, own, row as i64)).collect()
    }

    fn row(self, rng: &mut ChaCha8Rng, own: i64, row: i64) -> [String; 2] {
        let small = |rng: &mut ChaCha8Rng| rng.random_range(-3..=3_i64);
        match self {
            TableKind::Noise => {
                let x = rng.random_range(-10_000..=10_000_i64);
                let y = own * x + 100 * rng.random_range(-500..=500_i64);
                [format!("{}", x as f64 / 100.0), format!("{:.4}", y as f64 / 10_000.0)]
            }
            TableKind::Ties => [small(rng).to_string(), small(rng).to_string()],
            TableKind::Collinear => {
                let x = small(rng);
                [x.to_string(), (own * x + 7).to_string()]
            }
            TableKind::Vertical => [own.to_string(), small(rng).to_string()],
            TableKind::Extreme => [row.to_string(), (row * row).to_string()],
            TableKind::MixedDecimals => [mixed_decimal(rng), mixed_decimal(rng)],
            TableKind::LongDecimals => {
                let x = rng.random_range(-5.0..5.0_f64);
                let y = own as f64 * x + rng.random_range(-0.1..0.1_f64);
                let power = if row % 7 == 0 { 1e-4 } else { 1.0 };
                [(x * power).to_string(), (y * power).to_string()]
            }
            TableKind::ManyDigits => [many_digits(rng, 20), many_digits(rng, 3)],
            TableKind::WideIntegers => [wide_integer(rng), wide_integer(rng)],
            TableKind::FarApart => {
                let exponent = [300, -300, 0, 299][rng.random_range(0..4)];
                [format!("{}e{exponent}", small(rng)), format!("{}e{}", small(rng), -exponent)]
            }
            TableKind::Fractions => {
                let fraction = format!("{}/{}", small(rng), rng.random_range(1..=7));
                [fraction, small(rng).to_string()]
            }
        }
    }
}

fn mixed_decimal(rng: &mut ChaCha8Rng) -> String {
    let (whole, part) = (rng.random_range(-20..=20_i64), rng.random_range(0..=99_u32));
    match rng.random_range(0..4) {
        0 => whole.to_string(),
        1 => format!("{whole}.{part:02}"),
        2 => format!("{whole}.{}e{}", part % 10, rng.random_range(-4..=4)),
        _ => format!("{whole}.5"),
    }
}

/// Returns a number near the whole numbers up to one of them, more or less.
fn many_digits(rng: &mut ChaCha8Rng, most: i64) -> String {
    let digits = [3, 15, 17, 19, 25, 37, 40, 70][rng.random_range(0..8)];
    let part: String = (0..digits).map(|_| char::from(b'0' + rng.random_range(0..=9_u8))).collect();
    let sign = if rng.random_bool(0.5) { "-" } else { "" };
    format!("{sign}{}.{part}{}", rng.random_range(0..=most), ["", "e0", "E-3"][rng.random_range(0..3)])
}

fn wide_integer(rng: &mut ChaCha8Rng) -> String {
    let edge = 1_i128 << rng.random_range(61..=64);
    let value = edge + rng.random_range(-2..=2_i128);
    if rng.random_bool(0.5) { value.to_string() } else { (-value).to_string() }
}
