//! The distance of a sensor's characteristic from a straight line, in the four ways that laws and data sheets state
//! it.
//!
//! *Independent* linearity is the maximum deviation of the actual characteristic, the average of upscale and
//! downscale readings, from a straight line. The line is so positioned as to equalise and minimise the maximum
//! deviations (US 15 CFR 772.1, "Linearity"). It is Chebyshev's minimax line, which three deviations that alternate
//! in sign prove (Cheney, *Introduction to Approximation Theory*, 1966, chapter 2). *Terminal* linearity is measured
//! from the line through both ends of the range, *zero-based* linearity from the best line through a given point,
//! *least-squares* linearity from the least-squares line.

#[cfg(feature = "files")]
mod calibration;
mod characteristic;
#[cfg(feature = "files")]
mod deciding;
#[cfg(feature = "files")]
mod directions;
mod input;
mod points;

use boundfit_exact::Rational;

#[cfg(feature = "files")]
pub use calibration::{Calibration, CalibrationColumns, CalibrationError, CalibrationResponse};
pub use characteristic::{AlternatingPoint, Characteristic, LinearityLine, NoLine};
pub use input::{LinearityInput, ResponseColumns};
pub use points::{CalibrationPoint, CalibrationReading, Difference, Pass};

use points::{Passes, points_of_passes, points_of_readings};

/// The facts about all readings of a table without directions that those which decide do not tell.
#[derive(Debug, Clone)]
struct Whole {
    count: usize,
    /// The terminal and the least-squares line; `None` where all x are the same.
    terminal: Option<[Rational; 2]>,
    least_squares: Option<[Rational; 2]>,
    repeatability: Option<Difference>,
}

/// The question of linearity.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LinearityOptions {
    /// The full scale of percents; the span of the response when `None`.
    pub full_scale: Option<Rational>,
    /// The point (x, y) of zero-based linearity; the origin by default.
    pub through: [Rational; 2],
}

/// The linearity of a calibration, with its hysteresis and repeatability.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Linearity {
    /// The linearity of the actual characteristic: at each x the average of the upscale and of the downscale average,
    /// or the one that there is. If no direction is known, every reading is a point of its own, since nothing says
    /// which readings a law would average. The least error bound of a fit of the same readings is then the same.
    pub average: Characteristic,
    /// The linearity of the upscale readings alone, averaged at each x.
    pub up: Option<Characteristic>,
    /// The linearity of the downscale readings alone, averaged at each x.
    pub down: Option<Characteristic>,
    /// The largest difference of the upscale and the downscale average at one x; `None` where no x has both.
    pub hysteresis: Option<Difference>,
    /// The largest spread of readings at one x in one direction; `None` where no x was read twice in one.
    pub repeatability: Option<Difference>,
}

impl Linearity {
    /// Finds the linearity of readings, of which there is at least one; `None` without any. Exact. Cost: O(n log n).
    ///
    /// ```
    /// use boundfit_exact::Rational;
    /// use boundfit_questions::{CalibrationReading, Linearity, LinearityOptions};
    ///
    /// let readings = [(0, 0), (1, 3), (2, 4)].iter().zip(1..).map(|(&(x, y), row)| {
    ///     CalibrationReading { row, x: Rational::from(x), y: Rational::from(y), pass: None, equal: None }
    /// });
    /// let linearity = Linearity::new(&readings.collect::<Vec<_>>(), &LinearityOptions::default()).unwrap();
    /// let independent = &linearity.average.independent;
    /// assert_eq!(independent.deviation, Rational::ratio(1, 2));
    /// assert_eq!(independent.percent, Some(Rational::ratio(25, 2)));
    /// assert_eq!(independent.rows(&linearity.average), [1, 2, 3]);
    /// ```
    pub fn new(readings: &[CalibrationReading], options: &LinearityOptions) -> Option<Self> {
        Linearity::of(readings, None, options)
    }

    /// The linearity of readings, which are all or decide for all that these facts are about.
    fn of(
        readings: &[CalibrationReading],
        whole: Option<&Whole>,
        options: &LinearityOptions,
    ) -> Option<Self> {
        let mut sorted: Vec<&CalibrationReading> = readings.iter().collect();
        sorted.sort_by(|one, other| (&one.x, one.row).cmp(&(&other.x, other.row)));
        let passes = Passes::new(&sorted);
        if !passes.has_directions() {
            let average = Characteristic::new(points_of_readings(&sorted), whole, options)?;
            let repeatability = match whole {
                Some(whole) => whole.repeatability.clone(),
                None => passes.repeatability(),
            };
            return Some(Linearity { average, up: None, down: None, hysteresis: None, repeatability });
        }
        let of = |pass| Characteristic::new(passes.averages(pass), None, options);
        Some(Linearity {
            average: Characteristic::new(points_of_passes(&passes), None, options)?,
            up: of(Pass::Up),
            down: of(Pass::Down),
            hysteresis: passes.hysteresis(),
            repeatability: passes.repeatability(),
        })
    }
}
