//! Figures of the parameter plane: the feasible parameter set, its boxes, estimates and approximations.

mod contradiction;
mod directions;
mod empty;
mod fps;
mod layout;
mod marks;
pub(crate) mod nested;
mod outliers;
mod program;
mod region;
mod several;
mod sliver;
#[cfg(test)]
mod tests;
mod view;
mod x_errors;

pub(crate) use directions::drawing as directions;
pub(crate) use fps::drawing as fps;
pub(crate) use outliers::drawing as outliers;
pub(crate) use program::{drawing as program, region as region_of_half_planes};
pub(crate) use region::inequality;
pub(crate) use several::{panels, several};
pub(crate) use x_errors::drawing as x_errors;
