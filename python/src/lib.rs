//! The compiled part of the Python package `boundfit`: arrays in, exact answers out. The public functions are in
//! `boundfit/*.py`.

mod cells;
mod data;
mod fitted;
mod fleet;
mod forms;
mod numbers;
mod partitions;
mod pictures;
mod plane;
mod program;
mod proofs;
mod questions;
mod readings;
mod said;
mod waiting;
mod words;

use pyo3::prelude::*;

/// Built by maturin as `boundfit._boundfit`.
#[pymodule]
mod _boundfit {
    use pyo3::prelude::*;

    /// The version of the compiled part, which is the package's.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }

    #[pymodule_export]
    use crate::fitted::Fitted;
    #[pymodule_export]
    use crate::fleet::{codes, fit_groups, reduce};
    #[pymodule_export]
    use crate::partitions::{merge_reductions, readings_of_reductions, reduce_part};
    #[pymodule_export]
    use crate::pictures::{figure, lesson};
    #[pymodule_export]
    use crate::plane::{Plane, polygon_of_file, polygon_of_text};
    #[pymodule_export]
    use crate::program::{judge, judge_file};
    #[pymodule_export]
    use crate::proofs::verify;
    #[pymodule_export]
    use crate::questions::{ask, number, number_text};
    #[pymodule_export]
    use crate::readings::{Readings, readings_of_columns, readings_of_file};
}
