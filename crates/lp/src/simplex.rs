//! The exact simplex: programs in two free variables, solved on their dual.
//!
//! The dual of `min c·θ, a_k·θ ≤ b_k` is `min Σ b_k·λ_k, Σ λ_k·a_k = -c, λ ≥ 0`: two equations, one column per row.
//! Its prices are a point θ, and its λ are the multipliers that prove the optimum. Where the dual is unbounded, its
//! ray is a Farkas certificate. Where it is infeasible, the proof is a direction in which the objective falls.

use boundfit_exact::Rational;

use crate::outcome::{ExactOutcome, Multiplier};
use crate::program::{Program, Row};
use crate::standard_form::{Column, Ending, solve};

/// Solves a program exactly, with a proof of the outcome. Exact. Cost: linear in the number of rows per pivot.
///
/// ```
/// use boundfit_lp::{ExactOutcome, Program, Row, exact_simplex};
///
/// // θ1 ≥ 1 and θ1 ≤ 0, in ≤ form: the sum of both, each taken once, says 0 ≤ -1.
/// let rows = [(-1, -1), (1, 0)].map(|(a1, b)| Row { a: [a1.into(), 0.into()], b: b.into() });
/// let outcome = exact_simplex(&Program { rows: &rows, objective: [1.into(), 0.into()] });
/// assert!(matches!(outcome, ExactOutcome::Infeasible { multipliers } if multipliers.len() == 2));
/// ```
pub fn exact_simplex(program: &Program<'_>) -> ExactOutcome {
    ExactSimplex::new(program.rows).minimise(&program.objective)
}

/// Rows, ready to be asked about several objectives: see [`exact_simplex`].
#[derive(Debug, Clone)]
pub struct ExactSimplex {
    columns: Vec<Column>,
}

impl ExactSimplex {
    /// Brings each row over a denominator of its own. Cost: linear.
    pub fn new<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Self {
        let column = |Row { a: [a1, a2], b }: &Row| Column::new([a1, a2], b);
        ExactSimplex { columns: rows.into_iter().map(column).collect() }
    }

    /// Minimises a form over the rows, with a proof of the outcome. Exact. Cost: linear in the number of rows per pivot.
    pub fn minimise(&self, objective: &[Rational; 2]) -> ExactOutcome {
        outcome(&self.columns, objective)
    }
}

fn outcome(columns: &[Column], [c1, c2]: &[Rational; 2]) -> ExactOutcome {
    match solve(columns, &[-c1, -c2]) {
        Ending::Optimal { basis, prices } => {
            let value = c1 * &prices[0] + c2 * &prices[1];
            let rows = basis.iter().map(|(row, _)| *row).collect();
            ExactOutcome::Optimal { theta: prices, value, multipliers: positive(basis), basis: rows }
        }
        Ending::Unbounded { combination } => ExactOutcome::Infeasible { multipliers: positive(combination) },
        // No multipliers: the objective falls along the prices. The rows alone decide whether there is a point to
        // start from, and a zero objective asks for it.
        Ending::OutOfReach { prices: ray } => match solve(columns, &[Rational::zero(), Rational::zero()]) {
            Ending::Optimal { prices: theta, .. } => ExactOutcome::Unbounded { theta, ray },
            Ending::Unbounded { combination } => {
                ExactOutcome::Infeasible { multipliers: positive(combination) }
            }
            // Not reached: λ = 0 meets a zero target.
            Ending::OutOfReach { .. } => ExactOutcome::Infeasible { multipliers: Vec::new() },
        },
    }
}

/// The multipliers that are not 0, by row.
fn positive(columns: Vec<(usize, Rational)>) -> Vec<Multiplier> {
    let positive = columns.into_iter().filter(|(_, value)| !value.is_zero());
    let mut multipliers: Vec<Multiplier> = positive.map(|(row, value)| Multiplier { row, value }).collect();
    multipliers.sort_by_key(|multiplier| multiplier.row);
    multipliers
}

impl ExactOutcome {
    /// Recomputes the proof from the program. Exact; one pass over the rows.
    pub fn verify(&self, program: &Program<'_>) -> bool {
        let feasible = |theta: &[Rational; 2]| program.rows.iter().all(|row| !row.slack(theta).is_negative());
        let product = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[0] + &u[1] * &v[1];
        match self {
            ExactOutcome::Optimal { theta, value, multipliers, .. } => {
                let Some((form, bound)) = combine(program, multipliers, 2) else { return false };
                feasible(theta)
                    && product(&program.objective, theta) == *value
                    && form == program.objective.each_ref().map(|c| -c)
                    && bound == -value
            }
            ExactOutcome::Infeasible { multipliers } => combine(program, multipliers, 3)
                .is_some_and(|(form, bound)| form.iter().all(Rational::is_zero) && bound.is_negative()),
            ExactOutcome::Unbounded { theta, ray } => {
                feasible(theta)
                    && program.rows.iter().all(|row| !product(&row.a, ray).is_positive())
                    && product(&program.objective, ray).is_negative()
            }
        }
    }
}

/// The combination of at most `most` rows with positive multipliers, or `None` when they are not that.
fn combine(
    program: &Program<'_>,
    multipliers: &[Multiplier],
    most: usize,
) -> Option<([Rational; 2], Rational)> {
    let mut form = [Rational::zero(), Rational::zero()];
    let mut bound = Rational::zero();
    for Multiplier { row, value } in multipliers {
        let Row { a, b } = program.rows.get(*row).filter(|_| value.is_positive())?;
        form = [&form[0] + &a[0] * value, &form[1] + &a[1] * value];
        bound = bound + b * value;
    }
    (multipliers.len() <= most).then_some((form, bound))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(rows: &[[i64; 3]]) -> Vec<Row> {
        rows.iter().map(|&[a1, a2, b]| Row { a: [a1.into(), a2.into()], b: b.into() }).collect()
    }

    #[test]
    fn each_outcome_by_hand() {
        let triangle = rows(&[[-1, 0, 0], [0, -1, 0], [2, 3, 6]]);
        let minus_sum = Program { rows: &triangle, objective: [Rational::from(-1), Rational::from(-1)] };
        let outcome = exact_simplex(&minus_sum);
        let ExactOutcome::Optimal { theta, value, .. } = &outcome else { panic!("{outcome:?}") };
        assert_eq!((theta, value), (&[Rational::from(3), Rational::zero()], &Rational::from(-3)));
        assert!(outcome.verify(&minus_sum));

        let strip = rows(&[[1, 0, 1], [-1, 0, 0]]);
        let along = Program { rows: &strip, objective: [Rational::zero(), Rational::one()] };
        assert!(matches!(exact_simplex(&along), ExactOutcome::Unbounded { .. }));
        assert!(exact_simplex(&along).verify(&along));
        let across = Program { rows: &strip, objective: [Rational::one(), Rational::zero()] };
        assert!(matches!(exact_simplex(&across), ExactOutcome::Optimal { .. }));
        assert!(exact_simplex(&across).verify(&across));

        let empty = rows(&[[1, 0, -1], [-1, 0, 0]]);
        let along = Program { rows: &empty, objective: [Rational::zero(), Rational::one()] };
        assert!(matches!(exact_simplex(&along), ExactOutcome::Infeasible { .. }));
        assert!(exact_simplex(&along).verify(&along));

        let free = Program { rows: &[], objective: [Rational::one(), Rational::zero()] };
        assert!(exact_simplex(&free).verify(&free));
        let never = rows(&[[0, 0, -1]]);
        let never = Program { rows: &never, objective: [Rational::one(), Rational::zero()] };
        assert!(matches!(exact_simplex(&never), ExactOutcome::Infeasible { .. }));
        assert!(exact_simplex(&never).verify(&never));
    }

    /// Every outcome is proved on all sets of four rows from a cycle of small ones: ties, parallels, zero normals and
    /// zero objectives.
    #[test]
    fn small_programs_are_solved_with_proofs() {
        let number = |index: usize, step: usize| (index * step % 1_009 % 5) as i64 - 2;
        let row = |index: usize| [number(index, 17), number(index, 71), number(index, 313)];
        let mut outcomes = [0; 3];
        for start in 0..600 {
            let rows = rows(&[0, 1, 2, 3].map(|k| row(7 * start + 5 * k)));
            for c in [[1, 0], [-1, 0], [0, 1], [2, -1], [0, 0]] {
                let program = Program { rows: &rows, objective: c.map(Rational::from) };
                let outcome = exact_simplex(&program);
                assert!(outcome.verify(&program), "{program:?} {outcome:?}");
                match &outcome {
                    ExactOutcome::Optimal { multipliers, basis, .. } => {
                        assert!(multipliers.iter().all(|multiplier| basis.contains(&multiplier.row)));
                        outcomes[0] += 1;
                    }
                    ExactOutcome::Infeasible { .. } => outcomes[1] += 1,
                    ExactOutcome::Unbounded { .. } => outcomes[2] += 1,
                }
            }
        }
        assert!(outcomes.iter().all(|count| *count > 200), "{outcomes:?}");
    }

    /// A zero objective has both basic values 0, so that rows tie all the way. Each of these programs goes round for
    /// ever when ties are broken in another way. The other ways are: by the higher row, by the lower row, against the
    /// order of the columns, or by whether a column comes first of all.
    #[test]
    fn ties_do_not_make_it_go_round_for_ever() {
        let programs: [&[[i64; 3]]; 4] = [
            &[[1, 3, 3], [2, -2, -3], [0, 3, 2], [-2, -3, -2], [1, -2, -1], [-3, -1, 2]],
            &[[2, -1, 1], [3, -2, -3], [-2, 0, 0], [3, 2, 0], [1, 1, 3], [-3, -1, 3]],
            &[[2, 2, -1], [1, -3, 0], [1, -1, 1], [1, 1, -2], [3, 1, -2], [1, -2, 3]],
            &[
                [1, -2, 3],
                [1, -1, -1],
                [-3, -1, -1],
                [0, 2, -1],
                [3, -2, -1],
                [-1, -1, 1],
                [0, -1, 2],
                [-1, 2, 2],
            ],
        ];
        for program in programs {
            let rows = rows(program);
            let zero = Program { rows: &rows, objective: [Rational::zero(), Rational::zero()] };
            let outcome = exact_simplex(&zero);
            assert!(outcome.verify(&zero), "{program:?}: {outcome:?}");
        }
    }

    #[test]
    fn a_wrong_outcome_does_not_verify() {
        let triangle = rows(&[[-1, 0, 0], [0, -1, 0], [2, 3, 6]]);
        let sum = Program { rows: &triangle, objective: [Rational::from(-2), Rational::from(-3)] };
        let whole = |numbers: [i64; 2]| numbers.map(Rational::from);
        let by = |multipliers: &[(usize, i64)]| -> Vec<Multiplier> {
            multipliers.iter().map(|&(row, value)| Multiplier { row, value: value.into() }).collect()
        };
        let optimal = |theta, value: i64, multipliers: &[(usize, i64)]| {
            let (value, multipliers) = (Rational::from(value), by(multipliers));
            ExactOutcome::Optimal { theta: whole(theta), value, multipliers, basis: Vec::new() }
        };
        assert!(optimal([3, 0], -6, &[(2, 1)]).verify(&sum));
        assert!(optimal([0, 2], -6, &[(2, 1)]).verify(&sum));
        for wrong in [
            optimal([6, -2], -6, &[(2, 1)]),
            optimal([0, 0], -6, &[(2, 1)]),
            optimal([3, 0], -5, &[(2, 1)]),
            optimal([3, 0], -6, &[(2, 2)]),
            optimal([3, 0], -6, &[(3, 1)]),
            optimal([3, 0], -6, &[]),
            optimal([3, 0], -6, &[(2, 2), (2, -1)]),
            optimal([3, 0], -6, &[(2, 1), (2, 0)]),
            optimal([0, 0], 0, &[]),
        ] {
            assert!(!wrong.verify(&sum), "{wrong:?}");
        }
        let thirds = vec![Multiplier { row: 2, value: Rational::ratio(1, 3) }; 3];
        let value = Rational::from(-6);
        let split =
            ExactOutcome::Optimal { theta: whole([3, 0]), value, multipliers: thirds, basis: Vec::new() };
        assert!(!split.verify(&sum));

        let empty = rows(&[[1, 0, -1], [-1, 0, 0], [0, 1, 0], [1, 0, 1]]);
        let empty = Program { rows: &empty, objective: whole([0, 1]) };
        let infeasible =
            |multipliers: &[(usize, i64)]| ExactOutcome::Infeasible { multipliers: by(multipliers) };
        assert!(infeasible(&[(0, 1), (1, 1)]).verify(&empty));
        for wrong in [
            &[(1, 1), (3, 1)][..],
            &[(0, 1)],
            &[(0, 1), (1, 1), (2, 1)],
            &[(0, 1), (1, 1), (0, 1), (1, 1)],
            &[],
        ] {
            assert!(!infeasible(wrong).verify(&empty), "{wrong:?}");
        }

        let strip = rows(&[[1, 0, 1], [-1, 0, 0]]);
        let along = Program { rows: &strip, objective: whole([0, -2]) };
        let unbounded = |theta, ray| ExactOutcome::Unbounded { theta: whole(theta), ray: whole(ray) };
        assert!(unbounded([1, 7], [0, 1]).verify(&along));
        for (theta, ray) in
            [([2, 0], [0, 1]), ([0, 0], [0, -1]), ([0, 0], [0, 0]), ([0, 0], [1, 1]), ([0, 0], [-1, 1])]
        {
            assert!(!unbounded(theta, ray).verify(&along), "{theta:?} {ray:?}");
        }
    }
}
