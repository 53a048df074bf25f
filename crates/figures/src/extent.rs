//! The ends of what is to be seen.

use boundfit_exact::Rational;

/// The smallest and the largest of some numbers, if there are any.
#[derive(Debug, Clone, Default)]
pub(crate) struct Extent(Option<[Rational; 2]>);

impl Extent {
    pub(crate) fn include(&mut self, value: &Rational) {
        match &mut self.0 {
            None => self.0 = Some([value.clone(), value.clone()]),
            Some([lower, upper]) => {
                if value < lower {
                    *lower = value.clone();
                }
                if value > upper {
                    *upper = value.clone();
                }
            }
        }
    }

    pub(crate) fn ends(&self) -> Option<&[Rational; 2]> {
        self.0.as_ref()
    }

    /// The ends; twice 0 when nothing was included.
    pub(crate) fn into_ends(self) -> [Rational; 2] {
        self.0.unwrap_or_default()
    }

    /// Moves both ends apart by a part of the width.
    pub(crate) fn padded(self, part: &Rational) -> Self {
        Extent(self.0.map(|[lower, upper]| {
            let margin = (&upper - &lower) * part;
            [lower - &margin, upper + margin]
        }))
    }

    /// Grows to hold another extent, but by at most `most` times the own width on each side.
    pub(crate) fn grown_towards(self, other: &Extent, most: &Rational) -> Self {
        let (Some([lower, upper]), Some([other_lower, other_upper])) = (&self.0, &other.0) else {
            return self;
        };
        let room = (upper - lower) * most;
        if room.is_zero() {
            let mut both = self.clone();
            both.include(other_lower);
            both.include(other_upper);
            return both;
        }
        let least = (lower - &room).max(other_lower.clone()).min(lower.clone());
        let greatest = (upper + &room).min(other_upper.clone()).max(upper.clone());
        Extent(Some([least, greatest]))
    }
}
