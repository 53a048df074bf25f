//! Limits by their names.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use boundfit_exact::{Limit, Limits};
use boundfit_formats::{MemoryBudget, SizeLimits};

use crate::refusal::{Refusal, ValueProblem};

/// The most that an input may ask for of something, by the names of limits ([`Limit::name`]).
pub type AskedLimits = BTreeMap<String, u64>;

/// The limits of whatever is read. The others belong to one question or form each.
pub fn limits_of_files() -> impl Iterator<Item = Limit> {
    let is_own =
        |limit: &Limit| matches!(limit, Limit::Fraction | Limit::Sets | Limit::Steps | Limit::Readings);
    Limit::ALL.into_iter().filter(move |limit| !is_own(limit))
}

/// Returns the numbers that a limit of files may be raised or lowered to.
pub fn range_of_limit(limit: Limit) -> RangeInclusive<u64> {
    const LONG: u64 = 1_000_000;
    match limit {
        Limit::Digits | Limit::Fraction | Limit::Sets => 1..=LONG,
        Limit::Exponent => 0..=LONG,
        Limit::Line | Limit::Columns | Limit::Rows | Limit::Elements => 1..=1 << 32,
        Limit::Workbook => 1..=1 << 40,
        Limit::Nesting => 1..=120,
        Limit::Work | Limit::Steps => 0..=u64::MAX,
        Limit::Unpacked | Limit::Ratio | Limit::Text | Limit::Memory | Limit::Readings => 1..=u64::MAX,
    }
}

/// The limits of one number, and those of a file.
///
/// # Errors
/// When there is no such limit of files, or it cannot be so large or so small.
pub fn resolve_limits(asked: &AskedLimits) -> Result<(Limits, SizeLimits), Refusal> {
    let (mut numbers, mut sizes) = (Limits::default(), SizeLimits::default());
    for (name, &most) in asked {
        let limit = limits_of_files().find(|limit| limit.name() == name);
        let limit = limit.ok_or_else(|| {
            let problem = match name.as_str() {
                "sets" | "steps" => ValueProblem::Other(format!("'outliers' has a key for it, max_{name}")),
                _ => ValueProblem::OneOf(limits_of_files().map(|limit| limit.name().to_owned()).collect()),
            };
            Refusal::Value { key: "limits", text: name.clone(), problem }
        })?;
        let range = range_of_limit(limit);
        if !range.contains(&most) {
            let problem = ValueProblem::Range { name: limit.name(), range };
            return Err(Refusal::Value { key: "limits", text: most.to_string(), problem });
        }
        // A size that no memory of this machine holds is as good as the largest one.
        let size = usize::try_from(most).unwrap_or(usize::MAX);
        match limit {
            Limit::Digits => numbers.digits = size,
            Limit::Exponent => numbers.exponent = u32::try_from(most).unwrap_or(u32::MAX),
            Limit::Line => sizes.line = size,
            Limit::Columns => sizes.columns = size,
            Limit::Rows => sizes.rows = size,
            Limit::Elements => sizes.elements = size,
            Limit::Unpacked => sizes.unpacked = most,
            Limit::Ratio => sizes.ratio = most,
            Limit::Workbook => sizes.workbook = most,
            Limit::Work => sizes.work = most,
            Limit::Text => sizes.text = most,
            Limit::Nesting => sizes.nesting = size,
            Limit::Memory => sizes.memory = MemoryBudget::new(most),
            // None of files.
            Limit::Fraction | Limit::Sets | Limit::Steps | Limit::Readings => {}
        }
    }
    Ok((numbers, sizes))
}
