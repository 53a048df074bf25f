//! pdflatex sets what we write in LaTeX, and every line of it fits a page of A4. Needs `pdflatex` with `booktabs`.

use std::fs;
use std::path::Path;
use std::process::Command;

use boundfit_tests::program::{root, run, run_with_input};

/// Sets a report in an article of this size and returns what TeX says.
fn pdflatex(folder: &Path, report: &str, size: &str) -> String {
    let document = format!(
        "\\documentclass[a4paper,{size}]{{article}}\n\\usepackage{{booktabs}}\n\\begin{{document}}\n{report}\\end{{document}}\n"
    );
    fs::write(folder.join("report.tex"), document).unwrap();
    let output = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "report.tex"])
        .current_dir(folder)
        .output()
        .expect(
            "pdflatex starts: it is in Debian's packages texlive-latex-base and texlive-latex-recommended",
        );
    let log = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{log}\n{report}");
    log
}

fn assert_fits(report: &str) {
    let folder = tempfile::tempdir().unwrap();
    for size in ["10pt", "11pt", "12pt"] {
        let log = pdflatex(folder.path(), report, size);
        let wide: Vec<&str> = log.lines().filter(|line| line.starts_with("Overfull \\hbox")).collect();
        assert!(wide.is_empty(), "{size}: {wide:?}\n{report}");
    }
}

#[test]
fn golden_reports_fit_the_page() {
    for name in ["transducer", "empty", "strip", "house"] {
        assert_fits(&fs::read_to_string(root().join(format!("fixtures/documents/{name}.tex"))).unwrap());
    }
}

#[test]
fn long_numbers_and_names_are_broken_into_lines() {
    let transducer = "fit fixtures/transducer/transducer.csv --x Vz --y z --eps 0.5e-3 --format latex";
    let steam =
        "fit fixtures/steam-generator/steam_generator.csv --x x --y y --eps-column eps --format latex";
    let norris = "fit fixtures/norris/norris.csv --x x --y y --eps 1 --format latex";
    for line in [
        format!("{transducer} --exact"),
        format!("{transducer} --digits 15"),
        format!("{transducer} --rows 14..36 --sweep 0..3 --exact"),
        format!("{steam} --sweep 0..3"),
        format!("{norris} --sweep 0..3"),
    ] {
        assert_fits(&run(&line.split(' ').collect::<Vec<_>>()).stdout);
    }
    let name = "a_column_with_a_very_long_name_in_which_there_is_no_blank_at_all_and_then_some_more";
    let table = format!("x,{name}\n1,2.123456789123456789\n2,3\n3.5,4.1\n7,9.00000000000000000000000001\n");
    let fit = ["fit", "-", "--x", "x", "--y", name, "--eps", "1/3", "--sweep", "0..2", "--format", "latex"];
    assert_fits(&run_with_input(&fit, table.as_bytes()).stdout);
}
