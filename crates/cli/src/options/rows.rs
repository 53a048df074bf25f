//! The data rows that are used.

use boundfit_ask::{Given, RowWords, Rows};
use clap::Args;

/// The data rows that are used.
#[derive(Debug, Clone, Args)]
pub(crate) struct RowArguments {
    /// Use only these data rows, counted from 1 without the header: 14..36, 5, ..10, 10.. or a list such as
    /// 1..22,24..50
    #[arg(long, value_name = "ROWS")]
    rows: Option<String>,
    /// Skip these data rows, such as 23,31 or 40..
    #[arg(long, value_name = "ROWS")]
    without: Option<String>,
    /// Use only rows where a number in a column compares so (< <= = != >= >), such as 'temperature >= 20'. The column
    /// is a name, quoted or not, or a number; if repeated, all comparisons must hold
    #[arg(long, value_name = "COMPARISON", allow_hyphen_values = true)]
    where_row: Vec<String>,
}

impl RowArguments {
    /// The rows as they are asked for.
    pub(crate) fn words(&self) -> RowWords {
        let rows = |asked: &Option<String>| asked.clone().map(Rows::Text).unwrap_or_default();
        RowWords {
            rows: rows(&self.rows),
            without: rows(&self.without),
            where_row: self.where_row.iter().cloned().map(Given::Read).collect(),
        }
    }
}
