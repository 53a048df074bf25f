"""From what people have to what the compiled part takes: a buffer of numbers where there is one without a loss, else a list."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from typing import Any


def cells(values: Any, name: str, reading: str = "decimal") -> Any:
    """A buffer of numbers where there is one without a loss, else a list, whose items the compiled part reads.

    :raises ValueError: where it is no column, or one of times.
    """
    if isinstance(values, list):
        return values
    if type(values).__module__ == "numpy":
        return _of_numpy(values, name, reading)
    if hasattr(values, "toarray"):
        # A sparse matrix.
        values = values.toarray()
    match type(values).__module__.partition(".")[0]:
        case "numpy":
            return _of_numpy(values, name, reading)
        case "pandas":
            return _of_pandas(values, name, reading)
        case "polars":
            return _of_polars(values, name, reading)
        case "pyarrow":
            return _of_pyarrow(values, name, reading)
        case "array":
            return values
        case "astropy" | "pint":
            _refuse_unit(values, name)
        case "xarray":
            # An array of numpy would have the numbers alone.
            _refuse_unit(getattr(values, "data", None), name)
    mask = getattr(values, "mask", None)
    if mask is not None and not callable(mask) and hasattr(values, "__array__"):
        # Masked columns of other libraries hand out a buffer in which masked cells have numbers.
        import numpy

        data = getattr(values, "unmasked", getattr(values, "data", values))
        return _of_numpy(numpy.ma.MaskedArray(numpy.asarray(data), mask=numpy.asarray(mask)), name, reading)
    if isinstance(values, (bytearray, memoryview)) or (hasattr(values, "__buffer__") and not isinstance(values, bytes)):
        if memoryview(values).format[:1] not in "<>=!":
            return values
        # The compiled part knows the order of bytes of this machine, numpy knows any.
        import numpy

        return _of_numpy(numpy.asarray(values), name, reading)
    if hasattr(values, "__array__") and not isinstance(values, Mapping):
        # Arrays of other libraries, such as xarray's and h5py's.
        import numpy

        return _of_numpy(numpy.asarray(values), name, reading)
    # Of a set nobody knows the order, and of a mapping nobody knows whether keys are meant.
    if isinstance(values, (str, bytes, Set, Mapping)) or not isinstance(values, Iterable):
        raise _no_column(values, name)
    return list(values)


def refuse_lazy(values: Any, name: str) -> None:
    """Refuses a frame of polars that is not computed yet.

    :raises ValueError: where it is one.
    """
    if type(values).__name__ == "LazyFrame":
        raise ValueError(f"{name} is of type LazyFrame: expected an array or a list of numbers, such as those of its collect()")


def _refuse_unit(values: Any, name: str) -> None:
    """Numbers of different units would be taken for those of one."""
    unit = str(next((own for own in (getattr(values, "unit", None), getattr(values, "units", None)) if own is not None), ""))
    if unit not in ("", "dimensionless"):
        raise ValueError(
            f"{name} has the unit {unit}: expected numbers without one, such as those of to_value({unit!r}) of astropy, or m_as({unit!r}) of pint"
        )


def _no_column(values: Any, name: str) -> ValueError:
    return ValueError(f"{name} is of type {type(values).__name__}: expected an array or a list of numbers")


def _times(name: str, kind: Any) -> ValueError:
    return ValueError(
        f"{name} holds times ({kind}), not numbers: expected numbers, such as those of (t - t0) / one second, from a time t0 on"
    )


def _of_numpy(values: Any, name: str, reading: str) -> Any:
    if values.ndim == 2 and 1 in values.shape:
        # A matrix of numpy stays one until it is an array.
        values = getattr(values, "A1", values).reshape(-1)
    if values.ndim != 1:
        raise ValueError(f"{name} has {values.ndim} dimensions: expected a column, which has one")
    kind = values.dtype.kind
    if kind in "mM":
        raise _times(name, values.dtype)
    if hasattr(values, "mask"):
        # What is masked is missing, whatever is stored there.
        if not values.mask.any():
            return _of_numpy(values.data, name, reading)
        return _of_numpy(values.filled(float("nan")), name, reading) if kind == "f" else values.tolist()
    if kind == "f" and values.dtype.itemsize == 2:
        return values.astype("float64") if reading == "binary64" else list(values)
    if kind in "iuf" and values.dtype.itemsize <= 8:
        # The fields of records need not be where such numbers are in memory otherwise.
        return values if values.dtype.isnative and values.flags.aligned else values.astype(values.dtype.newbyteorder("="))
    return values.tolist()


def _of_pandas(values: Any, name: str, reading: str) -> Any:
    if hasattr(values, "columns"):
        return cells(only_column(values, name).iloc[:, 0], name, reading)
    dtype: Any = getattr(values, "dtype", None)
    if not hasattr(dtype, "kind"):
        raise _no_column(values, name)
    # A series, an index or an array of categories, which become those of their numbers.
    categories = getattr(dtype, "categories", None)
    if categories is not None and categories.dtype.kind == "f":
        return cells(values.astype(categories.dtype), name, reading)
    if dtype.kind in "mM":
        raise _times(name, dtype)
    if "dictionary" in str(dtype) and hasattr(dtype, "pyarrow_dtype"):
        import pyarrow

        return cells(pyarrow.array(values.array), name, reading)
    if hasattr(dtype, "subtype") and hasattr(dtype, "fill_value"):
        # A sparse column has the type of its numbers.
        return cells(values.astype(dtype.subtype), name, reading)
    # Nullable columns, and those of Arrow, have the type of numpy that they are stored as.
    stored = getattr(dtype, "numpy_dtype", dtype if dtype.kind in "iuf" and not hasattr(dtype, "subtype") else None)
    if stored is not None and stored.kind == "f":
        return _of_numpy(values.to_numpy(dtype=stored, na_value=float("nan")), name, reading)
    if stored is not None and stored.kind in "iu" and not values.isna().any():
        return _of_numpy(values.to_numpy(dtype=stored), name, reading)
    return values.astype(object).tolist()


def _of_polars(values: Any, name: str, reading: str) -> Any:
    if hasattr(values, "get_columns"):
        return cells(only_column(values, name).to_series(), name, reading)
    refuse_lazy(values, name)
    if not hasattr(values, "to_list"):
        raise _no_column(values, name)
    if values.dtype.is_temporal():
        raise _times(name, values.dtype)
    # A short float that is null is one that is not a number: a list would hold doubles.
    if values.dtype.is_float() or (values.dtype.is_integer() and values.null_count() == 0 and "128" not in str(values.dtype)):
        return _of_numpy(values.to_numpy(), name, reading)
    return values.to_list()


def _of_pyarrow(values: Any, name: str, reading: str) -> Any:
    import pyarrow

    if hasattr(values, "column_names"):
        return cells(only_column(values, name).column(0), name, reading)
    if not hasattr(values, "null_count"):
        raise _no_column(values, name)
    types = pyarrow.types
    if types.is_run_end_encoded(values.type):
        import pyarrow.compute

        values = pyarrow.compute.call_function("run_end_decode", [values])
    if types.is_dictionary(values.type):
        values = values.cast(values.type.value_type)
    if types.is_temporal(values.type):
        raise _times(name, values.type)
    if types.is_floating(values.type) or (types.is_integer(values.type) and values.null_count == 0):
        plain = values.to_numpy(zero_copy_only=False) if isinstance(values, pyarrow.Array) else values.to_numpy()
        return _of_numpy(plain, name, reading)
    return values.to_pylist()


def only_column(frame: Any, name: str) -> Any:
    width = frame.shape[1]
    if width != 1:
        raise ValueError(f"{name} has {width} columns: expected one")
    return frame
