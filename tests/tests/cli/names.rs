//! The end of the output file's name tells the format, unless `--format` does.

use std::fs;

use boundfit_tests::cli::{boundfit, directory_with};

const DATA: &[u8] = b"x,y\n1,2\n2,3\n3,5\n4,6\n";
const FIT: &str = "fit data.csv --x x --y y --eps 1 --no-lp";

/// Each command, the name of a file, and the format that stands for.
const TOLD: [(&str, &str, &str); 26] = [
    (FIT, "r.json", "json"),
    (FIT, "r.ndjson", "json"),
    (FIT, "r.tex", "latex"),
    (FIT, "r.md", "markdown"),
    (FIT, "r.markdown", "markdown"),
    (FIT, "r.csv", "csv"),
    (FIT, "r.wkt", "wkt"),
    (FIT, "r.m", "m"),
    (FIT, "r.ine", "ine"),
    (FIT, "r.ext", "ext"),
    (FIT, "r.EXT", "ext"),
    (FIT, "r.txt", "text"),
    (FIT, "r", "text"),
    (FIT, "r.report", "text"),
    (FIT, ".json", "text"),
    ("polygon planes.csv", "r.json", "json"),
    ("polygon planes.csv", "r.tex", "latex"),
    ("polygon planes.csv", "r.md", "markdown"),
    ("polygon planes.csv", "r.csv", "csv"),
    ("polygon planes.csv", "r.wkt", "wkt"),
    ("polygon planes.csv", "r.m", "m"),
    ("polygon planes.csv", "r.ine", "ine"),
    ("polygon planes.csv", "r.ext", "ext"),
    ("check data.csv --x x --y y --eps 1 --claim-pui 0,1,0,1", "r.json", "json"),
    ("plot data.csv --x x --y y --eps 1", "r.svg", "svg"),
    ("plot data.csv --x x --y y --eps 1", "r.png", "png"),
];

#[test]
fn the_name_of_the_file_tells_the_format() {
    let directory =
        directory_with(&[("data.csv", DATA), ("planes.csv", b"a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n")]);
    for (command, name, format) in TOLD {
        let by_name = format!("{command} -o {name} --force");
        let status = boundfit(directory.path(), &by_name).status;
        let asked = boundfit(directory.path(), &format!("{command} --format {format} -o asked"));
        assert!(asked.stderr.is_empty() && [0, 4].contains(&status) && status == asked.status, "{by_name}");
        let read = |name: &str| fs::read(directory.path().join(name)).unwrap();
        assert!(read(name) == read("asked"), "{by_name}");
        fs::remove_file(directory.path().join("asked")).unwrap();
    }
    // Groups are a line each.
    let run = boundfit(directory.path(), "fit data.csv --x x --y y --eps 1 --by x -o groups.jsonl");
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(
        fs::read(directory.path().join("groups.jsonl"))
            .unwrap()
            .starts_with(b"{\"schema\":\"boundfit/fleet/2\"")
    );
    for format in ["mps", "lp"] {
        let file = format!("r.{format}");
        let convert = "convert data.csv --x x --y y --eps 1 --objective theta1-min";
        assert_eq!(boundfit(directory.path(), &format!("{convert} -o {file}")).status, 0);
        let printed = boundfit(directory.path(), &format!("{convert} --to {format}")).stdout;
        assert_eq!(fs::read_to_string(directory.path().join(file)).unwrap(), printed);
    }
}

#[test]
fn an_explicit_format_wins() {
    let directory = directory_with(&[("data.csv", DATA)]);
    for (line, file, start) in [
        (format!("{FIT} --format text -o r.json"), "r.json", "Set-membership fit\n"),
        (format!("{FIT} --format json -o r.pdf"), "r.pdf", "{"),
        ("plot data.csv --x x --y y --eps 1 --format svg -o a.png".to_owned(), "a.png", "<svg "),
        ("plot data.csv --x x --y y --eps 1 --format svg -o picture".to_owned(), "picture", "<svg "),
    ] {
        let run = boundfit(directory.path(), &line);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{line}");
        assert!(fs::read_to_string(directory.path().join(file)).unwrap().starts_with(start), "{line}");
    }
}

#[test]
fn a_format_that_a_command_does_not_have_is_refused() {
    let directory = directory_with(&[("data.csv", DATA)]);
    let all = ".json, .ndjson, .jsonl, .tex, .md, .markdown, .csv, .wkt, .m, .ine, .ext, .txt, or '--format'";
    let options = "data.csv --x x --y y --eps 1";
    for (line, file, expected) in [
        (
            format!("fit {options}"),
            "r.svg",
            format!("this command writes no .svg (expected a name that ends in {all})"),
        ),
        (
            format!("fit {options}"),
            "r.pdf",
            format!("this command writes no .pdf (expected a name that ends in {all})"),
        ),
        (
            format!("check {options}"),
            "r.md",
            "this command writes no .md (expected a name that ends in .json, .txt, or '--format')".to_owned(),
        ),
        (
            format!("lesson {options}"),
            "r.json",
            "this command writes no .json (expected a name that ends in .html, .htm)".to_owned(),
        ),
        (
            "reduce data.csv --x x --y y".to_owned(),
            "r.json",
            "this command writes no .json (expected a name that ends in .csv, .tsv, .txt)".to_owned(),
        ),
        (
            format!("convert {options} --objective theta1-min"),
            "r.xml",
            "this command writes no .xml (expected a name that ends in .mps, .lp, or '--to')".to_owned(),
        ),
    ] {
        let run = boundfit(directory.path(), &format!("{line} -o {file}"));
        let message = format!("error: invalid value '{file}' for '--output <FILE>': {expected}\n");
        assert_eq!(
            (run.status, run.stderr.split_once("\n\n").map(|(first, _)| format!("{first}\n"))),
            (2, Some(message))
        );
        assert!(!directory.path().join(file).exists());
    }
    let run = boundfit(directory.path(), &format!("convert {options} --objective theta1-min -o program"));
    let message = "error: '--to <TO>' is missing: the format of the programs, mps or lp\n\nFor more information, try '--help'.\n";
    assert_eq!((run.status, run.stderr.as_str()), (2, message));
}
