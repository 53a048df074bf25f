//! The documentation is true: its examples are run, its names exist.

mod architecture;
mod book;
mod circles;
mod generated;
mod pages;
mod readme;
mod sources;
mod surfaces;
mod theory;
mod versions;
