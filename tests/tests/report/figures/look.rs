//! Size, letters, colours and names of what other commands draw beside their answers.

use std::fs;
use std::process::{Command, Output};

use boundfit_tests::program::{binary, root};

use super::TRANSDUCER;
use super::geometry::assert_labels_have_room;

const COMMANDS: [&str; 3] = ["judge", "polygon", "linearity"];

/// A model and a set in a folder of their own.
fn inputs() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let model = "Maximize\n obj: 2 x + 3 y\nSubject To\n c1: x + y <= 4\n c2: x + 3 y <= 6\nEnd\n";
    fs::write(folder.path().join("model.lp"), model).unwrap();
    fs::write(folder.path().join("square.csv"), "a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n").unwrap();
    folder
}

/// Runs one of the commands, with further words, and gives the picture.
fn drawn(folder: &tempfile::TempDir, command: &str, words: &[&str], file: Option<&str>) -> Output {
    let path = |name: &str| folder.path().join(name).display().to_string();
    let mut all: Vec<String> = match command {
        "judge" => vec!["judge".to_owned(), path("model.lp")],
        "polygon" => vec!["polygon".to_owned(), path("square.csv")],
        _ => "linearity fixtures/transducer/transducer.csv --x Vz --y z"
            .split(' ')
            .map(str::to_owned)
            .collect(),
    };
    if let Some(file) = file {
        all.push(option(command).to_owned());
        all.push(path(file));
    }
    all.extend(words.iter().map(|word| (*word).to_owned()));
    Command::new(binary()).args(&all).current_dir(root()).output().unwrap()
}

fn option(command: &str) -> &'static str {
    if command == "linearity" { "--figure" } else { "--plot" }
}

#[test]
fn every_command_that_draws_has_the_options_of_plot() {
    for command in COMMANDS {
        let folder = inputs();
        let look = [
            "--size",
            "85mm",
            "--font-size",
            "8pt",
            "--title",
            "Own title",
            "--x-label",
            "own x",
            "--y-label",
            "own y",
            "--greyscale",
            "--real-text",
            "--x-range",
            "-1..5",
        ];
        let output = drawn(&folder, command, &look, Some("own.svg"));
        assert_eq!(output.status.code(), Some(0), "{command}: {}", String::from_utf8_lossy(&output.stderr));
        let text = fs::read_to_string(folder.path().join("own.svg")).unwrap();
        for expected in ["Own title", "own x", "own y"] {
            assert!(text.contains(expected), "{command}: {expected}");
        }
        // 85 mm in pixels of 1/96 inch.
        assert!(text.contains("width=\"321.2"), "{command}: {}", &text[..200]);
        let is_grey = |colour: &str| colour[..2] == colour[2..4] && colour[..2] == colour[4..6];
        assert!(text.split("=\"#").skip(1).all(|part| is_grey(&part[..6])), "{command}");
        assert_labels_have_room(&text, command);
        let output = drawn(&folder, command, &["--dpi", "96"], Some("own.png"));
        assert_eq!(output.status.code(), Some(0), "{command}");
        let png = fs::read(folder.path().join("own.png")).unwrap();
        assert_eq!(resvg::tiny_skia::Pixmap::decode_png(&png).unwrap().width(), 800, "{command}");
    }
}

#[test]
fn options_of_a_picture_that_is_not_drawn_are_refused() {
    for command in COMMANDS {
        let folder = inputs();
        for (option_of_look, value) in [
            ("--size", Some("85mm")),
            ("--font-size", Some("8pt")),
            ("--dpi", Some("300")),
            ("--x-range", Some("0..1")),
            ("--y-range", Some("0..1")),
            ("--x-label", Some("x")),
            ("--y-label", Some("y")),
            ("--greyscale", None),
            ("--real-text", None),
        ] {
            let words: Vec<&str> = [option_of_look].into_iter().chain(value).collect();
            let output = drawn(&folder, command, &words, None);
            let expected = format!(
                "error: '{option_of_look}' is about the picture: say where it goes with '{} <FILE>'",
                option(command)
            );
            let message = String::from_utf8_lossy(&output.stderr);
            assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(2), true), "{command}");
            assert_eq!(message.lines().next(), Some(expected.as_str()), "{command}");
        }
        for (words, file, problem) in [
            (
                &["--dpi", "300"][..],
                "own.svg",
                "'--dpi' is about the pixels of a PNG, and the picture is an SVG",
            ),
            (
                &["--real-text"],
                "own.pdf",
                "'--real-text' is about the texts of an SVG, and the picture is a PDF",
            ),
        ] {
            let output = drawn(&folder, command, words, Some(file));
            let message = String::from_utf8_lossy(&output.stderr);
            assert_eq!(
                (output.status.code(), message.contains(problem)),
                (Some(2), true),
                "{command}: {message}"
            );
        }
        let output = drawn(&folder, command, &["--title", "own"], None);
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("'--title' is about the picture"), "{command}: {message}");
        let output = drawn(&folder, command, &["--size", "30mm", "--font-size", "8pt"], Some("own.svg"));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("27 to 266 times as wide as its letters are large"), "{command}: {message}");
    }
}

#[test]
fn descriptions_name_axes_as_the_figure_does_and_those_without_names_too() {
    for command in COMMANDS {
        let folder = inputs();
        let output = drawn(&folder, command, &["--x-label", "own x", "--y-label", ""], Some("own.svg"));
        assert_eq!(output.status.code(), Some(0), "{command}");
        let text = fs::read_to_string(folder.path().join("own.svg")).unwrap();
        let said = text.split_once("<desc>").unwrap().1.split_once("</desc>").unwrap().0;
        assert!(said.contains("Horizontal axis: own x. Vertical axis: "), "{command}: {said}");
        assert!(!said.contains("Vertical axis: ."), "{command}: {said}");
    }
    for (figure, expected) in [
        ("fps", "Horizontal axis: θ₁ [m/V]. Vertical axis: own y."),
        ("data", "First panel: own y against Vz [V]."),
        ("fps --eps 1", "Horizontal axis: θ₁ [m/V]. Vertical axis: own y."),
        ("data --x-eps 1e-3", ": own y against Vz [V]."),
    ] {
        let words = format!("{TRANSDUCER} --figure {figure} --x-label= --y-label");
        let output = Command::new(binary())
            .arg("plot")
            .args(words.split(' ').filter(|word| !word.is_empty()))
            .arg("own y")
            .current_dir(root())
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(text.contains(expected), "{figure}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
