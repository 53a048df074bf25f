//! Other programs read what boundfit writes, and answer the same questions.

mod octave;
mod polytopes;
mod python;
mod solvers;
