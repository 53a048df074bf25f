//! The formats of linear programs in files.

/// A format of linear programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExchangeFormat {
    /// Free MPS.
    Mps,
    /// CPLEX's LP format.
    Lp,
}

impl ExchangeFormat {
    /// Both of them.
    pub const ALL: [ExchangeFormat; 2] = [ExchangeFormat::Mps, ExchangeFormat::Lp];

    /// The name on the command line, and the end of a file's name: `mps` or `lp`.
    pub fn name(self) -> &'static str {
        match self {
            ExchangeFormat::Mps => "mps",
            ExchangeFormat::Lp => "lp",
        }
    }

    /// Returns what the name stands for.
    pub fn title(self) -> &'static str {
        match self {
            ExchangeFormat::Mps => "Free-format MPS",
            ExchangeFormat::Lp => "CPLEX LP format",
        }
    }
}
