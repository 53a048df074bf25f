//! What every solver is worth on each of many cases: the table and the JSON of `bench-solvers`.

use boundfit_check::Check;
use boundfit_exact::{Foreign, Reading};
use boundfit_judge::{Findings, JudgedSolver, Worth};
use serde::Serialize;

use crate::json::to_text;

/// A case with the worst verdict of each source on it.
#[derive(Debug, Clone)]
pub struct CaseVerdicts {
    name: Foreign,
    claims: Vec<Claim>,
}

#[derive(Debug, Clone)]
struct Claim {
    source: Foreign,
    /// What it is judged by: the numbers as they are, or the doubles that the solver received.
    reading: Reading,
    verdict: String,
    is_refuted: bool,
}

impl CaseVerdicts {
    /// Of a fit, whose four programs the sources answered.
    pub fn of_fit(name: Foreign, check: &Check) -> Self {
        let claims = check.answers.iter().map(|answer| Claim {
            source: answer.source.clone(),
            reading: answer.reading,
            verdict: answer.worst().name().to_owned(),
            is_refuted: answer.worst().is_refutation(),
        });
        CaseVerdicts { name, claims: claims.collect() }
    }

    /// Of a linear program in a file. What is refuted is named.
    pub fn of_model(name: Foreign, solvers: &[JudgedSolver]) -> Self {
        let claims = solvers.iter().flat_map(|solver| {
            let readings = [(Reading::Decimal, &solver.as_read), (Reading::Binary64, &solver.received)];
            readings.map(|(reading, findings)| Claim {
                source: solver.source.clone(),
                reading,
                verdict: verdict(findings),
                is_refuted: findings.is_refuted(),
            })
        });
        CaseVerdicts { name, claims: claims.collect() }
    }

    fn claim(&self, source: &Foreign, reading: Reading) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.source == *source && claim.reading == reading)
    }
}

/// The worst of all aspects, and which are refuted.
fn verdict(findings: &Findings) -> String {
    let refuted = findings.findings.iter().filter(|finding| finding.worth == Worth::Refuted);
    let refuted: Vec<&str> = refuted.map(|finding| finding.aspect.name()).collect();
    let worst = findings.worst().name();
    if refuted.is_empty() { worst.to_owned() } else { format!("{worst}: {}", refuted.join(", ")) }
}

/// A Markdown table of the worst verdict of each source on each case.
pub fn cases_table(cases: &[CaseVerdicts]) -> String {
    let mut sources: Vec<&Foreign> = Vec::new();
    for claim in cases.iter().flat_map(|case| &case.claims) {
        if !sources.contains(&&claim.source) {
            sources.push(&claim.source);
        }
    }
    let names: Vec<String> = sources.iter().map(|source| source.to_string()).collect();
    let mut text = format!("| case | {} |\n|---|{}\n", names.join(" | "), "---|".repeat(sources.len()));
    let mut right = vec![0; sources.len()];
    for case in cases {
        let mut cells = Vec::new();
        for (source, right) in sources.iter().zip(&mut right) {
            let as_read = case.claim(source, Reading::Decimal);
            let received = case.claim(source, Reading::Binary64).or(as_read);
            let verdict = |claim: Option<&Claim>| claim.map_or("-".to_owned(), |claim| claim.verdict.clone());
            *right += usize::from(as_read.is_some_and(|claim| !claim.is_refuted));
            cells.push(if verdict(as_read) == verdict(received) {
                verdict(as_read)
            } else {
                format!("{} ({} for the doubles it received)", verdict(as_read), verdict(received))
            });
        }
        text.push_str(&format!("| `{}` | {} |\n", case.name, cells.join(" | ")));
    }
    let totals: Vec<String> = right.iter().map(|count| format!("{count} of {}", cases.len())).collect();
    text.push_str(&format!("| not refuted | {} |\n", totals.join(" | ")));
    text
}

#[derive(Serialize)]
struct CasesJson<'a> {
    schema: &'static str,
    cases: Vec<CaseJson<'a>>,
}

#[derive(Serialize)]
struct CaseJson<'a> {
    name: &'a Foreign,
    claims: Vec<VerdictJson<'a>>,
}

#[derive(Serialize)]
struct VerdictJson<'a> {
    source: &'a Foreign,
    reading: &'static str,
    verdict: &'a str,
}

/// The worst verdict of each source on each case as JSON, schema `boundfit/bench-solvers/1`, with a line end.
pub fn cases_json(cases: &[CaseVerdicts]) -> String {
    let cases = cases.iter().map(|case| CaseJson {
        name: &case.name,
        claims: case
            .claims
            .iter()
            .map(|claim| VerdictJson {
                source: &claim.source,
                reading: claim.reading.name(),
                verdict: &claim.verdict,
            })
            .collect(),
    });
    to_text(&CasesJson { schema: "boundfit/bench-solvers/1", cases: cases.collect() })
}
