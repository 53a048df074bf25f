//! Readings in columns of doubles, some dozen of which are looked at together.

/// The number of rows that are tested together. Compilers turn loops over fewer numbers into single steps before they see that vector
/// registers would do.
pub(super) const LANES: usize = 32;

/// A reading lower ≤ φ·θ ≤ upper, rounded.
#[derive(Debug, Clone, Copy)]
pub struct RoundedStrip {
    /// φ, each within a relative error of 2⁻⁵⁰, and [in range](super::in_range).
    pub phi: [f64; 2],
    /// Certainly not below the lower bound; -∞ without one.
    pub lower: f64,
    /// Certainly not above the upper bound; ∞ without one.
    pub upper: f64,
}

/// Such readings in columns of equal length.
#[derive(Debug, Clone, Default)]
pub struct RoundedStrips {
    /// φ of each.
    pub phi: [Vec<f64>; 2],
    /// The lower bounds.
    pub lower: Vec<f64>,
    /// The upper bounds.
    pub upper: Vec<f64>,
}

impl RoundedStrips {
    /// Returns how many there are.
    pub fn len(&self) -> usize {
        self.lower.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.lower.is_empty()
    }

    /// The reading of a row.
    ///
    /// # Panics
    /// When there are not that many.
    #[inline]
    pub fn strip(&self, row: usize) -> RoundedStrip {
        let phi = [self.phi[0][row], self.phi[1][row]];
        RoundedStrip { phi, lower: self.lower[row], upper: self.upper[row] }
    }

    /// Some rows that follow one another, as those that bound θ2 from above and from below; `None` where there are not that many.
    #[inline]
    pub(super) fn lanes(&self, start: usize) -> Option<Lanes> {
        let of = |column: &Vec<f64>| column.get(start..)?.first_chunk::<LANES>().copied();
        let ([phi1, phi2], [lower, upper]) =
            ([of(&self.phi[0])?, of(&self.phi[1])?], [of(&self.lower)?, of(&self.upper)?]);
        let mut lanes = Lanes { slope: phi1, height: phi2, from_above: upper, from_below: lower };
        let bounds = lanes.from_above.iter_mut().zip(&mut lanes.from_below);
        for ((slope, height), (above, below)) in lanes.slope.iter_mut().zip(&mut lanes.height).zip(bounds) {
            // On bits, since signs of regressors are no pattern that a branch could follow.
            let sign = height.to_bits() & (-0.0_f64).to_bits();
            let (upper, lower) = (above.to_bits(), (-*below).to_bits());
            let swapped = (upper ^ lower) & ((sign as i64) >> 63) as u64;
            (*above, *below) = (f64::from_bits(upper ^ swapped), f64::from_bits(lower ^ swapped));
            *slope = f64::from_bits(slope.to_bits() ^ sign);
            *height = height.abs();
        }
        Some(lanes)
    }
}

/// Rows turned so that φ2 is not negative: slope·θ1 + height·θ2 ≤ `from_above` and -slope·θ1 - height·θ2 ≤ `from_below`.
pub(super) struct Lanes {
    pub(super) slope: [f64; LANES],
    pub(super) height: [f64; LANES],
    pub(super) from_above: [f64; LANES],
    pub(super) from_below: [f64; LANES],
}
