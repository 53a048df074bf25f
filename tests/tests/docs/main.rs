//! What the documentation says is so: its examples are run, its names exist.

mod book;
mod pages;
mod readme;
mod surfaces;
mod theory;
mod versions;
