//! Theorems for the kernel of Coq: true ones are accepted, and what is accepted is true.

mod about_parts;
mod accepted;
mod bytes;
mod claim;
mod coq;
mod forged;
mod forged_files;
mod mutants;
mod parts;
