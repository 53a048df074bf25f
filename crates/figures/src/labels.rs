//! The texts on figures: names with units, the model, numbers.

use boundfit_estimation::{BoundName, ErrorBound, Fit, LeastSquares, Model, Problem};
use boundfit_exact::english::{counted, listed, sentence, split_unit, unit_by};
use boundfit_exact::{Foreign, Rational, Rounding};

use crate::axis::superscript;
use crate::figure::PlotOptions;
use crate::text::one_line;

/// The longest name of a column or unit that fits an axis.
pub(crate) const LONGEST_NAME: usize = 32;
/// The longest name of an axis that was asked for.
const LONGEST_LABEL: usize = 90;
/// Significant digits of the error bound.
const BOUND_DIGITS: usize = 12;

/// A name with its unit: `Vz [V]`.
pub(crate) fn with_unit(name: &str, unit: Option<&str>) -> String {
    // A name such as `U (mV)` has its unit already.
    let has_own = |unit: &&str| split_unit(name).1 == Some(unit);
    let unit = unit.filter(|unit| !unit.is_empty() && !has_own(unit));
    unit.map_or_else(|| name.to_owned(), |unit| format!("{name} [{unit}]"))
}

/// The given unit, fit for an axis.
pub(crate) fn unit(text: &Option<Foreign>) -> Option<String> {
    text.as_ref().map(|text| one_line(text, LONGEST_NAME)).filter(|unit| !unit.is_empty())
}

/// Options for the names in a description: of an axis without a name, what it would be called.
pub(crate) fn described(options: &PlotOptions) -> PlotOptions {
    let named =
        |label: &Option<Foreign>| label.clone().filter(|label| !one_line(label, LONGEST_LABEL).is_empty());
    PlotOptions { x_label: named(&options.x_label), y_label: named(&options.y_label), ..options.clone() }
}

/// The name of the abscissa of figures of the data plane: x, or the number of the row.
pub(crate) fn abscissa(problem: &Problem, options: &PlotOptions) -> String {
    if let Some(label) = &options.x_label {
        return one_line(label, LONGEST_LABEL);
    }
    match problem.measurements.model() {
        Model::Line { x } => with_unit(&counted_x(problem, x), unit(&options.x_unit).as_deref()),
        Model::TwoRegressors { .. } => "data row".to_owned(),
    }
}

/// The name of x as it is counted: `year − 1980`.
fn counted_x(problem: &Problem, x: &Foreign) -> String {
    let form = problem.measurements.line_form();
    let name = form.abscissa(&one_line(x, LONGEST_NAME).into()).into_raw();
    // The sign before the origin only: a name may have hyphens of its own.
    match name.rsplit_once(" - ").filter(|_| !form.x_origin.is_zero()) {
        Some((x, origin)) if !form.x_origin.is_negative() => format!("{x} − {origin}"),
        _ => name,
    }
}

/// The name of the response with its unit.
pub(crate) fn response(problem: &Problem, options: &PlotOptions) -> String {
    if let Some(label) = &options.y_label {
        return one_line(label, LONGEST_LABEL);
    }
    with_unit(&one_line(problem.measurements.response(), LONGEST_NAME), unit(&options.y_unit).as_deref())
}

/// The name of what a reading is above a line, with the unit of the response.
pub(crate) fn residual(options: &PlotOptions) -> String {
    with_unit("residual", unit(&options.y_unit).as_deref())
}

/// The names of the axes of both parameters: those asked for, or `θ₁ [m/V]` and `θ₂ [m]`.
pub(crate) fn axes_of_parameters(problem: &Problem, options: &PlotOptions) -> [String; 2] {
    asked_for(options, parameters(problem, options))
}

/// The names of both axes that were asked for, and these where none were.
pub(crate) fn asked_for(options: &PlotOptions, [first, second]: [String; 2]) -> [String; 2] {
    let asked = |label: &Option<Foreign>, plain: String| {
        label.as_ref().map_or(plain, |label| one_line(label, LONGEST_LABEL))
    };
    [asked(&options.x_label, first), asked(&options.y_label, second)]
}

/// `θ₁ [m/V]` and `θ₂ [m]`.
pub(crate) fn parameters(problem: &Problem, options: &PlotOptions) -> [String; 2] {
    let quotient = unit(&options.y_unit).zip(unit(&options.x_unit)).map(|(y, x)| unit_by(&y, &x));
    let second = match problem.measurements.model() {
        Model::Line { .. } => unit(&options.y_unit),
        Model::TwoRegressors { .. } => quotient.clone(),
    };
    [with_unit("θ₁", quotient.as_deref()), with_unit("θ₂", second.as_deref())]
}

/// Model, error bound and rows in one line.
pub(crate) fn subtitle(problem: &Problem, options: &PlotOptions) -> String {
    format!("{},  {},  {}", model(problem), bound(problem, options), rows(problem))
}

/// The model as a formula.
pub(crate) fn model(problem: &Problem) -> String {
    let measurements = &problem.measurements;
    let y = one_line(measurements.response(), LONGEST_NAME);
    let e = measurements.error_name();
    match measurements.model() {
        Model::Line { x } => {
            let form = measurements.line_form();
            let x = counted_x(problem, x);
            let x = if form.x_origin.is_zero() { x } else { format!("({x})") };
            let offset = if form.through_origin { "" } else { " + θ₂" };
            format!("{y} = θ₁·{x}{offset} + {e}")
        }
        Model::TwoRegressors { regressors: [first, second] } => {
            let [first, second] = [first, second].map(|name| one_line(name, LONGEST_NAME));
            format!("{y} = θ₁·{first} + θ₂·{second} + {e}")
        }
    }
}

/// The error bound.
pub(crate) fn bound(problem: &Problem, options: &PlotOptions) -> String {
    let e = problem.measurements.error_name();
    match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => uniform_bound(problem, epsilon, options),
        ErrorBound::Column(column) => format!("|{e}| ≤ {} of each row", one_line(column, LONGEST_NAME)),
        ErrorBound::Law(law) => {
            let [y, words] =
                problem.measurements.law_in_names(law).map(|words| one_line(&words, LONGEST_NAME));
            if law.is_asymmetric() { format!("{y} {words}") } else { format!("|{e}| ≤ {words}") }
        }
        ErrorBound::Interval { lower, upper } => {
            let [lower, upper] =
                [lower, upper].map(|name| name.as_ref().map(|name| one_line(name, LONGEST_NAME)));
            match (lower, upper) {
                (Some(lower), Some(upper)) => format!("between {lower} and {upper} of each row"),
                (Some(lower), None) => format!("at least {lower} of each row"),
                (None, upper) => format!("at most {} of each row", upper.unwrap_or_default()),
            }
        }
    }
}

/// A bound that is the same for all readings, with how it was asked for.
fn uniform_bound(problem: &Problem, epsilon: &Rational, options: &PlotOptions) -> String {
    let e = problem.measurements.error_name();
    let unit = unit(&options.y_unit).map(|unit| format!(" {unit}")).unwrap_or_default();
    let multiple = problem.measurements.multiple_of_least().map(|multiple| {
        let factor = number(&multiple.factor, BOUND_DIGITS, Rounding::Nearest);
        if factor == "1" { " = ε_min".to_owned() } else { format!(" = {factor}·ε_min") }
    });
    let read = epsilon.shortest_of_f64().filter(|_| epsilon.exact_decimal(BOUND_DIGITS).is_none());
    match (multiple, read) {
        // A few digits are enough of what nobody wrote.
        (Some(multiple), _) => format!("|{e}| ≤ {}{unit}{multiple}", number(epsilon, 5, Rounding::Up)),
        (None, Some(read)) => {
            format!("|{e}| ≤ {}{unit} (as a double)", number(&read, BOUND_DIGITS, Rounding::Up))
        }
        (None, None) => format!("|{e}| ≤ {}{unit}", number(epsilon, BOUND_DIGITS, Rounding::Up)),
    }
}

/// Returns the number of rows that are fitted, and the number of conditions.
fn rows(problem: &Problem) -> String {
    let (fitted, total) = (problem.measurements.fitted(), problem.measurements.rows_total());
    let rows = if fitted == total {
        counted(total, "row", "rows")
    } else {
        format!("{fitted} of {}", counted(total, "row", "rows"))
    };
    let conditions = match problem.conditions.len() {
        0 => String::new(),
        count => format!(", {}", counted(count, "condition", "conditions")),
    };
    format!("{rows}{conditions}")
}

/// A decimal of at most so many digits with a true minus sign and a written-out power of ten.
pub(crate) fn number(value: &Rational, digits: usize, rounding: Rounding) -> String {
    let text = value.to_decimal(digits, rounding).replace('-', "−");
    match text.split_once('e') {
        Some((mantissa, exponent)) => {
            let exponent = exponent.replace('−', "-").parse().map(superscript).unwrap_or_default();
            format!("{mantissa}×10{exponent}")
        }
        None => text,
    }
}

/// A number rounded up to a few digits, and the sign that says whether it was.
pub(crate) fn rounded_up(value: &Rational) -> (&'static str, String) {
    const DIGITS: usize = 5;
    let exact = value.to_decimal(DIGITS, Rounding::Down) == value.to_decimal(DIGITS, Rounding::Up);
    (if exact { "=" } else { "≈" }, number(value, DIGITS, Rounding::Up))
}

/// The readings behind an empty set, and the conditions, by number.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Conflict {
    pub(crate) bounds: Vec<BoundName>,
    pub(crate) rows: Vec<usize>,
    pub(crate) conditions: Vec<usize>,
}

impl Conflict {
    /// Returns the bounds that contradict each other; nothing when the set is not empty.
    pub(crate) fn of(problem: &Problem, fit: &Fit) -> Self {
        let contradiction = fit.contradiction(problem.measurements.error_bound()).unwrap_or_default();
        Conflict::among(contradiction.into_iter().map(|(bound, _)| bound))
    }

    /// Returns the conflict among these bounds.
    pub(crate) fn among(bounds: impl Iterator<Item = BoundName>) -> Self {
        let mut conflict = Conflict::default();
        for bound in bounds {
            conflict.bounds.push(bound);
            conflict.rows.extend(bound.row());
            conflict.conditions.extend(bound.condition());
        }
        conflict.rows.dedup();
        conflict.conditions.dedup();
        conflict
    }

    /// `rows 14, 24 and 34 and condition 1`.
    pub(crate) fn names(&self) -> String {
        let named = |noun: &str, numbers: &[usize]| {
            let all: Vec<String> = numbers.iter().map(usize::to_string).collect();
            let plural = if all.len() == 1 { "" } else { "s" };
            (!all.is_empty()).then(|| format!("{noun}{plural} {}", listed(&all)))
        };
        let parts = [named("row", &self.rows), named("condition", &self.conditions)];
        parts.into_iter().flatten().collect::<Vec<_>>().join(" and ")
    }

    /// A sentence about who contradicts whom.
    pub(crate) fn sentence(&self) -> String {
        sentence(&self.claim())
    }

    /// The sentence as the end of another one.
    pub(crate) fn claim(&self) -> String {
        let one = self.rows.len() + self.conditions.len() == 1;
        let verb = if one { "cannot be met" } else { "contradict each other" };
        format!("{} {verb}.", self.names())
    }
}

/// A condition as it was written, with indices as on the axes.
pub(crate) fn condition(text: &Foreign) -> String {
    let pretty =
        text.raw().replace("theta1", "θ₁").replace("theta2", "θ₂").replace("<=", "≤").replace(">=", "≥");
    one_line(&pretty.replace('*', "·").into(), 40)
}

/// Returns the reason why a fit has no EUI, where it has none.
pub(crate) fn why_no_eui(fit: &Fit) -> Option<String> {
    match &fit.least_squares {
        Err(reason) => Some(format!("No least squares and no EUI: {reason}.")),
        Ok(LeastSquares { eui: Err(reason), .. }) => Some(format!("No EUI: {reason}.")),
        Ok(_) => None,
    }
}
