//! The family of sets over the error bound as text.

use boundfit_estimation::{
    BoundName, ErrorBound, Family, Linear, MovingBoundary, MovingVertex, Piece, Problem, Quadratic,
};
use boundfit_exact::Rational;
use boundfit_geometry::{Direction, RegionKind};

use crate::document::{Block, Text};
use crate::region::{VERTEX_HEADER, direction_text};
use crate::style::Style;
use crate::text::{counted, list, table};

/// The sets FPS(s·ε): where the set changes its shape, then every vertex and every end of the PUI between, as exact
/// functions of s.
pub fn sweep_text(problem: &Problem, family: &Family, style: &Style) -> String {
    let Some((title, birth)) = heading(family, style) else { return String::new() };
    let (header, rows) = breakpoint_rows(problem, family, style);
    let mut text = format!("{title}\n  {birth}\n{}", table(&header, rows));
    for piece in family.pieces() {
        text.push_str(&format!("\n{}\n", piece_title(piece, style)));
        text.push_str(&table(&VERTEX_HEADER, piece_vertices(piece, style)));
        let lines = piece_lines(piece, style).into_iter().chain(piece_bounds(piece, style));
        lines.for_each(|line| text.push_str(&format!("  {line}\n")));
    }
    text
}

/// The same as blocks.
pub(crate) fn sweep_blocks(problem: &Problem, family: &Family, style: &Style) -> Vec<Block> {
    let Some((title, birth)) = heading(family, style) else { return Vec::new() };
    let (header, rows) = breakpoint_rows(problem, family, style);
    let mut blocks =
        vec![Block::Title(title), Block::Paragraph(Text::own(birth)), Block::table(&header, rows)];
    for piece in family.pieces() {
        blocks.push(Block::Title(piece_title(piece, style)));
        blocks.push(Block::table(&VERTEX_HEADER, piece_vertices(piece, style)));
        blocks.extend(piece_lines(piece, style).into_iter().map(|line| Block::Paragraph(Text::own(line))));
        // A label, spaces, a function.
        let bounds = piece_bounds(piece, style);
        let bounds = bounds.iter().filter_map(|bound| bound.split_once("  "));
        let bounds = bounds.map(|(label, text)| (label.to_owned(), Text::own(text.trim_start())));
        blocks.push(Block::Facts(bounds.collect()));
    }
    blocks
}

/// What the sweep is about, and where the set is born.
fn heading(family: &Family, style: &Style) -> Option<(String, String)> {
    let breakpoints = family.breakpoints();
    let (first, last) = (breakpoints.first()?, breakpoints.last()?);
    let range = format!("s from {} to {}", style.given_text(&first.s), style.given_text(&last.s));
    let birth = match family.least() {
        None => "No factor, however large, leaves a feasible parameter.".to_owned(),
        Some(least) if least.is_zero() => "The set is never empty.".to_owned(),
        Some(least) => format!("The set is born at s = {}.", style.upper_text_with_exact(least)),
    };
    Some((format!("Sweep of the error bound: FPS(s*eps) for {range}"), birth))
}

fn breakpoint_rows(
    problem: &Problem,
    family: &Family,
    style: &Style,
) -> (Vec<&'static str>, Vec<Vec<String>>) {
    let epsilon = match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => Some(epsilon),
        ErrorBound::PerRow(_) => None,
    };
    let rows = family.breakpoints().iter().map(|breakpoint| {
        let section = &breakpoint.section;
        // Of factors as of error bounds: what is printed is never too small.
        let mut row = vec![style.upper_text(&breakpoint.s)];
        if !style.exact {
            row.push(style.proof_text(&breakpoint.s));
        }
        row.extend(epsilon.map(|epsilon| style.upper_text(&(epsilon * &breakpoint.s))));
        row.push(kind_text(section.kind, section.vertices.len()));
        row.extend([&breakpoint.entering, &breakpoint.leaving].map(|names| names_text(names)));
        row
    });
    let mut header = vec!["s"];
    if !style.exact {
        header.push("exactly");
    }
    header.extend(epsilon.map(|_| "eps"));
    header.extend(["set", "begins to shape it", "ceases to"]);
    let rows = rows.collect();
    (header, rows)
}

fn piece_title(piece: &Piece, style: &Style) -> String {
    let kind = kind_text(piece.kind, piece.vertices.len());
    format!("For s from {} to {}: {kind}", style.proof_text(&piece.from), style.proof_text(&piece.to))
}

fn piece_vertices(piece: &Piece, style: &Style) -> Vec<Vec<String>> {
    let vertex = |(number, vertex): (usize, &MovingVertex)| {
        let [theta1, theta2] = vertex.theta.each_ref().map(|function| linear_text(function, style));
        vec![number.to_string(), theta1, theta2, names_text(&vertex.active)]
    };
    (1..).zip(&piece.vertices).map(vertex).collect()
}

/// Where the set goes on for ever, and which lines bound it.
fn piece_lines(piece: &Piece, style: &Style) -> Vec<String> {
    let rays = piece.rays.iter().map(|ray| format!("goes on for ever in direction {}", direction_text(ray)));
    let lines = piece
        .lines
        .iter()
        .map(|line| format!("goes on for ever in both directions of {}", direction_text(line)));
    let boundaries = piece.boundaries.iter().map(|MovingBoundary { normal, offset, active }| {
        let (form, offset) = (form_text(normal), linear_text(offset, style));
        format!("bounded by {form} <= {offset}: {}", names_text(active))
    });
    rays.chain(lines).chain(boundaries).collect()
}

/// The ends of the PUI and the area: a label, spaces, a function.
fn piece_bounds(piece: &Piece, style: &Style) -> Vec<String> {
    let function = |function: &Linear| linear_text(function, style);
    let mut bounds = Vec::new();
    for (axis, [lower, upper]) in piece.pui.iter().flatten().enumerate() {
        let lower = lower.as_ref().map_or("(-inf".to_owned(), |end| format!("[{}", function(end)));
        let upper = upper.as_ref().map_or("inf)".to_owned(), |end| format!("{}]", function(end)));
        bounds.push(format!("PUI theta{}  {lower}, {upper}", axis + 1));
    }
    if let Some(area) = &piece.area {
        bounds.push(format!("area        {}", quadratic_text(area, style)));
    }
    bounds
}

fn kind_text(kind: RegionKind, vertices: usize) -> String {
    match kind {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            format!("{} with {}", kind.name(), counted(vertices, "vertex", "vertices"))
        }
        kind => kind.name().to_owned(),
    }
}

fn names_text(names: &[BoundName]) -> String {
    list(names.iter().map(BoundName::to_string))
}

fn form_text(normal: &Direction) -> String {
    let coefficients = [normal.dx(), normal.dy()].map(Rational::from);
    let names = ["*theta1", "*theta2"];
    sum_text(
        coefficients.iter().zip(names).map(|(value, name)| (value.clone(), name, value.abs().to_string())),
    )
}

fn linear_text(Linear { constant, slope }: &Linear, style: &Style) -> String {
    polynomial_text(&[constant, slope], style)
}

fn quadratic_text(Quadratic { constant, slope, quadratic }: &Quadratic, style: &Style) -> String {
    polynomial_text(&[constant, slope, quadratic], style)
}

fn polynomial_text(coefficients: &[&Rational], style: &Style) -> String {
    let terms = coefficients.iter().zip(["", "*s", "*s^2"]);
    sum_text(terms.map(|(value, power)| ((*value).clone(), power, style.proof_text(&value.abs()))))
}

/// `1/2 - 3*s`: terms of a value, what it multiplies and its size as text; those that are zero are left out.
fn sum_text<'a>(terms: impl Iterator<Item = (Rational, &'a str, String)>) -> String {
    let mut text = String::new();
    for (value, factor, size) in terms.filter(|(value, ..)| !value.is_zero()) {
        text.push_str(match (text.is_empty(), value.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let size = if size.starts_with("about ") { format!("({size})") } else { size };
        // 1*s is s.
        text.push_str(if size == "1" && !factor.is_empty() { &factor[1..] } else { &size });
        if size != "1" || factor.is_empty() {
            text.push_str(factor);
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_read_like_formulas() {
        let text = |coefficients: &[i64]| {
            let values: Vec<Rational> = coefficients.iter().map(|&value| Rational::ratio(value, 2)).collect();
            polynomial_text(&values.iter().collect::<Vec<_>>(), &Style::default())
        };
        for (coefficients, expected) in [
            (&[1, -3][..], "1/2 - 3/2*s"),
            (&[0, 2], "s"),
            (&[2, 0], "1"),
            (&[0, 0, 0], "0"),
            (&[-2, -2, 1], "-1 - s + 1/2*s^2"),
            (&[0, -2, 4], "-s + 2*s^2"),
        ] {
            assert_eq!(text(coefficients), expected);
        }
    }
}
