//! Command lines about small files.

use std::fs;
use std::sync::OnceLock;

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::files::{as_file, bomb, cdd, gzip, model, rows, size, table};
use super::mutations::mutated;
use super::numbers::{Written, bound, number, written};
use super::questions::asked_of_table;
use super::{Case, MOST_BYTES, one_of};
use crate::cli::words;
use crate::program::root;

const REPORTS: [&str; 9] = ["text", "json", "csv", "wkt", "m", "ine", "ext", "latex", "markdown"];
const FIGURES: [&str; 7] = ["data", "eui", "pui", "fps", "directions", "empty", "all"];

/// A command line of words that do not come from files.
fn line(text: &str) -> Vec<String> {
    words(text)
}

/// A way of asking for x, y and the error bound.
fn question(rng: &mut ChaCha8Rng) -> Vec<String> {
    let mut line =
        line(one_of(rng, &["--x x --y y", "--x x --y y", "--x x --y y", "--x u,x --y y", "--x 1 --y 2"]));
    match rng.random_range(0..12) {
        0 => line.extend(words("--eps-column u")),
        1 => line.extend(words("--lower x --upper u")),
        _ => line.extend(["--eps".to_owned(), bound(rng)]),
    }
    match rng.random_range(0..16) {
        0 => line.extend(words("--reading binary64")),
        1 => line.push("--through-origin".to_owned()),
        2 => line.extend(["--x-origin".to_owned(), number(rng, Written::Far, 0)]),
        3..5 => {
            for _ in 0..rng.random_range(1..4) {
                let written = written(rng);
                let condition = format!(
                    "{}*theta1 - {}*theta2 <= {}",
                    number(rng, Written::Digit, 0).replace('-', ""),
                    number(rng, Written::Digit, 0).replace('-', ""),
                    number(rng, written, 0)
                );
                line.extend(["--where".to_owned(), condition]);
            }
        }
        5 => line.extend(words("--where-row 'x >= 1e-5'")),
        6 => line.extend(words("--missing skip")),
        _ => {}
    }
    line
}

/// Returns how decimals of a report look.
fn style(rng: &mut ChaCha8Rng) -> Vec<String> {
    line(one_of(rng, &["", "", "", "--exact", "--digits 1000", "--rounding nearest", "--digits 25"]))
}

fn table_command(rng: &mut ChaCha8Rng, file: &str) -> Vec<Vec<String>> {
    let question = question(rng);
    let all = |command: &[&str]| -> Vec<String> {
        let words = command.iter().flat_map(|part| words(part));
        words.chain([file.to_owned()]).chain(question.clone()).collect()
    };
    if rng.random_bool(0.5) {
        return asked_of_table(rng, file, &question);
    }
    let fit = match rng.random_range(0..14) {
        0..5 => {
            let format = one_of(rng, &REPORTS);
            [all(&["fit --format", format]), style(rng)].concat()
        }
        5 => {
            let sweep = one_of(rng, &["0..2", "0..1e9999", "1/3..7", "0.9..1.1", "1..1"]);
            let format = one_of(rng, &["text", "json"]);
            [all(&["fit --format", format, "--sweep", sweep]), style(rng)].concat()
        }
        6 => {
            let format = one_of(rng, &["text", "json", "csv"]);
            let by = one_of(rng, &["x", "y", "u"]);
            all(&["fit --by", by, "--format", format])
        }
        7 => {
            let parts: Vec<String> = question.iter().filter(|word| !word.contains("min")).cloned().collect();
            [line("reduce"), vec![file.to_owned()], parts].concat()
        }
        8 => [all(&["check"]), style(rng)].concat(),
        9 => {
            let ends: Vec<String> = (0..4)
                .map(|_| {
                    let kind = written(rng);
                    number(rng, kind, 1)
                })
                .collect();
            [all(&["check --solver exact-simplex"]), vec![format!("--claim-pui={}", ends.join(","))]].concat()
        }
        10 => {
            let figure = one_of(rng, &FIGURES);
            let output = if figure == "all" { "figures" } else { one_of(rng, &["a.svg", "a.svg", "a.png"]) };
            all(&["plot --figure", figure, "-o", output])
        }
        11 | 12 => all(&["lesson -o a.html"]),
        _ => {
            let format = one_of(rng, &["lp", "mps"]);
            all(&["convert --objective theta1-max --to", format])
        }
    };
    if rng.random_range(0..12) == 0 {
        let proof = all(&["fit --no-lp -o r.txt --proof p.json"]);
        return vec![proof, words(&format!("verify p.json {file}"))];
    }
    vec![fit]
}

/// A fit of a table and all that is done with one.
pub(super) fn about_table(rng: &mut ChaCha8Rng) -> Case {
    let table = table(rng);
    let (name, content) = as_file(rng, &table);
    let lines = table_command(rng, &name);
    Case { files: vec![(name, content)], lines }
}

fn polygon_command(rng: &mut ChaCha8Rng, file: &str) -> Vec<String> {
    let format = one_of(rng, &REPORTS);
    [words(&format!("polygon {file} --format {format}")), style(rng)].concat()
}

/// Half-planes and points.
pub(super) fn about_half_planes(rng: &mut ChaCha8Rng) -> Case {
    let (name, content) = if rng.random_bool(0.3) {
        let bytes = size(rng);
        ("data.csv".to_owned(), format!("a1,a2,b\n{}", rows(rng, 3, bytes)).into_bytes())
    } else {
        cdd(rng)
    };
    let lines = vec![polygon_command(rng, &name)];
    Case { files: vec![(name, content)], lines }
}

fn judge_command(rng: &mut ChaCha8Rng, file: &str) -> Vec<String> {
    let more = one_of(rng, &["", "", "--plot a.svg", "--solution s.sol", "--solution s.json"]);
    let format = one_of(rng, &["text", "json"]);
    let judge = words(&format!("judge {file} --format {format} {more}"));
    [judge, style(rng)].concat()
}

fn solution(rng: &mut ChaCha8Rng) -> (String, Vec<u8>) {
    let kind = written(rng);
    let (x, y) = (number(rng, kind, 1), number(rng, kind, 2));
    if rng.random_bool(0.5) {
        let text = format!("=obj= {x}\nx {x}\ny {y}\n");
        return ("s.sol".to_owned(), text.into_bytes());
    }
    let text = format!(
        "{{\"status\": \"optimal\", \"objective\": \"{x}\", \"point\": {{\"x\": \"{x}\", \"y\": \"{y}\"}}}}"
    );
    ("s.json".to_owned(), text.into_bytes())
}

/// Linear programs with solutions.
pub(super) fn about_model(rng: &mut ChaCha8Rng) -> Case {
    let (name, content) = if rng.random_bool(0.2) {
        let (name, seed) = seed_ending(rng, &["mps", "lp"]);
        (name, mutated(rng, &seed))
    } else {
        model(rng)
    };
    let lines = vec![judge_command(rng, &name)];
    Case { files: vec![(name, content), solution(rng)], lines }
}

/// Claims about a fit, right or not.
pub(super) fn about_claims(rng: &mut ChaCha8Rng) -> Case {
    let bytes = rng.random_range(30..2500);
    let table = format!("x,y\n{}", rows(rng, 2, bytes));
    let kind = written(rng);
    let mut cell = || number(rng, kind, 1);
    let claims = match cell().len() % 3 {
        0 => format!("{{\"pui\": [[\"{}\", \"{}\"], [\"{}\", \"{}\"]]}}", cell(), cell(), cell(), cell()),
        1 => format!(
            "{{\"theta1-min\": {{\"status\": \"optimal\", \"objective\": {}, \"point\": [{}, {}]}}}}",
            cell(),
            cell(),
            cell()
        ),
        _ => String::new(),
    };
    let (name, claims) = if claims.is_empty() {
        let (name, seed) = seed_ending(rng, &["json", "sol"]);
        (name, mutated(rng, &seed))
    } else {
        ("claims.json".to_owned(), claims.into_bytes())
    };
    let check =
        [words("check data.csv --x x --y y --claim"), vec![name.clone(), "--eps".to_owned(), bound(rng)]];
    Case {
        files: vec![("data.csv".to_owned(), table.into_bytes()), (name, claims)],
        lines: vec![check.concat()],
    }
}

/// Proofs as they are, and changed.
pub(super) fn about_proof(rng: &mut ChaCha8Rng) -> Case {
    let (_, seed) = seed_in(rng, "fuzz/seeds/proof_files");
    let (name, bytes) = ("p.json".to_owned(), mutated(rng, &seed));
    let bytes = bytes.into_iter().skip(usize::from(rng.random_bool(0.3))).collect();
    let table = format!("x,y\n{}", rows(rng, 2, 300));
    let data = one_of(rng, &["data.csv", "data.csv", "/dev/zero"]);
    let lines = vec![words(&format!("verify p.json {data}"))];
    Case { files: vec![(name, bytes), ("data.csv".to_owned(), table.into_bytes())], lines }
}

/// Reductions, whose sums are stated.
pub(super) fn about_reduction(rng: &mut ChaCha8Rng) -> Case {
    let bytes = rng.random_range(30..2000);
    let table = rows(rng, 2, bytes);
    let count = table.lines().count();
    let kind = written(rng);
    let sums: Vec<String> = (0..4).map(|_| format!("\"{}\"", number(rng, kind, 2))).collect();
    let rows = one_of(rng, &[count, count * 2, 1_000_000_000]);
    let text = format!(
        "# boundfit/reduced/1 {{\"rows\":{rows},\"kept\":{count},\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
         \"epsilon\":null,\"sums\":[{}]}}\nx,y\n{table}",
        sums.join(",")
    );
    let text = if rng.random_bool(0.3) { mutated(rng, text.as_bytes()) } else { text.into_bytes() };
    let lines = table_command(rng, "data.csv");
    Case { files: vec![("data.csv".to_owned(), text)], lines }
}

/// Returns what unpacks to more than it is.
pub(super) fn about_packed(rng: &mut ChaCha8Rng) -> Case {
    let (name, content) = bomb(rng);
    let lines = table_command(rng, &name);
    Case { files: vec![(name, content)], lines }
}

/// A shipped file, changed, in a command that may read it.
pub(super) fn about_seed(rng: &mut ChaCha8Rng) -> Case {
    let (name, seed) = one_of(rng, seeds());
    let content = mutated(rng, &seed);
    let content = if rng.random_range(0..20) == 0 { gzip(&content) } else { content };
    let lines = match rng.random_range(0..4) {
        0 => vec![polygon_command(rng, &name)],
        1 => vec![judge_command(rng, &name)],
        _ => table_command(rng, &name),
    };
    Case { files: vec![(name, content)], lines }
}

/// Shipped files that are small enough, with the last parts of their names.
fn seeds() -> &'static [(String, Vec<u8>)] {
    static SEEDS: OnceLock<Vec<(String, Vec<u8>)>> = OnceLock::new();
    SEEDS.get_or_init(|| {
        let mut seeds = Vec::new();
        let mut folders = vec![root().join("fixtures"), root().join("fuzz/seeds")];
        while let Some(folder) = folders.pop() {
            let mut paths: Vec<_> = fs::read_dir(folder)
                .expect("a folder of the repository")
                .map(|entry| entry.expect("a file").path())
                .collect();
            // Their order is that of the file system, which must not matter.
            paths.sort();
            for path in paths {
                if path.is_dir() {
                    folders.push(path);
                } else if path.metadata().is_ok_and(|data| data.len() < MOST_BYTES as u64 - 700) {
                    let name = path.file_name().expect("a file").to_string_lossy().into_owned();
                    seeds.push((name, fs::read(&path).expect("a readable file")));
                }
            }
        }
        seeds
    })
}

fn seed_ending(rng: &mut ChaCha8Rng, endings: &[&str]) -> (String, Vec<u8>) {
    let fits = |name: &str| endings.iter().any(|ending| name.ends_with(&format!(".{ending}")));
    let some: Vec<&(String, Vec<u8>)> = seeds().iter().filter(|(name, _)| fits(name)).collect();
    one_of(rng, &some).clone()
}

fn seed_in(rng: &mut ChaCha8Rng, folder: &str) -> (String, Vec<u8>) {
    let mut paths: Vec<_> = fs::read_dir(root().join(folder))
        .expect("a folder")
        .map(|entry| entry.expect("a file").path())
        .collect();
    paths.sort();
    let path = one_of(rng, &paths);
    ("seed".to_owned(), fs::read(path).expect("a readable file"))
}
