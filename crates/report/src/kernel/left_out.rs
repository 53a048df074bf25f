//! Outliers as a theorem: how many rows have to be left out, and which.

use std::fmt::Write;

use boundfit_exact::Reading;

use super::parts::{FIELDS, Field, Parts, lines, pair, whole, with_parts};
use super::theorem::Theory;
use crate::outliers::{NoOutliersProof, OutliersReport, contradictions};

/// The theorem about outliers: the set of all rows, that fewer rows are not enough, what the listed sets leave, and that a complete list
/// is complete. Exact. Cost: a fit for each of at most a thousand sets of rows left out.
///
/// # Errors
/// When there is none.
pub fn kernel_outliers(
    report: &OutliersReport,
    reading: Reading,
    theory: Theory,
) -> Result<String, NoOutliersProof> {
    const SUBJECT: &str = "the set of all rows, and the rows to leave out so that something is left.\n   \
                           The last ones need the definitions of feasible_part, feasible_without and sets, and that of numbered";
    let asked = (report.problem, report.fit);
    let (text, parts) = with_parts(asked, (reading, theory), SUBJECT).ok_or(NoOutliersProof::NotInMemory)?;
    let Ok(outliers) = report.outliers else { return Ok(text) };
    // Where nothing has to be left out, the set of all rows says so.
    if outliers.least == 0 {
        return Ok(text);
    }
    let sets: Vec<Vec<usize>> = outliers.pieces.iter().map(|piece| piece.rows.clone()).collect();
    let listed = outliers.is_complete.then_some(sets.as_slice());
    let entries: Vec<_> = contradictions(report.problem, outliers.least, listed)?
        .into_iter()
        .map(|(rows, own)| (rows, own.into_iter().filter_map(|(name, _)| name.row()).collect()))
        .collect();
    let points = outliers.pieces.iter().map(|piece| {
        let point = piece.left.polyhedron().region().witness()?.coordinates();
        Some(pair(point.each_ref()))
    });
    let points: Option<Vec<String>> = points.collect();
    let definitions = points.and_then(|points| definitions(&parts, &sets, &entries, &points));
    let definitions = definitions.ok_or(NoOutliersProof::NotInMemory)?;
    let theorems: String =
        FIELDS.iter().map(|field| theorem(field, outliers.least, outliers.is_complete)).collect();
    Ok(format!("{text}{definitions}{theorems}\nPrint Assumptions the_outliers.\n"))
}

/// The sets and the certificate. `None` when a row is not there, or nothing contradicts.
fn definitions(
    parts: &Parts,
    sets: &[Vec<usize>],
    entries: &[(Vec<usize>, Vec<usize>)],
    points: &[String],
) -> Option<String> {
    let places = |rows: &Vec<usize>| Some(whole(&parts.sorted(rows.iter().copied())?));
    let sets: Option<Vec<String>> = sets.iter().map(places).collect();
    let entry = |(out, own): &(Vec<usize>, Vec<usize>)| {
        Some(format!("({}, {})", places(out)?, parts.contradiction(own.iter().copied())?))
    };
    let entries: Option<Vec<String>> = entries.iter().map(entry).collect();
    Some(format!(
        "(* The rows but those whose numbers are out. *)\n\
         Definition feasible_without (out : list Z) := feasible_part (fun i _ => ~ In i out).\n\
         Definition feasible_withoutR (out : list Z) := feasible_partR (fun i _ => ~ In i out).\n\
         (* Rows to leave out. *)\n\
         Definition sets : list (list Z) := {}.\n\
         (* A point that is left without each set. *)\n\
         Definition points : list (Q * Q) := {}.\n\
         (* Rows that are out, and others that contradict each other, one of which has to be out as well. *)\n\
         Definition entries : list (list Z * contradiction) := {}.\n\
         Lemma same_sets : map fst (combine sets points) = sets.\nProof. vm_cast_no_check (eq_refl sets). Qed.\n",
        lines(&sets?),
        lines(points),
        lines(&entries?),
    ))
}

/// The theorem over one field.
fn theorem(field: &Field, least: usize, is_complete: bool) -> String {
    let (real, fewer) = (field.real, least - 1);
    let name = if real.is_empty() { "the_outliers" } else { "the_real_outliers" };
    let left = |rows: &str| format!("exists p, feasible_without{real} {rows} p");
    let mut text = format!("\nTheorem {name} :\n  ");
    let _ = write!(
        text,
        "(forall out, ({}) -> ({least} <= length out)%nat)\n  \
         /\\ (forall s, In s sets -> length s = {least}%nat /\\ NoDup s /\\ ({}))",
        left("out"),
        left("s")
    );
    if is_complete {
        let _ = write!(
            text,
            "\n  /\\ (forall out, (length out <= {least})%nat -> ({}) -> exists s, In s sets /\\ incl s out)",
            left("out")
        );
    }
    let _ = write!(
        text,
        ".\nProof.\n  split; [apply (least_outliers {} {fewer} entries); vm_cast_no_check (eq_refl true) |].\n  {}\
         rewrite <- same_sets. apply (sets_sound {} {least} (combine sets points)). vm_cast_no_check (eq_refl true).{}\nQed.\n",
        field.of_contradictions(),
        if is_complete { "split.\n  - " } else { "" },
        field.of_points(),
        if is_complete {
            format!(
                "\n  - apply (outliers_sound {} {least} sets entries). vm_cast_no_check (eq_refl true).",
                field.of_contradictions()
            )
        } else {
            String::new()
        }
    );
    text
}
