//! The least factor on all bounds, of x and of y, that leaves a line.
//!
//! At a factor that is too small three rows at most contradict each other, and ask for a larger one by themselves
//! ([`least_of_few`]). From factor 0 on the larger one is tried next, until a factor leaves something of all rows: it is the least one, since
//! the rows that ask for it are among all. Each step asks for more than the one before, and there are finitely many triples of rows.
//!
//! Two ratios of linear functions of the slope are equal where a quadratic equation says so, so that a factor may be irrational. Then
//! the rows that ask for it leave a single point, and whether the others contain it is decided by arithmetic with one square root.

use boundfit_estimation::{BoundName, conditions_by_name, growing_half_planes};
use boundfit_exact::{Rational, Sign, Surd};
use boundfit_geometry::{Inequality, Polyhedron, Region, Support, System, envelope};
use thiserror::Error;

use super::few::{Few, Row, least_of_few};
use super::{Agreement, Side, XErrorProblem};

/// The least factor s on all bounds s·ε_i and s·δ_i for which some line agrees with all readings. Under strong agreement larger factors
/// leave more only as long as |θ1|·δ_i ≤ ε_i: it is the least one among such lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeastFactor {
    /// A rational number, or the root of a quadratic equation.
    pub value: Surd,
    /// Whether it leaves a line; otherwise every larger factor does, the closer the steeper.
    pub is_attained: bool,
    /// The side of such a line, [`Side::Rising`] where both have one.
    pub side: Side,
    /// Such a line; `None` where there is none.
    pub theta: Option<[Surd; 2]>,
    /// At most three bounds of readings and conditions that leave nothing under a smaller factor on this side. None where the factor is
    /// 0.
    pub fixed_by: Vec<BoundName>,
}

/// Why there is no least factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoLeastFactor {
    /// No factor, however large, leaves anything.
    #[error("no factor on the bounds, however large, is enough")]
    Never,
    /// A factor on its error in x asks for more of a reading without two bounds on y.
    #[error(
        "a reading without both bounds on y, or with bounds that cross, becomes stricter as the bound on its x grows"
    )]
    NotMonotone,
}

impl LeastFactor {
    /// The least factor of readings with errors in x. Exact. Cost: O(n log n) for each step, of which a few suffice in practice.
    ///
    /// # Errors
    /// When there is none.
    pub fn new(problem: &XErrorProblem) -> Result<Self, NoLeastFactor> {
        let [rising, falling] = LeastFactor::of_sides(problem);
        LeastFactor::best(rising?, falling?)
    }

    /// The one of both sides that leaves more.
    pub(super) fn best(rising: Option<Self>, falling: Option<Self>) -> Result<Self, NoLeastFactor> {
        let found = rising.into_iter().chain(falling);
        found
            .reduce(|best, next| {
                let is_better = next.value < best.value
                    || next.value == best.value && next.is_attained && !best.is_attained;
                if is_better { next } else { best }
            })
            .ok_or(NoLeastFactor::Never)
    }

    /// The least factors of rising and of falling lines; `None` where none is enough.
    pub(super) fn of_sides(problem: &XErrorProblem) -> [Result<Option<Self>, NoLeastFactor>; 2] {
        let is_strong = problem.agreement() == Agreement::Strong;
        let grows = |half_width: Option<&Rational>| half_width.is_some_and(|own| !own.is_negative());
        let is_stricter =
            problem.readings().any(|(row, width)| width.is_positive() && !grows(row.half_width().as_deref()));
        if is_strong && is_stricter {
            return [Err(NoLeastFactor::NotMonotone), Err(NoLeastFactor::NotMonotone)];
        }
        [Side::Rising, Side::Falling].map(|side| Ok(SideRows::new(problem, side).least()))
    }

    /// Whether the bounds as they are leave a line, as this factor has it.
    pub fn is_enough(&self) -> bool {
        match self.value.cmp(&Rational::one().into()) {
            std::cmp::Ordering::Less => true,
            std::cmp::Ordering::Equal => self.is_attained,
            std::cmp::Ordering::Greater => false,
        }
    }
}

/// The rows of one side, with |θ1| as a variable.
struct SideRows {
    side: Side,
    names: Vec<BoundName>,
    rows: Vec<Row>,
    /// The largest λ at which no row gets stricter as the factor grows.
    top: Rational,
}

impl SideRows {
    fn new(problem: &XErrorProblem, side: Side) -> Self {
        let is_strong = problem.agreement() == Agreement::Strong;
        let towards = |slope: &Rational| if side == Side::Falling { -slope } else { slope.clone() };
        let readings = problem.readings().flat_map(|(row, width)| {
            let of_x = if is_strong { -width } else { width.clone() };
            growing_half_planes(row).map(move |(name, own)| {
                let Inequality { a: [slope, offset], b: bound } = own.at_zero;
                let slope = towards(&slope);
                (name, Row { slope, offset, bound, of_y: own.growth, of_x: of_x.clone() })
            })
        });
        let conditions = conditions_by_name(&problem.problem().conditions).map(|(name, own)| {
            let Inequality { a: [slope, offset], b: bound } = own;
            let (of_y, of_x) = (Rational::zero(), Rational::zero());
            (name, Row { slope: towards(&slope), offset, bound, of_y, of_x })
        });
        let (names, rows): (Vec<BoundName>, Vec<Row>) = readings.chain(conditions).unzip();
        // of_y·(1 - λ) + of_x·λ ≥ 0
        let tops = rows.iter().filter(|row| row.of_x.is_negative());
        let tops = tops.filter_map(|row| row.of_y.checked_div(&(&row.of_y - &row.of_x)));
        let top = tops.min().unwrap_or_else(Rational::one);
        SideRows { side, names, rows, top }
    }

    fn least(&self) -> Option<LeastFactor> {
        // A condition that no line meets would have no say where λ = 1.
        let is_met_nowhere =
            |row: &Row| row.slope.is_zero() && row.offset.is_zero() && row.bound.is_negative();
        if self.rows.iter().any(is_met_nowhere) {
            return None;
        }
        let mut few: Vec<usize> = Vec::new();
        let mut least = least_of_few(&[], &self.top)?;
        loop {
            let more = match least.factor.rational() {
                Some(factor) => self.contradiction(factor),
                None => self.most_violated(&few, &least).map(|row| {
                    few.push(row);
                    std::mem::take(&mut few)
                }),
            };
            let Some(more) = more else { break };
            let next = self.least_of(&more)?;
            debug_assert!(next.factor > least.factor, "a step that leads nowhere");
            few = self.fewest(more, &next);
            least = next;
        }
        let (theta, is_attained) = match least.factor.rational() {
            Some(factor) => {
                let theta = self.line_at(factor);
                let is_attained = theta.is_some();
                (theta.map(|theta| theta.map(Surd::from)), is_attained)
            }
            None => (self.line_of(&few, &least), true),
        };
        let mut fixed_by: Vec<BoundName> = few.iter().map(|&index| self.names[index]).collect();
        fixed_by.sort();
        Some(LeastFactor { value: least.factor, is_attained, side: self.side, theta, fixed_by })
    }

    fn least_of(&self, indices: &[usize]) -> Option<Few> {
        let rows: Vec<&Row> = indices.iter().map(|&index| &self.rows[index]).collect();
        least_of_few(&rows, &self.top)
    }

    /// At most three of some rows that ask for as much as these do.
    fn fewest(&self, mut indices: Vec<usize>, asked: &Few) -> Vec<usize> {
        indices.sort_unstable();
        indices.dedup();
        for position in (0..indices.len()).rev() {
            let mut without = indices.clone();
            without.remove(position);
            if self.least_of(&without).is_some_and(|own| own.factor == asked.factor) {
                indices = without;
            }
        }
        indices
    }

    /// The half-planes of (λ, v) of some rows at a factor, and the ends of λ.
    fn system(&self, indices: &[usize], factor: &Rational, top: &Rational) -> System {
        let zero = Rational::zero;
        let ends = [
            Inequality::new(-Rational::one(), zero(), zero()),
            Inequality::new(Rational::one(), zero(), top.clone()),
        ];
        indices.iter().map(|&index| self.rows[index].at(factor)).chain(ends).collect()
    }

    /// At most three rows that leave nothing at a factor, nor at others that are hardly larger; `None` when something is left at the
    /// factor or at all larger ones.
    fn contradiction(&self, factor: &Rational) -> Option<Vec<usize>> {
        let every: Vec<usize> = (0..self.rows.len()).collect();
        let polyhedron = Polyhedron::intersect(self.system(&every, factor, &self.top));
        let rows_of = |region: &Region, among: &[usize]| {
            let multipliers = region.certificate()?.multipliers().iter();
            Some(multipliers.filter_map(|own| among.get(own.index).copied()).collect())
        };
        let towards_level = [-Rational::one(), Rational::zero()];
        let proof = match polyhedron.support(&towards_level) {
            Support::Empty(_) => return rows_of(polyhedron.region(), &every),
            Support::Bounded { proof, .. } if -&proof.value == Rational::one() => proof,
            _ => return None,
        };
        // Nothing but one point with λ = 1 is left, where rows of one x without an error in it have no say, though lines as steep as one likes
        // have to meet them. All else makes room around the point as the factor grows.
        let v = proof.attained_at.theta2();
        let is_there = |index: &usize| {
            let Row { slope, offset, of_x, .. } = &self.rows[*index];
            of_x.is_zero() && !offset.is_zero() && (slope + offset * &v).is_zero()
        };
        let there: Vec<usize> = every.into_iter().filter(is_there).collect();
        // Of one x the slope does not matter.
        rows_of(&envelope::intersect(&self.system(&there, factor, &Rational::zero())), &there)
    }

    /// A line that a factor leaves; `None` when it leaves none.
    fn line_at(&self, factor: &Rational) -> Option<[Rational; 2]> {
        let every: Vec<usize> = (0..self.rows.len()).collect();
        let polyhedron = Polyhedron::intersect(self.system(&every, factor, &self.top));
        let one = Rational::one();
        // Whether there is a λ below 1.
        let Support::Bounded { proof, .. } = polyhedron.support(&[-&one, Rational::zero()]) else {
            return None;
        };
        if -&proof.value == one {
            return None;
        }
        let [lambda, v] = polyhedron.region().witness()?.coordinates();
        let over = (one - &lambda).recip()?;
        let theta1 = lambda * &over;
        Some([if self.side == Side::Falling { -theta1 } else { theta1 }, v * over])
    }

    /// The only point that few rows leave at an irrational least factor of theirs.
    fn point(&self, few: &[usize], Few { factor, lambda }: &Few) -> Option<[Surd; 2]> {
        let zero = Surd::from(Rational::zero());
        let above = |&index: &usize| {
            let row = &self.rows[index];
            let at_zero = row.slack(factor, &[lambda.clone(), zero.clone()]);
            let over = row.offset.recip().filter(Rational::is_positive)?;
            Some(Surd::sum([(&over, &at_zero)]))
        };
        Some([lambda.clone(), few.iter().filter_map(above).min()?])
    }

    /// The row that this point violates most, if it violates one.
    fn most_violated(&self, few: &[usize], least: &Few) -> Option<usize> {
        let point = self.point(few, least)?;
        let slacks = self.rows.iter().map(|row| row.slack(&least.factor, &point)).enumerate();
        let worst = slacks.min_by(|one, other| one.1.cmp(&other.1))?;
        (worst.1.sign() == Sign::Negative).then_some(worst.0)
    }

    /// The only line that an irrational least factor leaves.
    fn line_of(&self, few: &[usize], least: &Few) -> Option<[Surd; 2]> {
        let [lambda, v] = self.point(few, least)?;
        let one = Rational::one();
        let towards = if self.side == Side::Falling { -&one } else { one.clone() };
        let over = Surd::sum([(&one, &one.clone().into()), (&-&one, &lambda)]).recip()?;
        let theta1 = lambda.product(&over);
        Some([Surd::sum([(&towards, &theta1)]), v.product(&over)])
    }
}
