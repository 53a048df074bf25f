//! Other programs read what boundfit writes, and answer the same questions.

mod latex;
mod octave;
mod polytopes;
mod python;
mod solvers;
mod tables;
