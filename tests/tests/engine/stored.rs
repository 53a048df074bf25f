//! Tables of doubles in binary files: fits and reductions of them are those of the same doubles as text.

use std::fs;
use std::path::Path;

use boundfit_estimation::{Fit, Keep, Measurements, Problem};
use boundfit_exact::{Limits, Reading};
use boundfit_formats::{ScanOptions, Source};
use boundfit_tests::generate::seeded;

use crate::reducing::reduced;
use crate::reduction::{essence, options};
use crate::streams::Case;

/// The columns of a table, where empty cells have no number.
struct Table {
    names: Vec<String>,
    columns: Vec<Vec<Option<f64>>>,
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

    /// Returns the table as vectors of MATLAB's doubles, with NaN where there is no number.
    fn mat(&self) -> Vec<u8> {
        let element = |kind: u32, content: &[u8]| {
            let mut bytes = [kind.to_le_bytes(), (content.len() as u32).to_le_bytes()].concat();
            bytes.extend(content);
            bytes.resize(bytes.len().next_multiple_of(8), 0);
            bytes
        };
        let words = |words: [u32; 2]| words.map(u32::to_le_bytes).concat();
        let mut file = b"MATLAB 5.0 MAT-file, written by a test".to_vec();
        file.resize(124, b' ');
        file.extend(b"\x00\x01IM");
        for (name, column) in self.names.iter().zip(&self.columns) {
            let numbers: Vec<u8> =
                column.iter().flat_map(|number| number.unwrap_or(f64::NAN).to_le_bytes()).collect();
            let parts = [
                element(6, &words([6, 0])),
                element(5, &words([column.len() as u32, 1])),
                element(1, name.as_bytes()),
                element(9, &numbers),
            ];
            file.extend(element(14, &parts.concat()));
        }
        file
    }

    #[cfg(feature = "arrow")]
    fn write_columnar(&self, folder: &Path) {
        use std::sync::Arc;

        use arrow_array::{ArrayRef, Float64Array, RecordBatch};

        let column = |(name, numbers): (&String, &Vec<Option<f64>>)| {
            (name.clone(), Arc::new(Float64Array::from(numbers.clone())) as ArrayRef, true)
        };
        let batch =
            RecordBatch::try_from_iter_with_nullable(self.names.iter().zip(&self.columns).map(column));
        let batch = batch.unwrap();
        let create = |name: &str| fs::File::create(folder.join(name)).unwrap();
        let mut parquet =
            parquet::arrow::ArrowWriter::try_new(create("table.parquet"), batch.schema(), None).unwrap();
        parquet.write(&batch).unwrap();
        parquet.close().unwrap();
        let mut arrow =
            arrow_ipc::writer::FileWriter::try_new(create("table.arrow"), &batch.schema()).unwrap();
        arrow.write(&batch).unwrap();
        arrow.finish().unwrap();
    }

    #[cfg(not(feature = "arrow"))]
    fn write_columnar(&self, _: &Path) {}
}

#[test]
fn binary_files_are_fitted_and_reduced_like_text_of_their_doubles() {
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
        fs::write(folder.path().join("table.mat"), table.mat()).unwrap();
        table.write_columnar(folder.path());
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
        for name in ["table.mat", "table.parquet", "table.arrow"] {
            let path = folder.path().join(name);
            if !path.exists() {
                continue;
            }
            let open = || Source::open(path.to_str().unwrap()).unwrap();
            let streamed = scanned(open(), 0);
            assert_eq!(essence(&streamed, &|row| row), whole, "{name} {:?}\n{}", case.columns, case.text);
            let own = crate::reducing::reduced_source(open(), &case.columns, &options(Reading::Binary64, 1));
            let own = own.unwrap_or_else(|error| panic!("{name}: {error}\n{}", case.text));
            let found = essence(&scanned(text(&own), usize::MAX), &|row| row);
            assert_eq!(found, of_text, "{name} {:?}\n{}\n{own}", case.columns, case.text);
        }
    }
}
