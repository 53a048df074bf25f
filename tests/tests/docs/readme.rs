//! The examples of the documentation, run as they stand. `SNAPSHOTS=overwrite cargo test` rewrites what they print.

use std::fs;
use std::process::Command;

use boundfit_tests::program::{binary, root};

use crate::pages::pages;

/// Returns the output of a shell for a command line of a page, with the status added when it is not 0.
fn output_of(command: &str) -> String {
    // The program is on nobody's path here; these functions stand in for an installed one and for `cargo run`.
    let script = format!(
        "boundfit() {{ \"$BOUNDFIT\" \"$@\"; }}
        cargo() {{ case $* in *\" --bin bench-solvers \"*) shift 6; \"$BENCH\" \"$@\";; *) shift 3; \"$BOUNDFIT\" \"$@\";; esac; }}
        {command}\n"
    );
    let output = Command::new("sh")
        .args(["-c", &script])
        .env("BOUNDFIT", binary())
        .env("BENCH", env!("CARGO_BIN_EXE_bench-solvers"))
        .current_dir(root())
        .output()
        .unwrap();
    let mut text = String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap();
    if let Some(status @ 1..) = output.status.code() {
        text.push_str(&format!("(exit status {status})\n"));
    }
    text
}

/// A page with the output of every command in a `console` block replaced, and how many commands there were.
fn rerun(page: &str) -> (String, usize) {
    let mut result = String::new();
    let mut commands = 0;
    let mut in_block = false;
    let mut in_output = false;
    for line in page.lines() {
        // The text between these comments is the output of the command, as Markdown.
        let output = line.strip_prefix("<!-- output of: ").and_then(|rest| rest.strip_suffix(" -->"));
        if let Some(command) = output {
            commands += 1;
            in_output = true;
            result.push_str(&format!("{line}\n{}", output_of(command)));
            continue;
        }
        in_output &= line != "<!-- end of output -->";
        if in_output {
            continue;
        }
        match line.strip_prefix("$ ") {
            _ if line.starts_with("```") => in_block = line == "```console",
            Some(command) if in_block => {
                commands += 1;
                result.push_str(&format!("{line}\n{}", output_of(command)));
                continue;
            }
            _ if in_block => continue,
            _ => {}
        }
        result.push_str(line);
        result.push('\n');
    }
    (result, commands)
}

#[test]
fn every_example_prints_what_the_page_says() {
    let bless = std::env::var_os("SNAPSHOTS").is_some_and(|action| action == "overwrite");
    let mut examples = 0;
    for page in pages() {
        let (rerun, commands) = rerun(&page.text);
        examples += commands;
        if bless {
            fs::write(root().join(&page.path), &rerun).unwrap();
            continue;
        }
        let path = page.path.display();
        for (number, (said, printed)) in (1..).zip(page.text.lines().zip(rerun.lines())) {
            assert_eq!(said, printed, "{path} line {number}: left is what it says, right what is printed");
        }
        assert_eq!(page.text.lines().count(), rerun.lines().count(), "{path}");
    }
    assert!(examples >= 25, "only {examples} examples");
}

#[test]
fn the_readme_begins_with_the_two_commands_that_set_everything_up() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let commands: Vec<&str> = readme
        .lines()
        .filter(|line| line.starts_with("cargo ") || line.starts_with("$ cargo "))
        .map(|line| line.trim_start_matches("$ "))
        .collect();
    let main_job = "cargo run --no-default-features -- fit fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";
    assert_eq!(commands[..2], [main_job, "cargo test --workspace"]);
}
