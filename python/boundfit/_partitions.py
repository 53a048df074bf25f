"""What is done with the parts of a table on many machines, in plain Python on Arrow record batches: :mod:`boundfit.spark`,
:mod:`boundfit.dask` and :mod:`boundfit.ray` say where it is done.

No answer depends on how the rows are dealt out: to which parts, in which batches, in which order.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any
from zlib import crc32

import numpy
import pyarrow
import pyarrow.compute

from ._bounds import UpperBound, nearest, upper_bound
from ._cells import cells
from ._fit import Fit
from ._reduction import (
    NO_NUMBERS,
    Part,
    Readings,
    Reduction,
    columns_of_groups,
    fitted_groups,
    in_halves,
    in_words,
    lacks_all,
    merge_parts,
    merged,
    of_part,
    reduce_columns,
    unique,
)

#: How many rows are reduced at a time, and how many of groups are held before the largest groups are reduced.
ROWS_AT_A_TIME = 1 << 20
MOST_ROWS_HELD = 1 << 22
#: A group of fewer rows is not worth a reduction of its own.
FEWEST_ROWS_REDUCED = 1 << 12

#: The column of what rows of one group were reduced to before they were moved, in the place of these rows.
REDUCTION = "boundfit reduction"

#: What there is of a part of a table, where it must be sent on.
PARTS = pyarrow.schema([("number", pyarrow.int64()), ("reduction", pyarrow.binary()), ("problem", pyarrow.string())])

Batches = Iterable[pyarrow.RecordBatch]


def reduce_partition(number: int, batches: Batches, own: Readings) -> Part:
    """What one part of a table comes to; a part may have no rows, and no batches."""

    def reduction() -> bytes:
        tables = _gathered(batches, own.columns, ROWS_AT_A_TIME)
        return merged((reduce_columns(_columns(table, own.reduced_columns, own), own) for table in tables), own)

    return of_part(number, reduction)


def parts_as_batch(parts: Iterable[Part]) -> pyarrow.RecordBatch:
    """Parts as rows."""
    rows = [(part.number, part.reduction, part.problem) for part in parts]
    return pyarrow.RecordBatch.from_pylist([dict(zip(PARTS.names, row, strict=True)) for row in rows], schema=PARTS)


def parts_of(batches: Batches) -> list[Part]:
    """Rows as parts."""
    return [Part(**row) for batch in batches for row in batch.select(PARTS.names).to_pylist()]


def merge_partition(batches: Batches, own: Readings, fan_in: int) -> Iterator[pyarrow.RecordBatch]:
    """Parts whose numbers lie in the same ``fan_in`` numbers, put together. The new part has the number of these, so that a
    level of the tree needs the parts before it alone."""
    groups: dict[int, list[Part]] = {}
    for part in parts_of(batches):
        groups.setdefault(part.number // fan_in, []).append(part)
    for number, parts in sorted(groups.items()):
        part = merge_parts(parts, own)
        yield parts_as_batch([Part(number, part.reduction, part.problem)])


def schema_of_groups(by: list[pyarrow.Field], own: Readings) -> pyarrow.Schema:
    """The columns of the answer: those of the key as they are, what is said of the group, and why nothing is."""
    said = {name: pyarrow.string() if name.endswith("_exact") else pyarrow.float64() for name in columns_of_groups(own)}
    said |= {"rows": pyarrow.int64(), "kind": pyarrow.string(), "problem": pyarrow.string()}
    return pyarrow.schema([*(field.with_nullable(True) for field in by), *said.items()])


def combine_partition(batches: Batches, own: Readings, most_rows: int) -> Iterator[pyarrow.RecordBatch]:
    """The rows of a part on their way to where their groups are gathered. Those of a group that has more than ``most_rows`` at
    hand are reduced to one row, where a reduction tells as much."""
    decide = own.decide_alone()
    for table in _gathered(batches, own.columns, ROWS_AT_A_TIME):
        held = _Held(own, table.schema)
        held.add(table)
        if decide:
            held.reduce_large(most_rows)
        yield from held.moved()


def fit_partition(batches: Batches, own: Readings) -> Iterator[pyarrow.RecordBatch]:
    """The groups of a part, which has all rows of each, in any order. A group of which nothing can be said is a row with the
    reason."""
    held: _Held | None = None
    for table in _gathered(batches, None, ROWS_AT_A_TIME):
        held = held or _Held(own, table.select(own.columns).schema)
        held.add(table)
        if held.count > MOST_ROWS_HELD and own.decide_alone():
            # Where many groups are small the rows are what they are.
            held.reduce_large(max(FEWEST_ROWS_REDUCED, held.count // 64))
    if held is not None:
        yield from held.fits()


def split(table: pyarrow.Table, own: Readings, parts: int) -> list[pyarrow.Table]:
    """The rows by where their groups are gathered: for engines that have no shuffle by key which keeps groups whole."""
    table = table.select(own.columns + [name for name in (REDUCTION,) if name in table.column_names])
    codes, first = _codes(table, own.by)
    keys = _hashables(table.select(list(own.by)).take(first))
    places = numpy.array([crc32(repr(key).encode()) % parts for key in keys], dtype=numpy.int64)
    place_of = places[codes] if len(codes) else codes
    return [table.filter(pyarrow.array(place_of == place)) for place in range(parts)]


@dataclass
class _Held:
    """Rows of groups, some of which are reduced."""

    own: Readings
    schema: pyarrow.Schema
    tables: list[pyarrow.Table] = field(default_factory=list)
    count: int = 0
    #: Of the keys of groups that are reduced in parts: the key as a row of the table, and the reductions.
    reduced: dict[Hashable, tuple[pyarrow.Table, list[bytes]]] = field(default_factory=dict)

    def add(self, table: pyarrow.Table) -> None:
        """More rows, which may be reductions of rows."""
        if REDUCTION in table.column_names:
            reductions = table.column(REDUCTION)
            of_groups = table.filter(reductions.is_valid())
            keys = of_groups.select(list(self.own.by))
            for index, reduction in enumerate(of_groups.column(REDUCTION).to_pylist()):
                self._keep(keys.slice(index, 1), reduction)
            table = table.filter(reductions.is_null())
        table = table.select(self.own.columns).cast(self.schema)
        if table.num_rows:
            self.tables.append(table)
            self.count += table.num_rows

    def _keep(self, key: pyarrow.Table, reduction: bytes) -> None:
        [hashed] = _hashables(key)
        _, reductions = self.reduced.setdefault(hashed, (key, []))
        reductions.append(reduction)

    def _table(self) -> pyarrow.Table:
        return pyarrow.concat_tables([self.schema.empty_table(), *self.tables]).combine_chunks()

    def reduce_large(self, most_rows: int) -> None:
        """Reduces the rows of groups with more than so many. Rows that cannot be reduced stay, so that the fit says why."""
        table = self._table()
        codes, first = _codes(table, self.own.by)
        large = numpy.flatnonzero(numpy.bincount(codes, minlength=len(first)) > most_rows)
        stays = numpy.ones(len(codes), dtype=bool)
        for group in large:
            is_own = codes == group
            rows = table.filter(pyarrow.array(is_own))
            try:
                reduction = reduce_columns(_columns(rows, self.own.reduced_columns, self.own), self.own)
            except ValueError:
                continue
            self._keep(rows.select(list(self.own.by)).slice(0, 1), reduction)
            stays &= ~is_own
        rest = table.filter(pyarrow.array(stays))
        self.tables, self.count = [rest], rest.num_rows

    def moved(self) -> Iterator[pyarrow.RecordBatch]:
        """All of it, in batches."""
        schema = self.schema.append(pyarrow.field(REDUCTION, pyarrow.binary()))
        rows = self._table()
        nothing = pyarrow.nulls(rows.num_rows, pyarrow.binary())
        tables = [rows.append_column(schema.field(REDUCTION), nothing)]
        for key, reductions in self.reduced.values():
            for reduction in reductions:
                row = {name: key.column(name) for name in self.own.by} | {REDUCTION: pyarrow.array([reduction], pyarrow.binary())}
                columns = [row.get(field.name, pyarrow.nulls(1, field.type)) for field in schema]
                tables.append(pyarrow.Table.from_arrays(columns, schema=schema))
        yield from pyarrow.concat_tables(tables).to_batches()

    def fits(self) -> Iterator[pyarrow.RecordBatch]:
        """What is said of each group."""
        own, table = self.own, self._table()
        schema = schema_of_groups([self.schema.field(name) for name in own.by], own)
        groups = _Groups(table, own, schema)
        if self.reduced:
            in_parts = [key in self.reduced for key in _hashables(groups.keys)]
            rows = {key: groups.rows(code, code + 1) for code, key in enumerate(_hashables(groups.keys)) if in_parts[code]}
            is_whole = ~numpy.array(in_parts, dtype=bool)[groups.codes]
            groups = _Groups(table.filter(pyarrow.array(is_whole)), own, schema)
            for hashed, (key, reductions) in self.reduced.items():
                own_rows = rows.get(hashed, table.slice(0, 0))
                yield _batch(key, _fit_in_parts(own_rows, reductions, own), schema)
        if len(groups.first):
            yield from groups.fits(0, len(groups.first))


class _Groups:
    """The rows of a table by their keys."""

    def __init__(self, table: pyarrow.Table, own: Readings, schema: pyarrow.Schema) -> None:
        self.table, self.own, self.schema = table, own, schema
        #: Of each row the number of its group; of each group its first row.
        self.codes, self.first = _codes(table, own.by)
        self.keys = table.select(list(own.by)).take(self.first)
        self._order = numpy.argsort(self.codes, kind="stable")
        self.said = numpy.zeros(len(self.first), dtype=bool)
        self._starts = numpy.concatenate([[0], numpy.cumsum(numpy.bincount(self.codes, minlength=len(self.first)))])

    def rows(self, start: int, end: int) -> pyarrow.Table:
        """The rows of consecutive groups."""
        return self.table.take(self._order[self._starts[start] : self._starts[end]])

    def fits(self, start: int, end: int) -> Iterator[pyarrow.RecordBatch]:
        """What is said of consecutive groups."""
        for first, found in in_halves(self.fitted, start, end):
            if isinstance(found, ValueError):
                yield _batch(self.keys.slice(first, 1), self.problem(first, found), self.schema)
                continue
            groups = numpy.array(found["group"], dtype=numpy.int64)
            yield _batch(self.keys.take(groups), found, self.schema)
            self.said[groups] = True
        for code in numpy.flatnonzero(~self.said[start:end]) + start:
            yield _batch(self.keys.slice(code, 1), _nothing(0, NO_NUMBERS), self.schema)

    def fitted(self, start: int, end: int) -> dict[str, Any]:
        """What is said of consecutive groups, by number."""
        is_all = end - start == len(self.first)
        rows = self.table if is_all else self.rows(start, end)
        codes = self.codes if is_all else self.codes[self._order[self._starts[start] : self._starts[end]]]
        return fitted_groups(_columns(rows, self.own.roles, self.own), self.own, codes)

    def problem(self, group: int, problem: ValueError) -> dict[str, Any]:
        """Why nothing is said of a group."""
        self.said[group] = True
        rows = self.rows(group, group + 1)
        if lacks_all(_columns(rows, list(dict.fromkeys(self.own.roles)), self.own), self.own):
            return _nothing(0, NO_NUMBERS)
        return _nothing(len(rows), _in_words(problem, rows, self.own))


def _gathered(batches: Batches, columns: list[str] | None, rows: int) -> Iterator[pyarrow.Table]:
    """Batches put together to tables of about so many rows."""
    held: list[pyarrow.RecordBatch] = []
    for batch in batches:
        held.append(batch if columns is None else batch.select(columns))
        if sum(len(own) for own in held) >= rows:
            yield pyarrow.Table.from_batches(held)
            held = []
    if held:
        yield pyarrow.Table.from_batches(held)


def _columns(table: pyarrow.Table, names: list[str], own: Readings) -> list[tuple[str, Any]]:
    """Columns as the compiled part takes them; one with two roles is there twice, under two names."""
    columns: list[tuple[str, Any]] = []
    for own_name, name in zip(unique(names), names, strict=True):
        column = table.column(name).combine_chunks()
        if pyarrow.types.is_dictionary(column.type):
            column = column.dictionary_decode()
        if pyarrow.types.is_decimal(column.type) or (name not in own.roles and not pyarrow.types.is_integer(column.type)):
            # Exactly what is stored, without an object for each; identities may be anything that has a text.
            column = column.cast(pyarrow.string())
        columns.append((own_name, cells(column, name, own.reading)))
    return columns


def _codes(table: pyarrow.Table, by: tuple[str, ...]) -> tuple[Any, Any]:
    """Of each row the number of its group, and of each group its first row, in the order of these. Null is a key like others."""
    codes = numpy.zeros(table.num_rows, dtype=numpy.int64)
    for name in by:
        column = _comparable(table.column(name))
        encoded = column.dictionary_encode(null_encoding="encode")
        own = encoded.indices.to_numpy(zero_copy_only=False).astype(numpy.int64)
        # Numbered anew after each column, so that they stay small.
        codes = codes * max(len(encoded.dictionary), 1) + own
        codes = pyarrow.array(codes).dictionary_encode().indices.to_numpy(zero_copy_only=False).astype(numpy.int64)
    count = int(codes.max()) + 1 if len(codes) else 0
    first = numpy.zeros(count, dtype=numpy.int64)
    # Of several assignments to one place the last one stays.
    first[codes[::-1]] = numpy.arange(len(codes))[::-1]
    return codes, first


def _comparable(column: Any) -> Any:
    """Keys that are equal where in memory they are one: times as the integers that they store, since Python's own times have
    microseconds and take two hours at the end of summer time for one; and no zero with a sign."""
    column, types = column.combine_chunks(), pyarrow.types
    if types.is_dictionary(column.type):
        column = column.dictionary_decode()
    if types.is_timestamp(column.type) or types.is_duration(column.type) or types.is_time64(column.type):
        return column.cast(pyarrow.int64())
    if types.is_floating(column.type):
        return pyarrow.compute.call_function("add", [column.cast(pyarrow.float64()), 0.0])
    return column


def _hashables(keys: pyarrow.Table) -> list[Hashable]:
    """Keys as rows that are equal where the engines say so: a NaN is itself."""
    columns = [[value if value == value else "NaN" for value in _comparable(keys.column(name)).to_pylist()] for name in keys.column_names]
    return list(zip(*columns, strict=True))


def _fit_in_parts(rows: pyarrow.Table, reductions: list[bytes], own: Readings) -> dict[str, Any]:
    """What is said of one group that came in reductions and rows: what is said of its rows together."""
    count = sum(Reduction(text, own).rows for text in reductions)
    try:
        reduction = Reduction(merged([*reductions, reduce_columns(_columns(rows, own.reduced_columns, own), own)], own), own)
        if reduction.rows == 0:
            return _nothing(0, NO_NUMBERS)
        fit = reduction.fit()
    except ValueError as problem:
        return _nothing(count + len(rows), _in_words(problem, rows, own))
    answer: dict[str, Any] = {"rows": [reduction.rows], "kind": [fit.kind]}
    numbers = numbers_of(fit)
    for name, value in numbers.items():
        answer[name] = [value if value is None or isinstance(value, float) else nearest(Fraction(value) if isinstance(value, int) else value)]
        answer[f"{name}_exact"] = [None if value is None or isinstance(value, float) else str(Fraction(value))]
    for theta in ("theta1", "theta2"):
        answer[f"{theta}_error"] = [_error_around(numbers[f"{theta}_central"], numbers[f"{theta}_error"])]
    if own.eps_column is not None:
        for end in ("", "_exact"):
            answer["epsilon_factor" + end] = answer.pop("epsilon_min" + end)
    return answer


def numbers_of(fit: Fit) -> dict[str, Fraction | float | None]:
    """The numbers of a fit that are said of a group, ends and errors as bounds, which are rounded outward."""
    numbers: dict[str, Fraction | float | None] = {}
    pui, central, squares, least = fit.pui, fit.central, fit.least_squares, fit.epsilon_min
    for index, theta in enumerate(("theta1", "theta2")):
        interval = None if pui is None else pui[index]
        numbers[f"{theta}_lower"] = None if interval is None else -math.inf if interval.lower is None else interval.lower
        numbers[f"{theta}_upper"] = None if interval is None else math.inf if interval.upper is None else interval.upper
        numbers[f"{theta}_central"] = None if central is None else (central.theta1, central.theta2)[index]
        numbers[f"{theta}_error"] = None if central is None else upper_bound(central.guaranteed_error[index])
        numbers[f"{theta}_least_squares"] = None if squares is None else squares[index]
    numbers["epsilon_min"] = upper_bound(least)
    return numbers


def _error_around(centre: Fraction | float | None, error: Fraction | float | None) -> float | None:
    """The double of an error that holds around the nearest double of a centre too: rounded up."""
    if centre is None or error is None:
        return None
    double = nearest(Fraction(centre))
    if math.isinf(double):
        return math.inf
    return float(UpperBound(Fraction(error) + abs(Fraction(double) - Fraction(centre))))


def _nothing(rows: int, problem: str) -> dict[str, Any]:
    return {"rows": [rows], "problem": [problem]}


def _in_words(problem: ValueError, rows: pyarrow.Table, own: Readings) -> str:
    """What is wrong with a group. The number that a row has among those at hand says nothing elsewhere."""

    def named(index: int) -> str:
        if own.identity is None or index >= len(rows):
            return ""
        return f"{own.identity} {rows.column(own.identity)[index].as_py()}"

    return in_words(problem, named)


def _batch(keys: pyarrow.Table, answer: dict[str, Any], schema: pyarrow.Schema) -> pyarrow.RecordBatch:
    """What is said of some groups as rows."""

    def column(field: pyarrow.Field) -> Any:
        if field.name in keys.column_names:
            return keys.column(field.name).combine_chunks()
        values = answer.get(field.name)
        if values is None:
            return pyarrow.nulls(len(keys), field.type)
        if isinstance(values, bytes):
            doubles = numpy.frombuffer(values, dtype=float)
            return pyarrow.array(doubles, field.type, mask=numpy.isnan(doubles))
        return pyarrow.array(values, field.type)

    return pyarrow.RecordBatch.from_arrays([column(field) for field in schema], schema=schema)
