//! The part of the data plane that a panel shows, and the lines on it.

use std::borrow::Cow;

use boundfit_estimation::{Bounds, Measurement};
use boundfit_exact::Rational;

use super::scene::{Reference, Scene, Shown, level};
use crate::axis::Axis;
use crate::drawing::{Anchor, Frame, Panel};
use crate::extent::Extent;
use crate::figure::Figure;
use crate::outside::Outside;
use crate::palette::{FAINT_INK, Stroke};

/// The content of a panel: values, or distances from a reference line.
pub(crate) struct View<'a> {
    pub(crate) scene: &'a Scene<'a>,
    pub(crate) reference: Option<&'a Reference>,
}

impl View<'_> {
    /// Returns the value that is subtracted from the values of a reading.
    pub(crate) fn reference_at(&self, measurement: &Measurement) -> Rational {
        self.reference.map_or_else(Rational::zero, |reference| {
            let [phi1, phi2] = &measurement.regressor;
            &reference.theta[0] * phi1 + &reference.theta[1] * phi2
        })
    }

    /// Returns the value at which the panel shows a reading.
    pub(crate) fn value<'b>(&self, shown: &'b Shown) -> &'b Rational {
        if self.reference.is_some() { &shown.distance } else { &shown.level }
    }

    /// The bounds of a reading as the panel shows them.
    pub(crate) fn ends(&self, shown: &Shown) -> [Option<Rational>; 2] {
        if let Bounds::Around { epsilon, .. } = &shown.measurement.bounds {
            // Around y, which is the level: no long fractions but the result.
            let value = self.value(shown);
            return [Some(value - epsilon), Some(value + epsilon)];
        }
        let base = &shown.level - self.value(shown);
        [shown.measurement.lower(), shown.measurement.upper()].map(|end| end.map(|end| end - &base))
    }

    /// A line of the data plane as the panel shows it.
    pub(crate) fn relative(&self, theta: &[Rational; 2]) -> [Rational; 2] {
        match self.reference {
            None => theta.clone(),
            Some(reference) => [&theta[0] - &reference.theta[0], &theta[1] - &reference.theta[1]],
        }
    }

    /// The axes of a panel: of x and of what stands above it. `bands` says how far bands reach.
    pub(crate) fn axes(&self, frame: Frame, [across, up]: [String; 2], bands: &Extent) -> [Axis; 2] {
        let flip = self.scene.options.flip;
        let most = |along_width: bool| {
            if along_width { frame.width / 62.0 } else { frame.height / 33.0 }
        };
        let asked = self.scene.options.y_range.clone().filter(|_| self.reference.is_none());
        let [lower, upper] = asked.unwrap_or_else(|| self.extent(bands).into_ends());
        let abscissas = if self.scene.is_line() { Axis::new } else { Axis::counting };
        [
            abscissas(across, &self.scene.abscissas[0], &self.scene.abscissas[1], most(!flip) as usize),
            Axis::new(up, &lower, &upper, most(flip) as usize),
        ]
    }

    /// The ends of the axis of y: the readings, and of the bands what does not dwarf these.
    fn extent(&self, bands: &Extent) -> Extent {
        let mut fitted = Extent::default();
        let mut others = Extent::default();
        for shown in &self.scene.readings {
            let middle = self.value(shown);
            if !shown.fitted {
                others.include(middle);
                continue;
            }
            let [lower, upper] = self.ends(shown);
            fitted.include(&lower.unwrap_or_else(|| middle.clone()));
            fitted.include(&upper.unwrap_or_else(|| middle.clone()));
            fitted.include(middle);
        }
        if self.reference.is_some() {
            fitted.include(&Rational::zero());
        }
        let whole = Rational::from(1000);
        let others_room = if self.reference.is_some() { Rational::ratio(1, 4) } else { whole };
        // The numbers of conflicting rows stand beside their bars.
        let margin = Rational::ratio(1, if self.scene.conflict.rows.is_empty() { 16 } else { 5 });
        let band_room = Rational::ratio(3, 2);
        fitted.grown_towards(bands, &band_room).grown_towards(&others, &others_room).padded(&margin)
    }

    /// Counts the figure's readings outside the panel. Returns `None` where a look at each of very many readings takes
    /// long and would find none.
    pub(crate) fn outside(&self, panel: &Panel) -> Option<Outside> {
        let Scene { problem, figure, options, .. } = self.scene;
        let is_asked = options.x_range.is_some() || options.y_range.is_some();
        if self.scene.is_crowded() && (self.reference.is_some() || !is_asked) {
            return None;
        }
        let others = if *figure == Figure::Corridor { &[] } else { problem.measurements.others() };
        let all = others.iter().map(Cow::Borrowed).chain(self.scene.fitted());
        let mut found = Outside::default();
        for reading in all {
            let level = level(&reading);
            let value = if self.reference.is_some() { level - self.reference_at(&reading) } else { level };
            found.include(panel, [&self.scene.abscissa(&reading), &value]);
        }
        Some(found)
    }

    /// Marks the places where the fitted rows begin and end, when other rows are shown.
    pub(crate) fn interval_of_fitted_rows(&self, panel: &mut Panel) {
        let scene = self.scene;
        if scene.readings.iter().all(|shown| shown.fitted) {
            return;
        }
        let mut extent = Extent::default();
        let fitted = || scene.readings.iter().filter(|shown| shown.fitted);
        fitted().for_each(|shown| extent.include(&shown.abscissa));
        let Some([lower, upper]) = extent.ends() else { return };
        panel.line_at_first(lower, FAINT_INK);
        panel.line_at_first(upper, FAINT_INK);
        let rows = || fitted().map(|shown| shown.measurement.row);
        if let (Some(first), Some(last), None) = (rows().min(), rows().max(), self.reference) {
            let are_consecutive = last + 1 - first == scene.problem.measurements.fitted();
            let text = match are_consecutive {
                true => format!("fitted rows {first}..{last}"),
                false => "fitted readings".to_owned(),
            };
            let at = panel.coordinates()[0].fraction(&(lower + upper).half());
            let (place, anchor) = match scene.options.flip {
                false => ([at, 1.0], Anchor { across: 0.0, up: 1.0 }),
                true => ([1.0, at], Anchor { across: -1.0, up: 0.0 }),
            };
            panel.text(place, text, anchor, FAINT_INK);
        }
    }

    /// The reference line; for two regressors a short stroke at every row.
    pub(crate) fn lines(&self, panel: &mut Panel) {
        let Some(Reference { theta, stroke, .. }) = &self.scene.reference else { return };
        if self.scene.is_line() {
            let relative = self.relative(theta);
            let ends =
                self.scene.abscissas.each_ref().map(|x| panel.place([x, &(&relative[0] * x + &relative[1])]));
            panel.line(&ends, *stroke);
        } else if self.reference.is_some() {
            let ends = self.scene.abscissas.each_ref().map(|row| panel.place([row, &Rational::zero()]));
            panel.line(&ends, *stroke);
        } else {
            self.strokes_at_rows(panel, theta, *stroke);
        }
    }

    /// Half the width of what is drawn at a row, in rows: two fifths, but never too little to be seen.
    pub(crate) fn half_row(&self, panel: &Panel) -> Rational {
        /// Pixels of the nominal size.
        const LEAST_WIDTH: f64 = 2.0;
        let length = if panel.is_flipped() { panel.frame.height } else { panel.frame.width };
        let least = Rational::ratio((LEAST_WIDTH * 50.0) as i64, (length * 100.0) as i64);
        Rational::ratio(2, 5).max(panel.coordinates()[0].width() * least)
    }

    fn strokes_at_rows(&self, panel: &mut Panel, theta: &[Rational; 2], stroke: Stroke) {
        let half = self.half_row(panel);
        for shown in self.scene.rows_with_room() {
            let [phi1, phi2] = &shown.measurement.regressor;
            let value = &theta[0] * phi1 + &theta[1] * phi2;
            let ends =
                [&shown.abscissa - &half, &shown.abscissa + &half].map(|row| panel.place([&row, &value]));
            panel.line(&ends, stroke);
        }
    }
}
