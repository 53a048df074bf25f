//! Theorems for the kernel of Coq: true ones are accepted, and what is accepted is true.

mod accepted;
mod claim;
mod coq;
mod forged;
mod forged_files;
