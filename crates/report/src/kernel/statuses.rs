//! Statuses as a theorem: which rows decide the set, and which could go.

use std::fmt::Write;

use boundfit_estimation::{BoundName, Fit, Measurement, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_geometry::{Polyhedron, Support};
use boundfit_questions::{Standing, Status, Statuses};

use super::evidence::Evidence;
use super::parts::{FIELDS, Field, Parts, lines, pair, whole, with_parts};
use super::theorem::Theory;

/// The theorem about statuses. Each row but those that decide could go alone, and the rows on the boundary make the set
/// without any other. If nothing is feasible, it says which rows would mend this if they went alone. `None` when some readings are not
/// in memory. Exact. Cost: a fit of the rows next to each deciding one.
pub fn kernel_status(
    (problem, fit): (&Problem, &Fit),
    statuses: &Statuses,
    reading: Reading,
    theory: Theory,
) -> Option<String> {
    const SUBJECT: &str = "the set of all rows, and the rows without which it would be another one.\n   \
                           The last ones need the definitions of feasible_part, deciding and boundary (or outliers), and that of numbered";
    let (text, parts) = with_parts((problem, fit), (reading, theory), SUBJECT)?;
    let (definitions, name) = match fit.is_empty() {
        true => (mended(statuses, &parts)?, "outlier"),
        false => (deciding(problem, statuses, &parts)?, "deciding"),
    };
    let theorem = if fit.is_empty() { outliers_theorem } else { deciding_theorem };
    let theorems: String = FIELDS.iter().map(theorem).collect();
    Some(format!("{text}{definitions}{theorems}\nPrint Assumptions the_{name}_rows.\n"))
}

/// The rows of the half-planes that are not redundant.
fn sides(polyhedron: &Polyhedron, name: impl Fn(usize) -> BoundName) -> Vec<usize> {
    polyhedron.irredundant().into_iter().filter_map(|index| name(index).row()).collect()
}

/// The rows that decide, and the certificate that others do not.
fn deciding(problem: &Problem, statuses: &Statuses, parts: &Parts) -> Option<String> {
    let fps = statuses.fps();
    let all = parts.sorted(sides(fps.polyhedron(), |index| fps.name(index)))?;
    let (mut bases, mut needed) = (vec![all], Vec::new());
    for own in statuses.deciding_readings() {
        let (others, names) = statuses.set_without(own.row);
        match beyond(own, &others) {
            Some(point) => needed.push((parts.place(own.row)?, point)),
            // Other rows say the same as this one.
            None => bases.push(parts.sorted(sides(&others, |index| names[index]))?),
        }
    }
    let touches = |own: &&Measurement| {
        Standing::against(own, statuses.set()).is_some_and(|own| own.status == Status::Boundary)
    };
    let (every, ties) = problem.measurements.every()?;
    let boundary = every.iter().filter(touches).map(|own| own.row);
    let boundary: Vec<usize> = match ties.is_empty() {
        true => boundary.collect(),
        false => boundary.flat_map(|row| ties.rows(row)).collect(),
    };
    let boundary = parts.sorted(boundary)?;
    let bases: Option<Vec<String>> = bases.iter().map(|places| base(parts, places)).collect();
    let rows: Vec<usize> = needed.iter().map(|(place, _)| *place).collect();
    let points: Vec<String> = needed.iter().map(|(_, point)| point.clone()).collect();
    Some(format!(
        "(* The rows without each of which the set is another one, with a point that each alone keeps out. *)\n\
         Definition deciding : list Z := {}.\n\
         Definition beyond : list (Q * Q) := {}.\n\
         (* The rows that touch the set. *)\n\
         Definition boundary : list Z := {}.\n\
         (* Rows that make the set, and why. *)\n\
         Definition bases : list (list Z * certificate) := {}.\n\
         Definition boundary_base : list Z * certificate := {}.\n\
         Lemma deciding_checked : check_status rows row_form always vertices rays bases (combine deciding beyond) = true.\n\
         Proof. vm_cast_no_check (eq_refl true). Qed.\n\
         Lemma boundary_checked : check_base rows row_form always vertices rays boundary_base = true.\n\
         Proof. vm_cast_no_check (eq_refl true). Qed.\n\
         Lemma same_deciding : map fst (combine deciding beyond) = deciding.\n\
         Proof. vm_cast_no_check (eq_refl deciding). Qed.\n",
        whole(&rows),
        lines(&points),
        whole(&boundary),
        lines(&bases?),
        base(parts, &boundary)?,
    ))
}

/// Rows, and the certificate that they make the set.
fn base(parts: &Parts, places: &[usize]) -> Option<String> {
    let Evidence { certificate, .. } = parts.evidence(places)?;
    Some(format!("({}, {certificate})", whole(places)))
}

/// A point of a set that a reading does not keep; `None` if it keeps every one.
fn beyond(reading: &Measurement, others: &Polyhedron) -> Option<String> {
    let opposite = reading.regressor.each_ref().map(|part| -part);
    let ends =
        [(reading.upper(), reading.regressor.clone()), (reading.lower().map(|lower| -lower), opposite)];
    ends.into_iter().find_map(|(bound, form)| beyond_end(&bound?, &form, others))
}

/// A point at which a form is larger than a bound.
fn beyond_end(bound: &Rational, form: &[Rational; 2], others: &Polyhedron) -> Option<String> {
    let value = |[x, y]: &[Rational; 2]| &form[0] * x + &form[1] * y;
    match others.support(form) {
        Support::Empty(_) => None,
        Support::Bounded { proof, .. } => {
            let point = proof.attained_at.coordinates();
            (value(&point) > *bound).then(|| pair(point.each_ref()))
        }
        Support::Unbounded(proof) => {
            let [x, y] = proof.point.coordinates();
            let ray = [proof.ray.dx(), proof.ray.dy()].map(Rational::from);
            // So far along the ray that the form exceeds the bound by at least 1.
            let missing = bound - value(&[x.clone(), y.clone()]) + Rational::one();
            let times = missing.checked_div(&value(&ray)).filter(Rational::is_positive).unwrap_or_default();
            Some(pair([&(x + &times * &ray[0]), &(y + &times * &ray[1])]))
        }
    }
}

fn deciding_theorem(field: &Field) -> String {
    let real = field.real;
    let name = if real.is_empty() { "the_deciding_rows" } else { "the_real_deciding_rows" };
    let mut text = format!(
        "Lemma whole_forms{real} p : feasible{real} p <-> (forall c, In c (map row_form rows ++ always) -> {} c p).\n\
         Proof. rewrite feasible_forms{real}. unfold always. rewrite ?app_nil_r. reflexivity. Qed.\n",
        field.meets()
    );
    let _ = write!(
        text,
        "\nTheorem {name} :\n  \
         (forall i r, In (i, r) (numbered rows) ->\n   \
         ((forall p, feasible_part{real} (fun j _ => j <> i) p -> feasible{real} p) <-> ~ In i deciding))\n  \
         /\\ (forall p, feasible_part{real} (fun i _ => In i boundary) p <-> feasible{real} p).\n\
         Proof.\n  split.\n  \
         - rewrite <- same_deciding. exact (status_sound {} feasible{real} vertices rays same_set{real} whole_forms{real} bases \
         (combine deciding beyond) deciding_checked).\n  \
         - exact (base_is {} feasible{real} vertices rays same_set{real} boundary_base boundary_checked).\nQed.\n",
        field.of_sets_and_points(),
        field.of_sets(),
    );
    if real.is_empty() {
        return text;
    }
    format!(
        "Lemma same_setR (p : R * R) : feasibleR p <-> set_ofR vertices rays p.\n\
         Proof. rewrite feasible_formsR. exact (set_soundR forms evidence vertices rays checked p). Qed.\n{text}"
    )
}

/// The rows without each of which something is left, and the certificate that this is true of no other.
fn mended(statuses: &Statuses, parts: &Parts) -> Option<String> {
    let readings = statuses.deciding_readings();
    let (mut outliers, mut points) = (Vec::new(), Vec::new());
    let mut against = vec![parts.contradiction(readings.iter().map(|own| own.row))?];
    for own in readings {
        let (others, names) = statuses.set_without(own.row);
        match (others.region().witness(), others.region().certificate()) {
            (Some(point), None) => {
                outliers.push(parts.place(own.row)?);
                points.push(pair(point.coordinates().each_ref()));
            }
            (_, certificate) => {
                let rows = certificate?.multipliers().iter().filter_map(|own| names[own.index].row());
                against.push(parts.contradiction(rows)?);
            }
        }
    }
    Some(format!(
        "(* The rows without each of which something is left, with a point of this. *)\n\
         Definition outliers : list Z := {}.\n\
         Definition points : list (Q * Q) := {}.\n\
         (* Rows that contradict each other. *)\n\
         Definition against : list contradiction := {}.\n\
         Lemma outliers_checked : check_mended rows row_form always (combine outliers points) against = true.\n\
         Proof. vm_cast_no_check (eq_refl true). Qed.\n\
         Lemma same_outliers : map fst (combine outliers points) = outliers.\n\
         Proof. vm_cast_no_check (eq_refl outliers). Qed.\n",
        whole(&outliers),
        lines(&points),
        lines(&against),
    ))
}

fn outliers_theorem(field: &Field) -> String {
    let real = field.real;
    let name = if real.is_empty() { "the_outlier_rows" } else { "the_real_outlier_rows" };
    format!(
        "\nTheorem {name} : forall i r, In (i, r) (numbered rows) ->\n  \
         ((exists p, feasible_part{real} (fun j _ => j <> i) p) <-> In i outliers).\n\
         Proof. rewrite <- same_outliers. exact (mended_sound {} (combine outliers points) against outliers_checked). Qed.\n",
        field.of_both()
    )
}
