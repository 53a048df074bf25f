//! The report of a calibration: its linearity in four ways, hysteresis and repeatability.

mod csv;
mod json;
#[cfg(feature = "files")]
mod proof;

use boundfit_exact::english::{MOST, counted, list, list_of};
use boundfit_exact::{Foreign, Rational, Rounding, fewest_digits};
use boundfit_geometry::Tally;
use boundfit_questions::{
    Characteristic, Difference, Linearity, LinearityInput, LinearityLine, LinearityOptions, NoLine,
    ResponseColumns,
};

use crate::document::{Block, Document, Facts, Operator, Table, Text};
use crate::fit::fractions;
use crate::formula::pair;
use crate::origin::Origin;
use crate::style::{Style, USUAL_DIGITS};
use crate::table_json::words_of_input;

pub use csv::linearity_csv;
pub use json::linearity_json;
#[cfg(feature = "files")]
pub use proof::{linearity_proof, linearity_question};

/// The four ways, in the order in which they are shown, with what each is measured from.
pub(crate) const METHODS: [(&str, &str); 4] = [
    ("independent", "the line whose largest deviation is smallest (US 15 CFR 772.1)"),
    ("terminal", "the line through both ends of the range of x"),
    ("zero-based", "the line through a given point whose largest deviation is smallest"),
    ("least squares", "the least-squares line"),
];

/// The lines of a characteristic, in the order of [`METHODS`].
pub(crate) fn lines(characteristic: &Characteristic) -> [Result<&LinearityLine, NoLine>; 4] {
    let Characteristic { independent, terminal, zero_based, least_squares, .. } = characteristic;
    [
        Ok(independent),
        terminal.as_ref().map_err(|no_line| *no_line),
        Ok(zero_based),
        least_squares.as_ref().map_err(|no_line| *no_line),
    ]
}

/// The reason why there are no percents.
pub(crate) const NO_PERCENT: &str =
    "full scale is 0: all readings are the same, and nothing is a percentage of that";

/// The report of a calibration.
pub fn linearity_document(
    linearity: &Linearity,
    options: &LinearityOptions,
    input: &LinearityInput,
    origin: &Origin,
    style: &Style,
) -> Document<'static> {
    let report = Report { linearity, options, input, style };
    let mut blocks =
        vec![Block::Title("Linearity".into()), Block::Facts(Facts { width: 10, rows: report.facts(origin) })];
    let parts = [
        ("", Some(&linearity.average)),
        ("Upscale readings alone", linearity.up.as_ref()),
        ("Downscale readings alone", linearity.down.as_ref()),
    ];
    for (title, characteristic) in parts {
        let Some(characteristic) = characteristic else { continue };
        blocks.push(if title.is_empty() { Block::Space } else { Block::Title(title.into()) });
        blocks.extend(report.table(characteristic, !title.is_empty()));
        if title.is_empty() {
            blocks.extend([Block::Space, Block::Facts(Facts { width: 13, rows: report.words() })]);
        }
    }
    blocks.extend(report.proof());
    blocks.push(Block::Results(report.results()));
    Document::new(blocks)
}

struct Report<'a> {
    linearity: &'a Linearity,
    options: &'a LinearityOptions,
    input: &'a LinearityInput,
    style: &'a Style,
}

impl Report<'_> {
    fn facts(&self, origin: &Origin) -> Vec<(Text, Text)> {
        let LinearityInput { x, rows, rows_total, rows_missing, selection, .. } = self.input;
        let missing = match rows_missing {
            0 => String::new(),
            &missing => format!(", {} with missing values left out", counted(missing, "row", "rows")),
        };
        let used = match selection.is_all() {
            true => counted(*rows_total, "row", "rows"),
            false => format!("{selection}: {rows} of {rows_total}"),
        };
        let facts = [
            ("data", Text::new().given(origin.name()).words(format!(", {used}{missing}"))),
            ("x", Text::new().given(x)),
            ("y", self.response()),
            ("reading", origin.words_of_reading().into()),
            ("full scale", self.full_scale()),
        ];
        let facts = facts.into_iter().map(|(label, text)| (label.into(), text));
        let table = words_of_input(self.input).map(|words| ("table".into(), words));
        let notes = self.input.fractions.iter().map(|found| ("note".into(), fractions(found)));
        facts.chain(table).chain(notes).collect()
    }

    /// The origin of the characteristic.
    fn response(&self) -> Text {
        let points = counted(self.linearity.average.count(), "point", "points");
        match &self.input.response {
            ResponseColumns::One(y) => Text::new()
                .given(y)
                .words(", each reading as it is: no direction is known, so that none are averaged"),
            ResponseColumns::Two { up, down } => Text::from("at each x the average of ")
                .given(up)
                .words(" and ")
                .given(down)
                .words(format!(", {points}")),
            ResponseColumns::Directed { y, direction, words } => {
                let [up, down] = words.each_ref().map(|words| list(words.iter().map(Foreign::quoted)));
                let which = match (up.is_empty(), down.is_empty()) {
                    (false, false) => format!(" (up: {up}; down: {down})"),
                    (false, true) => format!(" (up: {up}; none is down)"),
                    (true, _) => format!(" (none is up; down: {down})"),
                };
                Text::new()
                    .given(y)
                    .words(", at each x the average of up and down by ")
                    .given(direction)
                    .words(format!("{which}, {points}"))
            }
        }
    }

    fn full_scale(&self) -> Text {
        match &self.options.full_scale {
            Some(given) => self.style.given(given).words(", as given"),
            None => {
                let what = match self.input.response {
                    ResponseColumns::One(_) => ", the span of y",
                    _ => ", the span of the average",
                };
                self.style.given(&self.linearity.average.full_scale).words(what)
            }
        }
    }

    /// The table of the four ways; of one direction with the full scale that is its own.
    fn table(&self, characteristic: &Characteristic, has_own_span: bool) -> Vec<Block<'static>> {
        let style = self.style;
        let styles = self.line_styles(characteristic);
        let mut rows = Vec::new();
        let mut reasons = Vec::new();
        for ((name, _), line) in METHODS.iter().zip(lines(characteristic)) {
            match line {
                Err(no_line) => reasons.push(format!("No {name} linearity: {no_line}.")),
                Ok(line) => {
                    let [slope, intercept] =
                        [0, 1].map(|axis| Text::new().number(styles[axis].nearest(&line.theta[axis])));
                    let percent = line
                        .percent
                        .as_ref()
                        .map_or("-".into(), |percent| Text::new().number(style.upper(percent)));
                    let at = line.tally(characteristic).map_or_else(String::new, |rows| list_of_rows(&rows));
                    let deviation = Text::new().number(style.upper(&line.deviation));
                    rows.push(vec![(*name).into(), deviation, percent, slope, intercept, at.into()]);
                }
            }
        }
        let header = ["", "deviation", "% of full scale", "slope", "intercept", "reached in rows"];
        let mut blocks = vec![Block::Table(Table::new(header, rows))];
        if characteristic.full_scale.is_zero() {
            reasons.push(format!("No percentages: {NO_PERCENT}."));
        } else if has_own_span && self.options.full_scale.is_none() {
            let span = Text::from("Full scale: ").then(style.given(&characteristic.full_scale));
            blocks.push(Block::Paragraph(span.words(", their span.")));
        }
        if !characteristic.independent.unique {
            reasons.push("The independent line is one of several that serve as well.".to_owned());
        }
        blocks.extend(reasons.into_iter().map(|reason| Block::Paragraph(reason.into())));
        blocks
    }

    /// The styles of slopes and of intercepts. As printed, a line deviates by at most a twentieth more than it does; one that meets
    /// every point deviates by less than the span shows.
    fn line_styles(&self, characteristic: &Characteristic) -> [Style; 2] {
        let farthest = characteristic.points.iter().map(|point| point.x.abs()).max().unwrap_or_default();
        let unseen = &characteristic.span * Rational::scientific(1, -(USUAL_DIGITS as i64));
        [(0, farthest), (1, Rational::one())].map(|(axis, reach)| {
            // Slope and intercept share the twentieth.
            let keeps = |line: &LinearityLine, digits: usize| {
                let value = &line.theta[axis];
                let moved = (value - value.rounded(digits, Rounding::Nearest)).abs() * &reach;
                let deviation = if line.deviation.is_zero() { &unseen } else { &line.deviation };
                moved * Rational::from(40) <= *deviation
            };
            let all = |digits| lines(characteristic).into_iter().flatten().all(|line| keeps(line, digits));
            match self.style.digits {
                Some(_) => *self.style,
                None => self.style.with_at_least(fewest_digits(USUAL_DIGITS, all)),
            }
        })
    }

    /// The meaning of each way.
    fn words(&self) -> Vec<(Text, Text)> {
        let [x, y] = &self.options.through;
        let point = pair(self.style.given(x), self.style.given(y));
        let meaning = |(name, meaning): &(&str, &str)| {
            let text = match *name {
                "zero-based" => {
                    let text = Text::from("the line through ").then(point.clone());
                    let text = text.words(" whose largest deviation is smallest");
                    match self.linearity.average.zero_based.unique {
                        true => text,
                        false => text.words("; of several slopes the middle one"),
                    }
                }
                _ => Text::from(*meaning),
            };
            ((*name).into(), text)
        };
        METHODS.iter().map(meaning).collect()
    }

    /// The readings that prove the independent value.
    fn proof(&self) -> Vec<Block<'static>> {
        let characteristic = &self.linearity.average;
        let title = Block::Title("Proof of the independent linearity".into());
        if characteristic.proof.is_empty() {
            let exact = "Nothing needs to: every point lies on one line exactly.";
            return vec![title, Block::Paragraph(exact.into())];
        }
        let mut rows = Vec::new();
        for point in &characteristic.proof {
            let Some(place) = characteristic.points.get(point.position) else { continue };
            rows.push(vec![
                self.style.given(&place.x),
                list_of_rows(&place.rows).into(),
                self.signed(&point.deviation),
                self.style.proof(&point.weight),
            ]);
        }
        let several = rows.len() != 2;
        let sentence = match several {
            true => {
                "The deviations of these points alternate in sign. Each times its weight and sign, they add up to the same \
                 for every straight line, so that for none the largest is smaller."
            }
            false => {
                "These two have the same x, so that every straight line is at least half their distance away from one of \
                 them."
            }
        };
        let header = ["x", "rows", "deviation", "weight"];
        vec![title, Block::Table(Table::new(header, rows)), Block::Paragraph(sentence.into())]
    }

    /// A number with its sign, to nearest.
    fn signed(&self, value: &Rational) -> Text {
        let size = value.abs();
        let text = Text::new().mark(if value.is_negative() { "-" } else { "+" });
        text.number(self.style.nearest(&size))
    }

    /// Hysteresis and repeatability.
    fn results(&self) -> Vec<(Text, Text)> {
        let is_plain = matches!(self.input.response, ResponseColumns::One(_));
        let no_hysteresis = match is_plain {
            true => "not known: nothing tells which readings were taken upwards and which downwards",
            false => "not known: no x was read in both directions",
        };
        let repeatability = match is_plain {
            true => "no x was read twice",
            false => "no x was read twice in one direction",
        };
        vec![
            ("hysteresis".into(), self.difference(self.linearity.hysteresis.as_ref(), no_hysteresis)),
            ("repeatability".into(), self.difference(self.linearity.repeatability.as_ref(), repeatability)),
        ]
    }

    /// A difference with the places where it is reached.
    fn difference(&self, difference: Option<&Difference>, none: &str) -> Text {
        let Some(Difference { value, at }) = difference else { return none.into() };
        let mut text = Text::new().number(self.style.upper(value));
        let full_scale = &self.linearity.average.full_scale;
        if let Some(percent) = (value * Rational::from(100)).checked_div(full_scale) {
            text = text.words(" (").number(self.style.upper(&percent)).words(" % of full scale)");
        }
        let Some(first) = at.first() else { return text };
        let rows = list_of_rows(&first.rows);
        let noun = if first.rows.count() == 1 { "row" } else { "rows" };
        let more = match at.len() - 1 {
            0 => String::new(),
            more => format!(", and at {} more", counted(more, "x", "x")),
        };
        let place = Text::from(" at x").operator(Operator::Equals).then(self.style.given(&first.x));
        text.then(place).words(format!(", {noun} {rows}{more}"))
    }
}

/// Row numbers, of which only the first are read: there may be very many.
fn list_of_rows(rows: &Tally) -> String {
    let first: Vec<String> = rows.rows().take(MOST).map(|row| row.to_string()).collect();
    let more = rows.listed() - first.len();
    list_of(first.into_iter(), more)
}
