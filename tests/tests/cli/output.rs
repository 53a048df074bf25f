//! The output of the program: its content, its place and its shape, and its statements about itself.

use std::fs;
use std::path::Path;

use boundfit_tests::program::{Run, root};
use serde_json::{Value, json};

use boundfit_tests::cli::numbers::{check_numbers, rational};
use boundfit_tests::cli::{
    FIT_TRANSDUCER, boundfit, command, directory_with, files_in, finish, fixture, printed, report, words,
};

/// Command lines that end with an answer, of either kind and in either format.
fn answers() -> Vec<(String, i32)> {
    let norris = "fit fixtures/norris/norris.csv --x x --y y --eps 1/2";
    let mut lines = Vec::new();
    for (line, status) in [
        (FIT_TRANSDUCER, 0),
        (norris, 3),
        ("polygon fixtures/polygon/house.ine", 0),
        ("polygon fixtures/polygon/empty.csv", 3),
    ] {
        lines.extend(["text", "json"].map(|format| (format!("{line} --format {format}"), status)));
    }
    lines
}

/// Runs a command line with its answer to a file.
fn with_output(line: &str, file: &Path) -> Run {
    finish(command(&root()).args(words(line)).arg("-o").arg(file), b"")
}

/// Checks that a run writes the answer to a file and nothing else.
fn writes(line: &str, status: i32, file: &Path) {
    let run = with_output(line, file);
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (status, "", ""), "{line}");
    assert_eq!(fs::read_to_string(file).unwrap(), boundfit(&root(), line).stdout, "{line}");
}

#[test]
fn a_file_gets_exactly_what_standard_output_would_show() {
    let directory = tempfile::tempdir().unwrap();
    for (line, status) in answers() {
        let file = directory.path().join("answer");
        writes(&line, status, &file);
        // The second time over the first answer.
        writes(&line, status, &file);
        assert_eq!(files_in(directory.path()), ["answer"], "{line}");
    }
}

#[test]
fn a_longer_old_file_is_replaced_whole() {
    let directory =
        directory_with(&[("answer", format!("Set-membership fit\n{}", "old\n".repeat(100_000)).as_bytes())]);
    writes(FIT_TRANSDUCER, 0, &directory.path().join("answer"));
    assert_eq!(files_in(directory.path()), ["answer"]);
}

#[test]
fn a_relative_path_starts_where_the_program_was_started() {
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3\n")]);
    fs::create_dir(directory.path().join("folder")).unwrap();
    for file in ["answer", "./other", "folder/answer", "folder/../third"] {
        assert_eq!(printed(directory.path(), &format!("fit data.csv --x x --y y --eps 1 -o {file}")), "");
        assert!(directory.path().join(file).is_file(), "{file}");
    }
    assert_eq!(files_in(directory.path()), ["answer", "data.csv", "folder", "other", "third"]);
    assert_eq!(files_in(&directory.path().join("folder")), ["answer"]);
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Stdio;

    use tempfile::TempDir;

    use super::*;
    use boundfit_tests::cli::TRANSDUCER;

    fn mode(file: &Path) -> u32 {
        fs::metadata(file).unwrap().permissions().mode() & 0o7777
    }

    #[test]
    fn permissions_are_kept_and_new_ones_are_the_usual_ones() {
        let directory = directory_with(&[("answer", b""), ("plain", b"")]);
        let file = directory.path().join("answer");
        for kept in [0o640, 0o600, 0o755, 0o664] {
            fs::set_permissions(&file, fs::Permissions::from_mode(kept)).unwrap();
            writes(FIT_TRANSDUCER, 0, &file);
            assert_eq!(mode(&file), kept, "{kept:o}");
        }
        let new = directory.path().join("new");
        writes(FIT_TRANSDUCER, 0, &new);
        assert_eq!(mode(&new), mode(&directory.path().join("plain")));
    }

    #[test]
    fn a_link_is_written_through() {
        let directory = directory_with(&[("target", b"Set-membership fit\nold")]);
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link");
        symlink(directory.path().join("target"), &link).unwrap();
        writes(FIT_TRANSDUCER, 0, &link);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(
            fs::read_to_string(directory.path().join("target")).unwrap(),
            printed(&root(), FIT_TRANSDUCER)
        );
        assert_eq!(
            (files_in(directory.path()), files_in(folder.path())),
            (vec!["target".into()], vec!["link".into()])
        );
    }

    #[test]
    fn a_link_to_a_file_that_is_not_there_yet_is_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link");
        symlink("target", &link).unwrap();
        writes(FIT_TRANSDUCER, 0, &link);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(
            fs::read_to_string(folder.path().join("target")).unwrap(),
            printed(&root(), FIT_TRANSDUCER)
        );
    }

    #[test]
    fn a_device_is_written_to() {
        let run = with_output(FIT_TRANSDUCER, Path::new("/dev/null"));
        assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_device_is_an_error() {
        let full = "No space left on device (os error 28)";
        let run = with_output(FIT_TRANSDUCER, Path::new("/dev/full"));
        assert_eq!((run.status, run.stderr), (1, format!("error: /dev/full: cannot write: {full}\n")));
        for line in [FIT_TRANSDUCER, "man fit", "completions bash"] {
            let full_device = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
            let run = finish(command(&root()).args(words(line)).stdout(full_device), b"");
            assert_eq!(
                (run.status, run.stderr),
                (1, format!("error: standard output: cannot write: {full}\n"))
            );
        }
    }

    /// The command lines of the examples in a help text.
    fn examples(help: &str) -> Vec<String> {
        let (_, examples) = help.split_once("Example").unwrap();
        let indented = |line: &&str| line.starts_with("  ") && line.contains("boundfit ");
        let examples = examples.replace("\\\n", " ");
        let lines = examples.lines().skip(1).take_while(|line| !line.is_empty());
        lines.filter(indented).map(|line| line.trim().to_owned()).collect()
    }

    /// Runs a line as a shell would, with `boundfit` on the path.
    fn run_in_shell(directory: &Path, line: &str) -> Run {
        let program = command(directory).get_program().to_owned();
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &format!("boundfit() {{ \"$BOUNDFIT\" \"$@\"; }}\n{line}")]);
        shell.current_dir(directory).env("BOUNDFIT", program);
        finish(shell.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()), b"")
    }

    fn directory_of_examples() -> TempDir {
        directory_with(&[
            ("transducer.csv", fixture("transducer/transducer.csv").as_bytes()),
            ("steam.csv", fixture("steam-generator/steam_generator.csv").as_bytes()),
            ("transducer.mat", &fs::read(root().join("fixtures/mat/transducer-v7.mat")).unwrap()),
            ("current.csv", fixture("worst-line/current.csv").as_bytes()),
            ("fleet.csv", fixture("fleet/levels.csv").as_bytes()),
            ("north.csv", b"t,U\n0,1\n1,3\n2,5\n"),
            ("south.csv", b"t,U\n0,2\n1,3\n2,4\n"),
            ("readings.csv", b"1,0,2\n0,1,3\n1,1,5\n"),
            ("square.ine", b"H-representation\nbegin\n4 3 integer\n1 1 0\n1 -1 0\n1 0 1\n1 0 -1\nend\n"),
        ])
    }

    #[test]
    fn the_examples_of_the_help_run() {
        let directory = directory_of_examples();
        let mut starts = Vec::new();
        for command in ["fit", "verify", "polygon", "plot", "lesson", "completions", "man"] {
            for line in examples(&printed(&root(), &format!("{command} --help"))) {
                // Nothing is installed by a test.
                let run =
                    run_in_shell(directory.path(), &line.replace("/etc/bash_completion.d/", "completions-"));
                assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{line}");
                let first = run.stdout.lines().next().unwrap_or("").to_owned();
                starts.push(format!("{command}: {first}"));
            }
        }
        let expected = [
            "fit: Set-membership fit",
            "fit: Set-membership fit",
            "fit: Set-membership fit",
            "fit: {",
            "fit: ",
            "fit: Set-membership fit",
            "fit: Set-membership fit",
            "fit: Set-membership fit",
            "fit: Set-membership fit with errors in x",
            "fit: group        rows  kind     theta1              theta2                 eps_min",
            "fit: rows    count  kind     theta1                  theta2                eps_min",
            "verify: Set-membership fit",
            "verify: verified: proof.json is true of transducer.csv",
            "verify: verified: proof.json is true of transducer.csv",
            "verify: Set-membership fit",
            "verify: verified: answer.v is about transducer.csv",
            "polygon: Half-planes of square.ine, 4 rows",
            "polygon: ",
            "polygon: Generators of corners.ext, 4 rows",
            "polygon: H-representation",
            "polygon: Half-planes of standard input, 3 rows",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "plot: ",
            "lesson: ",
            "completions: ",
            "man: ",
        ];
        assert_eq!(starts, expected);
        let written = ["completions-boundfit", "boundfit-fit.1"].map(|file| directory.path().join(file));
        assert!(written.iter().all(|file| fs::read_to_string(file).unwrap().contains("boundfit")));
        let pictures = [
            "fps.svg",
            "fps.png",
            "fps.pdf",
            "fps.tikz",
            "both.svg",
            "nested.svg",
            "cells.svg",
            "figures/data.png",
            "figures/directions.png",
            "lesson.html",
        ];
        assert!(pictures.iter().all(|file| directory.path().join(file).exists()));
    }

    #[test]
    fn the_first_example_is_the_published_fit() {
        let directory = directory_of_examples();
        let lines = examples(&printed(&root(), "fit --help"));
        let expected = format!("boundfit {}", FIT_TRANSDUCER.replace("fixtures/transducer/", ""));
        assert_eq!(lines[0], expected);
        let shown = run_in_shell(directory.path(), &lines[0]).stdout;
        assert_eq!(shown.replace("transducer.csv", TRANSDUCER), printed(&root(), FIT_TRANSDUCER));
    }
}

/// The reader of a pipe goes away before everything is written: no message, no panic, the status of the answer.
#[test]
fn a_reader_that_goes_away_is_no_error() {
    for (line, status) in answers() {
        let mut child = command(&root()).args(words(&format!("{line} --digits 1000"))).spawn().unwrap();
        drop(child.stdin.take());
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), said.as_str()), (Some(status), ""), "{line}");
    }
    let all_digits = format!("{FIT_TRANSDUCER} --format json --digits 1000");
    assert!(
        printed(&root(), &all_digits).len() > 1 << 16,
        "fits into a pipe: the reader's absence goes unnoticed"
    );
}

/// The decimal of the first component of the minimax estimate.
fn minimax_decimal(options: &str) -> Value {
    report(&root(), &format!("{FIT_TRANSDUCER} {options}"), b"")["minimax"]["theta"][0]["decimal"].clone()
}

#[test]
fn digits_are_as_many_as_asked_for() {
    for (digits, decimal) in [
        ("1", "2e-3"),
        ("2", "1.8e-3"),
        ("5", "1.8133e-3"),
        ("9", "1.81328595e-3"),
        ("20", "1.8132859461272745406e-3"),
    ] {
        assert_eq!(minimax_decimal(&format!("--digits {digits}")), decimal);
    }
    for digits in [1, 2, 3, 17, 100] {
        check_numbers(&report(&root(), &format!("{FIT_TRANSDUCER} --digits {digits}"), b""), digits);
    }
    let text = printed(&root(), &format!("{FIT_TRANSDUCER} --digits 8"));
    assert!(text.contains("\n  PUI            [0.0017908920, 0.0018483801]"), "{text}");
}

/// Rounded to nearest the figures are those published with the data, digit for digit; outward they enclose the exact values.
#[test]
fn rounding_to_nearest_gives_the_published_figures() {
    let published: Value = serde_json::from_str(&fixture("transducer/published.json")).unwrap();
    let nearest = report(&root(), &format!("{FIT_TRANSDUCER} --rounding nearest"), b"");
    let outward = report(&root(), FIT_TRANSDUCER, b"");
    let decimals = |interval: &Value| json!([interval["lower"]["decimal"], interval["upper"]["decimal"]]);
    for name in ["eui", "pui"] {
        for (axis, parameter) in ["theta1", "theta2"].into_iter().enumerate() {
            assert_eq!(decimals(&nearest[name][axis]), published[name][parameter], "{name} {parameter}");
        }
    }
    let text = printed(&root(), &format!("{FIT_TRANSDUCER} --rounding nearest"));
    assert!(text.contains("\n  PUI            [0.0017909, 0.0018484]  [0.022596, 0.022807]"), "{text}");
    let text = printed(&root(), FIT_TRANSDUCER);
    assert!(text.contains("\n  PUI            [0.0017908, 0.0018484]  [0.022595, 0.022808]"), "{text}");
    let lower = &outward["pui"][0]["lower"];
    let [decimal, value] = [&lower["decimal"], &lower["value"]];
    assert_eq!((lower["exact"].as_str(), decimal.as_str()), (Some("21/11726"), Some("1.7908e-3")));
    assert_eq!(value, &json!(21.0 / 11726.0));
    assert!(rational("1.7908e-3") < rational("21/11726"));
}

#[test]
fn exact_shows_fractions_in_text_and_changes_no_json() {
    let text = printed(&root(), &format!("{FIT_TRANSDUCER} --exact"));
    for piece in [
        "\n  error    |e| <= 1/2000\n",
        "\n  least squares  13889250/7633870643 ",
        " [21/11726, 70/37871] ",
        "\n  All numbers are exact.\n",
        "\neps_min        791/2005400,",
    ] {
        assert!(text.contains(piece), "{piece}\n{text}");
    }
    let json = format!("{FIT_TRANSDUCER} --format json");
    assert_eq!(printed(&root(), &format!("{json} --exact")), printed(&root(), &json));
}

#[test]
fn an_empty_set_is_an_answer_with_its_proof() {
    let line = "fit fixtures/norris/norris.csv --x x --y y --eps 1/2";
    let run = boundfit(&root(), line);
    assert_eq!((run.status, run.stderr.as_str()), (3, ""));
    let expected = "numbers exactly as written\n\nFeasible parameter set (FPS): empty\n\
        \x20 No theta meets every bound. These contradict each other: 4 lower, 29 upper,\n\
        \x20 34 upper.\n\
        \x20 Proof: 1/2 * (4 lower) + 2155/6598 * (29 upper) + 572/3299 * (34 upper) gives\n\
        \x20 0 <= -1.4846.\n\
        \x20 The error bound would have to grow by 1.4847, to at least 1.9847\n\
        \x20 (exactly 130949/65980).\n";
    assert!(run.stdout.contains(expected), "{}", run.stdout);
    let report = report(&root(), line, b"");
    let term = |row: usize, bound: &str, exact: &str, decimal: &str| json!({"row": row, "bound": bound, "multiplier": {"exact": exact, "decimal": decimal, "value": rational(exact).to_f64()}});
    let farkas = json!([
        term(4, "lower", "1/2", "0.5"),
        term(29, "upper", "2155/6598", "0.32661"),
        term(34, "upper", "572/3299", "0.17339")
    ]);
    assert_eq!(report["fps"]["certificate"], json!({"farkas": farkas}));
}

#[test]
fn the_version_is_that_of_the_package() {
    for line in ["--version", "-V"] {
        assert_eq!(printed(&root(), line), format!("boundfit {}\n", env!("CARGO_PKG_VERSION")));
    }
}

/// The options that every command for data has, and those of each.
const SHARED: [&str; 8] =
    ["--reading", "--header", "--delimiter", "--format", "--output", "--digits", "--rounding", "--exact"];
const OF_FIT: [&str; 6] = ["--x", "--y", "--eps", "--eps-column", "--rows", "--where"];

/// The commands that the help lists.
fn commands() -> Vec<String> {
    let help = printed(&root(), "--help");
    let (_, list) = help.split_once("\nCommands:\n").unwrap();
    let names = list.lines().take_while(|line| !line.is_empty()).filter(|line| !line.starts_with("   "));
    let names: Vec<String> = names.map(|line| words(line)[0].clone()).collect();
    for command in ["fit", "polygon", "completions", "man"] {
        assert!(names.iter().any(|name| name == command), "{command}\n{help}");
    }
    names
}

#[test]
fn help_names_every_command_and_option() {
    for command in commands() {
        for line in ["-h", "help"] {
            let help = printed(&root(), line);
            assert!(help.contains(&format!("\n  {command} ")), "{command}\n{help}");
        }
        let of_itself = printed(&root(), &format!("help {command}"));
        assert!(of_itself.contains(&format!("Usage: boundfit {command}")), "{of_itself}");
    }
    // The short help has what is needed first (`help::the_short_help_fits_a_screen_in_groups`).
    for line in ["fit --help", "help fit"] {
        let help = printed(&root(), line);
        for option in SHARED.iter().chain(&OF_FIT) {
            assert!(
                help.contains(&format!(" {option} ")) || help.contains(&format!(" {option}\n")),
                "{option}\n{help}"
            );
        }
        for part in ["\nExamples:\n", "\nExit status:\n  0  ", "\n  1  ", "\n  2  ", "\n  3  "] {
            assert!(help.contains(part), "{part}\n{help}");
        }
    }
    let help = printed(&root(), "polygon --help");
    assert!(SHARED.iter().all(|option| help.contains(option)) && help.contains("\nExamples:\n"), "{help}");
}

#[test]
fn completions_know_every_command_and_option() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = printed(&root(), &format!("completions {shell}"));
        // fish names options without their dashes.
        let written = |option: &str| match shell {
            "fish" => format!("-l {}", option.trim_start_matches('-')),
            _ => option.to_owned(),
        };
        assert!(commands().iter().all(|command| script.contains(command)), "{shell}");
        for option in SHARED.iter().chain(&OF_FIT) {
            assert!(script.contains(&written(option)), "{shell} {option}");
        }
    }
}

#[test]
fn manual_pages_name_every_command_and_option() {
    let page = printed(&root(), "man");
    assert!(page.contains(".TH boundfit 1 "), "{page}");
    for command in commands() {
        let in_roff = format!("\nboundfit\\-{}(1)\n", command.replace('-', "\\-"));
        assert!(page.contains(&in_roff), "{command}\n{page}");
        assert!(printed(&root(), &format!("man {command}")).contains(".SH SYNOPSIS\n"), "{command}");
    }
    let page = printed(&root(), "man fit");
    assert!(page.contains(".TH boundfit-fit 1 "), "{page}");
    for option in SHARED.iter().chain(&OF_FIT) {
        let in_roff = format!("\\fB{}\\fR", option.replace('-', "\\-"));
        assert!(page.contains(&in_roff), "{in_roff}\n{page}");
    }
    assert!(
        page.contains(
            "boundfit fit transducer.csv \\-\\-x Vz \\-\\-y z \\-\\-rows 14..36 \\-\\-eps 0.5e\\-3"
        )
    );
}
