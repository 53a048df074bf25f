"""From what people have to columns that the compiled part takes, and the words of a call to what it is asked."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, TypeAlias

from ._cells import cells

Number: TypeAlias = "int | float | str | Decimal | Fraction"
#: A numpy array, a pandas or polars Series, a pyarrow array or a sequence of numbers.
Column: TypeAlias = Any
Reading: TypeAlias = Literal["decimal", "binary64"]
Missing: TypeAlias = Literal["refuse", "skip"]
Rows: TypeAlias = "str | Iterable[int] | None"

NamedColumns = list[tuple[str, Any]]


def is_number(value: Any) -> bool:
    """Whether this is one number rather than a column of them."""
    return isinstance(value, (str, int, float, Decimal, Fraction)) or getattr(value, "shape", None) == ()


def text(value: Any) -> str:
    """A number as its shortest text."""
    if isinstance(value, float):
        return float.__repr__(value)
    return str(value)


def fraction(value: Any, name: str, reading: str) -> Fraction:
    """A number exactly; of a float what its shortest text says, or what is stored."""
    is_float = isinstance(value, float) or getattr(getattr(value, "dtype", None), "kind", None) == "f"
    try:
        return Fraction(float(value) if is_float and reading == "binary64" else text(value).strip())
    except (ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"{name}: {value!r} is not a number") from None


def regressors(x: Any) -> list[Any]:
    """The column of x, or both columns of two regressors: a tuple of two, an array of two columns, a frame of two."""
    if isinstance(x, tuple):
        return list(x) if len(x) == 2 and not is_number(x[0]) else [x]
    if getattr(x, "ndim", 1) == 2 or hasattr(x, "columns") or hasattr(x, "column_names"):
        width = len(x.column_names) if hasattr(x, "column_names") else x.shape[1]
        if width not in (1, 2):
            raise ValueError(f"x has {width} columns: expected one, or two of a model with two regressors")
        if hasattr(x, "iloc"):
            return [x.iloc[:, index] for index in range(width)]
        if hasattr(x, "column_names"):
            return [x.column(index) for index in range(width)]
        return [x[:, index] for index in range(width)]
    return [x]


def named(values: Any, default: str, taken: set[str]) -> str:
    """The name of a Series, where it has one that no other column of this call has."""
    name = getattr(values, "name", None)
    name = name.strip() if isinstance(name, str) else ""
    if not name or name.isdigit() or name in taken:
        name = default
    while name in taken:
        name += "'"
    taken.add(name)
    return name


def row_ranges(asked: Rows, name: str) -> list[tuple[int, int | None]]:
    """Ranges of rows, from 1: ``"14..36"``, ``"1..22,24.."`` or row numbers."""
    if asked is None:
        return []
    if not isinstance(asked, str):
        return [(int(row), int(row)) for row in asked]
    ranges: list[tuple[int, int | None]] = []
    for part in asked.split(","):
        match = re.fullmatch(r"\s*(?:(\d+)|(\d*)\s*\.\.\s*(\d*))\s*", part)
        if match is None or not part.strip(" ."):
            raise ValueError(f"{name}={asked!r}: expected rows from 1 such as 14..36, 5, ..10, 10.. or a list of these")
        only, first, last = match.groups()
        if only:
            ranges.append((int(only), int(only)))
        else:
            ranges.append((int(first or 1), int(last) if last else None))
    return ranges


def asked(
    *,
    regressors: int,
    response: bool,
    eps: Any,
    lower: bool,
    upper: bool,
    where: str | Sequence[str],
    through_origin: bool,
    x_origin: Any,
    reading: str,
    missing: str,
    eps_column: bool,
    x_eps: Any = None,
    x_eps_column: bool = False,
    strong: bool = False,
) -> dict[str, Any]:
    """What the compiled part is asked. ``eps`` is a number or a text, or a column of its own, and so is ``x_eps``."""
    if not eps_column and eps is None and not lower and not upper:
        raise ValueError("nothing bounds the errors: expected eps, or lower and upper")
    if (eps is not None or eps_column) and (lower or upper):
        raise ValueError("eps, and lower and upper, both bound the errors: expected one of them")
    if eps is not None and eps_column:
        raise ValueError("eps and eps_column both bound the errors: expected one of them")
    if x_eps is not None and x_eps_column:
        raise ValueError("x_eps and x_eps_column both bound the errors of x: expected one of them")
    if not response and (eps is not None or eps_column):
        raise ValueError("y is missing: expected a column of y, or lower and upper")
    return {
        "regressors": regressors,
        "response": response,
        "eps": eps,
        "eps_column": eps_column,
        "lower": lower,
        "upper": upper,
        "conditions": [where] if isinstance(where, str) else list(where),
        "through_origin": through_origin,
        "x_origin": x_origin,
        "reading": reading,
        "missing": missing,
        "x_eps": x_eps,
        "x_eps_column": x_eps_column,
        "strong": strong,
    }


def in_memory(
    x: Any,
    y: Any,
    eps: Any,
    *,
    lower: Any = None,
    upper: Any = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Any = None,
    reading: str = "decimal",
    missing: str = "refuse",
    x_eps: Any = None,
    strong: bool = False,
) -> tuple[NamedColumns, dict[str, Any]]:
    """The columns of a call in the order of their roles, and what is asked about them."""
    taken: set[str] = set()
    columns: NamedColumns = []

    def add(values: Any, default: str) -> None:
        columns.append((named(values, default, taken), cells(values, default, reading)))

    phi = regressors(x)
    if len(phi) == 1:
        add(phi[0], "x")
    else:
        add(phi[0], "phi1")
        add(phi[1], "phi2")
    if y is not None:
        add(y, "y")
    eps_column = eps is not None and not is_number(eps)
    if eps_column:
        add(eps, "eps")
    for side, name in ((lower, "lower"), (upper, "upper")):
        if side is not None:
            add(side, name)
    x_eps_column = x_eps is not None and not is_number(x_eps)
    if x_eps_column:
        add(x_eps, "x_eps")
    question = asked(
        regressors=len(phi),
        response=y is not None,
        eps=None if eps_column else eps,
        lower=lower is not None,
        upper=upper is not None,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        eps_column=eps_column,
        x_eps=None if x_eps_column else x_eps,
        x_eps_column=x_eps_column,
        strong=strong,
    )
    return columns, question


DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t", "space": " ", "pipe": "|"}


def table(
    *,
    rows: Rows = None,
    without: Rows = None,
    where_row: str | Sequence[str] = (),
    header: bool | None = None,
    encoding: str | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    thousands: str | None = None,
    comment: str | None = None,
    sheet: str | int | None = None,
    skip_lines: int = 0,
    units_row: bool = False,
    missing_as: str | Sequence[str] = (),
    block: str | int | None = None,
    limits: Mapping[str, int] | None = None,
) -> dict[str, Any]:
    """How a file is read."""
    if delimiter is not None:
        delimiter = DELIMITERS.get(delimiter, delimiter)
        if delimiter not in DELIMITERS.values():
            raise ValueError(f"delimiter={delimiter!r}: expected one of {', '.join(DELIMITERS)}")
    return {
        "rows": row_ranges(rows, "rows"),
        "without": row_ranges(without, "without"),
        "where_row": [where_row] if isinstance(where_row, str) else list(where_row),
        "header": header,
        "encoding": encoding,
        "delimiter": None if delimiter is None else ord(delimiter),
        "sheet": None if sheet is None else str(sheet),
        "decimal": decimal,
        "thousands": thousands,
        "comment": comment,
        "skip_lines": skip_lines,
        "units_row": units_row,
        "missing_as": [missing_as] if isinstance(missing_as, str) else [str(word) for word in missing_as],
        "block": None if block is None else str(block),
        "limits": list((limits or {}).items()),
    }
