//! The second witness: the exact simplex, the solvers and the referee.

mod referee;
mod simplex;
