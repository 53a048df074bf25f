"""Reductions: the few readings that decide, with the sums over all."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Unpack

from . import _boundfit
from ._asking import Name, Table, readings, readings_of_file
from ._columns import Column, Missing, Number, Reading, regressors
from ._keywords import knows
from ._reduction import any_bound


@knows()
def reduce(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
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
    if eps is None and lower is None and upper is None:
        eps = any_bound(len(regressors(x)))
    return _boundfit.reduce(readings(x, y, eps, lower=lower, upper=upper, reading=reading, missing=missing))


@knows(Table.__annotations__)
def reduce_file(
    path: str | os.PathLike[str],
    x: Name | Sequence[Name],
    y: Name | None = None,
    eps: Number | None = None,
    *,
    eps_column: Name | None = None,
    lower: Name | None = None,
    upper: Name | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    **how: Unpack[Table],
) -> bytes:
    """As :func:`reduce`, of columns of a file, or of reductions one after the other in it. How it is read is told as in
    :func:`boundfit.fit_file`."""
    if eps is None and eps_column is None and lower is None and upper is None:
        eps = any_bound(1 if isinstance(x, (str, int)) else len(x))
    asked = readings_of_file(
        path, x, y, eps, eps_column=eps_column, lower=lower, upper=upper, reading=reading, missing=missing, **how
    )
    return _boundfit.reduce(asked)
