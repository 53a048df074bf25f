//! The region as a MATLAB or Octave script.

use std::fmt::Write;

use boundfit_geometry::Polyhedron;

use crate::generators::{ActiveNames, Generator, GeneratorKind, generators};

/// A script that defines the region in MATLAB and in Octave:
///
/// - `kind`: which of the ten kinds;
/// - `theta_exact` and `theta`: the vertices counter-clockwise, one per row, as exact text (`p/q` or `n`, n-by-2 cell
///   array) and as the nearest doubles (n-by-2 matrix);
/// - `active`: for each vertex the names of the half-planes active there, by `names`, separated by `; `;
/// - `points_exact`, `points`: where there are no vertices, a point of each boundary;
/// - `rays_exact`, `rays`, `lines_exact`, `lines`: the directions in which the region goes on, one way and both ways.
///
/// Parts that a region lacks have 0 rows. A number beyond the largest double is `Inf`.
pub fn region_script(polyhedron: &Polyhedron, names: &ActiveNames<'_>) -> String {
    let region = polyhedron.region();
    let generators = generators(region);
    let of = |kind| generators.iter().filter(move |generator| generator.kind == kind).collect::<Vec<_>>();
    let mut text = String::from(
        "% A set of parameters (theta1, theta2), written by boundfit.\n\
         % The set is the convex hull of theta and points, plus the cone of rays, plus the span of lines.\n\
         % ..._exact are the exact numbers as text; the others are the doubles nearest to them.\n",
    );
    text.push_str(&format!("kind = '{}';\n", region.kind().name()));
    let vertices = of(GeneratorKind::Vertex);
    text.push_str(&matrices("theta", &vertices));
    let active = |generator: &&Generator| vec![quoted(&generator.active_names(names))];
    text.push_str(&assignment("active", "cell(0, 1)", ['{', '}'], vertices.iter().map(active).collect()));
    text.push_str(&matrices("points", &of(GeneratorKind::Point)));
    text.push_str(&matrices("rays", &of(GeneratorKind::Ray)));
    text.push_str(&matrices("lines", &of(GeneratorKind::Line)));
    text
}

/// Coordinates as exact text and as doubles.
fn matrices(name: &str, generators: &[&Generator]) -> String {
    let exact =
        generators.iter().map(|g| g.coordinates.iter().map(|value| quoted(&value.to_string())).collect());
    let doubles =
        generators.iter().map(|g| g.coordinates.iter().map(|value| literal(value.to_f64())).collect());
    assignment(&format!("{name}_exact"), "cell(0, 2)", ['{', '}'], exact.collect())
        + &assignment(name, "zeros(0, 2)", ['[', ']'], doubles.collect())
}

/// One row per line; `nothing` without rows.
pub(crate) fn assignment(
    name: &str,
    nothing: &str,
    [open, close]: [char; 2],
    rows: Vec<Vec<String>>,
) -> String {
    if rows.is_empty() {
        return format!("{name} = {nothing};\n");
    }
    let mut text = format!("{name} = {open}\n");
    for row in rows {
        // Writing to a string does not fail.
        let written = writeln!(text, "  {}", row.join(", "));
        debug_assert!(written.is_ok());
    }
    text + &format!("{close};\n")
}

pub(crate) fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

/// The shortest literal that reads back as the same double.
pub(crate) fn literal(double: f64) -> String {
    match double {
        infinite if infinite.is_infinite() => if infinite > 0.0 { "Inf" } else { "-Inf" }.to_owned(),
        double => format!("{double:e}"),
    }
}
