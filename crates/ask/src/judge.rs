//! The exact answer to a linear program, and the findings about solutions of it.

use boundfit_estimation::Measurements;
use boundfit_exact::{Foreign, Work};
use boundfit_formats::{Source, TableOptions, WholeFile};
use boundfit_judge::{
    Answer, Findings, Ground, JudgedSolution, Plane, Solution, SolutionError, SolveError, Tolerances,
    read_solution,
};
use boundfit_lp::{ExchangeFormat, Model, ModelError, ModelErrorKind, ModelLimits, model_text, read_model};
use boundfit_questions::times;
use boundfit_report::{
    JudgeJson, h_representation, judge_document, judge_json, kernel_program, solutions_document,
    solutions_json, solutions_junit, solutions_sarif, v_representation,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::check::{ClaimFile, tolerance};
use crate::form::{Form, Shows, Written};
use crate::given::Given;
use crate::misuse::Misuse;
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem, Subject};
use crate::refusal::Refusal;

/// The exact answer to a linear program with at most two free variables, in MPS or in the LP format of CPLEX, and the findings about
/// solutions of it.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Judge {
    /// The solutions to judge: files of HiGHS, GLPK, CBC, CLP, SCIP, CPLEX (XML), Gurobi or MIPLIB, or JSON.
    pub solution: Vec<ClaimFile>,
    /// The error that an answer may have on either side, relative to its size; 1e-6 by default.
    pub tolerance: Option<Given>,
    /// `false` takes numbers in texts for exact; otherwise they are as precise as printed.
    pub digits_as_printed: Option<bool>,
}

/// A linear program, and the solutions of it that are judged.
pub struct Solvable {
    model: Model,
    plane: Plane,
    sha256: String,
    solutions: Vec<(Foreign, Solution)>,
    tolerances: Tolerances,
}

/// The exact answer, and the judged solutions.
pub struct Solved {
    answer: Answer,
    solutions: Vec<JudgedSolution>,
}

impl Solvable {
    /// Returns the model as it stands in the file.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns the half-planes of the model in the plane of its free columns.
    pub fn plane(&self) -> &Plane {
        &self.plane
    }
}

/// The model in a file, in the format that its name or its first word tells.
fn model_of(file: &WholeFile, table: &TableOptions) -> Result<Model, Refusal> {
    let refused = |error: ModelError| Refusal::Model {
        problem: error.to_string(),
        limit: error.limit(),
        is_other: matches!(error.kind, ModelErrorKind::UnknownSection),
    };
    let text = model_text(&file.content).map_err(refused)?;
    check_text(text, table)?;
    let sizes = &table.sizes;
    let limits = ModelLimits {
        number: table.limits,
        line: sizes.line,
        rows: sizes.rows,
        columns: sizes.columns,
        entries: sizes.elements,
    };
    let format = ExchangeFormat::of_name(file.name.raw()).unwrap_or_else(|| ExchangeFormat::of_text(text));
    read_model(text, format, &limits).map_err(refused)
}

fn no_answer(error: SolveError) -> Refusal {
    Refusal::Readings(error.to_string())
}

/// Refuses a text with more, or longer, numbers with exponents than can be computed with.
fn check_text(text: &str, table: &TableOptions) -> Result<(), Refusal> {
    Ok(Work::of_text(text, table.limits.exponent).check(times::FIT, table.sizes.work)?)
}

impl Judge {
    fn solutions(&self, model: &Model, table: &TableOptions) -> Result<Vec<(Foreign, Solution)>, Refusal> {
        let solution = |text: &str| {
            let refused =
                |error: SolutionError| Refusal::Claim { problem: error.to_string(), limit: error.limit() };
            check_text(text, table)?;
            Solution::new(&read_solution(text, &table.limits).map_err(refused)?, model).map_err(refused)
        };
        let one = |ClaimFile { file, text }: &ClaimFile| match solution(text) {
            Ok(solution) => Ok((Foreign::from(file), solution)),
            Err(why) => Err(Refusal::OfFile { file: Foreign::from(file), why: Box::new(why) }),
        };
        self.solution.iter().map(one).collect()
    }
}

impl Ask for Judge {
    const NAME: &'static str = "judge";
    const FORMS: &'static [Form] = &[
        Form::Text,
        Form::Latex,
        Form::Markdown,
        Form::Json,
        Form::Sarif,
        Form::Junit,
        Form::Ine,
        Form::Ext,
    ];
    const SUBJECT: Subject = Subject::LinearProgram;
    type Problem = Solvable;
    type Answer = Solved;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Solvable, Refusal> {
        /// The cost of a model with judged solutions, relative to a fit.
        const TIMES: u64 = 2;
        let table = &asked.options.table;
        let tolerances = Tolerances {
            relative: tolerance(self.tolerance.as_ref(), &table.limits)?,
            digits_as_printed: self.digits_as_printed.unwrap_or(true),
        };
        let file = WholeFile::read(source, &table.sizes)?;
        let model = model_of(&file, table)?;
        // A theorem is about programs that are in the plane as they stand in the file.
        if shows >= Shows::Readings && model.columns.len() != 2 {
            return Err(Refusal::ColumnsOfTheorem { file: file.name, count: model.columns.len() });
        }
        model.work().check(TIMES, asked.most_work())?;
        let plane = Plane::new(&model).map_err(no_answer)?;
        let solutions = self.solutions(&model, table)?;
        Ok(Solvable { model, plane, sha256: file.sha256, solutions, tolerances })
    }

    fn measurements<'a>(&self, _: &'a Solvable) -> Option<&'a Measurements> {
        None
    }

    fn answer(&self, program: &Solvable) -> Result<Solved, Refusal> {
        let Solvable { model, plane, solutions, tolerances, .. } = program;
        let answer = Answer::in_plane(model, plane).map_err(no_answer)?;
        if solutions.is_empty() {
            return Ok(Solved { answer, solutions: Vec::new() });
        }
        let ground = Ground::new(model, &answer);
        let judged = solutions.iter().map(|(file, solution)| JudgedSolution {
            file: file.clone(),
            solution: solution.clone(),
            findings: ground.judge(solution, tolerances),
        });
        let solutions = judged.collect();
        Ok(Solved { answer, solutions })
    }

    fn write(
        &self,
        Solvable { model, plane, sha256, .. }: &Solvable,
        Solved { answer, solutions }: &Solved,
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = *paper;
        match paper.form {
            Form::Json => {
                let json = JudgeJson::new(model, plane, answer, origin.file, sha256, &style);
                paper.put(judge_json(&json.with_solutions(solutions_json(model, solutions, &style))))
            }
            Form::Sarif => paper.put(solutions_sarif(model, solutions)),
            Form::Junit => paper.put(solutions_junit(model, solutions)),
            Form::Ine => paper.put(h_representation(plane.polyhedron())),
            Form::Ext => paper.put(v_representation(plane.polyhedron())),
            _ => Self::report(paper, || {
                let mut document = judge_document(model, plane, answer, origin.name(), &style);
                document.append(solutions_document(model, solutions));
                document
            }),
        }?;
        Ok(Written {
            // Who asks about solutions is not asked to look at the status twice.
            is_empty: matches!(answer, Answer::Infeasible { .. }) && solutions.is_empty(),
            is_refuted: solutions.iter().any(|judged| Findings::is_refuted(&judged.findings)),
            ..Written::default()
        })
    }

    fn theorem(
        &self,
        Solvable { model, sha256, .. }: &Solvable,
        Solved { answer, .. }: &Solved,
        AskedTheorem { theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        kernel_program(model, answer, Some(sha256), theory)
            .ok_or_else(|| Refusal::Readings("this answer has no certificate".to_owned()))
    }

    fn refuse_vain(&self, form: Form) -> Result<(), Refusal> {
        match matches!(form, Form::Sarif | Form::Junit) && self.solution.is_empty() {
            true => Err(Refusal::Misuse(Misuse::FindingsOfNothing)),
            false => Ok(()),
        }
    }
}
