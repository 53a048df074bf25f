use boundfit_exact::{Limits, Rational};
use boundfit_lp::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};

use super::{Aspect, Fault, Findings, Ground, Tolerances, Worth};
use crate::answer::{Answer, Item};
use crate::solution::{Solution, read_solution};

fn number(text: &str) -> Rational {
    boundfit_exact::Reading::Decimal.read(text, &Limits::default()).unwrap()
}

fn bounds(lower: Option<&str>, upper: Option<&str>) -> Bounds {
    Bounds { lower: lower.map(number), upper: upper.map(number) }
}

fn column(name: &str, cost: &str, own: Bounds) -> ModelColumn {
    ModelColumn { name: name.into(), cost: number(cost), bounds: own }
}

fn row(name: &str, coefficients: [&str; 2], own: Bounds) -> ModelRow {
    let coefficients = coefficients.iter().enumerate().map(|(place, value)| (place, number(value)));
    ModelRow { name: name.into(), coefficients: coefficients.collect(), bounds: own }
}

/// The largest 3 x + 5 y with x ≤ 4, 2 y ≤ 12, 3 x + 2 y ≤ 18: 36 at (2, 6), duals 0, 3/2 and 1.
fn textbook() -> Model {
    let positive = || bounds(Some("0"), None);
    Model {
        sense: ObjectiveSense::Maximize,
        columns: vec![column("x", "3", positive()), column("y", "5", positive())],
        rows: vec![
            row("r1", ["1", "0"], bounds(None, Some("4"))),
            row("r2", ["0", "2"], bounds(None, Some("12"))),
            row("r3", ["3", "2"], bounds(None, Some("18"))),
        ],
        ..Model::default()
    }
}

/// x + y ≤ 1 and ≥ 3.
fn infeasible() -> Model {
    let positive = || bounds(Some("0"), None);
    Model {
        columns: vec![column("x", "1", positive()), column("y", "1", positive())],
        rows: vec![
            row("low", ["1", "1"], bounds(None, Some("1"))),
            row("high", ["1", "1"], bounds(Some("3"), None)),
        ],
        ..Model::default()
    }
}

/// The least −x with x − y ≤ 1.
fn unbounded() -> Model {
    let positive = || bounds(Some("0"), None);
    Model {
        columns: vec![column("x", "-1", positive()), column("y", "0", positive())],
        rows: vec![row("r", ["1", "-1"], bounds(None, Some("1")))],
        ..Model::default()
    }
}

fn judged_by(model: &Model, text: &str, tolerance: &str, digits_as_printed: bool) -> Findings {
    let answer = Answer::of(model).unwrap();
    let file = read_solution(text, &Limits::default()).unwrap();
    let solution = Solution::new(&file, model).unwrap();
    let tolerances = Tolerances { relative: number(tolerance), digits_as_printed };
    Ground::new(model, &answer).judge(&solution, &tolerances)
}

fn judged(model: &Model, text: &str) -> Findings {
    judged_by(model, text, "1e-6", true)
}

fn refuted(findings: &Findings) -> Vec<Aspect> {
    let refuted = findings.findings.iter().filter(|finding| finding.worth == Worth::Refuted);
    refuted.map(|finding| finding.aspect).collect()
}

const RIGHT: &str = r#"{"status": "optimal", "objective": 36, "x": {"x": 2, "y": 6},
    "duals": {"r1": 0, "r2": 1.5, "r3": 1}, "reduced_costs": {"x": 0, "y": 0}}"#;

#[test]
fn a_right_answer_is_exact_in_every_aspect() {
    let findings = judged(&textbook(), RIGHT);
    let aspects: Vec<_> = findings.findings.iter().map(|finding| (finding.aspect, finding.worth)).collect();
    let expected = [
        Aspect::Status,
        Aspect::Objective,
        Aspect::Primal,
        Aspect::Optimality,
        Aspect::Dual,
        Aspect::ComplementarySlackness,
        Aspect::DualityGap,
    ];
    assert_eq!(aspects, expected.map(|aspect| (aspect, Worth::Exact)));
    assert!(!findings.is_refuted());
}

#[test]
fn each_wrong_part_is_refuted_by_the_aspects_that_it_breaks() {
    use Aspect::{
        ComplementarySlackness as Slackness, Dual, DualityGap as Gap, Objective, Optimality, Primal, Status,
    };
    for (right, wrong, expected) in [
        ("\"optimal\"", "\"infeasible\"", vec![Status]),
        ("\"optimal\"", "\"unbounded\"", vec![Status]),
        ("\"objective\": 36", "\"objective\": 36.001", vec![Objective]),
        ("\"objective\": 36", "\"objective\": 35.999", vec![Objective]),
        // Beyond a row of price 0, and where the objective is as it should be.
        ("\"x\": 2, \"y\": 6", "\"x\": 12, \"y\": 0", vec![Primal, Slackness]),
        // Feasible and not optimal.
        ("\"x\": 2, \"y\": 6", "\"x\": 2, \"y\": 5", vec![Optimality, Slackness, Gap]),
        ("\"reduced_costs\": {\"x\": 0", "\"reduced_costs\": {\"x\": 0.01", vec![Dual]),
        // The duals leave −3 of the cost of x, which is what its lower bound 0 may be priced at in a maximum.
        ("\"r3\": 1}, \"reduced_costs\": {\"x\": 0, \"y\": 0}", "\"r3\": 2}", vec![Slackness, Gap]),
        ("\"r1\": 0", "\"r1\": -0.01", vec![Dual]),
    ] {
        let text = RIGHT.replace(right, wrong);
        assert_ne!(text, RIGHT, "{right}");
        assert_eq!(refuted(&judged(&textbook(), &text)), expected, "{wrong}");
    }
}

#[test]
fn the_size_of_the_error_decides() {
    let about = |objective: &str, tolerance: &str, as_printed: bool| {
        let text = RIGHT.replace("\"objective\": 36", &format!("\"objective\": {objective}"));
        judged_by(&textbook(), &text, tolerance, as_printed).about(Aspect::Objective).unwrap().worth
    };
    assert_eq!(about("36", "1e-6", true), Worth::Exact);
    assert_eq!(about("36.00000000000001", "1e-6", true), Worth::Rounded);
    assert_eq!(about("36.00003", "1e-6", true), Worth::WithinTolerance);
    assert_eq!(about("35.99997", "1e-6", true), Worth::WithinTolerance);
    assert_eq!(about("36.00004", "1e-6", true), Worth::Refuted);
    assert_eq!(about("36.00003", "0", true), Worth::Refuted);
    assert_eq!(about("36.00000000000001", "0", true), Worth::Rounded);
    // Texts are precise to half a unit of their last digit, unless they are meant exactly.
    assert_eq!(about("\"36.004\"", "1e-6", true), Worth::Refuted);
    assert_eq!(about("\"36.00\"", "1e-6", true), Worth::Exact);
    assert_eq!(about("\"36.0000000001\"", "0", false), Worth::Refuted);
}

#[test]
fn a_violation_has_a_place_and_the_tolerances_that_excuse_it() {
    let text = RIGHT.replace("\"x\": 2, \"y\": 6", "\"x\": 2.25, \"y\": 6");
    let findings = judged(&textbook(), &text);
    let primal = findings.about(Aspect::Primal).unwrap();
    let Some(Fault::Beyond { side, bound, value }) = &primal.fault else { panic!("{primal:?}") };
    assert_eq!((side.item, bound, value), (Item::Row(2), &number("18"), &number("18.75")));
    let excuse = primal.excuse.as_ref().unwrap();
    // By 0.75, of 18.75, in a row whose largest coefficient is 3.
    assert_eq!(excuse.absolute, number("0.75"));
    assert_eq!(excuse.relative, number("1/25"));
    assert_eq!(excuse.scaled, number("0.25"));
    assert_eq!(
        primal.relative,
        Some(number("0.75/18".split('/').next().unwrap()).checked_div(&number("18")).unwrap())
    );
}

#[test]
fn noise_at_a_bound_of_zero_is_measured_by_what_the_rows_let_the_column_be() {
    let positive = || bounds(Some("0"), None);
    let model = |size: &str| Model {
        columns: vec![column("x", "1", positive()), column("y", "2", positive())],
        rows: vec![row("need", ["1", "1"], bounds(Some(size), None))],
        ..Model::default()
    };
    let text = |x: &str, y: &str| format!("{{\"x\": {{\"x\": {x}, \"y\": {y}}}}}");
    let worth = |size, y| judged(&model(size), &text(size, y)).about(Aspect::Primal).unwrap().worth;
    assert_eq!(worth("3", "-1e-17"), Worth::WithinTolerance);
    assert_eq!(worth("3", "-1e-9"), Worth::WithinTolerance);
    assert_eq!(worth("3", "-1e-5"), Worth::Refuted);
    // A size next to nothing there is ten times all that is asked for here.
    assert_eq!(worth("1e-10", "-1e-9"), Worth::Refuted);
}

#[test]
fn statuses_that_are_none_and_one_of_two() {
    let worth = |model: &Model, status: &str| {
        let findings = judged(model, &format!("{{\"status\": \"{status}\"}}"));
        findings.about(Aspect::Status).unwrap().worth
    };
    for (model, own) in [(textbook(), "optimal"), (infeasible(), "infeasible"), (unbounded(), "unbounded")] {
        for status in ["optimal", "infeasible", "unbounded"] {
            let expected = if status == own { Worth::Exact } else { Worth::Refuted };
            assert_eq!(worth(&model, status), expected, "{own} {status}");
        }
        assert_eq!(worth(&model, "time limit"), Worth::NoAnswer);
        let either = if own == "optimal" { Worth::Refuted } else { Worth::NoAnswer };
        assert_eq!(worth(&model, "infeasible-or-unbounded"), either, "{own}");
    }
}

#[test]
fn certificates_are_judged_alone() {
    let ray = |ray: &str| {
        let findings = judged(&unbounded(), &format!("{{\"ray\": {ray}}}"));
        findings.about(Aspect::Ray).unwrap().clone()
    };
    assert_eq!(ray("[1, 1]").worth, Worth::Exact);
    assert_eq!(ray("{\"x\": 3, \"y\": 5}").worth, Worth::Exact);
    assert_eq!(ray("[1, 0.9999999]").worth, Worth::WithinTolerance);
    assert_eq!(ray("[1, 0.999]").worth, Worth::Refuted);
    assert_eq!(ray("[0, 1]").worth, Worth::Refuted);
    assert_eq!(ray("[0, 1]").fault, Some(Fault::DoesNotImprove { change: number("0") }));
    let farkas = |farkas: &str| {
        let findings = judged(&infeasible(), &format!("{{\"farkas\": {farkas}}}"));
        findings.about(Aspect::Farkas).unwrap().clone()
    };
    assert_eq!(farkas("[-1, 1]").worth, Worth::Exact);
    // The rest of the columns leans on their lower bounds, which are 0.
    assert_eq!(farkas("[-2, 1]").worth, Worth::Exact);
    assert_eq!(farkas("[-1, 1.0000001]").worth, Worth::WithinTolerance);
    assert_eq!(farkas("[-1, 1.001]").worth, Worth::Refuted);
    assert_eq!(farkas("[1, 1]").worth, Worth::Refuted);
    assert_eq!(farkas("[0, 0]").fault, Some(Fault::NoContradiction { total: number("0") }));
}

#[test]
fn an_infeasible_program_called_optimal_is_refuted_and_says_what_excuses_it() {
    let text = r#"{"status": "optimal", "objective": 1, "x": [1, 0]}"#;
    let findings = judged(&infeasible(), text);
    assert_eq!(refuted(&findings), [Aspect::Status, Aspect::Primal]);
    let status = findings.about(Aspect::Status).unwrap();
    assert_eq!(status.excuse.as_ref().unwrap().absolute, number("2"));
}

#[test]
fn files_are_refused_that_are_not_about_the_model() {
    let refusal = |text: &str| {
        let file = read_solution(text, &Limits::default()).unwrap();
        Solution::new(&file, &textbook()).unwrap_err().to_string()
    };
    let has = "(expected x, y)";
    assert_eq!(refusal("{\"x\": {\"z\": 1}}"), format!("line 1: z is no column of the model {has}"));
    assert_eq!(
        refusal("{\"x\": {\n\"x\": 1,\n\"z\": 2}}"),
        format!("line 3: z is no column of the model {has}")
    );
    assert_eq!(refusal("{\"x\": [1, 2, 3]}"), format!("line 1: number 3 is no column of the model {has}"));
    assert_eq!(refusal("{\"x\": {\"x\": 1}}"), "there is no value of the column y, which JSON writes");
    assert_eq!(refusal("=obj= 1\nx 1\nx 2\n"), "line 3: x has a value already (line 2)");
    assert_eq!(
        refusal("{\"duals\": {\"r9\": 1}, \"status\": \"optimal\"}"),
        "line 1: r9 is no row of the model (expected r1, r2, r3)"
    );
    let read = |text: &str| read_solution(text, &Limits::default()).unwrap_err().to_string();
    assert_eq!(
        read("{\n\"y\": 1}"),
        "line 2: \"y\": 1 (expected source, status, objective, x, duals, reduced_costs, ray or farkas, see docs/claims.md)"
    );
    assert_eq!(read("{\"x\": [true]}"), "line 1: \"x\": true (expected a number, or a text like \"1/3\")");
    assert_eq!(read("{}"), "the file stops without \"status\", which JSON writes");
    assert_eq!(read("[]"), "line 1: \"\": [] (expected an object with \"status\", \"objective\", \"x\")");
    assert!(read("{").ends_with("\"duals\": {NAME: VALUE}})"), "{}", read("{"));
    assert_eq!(
        read("# Objective value = 3\nx\n"),
        "line 2: \"x\" (expected \"NAME VALUE\", as Gurobi writes it)"
    );
    assert_eq!(
        read("=obj= 3\nx one\n"),
        "line 2: \"one\": unexpected character 'o' at character 1 (expected a number, as MIPLIB writes it)"
    );
    assert!(read("whatever").starts_with("this is no solution (expected JSON, or a solution as GLPK"));
}

#[test]
fn json_names_each_value_once_and_gives_an_optimum_its_point() {
    let read = |text: &str| read_solution(text, &Limits::default()).unwrap_err().to_string();
    assert_eq!(
        read("{\"x\": {\"x\": 4,\n\"\\u0078\": 3, \"y\": 2}}"),
        "line 2: x has a value already (line 1)"
    );
    assert_eq!(
        read("{\"status\": \"optimal\", \"a\\\"{\": 1, \"status\": \"infeasible\"}"),
        "line 1: status has a value already (line 1)"
    );
    for empty in ["[]", "{}"] {
        let text = format!("{{\"status\": \"optimal\",\n\"objective\": 36, \"x\": {empty}}}");
        assert_eq!(read(&text), format!("line 2: \"x\": {empty} (expected a number for each column)"));
        // Beside another status there is nothing to give.
        judged(&infeasible(), &text.replace("optimal", "infeasible"));
    }
    // One name in two objects is no second value.
    judged(&textbook(), RIGHT);
}

#[test]
fn lists_of_another_program_are_refused() {
    let file =
        read_solution("{\"x\": [2, 6], \"duals\": [0, 1.5, 1], \"status\": \"optimal\"}", &Limits::default())
            .unwrap();
    let solution = Solution::new(&file, &textbook()).unwrap();
    assert_eq!(solution.clone().of_size(&textbook()).unwrap(), solution);
    let other = |change: &dyn Fn(&mut Solution)| {
        let mut other = solution.clone();
        change(&mut other);
        other.of_size(&textbook()).unwrap_err().to_string()
    };
    let column = "(expected 2, one for each column of the program)";
    assert_eq!(
        other(&|own| own.point.as_mut().unwrap().truncate(1)),
        format!("the point has 1 number {column}")
    );
    let row = "(expected 3, one for each row of the program)";
    assert_eq!(other(&|own| own.duals = own.point.clone()), format!("the list of duals has 2 numbers {row}"));
    let reduced = format!("the list of reduced costs has 3 numbers {column}");
    let priced = |own: &Solution| own.duals.clone().map(|duals| duals.into_iter().map(Some).collect());
    assert_eq!(other(&|own| own.reduced_costs = priced(own)), reduced);
}

#[test]
fn gurobi_miplib_and_clp_are_read() {
    for text in [
        "# Solution for model textbook\n# Objective value = 36\nx 2\ny 6\n",
        "# Objective value = 36.0\nx 2.0\ny 6.0000000000000001\n",
        "=obj= 36\nx 2\ny 6\n",
        "optimal\nObjective value              36\n      0 r1   2   0\n      1 r2   12   1.5\n      2 r3  18   1\n      0 x   2   0\n      1 y   6    0\n",
        "solution status: optimal solution found\nobjective value:    36\nx    2 \t(obj:3)\ny    6 \t(obj:5)\n",
    ] {
        let findings = judged(&textbook(), text);
        assert!(findings.worst() <= Worth::Rounded, "{text}: {findings:?}");
        assert!(findings.about(Aspect::Optimality).is_some(), "{text}");
        assert_eq!(findings.about(Aspect::Dual).is_some(), text.contains("r1"), "{text}");
    }
    assert_eq!(refuted(&judged(&textbook(), "=infeas=\n")), [Aspect::Status]);
    // Both writers print all digits, so that a short number is no rounded one: the optimum is 36.0002 here.
    let mut longer = textbook();
    longer.rows[2].bounds = bounds(None, Some("18.0002"));
    for text in ["# Objective value = 36.000\nx 2.000\ny 6.000\n", "=obj= 36.000\nx 2.000\ny 6.000\n"] {
        assert_eq!(refuted(&judged(&longer, text)), [Aspect::Objective, Aspect::Optimality], "{text}");
    }
    // Values that are left out are 0.
    assert_eq!(refuted(&judged(&textbook(), "=obj= 36\ny 6\n")), [Aspect::Optimality]);
}

/// The aspects without an answer, each with its line.
fn unanswered(findings: &Findings) -> Vec<(Aspect, usize)> {
    let none = findings.findings.iter().filter(|finding| finding.worth == Worth::NoAnswer);
    none.map(|finding| (finding.aspect, finding.line)).collect()
}

#[test]
fn numbers_that_are_not_finite_are_no_answer() {
    let plain = "s bas 3 2 f f 36\ni 1 b 2 0\ni 2 u 12 1.5\ni 3 u 18 1\nj 1 b 2 0\nj 2 b 6 0\ne o f\n";
    let cplex = "<CPLEXSolution>\n<header solutionStatusString=\"optimal\"/>\n<variables>\n<variable name=\"x\" value=\"2\"/>\n<variable name=\"y\" value=\"1.#INF\"/></variables>\n<linearConstraints><constraint name=\"r1\"/></linearConstraints></CPLEXSolution>";
    for (text, aspect, line) in [
        ("# Objective value = 36\nx nan\ny 6\n", Aspect::Primal, 2),
        ("# Objective value = inf\nx 2\ny 6\n", Aspect::Objective, 1),
        ("=obj= 36\nx 2\ny -Infinity\n", Aspect::Primal, 3),
        (&plain.replace("f f 36", "f f nan"), Aspect::Objective, 1),
        (&plain.replace("u 12 1.5", "u 12 nan"), Aspect::Dual, 3),
        (&plain.replace("b 6 0", "b 6 inf"), Aspect::Dual, 6),
        (cplex, Aspect::Primal, 5),
    ] {
        let findings = judged_by(&textbook(), text, "0", true);
        assert_eq!(unanswered(&findings), [(aspect, line)], "{text}");
        assert_eq!(findings.worst(), Worth::NoAnswer, "{text}");
    }
    // A dual that is refuted stays so beside a reduced cost that says nothing.
    let both = plain.replace("u 12 1.5", "u 12 -1.5").replace("b 6 0", "b 6 inf");
    assert!(refuted(&judged(&textbook(), &both)).contains(&Aspect::Dual));
    // Numbers beside another status mean nothing.
    let infeasible = plain.replace("f f 36", "n i nan");
    assert_eq!(unanswered(&judged(&textbook(), &infeasible)), []);
}

#[test]
fn a_wrong_objective_names_the_program_that_it_answers() {
    use super::OtherProgram::{OppositeSense, OtherConstant};
    let model = Model { constant: number("3"), ..textbook() };
    for (objective, x, expected) in [
        ("33", "[2, 6]", [Some(OtherConstant), None]),
        ("3", "[0, 0]", [Some(OppositeSense), Some(OppositeSense)]),
        ("34", "[0, 1]", [None, None]),
    ] {
        let text = format!(r#"{{"status": "optimal", "objective": {objective}, "x": {x}}}"#);
        let findings = judged(&model, &text);
        let answers = [Aspect::Objective, Aspect::Optimality].map(|aspect| {
            match &findings.about(aspect).unwrap().fault {
                Some(Fault::Value { answers, .. }) => *answers,
                _ => None,
            }
        });
        assert_eq!(answers, expected, "{text}");
    }
}

#[test]
fn prices_of_the_opposite_sign_are_called_so() {
    let negated = RIGHT.replace("1.5, \"r3\": 1", "-1.5, \"r3\": -1");
    let both = "\"reduced_costs\": {\"x\": 0.01";
    for (text, expected) in [
        (negated.clone(), vec![true]),
        (negated.replace("\"reduced_costs\": {\"x\": 0", both), vec![false]),
        (RIGHT.replace("\"reduced_costs\": {\"x\": 0", both), vec![false]),
        (RIGHT.to_owned(), vec![]),
    ] {
        let findings = judged(&textbook(), &text);
        let refuted = findings.findings.iter().filter(|finding| finding.worth == Worth::Refuted);
        let said: Vec<bool> = refuted.map(|finding| finding.is_negated).collect();
        assert_eq!(said, expected, "{text}: {findings:?}");
    }
}

#[test]
fn the_constant_of_the_objective_excuses_nothing() {
    // The least x + 10⁹ with x ≥ 1: nothing limits x above.
    let model = Model {
        constant: number("1e9"),
        columns: vec![column("x", "1", bounds(Some("0"), None))],
        rows: vec![ModelRow {
            name: "c".into(),
            coefficients: vec![(0, number("1"))],
            bounds: bounds(Some("1"), None),
        }],
        ..Model::default()
    };
    let findings = judged(&model, r#"{"status": "optimal", "objective": 1000000500, "x": {"x": 500}}"#);
    assert_eq!(refuted(&findings), [Aspect::Objective, Aspect::Optimality]);
    let findings = judged(&model, r#"{"status": "optimal", "objective": 1000000001.0000001, "x": {"x": 1}}"#);
    assert_eq!(findings.worst(), Worth::Rounded);
}
