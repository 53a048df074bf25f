//! The fuzz targets without a fuzzer: every seed as it stands, then mutations of them, the same on every run.
//!
//! `FUZZ_CASES` sets the number of mutations per target; continuous integration runs more of them.

use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

use boundfit_tests::fuzz_targets::{TARGETS, Target};
use boundfit_tests::generate::seeded;
use boundfit_tests::program::root;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Mutations per target when nothing else is asked for.
const CASES: u32 = 1_000;

/// A place in bytes of any length, as a part of the length.
#[derive(Debug, Clone, Copy)]
struct Index(u32);

impl Index {
    fn any(rng: &mut ChaCha8Rng) -> Self {
        Index(rng.random())
    }

    /// The place in so many bytes; `size` is not 0.
    fn index(self, size: usize) -> usize {
        let place = (u64::from(self.0) * u64::try_from(size).unwrap()) >> 32;
        usize::try_from(place).unwrap()
    }
}

/// One change to some bytes.
#[derive(Debug, Clone, Copy)]
enum Mutation {
    Replace(Index, u8),
    Insert(Index, u8),
    Remove(Index),
    Flip(Index, u8),
    Truncate(Index),
    /// A piece that means something to one of the formats.
    Splice(Index, &'static str),
    /// A stretch of the bytes once more, somewhere else.
    Repeat(Index, Index, Index),
    /// Another seed behind.
    Append(Index),
}

const PIECES: &[&str] = &[
    "\n",
    "\r\n",
    "\r",
    ",",
    ";",
    "\t",
    "\"",
    "\u{feff}",
    "\u{0}",
    "e",
    "-",
    "/",
    ".",
    "1e400",
    "1e-400",
    "99999999999999999999",
    "9223372036854775808",
    "18446744073709551616",
    "inf",
    "nan",
    "begin\n",
    "end\n",
    "linearity 1 1\n",
    "3 3 integer\n",
    "H-representation\n",
    "*",
    "null",
    "[",
    "]",
    "{",
    "}",
    "\"pui\":",
    "\u{2212}",
    "\u{a0}",
    "\u{202f}",
    "D+03",
    "/0",
    "\r \n",
    "# ",
    " (mV)",
    "NA",
    "#DIV/0!",
    "<f>A1</f>",
    " t=\"s\"",
    " r=\"XFD1048576\"",
    " uniqueCount=\"4294967295\"",
    " table:number-columns-repeated=\"16384\"",
    " table:number-rows-repeated=\"1048576\"",
    "<text:s text:c=\"99999\"/>",
    "&#0;",
    "</c>",
];

fn mutation(rng: &mut ChaCha8Rng) -> Mutation {
    let place = Index::any(rng);
    match rng.random_range(0..8) {
        0 => Mutation::Replace(place, rng.random()),
        1 => Mutation::Insert(place, rng.random()),
        2 => Mutation::Remove(place),
        3 => Mutation::Flip(place, rng.random_range(0..8)),
        4 => Mutation::Truncate(place),
        5 => Mutation::Splice(place, PIECES[rng.random_range(0..PIECES.len())]),
        6 => Mutation::Repeat(place, Index::any(rng), Index::any(rng)),
        _ => Mutation::Append(place),
    }
}

/// The longest input: longer ones take time and show no more.
const LONGEST: usize = 4_096;

fn mutated(seeds: &[Vec<u8>], seed: Index, mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = seeds[seed.index(seeds.len())].clone();
    for &mutation in mutations {
        let at = |place: Index, bytes: &[u8]| place.index(bytes.len().max(1));
        let end = |place: Index, bytes: &[u8]| place.index(bytes.len() + 1);
        match mutation {
            Mutation::Replace(place, byte) => {
                let place = at(place, &bytes);
                bytes.iter_mut().skip(place).take(1).for_each(|old| *old = byte);
            }
            Mutation::Flip(place, bit) => {
                let place = at(place, &bytes);
                bytes.iter_mut().skip(place).take(1).for_each(|old| *old ^= 1 << bit);
            }
            Mutation::Insert(place, byte) => bytes.insert(end(place, &bytes), byte),
            Mutation::Remove(place) if !bytes.is_empty() => drop(bytes.remove(at(place, &bytes))),
            Mutation::Remove(_) => {}
            Mutation::Truncate(place) => bytes.truncate(end(place, &bytes)),
            Mutation::Splice(place, piece) => {
                let place = end(place, &bytes);
                drop(bytes.splice(place..place, piece.bytes()));
            }
            Mutation::Repeat(from, to, place) => {
                let (from, to, place) = (end(from, &bytes), end(to, &bytes), end(place, &bytes));
                let piece = bytes[from.min(to)..from.max(to)].to_vec();
                drop(bytes.splice(place..place, piece));
            }
            Mutation::Append(other) => bytes.extend_from_slice(&seeds[other.index(seeds.len())]),
        }
        bytes.truncate(LONGEST);
    }
    bytes
}

/// The files of a folder and of those in it, in order.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of seeds").map(|entry| entry.unwrap().path());
    let parts = entries.map(|path| if path.is_dir() { files_in(&path) } else { vec![path] });
    let mut files: Vec<PathBuf> = parts.flatten().collect();
    files.sort();
    files
}

fn seeds(target: Target) -> Vec<Vec<u8>> {
    // A target whose seeds are all fixtures has no folder of its own.
    let own = Some(root().join("fuzz/seeds").join(target.name)).filter(|folder| folder.is_dir());
    let fixtures = target.fixtures.iter().map(|folder| root().join("fixtures").join(folder));
    let files = own.into_iter().chain(fixtures).flat_map(|folder| files_in(&folder));
    files.map(|file| fs::read(file).unwrap()).collect()
}

fn smoke(target: Target) {
    let (Target { name, body, .. }, seeds) = (target, seeds(target));
    assert!(seeds.len() >= 4, "{name} has few seeds");
    seeds.iter().for_each(|seed| body(seed));
    let cases =
        std::env::var("FUZZ_CASES").map_or(CASES, |cases| cases.parse().expect("FUZZ_CASES is a number"));
    // Each of these cases is a whole computation.
    let cases = if name == "slow_units" { cases / 20 } else { cases };
    let mut rng = seeded(2027);
    for _ in 0..cases {
        let seed = Index::any(&mut rng);
        let count = rng.random_range(0..6);
        let mut mutations: Vec<Mutation> = (0..count).map(|_| mutation(&mut rng)).collect();
        let fails = |mutations: &[Mutation]| {
            let bytes = mutated(&seeds, seed, mutations);
            catch_unwind(|| body(&bytes)).is_err()
        };
        if fails(&mutations) {
            // Mutations that the failure does not need go.
            for place in (0..mutations.len()).rev() {
                let mut fewer = mutations.clone();
                fewer.remove(place);
                if fails(&fewer) {
                    mutations = fewer;
                }
            }
            let bytes = mutated(&seeds, seed, &mutations);
            panic!("{name} fails on {mutations:?}: {:?}", String::from_utf8_lossy(&bytes));
        }
    }
}

#[test]
fn tables() {
    smoke(TARGETS[0]);
}

#[test]
fn numbers() {
    smoke(TARGETS[1]);
}

#[test]
fn half_plane_files() {
    smoke(TARGETS[2]);
}

#[test]
fn mat_files() {
    smoke(TARGETS[3]);
}

#[test]
fn claims() {
    smoke(TARGETS[4]);
}

#[test]
fn polygons() {
    smoke(TARGETS[5]);
}

#[test]
fn proofs() {
    smoke(TARGETS[6]);
}

#[test]
fn models() {
    smoke(TARGETS[7]);
}

#[test]
fn slow_units() {
    smoke(TARGETS[8]);
}

#[test]
fn workbooks() {
    smoke(TARGETS[9]);
}

#[test]
fn packed_tables() {
    smoke(TARGETS[10]);
}
