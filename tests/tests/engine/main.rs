//! The exact engine: sets, estimates and proofs against oracles that share no code with it.

mod clipping_steps;
mod corridor;
mod edited;
mod estimation;
mod family;
mod fleet;
mod generators;
mod grid;
mod guarantee;
mod intervals;
mod library;
mod line_forms;
mod mending;
mod oracle;
mod paths;
mod polyhedron;
mod proof;
mod published;
mod range;
mod reducing;
mod reduction;
mod status;
mod stored;
mod streams;
mod window;
mod x_errors;
