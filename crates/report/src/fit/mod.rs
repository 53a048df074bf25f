//! The report of a fit.

mod brief;
mod emptiness;
mod estimates;
mod next;
mod results;

pub use brief::brief_document;
pub(crate) use brief::times_what;
pub(crate) use estimates::bounded_rows;
pub use next::{NextStep, next_document, next_steps};

use boundfit_estimation::{
    ErrorBound, Fit, FractionCells, Inverse, Law, Model, MultipleOfLeast, NoLeastSquares, ParameterBound,
    ParameterInterval, Problem, Ties,
};
use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Interval, Rational};

use crate::advice::bounding_reading;
use crate::document::{Block, Document, Facts, Operator, Symbol, THETA, Table, Text};
use crate::formula::{bounded_error, error, products};
use crate::origin::Origin;
use crate::region::{names_of, region_blocks};
use crate::scale::{Scale, scales};
use crate::style::Style;
use crate::table_json::rows_left_out;
use crate::table_json::table_words;

/// The name of the set in titles.
const SET: &str = "Feasible parameter set (FPS)";

/// The condition under which the report has gain and offset of the inverse line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InverseLine {
    /// The report has both if every feasible line has an inverse: 0 is not in the PUI of θ1.
    #[default]
    WhereItExists,
    /// Always.
    Always,
}

/// The extent of a report of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extent {
    /// The results that a calibration needs.
    Usual,
    /// Everything.
    Full,
}

/// Writes the report of a fit: estimates, intervals, the inverse line, the vertices, ε_min and the lines at the ends of the slopes.
/// The last block holds the remaining results, so that [`Document::add_result`] can add to them.
pub fn fit_document<'a>(
    problem: &Problem,
    fit: &'a Fit,
    origin: &Origin,
    inverse_line: InverseLine,
    style: &Style,
) -> Document<'a> {
    document(problem, fit, origin, inverse_line, style, Extent::Usual)
}

/// Writes the report of a fit as [`fit_document`] does, with all further parts.
/// - The proof of each end of the PUI.
/// - Every estimate of the inverse line.
/// - Area and centroid.
/// - The guaranteed errors of least squares.
/// - Least squares in doubles.
pub fn full_fit_document<'a>(
    problem: &Problem,
    fit: &'a Fit,
    origin: &Origin,
    inverse_line: InverseLine,
    style: &Style,
) -> Document<'a> {
    document(problem, fit, origin, inverse_line, style, Extent::Full)
}

fn document<'a>(
    problem: &Problem,
    fit: &'a Fit,
    origin: &Origin,
    inverse_line: InverseLine,
    style: &Style,
    extent: Extent,
) -> Document<'a> {
    let pui = fit.pui_intervals();
    let report = Report { extent, ..Report::new(problem, fit, pui.as_ref(), inverse_line, style) };
    let mut blocks = vec![Block::Title("Set-membership fit".into())];
    blocks.push(Block::Facts(Facts { width: 7, rows: report.facts(origin) }));
    if fit.is_empty() {
        // Nothing else matters as much.
        blocks.extend(empty_blocks(problem, fit, style));
    }
    blocks.extend(estimates::blocks(&report));
    if !fit.is_empty() {
        let names = |indices: &[usize]| names_of(&fit.fps.active(indices, Ties::MOST_LISTED));
        blocks.extend(region_blocks(SET, fit.fps.polyhedron(), &report.theta, names));
    }
    let advice = bounding_reading(fit.fps.polyhedron(), &problem.measurements, style);
    blocks.extend(advice.map(Block::Paragraph));
    let proofs = if extent == Extent::Full { report.proofs() } else { Vec::new() };
    if !proofs.is_empty() {
        let header = Text::from("multiplier").operator(Operator::Times).words("(row and bound)");
        blocks.push(Block::Title("Proof of each end of the PUI".into()));
        blocks.push(Block::Table(Table::new([Text::new(), Text::new(), header], proofs)));
    }
    blocks.push(Block::Results(results::lines(&report)));
    Document::new(blocks)
}

/// The facts about model, bounds and data that head every answer about readings.
pub(crate) fn fit_facts(problem: &Problem, fit: &Fit, origin: &Origin, style: &Style) -> Facts {
    let report = Report::new(problem, fit, None, InverseLine::default(), style);
    Facts { width: 7, rows: report.facts(origin) }
}

/// Says of an empty set which rows contradict each other, and what would help, for any answer that needs a set.
pub(crate) fn empty_blocks(problem: &Problem, fit: &Fit, style: &Style) -> Vec<Block<'static>> {
    let report = Report::new(problem, fit, None, InverseLine::default(), style);
    let title = Block::Title(format!("{SET}: {}", fit.fps.polyhedron().kind().name()).into());
    [title].into_iter().chain(report.emptiness().into_iter().map(Block::Paragraph)).collect()
}

/// The error bound that was found from the readings themselves, in a line beside answers that have no place for assumptions.
pub fn bound_found(multiple: &MultipleOfLeast) -> String {
    let (factor, epsilon) = (&multiple.factor, multiple.bound());
    match *factor == Rational::one() {
        true => format!("|e| <= {epsilon}, which is eps_min of these very readings"),
        false => format!("|e| <= {epsilon}, {factor} times eps_min of these very readings"),
    }
}

/// The assumption behind an error bound that was found from the readings themselves.
pub(crate) fn assumption(MultipleOfLeast { factor, least }: &MultipleOfLeast, style: &Style) -> Text {
    let text = match *factor == Rational::one() {
        true => Text::from("that no error is larger than eps_min, "),
        false => {
            Text::from("that no error is larger than ").then(style.given(factor)).words(" times eps_min, ")
        }
    };
    let text = text.number(style.upper(least));
    if *factor < Rational::one() && !least.is_zero() {
        return text.words(", the least bound under which any theta fits. Under a smaller one none does.");
    }
    let text = text.words(
        ", the least bound under which any theta fits. It was found from these very readings, which cannot show that \
         errors are no larger; if one is, the set may miss the true theta.",
    );
    match least.is_zero() {
        true => text.words(" Here it is 0: the readings fit exactly, and say nothing of their errors."),
        false => text,
    }
}

/// `x: 12 cells are fractions such as 3/4`.
pub(crate) fn fractions(FractionCells { column, cells, first }: &FractionCells) -> Text {
    let said = match cells {
        1 => ": 1 cell is a fraction, ".to_owned(),
        cells => format!(": {cells} cells are fractions such as "),
    };
    Text::new().given(column).words(said).given(first)
}

/// The material of all parts of a report.
struct Report<'a> {
    problem: &'a Problem,
    fit: &'a Fit,
    style: &'a Style,
    /// The scales that show the values of the two parameters.
    theta: [Scale; 2],
    inverse_line: InverseLine,
    extent: Extent,
}

impl<'a> Report<'a> {
    fn new(
        problem: &'a Problem,
        fit: &'a Fit,
        pui: Option<&'a [Interval; 2]>,
        inverse_line: InverseLine,
        style: &'a Style,
    ) -> Self {
        let others: Vec<&[Interval; 2]> = fit.eui().into_iter().collect();
        let estimates = [
            fit.least_squares.as_ref().ok().map(|estimate| &estimate.theta),
            fit.central.as_ref().map(|central| &central.theta),
            fit.minimax.as_ref().map(|minimax| &minimax.theta),
        ];
        let estimates: Vec<&[Rational; 2]> = estimates.into_iter().flatten().collect();
        let theta = scales(style, pui, &others, &estimates, || fit.fps.polyhedron().homogeneous_vertices());
        Report { problem, fit, style, theta, inverse_line, extent: Extent::Usual }
    }

    /// The inverse line, if it is to be shown.
    fn inverse(&self) -> Option<Inverse> {
        let exists = || {
            let pui = self.fit.pui_intervals();
            pui.is_some_and(|[theta1, _]| !theta1.contains(&Rational::zero()))
        };
        let is_shown = self.inverse_line == InverseLine::Always || exists();
        self.fit.inverse(self.problem.measurements.model()).filter(|_| is_shown)
    }

    /// The facts about model, bounds and data.
    fn facts(&self, origin: &Origin) -> Vec<(Text, Text)> {
        let measurements = &self.problem.measurements;
        let bounded = bounded_error(measurements);
        let in_names = |law: &Law| {
            let [_, words] = measurements.law_in_names(law);
            words
        };
        let bound = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => {
                let law = measurements.law();
                let bounded = law
                    .map_or(bounded.clone(), |law| bounded.given(in_names(law)).operator(Operator::Equals));
                // Nobody wrote a multiple of eps_min down: its digits are those of a result.
                match measurements.multiple_of_least() {
                    Some(_) => bounded.number(self.style.upper(epsilon)),
                    None => bounded.then(self.style.given(epsilon)),
                }
            }
            ErrorBound::Column(column) => bounded.given(column).words(", one bound per row"),
            ErrorBound::Law(law) if law.is_asymmetric() => {
                let [y, law] = measurements.law_in_names(law);
                Text::new().given(&y).words(" ").given(&law).words(" of each row")
            }
            ErrorBound::Law(law) => bounded.given(in_names(law)).words(" of each row"),
            ErrorBound::Interval { .. } => self.intervals(),
        };
        let (used, total) = (measurements.fitted(), measurements.rows_total());
        let selection = measurements.selection();
        let rows = match selection.is_all() {
            true if measurements.is_of_reductions() => {
                let kept = counted(measurements.kept().len(), "row", "rows");
                format!("a reduction: {kept} for {}", counted(total, "reading", "readings"))
            }
            true => counted(total, "row", "rows"),
            false => format!("{selection}: {used} of {total}"),
        };
        let missing = rows_left_out(measurements.rows_missing());
        let missing = missing.map_or_else(String::new, |words| format!(", {words}"));
        let multiple = measurements.multiple_of_least();
        let label = match measurements.error_bound() {
            ErrorBound::Interval { .. } => "bounds",
            _ => "error",
        };
        let facts = [("model", self.model()), (label, bound)]
            .into_iter()
            .chain(multiple.map(|multiple| ("assumes", assumption(multiple, self.style))))
            .chain([
                ("data", Text::new().given(origin.name()).words(format!(", {rows}{missing}"))),
                ("reading", origin.words_of_reading().into()),
            ]);
        let table = table_words(measurements).map(|words| ("table".into(), words));
        let conditions = (1..).zip(&self.problem.conditions).map(|(number, condition)| {
            (format!("where:{number}").into(), Text::new().given(condition.text()))
        });
        let fractions = measurements.fractions().iter().map(|found| ("note".into(), fractions(found)));
        let facts = facts.into_iter().map(|(label, text)| (label.into(), text));
        facts.chain(table).chain(fractions).chain(conditions).collect()
    }

    fn model(&self) -> Text {
        let term = |theta, regressor: &Foreign| Text::from(theta).operator(Operator::Dot).given(regressor);
        let measurements = &self.problem.measurements;
        let (first, second) = match measurements.model() {
            Model::Line { x } => {
                let form = measurements.line_form();
                let name = form.abscissa(x);
                let shown = if form.x_origin.is_zero() { name } else { format!("({})", name.raw()).into() };
                (shown, (!form.through_origin).then(|| Text::from(Symbol::Theta2)))
            }
            Model::TwoRegressors { regressors: [first, second] } => {
                (first.clone(), Some(term(Symbol::Theta2, second)))
            }
        };
        let value = term(Symbol::Theta1, &first);
        let value = match second {
            Some(second) => value.operator(Operator::Plus).then(second),
            None => value,
        };
        if let ErrorBound::Interval { lower, upper } = measurements.error_bound() {
            let between = lower
                .as_ref()
                .map_or_else(Text::new, |lower| Text::new().given(lower).operator(Operator::AtMost));
            let between = between.then(value);
            return match upper {
                Some(upper) => between.operator(Operator::AtMost).given(upper),
                None => between,
            };
        }
        let model = Text::new().given(measurements.response()).operator(Operator::Equals).then(value);
        model.operator(Operator::Plus).then(error(measurements))
    }

    /// Counts the bounds that two columns give, and names the values that least squares uses.
    fn intervals(&self) -> Text {
        let measurements = &self.problem.measurements;
        let ties = measurements.ties().filter(|_| measurements.every().is_some());
        let [mut all, mut lacking] = [0; 2];
        for row in measurements.each_shown() {
            let times = ties.map_or(1, |ties| ties.count(row.row));
            all += times;
            lacking += if row.is_two_sided() { 0 } else { times };
        }
        // Other rows are no longer in memory.
        let which = if all == measurements.fitted() { "" } else { " kept" };
        let bounds = match lacking {
            0 => format!("both bounds of every row{which}"),
            _ if lacking == all => format!("one bound of every row{which}"),
            _ => {
                let both = counted(all - lacking, "row", "rows");
                format!("both bounds of {both}{which}, one of {lacking}")
            }
        };
        let has_values = !matches!(self.fit.least_squares, Err(NoLeastSquares::NoResponse));
        let text = Text::from(bounds);
        match (measurements.has_response(), lacking) {
            (true, _) => text.words("; least squares takes ").given(measurements.response()),
            (false, 0) if has_values => text.words("; least squares takes the middles"),
            (false, _) => text,
        }
    }

    fn name(&self, index: usize) -> String {
        self.fit.fps.name(index).to_string()
    }

    /// The readings behind each end of the PUI.
    fn proofs(&self) -> Vec<Vec<Text>> {
        let mut rows = Vec::new();
        for (axis, ParameterInterval { lower, upper }) in self.fit.pui.iter().flatten().enumerate() {
            let own = &self.theta[axis];
            for (relation, end) in [(Symbol::AtLeast, lower), (Symbol::AtMost, upper)] {
                let ParameterBound::Bounded { value, proof } = end else { continue };
                let terms =
                    proof.multipliers.iter().map(|m| (self.style.proof(&m.value), self.name(m.index)));
                let label = Text::from(THETA[axis]).mark(" ").symbol(relation);
                rows.push(vec![label, own.end(relation, value), products(terms)]);
            }
        }
        rows
    }
}
