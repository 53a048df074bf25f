//! The line in front of a reduction.

use boundfit_exact::{Foreign, Limits, Rational, Reading};
use serde::{Deserialize, Serialize};

use super::error::ReductionError;
use super::marks::ReducedMarks;
use super::model::{AskedReduction, ReducedBounds, ReducedModel};

/// The beginning of the line in front, before the number of the format.
pub const REDUCTION_MARK: &str = "# boundfit/reduced/";

/// The line in front of a reduction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReductionRecord {
    /// The number of readings.
    pub rows: usize,
    /// The number of lines that follow.
    pub kept: usize,
    /// `true` if each of these lines begins with how many readings it stands for.
    pub counted: bool,
    /// `true` if the first line that follows is a header.
    pub header: bool,
    /// The number of lines of the header: a cell in quotes may have several.
    pub header_lines: usize,
    /// `decimal` or `binary64`: how numbers were read.
    pub reading: String,
    /// The marks and words that were stated for the cells of the table, which the rows still have.
    pub written: ReducedMarks,
    /// The questions that a reduction serves.
    pub model: ReducedModel,
    /// `true` if a reading has two bounds, whose distance a factor may multiply.
    pub widths: bool,
    /// Σu², Σuv, Σv², Σuy and Σvy over all readings, each as `p/q` or `n`; of a line u is x and v is 1. `None` where a reading
    /// has nothing that least squares could take for y.
    pub sums: Option<[String; 5]>,
}

/// Format 1, or 3 with counts: of a line under one bound for all readings, whatever it is, or under any multiple of a column of bounds.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record1 {
    rows: usize,
    kept: usize,
    header: bool,
    #[serde(default = "one", skip_serializing_if = "is_one")]
    header_lines: usize,
    reading: String,
    #[serde(default, skip_serializing_if = "ReducedMarks::is_empty")]
    written: ReducedMarks,
    x: Foreign,
    y: Foreign,
    epsilon: Option<Foreign>,
    /// Σx, Σy, Σx² and Σxy.
    sums: [String; 4],
}

/// Format 2, or 4 with counts: under bounds that are fixed.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record2 {
    rows: usize,
    kept: usize,
    header: bool,
    #[serde(default = "one", skip_serializing_if = "is_one")]
    header_lines: usize,
    reading: String,
    #[serde(default, skip_serializing_if = "ReducedMarks::is_empty")]
    written: ReducedMarks,
    /// x of a line, or two.
    x: Vec<Foreign>,
    y: Option<Foreign>,
    bounds: ReducedBounds,
    widths: bool,
    sums: Option<[String; 5]>,
}

impl ReductionRecord {
    /// The sums as numbers; `None` where there are none.
    ///
    /// # Errors
    /// When one of them is not a number within the limits.
    pub fn sums(&self, limits: &Limits) -> Result<Option<[Rational; 5]>, ReductionError> {
        let Some(texts) = &self.sums else { return Ok(None) };
        let mut numbers = [const { None }; 5];
        for (number, text) in numbers.iter_mut().zip(texts) {
            *number = Some(Reading::Decimal.read(text, limits)?);
        }
        Ok(Some(numbers.map(Option::unwrap_or_default)))
    }

    /// Returns whether the reduction serves what is asked for in this reading of numbers.
    ///
    /// # Errors
    /// The first thing that differs.
    pub fn check(&self, asked: &AskedReduction, reading: Reading) -> Result<(), ReductionError> {
        self.model.check(asked)?;
        if self.reading != reading.name() {
            let (has, asked) = (Foreign::of(&self.reading).to_string(), reading.name().to_owned());
            return Err(ReductionError::NotAsked { what: "the reduction is about the reading", has, asked });
        }
        Ok(())
    }

    /// The line in front, without line end.
    pub fn line(&self) -> String {
        let ReductionRecord {
            rows,
            kept,
            counted,
            header,
            header_lines,
            reading,
            written: cells,
            model,
            widths,
            sums,
        } = self.clone();
        let of_counted = if counted { 2 } else { 0 };
        let epsilon = match &model.bounds {
            ReducedBounds::Any => None,
            ReducedBounds::Multiples(column) => Some(column.clone()),
            _ => {
                let ReducedModel { regressors: x, response: y, bounds } = model;
                return written(
                    2 + of_counted,
                    &Record2 {
                        rows,
                        kept,
                        header,
                        header_lines,
                        reading,
                        written: cells,
                        x,
                        y,
                        bounds,
                        widths,
                        sums,
                    },
                );
            }
        };
        let [xx, x_sum, _, xy, y_sum] = sums.unwrap_or_default();
        let x = model.regressors.into_iter().next().unwrap_or_default();
        let y = model.response.unwrap_or_default();
        let sums = [x_sum, y_sum, xx, xy];
        written(
            1 + of_counted,
            &Record1 { rows, kept, header, header_lines, reading, written: cells, x, y, epsilon, sums },
        )
    }

    pub(super) fn parse(line: &[u8]) -> Result<Self, ReductionError> {
        let bad = |error: serde_json::Error| ReductionError::BadRecord(error.to_string().into());
        let rest = line.strip_prefix(REDUCTION_MARK.as_bytes()).unwrap_or_default();
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (format, json) = rest.split_at_checked(end).unwrap_or_default();
        match format {
            b"1" | b"3" => {
                let record: ReductionRecord = serde_json::from_slice::<Record1>(json).map_err(bad)?.into();
                Ok(ReductionRecord { counted: format == b"3", ..record })
            }
            b"2" | b"4" => {
                let record = serde_json::from_slice::<Record2>(json).map_err(bad)?.checked()?;
                Ok(ReductionRecord { counted: format == b"4", ..record })
            }
            _ => {
                let shown: String = String::from_utf8_lossy(format).chars().take(20).collect();
                Err(ReductionError::UnknownFormat(shown.into()))
            }
        }
    }

    /// Returns the difference that makes two reductions parts of different wholes.
    pub(super) fn difference(&self, other: &Self) -> Option<&'static str> {
        let differences = [
            (self.reading != other.reading, "the reading of numbers"),
            (self.header != other.header, "whether there is a header"),
            (self.written != other.written, "the stated marks in numbers or words for missing values"),
        ];
        let of_others = differences.into_iter().find_map(|(differs, what)| differs.then_some(what));
        self.model.difference(&other.model).or(of_others)
    }
}

/// The usual number of lines of a header.
fn one() -> usize {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn is_one(lines: &usize) -> bool {
    *lines == 1
}

fn written(format: u32, record: &impl Serialize) -> String {
    // Strings, numbers and truth values only: there is nothing in it that cannot be written.
    let json = serde_json::to_string(record).unwrap_or_default();
    format!("{REDUCTION_MARK}{format} {json}")
}

impl From<Record1> for ReductionRecord {
    fn from(record: Record1) -> Self {
        let Record1 {
            rows,
            kept,
            header,
            header_lines,
            reading,
            written,
            x,
            y,
            epsilon,
            sums: [x_sum, y_sum, xx, xy],
        } = record;
        let bounds = epsilon.map_or(ReducedBounds::Any, ReducedBounds::Multiples);
        let model = ReducedModel { regressors: vec![x], response: Some(y), bounds };
        let sums = Some([xx, x_sum, rows.to_string(), xy, y_sum]);
        ReductionRecord {
            rows,
            kept,
            counted: false,
            header,
            header_lines,
            reading,
            written,
            model,
            widths: rows > 0,
            sums,
        }
    }
}

impl Record2 {
    fn checked(self) -> Result<ReductionRecord, ReductionError> {
        let Record2 { rows, kept, header, header_lines, reading, written, x, y, bounds, widths, sums } = self;
        let bad = |problem: &str| Err(ReductionError::BadRecord(problem.into()));
        if !(1..=2).contains(&x.len()) {
            return bad("x has neither one name nor two");
        }
        match (&bounds, &y) {
            (ReducedBounds::Uniform(_), _) if x.len() == 1 => {
                bad("a line under one bound for all readings has format 1")
            }
            (ReducedBounds::Interval { lower: None, upper: None }, _) => bad("neither lower nor upper"),
            (ReducedBounds::Interval { .. }, None) | (_, Some(_)) => {
                let model = ReducedModel { regressors: x, response: y, bounds };
                Ok(ReductionRecord {
                    rows,
                    kept,
                    counted: false,
                    header,
                    header_lines,
                    reading,
                    written,
                    model,
                    widths,
                    sums,
                })
            }
            (_, None) => bad("y is missing"),
        }
    }
}
