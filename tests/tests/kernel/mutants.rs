//! Proofs of fits in JSON with one change, and three judges: `crates/verify`, `tests/verify.py`, and the checker of the theory.
//! The checker gets the vertices, sides, contradictions and ends of the proof as its evidence. No judge accepts what the engine
//! finds false, and the checker accepts the evidence of what the others accept.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use boundfit_estimation::{Fit, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_geometry::Direction;
use boundfit_report::{Theory, kernel_fit};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::proofs::{
    Question, bounded, generated, questions, statuses_in_python, tampered, verdict,
};
use serde_json::Value;

use crate::coq::{body, compiled};

/// Mutants of one proof, and of all; a share of them is tried.
const OF_EACH: usize = 30;
const ALL: usize = 3_000;

/// A fit, its proof, and the half-planes as the checker numbers them.
struct Proved {
    question: Question,
    fit: Fit,
    proof: Value,
    definitions: String,
    numbers: HashMap<String, usize>,
}

impl Proved {
    /// `None` for questions with other than a few rows.
    fn of(question: Question) -> Option<Self> {
        let problem = question.problem().ok()?;
        let proof: Value = serde_json::from_str(&question.proof_of(&problem)?).unwrap();
        let fit = fit(&problem).with_every_half_plane(&problem);
        let text = body(&kernel_fit(&problem, &fit, question.options.reading, None, Theory::Installed)?);
        let (rows, rest) = text.split_once("(* What the rows say of p").unwrap();
        let forms = rest.lines().find(|line| line.starts_with("Definition forms ")).unwrap();
        let definitions = format!("{rows}{forms}\n");
        let numbers = numbers(&proof, rows);
        (numbers.len() <= 60).then_some(Proved { question, fit, proof, definitions, numbers })
    }

    /// The evidence of a proof as a computation by the checker, and its statement; `None` where it has none of these kinds.
    fn evidence(&self, proof: &Value) -> Option<Evidence> {
        let sides = proof["sides"].as_array()?;
        let vertices: Vec<[Rational; 2]> =
            proof["vertices"].as_array()?.iter().map(pair).collect::<Option<_>>()?;
        let numbers: Vec<usize> = sides.iter().map(|side| self.number(&side[0])).collect::<Option<_>>()?;
        if sides.is_empty() && vertices.is_empty() {
            let farkas = proof["farkas"].as_array()?;
            // The checker finds the multipliers itself, and takes no half-plane twice or without need.
            let farkas: BTreeSet<usize> =
                farkas.iter().map(|own| self.number(&own[0])).collect::<Option<_>>()?;
            let farkas: Vec<usize> = farkas.into_iter().collect();
            let chosen = |bits: usize| {
                let own = farkas.iter().enumerate().filter(move |(index, _)| bits >> index & 1 == 1);
                own.map(|(_, &number)| number).collect::<Vec<usize>>()
            };
            let tries: Vec<String> = (1..1_usize << farkas.len().min(6))
                .map(chosen)
                .flat_map(|own| [own.clone(), own.into_iter().rev().collect()])
                .map(|own| format!("check_empty forms [{}]%Z", joined(&own)))
                .collect();
            let accepts = tries.join(" || ");
            let has_farkas = !farkas.is_empty() && proof["bounds"].as_array()?.is_empty();
            return has_farkas.then_some(Evidence { accepts, statement: None });
        }
        // The vertex where a side ends.
        let ends: Vec<Option<usize>> =
            sides.iter().map(|side| side[1].as_u64().map(|own| own as usize)).collect();
        let count = sides.len();
        let gaps: Vec<usize> = (0..count).filter(|&index| ends[index].is_none()).collect();
        let at = |index: usize| ends[index].and_then(|own| vertices.get(own).cloned());
        let (points, rays, certificates) = match (gaps.as_slice(), vertices.len()) {
            ([], 1) => (vertices.clone(), Vec::new(), vec![format!("Pinned [{}]%Z", joined(&numbers))]),
            ([], 2) => {
                let [a, b, c, d] = numbers[..] else { return None };
                let turns = [[a, b, c, d], [b, c, d, a], [c, d, a, b], [d, a, b, c]];
                let both = turns.iter().flat_map(|[a, b, c, d]| {
                    [format!("Segment {a} {c} {b} {d}"), format!("Segment {a} {c} {d} {b}")]
                });
                (vertices.clone(), Vec::new(), both.collect())
            }
            ([], _) => {
                let points: Vec<_> = (0..count).map(at).collect::<Option<_>>()?;
                let leaving: Vec<usize> = (0..count).map(|index| numbers[(index + 1) % count]).collect();
                (points, Vec::new(), vec![format!("Polygon [{}]%Z", joined(&leaving))])
            }
            ([gap], _) => {
                let order: Vec<usize> = (1..=count).map(|step| (gap + step) % count).collect();
                let points: Vec<_> =
                    order[..count - 1].iter().map(|&index| at(index)).collect::<Option<_>>()?;
                let normal = |index: usize| self.normal(&sides[index][0]);
                let (first, last) = (normal(order[0])?, normal(order[count - 1])?);
                let (from, to) = (first.turned_right(), last.turned_left());
                let mut own: Vec<usize> = order.iter().map(|&index| numbers[index]).collect();
                let mut rays = vec![from.clone()];
                if from != to {
                    rays.push(to);
                    own.push(0);
                }
                // A ray has three sides.
                if points.is_empty()
                    || (points.len() == 1 && first == last.reversed())
                    || points.len() + 1 != count
                {
                    return None;
                }
                if count == 3 && points[0] == points[1] {
                    return None;
                }
                (points, rays, vec![format!("Polygon [{}]%Z", joined(&own))])
            }
            _ => return None,
        };
        let vs = listed(&points);
        let rs = listed(&rays.iter().map(|own| [own.dx().into(), own.dy().into()]).collect::<Vec<_>>());
        let tries: Vec<String> =
            certificates.iter().map(|own| format!("check forms ({own}) {vs} {rs}")).collect();
        let mut accepts = format!("({})", tries.join(" || "));
        let bounds = proof["bounds"].as_array().filter(|own| own.len() == 4)?;
        let mut found = Vec::new();
        for (index, bound) in bounds.iter().enumerate() {
            let (form, which) = (["fst", "snd"][index / 2], ["lowest", "highest"][index % 2]);
            let end = if bound[0].as_array()?.is_empty() {
                None
            } else {
                Some(pair(&bound[1])?[index / 2].clone())
            };
            accepts += &match &end {
                Some(end) => format!(" && check_{which} {form} {vs} {rs} {}", literal(end)),
                None => format!(" && check_no_{which} {form} {vs} {rs}"),
            };
            found.push(end);
        }
        Some(Evidence { accepts, statement: Some(Statement { points, rays, ends: found }) })
    }

    fn number(&self, name: &Value) -> Option<usize> {
        self.numbers.get(name.as_str()?).copied()
    }

    fn normal(&self, name: &Value) -> Option<Direction> {
        let index = self
            .fit
            .fps
            .names()
            .iter()
            .position(|own| own.to_string() == name.as_str().unwrap_or_default())?;
        Direction::from_rational(&self.fit.fps.polyhedron().system().inequalities().get(index)?.a)
    }

    /// Returns whether a statement is true, by the engine.
    fn is_true(&self, statement: Option<&Statement>) -> bool {
        let polyhedron = self.fit.fps.polyhedron();
        let region = polyhedron.region();
        let Some(Statement { points, rays, ends }) = statement else { return self.fit.is_empty() };
        let rows = polyhedron.system().inequalities();
        let goes_on = |ray: &Direction| {
            rows.iter().all(|own| {
                !(&own.a[0] * Rational::from(ray.dx().clone()) + &own.a[1] * Rational::from(ray.dy().clone()))
                    .is_positive()
            })
        };
        let Some(ranges) = self.fit.pui_intervals() else { return false };
        let true_ends =
            ranges.iter().flat_map(|own| [own.lower().value().cloned(), own.upper().value().cloned()]);
        points.iter().all(|own| polyhedron.membership(own).is_inside())
            && region.vertices().iter().all(|own| points.contains(&own.point().coordinates()))
            && rays.iter().all(goes_on)
            && region.rays().iter().all(|own| rays.contains(own))
            && region.lines().is_empty()
            && true_ends.eq(ends.iter().cloned())
    }
}

struct Evidence {
    /// A term that is true if the checker accepts.
    accepts: String,
    /// `None` says that nothing is feasible.
    statement: Option<Statement>,
}

struct Statement {
    points: Vec<[Rational; 2]>,
    rays: Vec<Direction>,
    ends: Vec<Option<Rational>>,
}

/// The half-planes of rows and conditions by their names in a proof.
fn numbers(proof: &Value, rows: &str) -> HashMap<String, usize> {
    let ends: Vec<u64> = proof["rows"].as_array().unwrap().iter().map(|own| own.as_u64().unwrap()).collect();
    let wanted = ends.chunks(2).flat_map(|range| range[0]..=range[1]);
    let text = rows.split_once("read [\"").unwrap().1.split_once("\"]%text").unwrap().0;
    let text = text.replace("\";\n\"", "");
    let mut names = Vec::new();
    for (row, line) in wanted.zip(text.lines()) {
        let cells: Vec<&str> = line.split(',').collect();
        let [lower, upper] = match rows.contains("Definition least ") {
            true => [cells.len() - 2, cells.len() - 1].map(|place| !cells[place].is_empty()),
            false => [true, true],
        };
        names.extend(lower.then(|| format!("{row} lower")));
        names.extend(upper.then(|| format!("{row} upper")));
    }
    for (index, condition) in proof["conditions"].as_array().unwrap().iter().enumerate() {
        let name = format!("where:{}", index + 1);
        match condition.as_array().unwrap().len() {
            4 => names.extend([format!("{name} lower"), format!("{name} upper")]),
            _ => names.push(name),
        }
    }
    names.into_iter().enumerate().map(|(index, name)| (name, index + 1)).collect()
}

fn pair(value: &Value) -> Option<[Rational; 2]> {
    let number = |own: &Value| Reading::Decimal.read(own.as_str()?, &Limits::default()).ok();
    let [x, y] = value.as_array()?.as_slice() else { return None };
    Some([number(x)?, number(y)?])
}

fn joined(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

fn literal(number: &Rational) -> String {
    format!("({} # {})", number.numerator(), number.denominator())
}

fn listed(points: &[[Rational; 2]]) -> String {
    let points: Vec<String> =
        points.iter().map(|own| format!("({}, {})", literal(&own[0]), literal(&own[1]))).collect();
    format!("[{}]", points.join("; "))
}

#[test]
fn three_judges_agree_about_changed_proofs() {
    let mut rng = seeded(3108);
    let more = std::iter::repeat_with(|| generated(&mut rng)).take(200);
    let mut proved = Vec::new();
    // (the proof, the mutant, its evidence, whether it is the proof itself)
    let mut cases: Vec<(usize, Value, Evidence, bool)> = Vec::new();
    for own in questions().into_iter().chain(bounded()).chain(more).filter_map(Proved::of) {
        let Some(evidence) = own.evidence(&own.proof).filter(|_| cases.len() < share(ALL)) else { continue };
        let is_about_evidence = |place: &str| {
            ["/vertices", "/sides", "/farkas", "/bounds"].iter().any(|start| place.starts_with(start))
        };
        let mut mutants: Vec<Value> = tampered(&own.proof)
            .into_iter()
            .filter(|(place, mutant)| is_about_evidence(place) && own.evidence(mutant).is_some())
            .map(|(_, mutant)| mutant)
            .collect();
        let step = mutants.len().div_ceil(share(OF_EACH)).max(1);
        mutants = mutants.into_iter().step_by(step).collect();
        cases.push((proved.len(), own.proof.clone(), evidence, true));
        for mutant in mutants {
            let evidence = own.evidence(&mutant).unwrap();
            cases.push((proved.len(), mutant, evidence, false));
        }
        proved.push(own);
    }
    let asked: Vec<(Vec<u8>, &[u8])> = cases
        .iter()
        .map(|(index, proof, ..)| (proof.to_string().into_bytes(), &proved[*index].question.data[..]))
        .collect();
    let python = statuses_in_python(&asked);
    let mut text = String::from(
        "From Boundfit Require Import Reader Checker Convex Sound Rationals.\n\
         From Coq Require Import ZArith QArith List.\nImport ListNotations.\nOpen Scope Q_scope.\n",
    );
    let mut last = None;
    for (index, _, evidence, _) in &cases {
        if last != Some(index) {
            text += &last.map_or(String::new(), |own| format!("End M{own}.\n"));
            text += &format!("Module M{index}.\n{}", proved[*index].definitions);
        }
        last = Some(index);
        text += &format!("Eval vm_compute in ({})%bool.\n", evidence.accepts);
    }
    text += &last.map_or(String::new(), |own| format!("End M{own}.\n"));
    let output = compiled("mutants", &text).unwrap();
    let kernel: Vec<bool> =
        output.lines().filter_map(|line| line.trim().strip_prefix("= ")).map(|own| own == "true").collect();
    assert_eq!(kernel.len(), cases.len());
    let mut counts = BTreeMap::<_, usize>::new();
    for ((((index, proof, evidence, is_original), (text, data)), python), kernel) in
        cases.iter().zip(&asked).zip(python).zip(kernel)
    {
        let own = &proved[*index];
        let shown = || format!("{}: {proof}", own.question.name);
        let is_true = own.is_true(evidence.statement.as_ref());
        assert_eq!(verdict(text, data), python, "{}", shown());
        assert!(is_true || !kernel, "accepted by the kernel, and false: {}", shown());
        assert!(is_true || python != 0, "accepted by the other judges, and false: {}", shown());
        assert!(kernel || python != 0, "accepted by the other judges alone: {}", shown());
        assert!(kernel && python == 0 || !is_original, "refused, and true: {}", shown());
        *counts.entry((*is_original, python == 0, kernel)).or_default() += 1;
    }
    println!("mutants, by (true proof, accepted by verify and Python, by the kernel): {counts:?}");
    assert!(cases.len() >= share(ALL) && counts[&(false, false, false)] > share(ALL) / 5, "{counts:?}");
}
