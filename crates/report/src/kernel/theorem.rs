//! The file of a theorem: its head, the theory, and the statement about a set.

use std::fmt::Write;

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::Polyhedron;

use super::evidence::{Evidence, Number, contradiction};
use super::numbers::literal;
use super::rows::Statement;
use crate::proof_question::ProofQuestion;

/// The files of the theory, in the order in which each needs those before it.
pub const THEORY: [(&str, &str); 8] = [
    ("Reader", include_str!("../../kernel/Reader.v")),
    ("Bytes", include_str!("../../kernel/Bytes.v")),
    ("Checker", include_str!("../../kernel/Checker.v")),
    ("Convex", include_str!("../../kernel/Convex.v")),
    ("Sound", include_str!("../../kernel/Sound.v")),
    ("Rationals", include_str!("../../kernel/Rationals.v")),
    ("RealNumbers", include_str!("../../kernel/RealNumbers.v")),
    ("Parts", include_str!("../../kernel/Parts.v")),
];

/// The number of files that a theorem about one set needs.
const OF_A_SET: usize = 7;

/// The place that a theorem has its theory from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theory {
    /// The file holds it, so that it needs nothing but Coq.
    Included,
    /// Coq has it installed as `Boundfit`.
    Installed,
}

/// A set with the ranges of its parameters.
pub(super) struct Set<'a> {
    pub(super) polyhedron: &'a Polyhedron,
    pub(super) ranges: Option<[Interval; 2]>,
    pub(super) number: Number<'a>,
}

/// The facts in the first lines.
#[derive(Default)]
pub(super) struct Head<'a> {
    /// The subject of the last theorems where it is more than a set.
    pub(super) subject: Option<&'static str>,
    /// True if the last theorems are about parts of the rows.
    pub(super) has_parts: bool,
    pub(super) sha256: Option<&'a str>,
    /// Rows of the data.
    pub(super) rows: &'a [[usize; 2]],
    pub(super) question: Option<ProofQuestion>,
    /// The bytes of the data, and the theorem that the rows are read from them.
    pub(super) bytes: Option<String>,
}

impl Head<'_> {
    /// The first lines: what is proved, how to check it, and what is outside.
    fn text(&self) -> String {
        let Head { subject, sha256, rows, question, bytes, .. } = self;
        let outside = match bytes {
            Some(_) => {
                "that 'data' below are the bytes of the file. That the rows are read from them\n   \
                 is the theorem the_rows_are_the_bytes, which needs the definitions of rows_of and same_rows."
            }
            None => "that the rows are those of the data.",
        };
        let mut text = String::from(
            "(* What is proved: the last theorems of this file. Their statements need the definitions of rows, feasible and\n   \
             vertices below, and those of read, hull and is_range in the theory.\n   \
             How to check: coqc FILE (Coq 8.16). It ends by printing what the theorem over the rational numbers assumes:\n   \
             nothing. The one over the real numbers assumes the axioms of Coq's real numbers.\n",
        );
        let compared = match question {
            Some(_) => "'boundfit verify FILE DATA' compares both.",
            None => "No question stands here, so that 'boundfit verify' cannot compare both.",
        };
        let _ = writeln!(text, "   What is outside: {outside}\n   {compared}");
        if let Some(subject) = subject {
            let _ = writeln!(text, "   The theorems are about {subject}.");
        }
        if let Some(sha256) = sha256 {
            let _ = writeln!(text, "   The data have the SHA-256 {sha256}.");
        }
        if !rows.is_empty() && rows.len() <= 20 {
            let range = |&[from, to]: &[usize; 2]| {
                if from == to { from.to_string() } else { format!("{from}..{to}") }
            };
            let _ = writeln!(
                text,
                "   Rows of the data: {}.",
                rows.iter().map(range).collect::<Vec<_>>().join(",")
            );
        }
        if let Some(question) = question {
            let _ = writeln!(text, "   The question: {}", question.to_line("boundfit/theorem/1"));
        }
        text + "*)\n"
    }
}

/// The file about a set. `None` when a half-plane has no number.
pub(super) fn theorem(statement: &Statement, set: &Set, head: Head, theory: Theory) -> Option<String> {
    let bytes = head.bytes.as_deref().unwrap_or_default();
    let imports = imports(theory, head.has_parts);
    let mut text = format!("{}{imports}\n{}\n{bytes}", head.text(), statement.text());
    let _ = write!(
        text,
        "Theorem the_rows : Z.of_nat (length rows) = {}%Z.\nProof. vm_compute. reflexivity. Qed.\n\n",
        statement.count
    );
    match contradiction(set.polyhedron, set.number) {
        Some(numbers) => {
            let _ = write!(
                text,
                "Definition evidence : list Z := {numbers}.\n\
                 Lemma checked : check_empty forms evidence = true.\nProof. vm_cast_no_check (eq_refl true). Qed.\n\n\
                 Theorem nothing_is_feasible : forall p, ~ feasible p.\n\
                 Proof. intros p H. apply (empty forms evidence checked p), feasible_forms, H. Qed.\n\n\
                 Theorem no_real_is_feasible : forall p, ~ feasibleR p.\n\
                 Proof. intros p H. apply (emptyR forms evidence checked p), feasible_formsR, H. Qed.\n\n\
                 Print Assumptions nothing_is_feasible.\n"
            );
        }
        None => {
            text.push_str(&the_set(&Evidence::new(set.polyhedron, set.number)?, set.ranges.as_ref()?));
        }
    }
    Some(text)
}

/// The theory, or where it is.
fn imports(theory: Theory, has_parts: bool) -> String {
    let (set, parts) = THEORY.split_at(OF_A_SET);
    let needed = |files: &[(&str, &str)]| {
        let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
        format!("From Boundfit Require Import {}.\n", names.join(" "))
    };
    let (theory, parts) = match (theory, has_parts) {
        (Theory::Installed, true) => (needed(set), needed(parts)),
        (Theory::Installed, false) => (needed(set), String::new()),
        (Theory::Included, true) => (included(&THEORY), String::new()),
        (Theory::Included, false) => (included(set), String::new()),
    };
    format!(
        "\n{theory}From Coq Require Import ZArith QArith Qabs Rbase Rbasic_fun Qreals List.\nImport ListNotations.\nOpen Scope Q_scope.\n{parts}"
    )
}

/// The files of the theory as modules of one file, which imports what they import in the same order.
fn included(files: &[(&str, &str)]) -> String {
    const FROM_COQ: &str = "From Coq Require Import ";
    const FROM_THEORY: &str = "From Boundfit Require Import ";
    let lines = || files.iter().flat_map(|(_, text)| text.lines());
    let mut libraries: Vec<&str> = lines()
        .filter_map(|line| line.strip_prefix(FROM_COQ)?.strip_suffix('.'))
        .flat_map(str::split_whitespace)
        .collect();
    libraries.sort_unstable();
    libraries.dedup();
    let mut text = format!("From Coq Require {}.\n\n", libraries.join(" "));
    for (name, own) in files {
        let _ = writeln!(text, "Module {name}.");
        for line in own.lines() {
            match line.strip_prefix(FROM_COQ).or_else(|| line.strip_prefix(FROM_THEORY)) {
                Some(imported) => _ = writeln!(text, "Import {imported}"),
                None => _ = writeln!(text, "{line}"),
            }
        }
        let _ = writeln!(text, "End {name}.\nImport {name}.\n");
    }
    text
}

/// The theorem about a set that is not empty.
fn the_set(evidence: &Evidence, ranges: &[Interval; 2]) -> String {
    let [lemmas, names, says] = ends(ranges);
    let [hull, real_hull] = evidence.hull(["vertices", "rays"]);
    format!(
        "{}\
         Lemma checked : check forms evidence vertices rays = true.\nProof. vm_cast_no_check (eq_refl true). Qed.\n\
         Lemma same_set (p : Q * Q) : feasible p <-> set_of vertices rays p.\n\
         Proof. rewrite feasible_forms. exact (set_sound forms evidence vertices rays checked p). Qed.\n{lemmas}\n\
         Theorem the_set : (forall p, feasible p <-> {hull}) /\\ (forall v, In v vertices -> feasible v)\n  /\\ {says}.\n\
         Proof.\n  split; [exact same_set |]. split; [intros v H; apply same_set; exact (vertex_in vertices rays v H) |].\n  \
         exact {names}.\nQed.\n\n\
         Theorem the_real_set : forall p, feasibleR p <-> {real_hull}.\n\
         Proof. intros p. rewrite feasible_formsR. exact (set_soundR forms evidence vertices rays checked p). Qed.\n\n\
         Print Assumptions the_set.\n",
        evidence.definitions(["vertices", "rays", "evidence"]),
    )
}

/// Lemmas about the four ends, their names in a proof, and what they say.
fn ends(ranges: &[Interval; 2]) -> [String; 3] {
    let forms = [("fst", "1 0"), ("snd", "0 1")];
    let both = forms.into_iter().zip(ranges).map(|((form, coefficients), range)| {
        let linear = format!("{coefficients} {form}_is_linear");
        range_of(&Form { name: form, term: form, linear: &linear }, range)
    });
    let [lemmas, names, says] = both.fold([const { Vec::new() }; 3], |mut all, own| {
        all.iter_mut().zip(own).for_each(|(all, own)| all.push(own));
        all
    });
    [lemmas.concat(), format!("(conj {})", names.join(" ")), says.join(" /\\ ")]
}

/// A linear function of p.
pub(super) struct Form<'a> {
    /// The beginning of its lemmas' names.
    pub(super) name: &'a str,
    /// The function.
    pub(super) term: &'a str,
    /// The two coefficients of the function, and the lemma that it has them.
    pub(super) linear: &'a str,
}

/// Lemmas about both ends of a function on the set, their names in a proof, and what they say.
pub(super) fn range_of(form: &Form, range: &Interval) -> [String; 3] {
    let Form { name: prefix, term, linear } = form;
    let mut lemmas = String::new();
    let mut end = |which: &str, bound: Option<&Rational>| {
        let bound = bound.map(literal);
        let name = if bound.is_some() { which.to_owned() } else { format!("no_{which}") };
        let value = bound.as_ref().map(|value| format!(" {value}")).unwrap_or_default();
        let _ = write!(
            lemmas,
            "Lemma {prefix}_{name} : {name} feasible {term}{value}.\n\
             Proof. apply ({name}_of {term} {linear} feasible vertices rays same_set). \
             vm_cast_no_check (eq_refl true). Qed.\n"
        );
        (format!("{prefix}_{name}"), format!("{name} feasible {term}{value}"), bound)
    };
    let (low, high) = (end("lowest", range.lower().value()), end("highest", range.upper().value()));
    let says = match (low.2, high.2) {
        (Some(from), Some(to)) => format!("is_range feasible {term} {from} {to}"),
        _ => format!("({} /\\ {})", low.1, high.1),
    };
    [lemmas, format!("(conj {} {})", low.0, high.0), says]
}
