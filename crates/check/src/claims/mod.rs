//! Claims brought from elsewhere: JSON with all four ends, and solvers' own files with one each.

mod all_ends;
mod error;
mod limits;
mod programs;
mod solution;

use std::path::Path;

use boundfit_estimation::Problem;
use boundfit_exact::{Foreign, Work};
use boundfit_judge::SolutionFile;
use boundfit_lp::{BoundClaim, PuiEnd};

pub use all_ends::{nested_beyond, parse_claim_pui};
pub use error::{ClaimError, ClaimFileError};
pub use limits::ClaimLimits;

use crate::answer::Answer;
use all_ends::parse_claim_file;
use programs::Programs;
use solution::parse_solution;

/// A claims file in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimText {
    /// The file, as it was named.
    pub file: Foreign,
    /// The text of the claim.
    pub text: String,
}

/// The answers of claims files, before the rows are known that they are about.
#[derive(Debug, Clone, Default)]
pub struct Claims(Vec<Draft>);

/// Reads claims files. Their content tells the format. A JSON file is a whole answer. A solution file answers the
/// last program in its name (`theta1-min` and so on), or the program that it states. Files whose paths differ in
/// nothing else form one answer, which claims nothing about ends without a file. Numbers are exact as printed.
///
/// # Errors
/// The first file with something wrong, and what that is.
pub fn read_claims(files: &[ClaimText], limits: &ClaimLimits) -> Result<Claims, ClaimFileError> {
    let mut drafts: Vec<Draft> = Vec::new();
    for file in files {
        let fail = |problem| ClaimFileError { file: file.file.clone(), problem };
        // Numbers with exponents are counted before any of them is built.
        let work = Work::of_text(&file.text, limits.number.exponent);
        work.check(1, limits.work).map_err(|error| fail(error.into()))?;
        if is_json(&file.text) {
            let answer = parse_claim_file(&file.text, &file.file, limits).map_err(fail)?;
            drafts.push(Draft::Whole(Box::new(answer)));
            continue;
        }
        let solution = parse_solution(&file.text, &limits.number).map_err(|error| fail(error.into()))?;
        let (target, key) = program_and_group(file.file.raw(), &solution).map_err(fail)?;
        let same = |draft: &&mut Draft| matches!(draft, Draft::Group(group) if group.key == key);
        if let Some(Draft::Group(group)) = drafts.iter_mut().find(same) {
            group.add(target, file, solution).map_err(fail)?;
        } else {
            let mut group = SolutionGroup { key, members: Vec::new() };
            group.add(target, file, solution).map_err(fail)?;
            drafts.push(Draft::Group(group));
        }
    }
    Ok(Claims(drafts))
}

impl Claims {
    /// Returns whether one of them has multipliers, which are about rows by their place among all of them.
    pub fn have_duals(&self) -> bool {
        self.0.iter().any(|draft| match draft {
            Draft::Whole(answer) => answer.has_duals(),
            Draft::Group(group) => group.members.iter().any(|(.., file)| file.has_duals),
        })
    }

    /// The answers about a problem. Cost: linear in its rows where there are multipliers.
    pub fn answers(self, problem: &Problem) -> Vec<Answer> {
        let mut programs = self.have_duals().then(|| Programs::new(problem));
        self.0.into_iter().map(|draft| draft.answer(programs.as_mut())).collect()
    }
}

/// Returns whether a file of a folder of claims answers one of the four programs, by its name. Programs themselves, bases and logs
/// do not, nor do claims in JSON, which answer all four.
pub fn is_solution_name(file: &Path) -> bool {
    const OTHERS: [&str; 6] = ["mps", "lp", "log", "bas", "json", "gz"];
    let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    !OTHERS.contains(&extension.to_ascii_lowercase().as_str()) && PuiEnd::find(name).is_some()
}

fn is_json(text: &str) -> bool {
    text.trim_start_matches('\u{feff}').trim_start().starts_with(['{', '['])
}

/// The part of a name that the files of one answer have in common.
#[derive(Debug, Clone, PartialEq, Eq)]
struct GroupKey {
    format: &'static str,
    /// The path up to the name of the program and after it.
    path: (String, String),
}

/// The program that a file answers, and the answer that it is a part of.
fn program_and_group(file: &str, solution: &SolutionFile) -> Result<(PuiEnd, GroupKey), ClaimError> {
    let folder = Path::new(file).parent().map(|folder| folder.join("").to_string_lossy().into_owned());
    let name = Path::new(file).file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let key = |before: &str, after: &str| GroupKey {
        format: solution.writer,
        path: (format!("{}{before}", folder.as_deref().unwrap_or_default()), after.to_owned()),
    };
    match (PuiEnd::find(name), solution::target(solution)) {
        (Some((_, named, _)), Some(inside)) if named != inside => {
            Err(ClaimError::OtherTarget { named, inside })
        }
        (Some((before, named, after)), _) => Ok((named, key(before, after))),
        // Without a name to go by, what lies in one folder belongs together.
        (None, Some(inside)) => Ok((inside, key("", ""))),
        (None, None) => Err(ClaimError::NoTarget),
    }
}

/// An answer in the making.
#[derive(Debug, Clone)]
enum Draft {
    Whole(Box<Answer>),
    Group(SolutionGroup),
}

impl Draft {
    fn answer(self, programs: Option<&mut Programs>) -> Answer {
        match self {
            Draft::Whole(answer) => *answer,
            Draft::Group(group) => group.answer(programs),
        }
    }
}

/// Solution files that answer one program each.
#[derive(Debug, Clone)]
struct SolutionGroup {
    key: GroupKey,
    members: Vec<(PuiEnd, Foreign, SolutionFile)>,
}

impl SolutionGroup {
    fn add(&mut self, target: PuiEnd, file: &ClaimText, solution: SolutionFile) -> Result<(), ClaimError> {
        if let Some((_, other, _)) = self.members.iter().find(|(member, ..)| *member == target) {
            return Err(ClaimError::Twice { target, other: other.clone() });
        }
        self.members.push((target, file.file.clone(), solution));
        Ok(())
    }

    fn answer(mut self, mut programs: Option<&mut Programs>) -> Answer {
        for (target, _, file) in &mut self.members {
            if let Some(known) =
                programs.as_mut().and_then(|programs| programs.without_cost_row(file, *target))
            {
                *file = known;
            }
        }
        // The files of one group have one writer; one without values may not tell it.
        let writer =
            self.members.iter().map(|(.., file)| file.writer).find(|writer| *writer != self.key.format);
        let (before, after) = &self.key.path;
        let source = match self.members.as_slice() {
            [(_, file, _)] => file.raw().to_owned(),
            _ => format!("{before}*{after}"),
        };
        let claims = PuiEnd::each(|end| {
            let member = self.members.iter().find(|(member, ..)| *member == end);
            member.map_or_else(
                || BoundClaim::nothing("no file given"),
                |(.., file)| solution::claim(file, end, programs.as_deref()),
            )
        });
        let source = format!("{}, {source}", writer.unwrap_or(self.key.format));
        Answer { source: source.into(), exact_input: false, claims }
    }
}
