//! Files in: tables, MATLAB, Parquet and Arrow, and what the fuzzer makes of them.

#[cfg(feature = "arrow")]
mod arrow;
mod fuzz_smoke;
mod mat;
mod scan;
