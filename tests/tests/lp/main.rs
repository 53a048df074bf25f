//! The second witness: the exact simplex, the solvers and the referee; and linear programs in files, with their answers.

mod answers;
mod conformance;
mod models;
mod referee;
mod simplex;
