//! Reports and figures, byte for byte.

mod figures;
mod golden;
