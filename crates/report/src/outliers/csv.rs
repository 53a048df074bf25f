//! Minimal sets of outliers as CSV.

use boundfit_exact::Interval;
use boundfit_questions::Outliers;
use csv::Writer;

use crate::fit_csv::shown;

const COLUMNS: [&str; 8] =
    ["set", "rows", "kind", "vertices", "theta1_lower", "theta1_upper", "theta2_lower", "theta2_upper"];

/// Returns the minimal sets as a table with a row for each. Its cells are the number of the set, its data rows
/// separated by blanks, and the kind and number of vertices of the remaining set. The ranges of both parameters
/// follow as doubles rounded outward, `-inf` and `inf` where there is no end.
pub fn outliers_csv(outliers: Option<&Outliers>) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    let mut write = |cells: [String; 8]| {
        let written = writer.write_record(&cells);
        debug_assert!(written.is_ok(), "writing to memory does not fail");
    };
    write(COLUMNS.map(str::to_owned));
    let pieces = outliers.map(|outliers| outliers.pieces.as_slice()).unwrap_or_default();
    for (number, piece) in (1..).zip(pieces) {
        let region = piece.left.polyhedron().region();
        let rows: Vec<String> = piece.rows.iter().map(ToString::to_string).collect();
        let [first, second] =
            piece.left.polyhedron().bounding_box().map_or_else(Default::default, |ranges| {
                let [first, second] = ranges;
                [ends(&first), ends(&second)]
            });
        let [theta1_lower, theta1_upper] = first;
        let [theta2_lower, theta2_upper] = second;
        let kind = region.kind().name().to_owned();
        let (number, vertices) = (usize::to_string(&number), region.vertices().len().to_string());
        write([
            number,
            rows.join(" "),
            kind,
            vertices,
            theta1_lower,
            theta1_upper,
            theta2_lower,
            theta2_upper,
        ]);
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

fn ends(interval: &Interval) -> [String; 2] {
    let lower =
        interval.lower().value().map_or_else(|| "-inf".to_owned(), |value| shown(value.floor_to_f64()));
    let upper = interval.upper().value().map_or_else(|| "inf".to_owned(), |value| shown(value.ceil_to_f64()));
    [lower, upper]
}
