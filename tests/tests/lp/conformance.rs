//! The table of `bench-solvers`: a row for each case, a column for each solver.

use boundfit_tests::conformance::conformance_table;
use boundfit_tests::lp_cases::hard_cases;
use boundfit_tests::program::root;

#[test]
fn the_conformance_table_has_a_row_per_case() {
    let table = conformance_table(&root().join("fixtures/hard-lp"));
    let lines: Vec<&str> = table.lines().collect();
    let names: Vec<String> = hard_cases().into_iter().map(|case| case.name).collect();
    assert_eq!(lines.len(), names.len() + 3, "{}", table);
    let sources = boundfit_check::source_names().len();
    assert!(lines[0].starts_with("| case | microlp 0.7 | clarabel 0.11 |"), "{}", lines[0]);
    assert!(lines[0].ends_with("| exact-simplex |") && lines[1].starts_with("|---|"));
    let mut right = vec![0; sources];
    for (line, name) in lines[2..].iter().zip(&names) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        assert_eq!((cells[0], cells.len()), (format!("`{name}`").as_str(), sources + 1), "{line}");
        assert_eq!(cells[sources], "exact", "{line}");
        for (count, cell) in right.iter_mut().zip(&cells[1..]) {
            let verdict = cell.split(" (").next().unwrap();
            *count += usize::from(["exact", "rounded", "within tolerance", "no answer"].contains(&verdict));
        }
    }
    let totals: Vec<String> = right.iter().map(|count| format!("{count} of 12")).collect();
    assert_eq!(*lines.last().unwrap(), format!("| not refuted | {} |", totals.join(" | ")));
    assert_eq!(totals[sources - 1], "12 of 12");
}

const BEST: &str =
    "ROWS\n N cost\n G need\nCOLUMNS\n x cost 1 need 1\n y cost 2 need 1\nRHS\n RHS need 3\nENDATA\n";

#[test]
fn fits_and_linear_programs_may_be_in_one_folder() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("best.mps", BEST);
    write("empty.mps", &BEST.replace("ENDATA", "RANGES\n R need 1\nBOUNDS\n FX B x 9\nENDATA"));
    write("fit.csv", "x,y\n1,1\n2,2\n3,3\n");
    write("fit.json", r#"{"eps": "1"}"#);
    write("open.mps", &BEST.replace("ROWS", "OBJSENSE MAX\nROWS"));
    let table = conformance_table(folder.path());
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("| case | microlp 0.7 | clarabel 0.11 |"), "{table}");
    assert!(lines[0].ends_with("| exact-simplex |"), "{table}");
    assert_eq!(lines.len(), 7, "{table}");
    for (line, name) in lines[2..6].iter().zip(["best", "empty", "fit", "open"]) {
        let microlp = line.split(" | ").nth(1).unwrap();
        assert!(line.starts_with(&format!("| `{name}` | ")) && line.ends_with(" | exact |"), "{line}");
        assert!(["exact", "rounded", "within tolerance"].contains(&microlp), "{line}");
    }
    assert!(
        lines[6].starts_with("| not refuted | 4 of 4 | ") && lines[6].ends_with(" | 4 of 4 |"),
        "{table}"
    );
}
