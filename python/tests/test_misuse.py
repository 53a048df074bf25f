"""What is misspelt, or none of what it should be, is refused in the words of the call."""

from __future__ import annotations

import errno
import json
import pickle
import re
import warnings
from collections.abc import Callable
from datetime import datetime, timedelta
from fractions import Fraction
from pathlib import Path
from typing import Any

import boundfit
import numpy
import pandas
import polars
import pytest
from scipy import sparse
from scipy.io import savemat

X, Y = [0, 1, 2], [0, 1.5, 2]
FIT = boundfit.fit(X, Y, "1/2")

Call = Callable[..., Any]

KEYWORDS: list[tuple[Call, str, str]] = [
    (lambda **how: boundfit.fit(X, Y, **how), "epsilon", "fit() got an unexpected keyword argument 'epsilon': did you mean 'eps'?"),
    (lambda **how: boundfit.fit_file("x.csv", "x", **how), "delimeter", "fit_file() got .* 'delimeter': did you mean 'delimiter'"),
    (lambda **how: boundfit.status(X, Y, 1, **how), "repairs", "status() got .*: did you mean 'repair'"),
    (lambda **how: boundfit.status(X, Y, 1, **how), "lowr", "status() got .*: did you mean 'lower'"),
    (lambda **how: boundfit.predict(X, Y, 1, **how), "frm", "predict() got .*: did you mean 'from_'"),
    (lambda **how: boundfit.next(X, Y, 1, **how), "with_in", "next() got .*: did you mean 'within'"),
    (lambda **how: boundfit.range(X, Y, 1, **how), "b", "range() got .*: did you mean 'by'"),
    (lambda **how: boundfit.outliers(X, Y, 1, **how), "mst", "outliers() got .*: did you mean 'most'"),
    (lambda **how: boundfit.windows(X, Y, 1, **how), "windows", "windows() got .*: did you mean 'window'"),
    (lambda **how: boundfit.linearity(X, Y, **how), "fullscale", "linearity() got .*: did you mean 'full_scale'"),
    (lambda **how: boundfit.linearity_file("x.csv", "x", **how), "row", "linearity_file() got .*: did you mean 'rows'"),
    (lambda **how: boundfit.reduce(X, Y, **how), "epss", "reduce() got .*: did you mean 'eps'"),
    (lambda **how: boundfit.reduce_file("x.csv", "x", **how), "sheets", "reduce_file() got .*: did you mean 'sheet'"),
    (lambda **how: boundfit.fit_groups({}, "g", "x", **how), "eps_col", "fit_groups() got .*: did you mean 'eps_column'"),
    (lambda **how: boundfit.polygon([[1, 0]], [1], **how), "readings", "polygon() got .*: did you mean 'reading'"),
    (lambda **how: boundfit.judge([1, 1], **how), "A_up", "judge() got .*: did you mean 'A_ub'"),
    (FIT.predict, "form", "predict() got .*: did you mean 'from_'"),
    (FIT.outliers, "max", "outliers() got .* 'max' (expected one of most, max_sets, max_steps)"),
]


@pytest.mark.parametrize(("call", "keyword", "words"), KEYWORDS, ids=lambda own: own if isinstance(own, str) else "")
def test_an_unknown_keyword_is_refused_by_the_function_that_was_called(call: Call, keyword: str, words: str) -> None:
    pattern = words.replace("(", r"\(").replace(")", r"\)").replace("?", r"\?")
    with pytest.raises(TypeError, match=f"^{pattern}"):
        call(**{keyword: 1})


def test_keywords_that_only_fits_have_are_refused_with_the_reason() -> None:
    with pytest.raises(ValueError, match="^x_eps: only fit and fit_file answer with errors in x"):
        boundfit.status(X, Y, 1, x_eps=1)


RECORDS = numpy.array([(0, 0.0), (1, 0.1)], dtype=[("flag", "i1"), ("y", "f8")])


def columns() -> list[Any]:
    with warnings.catch_warnings():
        # Matrices are about to be left out of numpy.
        warnings.simplefilter("ignore")
        matrix = numpy.matrix([[0], [0.1]])
    return [RECORDS["y"], RECORDS.view(numpy.recarray).y, matrix, sparse.csr_matrix([[0], [0.1]]), sparse.coo_array([0, 0.1])]


@pytest.mark.parametrize("column", columns(), ids=lambda own: type(own).__name__)
def test_columns_that_are_stored_otherwise(column: Any) -> None:
    assert boundfit.fit([0, 1], column, 0).vertices == [(Fraction(1, 10), Fraction(0))]


def test_groups_of_records() -> None:
    records = numpy.array([(7, 0, 0.0), (7, 1, 2.0)], dtype=[("key", "i1"), ("x", "f8"), ("y", "f4")])
    groups: Any = boundfit.fit_groups(records, "key", "x", "y", 0)
    assert groups["key"] == [7] and groups["theta1_lower_exact"] == ["2"]


class Quantity:
    """As those of astropy and pint: an array that says which unit it has."""

    def __init__(self, values: list[float], **unit: str) -> None:
        self.values = values
        self.__dict__.update(unit)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return numpy.array(self.values, dtype=dtype)


@pytest.mark.parametrize(("library", "unit"), [("astropy.units.quantity", "unit"), ("pint", "units")])
def test_a_unit_is_never_dropped(library: str, unit: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Quantity, "__module__", library)
    with pytest.raises(ValueError, match="^eps has the unit mm: expected numbers without one"):
        boundfit.fit([0, 1], [0, 1], Quantity([0.5, 0.5], **{unit: "mm"}))
    for none in ("", "dimensionless"):
        assert boundfit.fit([0, 1], Quantity([0, 0.5], **{unit: none}), 0).vertices == [(Fraction(1, 2), Fraction(0))]


LAZY: Any = polars.DataFrame({"a": [0, 1], "b": [1, 1]}).lazy()
FRAME = pandas.DataFrame({"g": [1], "x": [1], "y": [1]})

MISSING = 'at: row 2, column 1 (at): "": the value is missing, in this row only (expected a number in every row)'
SKIPPING = boundfit.fit([0, 1, None], [0, 1, 2], 1, missing="skip")

REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: boundfit.fit([0, 1], LAZY, 1), "y is of type LazyFrame: expected an array or a list of numbers, such as those of its collect()"),
    (lambda: boundfit.fit(LAZY, [0, 1], 1), "x is of type LazyFrame"),
    (lambda: boundfit.fit([[1, 0], [0, 1]], [1, 2], 1), "x holds lists: expected one column of numbers, or two regressors as a tuple"),
    (lambda: boundfit.fit([0], FRAME.groupby("g")["y"], 1), "y is of type SeriesGroupBy"),
    (lambda: boundfit.fit([0], [datetime(2020, 1, 1)], 1), "row 1 of y: 2020-01-01 00:00:00 is a time (datetime), not a number"),
    (lambda: boundfit.fit([0], [timedelta(1)], 1), "row 1 of y: 1 day, 0:00:00 is a time (timedelta), not a number"),
    (lambda: boundfit.fit(X, Y, 1, where=5), "where=5: expected a condition as a text, or several such texts"),
    (lambda: boundfit.fit(X, Y, 1, where=["theta1 >= 0", 5]), "where=['theta1 >= 0', 5]: expected"),
    (lambda: FIT.predict(at=[]), "at=[]: expected at least one number"),
    (lambda: FIT.predict(at=[1, None]), MISSING),
    (lambda: SKIPPING.predict(at=[1, None]), MISSING),
    (lambda: SKIPPING.predict(from_=[1, None]), MISSING.replace("at", "from_", 1).replace("(at)", "(from_)")),
    (FIT.windows, "window or window_x says how far a window reaches back"),
    (lambda: boundfit.check(FIT, [1, 2]), "claim=1: expected two ends of each parameter"),
    (lambda: boundfit.check(3, [(1, 2), (3, 4)]), "problem is of type int: expected a fit of exact x, as boundfit.fit returns it"),  # type: ignore[arg-type]
    (lambda: boundfit.check(FIT, [(1, numpy.inf), (3, 4)]), "claim: the upper end of theta1 is inf: expected a number, or None"),
    (lambda: boundfit.check(FIT, [(1, 2), ("-inf", 4)]), "claim: the lower end of theta2 is -inf: expected a number, or None"),
    (lambda: boundfit.fit_groups(LAZY, "a", "a", "b", 1), "frame is of type LazyFrame: expected a frame with its rows, such as that of its"),
    (lambda: boundfit.fit_groups(3, "g", "x", "y", 1), "frame is of type int: expected a frame, or a dictionary of columns"),
    (lambda: boundfit.fit_groups({"g": 3, "x": [1], "y": [1]}, "g", "x", "y", 1), "the column 'g' is of type int: expected an array or a list"),
    (lambda: boundfit.fit_groups(FRAME, 0, "x", "y", 1), "by: 0 is of type int: expected the name of a column"),  # type: ignore[arg-type]
    (lambda: boundfit.fit_groups(FRAME, "g", 1, "y", 1), "x: 1 is of type int: expected the name of a column"),  # type: ignore[arg-type]
    (lambda: boundfit.fit_groups(FRAME, "g", "x", ("y", "y"), 1), "y: ('y', 'y') is of type tuple: expected the name of a column"),
    (lambda: boundfit.fit_groups(FRAME, FRAME["g"], "x", "y", 1), "by: 1 is of type int: expected the name of a column"),
]


@pytest.mark.parametrize(("call", "words"), REFUSED, ids=[words[:40] for _, words in REFUSED])
def test_what_has_no_meaning_is_refused_by_name(call: Callable[[], Any], words: str) -> None:
    with pytest.raises(ValueError) as refused:
        call()
    assert str(refused.value).startswith(words)
    # There is no skipping of what is asked.
    assert words != MISSING or "skip" not in str(refused.value)


def test_one_reading_is_one() -> None:
    assert repr(boundfit.fit([0], [0], 1)).startswith("<boundfit.Fit of 1 reading: strip")


class Masked:
    """As the masked columns of astropy: an array whose masked cells have numbers."""

    def __init__(self, values, mask):
        self.data, self.mask = numpy.array(values), numpy.array(mask)

    def __array__(self, dtype=None, copy=None):
        return self.data


def test_masked_cells_of_other_libraries_are_missing():
    y = Masked([1.0, 9999.0, 3.0], [False, True, False])
    with pytest.raises(ValueError, match="row 2, column 2"):
        boundfit.fit([0, 1, 2], y, 1)
    fit = boundfit.fit([0, 1, 2], y, 1, missing="skip")
    assert fit.to_csv() == b"x,y\n0,1.0\n1,NaN\n2,3.0\n"


def test_a_number_is_no_path():
    fit = boundfit.fit([0, 1], [0, 1], 1)
    for write in (fit.to_csv, fit.lesson, lambda path: boundfit.verify(fit.proof(), path)):
        with pytest.raises(TypeError):
            write(1)


@pytest.mark.parametrize("read", [boundfit.fit_file, boundfit.linearity_file, boundfit.reduce_file])
def test_a_file_that_is_not_there_is_not_found(read: Callable[..., Any], tmp_path: Path) -> None:
    path = str(tmp_path / "none.csv")
    bound = {} if read is boundfit.linearity_file else {"eps": 1}
    with pytest.raises(FileNotFoundError) as missing:
        read(path, x="x", y="y", **bound)
    told = pickle.loads(pickle.dumps(missing.value))
    assert isinstance(told, ValueError) and (told.errno, told.filename) == (errno.ENOENT, path)
    assert str(told).startswith(f"{path}: cannot read: ")
    with pytest.raises(FileNotFoundError, match="cannot read"):
        boundfit.polygon_file(path)


@pytest.mark.parametrize("read", [boundfit.fit_file, boundfit.linearity_file, boundfit.reduce_file])
def test_standard_input_is_no_file_that_is_read_again(read: Callable[..., Any]) -> None:
    bound = {} if read is boundfit.linearity_file else {"eps": 1}
    with pytest.raises(ValueError, match='^path="-": the data are read again for each question'):
        read("-", x="x", y="y", **bound)


class Array(Quantity):
    """As those of xarray: an array around one of any kind."""

    data: Any = None


def test_the_unit_within_an_array_is_not_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Array, "__module__", "xarray.core.dataarray")
    with pytest.raises(ValueError, match="^y has the unit mm: expected numbers without one"):
        boundfit.fit([0, 1], Array([0, 0.5], data=Quantity([0, 0.5], units="mm")), 1)
    assert boundfit.fit([0, 1], Array([0, 0.5], data=numpy.array([0, 0.5])), 0).vertices == [(Fraction(1, 2), Fraction(0))]


def test_the_proof_is_a_report() -> None:
    assert FIT.report("proof") == FIT.proof()


@pytest.mark.parametrize("read", [boundfit.fit_file, boundfit.reduce_file, boundfit.linearity_file])
def test_stored_doubles_are_not_read_as_decimals(read: Callable[..., Any], tmp_path: Path) -> None:
    path = tmp_path / "doubles.mat"
    savemat(path, {"x": [0.0, 1.0], "y": [0.0, 0.1]})
    bound = {} if read is boundfit.linearity_file else {"eps": 0}
    with pytest.raises(ValueError, match='^reading="decimal": the data store doubles and no decimals'):
        read(path, x="x", y="y", reading="decimal", **bound)
    assert read(path, x="x", y="y", **bound)
    assert boundfit.fit_file(path, "x", "y", 0).vertices == [(Fraction(0.1), 0)]


def test_one_number_is_no_list(tmp_path: Path) -> None:
    (tmp_path / "one.csv").write_text("x,y\n0,1\n")
    for key in ("eps", "x_eps", "x_origin"):
        with pytest.raises(ValueError, match=rf'^{key}=\[1\]: expected one number, such as 0.5 or "1/3"$'):
            boundfit.fit_file(tmp_path / "one.csv", "x", "y", **{"eps": 1, key: [1]})
    with pytest.raises(ValueError, match="^encoding: 5: expected a text$"):
        boundfit.fit_file(tmp_path / "one.csv", "x", "y", 1, encoding=5)


LINE = boundfit.fit([0, 1, 2], [0, 1.5, 2], 0.5)

IN_VAIN: list[tuple[Callable[[], Any], str]] = [
    (lambda: LINE.report(brief=True, full=True), "brief and full exclude each other: give one of them"),
    (lambda: LINE.report("csv", brief=True), "brief has no effect on format='csv', which has everything: expected text, latex or markdown"),
    (lambda: LINE.report("wkt", full=True), "full has no effect on format='wkt'"),
    (lambda: LINE.report("proof", digits=3), "digits has no effect on format='proof', which has doubles, exact numbers or both"),
    (lambda: LINE.status().report("csv", digits=3), "digits has no effect on format='csv'"),
]


@pytest.mark.parametrize(("call", "message"), IN_VAIN, ids=lambda own: own if isinstance(own, str) else "")
def test_an_argument_without_effect_is_refused(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        call()


def test_documents_of_columns_name_no_file() -> None:
    assert LINE.report("json") == LINE.to_json() and LINE.status().report("json") == LINE.status().to_json()
    assert json.loads(LINE.report("json", digits=3))["input"]["file"] is None


def test_a_reduction_says_that_it_is_one(tmp_path: Path) -> None:
    (tmp_path / "reduced.csv").write_bytes(boundfit.reduce([0, 1, 2, 3, 4], [0, 5, 0, 5, 0]))
    fit = boundfit.fit_file(tmp_path / "reduced.csv", "x", "y", 1)
    with pytest.raises(ValueError, match="^a proof is about every reading, and this is a reduction: prove the answer about the table that it was made from$"):
        fit.proof()
    assert fit.to_dict()["reasons"]["mended_without"] == "since the data are a reduction"
    assert "The single row to leave out is not known, since the data are a reduction." in " ".join(fit.report(full=True).split())
