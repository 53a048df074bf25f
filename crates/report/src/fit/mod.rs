//! The report of a fit.

mod brief;
mod estimates;
mod results;

pub use brief::brief_document;
pub(crate) use estimates::bounded_rows;

use boundfit_estimation::{
    BoundName, ErrorBound, Fit, FractionCells, Inverse, Measurement, Model, MultipleOfLeast, NoLeastSquares,
    ParameterBound, ParameterInterval, Problem, Ties, mending_rows,
};
use boundfit_exact::english::{counted, listed};
use boundfit_exact::{Foreign, Interval, Rational, Reading};

use crate::advice::bounding_reading;
use crate::document::{Block, Document, Facts, Operator, Symbol, THETA, Table, Text};
use crate::fit_json::NO_MENDING;
use crate::formula::{absurdity, products};
use crate::origin::Origin;
use crate::region::{names_of, region_blocks};
use crate::scale::{Scale, scales};
use crate::style::Style;
use crate::table_json::table_words;

/// What the set is called in titles.
const SET: &str = "Feasible parameter set (FPS)";

/// When the report has gain and offset of the inverse line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InverseLine {
    /// Where every feasible line has one: 0 is not in the PUI of θ1.
    #[default]
    WhereItExists,
    /// Always.
    Always,
}

/// The report of a fit. The last part of it are the remaining results, so that [`Document::add_result`] can add to them.
pub fn fit_document(
    problem: &Problem,
    fit: &Fit,
    origin: &Origin,
    inverse_line: InverseLine,
    style: &Style,
) -> Document {
    let pui = fit.pui_intervals();
    let report = Report::new(problem, fit, pui.as_ref(), inverse_line, style);
    let mut blocks = vec![Block::Title("Set-membership fit".into())];
    blocks.push(Block::Facts(Facts { width: 7, rows: report.facts(origin) }));
    let region = fit.fps.polyhedron().region();
    if region.is_empty() {
        // Nothing else matters as much.
        blocks.extend(empty_blocks(problem, fit, style));
    }
    blocks.extend(estimates::blocks(&report));
    if !region.is_empty() {
        let names = |indices: &[usize]| names_of(&fit.fps.active(indices, Ties::MOST_LISTED));
        blocks.extend(region_blocks(SET, region, &report.theta, names));
    }
    let advice = bounding_reading(region, &problem.measurements, style);
    blocks.extend(advice.map(Block::Paragraph));
    let proofs = report.proofs();
    if !proofs.is_empty() {
        let header = Text::from("multiplier").operator(Operator::Times).words("(row and bound)");
        blocks.push(Block::Title("What proves each end of the PUI".into()));
        blocks.push(Block::Table(Table::new([Text::new(), Text::new(), header], proofs)));
    }
    blocks.push(Block::Results(results::lines(&report)));
    Document::new(blocks)
}

/// What was fitted, in which way, for the head of any answer about readings.
pub(crate) fn fit_facts(problem: &Problem, fit: &Fit, origin: &Origin, style: &Style) -> Facts {
    let report = Report::new(problem, fit, None, InverseLine::default(), style);
    Facts { width: 7, rows: report.facts(origin) }
}

/// Of an empty set which rows contradict each other, and what would help, for any answer that needs a set.
pub(crate) fn empty_blocks(problem: &Problem, fit: &Fit, style: &Style) -> Vec<Block> {
    let report = Report::new(problem, fit, None, InverseLine::default(), style);
    let title = Block::Title(format!("{SET}: {}", fit.fps.polyhedron().region().kind().name()).into());
    [title].into_iter().chain(report.emptiness().into_iter().map(Block::Paragraph)).collect()
}

/// What an error bound that was found from the readings themselves stands and falls with.
fn assumption(MultipleOfLeast { factor, least }: &MultipleOfLeast, style: &Style) -> Text {
    let text = match *factor == Rational::one() {
        true => Text::from("that no error is larger than eps_min, "),
        false => {
            Text::from("that no error is larger than ").then(style.given(factor)).words(" times eps_min, ")
        }
    };
    let text = text.number(style.upper(least)).words(
        ", the least bound under which any theta fits. It was found from these very readings, which cannot show that \
         errors are no larger; if one is, the intervals below may miss the true theta.",
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

/// What the parts of a report are made of.
struct Report<'a> {
    problem: &'a Problem,
    fit: &'a Fit,
    style: &'a Style,
    /// How the values of the two parameters are shown.
    theta: [Scale<'a>; 2],
    inverse_line: InverseLine,
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
        let theta = scales(style, pui, &others, &estimates, fit.fps.polyhedron().region().vertices());
        Report { problem, fit, style, theta, inverse_line }
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

    /// What was fitted, in which way.
    fn facts(&self, &Origin { file, reading, is_stored }: &Origin) -> Vec<(Text, Text)> {
        let measurements = &self.problem.measurements;
        let bounded = Text::new().mark("|").symbol(Symbol::Error).mark("|").operator(Operator::AtMost);
        let bound = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => {
                let law = measurements.law();
                let bounded =
                    law.map_or(bounded.clone(), |law| bounded.given(law.text()).operator(Operator::Equals));
                // Nobody wrote a multiple of eps_min down: its digits are those of a result.
                match measurements.multiple_of_least() {
                    Some(_) => bounded.number(self.style.upper(epsilon)),
                    None => bounded.then(self.style.given(epsilon)),
                }
            }
            ErrorBound::Column(column) => bounded.given(column).words(", one bound per row"),
            ErrorBound::Law(law) if law.is_asymmetric() => {
                Text::from("y ").given(law.text()).words(" of each row")
            }
            ErrorBound::Law(law) => bounded.given(law.text()).words(" of each row"),
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
        let missing = match measurements.rows_missing() {
            0 => String::new(),
            missing => format!(", {} with missing values left out", counted(missing, "row", "rows")),
        };
        let reading = match reading {
            _ if is_stored => "binary64: the numbers of the file exactly as stored",
            Reading::Decimal => "decimal: numbers exactly as written",
            Reading::Binary64 => "binary64: the double nearest to each number, exactly",
        };
        let multiple = measurements.multiple_of_least();
        let label = match measurements.error_bound() {
            ErrorBound::Interval { .. } => "bounds",
            _ => "error",
        };
        let facts = [("model", self.model()), (label, bound)]
            .into_iter()
            .chain(multiple.map(|multiple| ("assumes", assumption(multiple, self.style))))
            .chain([
                (
                    "data",
                    Text::new()
                        .given(file.unwrap_or(Foreign::of("standard input")))
                        .words(format!(", {rows}{missing}")),
                ),
                ("reading", reading.into()),
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
        model.operator(Operator::Plus).symbol(Symbol::Error)
    }

    /// How many of the bounds that two columns may have are there, and what least squares takes.
    fn intervals(&self) -> Text {
        let measurements = &self.problem.measurements;
        let rows = measurements.kept();
        let ties = measurements.ties().filter(|_| measurements.every().is_some());
        let times = |row: &Measurement| ties.map_or(1, |ties| ties.count(row.row));
        let all: usize = rows.iter().map(times).sum();
        let lacking: usize = rows.iter().filter(|row| row.half_width().is_none()).map(times).sum();
        // Of the other rows it is not known.
        let which = if measurements.every().is_some() { "" } else { " kept" };
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

    /// Of an empty set which rows contradict each other, and what would help.
    fn emptiness(&self) -> Vec<Text> {
        let (style, error_bound) = (self.style, self.problem.measurements.error_bound());
        let terms = self.fit.contradiction(error_bound).unwrap_or_default();
        let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
        let verb = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
        let contradiction = format!("No theta meets every bound. These {verb}: {}.", names.join(", "));
        let products = products(terms.iter().map(|(name, m)| (style.proof(m), name.to_string())));
        let proof = absurdity(Text::from("Proof: ").then(products), &self.sum_of(&terms), style);
        let help = match (&self.fit.minimax, error_bound) {
            (None, _) if !self.problem.measurements.has_widths() => {
                "No row has both bounds, so there is no width that could grow.".into()
            }
            (None, _) => "A larger error bound would not help.".into(),
            (Some(minimax), ErrorBound::Uniform(epsilon)) => {
                let growth = Text::from("The error bound would have to grow by ")
                    .number(style.upper(&(&minimax.least - epsilon)));
                growth.words(", to at least ").then(style.upper_with_exact(&minimax.least)).words(".")
            }
            (Some(minimax), ErrorBound::Column(_) | ErrorBound::Law(_)) => {
                Text::from("All error bounds would have to grow by a factor of at least ")
                    .then(style.upper_with_exact(&minimax.least))
                    .words(".")
            }
            (Some(minimax), ErrorBound::Interval { .. }) => {
                Text::from("All intervals would have to grow about their middles by a factor of at least ")
                    .then(style.upper_with_exact(&minimax.least))
                    .words(".")
            }
        };
        let is_known = self.problem.measurements.deciding_minimax().is_ok();
        let help = self.swapped().map_or_else(|| is_known.then_some(help), |why| Some(why.into()));
        let mending = self.mending().into();
        [contradiction.into(), proof.words(".")].into_iter().chain(help).chain([mending]).collect()
    }

    /// In how many rows the lower bound is above the upper one, if in any.
    fn swapped(&self) -> Option<String> {
        let measurements = &self.problem.measurements;
        let rows = measurements.kept();
        let is_swapped =
            |row: &&Measurement| row.lower().zip(row.upper()).is_some_and(|(lower, upper)| lower > upper);
        let count = rows.iter().filter(is_swapped).count();
        // Of the other rows it is not known.
        let which = if measurements.all().is_some() { "rows" } else { "rows kept" };
        (count > 0).then(|| {
            format!("In {count} of {} {which} the lower bound is above the upper one: swapped?", rows.len())
        })
    }

    /// Which single row an empty set would have to lose.
    fn mending(&self) -> String {
        match mending_rows(self.problem, self.fit).as_deref() {
            None => format!("Which row alone would mend it is not told, {NO_MENDING}."),
            Some([]) => "To leave out a single row would not mend it.".to_owned(),
            Some([row]) => format!("To leave out row {row} would mend it; no other single row would."),
            Some(rows) => {
                let rows: Vec<String> = rows.iter().map(ToString::to_string).collect();
                format!("To leave out one of the rows {} would mend it; no other would.", listed(&rows))
            }
        }
    }

    /// The right-hand side of a combination of half-planes.
    fn sum_of(&self, terms: &[(BoundName, Rational)]) -> Rational {
        let inequalities = self.fit.fps.polyhedron().system().inequalities();
        let right_hand_side = |name: &BoundName| {
            (0..inequalities.len())
                .find(|&index| self.fit.fps.name(index) == *name)
                .map(|index| &inequalities[index].b)
        };
        terms.iter().filter_map(|(name, multiplier)| Some(right_hand_side(name)? * multiplier)).sum()
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
