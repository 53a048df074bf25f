//! The family of sets over the error bound as text.

use boundfit_estimation::{
    BoundName, ErrorBound, Family, Linear, MovingBoundary, MovingVertex, Piece, Problem, Quadratic,
};
use boundfit_exact::Rational;
use boundfit_geometry::{Direction, RegionKind};

use crate::region::direction_text;
use crate::style::Style;
use crate::text::{counted, list, table};

/// The sets FPS(s·ε): where the set changes its shape, then every vertex and every end of the PUI between, as exact
/// functions of s.
pub fn sweep_text(problem: &Problem, family: &Family, style: &Style) -> String {
    let breakpoints = family.breakpoints();
    let [Some(first), Some(last)] = [breakpoints.first(), breakpoints.last()] else { return String::new() };
    let range = format!("s from {} to {}", style.given_text(&first.s), style.given_text(&last.s));
    let birth = match family.least() {
        None => "No factor, however large, leaves a feasible parameter.".to_owned(),
        Some(least) if least.is_zero() => "The set is never empty.".to_owned(),
        Some(least) => format!("The set is born at s = {}.", style.upper_text_with_exact(least)),
    };
    let mut text = format!("Sweep of the error bound: FPS(s*eps) for {range}\n  {birth}\n");
    text.push_str(&breakpoint_table(problem, family, style));
    for piece in family.pieces() {
        text.push('\n');
        text.push_str(&piece_text(piece, style));
    }
    text
}

fn breakpoint_table(problem: &Problem, family: &Family, style: &Style) -> String {
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
    table(&header, rows.collect())
}

fn piece_text(piece: &Piece, style: &Style) -> String {
    let function = |function: &Linear| linear_text(function, style);
    let kind = kind_text(piece.kind, piece.vertices.len());
    let mut text =
        format!("For s from {} to {}: {kind}\n", style.proof_text(&piece.from), style.proof_text(&piece.to));
    let vertex = |(number, vertex): (usize, &MovingVertex)| {
        let [theta1, theta2] = vertex.theta.each_ref().map(function);
        vec![number.to_string(), theta1, theta2, names_text(&vertex.active)]
    };
    let rows = (1..).zip(&piece.vertices).map(vertex).collect();
    text.push_str(&table(&["vertex", "theta1", "theta2", "active"], rows));
    for ray in &piece.rays {
        text.push_str(&format!("  goes on for ever in direction {}\n", direction_text(ray)));
    }
    for line in &piece.lines {
        text.push_str(&format!("  goes on for ever in both directions of {}\n", direction_text(line)));
    }
    for MovingBoundary { normal, offset, active } in &piece.boundaries {
        let form = form_text(normal);
        text.push_str(&format!("  bounded by {form} <= {}: {}\n", function(offset), names_text(active)));
    }
    for (axis, [lower, upper]) in piece.pui.iter().flatten().enumerate() {
        let lower = lower.as_ref().map_or("(-inf".to_owned(), |end| format!("[{}", function(end)));
        let upper = upper.as_ref().map_or("inf)".to_owned(), |end| format!("{}]", function(end)));
        text.push_str(&format!("  PUI theta{}  {lower}, {upper}\n", axis + 1));
    }
    if let Some(area) = &piece.area {
        text.push_str(&format!("  area        {}\n", quadratic_text(area, style)));
    }
    text
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
