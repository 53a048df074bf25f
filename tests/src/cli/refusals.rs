//! The program's refusal of input that it cannot use.

use std::path::Path;

use crate::program::{Run, root};

use super::{TRANSDUCER, boundfit, command, directory_with, files_in, finish, words};

/// The end of a message about a text that is no number.
pub const A_NUMBER: &str = "(expected a decimal such as 1.30e-2 or a fraction such as 7/19)";

/// An old answer, which a new one may replace.
const OLD: &[u8] = b"{\"schema\":\"boundfit/fit/1\"}";

/// Checks that the program refuses a command line with this status and message. It must write nothing: neither to
/// standard output, nor to a new file, nor over an old one.
pub fn refuses(directory: &Path, line: &str, status: i32, message: &str) {
    check_refusal(&boundfit(directory, line), line, status, message);
    let outputs = directory_with(&[("old", OLD)]);
    for (name, format) in [("new", "text"), ("old", "json")] {
        let mut command = command(directory);
        command.args(words(line)).args(["--format", format, "-o"]).arg(outputs.path().join(name));
        check_refusal(&finish(&mut command, b""), line, status, message);
    }
    assert_eq!(files_in(outputs.path()), ["old"], "{line}");
    assert_eq!(std::fs::read(outputs.path().join("old")).unwrap(), OLD, "{line}");
}

/// Bad data is one line. Bad usage begins with the message; hints on usage follow after a blank line.
pub fn check_refusal(run: &Run, line: &str, status: i32, message: &str) {
    let said = match (status, run.stderr.split_once("\n\n")) {
        (2, Some((first, _))) => format!("{first}\n"),
        _ => run.stderr.clone(),
    };
    let expected = format!("error: {message}\n");
    assert_eq!((run.status, run.stdout.as_str(), said), (status, "", expected), "{line}");
}

/// Checks the messages on files in `fixtures/bad-input`.
pub fn refuses_files(command: &str, options: &str, cases: &[(&str, &str)]) {
    for (file, message) in cases {
        let file = format!("fixtures/bad-input/{file}");
        refuses(&root(), &format!("{command} {file} {options}"), 1, &format!("{file}{message}"));
    }
}

/// Checks the messages on options of a fit of the transducer's data.
pub fn refuses_options(status: i32, cases: &[(&str, &str)]) {
    for (options, message) in cases {
        refuses(&root(), &format!("fit {TRANSDUCER} {options}"), status, message);
    }
}
