//! The region as well-known text.

use boundfit_exact::{Limits, Rational, Reading, Rounding};
use boundfit_geometry::{Polyhedron, Region, RegionKind, Vertex};

use crate::style::Style;

/// The least number of digits; a reader of such text makes doubles, and 17 digits tell all doubles apart.
const LEAST_DIGITS: usize = 17;
/// The largest number of digits, beyond which no reader goes on and the polygon is refused.
const MOST_DIGITS: usize = 10_000;

/// The region as well-known text (OGC Simple Features, ISO 19125-1), with a line end: `POLYGON` with a ring that is
/// counter-clockwise and closed, `LINESTRING`, `POINT`, or `POLYGON EMPTY`.
///
/// Coordinates are decimals rounded to nearest, with the style's digits but at least 17. More digits follow where the
/// rounded vertices would otherwise not turn left everywhere as the exact ones do.
///
/// # Errors
/// The reason when the region is unbounded, which this format has no words for, or thinner than any decimals can say.
pub fn region_wkt(polyhedron: &Polyhedron, style: &Style) -> Result<String, String> {
    let region = polyhedron.region();
    let least = style.significant().max(LEAST_DIGITS);
    let text = match region {
        Region::Empty(_) => "POLYGON EMPTY".to_owned(),
        Region::Point(_) | Region::Segment(_) | Region::Polygon(_) => {
            let (texts, _) = std::iter::successors(Some(least), |digits| digits.checked_mul(2))
                .take_while(|digits| *digits < 2 * MOST_DIGITS)
                .map(|digits| rounded(region.vertices(), digits))
                .find(|(_, points)| keeps_shape(points, region.kind()))
                .ok_or("the set is too thin to be said in decimals (CSV, JSON and MATLAB have it exactly)")?;
            written(region.kind(), texts)
        }
        _ => {
            let kind = region.kind().name();
            return Err(format!(
                "the set is unbounded ({kind}), which well-known text cannot say (CSV, JSON, MATLAB and cdd's format can)"
            ));
        }
    };
    Ok(text + "\n")
}

/// The vertices as text, and the numbers that the text says.
fn rounded(vertices: &[Vertex], digits: usize) -> (Vec<String>, Vec<[Rational; 2]>) {
    let limits = Limits { digits: usize::MAX, exponent: u32::MAX };
    let point = |vertex: &Vertex| {
        let texts = vertex
            .point()
            .coordinates()
            .map(|value| value.decimal(digits, Rounding::Nearest).compact().to_string());
        let numbers = texts.each_ref().map(|text| Reading::Decimal.read(text, &limits).unwrap_or_default());
        (texts.join(" "), numbers)
    };
    vertices.iter().map(point).unzip()
}

/// Returns whether points are different and, three or more of them, turn left at each.
fn keeps_shape(points: &[[Rational; 2]], kind: RegionKind) -> bool {
    let next = |step: usize| points.iter().cycle().skip(step);
    match kind {
        RegionKind::Polygon => points.iter().zip(next(1)).zip(next(2)).all(|((p, q), r)| {
            let ([p1, p2], [q1, q2], [r1, r2]) = (p, q, r);
            let turn = (q1 - p1) * (r2 - q2) - (q2 - p2) * (r1 - q1);
            turn > Rational::zero()
        }),
        RegionKind::Segment => points.first() != points.last(),
        _ => true,
    }
}

fn written(kind: RegionKind, mut texts: Vec<String>) -> String {
    match kind {
        RegionKind::Point => format!("POINT ({})", texts.join(", ")),
        RegionKind::Segment => format!("LINESTRING ({})", texts.join(", ")),
        _ => {
            texts.extend(texts.first().cloned());
            format!("POLYGON (({}))", texts.join(", "))
        }
    }
}
