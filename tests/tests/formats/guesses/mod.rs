//! The detected format of a table: header, names, blocks. No guess goes unsaid.

mod edits;

use boundfit_formats::{
    AskedBlock, ColumnSelector, Header, Missing, MissingWords, RowRange, ScanOptions, Source, TableNotes,
    TableOptions,
};
use boundfit_tests::program::root;

use crate::scan::both::{POOLS, batches, found};

/// The columns asked for, their numbers row by row, and what is said of the table; or the message.
type Read = Result<(Vec<String>, Vec<Vec<String>>, Option<String>), String>;

fn read(bytes: &[u8], columns: &[&str], table: TableOptions, chunk_bytes: usize) -> Read {
    let columns: Vec<ColumnSelector> =
        columns.iter().map(|column| ColumnSelector::name_or_number(column)).collect();
    let options = ScanOptions { table, chunk_bytes, ..ScanOptions::default() };
    let source = Source::new("data", std::io::Cursor::new(bytes.to_vec()));
    let (scanned, batches) = batches(source, &columns, &options)?;
    let words = scanned.table.as_ref().and_then(TableNotes::words);
    let found = found(scanned, &batches);
    let numbers = |(_, row): (usize, Vec<_>)| row.iter().map(ToString::to_string).collect();
    Ok((found.names, found.rows.into_iter().map(numbers).collect(), words))
}

fn fixture(file: &str) -> Vec<u8> {
    std::fs::read(root().join("fixtures/guesses").join(file)).unwrap()
}

/// Names, first row, number of rows and words of a fixture, or the message, whatever the chunks.
fn said(file: &str, columns: &[&str], table: &TableOptions) -> String {
    let shown = |chunk_bytes| {
        let read = read(&fixture(file), columns, table.clone(), chunk_bytes);
        read.map_or_else(
            |message| message,
            |(names, rows, words)| {
                let words = words.map(|words| format!("; {words}")).unwrap_or_default();
                format!("{}: {} and {} more{words}", names.join(" "), rows[0].join(" "), rows.len() - 1)
            },
        )
    };
    let expected = shown(1 << 18);
    for chunk_bytes in [1, 7, 64] {
        assert_eq!(POOLS[1].install(|| shown(chunk_bytes)), expected, "{file} in chunks of {chunk_bytes}");
    }
    expected
}

fn with(change: impl FnOnce(&mut TableOptions)) -> TableOptions {
    let mut options = TableOptions::default();
    change(&mut options);
    options
}

fn auto() -> TableOptions {
    TableOptions::default()
}

#[test]
fn line_1_is_a_header_where_a_cell_of_it_is_no_number_above_numbers() {
    let nonames = "0 1: 10 12501/500 and 9 more; header in line 1 (else header no)";
    assert_eq!(said("pandas-nonames.csv", &["2", "3"], &auto()), nonames);
    assert_eq!(said("pandas-nonames.csv", &["0", "1"], &auto()), nonames);
    let reading = with(|options| options.header = Header::Absent);
    assert_eq!(said("pandas-nonames.csv", &["2", "3"], &reading), "col2 col3: 0 1 and 10 more");
    let years = "1960 1970: 241/50 727/250 and 7 more; header in line 1 (else header no)";
    assert_eq!(said("years-as-names.csv", &["4", "5"], &auto()), years);
    let by_name = "1960 1970: 241/50 727/250 and 7 more; header in line 1";
    assert!(said("years-as-names.csv", &["1960", "1970"], &auto()).starts_with(by_name));
    assert_eq!(
        said("counts-in-line-1.csv", &["1", "2"], &auto()),
        "150 4: 51/10 7/2 and 8 more; header in line 1 (else header no)"
    );
    let years = "2010 2011: 2 3 and 2 more; header in line 1 (else header no)";
    assert_eq!(said("yearheads.csv", &["2", "3"], &auto()), years);
}

/// Names, rows and words of a text whose wanted columns are asked for by these numbers, or the message.
fn said_of(text: &str, columns: &[&str], missing_as: &[&str]) -> (String, usize, String) {
    let words = missing_as.iter().map(|&word| word.to_owned());
    let table = TableOptions {
        missing: Missing::Skip,
        missing_as: MissingWords::new(words),
        ..TableOptions::default()
    };
    let (names, rows, words) = read(text.as_bytes(), columns, table, 1 << 18).unwrap();
    (names.join(" "), rows.len(), words.unwrap_or_default())
}

#[test]
fn a_word_for_a_missing_value_is_no_name() {
    let reading = "no header, the first line is a reading (else header yes)";
    let overload = "OVLD,2.5,1.5\n5,3,2\n6,4,4\n";
    for (text, columns, missing_as, rows) in [
        (overload, ["2", "3"], ["OVLD"].as_slice(), 3),
        (&overload.replace("OVLD", "NA"), ["2", "3"], &[], 3),
        ("1,OL\n2,3\n3,4\n4,5.1\n", ["1", "2"], &["OL"], 3),
        ("OL,OL\n2,3\n3,4\n4,5.1\n", ["1", "2"], &["OL"], 3),
    ] {
        let names = columns.map(|column| format!("col{column}")).join(" ");
        assert_eq!(said_of(text, &columns, missing_as), (names, rows, reading.to_owned()), "{text:?}");
    }
}

#[test]
fn a_first_line_that_may_be_a_reading_leaves_the_header_open() {
    let open = "header in line 1 (else header no)";
    for (text, words) in [
        ("OVLD,2.5,1.5\n5,3,2\n6,4,4\n", open),
        ("OVLD,NA,1.5\n5,3,2\n6,4,4\n", open),
        ("when,12:30,1.5\n5,3,2\n6,4,4\n", "header in line 1"),
        ("run,x,1.5\n5,3,2\n6,4,4\n", "header in line 1"),
        ("run,x,y\n5,3,2\n6,4,4\n", ""),
    ] {
        assert_eq!(said_of(text, &["2", "3"], &[]).2, words, "{text:?}");
    }
    // A number that no column has is a name.
    assert_eq!(said_of("run,2019,2020\n5,3,2\n6,4,4\n", &["2019", "2020"], &[]).2, "header in line 1");
}

#[test]
fn a_name_that_is_the_number_of_another_column_is_refused() {
    let message = "data: line 1: \"1\" is the name of column 2 and the number of another one (expected '\"1\"', with \
                   the quotes, for the name; for the number the name of that column)";
    assert_eq!(said("scope.csv", &["x-axis", "1"], &auto()), message);
    let units = with(|options| options.dialect.units_row = true);
    assert_eq!(
        said("scope.csv", &["x-axis", "\"1\""], &units),
        "x-axis 1: -1/200 51/500 and 3 more; header in line 1, units in line 2"
    );
    for (columns, message) in [
        (
            ["temp", "temp"],
            "data: line 1, column 1 (temp): the same column is asked for as \"temp\" and as \"temp\" (expected two columns)",
        ),
        (
            ["1", "temp"],
            "data: line 1, column 1 (temp): the same column is asked for as \"1\" and as \"temp\" (expected two columns)",
        ),
    ] {
        assert_eq!(said("yearheads.csv", &columns, &auto()), message);
    }
}

#[test]
fn a_remark_names_no_columns() {
    assert_eq!(
        said("run1.txt", &["1", "2"], &auto()),
        "col1 col2: 1 2 and 3 more; no header, the first line is a reading (else header yes), separated by blanks"
    );
    assert_eq!(
        said("taken-out.dat", &["T", "U"], &auto()),
        "T U: 1 2 and 2 more; names in the comment of line 1, 1 comment line between rows, separated by blanks"
    );
    assert_eq!(
        said("integers-in-r.csv", &["x", "y"], &auto()),
        "x y: 2 5 and 2 more; names of rows in column 1 (unless commas are decimal marks)"
    );
    // A label ends with a colon. If every cell does, the cells are names.
    for (text, names) in [
        ("# source: me\n1 2\n2 3\n3 5\n", "col1 col2"),
        ("# a log\n# date:, today\n1,2\n2,3\n3,5\n", "col1 col2"),
        ("# U: I:\n1 2\n2 3\n3 5\n", "U: I:"),
        ("# U I\n1 2\n2 3\n3 5\n", "U I"),
    ] {
        assert_eq!(said_of(text, &["1", "2"], &[]).0, names, "{text:?}");
    }
}

#[test]
fn the_mark_before_the_names_is_none_of_them() {
    let comment = "names in the comment of line";
    for (text, columns, names, words) in [
        (
            "# Speed (m/s), Dist (m)\n1,2\n2,3\n3,5\n",
            ["Speed", "Dist"],
            "Speed (m/s) Dist (m)",
            format!("{comment} 1"),
        ),
        ("% Speed, Dist\n1,2\n2,3\n3,5\n", ["1", "2"], "Speed Dist", format!("{comment} 1")),
        ("# a log\n# Speed, Dist\n1,2\n2,3\n3,5\n", ["Speed", "2"], "Speed Dist", format!("{comment} 2")),
        ("# Speed;Dist\n1;2\n2;3\n3;5\n", ["# Speed", "Dist"], "Speed Dist", format!("{comment} 1")),
        // A mark without a blank may be a part of the name, and so may one within quotes.
        ("#,n\n1,2\n2,3\n3,5\n", ["#", "n"], "# n", String::new()),
        ("#1,n\n1,2\n2,3\n3,5\n", ["#1", "n"], "#1 n", String::new()),
        ("\"# n\",y\n1,2\n2,3\n3,5\n", ["# n", "y"], "# n y", String::new()),
    ] {
        assert_eq!(said_of(text, &columns, &[]), (names.to_owned(), 3, words), "{text:?}");
    }
    // It is a header that further blocks may repeat.
    let all = with(|options| options.block = AskedBlock::parse("all"));
    let text = b"# x,y\n1,2\n\n\n# x,y\n3,4\n";
    let (names, rows, words) = read(text, &["x", "y"], all, 100).unwrap();
    assert_eq!((names.join(" "), rows.len()), ("x y".to_owned(), 2));
    assert_eq!(words.as_deref(), Some("names in the comment of line 1, all 2 blocks, 1 header repeated"));
}

#[test]
fn blocks_are_told_apart() {
    let list = "1 (run 1), lines 2 to 4, 3 rows; 2 (run 2), lines 8 to 10, 3 rows";
    let expected = "(expected a block by its number or its name)";
    assert_eq!(
        said("gnuplot.dat", &["1", "2"], &auto()),
        format!("data: the file has 2 blocks of rows: {list} {expected}")
    );
    let block = |text: &str| with(|options| options.block = AskedBlock::parse(text));
    let open = "no header, the first line is a reading (else header yes)";
    for (asked, rows, said_of) in [
        ("2", "1 7 and 2 more", "block 2 of 2 (run 2)"),
        ("run 2", "1 7 and 2 more", "block 2 of 2 (run 2)"),
        ("1", "1 2 and 2 more", "block 1 of 2 (run 1)"),
        ("run 1", "1 2 and 2 more", "block 1 of 2 (run 1)"),
        ("all", "1 2 and 5 more", "all 2 blocks"),
    ] {
        assert_eq!(
            said("gnuplot.dat", &["1", "2"], &block(asked)),
            format!("col1 col2: {rows}; {open}, {said_of}, separated by blanks")
        );
    }
    for asked in ["3", "run"] {
        let wanted = AskedBlock::parse(asked).unwrap();
        assert_eq!(
            said("gnuplot.dat", &["1", "2"], &block(asked)),
            format!("data: there is no block {wanted}; the file has 2: {list} {expected}")
        );
    }
}

#[test]
fn a_block_whose_name_is_the_number_of_another_is_refused() {
    let text = "# 2\n1 2\n2 3\n\n\n# 1\n5 6\n6 8\n7 9\n";
    let rows = |text: &str, asked: &str| {
        let block = with(|options| options.block = AskedBlock::parse(asked));
        read(text.as_bytes(), &["1", "2"], block, 7).map(|(_, rows, _)| rows.len())
    };
    for (asked, named) in [("2", 1), ("1", 2)] {
        let message = format!(
            "data: \"{asked}\" is the name of block {named} and the number of another one (expected '\"{asked}\"', with \
             the quotes, for the name; for the number the name of that block)"
        );
        assert_eq!(rows(text, asked), Err(message));
    }
    assert_eq!((rows(text, "\"2\""), rows(text, "'1'"), rows(text, "all")), (Ok(2), Ok(3), Ok(5)));
    // A block may have its own number for a name.
    let own = text.replace("# 2", "# one").replace("# 1", "# 2");
    assert_eq!((rows(&own, "2"), rows(&own, "1"), rows(&own, "\"2\"")), (Ok(3), Ok(2), Ok(3)));
    let message = rows(&text.replace("# 2", "# 2014"), "2014").unwrap_err();
    assert!(message.contains("there is no block 2014; the file has 2: 1 (2014), lines 2 to 3"), "{message}");
    let expected =
        "(expected '\"2014\"', with the quotes, for the name, or another block by its number or its name)";
    assert!(message.ends_with(expected), "{message}");
}

#[test]
fn the_header_of_each_block_is_no_row_of_all_of_them() {
    let all = with(|options| options.block = AskedBlock::parse("all"));
    let text = |between: &str, header: &str| format!("x,y\n1,2\n2,3\n{between}{header}\n3,4\n");
    for (between, header, words) in [
        ("\n\n", "x,y", "all 2 blocks, 1 header repeated"),
        ("# run 2\n", "\"x\", y", "all 2 blocks, 1 header repeated"),
        ("", "x,y", "1 header repeated"),
        ("x,y\n", "x,y", "2 headers repeated"),
    ] {
        let text = text(between, header);
        for chunk_bytes in [1, 5, 9, 100] {
            let (_, rows, said) = read(text.as_bytes(), &["x", "y"], all.clone(), chunk_bytes).unwrap();
            assert_eq!(rows, [["1", "2"], ["2", "3"], ["3", "4"]], "{text:?}");
            assert_eq!(said.as_deref(), Some(words), "{text:?} in chunks of {chunk_bytes}");
            // Rows are counted without headers, wanted or not.
            let last = TableOptions { rows: RowRange::new(3, 3).unwrap().into(), ..all.clone() };
            let (_, rows, _) = read(text.as_bytes(), &["x", "y"], last, chunk_bytes).unwrap();
            assert_eq!(rows, [["3", "4"]], "{text:?}");
        }
        // Nobody said that the rows are one table.
        assert!(read(text.as_bytes(), &["x", "y"], auto(), 100).is_err());
    }
    // Other names, or the same ones in another order, are no repetition, and numbers are a row.
    for header in ["y,x", "x,z"] {
        let message = read(text("\n\n", header).as_bytes(), &["x", "y"], all.clone(), 100).unwrap_err();
        assert!(
            message.contains("line 6, column 1 (x)") || message.contains("line 6, column 2 (y)"),
            "{message}"
        );
    }
    let numbers = TableOptions { header: Header::Present, ..all };
    let (_, rows, _) = read(b"1,2\n3,4\n1,2\n", &["1", "2"], numbers, 100).unwrap();
    assert_eq!(rows, [["3", "4"], ["1", "2"]]);
}

#[test]
fn blocks_are_found_wherever_chunks_end() {
    let rows = |start: usize| (start..start + 9).map(|k| format!("{k},{}.5\n", k * 3)).collect::<String>();
    for (between, is_break) in
        [("\n", false), ("\n\n", true), ("\r\n \n", true), ("# b\n", true), ("#b\n\n\n", true)]
    {
        let text = format!("x,y\n{}{between}{}", rows(1), rows(10));
        for chunk_bytes in 1..=text.len() {
            let read = POOLS[1].install(|| read(text.as_bytes(), &["x", "y"], auto(), chunk_bytes));
            let message = read.as_ref().err().cloned().unwrap_or_default();
            assert_eq!(
                message.contains("the file has 2 blocks of rows: 1, lines 1 to 10, 9 rows; 2"),
                is_break,
                "{between:?} in chunks of {chunk_bytes}: {message}"
            );
            assert_eq!(read.is_ok_and(|(_, rows, _)| rows.len() == 18), !is_break, "{between:?}");
        }
    }
}

#[test]
fn lines_before_the_table_and_short_rows_are_passed_over_and_counted() {
    assert_eq!(
        said("labview.lvm", &["X_Value", "Voltage"], &auto()),
        "X_Value Voltage: 0 1021/1000 and 3 more; header in line 22, 3 rows shorter than the first"
    );
    assert_eq!(
        said("logger.csv", &["Time", "Temperature"], &auto()),
        "Time (s) Temperature (C): 0 201/10 and 3 more; header in line 4, 2 rows shorter than the first"
    );
    assert_eq!(
        said("scope-preamble.csv", &["TIME", "CH1"], &auto()),
        "TIME CH1: -1/1000 51/500 and 3 more; header in line 5"
    );
}

#[test]
fn marks_of_spreadsheets_are_understood_or_explained() {
    assert_eq!(
        said("sep-line.csv", &["U", "I"], &auto()),
        "U I: 3/2 9/4 and 2 more; decimal comma, separated by semicolons"
    );
    let comma = with(|options| options.dialect.decimal = Some(boundfit_exact::DecimalMark::Comma));
    assert_eq!(
        said("quoted-commas.csv", &["x", "y"], &comma),
        "x y: 3/2 2 and 2 more; decimal comma, separated by commas"
    );
    assert_eq!(
        said("quoted-commas.csv", &["x", "y"], &auto()),
        said("quoted-commas.csv", &["x", "y"], &comma)
    );
    assert_eq!(
        said("commas-twice.csv", &["x", "y"], &auto()),
        "data: line 2: the row has 4 cells where the first row has 2: decimal commas and commas between columns? (expected semicolons or tabs between the columns, or quotes around numbers with commas)"
    );
    assert_eq!(
        said("dates.csv", &["t", "U"], &auto()),
        "data: line 2, column 1 (t): \"2024-01-01 00:00:10\": a date or a time, not a number (expected a number: give the \
         cells the format of one, or add a column of seconds or days)"
    );
}

/// Reads quoted commas in a table that commas divide, between rows of integers. The first comma that cannot group
/// digits decides their meaning. Neither the ends of chunks nor columns outside the question matter.
#[test]
fn quoted_decimal_commas_are_told_from_grouped_digits() {
    let text = |head: &str, cells: &str| {
        let integers: String = (1..6).map(|k| format!("0:00.{k},{k},{}\n", 2 * k)).collect();
        format!("t,x,y\n{head}{integers}{cells}{integers}\"no. 7\",8,9\n")
    };
    let grouped = |line: u32| {
        format!(
            "data: line {line}, column 2 (x): \"1,234\": not a number: unexpected ',' (the decimal mark is a point) at \
             character 2 (expected 1.5)"
        )
    };
    let another = |line: u32, cell: &str, marks: [&str; 2]| {
        format!(
            "data: line {line}, column 2 (x): \"{cell}\": a number with a decimal {}, where those before have a decimal {} \
             (expected one decimal mark)",
            marks[0], marks[1]
        )
    };
    let comma = Some("decimal comma, separated by commas".to_owned());
    let number = |text: &str| Ok::<_, String>((text.to_owned(), comma.clone()));
    for (head, cells, expected) in [
        ("", "n,\"3,5\",1\n", number("7/2")),
        ("", "n,\"0,125\",1\n", number("1/8")),
        ("", "n,\"1234,5\",1\n", number("2469/2")),
        ("n,\"3,5\",1\n", "n,\"1,234\",1\n", number("617/500")),
        ("", "n,2,\"-,5\"\nn,\"1,234\",1\n", number("2")),
        ("", "n,\"1,234\",1\nn,\"3,5\",1\n", Err(grouped(7))),
        ("n,1.5,1\n", "n,\"1,234\",1\n", Err(grouped(8))),
        ("n,1.5,1\n", "n,\"3,5\",1\n", Err(another(8, "3,5", ["comma", "point"]))),
        ("n,1,5.\n", "n,\"3,5\",1\n", Err(another(8, "3,5", ["comma", "point"]))),
        ("n,\"3,5\",1\n", "n,1.5,1\n", Err(another(8, "1.5", ["point", "comma"]))),
    ] {
        let text = text(head, cells);
        let line = text.lines().position(|line| line == cells.lines().next().unwrap()).unwrap() - 1;
        for chunk_bytes in (1..=text.len() + 1).chain([1 << 18]) {
            let read = POOLS[1].install(|| read(text.as_bytes(), &["x", "y"], auto(), chunk_bytes));
            let read = read.map(|(_, rows, words)| (rows[line][0].clone(), words));
            assert_eq!(read, expected, "{text} in chunks of {chunk_bytes}");
        }
    }
    let asked = with(|options| options.dialect.thousands = Some(boundfit_exact::Thousands::Comma));
    let read = read(text("", "n,\"1,234\",1\n").as_bytes(), &["x", "y"], asked, 1);
    assert_eq!(read.unwrap().1[5], ["1234", "1"]);
}

#[test]
fn a_comma_that_may_group_digits_is_a_guess() {
    let options = ScanOptions { chunk_bytes: 9, ..ScanOptions::default() };
    for (text, is_guess) in [
        ("x;y\n1;60,323\n2;83,200\n", true),
        ("x\ty\n1\t2\n2\t-1,234\n", true),
        ("x;y\n1;6,3\n2;83,200\n", false),
        ("x;y\n1;0,323\n2;83,200\n", false),
        ("x;y\n1;1234,567\n2;83,200\n", false),
        ("x;y\n1;60.323\n2;83.200\n", false),
        ("x,y\n1,\"6,3\"\n2,\"83,200\"\n", false),
    ] {
        let source = Source::new("data", std::io::Cursor::new(text.as_bytes().to_vec()));
        let (scanned, _) = batches(source, &["x", "y"].map(ColumnSelector::name), &options).unwrap();
        let notes = scanned.table.unwrap();
        assert_eq!([notes.is_comma_open, notes.has_guesses()], [is_guess; 2], "{text:?}");
    }
}

#[test]
fn words_and_numbers_for_missing_values_are_told() {
    let words = || MissingWords::new(["OVLD", "-999"].map(str::to_owned));
    let skipped = with(|options| (options.missing, options.missing_as) = (Missing::Skip, words()));
    assert_eq!(said("overload.csv", &["x", "y"], &skipped), "x y: 1 2 and 1 more");
    let refused = with(|options| options.missing_as = words());
    assert_eq!(
        said("overload.csv", &["x", "y"], &refused),
        "data: line 3, column 2 (y): \"OVLD\": the value is missing, and in 1 row more (expected a number in every row)"
    );
}
