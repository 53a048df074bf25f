"""From what people have to columns that the compiled part takes, and the keywords of a call to the words of a request."""

from __future__ import annotations

import numbers
from collections.abc import Iterable, Mapping, Sequence, Set
from decimal import Decimal
from fractions import Fraction
from operator import index
from typing import Any, Literal, TypeAlias

from . import _boundfit
from ._cells import cells, refuse_lazy

Number: TypeAlias = "int | float | str | Decimal | Fraction"
#: A numpy array, a pandas or polars Series, a pyarrow array or a sequence of numbers.
Column: TypeAlias = Any
Reading: TypeAlias = Literal["decimal", "binary64"]
Missing: TypeAlias = Literal["refuse", "skip"]
Rows: TypeAlias = "str | Iterable[int] | None"

NamedColumns = list[tuple[str, Any]]


def is_number(value: Any) -> bool:
    """Whether this is one number rather than a column of them."""
    # Number has those of mpmath and sympy, too, but takes longer than the types before it.
    if isinstance(value, (str, int, float, numbers.Number)) or getattr(value, "shape", None) == ():
        return True
    # A quantity of pint has the shape of its magnitude.
    if type(value).__module__.partition(".")[0] == "pint" and hasattr(value, "magnitude"):
        return is_number(value.magnitude)
    # A scalar of pyarrow, or a float of gmpy2.
    return hasattr(value, "as_py") or hasattr(value, "as_integer_ratio")


def text(value: Any) -> str:
    """A number as its shortest text."""
    return _boundfit.number_text(value, "decimal")


def fraction(value: Any, name: str, reading: str) -> Fraction:
    """A number exactly, within the limits of numbers; of a float what its shortest text says, or what is stored."""
    return _boundfit.number(value, name, reading)


def count(value: Any, name: str, least: int = 0, most: int | None = None) -> int:
    """A whole number of a call.

    :raises ValueError: where it is none, or one that has no meaning there.
    """
    # Larger ones count nothing that a computer holds.
    end = 2**62 if most is None else most
    try:
        number = None if _is_truth(value) else index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= end:
        is_large = number is not None and number > end
        expected = f"at least {least}" if most is None and not is_large else f"{least} to {end}"
        kind = "a whole number, " if number is None else ""
        raise ValueError(f"{name}={value!r}: expected {kind}{expected}")
    return number


def maybe_count(value: Any, name: str, least: int = 0, most: int | None = None) -> int | None:
    """A whole number, where one is given."""
    return None if value is None else count(value, name, least, most)


def maybe_digits(value: Any) -> int | None:
    """The digits of a report, where they are given."""
    return maybe_count(value, "digits", 1, 1000)


def refuse_vain(format: str, digits: int | None, brief: bool = False, full: bool = False) -> None:
    """Refuses what has no effect on a report in a format.

    :raises ValueError: where something has none.
    """
    documents = ("text", "latex", "markdown")
    if brief and full:
        raise ValueError("brief and full exclude each other: give one of them")
    if (brief or full) and format not in documents:
        raise ValueError(f"{'brief' if brief else 'full'} has no effect on format={format!r}, which has everything: expected text, latex or markdown")
    if digits is not None and format not in (*documents, "json"):
        raise ValueError(f"digits has no effect on format={format!r}, which has doubles, exact numbers or both: expected text, latex, markdown or json")


def flag(value: Any, name: str) -> bool:
    """A truth value of a call, also one of numpy.

    :raises ValueError: where it is none.
    """
    if value is True or value is False:
        return value
    if not _is_truth(value):
        raise ValueError(f"{name}={value!r}: expected True or False")
    return bool(value)


def _is_truth(value: Any) -> bool:
    return isinstance(value, bool) or (getattr(getattr(value, "dtype", None), "kind", None) == "b" and getattr(value, "shape", None) == ())


def several(values: Any, name: str, length: int, expected: str) -> tuple[Any, ...]:
    """So many values that belong together, such as both ends of a range.

    :raises ValueError: where they are not as many.
    """
    listed = tuple(values) if isinstance(values, Iterable) and not isinstance(values, (str, bytes, Mapping, Set)) else ()
    if len(listed) != length:
        raise ValueError(f"{name}={values!r}: expected {expected}")
    return listed


def numbers_of(values: Any, name: str) -> list[Any]:
    """The numbers of a vector, which may be whatever a column may be; short floats stay short.

    :raises ValueError: where it is none.
    """
    return list(cells(values, name))


def rows_of(matrix: Any, name: str) -> list[list[Any]]:
    """The rows of a matrix, also of a sparse one, and of a frame.

    :raises ValueError: where something is no row.
    """
    if hasattr(matrix, "toarray"):
        matrix = matrix.toarray()
    # Iterating over a frame gives its columns, or their names.
    columns: list[Any] | None = None
    if hasattr(matrix, "iloc") and hasattr(matrix, "columns"):
        columns = [matrix.iloc[:, place] for place in range(matrix.shape[1])]
    elif hasattr(matrix, "get_columns"):
        columns = matrix.get_columns()
    elif hasattr(matrix, "column_names"):
        columns = matrix.columns
    if columns is not None:
        return [list(row) for row in zip(*(numbers_of(column, name) for column in columns), strict=True)]
    if isinstance(matrix, (str, bytes, Mapping, Set)) or not isinstance(matrix, Iterable):
        raise ValueError(f"{name} is of type {type(matrix).__name__}: expected rows of numbers")
    return [numbers_of(row, f"row {number} of {name}") for number, row in enumerate(matrix, 1)]


def _holds_lists(x: Any) -> bool:
    return isinstance(x, (list, tuple)) and bool(x) and isinstance(x[0], (list, tuple))


def regressors(x: Any) -> list[Any]:
    """The column of x, or both columns of two regressors: a tuple of two, an array of two columns, a frame of two."""
    refuse_lazy(x, "x")
    if isinstance(x, tuple) and len(x) == 2 and not is_number(x[0]):
        return list(x)
    if isinstance(x, tuple):
        return [x]
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


def texts(one_or_more: Any, name: str) -> list[str]:
    """One text, or several.

    :raises ValueError: where it is neither.
    """
    if isinstance(one_or_more, tuple) and not one_or_more:
        return []
    listed: list[Any] = [one_or_more] if isinstance(one_or_more, str) else list(one_or_more) if isinstance(one_or_more, (tuple, Iterable)) else [None]
    if not all(isinstance(own, str) for own in listed):
        raise ValueError(f"{name}={one_or_more!r}: expected a condition as a text, or several such texts")
    return listed


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
    # The compiled part reads every key: one that says nothing is left out.
    said: dict[str, Any] = {}

    def add(values: Any, key: str, default: str) -> None:
        columns.append((named(values, default, taken), cells(values, default, reading)))
        said[key] = quoted(columns[-1][0])

    def add_bound(values: Any, key: str) -> None:
        if values is None:
            return
        if is_number(values):
            said[key] = values
        else:
            add(values, f"{key}_column", key)

    phi = regressors(x)
    if len(phi) == 1:
        if _holds_lists(phi[0]):
            raise ValueError("x holds lists: expected one column of numbers, or two regressors as a tuple of two columns or an array of two")
        add(phi[0], "x", "x")
    else:
        for own, key in zip(phi, ["phi1", "phi2"], strict=True):
            add(own, key, key)
        said["x"] = [said.pop("phi1"), said.pop("phi2")]
    if y is not None:
        add(y, "y", "y")
    add_bound(eps, "eps")
    if lower is not None:
        add(lower, "lower", "lower")
    if upper is not None:
        add(upper, "upper", "upper")
    add_bound(x_eps, "x_eps")
    if conditions := texts(where, "where"):
        said["where"] = conditions
    if flag(through_origin, "through_origin"):
        said["through_origin"] = True
    if x_origin is not None:
        said["x_origin"] = x_origin
    if reading != "decimal":
        said["reading"] = reading
    if missing != "refuse":
        said["missing"] = missing
    if flag(strong, "strong"):
        said["strong"] = True
    return columns, said


DELIMITERS = {",": "comma", ";": "semicolon", "\t": "tab", " ": "space", "|": "pipe"}


def table(
    *,
    rows: Rows = None,
    without: Rows = None,
    where_row: str | Sequence[str] = (),
    header: bool | Literal["yes", "no", "auto"] | None = None,
    delimiter: str | None = None,
    sheet: str | int | None = None,
    skip_lines: int | None = None,
    units_row: bool = False,
    missing_as: Any = (),
    block: str | int | None = None,
    limits: Mapping[str, int] | None = None,
    **how: Any,
) -> dict[str, Any]:
    """How a file is read, in the words of a request."""

    chosen = _chosen(rows, "rows")
    if chosen == []:
        # No rows would be no choice of rows, which is that of all.
        raise ValueError(f"rows={rows!r}: expected the number of at least one row, such as [1, 2], or a text such as \"14..36\"")
    return {
        "rows": chosen,
        "without": _chosen(without, "without"),
        "where_row": texts(where_row, "where_row"),
        "header": _header(header),
        "delimiter": None if delimiter is None else DELIMITERS.get(delimiter, delimiter),
        "sheet": None if sheet is None else str(sheet),
        "skip_lines": maybe_count(skip_lines, "skip_lines"),
        "units_row": flag(units_row, "units_row"),
        "missing_as": _words(missing_as),
        "block": None if block is None else str(block),
        "limits": None if limits is None else _limits(limits),
        **how,
    }


def _words(asked: Any) -> list[str]:
    if is_number(asked):
        return [text(asked)]
    if isinstance(asked, bytes) or not isinstance(asked, Iterable):
        raise ValueError(f"missing_as={asked!r}: expected a text such as \"OVLD\", a number, or several of them")
    return [text(word) for word in asked]


def _chosen(asked: Rows, name: str) -> str | list[int] | None:
    if asked is None or isinstance(asked, str):
        return asked
    if isinstance(asked, bytes) or not isinstance(asked, Iterable):
        raise ValueError(f"{name}={asked!r}: expected a list of the numbers of rows, such as [1, 2], or a text such as \"14..36\"")
    return [count(row, name, 1) for row in asked]


def _header(header: Any) -> str | None:
    if header is None or (isinstance(header, str) and header == "auto"):
        return None
    if isinstance(header, str) and header in ("yes", "no"):
        return header
    if not _is_truth(header):
        raise ValueError(f"header={header!r}: expected True or \"yes\", False or \"no\", None or \"auto\"")
    return "yes" if header else "no"


def _limits(limits: Any) -> dict[str, int]:
    if not isinstance(limits, Mapping):
        raise ValueError(f"limits={limits!r}: expected a dictionary, such as {{\"digits\": 20_000}}")
    return {str(name): count(most, f"limits[{name!r}]") for name, most in limits.items()}
