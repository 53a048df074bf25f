//! Settings with which a file is read: each surface has a name for it.

use boundfit_exact::{Limit, ParseNumberError, ParseNumberErrorKind};

use super::kind::InputErrorKind;
use crate::reduction::error::ReductionError;

/// A setting that decides whether a file is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Setting {
    /// [`TableOptions::block`](crate::TableOptions::block).
    Block,
    /// [`AskedDialect::decimal`](crate::AskedDialect::decimal).
    Decimal,
    /// [`AskedDialect::delimiter`](crate::AskedDialect::delimiter).
    Delimiter,
    /// [`AskedDialect::encoding`](crate::AskedDialect::encoding).
    Encoding,
    /// [`TableOptions::header`](crate::TableOptions::header).
    Header,
    /// [`TableOptions::missing`](crate::TableOptions::missing).
    Missing,
    /// [`TableOptions::sheet`](crate::TableOptions::sheet).
    Sheet,
    /// [`AskedDialect::skip_lines`](crate::AskedDialect::skip_lines).
    SkipLines,
    /// [`AskedDialect::thousands`](crate::AskedDialect::thousands).
    Thousands,
    /// [`AskedDialect::units_row`](crate::AskedDialect::units_row).
    UnitsRow,
    /// A limit.
    Limit(Limit),
}

impl Setting {
    /// The words of its name: `skip lines`; of a limit the limit's.
    pub fn name(self) -> &'static str {
        match self {
            Setting::Block => "block",
            Setting::Decimal => "decimal",
            Setting::Delimiter => "delimiter",
            Setting::Encoding => "encoding",
            Setting::Header => "header",
            Setting::Missing => "missing",
            Setting::Sheet => "sheet",
            Setting::SkipLines => "skip lines",
            Setting::Thousands => "thousands",
            Setting::UnitsRow => "units row",
            Setting::Limit(limit) => limit.name(),
        }
    }
}

/// A way out of a refusal: a setting, and what it does then.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Way {
    /// The setting.
    pub setting: Setting,
    /// The value that the option gets; empty for a switch.
    pub value: &'static str,
    /// The effect: `reads any byte`.
    pub effect: &'static str,
}

impl Way {
    pub(crate) fn new(setting: Setting, value: &'static str, effect: &'static str) -> Self {
        Way { setting, value, effect }
    }

    /// Raises a limit.
    pub fn raises(limit: Limit) -> Self {
        Way { setting: Setting::Limit(limit), value: "N", effect: "raises it" }
    }
}

impl InputErrorKind {
    /// The limit that was passed, if that is the problem.
    pub fn limit(&self) -> Option<Limit> {
        match self {
            InputErrorKind::NotANumber(error) => Limit::of_number(&error.kind),
            // Sums are written without exponents.
            InputErrorKind::Reduction(ReductionError::BadSum(error)) => {
                Limit::of_number(&error.kind).filter(|limit| *limit == Limit::Digits)
            }
            InputErrorKind::LineTooLong { .. } | InputErrorKind::RowTooLong { .. } => Some(Limit::Line),
            InputErrorKind::TooManyColumns { .. } => Some(Limit::Columns),
            InputErrorKind::TooManyRows { .. } => Some(Limit::Rows),
            InputErrorKind::TooMuchMemory { .. } => Some(Limit::Memory),
            InputErrorKind::TooManyElements { .. } => Some(Limit::Elements),
            InputErrorKind::TooMuchUnpacked { .. } => Some(Limit::Unpacked),
            InputErrorKind::UnpacksTooFar { .. } | InputErrorKind::HoldsTooMuch { .. } => Some(Limit::Ratio),
            InputErrorKind::TextTooLarge { .. } => Some(Limit::Text),
            InputErrorKind::WorkbookTooLarge { .. } => Some(Limit::Workbook),
            InputErrorKind::TooMuchWork(_) => Some(Limit::Work),
            _ => None,
        }
    }

    /// Settings with which the file is read, whatever stands in the cell, the most helpful first.
    pub(super) fn ways(&self) -> Vec<Way> {
        let way = Way::new;
        match self {
            InputErrorKind::NotUtf8 { unit: "cell", .. } => {
                vec![way(Setting::Encoding, "windows-1252", "reads any byte")]
            }
            InputErrorKind::AmbiguousBlock { .. } => vec![way(Setting::Block, "N", "chooses it")],
            InputErrorKind::EmptySheet { others } if !others.is_empty() => {
                vec![way(Setting::Sheet, "N|NAME", "chooses one")]
            }
            InputErrorKind::SeveralBlocks { .. } | InputErrorKind::UnknownBlock { .. } => vec![
                way(Setting::Block, "N|NAME", "chooses it"),
                way(Setting::Block, "all", "takes the rows of all of them together"),
            ],
            InputErrorKind::NameOrNumber { fits_header: true, .. } => {
                vec![way(Setting::Header, "no", "says that the first row is a reading")]
            }
            InputErrorKind::CommasTwice { .. } => {
                vec![way(Setting::Decimal, "comma", "reads those in quotes")]
            }
            InputErrorKind::NotANumber(ParseNumberError { kind: ParseNumberErrorKind::Comma, .. }) => vec![
                way(Setting::Decimal, "comma", "reads 1,5"),
                way(Setting::Thousands, "','", "reads 60,323 as 60323"),
            ],
            InputErrorKind::NotANumber(ParseNumberError { kind: ParseNumberErrorKind::Point, .. }) => vec![
                way(Setting::Decimal, "point", "reads 1.5"),
                way(Setting::Thousands, "'.'", "reads 60.323 as 60323"),
            ],
            InputErrorKind::NoDelimiter { .. } => vec![
                way(Setting::Delimiter, "comma|semicolon|tab|space|pipe", "says what separates columns"),
                way(Setting::SkipLines, "N", "passes over lines before the table"),
            ],
            InputErrorKind::AnotherDecimalMark { .. } => vec![
                way(Setting::Decimal, "comma|point", "says which"),
                way(Setting::Thousands, "CHARACTER", "says what groups digits"),
            ],
            InputErrorKind::NoNumberInFirstRow { behind_units: true } => {
                vec![
                    way(Setting::SkipLines, "N", "passes over lines before the readings"),
                    way(Setting::Header, "no", "takes columns by number"),
                ]
            }
            InputErrorKind::NoNumberInFirstRow { .. } => {
                vec![
                    way(Setting::UnitsRow, "", "passes over a row of units"),
                    way(Setting::SkipLines, "N", "passes over lines before the table"),
                ]
            }
            InputErrorKind::Missing { .. } => vec![way(Setting::Missing, "skip", "leaves such rows out")],
            _ => self.limit().map(Way::raises).into_iter().collect(),
        }
    }
}
