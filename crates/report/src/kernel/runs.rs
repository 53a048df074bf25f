//! A linear range as a theorem: which runs of readings some parameters agree with.

use boundfit_estimation::Fps;
use boundfit_exact::{Rational, Reading};
use boundfit_questions::{Contradiction, Order, Run};

use super::numbers::literal;
use super::parts::{FIELDS, Field, Parts, lines, pair, with_parts};
use super::theorem::Theory;
use crate::range::RangeReport;

/// The theorem about a linear range: the set of all readings, and that a run of readings leaves something exactly if it lies within
/// one of the listed runs. `None` when some readings are not in memory. Exact. Cost: a fit of each run.
pub fn kernel_range(report: &RangeReport, reading: Reading, theory: Theory) -> Option<String> {
    const SUBJECT: &str = "the set of all rows, and the runs of rows that leave something.\n   \
                           The last ones need the definitions of feasible_part, key and runs, and those of numbered and spans";
    let (text, parts) = with_parts((report.problem, report.fit), (reading, theory), SUBJECT)?;
    let definitions = definitions(report, &parts)?;
    let theorems: String = FIELDS.iter().map(theorem).collect();
    Some(format!("{text}{definitions}{theorems}\nPrint Assumptions the_range.\n"))
}

/// The key of rows, the runs, and the certificate.
fn definitions(report: &RangeReport, parts: &Parts) -> Option<String> {
    let (about, body) = match report.order {
        Order::X => ("x", "x r"),
        Order::Row => ("the number of a row", "inject_Z i"),
    };
    let runs = &report.range.runs;
    let ends: Option<Vec<String>> = runs.iter().map(|run| ends(report, parts, run)).collect();
    let points: Option<Vec<String>> = runs.iter().map(|run| point(report, run)).collect();
    let after = |(index, run): (usize, &Run)| {
        // The contradiction of the last readings of the run with the place that does not join them. Where the place contradicts
        // itself, no later place does.
        let lonely = report.range.alone.iter().find(|(position, _)| *position == run.last + 1);
        let next = runs.get(index + 1).and_then(|next| next.before.as_ref());
        match lonely.map(|(_, own)| own).or(next) {
            Some(own) => Some(format!("Some {}", term(parts, own)?)),
            None => Some("None".to_owned()),
        }
    };
    let nexts: Option<Vec<String>> = runs.iter().enumerate().map(after).collect();
    let mut lonely: Vec<&Contradiction> = report.range.alone.iter().map(|(_, own)| own).collect();
    lonely.dedup();
    let lonely: Option<Vec<String>> = lonely.into_iter().map(|own| term(parts, own)).collect();
    Some(format!(
        "(* Rows are taken by {about}. *)\n\
         Definition key (i : Z) (r : row) : Q := {body}.\n\
         (* The first and the last key of each run. *)\n\
         Definition runs : list (Q * Q) := {}.\n\
         (* A point that each run leaves. *)\n\
         Definition points : list (Q * Q) := {}.\n\
         (* The rows that end each run, and rows that contradict each other at one key. *)\n\
         Definition ends : list (option contradiction) := {}.\n\
         Definition lonely_rows : list contradiction := {}.\n\
         Lemma range_checked : check_range rows row_form always key runs ends lonely_rows = true.\n\
         Proof. vm_cast_no_check (eq_refl true). Qed.\n\
         Lemma runs_checked : forallb (fun own => is_left rows row_form always (spans_b key (fst (fst own)) (snd (fst own))) (snd own)) \
         (combine runs points) = true.\n\
         Proof. vm_cast_no_check (eq_refl true). Qed.\n",
        lines(&ends?),
        lines(&points?),
        lines(&nexts?),
        lines(&lonely?),
    ))
}

fn term(parts: &Parts, own: &Contradiction) -> Option<String> {
    parts.contradiction(own.rows())
}

/// The first and the last key of a run.
fn ends(report: &RangeReport, parts: &Parts, run: &Run) -> Option<String> {
    let key = |position: usize| match report.order {
        Order::X => report.x(position).cloned(),
        Order::Row => parts.place(report.row(position)).map(Rational::from),
    };
    Some(pair([&key(run.first)?, &key(run.last)?]))
}

/// A point that a run leaves.
fn point(report: &RangeReport, run: &Run) -> Option<String> {
    let own = report.range.problem_of(run, report.problem, false);
    let fps = Fps::new(&own.measurements, &own.conditions);
    let [a, b] = fps.polyhedron().region().witness()?.coordinates();
    Some(format!("({}, {})", literal(&a), literal(&b)))
}

/// The theorem over one field.
fn theorem(field: &Field) -> String {
    let real = field.real;
    let name = if real.is_empty() { "the_range" } else { "the_real_range" };
    format!(
        "\nTheorem {name} : forall a b, (exists i r, In (i, r) (numbered rows) /\\ spans key a b i r) ->\n  \
         ((exists p, feasible_part{real} (spans key a b) p) <->\n   \
         exists run, In run runs\n   \
         /\\ forall i r, In (i, r) (numbered rows) -> spans key a b i r -> spans key (fst run) (snd run) i r).\n\
         Proof. exact (range_sound {} key runs ends lonely_rows points range_checked runs_checked eq_refl). Qed.\n",
        field.of_both()
    )
}
