# pyright: reportMissingImports=false
"""Fleets, reductions and fits of data frames of Apache Spark, also through Spark Connect. The package has to be installed where
the driver and the executors run, with its extra ``spark``: docs/past-one-machine.md says how.

One call is made per partition, never per sensor or per row. What is returned does not depend on how many partitions there are,
which rows they have, and which of their tasks run twice.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import pyarrow
from pyspark import TaskContext
from pyspark.sql import functions
from pyspark.sql.pandas.types import from_arrow_schema, to_arrow_schema
from pyspark.sql.types import StructType

from . import _partitions
from ._columns import Number
from ._keywords import knows
from ._reduction import FAN_IN, QUESTION, Names, Readings, ReducedFit, Reduction, merge_parts, readings, to_fit, to_reduce

if TYPE_CHECKING:
    from pyspark.sql import Column, DataFrame

__all__ = ["fit", "fit_groups", "reduce"]

#: How many tasks put reductions together; those of empty partitions end at once.
MERGERS = 16


@knows(QUESTION)
def fit_groups(
    df: DataFrame,
    by: Names,
    x: Names,
    y: str | None = None,
    eps: Number | None = None,
    *,
    partitions: int | None = None,
    combine: int | None = None,
    **question: Any,
) -> DataFrame:
    """Fits the rows of each key on their own: a row per key, with the columns of the key as they are, then those of
    :func:`boundfit.fit_groups`, null where there is no number, and ``problem``, which says why nothing is said of a group.

    The rows are moved to ``partitions`` partitions by key, as many as Spark chooses if you do not say. Where single keys have so
    many rows that no machine should take them all, ``combine=100_000`` reduces more rows than that of a key where they are, at
    most those of one task at a time, before they are moved; the answer stays what it is. ``id`` names a column that problems
    quote; all else in ``question`` is as in :func:`boundfit.fit_groups`.

    :raises ValueError: when the question makes no sense; what is wrong with readings is said in the row of their group.
    """
    own = readings(x, y, eps, by=by, **question)
    df = _columns(df, own.columns)
    key = _arrow_fields(df, own.by)
    answer = _partitions.schema_of_groups(key, own)
    keys = [_column(name) for name in own.by]
    if combine is not None and own.decide_alone():
        moved = to_arrow_schema(df.schema).append(pyarrow.field(_partitions.REDUCTION, pyarrow.binary()))
        df = _map(df, partial(_partitions.combine_partition, own=own, most_rows=combine), moved)
    df = df.repartition(*keys) if partitions is None else df.repartition(partitions, *keys)
    return _map(df, partial(_partitions.fit_partition, own=own), answer)


@knows(QUESTION)
def reduce(df: DataFrame, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any) -> Reduction:
    """The readings of a data frame that decide, with the sums over all: each partition is reduced where it is, what is left is put
    together where there is room, ``fan_in`` partitions at a time, and the rest on the driver. No row is moved between machines.

    A line needs no ``eps`` here: its reduction serves each, which its ``fit`` is given. Two regressors need bounds.

    ``id`` names the column by which proofs call the readings, such as the key of the table; all else in ``question`` is as in
    :func:`boundfit.reduce`.

    :raises ValueError: with the partition and the reading that is wrong.
    """
    own = to_reduce(x, y, eps, fan_in, **question)
    df = _columns(df, own.columns)
    parts = _map(df, partial(_reduced, own=own), _partitions.PARTS)
    # How many partitions there are is not known before they are computed, and Connect does not tell: one level serves
    # fan_in² of them, and the driver takes what more there is.
    number = functions.floor(functions.col("number") / fan_in)
    parts = _map(parts.repartition(MERGERS, number), partial(_partitions.merge_partition, own=own, fan_in=fan_in), _partitions.PARTS)
    merged = merge_parts(_partitions.parts_of(parts.toArrow().to_batches()), own)
    if merged.reduction is None:
        raise ValueError(merged.problem)
    return Reduction(merged.reduction, own)


@knows(QUESTION)
def fit(df: DataFrame, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any) -> ReducedFit:
    """Fits all rows of a data frame: :func:`reduce`, and the fit of what is left. Everything is as in :func:`boundfit.fit`, but
    that the EUI is not known, nor ε_min under bounds that are fixed, since both need every reading.

    :raises ValueError: with the partition and the reading that is wrong, or when there are no readings.
    """
    to_fit(x, y, eps, fan_in, **question)
    return reduce(df, x, y, eps, fan_in=fan_in, **question).fit()


def _reduced(batches: Iterator[pyarrow.RecordBatch], own: Readings) -> Iterator[pyarrow.RecordBatch]:
    context = TaskContext.get()
    number = 0 if context is None else context.partitionId()
    yield _partitions.parts_as_batch([_partitions.reduce_partition(number, batches, own)])


def _map(df: DataFrame, function: Any, schema: pyarrow.Schema) -> DataFrame:
    # Spark asks functions for their signature, which must have one argument.
    def of_batches(batches: Any) -> Any:
        return function(batches)

    return df.mapInArrow(of_batches, from_arrow_schema(schema))


def _columns(df: DataFrame, names: list[str]) -> DataFrame:
    if df.isStreaming:
        raise ValueError(
            "the frame is a stream, of which Spark hands over one small batch after the other, and each would be fitted on its own: "
            "fit the table that the stream is written to, or call reduce in foreachBatch"
        )
    for name in names:
        if name not in df.columns:
            raise ValueError(f"the frame has no column {name!r} (it has {', '.join(map(repr, df.columns))})")
    return df.select([_column(name) for name in names])


def _column(name: str) -> Column:
    # Dots in names are part of them.
    return functions.col("`" + name.replace("`", "``") + "`")


def _arrow_fields(df: DataFrame, names: tuple[str, ...]) -> list[pyarrow.Field]:
    schema = StructType([field for name in names for field in df.schema if field.name == name])
    return list(to_arrow_schema(schema))
