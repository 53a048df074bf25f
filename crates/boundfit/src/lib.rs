//! Exact bounded-error (set-membership) estimation in two parameters: every parameter pair that agrees with all readings.

pub use boundfit_estimation as estimation;
pub use boundfit_exact as exact;
pub use boundfit_geometry as geometry;
