//! Readings in memory: from slices of numbers to a problem.

use boundfit_estimation::{
    Bounds, ErrorBound, LineForm, Measurement, Measurements, Model, ParseConditionError, Problem,
};
use boundfit_exact::Rational;
use thiserror::Error;

use crate::number::{Number, NumberError};

/// The ways to what only the program's `--eps` says in one text.
const NO_LAW: &str = " (a law is for error_bounds, a multiple of the least bound for with_multiple_of_least)";

/// The reason why numbers make no problem.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A number of a column has no exact value.
    #[error("row {row} of {column}: {problem}")]
    Number {
        /// The name of the column: `x`, `phi1`, `phi2`, `y`, `eps`, or `a1`, `a2`, `b` of a half-plane.
        column: &'static str,
        /// The row, from 1.
        row: usize,
        /// The problem with the number.
        problem: NumberError,
    },
    /// The error bound of all readings has no exact value.
    #[error("the error bound: {0}{hint}", hint = if matches!(.0, NumberError::Text { .. }) { NO_LAW } else { "" })]
    ErrorBound(NumberError),
    /// The origin of x has no exact value.
    #[error("the origin of x: {0}")]
    Origin(NumberError),
    /// A claimed end of an interval has no exact value.
    #[error("{end}: {problem}")]
    Claim {
        /// The end: `theta1-min`, `theta1-max`, `theta2-min` or `theta2-max`.
        end: &'static str,
        /// The problem with the number.
        problem: NumberError,
    },
    /// Two columns are not equally long.
    #[error("{} has {} rows, but {} has {}", .columns[0], .rows[0], .columns[1], .rows[1])]
    Lengths {
        /// The names of the columns.
        columns: [&'static str; 2],
        /// The number of numbers in each.
        rows: [usize; 2],
    },
    /// A regressor matrix has no column, or more than two.
    #[error("the regressor matrix has {columns} columns (expected 1 or 2)")]
    Regressors {
        /// The number of its columns.
        columns: usize,
    },
    /// An error bound is negative.
    #[error("the error bound{} is negative", .row.map(|row| format!(" of row {row}")).unwrap_or_default())]
    NegativeBound {
        /// The row, from 1; `None` when the bound is that of all readings.
        row: Option<usize>,
    },
    /// A reading has neither a lower nor an upper bound.
    #[error("row {row} has neither a lower nor an upper bound")]
    NoBound {
        /// The row, from 1.
        row: usize,
    },
    /// A text is not a condition.
    #[error(transparent)]
    Condition(#[from] ParseConditionError),
}

/// The measured values, before anything is known about the errors. With error bounds it becomes a
/// [`Problem`].
///
/// ```
/// use boundfit::Observations;
///
/// // The slope is not negative, and the second reading is ten times as good as the others.
/// let fit = Observations::line(&[0, 1, 2], &["0.1", "0.98", "2.2"])?
///     .error_bounds(&["0.5", "0.05", "0.5"])?
///     .condition("theta1 >= 0")?
///     .fit();
/// assert!(!fit.is_empty());
/// # Ok::<(), boundfit::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Observations {
    model: Model,
    regressors: Vec<[Rational; 2]>,
    responses: Vec<Rational>,
    form: LineForm,
}

impl Observations {
    /// Readings of a line, y = theta1*x + theta2 + e. Data row k has the numbers at index k - 1.
    ///
    /// # Errors
    /// When a number has no exact value, or the columns are not equally long.
    pub fn line<X: Number, Y: Number>(x: &[X], y: &[Y]) -> Result<Self, Error> {
        let regressors = column("x", x)?.into_iter().map(|x| [x, Rational::one()]).collect();
        same_length(["x", "y"], [x.len(), y.len()])?;
        Ok(Observations {
            model: Model::Line { x: "x".into() },
            regressors,
            responses: column("y", y)?,
            form: LineForm::default(),
        })
    }

    /// Readings of a model with two regressors and no constant, y = theta1*phi1 + theta2*phi2 + e.
    ///
    /// # Errors
    /// When a number has no exact value, or the columns are not equally long.
    pub fn regressors<A: Number, B: Number, Y: Number>(
        phi1: &[A],
        phi2: &[B],
        y: &[Y],
    ) -> Result<Self, Error> {
        same_length(["phi1", "phi2"], [phi1.len(), phi2.len()])?;
        same_length(["phi1", "y"], [phi1.len(), y.len()])?;
        let regressors = column("phi1", phi1)?.into_iter().zip(column("phi2", phi2)?);
        let regressors = regressors.map(|(phi1, phi2)| [phi1, phi2]).collect();
        let model = Model::TwoRegressors { regressors: ["phi1".into(), "phi2".into()] };
        Ok(Observations { model, regressors, responses: column("y", y)?, form: LineForm::default() })
    }

    /// These readings as those of lines through the origin, y = theta1*x + e: `theta2 = 0` is known, and least squares has one
    /// parameter. A model with two regressors has no constant and stays as it is.
    ///
    /// ```
    /// use boundfit::Observations;
    ///
    /// let fit = Observations::line(&[1, 2, 3], &["2.1", "3.9", "6.2"])?.through_origin().error_bound("0.5")?.fit();
    /// let [slope, offset] = fit.pui_intervals().unwrap();
    /// assert_eq!((slope.to_string(), offset.to_string()), ("[19/10, 11/5]".to_owned(), "[0, 0]".to_owned()));
    /// assert_eq!(fit.least_squares.unwrap().theta[0].to_string(), "57/28");
    /// # Ok::<(), boundfit::Error>(())
    /// ```
    pub fn through_origin(mut self) -> Self {
        self.form.through_origin = true;
        self
    }

    /// These readings as those of y = theta1*(x - origin) + theta2 + e: theta2 is the value at the origin. A model with two
    /// regressors has no x and stays as it is.
    ///
    /// ```
    /// use boundfit::Observations;
    ///
    /// let years = Observations::line(&[1979, 1980, 1981], &[4, 7, 8])?.x_origin(1980)?;
    /// let [_, in_1980] = years.error_bound(1)?.fit().pui_intervals().unwrap();
    /// assert_eq!(in_1980.to_string(), "[6, 7]");
    /// # Ok::<(), boundfit::Error>(())
    /// ```
    ///
    /// # Errors
    /// When the number has no exact value.
    pub fn x_origin(mut self, origin: impl Number) -> Result<Self, Error> {
        self.form.x_origin = origin.exact().map_err(Error::Origin)?;
        Ok(self)
    }

    /// The problem in which every reading has this error bound: |e| ≤ eps. A law such as 1 % of |y| is a bound for each reading, which
    /// [`error_bounds`](Observations::error_bounds) takes. A multiple of the least bound is [`Problem::with_multiple_of_least`].
    ///
    /// # Errors
    /// When the number has no exact value, or is negative.
    pub fn error_bound(self, eps: impl Number) -> Result<Problem, Error> {
        let epsilon = eps.exact().map_err(Error::ErrorBound)?;
        if epsilon.is_negative() {
            return Err(Error::NegativeBound { row: None });
        }
        let epsilons = vec![epsilon.clone(); self.responses.len()];
        Ok(self.problem(ErrorBound::Uniform(epsilon), epsilons))
    }

    /// The problem in which each reading has an error bound of its own.
    ///
    /// # Errors
    /// When a number has no exact value or is negative, or there are not as many as readings.
    pub fn error_bounds<E: Number>(self, eps: &[E]) -> Result<Problem, Error> {
        same_length(["y", "eps"], [self.responses.len(), eps.len()])?;
        let epsilons = column("eps", eps)?;
        if let Some(index) = epsilons.iter().position(Rational::is_negative) {
            return Err(Error::NegativeBound { row: Some(index + 1) });
        }
        Ok(self.problem(ErrorBound::Column("eps".into()), epsilons))
    }

    /// The problem in which theta1*x + theta2 (or theta1*phi1 + theta2*phi2) lies between two values at each
    /// reading, of which one may be missing. The measured y then bounds nothing; least squares takes it.
    ///
    /// ```
    /// use boundfit::Observations;
    ///
    /// let (lower, upper) = ([Some(0), Some(1), None], [None, Some(2), Some(3)]);
    /// let fit = Observations::line(&[0, 1, 2], &[0, 1, 3])?.bounds(&lower, &upper)?.fit();
    /// let [slope, _] = fit.pui_intervals().expect("the set is not empty");
    /// assert_eq!(slope.to_string(), "(-inf, 3/2]");
    /// # Ok::<(), boundfit::Error>(())
    /// ```
    ///
    /// # Errors
    /// When a number has no exact value, a reading has no bound, or there are not as many bounds as readings.
    pub fn bounds<B: Number>(self, lower: &[Option<B>], upper: &[Option<B>]) -> Result<Problem, Error> {
        same_length(["y", "lower"], [self.responses.len(), lower.len()])?;
        same_length(["y", "upper"], [self.responses.len(), upper.len()])?;
        let sides: Vec<_> = sides("lower", lower)?.into_iter().zip(sides("upper", upper)?).collect();
        if let Some(index) = sides.iter().position(|(lower, upper)| lower.is_none() && upper.is_none()) {
            return Err(Error::NoBound { row: index + 1 });
        }
        let bound = ErrorBound::Interval { lower: Some("lower".into()), upper: Some("upper".into()) };
        let between = |response, (lower, upper)| Bounds::Between { lower, upper, response: Some(response) };
        Ok(self.with_bounds(bound, sides, between))
    }

    fn problem(self, error_bound: ErrorBound, epsilons: Vec<Rational>) -> Problem {
        self.with_bounds(error_bound, epsilons, |response, epsilon| Bounds::Around { response, epsilon })
    }

    /// The problem with what is known of each reading, and what that makes of its y.
    fn with_bounds<K>(
        self,
        error_bound: ErrorBound,
        known: Vec<K>,
        bounds: impl Fn(Rational, K) -> Bounds,
    ) -> Problem {
        let parts = self.regressors.into_iter().zip(self.responses).zip(known);
        let measurement = |(row, ((regressor, response), known))| Measurement {
            row,
            regressor,
            bounds: bounds(response, known),
        };
        let rows = (1..).zip(parts).map(measurement).collect();
        let LineForm { x_origin, through_origin } = self.form;
        let measurements = Measurements::new(self.model, "y".into(), error_bound, rows);
        let problem = Problem::new(measurements.with_form(LineForm { x_origin, through_origin: false }));
        if through_origin { problem.through_origin() } else { problem }
    }
}

/// The exact values of a column.
pub(crate) fn column<N: Number>(name: &'static str, numbers: &[N]) -> Result<Vec<Rational>, Error> {
    let exact = |(row, number): (usize, &N)| {
        number.exact().map_err(|problem| Error::Number { column: name, row, problem })
    };
    (1..).zip(numbers).map(exact).collect()
}

/// The exact values of a column with gaps.
fn sides<N: Number>(name: &'static str, numbers: &[Option<N>]) -> Result<Vec<Option<Rational>>, Error> {
    let exact = |(row, number): (usize, &Option<N>)| {
        let exact = number.as_ref().map(N::exact).transpose();
        exact.map_err(|problem| Error::Number { column: name, row, problem })
    };
    (1..).zip(numbers).map(exact).collect()
}

pub(crate) fn same_length(columns: [&'static str; 2], rows: [usize; 2]) -> Result<(), Error> {
    if rows[0] == rows[1] { Ok(()) } else { Err(Error::Lengths { columns, rows }) }
}
