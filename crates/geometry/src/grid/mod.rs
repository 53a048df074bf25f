//! Readings of a line as points with integer coordinates, and the few of them that count.
//!
//! Decimal columns are integers on a common power of ten. Only such points on the lower or the upper hull bound the
//! parameters of a line under a uniform error bound. [`touching`] finds them by exact integer arithmetic, each place
//! once. [`touching_of_columns`] and [`touching_doubles`] first use a float filter that discards only points
//! certainly strictly between the hulls.
//!
//! ```
//! use boundfit_geometry::grid::touching_of_columns;
//!
//! // The second reading is on the line from the first to the fourth; the third is strictly between the hulls.
//! let touching = touching_of_columns(&[10, 20, 30, 40, 30], &[50, 60, 75, 80, 90], &|row| row as u64, 9);
//! assert_eq!(touching.iter().map(|point| point.rows.first()).collect::<Vec<_>>(), [0, 1, 4, 3]);
//! ```

mod cells;
mod columns;
mod coordinate;
mod corners;
mod doubles;
mod envelope_sieve;
mod filter;
mod known_hulls;
mod point;
mod rounded_sieve;
mod rounded_strips;
mod sample;
mod sieve;
mod slopes;
mod strip;

pub use columns::{candidates_of_columns, touching_of_columns, touching_places_of_columns};
pub use corners::in_range;
pub use doubles::touching_doubles;
pub use envelope_sieve::EnvelopeSieve;
pub use filter::Place;
pub use point::{GridPoint, doubled_area};
pub use rounded_sieve::{RoundedSieve, candidates_of_rounded};
pub use rounded_strips::{RoundedStrip, RoundedStrips};
pub use sieve::Sieve;

/// Returns the points on the lower or the upper hull. These are corners, and points on the hull's vertical ends that
/// are lowest or highest at their x, each once for all readings there. The point with the least number represents the
/// points strictly within a hull edge. Sorted by x, then y. The others are strictly between the two hulls. At most
/// `most` numbers of each are listed.
///
/// Exact for all coordinates. It depends on the set of points alone, so that parts can be reduced first:
/// `touching(touching(A) ∪ touching(B)) == touching(A ∪ B)`. Cost: O(n log n); linear for sorted points.
pub fn touching(mut points: Vec<GridPoint>, most: usize) -> Vec<GridPoint> {
    points.sort_unstable();
    point::touching_of_sorted(points, most, true)
}
