//! Files that unpack to a thousand times their size, and streams without an end, are refused within a few seconds, with the option
//! that would let them pass.

#![cfg(target_os = "linux")]

use std::io::Write;
use std::process::{Command, Stdio};
use std::time::Duration;

use boundfit_tests::cli::{boundfit, directory_with, words};
use boundfit_tests::hostile::{
    Cost, FEW_SECONDS, LIMITS, TOO_FAR, gzip, matlab_zeros, refused, repeated_behind, repeated_by_zstandard,
    run_limited,
};
use boundfit_tests::workbooks::{ods, xlsx, xlsx_rows, xlsx_with};

const FIT: &str = "fit FILE --x x --y y --eps 1 --no-lp";
/// A table whose rows go on and on, packed.
fn packed_rows(piece: &str) -> Vec<u8> {
    let mut text = "x,y\n1,2\n2,3\n".to_owned();
    text += &piece.repeat((80 << 20) / piece.len());
    gzip(text.as_bytes())
}

#[test]
fn packed_text_is_refused_once_it_is_a_hundred_times_its_size() {
    for piece in ["\n", "# comment\n"] {
        refused(&packed_rows(piece), FIT, TOO_FAR, FEW_SECONDS);
    }
    let readings = packed_rows("1,1\n2,1\n");
    for command in [
        FIT,
        "reduce FILE --x x --y y",
        "check FILE --x x --y y --eps 1",
        "fit FILE --x x --y y --eps 1 --by x",
    ] {
        refused(&readings, command, TOO_FAR, FEW_SECONDS);
    }
    let blank_lines = repeated_by_zstandard(b'\n', 700);
    assert!(blank_lines.len() < 4_096);
    for command in [FIT, "polygon FILE", "judge FILE"] {
        refused(&blank_lines, command, TOO_FAR, FEW_SECONDS);
    }
}

/// Blank lines up to the limit cost no memory, wherever they stand.
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
    refused(&zeros, FIT, TOO_FAR, FEW_SECONDS);
}

#[test]
fn sheets_of_one_cell_again_and_again_are_refused() {
    let row = format!("<row>{}</row>", "<c><v>1</v></c>".repeat(16_384));
    refused(&xlsx(&[("S", &row.repeat(300))]), FIT, TOO_FAR, FEW_SECONDS);
    refused(&xlsx(&[("S", &" ".repeat(80 << 20))]), FIT, TOO_FAR, FEW_SECONDS);
    let cell = "<table:table-cell office:value-type=\"float\" office:value=\"1\"/>";
    let row = format!("<table:table-row>{}</table:table-row>", cell.repeat(2));
    refused(&ods(&[("S", &row.repeat(700_000))]), FIT, TOO_FAR, FEW_SECONDS);
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
        let ended = run_limited(directory.path(), &words(&line.replace("FILE", "/dev/zero")), FEW_SECONDS);
        let message = "16777216 bytes (the limit); --limit line=N raises it\n";
        assert!(ended.status == Some(1) && ended.messages.ends_with(message), "{line}: {ended:?}");
    }
    for line in ["verify /dev/zero few.csv", "check few.csv --x x --y y --eps 1 --claim /dev/zero"] {
        let ended = run_limited(directory.path(), &words(line), LIMITS);
        let message = "/dev/zero: this is no text in UTF-8\n";
        assert!(ended.status == Some(1) && ended.messages.ends_with(message), "{line}: {ended:?}");
    }
}

/// A reader that holds every row, or all of a text, stops at a limit; a smaller limit shows it.
#[test]
fn rows_without_an_end_are_refused_where_they_are_held() {
    let mut rows = b"x,y\n".to_vec();
    (0..200_000).for_each(|row| writeln!(rows, "{row},{}", row % 7).unwrap());
    let too_many = "bomb: there are more than 100000 rows (the limit); --limit rows=N raises it\n";
    for command in [
        "plot FILE --x x --y y --eps 9 -o a.svg --figure data",
        "outliers FILE --x x --y y --eps 9",
        "fit FILE --x x --y y --eps 9 --x-eps-column x",
        "fit FILE --x x --y y --eps 9 --by y",
        "linearity FILE --x x --y y",
    ] {
        refused(&rows, &format!("{command} --limit rows=100000"), too_many, FEW_SECONDS);
    }
    let readings = "bomb: more than 300 readings are too many for a lesson; choose some with --rows FIRST..LAST, or raise it with \
                    --limit readings=N\n";
    refused(&rows, "lesson FILE --x x --y y --eps 9 -o a.html", readings, FEW_SECONDS);
    let too_large =
        "bomb: refused: the file has more than 1000000 bytes (the limit); --limit text=N raises it\n";
    for command in ["polygon FILE", "judge FILE"] {
        refused(&rows, &format!("{command} --limit text=1000000"), too_large, FEW_SECONDS);
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
            "error: {name}: line {line}: there are more than 100000 columns (the limit); --limit columns=N raises it\n"
        );
        let run = boundfit(directory.path(), &format!("fit {name} --x 1 --y 2 --eps 1"));
        assert_eq!((run.status, run.stderr), (1, message));
    }
}

/// The program does not read on where a file never ends and is no text.
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

/// A command that holds readings reports their memory before it takes it.
#[test]
fn readings_take_no_more_memory_than_they_may() {
    let mut rows = b"x,y\n".to_vec();
    (0..60_000).for_each(|row| writeln!(rows, "{row},{}", row % 1009).unwrap());
    let way_out = "of memory, more than 16 MiB (the limit); --limit memory=N raises it\n";
    for command in [
        "plot FILE --x x --y y --eps 9 -o a.svg --figure data",
        "outliers FILE --x x --y y --eps 9",
        "fit FILE --x x --y y --eps 9 --x-eps-column x",
        "range FILE --x x --y y --eps 9",
    ] {
        refused(&rows, &format!("{command} --limit memory=16MiB"), way_out, FEW_SECONDS);
    }
    let way_out = "of memory, more than 1 MiB (the limit); --limit memory=N raises it\n";
    for command in ["fit FILE --x x --y y --eps 9 --by y", "linearity FILE --x x --y y"] {
        refused(&rows, &format!("{command} --limit memory=1MiB"), way_out, FEW_SECONDS);
    }
    let directory = directory_with(&[("few.csv", b"x,y\n1,2\n2,3\n")]);
    for (value, message) in [
        ("size=5", "there is no limit \"size\" (expected one of digits,"),
        ("memory", "expected NAME=N, such as digits=20000 or memory=4GiB"),
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

/// Text that never ends, without a byte that is none of text.
#[test]
fn proofs_and_claims_without_an_end_are_refused() {
    let directory = directory_with(&[("a.csv", b"x,y\n1,1\n2,2\n")]);
    let pipe = directory.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for (line, option) in [
        ("verify pipe a.csv", "--limit text"),
        ("check a.csv --x x --y y --eps 1 --claim pipe", "--limit text"),
    ] {
        // A buffer of the limit, 256 MB, grows to it by copies.
        let usual = Cost { data: 1 << 30, ..FEW_SECONDS };
        for (set, size, cost) in
            [(String::new(), 268_435_456, usual), (format!(" {option}=1000000"), 1_000_000, LIMITS)]
        {
            let yes =
                Command::new("sh").args(["-c", "exec yes > \"$0\""]).arg(&pipe).stderr(Stdio::null()).spawn();
            let ended = run_limited(directory.path(), &words(&format!("{line}{set}")), cost);
            // It ends when nobody reads on.
            yes.unwrap().wait().unwrap();
            let message = format!("pipe: larger than {size} bytes (the limit; {option}=N raises it)\n");
            assert!(ended.status == Some(1) && ended.messages.ends_with(&message), "{line}: {ended:?}");
        }
    }
}

/// Readers ask the one budget for data that they cannot hand out at once.
#[test]
fn readers_ask_for_memory_before_they_take_it() {
    let rows: String = (0..20_000).map(|row| format!("{row},{}\n", row % 1009)).collect();
    let table = format!("x,y\n{rows}");
    let sheet = xlsx(&[("S", &xlsx_rows(&table, b'A', 1))]);
    let texts = "<si><t>some text or other</t></si>".repeat(40_000);
    let texts = xlsx_with(
        &[("S", &xlsx_rows("x,y\n1,2\n2,3\n", b'A', 1))],
        "xl/sharedStrings.xml",
        &format!("<sst xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\">{texts}</sst>"),
    );
    let octave =
        format!("# name: x\n# type: matrix\n# rows: 20000\n# columns: 1\n{}\n", "1\n".repeat(20_000));
    let names = "# name: a\n# type: scalar\n1\n\n\n".repeat(20_000);
    let empty = format!("[[\"x\",\"y\"],[{}\"\"]]", "\"\",".repeat(50_000));
    let ine = format!("H-representation\nbegin\n20000 3 integer\n{}end\n", "1 1 1\n".repeat(20_000));
    let window = repeated_behind(b"x,y\n1,1\n2,2\n3,4\n", b'\n', 60, 27);
    for (name, content, command, limit, what) in [
        ("sheet", sheet, FIT, "300KiB", "the cells of the sheet take "),
        ("shared texts", texts, FIT, "300KiB", "the cells of the sheet take "),
        ("a workbook", [b'P', b'K', 3, 4].repeat(100_000), FIT, "300KiB", "the workbook takes "),
        ("variables", matlab_zeros(100_000), FIT, "1MiB", "the variables that are asked for take "),
        ("numbers as text", octave.into_bytes(), FIT, "1MiB", "the variables that are asked for take "),
        ("many variables", names.into_bytes(), FIT, "1MiB", "the variables that are asked for take "),
        ("records", empty.into_bytes(), FIT, "1MiB", "the records that are read together take "),
        ("half-planes", ine.into_bytes(), "polygon FILE", "5MiB", "error: bomb: the first "),
        ("a window", window, FIT, "4MiB", "unpacking takes "),
    ] {
        let directory = directory_with(&[("bomb", &content)]);
        let line = format!("{command} --limit memory={limit}").replace("FILE", "bomb");
        let ended = run_limited(directory.path(), &words(&line), LIMITS);
        let is_refused = ended.messages.contains(what)
            && ended.messages.ends_with("(the limit); --limit memory=N raises it\n");
        assert!(ended.status == Some(1) && is_refused, "{name}: {ended:?}");
    }
}

/// A frame may say that it repeats what stands 128 MiB before, which has to be held until then.
#[test]
fn windows_are_as_large_as_the_file_gives_reason_to() {
    let start = b"x,y\n1,1\n2,2\n3,4\n";
    let small = repeated_behind(start, b'\n', 30, 27);
    let directory = directory_with(&[("small.zst", &small)]);
    assert!(run_limited(directory.path(), &words(&FIT.replace("FILE", "small.zst")), FEW_SECONDS).is_well());
    let large = repeated_behind(start, b'\n', 400, 27);
    assert!(large.len() < 2_000);
    let message = "refused: unpacking it takes more than 8388608 bytes of memory and 100 times its size (the limit); \
                   --limit ratio=N raises it\n";
    let few = Cost { data: 48 << 20, ..LIMITS };
    for command in [
        FIT,
        "fit FILE --x x --y y --eps 1 --by x",
        "reduce FILE --x x --y y",
        "lesson FILE --x x --y y --eps 1 -o a.html",
        "polygon FILE",
        "judge FILE",
    ] {
        refused(&large, command, message, few);
    }
    let too_large = repeated_behind(start, b'\n', 4, 30);
    let message = "cannot read a Zstandard file: it takes the last 1 GiB that were unpacked, and 128 MiB may be taken; pack it anew \
                   with a smaller window\n";
    refused(&too_large, FIT, message, few);
}

/// Neither rows of a reduction that stand for others nor readings that a lesson has no room for are kept.
#[test]
fn equal_rows_are_kept_once_or_not_at_all() {
    let rows = 400_000;
    let mut reduction = format!(
        "# boundfit/reduced/3 {{\"rows\":{all},\"kept\":{rows},\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
         \"epsilon\":null,\"sums\":[\"{all}\",\"{all}\",\"{all}\",\"{all}\"]}}\nx,y\n",
        all = 2 * rows
    );
    reduction += &"2 1,1\n".repeat(rows);
    let directory = directory_with(&[("reduced", &gzip(reduction.as_bytes()))]);
    let cost = Cost { cpu: Duration::from_secs(20), data: 64 << 20 };
    let ended = run_limited(directory.path(), &words("fit reduced --x x --y y --eps 1 --no-lp"), cost);
    assert_eq!(ended.status, Some(0), "{ended:?}");
    let readings = "bomb: more than 300 readings are too many for a lesson; choose some with --rows FIRST..LAST, or raise it with \
                    --limit readings=N\n";
    let ties = format!("x,y\n{}", "1,1\n1,2\n".repeat(300_000));
    refused(
        ties.as_bytes(),
        "lesson FILE --x x --y y --eps 9 -o a.html",
        readings,
        Cost { data: 24 << 20, ..LIMITS },
    );
}
