# pyright: reportMissingImports=false
"""Fleets, reductions and fits of data frames of Dask: ``pip install '.[dask]'`` where the scheduler and the workers run.

One call is made per partition. The functions are those of :mod:`boundfit.spark`, which says what they do.
"""

from __future__ import annotations

from typing import Any

import dask.dataframe
import pandas
import pyarrow
from dask.base import compute
from dask.delayed import delayed

from . import _partitions
from ._columns import Number, text
from ._keywords import knows
from ._reduction import FAN_IN, QUESTION, Names, Part, Readings, ReducedFit, Reduction, merge_parts, readings, to_fit, to_reduce

__all__ = ["fit", "fit_groups", "reduce"]


@knows(QUESTION)
def fit_groups(
    ddf: dask.dataframe.DataFrame,
    by: Names,
    x: Names,
    y: str | None = None,
    eps: Number | None = None,
    *,
    partitions: int | None = None,
    combine: int | None = None,
    **question: Any,
) -> dask.dataframe.DataFrame:
    """Fits the rows of each key on their own: see :func:`boundfit.spark.fit_groups`."""
    own = readings(x, y, eps, by=by, **question)
    ddf = _columns(ddf, own.columns)
    key = _table(ddf._meta[list(own.by)]).schema
    answer = _frame(_partitions.schema_of_groups(list(key), own).empty_table(), ddf._meta, own)
    if combine is not None and own.decide_alone():
        moved = ddf._meta.assign(**{_partitions.REDUCTION: pandas.Series([], dtype=object)})
        ddf = ddf.map_partitions(_combined, own, combine, meta=moved)
    shuffled = ddf.shuffle(on=list(own.by), npartitions=partitions)
    return shuffled.map_partitions(_fitted, own, key, meta=answer)


@knows(QUESTION)
def reduce(
    ddf: dask.dataframe.DataFrame, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any
) -> Reduction:
    """The readings that decide, with the sums over all: see :func:`boundfit.spark.reduce`."""
    own = to_reduce(x, y, eps, fan_in, **question)
    parts = [delayed(_reduced)(number, frame, own) for number, frame in enumerate(_columns(ddf, own.columns).to_delayed())]
    while len(parts) > 1:
        parts = [delayed(merge_parts)(parts[start : start + fan_in], own) for start in range(0, len(parts), fan_in)]
    [part] = compute(*parts)
    if part.reduction is None:
        raise ValueError(part.problem)
    return Reduction(part.reduction, own)


@knows(QUESTION)
def fit(
    ddf: dask.dataframe.DataFrame, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any
) -> ReducedFit:
    """Fits all rows: see :func:`boundfit.spark.fit`."""
    to_fit(x, y, eps, fan_in, **question)
    return reduce(ddf, x, y, eps, fan_in=fan_in, **question).fit()


def _columns(ddf: dask.dataframe.DataFrame, names: list[str]) -> dask.dataframe.DataFrame:
    """The columns that are looked at."""
    if not isinstance(ddf, dask.dataframe.DataFrame):
        raise ValueError(f"ddf is of type {type(ddf).__module__}.{type(ddf).__name__}: expected a data frame of Dask")
    for name in names:
        if name not in ddf.columns:
            raise ValueError(f"the frame has no column {name!r} (it has {', '.join(map(repr, ddf.columns))})")
    return ddf[names]


def _reduced(number: int, frame: pandas.DataFrame, own: Readings) -> Part:
    return _partitions.reduce_partition(number, _table(frame).to_batches(), own)


def _combined(frame: pandas.DataFrame, own: Readings, most_rows: int) -> Any:
    batches = list(_partitions.combine_partition(_table(frame, own.by).to_batches(), own, most_rows))
    if not batches:
        return frame.assign(**{_partitions.REDUCTION: pandas.Series([], dtype=object)})
    return _frame(pyarrow.Table.from_batches(batches), frame, own)


def _fitted(frame: pandas.DataFrame, own: Readings, key: pyarrow.Schema) -> Any:
    table = _table(frame, own.by)
    # Of a column of objects the empty frame does not tell the type.
    keys = [table.schema.field(field.name) if pyarrow.types.is_null(field.type) else field for field in key]
    schema = _partitions.schema_of_groups(keys, own)
    batches = list(_partitions.fit_partition(table.to_batches(), own))
    return _frame(pyarrow.concat_tables([schema.empty_table(), *(pyarrow.table(batch).cast(schema) for batch in batches)]), frame, own)


def _frame(table: pyarrow.Table, given: pandas.DataFrame, own: Readings) -> Any:
    """A table as pandas has it. Keys have the types that they have in the frame that they come from."""
    # Beside a null pandas would make doubles of integers.
    return table.to_pandas(integer_object_nulls=True).astype({name: given.dtypes[name] for name in own.by})


def _table(frame: pandas.DataFrame, by: tuple[str, ...] = ()) -> pyarrow.Table:
    """A frame as Arrow has it; a column of objects of several kinds as their texts, which are as exact."""
    columns = {}
    for name in frame.columns:
        try:
            columns[name] = pyarrow.array(frame[name], from_pandas=True)
        except (pyarrow.ArrowInvalid, pyarrow.ArrowTypeError, pyarrow.ArrowNotImplementedError, OverflowError):
            if name in by:
                raise ValueError(f"by: the column {name!r} holds values of several types: give them one type, such as that of text") from None
            columns[name] = pyarrow.array([None if pandas.isna(value) else text(value) for value in frame[name]], pyarrow.string())
    return pyarrow.table(columns)
