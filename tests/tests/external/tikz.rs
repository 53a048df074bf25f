//! pdflatex sets the figures that we write for TikZ. Needs `pdflatex` with `tikz`.

use std::fs;
use std::path::Path;
use std::process::Command;

use boundfit_tests::program::run;

/// Sets a file of a folder and returns what TeX says.
fn pdflatex(folder: &Path, file: &str) -> String {
    let output = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", file])
        .current_dir(folder)
        .output()
        .expect("pdflatex starts: it is in Debian's package texlive-latex-base");
    let log = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{file}: {log}");
    assert!(!log.contains("Missing character"), "{file}: {log}");
    log
}

/// Commands that draw, but for where to.
fn commands() -> Vec<String> {
    let transducer = "plot fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";
    let small = "plot fixtures/figures";
    let mut all: Vec<String> =
        ["data", "eui", "pui", "fps", "corridor", "directions", "status", "range", "next", "outliers"]
            .map(|figure| format!("{transducer} --figure {figure}"))
            .to_vec();
    all.extend(
        [
            "plot fixtures/hard-lp/ptp-nanoseconds.csv --x x --y y --eps 0.00000005",
            "plot fixtures/worst-line/current.csv --x U --y I --eps 2 --x-eps 0.2 --figure data",
            "plot fixtures/tables/faithful.csv --x eruptions --y waiting --eps 20 --figure data --greyscale",
        ]
        .map(str::to_owned),
    );
    for fit in [
        "contradicting.csv --x x --y y --eps 0.3",
        "on-a-line.csv --x x --y y --eps 0",
        "one-reading.csv --x x --y y --eps 0.1",
        "nothing.csv --x u,v --y y --eps 1",
        "two-readings.csv --x x --y y --eps 0.1 --sweep 0.8..2",
        "two-regressors.csv --x u,v --y y --eps 0.3 --figure corridor --flip --size 85mm --font-size 8pt",
    ] {
        all.push(format!("{small}/{fit}"));
    }
    all
}

#[test]
fn every_kind_of_figure_is_set_in_one_document() {
    let folder = tempfile::tempdir().unwrap();
    let mut inputs = String::new();
    let commands = commands();
    for (number, command) in commands.iter().enumerate() {
        let name = format!("figure-{number}.tikz");
        let file = folder.path().join(&name);
        let mut words: Vec<&str> = command.split_whitespace().collect();
        let file = file.to_str().unwrap();
        words.extend(["-o", file]);
        run(&words);
        assert!(fs::metadata(file).is_ok(), "{command}");
        inputs.push_str(&format!("\\input{{{name}}}\n\\clearpage\n"));
    }
    let head = "\\documentclass{article}\n\\usepackage[papersize={1000bp,1000bp},margin=50bp]{geometry}\n\\usepackage{tikz}\n";
    fs::write(
        folder.path().join("all.tex"),
        format!("{head}\\parindent=0pt\n\\begin{{document}}\n{inputs}\\end{{document}}\n"),
    )
    .unwrap();
    let log = pdflatex(folder.path(), "all.tex");
    assert!(log.contains(&format!("({} pages", commands.len())), "{log}");
    assert!(!log.contains("Overfull"), "{log}");
}

#[test]
fn names_with_every_special_character_are_set() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("odd.csv");
    fs::write(
        &data,
        "\"U_z % & # $ {a} ~^\\ <|> 'b' --\",\"θ ε µV °C × ≤ ∞ é “q” € ½ x₁²\"\n1,2\n2,3\n4,4\n",
    )
    .unwrap();
    let file = folder.path().join("odd.tex");
    let title = "100 % of #1 & \\end{document} $x$ {";
    let words =
        ["--header", "yes", "--x", "1", "--y", "2", "--eps", "1", "--figure", "data", "--title", title];
    let mut all = vec!["plot", data.to_str().unwrap()];
    all.extend(words);
    all.extend(["-o", file.to_str().unwrap()]);
    run(&all);
    let log = pdflatex(folder.path(), "odd.tex");
    assert!(log.contains("(1 page,"), "{log}");
}

#[test]
fn a_document_of_its_own_is_a_page_of_the_size_of_the_figure() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("own.tex");
    let fit = "plot fixtures/figures/two-readings.csv --x x --y y --eps 0.1 --size 85mm --font-size 8pt -o";
    let mut words: Vec<&str> = fit.split(' ').collect();
    words.push(file.to_str().unwrap());
    run(&words);
    // With what says how large the page is in plain text.
    let log = pdflatex(folder.path(), "\\pdfobjcompresslevel=0 \\input{own.tex}");
    assert!(log.contains("(1 page,") && !log.contains("Overfull"), "{log}");
    let pdf = fs::read(folder.path().join("own.pdf")).unwrap();
    let text = String::from_utf8_lossy(&pdf);
    // Points of 1/72 inch.
    let size = text.split("/MediaBox [0 0 ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    let width: f64 = size.parse().unwrap();
    assert!((width - 85.0 / 25.4 * 72.0).abs() < 0.1, "{width}");
}
