//! Settings with which a file is read: each surface has a name for it.

use boundfit_exact::Limit;

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
