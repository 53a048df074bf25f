//! Reports and figures: byte for byte, and no wider than a page.

mod deciding;
mod enclosure;
mod figures;
mod golden;
mod width;
