//! `boundfit next`: exact answers, ranges, error bounds, statuses, refusals.

use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit, boundfit_with_input, report};
use boundfit_tests::program::root;
use serde_json::{Value, json};

const TRANSDUCER: &str = "fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";
const ALL_LENGTHS: [&str; 2] = ["25529/444075346", "939827/4442763160"];
const AREA: &str = "155025288493988869/23916155774463827734548000";

fn next(options: &str) -> Value {
    report(&root(), &format!("next {TRANSDUCER} {options}"), b"")
}

fn of_table(table: &str, options: &str) -> (i32, Value) {
    let run = boundfit_with_input(&root(), &format!("next - {options} --format json"), table.as_bytes());
    assert_eq!(run.stderr, "", "{options}");
    (run.status, serde_json::from_str(&run.stdout).unwrap())
}

/// Exact ends of open intervals.
fn certain(found: &Value) -> Vec<[Option<&str>; 2]> {
    let intervals = found["certain"].as_array().unwrap();
    intervals.iter().map(|own| ["lower", "upper"].map(|end| own[end]["exact"].as_str())).collect()
}

/// The name, the value now, the worst one and the best x of a goal.
type Goal<'a> = (&'a str, Option<&'a str>, Option<&'a str>, Vec<&'a str>);

fn goals(found: &Value) -> Vec<Goal<'_>> {
    let all = found["goals"].as_array().unwrap();
    all.iter()
        .map(|goal| {
            let at = goal["at"].as_array().unwrap().iter().map(|x| x["exact"].as_str().unwrap()).collect();
            let name = goal["goal"].as_str().unwrap();
            (name, goal["now"]["exact"].as_str(), goal["worst"]["exact"].as_str(), at)
        })
        .collect()
}

#[test]
fn no_single_voltage_within_ten_volts_is_sure_to_help() {
    let found = next("--within -10..10");
    assert_eq!(found["schema"], "boundfit/next/1");
    let [below, above] = ["-576031023/36470000", "4849289759/255290000"];
    assert_eq!(certain(&found), [[None, Some(below)], [Some(above), None]]);
    assert_eq!(found["certain_within"], false);
    let [theta1, theta2] = ALL_LENGTHS.map(Some);
    let none = Vec::new;
    assert_eq!(
        goals(&found),
        [
            ("theta1", theta1, theta1, none()),
            ("theta2", theta2, theta2, none()),
            ("area", Some(AREA), Some(AREA), none())
        ]
    );
    // Open intervals are rounded inward.
    assert_eq!(found["certain"][0]["upper"]["decimal"], "-15.795");
    assert_eq!(found["certain"][1]["lower"]["decimal"], "18.996");
}

#[test]
fn the_best_x_is_an_end_of_the_range_or_zero() {
    let found = next("--within -20..20");
    assert_eq!(found["certain_within"], true);
    let [theta1, theta2] = ALL_LENGTHS.map(Some);
    let [worst1, worst] = ["487410/10071072901", "26423912945930207/4245645275909499316294550"];
    assert_eq!(
        goals(&found),
        [
            ("theta1", theta1, Some(worst1), vec!["-20"]),
            ("theta2", theta2, theta2, Vec::new()),
            ("area", Some(AREA), Some(worst), vec!["-20"])
        ]
    );
    // A better instrument measures the offset best at 0.
    let found = next("--within -10..10 --new-eps 1e-4");
    let [worst1, worst] = ["1151/40020194", "18521848426436029/5893416681321186531472750"];
    assert_eq!(
        goals(&found),
        [
            ("theta1", theta1, Some(worst1), vec!["-10"]),
            ("theta2", theta2, Some("1/5000"), vec!["0"]),
            ("area", Some(AREA), Some(worst), vec!["-10"])
        ]
    );
    assert_eq!(found["new_reading"]["given"], true);
    // One goal alone is answered alike.
    let alone = next("--within -10..10 --new-eps 1e-4 --goal theta2");
    assert_eq!(goals(&alone), [goals(&found)[1].clone()]);
    assert_eq!(alone["certain"], found["certain"]);
}

#[test]
fn the_range_is_that_of_the_readings_unless_it_is_given() {
    let found = next("--new-eps 1e-4");
    let within = &found["within"];
    assert_eq!(
        (&within["lower"]["exact"], &within["upper"]["exact"], &within["given"]),
        (&json!("-51329/10000"), &json!("65931/10000"), &json!(false))
    );
    let text = boundfit(&root(), &format!("next {TRANSDUCER}")).stdout;
    assert!(text.contains("\nThe best Vz from -5.1329 to 6.5931, the range of the readings\n"), "{text}");
    // Counted from another origin x is that of the data still, and the offset is measured at the origin.
    let moved = next("--new-eps 1e-4 --x-origin 2");
    assert_eq!((certain(&moved), &moved["within"]), (certain(&found), within));
    assert_eq!(goals(&moved)[1].3, ["2"]);
    for place in [0, 2] {
        assert_eq!(goals(&moved)[place], goals(&found)[place]);
    }
}

#[test]
fn sets_of_every_extent_have_an_answer() {
    let one = "x,y\n1,1\n";
    let (status, strip) = of_table(one, "--x x --y y --eps 1 --within -1..3");
    assert_eq!((status, strip["fps"]["kind"].as_str()), (0, Some("strip")));
    // Only another reading at the same x may say nothing new.
    assert_eq!(certain(&strip), [[None, Some("1")], [Some("1"), None]]);
    // The strip and a slab make a parallelogram; the offset is best known at 0, from the new reading alone.
    let three = vec!["-1", "3"];
    assert_eq!(
        goals(&strip),
        [
            ("theta1", None, Some("2"), three.clone()),
            ("theta2", None, Some("2"), vec!["-1", "0"]),
            ("area", None, Some("2"), three)
        ]
    );
    let (_, point) = of_table("x,y\n0,0\n1,1\n2,2\n", "--x x --y y --eps 0");
    assert_eq!((certain(&point), &point["fps"]["kind"]), (vec![], &json!("point")));
    let (_, plane) = of_table("x,low,high\n1,,2\n", "--x x --lower low --upper high --new-eps 1");
    assert_eq!((certain(&plane), &plane["fps"]["kind"]), (vec![[None, None]], &json!("half-plane")));
    let (status, empty) = of_table("x,y\n0,0\n1,1\n2,9\n", "--x x --y y --eps 1");
    assert_eq!((status, &empty["certain"], &empty["goals"]), (3, &Value::Null, &json!([])));
    assert!(empty["fps"]["certificate"]["farkas"].as_array().is_some_and(|terms| terms.len() == 3));
}

#[test]
fn many_readings_and_reductions_are_asked_like_few() {
    let table: String =
        (0..12_000).map(|row| format!("{},{}\n", row % 701, 3 * (row % 701) + (row * 7919) % 13)).collect();
    let table = format!("x,y\n{table}");
    let options = "--x x --y y --eps 8";
    let (status, found) = of_table(&table, options);
    assert_eq!((status, found["within"]["upper"]["exact"].as_str()), (0, Some("700")));
    let reduced = boundfit_with_input(&root(), "reduce - --x x --y y", table.as_bytes()).stdout;
    let (_, from_reduced) = of_table(&reduced, options);
    for part in ["certain", "within", "goals", "certain_within"] {
        assert_eq!(found[part], from_reduced[part], "{part}");
    }
    // Under bounds of their own not all x are kept.
    let own: String = table.lines().skip(1).map(|line| format!("{line},8\n")).collect();
    let own = format!("x,y,e\n{own}");
    let options = "--x x --y y --eps-column e --new-eps 8";
    let (_, left_out) = of_table(&own, options);
    assert_eq!((&left_out["within"], &left_out["goals"]), (&Value::Null, &json!([])));
    assert!(left_out["reasons"]["within"].as_str().is_some_and(|why| why.contains("give one")), "{left_out}");
    assert_eq!(left_out["certain"], found["certain"]);
    let (_, asked) = of_table(&own, &format!("{options} --within 0..700"));
    assert_eq!(asked["goals"], found["goals"]);
    // All x of hundreds of rows are kept.
    let hundreds: String = own.lines().take(500).map(|line| format!("{line}\n")).collect();
    let (_, kept) = of_table(&hundreds, options);
    assert_eq!(kept["within"]["upper"]["exact"], "498");
}

#[test]
fn csv_has_a_row_for_each_goal() {
    let run =
        boundfit_with_input(&root(), "next - --x x --y y --eps 1 --within -1..3 --format csv", b"x,y\n1,1\n");
    assert_eq!(run.status, 0);
    assert_eq!(
        run.stdout,
        "goal,now,worst,at,now_exact,worst_exact\ntheta1,inf,2.0,-1 3,,2\ntheta2,inf,2.0,-1 0,,2\narea,inf,2.0,-1 3,,2\n"
    );
}

#[test]
fn exact_columns_of_csv_are_fractions() {
    let line = "next - --x x --y y --eps 1/1024 --new-eps 1/4096 --within 0..1 --goal theta1 --format csv";
    let run = boundfit_with_input(&root(), line, b"x,y\n0,0\n1e-5,1\n2e-5,2\n");
    let expected =
        "goal,now,worst,at,now_exact,worst_exact\ntheta1,195.3125,0.00244140625,1,3125/16,5/2048\n";
    assert_eq!(run.stdout, expected);
}

#[test]
fn what_makes_no_question_is_refused() {
    for (options, message) in [
        ("--goal slope", "invalid value 'slope' for '--goal <GOAL>': expected theta1, theta2 or area"),
        (
            "--within 3",
            "invalid value '3' for '--within <LO..HI>': expected LO..HI, two numbers such as -10..10",
        ),
        (
            "--within 0...10",
            "invalid value '0...10' for '--within <LO..HI>': expected LO..HI, two numbers such as -10..10",
        ),
        (
            "--within 3..1",
            "invalid value '3..1' for '--within <LO..HI>': expected two numbers, the lower one first, such as -10 and 10",
        ),
        (
            "--new-eps -1",
            "invalid value '-1' for '--new-eps <NUM>': expected one number for both sides that is not negative, such as 0.5",
        ),
    ] {
        refuses(&root(), &format!("next {TRANSDUCER} {options}"), 2, message);
    }
    refuses(
        &root(),
        "next fixtures/transducer/transducer.csv --x Vz,z --y z --eps 1",
        2,
        "'next' is about a line: with two regressors there is no single x",
    );
    refuses(
        &root(),
        "next fixtures/steam-generator/steam_generator.csv --x x --y y --eps-column eps",
        2,
        "each reading has an error bound of its own, so a further one has none yet; state the error bound of the next reading with \
         '--new-eps'",
    );
}

/// A rounded number would make "more than" false of what lies between.
#[test]
fn twice_the_error_bound_is_repeated_in_full() {
    for (epsilon, twice) in [("0.7123456", "1.4246912"), ("0.7 --digits 1", "1.4"), ("1/3", "2/3")] {
        let line = format!("next - --x x --y y --eps {epsilon}");
        let run = boundfit_with_input(&root(), &line, b"x,y\n1,2\n2,3\n3,4.1\n4,5\n");
        assert!(
            run.stdout.replace("\n  ", " ").contains(&format!("2 eps = {twice} apart")),
            "{}",
            run.stdout
        );
    }
}

#[test]
fn the_figure_is_refused_where_the_question_is() {
    let of = |options: &str| {
        boundfit(
            &root(),
            &format!("plot fixtures/steam-generator/steam_generator.csv --y y --figure next {options}"),
        )
    };
    for (options, message) in [
        ("--x x,eps --eps 10", "error: 'next' is about a line: with two regressors there is no single x\n"),
        (
            "--x x --eps-column eps",
            "error: '--figure next' needs one error bound on both sides of all readings, which the next one has too; 'boundfit \
             next ... --new-eps NUM' takes another\n",
        ),
    ] {
        let run = of(options);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.starts_with(message), "{}", run.stderr);
    }
    let run = boundfit(&root(), &format!("plot {TRANSDUCER} --figure next --within -20..20"));
    assert!(
        run.status == 2 && run.stderr.contains("tip: '--x-range LO..HI' is the x that a figure shows"),
        "{}",
        run.stderr
    );
    assert!(!run.stderr.contains("a similar argument exists"), "{}", run.stderr);
}

#[test]
fn the_legend_names_what_the_figure_shows() {
    let distance = "distance of the lowest and the highest feasible line";
    for (table, is_drawn) in [("x,y\n5,2\n5,2.5\n", false), ("x,y\n5,2\n6,2.5\n", true)] {
        let run = boundfit_with_input(
            &root(),
            "plot - --x x --y y --eps 0.7 --figure next --format tikz",
            table.as_bytes(),
        );
        assert_eq!((run.status, run.stdout.contains(distance)), (0, is_drawn), "{table}");
    }
}

#[test]
fn a_figure_far_from_0_tells_the_ends_apart() {
    let table = "x,y\n1000000,0\n1000000.001,1\n1000000.002,2\n";
    let run = boundfit_with_input(&root(), "plot - --x x --y y --eps 0.5 --figure next", table.as_bytes());
    let note = "At x below 1×10⁶ and above 1000000.002 a reading certainly makes the set smaller.</desc>";
    assert!(run.stdout.contains(note), "{}", run.stdout.chars().take(600).collect::<String>());
}

/// Other bounds above than below are not one.
#[test]
fn unequal_bounds_of_the_readings_are_told_in_plain_words() {
    refuses(
        &root(),
        "next fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps +0.3/-0.1",
        2,
        "the readings do not all have one error bound, the same above and below; state the error bound of the next reading with \
         '--new-eps'",
    );
}
