//! Other programs read what boundfit writes, and answer the same questions.

mod judge;
mod latex;
mod models;
mod octave;
mod outliers;
mod polytopes;
mod predict;
mod proportion;
mod python;
mod solvers;
mod statuses;
mod tables;
mod terminal;
mod tikz;
