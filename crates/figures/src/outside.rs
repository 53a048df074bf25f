//! The words about what a view does not show, and where it is.

use boundfit_exact::english::counted;
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Inequality, Polyhedron, Region};

use crate::drawing::Panel;
use crate::extent::Extent;
use crate::figure::PlotOptions;
use crate::labels::number;
use crate::parameter_plane::inequality;

/// Significant digits of places.
const DIGITS: usize = 5;

/// The readings of a view: how many there are, how many of them are outside, and the ends of all.
#[derive(Debug, Default)]
pub(crate) struct Outside {
    pub(crate) count: usize,
    pub(crate) outside: usize,
    ends: [Extent; 2],
}

impl Outside {
    /// Counts points, given by the first and the second coordinate of a panel.
    pub(crate) fn include(&mut self, panel: &Panel, point: [&Rational; 2]) {
        self.count += 1;
        self.outside += usize::from(!panel.shows(panel.place(point)));
        for (extent, value) in self.ends.iter_mut().zip(point) {
            extent.include(value);
        }
    }

    /// Returns the note about readings outside a view of this name.
    pub(crate) fn note(&self, panel: &Panel, view: &str) -> Option<String> {
        match self.outside {
            0 => None,
            outside if outside == self.count => {
                let places = places(panel, &self.ends)?;
                Some(format!("No reading is in {view}: they lie {places}."))
            }
            outside => {
                let readings = counted(self.count, "reading", "readings");
                Some(format!("Outside {view}: {outside} of {readings}."))
            }
        }
    }
}

/// Returns the note about the arrows of sets without an end.
pub(crate) fn without_end<'a>(mut regions: impl Iterator<Item = &'a Region>) -> Option<String> {
    let goes_on = |region: &Region| !region.is_empty() && !region.is_bounded();
    regions.any(goes_on).then(|| "Arrows: the set goes on without end.".to_owned())
}

/// Returns the note about sets of which a panel with ends that were asked for shows nothing. Exact.
pub(crate) fn unseen_sets<'a>(
    panel: &Panel,
    sets: impl Iterator<Item = &'a Polyhedron>,
    options: &PlotOptions,
) -> Option<String> {
    if options.x_range.is_none() && options.y_range.is_none() {
        return None;
    }
    let sets: Vec<&Polyhedron> = sets.filter(|set| !set.region().is_empty()).collect();
    if sets.is_empty() || sets.iter().any(|set| is_seen(panel, set)) {
        return None;
    }
    let mut ends = [Extent::default(), Extent::default()];
    for vertex in sets.iter().flat_map(|set| set.region().vertices()) {
        for (extent, value) in ends.iter_mut().zip(vertex.point().coordinates()) {
            extent.include(&value);
        }
    }
    let (none, has) = match sets.as_slice() {
        [_] => ("The set is not in this view", "it has"),
        _ => ("No set is in this view", "they have"),
    };
    Some(match places(panel, &ends) {
        Some(places) => format!("{none}: {has} vertices {places}."),
        None => format!("{none}."),
    })
}

/// Returns whether a set has a point in the view of a panel.
fn is_seen(panel: &Panel, set: &Polyhedron) -> bool {
    let system = set.system();
    let own = set.irredundant().into_iter().filter_map(|index| system.half_plane(index)).map(inequality);
    let [first, second] = panel.coordinates();
    let (one, zero) = (Rational::one, Rational::zero);
    let view = [
        Inequality::new(one(), zero(), first.lower() + first.width()),
        Inequality::new(-one(), zero(), -first.lower()),
        Inequality::new(zero(), one(), second.lower() + second.width()),
        Inequality::new(zero(), -one(), -second.lower()),
    ];
    !Polyhedron::intersect(own.chain(view).collect()).region().is_empty()
}

/// The ends of points along the axes of a panel, in words; `None` without a point.
fn places(panel: &Panel, [first, second]: &[Extent; 2]) -> Option<String> {
    let along = |[lower, upper]: &[Rational; 2]| {
        let [from, to] = [(lower, Rounding::Down), (upper, Rounding::Up)]
            .map(|(end, rounding)| number(end, DIGITS, rounding));
        if lower == upper {
            format!("at {}", number(lower, DIGITS, Rounding::Nearest))
        } else {
            format!("from {from} to {to}")
        }
    };
    let (first, second) = (along(first.ends()?), along(second.ends()?));
    let (across, up) = if panel.is_flipped() { (second, first) } else { (first, second) };
    Some(format!("{across} across and {up} up"))
}
