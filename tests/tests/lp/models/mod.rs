//! Linear programs in files: read, and held against what is known about them.

mod corpus;
mod naive;
mod written;
