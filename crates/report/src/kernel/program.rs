//! The answer to a linear program in two columns as a theorem: the feasible set, the optimum, and all optimal points.

use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, System};
use boundfit_judge::Answer;
use boundfit_lp::{Bounds, Model, ObjectiveSense};

use super::evidence::{Evidence, by_place};
use super::numbers::literal;
use super::rows::{ProgramRow, Statement};
use super::theorem::{Head, Set, Theory, theorem};

/// The theorem about the answer to a linear program. `None` when it has other than two columns. Exact. Cost: O(n log n) in the
/// number of bounds.
pub fn kernel_program(
    model: &Model,
    answer: &Answer,
    sha256: Option<&str>,
    theory: Theory,
) -> Option<String> {
    let [first, second] = model.columns.as_slice() else { return None };
    let mut rows = Vec::new();
    for row in &model.rows {
        let mut form = [Rational::zero(), Rational::zero()];
        for (column, coefficient) in &row.coefficients {
            let entry = form.get_mut(*column)?;
            *entry = &*entry + coefficient;
        }
        rows.push(ProgramRow { form, bounds: &row.bounds });
    }
    let unit = [[Rational::one(), Rational::zero()], [Rational::zero(), Rational::one()]];
    for (form, column) in unit.into_iter().zip([first, second]) {
        rows.push(ProgramRow { form, bounds: &column.bounds });
    }
    let mut system = System::default();
    rows.iter().for_each(|row| row.push_to(&mut system));
    let polyhedron = Polyhedron::intersect(system.clone());
    let statement = Statement::of_program(&rows, [&first.name, &second.name]);
    let set = Set { polyhedron: &polyhedron, ranges: polyhedron.bounding_box(), number: &by_place };
    let head = Head {
        subject: Some(
            "a linear program in two columns: its feasible set, its optimum, and all points that attain it.\n   \
             These need the definitions of objective and optimal_points, and those of lowest and highest",
        ),
        sha256,
        ..Head::default()
    };
    let text = theorem(&statement, &set, head, theory)?;
    let objective = Objective {
        costs: [&first.cost, &second.cost],
        constant: &model.constant,
        is_least: model.sense == ObjectiveSense::Minimize,
    };
    Some(match answer {
        Answer::Infeasible { .. } => text,
        Answer::Unbounded { .. } => text + &objective.has_no_end(),
        Answer::Optimal { value, .. } => text + &objective.is_attained(value, system)?,
    })
}

struct Objective<'a> {
    costs: [&'a Rational; 2],
    constant: &'a Rational,
    is_least: bool,
}

impl Objective<'_> {
    /// Literals of both costs and the constant.
    fn literals(&self) -> [String; 3] {
        let [a, b] = self.costs;
        [a, b, self.constant].map(literal)
    }

    /// The end that is wanted.
    fn end(&self) -> &'static str {
        if self.is_least { "lowest" } else { "highest" }
    }

    fn definition(&self) -> String {
        let [a, b, c] = self.literals();
        format!(
            "\n(* The objective of the program, to be made {}. *)\n\
             Definition objective (p : Q * Q) : Q := fst p * {a} + snd p * {b} + {c}.\n",
            if self.is_least { "small" } else { "large" }
        )
    }

    /// The theorem that the objective improves for ever.
    fn has_no_end(&self) -> String {
        let (end, [a, b, c]) = (self.end(), self.literals());
        format!(
            "{}\nTheorem no_optimum : no_{end} feasible objective.\n\
             Proof. apply (no_{end}_value {a} {b} {c} feasible vertices rays same_set). vm_cast_no_check (eq_refl true). Qed.\n\n\
             Print Assumptions no_optimum.\n",
            self.definition()
        )
    }

    /// The theorem that a value is the optimum, and of all points that attain it. These are the set of the program's half-planes
    /// and of an equation.
    fn is_attained(&self, value: &Rational, mut system: System) -> Option<String> {
        let (end, [a, b, c], optimum) = (self.end(), self.literals(), literal(value));
        let bound = Some(value - self.constant);
        let bounds = Bounds { lower: bound.clone(), upper: bound };
        ProgramRow { form: self.costs.map(Clone::clone), bounds: &bounds }.push_to(&mut system);
        let evidence = Evidence::new(&Polyhedron::intersect(system), &by_place)?;
        let [hull, real_hull] = evidence.hull(["optimal_points", "optimal_rays"]);
        let attained = format!("{a} {b} {c} {optimum}");
        Some(format!(
            "{}\n{}\
             Lemma optimal_checked : check (forms ++ [level {attained}]) optimal_evidence optimal_points optimal_rays = true.\n\
             Proof. vm_cast_no_check (eq_refl true). Qed.\n\
             Lemma attains (p : Q * Q) : feasible p /\\ objective p == {optimum} <-> set_of optimal_points optimal_rays p.\n\
             Proof.\n  rewrite feasible_forms.\n  \
             exact (attained forms {attained} optimal_evidence optimal_points optimal_rays optimal_checked p).\nQed.\n\
             Lemma is_bound : {end} feasible objective {optimum}.\n\
             Proof. apply ({end}_value {a} {b} {c} feasible vertices rays same_set). vm_cast_no_check (eq_refl true). Qed.\n\n\
             Theorem the_optimum : {end} feasible objective {optimum}\n  \
             /\\ (forall p, feasible p /\\ objective p == {optimum} <-> {hull}).\n\
             Proof. exact (conj is_bound attains). Qed.\n\n\
             Theorem the_real_optimum : forall p,\n  \
             feasibleR p /\\ (fst p * Q2R {a} + snd p * Q2R {b} + Q2R {c} = Q2R {optimum})%R <-> {real_hull}.\n\
             Proof.\n  intros p. rewrite feasible_formsR.\n  \
             exact (attainedR forms {attained} optimal_evidence optimal_points optimal_rays optimal_checked p).\nQed.\n\n\
             Print Assumptions the_optimum.\n",
            self.definition(),
            evidence.definitions(["optimal_points", "optimal_rays", "optimal_evidence"]),
        ))
    }
}
