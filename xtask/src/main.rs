//! Tasks of those who change boundfit: `cargo xtask TASK`.

use std::env;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (task, _options) = match arguments.split_first() {
        Some((task, options)) => (task.as_str(), options),
        None => ("", [].as_slice()),
    };
    match task {
        _ => {
            std::io::Write::write_all(&mut std::io::stderr(), b"cargo xtask TASK\n").unwrap_or_default();
            ExitCode::from(2)
        }
    }
}
