//! The steps in their order. Programs are installed while the compiler works: steps that need one come after those that do not.

use super::programs::{
    CBC, CDD, CHROMIUM, CMAKE, COQ, CXX, GLPK, LATEX, LIBCLANG, LRS, NODE, OCTAVE, PYTHON, Program, TIKZ,
    VALGRIND, VENV,
};

/// A step of continuous integration.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Step {
    /// The name that people type.
    pub(super) name: &'static str,
    /// The fact that holds if the step succeeds.
    pub(super) holds: &'static str,
    /// The changes that need the step.
    pub(super) changes: &'static str,
    /// The programs that it starts, cargo aside.
    pub(super) needs: &'static [Program],
    /// `true` for a step that runs beside others, since it would leave a processor free. Such steps have lanes of their own.
    pub(super) beside: bool,
    /// Commands of bash, run from the top of the repository; the first that fails ends the step. `$built` is cargo's folder.
    pub(super) script: &'static str,
}

/// A step that needs no program and runs after the others.
const PLAIN: Step = Step { name: "", holds: "", changes: "", needs: &[], beside: false, script: "" };

/// Every step.
pub(super) static STEPS: &[Step] = &[
    Step {
        name: "format",
        holds: "rustfmt has nothing to change",
        changes: "every change of Rust",
        script: "\
cargo fmt --all --check
cargo fmt --manifest-path python/Cargo.toml --check
cargo fmt --manifest-path wasm/Cargo.toml --all --check",
        ..PLAIN
    },
    Step {
        name: "lints",
        holds: "clippy finds nothing in the workspace",
        changes: "every change of Rust",
        // The features of both commands are the same, so that the second checks no more than targets that `cargo test` leaves out.
        // `core` has the crates without these features.
        script: "\
features=tests/arrow,tests/benches
cargo clippy --workspace --all-targets --features \"$features\" --locked -- -D warnings
cargo clippy --workspace --test external --test kernel --features \"$features\" --locked -- -D warnings",
        ..PLAIN
    },
    Step {
        name: "docs",
        holds: "rustdoc finds no broken link and no public item without documentation",
        changes: "public items and their comments",
        script: "RUSTDOCFLAGS='-D warnings' cargo doc --workspace --no-deps --locked",
        ..PLAIN
    },
    Step {
        name: "core",
        holds: "every crate builds with its fewest features and without warnings, and the library's core has no thread, file, clock or linear algebra",
        changes: "dependencies, features and `cfg`",
        script: "\
for part in exact geometry estimation lp judge questions check report figures lesson; do
  cargo clippy --locked --package \"boundfit-$part\" --no-default-features -- -D warnings
done
for feature in '' nalgebra files files,matlab files,packed lp judge questions verify report figures tikz lesson lesson,engine; do
  cargo clippy --locked --package boundfit --no-default-features --features \"$feature\" -- -D warnings
done
core=$(cargo tree --locked --package boundfit --no-default-features --features lp,judge --edges normal --prefix none)
if grep -E '^(rayon|tempfile|web-time|clarabel|microlp|nalgebra|boundfit-formats) ' <<< \"$core\"; then
  echo 'the core of the library needs threads, files, clocks or linear algebra' >&2; exit 1
fi",
        ..PLAIN
    },
    Step {
        name: "package",
        holds: "every crate has what crates.io asks for",
        changes: "manifests, and files that a crate includes",
        script: "cargo package --workspace --exclude tests --exclude xtask --locked --no-verify --allow-dirty --quiet",
        ..PLAIN
    },
    Step {
        name: "first-command",
        holds: "the first command of README does its job",
        changes: "the profile `dev`, dependencies of the program, README's beginning",
        script: "eval \"$(grep '^cargo ' README.md | sed -n 1p)\"",
        ..PLAIN
    },
    Step {
        name: "shipped",
        holds: "the program as it is installed answers the same, in at most 20 MB",
        changes: "the profile `release`, dependencies of the program",
        beside: true,
        // Float solvers are not among what the first command builds.
        script: "\
cargo build --release --locked
size=$(stat -c %s \"$built/release/boundfit\")
echo \"$size bytes\"
[ \"$size\" -le 20000000 ] || { echo 'more than 20 MB' >&2; exit 1; }
first=$(grep '^cargo ' README.md | sed -n 1p)
diff <(eval \"$first\" | grep -v '^LP solver') <(eval \"$built/release/boundfit ${first#* -- }\" | grep -v '^LP solver')",
        ..PLAIN
    },
    Step {
        name: "tiny-lp",
        holds: "the answers of the tiny linear programs are proved without boundfit",
        changes: "fixtures/tiny-lp",
        needs: &[PYTHON],
        script: "python3 fixtures/tiny-lp/check.py",
        ..PLAIN
    },
    Step {
        name: "scripts",
        holds: "the scripts that compare speed are Python",
        changes: "benches",
        needs: &[PYTHON],
        script: "python3 -m py_compile benches/side-by-side benches/peers/peers.py",
        ..PLAIN
    },
    Step {
        name: "examples",
        holds: "the examples of the library run",
        changes: "crate boundfit and what it shows",
        // As in `differential`: `cargo run --example` would build all crates with other features.
        script: "\
cargo test --workspace --locked --no-run --quiet
for example in fit polygon judge teach; do
  \"$built/debug/examples/$example\"
done",
        ..PLAIN
    },
    Step {
        name: "book",
        holds: "the manual becomes a book, target/book",
        changes: "docs",
        // Building mdBook takes three minutes of processor time; this wheel has its program, and its hash is known.
        needs: &[PYTHON, VENV],
        script: "\
if ! command -v mdbook > /dev/null; then
  python3 -m venv target/mdbook
  target/mdbook/bin/pip install --quiet --require-hashes --requirement .ci/mdbook.txt
  PATH=$PWD/target/mdbook/bin:$PATH
fi
mdbook build docs",
        ..PLAIN
    },
    Step {
        name: "prose",
        holds: "no folder has more long sentences or unclear beginnings than xtask/prose.txt says",
        changes: "every page and comment",
        script: "cargo xtask prose",
        ..PLAIN
    },
    Step {
        name: "build-tests",
        holds: "the tests compile",
        changes: "every change of Rust; `tests` does it too",
        script: "cargo test --workspace --locked --no-run",
        ..PLAIN
    },
    Step {
        name: "generated",
        holds: "schemas, declarations and references are those of the types and options",
        changes: "types of answers and requests, options",
        // As in `differential`: of one package alone cargo would build all crates with other features.
        script: "\
cargo test --workspace --locked --no-run --quiet
\"$built/debug/references\" --check",
        ..PLAIN
    },
    Step {
        name: "peers",
        holds: "lrs, cddlib, GLPK, CBC, HiGHS, Octave, LaTeX and Python read what boundfit writes and answer the same",
        changes: "exporters, readers of solutions, answers",
        needs: &[LRS, CDD, GLPK, CBC, OCTAVE, LATEX, TIKZ, PYTHON, VENV],
        script: "cargo test --workspace --locked --test external",
        ..PLAIN
    },
    Step {
        name: "kernel",
        holds: "Coq's kernel accepts theorems about answers, and what it accepts is true",
        changes: "crate report (kernel), exporters of theorems",
        needs: &[COQ],
        script: "cargo test --workspace --locked --test kernel -- --nocapture",
        ..PLAIN
    },
    Step {
        name: "features",
        holds: "Parquet and Arrow files are read as other tables are, and HiGHS, the optional solver, gets the verdicts that are stored",
        changes: "crates formats, estimation, lp, check and judge",
        needs: &[CMAKE, CXX, LIBCLANG],
        // Both features at once: each set of features is another build of most crates. The tests that a feature changes are a program
        // of their own, so that the large ones are not built again. HiGHS is not optimised, which would take longer than all that it
        // solves here.
        script: "\
export CMAKE_TOOLCHAIN_FILE=$PWD/.ci/highs.cmake
cargo test --package tests --locked --no-default-features --features arrow,highs,boundfit-cli/highs --test columnar
\"$built/debug/bench-solvers\" fixtures/hard-lp | tee target/conformance.md
diff fixtures/hard-lp/conformance-with-highs.md target/conformance.md",
        ..PLAIN
    },
    Step {
        name: "differential",
        holds: "clipping, envelopes, brute force and the exact simplex agree on 20,000 generated sets",
        changes: "crates exact, geometry, estimation and lp",
        // `cargo run --package tests` would ask for other features of the crates, and build them all once more.
        script: "\
cargo test --workspace --locked --no-run --quiet
\"$built/debug/deep\" --cases 20000",
        ..PLAIN
    },
    Step {
        name: "fuzz",
        holds: "no target of the fuzzer fails on seeds and 10,000 mutations of them",
        changes: "everything that reads input",
        script: "FUZZ_CASES=10000 cargo test --workspace --locked --test formats fuzz_smoke",
        ..PLAIN
    },
    Step {
        name: "small-inputs",
        holds: "every command ends within two seconds of processor time and 64 MB for any input of 4 kB",
        changes: "everything that reads input or computes",
        // The promise is the time of the program as it is installed.
        script: "\
cargo build --release --locked
BOUNDFIT_PROGRAM=$built/release/boundfit SMALL_CASES=5000 cargo test --workspace --locked --test cli small_inputs",
        ..PLAIN
    },
    Step {
        name: "wasm-source",
        holds: "if its source has changed since the checked-in WebAssembly module: the module of today answers as the program does",
        changes: "wasm, answers",
        needs: &[NODE],
        beside: true,
        // wasm/README.md names the commit that the checked-in module is from. A clone without that commit builds the module.
        script: "\
commit=$(sed -n 's/.* were made on commit \\([0-9a-f]*\\) .*/\\1/p' wasm/README.md)
crates=$(sed -n 's|^name = \"boundfit-\\(.*\\)\"|crates/\\1|p' wasm/Cargo.lock)
own='Cargo.toml crates/boundfit wasm/src wasm/pack wasm/Cargo.toml wasm/Cargo.lock wasm/build.sh'
if git diff --quiet \"$commit\" -- $crates $own ':!crates/lesson/engine' 2> /dev/null; then
  echo \"not built: its source has not changed since $commit, from which the checked-in module is\"
elif [ \"$(id -u)\" = 0 ] && apt-get install --simulate rustc-web rust-web-src binaryen > target/compiler.log 2>&1; then
  CARGO_TARGET_DIR=wasm/target cargo clippy --manifest-path wasm/Cargo.toml --workspace --locked -- -D warnings
  wasm/build.sh target/engine
  cargo build --release --locked
  BOUNDFIT_PROGRAM=$built/release/boundfit BOUNDFIT_ENGINE=target/engine node --test wasm/test.mjs
  ls -l target/engine
else
  echo 'not built: there is no Debian compiler for browsers here'; cat target/compiler.log 2>/dev/null || true
fi",
    },
    Step {
        name: "python",
        holds: "the wheel answers as the program does, and its types are right",
        changes: "python, and every crate that it shows",
        needs: &[PYTHON, VENV],
        beside: true,
        // The link of the wheel that people get takes minutes, and so does the optimisation of what it is linked from. This step's wheel
        // has the profile of the tests, under the name that maturin knows, and shares what they have built; it answers the same.
        // `cargo clippy` would check every crate below once more; in place of the compiler, its driver takes those of the wheel. Most
        // modules of other packages are never imported: Python compiles those that are.
        script: "\
python3 -m venv --clear target/python
target/python/bin/pip install --quiet --no-compile 'maturin>=1.9,<2' -r python/tests/requirements.txt
rm -rf target/wheels
export VIRTUAL_ENV=$PWD/target/python CARGO_TARGET_DIR=$built
sed -n '/^.profile.test/,/^$/{s/profile.test/profile.dev/; p}' Cargo.toml > target/wheel.toml
target/python/bin/maturin build --config Cargo.toml --config target/wheel.toml --locked --out target/wheels
target/python/bin/pip install --quiet target/wheels/*.whl
wheel='--manifest-path python/Cargo.toml --config Cargo.toml --config target/wheel.toml --locked --lib'
RUSTC_WORKSPACE_WRAPPER=clippy-driver cargo rustc $wheel -- -D warnings
cargo build --release --locked
export BOUNDFIT_PROGRAM=$built/release/boundfit
target/python/bin/python -m pytest --quiet python/tests
target/python/bin/python -m mypy --strict python/boundfit
target/python/bin/python -m pyright --pythonpath target/python/bin/python python/boundfit",
    },
    Step {
        name: "browser",
        holds: "the lesson works in a real browser, and its scripts have types",
        changes: "crate lesson, tests/browser",
        needs: &[NODE, CHROMIUM],
        beside: true,
        script: "\
cargo build --release --locked
export BOUNDFIT=$built/release/boundfit
npm --prefix tests/browser ci
npm --prefix tests/browser run types
npm --prefix tests/browser test",
    },
    Step {
        name: "wasm",
        holds: "the checked-in WebAssembly module answers as the program does",
        changes: "answers, wasm, crates/lesson/engine",
        needs: &[NODE],
        beside: true,
        script: "\
cargo build --release --locked
BOUNDFIT_PROGRAM=$built/release/boundfit node --test wasm/test.mjs",
    },
    Step {
        name: "growth",
        holds: "no command costs more per row where there are more rows, nor 5 % more than xtask/growth.txt says",
        changes: "everything that reads input or computes",
        needs: &[VALGRIND],
        // One program after the other is counted.
        beside: true,
        script: "\
cargo build --release --locked
cargo xtask growth",
    },
    Step {
        name: "page",
        holds: "the program writes the page for those who have only a browser, into target/boundfit.html",
        changes: "crate lesson",
        script: "\
cargo run --release --locked -- playground -o target/boundfit.html
ls -l target/boundfit.html",
        ..PLAIN
    },
    Step {
        name: "tests",
        holds: "the second command of README, all tests that need no other program, passes as README prints it, with one of eight generated cases in the longest tests",
        changes: "every change",
        script: "eval \"$(grep '^cargo ' README.md | sed -n 2p)\" 2>&1",
        ..PLAIN
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_have_names_of_their_own_and_are_explained() {
        for (place, step) in STEPS.iter().enumerate() {
            assert!(
                !step.holds.is_empty() && !step.changes.is_empty() && !step.script.is_empty(),
                "{step:?}"
            );
            assert!(STEPS[place + 1..].iter().all(|other| other.name != step.name), "{}", step.name);
            assert!(step.name.len() <= 13, "{} is long to type", step.name);
        }
    }
}
