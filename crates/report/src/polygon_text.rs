//! The text report of any half-planes.

use boundfit_exact::Rational;
use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Multiplier, Polyhedron, Redundancy};

use crate::polygon_json::{redundant_rows, rows_of};
use crate::region::{point_text, region_text};
use crate::style::Style;
use crate::text::{counted, list, table};

/// The report as text.
pub fn polygon_text(file: &HalfPlaneFile, polyhedron: &Polyhedron, name: &str, style: &Style) -> String {
    let region = polyhedron.region();
    let rows = counted(file.rows, "row", "rows");
    let bounds = polyhedron.bounding_box();
    let styles = style.resolving_both(bounds.as_ref());
    let names = |indices: &[usize]| rows_of(file, indices).iter().map(ToString::to_string).collect();
    let mut text =
        format!("Half-planes of {name}, {rows}\n\nRegion: {}", region_text(region, &styles, names));
    if let Some(certificate) = region.certificate() {
        let products = products(file, certificate.multipliers(), style);
        let right_hand_side = |m: &Multiplier| &polyhedron.system().inequalities()[m.index].b * &m.value;
        let sum: Rational = certificate.multipliers().iter().map(right_hand_side).sum();
        text.push_str(&format!("  Proof: {products} gives 0 <= {}.\n", style.upper_text(&sum)));
    }
    if let Some(bounds) = &bounds {
        let row = |axis: usize| {
            vec![["theta1", "theta2"][axis].to_owned(), styles[axis].interval_text(&bounds[axis])]
        };
        text.push('\n');
        text.push_str(&table(&["", "range"], vec![row(0), row(1)]));
    }
    if let Some(area) = region.area().filter(|_| !region.is_empty()) {
        text.push_str(&format!("  area      {}\n", style.text(&area)));
    }
    if let Some(centroid) = region.area_centroid() {
        text.push_str(&format!("  centroid  {}\n", point_text(&centroid.coordinates(), &styles)));
    }
    if let Some(diameter) = region.squared_diameter() {
        text.push_str(&format!("  diameter  square root of {}\n", style.text(&diameter)));
    }
    text.push('\n');
    text.push_str(&redundancy(file, polyhedron, style));
    text
}

fn redundancy(file: &HalfPlaneFile, polyhedron: &Polyhedron, style: &Style) -> String {
    let redundant = redundant_rows(file, polyhedron);
    if redundant.is_empty() {
        return "No row is redundant.\n".to_owned();
    }
    let mut rows = Vec::new();
    for (index, reason) in polyhedron.redundancies().iter().enumerate() {
        let RowOrigin { row, reversed } = file.origins[index];
        let Some(reason) = reason.as_ref().filter(|_| redundant.binary_search(&row).is_ok()) else {
            continue;
        };
        let reason = match reason {
            Redundancy::Always => "holds everywhere".to_owned(),
            Redundancy::SameAs(other) => {
                let RowOrigin { row, reversed } = file.origins[*other];
                format!("the same half-plane as row {row}{}", if reversed { " (>=)" } else { "" })
            }
            Redundancy::EmptyWithout => "the region is empty without it".to_owned(),
            Redundancy::Dominated { by, slack } if slack.is_zero() => {
                format!("touches the region; implied by {}", products(file, by, style))
            }
            Redundancy::Dominated { by, slack } => {
                format!("implied by {} with {} to spare", products(file, by, style), style.text(slack))
            }
        };
        let direction = if reversed { " (>=)" } else { "" };
        rows.push(vec![format!("{row}{direction}"), reason]);
    }
    let listed = list(redundant.iter().map(ToString::to_string));
    format!("Redundant rows: {listed}\n{}", table(&["row", "why"], rows))
}

/// `2 * (row 3) + 1/2 * (row 5)`.
fn products(file: &HalfPlaneFile, multipliers: &[Multiplier], style: &Style) -> String {
    let product = |multiplier: &Multiplier| {
        let RowOrigin { row, reversed } = file.origins[multiplier.index];
        let sign = if reversed { "-" } else { "" };
        format!("{sign}{} * (row {row})", style.proof_text(&multiplier.value))
    };
    let products: Vec<String> = multipliers.iter().map(product).collect();
    products.join(" + ")
}
