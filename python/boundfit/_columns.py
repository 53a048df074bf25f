"""From what people have to columns that the compiled part takes, and the keywords of a call to the words of a request."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
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


def quoted(name: str) -> str:
    """A column's name, also where it looks like a number."""
    return f'"{name}"'


def texts(one_or_more: str | Sequence[str]) -> list[str]:
    """One text, or several."""
    return [one_or_more] if isinstance(one_or_more, str) else list(one_or_more)


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

    def add(values: Any, default: str) -> str | None:
        if values is None:
            return None
        columns.append((named(values, default, taken), cells(values, default, reading)))
        return quoted(columns[-1][0])

    phi = regressors(x)
    x_names = [add(own, default) for own, default in zip(phi, ["x"] if len(phi) == 1 else ["phi1", "phi2"])]
    y_name = add(y, "y")
    eps_name = None if is_number(eps) else add(eps, "eps")
    lower_name, upper_name = add(lower, "lower"), add(upper, "upper")
    x_eps_name = None if is_number(x_eps) else add(x_eps, "x_eps")
    said = {
        "x": x_names[0] if len(x_names) == 1 else x_names,
        "y": y_name,
        "eps": None if eps_name else eps,
        "eps_column": eps_name,
        "lower": lower_name,
        "upper": upper_name,
        "where": texts(where) or None,
        "through_origin": through_origin,
        "x_origin": x_origin,
        "reading": reading,
        "missing": missing,
        "x_eps": None if x_eps_name else x_eps,
        "x_eps_column": x_eps_name,
        "strong": strong,
    }
    # Most of it is not said, and each key would be read once more.
    return columns, {key: value for key, value in said.items() if value is not None and value is not False}


DELIMITERS = {",": "comma", ";": "semicolon", "\t": "tab", " ": "space", "|": "pipe"}


def table(
    *,
    rows: Rows = None,
    without: Rows = None,
    where_row: str | Sequence[str] = (),
    header: bool | None = None,
    delimiter: str | None = None,
    sheet: str | int | None = None,
    missing_as: str | Sequence[str] = (),
    block: str | int | None = None,
    **how: Any,
) -> dict[str, Any]:
    """How a file is read, in the words of a request."""

    def chosen(asked: Rows) -> Any:
        return asked if asked is None or isinstance(asked, str) else [int(row) for row in asked]

    return {
        "rows": chosen(rows),
        "without": chosen(without),
        "where_row": texts(where_row),
        "header": None if header is None else "yes" if header else "no",
        "delimiter": None if delimiter is None else DELIMITERS.get(delimiter, delimiter),
        "sheet": None if sheet is None else str(sheet),
        "missing_as": [missing_as] if isinstance(missing_as, str) else [str(word) for word in missing_as],
        "block": None if block is None else str(block),
        **how,
    }
