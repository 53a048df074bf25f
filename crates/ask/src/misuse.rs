//! Keys that exclude or need each other, and the reasons why there is no proof.

use boundfit_estimation::Measurements;
use boundfit_exact::DecimalMark;
use boundfit_formats::{BLANKS, Dialect, Encoding};

use crate::surface::Surface;

macro_rules! misuses {
    ($($(#[$meaning:meta])* $name:ident: $words:literal),* $(,)?) => {
        /// Keys that exclude or need each other.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Misuse {
            $($(#[$meaning])* $name),*
        }

        impl Misuse {
            /// The sentence, in which keys stand in braces.
            fn sentence(self) -> &'static str {
                match self { $(Misuse::$name => $words),* }
            }
        }
    };
}

misuses! {
    /// The column of x is missing.
    NoX: "{x} is missing: it names the column of x, or those of two regressors",
    /// The column of y is missing, and errors have bounds around it.
    NoResponse: "{y} is missing: only beside {lower} or {upper} it may be left out",
    /// The size of the errors is missing.
    NoBound: "the bound on the errors is missing: {eps}, {eps_column}, {lower} or {upper}",
    /// The size of the errors is given in more than one way.
    SeveralBounds: "the errors have one bound: {eps}, or {eps_column}, or {lower} and {upper}",
    /// Two regressors have no offset.
    OffsetOfTwoRegressors: "{through_origin} is about a line: with two regressors there is no offset, and the model passes \
                 through the origin as it is",
    /// Two regressors have no inverse line.
    InverseOfTwoRegressors: "{inverse} is about a line: with two regressors there is no single x for each y",
    /// Two regressors have no x to count from an origin.
    OriginOfTwoRegressors: "{x_origin} is about a line: with two regressors there is no x to count from an origin",
    /// One mark groups digits and comes before decimals.
    OneMark: "{thousands} and {decimal} name one mark: it cannot both group digits and come before decimals",
    /// The errors of x have one bound for all readings, and a column of them.
    TwoXBounds: "the errors of x have one bound: {x_eps} or {x_eps_column}",
    /// Two regressors have no x in whose order readings are taken.
    OrderOfX: "two regressors have no order of x (expected the order of rows)",
    /// Two regressors have no x along which a window reaches back.
    WindowOfX:
        "{window_x} is about a line: two regressors have no x to look back along; {window} counts readings",
    /// A window reaches back so many readings, or so far in x.
    TwoWindows: "{window} and {window_x} both say how far a window reaches back: give one of them",
    /// The reach of a window is missing.
    NoWindow: "{window} or {window_x} says how far a window reaches back: give one of them",
    /// The step of a window is given without its reach.
    StepAlone: "{step} says how far a window moves on: say which with {window} or {window_x}",
    /// The size of the errors of x is missing.
    NoXErrors: "{x_eps} is missing: it says how large the errors of x may be",
    /// Lines agree for every x that errors allow, and x has none.
    StrongAlone: "{strong} is about errors in x: say how large they may be with {x_eps} or {x_eps_column}",
    /// Two regressors have no x with errors.
    XErrorsOfTwoRegressors:
        "{x_eps} is about a line: with two regressors it is not known how their errors go together",
    /// A multiple of the least bound is found without errors in x.
    LeastBesideXErrors: "{eps} asks for a multiple of eps_min, which is found as if every x were exact: beside {x_eps} it is a \
                 number, and the answer says by which factor all bounds may shrink or have to grow",
    /// A multiple of the least bound is asked under conditions that contradict each other.
    LeastOfNothing: "{eps} asks for a multiple of eps_min, and there is none: the conditions on theta1 and theta2 contradict each \
                 other, so that no error bound, however large, is enough",
    /// A multiple of the least bound is asked of readings reduced under others.
    LeastOfFixed: "{eps} asks for a multiple of eps_min, which moves the error bounds, and the data are a reduction under \
                 bounds that are fixed: fit the table that it was made from",
    /// Sets under growing bounds are asked of readings reduced under others.
    SweepOfFixed: "{sweep} moves the error bounds, and the data are a reduction under bounds that are fixed: sweep the table \
                 that it was made from",
    /// A share of further readings is asked of intervals.
    ConfidenceOfIntervals:
        "{confidence} is about error bounds that reach as far above y as below: intervals need not",
    /// A share of further readings is asked where a reading has the bound 0.
    ConfidenceOfZero:
        "{confidence} is about error bounds above 0: a reading with the bound 0 leaves no room for another one",
    /// The groups of a fleet are fitted as if x had no errors.
    FleetOfXErrors: "{x_eps} is about a single set, and a fleet has one for each group",
    /// The question takes every x for exact.
    ExactX: "{x_eps} says how large the errors of x may be, and this question takes every x for exact: only a fit answers with \
                 errors in x",
    /// Nothing is to be predicted.
    NothingToPredict: "nothing is to be predicted: expected {at}, {grid} or {from}",
    /// Two regressors have no single x that a reading may come from.
    FromOfTwoRegressors:
        "{from} is about a line: with two regressors there is no single x (ask {at} for pairs)",
    /// Two regressors have no single x that goes in steps.
    GridOfTwoRegressors:
        "{grid} is about a line: with two regressors there is no single x (ask {at} for pairs)",
    /// Two regressors have no single x at which the next reading is taken.
    NextOfTwoRegressors: "'next' is about a line: with two regressors there is no single x",
    /// Values of two kinds are no single table.
    TwoTables: "csv writes one table: ask {at} or {grid}, and {from}, in calls of their own",
    /// Further readings have bounds of their own, and a law takes its bound from a whole table.
    NewOfRange: "{new} is about readings with bounds of their own, and a law with range(y) takes them from all of a table: \
                 give the number that it comes to",
    /// Further readings are a reduction.
    NewReduction:
        "{new} is about every reading, and the file is a reduction: judge the table that it was made from",
    /// No table is at hand but the first one.
    NoTables: "no other table is at hand here: {at} and {from} take values themselves, and {new} takes a table alone",
    /// Half-planes have neither columns of readings nor bounds, conditions and rows.
    ReadingsOfHalfPlanes: "half-planes are rows with the columns a1, a2 and b: {x}, {y}, {eps}, {where}, {rows} and their like are about \
                 readings",
    /// A linear program is read as it is written.
    ReadingsOfProgram: "a linear program is read as MPS or LP format say: beside it only {limits} is a word about the data",
    /// Findings are about solutions, and none is given.
    FindingsOfNothing: "sarif and junit write findings about solutions: give {solution}",
    /// Directions are spread in some way, and there are none.
    ScaledAlone: "{scaled} says how directions are spread: say how many there are with {directions}",
    /// The columns of a calibration are missing, or given twice.
    Response: "expected {y}, or {y} and {direction}, or {up} and {down}",
    /// Two regressors are no characteristic.
    LinearityOfTwoRegressors: "linearity is about a line: two regressors have no characteristic",
    /// Conditions are about sets of parameters.
    LinearityUnderConditions: "{where} is about the set of all lines that agree, and linearity compares readings with lines of its own",
    /// The lines of linearity have an offset, except one through a point.
    LinearityThroughOrigin: "{through_origin} is about fits: zero-based linearity has the line through the origin, or {through} another \
                 point",
    /// The lines of linearity are those of x as it is.
    LinearityFromOrigin: "{x_origin} is about fits: linearity takes x as it is, and {through} is a point of the line of zero-based \
                 linearity",
    /// A form has no decimals, whose digits are asked for.
    VainDigits: "{digits} is about decimals in text, latex, markdown and json; this format has doubles, exact numbers or both",
    /// A form has no decimals, whose rounding is asked for.
    VainRounding: "{rounding} is about decimals in text, latex, markdown and json; this format has doubles, exact numbers or both",
    /// A form has no decimals, for which fractions could stand.
    VainExact: "{exact} is about decimals in text, latex, markdown and json; this format has doubles, exact numbers or both",
    /// A form is no report, whose length is asked for.
    VainReport: "{brief}, {full} and {inverse} need the format text, latex or markdown; other formats contain everything",
    /// A short report has no room for more.
    BriefAlone: "{brief} reports ten lines: it goes with none of {full}, {sweep}, {inverse} and {confidence}",
    /// A form has one set.
    VainSweep: "{sweep} needs the format text, latex, markdown or json; other formats have no place for many sets",
    /// A form has no place for a guarantee.
    VainConfidence: "{confidence} needs the format text, latex, markdown or json; other formats have no place for a guarantee",
    /// A table of readings has no place for a repair.
    VainRepair: "{repair} needs another format than csv, which has a row for each reading and no room for it",
    /// A form has every reading, whether or not all are asked for.
    VainAll: "{all} needs the format text, latex or markdown; other formats list every reading anyway",
    /// A form has the proofs of predictions, or no room for them.
    VainProofs: "{proofs} needs the format text, latex or markdown; JSON has the proofs anyway, and CSV has no room for them",
    /// A table of sets of outliers has no place for how the set grows.
    VainMost: "{most} is no part of csv: a table has a row for each set of outliers, and no room for how the set grows",
}

/// The reason why there is no proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoProof {
    /// The readings are not those of plain delimited text: why.
    NoText(&'static str),
    /// The readings are a reduction.
    Reduction,
    /// The data would have to be read once more.
    ReadOnce,
    /// Some points stand for several rows.
    Points,
    /// The answer has no theorem for Coq.
    NoTheorem,
    /// The proof would have more parts than this.
    TooMany {
        /// The largest number of parts.
        most: usize,
        /// The kind of parts.
        of: &'static str,
    },
}

impl Misuse {
    pub(crate) fn words(self, surface: &dyn Surface) -> String {
        in_words(self.sentence(), surface)
    }
}

impl NoProof {
    /// The most statements of a proof where each of them takes a set of its own.
    pub(crate) const MOST: usize = 1_000;

    /// Refuses a proof about too many parts.
    pub(crate) fn check(parts: usize, most: usize, of: &'static str) -> Result<(), Self> {
        if parts > most { Err(NoProof::TooMany { most, of }) } else { Ok(()) }
    }

    /// The reason why there is no proof about readings that are not those of plain delimited text.
    pub(crate) fn about(measurements: &Measurements) -> Self {
        if measurements.is_of_reductions() {
            return NoProof::Reduction;
        }
        let obstacle = match measurements.layout() {
            Some(layout) => obstacle(&layout.dialect),
            None => other_rows(measurements),
        };
        NoProof::NoText(obstacle)
    }

    pub(crate) fn words(self, surface: &dyn Surface) -> String {
        let sentence = match self {
            NoProof::NoText(obstacle) => {
                return format!(
                    "a proof is about the rows of plain delimited text, and the data are none that the checkers read: {obstacle}; \
                     save them as CSV with points, a header in the first line and as many cells in each row"
                );
            }
            NoProof::Reduction => {
                "a proof is about every reading, and this is a reduction: prove the answer about the table that it was made from"
            }
            NoProof::ReadOnce => "{proof} reads the data once more, and they are read once: give it a file",
            NoProof::Points => {
                "{proof} is about the rows of delimited text of which each is a point of its own, with a reading in every column, and \
                 those of the data are not"
            }
            NoProof::NoTheorem => "there is no theorem for Coq about this answer",
            NoProof::TooMany { most, of } => return format!("the proof would take more than {most} {of}"),
        };
        in_words(sentence, surface)
    }
}

/// Returns the reason why the rows of a table are not those of its lines.
fn other_rows(measurements: &Measurements) -> &'static str {
    let text = measurements.table().filter(|table| !table.is_sheet && !table.is_records);
    match text {
        Some(table) if table.block.is_some() => "they are one of several blocks, or all of them",
        Some(table) if table.skipped.headers > 0 => "their header is repeated among the rows",
        Some(table) if table.skipped.short_rows > 0 => "a row has fewer cells than the first one",
        _ => "they are another kind of file, or packed",
    }
}

/// Returns the first part of a dialect that the checkers of proofs do not read ([`Dialect::is_plain`]).
fn obstacle(dialect: &Dialect) -> &'static str {
    let Dialect {
        delimiter,
        notation,
        comment,
        skip_lines,
        records_before,
        has_row_names,
        encoding,
        missing: _,
    } = dialect;
    let obstacles = [
        (*encoding != Encoding::Utf8, "their bytes are not UTF-8"),
        (*delimiter == BLANKS, "blanks separate their cells (expected a comma, a semicolon, a tab or |)"),
        (notation.decimal == DecimalMark::Comma, "a comma comes before decimals (expected a point)"),
        (notation.thousands.is_some(), "a mark groups the digits of numbers (expected digits alone)"),
        (*skip_lines > 0, "lines stand before the table"),
        (comment.is_some(), "comments stand among the rows"),
        (*records_before > 1, "a row of units stands behind the header"),
        (*has_row_names, "the names of their rows have no cell in the header"),
    ];
    let first = obstacles.into_iter().find(|(is_there, _)| *is_there);
    first.map_or("their rows are not known by numbers", |(_, words)| words)
}

/// A sentence with the keys in braces as the surface names them.
fn in_words(mut sentence: &str, surface: &dyn Surface) -> String {
    let mut words = String::new();
    while let Some((before, (key, after))) =
        sentence.split_once('{').and_then(|(before, rest)| Some((before, rest.split_once('}')?)))
    {
        words.push_str(before);
        words.push_str(&surface.key(key));
        sentence = after;
    }
    words + sentence
}
