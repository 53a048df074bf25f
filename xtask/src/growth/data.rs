//! Files of rows that are the same at every run.

use std::fmt::Write as _;

use super::cases::Data;

/// Numbers that look random: the upper bits of a linear congruential generator (Knuth, MMIX).
struct Random(u64);

impl Random {
    /// A number from 0 to less than `end`.
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) % end
    }
}

impl Data {
    /// The ending of such a file.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Data::HalfPlanes => "ine",
            Data::Program => "lp",
            _ => "csv",
        }
    }

    /// The text of a file with so many rows.
    pub(super) fn text(self, rows: usize) -> String {
        match self {
            Data::Line => line(rows, 4, false),
            Data::Long => line(rows, 15, false),
            Data::Wrong => line(rows, 4, true),
            Data::Curve => {
                let row = |x: usize| format!("{x},{}\n", x * x);
                format!("x,y\n{}", (0..rows).map(row).collect::<String>())
            }
            Data::HalfPlanes => {
                let mut text = format!("H-representation\nbegin\n{rows} 3 rational\n");
                for [a1, a2, b] in around_disc(rows) {
                    let _ = writeln!(text, "{b} {} {}", -a1, -a2);
                }
                text + "end\n"
            }
            Data::Program => {
                let mut text = "Maximize\n objective: u + v\nSubject To\n".to_owned();
                for (index, [a1, a2, b]) in around_disc(rows).enumerate() {
                    let _ = writeln!(text, " c{index}: {a1} u + {a2} v <= {b}");
                }
                text + "Bounds\n u free\n v free\nEnd\n"
            }
        }
    }
}

/// Readings whose distance from y = 2·x + 1 is at most 1/2, with so many decimals; three of them are 50 too large if asked for.
fn line(rows: usize, decimals: usize, are_wrong: bool) -> String {
    let mut random = Random(1);
    let unit = 10_u64.pow(u32::try_from(decimals).unwrap_or_default());
    let number = |value: u64| format!("{}.{:0decimals$}", value / unit, value % unit);
    let mut text = "x,y,u,e,lo,hi,g\n".to_owned();
    for row in 0..rows {
        let [x, noise, u, e] = [100 * unit, unit, unit, unit / 2].map(|end| random.below(end));
        let wrong = if are_wrong && [rows / 4, rows / 2, 3 * rows / 4].contains(&row) { 50 } else { 0 };
        let y = 2 * x + unit / 2 + noise + wrong * unit;
        // Each column with its own digits; bounds are 1 away, and y is above 1/2.
        let [x, lo, hi] = [x, y + unit, y + 3 * unit].map(number);
        let [y, u, e] = [y + 2 * unit, u, unit + e].map(number);
        let group = ["a", "b"][row % 2];
        let _ = writeln!(text, "{x},{y},{u},{e},{lo},{hi},{group}");
    }
    text
}

/// Half-planes a1·u + a2·v ≤ b around a disc about the origin.
fn around_disc(rows: usize) -> impl Iterator<Item = [i64; 3]> {
    let mut random = Random(2);
    (0..rows).map(move |_| {
        let [a1, a2] = [(); 2].map(|()| random.below(2_000_001).cast_signed() - 1_000_000);
        // The norm, rounded, times a thousand: most half-planes touch the disc or nearly do.
        [a1, a2, 1000 * (a1 * a1 + a2 * a2).isqrt()]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_have_the_rows_that_are_asked_for() {
        for data in [Data::Line, Data::Long, Data::Wrong, Data::Curve] {
            assert_eq!(data.text(500).lines().count(), 501, "{data:?}");
        }
        assert_eq!(Data::HalfPlanes.text(10).lines().count(), 14);
        assert_eq!(Data::Line.text(100), Data::Line.text(100));
    }

    #[test]
    fn three_readings_are_wrong() {
        for rows in [500, 1000, 2000] {
            let [right, wrong] = [Data::Line, Data::Wrong].map(|data| data.text(rows));
            let differ = right.lines().zip(wrong.lines()).filter(|(one, other)| one != other);
            assert_eq!(differ.count(), 3, "{rows}");
        }
    }
}
