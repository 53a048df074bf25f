"""Reductions: the few readings that decide, with the sums over all."""

from __future__ import annotations

import os
from collections.abc import Sequence

from . import _boundfit
from ._columns import Column, Missing, Number, Reading, Rows, in_memory
from ._fit import of_file


def reduce(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = 0,
    *,
    lower: Column | None = None,
    upper: Column | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
) -> bytes:
    """The readings that decide, as the text of a reduction, which :func:`boundfit.fit_file` and the program fit like the whole.
    Reductions written one after the other into a file are the reduction of all. Of a line under one bound for all readings they
    serve every such bound; of anything else, those given here.

    >>> text = reduce([0.0, 1.0, 2.0, 3.0], [0.0, 1.5, 1.5, 3.0])
    >>> text.splitlines()[1:]
    [b'x,y', b'0.0,0.0', b'1.0,1.5', b'2.0,1.5', b'3.0,3.0']
    """
    columns, question = in_memory(
        x,
        y,
        None if lower is not None or upper is not None else eps,
        lower=lower,
        upper=upper,
        where=(),
        through_origin=False,
        x_origin=None,
        reading=reading,
        missing=missing,
        eui=False,
    )
    return _boundfit.reduce_columns(columns, question)


def reduce_file(
    path: str | os.PathLike[str],
    x: str | int | Sequence[str | int],
    y: str | int | None = None,
    eps: Number | None = None,
    *,
    eps_column: str | int | None = None,
    lower: str | int | None = None,
    upper: str | int | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
    rows: Rows = None,
    without: Rows = None,
    where_row: str | Sequence[str] = (),
    header: bool | None = None,
    delimiter: str | None = None,
    sheet: str | int | None = None,
    skip_lines: int = 0,
    units_row: bool = False,
) -> bytes:
    """As :func:`reduce`, of columns of a file, or of reductions one after the other in it."""
    if eps is None and eps_column is None and lower is None and upper is None:
        eps = 0
    question, names, how = of_file(
        x, y, eps, eps_column, lower, upper, (), False, None, reading, missing, False,
        rows, without, where_row, header, delimiter, sheet, skip_lines, units_row,
    )  # fmt: skip
    return _boundfit.reduce_file(os.fspath(path), names, question, how)
