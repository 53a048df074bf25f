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

    /// Returns the format that a file's name announces, packed or not.
    pub fn of_name(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let name = name.strip_suffix(".gz").or_else(|| name.strip_suffix(".zst")).unwrap_or(&name);
        let (_, ending) = name.rsplit_once('.')?;
        Self::ALL.into_iter().find(|format| format.name() == ending)
    }

    /// Returns the format of a text: LP begins with a comment behind `\` or with what is wanted of the objective. A comment behind `/`
    /// is lp_solve's, whose format the reader of LP knows.
    pub fn of_text(text: &str) -> Self {
        let start = text.trim_start_matches('\u{feff}').trim_start();
        let word: String = start.chars().take(3).flat_map(char::to_lowercase).collect();
        match start.starts_with(['\\', '/']) || word == "min" || word == "max" {
            true => ExchangeFormat::Lp,
            false => ExchangeFormat::Mps,
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
