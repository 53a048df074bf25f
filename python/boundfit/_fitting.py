"""Fits of readings in memory and in files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Unpack, overload

from . import _boundfit
from ._asking import How, Name, Table, ask, readings_of_file
from ._columns import Column, Missing, Number, Reading, in_memory
from ._fit import Fit
from ._keywords import knows
from ._x_errors import XErrorFit


def _fitted(asked: _boundfit.Readings, has_x_errors: bool, eui: bool, confidence: Number | None) -> Fit | XErrorFit:
    if not has_x_errors:
        return Fit(asked, eui, confidence)
    if confidence is not None:
        raise ValueError("confidence is about the band of a single set, and with x_eps there may be two")
    return XErrorFit(ask(asked, "fit-x-errors"), asked.reading)


@overload
def fit(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    x_eps: None = None,
    strong: bool = False,
    eui: bool = True,
    confidence: Number | None = None,
    **how: Unpack[How],
) -> Fit: ...


@overload
def fit(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    x_eps: Number | Column,
    strong: bool = False,
    **how: Unpack[How],
) -> XErrorFit: ...


@knows()
def fit(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    lower: Column | None = None,
    upper: Column | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
    x_eps: Number | Column | None = None,
    strong: bool = False,
    eui: bool = True,
    confidence: Number | None = None,
) -> Fit | XErrorFit:
    """Fits a line, y = theta1*x + theta2 + e, or with two regressors in ``x``, y = theta1*phi1 + theta2*phi2 + e.

    Columns are numpy arrays, pandas or polars Series, pyarrow arrays, or lists of int, float, ``Decimal``, ``Fraction`` and str.
    Integers, texts, decimals and fractions are exact. A float stands, under ``reading="decimal"``, for its shortest text, so that a
    frame gives the answer of the CSV that it came from (0.1 is 1/10); under ``"binary64"`` for the number that is stored. It means
    the same in every argument, and in whatever the fit is asked later.

    ``eps`` bounds every error: a number, a column of one per reading, a law such as ``"0.05%*|y| + 2e-3"``, or a multiple of the
    least bound, ``"1.2*min"``. In its place ``lower`` and ``upper`` may bound the line itself at each reading; a NaN or ``None``
    is no bound. ``where`` has what is known of the parameters, such as ``"theta1 >= 0"``.

    Rows without a number are refused, or left out with ``missing="skip"``. ``eui=False`` saves the look that the EUI takes.

    ``x_eps`` bounds the errors of x as well, a number or a column: a line then agrees with a reading if it meets its box, for
    some x, or with ``strong`` for every x, and the answer is an :class:`XErrorFit`. ``confidence``, such as ``"0.99"``, also asks
    which share of further readings lies in the band of the least bound (``guarantee``).

    :raises ValueError: with the row, for NaN, infinities, texts that are no numbers, and columns of different lengths.

    >>> through = fit([1, 2, 3], ["2.1", "3.9", "6.2"], 0.5, through_origin=True)
    >>> through.pui.theta1.lower, through.pui.theta1.upper
    (LowerBound(19, 10), UpperBound(11, 5))
    >>> through.pui.theta1.upper_proof[0]
    Term(row=2, bound='upper', multiplier=Fraction(1, 2))
    """
    columns, question = in_memory(
        x,
        y,
        eps,
        lower=lower,
        upper=upper,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        x_eps=x_eps,
        strong=strong,
    )
    return _fitted(_boundfit.readings_of_columns(columns, question), x_eps is not None, eui, confidence)


@overload
def fit_file(
    path: str | os.PathLike[str],
    x: Name | Sequence[Name],
    y: Name | None = None,
    eps: Number | None = None,
    *,
    eps_column: Name | None = None,
    lower: Name | None = None,
    upper: Name | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    x_eps: None = None,
    x_eps_column: None = None,
    strong: bool = False,
    eui: bool = True,
    confidence: Number | None = None,
    **how: Unpack[Table],
) -> Fit: ...


@overload
def fit_file(
    path: str | os.PathLike[str],
    x: Name | Sequence[Name],
    y: Name | None = None,
    eps: Number | None = None,
    *,
    eps_column: Name | None = None,
    lower: Name | None = None,
    upper: Name | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    x_eps: Number,
    x_eps_column: None = None,
    strong: bool = False,
    **how: Unpack[Table],
) -> XErrorFit: ...


@overload
def fit_file(
    path: str | os.PathLike[str],
    x: Name | Sequence[Name],
    y: Name | None = None,
    eps: Number | None = None,
    *,
    eps_column: Name | None = None,
    lower: Name | None = None,
    upper: Name | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    x_eps: None = None,
    x_eps_column: Name,
    strong: bool = False,
    **how: Unpack[Table],
) -> XErrorFit: ...


@knows(Table.__annotations__)
def fit_file(
    path: str | os.PathLike[str],
    x: str | int | Sequence[str | int],
    y: str | int | None = None,
    eps: Number | None = None,
    *,
    eps_column: str | int | None = None,
    lower: str | int | None = None,
    upper: str | int | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading | None = None,
    missing: Missing = "refuse",
    x_eps: Number | None = None,
    x_eps_column: Name | None = None,
    strong: bool = False,
    eui: bool = True,
    confidence: Number | None = None,
    **how: Unpack[Table],
) -> Fit | XErrorFit:
    """Fits columns of a file in any format that the program reads: CSV in many dialects, workbooks, MATLAB, Parquet, Arrow, and
    reductions, packed or not. Columns are named by their headers, or numbered from 1; two in ``x`` are two regressors. Everything
    else is as in :func:`fit`, and how the file is read is told by it, or by these. ``reading`` is ``"decimal"`` unless it is given; a
    file that stores doubles, such as one of MATLAB, is always read as ``"binary64"``, and refuses ``"decimal"``.

    - ``rows="14..36"``, ``without="23,31"``: rows by number from 1, without the header; ``where_row="temperature >= 20"``
    - ``header=True`` or ``False``, also ``"yes"`` or ``"no"``: whether the first row names the columns; ``units_row=True``: the next one has units
    - ``encoding="windows-1252"``, also ``"utf-8"``, ``"iso-8859-1"``, ``"iso-8859-15"``, ``"utf-16le"``, ``"utf-16be"``: found out
      otherwise
    - ``delimiter``: ``"comma"``, ``"semicolon"``, ``"tab"``, ``"space"``, ``"pipe"`` or the character
    - ``decimal="comma"``; ``thousands="."``: what stands between groups of three digits
    - ``comment="#"``: lines that start with it are passed over; ``"none"``: no line is; ``skip_lines=3``: the first three are
    - ``sheet``: of a workbook, by name or number
    - ``block``: of a file with several blocks of rows, its number or the comment before it; ``"all"``: the rows of all of them
    - ``missing_as="OVLD"``, or several such texts: these cells, or those with the same number, count as missing ones
    - ``limits={"digits": 20_000}``: what is refused unless it is raised, such as ``"rows"`` or bytes (``"memory"``) held, or ``"work"``
    """
    asked = readings_of_file(
        path,
        x,
        y,
        eps,
        eps_column=eps_column,
        lower=lower,
        upper=upper,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        x_eps=x_eps,
        x_eps_column=x_eps_column,
        strong=strong,
        **how,
    )
    return _fitted(asked, x_eps is not None or x_eps_column is not None, eui, confidence)
