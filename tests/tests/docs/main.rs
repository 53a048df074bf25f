//! What the documentation says is so: its examples are run, its names exist.

mod readme;
mod theory;
