use super::*;

const MPS: ExchangeFormat = ExchangeFormat::Mps;

/// A file with these lines instead of what stands in the same section.
const PLAIN: &str = "\
NAME plain
ROWS
 N cost
 L r1
 G r2
 E r3
COLUMNS
 x cost 1 r1 1
 x r2 1
 y cost 2 r3 1
RHS
 RHS r1 4 r2 1
RANGES
 RNG r1 2
BOUNDS
 UP BND x 3
ENDATA
";

fn row_bounds(text: &str) -> Vec<Bounds> {
    read(text, MPS).rows.into_iter().map(|row| row.bounds).collect()
}

#[test]
fn ranges_extend_from_the_side() {
    let file = |kind: &str, side: &str, range: &str| {
        format!("ROWS\n N c\n {kind} r\nCOLUMNS\n x r 1\nRHS\n r {side}\nRANGES\n r {range}\nENDATA\n")
    };
    for (kind, side, range, lower, upper) in [
        ("L", "4", "3", "1", "4"),
        ("L", "4", "-3", "1", "4"),
        ("G", "4", "3", "4", "7"),
        ("G", "4", "-3", "4", "7"),
        ("E", "4", "3", "4", "7"),
        ("E", "4", "-3", "1", "4"),
        ("E", "4", "0", "4", "4"),
        ("E", "4", "-0", "4", "4"),
        ("L", "-0.1", "1e30", "-", "-0.1"),
        ("E", "-1", "-1e30", "-", "-1"),
        ("E", "1", "-1e30", "-999999999999999999999999999999", "1"),
        ("E", "1", "inf", "1", "-"),
        ("G", "-9e29", "1.9e30", "-9e29", "-"),
        ("G", "-9e29", "1.8e30", "-9e29", "9e29"),
    ] {
        assert_eq!(row_bounds(&file(kind, side, range)), [bounds(lower, upper)], "{kind} {side} {range}");
    }
}

#[test]
fn bounds_are_meant_as_cplex_means_them() {
    let file = |lines: &str| format!("ROWS\n N c\nCOLUMNS\n x c 1\nBOUNDS\n{lines}\nENDATA\n");
    for (lines, lower, upper) in [
        ("", "0", "-"),
        (" UP B x 3", "0", "3"),
        (" UP B x -3", "-", "-3"),
        (" UP B x -3\n LO B x -5", "-5", "-3"),
        (" LO B x 0\n UP B x -3", "0", "-3"),
        (" UP B x 0", "0", "0"),
        (" UP B x -0.0", "0", "0"),
        (" LO B x 7/3", "7/3", "-"),
        (" FX B x 1.5D+1", "15", "15"),
        (" FR B x", "-", "-"),
        (" FR x", "-", "-"),
        (" FR x 0", "-", "-"),
        (" MI B x", "-", "-"),
        (" MI B x 0\n UP B x 2", "-", "2"),
        (" PL x", "0", "-"),
        (" up x 3", "0", "3"),
        (" UP B x 1e30", "0", "-"),
        (" UP B x 999999999999999999999999999999", "0", "999999999999999999999999999999"),
        (" LO B x -1e31", "-", "-"),
        (" LO B x -INF\n UP B x Infinity", "-", "-"),
        (" UP\tB\tx\t3", "0", "3"),
        (" UP x 3 $ a comment", "0", "3"),
    ] {
        assert_eq!(read(&file(lines), MPS).columns[0].bounds, bounds(lower, upper), "{lines}");
    }
}

#[test]
fn the_frame_of_a_file_may_vary() {
    let plain = read(PLAIN, MPS);
    let objective = "OBJSENSE\n    MAX\nOBJNAME\n    second\nROWS\n N cost\n N second\nCOLUMNS\n x cost 1 second 2\nRHS\n second 3\nENDATA\n";
    let model = read(objective, MPS);
    assert_eq!((model.sense, model.objective_name.raw()), (ObjectiveSense::Maximize, "second"));
    assert_eq!((model.constant, model.columns[0].cost.clone()), (number("-3"), number("2")));
    for line in ["OBJSENSE MAX", "objsense maximise", "OBJSENSE\n MAXIMIZE", "OBJSENSE\n\n* c\n max"] {
        let model = read(&PLAIN.replace("ROWS", &format!("{line}\nROWS")), MPS);
        assert_eq!(model, Model { sense: ObjectiveSense::Maximize, ..plain.clone() }, "{line}");
    }
    for text in [
        PLAIN.replace('\n', "\r\n"),
        format!("\u{feff}{PLAIN}"),
        PLAIN.replace("\n ", "\n\t"),
        PLAIN.replace("COLUMNS", "* comment\n$ comment\n\n \nCOLUMNS"),
        format!("{PLAIN} what follows is not read\u{0}"),
        PLAIN.replace(" UP BND x 3", " UP x 3").replace("RNG r1", "r1").replace("RHS r1", "r1"),
        PLAIN.replace("ENDATA\n", "ENDATA\r"),
        PLAIN.replace("\n N cost\n L r1\n", "\n N cost $ the cost\n L r1   $ first row $\n"),
        PLAIN.replace("\n L r1\n", "\n l r1\n").replace("x cost 1 r1 1", "x cost 1 $ r1 1\n x r1 1"),
        PLAIN.replace(" x r2 1", " x r2 1.0E0").replace(" y cost 2", " y cost 2.d0"),
        PLAIN.replace("COLUMNS\n", "COLUMNS\n M 'MARKER' 'INTORG'\n M 'MARKER' 'INTEND'\n"),
    ] {
        assert_eq!(read(&text, MPS), plain, "{text}");
    }
    let without_rows = read("ROWS\nCOLUMNS\nENDATA\n", MPS);
    assert_eq!(without_rows, Model::default());
    assert_eq!(read(&PLAIN.replace(" x r2 1", " x r2 0"), MPS).rows[1].coefficients, []);
}

/// A model in the columns of the fixed format, with blanks in all names.
const FIXED: &str = "\
NAME          a model
ROWS
 N  the cost
 L  row 1
  G row 2
COLUMNS
    col 1     the cost  1              row 1     1
    col 1     row 2     -0.5           $ a comment
    c 2       the cost  2              row 2     1
RHS
    rhs 1     row 1     4              row 2     1
              the cost  -7
BOUNDS
 UP bnd a     col 1     3
 FR bnd a     c 2
ENDATA
";

#[test]
fn fixed_files_may_have_blanks_in_names() {
    // The unnamed vector is another one.
    let text = FIXED.replace("              the cost", "    rhs 1     the cost");
    let model = read(&text, MPS);
    assert_eq!(model.name, "a model");
    assert_eq!(model.objective_name, "the cost");
    let names: Vec<&str> = model.columns.iter().map(|column| column.name.raw()).collect();
    assert_eq!(names, ["col 1", "c 2"]);
    assert_eq!(model.rows[1].name, "row 2");
    assert_eq!(model.rows[1].coefficients, [(0, number("-1/2")), (1, number("1"))]);
    assert_eq!(model.constant, number("7"));
    assert_eq!(model.columns[1].bounds, bounds("-", "-"));
    assert_eq!(
        message(FIXED, MPS),
        "line 12, column 15: \"the cost\": a second vector in RHS, after \"rhs 1\"; some solvers take the first \
         alone, some take both (expected one vector, under one name)"
    );
    let unknown = text.replace("c 2       the cost", "c 2       the csot");
    assert!(message(&unknown, MPS).contains("did you mean \"the cost\"?"), "{}", message(&unknown, MPS));
}

#[test]
fn a_line_out_of_the_fixed_columns_is_named() {
    // Read as free MPS, the first line with blanks in a name would be named.
    let text = FIXED.replace(
        "    c 2       the cost  2              row 2     1",
        "    c 2       the cost  0.123456789012345",
    );
    assert_eq!(
        message(&text, MPS),
        "line 9, column 5: \"c 2       the cost  0.123456789012345\": this is not in the columns of fixed MPS, as the \
         names with blanks before it are (expected names and numbers in the columns 2-3, 5-12, 15-22, 25-36, 40-47 and \
         50-61, or names without blanks)"
    );
}

#[test]
fn files_that_mean_two_programs_are_refused() {
    // As free MPS, column a has 5 in row r and 1 in row 2.
    let text = "ROWS\n N  cost\n L  r\n L  2\nCOLUMNS\n    a r 5     2         1\nENDATA\n";
    let expected = "names with blanks, as in fixed MPS, and yet another program as free MPS (expected names without blanks)";
    assert_eq!(message(text, MPS), expected);
    let names =
        |text: &str| read(text, MPS).columns.into_iter().map(|column| column.name).collect::<Vec<_>>();
    assert_eq!(names(&text.replace("a r 5 ", "a s 5 ")), ["a s 5"]);
    assert_eq!(names(&text.replace("    a r 5", "\ta r 5")), ["a"]);
}

#[test]
fn a_sense_in_a_comment_wants_its_section() {
    let comment = "*SENSE:Maximize\n";
    assert_eq!(
        message(&format!("{comment}{PLAIN}"), MPS),
        "line 1, column 1: \"*SENSE:Maximize\": only a comment asks for the maximum, and MPS without OBJSENSE means the minimum (expected the section OBJSENSE with MAX or MIN; PuLP writes it with writeMPS(..., with_objsense=True))"
    );
    for (section, sense) in [("MAX", ObjectiveSense::Maximize), ("MIN", ObjectiveSense::Minimize)] {
        let stated = PLAIN.replacen("ROWS", &format!("OBJSENSE\n {section}\nROWS"), 1);
        assert_eq!(read(&format!("{comment}{stated}"), MPS).sense, sense);
    }
    assert_eq!(read(&format!("*SENSE:Minimize\n{PLAIN}"), MPS), read(PLAIN, MPS));
}

#[test]
fn refusals_say_what_would_be_accepted() {
    let with = |old: &str, new: &str| {
        assert!(PLAIN.contains(old), "{old}");
        PLAIN.replacen(old, new, 1)
    };
    let sections =
        "NAME, OBJSENSE, OBJNAME, ROWS, COLUMNS, RHS, RANGES, BOUNDS or ENDATA; data begin with a blank";
    let file = "a linear program in MPS: NAME, ROWS, COLUMNS, RHS, RANGES, BOUNDS, ENDATA";
    let order = "ROWS, then COLUMNS, then RHS, RANGES and BOUNDS, each once";
    let values = "columns that may have any value between two bounds";
    for (text, expected) in [
        (String::new(), format!("there is nothing in the file (expected {file})")),
        ("* only\n\n$ comments\n".to_owned(), format!("there is nothing in the file (expected {file})")),
        ("\u{0}\u{1}".to_owned(), "line 1, column 1: \"\\0\\u{1}\": the control character '\\0' (expected text in UTF-8)".to_owned()),
        ("NAME x\rROWS\n".to_owned(), "line 1, column 7: \"\\rROWS\": the control character '\\r' (expected text in UTF-8)".to_owned()),
        ("hello world\n".to_owned(), format!("line 1, column 1: \"hello\": this begins no section of MPS (expected {sections})")),
        (" x c 1\n".to_owned(), format!("line 1, column 2: \"x c 1\": a line of data where a section begins (expected {sections})")),
        (with("ENDATA", "QUADOBJ\n x x 1\nENDATA"), "line 17, column 1: \"QUADOBJ\": this is more than a linear program (expected rows, columns, right-hand sides, ranges and bounds)".to_owned()),
        (with("RANGES", "RHS"), format!("line 13, column 1: \"RHS\": the section began on line 11 already (expected {order})")),
        (with("ROWS", "COLUMNS"), format!("line 2, column 1: \"COLUMNS\": the section ROWS has to come before this one (expected {order})")),
        ("ROWS\n N c\nENDATA\n".to_owned(), format!("line 3, column 1: \"ENDATA\": there is no section COLUMNS (expected {file})")),
        (with("ROWS\n", "OBJSENSE\nROWS\n"), "line 3, column 1: \"ROWS\": the section OBJSENSE has no line of data (expected MIN or MAX in OBJSENSE, a row in OBJNAME)".to_owned()),
        (with("ROWS\n", "OBJSENSE\n BEST\nROWS\n"), "line 3, column 2: \"BEST\": not a sense (expected MIN or MAX)".to_owned()),
        (with("ROWS\n", "OBJSENSE MAX\n MIN\nROWS\n"), "line 3, column 2: \"MIN\": this is no line of OBJSENSE (expected one word)".to_owned()),
        (with("ROWS\n", "OBJNAME r1\nROWS\n"), "line 2, column 9: \"r1\": the row is not of type N, so it is no objective (expected a row of type N)".to_owned()),
        (with("ROWS\n", "OBJNAME costs\nROWS\n"), "line 2, column 9: \"costs\": there is no such row; did you mean \"cost\"? (expected a row of the section ROWS)".to_owned()),
        (with("ROWS\n", "ROWS x\n"), "line 2, column 6: \"x\": there is more on the line than the name of a section (expected the name alone; data begin with a blank)".to_owned()),
        (with(" L r1", " L r 1"), "line 4, column 2: \"L r 1\": this is no line of ROWS (expected a type and a name: N, L, G or E, then a row)".to_owned()),
        (with(" L r1", " Q r1"), "line 4, column 2: \"Q\": not a type of row (expected N, L, G or E)".to_owned()),
        (with(" G r2", " G r1"), "line 5, column 4: \"r1\": the row is on line 4 already (expected names that differ)".to_owned()),
        (with(" G r2", " G $2"), "line 5, column 4: \"$2\": a name that begins with $ (expected another name: what begins with $ may be a comment)".to_owned()),
        (with(" x r2 1", " x r2"), "line 9, column 2: \"x r2\": this is no line of COLUMNS (expected a column, then one or two rows, each with its coefficient)".to_owned()),
        (with(" x r2 1", " x R2 1"), "line 9, column 4: \"R2\": there is no such row; did you mean \"r2\"? (expected a row of the section ROWS)".to_owned()),
        (with(" x r2 1", " x r2 1,5"), "line 9, column 7: \"1,5\": not a number: unexpected ',' (the decimal mark is a point) at character 2 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)".to_owned()),
        (with(" x r2 1", " x r2 1e999999999"), "line 9, column 7: \"1e999999999\": refused: exponent beyond 10000 (the limit) at character 3".to_owned()),
        (with(" x r2 1", " x r1 1"), "line 9, column 4: \"r1\": the column has a coefficient in this row on line 8 already (expected one)".to_owned()),
        (with("ENDATA", "ENDATA").replacen("RHS", " x r3 1\nRHS", 1), "line 11, column 2: \"x\": other columns stand between this and line 9, where the column was before (expected all of a column together)".to_owned()),
        (with("COLUMNS\n", "COLUMNS\n M 'MARKER' 'INTORG'\n"), format!("line 9, column 2: \"x\": the column is integer (expected {values})")),
        (with("UP BND x 3", "BV BND x"), format!("line 16, column 9: \"x\": the column is integer (expected {values})")),
        (with("UP BND x 3", "LI BND x 3"), format!("line 16, column 9: \"x\": the column is integer (expected {values})")),
        (with("UP BND x 3", "UI BND x 3"), format!("line 16, column 9: \"x\": the column is integer (expected {values})")),
        (with("UP BND x 3", "SC BND x 3"), format!("line 16, column 9: \"x\": the column is semi-continuous (expected {values})")),
        (with("UP BND x 3", "UB BND x 3"), "line 16, column 2: \"UB\": not a type of bound (expected LO, UP, FX, FR, MI or PL)".to_owned()),
        (with("UP BND x 3", "UP BND z 3"), "line 16, column 9: \"z\": there is no such column (expected a column that has coefficients; they may be 0)".to_owned()),
        (with("UP BND x 3", "UP x"), "line 16, column 2: \"UP x\": the bound is missing (expected a number behind the column; FR, MI and PL have none)".to_owned()),
        (with("UP BND x 3", "UP BND x 3\n FX BND x 2"), "line 17, column 9: \"x\": the column has its upper bound on line 16 already (expected one; FX and FR are both bounds)".to_owned()),
        (with("UP BND x 3", "UP BND x 3\n UP B2 y 2"), "line 17, column 5: \"B2\": a second vector in BOUNDS, after \"BND\"; some solvers take the first alone, some take both (expected one vector, under one name)".to_owned()),
        (with("UP BND x 3", "LO BND x 1e30"), "line 16, column 11: \"1e30\": an infinite lower bound leaves no value (expected a number; 1e30 and more are infinite)".to_owned()),
        (with("UP BND x 3", "UP BND x -inf"), "line 16, column 11: \"-inf\": an infinite upper bound leaves no value (expected a number; 1e30 and more are infinite)".to_owned()),
        (with("UP BND x 3", "FX BND x 1e31"), "line 16, column 11: \"1e31\": an infinite lower bound leaves no value (expected a number; 1e30 and more are infinite)".to_owned()),
        (with("RHS r1 4", "RHS r1 -1e30"), "line 12, column 9: \"-1e30\": an infinite upper bound leaves no value (expected a number; 1e30 and more are infinite)".to_owned()),
        (with("RHS r1 4", "RHS cost inf"), "line 12, column 11: \"inf\": not a number: not a finite number at character 1 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)".to_owned()),
        (with("RHS r1 4", "RHS r1 1e30"), "line 14, column 9: \"2\": the row has no finite right-hand side from which the range extends".to_owned()),
        (with("RHS r1 4 r2 1", "RHS r1 4 r1 1"), "line 12, column 11: \"r1\": the row has a right-hand side on line 12 already (expected one)".to_owned()),
        (with("RNG r1 2", "RNG r1 2\n RNG r1 3"), "line 15, column 6: \"r1\": the row has a range on line 14 already (expected one)".to_owned()),
        (with("RNG r1 2", "RNG cost 2"), "line 14, column 11: \"2\": the row is of type N and has no range".to_owned()),
        (with("ENDATA\n", ""), "line 16, column 2: \"UP BND x 3\": the file stops without its end (expected ENDATA as the last line; was the file cut off?)".to_owned()),
    ] {
        assert_eq!(message(&text, MPS), expected, "{text}");
    }
}

#[test]
fn limits_are_kept_and_named() {
    let limits = ModelLimits { rows: 3, columns: 1, entries: 3, line: 60, ..ModelLimits::default() };
    let refused = |limits: ModelLimits| {
        let error = read_model(PLAIN, MPS, &limits).unwrap_err();
        (error.to_string(), error.limit().map(Limit::name))
    };
    for (limits, message, flag) in [
        (limits, "line 6, column 4: \"r3\": there are more than 3 rows (the limit)", "rows"),
        (
            ModelLimits { rows: 4, ..limits },
            "line 10, column 2: \"y\": there are more than 1 columns (the limit)",
            "columns",
        ),
        (
            ModelLimits { rows: 4, columns: 2, ..limits },
            "line 10, column 4: \"cost\": there are more than 3 coefficients (the limit)",
            "elements",
        ),
        (
            ModelLimits { rows: 4, line: 10, ..limits },
            "line 8, column 2: \"x cost 1 r1 1\": the line is longer than 10 bytes (the limit)",
            "line",
        ),
    ] {
        assert_eq!(refused(limits), (message.to_owned(), Some(flag)));
    }
}
