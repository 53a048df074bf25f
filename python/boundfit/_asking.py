"""One way of saying what is asked of readings, whatever it is and wherever they come from."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any, Literal, TypeAlias, TypedDict, Unpack

from . import _boundfit
from ._answers import Ask
from ._columns import Column, Missing, Number, Reading, Rows, flag, in_memory, table, texts

#: A column of a file, by its header or its number from 1.
Name: TypeAlias = "str | int"


class How(TypedDict, total=False):
    """What is said of columns besides x, y and eps: see :func:`boundfit.fit`."""

    lower: Column | None
    upper: Column | None
    where: str | Sequence[str]
    through_origin: bool
    x_origin: Number | None
    reading: Reading
    missing: Missing


class Table(TypedDict, total=False):
    """How a file is read: see :func:`boundfit.fit_file`."""

    rows: Rows
    without: Rows
    where_row: str | Sequence[str]
    header: bool | Literal["yes", "no", "auto"] | None
    encoding: str | None
    delimiter: str | None
    decimal: Literal["point", "comma"] | None
    thousands: str | None
    comment: str | None
    sheet: str | int | None
    skip_lines: int
    units_row: bool
    missing_as: Number | Sequence[Number]
    block: str | int | None
    limits: Mapping[str, int] | None


def readings(
    x: Column | tuple[Column, Column],
    y: Column | None,
    eps: Number | Column | None,
    *,
    x_eps: Number | Column | None = None,
    strong: bool = False,
    **how: Unpack[How],
) -> _boundfit.Readings:
    """Columns in memory, and what is asked of them."""
    columns, question = in_memory(x, y, eps, x_eps=x_eps, strong=strong, **how)
    return _boundfit.readings_of_columns(columns, question)


def file_name(path: str | os.PathLike[str]) -> str:
    """The name of a file. The engine would take ``-`` for standard input, which is empty where a question reads the data again."""
    name = os.fsdecode(path)
    if name == "-":
        raise ValueError('path="-": the data are read again for each question, and standard input cannot be (expected the path of a file)')
    return name


def readings_of_file(
    path: str | os.PathLike[str],
    x: Name | Sequence[Name],
    y: Name | None,
    eps: Number | None,
    *,
    eps_column: Name | None = None,
    lower: Name | None = None,
    upper: Name | None = None,
    x_eps: Number | None = None,
    x_eps_column: Name | None = None,
    strong: bool = False,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    **how: Unpack[Table],
) -> _boundfit.Readings:
    """Columns of a file, and what is asked of them."""
    if not isinstance(x, (str, int)) and (isinstance(x, bytes) or not isinstance(x, Iterable)):
        raise ValueError(f"x={x!r}: expected the name of a column or its number from 1, or two of them")
    regressors = [x] if isinstance(x, (str, int)) else list(x)
    if len(regressors) not in (1, 2):
        raise ValueError(f"x names {len(regressors)} columns: expected one, or two of a model with two regressors")
    *phi, y, eps_column, lower, upper, x_eps_column = roles = [
        None if name is None else str(name) for name in (*regressors, y, eps_column, lower, upper, x_eps_column)
    ]
    question = {
        "x": phi[0] if len(phi) == 1 else phi,
        "y": y,
        "eps": eps,
        "eps_column": eps_column,
        "lower": lower,
        "upper": upper,
        "where": texts(where, "where"),
        "through_origin": flag(through_origin, "through_origin"),
        "x_origin": x_origin,
        "reading": reading,
        "missing": missing,
        "x_eps": x_eps,
        "x_eps_column": x_eps_column,
        "strong": flag(strong, "strong"),
        **table(**how),
    }
    return _boundfit.readings_of_file(file_name(path), [name for name in roles if name is not None], question)


def ask(
    readings: _boundfit.Readings, question: str, *, tables: list[tuple[str, list[tuple[str, Any]]]] | None = None, **keys: Any
) -> Ask:
    """What answers a question about readings in any form; keys that are None are left out. ``tables`` are columns that it names."""
    given = {key: value for key, value in keys.items() if value is not None}
    return partial(_boundfit.ask, readings, json.dumps({"ask": question, **given}), tables=tables)


def exact(number: Number | None, reading: str) -> dict[str, str] | None:
    """A number of a question, exactly as it was given."""
    return None if number is None else {"exact": _boundfit.number_text(number, reading)}
