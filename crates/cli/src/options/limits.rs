//! The limits on inputs, so that a hostile input costs neither memory nor time: one option, which names the limit.

use std::ops::RangeInclusive;
use std::sync::{Arc, OnceLock};

use boundfit_ask::{AskedLimits, limits_of_files, range_of_limit, resolve_limits};
use boundfit_exact::{Limit, Limits};
use boundfit_formats::{MemoryBudget, SizeLimits};
use boundfit_questions::OutlierLimits;
use boundfit_report::{LONGEST_FRACTION, Style};
use clap::builder::ValueParser;
use clap::{Arg, Args};

use super::values::parse_size;

/// The heading of limits in the help, below all other options.
const HEADING: &str = "Limits";

/// A limit that is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct AskedLimit {
    limit: Limit,
    most: u64,
}

/// The limits on what an input may ask for. The short help is silent about it: a message that names a limit also says how it is raised.
#[derive(Debug, Clone, Args)]
pub(crate) struct LimitArguments {
    #[arg(long, value_name = "NAME=N", value_parser = parser(&[]), help = HELP, long_help = long_help(&[]),
          help_heading = HEADING, hide_short_help = true)]
    limit: Vec<AskedLimit>,
    /// One budget for all that the command reads.
    #[arg(skip)]
    memory: Arc<OnceLock<MemoryBudget>>,
}

const HELP: &str = "Change the limit of this name; repeatable";

/// The option of a command that has limits of its own.
pub(crate) fn with(own: &'static [Limit]) -> impl FnOnce(Arg) -> Arg {
    move |argument| argument.value_parser(parser(own)).long_help(long_help(own))
}

fn long_help(own: &[Limit]) -> String {
    let mut help =
        format!("{HELP}. Sizes may have a unit, as in memory=512MiB. The names, each with its default:");
    // A program that starts for a few readings spends its time here: defaults are made once.
    let defaults = Defaults::default();
    for limit in limits_of_files().chain(own.iter().copied()) {
        let (most, what) = about(limit, &defaults);
        help += &format!("\n- {} ({most}): {what}", limit.name());
    }
    help
}

/// The limits where nothing else is asked for.
#[derive(Default)]
struct Defaults {
    numbers: Limits,
    sizes: SizeLimits,
    outliers: OutlierLimits,
}

/// Returns the default of a limit, and what it limits.
fn about(limit: Limit, defaults: &Defaults) -> (String, &'static str) {
    let Defaults { numbers, sizes, outliers } = defaults;
    let (most, what) = match limit {
        Limit::Digits => {
            (numbers.digits as u64, "digits of one number, of a fraction above and below its bar")
        }
        Limit::Exponent => (numbers.exponent.into(), "absolute value of a decimal exponent"),
        Limit::Line => (sizes.line as u64, "bytes of one line, and of one row on several lines"),
        Limit::Columns => (sizes.columns as u64, "columns of a table of text or of a linear program"),
        Limit::Rows => {
            (sizes.rows as u64, "rows of an .ine or .ext file or of a linear program, or rows held in memory")
        }
        Limit::Elements => (
            sizes.elements as u64,
            "elements of one array in a .mat file, or coefficients of a linear program",
        ),
        Limit::Unpacked => (sizes.unpacked, "bytes of an unpacked .gz or .zst file"),
        Limit::Ratio => {
            (sizes.ratio, "unpacked size of any packed file as a multiple of its size, beyond 64 MB")
        }
        Limit::Workbook => (sizes.workbook, "bytes of an .xlsx or .ods workbook, packed or unpacked"),
        Limit::Work => (
            sizes.work,
            "products of machine words for exact arithmetic on numbers of more than a thousand digits, and for proofs with many statements",
        ),
        Limit::Text => (
            sizes.text,
            "bytes of a file of half-planes or of a linear program; of a proof, claim or solution, 256MiB",
        ),
        Limit::Nesting => (sizes.nesting as u64, "depth of arrays and objects in a JSON file"),
        Limit::Memory => (
            sizes.memory.limit(),
            "bytes of memory for held readings and everything computed from them, and for reading a file",
        ),
        Limit::Fraction => (
            LONGEST_FRACTION as u64,
            "digits of the fraction of an area or centroid, about as many as all vertices have together; beyond, only its \
             decimal is written",
        ),
        Limit::Sets => (outliers.sets as u64, "listed sets of outliers"),
        Limit::Steps => (outliers.steps, "crossings of two bounds to visit; a million take about a second"),
        Limit::Readings => (
            boundfit_lesson::MOST_ROWS as u64,
            "readings on a page; its size and time grow with their square",
        ),
    };
    let with_unit = |bits: u32| (is_size(limit) && most.trailing_zeros() >= bits).then_some(most >> bits);
    let text = match (with_unit(30), with_unit(20)) {
        (Some(most), _) => format!("{most}GiB"),
        (None, Some(most)) => format!("{most}MiB"),
        (None, None) => most.to_string(),
    };
    (text, what)
}

/// Returns whether the limit is counted in bytes.
fn is_size(limit: Limit) -> bool {
    matches!(limit, Limit::Line | Limit::Unpacked | Limit::Workbook | Limit::Text | Limit::Memory)
}

/// Returns the values that a user may ask for.
fn range(limit: Limit) -> RangeInclusive<u64> {
    match limit {
        Limit::Readings => 1..=boundfit_lesson::MOST_ROWS_EVER.into(),
        limit => range_of_limit(limit),
    }
}

/// Reads `memory=512MiB` and `digits=20000`.
fn parser(own: &'static [Limit]) -> ValueParser {
    ValueParser::new(move |text: &str| parse(text, own))
}

fn parse(text: &str, own: &[Limit]) -> Result<AskedLimit, String> {
    let (name, number) = text
        .split_once('=')
        .ok_or("expected NAME=N, such as digits=20000 or memory=4GiB; --help lists the names")?;
    let limits = || limits_of_files().chain(own.iter().copied());
    let limit = limits().find(|limit| limit.name() == name.trim()).ok_or_else(|| {
        let names: Vec<&str> = limits().map(Limit::name).collect();
        let is_another = Limit::ALL.iter().any(|limit| limit.name() == name.trim());
        let of_this = if is_another { " for this command" } else { "" };
        format!("there is no limit {name:?}{of_this} (expected one of {})", names.join(", "))
    })?;
    const SIZE: &str =
        "a size in bytes above 0, with k, M, G (1000) or KiB, MiB, GiB (1024) behind it, such as 512MiB";
    let most = if is_size(limit) { parse_size(number.trim()) } else { number.trim().parse().ok() };
    let range = range(limit);
    most.filter(|most| range.contains(most)).map(|most| AskedLimit { limit, most }).ok_or_else(|| {
        let expected = match (is_size(limit), *range.end()) {
            (true, u64::MAX) => SIZE.to_owned(),
            (true, end) => format!("{SIZE}, at most {end}"),
            (false, u64::MAX) => format!("an integer from {}", range.start()),
            (false, end) => format!("an integer from {} to {end}", range.start()),
        };
        format!("{number:?} is no value of the limit {} (expected {expected})", limit.name())
    })
}

impl LimitArguments {
    /// Returns the value that was asked for; the last one if there are several.
    pub(crate) fn asked(&self, limit: Limit) -> Option<u64> {
        self.limit.iter().rev().find(|asked| asked.limit == limit).map(|asked| asked.most)
    }

    /// The limits of whatever is read, by their names.
    pub(crate) fn words(&self) -> AskedLimits {
        let is_of_files = |asked: &&AskedLimit| limits_of_files().any(|limit| limit == asked.limit);
        let named = |asked: &AskedLimit| (asked.limit.name().to_owned(), asked.most);
        self.limit.iter().filter(is_of_files).map(named).collect()
    }

    /// The limits of one number, and of a file.
    fn resolved(&self) -> (Limits, SizeLimits) {
        // Others were refused with the command line.
        resolve_limits(&self.words()).unwrap_or_default()
    }

    /// The limits of one number.
    pub(crate) fn number(&self) -> Limits {
        self.resolved().0
    }

    /// Returns the limits on a file.
    pub(crate) fn sizes(&self) -> SizeLimits {
        let (_, sizes) = self.resolved();
        SizeLimits { memory: self.memory.get_or_init(|| sizes.memory.clone()).clone(), ..sizes }
    }

    /// Returns the limit on a statement about an answer: a proof, a claim, a solution.
    pub(crate) fn statement(&self) -> u64 {
        const USUAL: u64 = 1 << 28;
        self.asked(Limit::Text).unwrap_or(USUAL)
    }

    /// Returns the limit on the readings of a lesson.
    pub(crate) fn readings(&self) -> usize {
        self.asked(Limit::Readings).map_or(boundfit_lesson::MOST_ROWS, size)
    }

    /// Returns the limits on outliers.
    pub(crate) fn outliers(&self) -> OutlierLimits {
        let usual = OutlierLimits::default();
        OutlierLimits {
            sets: self.asked(Limit::Sets).map_or(usual.sets, size),
            steps: self.asked(Limit::Steps).unwrap_or(usual.steps),
        }
    }

    /// A style that keeps to them.
    pub(crate) fn limited(&self, style: Style) -> Style {
        let longest_fraction = self.asked(Limit::Fraction).map_or(style.longest_fraction, size);
        Style { longest_fraction, ..style }
    }
}

/// A size that no memory of this machine holds is as good as the largest one.
pub(crate) fn size(asked: u64) -> usize {
    usize::try_from(asked).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_limit_has_a_default_that_can_be_asked_for() {
        for limit in Limit::ALL {
            let (most, _) = about(limit, &Defaults::default());
            let asked = parse(&format!("{}={most}", limit.name()), &Limit::ALL).unwrap();
            assert_eq!(asked.limit, limit);
        }
    }
}
