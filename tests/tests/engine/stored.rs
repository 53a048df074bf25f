//! Doubles in MATLAB's files are fitted and reduced like text.

use std::fs;

use boundfit_tests::stored::{self, Table};

/// Returns the table as vectors of MATLAB's doubles, with NaN where there is no number.
fn mat(table: &Table) -> Vec<u8> {
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
    for (name, column) in table.names.iter().zip(&table.columns) {
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

#[test]
fn binary_files_are_fitted_and_reduced_like_text_of_their_doubles() {
    let name = "table.mat";
    stored::check(&[name], |table, folder| fs::write(folder.join(name), mat(table)).unwrap());
}
