//! `boundfit plot`.

use std::io::{self, IsTerminal};
use std::path::Path;

use boundfit_estimation::{Family, Problem, fit};
use boundfit_figures::{
    Encoding, Figure, FigureError, Picture, PictureFormat, PlotOptions, draw, draw_boxes, draw_outliers,
    draw_sweep, draw_x_errors,
};
use boundfit_questions::{NoOutliers, OutlierLimits, Outliers, XErrorFit, XErrorProblem};

use crate::CommandResult;
use crate::arguments::{FactorRange, Figures, PlotArguments};
use crate::commands::fit::SWEEP_OF_FIXED;
use crate::commands::outliers::refusal;
use crate::commands::pictures::{EXPECTED, told_by_name};
use crate::exit::{Exit, Failure};
use crate::output::{self, Guard, Output};
use crate::progress::while_working;
use crate::work::{refuse_long_outliers, refuse_long_problem, refuse_long_sweep, times};

/// Where pictures go.
enum Destination<'a> {
    /// One picture to a file, or to standard output.
    One(Figure, Option<&'a str>),
    /// The pictures of every fit into a folder.
    All(&'a str),
}

/// Reads the data, fits, draws every picture that is asked for, and then writes them.
pub(crate) fn run(arguments: &PlotArguments) -> CommandResult {
    let draw_x_errors = match arguments.x_errors.are_asked()? {
        true => Some(x_error_figure(arguments.figure)?),
        false => None,
    };
    let factors = arguments.factors()?;
    if factors.is_some() && !matches!(arguments.figure, Figures::One(Figure::Fps)) {
        return Err(Failure::Usage(
            "'--sweep' draws sets of parameters: with '--figure fps' alone".to_owned(),
        ));
    }
    refuse_ranges_of_statuses(arguments)?;
    refuse_letters_without_room(arguments)?;
    let (destination, format) = destination(arguments)?;
    let name = |figure: Figure| format!("{}.{}", figure.name(), format.name());
    let guard = arguments.replace.guard([arguments.data.path()]);
    match destination {
        Destination::One(_, file) => guard.check(file)?,
        Destination::All(folder) => guard.check_all(folder, Figure::OF_FIT.map(name))?,
    }
    if let (Some(draw), Destination::One(_, file)) = (draw_x_errors, &destination) {
        return run_with_x_errors(arguments, draw, format, *file, &guard);
    }
    let problem = arguments.data.open().shown_problem()?;
    let limits = &arguments.data.table.limits;
    let figures = if matches!(destination, Destination::All(_)) { Figure::OF_FIT.len() as u64 } else { 1 };
    refuse_long_problem(arguments.data.file_name(), &problem, figures * times::PLOT, limits)?;
    if let Destination::One(Figure::Outliers, file) = destination {
        refuse_long_outliers(arguments.data.file_name(), &problem, limits)?;
        let limits = OutlierLimits::default();
        let outliers = while_working("looking for outliers", || Outliers::new(&problem, &limits));
        let picture = match outliers {
            // The figure shows the contradiction then.
            Err(NoOutliers::Conditions(_)) => None,
            Err(why) => return Err(refusal(arguments.data.file_name(), &why, None)),
            Ok(outliers) => Some(draw_outliers(&problem, &outliers, &options(arguments, &problem))),
        };
        if let Some(picture) = picture {
            let encoded = |picture: Picture| picture.encoded_as(format, &encoding(arguments));
            let picture = picture.and_then(encoded).map_err(Failure::data)?;
            output::write(picture, file, &guard)?;
            return Ok(Exit::Answer);
        }
    }
    if let (Some(factors), Destination::One(_, file)) = (&factors, &destination) {
        return run_with_factors(arguments, &problem, factors, format, (*file, &guard));
    }
    let fit = fit(&problem);
    let options = options(arguments, &problem);
    let encoding = encoding(arguments);
    let picture = |figure: Figure| {
        let picture = while_working("drawing", || draw(&problem, &fit, figure, &options));
        let picture = picture.map_err(Failure::data)?;
        picture.encoded_as(format, &encoding).map_err(Failure::data)
    };
    // Runs fit where all readings together do not: the figure is the answer.
    let is_of_runs = matches!(destination, Destination::One(Figure::Range, _));
    match destination {
        Destination::One(figure, file) => output::write(picture(figure)?, file, &guard)?,
        Destination::All(folder) => {
            let file = |figure: Figure| Ok((name(figure), picture(figure)?));
            let files = Figure::OF_FIT.into_iter().map(file).collect::<Result<Vec<_>, Failure>>()?;
            let write =
                |(name, bytes): (String, Vec<u8>)| (name, move |output: &mut Output| output.write(&bytes));
            let files: Vec<_> = files.into_iter().map(write).collect();
            output::write_all(folder, &files, &guard)?;
        }
    }
    Ok(if fit.is_empty() && !is_of_runs { Exit::Empty } else { Exit::Answer })
}

/// The axes of statuses are those of residuals and leverages, whose regions are to be seen whole.
fn refuse_ranges_of_statuses(arguments: &PlotArguments) -> Result<(), Failure> {
    let asked = [("--x-range", &arguments.look.x_range), ("--y-range", &arguments.look.y_range)];
    let asked = asked.into_iter().find(|(_, range)| range.is_some());
    match (arguments.figure, asked) {
        (Figures::One(Figure::Status), Some((option, _))) => Err(Failure::Usage(format!(
            "'{option}' is about x, y, theta1 and theta2: the axes of '--figure status' are residuals and leverages"
        ))),
        _ => Ok(()),
    }
}

/// Words and numbers around panels need some room.
fn refuse_letters_without_room(arguments: &PlotArguments) -> Result<(), Failure> {
    let look = &arguments.look;
    let options = PlotOptions { width: look.size, letters: look.font_size, ..PlotOptions::default() };
    match options.have_letters_room() {
        true => Ok(()),
        false => Err(Failure::Usage(
            "with '--font-size' a picture has to be 27 to 266 times as wide as its letters are large: change it, or '--size'"
                .to_owned(),
        )),
    }
}

/// What draws a figure of errors in x.
type DrawXErrors = fn(&XErrorProblem, &XErrorFit, &PlotOptions) -> Result<Picture, FigureError>;

/// What draws this figure with errors in x.
fn x_error_figure(figures: Figures) -> Result<DrawXErrors, Failure> {
    let name = match figures {
        Figures::One(Figure::Data) => return Ok(draw_boxes),
        Figures::One(Figure::Fps) => return Ok(draw_x_errors),
        Figures::One(other) => other.name(),
        Figures::All => "all",
    };
    Err(Failure::Usage(format!(
        "'--figure {name}' is about readings whose x is exact: with errors in x ('--x-eps') draw 'data' or 'fps'"
    )))
}

/// Reads the data with errors in x, fits and draws.
fn run_with_x_errors(
    arguments: &PlotArguments,
    draw: DrawXErrors,
    format: PictureFormat,
    file: Option<&str>,
    guard: &Guard,
) -> CommandResult {
    let problem = arguments.data.open().x_error_problem(&arguments.x_errors, true)?;
    let answer = while_working("fitting", || problem.fit());
    let options = options(arguments, problem.problem());
    let picture = while_working("drawing", || draw(&problem, &answer, &options)).map_err(Failure::data)?;
    let picture = picture.encoded_as(format, &encoding(arguments)).map_err(Failure::data)?;
    output::write(picture, file, guard)?;
    Ok(if answer.is_empty() { Exit::Empty } else { Exit::Answer })
}

/// Draws sets under growing error bounds, one in another.
fn run_with_factors(
    arguments: &PlotArguments,
    problem: &Problem,
    FactorRange { from, to }: &FactorRange,
    format: PictureFormat,
    (file, guard): (Option<&str>, &Guard),
) -> CommandResult {
    if !problem.measurements.are_open() {
        return Err(Failure::Usage(SWEEP_OF_FIXED.to_owned()));
    }
    refuse_long_sweep(arguments.data.file_name(), problem, to, &arguments.data.table.limits)?;
    let family = while_working("sweeping", || Family::new(problem, from.clone(), to.clone()));
    let options = options(arguments, problem);
    let picture =
        while_working("drawing", || draw_sweep(problem, &family, &options)).map_err(Failure::data)?;
    let nothing = || {
        let name = arguments.data.file_name();
        Failure::data(format_args!("{name}: no factor of '--sweep' leaves any parameters"))
    };
    let picture =
        picture.ok_or_else(nothing)?.encoded_as(format, &encoding(arguments)).map_err(Failure::data)?;
    output::write(picture, file, guard)?;
    Ok(Exit::Answer)
}

fn options(arguments: &PlotArguments, problem: &Problem) -> PlotOptions {
    let [x_unit, y_unit] = arguments.labels.units(&problem.measurements);
    PlotOptions {
        x_unit,
        y_unit,
        title: arguments.labels.title.clone(),
        x_label: arguments.look.x_label.clone(),
        y_label: arguments.look.y_label.clone(),
        x_range: arguments.look.x_range.clone(),
        y_range: arguments.look.y_range.clone(),
        width: arguments.look.size,
        letters: arguments.look.font_size,
        greyscale: arguments.look.greyscale,
        flip: arguments.flip,
        directions: usize::from(arguments.directions),
    }
}

fn encoding(arguments: &PlotArguments) -> Encoding {
    Encoding { real_text: arguments.look.real_text, dpi: arguments.look.dpi }
}

/// What goes where, and in which format.
fn destination(arguments: &PlotArguments) -> Result<(Destination<'_>, PictureFormat), Failure> {
    let file = arguments.output.as_deref().filter(|file| *file != "-");
    let asked = arguments.format;
    let Figures::One(figure) = arguments.figure else {
        let folder = file.ok_or_else(|| {
            Failure::Usage(
                "'--figure all' makes six files and needs '--output <DIR>', the folder for them".to_owned(),
            )
        })?;
        if told_by_name(folder).is_some() && !Path::new(folder).is_dir() {
            let problem = "'--figure all' makes six files (expected a folder for them)";
            return Err(Failure::value("--output <FILE|DIR>", folder, problem));
        }
        return Ok((Destination::All(folder), asked.unwrap_or(PictureFormat::Svg)));
    };
    let Some(file) = file else {
        let format = asked.unwrap_or(PictureFormat::Svg);
        if matches!(format, PictureFormat::Png | PictureFormat::Pdf) && io::stdout().is_terminal() {
            let kind = format.name().to_uppercase();
            let problem =
                format!("a {kind} is nothing for a terminal: name a file with '--output', or pipe it on");
            return Err(Failure::Usage(problem));
        }
        return Ok((Destination::One(figure, None), format));
    };
    let refuse = |problem: String| Err(Failure::value("--output <FILE|DIR>", file, problem));
    match (told_by_name(file), asked) {
        (_, Some(format)) | (Some(format), None) => Ok((Destination::One(figure, Some(file)), format)),
        (None, None) => refuse(format!("{EXPECTED}, or '--format')")),
    }
}
