//! The `boundfit` program.

fn main() -> std::process::ExitCode {
    boundfit_cli::main()
}
