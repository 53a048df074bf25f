//! `boundfit outliers`: answers of every kind, formats and refusals.

use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit_with_input, directory_with, printed, printed_with_input, unbroken};
use boundfit_tests::program::root;
use serde_json::{Value, json};

const READ: &str = "outliers - --x x --y y";

/// The JSON report about rows on standard input.
fn report(line: &str, input: &str, status: i32) -> Value {
    let run = boundfit_with_input(&root(), &format!("{line} --format json"), input.as_bytes());
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{line}");
    serde_json::from_str(&run.stdout).unwrap()
}

/// The coordinates of the vertices of each piece.
fn corners(report: &Value) -> Vec<Vec<[String; 2]>> {
    let text = |number: &Value| number["exact"].as_str().unwrap().to_owned();
    let corner = |vertex: &Value| [text(&vertex["theta"][0]), text(&vertex["theta"][1])];
    let pieces = report["pieces"].as_array().unwrap().iter();
    pieces.map(|piece| piece.as_array().unwrap().iter().map(corner).collect()).collect()
}

fn owned(corners: &[[&str; 2]]) -> Vec<[String; 2]> {
    corners.iter().map(|corner| corner.map(ToOwned::to_owned)).collect()
}

#[test]
fn two_lines_through_three_points_each() {
    // Three points on y = x, three on y = 10 - x, one of them common to neither.
    let rows = "x,y\n0,0\n1,1\n2,2\n0,10\n1,9\n2,8\n";
    let report = report(&format!("{READ} --eps 0"), rows, 0);
    assert_eq!(report["schema"], "boundfit/outliers/1");
    assert_eq!((&report["least"], &report["complete"]), (&json!(3), &json!(true)));
    assert_eq!(report["sets"], json!([[1, 2, 3], [4, 5, 6]]));
    assert_eq!(corners(&report), [owned(&[["-1", "10"]]), owned(&[["1", "0"]])]);
    assert_eq!(report["pieces"][1][0]["active"].as_array().unwrap().len(), 6);
    assert_eq!(report["regions"][0]["kind"], "point");
    assert_eq!(report["area"]["exact"], "0");
    assert_eq!(report["pui"][0]["lower"]["exact"], "-1");
    let missed = &report["regions"][0]["missed"][0];
    assert_eq!(
        (&missed["row"], &missed["bound"], &missed["by"]["lower"]["exact"]),
        (&json!(1), &json!("upper"), &json!("10"))
    );
    assert_eq!(report["growth"].as_array().unwrap().len(), 4);
    assert_eq!((&report["growth"][3]["pieces"], &report["growth"][2]["pui"]), (&json!(2), &Value::Null));
    assert_eq!(report["input"]["rows"], 6);
}

#[test]
fn nothing_has_to_be_left_out() {
    let report = report(&format!("{READ} --eps 1"), "x,y\n0,0\n1,1\n2,2\n", 0);
    assert_eq!((&report["least"], &report["sets"]), (&json!(0), &json!([[]])));
    assert_eq!(report["pieces"][0].as_array().unwrap().len(), 4);
    let text = printed_with_input(&root(), &format!("{READ} --eps 1"), b"x,y\n0,0\n1,1\n2,2\n");
    assert!(text.contains("Least number of readings to leave out: 0 of 3\n"), "{text}");
    assert!(text.contains("Feasible parameter set (FPS): polygon with 4 vertices\n"), "{text}");
}

#[test]
fn few_readings_and_one_abscissa() {
    let one = report(&format!("{READ} --eps 1"), "x,y\n3,5\n", 0);
    assert_eq!((&one["least"], &one["regions"][0]["kind"]), (&json!(0), &json!("strip")));
    assert_eq!((&one["pieces"], &one["area"]), (&json!([[]]), &Value::Null));
    let two = report(&format!("{READ} --eps 1"), "x,y\n3,5\n3,9\n", 0);
    assert_eq!((&two["least"], &two["sets"]), (&json!(1), &json!([[1], [2]])));
    assert_eq!(two["regions"][1]["lines"][0][0]["exact"], "1");
    let touching = report(&format!("{READ} --eps 2"), "x,y\n3,5\n3,9\n3,13\n", 0);
    assert_eq!((&touching["least"], &touching["sets"]), (&json!(1), &json!([[1], [3]])));
    assert_eq!(touching["regions"][0]["kind"], "line");
    assert_eq!(touching["area"]["exact"], "0");
    let repeated = report(&format!("{READ} --eps 1"), "x,y\n3,5\n3,5\n3,9\n3,9\n3,5\n", 0);
    assert_eq!(repeated["sets"], json!([[3, 4]]));
}

#[test]
fn rows_that_no_parameters_meet_are_always_left_out() {
    let bounds = "outliers - --x u,v --lower lo --upper up";
    let crossing = report(bounds, "u,v,lo,up\n1,0,2,1\n0,1,0,1\n0,0,1,2\n1,1,,3\n", 0);
    assert_eq!((&crossing["least"], &crossing["sets"]), (&json!(2), &json!([[1, 3]])));
    assert_eq!(crossing["regions"][0]["missed"][0], json!({"row": 1, "bound": null, "by": null}));
    let text = printed_with_input(&root(), bounds, b"u,v,lo,up\n1,0,2,1\n0,1,0,1\n");
    assert!(text.contains("1              met by no parameters at all\n"), "{text}");
}

#[test]
fn two_regressors_make_a_hole() {
    let three = "u,v,lo,up\n0,1,0,1\n1,1,20,21\n1,-1,-21,-20\n";
    let line = "outliers - --x u,v --lower lo --upper up --most 3";
    let report = report(line, three, 0);
    assert_eq!(report["sets"], json!([[1], [2], [3]]));
    let growth = report["growth"].as_array().unwrap();
    let shape = |growth: &Value| (growth["pieces"].as_u64().unwrap(), growth["holes"].as_u64().unwrap());
    assert_eq!(growth.iter().map(shape).collect::<Vec<_>>(), [(0, 0), (3, 0), (1, 1), (1, 0)]);
    assert_eq!(growth[1]["area"]["exact"], "5/2");
    let text = printed_with_input(&root(), line, three.as_bytes());
    assert!(text.contains("\n  2       1, 1 hole  (-inf, inf)  (-inf, inf)  inf\n"), "{text}");
}

#[test]
fn conditions_are_never_left_out() {
    let rows = "x,y\n0,0\n1,1\n2,2\n0,10\n1,9\n2,8\n";
    let rising = report(&format!("{READ} --eps 0 --where 'theta1 >= 0'"), rows, 0);
    assert_eq!(rising["sets"], json!([[4, 5, 6]]));
    let none = report(&format!("{READ} --eps 0 --where 'theta1 >= 1' --where 'theta1 <= 0'"), rows, 3);
    assert_eq!((&none["least"], &none["sets"], &none["pieces"]), (&Value::Null, &json!([]), &json!([])));
    assert_eq!(none["certificate"]["farkas"][0]["bound"], "where:1");
    let line = format!("{READ} --eps 0 --where 'theta1 >= 1' --where 'theta1 <= 0'");
    let run = boundfit_with_input(&root(), &line, rows.as_bytes());
    assert_eq!(run.status, 3);
    let said = "Nothing is left whatever is left out: the conditions contradict each other (where:1, where:2), and no \
                reading has a part in that. Proof: 1 * (where:1) + 1 * (where:2) gives 0 <= -1.";
    assert!(unbroken(&run.stdout).contains(said), "{}", run.stdout);
}

#[test]
fn more_sets_than_are_asked_for_are_cut() {
    let rows = "x,y\n0,0\n1,5\n2,1\n3,9\n4,3\n";
    let all = report(&format!("{READ} --eps 0"), rows, 0);
    assert_eq!((all["sets"].as_array().unwrap().len(), &all["complete"]), (10, &json!(true)));
    let cut = report(&format!("{READ} --eps 0 --limit sets=4"), rows, 0);
    assert_eq!((cut["sets"].as_array().unwrap().len(), &cut["complete"]), (4, &json!(false)));
    assert_eq!(cut["growth"][3]["pieces"], 10);
    let text = printed_with_input(&root(), &format!("{READ} --eps 0 --limit sets=4"), rows.as_bytes());
    assert!(
        unbroken(&text).contains(
            "These are 4 of the sets of this size that leave feasible parameters; more exist (the limit 'sets')."
        ),
        "{text}"
    );
    let text = printed_with_input(&root(), &format!("{READ} --eps 0"), rows.as_bytes());
    assert!(text.contains("\nFurther sets\n"), "{text}");
}

#[test]
fn every_format_has_the_sets() {
    let line = "outliers fixtures/norris/norris.csv --x x --y y --eps 1";
    let csv = printed(&root(), &format!("{line} --format csv"));
    assert!(csv.starts_with("set,rows,kind,vertices,theta1_lower,theta1_upper,theta2_lower,theta2_upper\n1,22 28 29 30 34,polygon,3,1.0027"), "{csv}");
    let latex = printed(&root(), &format!("{line} --format latex"));
    assert!(latex.contains("22, 28..30 and 34"), "{latex}");
    let markdown = printed(&root(), &format!("{line} --format markdown --most 6"));
    assert!(markdown.contains("### Outliers\n") && markdown.contains("| missed | pieces |"), "{markdown}");
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let norris = "outliers fixtures/norris/norris.csv --x x --y y --eps 1";
    let file = "fixtures/norris/norris.csv";
    refuses(
        &root(),
        &format!("{norris} --limit steps=1"),
        1,
        &format!(
            "{file}: at least 1 reading has to be left out; to find the least number takes 144 crossings of bounds, more \
             than 1; --limit steps=N raises it"
        ),
    );
    refuses(
        &root(),
        &format!("{norris}.5 --limit steps=2000 --most 30"),
        1,
        &format!(
            "{file}: to see how the set grows takes 5184 crossings of bounds, more than 2000, and a smaller '--most' takes \
             fewer; --limit steps=N raises it"
        ),
    );
    let reduced = printed(&root(), "reduce fixtures/norris/norris.csv --x x --y y");
    let directory = directory_with(&[("reduced.csv", reduced.as_bytes())]);
    refuses(
        directory.path(),
        "outliers reduced.csv --x x --y y --eps 1",
        2,
        "'outliers' is about every reading, and the data are a reduction: ask about the table that it was made from",
    );
}
