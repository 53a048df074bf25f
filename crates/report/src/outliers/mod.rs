//! Reports of outliers: which readings to leave out, and what is left then.

mod csv;
mod json;
#[cfg(feature = "files")]
mod proof;

pub use csv::outliers_csv;
pub use json::outliers_json;
#[cfg(feature = "files")]
pub(crate) use proof::contradictions;
#[cfg(feature = "files")]
pub use proof::{NoOutliersProof, outliers_proof};

use boundfit_estimation::{Fit, Measurement, Problem, Ties};
use boundfit_exact::Interval;
use boundfit_exact::english::{counted, ranges};
use boundfit_geometry::Measure;
use boundfit_questions::{Growth, NoOutliers, Outliers, Piece};

use crate::document::{Block, Document, Facts, Symbol, THETA, Table, Text};
use crate::fit::fit_facts;
use crate::formula::{absurdity, products};
use crate::origin::Origin;
use crate::region::{endless, kind_text, names_of, vertex_table};
use crate::scale::{Scale, scales};
use crate::style::Style;

/// The material of a report of outliers.
#[derive(Debug, Clone, Copy)]
pub struct OutliersReport<'a> {
    /// The question.
    pub problem: &'a Problem,
    /// The fit of all readings.
    pub fit: &'a Fit,
    /// The readings to leave out, or the reason why none can be.
    pub outliers: Result<&'a Outliers, &'a NoOutliers>,
    /// The growth of the set.
    pub growth: &'a [Growth],
    /// `true` if the question asked for the growth.
    pub shows_growth: bool,
}

/// The number of pieces that are shown in full, and the number of those that are shown with their rows.
const MOST_WHOLE: usize = 4;
const MOST_SETS: usize = 20;
/// The number of rows of one set that are listed with the amounts by which they are missed, and the number of rows by
/// name.
const MOST_MISSED: usize = 30;
const MOST_ROWS: usize = 200;

/// The report of outliers.
pub fn outliers_document(report: &OutliersReport, origin: &Origin, style: &Style) -> Document<'static> {
    let mut blocks = vec![
        Block::Title("Outliers".into()),
        Block::Facts(fit_facts(report.problem, report.fit, origin, style)),
    ];
    match report.outliers {
        Err(_) => blocks.extend(contradiction(report, style)),
        Ok(outliers) => {
            blocks.extend(answer(report, outliers, style));
            for (number, piece) in (1..).zip(&outliers.pieces).take(MOST_WHOLE) {
                blocks.extend(piece_blocks(report.problem, outliers, number, piece, style));
            }
            blocks.extend(further_sets(outliers));
        }
    }
    if report.shows_growth {
        blocks.extend(growth_blocks(report.growth, style));
    }
    Document::new(blocks)
}

/// Returns the conditions that contradict each other.
fn contradiction(report: &OutliersReport, style: &Style) -> Vec<Block<'static>> {
    let Err(NoOutliers::Conditions(terms)) = report.outliers else { return Vec::new() };
    let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
    let verb = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
    let sentence = format!(
        "Nothing is left whatever is left out: the conditions {verb} ({}), and no reading has a part in that.",
        names.join(", ")
    );
    let products = products(terms.iter().map(|(name, m)| (style.proof(m), name.to_string())));
    let right_sides = terms.iter().filter_map(|(name, times)| {
        let mut named = boundfit_estimation::conditions_by_name(&report.problem.conditions);
        named.find(|(own, _)| own == name).map(|(_, inequality)| inequality.b * times)
    });
    let proof = absurdity(Text::from("Proof: ").then(products), &right_sides.sum(), style);
    vec![
        Block::Title("Least number of readings to leave out: none".into()),
        Block::Paragraph(sentence.into()),
        Block::Paragraph(proof.words(".")),
    ]
}

/// Returns the number of rows to leave out, the number of ways, and the range that remains over all ways.
fn answer(report: &OutliersReport, outliers: &Outliers, style: &Style) -> Vec<Block<'static>> {
    let all = report.problem.measurements.fitted();
    let title = format!("Least number of readings to leave out: {} of {all}", outliers.least);
    let count = outliers.pieces.len();
    let sentence = match (outliers.least, outliers.is_complete, count) {
        (0, ..) => {
            "Some parameters agree with every reading; below is the feasible set of all of them.".into()
        }
        (_, true, 1) => "Only one set of this size leaves a feasible parameter.".into(),
        (_, true, _) => format!(
            "{count} sets of this size leave feasible parameters; no two of the remaining sets have a point in common."
        ),
        (_, false, _) => format!(
            "These are {count} of the sets of this size that leave feasible parameters; more exist (the limit 'sets')."
        ),
    };
    let mut blocks = vec![Block::Title(title.into()), Block::Paragraph(sentence.into())];
    let pui = outliers.pui();
    let over = if count > 1 { " over all of these" } else { "" };
    let styles = style.resolving_both(pui.as_ref());
    let mut rows: Vec<(Text, Text)> = Vec::new();
    for (axis, interval) in pui.iter().flatten().enumerate() {
        rows.push((Text::from("PUI ").symbol(THETA[axis]), styles[axis].interval(interval).words(over)));
    }
    rows.push(("area".into(), area_text(outliers.area().as_ref(), style).words(over)));
    blocks.push(Block::Facts(Facts { width: 10, rows }));
    blocks
}

fn area_text(area: Option<&boundfit_exact::LongSum>, style: &Style) -> Text {
    area.map_or_else(|| Symbol::Infinity.into(), |area| style.measure(&Measure::of(area)))
}

/// One minimal set: its rows, by how much each is missed, and what is left.
fn piece_blocks(
    problem: &Problem,
    outliers: &Outliers,
    number: usize,
    piece: &Piece,
    style: &Style,
) -> Vec<Block<'static>> {
    let mut blocks = Vec::new();
    let region = piece.left.polyhedron().region();
    if outliers.least > 0 {
        let which =
            if outliers.pieces.len() > 1 { format!("Set {number}: without ") } else { "Without ".into() };
        blocks.push(Block::Title(format!("{which}{}", rows_text(&piece.rows)).into()));
        blocks.extend(missed_table(problem, piece, style));
    }
    let kind = kind_text(region.kind(), region.vertices().len());
    let left = if outliers.least > 0 { "Remaining set" } else { "Feasible parameter set (FPS)" };
    let pui = piece.left.polyhedron().bounding_box();
    let shown: [Scale; 2] =
        scales(style, pui.as_ref(), &[], &[], || piece.left.polyhedron().homogeneous_vertices());
    blocks.push(if outliers.least > 0 {
        Block::Lead(format!("{left}: {kind}").into())
    } else {
        Block::Title(format!("{left}: {kind}").into())
    });
    if outliers.pieces.len() > 1 {
        let range = |axis: usize, interval: &Interval| {
            (Text::from("PUI ").symbol(THETA[axis]), shown[axis].interval(interval))
        };
        let rows = pui.iter().flatten().enumerate().map(|(axis, interval)| range(axis, interval)).collect();
        blocks.push(Block::Facts(Facts { width: 10, rows }));
    }
    let names = |indices: &[usize]| names_of(&piece.left.active(indices, Ties::MOST_LISTED));
    let vertices = (1..).zip(region.vertices()).map(|(number, vertex)| {
        let theta = vertex.point().coordinates();
        let [theta1, theta2] = [0, 1].map(|axis| Text::new().number(shown[axis].value(&theta[axis])));
        vec![Text::new().number(number), theta1, theta2, names(vertex.active()).into()]
    });
    blocks.push(vertex_table(vertices.collect()));
    let boundaries =
        region.boundaries().iter().map(|own| Text::from(format!("bounded by {}", names(own.active()))));
    let lines = endless(&region.rays(), &region.lines()).into_iter().chain(boundaries);
    blocks.extend(lines.map(Block::Paragraph));
    blocks
}

/// `row 3`, `rows 3, 5..9 and 12`; of very many the first.
fn rows_text(rows: &[usize]) -> String {
    let more = match rows.len().saturating_sub(MOST_ROWS) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let shown = rows.get(..MOST_ROWS).unwrap_or(rows);
    format!("{} {}{more}", if rows.len() == 1 { "row" } else { "rows" }, ranges(shown))
}

/// Returns the amount by which each removed row is missed, over the whole remaining set.
fn missed_table(problem: &Problem, piece: &Piece, style: &Style) -> Vec<Block<'static>> {
    let row = |(row, reading): (usize, &Measurement)| {
        let (bound, by) = match piece.missed_by(reading) {
            Some((name, by)) => (name.of_row(row).to_string(), style.resolving(&by).interval(&by)),
            None => (row.to_string(), "met by no parameters at all".into()),
        };
        vec![bound.into(), by]
    };
    let shown = piece.rows.get(..MOST_MISSED).unwrap_or(&piece.rows);
    let rows: Vec<Vec<Text>> = problem.measurements.readings_of(shown).into_iter().map(row).collect();
    let more = piece.rows.len().saturating_sub(MOST_MISSED);
    let more = (more > 0)
        .then(|| Block::Paragraph(format!("and {}", counted(more, "more row", "more rows")).into()));
    [Block::Table(Table::new(["row and bound", "missed by"], rows))].into_iter().chain(more).collect()
}

/// The rows of the sets that are not shown with all they have.
fn further_sets(outliers: &Outliers) -> Vec<Block<'static>> {
    let count = outliers.pieces.len();
    if count <= MOST_WHOLE {
        return Vec::new();
    }
    let row = |(number, piece): (usize, &Piece)| {
        let region = piece.left.polyhedron().region();
        let left = kind_text(region.kind(), region.vertices().len());
        vec![Text::new().number(number), rows_text(&piece.rows).into(), left.into()]
    };
    let rows = (1..).zip(&outliers.pieces).skip(MOST_WHOLE).take(MOST_SETS).map(row).collect();
    let more = count.saturating_sub(MOST_WHOLE + MOST_SETS);
    let more = (more > 0).then(|| {
        Block::Paragraph(
            format!("and {} (JSON and CSV have all)", counted(more, "more set", "more sets")).into(),
        )
    });
    let title = Block::Title("Further sets".into());
    let table = Block::Table(Table::new(["set", "without", "remaining set"], rows));
    [title, table].into_iter().chain(more).collect()
}

/// Returns the growth of the set with the number of readings that may be missed.
fn growth_blocks(growth: &[Growth], style: &Style) -> Vec<Block<'static>> {
    // Nothing agrees with so many.
    let nothing = growth.iter().take_while(|growth| growth.pieces == 0).count();
    let growth = growth.get(nothing.saturating_sub(1)..).unwrap_or_default();
    let row = |growth: &Growth| {
        let range = |axis: usize| match &growth.pui {
            Some(pui) => style.resolving(&pui[axis]).interval(&pui[axis]),
            None => "-".into(),
        };
        let pieces = match (growth.pieces, growth.holes) {
            (pieces, 0) => pieces.to_string(),
            (pieces, holes) => format!("{pieces}, {}", counted(holes, "hole", "holes")),
        };
        let area = if growth.pieces == 0 { "-".into() } else { area_text(growth.area.as_ref(), style) };
        vec![Text::new().number(growth.most), pieces.into(), range(0), range(1), area]
    };
    let header =
        ["missed".into(), "pieces".into(), Text::from(THETA[0]), Text::from(THETA[1]), "area".into()];
    vec![
        Block::Title("Sets that miss at most a few readings".into()),
        Block::Table(Table::new(header, growth.iter().map(row).collect())),
    ]
}
