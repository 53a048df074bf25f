//! `boundfit polygon`: both file formats, all kinds of region, and every proof recomputed from the file alone.

mod representations;

use std::collections::BTreeSet;

use boundfit_tests::program::root;
use serde_json::{Value, json};

use boundfit_tests::cli::half_plane_files::{h_representation, shape, system, with_rows};
use boundfit_tests::cli::numbers::{check_numbers, exact, pair, rational, whole};
use boundfit_tests::cli::regions::check_region;
use boundfit_tests::cli::schema::{POLYGON, check_schema};
use boundfit_tests::cli::{
    boundfit, boundfit_with_input, directory_with, fixture, printed, printed_with_input, report,
};

/// A table of half-planes, which of its rows are equations, and the kind of its region.
struct Case {
    kind: &'static str,
    csv: String,
    equations: &'static [usize],
}

fn case(kind: &'static str, rows: &str, equations: &'static [usize]) -> Case {
    Case { kind, csv: format!("a1,a2,b\n{}\n", rows.replace(' ', "\n")), equations }
}

/// Every kind of region, some in several ways.
fn cases() -> Vec<Case> {
    vec![
        Case { kind: "polygon", csv: fixture("polygon/house.csv"), equations: &[] },
        Case { kind: "empty", csv: fixture("polygon/empty.csv"), equations: &[] },
        case("polygon", "-1,0,1/3 0,-1,1/7 2,3,0.6", &[]),
        case("empty", "0,0,-1 1,0,1", &[]),
        case("empty", "1,0,1 1,0,2", &[1, 2]),
        case("point", "1,2,3 2,1,3", &[1, 2]),
        case("point", "1,0,0 -1,0,0 0,1,0 0,-1,0 1,1,0", &[]),
        case("segment", "1,1,2 -1,0,0 0,-1,0 2,2,4 1,0,5", &[1, 4]),
        case("segment", "-3,0,1 0,-1,0 0,1,1/3", &[1]),
        case("ray", "1,-1,0 -1,0,1", &[1]),
        case("line", "3,-6,1", &[1]),
        case("line", "0,1,5 0,-1,-5 0,2,11", &[]),
        case("unbounded-polygon", "-1,0,0 0,-1,0 -1,-1,-1", &[]),
        case("unbounded-polygon", "-1,0,0 1,0,2 0,-1,0 -1,-1,-1", &[]),
        case("strip", "1,2,3 -1,-2,1/2 2,4,9", &[]),
        case("half-plane", "-2,4,1 -1,2,1 0,0,0", &[]),
        case("plane", "0,0,0 0,0,7", &[]),
    ]
}

/// Runs every case and hands it to a check with the report on its H-representation.
fn for_each_region(check: impl Fn(&Case, &Value)) {
    for case in cases() {
        println!("{} {:?}", case.kind, case.csv);
        check(&case, &answer(&h_representation(&case.csv, case.equations)));
    }
}

/// The report on half-planes from standard input.
fn answer(input: &str) -> Value {
    report(&root(), "polygon -", input.as_bytes())
}

#[test]
fn every_kind_of_region_is_reached() {
    for_each_region(|case, report| {
        check_schema(report, POLYGON);
        assert_eq!(report["schema"], "boundfit/polygon/2");
        assert_eq!(report["region"]["kind"], case.kind);
        assert_eq!(report["input"]["rows"], case.csv.lines().count() - 1);
        assert!(case.kind == "plane" || check_numbers(report, 5) > 0);
    });
    let kinds: BTreeSet<&str> = cases().iter().map(|case| case.kind).collect();
    assert_eq!(kinds.len(), 10, "{kinds:?}");
}

#[test]
fn the_region_and_its_proofs_follow_from_the_file() {
    for_each_region(|case, report| {
        let system = system(&case.csv, case.equations);
        check_region(&report["region"], &system);
        if case.kind == "empty" {
            assert!(report["bounds"].is_null());
        } else {
            system.check_bounds(&report["bounds"], &report["region"]);
        }
    });
}

/// The region stays the same without the redundant rows, and changes without any other row as well.
#[test]
fn the_redundant_rows_are_those_that_can_be_left_out_together() {
    for_each_region(|case, report| {
        let redundant = report["redundant"].as_array().unwrap();
        let region_of = |keep: &dyn Fn(usize) -> bool| {
            let rows: Vec<usize> = (1..case.csv.lines().count()).filter(|row| keep(*row)).collect();
            let is_equation = |position: &usize| case.equations.contains(&rows[*position - 1]);
            let equations: Vec<usize> = (1..=rows.len()).filter(is_equation).collect();
            shape(&answer(&h_representation(&with_rows(&case.csv, keep), &equations))["region"])
        };
        let needed = |row: usize| !redundant.contains(&json!(row));
        assert_eq!(region_of(&needed), shape(&report["region"]));
        for left_out in (1..case.csv.lines().count()).filter(|row| needed(*row)) {
            let region = region_of(&|row| needed(row) && row != left_out);
            assert_ne!(region, shape(&report["region"]), "without row {left_out}");
        }
    });
}

fn without_file(mut report: Value) -> Value {
    report["input"]["sha256"].take();
    report["input"]["file"].take();
    report["input"]["table"].take();
    report
}

#[test]
fn both_formats_give_the_same_answer() {
    let directory = root();
    let table = without_file(report(&directory, "polygon fixtures/polygon/house.csv", b""));
    for file in ["house.ine", "house-with-comments.ine"] {
        let other = without_file(report(&directory, &format!("polygon fixtures/polygon/{file}"), b""));
        assert_eq!(other, table, "{file}");
    }
    for case in cases().iter().filter(|case| case.equations.is_empty()) {
        let matrix = without_file(answer(&h_representation(&case.csv, &[])));
        assert_eq!(matrix, without_file(answer(&case.csv)), "{}", case.csv);
    }
}

#[test]
fn the_format_follows_from_the_name_or_else_from_the_contents() {
    let (table, matrix) = (fixture("polygon/house.csv"), fixture("polygon/house.ine"));
    let (table, matrix) = (table.as_bytes(), matrix.as_bytes());
    let directory = directory_with(&[
        ("table.csv", table),
        ("table.txt", table),
        ("table", table),
        ("matrix.ine", matrix),
        ("matrix.INE", matrix),
        ("matrix.txt", matrix),
        ("matrix", matrix),
    ]);
    for (name, bytes) in [("table", table), ("matrix", matrix)] {
        let expected = printed_with_input(directory.path(), "polygon - --format json", bytes);
        for suffix in [".csv", ".ine", ".INE", ".txt", ""] {
            let file = format!("{name}{suffix}");
            if directory.path().join(&file).exists() {
                let line = format!("polygon {file} --format json");
                let named = format!("\"file\": {file:?}");
                let unnamed = printed(directory.path(), &line).replacen(&named, "\"file\": null", 1);
                assert_eq!(unnamed, expected, "{file}");
            }
        }
    }
    let wrong = directory_with(&[("matrix.csv", matrix), ("table.ine", table)]);
    assert_eq!(boundfit(wrong.path(), "polygon matrix.csv").status, 1);
    assert_eq!(boundfit(wrong.path(), "polygon table.ine").status, 1);
}

#[test]
fn the_number_types_of_an_h_representation_mean_the_same_numbers() {
    let matrix = |kind: &str, half: &str| format!("begin\n3 3 {kind}\n{half} 1 0\n1 0 1\n1 -1 -1\nend\n");
    let region = |kind: &str, half: &str| answer(&matrix(kind, half))["region"].clone();
    let expected = region("rational", "1/2");
    assert_eq!(expected["vertices"][0]["theta"][0]["exact"], "-1/2");
    for (kind, half) in [("real", "0.5"), ("real", "5e-1"), ("real", ".5"), ("rational", "2/4")] {
        assert_eq!(region(kind, half), expected, "{kind} {half}");
    }
    let whole = region("integer", "3");
    assert_eq!(whole, region("rational", "3/1"));
    assert_eq!(whole, region("real", "3.00"));
}

#[test]
fn columns_are_found_by_name_or_without_a_header_by_place() {
    let named = without_file(answer("a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n"));
    for table in [
        "-1,0,0\n0,-1,0\n2,3,6\n",
        "b,a2,a1\n0,0,-1\n0,-1,0\n6,3,2\n",
        "name;b;a1;a2\nleft;0;-1;0\nbelow;0;0;-1\n'roof, right';6;2;3\n",
        "a1\ta2\tb\n-1\t0\t0\n0\t-1\t0\n2\t3\t6\n",
        "\u{feff}a1,a2,b\r\n-1,0,0\r\n\r\n0,-1,0\r\n2,3,6",
    ] {
        assert_eq!(without_file(answer(table)), named, "{table:?}");
    }
}

#[test]
fn columns_beside_a_half_plane_do_not_make_it_another_one() {
    let relation = |place: &str| {
        format!(
            "error: standard input: {place}: a relation, and every row means a1*theta1 + a2*theta2 <= b (expected no such \
             column: change all signs of a row with >=, and write a row with = both ways)\n"
        )
    };
    let beside = |place: &str| {
        format!(
            "error: standard input: {place}: a cell beside a1, a2 and b in a table without a header (expected 3 columns, or \
             a header with the names a1, a2 and b: other columns are then ignored)\n"
        )
    };
    for (table, message) in [
        ("a1,a2,rel,b\n1,0,>=,0\n0,1,>=,0\n2,3,<=,6\n", relation("line 2, column 3 (rel): \">=\"")),
        ("a1,a2,b,rel\n1,0,0,\n0,1,0,=\n2,3,6,\n", relation("line 3, column 4 (rel): \"=\"")),
        ("a1,a2,b,sense\n1,0,1,L\n0,1,1,G\n", relation("line 2, column 4 (sense): \"L\"")),
        ("a1,a2,b,w\n1,0,1,le\n0,1,1,ge\n", relation("line 2, column 4 (w): \"le\"")),
        ("[{\"a1\": 1, \"a2\": 0, \"Sense\": \"G\", \"b\": 0}]", relation("line 1, column 3 (Sense): \"G\"")),
        ("1,0,\u{2264},5\n0,1,\u{2264},5\n", relation("line 1, column 3: \"\u{2264}\"")),
        ("1,0,0,5\n0,1,0,5\n", beside("line 1, column 4: \"5\"")),
        ("[{\"a1\": 1, \"a2\": 0, \"rel\": \"<\", \"b\": 0}]", relation("line 1, column 3 (rel): \"<\"")),
    ] {
        let run = boundfit_with_input(&root(), "polygon -", table.as_bytes());
        assert_eq!((run.status, run.stdout.as_str(), run.stderr), (1, "", message), "{table:?}");
    }
    let plain = without_file(answer("a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n"));
    let labels = without_file(answer("a1,a2,b,corner\n-1,0,0,E\n0,-1,0,G\n2,3,6,L\n"));
    assert_eq!(labels["region"], plain["region"]);
    let others = without_file(answer("a1,a2,b,w\n-1,0,0,>= 1\n0,-1,0,5\n2,3,6,\n"));
    assert_eq!(others["region"], plain["region"]);
}

#[test]
fn equations_of_an_h_representation_are_redundant_like_other_rows() {
    let report = report(&root(), "polygon fixtures/polygon/segment.ine", b"");
    let segment = &report["region"];
    assert_eq!((&segment["kind"], &report["redundant"]), (&json!("segment"), &json!([4, 5])));
    let ends = [0, 1].map(|end| &segment["vertices"][end]);
    assert_eq!(ends.map(|end| pair(&end["theta"])), [[whole(0), whole(2)], [whole(2), whole(0)]]);
    assert_eq!(ends.map(|end| &end["active"]), [&json!([1, 2, 4]), &json!([1, 3, 4])]);
}

#[test]
fn an_equation_is_one_row_that_proves_both_ways() {
    let report = answer("linearity 1 1\nbegin\n2 3 integer\n-3 2 0\n0 0 1\nend\n");
    let ray = &report["region"];
    assert_eq!(ray["kind"], "ray");
    assert_eq!(ray["vertices"][0]["active"], json!([1, 2]));
    assert_eq!(pair(&ray["vertices"][0]["theta"]), [rational("3/2"), whole(0)]);
    assert_eq!(report["redundant"], json!([]));
    let [lower, upper] = ["lower", "upper"].map(|end| &report["bounds"][0][end]);
    assert_eq!((exact(lower), exact(upper)), (rational("3/2"), rational("3/2")));
    let half = json!({"exact": "1/2", "decimal": "0.5", "value": 0.5});
    assert_eq!(lower["active"], json!([{"row": 1, "bound": "upper", "multiplier": half}]));
    assert_eq!(upper["active"], json!([{"row": 1, "bound": "lower", "multiplier": half}]));
    // The older word for the same thing.
    let older = answer("equality 1 1\nbegin\n2 3 integer\n-3 2 0\n0 0 1\nend\n");
    assert_eq!(without_file(older), without_file(report));
}

#[test]
fn the_format_of_a_table_of_half_planes_is_said() {
    let table = b"a1;a2;b\n1;0;60,323\n0;1;83,200\n";
    let text = printed_with_input(&root(), "polygon -", table);
    let start = "Half-planes of standard input, 2 rows\n  table     decimal comma, separated by semicolons\n\nRegion: ";
    assert!(text.starts_with(start), "{text}");
    let json = report(&root(), "polygon -", table);
    let [delimiter, decimal, open] =
        ["delimiter", "decimal", "decimal_open"].map(|key| &json["input"]["table"][key]);
    assert_eq!([delimiter, decimal, open], [&json!("semicolon"), &json!("comma"), &json!(true)]);
    let run = boundfit_with_input(&root(), "polygon - --format ine", table);
    assert_eq!(run.stderr, "note: standard input: decimal comma, separated by semicolons\n");
    let matrix = answer("begin\n1 3 integer\n1 -1 0\nend\n");
    assert_eq!(matrix["input"]["table"], serde_json::Value::Null);
}

#[test]
fn the_text_says_why_rows_are_redundant() {
    let text = printed(&root(), "polygon fixtures/polygon/house.csv");
    let (_, why) = text.split_once("Redundant rows:").unwrap();
    let expected = " 6, 7, 8, 9\n\
        \x20 row  why\n\
        \x20 6    the same half-plane as row 2\n\
        \x20 7    touches the region; implied by 1/2 * (row 4) + 1/2 * (row 5)\n\
        \x20 8    implied by 1/2 * (row 4) + 1/2 * (row 5) with 1 to spare\n\
        \x20 9    holds everywhere\n";
    assert_eq!(why, expected);
    let text = printed_with_input(&root(), "polygon -", b"a1,a2,b\n1,0,1\n");
    assert!(text.ends_with("\nNo row is redundant.\n"), "{text}");
}

/// The first of equal half-planes is irredundant, but an equation behind it says the same.
#[test]
fn a_row_is_redundant_that_an_equation_behind_it_has_too() {
    let polygon = |rows: &str| {
        let count = rows.lines().count();
        let file = format!("H-representation\nlinearity 1 2\nbegin\n{count} 3 rational\n{rows}end\n");
        printed_with_input(&root(), "polygon -", file.as_bytes())
    };
    let text = polygon("0 0 1\n0 0 2\n");
    assert!(
        text.ends_with("\nRedundant rows: 1\n  row  why\n  1    the same half-plane as row 2\n"),
        "{text}"
    );
    // Without the third row the set is larger, without the first it is not.
    let text = polygon("1 -1 0\n1 -1 0\n0 0 1\n");
    assert!(
        text.ends_with("\nRedundant rows: 1\n  row  why\n  1    the same half-plane as row 2\n"),
        "{text}"
    );
}

#[test]
fn the_text_lists_vertices_and_ranges() {
    let text = printed(&root(), "polygon fixtures/polygon/house.ine");
    let (region, rest) = text.split_once("\n\n").unwrap().1.split_once("\n\n").unwrap();
    let expected = "Region: polygon with 5 vertices\n\
        \x20 vertex  theta1  theta2  active\n\
        \x20 1       0       0       1, 3\n\
        \x20 2       4       0       2, 3, 6\n\
        \x20 3       4       2       2, 5, 6\n\
        \x20 4       2       4       4, 5, 7\n\
        \x20 5       0       2       1, 4";
    assert_eq!(region, expected);
    assert!(rest.starts_with("          range\n  theta1  [0, 4]\n  theta2  [0, 4]\n"), "{rest}");
}

#[test]
fn an_empty_region_is_an_answer_of_its_own_status() {
    let run = boundfit(&root(), "polygon fixtures/polygon/empty.csv");
    assert_eq!((run.status, run.stderr.as_str()), (3, ""));
    let (_, region) = run.stdout.split_once("\n\n").unwrap();
    let expected = "Region: empty\n\
        \x20 Proof: 1 * (row 1) + 1 * (row 2) + 1 * (row 3) gives 0 <= -1.\n\
        \n\
        Redundant rows: 4\n\
        \x20 row  why\n\
        \x20 4    the region is empty without it\n";
    assert_eq!(region, expected);
    let report = report(&root(), "polygon fixtures/polygon/empty.csv", b"");
    let one = json!({"exact": "1", "decimal": "1", "value": 1.0});
    let term = |row: usize| json!({"row": row, "bound": "upper", "multiplier": one});
    assert_eq!(report["region"]["certificate"], json!({"farkas": [term(1), term(2), term(3)]}));
    assert_eq!(report["redundant"], json!([4]));
}

#[test]
fn binary64_takes_the_number_that_a_float_program_would_receive() {
    let table = b"a1,a2,b\n1,0,0.1\n";
    let vertex = |reading: &str| {
        let line = format!("polygon - --format json --reading {reading}");
        let report: Value = serde_json::from_str(&boundfit_with_input(&root(), &line, table).stdout).unwrap();
        (report["input"]["reading"].clone(), exact(&report["bounds"][0]["upper"]))
    };
    assert_eq!(vertex("decimal"), (json!("decimal"), rational("1/10")));
    assert_eq!(vertex("binary64"), (json!("binary64"), rational("3602879701896397/36028797018963968")));
}

#[test]
fn no_row_at_all_leaves_the_plane() {
    assert_eq!(answer("begin\n0 3 integer\nend\n")["region"]["kind"], "plane");
}

#[test]
fn the_limit_on_rows_can_be_set() {
    let matrix = b"begin\n3 3 integer\n0 1 0\n0 0 1\n1 -1 -1\nend\n";
    let run = boundfit_with_input(&root(), "polygon - --limit rows=2", matrix);
    let message = "error: standard input: line 2, column 1: \"3\": there are more than 2 rows (the limit); --limit rows=N raises it\n";
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (1, "", message));
    printed_with_input(&root(), "polygon - --limit rows=3", matrix);
}

#[test]
fn pictures_show_every_kind_of_set() {
    let mut kinds = BTreeSet::new();
    for Case { kind, csv, equations } in cases().into_iter().filter(|case| case.kind != "empty") {
        let csv = h_representation(&csv, equations);
        let directory = directory_with(&[("set.ine", csv.as_bytes())]);
        let report = printed(directory.path(), "polygon set.ine --plot set.svg");
        assert_eq!(report, printed(directory.path(), "polygon set.ine"), "{csv}");
        let svg = std::fs::read_to_string(directory.path().join("set.svg")).unwrap();
        let description =
            format!("<desc>Set of set.ine, set: {kind}. Horizontal axis: θ₁. Vertical axis: θ₂.");
        assert!(svg.contains(&description), "{csv}: {}", svg.chars().take(400).collect::<String>());
        let is_bounded = ["point", "segment", "polygon"].contains(&kind);
        assert_eq!(svg.contains("without end.") || svg.contains("Every point"), !is_bounded, "{csv}");
        kinds.insert(kind);
    }
    assert_eq!(kinds.len(), 9, "{kinds:?}");
}

#[test]
fn the_picture_of_an_empty_set_shows_what_contradicts() {
    for (csv, shown) in [
        ("a1,a2,b\n1,0,0\n0,1,9\n-1,0,-1\n", &["allowed by θ₁ ≤ 0", "allowed by θ₁ ≥ 1"][..]),
        ("a1,a2,b\n-1,0,0\n0,-0.5,0\n2,3,-6\n", &["allowed by 0.5·θ₂ ≥ 0", "allowed by 2·θ₁ + 3·θ₂ ≤ −6"]),
        ("a1,a2,b\n1,1,3\n0,0,-1\n", &["0 ≤ −1 holds nowhere"]),
    ] {
        let directory = directory_with(&[]);
        let run = boundfit_with_input(directory.path(), "polygon - --plot a.tikz", csv.as_bytes());
        let plain = boundfit_with_input(directory.path(), "polygon -", csv.as_bytes());
        assert_eq!((run.status, run.stdout), (3, plain.stdout), "{csv}: {}", run.stderr);
        let tikz = std::fs::read_to_string(directory.path().join("a.tikz")).unwrap();
        let description =
            "set: empty. Horizontal axis: θ₁. Vertical axis: θ₂. No point is in all half-planes.\n";
        assert!(tikz.contains(description), "{csv}: {tikz}");
        for text in shown {
            assert!(tikz.contains(text), "{csv}: {text}");
        }
        assert!(!tikz.contains("allowed by θ₂ ≤ 9"), "{csv}: a half-plane that takes no part");
    }
}

#[test]
fn pictures_that_cannot_be_drawn_or_written_are_refused() {
    let directory = directory_with(&[]);
    let table = "a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n";
    for (csv, line, status, problem) in [
        (table, "--plot a.gif", 2, "expected a name that ends in .svg, .png, .pdf, .tikz or .tex"),
        (table, "--plot a.svg -o a.svg", 2, "'--plot' and '--output' name the same file"),
        (table, "--plot -", 2, "'--plot -' and the report would both go to standard output"),
    ] {
        let run = boundfit_with_input(directory.path(), &format!("polygon - {line}"), csv.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{line}");
        assert!(run.stderr.contains(problem), "{line}: {}", run.stderr);
        assert!(!directory.path().join("a.svg").exists());
    }
    let run = boundfit_with_input(directory.path(), "polygon - --plot - -o a.txt", table.as_bytes());
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(run.stdout.starts_with("<svg "), "{}", run.stdout);
}

#[test]
fn the_diameter_is_a_number_where_its_square_is_one_of_a_number() {
    for (rows, diameter) in [
        ("1,0,2 -1,0,0 0,1,0 0,-1,0", "2"),
        ("1,0,1 -1,0,0 0,1,4/3 0,-1,0", "1.6667"),
        ("1,0,3 -1,0,0 0,1,2 0,-1,0", "square root of 13"),
    ] {
        let csv = format!("a1,a2,b\n{}\n", rows.replace(' ', "\n"));
        let text = printed_with_input(&root(), "polygon -", csv.as_bytes());
        let (_, found) = text.split_once("\n  diameter  ").unwrap();
        assert_eq!(found.lines().next(), Some(diameter), "{text}");
    }
}
