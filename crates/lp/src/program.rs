//! Linear programs in two free variables.

use boundfit_exact::Rational;

/// `a·θ ≤ b`, exactly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// The coefficients of θ1 and θ2.
    pub a: [Rational; 2],
    /// The right-hand side.
    pub b: Rational,
}

impl Row {
    /// `b - a·θ`: negative where the row is violated.
    pub fn slack(&self, theta: &[Rational; 2]) -> Rational {
        &self.b - &self.a[0] * &theta[0] - &self.a[1] * &theta[1]
    }
}

/// `min objective·θ` subject to the rows; θ is free. The objective is one of the directions of the rows' units.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program<'a> {
    /// The constraints.
    pub rows: &'a [Row],
    /// The form to be minimised.
    pub objective: [Rational; 2],
}

/// A program as a floating-point solver receives it: every number rounded to the nearest binary64.
#[derive(Debug, Clone, PartialEq)]
pub struct FloatProgram {
    /// `[a1, a2, b]` of each row.
    pub rows: Vec<[f64; 3]>,
    /// The form to be minimised.
    pub objective: [f64; 2],
}

impl FloatProgram {
    /// Rounds a program. The referee judges answers against the rounded rows too.
    pub fn new(program: &Program<'_>) -> Self {
        let rows = program.rows.iter().map(|Row { a: [a1, a2], b }| [a1.to_f64(), a2.to_f64(), b.to_f64()]);
        FloatProgram { rows: rows.collect(), objective: program.objective.each_ref().map(Rational::to_f64) }
    }

    /// Returns whether every number is finite: solvers are not asked otherwise.
    pub fn is_finite(&self) -> bool {
        self.rows.iter().flatten().chain(&self.objective).all(|value| value.is_finite())
    }

    /// The rounded rows, taken exactly; `None` when one is not finite.
    pub fn exact_rows(&self) -> Option<Vec<Row>> {
        let exact = |row: &[f64; 3]| {
            let [a1, a2, b] = row.map(Rational::from_f64);
            Some(Row { a: [a1?, a2?], b: b? })
        };
        self.rows.iter().map(exact).collect()
    }
}

/// `count` objectives spread evenly around the circle, (sin 2πk/n, cos 2πk/n) for k = 0, 1, …, as binary64 numbers
/// taken exactly. Axes and diagonals are exact, and directions that mirror each other do so exactly.
pub fn spread_objectives(count: usize) -> Vec<[Rational; 2]> {
    let direction = |k: usize| {
        // The place within its eighth of the circle; odd eighths are mirror images of even ones.
        let (eighth, rest) = (8 * k / count, 8 * k % count);
        let rest = if eighth % 2 == 0 { rest } else { count - rest };
        let angle = std::f64::consts::FRAC_PI_4 * rest as f64 / count as f64;
        let (sine, cosine) = if rest == count {
            (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2)
        } else {
            angle.sin_cos()
        };
        match eighth {
            0 => [sine, cosine],
            1 => [cosine, sine],
            2 => [cosine, -sine],
            3 => [sine, -cosine],
            4 => [-sine, -cosine],
            5 => [-cosine, -sine],
            6 => [-cosine, sine],
            _ => [-sine, cosine],
        }
        .map(|value| Rational::from_f64(value).unwrap_or_default())
    };
    (0..count).map(direction).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objectives_go_around_the_circle_and_mirror_each_other() {
        for count in [1, 2, 3, 5, 8, 16, 24, 100, 1000] {
            let objectives = spread_objectives(count);
            assert_eq!(objectives.len(), count);
            for (k, objective) in objectives.iter().enumerate() {
                let angle = std::f64::consts::TAU * k as f64 / count as f64;
                let [sine, cosine] = objective.each_ref().map(Rational::to_f64);
                assert!(
                    (sine - angle.sin()).abs() < 1e-14 && (cosine - angle.cos()).abs() < 1e-14,
                    "{k}/{count}"
                );
                let [s, c] = objective;
                let has = |mirrored: [Rational; 2]| objectives.contains(&mirrored);
                assert!(has([-s, c.clone()]), "{k}/{count} to the left");
                assert!(count % 2 != 0 || has([-s, -c]), "{k}/{count} to the opposite");
                assert!(count % 4 != 0 || has([c.clone(), s.clone()]), "{k}/{count} over the diagonal");
            }
        }
        assert_eq!(spread_objectives(8)[1][0], spread_objectives(8)[1][1]);
        assert_eq!(spread_objectives(4)[1], [Rational::one(), Rational::zero()]);
    }
}
