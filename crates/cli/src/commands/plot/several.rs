//! Several fits in one picture: of several files or error bounds in one panel, of groups of rows in one each.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use boundfit_ask::{Groups, Shows};
use boundfit_estimation::{Fit, Problem};
use boundfit_exact::Foreign;
use boundfit_figures::{
    Compared, Figure, MOST_COMPARED, MOST_PANELS, PlotOptions, Series, draw_compared, draw_groups,
};
use boundfit_formats::ColumnSelector;

use super::{Figures, Job, PlotArguments, plain_options};
use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::memory;
use crate::options::DataArguments;
use crate::progress::while_working;
use crate::work::{refuse_long_problem, times};

/// Several fits.
pub(super) enum Several {
    /// A comparison of files, error bounds or both.
    Compared(Compared),
    /// A comparison of groups of rows.
    Groups(Compared),
}

/// Returns the figure of several fits, if the options ask for one.
pub(super) fn asked(arguments: &PlotArguments) -> Result<Option<Several>, Failure> {
    let (files, bounds) = (arguments.files().count(), arguments.data.bounds().len().max(1));
    let subject = match (&arguments.by, files, bounds) {
        (None, 1, 1) => return Ok(None),
        (Some(_), 1, 1) => "'--by' draws a panel for each group of rows",
        (Some(_), ..) => {
            return Err(Failure::Usage(
                "'--by' is about the groups of one file under one '--eps', and there are several".to_owned(),
            ));
        }
        (None, 1, _) => "several '--eps' are drawn in one panel",
        (None, ..) => "several files are drawn in one panel",
    };
    if arguments.files().filter(|file| *file == "-").count() > 1 {
        return Err(Failure::Usage(
            "'-' is standard input, which is read once, and it is given twice".to_owned(),
        ));
    }
    if arguments.x_errors.are_asked() || arguments.factors()?.is_some() {
        return Err(Failure::Usage(format!("{subject}, without '--x-eps', '--x-eps-column' and '--sweep'")));
    }
    if files * bounds > MOST_COMPARED {
        return Err(Failure::Usage(format!(
            "{} fits are too many to be told apart in one panel (expected at most {MOST_COMPARED} files, error bounds, or \
             pairs of them)",
            files * bounds
        )));
    }
    let what = match arguments.figure {
        Figures::One(Figure::Fps) => Compared::Sets,
        Figures::One(Figure::Data) => Compared::Readings,
        _ => return Err(Failure::Usage(format!("{subject}: with '--figure fps' or '--figure data'"))),
    };
    Ok(Some(if arguments.by.is_some() { Several::Groups(what) } else { Several::Compared(what) }))
}

/// Reads, fits and draws.
pub(super) fn run(job: &Job, several: Several) -> CommandResult {
    match several {
        Several::Compared(what) => run_compared(job, what),
        Several::Groups(what) => run_groups(job, what),
    }
}

/// A fit with its name.
struct Named {
    name: String,
    problem: Problem,
    fit: Fit,
}

/// Each as a part of a picture.
fn series(all: &[Named]) -> Vec<Series<'_>> {
    all.iter()
        .map(|own| Series { name: Foreign::from(&own.name), problem: &own.problem, fit: &own.fit })
        .collect()
}

/// Returns the options for drawing; units that no option states come from each file.
fn options(arguments: &PlotArguments) -> PlotOptions {
    let labels = &arguments.labels;
    plain_options(arguments, [labels.x_unit.clone(), labels.y_unit.clone()])
}

/// The status of several fits.
fn status(all: &[Named]) -> Exit {
    if all.iter().any(|own| own.fit.is_empty()) { Exit::Empty } else { Exit::Answer }
}

fn run_compared(job: &Job, what: Compared) -> CommandResult {
    let mut all = Vec::new();
    let mut said = BTreeSet::new();
    for (name, data) in parts(job.arguments) {
        let problem =
            data.words_with(&job.arguments.x_errors).open()?.holding(memory::OF_A_FIGURE).whole_problem()?;
        refuse_long_problem(data.file_name(), &problem, times::PLOT, &data.table.limits)?;
        if said.insert(data.path().to_owned()) {
            let read = &problem.measurements;
            input::say_table(data.file_name(), read.table(), read.rows_missing());
        }
        let fit = while_working("fitting", || problem.fit());
        all.push(Named { name, problem, fit });
    }
    let options = options(job.arguments);
    let series = series(&all);
    job.write(while_working("drawing", || draw_compared(&series, what, &options)))?;
    Ok(status(&all))
}

/// The fits that are compared: each file under each bound, with what tells it from the others.
fn parts(arguments: &PlotArguments) -> Vec<(String, DataArguments)> {
    let files: Vec<&str> = arguments.files().collect();
    let bounds = arguments.data.bounds();
    let mut parts = Vec::new();
    for (file, name) in files.iter().zip(names(&files)) {
        if bounds.len() < 2 {
            parts.push((name.clone(), arguments.data.with(file, None)));
            continue;
        }
        for bound in bounds {
            let of_bound = format!("ε = {bound}");
            let name = if files.len() > 1 { format!("{name}, {of_bound}") } else { of_bound };
            parts.push((name, arguments.data.with(file, Some(bound))));
        }
    }
    parts
}

/// Returns the names of files: their names alone where these differ, else their paths without the common folders.
fn names(files: &[&str]) -> Vec<String> {
    let stem = |file: &&str| Path::new(file).file_stem().and_then(|stem| stem.to_str()).map(str::to_owned);
    let stems: Vec<Option<String>> = files.iter().map(stem).collect();
    if stems.iter().collect::<BTreeSet<_>>().len() == files.len() {
        return files
            .iter()
            .zip(stems)
            .map(|(file, stem)| stem.unwrap_or_else(|| (*file).to_owned()))
            .collect();
    }
    let folders = |file: &&str| Path::new(*file).parent().map_or(0, |folder| folder.components().count());
    let most = files.iter().map(folders).min().unwrap_or_default();
    let is_shared = |depth: &usize| {
        let parts = files.iter().map(|file| Path::new(file).components().nth(*depth));
        parts.collect::<BTreeSet<_>>().len() == 1
    };
    let shared = (0..most).take_while(is_shared).count();
    let rest =
        |file: &&str| Path::new(*file).components().skip(shared).collect::<PathBuf>().display().to_string();
    files.iter().map(rest).collect()
}

fn run_groups(job: &Job, what: Compared) -> CommandResult {
    let Some(by) = &job.arguments.by else { return Ok(Exit::Answer) };
    let by = ColumnSelector::name_or_number(by);
    let (asked, source) = job.arguments.data.words_with(&job.arguments.x_errors).open()?.scan();
    let groups = Groups::read(&asked, source, &by, Shows::Readings);
    let groups = groups.map_err(|refusal| Failure::of(&refusal, job.arguments.data.file_name()))?;
    let (asked, fleet) = (groups.question(), groups.fleet());
    input::say_table(job.arguments.data.file_name(), fleet.table(), fleet.rows_missing());
    input::say_note(job.arguments.data.file_name(), groups.without_readings());
    let drawn = fleet.len().min(MOST_PANELS);
    let mut all = Vec::with_capacity(drawn);
    for group in 0..drawn {
        let problem = asked.of_measurements(fleet.each(group));
        refuse_long_problem(
            job.arguments.data.file_name(),
            &problem,
            times::PLOT,
            &job.arguments.data.table.limits,
        )?;
        let fit = while_working("fitting", || problem.fit());
        all.push(Named { name: fleet.key(group).raw().to_owned(), problem, fit });
    }
    if all.is_empty() {
        let name = job.arguments.data.file_name();
        return Err(Failure::data(format_args!("{name}: there are no groups to draw")));
    }
    let options = options(job.arguments);
    let series = series(&all);
    let by = by.text();
    job.write(while_working("drawing", || draw_groups(&series, by, fleet.len(), what, &options)))?;
    Ok(status(&all))
}
