//! The figures that are refused, with the reasons.

use std::fs;

use super::{of_kind, plot};

/// Runs with further arguments; gives the status and the first line of the message. Nothing may be written elsewhere.
fn refused(more: &str) -> (i32, String) {
    let output = plot(&format!("{} {more}", of_kind("two-readings.csv --x x --y y --eps 0.1")));
    assert_eq!(output.stdout, b"", "{more}");
    let message = String::from_utf8(output.stderr).unwrap();
    (output.status.code().unwrap(), message.lines().next().unwrap_or_default().to_owned())
}

#[test]
fn a_name_that_says_no_format() {
    for name in ["picture.gif", "picture", "folder/", ".svg"] {
        let (status, message) = refused(&format!("-o {name}"));
        assert_eq!(status, 2, "{name}");
        let expected = "a picture is SVG, PNG, PDF or TikZ (expected a name that ends in .svg, .png, .pdf, .tikz or .tex, or '--format')";
        assert_eq!(message, format!("error: invalid value '{name}' for '--output <FILE|DIR>': {expected}"));
    }
}

#[test]
fn all_figures_without_a_folder() {
    let expected = "error: '--figure all' makes six files and needs '--output <DIR>', the folder for them";
    for more in ["--figure all", "--figure all -o -"] {
        assert_eq!(refused(more), (2, expected.to_owned()), "{more}");
    }
    let (status, message) = refused("--figure all -o all.svg");
    assert_eq!((status, message.contains("expected a folder for them")), (2, true), "{message}");
}

#[test]
fn a_folder_that_cannot_be_made() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let (status, message) = refused(&format!("--figure all -o {}", file.display()));
    assert_eq!(status, 1);
    let problem = "cannot create: a file is there, and several files need a folder";
    assert_eq!(message, format!("error: {}: {problem}", file.display()));
}

#[test]
fn all_figures_or_none() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("fps.svg");
    fs::create_dir(&taken).unwrap();
    let (status, message) = refused(&format!("--figure all -o {}", folder.path().display()));
    assert_eq!((status, message), (1, format!("error: {}: cannot write: is a directory", taken.display())));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn too_few_directions() {
    let (status, message) = refused("--figure directions --directions 2");
    assert_eq!((status, message.contains("'--directions <N>'")), (2, true), "{message}");
}

#[test]
fn bad_data_leaves_no_folder_behind() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("figures");
    let output = plot(&format!("no-such-file.csv --x 1 --y 2 --eps 1 --figure all -o {}", inside.display()));
    assert_eq!((output.status.code(), inside.exists()), (Some(1), false));
}

#[test]
fn sizes_and_ranges_that_are_none() {
    let size = "expected a width from 10mm to 2000mm, as 85mm, 8.5cm, 3.3in, 240pt or 600px";
    let range = "expected LOWER..UPPER, two numbers as in -1.5..2";
    for (more, problem) in [
        ("--size 85", size.to_owned()),
        ("--size 1mm", size.to_owned()),
        ("--size 3m", size.to_owned()),
        ("--size 1e3px", size.to_owned()),
        ("--size=-5cm", size.to_owned()),
        ("--size ..cm", size.to_owned()),
        ("--x-range 3", range.to_owned()),
        ("--x-range 3..3", "the lower end is not below the upper one".to_owned()),
        ("--y-range 2..-1", "the lower end is not below the upper one".to_owned()),
    ] {
        let (status, message) = refused(more);
        assert_eq!((status, message.ends_with(&problem)), (2, true), "{more}: {message}");
    }
    let (status, message) = refused("--x-range a..3");
    assert_eq!((status, message.contains("not a number")), (2, true), "{message}");
    let letters = "expected a size from 1pt to 200pt, as 8pt or 3mm";
    for more in ["--font-size 8", "--font-size 0.5pt", "--font-size 3in", "--font-size=-8pt"] {
        let (status, message) = refused(more);
        assert_eq!((status, message.ends_with(letters)), (2, true), "{more}: {message}");
    }
    for more in ["--size 30mm --font-size 8pt", "--size 2000mm --font-size 8pt", "--font-size 200pt"] {
        let (status, message) = refused(more);
        let problem = "has to be 27 to 266 times as wide as its letters are large";
        assert_eq!((status, message.contains(problem)), (2, true), "{more}: {message}");
    }
    for more in ["--dpi 10", "--dpi 5000"] {
        assert_eq!(refused(more).0, 2, "{more}");
    }
}

#[test]
fn ranges_of_axes_that_are_neither_of_readings_nor_of_parameters() {
    for option in ["--x-range", "--y-range"] {
        let (status, message) = refused(&format!("--figure status {option} 0..1"));
        let problem = format!(
            "'{option}' is about x, y, theta1 and theta2: the axes of '--figure status' are residuals and leverages"
        );
        assert_eq!((status, message.contains(&problem)), (2, true), "{message}");
    }
}

#[test]
fn options_about_other_pictures() {
    for (more, problem) in [
        ("--dpi 300", "'--dpi' is about the pixels of a PNG, and the picture is an SVG"),
        ("--dpi 300 --format pdf", "'--dpi' is about the pixels of a PNG, and the picture is a PDF"),
        (
            "--dpi 300 --format tex",
            "'--dpi' is about the pixels of a PNG, and the picture is source for TikZ",
        ),
        ("--real-text --format png", "'--real-text' is about the texts of an SVG, and the picture is a PNG"),
        (
            "--real-text --format tikz",
            "'--real-text' is about the texts of an SVG, and the picture is source for TikZ",
        ),
        (
            "--figure fps --flip",
            "'--flip' turns the figures 'data', 'eui', 'pui' and 'corridor', and this is '--figure fps'",
        ),
        (
            "--figure range --flip",
            "'--flip' turns the figures 'data', 'eui', 'pui' and 'corridor', and this is '--figure range'",
        ),
        ("--directions 9", "'--directions' needs '--figure directions', and this is '--figure fps'"),
    ] {
        let (status, message) = refused(more);
        assert_eq!((status, message.contains(problem)), (2, true), "{more}: {message}");
    }
}

#[test]
fn more_pixels_than_fit_into_memory() {
    let (status, message) = refused("--size 2000mm --dpi 1200 --format png");
    assert_eq!((status, message.contains("pixels are too many")), (1, true), "{message}");
}
