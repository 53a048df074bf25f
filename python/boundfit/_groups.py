"""Fleets: the readings of many sensors in one frame, each sensor fitted on its own."""

from __future__ import annotations

import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, TypeVar

from . import _boundfit
from ._cells import cells, only_column
from ._columns import Missing, NamedColumns, Number, Reading
from ._keywords import knows
from ._reduction import NO_NUMBERS, Names, Readings, columns_of_groups, fitted_groups, in_halves, in_words, lacks_all, readings, unique

Frame = TypeVar("Frame")


@knows()
def fit_groups(
    frame: Frame,
    by: Names,
    x: Names,
    y: str | None = None,
    eps: Number | None = None,
    *,
    id: str | None = None,
    eps_column: str | None = None,
    lower: str | None = None,
    upper: str | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
) -> Frame:
    """Fits the rows of each key on their own, in one call. Columns are named as those of the frame, and the answer is a frame of
    the library that it came from: pandas, polars or pyarrow; of a dictionary of columns it is one.

    There is a row per key, in the order in which the keys first occur. It has the columns of the key, with their names, types and
    values as they are, how many ``rows`` the key has and which ``kind`` of set there is. Ends, central and least-squares estimates
    follow as doubles, ends and errors rounded outward: an error covers the rounding of its centre too. Behind each is its exact text
    in the column ``…_exact``. A number that does not exist is NaN in pandas and in a dictionary, null elsewhere. ``problem`` says why
    nothing is said of a group, with the row of the frame, or its cell of the column ``id``.

    :raises ValueError: when the question makes no sense; what is wrong with readings is said in the row of their group.

    >>> table = {"cell": ["a", "b", "a", "b"], "x": [0, 0, 1, 1], "y": [0.0, 0.5, 1.0, 2.5]}
    >>> groups = fit_groups(table, by="cell", x="x", y="y", eps="0.1")
    >>> groups["cell"], groups["theta1_lower_exact"]
    (['a', 'b'], ['4/5', '9/5'])
    """
    own = readings(
        x,
        y,
        eps,
        by=by,
        id=id,
        eps_column=eps_column,
        lower=lower,
        upper=upper,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
    )
    names = columns_of_groups(own)
    if type(frame).__name__ == "LazyFrame":
        raise ValueError("frame is of type LazyFrame: expected a frame with its rows, such as that of its collect()")
    if isinstance(frame, (str, bytes)) or not hasattr(frame, "__getitem__"):
        raise ValueError(f"frame is of type {type(frame).__name__}: expected a frame, or a dictionary of columns")
    given = {name: _column(frame, name) for name in own.columns}
    keys = [_key(_counted(given[name]), name, len(own.by) == 1) for name in own.by]
    columns = [(name, cells(given[role], role, reading)) for name, role in zip(unique(own.roles), own.roles, strict=True)]
    ids = None if id is None else _listed(given[id], id)
    named = [] if id is None else [(id, ids)]
    for name, values in [*zip(own.by, keys, strict=True), *columns, *named]:
        if len(values) != len(keys[0]):
            raise ValueError(f"the column {name!r} has {len(values)} rows, but {own.by[0]!r} has {len(keys[0])}")
    groups = _Groups(columns, _codes(keys, own.by, _module(frame) == "pandas"), ids, own)
    answer = groups.answer(names)
    framed: Frame = _framed(frame, {name: given[name] for name in own.by}, groups.first, answer)
    return framed


def _column(frame: Any, name: str) -> Any:
    try:
        own = frame[name]
    except Exception as problem:
        # Every library has an exception of its own for it.
        if name not in getattr(frame, "column_names", getattr(frame, "columns", frame)):
            raise ValueError(f"the frame has no column {name!r}") from None
        raise ValueError(f"the column {name!r}: {problem}") from problem
    if hasattr(own, "columns") and hasattr(own, "iloc"):
        # In pandas columns of one name are a frame, and so are those of names with several levels.
        return only_column(own, name).iloc[:, 0]
    # An iterator can be gone through once only.
    return list(own) if isinstance(own, Iterator) else own


def _counted(values: Any) -> Any:
    """A column of times as the integers that it stores: Python's own times have microseconds, and two hours at the end of summer
    time are equal."""
    if _module(values) == "polars" and values.dtype.is_temporal():
        return values.to_physical()
    if _module(values) == "pyarrow":
        import pyarrow

        if pyarrow.types.is_dictionary(values.type):
            values = values.cast(values.type.value_type)
        if pyarrow.types.is_timestamp(values.type) or pyarrow.types.is_duration(values.type) or pyarrow.types.is_time64(values.type):
            return values.cast(pyarrow.int64())
    return values


def _key(values: Any, name: str, is_alone: bool) -> Any:
    """A column of a key as a list, or as a buffer of integers where the compiled part numbers them as they are."""
    if is_alone and _are_integers(values):
        return cells(values, name)
    return _listed(values, name)


def _are_integers(values: Any) -> bool:
    """Whether a column is one of numpy, pandas or polars in which every cell is an integer that is stored as such."""
    kind: Any = getattr(values, "dtype", None)
    if _module(values) == "polars":
        return bool(kind.is_integer()) and values.null_count() == 0 and "128" not in str(kind)
    return _module(kind) == "numpy" and kind.kind in "iu" and getattr(values, "ndim", 1) == 1


def _listed(values: Any, name: str) -> list[Any]:
    for method in ("to_pylist", "to_list", "tolist"):
        if hasattr(values, method):
            listed: list[Any] = getattr(values, method)()
            return listed
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise ValueError(f"the column {name!r} is of type {type(values).__name__}: expected an array or a list")
    return list(values)


_NAN = object()


def _codes(keys: list[Any], by: tuple[str, ...], nan_is_missing: bool) -> tuple[Any, list[int]]:
    """Of each row the number of its group, in the order in which they first occur, and of each group its first row. Keys are equal
    where the frame's library says so: a missing key is one, and a NaN is itself, which pandas takes for missing."""

    def hashable(value: Any) -> Any:
        if value is None or type(value).__name__ in ("NAType", "NaTType"):
            return None
        return value if value == value else None if nan_is_missing else _NAN

    found = _boundfit.codes(keys[0]) if len(keys) == 1 else None
    if found is not None:
        return found
    keys = [_listed(values, name) for values, name in zip(keys, by, strict=True)]
    numbers: dict[Any, int] = {}
    try:
        own = [values if set(map(type, values)) <= {str, int} else [hashable(value) for value in values] for values in keys]
        codes = array.array("q", [numbers.setdefault(key, len(numbers)) for key in (own[0] if len(own) == 1 else zip(*own, strict=True))])
    except Exception as problem:
        # Comparing and hashing call the methods of whatever the cells are.
        raise ValueError(f"by: a cell of {', '.join(map(repr, by))} is no key: {problem}") from None
    first = [0] * len(numbers)
    for row in range(len(codes) - 1, -1, -1):
        first[codes[row]] = row
    return codes, first


class _Groups:
    """Rows by their keys."""

    def __init__(self, columns: NamedColumns, codes: tuple[Any, list[int]], ids: list[Any] | None, own: Readings) -> None:
        self.columns, self.ids, self.own = columns, ids, own
        self.codes, self.first = codes
        self._rows: list[list[int]] = []

    def rows(self, start: int, end: int) -> list[int]:
        """The rows of consecutive groups, from 0."""
        if not self._rows:
            self._rows = [[] for _ in self.first]
            for row, code in enumerate(self.codes):
                self._rows[code].append(row)
        return [row for code in range(start, end) for row in self._rows[code]]

    def fitted(self, start: int, end: int) -> dict[str, Any]:
        """What is said of consecutive groups, by number."""
        if end - start == len(self.first):
            return fitted_groups(self.columns, self.own, self.codes)
        rows = self.rows(start, end)
        return fitted_groups(_taken(self.columns, rows), self.own, _cells_at(self.codes, rows))

    def problem(self, group: int, problem: ValueError) -> tuple[int, str]:
        """How many rows a group has of which nothing is said, and why."""
        rows = self.rows(group, group + 1)
        if lacks_all(_taken(self.columns, rows), self.own):
            return 0, NO_NUMBERS

        def named(index: int) -> str:
            row = rows[min(index, len(rows) - 1)]
            return f"row {row + 1}" if self.ids is None else f"{self.own.identity} {self.ids[row]}"

        return len(rows), in_words(problem, named)

    def answer(self, names: list[str]) -> dict[str, Any]:
        """The columns of the answer with these names: of each group what is said of it, or why nothing is."""
        count = len(self.first)
        parts = list(in_halves(self.fitted, 0, count)) if count else []
        _, whole = parts[0] if len(parts) == 1 else (0, None)
        if isinstance(whole, dict) and len(whole["rows"]) == count:
            return {name: _numbers(whole[name]) if name in whole else [None] * count for name in names}
        answer: dict[str, list[Any]] = {name: [None] * count for name in names}
        answer["rows"] = [0] * count
        answer["problem"] = [NO_NUMBERS] * count
        for start, found in parts:
            if isinstance(found, ValueError):
                answer["rows"][start], answer["problem"][start] = self.problem(start, found)
                continue
            groups = list(map(int, found["group"]))
            for name in names:
                own, values = answer[name], _numbers(found[name]) if name in found else [None] * len(groups)
                for group, value in zip(groups, values, strict=True):
                    own[group] = value
        return answer


def _taken(columns: NamedColumns, rows: list[int]) -> NamedColumns:
    return [(name, _cells_at(values, rows)) for name, values in columns]


def _cells_at(values: Any, rows: list[int]) -> Any:
    """Some cells of a list, or of a buffer of numbers, which stays one of the same numbers."""
    if isinstance(values, list):
        return [values[row] for row in rows]
    view = memoryview(values)
    return array.array(view.format, [view[row] for row in rows])


def _numbers(value: Any) -> Any:
    """A column as it comes from the compiled part: doubles are its bytes."""
    if not isinstance(value, bytes):
        return value
    doubles = array.array("d")
    doubles.frombytes(value)
    return doubles


def _module(frame: Any) -> str:
    return type(frame).__module__.partition(".")[0]


def _framed(frame: Any, keys: dict[str, Any], first: list[int], answer: dict[str, Any]) -> Any:
    """The keys as they are in the frame, and the columns of the answer, as a frame of the same library."""
    is_text: Callable[[str], bool] = lambda name: name in ("kind", "problem") or name.endswith("_exact")  # noqa: E731
    match _module(frame):
        case "pandas":
            import pandas

            text = pandas.Series(["text"]).dtype
            types = {name: text if is_text(name) else "int64" if name == "rows" else "float64" for name in answer}
            taken = {name: values.take(first).reset_index(drop=True) for name, values in keys.items()}
            return pandas.DataFrame(taken | {name: pandas.Series(values, dtype=types[name]) for name, values in answer.items()})
        case "polars":
            import polars

            kinds = {name: polars.String if is_text(name) else polars.Int64 if name == "rows" else polars.Float64 for name in answer}
            columns = [polars.Series(name, values, kinds[name]) for name, values in answer.items()]
            columns = [own.fill_nan(None) if own.dtype == polars.Float64 else own for own in columns]
            return polars.DataFrame([values.gather(first) for values in keys.values()] + columns)
        case "pyarrow":
            import pyarrow

            stored = {name: pyarrow.string() if is_text(name) else pyarrow.int64() if name == "rows" else pyarrow.float64() for name in answer}
            rows = pyarrow.array(first, pyarrow.int64())
            said = {name: pyarrow.array(values, stored[name], from_pandas=True) for name, values in answer.items()}
            return pyarrow.table({name: values.take(rows) for name, values in keys.items()} | said)
    listed = {name: _listed(values, name) for name, values in keys.items()}
    found = {name: [float("nan") if value is None and not is_text(name) else value for value in values] for name, values in answer.items()}
    return {name: [values[row] for row in first] for name, values in listed.items()} | found
