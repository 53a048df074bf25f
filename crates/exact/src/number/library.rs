//! The libraries behind the numbers; no other file names them, but for the examples of `interop.rs`.

pub(super) use num_bigint::{BigInt, BigUint, Sign as BigSign};
pub(super) use num_integer::Integer as DivisionAndGcd;
pub(super) use num_rational::{BigRational, Ratio};
pub(super) use num_traits::ToPrimitive;
