//! Files in: tables, MATLAB, Parquet and Arrow, and what the fuzzer makes of them.

mod foreign;
mod fuzz_smoke;
mod guesses;
mod mat;
mod scan;
mod workbooks;
