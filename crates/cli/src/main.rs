//! The `boundfit` program.

fn main() -> std::process::ExitCode {
    boundfit::main()
}
