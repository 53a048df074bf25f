//! Answers on a terminal, which `script` of Debian's bsdutils makes.

use std::process::{Command, Stdio};

use boundfit_tests::program::{binary, root};

#[test]
fn no_page_and_no_png_is_printed_on_a_terminal() {
    let readings = "fixtures/worst-line/current.csv --x U --y I --eps 4";
    for (line, kind) in [
        ("playground".to_owned(), "page"),
        (format!("lesson {readings}"), "page"),
        (format!("plot {readings} --format png"), "PNG"),
    ] {
        let typed = format!("{} {line}", binary().display());
        let run = Command::new("script")
            .args(["-qec", &typed, "/dev/null"])
            .stdin(Stdio::null())
            .current_dir(root())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&run.stdout).replace('\r', "");
        let refused = format!(
            "error: a {kind} is nothing for a terminal: name a file with '--output', or pipe it on\n"
        );
        assert!(said.starts_with(&refused) && said.len() < 300, "{line}: {said}");
        assert_eq!(run.status.code(), Some(2), "{line}");
    }
}
