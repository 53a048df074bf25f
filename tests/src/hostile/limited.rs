//! The program under limits on time and memory.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::cli::{directory_with, words};
use crate::program::binary;

/// The cost that a run may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Processor time of all threads.
    pub cpu: Duration,
    /// Bytes of data: what is allocated, and the stacks of threads.
    pub data: u64,
}

/// The cost that a small input may have.
pub const LIMITS: Cost = Cost { cpu: Duration::from_secs(2), data: 64 << 20 };

/// The cost of a refusal on a slow and busy machine that takes two seconds on a quiet one, with the memory that a laptop
/// has to spare.
pub const FEW_SECONDS: Cost = Cost { cpu: Duration::from_secs(15), data: 512 << 20 };

/// The message on a file that is mostly repetition.
pub const TOO_FAR: &str = "refused: it unpacks to more than 67108864 bytes and 100 times its size (the limit); --limit ratio=N raises it\n";

/// The end of a run.
#[derive(Debug)]
pub struct Ended {
    /// Exit status; `None` where a signal ended it: for the processor time, or for memory that could not be had.
    pub status: Option<i32>,
    /// Standard error, and behind it what the shell says of the time.
    pub messages: String,
}

impl Ended {
    /// Returns whether the program came to an end of its own, with an answer or a message.
    pub fn is_well(&self) -> bool {
        self.status.is_some_and(|status| (0..=4).contains(&status)) && !self.messages.contains("panicked")
    }
}

/// Runs the program in a folder under limits that the system enforces. This function ignores the output.
///
/// The limit on memory is one on data: that on addresses would count what threads and the allocator put by and never use.
pub fn run_limited(folder: &Path, words: &[String], limits: Cost) -> Ended {
    let kilobytes = limits.data >> 10;
    let seconds = limits.cpu.as_secs();
    let script = format!("ulimit -t {seconds}; ulimit -d {kilobytes}; ulimit -c 0; exec \"$0\" \"$@\"");
    let run = Command::new("sh")
        .args(["-c", &script])
        .arg(binary())
        .args(words)
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "2")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .output()
        .expect("a shell starts");
    Ended { status: run.status.code(), messages: String::from_utf8_lossy(&run.stderr).into_owned() }
}

/// Checks that a command about a file ends in time with a message.
pub fn refused(content: &[u8], line: &str, message: &str, limits: Cost) {
    let directory = directory_with(&[("bomb", content), ("few.csv", b"x,y\n1,2\n2,3\n")]);
    let ended = run_limited(directory.path(), &words(&line.replace("FILE", "bomb")), limits);
    assert!(
        ended.status == Some(1) && ended.messages.ends_with(message),
        "{line}: {ended:?}, {} bytes",
        content.len()
    );
}
