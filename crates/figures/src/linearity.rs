//! The deviation of a characteristic from its best straight line, as a data sheet prints it.

use boundfit_exact::english::{listed, sentence};
use boundfit_exact::{Foreign, Rational, Rounding};
use boundfit_questions::{CalibrationPoint, Characteristic, Linearity, LinearityLine};

use crate::axis::Axis;
use crate::clip::Place;
use crate::draw::finished;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::error::FigureError;
use crate::extent::Extent;
use crate::figure::PlotOptions;
use crate::labels::{LONGEST_NAME, asked_for, described, number, unit, with_unit};
use crate::page::Page;
use crate::palette::{BLUE, Dash, FAINT_INK, Fill, GREEN, INK, Mark, PURPLE, SKY, Shape, Stroke, VERMILLION};
use crate::picture::Picture;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};
use crate::text::one_line;

const TOP: f64 = 24.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = LEFT_LABELS + 16.0;
const RIGHT: f64 = 22.0;

const BAND: Fill = Fill { colour: SKY, opacity: 0.18 };
const BAND_EDGE: Stroke = Stroke::new(BLUE, 1.3, Dash::Long);
const ZERO: Stroke = Stroke::new(FAINT_INK, 0.9, Dash::Solid);
const AVERAGE: Stroke = Stroke::new(INK, 1.6, Dash::Solid);
const AVERAGE_MARK: Mark = Mark::new(Shape::Disc, 3.2, INK);
const UP: Stroke = Stroke::new(VERMILLION, 1.0, Dash::Short);
const UP_MARK: Mark = Mark::new(Shape::Triangle, 4.4, VERMILLION);
const DOWN: Stroke = Stroke::new(GREEN, 1.0, Dash::Dots);
const DOWN_MARK: Mark = Mark::new(Shape::Diamond, 4.2, GREEN);
/// The mark around the points that prove the value.
const PROOF_MARK: Mark = Mark::new(Shape::Circle, 7.4, PURPLE);

/// More points than this are thinned out to the extreme ones of each pixel.
const MOST_POINTS: usize = 1_000;
/// Significant digits of percents.
const DIGITS: usize = 5;

/// Draws the deviations from the line of independent linearity over x, a column of this name. It shows the
/// characteristic, the upscale and the downscale average, and the band of the independent linearity. Deviations are in
/// percent of full scale, or in units of y where full scale is 0. Cost: linear in the points.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_linearity(
    linearity: &Linearity,
    x: &Foreign,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(Sheet { linearity, x, options }.drawing(), options)
}

struct Sheet<'a> {
    linearity: &'a Linearity,
    x: &'a Foreign,
    options: &'a PlotOptions,
}

impl Sheet<'_> {
    fn line(&self) -> &LinearityLine {
        &self.linearity.average.independent
    }

    /// Returns the size of one unit of y on the vertical axis.
    fn scale(&self) -> Rational {
        let percent = Rational::from(100).checked_div(&self.linearity.average.full_scale);
        percent.unwrap_or_else(Rational::one)
    }

    fn has_percent(&self) -> bool {
        self.line().percent.is_some()
    }

    /// The deviation of a point from the line, as it is shown.
    fn deviation(&self, point: &CalibrationPoint) -> Rational {
        self.line().deviation_at(point) * self.scale()
    }

    /// The characteristics that are shown, the average last.
    fn curves(&self) -> impl Iterator<Item = (&Characteristic, Stroke, Mark)> {
        let Linearity { average, up, down, .. } = self.linearity;
        let up = up.as_ref().map(|up| (up, UP, UP_MARK));
        let down = down.as_ref().map(|down| (down, DOWN, DOWN_MARK));
        up.into_iter().chain(down).chain([(average, AVERAGE, AVERAGE_MARK)])
    }

    fn drawing(&self) -> Drawing {
        let panel = self.panel();
        let height = panel.frame.top + panel.frame.height + BOTTOM_LABELS + 8.0;
        let title = match &self.line().percent {
            Some(percent) => format!(
                "Linearity: deviation from the best straight line, at most {} % of full scale",
                number(percent, DIGITS, Rounding::Up)
            ),
            None => "Linearity: deviation from the best straight line".to_owned(),
        };
        let notes = vec![self.other_methods()];
        let names = asked_for(&described(self.options), [self.abscissa(), self.ordinate()]);
        Drawing {
            description: format!(
                "{title}. Horizontal axis: {}. Vertical axis: {}. {}",
                names[0],
                names[1],
                notes.join(" ")
            ),
            title,
            subtitle: self.subtitle(),
            height,
            panels: vec![panel],
            legend: self.legend(),
            notes,
        }
    }

    fn panel(&self) -> Panel {
        let page = Page::of(self.options);
        let frame =
            Frame { left: LEFT, top: TOP, width: page.width - LEFT - RIGHT, height: page.height(HEIGHT) };
        let band = &self.line().deviation * self.scale();
        let (mut across, mut up) = (Extent::default(), Extent::default());
        [band.clone(), -&band].iter().for_each(|edge| up.include(edge));
        for (characteristic, ..) in self.curves() {
            for point in &characteristic.points {
                across.include(&point.x);
                up.include(&self.deviation(point));
            }
        }
        let asked =
            |range: &Option<[Rational; 2]>, own: Extent| range.clone().unwrap_or_else(|| own.into_ends());
        let [from, to] = asked(&self.options.x_range, across.padded(&Rational::ratio(1, 25)));
        let [least, most] = asked(&self.options.y_range, up.padded(&Rational::ratio(1, 9)));
        let [x, y] = asked_for(self.options, [self.abscissa(), self.ordinate()]);
        let axes = [
            Axis::new(x, &from, &to, (frame.width / 62.0) as usize),
            Axis::new(y, &least, &most, (frame.height / 33.0) as usize),
        ];
        let mut panel = Panel::new(frame, axes, false);
        let [top, bottom, zero] =
            [band.clone(), -band, Rational::zero()].map(|at| panel.place([&from, &at])[1]);
        panel.area(&[[0.0, bottom], [1.0, bottom], [1.0, top], [0.0, top]], BAND);
        panel.line(&[[0.0, zero], [1.0, zero]], ZERO);
        for edge in [top, bottom] {
            panel.line(&[[0.0, edge], [1.0, edge]], BAND_EDGE);
        }
        self.rings(&mut panel);
        for (characteristic, stroke, mark) in self.curves() {
            self.curve(&mut panel, characteristic, stroke, mark);
        }
        panel
    }

    /// Marks the points that prove the value.
    fn rings(&self, panel: &mut Panel) {
        let average = &self.linearity.average;
        for point in average.proof.iter().filter_map(|proof| average.points.get(proof.position)) {
            let at = panel.place([&point.x, &self.deviation(point)]);
            panel.mark(at, PROOF_MARK);
        }
    }

    /// The points of a characteristic, joined where there is one at each x and few enough to be told apart.
    fn curve(&self, panel: &mut Panel, characteristic: &Characteristic, stroke: Stroke, mark: Mark) {
        let points = &characteristic.points;
        let place = |point: &CalibrationPoint| panel.place([&point.x, &self.deviation(point)]);
        let mut places: Vec<Place> = points.iter().map(place).collect();
        let is_dense = places.len() > MOST_POINTS;
        let is_function = points.windows(2).all(|pair| pair[0].x != pair[1].x);
        if is_dense {
            places = extremes(&places, panel.frame.width);
        } else if is_function {
            panel.line(&places, stroke);
        }
        let mark = if is_dense { Mark { shape: Shape::Square, radius: 1.0, ..mark } } else { mark };
        places.into_iter().for_each(|at| panel.mark(at, mark));
    }

    fn abscissa(&self) -> String {
        with_unit(&one_line(self.x, LONGEST_NAME), unit(&self.options.x_unit).as_deref())
    }

    fn ordinate(&self) -> String {
        match self.has_percent() {
            true => "deviation [% of full scale]".to_owned(),
            false => with_unit("deviation", unit(&self.options.y_unit).as_deref()),
        }
    }

    /// A number with the unit of y.
    fn with_unit_of_y(&self, value: &Rational, rounding: Rounding) -> String {
        let unit = unit(&self.options.y_unit).map(|unit| format!(" {unit}")).unwrap_or_default();
        format!("{}{unit}", number(value, DIGITS, rounding))
    }

    fn subtitle(&self) -> String {
        let [slope, intercept] =
            self.line().theta.each_ref().map(|value| number(value, DIGITS, Rounding::Nearest));
        let (sign, intercept) = match intercept.strip_prefix('−') {
            Some(size) => ("−", size.to_owned()),
            None => ("+", intercept),
        };
        let x = one_line(self.x, LONGEST_NAME);
        let deviation = self.with_unit_of_y(&self.line().deviation, Rounding::Up);
        let full_scale = self.with_unit_of_y(&self.linearity.average.full_scale, Rounding::Nearest);
        format!(
            "best straight line y = {slope}·{x} {sign} {intercept},  ±{deviation},  full scale {full_scale}"
        )
    }

    /// The other ways to state it, and hysteresis and repeatability.
    fn other_methods(&self) -> String {
        let Linearity { average, hysteresis, repeatability, .. } = self.linearity;
        let shown = |value: &Rational| {
            let percent = (value * Rational::from(100)).checked_div(&average.full_scale);
            match percent {
                Some(percent) => format!("{} %", number(&percent, DIGITS, Rounding::Up)),
                None => self.with_unit_of_y(value, Rounding::Up),
            }
        };
        let of = |name: &str, value: Option<&Rational>| value.map(|value| format!("{name} {}", shown(value)));
        let parts = [
            of("independent", Some(&average.independent.deviation)),
            of("terminal", average.terminal.as_ref().ok().map(|line| &line.deviation)),
            of("zero-based", Some(&average.zero_based.deviation)),
            of("least squares", average.least_squares.as_ref().ok().map(|line| &line.deviation)),
            of("hysteresis", hysteresis.as_ref().map(|difference| &difference.value)),
            of("repeatability", repeatability.as_ref().map(|difference| &difference.value)),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        let scale = if self.has_percent() { " of full scale" } else { "" };
        format!("{}{scale}.", sentence(&listed(&parts)))
    }

    fn legend(&self) -> Vec<LegendEntry> {
        let average = &self.linearity.average;
        let is_dense = average.points.len() > MOST_POINTS;
        let dense = |mark: Mark| if is_dense { Mark { shape: Shape::Square, ..mark } } else { mark };
        let name = match self.linearity.up.is_some() || self.linearity.down.is_some() {
            true => "average of up and down",
            false => "reading",
        };
        let mut legend = vec![
            LegendEntry::new(Swatch::line_and_mark(AVERAGE, dense(AVERAGE_MARK)), name),
            LegendEntry::new(Swatch::line_and_mark(UP, dense(UP_MARK)), "upscale"),
            LegendEntry::new(Swatch::line_and_mark(DOWN, dense(DOWN_MARK)), "downscale"),
            LegendEntry::new(Swatch::area(BAND, BAND_EDGE), "± independent linearity"),
        ];
        let points = average.proof.iter().filter_map(|proof| average.points.get(proof.position));
        let mut rows: Vec<usize> =
            points.flat_map(|point| point.rows.rows()).map(|row| row as usize).collect();
        rows.sort_unstable();
        rows.dedup();
        let rows: Vec<String> = rows.iter().map(ToString::to_string).collect();
        let noun = if rows.len() == 1 { "row" } else { "rows" };
        let text = format!("proves the independent value ({noun} {})", listed(&rows));
        legend.push(LegendEntry::new(Swatch::mark(PROOF_MARK), text));
        legend
    }
}

/// The lowest and the highest place of each pixel across.
fn extremes(places: &[Place], width: f64) -> Vec<Place> {
    let mut found: Vec<Option<[Place; 2]>> = vec![None; width.max(1.0) as usize + 1];
    for &place in places {
        let column = (place[0] * width).clamp(0.0, width) as usize;
        let Some(own) = found.get_mut(column) else { continue };
        let [lowest, highest] = own.unwrap_or([place, place]);
        let lowest = if place[1] < lowest[1] { place } else { lowest };
        let highest = if place[1] > highest[1] { place } else { highest };
        *own = Some([lowest, highest]);
    }
    found.into_iter().flatten().flatten().collect()
}
