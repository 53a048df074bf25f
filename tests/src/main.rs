//! The `boundfit` program under another name, for the tests of this package.

fn main() -> std::process::ExitCode {
    boundfit_cli::main()
}
