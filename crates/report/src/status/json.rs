//! The statuses of readings as JSON, schema `boundfit/status/1`.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::Foreign;
use boundfit_questions::{NoRepair, Repair, RowStatus, Standing, Widened};
use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::TermJson;
use crate::answer::status::{
    JudgedSetJson, NewStatusRowJson, RepairJson, RowMultiplierJson, StatusHeadJson, StatusRowJson,
    StatusesJson, WidenedJson,
};
use crate::json::to_text;
use crate::number::Number;
use crate::origin::Origin;
use crate::style::Style;

/// The report in parts, so that memory need not hold all rows. The parts are [head](StatusJson::head), the rows with
/// [`StatusJson::BETWEEN`] between them, and [`StatusJson::END_OF_ROWS`]. Further readings follow
/// [`StatusJson::new_head`] in the same way, and [`StatusJson::TAIL`] comes last.
#[derive(Debug)]
pub struct StatusJson;

impl WidenedJson {
    fn new(Widened { row, factor, half_width }: &Widened, style: &Style) -> Self {
        WidenedJson {
            row: *row,
            factor: style.upper_number(factor),
            half_width: style.upper_number(half_width),
        }
    }
}

impl StatusJson {
    /// The text between two rows.
    pub const BETWEEN: &'static str = ",\n";
    /// The text after the last row.
    pub const END_OF_ROWS: &'static str = "\n  ]";
    /// The end of the report.
    pub const TAIL: &'static str = "\n}\n";

    /// All before the first row. `deciding` are the rows that a set of the others may be different without.
    pub fn head(
        problem: &Problem,
        fit: &Fit,
        deciding: impl Iterator<Item = usize>,
        origin: &Origin,
        style: &Style,
    ) -> String {
        let contradiction = fit.contradiction(problem.measurements.error_bound());
        let head = StatusHeadJson {
            schema: StatusesJson::SCHEMA,
            input: InputJson::new(problem, origin, style),
            set: JudgedSetJson {
                kind: fit.fps.polyhedron().region().kind().name(),
                contradiction: contradiction.map(|terms| TermJson::all(&terms, style)),
            },
            deciding: deciding.collect(),
        };
        format!("{},\n  \"rows\": [\n", to_text(&head).trim_end_matches(Self::TAIL))
    }

    /// The least total widening, or why there is none.
    pub fn repair(repair: &Result<Repair, NoRepair>, style: &Style) -> String {
        let json = match repair {
            Ok(own) => RepairJson {
                total: Some(style.number(&own.total)),
                count: Some(own.count),
                theta: Some(style.numbers(&own.theta)),
                widened: own.widened.iter().map(|own| WidenedJson::new(own, style)).collect(),
                multipliers: own
                    .multipliers
                    .iter()
                    .map(|(row, value)| RowMultiplierJson { row: *row, value: style.number(value) })
                    .collect(),
                held: TermJson::all(&own.held, style),
                contradiction: None,
            },
            Err(NoRepair::Contradiction(contradiction)) => RepairJson {
                contradiction: Some(TermJson::all(contradiction, style)),
                ..RepairJson::default()
            },
            Err(NoRepair::NotInMemory) => RepairJson::default(),
        };
        format!(",\n  \"repair\": {}", to_text(&json).trim_end().replace('\n', "\n  "))
    }

    /// The text before the first of the further readings.
    pub fn new_head(file: Option<Foreign<&str>>) -> String {
        let file = to_text(&file.map(|file| -> Foreign { file.into() }));
        format!(",\n  \"new\": {{\n  \"file\": {},\n  \"rows\": [\n", file.trim_end())
    }

    /// The text after the last of the further readings.
    pub const END_OF_NEW: &'static str = "\n  ]\n  }";

    /// A reading of the set.
    pub fn row(status: &RowStatus, style: &Style) -> String {
        // Few readings decide. To all others both sets are alike, and digits are most of the work.
        if let Some(all) = status.all.as_ref().filter(|_| status.all == status.without) {
            return line_of_alike(status.row, all, style);
        }
        let ([leverage, residual], name) = parts(status.all.as_ref(), style);
        let ([without_leverage, without_residual], without) = parts(status.without.as_ref(), style);
        let row = status.row;
        line(&StatusRowJson {
            row,
            leverage,
            residual,
            status: name,
            without,
            without_leverage,
            without_residual,
        })
    }

    /// A further reading.
    pub fn new_row(row: usize, standing: Option<&Standing>, style: &Style) -> String {
        let ([leverage, residual], status) = parts(standing, style);
        line(&NewStatusRowJson { row, leverage, residual, status })
    }
}

type Parts = ([Option<Number>; 2], Option<&'static str>);

fn parts(standing: Option<&Standing>, style: &Style) -> Parts {
    let Some(Standing { leverage, residual, status }) = standing else { return ([None, None], None) };
    let numbers = [leverage, residual].map(|number| number.as_ref().map(|number| style.number(number)));
    (numbers, Some(status.name()))
}

/// A [`StatusRowJson`] of a reading that stands to both sets alike: each number becomes text once.
fn line_of_alike(row: usize, both: &Standing, style: &Style) -> String {
    let (numbers, _) = parts(Some(both), style);
    let ([leverage, residual], status) = (numbers.map(|number| json(&number)), both.status.name());
    format!(
        "    {{\"row\":{row},\"leverage\":{leverage},\"residual\":{residual},\"status\":\"{status}\",\"without\":\"{status}\",\
         \"without_leverage\":{leverage},\"without_residual\":{residual}}}"
    )
}

/// Writes a row on one line, so that many rows stay readable.
fn line(row: &impl Serialize) -> String {
    format!("    {}", json(row))
}

fn json(value: &impl Serialize) -> String {
    // Strings, numbers and nulls only: there is nothing that cannot be written.
    serde_json::to_string(value).expect("a row that is not JSON")
}
