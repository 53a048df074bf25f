//! `boundfit judge`: the exact answer to the model of a file, in every form in which it is written.

use boundfit_tests::cli::schema::{JUDGE, check_schema};
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, printed, printed_with_input};
use boundfit_tests::program::root;
use serde_json::{Value, json};

/// Two foods: the least that 3·x + 2·y costs, with x + y ≥ 4, x + 3·y ≥ 6 and x ≤ 3.
const DIET: &str = "\
NAME diet
ROWS
 N cost
 G energy
 G protein
COLUMNS
 bread cost 3 energy 1
 bread protein 1
 beans cost 2 energy 1
 beans protein 3
RHS
 RHS energy 4 protein 6
BOUNDS
 UP BND bread 3
ENDATA
";

fn json_of(line: &str, input: &str) -> (i32, Value) {
    let run = boundfit_with_input(&root(), &format!("{line} --format json"), input.as_bytes());
    assert_eq!(run.stderr, "");
    let report = serde_json::from_str(&run.stdout).unwrap();
    check_schema(&report, JUDGE);
    (run.status, report)
}

fn exact(value: &Value) -> Value {
    match value {
        Value::Array(values) => values.iter().map(exact).collect(),
        Value::Null => Value::Null,
        number => number["exact"].clone(),
    }
}

#[test]
fn an_optimum_has_prices_basis_and_proof() {
    let expected = "\
Linear program of standard input: minimize cost, 2 rows, 2 columns

Optimal: cost = 8, at one point
  column  value  reduced cost  basis
  bread   0      1             lower
  beans   4      0             basic

  row      value  dual  basis
  energy   4      2     lower
  protein  12     0     basic

  Proof: 2 * (energy lower) + 1 * (bread lower) gives cost >= 8.

Feasible set: unbounded-polygon with 2 vertices
  vertex  bread  beans  active
  1       0      4      energy lower, bread lower
  2       3      1      energy lower, protein lower, bread upper
  goes on for ever in direction (0, 1)
";
    assert_eq!(printed_with_input(&root(), "judge -", DIET.as_bytes()), expected);
}

#[test]
fn each_limit_names_the_option_that_raises_it() {
    for (option, count) in [("rows", 3), ("columns", 2), ("elements", 6)] {
        // Rows of type N count, too.
        let run =
            boundfit_with_input(&root(), &format!("judge - --limit {option}={}", count - 1), DIET.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{option}");
        assert!(
            run.stderr.contains(&format!("(the limit); --limit {option}=N raises it")),
            "{option}\n{}",
            run.stderr
        );
        printed_with_input(&root(), &format!("judge - --limit {option}={count}"), DIET.as_bytes());
    }
}

#[test]
fn the_report_for_programs_has_the_whole_answer() {
    let (status, report) = json_of("judge -", DIET);
    assert_eq!(
        (status, &report["schema"], &report["status"]),
        (0, &json!("boundfit/judge/1"), &json!("optimal"))
    );
    assert_eq!(exact(&report["objective"]), json!("8"));
    assert_eq!(exact(&report["face"]["vertices"]), json!([["0", "4"]]));
    let columns = report["columns"].as_array().unwrap();
    assert_eq!(exact(&columns[0]["reduced_cost"]), json!("1"));
    assert_eq!((&columns[0]["basis"], &columns[1]["basis"]), (&json!("lower"), &json!("basic")));
    assert_eq!(exact(&report["rows"][0]["dual"]), json!("2"));
    assert_eq!(report["plane"]["columns"], json!(["bread", "beans"]));
    let corner = json!({"row": "energy", "column": null, "side": "lower"});
    assert_eq!(report["plane"]["region"]["vertices"][0]["active"][0], corner);
    assert_eq!(report["input"]["file"], Value::Null);
}

#[test]
fn an_infeasible_program_ends_with_the_status_of_an_empty_set() {
    let infeasible = DIET.replace("UP BND bread 3", "UP BND bread 3\n UP BND beans 0.5");
    let run = boundfit_with_input(&root(), "judge -", infeasible.as_bytes());
    let expected = "Infeasible: no point fulfils all rows and bounds\n  Proof: 1 * (energy lower) + 1 * (bread upper) + 1 * (beans upper) gives 0 <= -0.5.\n";
    let report: Vec<&str> = run.stdout.split("\n\n").collect();
    assert_eq!((run.status, run.stderr.as_str(), unbroken(report[1])), (3, "", unbroken(expected)));
    let (status, report) = json_of("judge -", &infeasible);
    assert_eq!((status, &report["status"], &report["objective"]), (3, &json!("infeasible"), &Value::Null));
    let terms = report["farkas"].as_array().unwrap();
    let term = |row: &str| terms.iter().find(|term| term["row"] == row || term["column"] == row).unwrap();
    for (name, side) in [("energy", "lower"), ("bread", "upper"), ("beans", "upper")] {
        assert_eq!((exact(&term(name)["multiplier"]), &term(name)["side"]), (json!("1"), &json!(side)));
    }
}

fn unbroken(text: &str) -> String {
    boundfit_tests::cli::unbroken(text)
}

#[test]
fn an_unbounded_program_has_a_point_and_a_ray() {
    let unbounded = DIET.replace("beans cost 2", "beans cost -2");
    let report = printed_with_input(&root(), "judge -", unbounded.as_bytes());
    let expected = "\
Unbounded: cost improves for ever
  column  feasible point  direction
  bread   0               0
  beans   4               1

  Proof: from this feasible point each step in the direction stays feasible and
  adds -2 to cost.
";
    assert!(report.contains(expected), "{report}");
    let (status, report) = json_of("judge -", &unbounded);
    assert_eq!((status, &report["status"]), (0, &json!("unbounded")));
    assert_eq!((exact(&report["point"]), exact(&report["ray"])), (json!(["0", "4"]), json!(["0", "1"])));
}

#[test]
fn the_feasible_set_goes_to_other_programs() {
    let ine = printed_with_input(&root(), "judge - --format ine", DIET.as_bytes());
    let region = printed_with_input(&root(), "polygon - --format ext", ine.as_bytes());
    assert_eq!(region, printed_with_input(&root(), "judge - --format ext", DIET.as_bytes()));
    assert!(region.contains("\n1 0 4\n"), "{region}");
}

#[test]
fn markup_has_the_tables_of_the_report() {
    let markdown = printed_with_input(&root(), "judge - --format markdown", DIET.as_bytes());
    assert!(markdown.contains("| bread | 0 | 1 | lower |"), "{markdown}");
    let latex = printed_with_input(&root(), "judge - --format latex", DIET.as_bytes());
    assert!(latex.contains("\\toprule") && latex.contains("bread & "), "{latex}");
}

#[test]
fn a_packed_model_is_the_model() {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    std::io::Write::write_all(&mut encoder, DIET.as_bytes()).unwrap();
    let directory =
        directory_with(&[("diet.mps.gz", &encoder.finish().unwrap()), ("diet.mps", DIET.as_bytes())]);
    let [packed, plain] =
        ["diet.mps.gz", "diet.mps"].map(|file| printed(directory.path(), &format!("judge {file}")));
    assert_eq!(packed.replace("diet.mps.gz", "diet.mps"), plain);
}

#[test]
fn what_cannot_be_answered_is_refused_with_a_reason() {
    let wide = DIET
        .replace(" beans protein 3\n", " beans protein 3\n rice cost 1 energy 2\n oats cost 1 energy 2\n");
    let run = boundfit_with_input(&root(), "judge -", wide.as_bytes());
    let expected = "error: standard input: 4 columns are not fixed by their bounds, first bread, beans and rice (expected at \
                    most two)\n";
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (1, "", expected));
    let directory =
        directory_with(&[("diet.mps", DIET.as_bytes()), ("broken.mps", b"ROWS\n N cost\n Q energy\n")]);
    let run = boundfit(directory.path(), "judge broken.mps");
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.starts_with("error: broken.mps: "), "{}", run.stderr);
    // A table of readings is for another command.
    let run = boundfit_with_input(&root(), "judge -", b"x,y\n1,2\n");
    let expected = "error: standard input: no linear program; 'boundfit fit' fits the readings of a table; MPS and LP are the formats of \
                    linear programs\n";
    assert_eq!((run.status, run.stderr.as_str()), (1, expected));
    let run = boundfit(directory.path(), "judge diet.mps --plot a.svg -o a.svg");
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.starts_with("error: '--plot' and '--output' name the same file\n"), "{}", run.stderr);
}

#[test]
fn a_picture_shows_set_and_optimum() {
    let directory = directory_with(&[("diet.mps", DIET.as_bytes())]);
    let report = printed(directory.path(), "judge diet.mps --plot diet.svg");
    assert_eq!(report, printed(directory.path(), "judge diet.mps"));
    let svg = std::fs::read_to_string(directory.path().join("diet.svg")).unwrap();
    let description = "<desc>Linear program of diet.mps, feasible set: unbounded-polygon. Horizontal axis: bread. Vertical axis: \
                       beans. One point is optimal.</desc>";
    assert!(svg.contains(description), "{}", svg.chars().take(600).collect::<String>());
    printed(directory.path(), "judge diet.mps --plot diet.png");
    assert!(std::fs::read(directory.path().join("diet.png")).unwrap().starts_with(b"\x89PNG"));
    let fixed = DIET.replace("UP BND bread 3", "FX BND bread 3");
    for (model, line, status, problem) in [
        (
            DIET,
            "--plot a.gif",
            2,
            "a picture is SVG, PNG, PDF or TikZ (expected a name that ends in .svg, .png, .pdf, .tikz or .tex)",
        ),
        (DIET, "--plot a.svg -o a.svg", 2, "'--plot' and '--output' name the same file"),
        (
            "min x\nst\n c1: x >= 1\nend\n",
            "--plot a.svg",
            1,
            "'--plot' draws two columns, and this model has one",
        ),
        ("/* Objective */\nmax: x;\nx <= 4;\n", "", 1, "this is lp_solve's own LP format"),
        (
            "min 2*x\nst\n x >= 1\nend\n",
            "",
            1,
            "LP format has * in quadratic terms alone (expected a blank, as in 3 x)",
        ),
        (&fixed, "--plot a.svg", 1, "'--plot' draws two columns, and bounds fix all but one of this model"),
    ] {
        let run = boundfit_with_input(directory.path(), &format!("judge - {line}"), model.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{line}");
        assert!(run.stderr.contains(problem), "{}", run.stderr);
        assert!(!directory.path().join("a.svg").exists());
    }
    let infeasible = DIET.replace("UP BND bread 3", "UP BND bread 3\n UP BND beans 0.5");
    let run = boundfit_with_input(directory.path(), "judge - --plot a.tikz", infeasible.as_bytes());
    assert_eq!(run.status, 3, "{}", run.stderr);
    assert!(run.stdout.contains("Infeasible: no point fulfils all rows and bounds"), "{}", run.stdout);
    let tikz = std::fs::read_to_string(directory.path().join("a.tikz")).unwrap();
    assert!(tikz.contains("allowed by beans ≤ 0.5") && tikz.contains("No point is feasible."), "{tikz}");
}
