//! Predictions: the line elsewhere, a further reading there, and the x that a reading may come from.
//!
//! At x the feasible lines reach from m(x) = min θ1·x + θ2 to M(x) = max θ1·x + θ2. A further reading whose error is
//! at most ε lies in [m(x) - ε, M(x) + ε]. A reading y may come from each x where M(x) ≥ y - ε and m(x) ≤ y + ε. M is
//! convex and m is concave, so the excluded x are two intervals at most: where all lines are too low, and where all
//! are too high. If there are both, every line rises, or every line falls, from one to the other, so that one of them
//! goes on without end. At most two intervals are left.

mod further;
mod valley;

use boundfit_estimation::Corridor;
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Polyhedron, Support};

pub use further::{FurtherError, NoFurtherError};

use valley::{Gap, GapEnd, Valley};

/// Predictions from a feasible set that is not empty.
#[derive(Debug, Clone)]
pub struct Predictor<'a> {
    set: &'a Polyhedron,
    corridor: Corridor,
}

/// An interval of x that a reading may come from; without an end it goes on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PossibleX {
    /// The lower end of the interval.
    pub lower: Option<PossibleEnd>,
    /// The upper end of the interval.
    pub upper: Option<PossibleEnd>,
}

/// The end of an interval of x.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PossibleEnd {
    /// The x.
    pub x: Rational,
    /// `true` if a reading may come from this very x. Otherwise it may come from any x beyond, however near: a line's
    /// value may be bounded at a single x if the set has no end.
    pub included: bool,
    /// `true` if the upper end of the line's interval at this x decides, where further on all lines are too low.
    pub by_upper: bool,
}

impl<'a> Predictor<'a> {
    /// Gets ready to predict; `None` when the set is empty. Cost: O(n log n) for n vertices.
    ///
    /// ```
    /// use boundfit_exact::{Interval, Rational};
    /// use boundfit_geometry::{Inequality, Polyhedron};
    /// use boundfit_questions::{FurtherError, Predictor};
    ///
    /// // Readings 0 at x = 0 and 2 at x = 2, each known to 1/2.
    /// let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), Rational::from(b).half());
    /// let rows = [row(0, 1, 1), row(0, -1, 1), row(2, 1, 5), row(-2, -1, -3)];
    /// let set = Polyhedron::intersect(rows.into_iter().collect());
    /// let predictor = Predictor::new(&set).unwrap();
    /// let [one, half] = [Rational::one(), Rational::ratio(1, 2)];
    /// assert_eq!(Some(predictor.line(&one)), Interval::around(&one, &half));
    /// let error = FurtherError::within(half);
    /// assert_eq!(error.around(&predictor.line(&one), &one), Interval::around(&one, &one));
    /// let [source] = &predictor.sources(&one, &error)[..] else { panic!("one interval") };
    /// assert_eq!(source.lower.as_ref().unwrap().x, Rational::zero());
    /// ```
    pub fn new(set: &'a Polyhedron) -> Option<Self> {
        Some(Predictor { set, corridor: Corridor::new(set)? })
    }

    /// The values of the lines at an x. Exact. Cost: logarithmic.
    pub fn line(&self, x: &Rational) -> Interval {
        let Corridor { lower, upper } = &self.corridor;
        Interval::new(lower.value(x).into(), upper.value(x).into()).unwrap_or_else(whole)
    }

    /// The values of φ·θ. Exact. Cost: logarithmic.
    pub fn form(&self, form: &[Rational; 2]) -> Interval {
        self.set.range(form).unwrap_or_else(whole)
    }

    /// Returns the proof that φ·θ is not smaller, as the maximum of -φ·θ, and the proof that it is not larger. Exact.
    /// Cost: linear in the number of vertices.
    pub fn ends(&self, form: &[Rational; 2]) -> [Support; 2] {
        [self.set.support(&form.each_ref().map(|part| -part)), self.set.support(form)]
    }

    /// The x that a reading y may come from, ascending: at most two intervals, none where no line comes near y. Where |x| has
    /// a say in the reading's error, `error` says where x is 0. Exact. Cost: linear in the number of vertices; many y at once
    /// are asked of [`Predictor::sources_of_many`].
    pub fn sources(&self, y: &Rational, error: &FurtherError) -> Vec<PossibleX> {
        self.sources_of_many(error)(y)
    }

    /// Answers as [`Predictor::sources`] does, for many y. Cost for each: logarithmic.
    pub fn sources_of_many<'b>(
        &self,
        error: &'b FurtherError,
    ) -> impl Fn(&Rational) -> Vec<PossibleX> + use<'b> {
        let Corridor { lower, upper } = &self.corridor;
        let [above, below] = error.of_x();
        let zero = error.zero_of_x();
        // The line may be this much below y and above it.
        let highest = Valley::new(upper, false, below, zero);
        let lowest = Valley::new(lower, true, above, zero);
        move |y| {
            let [above, below] = error.without_x(y);
            let too_low = highest.below(&(y - below)).map(|gap| (gap, true));
            let too_high = lowest.below(&-(y + above)).map(|gap| (gap, false));
            outside(too_low.into_iter().chain(too_high).collect())
        }
    }
}

/// All numbers.
pub(crate) fn whole() -> Interval {
    // Ends that are not there are in order.
    Interval::new(Endpoint::Unbounded, Endpoint::Unbounded).expect("the interval without ends")
}

/// The complement of gaps without a common point. Each gap knows whether the lines are too low in it.
fn outside(mut gaps: Vec<(Gap, bool)>) -> Vec<PossibleX> {
    gaps.sort_by(|(one, _), (other, _)| one.start().cmp(&other.start()));
    let mut left = Vec::new();
    let mut lower = None;
    for (gap, by_upper) in gaps {
        let end = |end: &GapEnd| PossibleEnd { x: end.x.clone(), included: !end.is_in_gap, by_upper };
        if let Some(from) = &gap.from {
            let interval = PossibleX { lower: lower.take(), upper: Some(end(from)) };
            left.extend(interval.is_something().then_some(interval));
        }
        match &gap.to {
            Some(to) => lower = Some(end(to)),
            None => return left,
        }
    }
    left.push(PossibleX { lower, upper: None });
    left
}

impl PossibleX {
    /// Returns whether there is an x in it.
    fn is_something(&self) -> bool {
        match (&self.lower, &self.upper) {
            (Some(lower), Some(upper)) => {
                lower.x < upper.x || (lower.x == upper.x && lower.included && upper.included)
            }
            _ => true,
        }
    }

    /// Returns whether a reading may come from this x.
    pub fn contains(&self, x: &Rational) -> bool {
        let is_above = |end: &PossibleEnd| *x > end.x || (end.included && *x == end.x);
        let is_below = |end: &PossibleEnd| *x < end.x || (end.included && *x == end.x);
        self.lower.as_ref().is_none_or(is_above) && self.upper.as_ref().is_none_or(is_below)
    }
}
