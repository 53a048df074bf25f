//! The truth of a polyhedron's statements: supports, redundancies, measures and their proofs on generated systems of
//! half-planes.

mod before_a_look;
mod large;
mod leaving_out;
mod long_sums;
mod measures;
mod membership;
mod projective;
mod proofs;
mod redundancy;
mod reordering;
mod support;
