# pyright: reportMissingImports=false
"""Fleets, reductions and fits of datasets of Ray: ``pip install '.[ray]'`` where the driver and the workers run.

One task is run per block. The functions are those of :mod:`boundfit.spark`, which says what they do.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

import pyarrow

from . import _partitions
from ._columns import Number
from ._keywords import knows
from ._reduction import FAN_IN, QUESTION, Names, Part, Readings, ReducedFit, Reduction, merge_parts, readings, to_fit, to_reduce

if TYPE_CHECKING:
    from ray.data import Dataset

__all__ = ["fit", "fit_groups", "reduce"]

# Where it is not installed, checkers of types would take this module for it.
ray: Any = import_module("ray")
import_module("ray.data")


@knows(QUESTION)
def fit_groups(
    dataset: Dataset,
    by: Names,
    x: Names,
    y: str | None = None,
    eps: Number | None = None,
    *,
    partitions: int | None = None,
    combine: int | None = None,
    **question: Any,
) -> Dataset:
    """Fits the rows of each key on their own: see :func:`boundfit.spark.fit_groups`. The tasks are run at once."""
    own = readings(x, y, eps, by=by, **question)
    blocks = dataset.select_columns(own.columns).to_arrow_refs()
    count = partitions or max(len(blocks), 1)
    fields: list[pyarrow.Field] = next((fields for fields in ray.get([_on(_key, block, own) for block in blocks]) if fields), [])
    schema = _partitions.schema_of_groups(fields, own)
    split = ray.remote(_split).options(num_returns=count)
    dealt = [split.remote(block, own, count, combine) for block in blocks]
    places: list[Any] = [[parts] for parts in dealt] if count == 1 else dealt
    return ray.data.from_arrow_refs([_on(_fitted, own, schema, *(parts[place] for parts in places)) for place in range(count)])


@knows(QUESTION)
def reduce(
    dataset: Dataset, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any
) -> Reduction:
    """The readings that decide, with the sums over all: see :func:`boundfit.spark.reduce`."""
    own = to_reduce(x, y, eps, fan_in, **question)
    blocks = dataset.select_columns(own.columns).to_arrow_refs()
    parts = [_on(_reduced, number, block, own) for number, block in enumerate(blocks)]
    while len(parts) > fan_in:
        parts = [_on(_merged, own, *parts[start : start + fan_in]) for start in range(0, len(parts), fan_in)]
    part = merge_parts(ray.get(parts), own)
    if part.reduction is None:
        raise ValueError(part.problem)
    return Reduction(part.reduction, own)


@knows(QUESTION)
def fit(
    dataset: Dataset, x: Names, y: str | None = None, eps: Number | None = None, *, fan_in: int = FAN_IN, **question: Any
) -> ReducedFit:
    """Fits all rows: see :func:`boundfit.spark.fit`."""
    to_fit(x, y, eps, fan_in, **question)
    return reduce(dataset, x, y, eps, fan_in=fan_in, **question).fit()


def _on(function: Any, *arguments: Any) -> Any:
    """A task."""
    return ray.remote(function).remote(*arguments)


def _reduced(number: int, block: pyarrow.Table, own: Readings) -> Part:
    return _partitions.reduce_partition(number, block.to_batches(), own)


def _merged(own: Readings, *parts: Part) -> Part:
    return merge_parts(parts, own)


def _key(block: pyarrow.Table, own: Readings) -> list[pyarrow.Field] | None:
    # A block without rows may have lost its types.
    return [block.schema.field(name) for name in own.by] if block.num_rows else None


def _split(block: pyarrow.Table, own: Readings, count: int, combine: int | None) -> Any:
    if combine is not None and block.num_rows:
        block = pyarrow.Table.from_batches(_partitions.combine_partition(block.to_batches(), own, combine))
    parts = _partitions.split(block, own, count) if block.num_rows else [block] * count
    return parts[0] if count == 1 else parts


def _fitted(own: Readings, schema: pyarrow.Schema, *blocks: pyarrow.Table) -> pyarrow.Table:
    batches = [batch for block in blocks if block.num_rows for batch in block.to_batches()]
    fits = _partitions.fit_partition(batches, own)
    return pyarrow.concat_tables([schema.empty_table(), *(pyarrow.table(batch).cast(schema) for batch in fits)])
