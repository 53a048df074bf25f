//! Tasks that tests share with `cargo xtask`.

#[cfg(feature = "generate")]
pub mod generate;
