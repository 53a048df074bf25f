//! The way from readings to the points of a characteristic.

use std::borrow::Cow;

use boundfit_exact::Rational;
use boundfit_geometry::Tally;

/// States whether x was rising or falling when a reading was taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pass {
    /// Upscale: x was rising.
    Up,
    /// Downscale: x was falling.
    Down,
}

/// One reading of a calibration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CalibrationReading {
    /// Number of the data row, from 1. Readings of both directions may stand in one row.
    pub row: usize,
    /// The applied x.
    pub x: Rational,
    /// The output of the sensor.
    pub y: Rational,
    /// The direction in which the point was approached, where it is known.
    pub pass: Option<Pass>,
    /// All equal readings that are told once, of which this is the first; `None` where the reading stands for itself.
    pub equal: Option<Tally>,
}

impl CalibrationReading {
    /// Returns the number of readings that the point stands for.
    pub(crate) fn count(&self) -> u64 {
        self.equal.as_ref().map_or(1, Tally::count)
    }

    /// The rows of all that it stands for.
    fn tally(&self) -> Cow<'_, Tally> {
        self.equal.as_ref().map_or_else(|| Cow::Owned(Tally::one(self.row as u64)), Cow::Borrowed)
    }
}

/// A difference of readings at one x.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The size of the deviation.
    pub value: Rational,
    /// The points where the deviation is reached, ascending.
    pub at: Vec<CalibrationPoint>,
}

/// A point of a characteristic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CalibrationPoint {
    /// The applied x.
    pub x: Rational,
    /// The average output of the sensor.
    pub y: Rational,
    /// The data rows that it comes from, of which each is listed: very many readings may be at one x.
    pub rows: Tally,
    /// All equal readings, of which this is the first, where each reading is a point of its own and equal ones are
    /// told once.
    pub equal: Option<Tally>,
}

impl CalibrationPoint {
    /// Returns the number of points that it stands for.
    pub(super) fn count(&self) -> u64 {
        self.equal.as_ref().map_or(1, Tally::count)
    }

    /// The data rows of all that it stands for.
    pub(super) fn all_rows(&self) -> &Tally {
        self.equal.as_ref().unwrap_or(&self.rows)
    }
}

/// The readings at one x.
struct Passing<'a> {
    x: &'a Rational,
    readings: &'a [&'a CalibrationReading],
}

/// Readings by x.
pub(super) struct Passes<'a> {
    places: Vec<Passing<'a>>,
}

impl<'a> Passes<'a> {
    /// Readings that are sorted by x. Cost: linear.
    pub(super) fn new(sorted: &'a [&'a CalibrationReading]) -> Self {
        let places = sorted.chunk_by(|one, other| one.x == other.x);
        let places = places.filter_map(|readings| Some(Passing { x: &readings.first()?.x, readings }));
        Passes { places: places.collect() }
    }

    pub(super) fn has_directions(&self) -> bool {
        self.places.iter().flat_map(|place| place.readings).any(|reading| reading.pass.is_some())
    }

    /// The average of the readings of one direction at each x that has some.
    pub(super) fn averages(&self, pass: Pass) -> Vec<CalibrationPoint> {
        self.places.iter().filter_map(|place| place.average(Some(pass))).collect()
    }

    /// The largest difference of both averages at one x.
    pub(super) fn hysteresis(&self) -> Option<Difference> {
        let each = self.places.iter().filter_map(|place| {
            let [up, down] = [place.average(Some(Pass::Up))?, place.average(Some(Pass::Down))?];
            Some(((up.y - down.y).abs(), (place.x, move || place.rows(|_| true))))
        });
        largest(each).map(difference)
    }

    /// The largest spread of readings at one x in one direction.
    pub(super) fn repeatability(&self) -> Option<Difference> {
        let each = self.places.iter().flat_map(|place| {
            [None, Some(Pass::Up), Some(Pass::Down)].into_iter().filter_map(move |pass| {
                let own = || place.readings.iter().filter(move |reading| reading.pass == pass);
                let [least, most] =
                    [own().map(|reading| &reading.y).min()?, own().map(|reading| &reading.y).max()?];
                let is_spread = own().map(|reading| reading.count()).sum::<u64>() > 1;
                let rows = move || place.rows(|reading| reading.pass == pass);
                is_spread.then(|| (most - least, (place.x, rows)))
            })
        });
        largest(each).map(difference)
    }
}

impl Passing<'_> {
    /// The average of the readings of one direction.
    fn average(&self, pass: Option<Pass>) -> Option<CalibrationPoint> {
        let is_own = |reading: &CalibrationReading| reading.pass == pass;
        let own = self.readings.iter().filter(|reading| is_own(reading));
        let count: u64 = own.clone().map(|reading| reading.count()).sum();
        let sum: Rational = own.map(|reading| &reading.y * Rational::from(reading.count())).sum();
        let y = sum.checked_div(&Rational::from(count))?;
        Some(CalibrationPoint { x: self.x.clone(), y, rows: self.rows(is_own)?, equal: None })
    }

    /// The data rows of some of the readings; `None` without any.
    fn rows(&self, is_meant: impl Fn(&CalibrationReading) -> bool) -> Option<Tally> {
        let meant = self.readings.iter().filter(|reading| is_meant(reading));
        let rows: Vec<Cow<'_, Tally>> = meant.map(|reading| reading.tally()).collect();
        Tally::union(rows.iter().map(Cow::as_ref))
    }
}

/// The actual characteristic of readings with directions: at each x the mean of both averages, or the only one.
pub(super) fn points_of_passes(passes: &Passes) -> Vec<CalibrationPoint> {
    let point = |place: &Passing| {
        let averages = [None, Some(Pass::Up), Some(Pass::Down)].map(|pass| place.average(pass));
        let averages: Vec<Rational> = averages.into_iter().flatten().map(|point| point.y).collect();
        let count = averages.len();
        let y = averages.into_iter().sum::<Rational>().checked_div(&Rational::from(count))?;
        Some(CalibrationPoint { x: place.x.clone(), y, rows: place.rows(|_| true)?, equal: None })
    };
    passes.places.iter().filter_map(point).collect()
}

/// The characteristic of readings without directions: each as it is.
pub(super) fn points_of_readings(sorted: &[&CalibrationReading]) -> Vec<CalibrationPoint> {
    let point = |reading: &&CalibrationReading| {
        let CalibrationReading { row, x, y, equal, .. } = reading;
        CalibrationPoint { x: x.clone(), y: y.clone(), rows: Tally::one(*row as u64), equal: equal.clone() }
    };
    sorted.iter().map(point).collect()
}

/// The difference at some places, each with its data rows.
fn difference((value, places): (Rational, Vec<(&Rational, impl FnOnce() -> Option<Tally>)>)) -> Difference {
    let points = places.into_iter().filter_map(|(x, rows)| {
        Some(CalibrationPoint { x: x.clone(), y: value.clone(), rows: rows()?, equal: None })
    });
    Difference { at: points.collect(), value }
}

/// The largest of some differences, and each place where it is reached.
pub(super) fn largest<V: Ord, P>(differences: impl Iterator<Item = (V, P)>) -> Option<(V, Vec<P>)> {
    let mut found: Option<(V, Vec<P>)> = None;
    for (value, place) in differences {
        match &mut found {
            Some((largest, _)) if value < *largest => {}
            Some((largest, places)) if value == *largest => places.push(place),
            _ => found = Some((value, vec![place])),
        }
    }
    found
}
