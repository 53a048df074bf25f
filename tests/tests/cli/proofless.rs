//! Tables that are unusual enough to ask whether a proof can be about them.

use boundfit_tests::cli::{boundfit, directory_with};

/// The header has no cell for the names of the rows, so that the checkers would number other columns.
#[test]
fn rows_with_names_of_their_own_have_no_proof() {
    let directory = directory_with(&[("named.csv", b"a,b,c\nr1,1,2,9\nr2,2,3,1\nr3,3,5,4\n")]);
    for proof in ["p.json", "p.v"] {
        let run = boundfit(directory.path(), &format!("fit named.csv --x a --y b --eps 1 --proof {proof}"));
        let is_refused = run.stderr.contains("the names of their rows have no cell in the header");
        assert!(is_refused || proof == "p.v", "{run:?}");
        let options = "--x b --y c --eps 1";
        let verified = boundfit(directory.path(), &format!("verify {proof} named.csv {options}"));
        assert_eq!(verified.status, 1, "{verified:?}");
    }
}

/// Spreadsheets write rows of empty cells behind the last reading. They are no readings, and the question is about all rows.
#[test]
fn rows_of_empty_cells_at_the_end_are_not_asked_for() {
    let end = [",\n,\n", " , \n", "\"\",\"\"\n\n,,,\n"];
    for end in end {
        let directory = directory_with(&[("a.csv", format!("x,y\n1,2\n2,3\n{end}").as_bytes())]);
        let options = "--x x --y y --eps 1";
        for proof in ["p.json", "p.v"] {
            let fit = boundfit(directory.path(), &format!("fit a.csv {options} --proof {proof}"));
            assert_eq!(fit.status, 0, "{fit:?}");
            let run = boundfit(directory.path(), &format!("verify {proof} a.csv {options}"));
            assert_eq!(run.status, 0, "{end:?} {run:?}");
            assert!(run.stdout.contains("rows    1 to 2 of 2\n"), "{}", run.stdout);
        }
    }
    // A row of empty cells between readings counts.
    let directory = directory_with(&[("a.csv", b"x,y\n1,2\n,\n2,3\n,\n")]);
    let options = "--x x --y y --eps 1";
    let fit = boundfit(directory.path(), &format!("fit a.csv {options} --missing skip --proof p.json"));
    assert_eq!(fit.status, 0, "{fit:?}");
    let run = boundfit(directory.path(), "verify p.json a.csv");
    assert!(run.stdout.contains("rows    1 and 3 of 3\n"), "{run:?}");
}

#[test]
fn the_reason_why_a_table_has_no_proof_is_its_own() {
    let blocks = "x,y\n1,2\n2,3\n\n\nx,y\n3,5\n4,5\n";
    for (table, options, reason) in [
        ("x,y,z\n1,2\n2,3\n3,5\n", "", "a row has fewer cells than the first one"),
        (blocks, "--block 2", "they are one of several blocks, or all of them"),
        (blocks, "--block all", "they are one of several blocks, or all of them"),
    ] {
        let directory = directory_with(&[("a.csv", table.as_bytes())]);
        let run =
            boundfit(directory.path(), &format!("fit a.csv --x x --y y --eps 1 {options} --proof p.json"));
        assert!(run.status != 0 && run.stderr.contains(reason), "{options}: {run:?}");
    }
}
