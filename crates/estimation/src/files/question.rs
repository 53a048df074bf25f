//! A question about a table, whatever its source.

use boundfit_exact::{Limits, Rational, Reading, TooMuchWork, Work};
use boundfit_formats::{ColumnSelector, InputError, ScanOptions, Source};
use boundfit_geometry::{Polyhedron, System};

use super::{Columns, EpsilonColumn, Fleet, ReducedTable};
use crate::asked_bound::AskedBound;
use crate::condition::Condition;
use crate::group_fit::{GroupAnswer, GroupFit, GroupLine};
use crate::line_form::LineForm;
use crate::measurements::Measurements;
use crate::problem::Problem;
use crate::summary::Keep;
use crate::terms::ParseBoundError;

/// The columns of a table that are fitted, the bounds on the errors, and the conditions on the parameters. Files and
/// columns in memory ([`Source::of_table`]) are asked in the same words, and so are whole tables, fleets and what is
/// to be reduced.
///
/// ```
/// use boundfit_estimation::Question;
/// use boundfit_exact::Reading;
/// use boundfit_formats::{ColumnSelector, MemoryNumbers, MemoryTable, Source};
///
/// let mut table = MemoryTable::default();
/// table.push("x", MemoryNumbers::Integers(vec![0, 1, 2]));
/// table.push("y", MemoryNumbers::Doubles(vec![0.0, 1.5, 2.0]));
/// let [x, y] = ["x", "y"].map(ColumnSelector::name_or_number);
/// let question = Question::line(x, Some(y)).within("2*min", Reading::Decimal)?;
/// let problem = question.problem(Source::of_table("readings", table), &Default::default(), Default::default())?;
/// let [slope, _] = problem.fit().pui_intervals().unwrap();
/// assert_eq!(slope.to_string(), "[1/2, 3/2]");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Question {
    /// The columns.
    pub columns: Columns,
    /// The conditions that the parameters satisfy.
    pub conditions: Vec<Condition>,
    /// The multiple of ε_min of the readings that bounds every error, in the place of the bound in `columns`.
    pub multiple_of_least: Option<Rational>,
}

impl Question {
    /// A line, y = θ1·x + θ2 + e, of whose errors nothing is said yet: they are 0.
    pub fn line(x: ColumnSelector, y: Option<ColumnSelector>) -> Self {
        Question::of(x, None, y)
    }

    /// Two regressors, y = θ1·φ1 + θ2·φ2 + e, of whose errors nothing is said yet: they are 0.
    pub fn regressors(phi1: ColumnSelector, phi2: ColumnSelector, y: Option<ColumnSelector>) -> Self {
        Question::of(phi1, Some(phi2), y)
    }

    fn of(first: ColumnSelector, second: Option<ColumnSelector>, response: Option<ColumnSelector>) -> Self {
        let (epsilon, form) = (EpsilonColumn::Uniform(Rational::zero()), LineForm::default());
        let columns = Columns { first, second, response, epsilon, form };
        Question { columns, conditions: Vec::new(), multiple_of_least: None }
    }

    /// Sets the bound on the errors from words: a number, a law such as `0.05%*|y| + 2e-3`, or a multiple of ε_min
    /// such as `1.2*min` ([`AskedBound::parse`]).
    ///
    /// # Errors
    /// With the place where the text stops making sense.
    pub fn within(mut self, bound: &str, reading: Reading) -> Result<Self, ParseBoundError> {
        self.multiple_of_least = None;
        self.columns.epsilon = match AskedBound::parse(bound, reading, &Limits::default())? {
            AskedBound::Number(number) => EpsilonColumn::Uniform(number),
            AskedBound::Law(law) => EpsilonColumn::Law(*law),
            AskedBound::TimesLeast(factor) => {
                self.multiple_of_least = Some(factor);
                // It has no say in what the least bound follows from.
                EpsilonColumn::Uniform(Rational::zero())
            }
        };
        Ok(self)
    }

    /// Takes the bounds from columns.
    #[must_use]
    pub fn within_columns(mut self, epsilon: EpsilonColumn) -> Self {
        self.multiple_of_least = None;
        self.columns.epsilon = epsilon;
        self
    }

    /// The problem, in memory that does not grow with the table beyond what `keep` says. Exact. Cost: one pass, and what
    /// [`Measurements::scan`] says.
    ///
    /// # Errors
    /// The first thing wrong with the table.
    pub fn problem(&self, source: Source, options: &ScanOptions, keep: Keep) -> Result<Problem, InputError> {
        Ok(self.of_measurements(self.measurements(source, options, keep)?))
    }

    /// The readings of a table, as [`Question::problem`] takes them.
    ///
    /// # Errors
    /// The first thing wrong with the table.
    pub fn measurements(
        &self,
        source: Source,
        options: &ScanOptions,
        keep: Keep,
    ) -> Result<Measurements, InputError> {
        let conditions = self.every_condition();
        // Where the bounds are going to move, those that decide under these are not enough.
        let keeps_all = self.multiple_of_least.is_some() && !self.columns.are_open();
        let keep = if keeps_all { Keep { eui: keep.eui, ..Keep::EVERY } } else { keep };
        Measurements::scan(source, &self.columns, &conditions, options, keep)
    }

    /// The conditions, with that of a line through the origin.
    fn every_condition(&self) -> Vec<Condition> {
        let no_intercept = self.columns.form.through_origin.then(Condition::no_intercept);
        self.conditions.iter().cloned().chain(no_intercept).collect()
    }

    /// Returns whether the conditions contradict each other, so that no error bound, however large, leaves any parameter. Exact.
    pub fn conditions_contradict(&self) -> bool {
        let conditions = self.every_condition();
        let half_planes = conditions.iter().flat_map(Condition::inequalities);
        Polyhedron::intersect(System::new(half_planes)).is_empty()
    }

    /// Returns whether a multiple of the least bound is asked of readings that were reduced under bounds that are fixed: there is none.
    pub fn moves_fixed_bounds(&self, source: &Source) -> bool {
        self.multiple_of_least.is_some() && source.is_reduction() && self.columns.second.is_some()
    }

    /// The problem of readings of these columns, whose numbers are not too long for a fit within this limit on work.
    ///
    /// # Errors
    /// When they are.
    pub fn problem_within(&self, measurements: Measurements, limit: u64) -> Result<Problem, TooMuchWork> {
        self.work_of_every(measurements.shown()).check(1, limit)?;
        // A multiple of the least bound is work too.
        let stated = self.stated_problem(measurements);
        stated.check_work(1, limit)?;
        if self.asks_as_stated() {
            return Ok(stated);
        }
        let problem = self.of_measurements(stated.measurements);
        problem.check_work(1, limit)?;
        Ok(problem)
    }

    /// The problem of readings under the bound that is stated, where that is no multiple of the least one.
    pub fn stated_problem(&self, measurements: Measurements) -> Problem {
        Problem { measurements, conditions: self.conditions.clone() }
    }

    /// Estimates the work on the numbers that this many readings get beside their own, before memory is taken for
    /// them. These are the shared bound and origin and, where the bound comes from the readings, numbers from a
    /// condition.
    pub fn work_of_every(&self, readings: usize) -> Work {
        let right_sides = self.conditions.iter().map(|condition| &condition.inequality().b);
        let longest = right_sides.max_by_key(|number| number.bits());
        self.columns.work_of_every(readings, longest.filter(|_| self.multiple_of_least.is_some()))
    }

    /// Returns whether a bound or an origin that is the same for all readings is so long that it counts in each.
    pub fn has_long_bound(&self) -> bool {
        let is_long = |number: &Rational| Work::of_numbers(&[number]).products(1) > 0;
        let is_long_bound =
            matches!(&self.columns.epsilon, EpsilonColumn::Uniform(epsilon) if is_long(epsilon));
        is_long_bound || is_long(&self.columns.form.x_origin)
    }

    /// Returns whether nothing is known of the parameters beside the readings and their error bound, which is given.
    pub fn is_plain(&self) -> bool {
        self.conditions.is_empty() && self.asks_as_stated()
    }

    /// Returns whether the problem of some readings is the stated one.
    fn asks_as_stated(&self) -> bool {
        self.multiple_of_least.is_none() && !self.columns.form.through_origin
    }

    /// The problem of readings of these columns.
    pub fn of_measurements(&self, measurements: Measurements) -> Problem {
        let problem = self.stated_problem(measurements);
        let problem = if self.columns.form.through_origin { problem.through_origin() } else { problem };
        match &self.multiple_of_least {
            Some(factor) => problem.with_multiple_of_least(factor),
            None => problem,
        }
    }

    /// Returns what a fleet that was read for these columns says of one of its groups: see [`Fleet::group_fit`]. Exact.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn of_group(&self, fleet: &Fleet, group: usize) -> GroupFit {
        let line = self.is_plain().then(|| fleet.group_fit(group)).flatten();
        line.unwrap_or_else(|| {
            let problem = self.of_measurements(fleet.measurements(group));
            GroupFit { first_row: fleet.first_row(group), ..GroupFit::of(&problem, &problem.fit()) }
        })
    }

    /// Returns what [`Question::of_group`] does with the proofs: see [`Fleet::group_answer`]. Exact.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn answer_of_group(&self, fleet: &Fleet, group: usize) -> GroupAnswer {
        let answer = self.is_plain().then(|| fleet.group_answer(group)).flatten();
        answer.unwrap_or_else(|| {
            let problem = self.of_measurements(fleet.measurements(group));
            let answer = GroupAnswer::of(&problem, &problem.fit());
            GroupAnswer { fit: GroupFit { first_row: fleet.first_row(group), ..answer.fit }, ..answer }
        })
    }

    /// Returns what [`Question::of_group`] does, to be rounded only; `None` where the fit itself must answer: see [`Fleet::group_line`].
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn line_of_group(&self, fleet: &Fleet, group: usize) -> Option<GroupLine> {
        self.is_plain().then(|| fleet.group_line(group)).flatten()
    }

    /// The readings that decide, as a text that files of readings may be in the place of: see [`ReducedTable::scan`].
    ///
    /// # Errors
    /// The first thing wrong with the table.
    pub fn reduce(&self, source: Source, options: &ScanOptions) -> Result<ReducedTable, InputError> {
        ReducedTable::scan(source, &self.columns, options)
    }
}
