//! The list of what is counted: commands, formats and models, each on one kind of data.

/// Rows that a command reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Data {
    /// Readings near a line, with four decimals.
    Line,
    /// The same with fifteen decimals.
    Long,
    /// The same as [`Data::Line`], and three of them are wrong.
    Wrong,
    /// Readings on a parabola: each is extreme.
    Curve,
    /// Half-planes around a disc, as cddlib writes them.
    HalfPlanes,
    /// A linear program with as many rows.
    Program,
}

/// A command that is counted.
#[derive(Debug)]
pub(super) struct Case {
    /// The name in the table.
    pub(super) name: &'static str,
    pub(super) data: Data,
    /// A command that runs first and is not counted; none where it is empty.
    pub(super) first: &'static str,
    /// The words of the command; DATA is the file of rows, OUT a file for what is written.
    pub(super) command: &'static str,
}

/// A command that needs no other one.
const fn case(name: &'static str, data: Data, command: &'static str) -> Case {
    Case { name, data, first: "", command }
}

/// Rows of a case: some, twice and four times as many.
pub(super) const SIZES: [usize; 3] = [250, 500, 1000];

/// The rows that are just kept one by one, and one more, which are not (`Keep::MOST_ROWS`).
pub(super) const STEP: [usize; 2] = [10_000, 10_001];

/// The commands that are counted at each of [`SIZES`].
pub(super) static CASES: &[Case] = &[
    case("fit text", Data::Line, "fit DATA --x x --y y --eps 1 --no-lp"),
    case("fit json", Data::Line, "fit DATA --x x --y y --eps 1 --no-lp --format json"),
    case("fit 15 decimals", Data::Long, "fit DATA --x x --y y --eps 1 --no-lp --format csv"),
    case("fit binary64", Data::Long, "fit DATA --x x --y y --eps 1 --no-lp --reading binary64 --format csv"),
    case("fit eps column", Data::Line, "fit DATA --x x --y y --eps-column e --no-lp --format csv"),
    case("fit bounds", Data::Line, "fit DATA --x x --lower lo --upper hi --no-lp --format csv"),
    case("fit regressors", Data::Line, "fit DATA --x x,u --y y --eps 4 --no-lp --format csv"),
    case("fit origin", Data::Line, "fit DATA --x x --y y --eps 4 --through-origin --no-lp --format csv"),
    case("fit by", Data::Line, "fit DATA --x x --y y --eps 1 --by g --no-lp --format csv"),
    case("fit window", Data::Line, "fit DATA --x x --y y --eps 1 --window 100 --no-lp --format csv"),
    case("fit sweep", Data::Line, "fit DATA --x x --y y --eps 1 --sweep 0.5..2 --no-lp"),
    case("fit x-eps", Data::Line, "fit DATA --x x --y y --eps 1 --x-eps 0.01 --no-lp --format csv"),
    case("fit strong", Data::Line, "fit DATA --x x --y y --eps 1 --x-eps 0.01 --strong --no-lp --format csv"),
    case("fit proof", Data::Line, "fit DATA --x x --y y --eps 1 --no-lp --proof OUT --format csv"),
    case("extreme text", Data::Curve, "fit DATA --x x --y y --eps 3000000 --no-lp"),
    case("extreme csv", Data::Curve, "fit DATA --x x --y y --eps 3000000 --no-lp --format csv"),
    case("extreme ine", Data::Curve, "fit DATA --x x --y y --eps 3000000 --no-lp --format ine"),
    case("extreme ext", Data::Curve, "fit DATA --x x --y y --eps 3000000 --no-lp --format ext"),
    case("extreme wkt", Data::Curve, "fit DATA --x x --y y --eps 3000000 --no-lp --format wkt"),
    case("predict", Data::Line, "predict DATA --x x --y y --eps 1 --at 50"),
    case("next", Data::Line, "next DATA --x x --y y --eps 1 --within 0..100"),
    case("linearity", Data::Line, "linearity DATA --x x --y y"),
    case("range", Data::Line, "range DATA --x x --y y --eps 0.45"),
    case("status", Data::Line, "status DATA --x x --y y --eps 1"),
    case("outliers", Data::Wrong, "outliers DATA --x x --y y --eps 1"),
    case("reduce", Data::Line, "reduce DATA --x x --y y -o OUT --force"),
    case(
        "convert",
        Data::Line,
        "convert DATA --x x --y y --eps 1 --to mps --objective theta1-max -o OUT --force",
    ),
    case("plot", Data::Line, "plot DATA --x x --y y --eps 1 --figure data --format svg -o OUT --force"),
    case("lesson", Data::Line, "lesson DATA --x x --y y --eps 1 --limit readings=1000 -o OUT --force"),
    case("polygon", Data::HalfPlanes, "polygon DATA --format csv"),
    case("judge", Data::Program, "judge DATA"),
    Case {
        name: "verify",
        data: Data::Line,
        first: "fit DATA --x x --y y --eps 1 --no-lp --proof OUT --force",
        command: "verify OUT DATA",
    },
];

/// The commands that are counted at both of [`STEP`].
pub(super) static STEPS: &[Case] = &[
    case("step text", Data::Line, "fit DATA --x x --y y --eps 1 --no-lp"),
    case("step 15 decimals", Data::Long, "fit DATA --x x --y y --eps 1 --no-lp --format csv"),
    case("step regressors", Data::Line, "fit DATA --x x,u --y y --eps 4 --no-lp --format csv"),
    case("step eps column", Data::Line, "fit DATA --x x --y y --eps-column e --no-lp --format csv"),
    case("step bounds", Data::Line, "fit DATA --x x --lower lo --upper hi --no-lp --format csv"),
    case("step sweep", Data::Line, "fit DATA --x x --y y --eps 1 --sweep 0.5..2 --no-lp"),
    case("step x-eps", Data::Line, "fit DATA --x x --y y --eps 1 --x-eps 0.01 --no-lp --format csv"),
    case("step predict", Data::Line, "predict DATA --x x --y y --eps 1 --at 50"),
    case("step status", Data::Line, "status DATA --x x --y y --eps 1"),
    case("step plot", Data::Line, "plot DATA --x x --y y --eps 1 --figure data --format svg -o OUT --force"),
];
