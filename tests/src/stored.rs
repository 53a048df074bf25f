//! Tables of doubles in binary files: fits and reductions of them are those of the same doubles as text.

use std::path::Path;

use boundfit_estimation::{Fit, Keep, Measurements, Problem};
use boundfit_exact::{Limits, Reading};
use boundfit_formats::{ScanOptions, Source};

use crate::generate::seeded;
use crate::reducing::{essence, options, reduced, reduced_source};
use crate::streams::Case;

/// The columns of a table, where empty cells have no number.
pub struct Table {
    /// Names of columns.
    pub names: Vec<String>,
    /// Numbers of each column.
    pub columns: Vec<Vec<Option<f64>>>,
}

impl Table {
    fn of(case: &Case) -> Self {
        let mut lines = case.text.lines();
        let names: Vec<String> = lines.next().unwrap().split(',').map(str::to_owned).collect();
        let number = |cell: &str| {
            let value = Reading::Binary64.read(cell, &Limits::default());
            (!cell.is_empty()).then(|| value.unwrap().to_f64())
        };
        let mut columns = vec![Vec::new(); names.len()];
        for line in lines {
            columns.iter_mut().zip(line.split(',')).for_each(|(column, cell)| column.push(number(cell)));
        }
        Table { names, columns }
    }
}

/// Checks fits and reductions of files that a function writes into a folder.
pub fn check(names: &[&str], write: impl Fn(&Table, &Path)) {
    let mut rng = seeded(63);
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    while count < 400 {
        let mut case = Case::random(&mut rng, 1..=30);
        case.reading = Reading::Binary64;
        // Stored numbers have no last digit written.
        if case.needs_written() {
            continue;
        }
        count += 1;
        let table = Table::of(&case);
        write(&table, folder.path());
        let scanned = |source: Source, most_rows: usize| -> (Problem, Fit) {
            let keep = Keep { most_rows, ..Keep::default() };
            let options = ScanOptions { chunk_bytes: 64, ..options(Reading::Binary64, 1) };
            let conditions = case.all_conditions();
            let measurements = Measurements::scan(source, &case.columns, &conditions, &options, keep);
            case.fitted(measurements.unwrap_or_else(|error| panic!("{error}\n{}", case.text)))
        };
        let text = |text: &str| Source::new("text", std::io::Cursor::new(text.as_bytes().to_vec()));
        let whole = essence(&scanned(text(&case.text), usize::MAX), &|row| row);
        let of_text = reduced(&case.text, &case.columns, &options(Reading::Binary64, 1));
        let of_text = essence(&scanned(text(&of_text), usize::MAX), &|row| row);
        for name in names {
            let path = folder.path().join(name);
            let open = || Source::open(path.to_str().unwrap()).unwrap();
            let streamed = scanned(open(), 0);
            assert_eq!(essence(&streamed, &|row| row), whole, "{name} {:?}\n{}", case.columns, case.text);
            let own = reduced_source(open(), &case.columns, &options(Reading::Binary64, 1));
            let own = own.unwrap_or_else(|error| panic!("{name}: {error}\n{}", case.text));
            let found = essence(&scanned(text(&own), usize::MAX), &|row| row);
            assert_eq!(found, of_text, "{name} {:?}\n{}\n{own}", case.columns, case.text);
        }
    }
}
