//! The second witness: the exact simplex, the solvers and the referee; and linear programs in files.

mod models;
mod referee;
mod simplex;
