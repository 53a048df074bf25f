//! `tests/verify.py`, the checker in Python, asked about many proofs in one process.

use std::io::Write;
use std::process::Command;

use crate::program::root;

/// Asks the checker about proofs and data, each after its length, in one process, and prints the statuses.
const ASK: &str = "
import io, sys
sys.path.insert(0, sys.argv[1])
import verify
with open(sys.argv[2], 'rb') as cases:
    def part(): return cases.read(int.from_bytes(cases.read(4), 'little'))
    for _ in range(int(sys.argv[3])): print(verify.status(part(), io.BytesIO(part()))[0])
";

/// The status of the checker in Python for each proof: 0 true, 4 false, 1 no proof, or data beyond a limit.
///
/// # Panics
/// Without Python, or when the checker fails.
pub fn statuses_in_python(cases: &[(Vec<u8>, &[u8])]) -> Vec<i32> {
    let mut file = tempfile::NamedTempFile::new().expect("a file");
    for part in cases.iter().flat_map(|(proof, data)| [proof.as_slice(), data]) {
        file.write_all(&u32::try_from(part.len()).expect("a short text").to_le_bytes()).expect("a file");
        file.write_all(part).expect("a file");
    }
    let mut command = Command::new("python3");
    let output = command
        .args(["-c", ASK])
        .arg(root().join("tests"))
        .arg(file.path())
        .arg(cases.len().to_string())
        .output();
    let output = output.expect("python3 is needed: install Python 3.11 or newer");
    let text = String::from_utf8(output.stdout).expect("text");
    let statuses: Vec<i32> = text.lines().map(|line| line.parse().expect("a status")).collect();
    assert_eq!(statuses.len(), cases.len(), "{}", String::from_utf8_lossy(&output.stderr));
    statuses
}
