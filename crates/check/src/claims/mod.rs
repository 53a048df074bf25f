//! Claims brought from elsewhere: JSON with all four ends, and solvers' own files with one each.

mod cplex;
mod error;
mod glpk;
mod highs;
mod solution;
mod text;

use std::path::Path;

use boundfit_exact::Limits;
use boundfit_lp::{BoundClaim, End};

pub use error::{ClaimError, ClaimFileError};

use crate::answer::{Answer, nothing};
use crate::claim_file::parse_claim_file;
use crate::target::Target;
use solution::Solution;

/// What a claims file may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClaimLimits {
    /// Of one number.
    pub number: Limits,
    /// How deep arrays and objects of JSON may be nested. At most 120, so that no stack overflows.
    pub nesting: usize,
}

impl Default for ClaimLimits {
    /// Those of numbers, and 64 levels.
    fn default() -> Self {
        ClaimLimits { number: Limits::default(), nesting: 64 }
    }
}

/// A claims file in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimText {
    /// The file, as it was named.
    pub file: String,
    /// What it says.
    pub text: String,
}

/// Reads claims files. Their content tells the format. JSON is an answer by itself; a solution file answers the program
/// that its name says (`theta1-min` and so on, the last one in it) or that it is about, and those whose paths differ in
/// nothing else form one answer, in which nothing is claimed about ends without a file. Numbers are exact as printed.
///
/// # Errors
/// The first file with something wrong, and what that is.
pub fn read_claims(files: &[ClaimText], limits: &ClaimLimits) -> Result<Vec<Answer>, ClaimFileError> {
    let mut parts: Vec<Part> = Vec::new();
    for file in files {
        let fail = |problem| ClaimFileError { file: file.file.clone(), problem };
        if is_json(&file.text) {
            let answer = parse_claim_file(&file.text, &file.file, limits).map_err(fail)?;
            parts.push(Part::Whole(Box::new(answer)));
            continue;
        }
        let solution = parse_solution(&file.text, &limits.number).map_err(fail)?;
        let (target, key) = place(&file.file, &solution).map_err(fail)?;
        let same = |part: &&mut Part| matches!(part, Part::Group(group) if group.key == key);
        if let Some(Part::Group(group)) = parts.iter_mut().find(same) {
            group.add(target, file, solution).map_err(fail)?;
        } else {
            let mut group = Group { key, members: Vec::new() };
            group.add(target, file, solution).map_err(fail)?;
            parts.push(Part::Group(group));
        }
    }
    Ok(parts.into_iter().map(Part::answer).collect())
}

/// Whether a file of a folder of claims answers one of the four programs, by its name. Programs themselves, bases and logs
/// do not, nor do claims in JSON, which answer all four.
pub fn is_solution_name(file: &Path) -> bool {
    const OTHERS: [&str; 6] = ["mps", "lp", "log", "bas", "json", "gz"];
    let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    !OTHERS.contains(&extension.to_ascii_lowercase().as_str()) && Target::find(name).is_some()
}

fn is_json(text: &str) -> bool {
    text.trim_start_matches('\u{feff}').trim_start().starts_with(['{', '['])
}

/// Reads a solver's own file.
fn parse_solution(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    type Is = fn(&str) -> bool;
    type Parse = fn(&str, &Limits) -> Result<Solution, ClaimError>;
    let formats: [(Is, Parse); 7] = [
        (cplex::is_xml, cplex::parse),
        (highs::is_raw, highs::parse_raw),
        (highs::is_table, highs::parse_table),
        (glpk::is_printed, glpk::parse_printed),
        (text::is_cbc, text::parse_cbc),
        (text::is_scip, text::parse_scip),
        (glpk::is_plain, glpk::parse_plain),
    ];
    let parse = formats.into_iter().find(|(is_it, _)| is_it(text)).map(|(_, parse)| parse);
    parse.ok_or(ClaimError::UnknownFormat)?(text, limits)
}

/// What the files of one answer have in common.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Key {
    format: &'static str,
    /// The path up to the name of the program and after it.
    path: (String, String),
}

/// The program that a file answers, and the answer that it is a part of.
fn place(file: &str, solution: &Solution) -> Result<(Target, Key), ClaimError> {
    let folder = Path::new(file).parent().map(|folder| folder.join("").to_string_lossy().into_owned());
    let name = Path::new(file).file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let key = |before: &str, after: &str| Key {
        format: solution.format,
        path: (format!("{}{before}", folder.as_deref().unwrap_or_default()), after.to_owned()),
    };
    match (Target::find(name), solution.target) {
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
enum Part {
    Whole(Box<Answer>),
    Group(Group),
}

struct Group {
    key: Key,
    members: Vec<(Target, String, BoundClaim)>,
}

impl Group {
    fn add(&mut self, target: Target, file: &ClaimText, solution: Solution) -> Result<(), ClaimError> {
        if let Some((_, other, _)) = self.members.iter().find(|(member, ..)| *member == target) {
            return Err(ClaimError::Twice { target, other: other.clone() });
        }
        self.members.push((target, file.file.clone(), solution.claim(target)));
        Ok(())
    }
}

impl Part {
    fn answer(self) -> Answer {
        let mut group = match self {
            Part::Whole(answer) => return *answer,
            Part::Group(group) => group,
        };
        let (before, after) = &group.key.path;
        let source = match group.members.as_slice() {
            [(_, file, _)] => format!("{}, {file}", group.key.format),
            _ => format!("{}, {before}*{after}", group.key.format),
        };
        let mut claim = |axis: usize, end: End| {
            let is_it =
                |(target, ..): &(Target, String, BoundClaim)| target.axis() == axis && target.end() == end;
            let place = group.members.iter().position(is_it);
            place.map_or_else(|| nothing("no file given"), |place| group.members.swap_remove(place).2)
        };
        let claims = [0, 1].map(|axis| [claim(axis, End::Lower), claim(axis, End::Upper)]);
        Answer { source, exact_input: false, claims }
    }
}
