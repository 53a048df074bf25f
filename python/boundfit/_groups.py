"""Fleets: the readings of many sensors in one frame, each sensor fitted on its own."""

from __future__ import annotations

import array
from collections.abc import Sequence
from typing import Any, TypeVar

from . import _boundfit
from ._columns import Missing, Number, Reading, in_memory

Frame = TypeVar("Frame")


def fit_groups(
    frame: Frame,
    by: str,
    x: str | Sequence[str],
    y: str | None = None,
    eps: Number | None = None,
    *,
    eps_column: str | None = None,
    lower: str | None = None,
    upper: str | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
) -> Frame:
    """Fits the rows of each group on their own, in one call. Columns are named as those of the frame, and the answer is a frame of
    the library that it came from: pandas, polars or pyarrow; of a dictionary of columns it is one.

    There is a row per group, in the order in which the groups first occur: its key in ``group``, how many ``rows`` it has, which
    ``kind`` of set there is; ends, central and least-squares estimates as doubles, ends and errors rounded outward; and behind
    each its exact text in the column ``…_exact``. What there is not is NaN and null.

    >>> table = {"cell": ["a", "b", "a", "b"], "x": [0, 0, 1, 1], "y": [0.0, 0.5, 1.0, 2.5]}
    >>> groups = fit_groups(table, by="cell", x="x", y="y", eps="0.1")
    >>> groups["group"], groups["theta1_lower_exact"]
    (['a', 'b'], ['4/5', '9/5'])
    """

    def column(name: str) -> Any:
        try:
            return frame[name]  # type: ignore[index]
        except KeyError:
            raise ValueError(f"the frame has no column {name!r}") from None

    def optional(name: str | None) -> Any:
        return None if name is None else column(name)

    if eps is not None and eps_column is not None:
        raise ValueError("eps and eps_column both bound the errors: expected one of them")
    regressors = [x] if isinstance(x, str) else list(x)
    phi = [column(name) for name in regressors]
    columns, question = in_memory(
        phi[0] if len(phi) == 1 else tuple(phi),
        optional(y),
        eps if eps_column is None else column(eps_column),
        lower=optional(lower),
        upper=optional(upper),
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
    )
    taken = {name for name, _ in columns}
    key = "group"
    while key in taken:
        key += "'"
    answer = _boundfit.fit_groups(columns, (key, _keys(column(by))), question)
    framed: Frame = _framed(frame, answer)
    return framed


def _keys(values: Any) -> list[str]:
    values = values.to_pylist() if hasattr(values, "to_pylist") else values
    values = values.tolist() if hasattr(values, "tolist") else list(values)
    # What is missing is a key too: an empty one, as in a CSV of the frame.
    return [value if isinstance(value, str) else "" if _is_missing(value) else str(value) for value in values]


def _is_missing(value: Any) -> bool:
    # The missing value of pandas refuses to be compared.
    return value is None or type(value).__name__ == "NAType" or value != value


def _framed(frame: Any, answer: dict[str, Any]) -> Any:
    module = type(frame).__module__.partition(".")[0]
    columns = {name: _doubles(value) if isinstance(value, bytes) else value for name, value in answer.items()}
    if module == "pandas":
        import pandas

        return pandas.DataFrame(columns)
    if module == "polars":
        import polars

        schema = {name: polars.String for name in columns if name.endswith("_exact")}
        return polars.DataFrame(columns, schema_overrides=schema)
    if module == "pyarrow":
        import pyarrow

        texts = [name for name in columns if name.endswith("_exact")]
        return pyarrow.table(
            {name: pyarrow.array(own, pyarrow.string()) if name in texts else pyarrow.array(own) for name, own in columns.items()}
        )
    return {name: value if isinstance(value, list) else value.tolist() for name, value in columns.items()}


def _doubles(value: bytes) -> Any:
    try:
        import numpy
    except ImportError:
        doubles = array.array("d")
        doubles.frombytes(value)
        return doubles
    return numpy.frombuffer(value, dtype=float).copy()
