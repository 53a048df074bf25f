//! `boundfit plot`.

mod several;

use std::path::Path;

use boundfit_ask::{Factors, Misuse, Refusal, common_bound};
use boundfit_estimation::{Keep, Model, Problem, fit};
use boundfit_exact::Foreign;
use boundfit_figures::{
    Figure, FigureError, Picture, PictureFormat, PlotOptions, draw, draw_boxes, draw_outliers, draw_sweep,
    draw_sweep_of_corridors, draw_x_errors,
};
use boundfit_questions::{NoOutliers, OutlierLimits, Outliers, XErrorFit, XErrorProblem};
use clap::builder::{NonEmptyStringValueParser, PossibleValue};
use clap::{ArgAction, Args};

use crate::commands::pictures::told_by_name;
use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::memory;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, LabelArguments, LookArguments, Notes, ReplaceArguments,
    XErrorArguments, column_text, explained, named, whole,
};
use crate::output::{self, Guard, Output};
use crate::progress::while_working;
use crate::work::{refuse_long_outliers, refuse_long_problem, times};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The feasible parameter set of a line, as SVG and as PNG",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.svg\n\
             boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.png",
        ),
        (
            "All figures into a folder, with units on the axes",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --x-unit V --y-unit m \\\n\
             \x20 --figure all --format png -o figures",
        ),
        (
            "For a column of a paper: a PDF of its width, with letters of its size and without a title",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \\\n\
             \x20 --size 85mm --font-size 8pt --title '' -o fps.pdf",
        ),
        (
            "Two sensors in one picture, and one sensor under three error bounds",
            "boundfit plot north.csv south.csv --x t --y U --eps 0.5 -o both.svg\n\
             boundfit plot north.csv --x t --y U --eps 0.5 --eps 1 --eps 2 -o nested.svg",
        ),
        (
            "A panel for each sensor",
            "boundfit plot fleet.csv --x V --y level --eps 0.1 --by sensor --figure data -o cells.svg",
        ),
        (
            "Into a LaTeX document, in its own letters",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o fps.tikz",
        ),
        (
            "Errors in x as well: readings as boxes, with the steepest and the shallowest line",
            "boundfit plot current.csv --x U --y I --eps 2 --x-eps 0.2 --figure data -o boxes.svg",
        ),
    ],
    statuses: &[
        (0, "the figure is drawn"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty (of several, at least one); the figure shows the readings that contradict each other",
        ),
    ],
};

/// Draw the readings, the intervals and the feasible parameter set as SVG, PNG, PDF or TikZ
///
/// In the data plane, data shows the readings with error bars and the least-squares line. eui and pui show the band
/// of lines with parameters at the corners of the EUI or PUI box, and corridor the band of all feasible lines. In the
/// parameter plane, fps shows the feasible parameter set with its boxes and estimates. directions shows the set
/// beside the hull of the optimal points of linear programs and the polygon of their supporting half-planes. outliers
/// shows the sets that remain without the fewest outliers. status shows each reading against the set of the others,
/// its residual across and its leverage up. next shows the distance of the feasible lines over x, and where one more
/// reading certainly makes the set smaller. With errors in x (--x-eps) only two figures exist: data with boxes and
/// the steepest and the shallowest line, and fps with one set for each sign of the slope.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
#[command(mut_arg("eps", |eps| eps.action(ArgAction::Append)))]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Further tables, drawn in the same panel as sets (figure fps) or as readings and lines (figure data). One table
    /// with several --eps is drawn likewise; six fits at most
    #[arg(value_name = "DATA")]
    more: Vec<String>,
    /// Draw one panel per group of rows with the same text in this column, as the figure fps or data. All panels have the
    /// same axes; at most 24 groups are drawn, in order of first occurrence
    #[arg(long, value_name = "COL", value_parser = column_text, conflicts_with_all = ["sweep", "x_eps", "x_eps_column"])]
    by: Option<String>,
    #[command(flatten)]
    x_errors: XErrorArguments,
    /// The figure to draw
    #[arg(long, default_value = Figure::Fps.name(), value_parser = explained(Figures::named()))]
    figure: Figures,
    /// Draw, as the figure fps or corridor, the sets or corridors of some factors of all error bounds from FROM to TO,
    /// one inside another
    #[arg(long, value_name = "FROM..TO", conflicts_with_all = ["x_eps", "x_eps_column"])]
    sweep: Option<String>,
    #[command(flatten)]
    labels: LabelArguments,
    /// Draw the response y along the horizontal axis and x along the vertical one
    #[arg(long)]
    flip: bool,
    /// Number of directions of the figure 'directions' [default: 16]
    #[arg(long, value_name = "N", value_parser = whole::<u16>(3, 1000))]
    directions: Option<u16>,
    /// Spread the directions of the figure 'directions' evenly after scaling the box of both intervals to a square, and
    /// not in the plane of theta1 and theta2
    #[arg(long)]
    scaled: bool,
    /// SVG, PNG, PDF, tikz (source for a LaTeX document) or tex (a document of its own with that picture). Default: the
    /// ending of the output file's name, else SVG
    #[arg(long, value_parser = named(PictureFormat::ALL.map(|format| (format.name(), format))))]
    format: Option<PictureFormat>,
    #[command(flatten)]
    look: LookArguments,
    /// Write to this .svg, .png, .pdf, .tikz or .tex file, or all figures into this folder, instead of standard output;
    /// each file whole or not at all
    #[arg(short, long, value_name = "FILE|DIR", value_parser = NonEmptyStringValueParser::new())]
    output: Option<String>,
    #[command(flatten)]
    replace: ReplaceArguments,
}

impl PlotArguments {
    /// All tables.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        [self.data.path()].into_iter().chain(self.more.iter().map(String::as_str))
    }

    /// The factors of `--sweep`, if they are asked for.
    pub(crate) fn factors(&self) -> Result<Option<Factors>, Failure> {
        let limits = self.data.table.limits.number();
        let factors = self.sweep.as_deref().map(|text| Factors::parse(text, &limits));
        factors.transpose().map_err(Failure::misused)
    }
}

/// The value of `--figure` that asks for each figure of a fit.
const ALL: &str = "all";

/// The figures that are drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Figures {
    One(Figure),
    All,
}

impl Figures {
    fn named() -> impl Iterator<Item = (PossibleValue, Figures)> {
        let one =
            |figure: Figure| (PossibleValue::new(figure.name()).help(figure.title()), Figures::One(figure));
        let all = (
            PossibleValue::new(ALL)
                .help("Each of the figures of a fit, without status, outliers, range and next"),
            Figures::All,
        );
        Figure::ALL.into_iter().map(one).chain([all])
    }
}

/// The refusal of the figure 'next' where no error bound is that of the next reading.
const NEXT_OF_ONE_BOUND: &str = "'--figure next' needs one error bound on both sides of all readings, which the next one has too; \
                                 'boundfit next ... --new-eps NUM' takes another";

/// The destination of pictures.
enum Destination<'a> {
    /// One picture to a file, or to standard output.
    One(Figure, Option<&'a str>),
    /// The pictures of every fit into a folder.
    All(&'a str),
}

/// Reads the data, fits, draws every picture that is asked for, and then writes them.
pub(super) fn run(arguments: &PlotArguments) -> CommandResult {
    let draw_x_errors = match arguments.x_errors.are_asked() {
        true => Some(x_error_figure(arguments.figure)?),
        false => None,
    };
    let factors = arguments.factors()?;
    if factors.is_some() && !matches!(arguments.figure, Figures::One(Figure::Fps | Figure::Corridor)) {
        return Err(Failure::Usage(
            "'--sweep' draws sets of parameters, or the corridors of their lines: with '--figure fps' or '--figure corridor'"
                .to_owned(),
        ));
    }
    let several = several::asked(arguments)?;
    refuse_ranges_of_statuses(arguments)?;
    refuse_of_other_figures(arguments)?;
    arguments.look.check("--output", true)?;
    let (destination, format) = destination(arguments)?;
    arguments.look.check_format(format)?;
    let name = |figure: Figure| format!("{}.{}", figure.name(), format.name());
    let guard = arguments.replace.guard(arguments.files());
    let (figure, file) = match destination {
        Destination::One(figure, file) => {
            guard.check(file)?;
            (figure, file)
        }
        Destination::All(folder) => {
            guard.check_all(folder, Figure::OF_FIT.map(name))?;
            return run_with_folder(arguments, format, folder, &guard);
        }
    };
    let job = Job { arguments, figure, format, file, guard: &guard };
    match (several, draw_x_errors, factors) {
        (Some(what), ..) => several::run(&job, what),
        (None, Some(draw), _) => job.run_with_x_errors(draw),
        (None, None, Some(factors)) => job.run_with_factors(&factors),
        (None, None, None) if figure == Figure::Outliers => job.run_with_outliers(),
        (None, None, None) => job.run(),
    }
}

/// One picture.
struct Job<'a> {
    arguments: &'a PlotArguments,
    figure: Figure,
    format: PictureFormat,
    file: Option<&'a str>,
    guard: &'a Guard,
}

impl Job<'_> {
    /// Encodes a picture and writes it.
    fn write(&self, picture: Result<Picture, FigureError>) -> Result<(), Failure> {
        let encoded = |picture: Picture| picture.encoded_as(self.format, &self.arguments.look.encoding());
        output::write(picture.and_then(encoded).map_err(Failure::data)?, self.file, self.guard)
    }

    /// Any figure of a fit.
    fn run(&self) -> CommandResult {
        // These show counts of very many readings, for which floats are enough, and the bounds that fix the set.
        let most_plain = match self.figure {
            Figure::Data | Figure::Pui | Figure::Corridor => Keep::MOST_ROWS,
            _ => usize::MAX,
        };
        let problem = problem(self.arguments, 1, most_plain)?;
        if problem.measurements.is_of_reductions() && matches!(self.figure, Figure::Status | Figure::Range) {
            let refusal = Refusal::Reduction { ask: self.figure.name() };
            return Err(Failure::of(&refusal, self.arguments.data.file_name()));
        }
        if self.figure == Figure::Next {
            let refuse = |refusal| Failure::of(&refusal, self.arguments.data.file_name());
            if matches!(problem.measurements.model(), Model::TwoRegressors { .. }) {
                return Err(refuse(Refusal::Misuse(Misuse::NextOfTwoRegressors)));
            }
            if common_bound(&problem).is_err() {
                return Err(Failure::Usage(NEXT_OF_ONE_BOUND.to_owned()));
            }
        }
        self.draw(&problem)
    }

    fn draw(&self, problem: &Problem) -> CommandResult {
        let fit = while_working("fitting", || fit(problem));
        let options = options(self.arguments, problem);
        self.write(while_working("drawing", || draw(problem, &fit, self.figure, &options)))?;
        // Runs fit where all readings together do not: the figure is the answer.
        let is_empty = fit.is_empty() && self.figure != Figure::Range;
        Ok(if is_empty { Exit::Empty } else { Exit::Answer })
    }

    /// Draws the set that remains without outliers.
    fn run_with_outliers(&self) -> CommandResult {
        let problem = problem(self.arguments, 1, usize::MAX)?;
        let (file, table) = (self.arguments.data.file_name(), &self.arguments.data.table);
        refuse_long_outliers(file, &problem, &table.limits)?;
        let limits = OutlierLimits::default();
        match while_working("looking for outliers", || Outliers::new(&problem, &limits)) {
            // The figure shows the contradiction then.
            Err(NoOutliers::Conditions(_)) => self.draw(&problem),
            Err(why) => Err(Failure::of(&Refusal::Outliers { why, steps: None }, file)),
            Ok(outliers) => {
                self.write(draw_outliers(&problem, &outliers, &options(self.arguments, &problem)))?;
                Ok(Exit::Answer)
            }
        }
    }

    /// Reads the data with errors in x, fits and draws.
    fn run_with_x_errors(&self, draw: DrawXErrors) -> CommandResult {
        let problem = self.arguments.data.words_with(&self.arguments.x_errors).open()?.x_error_problem()?;
        let read = &problem.problem().measurements;
        input::say_table(self.arguments.data.file_name(), read.table(), read.rows_missing());
        let answer = while_working("fitting", || problem.fit());
        let options = options(self.arguments, problem.problem());
        self.write(while_working("drawing", || draw(&problem, &answer, &options)))?;
        Ok(if answer.is_empty() { Exit::Empty } else { Exit::Answer })
    }

    /// Draws sets, or their corridors, under growing error bounds, one in another.
    fn run_with_factors(&self, factors: &Factors) -> CommandResult {
        let data = &self.arguments.data;
        let problem = problem(self.arguments, 1, usize::MAX)?;
        let checked = factors.check(&problem, data.table.limits.sizes().work);
        checked.map_err(|refusal| Failure::of(&refusal, data.file_name()))?;
        let most = data.table.limits.sizes().memory.limit();
        let family = while_working("sweeping", || factors.family(&problem, data.file_name().raw(), most));
        let family = family.map_err(|refusal| Failure::of(&refusal, data.file_name()))?;
        let options = options(self.arguments, &problem);
        let draw = || match self.figure {
            Figure::Corridor => draw_sweep_of_corridors(&problem, &fit(&problem), &family, &options),
            _ => draw_sweep(&problem, &family, &options),
        };
        let picture = while_working("drawing", draw);
        let nothing = || {
            let name = data.file_name();
            Failure::data(format_args!("{name}: no factor of '--sweep' leaves any parameters"))
        };
        self.write(Ok(picture.map_err(Failure::data)?.ok_or_else(nothing)?))?;
        Ok(Exit::Answer)
    }
}

/// Reads the readings for this number of figures, with those that are not fitted. If there are more than `most_plain` of a line,
/// they stay in their columns.
fn problem(arguments: &PlotArguments, figures: u64, most_plain: usize) -> Result<Problem, Failure> {
    let problem = arguments
        .data
        .words_with(&arguments.x_errors)
        .open()?
        .holding(memory::OF_A_FIGURE)
        .shown_problem(most_plain)?;
    let limits = &arguments.data.table.limits;
    let read = &problem.measurements;
    input::say_table(arguments.data.file_name(), read.table(), read.rows_missing());
    refuse_long_problem(arguments.data.file_name(), &problem, figures * times::PLOT, limits)?;
    Ok(problem)
}

/// The figures of a fit, each a file.
fn run_with_folder(
    arguments: &PlotArguments,
    format: PictureFormat,
    folder: &str,
    guard: &Guard,
) -> CommandResult {
    let problem = problem(arguments, Figure::OF_FIT.len() as u64, usize::MAX)?;
    let fit = while_working("fitting", || fit(&problem));
    let options = options(arguments, &problem);
    let file = |figure: Figure| {
        let picture = while_working("drawing", || draw(&problem, &fit, figure, &options));
        let encoded = |picture: Picture| picture.encoded_as(format, &arguments.look.encoding());
        let bytes = picture.and_then(encoded).map_err(Failure::data)?;
        Ok((format!("{}.{}", figure.name(), format.name()), bytes))
    };
    let files = Figure::OF_FIT.into_iter().map(file).collect::<Result<Vec<_>, Failure>>()?;
    let write = |(name, bytes): (String, Vec<u8>)| (name, move |output: &mut Output| output.write(&bytes));
    let files: Vec<_> = files.into_iter().map(write).collect();
    output::write_all(folder, &files, guard)?;
    Ok(if fit.is_empty() { Exit::Empty } else { Exit::Answer })
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

/// Refuses options about other figures than the one that is drawn.
fn refuse_of_other_figures(arguments: &PlotArguments) -> Result<(), Failure> {
    let Figures::One(figure) = arguments.figure else { return Ok(()) };
    let name = figure.name();
    let is_turned = matches!(figure, Figure::Data | Figure::Eui | Figure::Pui | Figure::Corridor);
    if arguments.flip && !is_turned {
        return Err(Failure::Usage(format!(
            "'--flip' turns the figures 'data', 'eui', 'pui' and 'corridor', and this is '--figure {name}'"
        )));
    }
    let asked = [("directions", arguments.directions.is_some()), ("scaled", arguments.scaled)];
    if let Some((option, _)) =
        asked.into_iter().find(|(_, is_asked)| *is_asked && figure != Figure::Directions)
    {
        return Err(Failure::Usage(format!(
            "'--{option}' needs '--figure directions', and this is '--figure {name}'"
        )));
    }
    Ok(())
}

/// The function that draws a figure of errors in x.
type DrawXErrors = fn(&XErrorProblem, &XErrorFit, &PlotOptions) -> Result<Picture, FigureError>;

/// Returns the function that draws this figure with errors in x.
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

fn options(arguments: &PlotArguments, problem: &Problem) -> PlotOptions {
    let [x_unit, y_unit] = arguments.labels.units(&problem.measurements);
    plain_options(arguments, [x_unit, y_unit])
}

/// Returns the options for drawing with these units of x and y.
fn plain_options(arguments: &PlotArguments, [x_unit, y_unit]: [Option<Foreign>; 2]) -> PlotOptions {
    PlotOptions {
        x_unit,
        y_unit,
        flip: arguments.flip,
        directions: arguments.directions.map_or(PlotOptions::default().directions, usize::from),
        are_directions_scaled: arguments.scaled,
        ..arguments.look.options(arguments.labels.title.clone())
    }
}

/// Returns the destination of each picture, and its format.
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
        if matches!(format, PictureFormat::Png | PictureFormat::Pdf) {
            output::refuse_terminal(&format.name().to_uppercase(), None)?;
        }
        return Ok((Destination::One(figure, None), format));
    };
    match asked.or_else(|| told_by_name(file)) {
        Some(format) => Ok((Destination::One(figure, Some(file)), format)),
        None => {
            let problem = format!("{}, or '--format')", PictureFormat::EXPECTED);
            Err(Failure::value("--output <FILE|DIR>", file, problem))
        }
    }
}
