//! The libraries behind the numbers; no other file names them.

pub(super) use num_bigint::{BigInt, Sign as BigSign};
pub(super) use num_integer::Integer as DivisionAndGcd;
#[cfg(test)]
pub(super) use num_rational::BigRational;
pub(super) use num_traits::ToPrimitive;
