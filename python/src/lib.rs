//! The compiled part of the Python package `boundfit`: arrays in, exact answers out. What people call is in `boundfit/*.py`.

mod asked;
mod cells;
mod fitted;
mod fleet;
mod numbers;
mod partitions;
mod plane;
mod program;
mod proofs;

use pyo3::prelude::*;

/// Built by maturin as `boundfit._boundfit`.
#[pymodule]
mod _boundfit {
    #[pymodule_export]
    use crate::fitted::{Fitted, fit_columns, fit_file};
    #[pymodule_export]
    use crate::fleet::{fit_groups, reduce_columns, reduce_file};
    #[pymodule_export]
    use crate::partitions::{fit_reductions, merge_reductions, reduce_part};
    #[pymodule_export]
    use crate::plane::{Plane, polygon_of_file, polygon_of_text};
    #[pymodule_export]
    use crate::program::judge;
    #[pymodule_export]
    use crate::proofs::verify;
}
