//! A scan gives the rows and the errors of a naive reader, whatever the chunks, the threads and the way the bytes come.

mod agreement;
pub mod both;
mod bytes;
mod dialects;
mod handing_out;
mod numbers;
mod quotes;
mod records;
mod tables;
