//! No small input is expensive: whatever is in a few kilobytes, every command ends within two seconds of processor time and
//! 64 MB, with an answer or a message.

#![cfg(target_os = "linux")]

use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use boundfit_tests::hostile::{Case, Ended, LIMITS, case, run_limited};

/// Cases when nothing else is asked for. `SMALL_CASES` sets another number.
const CASES: u64 = 150;

#[test]
fn no_small_input_is_expensive() {
    let asked = |name: &str| std::env::var(name).ok().map(|value| value.parse::<u64>().unwrap());
    let count = asked("SMALL_CASES").unwrap_or(CASES);
    let first = asked("SMALL_SEED").unwrap_or(0);
    let next = AtomicU64::new(first);
    let failures: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..thread::available_parallelism().map_or(2, usize::from))
            .map(|_| {
                scope.spawn(|| {
                    let mut failures = Vec::new();
                    loop {
                        let seed = next.fetch_add(1, Ordering::Relaxed);
                        if seed >= first + count {
                            return failures;
                        }
                        failures.extend(failure(seed, &case(seed)));
                    }
                })
            })
            .collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
}

/// Returns the fault of a case. Its files are kept then.
fn failure(seed: u64, case: &Case) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in &case.files {
        fs::write(folder.path().join(name), content).unwrap();
    }
    for words in &case.lines {
        let run = || run_limited(folder.path(), words, LIMITS);
        // On a processor that is shared the same work may take half as long again: what is too much is so twice.
        let ended = Some(run()).filter(Ended::is_well).unwrap_or_else(run);
        if !ended.is_well() {
            let kept = folder.keep();
            return Some(format!(
                "seed {seed}: cd {}; boundfit {} # {ended:?}",
                kept.display(),
                words.join(" ")
            ));
        }
    }
    None
}
