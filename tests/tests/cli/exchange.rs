//! Vertices and tables for other programs: `--format csv`, `wkt`, `m`, `latex` and `markdown` for every kind of set.

use std::collections::BTreeMap;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_tests::program::{root, run_with_input};
use serde_json::Value;

use boundfit_tests::cli::{FIT_TRANSDUCER, boundfit, printed, report};

/// Half-planes a1, a2, b of each kind.
const KINDS: [(&str, &str); 10] = [
    ("empty", "1,0,0\n-1,0,-1\n"),
    ("point", "1,0,1\n-1,0,-1\n0,1,2\n0,-1,-2\n"),
    ("segment", "1,0,1\n-1,0,-1\n0,1,2\n0,-1,0\n"),
    ("ray", "1,0,1\n-1,0,-1\n0,-1,0\n"),
    ("line", "1,2,3\n-1,-2,-3\n"),
    ("polygon", "-1,0,0\n0,-1,0\n2,3,6\n"),
    ("unbounded-polygon", "-1,0,0\n0,-1,0\n"),
    ("strip", "1,2,3\n-1,-2,4\n"),
    ("half-plane", "1,2,3\n"),
    ("plane", "0,0,3\n"),
];

fn polygon(rows: &str, options: &[&str]) -> (i32, String, String) {
    let input = format!("a1,a2,b\n{rows}");
    let run = run_with_input(&[&["polygon", "-"][..], options].concat(), input.as_bytes());
    (run.status, run.stdout, run.stderr)
}

fn exact(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

#[test]
fn csv_has_generators_of_every_kind() {
    let expected = BTreeMap::from([
        ("empty", vec![]),
        ("point", vec!["vertex,1,2,1,2,1; 2; 3; 4"]),
        ("segment", vec!["vertex,1,0,1,0,1; 2; 4", "vertex,1,2,1,2,1; 2; 3"]),
        ("ray", vec!["vertex,1,0,1,0,1; 2; 3", "ray,0,1,0,1,"]),
        ("line", vec!["point,3/5,6/5,0.6,1.2,1; 2", "line,2,-1,2,-1,"]),
        ("polygon", vec!["vertex,0,0,0,0,1; 2", "vertex,3,0,3,0,2; 3", "vertex,0,2,0,2,1; 3"]),
        ("unbounded-polygon", vec!["vertex,0,0,0,0,1; 2", "ray,1,0,1,0,", "ray,0,1,0,1,"]),
        ("strip", vec!["point,3/5,6/5,0.6,1.2,1", "point,-4/5,-8/5,-0.8,-1.6,2", "line,2,-1,2,-1,"]),
        ("half-plane", vec!["point,3/5,6/5,0.6,1.2,1", "ray,-1,-2,-1,-2,", "line,2,-1,2,-1,"]),
        ("plane", vec!["point,0,0,0,0,", "line,1,0,1,0,", "line,0,1,0,1,"]),
    ]);
    for (kind, rows) in KINDS {
        let (status, text, error) = polygon(rows, &["--format", "csv"]);
        assert_eq!((status, error.as_str()), (if kind == "empty" { 3 } else { 0 }, ""), "{kind}");
        let (header, rows) = text.split_once('\n').unwrap();
        assert_eq!(header, "kind,theta1,theta2,theta1_decimal,theta2_decimal,active");
        assert_eq!(rows.lines().collect::<Vec<_>>(), expected[kind], "{kind}");
    }
}

#[test]
fn csv_of_a_fit_has_the_vertices_of_the_json() {
    let json = report(&root(), FIT_TRANSDUCER, b"");
    let csv = printed(&root(), &format!("{FIT_TRANSDUCER} --format csv --vertices"));
    let vertices = json["fps"]["vertices"].as_array().unwrap();
    assert_eq!(csv.lines().count(), vertices.len() + 1);
    for (line, vertex) in csv.lines().skip(1).zip(vertices) {
        let theta = |axis: usize, form: &str| vertex["theta"][axis][form].as_str().unwrap();
        let active: Vec<String> = vertex["active"]
            .as_array()
            .unwrap()
            .iter()
            .map(|active| format!("{} {}", active["row"], active["bound"].as_str().unwrap()))
            .collect();
        let expected = [
            "vertex",
            theta(0, "exact"),
            theta(1, "exact"),
            theta(0, "decimal"),
            theta(1, "decimal"),
            &active.join("; "),
        ];
        assert_eq!(line, expected.join(","));
    }
}

#[test]
fn wkt_says_bounded_sets_and_refuses_the_others() {
    let expected = BTreeMap::from([
        ("empty", "POLYGON EMPTY"),
        ("point", "POINT (1 2)"),
        ("segment", "LINESTRING (1 0, 1 2)"),
        ("polygon", "POLYGON ((0 0, 3 0, 0 2, 0 0))"),
    ]);
    for (kind, rows) in KINDS {
        let (status, text, error) = polygon(rows, &["--format", "wkt"]);
        match expected.get(kind) {
            Some(expected) => {
                assert_eq!((status, error.as_str()), (if kind == "empty" { 3 } else { 0 }, ""), "{kind}");
                assert_eq!(text, format!("{expected}\n"));
            }
            None => {
                let reason = "which well-known text cannot say (CSV, JSON, MATLAB and cdd's format can)";
                assert_eq!((status, text.as_str()), (1, ""), "{kind}");
                assert_eq!(
                    error,
                    format!("error: standard input: the set is unbounded ({kind}), {reason}\n")
                );
            }
        }
    }
}

#[test]
fn wkt_gets_the_digits_that_keep_the_shape() {
    // 10^-40 wide: with 17 digits all vertices would be on one line.
    let thin = "-1,0,-1\n0,-1,0\n0,1,1\n1,0,1.0000000000000000000000000000000000000001\n";
    let (status, text, _) = polygon(thin, &["--format", "wkt"]);
    assert_eq!(status, 0);
    let wide = "1.0000000000000000000000000000000000000001";
    assert_eq!(text, format!("POLYGON ((1 0, {wide} 0, {wide} 1, 1 1, 1 0))\n"));
    let third = "-1,0,0\n0,-1,0\n3,3,1\n";
    let digits = |options: &[&str]| polygon(third, &[&["--format", "wkt"][..], options].concat()).1;
    assert!(digits(&[]).contains(&format!("0.{} 0,", "3".repeat(17))));
    assert!(digits(&["--digits", "3"]).contains(&format!("0.{} 0,", "3".repeat(17))));
    assert!(digits(&["--digits", "30"]).contains(&format!("0.{} 0,", "3".repeat(30))));
}

#[test]
fn scripts_have_exact_texts_and_the_nearest_doubles() {
    for (kind, rows) in KINDS {
        let (status, text, error) = polygon(rows, &["--format", "m"]);
        assert_eq!((status, error.as_str()), (if kind == "empty" { 3 } else { 0 }, ""), "{kind}");
        assert!(text.contains(&format!("\nkind = '{kind}';\n")), "{text}");
        for name in ["theta", "points", "rays", "lines"] {
            let block = |start: &str, end: &str| -> Vec<String> {
                let rest = text.split_once(start).map_or("", |(_, rest)| rest);
                let block = rest.split_once(end).map_or("", |(block, _)| block);
                block.lines().flat_map(|line| line.split(", ")).map(|cell| cell.trim().to_owned()).collect()
            };
            let exacts = block(&format!("\n{name}_exact = {{\n"), "};\n");
            let doubles = block(&format!("\n{name} = [\n"), "];\n");
            assert_eq!(exacts.len(), doubles.len(), "{kind} {name}");
            for (text, double) in exacts.iter().zip(&doubles) {
                assert_eq!(double.parse::<f64>().unwrap(), exact(text.trim_matches('\'')).to_f64());
            }
            if exacts.is_empty() {
                assert!(text.contains(&format!("\n{name}_exact = cell(0, 2);\n{name} = zeros(0, 2);\n")));
            }
        }
    }
    let script = printed(&root(), &format!("{FIT_TRANSDUCER} --format m"));
    assert!(
        script.contains("  '21/11726', '2660919/117260000'\n") && script.contains("  '14 upper; 36 lower'\n")
    );
}

#[test]
fn documents_have_what_the_text_report_has() {
    let text = printed(&root(), &format!("{FIT_TRANSDUCER} --no-lp --sweep 0.75..0.9"));
    let markdown = printed(&root(), &format!("{FIT_TRANSDUCER} --sweep 0.75..0.9 --format markdown"));
    let plain = markdown.replace('\\', "");
    for word in text.split([' ', '\n']).filter(|word| word.contains(|digit: char| digit.is_ascii_digit())) {
        assert!(plain.contains(word), "{word}");
    }
    let latex = printed(&root(), &format!("{FIT_TRANSDUCER} --sweep 0.75..0.9 --format latex"));
    assert_eq!(latex.matches("\\begin{tabular}").count(), latex.matches("\\bottomrule").count());
    let without_formulas: String = latex.split('$').step_by(2).collect();
    assert_eq!(latex.matches('$').count() % 2, 0);
    assert!(!without_formulas.contains("theta") && !without_formulas.contains('^'));
    let exact = printed(&root(), &format!("{FIT_TRANSDUCER} --exact --format latex"));
    assert!(exact.contains("$21/11726$ & $2660919/117260000$"));
    for (kind, rows) in KINDS {
        for format in ["latex", "markdown"] {
            let (status, text, error) = polygon(rows, &["--format", format]);
            assert_eq!((status, error.as_str()), (if kind == "empty" { 3 } else { 0 }, ""), "{kind}");
            assert!(text.contains(&format!("Region: {kind}")), "{kind}");
        }
    }
}

#[test]
fn names_of_columns_are_escaped() {
    let directory = boundfit_tests::cli::directory_with(&[("t.csv", b"V_z & 5%|,z^2~#$\n1,2\n2,3\n3,4\n")]);
    let fit = "fit t.csv --x 1 --y 2 --eps 1";
    let latex = printed(directory.path(), &format!("{fit} --format latex"));
    let y = r"z\textasciicircum{}2\textasciitilde{}\#\$";
    let model =
        format!(r"model & {y}${{}} = \theta_1 \cdot {{}}$V\_z \& 5\%\textbar{{}}${{}} + \theta_2 + e$ \\");
    assert!(latex.contains(&model), "{latex}");
    let markdown = printed(directory.path(), &format!("{fit} --format markdown"));
    let model = r"| model | z^2\~\#\$ = theta1\*V\_z \& 5%\| + theta2 + e |";
    assert!(markdown.contains(model), "{markdown}");
}

#[test]
fn groups_are_written_as_text_json_or_csv_only() {
    for format in ["wkt", "m", "latex", "markdown"] {
        let line =
            format!("fit fixtures/fleet/levels.csv --by sensor --x V --y level --eps 1 --format {format}");
        let run = boundfit(&root(), &line);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{format}");
    }
    let json: Value = report(&root(), FIT_TRANSDUCER, b"");
    assert_eq!(json["input"]["reading"], "decimal");
}
