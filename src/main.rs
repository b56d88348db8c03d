//! The command `groundwave`: hands its arguments to `cli`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main(std::env::args_os())
}
