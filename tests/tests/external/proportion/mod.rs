//! The output of HiGHS, GLPK and CBC about seven well-known data sets. Right answers pass. Answers that are off by a
//! known part of the width get the verdict of the manual's table, by a judge that was written from it.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use boundfit_exact::{Rational, Rounding};
use boundfit_tests::lp_cases::{number, ten_to};
use boundfit_tests::program::{root, run};
use boundfit_tests::second_judge::{Finding, Said, Truth, is_excused, judge_end};
use boundfit_tests::shape::Tally;
use serde_json::Value;

use super::tables::python;

/// The data sets with their error bounds.
const TABLES: [(&str, &str); 7] = [
    ("cars", "45"),
    ("women", "3"),
    ("faithful", "20"),
    ("mtcars", "8"),
    ("trees", "12"),
    ("longley", "1.5"),
    ("engel", "700"),
];

const SOLVERS: [&str; 3] = ["highs", "glpk", "cbc"];

const PROGRAMS: [&str; 4] = ["theta1-min", "theta1-max", "theta2-min", "theta2-max"];

fn succeed(command: &mut Command) {
    let output = command.stdin(Stdio::null()).output().unwrap_or_else(|error| {
        panic!("{command:?}: {error}: install Python 3, GLPK and CBC (on Debian glpk-utils, coinor-cbc)")
    });
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// The program's JSON report of a line that ends with one of these statuses.
fn json(line: &str, statuses: &[i32]) -> (i32, Value) {
    let run = run(&line.split_whitespace().collect::<Vec<_>>());
    assert!(statuses.contains(&run.status) && run.stderr.is_empty(), "{line}: {run:?}");
    (run.status, serde_json::from_str(&run.stdout).unwrap())
}

/// Lets every solver answer the four programs of every table: `NAME-SOLVER/theta1-min.sol`.
fn solve_all(folder: &Path) {
    let script = root().join("tests/tests/external/proportion/solve.py");
    succeed(Command::new(python()).arg(&script).arg("tables").arg(folder));
    let mut highs = Command::new(python());
    highs.arg(&script).arg("highs");
    for (name, epsilon) in TABLES {
        let models = folder.join(name);
        let line = format!("convert {0}.csv --x x --y y --eps {epsilon} --to mps -o {0}", models.display());
        let made = run(&line.split_whitespace().collect::<Vec<_>>());
        assert_eq!((made.status, made.stderr.as_str()), (0, ""), "{line}");
        SOLVERS.iter().for_each(|solver| fs::create_dir(folder.join(format!("{name}-{solver}"))).unwrap());
        for program in PROGRAMS {
            let model = models.join(format!("{program}.mps"));
            let solution =
                |solver: &str| folder.join(format!("{name}-{solver}")).join(format!("{program}.sol"));
            highs.arg(&model).arg(solution("highs"));
            succeed(Command::new("glpsol").arg("--freemps").arg(&model).arg("-w").arg(solution("glpk")));
            succeed(Command::new("cbc").arg(&model).args(["solve", "solution"]).arg(solution("cbc")));
        }
    }
    succeed(&mut highs);
}

/// A number as a solver prints it, and what the second judge makes of it.
fn printed(solver: &str, value: &Rational) -> (String, Said) {
    let digits = match solver {
        "glpk" => 15,
        "cbc" => 8,
        // Down to the 13th decimal, at most 16 digits.
        _ => (value.decimal_exponent().unwrap_or(0) + 14).clamp(1, 16) as usize,
    };
    let text = value.to_decimal(digits, Rounding::Nearest);
    let said = said(solver, &text);
    (text, said)
}

fn said(solver: &str, text: &str) -> Said {
    let value = number(text);
    match solver {
        "glpk" => Said::general(value, 15),
        "cbc" => Said::general(value, 8),
        _ => {
            let sixteen = Said::general(value.clone(), 16);
            let down_to = ten_to(-13) * Rational::ratio(1, 2);
            let digits = (value.decimal_exponent().unwrap_or(0) + 14).clamp(1, 16) as usize;
            let half = sixteen.printed.map_or(down_to.clone(), |(half, _)| half.max(down_to));
            Said { value, printed: Some((half, digits)) }
        }
    }
}

/// The places of θ1 and θ2 in a solution: the line and the word.
fn places(solver: &str, text: &str) -> [(usize, String); 2] {
    ["theta1", "theta2"].map(|theta| {
        let word = |line: &str| {
            let words: Vec<&str> = line.split_whitespace().collect();
            match (solver, words.as_slice()) {
                ("glpk", ["j", place, _, value, ..]) if theta.ends_with(place) => Some((*value).to_owned()),
                ("highs", [name, value]) if *name == theta => Some((*value).to_owned()),
                ("cbc", [_, name, value, _]) if *name == theta => Some((*value).to_owned()),
                _ => None,
            }
        };
        let mut found = text.lines().enumerate().filter_map(|(place, line)| Some((place, word(line)?)));
        found.next().unwrap_or_else(|| panic!("{solver} prints no {theta}: {text}"))
    })
}

/// The truth about a table: the readings, the ends, the tolerance of 1e-6.
struct Known {
    readings: Vec<[Rational; 2]>,
    epsilon: Rational,
    ends: [[Rational; 2]; 2],
}

impl Known {
    fn new(folder: &Path, name: &str, epsilon: &str) -> Self {
        let csv = folder.join(format!("{name}.csv"));
        let cells = |line: &str| {
            let (x, y) = line.split_once(',').unwrap();
            [number(x), number(y)]
        };
        let readings = fs::read_to_string(&csv).unwrap().lines().skip(1).map(cells).collect();
        let line = format!("fit {} --x x --y y --eps {epsilon} --format json", csv.display());
        let (_, fit) = json(&line, &[0]);
        let end = |axis: usize, side: &str| {
            number(fit["pui"][axis][side]["exact"].as_str().expect("the set is bounded"))
        };
        let ends = [0, 1].map(|axis| [end(axis, "lower"), end(axis, "upper")]);
        Known { readings, epsilon: number(epsilon), ends }
    }

    fn width(&self, axis: usize) -> Rational {
        &self.ends[axis][1] - &self.ends[axis][0]
    }

    /// The second judge's verdict on a point at which a program is said to have its optimum.
    fn verdict(&self, axis: usize, side: usize, point: &[Said; 2]) -> &'static str {
        let truth = Truth {
            end: self.ends[axis][side].clone(),
            width: Some(self.width(axis)),
            epsilon: Some(self.epsilon.clone()),
            tolerance: ten_to(-6),
        };
        let Finding { verdict, .. } = judge_end(&point[axis], &truth, side == 1);
        let excuses = |[x, y]: &[Rational; 2]| {
            let upper = ([x.clone(), Rational::one()], y + &self.epsilon);
            let lower = ([-x, -Rational::one()], &self.epsilon - y);
            let excuses = |(a, b)| is_excused(&a, &b, Some(&self.epsilon), point, &ten_to(-6));
            excuses(upper) && excuses(lower)
        };
        if verdict != "unsafe" && !self.readings.iter().all(excuses) { "infeasible point" } else { verdict }
    }
}

/// The verdicts on four solution files in a folder, and the exit status.
fn judged(known: &str, folder: &Path) -> (i32, Vec<String>) {
    let (status, report) =
        json(&format!("check {known} --claim {} --format json", folder.display()), &[0, 4]);
    let bounds = report["claims"][0]["bounds"].as_array().unwrap();
    (status, bounds.iter().map(|bound| bound["verdict"].as_str().unwrap().to_owned()).collect())
}

#[test]
fn right_answers_pass_and_perturbed_ones_get_the_verdict_of_the_table() {
    let folder = tempfile::tempdir().unwrap();
    solve_all(folder.path());
    let (mut right, mut tally) = (0, Tally::default());
    for (name, epsilon) in TABLES {
        let known = Known::new(folder.path(), name, epsilon);
        let options = format!("{}/{name}.csv --x x --y y --eps {epsilon}", folder.path().display());
        for solver in SOLVERS {
            let own = folder.path().join(format!("{name}-{solver}"));
            let (status, verdicts) = judged(&options, &own);
            assert_eq!(status, 0, "{name} {solver}: {verdicts:?}");
            right += 1;
            for (places_off, is_inward) in [3, 6, 9].into_iter().flat_map(|k| [(k, true), (k, false)]) {
                let changed = tempfile::tempdir().unwrap();
                let mut expected = Vec::new();
                for (index, program) in PROGRAMS.iter().enumerate() {
                    let (axis, side) = (index / 2, index % 2);
                    let text = fs::read_to_string(own.join(format!("{program}.sol"))).unwrap();
                    let places = places(solver, &text);
                    let by = known.width(axis) * ten_to(-places_off);
                    let is_up = (side == 0) == is_inward;
                    let end = &known.ends[axis][side];
                    let (word, moved) = printed(solver, &(if is_up { end + by } else { end - by }));
                    let mut point = places.each_ref().map(|(_, text)| said(solver, text));
                    point[axis] = moved;
                    expected.push(known.verdict(axis, side, &point));
                    let (place, old) = &places[axis];
                    let line = |(number, line): (usize, &str)| {
                        if number == *place { line.replacen(old.as_str(), &word, 1) } else { line.to_owned() }
                    };
                    let lines: Vec<String> = text.lines().enumerate().map(line).collect();
                    fs::write(changed.path().join(format!("{program}.sol")), lines.join("\n") + "\n")
                        .unwrap();
                }
                let (status, verdicts) = judged(&options, changed.path());
                let place = format!("{name} {solver} 1e-{places_off} inward: {is_inward}");
                assert_eq!(verdicts, expected, "{place}");
                for verdict in expected {
                    match (places_off, is_inward) {
                        (3, true) => assert_eq!(verdict, "unsafe", "{place}"),
                        (3, false) => assert!(["loose", "infeasible point"].contains(&verdict), "{place}"),
                        (9, _) => {
                            let fine = ["exact", "rounded", "within tolerance"];
                            assert!(fine.contains(&verdict), "{place}: {verdict}");
                        }
                        _ => {}
                    }
                    tally.count(verdict);
                }
                match places_off {
                    3 => assert_eq!(status, 4, "{place}"),
                    9 => assert_eq!(status, 0, "{place}"),
                    _ => {}
                }
            }
        }
    }
    assert_eq!(right, 21);
    tally.assert_each(20, &["rounded", "within tolerance", "infeasible point", "unsafe"]);
}
