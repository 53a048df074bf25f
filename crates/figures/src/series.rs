//! Several fits in one picture: what each is called, and what it looks like.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Foreign, Rounding};

use crate::figure::PlotOptions;
use crate::labels;
use crate::palette::{
    BLUE, Colour, DARK_PURPLE, Dash, Fill, GREEN, Mark, ORANGE, SKY, Shape, Stroke, VERMILLION,
};
use crate::text::one_line_of_ends;

/// One of several fits.
#[derive(Debug, Clone)]
pub struct Series<'a> {
    /// The name of the fit in the legend, or in the heading of its panel.
    pub name: Foreign,
    /// The problem that was fitted.
    pub problem: &'a Problem,
    /// The answer.
    pub fit: &'a Fit,
}

/// The drawing of several fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compared {
    /// The readings with error bars, and a line for each fit.
    Readings,
    /// The feasible parameter sets.
    Sets,
}

/// More fits than this are not told apart in one panel: there are so many colours and dashes.
pub const MOST_COMPARED: usize = LOOKS.len();

/// The look of one of several fits: colour, dashes and marks all differ, and they differ in greys, too.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SeriesLook {
    pub(crate) edge: Stroke,
    pub(crate) mark: Mark,
}

const LOOKS: [SeriesLook; 6] = [
    look(BLUE, 1.7, Dash::Solid, Shape::Disc, 3.0),
    look(VERMILLION, 1.7, Dash::Long, Shape::Diamond, 3.9),
    look(GREEN, 1.7, Dash::Short, Shape::Triangle, 3.9),
    look(DARK_PURPLE, 1.7, Dash::Alternating, Shape::Square, 2.7),
    look(ORANGE, 2.3, Dash::Dots, Shape::Cross, 3.9),
    look(SKY, 3.0, Dash::Solid, Shape::Circle, 3.2),
];

const fn look(colour: Colour, width: f64, dash: Dash, shape: Shape, radius: f64) -> SeriesLook {
    SeriesLook { edge: Stroke::new(colour, width, dash), mark: Mark::new(shape, radius, colour) }
}

impl SeriesLook {
    /// The looks, in order, again from the first after the last.
    pub(crate) fn all() -> impl Iterator<Item = SeriesLook> {
        LOOKS.into_iter().cycle()
    }

    /// Light enough for others to be seen through it.
    pub(crate) fn fill(self) -> Fill {
        Fill { colour: self.edge.colour, opacity: 0.14 }
    }
}

impl Series<'_> {
    /// The name, fit for a legend.
    pub(crate) fn name(&self) -> String {
        let name = one_line_of_ends(&self.name, 60);
        let name = if name.is_empty() { "\"\"".to_owned() } else { name };
        // The number is not known where it is asked for.
        let multiple = self.problem.measurements.multiple_of_least();
        let bound = multiple.map_or_else(String::new, |multiple| {
            let (e, bound) = (self.problem.measurements.error_name(), multiple.bound());
            format!(" (|{e}| ≤ {})", labels::number(&bound, 5, Rounding::Up))
        });
        name + &bound
    }

    /// The sentence about who contradicts whom, as the end of another one.
    pub(crate) fn conflict(&self) -> String {
        labels::Conflict::of(self.problem, self.fit).claim().trim_end_matches('.').to_owned()
    }
}

/// Returns the options for drawing one of several fits: with the units of its own file, where the options have none.
pub(crate) fn own_options(problem: &Problem, options: &PlotOptions) -> PlotOptions {
    let [x, y] = problem.measurements.plane_units();
    let stated = |asked: &Option<Foreign>, stated: Option<&Foreign>| asked.clone().or(stated.cloned());
    PlotOptions { x_unit: stated(&options.x_unit, x), y_unit: stated(&options.y_unit, y), ..options.clone() }
}

/// Returns whether the numbers of all fits have the same units, so that they may be compared.
pub(crate) fn have_one_unit(series: &[Series], options: &PlotOptions) -> bool {
    let units = |own: &Series| {
        let own = own_options(own.problem, options);
        [own.x_unit, own.y_unit]
    };
    series.windows(2).all(|pair| units(&pair[0]) == units(&pair[1]))
}

/// Returns the common parts of all fits: model, bound and rows.
pub(crate) fn subtitle(series: &[Series], options: &PlotOptions) -> String {
    let parts: [&dyn Fn(&Problem) -> String; 2] = [&|problem| labels::model(problem), &|problem| {
        labels::bound(problem, &own_options(problem, options))
    }];
    let parts = parts.into_iter().filter_map(|part| {
        let mut all = series.iter().map(|own| part(own.problem));
        let first = all.next()?;
        all.all(|other| other == first).then_some(first)
    });
    parts.collect::<Vec<_>>().join(",  ")
}

/// The names of axes: the name that all fits give them, or their names one after the other.
pub(crate) fn axis_name(
    series: &[Series],
    options: &PlotOptions,
    name: impl Fn(&Problem, &PlotOptions) -> String,
) -> String {
    let mut names: Vec<String> = Vec::new();
    for own in series {
        let name = name(own.problem, &own_options(own.problem, options));
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}
