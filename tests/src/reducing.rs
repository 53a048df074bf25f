//! Tables reduced whole and in parts, and what their fits have in common.

use boundfit_estimation::{ActiveBounds, BoundName, Columns, Fit, ParameterBound, Problem, ReducedTable};
use boundfit_exact::{Rational, Reading};
use boundfit_formats::{InputError, ScanOptions, Source, TableOptions};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

/// The options of a scan that reads this many bytes at a time.
pub fn options(reading: Reading, chunk_bytes: usize) -> ScanOptions {
    let table = TableOptions { reading, ..TableOptions::default() };
    ScanOptions { table, chunk_bytes, ..ScanOptions::default() }
}

/// The reduction of a text.
pub fn try_reduced(text: &str, columns: &Columns, options: &ScanOptions) -> Result<String, InputError> {
    reduced_source(Source::new("table", std::io::Cursor::new(text.as_bytes().to_vec())), columns, options)
}

/// The reduction of a file.
pub fn reduced_source(
    source: Source,
    columns: &Columns,
    options: &ScanOptions,
) -> Result<String, InputError> {
    let mut reduced = Vec::new();
    ReducedTable::scan(source, columns, options)?.write(&mut reduced).unwrap();
    Ok(String::from_utf8(reduced).unwrap())
}

/// The reduction of a text that has one.
pub fn reduced(text: &str, columns: &Columns, options: &ScanOptions) -> String {
    try_reduced(text, columns, options).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The reductions of parts of a table with a header, rows and parts in any order, one after the other.
pub fn shuffled_parts(text: &str, columns: &Columns, options: &ScanOptions, rng: &mut ChaCha8Rng) -> String {
    let (header, rows) = text.split_once('\n').unwrap();
    let mut rows: Vec<&str> = rows.lines().collect();
    rows.shuffle(rng);
    let mut together = String::new();
    let mut rest = rows.as_slice();
    while !rest.is_empty() {
        let (part, others) = rest.split_at(rng.random_range(1..=rest.len()));
        let options = ScanOptions { chunk_bytes: rng.random_range(1..=100), ..options.clone() };
        together += &reduced(&format!("{header}\n{}\n", part.join("\n")), columns, &options);
        rest = others;
    }
    together
}

/// Everything about a fit that does not need every reading, with rows renamed.
pub fn essence(fitted: &(Problem, Fit), row: &dyn Fn(usize) -> usize) -> String {
    essence_by(fitted, row, &|_| true)
}

/// Returns the number of active bounds, and the names of the bounds of some rows, which have new names.
pub fn essence_by(
    (problem, fit): &(Problem, Fit),
    row: &dyn Fn(usize) -> usize,
    is_named: &dyn Fn(usize) -> bool,
) -> String {
    let name = |name: BoundName| match name {
        BoundName::Upper(own) => BoundName::Upper(row(own)),
        BoundName::Lower(own) => BoundName::Lower(row(own)),
        of_condition => of_condition,
    };
    let indices = |indices: &[usize]| -> (usize, Vec<BoundName>) {
        let ActiveBounds { names, more } = fit.fps.active(indices, usize::MAX);
        let count = names.len() + more;
        let names = names.into_iter().map(name);
        (count, names.filter(|name| name.row().is_none_or(is_named)).collect())
    };
    let named = |terms: Vec<(BoundName, Rational)>| -> Vec<_> {
        terms.into_iter().map(|(own, m)| (name(own), m)).collect()
    };
    let region = fit.fps.polyhedron().region();
    let vertices: Vec<_> = region
        .vertices()
        .iter()
        .map(|vertex| (vertex.point().coordinates(), indices(vertex.active())))
        .collect();
    let boundaries: Vec<_> = region.boundaries().iter().map(|boundary| indices(boundary.active())).collect();
    let ends: Vec<_> = fit
        .pui
        .iter()
        .flatten()
        .flat_map(|interval| [&interval.lower, &interval.upper])
        .map(|end| match end {
            ParameterBound::Bounded { value, proof } => {
                let terms =
                    proof.multipliers.iter().map(|m| (fit.fps.name(m.index), m.value.clone())).collect();
                Some((value.clone(), named(terms)))
            }
            ParameterBound::Unbounded(_) => None,
        })
        .collect();
    let theta = fit.least_squares.as_ref().map(|estimate| estimate.theta.clone());
    let minimax = fit.minimax.as_ref().map(|minimax| {
        let proof = named(minimax.proof.multipliers.clone());
        (minimax.least.clone(), minimax.theta.clone(), minimax.unique, proof)
    });
    let slack = fit.least_squares_slack().map(|(slack, own)| (slack, name(own)));
    let contradiction = fit.contradiction(problem.measurements.error_bound()).map(named);
    format!(
        "{} readings\n{:?} {vertices:?} {boundaries:?} {:?} {:?}\n{ends:?}\n{:?}\n{theta:?} {slack:?}\n{minimax:?}\n{contradiction:?}",
        problem.measurements.fitted(),
        region.kind(),
        region.rays(),
        region.lines(),
        fit.central,
    )
}
