//! `--proof FILE.v`: which theorem is written, and who refuses one. The target `kernel` asks whether Coq accepts the
//! theorem.

use std::fs;
use std::path::Path;

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, files_in};
use tempfile::TempDir;

const DATA: &str = "x,y,e,lo,up,w\n1,2,1,1.5,2.5,0\n2,3.1,1/2,NA,3.5,1\n3,3.9,0.25,3,,2\n4,5,1,4,6,1\n";

fn directory() -> TempDir {
    directory_with(&[
        ("a.csv", DATA.as_bytes()),
        ("planes.csv", b"a1,a2,b\n-1,0,0\n0,-1,0\n2,3,6\n"),
        ("points.ext", b"V-representation\nbegin\n2 3 rational\n1 1 0\n1 0 1\nend\n"),
        ("best.lp", b"max\nobj: 3 x + 2 y + 1\nst\n c1: x + y <= 4\n c2: 6 x + 4 y <= 21\nend\n"),
        ("none.lp", b"min\nobj: x\nst\n c1: x + y <= 1\n c2: x >= 2\nend\n"),
        ("ever.lp", b"min\nobj: x - y\nst\n c1: x - y <= 4\nend\n"),
        ("three.lp", b"min\nobj: x - y\nst\n c1: x - y + z >= 4\nbounds\n z = 1\nend\n"),
        ("mine.v", b"Definition one := 1.\n"),
    ])
}

#[test]
fn small_plain_data_stand_in_the_theorem() {
    let long = format!("x,y\n{}", "1.000000000000000000000000000000000000000000000000,2\n".repeat(2_000));
    let directory = directory();
    fs::write(directory.path().join("long.csv"), &long).unwrap();
    fs::write(directory.path().join("quoted.csv"), DATA.replace("2,3.1", "\"2\",3.1")).unwrap();
    let theorem = |line: &str, input: &str| {
        let run =
            boundfit_with_input(directory.path(), &format!("{line} --proof p.v --force"), input.as_bytes());
        assert_eq!(run.status, 0, "{line}: {run:?}");
        fs::read_to_string(directory.path().join("p.v")).unwrap()
    };
    let text = theorem("fit a.csv --x x --y y --eps-column e --rows 2..4", "");
    let says = "same_rows (rows_of Byte.x2c true [(2, 4)]%Z [1; 2; 3]%nat data) rows.";
    assert!(text.contains(says), "{text}");
    assert!(text.contains(&format!("Definition data : list text := [\"{DATA}\"]%text.\n")), "{text}");
    assert!(text.contains("What is outside: that 'data' below are the bytes of the file."), "{text}");
    assert!(text.contains("\n   'boundfit verify FILE DATA' compares both.\n"), "{text}");
    // A theorem without a question is compared with nothing.
    fs::write(directory.path().join("p.lp"), "min x + y\nst\n x + 2 y >= 1\n x <= 3\nend\n").unwrap();
    let text = theorem("judge p.lp", "");
    let uncompared = "\n   No question stands here, so that 'boundfit verify' cannot compare both.\n";
    assert!(text.contains(uncompared) && !text.contains("compares both"), "{text}");
    for (line, input) in [
        ("fit long.csv --x x --y y --eps 1", ""),
        ("fit - --x x --y y --eps 1", DATA),
        ("fit quoted.csv --x x --y y --eps 1", ""),
        ("fit a.csv --x x --y y --eps 50%*|y|", ""),
        ("fit a.csv --x x --y y --eps 1 --reading binary64", ""),
        ("fit a.csv --x x --lower lo --upper up", ""),
    ] {
        let text = theorem(line, input);
        assert!(!text.contains("Definition data"), "{line}");
        assert!(text.contains("What is outside: that the rows are those of the data."), "{line}");
    }
}

fn refused(directory: &Path, line: &str, message: &str) {
    let before = files_in(directory);
    let run = boundfit(directory, line);
    assert!(matches!(run.status, 1 | 2) && run.stdout.is_empty(), "{line}: {run:?}");
    assert!(run.stderr.starts_with(&format!("error: {message}\n")), "{line}: {}", run.stderr);
    assert_eq!(files_in(directory), before, "{line}");
}

#[test]
fn the_theorem_is_about_what_was_asked() {
    const PARTS: &str = "\nDefinition feasible_part (part : Z -> row -> Prop) (p : Q * Q) :=\n";
    const INSIDE: &str = "forall r, In r rows -> Qabs (y r - (fst p * x r + snd p)) <= eps r";
    for (line, status, says) in [
        (
            "fit a.csv --x x --y y --eps 0.2",
            0,
            &[INSIDE, "Definition eps (r : row) : Q := (1 # 5).", "<-> hull vertices p)"][..],
        ),
        ("fit a.csv --x x --y y --eps-column e", 0, &[INSIDE, "Definition eps (r : row) : Q := number 2 r."]),
        (
            "fit a.csv --x x --y y --eps 0",
            3,
            &[INSIDE, "Theorem nothing_is_feasible : forall p, ~ feasible p."],
        ),
        ("fit a.csv --x x,w --y y --eps 3", 0, &["Qabs (y r - (fst p * x r + snd p * u r)) <= eps r"]),
        (
            "fit a.csv --x x --lower lo --upper up",
            0,
            &["at_least (least r) (fst p * x r + snd p) /\\ at_most (fst p * x r + snd p) (most r)"],
        ),
        (
            "fit a.csv --x x --y y --eps 1 --where theta2>=0",
            0,
            &["(forall c, In c conditions -> keeps c p)", "\"0,-1,,0\n"],
        ),
        (
            "fit a.csv --x x --y y --eps 1 --rows 4",
            0,
            &["<-> hull_and_cone vertices rays p)", "Rows of the data: 4."],
        ),
        (
            "check a.csv --x x --y y --eps 0.2 --claim-pui 13/15,17/15,2/3,4/3",
            0,
            &[INSIDE, "is_range feasible fst (13 # 15) (17 # 15) /\\ is_range feasible snd (2 # 3) (4 # 3)."],
        ),
        (
            "check a.csv --x x --y y --eps 0.2 --claim-pui 0.8,1.2,0,1",
            4,
            &["is_range feasible snd (2 # 3) (4 # 3)."],
        ),
        (
            "judge best.lp",
            0,
            &[
                "at_most (fst p * a r + snd p * b r) (most r)",
                "theta1 is the first column (x), theta2 the second one (y). *)\n",
                "\"1,1,,4\n6,4,,21\n1,0,0,\n0,1,0,\n\"",
                "Definition objective (p : Q * Q) : Q := fst p * (3 # 1) + snd p * (2 # 1) + (1 # 1).",
                "Theorem the_optimum : highest feasible objective (23 # 2)\n  \
                 /\\ (forall p, feasible p /\\ objective p == (23 # 2) <-> hull optimal_points p).",
                "\"2.5,1.5\n3.5,0.0\n\"",
            ],
        ),
        ("judge none.lp", 3, &["Theorem nothing_is_feasible : forall p, ~ feasible p."]),
        ("judge ever.lp", 0, &["Theorem no_optimum : no_lowest feasible objective."]),
        (
            "predict a.csv --x x --y y --eps 0.2 --at 5",
            0,
            &[INSIDE, "Theorem the_prediction :\n  is_range feasible (value (5 # 1)) (17 # 3) (19 # 3).\n"],
        ),
        (
            "predict a.csv --x x --y y --eps 1 --rows 4 --at 4,5",
            0,
            &["  is_range feasible (value (4 # 1)) (4 # 1) (6 # 1)\n  \
               /\\ (no_lowest feasible (value (5 # 1)) /\\ no_highest feasible (value (5 # 1))).\n"],
        ),
        (
            "predict a.csv --x x --y y --eps 0 --at 5",
            3,
            &["Theorem nothing_is_feasible : forall p, ~ feasible p."],
        ),
        (
            "outliers a.csv --x x --y y --eps 0.07",
            0,
            &[
                INSIDE,
                "Theorem nothing_is_feasible : forall p, ~ feasible p.",
                "Definition sets : list (list Z) := [[2]%Z;\n  [3]%Z].\n",
                "(forall out, (exists p, feasible_without out p) -> (1 <= length out)%nat)\n",
                "Theorem the_real_outliers :\n",
                PARTS,
            ],
        ),
        (
            "outliers a.csv --x x --y y --eps 0.07 --limit sets=1",
            0,
            &[
                "/\\ (forall s, In s sets -> length s = 1%nat /\\ NoDup s /\\ (exists p, feasible_without s p)).\n",
            ],
        ),
        ("outliers a.csv --x x --y y --eps 0.2", 0, &["<-> hull vertices p)"]),
        (
            "range a.csv --x x --y y --eps 0.01",
            0,
            &[
                "Definition key (i : Z) (r : row) : Q := x r.\n",
                "Definition runs : list (Q * Q) := [((1 # 1), (2 # 1));\n  ((2 # 1), (3 # 1));\n  ((3 # 1), (4 # 1))].\n",
                "Theorem the_range : forall a b, (exists i r, In (i, r) (numbered rows) /\\ spans key a b i r) ->",
                PARTS,
            ],
        ),
        (
            "range a.csv --x x,w --y y --eps 0.01",
            0,
            &["Definition key (i : Z) (r : row) : Q := inject_Z i.\n"],
        ),
        (
            "status a.csv --x x --y y --eps 0.2",
            0,
            &[
                "Definition deciding : list Z := [1; 2; 3; 4]%Z.\n",
                "Definition boundary : list Z := [1; 2; 3; 4]%Z.\n",
                "Theorem the_deciding_rows :\n  (forall i r, In (i, r) (numbered rows) ->\n   \
                 ((forall p, feasible_part (fun j _ => j <> i) p -> feasible p) <-> ~ In i deciding))\n  \
                 /\\ (forall p, feasible_part (fun i _ => In i boundary) p <-> feasible p).\n",
                PARTS,
            ],
        ),
        (
            "status a.csv --x x --y y --eps 0.07",
            3,
            &[
                "Definition outliers : list Z := [2; 3]%Z.\n",
                "((exists p, feasible_part (fun j _ => j <> i) p) <-> In i outliers).\n",
            ],
        ),
        ("polygon planes.csv", 0, &["fst p * a r + snd p * b r <= c r", "<-> hull vertices p)"]),
    ] {
        let directory = directory();
        let alone = boundfit(directory.path(), line);
        for library in ["", " --proof-library"] {
            let run = boundfit(directory.path(), &format!("{line} --proof answer.v{library}"));
            assert_eq!((run.status, &run.stdout), (status, &alone.stdout), "{line}: {run:?}");
            let text = fs::read_to_string(directory.path().join("answer.v")).unwrap();
            for part in says {
                assert!(text.contains(part), "{line}: {part}: {text}");
            }
            let needs =
                "From Boundfit Require Import Reader Bytes Checker Convex Sound Rationals RealNumbers.\n";
            assert_eq!(text.contains(needs), !library.is_empty(), "{line}");
            assert_eq!(text.contains("\nModule Sound.\n"), library.is_empty(), "{line}");
            // Only theorems about parts of the rows need the last file of the theory.
            let has_parts = text.contains(PARTS);
            let needs = "\nFrom Boundfit Require Import Parts.\n";
            assert_eq!(text.contains(needs), has_parts && !library.is_empty(), "{line}");
            assert_eq!(text.contains("\nModule Parts.\n"), has_parts && library.is_empty(), "{line}");
            assert!(text.contains("\nPrint Assumptions "), "{line}");
        }
    }
}

#[test]
fn readings_from_standard_input_have_a_theorem() {
    let directory = directory();
    let line = "fit - --x x --y y --eps 0.2 --proof answer.v";
    assert_eq!(boundfit_with_input(directory.path(), line, DATA.as_bytes()).status, 0);
    let piped = fs::read_to_string(directory.path().join("answer.v")).unwrap();
    assert_eq!(boundfit(directory.path(), &line.replace(" - ", " a.csv ")).status, 0);
    let own = fs::read_to_string(directory.path().join("answer.v")).unwrap();
    // All but the bytes of the file.
    let (before, after) = own.split_once("(* The bytes of the data. *)\n").unwrap();
    let (_, after) = after.split_once("Print Assumptions the_rows_are_the_bytes.\n\n").unwrap();
    let statements = |text: &str| text[text.find("(* Rows: ").unwrap()..].to_owned();
    assert_eq!(statements(&format!("{before}{after}")), statements(&piped));
}

#[test]
fn other_answers_have_no_theorem() {
    const NONE: &str = "'--proof a.v': there is no theorem for Coq about this answer; a file that ends in .json gets the proof for \
                        'boundfit verify'";
    let directory = directory();
    for command in ["status", "outliers", "range", "predict --at 1"] {
        refused(
            directory.path(),
            &format!("{command} a.csv --x x --y y --eps 1 --proof a.json --proof-library"),
            "'--proof-library' is about theorems for Coq: give '--proof' a file that ends in .v",
        );
    }
    refused(
        directory.path(),
        "predict a.csv --x x --y y --eps 1 --grid 0..1/1000 --proof a.v",
        "a.csv: the proof would take more than 200 values",
    );
    refused(directory.path(), "linearity a.csv --x x --y y --proof a.v", NONE);
    refused(directory.path(), "fit a.csv --x x --y y --eps 1 --x-eps 1 --proof a.v", NONE);
    refused(
        directory.path(),
        "polygon planes.csv --proof a.json",
        "the proof of a set of half-planes is a theorem for Coq: give '--proof' a file that ends in .v",
    );
    refused(
        directory.path(),
        "judge best.lp --proof a.json",
        "the proof of a linear program is a theorem for Coq: give '--proof' a file that ends in .v",
    );
    refused(
        directory.path(),
        "check a.csv --x x --y y --eps 1 --proof a.json",
        "the proof of the four ends is a theorem for Coq: give '--proof' a file that ends in .v",
    );
    refused(
        directory.path(),
        "judge three.lp --proof a.v",
        "'--proof' is about linear programs in two columns, and three.lp has three: there is no theorem about its answer",
    );
    refused(
        directory.path(),
        "judge best.lp --proof a.v --output a.v",
        "'--proof' and '--output' name the same file",
    );
    refused(
        directory.path(),
        "polygon points.ext --proof a.v",
        "'--proof' is about half-planes, and points.ext has generators: write its half-planes with '--format ine', and prove that file",
    );
    refused(
        directory.path(),
        "fit a.csv --x x --y y --eps 1 --proof a.json --proof-library",
        "'--proof-library' is about theorems for Coq: give '--proof' a file that ends in .v",
    );
    refused(
        directory.path(),
        "fit a.csv --x x --y y --eps 1 --proof mine.v",
        "mine.v: not written: it is there and does not look as if boundfit wrote it (--force replaces it)",
    );
    assert_eq!(boundfit(directory.path(), "reduce a.csv --x x --y y -o r.csv").status, 0);
    refused(
        directory.path(),
        "fit r.csv --x x --y y --eps 1 --proof a.v",
        "a proof is about every reading, and this is a reduction: prove the answer about the table that it was made from",
    );
}
