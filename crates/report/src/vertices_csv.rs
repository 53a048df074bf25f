//! The vertices as CSV.

use boundfit_estimation::{ActiveBounds, Fit, Ties};
use boundfit_exact::Rounding;
use boundfit_geometry::Polyhedron;
use csv::WriterBuilder;

use crate::generators::{ActiveNames, generators};
use crate::style::Style;

/// The first of the bounds of a fit that are active where these half-planes are, by name, and how many there are beside them.
pub fn active_names(fit: &Fit, indices: &[usize]) -> (Vec<String>, usize) {
    let ActiveBounds { names, more } = fit.fps.active(indices, Ties::MOST_LISTED);
    (names.iter().map(ToString::to_string).collect(), more)
}

/// Returns the region as a table with the header `kind,theta1,theta2,theta1_decimal,theta2_decimal,active`. Each
/// `vertex` (counter-clockwise), `ray` and `line` has a row. A region without vertices has a `point` of each of its
/// boundaries instead. The region is the convex hull of the points, plus the cone of the rays, plus the span of the
/// lines; no row means that it is empty. `names` names the first of the half-planes with some indices, and tells how
/// many there are beside them; the names of those active at a point are separated by `; `.
///
/// `theta1` and `theta2` are exact (`p/q` or `n`), the decimals rounded to nearest with the style's digits, where it
/// has none with those that the region's ranges take.
pub fn vertices_csv(polyhedron: &Polyhedron, names: &ActiveNames<'_>, style: &Style) -> String {
    let styles = style.resolving_both(polyhedron.bounding_box().as_ref());
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    let header = ["kind", "theta1", "theta2", "theta1_decimal", "theta2_decimal", "active"];
    let mut rows = vec![header.map(str::to_owned)];
    for generator in generators(polyhedron.region()) {
        let [theta1, theta2] = &generator.coordinates;
        let [decimal1, decimal2] = [(theta1, &styles[0]), (theta2, &styles[1])].map(|(value, style)| {
            value.decimal(style.significant(), Rounding::Nearest).compact().to_string()
        });
        let active = generator.active_names(names);
        let kind = generator.kind.name().to_owned();
        rows.push([kind, theta1.to_string(), theta2.to_string(), decimal1, decimal2, active]);
    }
    for row in rows {
        // Writing to memory does not fail.
        let written = writer.write_record(&row);
        debug_assert!(written.is_ok());
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}
