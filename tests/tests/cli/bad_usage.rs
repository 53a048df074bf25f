//! Bad usage, and options that do not go with the data: the exact message, the status, and nothing written anywhere.

use boundfit_tests::program::root;

use boundfit_tests::cli::refusals::{check_refusal, refuses, refuses_options};
use boundfit_tests::cli::{FIT_TRANSDUCER, TRANSDUCER, boundfit, directory_with, files_in};

#[test]
fn options_that_say_nothing_sensible() {
    let bound = "(expected a number that is at least 0, such as 0.5e-3 or 1/2000)";
    let condition = "(expected a condition such as \"2*theta1 - theta2 <= 1/3\" or \"theta2 = 0\")";
    let rows = |text: &str| {
        format!(
            "invalid value '{text}' for '--rows <ROWS>': expected rows from 1 such as 14..36, 5, ..10, 10.. or a list of \
             these, 1..22,24..50"
        )
    };
    let eps = |text: &str, problem: &str| {
        format!("invalid value '{text}' for '--eps <NUM>': not a number: {problem} {bound}")
    };
    let when = |text: &str, problem: &str| {
        format!("invalid value '{text}' for '--where <CONDITION>': {problem} {condition}")
    };
    let compared = |text: &str, problem: &str| {
        format!(
            "invalid value '{text}' for '--where-row <COMPARISON>': {problem} (expected a column, one of < <= = != >= >, \
             and a number, such as 'temperature >= 20')"
        )
    };
    let base = "--x Vz --y z --eps 1";
    let cases = [
        (
            "--x Vz --y z --eps abc".to_owned(),
            "invalid value 'abc' for '--eps <NUM>': neither a number nor one of |y|, |x|, range(y), written and min at \
             character 1 (expected a number such as 0.5e-3, or a law such as \"0.05%*|y| + 2e-3\", \"written\" or \
             \"+0.2/-0.1\"); '--eps-column' names a column of bounds"
                .to_owned(),
        ),
        ("--x Vz --y z --eps 0x10".to_owned(), eps("0x10", "unexpected character 'x' at character 2")),
        (
            "--x Vz --y z --eps 1,5".to_owned(),
            "invalid value '1,5' for '--eps <NUM>': not a number: unexpected ',' (the decimal mark is a point) at character 2 \
             (a point comes before decimals, whatever the data have: 1.5, not 1,5)"
                .to_owned(),
        ),
        ("--x Vz --y z --eps nan".to_owned(), eps("nan", "not a finite number at character 1")),
        ("--x Vz --y z --eps ''".to_owned(), eps("", "nothing to read at character 1")),
        (
            "--x Vz --y z --eps 1e999999999".to_owned(),
            "invalid value '1e999999999' for '--eps <NUM>': refused: exponent beyond 10000 (the limit) at character 3; \
             --limit exponent=N raises it"
                .to_owned(),
        ),
        (
            format!("{base} --where 'theta1 > 0'"),
            when("theta1 > 0", "a strict inequality at character 8: < and > leave out the boundary, which is part of every set here; <= and >= keep it"),
        ),
        (
            format!("{base} --where 'theta1 >= 0' --where slope"),
            when("slope", "neither a number nor theta1 nor theta2 at character 1"),
        ),
        (
            format!("{base} --where theta2/3>=1"),
            when(
                "theta2/3>=1",
                "a factor or divisor behind a parameter at character 7: write 3*theta2 for theta2*3, 1/3*theta2 for theta2/3",
            ),
        ),
        (format!("{base} --where theta1"), when("theta1", "neither <=, >= nor = nor another term at character 7")),
        (format!("{base} --rows 40..20"), rows("40..20")),
        (format!("{base} --rows 0..3"), rows("0..3")),
        (format!("{base} --rows x"), rows("x")),
        (format!("{base} --rows 0"), rows("0")),
        (format!("{base} --rows .."), rows("..")),
        (format!("{base} --rows 1..22;24"), rows("1..22;24")),
        (format!("{base} --without 23,"), rows("23,").replace("--rows", "--without")),
        (
            format!("{base} --rows 3..9 --without ..20"),
            "invalid value '..20' for '--without <ROWS>': no row is left".to_owned(),
        ),
        (format!("{base} --where-row z"), compared("z", "there is no comparison")),
        (format!("{base} --where-row '> 3'"), compared("> 3", "there is no column before the comparison")),
        (
            format!("{base} --where-row '\"z > 3'"),
            compared("\"z > 3", "the quote before the column's name is not closed"),
        ),
        (
            format!("{base} --where-row 'z > three'"),
            compared("z > three", "\"three\": not a number: unexpected character 't' at character 1"),
        ),
        (
            format!("{base} --where-row 'z > 1e99999'"),
            "invalid value 'z > 1e99999' for '--where-row <COMPARISON>': \"1e99999\": refused: exponent beyond 10000 \
             (the limit) at character 3; --limit exponent=N raises it"
                .to_owned(),
        ),
        (format!("{base} --digits 0"), "invalid value '0' for '--digits <N>': expected a whole number from 1 to 1000".to_owned()),
        (
            "--x Vz,z,Vz --y z --eps 1".to_owned(),
            "invalid value 'Vz,z,Vz' for '--x <COL[,COL2]>': expected one column, or two separated by a comma"
                .to_owned(),
        ),
        (
            "--x Vz, --y z --eps 1".to_owned(),
            "invalid value 'Vz,' for '--x <COL[,COL2]>': expected a header name or a column number".to_owned(),
        ),
    ];
    for (options, message) in &cases {
        refuses_options(2, &[(options, message)]);
    }
    // A fault of the command line comes before a fault of the file.
    refuses(&root(), "fit absent.csv --x x --y y --eps abc", 2, &cases[0].1);
}

#[test]
fn options_that_are_missing_unknown_or_too_many() {
    let missing = "the following required arguments were not provided:\n  ";
    refuses_options(
        2,
        &[
            (
                "--x Vz --y z",
                &format!("{missing}<--eps <NUM>|--eps-column <COL>|--lower <COL>|--upper <COL>>"),
            ),
            ("--y z --eps 1", &format!("{missing}--x <COL[,COL2]>")),
            (
                "--x Vz --y z --eps 1 --eps-column z",
                "the errors have one bound: '--eps', or '--eps-column', or '--lower' and '--upper'",
            ),
            ("--x Vz --y z --eps 1 --tolerance 1", "unexpected argument '--tolerance' found"),
            ("more.csv --x Vz --y z --eps 1", "unexpected argument 'more.csv' found"),
            (
                "--x Vz --y z --eps 1 --reading float",
                "invalid value 'float' for '--reading <READING>'\n  [possible values: decimal, binary64]",
            ),
        ],
    );
    for (line, message) in [
        ("frobnicate", "unrecognized subcommand 'frobnicate'"),
        (
            "completions tcsh",
            "invalid value 'tcsh' for '<SHELL>'\n  [possible values: bash, elvish, fish, powershell, zsh]",
        ),
        ("fit -x x -y y -e 1", "unexpected argument '-x' found"),
        ("readings.csv --x x", "unrecognized subcommand 'readings.csv'"),
        (
            "outliers readings.csv --x x --y y --eps 1 --most -1",
            "invalid value '-1' for '--most <Q>': expected a whole number, at least 0",
        ),
        ("linearity readings.csv --x x --y y --eps 1", "unexpected argument '--eps' found"),
        ("polygon", "the following required arguments were not provided:\n  <FILE>"),
    ] {
        check_refusal(&boundfit(&root(), line), line, 2, message);
    }
    for (line, tip) in [
        ("fit -x x --y y --eps 1", "a similar argument exists: '--x'"),
        ("fit --x x -y y --eps 1", "a similar argument exists: '--y'"),
        ("check --x x --y y -e 1", "a similar argument exists: '--eps'"),
        // Two neighbours that are exchanged are one letter.
        ("fit readings.csv --x x --y y --esp 0.5", "a similar argument exists: '--eps'"),
        (
            "fit readings.csv --x x --y y --eps 1 --throuhg-origin",
            "a similar argument exists: '--through-origin'",
        ),
        ("fit readings.csv --x x --y y --epsilon 1", "a similar argument exists: '--eps'"),
        ("fti readings.csv", "a similar subcommand exists: 'fit'"),
        ("oultiers readings.csv", "a similar subcommand exists: 'outliers'"),
        (
            "fit a.csv --x x --y y --eps 1 --format mps",
            "'boundfit convert ... --to lp' and '--to mps' write the linear programs behind a fit",
        ),
        ("fit --x x --y y --eps 1 --predict 3", "'boundfit predict ... --at X' answers this"),
        (
            "fit readings.csv --x x --y y",
            "--eps 0.5 says that no error exceeds 0.5; if you know no bound, --eps '1.2*min' takes one from the readings, \
             which guarantees nothing",
        ),
        ("readings.csv --x x", "a table is fitted by 'boundfit fit readings.csv --x COL --y COL --eps NUM'"),
    ] {
        let said = boundfit(&root(), line).stderr;
        assert!(said.contains(&format!("\n  tip: {tip}\n")), "{said}");
        assert_eq!(said.matches("tip:").count(), 1, "{said}");
    }
    let said = boundfit(&root(), "fit readings.csv --x x --y y --esp 0.5").stderr;
    assert!(said.contains("\nUsage: boundfit fit [OPTIONS] --x <COL[,COL2]>"), "{said}");
    let said = boundfit(&root(), "fit readings.csv --x x --y y --eps 1 --hlpx").stderr;
    assert!(!said.contains("tip:") && !said.contains("--hlpx --help"), "{said}");
    let topic = boundfit(&root(), "man frobnicate");
    let start = "error: invalid value 'frobnicate' for '[TOPIC]': expected one of fit, ";
    assert_eq!((topic.status, topic.stdout.as_str()), (2, ""));
    assert!(topic.stderr.starts_with(start), "{}", topic.stderr);
    let nothing = boundfit(&root(), "");
    assert_eq!((nothing.status, nothing.stdout.as_str()), (2, ""));
    assert!(nothing.stderr.contains("\nUsage: boundfit <COMMAND>\n"), "{}", nothing.stderr);
}

#[test]
fn rows_that_are_not_there() {
    for (rows, named) in [
        ("--rows 40..50", "rows 40..50 were"),
        ("--rows 47..47", "row 47 was"),
        ("--rows 1..99999999999", "rows 1..99999999999 were"),
        ("--rows 1..22,24..47,50", "rows 24..47 were"),
        ("--rows 47..", "rows 47.. were"),
        ("--rows 1..46 --without 3,47", "row 47 was"),
        ("--where-row 'z > 0' --without 48,47", "row 48 was"),
    ] {
        let message = format!("{TRANSDUCER}: {named} asked for, but the file has 46 data rows");
        refuses_options(1, &[(&format!("--x Vz --y z --eps 1 {rows}"), &message)]);
    }
    for (rows, none) in [
        ("--without ..46", "is left"),
        ("--where-row 'z > 1' --where-row '1 < 20'", "satisfies z > 1 and 1 < 20"),
    ] {
        let message = format!("{TRANSDUCER}: of the file's 46 data rows none {none}");
        refuses_options(1, &[(&format!("--x Vz --y z --eps 1 {rows}"), &message)]);
    }
}

#[test]
fn columns_that_are_not_there() {
    let message = |wanted: &str| {
        format!(
            "{TRANSDUCER}: line 1: there is no column \"{wanted}\" (expected one of \"z\", \"Vz\" or a number from 1 to 2)"
        )
    };
    refuses_options(
        1,
        &[
            ("--x volts --y z --eps 1", &message("volts")),
            (
                "--x vz --y z --eps 1",
                &message("vz").replace(" (expected", "; did you mean \"Vz\"? (expected"),
            ),
            ("--x Vz --y z --eps 1 --where-row 'volts > 1'", &message("volts")),
            ("--x 3 --y z --eps 1", &message("3")),
            ("--x 0 --y z --eps 1", &message("0")),
            ("--x Vz --y 99999999999999999999 --eps 1", &message("99999999999999999999")),
            ("--x Vz --y z --eps-column eps", &message("eps")),
            ("--x Vz,1.5 --y z --eps 1", &message("1.5")),
        ],
    );
    let run = boundfit(&root(), "polygon fixtures/bad-input/other-names.csv");
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    let start = "error: fixtures/bad-input/other-names.csv: line 1: there is no column \"a1\" (expected one of \"p\", \"q\", \"r\"";
    assert!(run.stderr.starts_with(start), "{}", run.stderr);
    let end = "; a row a1,a2,b means a1*theta1 + a2*theta2 <= b\n";
    assert!(run.stderr.ends_with(end), "{}", run.stderr);
}

#[test]
fn outputs_that_cannot_be_written() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::create_dir(directory.path().join("folder")).unwrap();
    std::fs::write(directory.path().join("data.csv"), "x,y\n1,2\n").unwrap();
    let fit = "fit data.csv --x x --y y --eps 1 -o";
    let run = boundfit(directory.path(), &format!("{fit} absent/answer.txt"));
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert_eq!(run.stderr, "error: absent/answer.txt: cannot write: there is no folder absent\n");
    let run = boundfit(directory.path(), &format!("{fit} folder"));
    check_refusal(&run, "-o folder", 1, "folder: cannot write: is a directory");
    assert_eq!(files_in(directory.path()), ["data.csv", "folder"]);
    assert_eq!(files_in(&directory.path().join("folder")), [""; 0]);
}

#[test]
fn what_is_refused_here_would_do_with_good_data() {
    assert_eq!(boundfit(&root(), FIT_TRANSDUCER).status, 0);
}

#[test]
fn a_file_of_another_command_is_sent_there() {
    let program = "min x + y\nst\n x + y >= 1\n x <= 3\nend\n";
    let matrix = "H-representation\nbegin\n1 3 rational\n1 1 0\nend\n";
    let directory = directory_with(&[
        ("p.lp", program.as_bytes()),
        ("p.mps", b"NAME P\nROWS\n N c\nENDATA\n"),
        ("h.ine", matrix.as_bytes()),
    ]);
    for (line, says) in [
        ("polygon p.mps", "'boundfit judge' solves the linear program in such a file\n"),
        ("polygon p.lp", "'boundfit judge' solves the linear program in such a file\n"),
        ("fit p.lp --x x --y y --eps 1", "'boundfit judge' solves the linear program in such a file\n"),
        (
            "status h.ine --x x --y y --eps 1",
            "'boundfit polygon' reads the half-planes or generators in such a file\n",
        ),
        (
            "judge h.ine",
            "h.ine: no linear program; 'boundfit polygon' reads the half-planes or generators in such a file\n",
        ),
    ] {
        let run = boundfit(directory.path(), line);
        assert!(run.status == 1 && run.stderr.ends_with(says), "{line}: {}", run.stderr);
        assert!(!run.stderr.contains("--delimiter"), "{line}: {}", run.stderr);
    }
}
