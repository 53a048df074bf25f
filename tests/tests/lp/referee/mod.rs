//! The referee of LP answers against a judge written from the definitions, which shares no code with it.

mod corpus;
mod judge;
mod proportion;
mod solvers_and_duals;
mod statuses;
