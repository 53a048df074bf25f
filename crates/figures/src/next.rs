//! The distance of the feasible lines over x, and where a further reading certainly makes the set smaller.

use boundfit_estimation::{Fit, Model, Problem};
use boundfit_exact::{Endpoint, Interval, Rational, Rounding};
use boundfit_questions::{FurtherError, Next};

use crate::axis::Axis;
use crate::clip::Place;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::extent::Extent;
use crate::figure::PlotOptions;
use crate::labels::{self, Conflict, LONGEST_NAME, asked_for, described, number, unit, with_unit};
use crate::page::Page;
use crate::palette::{BLUE, Dash, FAINT_INK, Fill, GREY, ORANGE, SKY, Stroke};
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};
use crate::text::one_line;

const WIDTH: Stroke = Stroke::new(BLUE, 1.8, Dash::Solid);
const TWICE: Stroke = Stroke::new(FAINT_INK, 1.2, Dash::Long);
// One is darker than the other, in greys too.
const UNSURE: Fill = Fill { colour: SKY, opacity: 0.14 };
const CERTAIN: Fill = Fill { colour: ORANGE, opacity: 0.34 };
const CERTAIN_EDGE: Stroke = Stroke::new(ORANGE, 1.2, Dash::Short);
const READINGS: Stroke = Stroke::new(GREY, 4.0, Dash::Solid);
/// Significant digits of x.
const DIGITS: usize = 5;

/// The figure. Cost: O(n log n) for n vertices of the set.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, options: &PlotOptions) -> Drawing {
    let is_line = matches!(problem.measurements.model(), Model::Line { .. });
    let epsilon = FurtherError::of(&problem.measurements).ok().and_then(|own| own.uniform().cloned());
    let next = Next::new(fit.fps.polyhedron(), epsilon.clone().unwrap_or_default()).filter(|_| is_line);
    let sheet = Sheet { problem, next, is_known: epsilon.is_some(), options };
    let (panel, has_curve) = sheet.panel();
    let names = |panel: &Panel| [0, 1].map(|axis| panel.axes[axis].name.clone());
    let [across, up] = asked_for(&described(options), names(&panel));
    let mut legend = vec![
        LegendEntry::new(Swatch::line(TWICE), "2ε: as far as a reading is known"),
        LegendEntry::new(Swatch::inside(UNSURE), "a reading may leave the set as it is"),
        LegendEntry::new(Swatch::area(CERTAIN, CERTAIN_EDGE), "a reading certainly makes the set smaller"),
        LegendEntry::new(Swatch::line(READINGS), "from the first to the last x of the readings"),
    ];
    if has_curve {
        legend.insert(
            0,
            LegendEntry::new(Swatch::line(WIDTH), "distance of the lowest and the highest feasible line"),
        );
    }
    let mut notes = Vec::new();
    if fit.is_empty() {
        notes.push(Conflict::of(problem, fit).sentence());
    }
    notes.extend(sheet.note(is_line));
    let title = match fit.is_empty() {
        true => "No next reading: the feasible parameter set is empty",
        false => "Where the next reading certainly makes the set smaller",
    };
    Drawing {
        title: title.to_owned(),
        subtitle: labels::subtitle(problem, options),
        description: format!("{title}. Horizontal axis: {across}. Vertical axis: {up}. {}", notes.join(" ")),
        height: panel.frame.top + panel.frame.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend,
        notes,
    }
}

struct Sheet<'a> {
    problem: &'a Problem,
    /// `None` where the set is empty or none of lines.
    next: Option<Next<'a>>,
    /// `true` if the error bound of a further reading is that of `next`.
    is_known: bool,
    options: &'a PlotOptions,
}

impl Sheet<'_> {
    /// The least and the largest x of the readings in memory; two regressors have no single x.
    fn readings(&self) -> Option<[&Rational; 2]> {
        if !matches!(self.problem.measurements.model(), Model::Line { .. }) {
            return None;
        }
        let x = || self.problem.measurements.kept().iter().map(|reading| &reading.regressor[0]);
        Some([x().min()?, x().max()?])
    }

    /// The ends of where a reading may leave the set as it is, as far as there are any.
    fn ends(&self) -> [Option<Rational>; 2] {
        let unsure = self.next.as_ref().filter(|_| self.is_known).and_then(Next::unsure);
        match unsure {
            Some(unsure) => [unsure.lower(), unsure.upper()].map(|end| end.value().cloned()),
            None => [None, None],
        }
    }

    fn twice(&self) -> Option<Rational> {
        let epsilon = self.next.as_ref().filter(|_| self.is_known)?.epsilon();
        Some(epsilon + epsilon)
    }

    /// The points of the curve: at the ends of a view, and where one line gives way to another.
    fn curve(&self, [from, to]: [&Rational; 2]) -> Vec<[Rational; 2]> {
        let Some(next) = &self.next else { return Vec::new() };
        let within = next.breaks().iter().filter(|x| from < *x && *x < to);
        let places = [from].into_iter().chain(within).chain([to]);
        places.filter_map(|x| Some([x.clone(), next.width(x)?])).collect()
    }

    /// The panel, and whether the curve is in it.
    fn panel(&self) -> (Panel, bool) {
        let ends = self.ends();
        let mut across = Extent::default();
        self.readings()
            .iter()
            .flatten()
            .chain(&ends.iter().flatten().collect::<Vec<_>>())
            .for_each(|x| across.include(x));
        let plain = across.padded(&Rational::ratio(1, 8)).into_ends();
        let [from, to] = self.options.x_range.clone().unwrap_or(plain);
        let curve = self.curve([&from, &to]);
        let highest = curve.iter().map(|[_, width]| width.clone()).chain(self.twice()).max();
        let highest = highest.filter(Rational::is_positive).unwrap_or_else(Rational::one);
        let plain = [Rational::zero(), highest * Rational::ratio(11, 10)];
        let [least, most] = self.options.y_range.clone().unwrap_or(plain);
        let page = Page::of(self.options);
        let width = page.width - LEFT_LABELS - 38.0;
        let frame = Frame { left: LEFT_LABELS + 16.0, top: 24.0, width, height: page.height(360.0) };
        let name = with_unit("distance of the lines", unit(&self.options.y_unit).as_deref());
        let [x, y] = asked_for(self.options, [labels::abscissa(self.problem, self.options), name]);
        let axes = [
            Axis::new(x, &from, &to, (frame.width / 62.0) as usize),
            Axis::new(y, &least, &most, (frame.height / 33.0) as usize),
        ];
        let mut panel = Panel::new(frame, axes, false);
        self.regions(&mut panel, &ends);
        // A set that goes on in a direction has a width at one x at most.
        let has_curve = curve.first().zip(curve.last()).is_some_and(|([first, _], [last, _])| first < last);
        let curve: Vec<Place> = curve.iter().map(|[x, width]| panel.place([x, width])).collect();
        if has_curve {
            panel.line(&curve, WIDTH);
        }
        if let Some([first, last]) = self.readings().filter(|[first, last]| first < last) {
            let zero = Rational::zero();
            let ends = [first, last].map(|x| panel.place([x, &zero]));
            panel.line(&ends, READINGS);
        }
        (panel, has_curve)
    }

    /// Shades where a reading certainly helps, and where it may not.
    fn regions(&self, panel: &mut Panel, ends: &[Option<Rational>; 2]) {
        let Some(next) = self.next.as_ref().filter(|_| self.is_known) else { return };
        let column = |panel: &mut Panel, [left, right]: [f64; 2], fill| {
            if left < right {
                panel.area(&[[left, 0.0], [right, 0.0], [right, 1.0], [left, 1.0]], fill);
            }
        };
        let axis = panel.coordinates()[0];
        let is_unsure = next.unsure().is_some();
        let [left, right] = match ends.each_ref().map(|end| end.as_ref().map(|end| axis.fraction(end))) {
            [left, right] if is_unsure => [left.unwrap_or(0.0), right.unwrap_or(1.0)],
            _ => [1.0, 1.0],
        };
        column(panel, [0.0, left], CERTAIN);
        column(panel, [right, 1.0], CERTAIN);
        column(panel, [left, right], UNSURE);
        for end in ends.iter().flatten() {
            let at = panel.coordinates()[0].fraction(end);
            panel.line(&[[at, 0.0], [at, 1.0]], CERTAIN_EDGE);
        }
        let twice = self.twice().unwrap_or_default();
        let level = panel.coordinates()[1].fraction(&twice);
        panel.line(&[[0.0, level], [1.0, level]], TWICE);
    }

    /// The answer in words.
    fn note(&self, is_line: bool) -> Option<String> {
        let next = match &self.next {
            None if !is_line => return Some("With two regressors there is no single x.".to_owned()),
            next => next.as_ref()?,
        };
        if !self.is_known {
            return Some(
                "Each reading has an error bound of its own, and the next one has none yet.".to_owned(),
            );
        }
        // The sentence is about the x of the data; only the axis counts from an origin.
        let origin = &self.problem.measurements.line_form().x_origin;
        let name = match self.problem.measurements.model() {
            Model::Line { x } if !origin.is_zero() => one_line(x, LONGEST_NAME),
            _ => "x".to_owned(),
        };
        let surely = "a reading certainly makes the set smaller.";
        let ends = self.ends().map(|end| end.map(|x| x + origin));
        let number = |x: &Rational, rounding| number(x, digits(&ends), rounding);
        Some(match (next.unsure().is_some(), &ends) {
            (false, _) => format!("At every x {surely}"),
            (true, [None, None]) => "At every x a reading may leave the set as it is.".to_owned(),
            (true, [Some(from), Some(to)]) if from == to => {
                format!("At every {name} but {} {surely}", number(from, Rounding::Nearest))
            }
            (true, [from, to]) => {
                let from = from.iter().map(|x| format!("below {}", number(x, Rounding::Down)));
                let to = to.iter().map(|x| format!("above {}", number(x, Rounding::Up)));
                let places: Vec<String> = from.chain(to).collect();
                format!("At {name} {} {surely}", places.join(" and "))
            }
        })
    }
}

/// Returns the digits that tell both ends apart, as in the report.
fn digits(ends: &[Option<Rational>; 2]) -> usize {
    let [lower, upper] = ends.clone().map(Endpoint::from);
    Interval::new(lower, upper).map_or(DIGITS, |unsure| unsure.resolving_digits(DIGITS))
}

#[cfg(test)]
mod tests {
    use boundfit_estimation::fit;

    use super::*;
    use crate::drawing::Item;
    use crate::samples::problem;

    #[test]
    fn places_differ_in_greys() {
        assert!(UNSURE.grey_on_paper() - CERTAIN.grey_on_paper() >= 16.0);
    }

    #[test]
    fn the_bar_from_the_first_to_the_last_x_is_that_of_a_line() {
        for (kind, rows, expected) in [
            ("line", ["0 1 0.5", "1 2 0.5", "2 4 0.5"], 1),
            ("two", ["0 1 1 0.5", "1 2 2 0.5", "2 0 4 0.5"], 0),
        ] {
            let problem = problem(kind, &rows, &[]);
            let figure = drawing(&problem, &fit(&problem), &PlotOptions::default());
            let is_bar = |item: &&Item| matches!(item, Item::Line { stroke, .. } if *stroke == READINGS);
            assert_eq!(figure.panels[0].items.iter().filter(is_bar).count(), expected, "{kind}");
        }
    }
}
