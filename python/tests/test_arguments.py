"""An argument means the same in every type, and one without a meaning is refused with the values that would be accepted."""

from __future__ import annotations

import copy
import decimal
import os
import pickle
import re
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import boundfit
import numpy
import pandas
import polars
import pyarrow
import pytest
from boundfit import LowerBound, UpperBound
from boundfit._columns import in_memory

TENTH = Fraction(1, 10)
THIRD = Fraction(1, 3)
SHORT, HALF, LONG = numpy.float32(0.1), numpy.float16(0.1), numpy.longdouble(1) / 10

#: More digits than Python prints.
LARGE = 10**5000


def line(second: Any, **how: Any) -> Any:
    """The slope of the line through (0, 0) and (1, the second number of a column)."""
    return boundfit.fit([0, 1], second, 0, **how).vertices[0][0]


def fit() -> boundfit.Fit:
    return boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")


def table(tmp_path: Path) -> Path:
    path = tmp_path / "table.csv"
    path.write_text("x,y\n0,0\n1,1.5\n2,2\n")
    return path


@pytest.mark.parametrize("order", [">", "<"])
@pytest.mark.parametrize("kind", ["f4", "f8", "i2"])
def test_a_buffer_has_the_order_of_its_bytes(order: str, kind: str) -> None:
    column = numpy.array([0, 3 if kind == "i2" else 0.1], order + kind)
    view: Any = column
    assert line(memoryview(view)) == (3 if kind == "i2" else TENTH)


COLUMN = numpy.array([0, 0.1], "f4")
SHORT_COLUMNS: list[Any] = [
    COLUMN,
    list(COLUMN),
    numpy.array(list(COLUMN), dtype=object),
    pandas.Series(pandas.arrays.SparseArray(COLUMN)),
    pandas.arrays.SparseArray(COLUMN),
    pandas.Series(pandas.arrays.ArrowExtensionArray(pyarrow.chunked_array([pyarrow.array(COLUMN).dictionary_encode()]))),
    [pyarrow.scalar(own, pyarrow.float32()) for own in (0, 0.1)],
]


@pytest.mark.parametrize("column", SHORT_COLUMNS, ids=lambda own: type(own).__name__)
def test_short_floats_are_short_in_every_column(column: Any) -> None:
    assert line(column) == TENTH
    assert line(column, reading="binary64") == Fraction(float(SHORT))


def test_long_floats_are_what_is_stored() -> None:
    stored = Fraction(*LONG.as_integer_ratio())
    for column in (numpy.array([0, LONG]), [0, LONG]):
        assert line(column, reading="binary64") == stored
        assert line(column) == TENTH
    assert boundfit.fit([0, 1], [0, 0], LONG, reading="binary64").vertices[0][1] == stored
    with pytest.raises(ValueError, match="row 2.*the value is missing"):
        line(numpy.array([0, numpy.longdouble("nan")]), reading="binary64")


def test_a_claim_is_what_is_stored() -> None:
    numbers: list[Any] = [SHORT, HALF, LONG, numpy.array(SHORT)]
    for number in numbers:
        claimed = boundfit.check(fit(), [[number, number], [0, 0]])[0].claimed
        assert claimed == Fraction(*number.item().as_integer_ratio())
    assert boundfit.check(fit(), numpy.array([[0.1] * 2, [0, 0]], "f4"))[0].claimed == Fraction(float(SHORT))
    strip = boundfit.fit([0], [0], 1)
    assert [own.verdict for own in boundfit.check(strip, strip.pui)] == ["exact"] * 4
    judged = boundfit.judge([SHORT, 1], [[-1, 0], [0, -1]], [-1, 0])
    assert judged.value == Fraction(float(SHORT))


def test_the_bounds_of_a_polygon_keep_the_reading() -> None:
    bounds = boundfit.polygon([[1, 0], [-1, 0]], [0.1, -0.1], reading="binary64").bounds
    assert bounds is not None
    assert 0.1 in bounds.theta1 and "0.1" not in bounds.theta1


FRAME = {"11": [-1.0, 0, 2], "22": [0.0, -1, 3]}


@pytest.mark.parametrize("library", [pandas.DataFrame, polars.DataFrame, pyarrow.table])
def test_a_frame_has_rows(library: Any) -> None:
    frame = library(FRAME)
    rows, ends = [[-1, 0], [0, -1], [2, 3]], [0, 0, 6]
    assert boundfit.polygon(frame, ends).vertices == boundfit.polygon(rows, ends).vertices
    assert boundfit.judge([-1, -1], frame, ends).points == boundfit.judge([-1, -1], rows, ends).points


def test_directions_as_numbers_are_those_as_words() -> None:
    def both(direction: Any) -> Any:
        found = boundfit.linearity([0, 1, 0, 1], [0, 1, "0.1", "1.3"], direction=direction)
        return found.up, found.down, found.hysteresis

    words = both(["up", "up", "down", "down"])
    for up, down in ((1, -1), (1.0, -1.0), (1.0, 0.0), (Decimal("1.0"), 0), (HALF * 0 + 1, -1)):
        assert both([up, up, down, down]) == words
        assert both([down, down, up, up]) != words
    assert both(numpy.array([1.0, 1, -1, -1])) == words


def test_arrays_of_ends_are_rounded_outward() -> None:
    for response, exact in (("1", THIRD), ("1e300", Fraction(10**300, 3)), ("-1e300", Fraction(-(10**300), 3))):
        pui = boundfit.fit([0, 3], [0, response], 0).pui
        assert pui is not None
        for kind in ("f2", "f4", "f8"):
            lower, upper = map(float, numpy.asarray(pui.theta1, dtype=kind))
            assert lower < exact < upper, (response, kind)
            assert numpy.asarray(pui, dtype=kind)[0].tolist() == [lower, upper]


def test_vertices_as_doubles_have_a_box_that_is_not_smaller() -> None:
    point = boundfit.fit([0, 3], ["1/7", "8/7"], 0)
    segment = boundfit.fit([1, 3], ["1/3", "1/3"], 1, where="theta1 = 1/3")
    distant = boundfit.fit([0, 1], [0, "1e400"], 0)
    for own in (point, segment, distant, fit()):
        box = own.to_numpy()
        for axis in (0, 1):
            column = [vertex[axis] for vertex in own.vertices]
            assert min(box[:, axis]) <= min(column) and max(column) <= max(box[:, axis])
    assert boundfit.fit([0, 1], [0, 1], 0).to_numpy().tolist() == [[1.0, 0.0]]
    assert distant.to_numpy(outward=False).tolist() == [[numpy.inf, 0.0]]


def test_a_bound_is_formatted_in_any_context() -> None:
    with decimal.localcontext(decimal.Context(prec=2)):
        assert f"{LowerBound(1, 3):.35g}" == f"0.{'3' * 35}"
        assert f"{UpperBound(10**35 + 1):.40g}" == str(10**35 + 1)


def test_polygons_and_judgements_are_copied_pickled_and_hashed(tmp_path: Path) -> None:
    triangle = boundfit.polygon([[-1, 0], [0, -1], [2, 3]], [0, 0, 0.1], reading="binary64")
    (tmp_path / "triangle.ine").write_text(triangle.report("ine"))
    for own in (triangle, boundfit.polygon_file(tmp_path / "triangle.ine")):
        read = pickle.loads(pickle.dumps(own))
        assert read.vertices == triangle.vertices and read.bounds == own.bounds and read.to_dict() == own.to_dict()
        assert copy.deepcopy(own) is own
    assert pickle.loads(pickle.dumps(triangle)).bounds.theta1.reading == "binary64"
    first, second = (boundfit.judge([-1, -1], [[1, 2], [3, 1]], [4, 6]) for _ in range(2))
    assert {first} == {second}


def test_what_is_gone_through_once_is_a_column_of_a_frame() -> None:
    frame = {"k": iter("abab"), "x": [0, 0, 1, 1], "y": iter([0, 0, 1, 2])}
    found = boundfit.fit_groups(frame, "k", "x", "y", 0)
    assert (found["k"], found["theta1_lower_exact"]) == (["a", "b"], ["1", "2"])


def test_numbers_longer_than_python_prints() -> None:
    fit = boundfit.fit([0, 1], [0, LARGE], 1)
    assert fit.pui is not None and fit.pui.theta1.upper == LARGE + 2
    assert LARGE in fit.pui.theta1
    assert fit.predict(at=1).at[0].line.upper == LARGE + 1
    assert boundfit.polygon([[LARGE, 0], [-1, 0]], [1, 0]).bounds.theta1.upper == Fraction(1, LARGE)  # type: ignore[union-attr]


def test_values_of_numpy_are_counts_and_truths(tmp_path: Path) -> None:
    own = fit()
    two: Any = numpy.int64(2)
    true: Any = numpy.True_
    assert own.windows(two) == own.windows(2)
    assert own.outliers(most=two).growth == own.outliers(most=2).growth
    assert own.status(repair=true).repair == own.status(repair=True).repair
    assert own.report(digits=two) == own.report(digits=2)
    assert boundfit.fit([0, 1], [0, 1], 1, through_origin=true).kind == "segment"
    strong = boundfit.fit([0, 1], [0, 1], 1, x_eps=1, strong=true)
    assert strong.sides == boundfit.fit([0, 1], [0, 1], 1, x_eps=1, strong=True).sides
    assert boundfit.fit_file(table(tmp_path), "x", "y", 1, rows=numpy.array([1, 2]), header="yes", missing_as=-999).rows == 2


def test_a_proof_may_be_bytes() -> None:
    own = fit()
    assert boundfit.verify(own.proof().encode(), bytearray(own.to_csv()))


LINE: dict[str, Any] = {"x": [0, 1], "y": [0, 1], "eps": 1}
TWO: Any = ([1, 0, 1], [0, 1, 1])
YEAR = numpy.datetime64(2020, "Y")
EXPONENT = "exponent beyond 10000 (the limit)"

REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: fit().status(new=([], [])), "new: the columns are empty"),
    (lambda: fit().status(new=([1],)), "new has 1 column: expected x, y"),
    (lambda: fit().predict(grid=(0, 1, 100000)), 'grid="0..1/100000": refused: more than 100000 values (expected fewer, or an array of them)'),
    (lambda: boundfit.fit_file("w.csv", None, "y", 1), "x=None: expected the name of a column or its number from 1, or two of them"),  # type: ignore[arg-type]
    (lambda: boundfit.fit_file("w.csv", 1.0, 2, 1), "x=1.0: expected the name of a column or its number from 1, or two of them"),  # type: ignore[arg-type]
    (lambda: boundfit.fit_file("w.csv", 1, 2, 1, missing_as=None), 'missing_as=None: expected a text such as "OVLD", a number, or several of them'),  # type: ignore[arg-type]
    (lambda: f"{fit().pui[0].lower:_.2f}", "format '_.2f' of a bound: expected one of a float"),  # type: ignore[index]
    (lambda: boundfit.status(**LINE | {"x_eps": 1}), "x_eps: only fit and fit_file answer with errors in x"),
    (lambda: boundfit.range(**LINE | {"strong": True}), "strong: only fit and fit_file answer with errors in x"),
    (lambda: boundfit.judge([1, 1], [[1, 1]], [4], [(0, -numpy.inf), (0, None)]), "bounds[0]: the upper bound is -inf: expected a number, inf or None"),
    (lambda: boundfit.judge([1, 1], [[1, 1]], [4], [(0, None), (numpy.inf, None)]), "bounds[1]: the lower bound is inf: expected a number, -inf or None"),
    (lambda: boundfit.judge([1, 1], [[1, 1]], [4], tolerance=-1), "tolerance=-1: expected a share, at least 0"),
    (lambda: boundfit.judge([1, 1], ["11"], [4]), "row 1 of A_ub is of type str: expected an array or a list of numbers"),
    (lambda: boundfit.polygon(["11"], [4]), "row 1 of A is of type str: expected an array or a list of numbers"),
    (lambda: boundfit.polygon([[True, 0]], [1]), 'row 1 of A="True": '),
    (lambda: boundfit.polygon([["1_0", 0]], [1]), 'row 1 of A="1_0": '),
    (lambda: boundfit.polygon([[1, 0]], [1], reading="Binary64"), 'reading="Binary64": expected one of "decimal", "binary64"'),  # type: ignore[arg-type]
    (lambda: boundfit.linearity([0, 1], [0, 1], direction=[True, False]), "row 1 of direction: True is a truth value"),
    (lambda: numpy.asarray(fit().pui[0], dtype=int), "dtype=int64: expected a type of floats"),  # type: ignore[index]
    (lambda: boundfit.fit([0, 1], ["0", 0.1], "written"), "row 2 of y: 0.1 is a float, of which no last digit is written"),
    (lambda: boundfit.fit([0, 1], numpy.array([0, 0.1], "f2"), "written"), "row 1 of y: 0.0 is a float"),
    (lambda: boundfit.reduce([0, 1], pandas.Series([None, 0.1], dtype=object), "written", missing="skip"), "row 2 of y: 0.1 is a float"),
    (lambda: line([0, YEAR]), "row 2 of y: 3990 is a time (datetime64), not a number"),
    (lambda: line(numpy.array([0, YEAR], dtype=object)), "row 2 of y: 3990 is a time (datetime64), not a number"),
    (lambda: fit().predict(grid=(0, 10, 2.9)), "grid: the number of steps=2.9: expected a whole number, at least 1"),  # type: ignore[arg-type]
    (lambda: fit().predict(grid=(0, 10)), "grid=(0, 10): expected (from, to, steps)"),  # type: ignore[arg-type]
    (lambda: boundfit.fit(TWO, [1, 1, 2], 1).response(3), "x2: expected one, as the model has two regressors"),
    (lambda: fit().response(3, 2), "x2: expected none, as the model is a line"),
    (lambda: boundfit.reduce([0, 1], lower=[0, 0], upper=[1, 1], eps=5), "the errors have one bound: eps"),
    (lambda: "1e999999999" in fit().pui[0], f'value="1e999999999": {EXPONENT}'),  # type: ignore[index]
    (lambda: fit().predict(grid=(0, Decimal("1e999999999"), 3)), f'grid="1E+999999999": {EXPONENT}'),
    (lambda: boundfit.polygon([[1, "1e999999999"]], [1]), f'row 1 of A="1e999999999": {EXPONENT}'),
    (lambda: line([0, 10**20000]), "row 2 of y: a number of more than 10000 digits (the limit)"),
    (lambda: fit().report(digits=10**9), "digits=1000000000: expected 1 to 1000"),
    (lambda: fit().status().report(digits=0), "digits=0: expected 1 to 1000"),
    (lambda: fit().windows(-1), "window=-1: expected at least 1"),
    (lambda: fit().outliers(most=-1), "most=-1: expected at least 0"),
    (lambda: fit().status(repair="no"), "repair='no': expected True or False"),  # type: ignore[arg-type]
    (lambda: fit().figure(dpi=10**8), "dpi=100000000: expected 30 to 1200"),
    (lambda: fit().figure(directions=-1), "directions=-1: expected 3 to 1000"),
    (lambda: fit().figure(x_range=3), "x_range=3: expected both ends of the axis"),  # type: ignore[arg-type]
    (lambda: boundfit.verify(b"abc", b""), "proof: these bytes are no JSON"),
]


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_what_has_no_meaning_is_refused(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        call()


REFUSED_OF_FILES: list[tuple[dict[str, Any], str]] = [
    ({"rows": []}, "rows=[]: expected the number of at least one row"),
    ({"rows": [2.9]}, "rows=2.9: expected a whole number, at least 1"),
    ({"rows": 2}, "rows=2: expected a list of the numbers of rows"),
    ({"header": "No"}, "header='No': expected True or \"yes\""),
    ({"header": "no"}, 'line 1: there is no column "x"'),
    ({"limits": {"digits": -5}}, "limits['digits']=-5: expected at least 0"),
    ({"skip_lines": -1}, "skip_lines=-1: expected at least 0"),
]


@pytest.mark.parametrize(("how", "message"), REFUSED_OF_FILES, ids=[message for _, message in REFUSED_OF_FILES])
def test_what_has_no_meaning_of_a_file_is_refused(how: dict[str, Any], message: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        boundfit.fit_file(table(tmp_path), "x", "y", 1, **how)


def test_limits_are_named_where_there_is_such_an_argument(tmp_path: Path) -> None:
    path = tmp_path / "long.csv"
    path.write_text(f"x,y\n0,0\n1,{'1' * 20000}\n")
    with pytest.raises(ValueError, match=r'\(the limit\) at character 10001; limits=\{"digits": \.\.\.\} raises it$'):
        boundfit.fit_file(path, "x", "y", 1)
    for how in ({**LINE, "y": [0, "1" * 20000]}, {**LINE, "eps": "1e99999"}):
        with pytest.raises(ValueError, match=r"\(the limit\) at character \d+$"):
            boundfit.fit(**how)


def test_a_further_file_that_is_not_there_is_none(tmp_path: Path) -> None:
    own = boundfit.fit_file(os.fsencode(table(tmp_path)), "x", "y", 1, missing_as=-999)  # type: ignore[arg-type]
    with pytest.raises(FileNotFoundError, match="nowhere.csv: cannot read: No such file"):
        own.status(new=str(tmp_path / "nowhere.csv"))


def test_what_is_at_its_default_says_nothing() -> None:
    x, y = numpy.array([0.0, 1.0, 2.0]), numpy.array([0.0, 1.5, 2.0])
    _, said = in_memory(x, y, 0.5)
    assert said == {"x": '"x"', "y": '"y"', "eps": 0.5}
    same = boundfit.fit(x, y, 0.5, where=[], through_origin=numpy.False_, reading="decimal", missing="refuse", strong=False)  # type: ignore[call-overload]
    assert same.to_dict() == boundfit.fit(x, y, 0.5).to_dict()
    _, said = in_memory((x, y), y, y, lower=None, where="theta1 >= 0", x_origin="1/2", reading="binary64", missing="skip")
    assert list(said) == ["x", "y", "eps_column", "where", "x_origin", "reading", "missing"]
