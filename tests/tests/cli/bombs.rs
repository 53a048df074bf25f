//! Files that unpack to a thousand times their size, and streams without an end, are refused within two seconds, with the option
//! that would let them pass.

#![cfg(target_os = "linux")]

use std::io::Write;
use std::time::Duration;

use boundfit_tests::cli::{boundfit, directory_with, words};
use boundfit_tests::hostile::{Cost, LIMITS, gzip, matlab_zeros, repeated_by_zstandard, run_limited};
use boundfit_tests::workbooks::{ods, xlsx};

const FIT: &str = "fit FILE --x x --y y --eps 1 --no-lp";
const TOO_FAR: &str = "refused: it unpacks to more than 67108864 bytes and 100 times its size (the limit); --max-ratio raises it\n";
/// What is within two seconds of processor time may take what a laptop has to spare.
const TWO_SECONDS: Cost = Cost { cpu: Duration::from_secs(2), data: 512 << 20 };

/// Checks that a command about a file ends in time with a message.
fn refused(content: &[u8], line: &str, message: &str, limits: Cost) {
    let directory = directory_with(&[("bomb", content), ("few.csv", b"x,y\n1,2\n2,3\n")]);
    let ended = run_limited(directory.path(), &words(&line.replace("FILE", "bomb")), limits);
    assert!(
        ended.status == Some(1) && ended.messages.ends_with(message),
        "{line}: {ended:?}, {} bytes",
        content.len()
    );
}

/// A table whose rows go on and on, packed.
fn packed_rows(piece: &str) -> Vec<u8> {
    let mut text = "x,y\n1,2\n2,3\n".to_owned();
    text += &piece.repeat((80 << 20) / piece.len());
    gzip(text.as_bytes())
}

#[test]
fn packed_text_is_refused_once_it_is_a_hundred_times_its_size() {
    for piece in ["1,1\n2,1\n", "\n", "# comment\n"] {
        refused(&packed_rows(piece), FIT, TOO_FAR, TWO_SECONDS);
    }
    for command in
        ["reduce FILE --x x --y y", "check FILE --x x --y y --eps 1", "fit FILE --x x --y y --eps 1 --by x"]
    {
        refused(&packed_rows("1,1\n2,1\n"), command, TOO_FAR, TWO_SECONDS);
    }
    let blank_lines = repeated_by_zstandard(b'\n', 700);
    assert!(blank_lines.len() < 4_096);
    for command in [FIT, "polygon FILE", "judge FILE"] {
        refused(&blank_lines, command, TOO_FAR, TWO_SECONDS);
    }
}

/// As many blank lines as may be cost no memory, wherever they stand.
#[test]
fn blank_lines_are_not_held() {
    let few = Cost { data: 40 << 20, ..LIMITS };
    let blank_lines = repeated_by_zstandard(b'\n', 400);
    let empty = "bomb: the file is empty (expected at least one row of numbers)\n";
    refused(&blank_lines, FIT, empty, few);
    let mut table = vec![b'\n'; 1 << 20];
    table.extend(b"x,y\n1,2\n2,three\n");
    let line_of_error = "bomb: line 1048579, column 2 (y): \"three\": not a number: ";
    let directory = directory_with(&[("bomb", &table)]);
    let ended = run_limited(directory.path(), &words(&FIT.replace("FILE", "bomb")), few);
    assert!(ended.messages.contains(line_of_error), "{ended:?}");
}

#[test]
fn variables_of_matlab_files_are_refused_before_memory_is_taken() {
    let zeros = matlab_zeros(5_000_000);
    assert!(zeros.len() < 100_000);
    refused(&zeros, FIT, TOO_FAR, TWO_SECONDS);
}

#[test]
fn sheets_of_one_cell_again_and_again_are_refused() {
    let row = format!("<row>{}</row>", "<c><v>1</v></c>".repeat(16_384));
    refused(&xlsx(&[("S", &row.repeat(300))]), FIT, TOO_FAR, TWO_SECONDS);
    refused(&xlsx(&[("S", &" ".repeat(80 << 20))]), FIT, TOO_FAR, TWO_SECONDS);
    let cell = "<table:table-cell office:value-type=\"float\" office:value=\"1\"/>";
    let row = format!("<table:table-row>{}</table:table-row>", cell.repeat(2));
    refused(&ods(&[("S", &row.repeat(700_000))]), FIT, TOO_FAR, TWO_SECONDS);
}

#[cfg(feature = "arrow")]
mod columns {
    use std::sync::Arc;

    use arrow_array::{ArrayRef, DictionaryArray, Int8Array, Int32Array, RecordBatch, StringArray};
    use arrow_ipc::writer::FileWriter;
    use parquet::arrow::ArrowWriter;

    use super::*;

    fn batch(column: &ArrayRef) -> RecordBatch {
        RecordBatch::try_from_iter([("x", column.clone()), ("y", column.clone())]).unwrap()
    }

    fn files(column: &ArrayRef) -> [Vec<u8>; 2] {
        let batch = batch(column);
        let (mut parquet, mut arrow) = (Vec::new(), Vec::new());
        let mut writer = ArrowWriter::try_new(&mut parquet, batch.schema(), None).unwrap();
        writer.write(&batch).unwrap();
        writer.close().unwrap();
        let mut writer = FileWriter::try_new(&mut arrow, &batch.schema()).unwrap();
        writer.write(&batch).unwrap();
        writer.finish().unwrap();
        [parquet, arrow]
    }

    #[test]
    fn one_number_in_millions_of_rows_is_refused() {
        let zeros: ArrayRef = Arc::new(Int8Array::from(vec![0; 6_000_000]));
        let [parquet, _] = files(&zeros);
        assert!(parquet.len() < 200_000);
        refused(&parquet, FIT, TOO_FAR, TWO_SECONDS);
    }

    /// Every row names one text of nine thousand digits.
    #[test]
    fn one_long_number_in_many_rows_is_refused_for_its_work() {
        let long = "7".repeat(9_000);
        let texts = StringArray::from(vec![long.as_str()]);
        let column = DictionaryArray::try_new(Int32Array::from(vec![0; 100_000]), Arc::new(texts)).unwrap();
        let work = " products of machine words, more than 400000000 (the limit); --max-work raises it\n";
        for file in files(&(Arc::new(column) as ArrayRef)) {
            refused(&file, FIT, work, TWO_SECONDS);
        }
    }
}

const COMMANDS: [&str; 10] = [
    FIT,
    "fit FILE --x x --y y --eps 1 --by x",
    "reduce FILE --x x --y y",
    "check FILE --x x --y y --eps 1",
    "plot FILE --x x --y y --eps 1 -o a.svg",
    "lesson FILE --x x --y y --eps 1 -o a.html",
    "convert FILE --x x --y y --eps 1 --to lp --objective theta1-max",
    "polygon FILE",
    "judge FILE",
    "verify p.json FILE",
];

#[test]
fn a_line_without_an_end_is_refused_by_every_command() {
    let directory = directory_with(&[("few.csv", b"x,y\n1,2\n2,3\n")]);
    let proof = words("fit few.csv --x x --y y --eps 1 --no-lp -o r.txt --proof p.json");
    assert!(run_limited(directory.path(), &proof, LIMITS).is_well());
    for line in COMMANDS {
        let ended = run_limited(directory.path(), &words(&line.replace("FILE", "/dev/zero")), TWO_SECONDS);
        let message = "16777216 bytes (the limit); --max-line raises it\n";
        assert!(ended.status == Some(1) && ended.messages.ends_with(message), "{line}: {ended:?}");
    }
    for line in ["verify /dev/zero few.csv", "check few.csv --x x --y y --eps 1 --claim /dev/zero"] {
        let ended = run_limited(directory.path(), &words(line), LIMITS);
        let message = "/dev/zero: this is no text in UTF-8\n";
        assert!(ended.status == Some(1) && ended.messages.ends_with(message), "{line}: {ended:?}");
    }
}

/// What holds every row, or all of a text, stops at a limit; a smaller one shows it.
#[test]
fn rows_without_an_end_are_refused_where_they_are_held() {
    let mut rows = b"x,y\n".to_vec();
    (0..200_000).for_each(|row| writeln!(rows, "{row},{}", row % 7).unwrap());
    let too_many = "bomb: there are more than 100000 rows (the limit); --max-rows raises it\n";
    for command in [
        "plot FILE --x x --y y --eps 9 -o a.svg --figure data",
        "outliers FILE --x x --y y --eps 9",
        "fit FILE --x x --y y --eps 9 --x-eps 1",
        "fit FILE --x x --y y --eps 9 --by y",
        "linearity FILE --x x --y y",
    ] {
        refused(&rows, &format!("{command} --max-rows 100000"), too_many, TWO_SECONDS);
    }
    let readings = "bomb: more than 300 readings are too many for a lesson; choose some with --rows FIRST..LAST, or raise it with \
                    --max-readings\n";
    refused(&rows, "lesson FILE --x x --y y --eps 9 -o a.html", readings, TWO_SECONDS);
    let too_large = "bomb: refused: the file has more than 1000000 bytes (the limit); --max-text raises it\n";
    for command in ["polygon FILE", "judge FILE"] {
        refused(&rows, &format!("{command} --max-text 1000000"), too_large, TWO_SECONDS);
    }
}

/// A line of commas has no more cells than there may be columns, whether it is a header, a row or packed.
#[test]
fn lines_of_commas_are_refused_before_their_cells_are_kept() {
    let commas = [b",".repeat(8_000_000), b"\n".to_vec()].concat();
    let blanks = [b"1 ".repeat(4_000_000), b"\n".to_vec()].concat();
    for (name, text, line) in [
        ("header.csv", commas.clone(), 1),
        ("row.csv", [b"x,y\n1,1\n".to_vec(), commas].concat(), 3),
        ("blanks.txt", blanks, 1),
    ] {
        let directory = directory_with(&[(name, &text)]);
        let message = format!(
            "error: {name}: line {line}: there are more than 100000 columns (the limit); --max-columns raises it\n"
        );
        let run = boundfit(directory.path(), &format!("fit {name} --x 1 --y 2 --eps 1"));
        assert_eq!((run.status, run.stderr), (1, message));
    }
}

/// What never ends, and is no text, is not read on.
#[test]
fn devices_are_no_claims_and_no_proofs() {
    let directory = directory_with(&[("a.csv", b"x,y\n1,1\n2,2\n")]);
    for command in ["verify /dev/zero a.csv", "check a.csv --x x --y y --eps 1 --claim /dev/zero"] {
        let run = boundfit(directory.path(), command);
        let message = "error: /dev/zero: this is no text in UTF-8\n";
        assert_eq!((run.status, run.stderr.as_str()), (1, message), "{command}");
    }
}

/// A sensor with few different readings may be as long as it likes: a row takes about a byte.
#[test]
fn equal_readings_are_counted_by_every_command() {
    let mut rows = b"g,x,y,d\n".to_vec();
    (0..300_000_u32).for_each(|k| {
        let mixed = k.wrapping_mul(2_654_435_761) >> 16;
        writeln!(rows, "1,{},{},{}", mixed % 2, mixed / 2 % 3, ["up", "down"][mixed as usize / 6 % 2])
            .unwrap();
    });
    let directory = directory_with(&[("ties.csv", &rows)]);
    for line in [
        "outliers ties.csv --x x --y y --eps 3",
        "outliers ties.csv --x x --y y --eps 1/2",
        "fit ties.csv --x x --y y --eps 3 --x-eps 1",
        "linearity ties.csv --x x --y y",
        "linearity ties.csv --x x --y y --direction d",
        "fit ties.csv --x x --y y --eps 3 --by g",
        "fit ties.csv --x x --y y --eps 3 --by d --format json",
    ] {
        let cost = Cost { cpu: Duration::from_secs(20), data: 64 << 20 };
        let ended = run_limited(directory.path(), &words(line), cost);
        assert_eq!(ended.status, Some(0), "{line}: {ended:?}");
    }
}

/// What holds readings says what they take before it takes it.
#[test]
fn readings_take_no_more_memory_than_they_may() {
    let mut rows = b"x,y\n".to_vec();
    (0..60_000).for_each(|row| writeln!(rows, "{row},{}", row % 1009).unwrap());
    let way_out = "of memory, more than 16 MiB (the limit); --limit memory=SIZE raises it\n";
    for command in [
        "plot FILE --x x --y y --eps 9 -o a.svg --figure data",
        "outliers FILE --x x --y y --eps 9",
        "fit FILE --x x --y y --eps 9 --x-eps 1",
        "linearity FILE --x x --y y",
        "range FILE --x x --y y --eps 9",
    ] {
        refused(&rows, &format!("{command} --limit memory=16MiB"), way_out, TWO_SECONDS);
    }
    let way_out = "of memory, more than 1 MiB (the limit); --limit memory=SIZE raises it\n";
    refused(&rows, "fit FILE --x x --y y --eps 9 --by y --limit memory=1MiB", way_out, TWO_SECONDS);
    let directory = directory_with(&[("few.csv", b"x,y\n1,2\n2,3\n")]);
    for (value, message) in [
        (
            "rows=5",
            "there is no limit of the name \"rows\" (expected memory=SIZE, such as memory=512MiB or memory=4GiB)",
        ),
        ("memory", "expected memory=SIZE, such as memory=512MiB or memory=4GiB"),
        ("memory=0", "expected a size in bytes above 0"),
        ("memory=1TB", "expected a size in bytes above 0"),
    ] {
        let line = format!("fit few.csv --x x --y y --eps 1 --limit {value}");
        let ended = run_limited(directory.path(), &words(&line), LIMITS);
        assert!(ended.status == Some(2) && ended.messages.contains(message), "{line}: {ended:?}");
    }
    let line = "fit few.csv --x x --y y --eps 1 --limit memory=1k --limit memory=1.5GiB";
    assert!(run_limited(directory.path(), &words(line), LIMITS).is_well());
}
