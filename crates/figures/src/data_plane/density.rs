//! More readings than can be told apart, as how many there are at a place.

use boundfit_estimation::Measurement;
use boundfit_exact::Rational;

use super::sample::COLUMN;
use super::scene::level;
use super::view::View;
use crate::axis::Axis;
use crate::drawing::{LegendEntry, Panel, Swatch};
use crate::palette::style;

/// The number of readings in a square from which on each grey is drawn.
const LEAST: [u32; 4] = [1, 10, 100, 1000];
/// The name in the legend.
const NAMES: [&str; 4] = ["1 to 9 readings", "10 to 99", "100 to 999", "1000 and more"];
/// A view this narrow beside its numbers needs digits that floats lack.
const NARROW: f64 = 1e-9;

/// Draws the number of fitted readings in each square of the panel, where there are too many to draw each.
pub(super) fn draw(view: &View, panel: &mut Panel) {
    if !view.scene.is_crowded() {
        return;
    }
    let length = |axis: usize| if axis == 0 { panel.frame.width } else { panel.frame.height };
    let first = usize::from(panel.is_flipped());
    let [columns, lines] = [length(first), length(1 - first)].map(|length| length / COLUMN);
    let counts = counted(view, panel, [columns, lines]);
    // Neighbours overlap a little, or the paper would shine through.
    let [beside, above] = [0.1 / columns, 0.1 / lines];
    for (column, counts) in counts.iter().enumerate() {
        let across = [column as f64 / columns - beside, (column as f64 + 1.0) / columns + beside];
        for (from, to, grey) in runs(counts) {
            let up = [from as f64 / lines - above, to as f64 / lines + above];
            let corners = [[across[0], up[0]], [across[1], up[0]], [across[1], up[1]], [across[0], up[1]]];
            panel.area(&corners.map(|corner| panel.oriented(corner)), style::COUNTS[grey]);
        }
    }
}

/// A line for each grey; those that are not drawn vanish.
pub(super) fn legend() -> impl Iterator<Item = LegendEntry> {
    let entry = |(fill, name)| LegendEntry::new(Swatch::inside(fill), name);
    style::COUNTS.into_iter().zip(NAMES).map(entry)
}

/// Counts the fitted readings in each square, column by column.
fn counted(view: &View, panel: &Panel, [columns, lines]: [f64; 2]) -> Vec<Vec<u32>> {
    let mut counts = vec![vec![0_u32; lines as usize + 1]; columns as usize + 1];
    let mut count = |[x, y]: [f64; 2]| {
        if !((0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y)) {
            return;
        }
        let count = counts.get_mut((x * columns) as usize).and_then(|c| c.get_mut((y * lines) as usize));
        if let Some(count) = count {
            *count = count.saturating_add(1);
        }
    };
    let [across, up] = panel.coordinates();
    let theta = view.reference.map(|reference| reference.theta.each_ref().map(Rational::near_f64));
    if let Some(floats) = &view.scene.floats {
        // The rest of a level after a line is subtracted has the error of the level.
        let largest = floats.iter().map(|[_, y, _]| y.abs()).fold(0.0, f64::max);
        if let Some((across, up)) = Rough::new(across, 0.0).zip(Rough::new(up, largest)) {
            for [x, y, _] in floats {
                let base = theta.map_or(0.0, |[theta1, theta2]| theta1 * x + theta2);
                count([across.fraction(*x), up.fraction(y - base)]);
            }
            return counts;
        }
    }
    let x_of = |reading: &Measurement| match view.scene.is_line() {
        true => reading.regressor[0].clone(),
        false => Rational::from(reading.row),
    };
    let largest = view.scene.fitted().map(|reading| level(&reading).near_f64().abs()).fold(0.0, f64::max);
    let rough = Rough::new(across, 0.0).zip(Rough::new(up, largest));
    for reading in view.scene.fitted() {
        count(match &rough {
            Some((across, up)) => {
                let base = theta.map_or(0.0, |[theta1, theta2]| {
                    theta1 * reading.regressor[0].near_f64() + theta2 * reading.regressor[1].near_f64()
                });
                [across.fraction(x_of(&reading).near_f64()), up.fraction(level(&reading).near_f64() - base)]
            }
            None => {
                let value = level(&reading) - view.reference_at(&reading);
                [across.fraction(&x_of(&reading)), up.fraction(&value)]
            }
        });
    }
    counts
}

/// An axis as floats.
struct Rough {
    lower: f64,
    width: f64,
}

impl Rough {
    /// `None` where floats do not tell neighbouring pixels apart, of numbers up to `largest`.
    fn new(axis: &Axis, largest: f64) -> Option<Self> {
        let [lower, width] = [axis.lower(), axis.width()].map(Rational::near_f64);
        let is_fine = width.is_normal() && lower.is_finite() && width > NARROW * lower.abs().max(largest);
        is_fine.then_some(Rough { lower, width })
    }

    fn fraction(&self, value: f64) -> f64 {
        (value - self.lower) / self.width
    }
}

/// Neighbouring squares of one grey: from, to, and which grey.
fn runs(counts: &[u32]) -> Vec<(usize, usize, usize)> {
    let grey = |count: u32| LEAST.iter().rposition(|&least| count >= least);
    let mut runs: Vec<(usize, usize, usize)> = Vec::new();
    for (index, grey) in counts.iter().map(|&count| grey(count)).enumerate() {
        let Some(grey) = grey else { continue };
        match runs.last_mut() {
            Some(last) if (last.1, last.2) == (index, grey) => last.1 += 1,
            _ => runs.push((index, index + 1, grey)),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::runs;

    #[test]
    fn neighbours_of_one_grey_are_one_area() {
        assert_eq!(runs(&[0, 1, 9, 10, 0, 99, 2000]), [(1, 3, 0), (3, 4, 1), (5, 6, 1), (6, 7, 3)]);
        assert!(runs(&[0, 0]).is_empty());
    }
}
