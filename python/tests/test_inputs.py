"""Columns in memory give the program's answers about the same numbers, whatever they come in."""

from __future__ import annotations

import array
import json
import math
import random
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

from conftest import Program

Texts = list[str]

# How texts of decimals become columns: those of which every reading is the text's.
EXACT: dict[str, Callable[[Texts], Any]] = {
    "list of str": list,
    "list of Decimal": lambda texts: [Decimal(text) for text in texts],
    "list of Fraction": lambda texts: [Fraction(text) for text in texts],
    "tuple of str": tuple,
    "numpy objects": lambda texts: numpy.array([Decimal(text) for text in texts], dtype=object),
    "pandas str": pandas.Series,
    "polars str": polars.Series,
    "polars decimal": lambda texts: polars.Series([Decimal(text) for text in texts], dtype=polars.Decimal(30, 6)),
    "pyarrow str": pyarrow.array,
    "pyarrow decimal": lambda texts: pyarrow.array([Decimal(text) for text in texts], pyarrow.decimal128(30, 6)),
}
# Those that hold doubles, whose shortest texts these are.
DOUBLES: dict[str, Callable[[Texts], Any]] = {
    "list of float": lambda texts: [float(text) for text in texts],
    "numpy": lambda texts: numpy.array(texts, dtype=float),
    "numpy strided": lambda texts: numpy.repeat(numpy.array(texts, dtype=float), 2)[::2],
    "numpy one column": lambda texts: numpy.array(texts, dtype=float).reshape(-1, 1),
    "array": lambda texts: array.array("d", map(float, texts)),
    "pandas": lambda texts: pandas.Series(texts, dtype=float),
    "pandas nullable": lambda texts: pandas.Series(texts, dtype=float).astype("Float64"),
    "pandas of arrow": lambda texts: pandas.Series(texts, dtype=float).astype("double[pyarrow]"),
    "polars": lambda texts: polars.Series(list(map(float, texts))),
    "pyarrow": lambda texts: pyarrow.array(list(map(float, texts))),
    "pyarrow chunked": lambda texts: pyarrow.chunked_array([list(map(float, texts[:1])), list(map(float, texts[1:]))], pyarrow.float64()),
}


def problems(count: int) -> list[tuple[Texts, Texts]]:
    """Readings with few distinct values, so that ties, vertical data and empty sets are many."""
    chance = random.Random(17)
    made = []
    for _ in range(count):
        rows = chance.choice([1, 2, 3, 3, 4, 5, 8, 13])
        places = chance.choice([0, 1, 3])
        spread = chance.choice([1, 3, 20, 1000])

        def number() -> str:
            return str(Decimal(chance.randint(-spread, spread)).scaleb(-places))  # noqa: B023

        same = number()
        is_vertical = chance.random() < 0.1
        x = [same if is_vertical else number() for _ in range(rows)]
        made.append((x, [number() for _ in range(rows)]))
    return made


def exact(number: Any) -> Fraction | None:
    return None if number is None or number["exact"] is None else Fraction(number["exact"])


def of_program(group: dict[str, Any]) -> Any:
    both = lambda ends: None if ends is None else [(exact(own["lower"]), exact(own["upper"])) for own in ends]  # noqa: E731
    pui = group["pui"]
    return (
        group["fps"]["kind"],
        group["fps"]["vertex_count"],
        None if pui is None else [(exact(own["lower"]), exact(own["upper"])) for own in pui],
        both(group["eui"]),
        None if group["least_squares"] is None else [exact(own) for own in group["least_squares"]["theta"]],
        None if group["central"] is None else [exact(own) for own in group["central"]["theta"]],
        exact(group["epsilon_min"]),
    )  # fmt: skip


def of_fit(fit: boundfit.Fit) -> Any:
    # The program's fleets have no interval without any end.
    both = lambda ends: None if ends is None else [(own.lower, own.upper) for own in ends]  # noqa: E731
    pui = both(fit.pui)
    return (
        fit.kind,
        len(fit.vertices),
        None if pui == [(None, None)] * 2 else pui,
        both(fit.eui),
        None if fit.least_squares is None else list(fit.least_squares),
        None if fit.central is None else list(fit.central[:2]),
        fit.epsilon_min,
    )


@pytest.mark.parametrize("reading", ["decimal", "binary64"])
def test_every_type_of_column_gives_the_answers_of_the_program(reading: Any, program: Program, tmp_path: Path) -> None:
    cases = problems(2000)
    lines = [f"{index},{x},{y}" for index, (xs, ys) in enumerate(cases) for x, y in zip(xs, ys, strict=True)]
    (tmp_path / "all.csv").write_text("\n".join(["case,x,y", *lines, ""]))
    options = ["--by", "case", "--x", "x", "--y", "y", "--eps", "0.5", "--format", "json"]

    def answers(reading: str) -> list[Any]:
        lines = program("fit", tmp_path / "all.csv", *options, "--reading", reading).splitlines()
        assert len(lines) == len(cases)
        return [of_program(json.loads(line)) for line in lines]

    # What is exact is so under either reading.
    of_exact, of_doubles = answers("decimal"), answers(reading)
    ways = list({**EXACT, **DOUBLES}.items())
    for index, (xs, ys) in enumerate(cases):
        # Types whose columns take long to make see a part of the problems; plain ones see all.
        for number, (name, column) in enumerate(ways):
            if name not in ("list of str", "list of float", "numpy", "pandas", "pyarrow") and (index + number) % 5:
                continue
            fit = boundfit.fit(column(xs), column(ys), "0.5", reading=reading)
            assert of_fit(fit) == (of_exact if name in EXACT else of_doubles)[index], (name, xs, ys)


def test_integers_are_exact() -> None:
    large = 2**53 + 1
    for column in (
        [0, large],
        numpy.array([0, large]),
        numpy.array([0, large], dtype="uint64"),
        pandas.Series([0, large]),
        pandas.Series([0, large], dtype="Int64"),
        polars.Series([0, large]),
        pyarrow.array([0, large]),
    ):
        assert boundfit.fit([0, 1], column, 0).vertices == [(large, 0)]
        assert boundfit.fit([0, 1], column, 0, reading="binary64").vertices == [(large, 0)]
    for kind in ("int8", "int16", "int32", "uint8", "uint16", "uint32"):
        assert boundfit.fit(numpy.array([0, 1], dtype=kind), [0, 7], 0).vertices == [(7, 0)]
    assert boundfit.fit([0, 1], [0, 10**40], 0).vertices == [(10**40, 0)]


def test_short_floats_are_their_shortest_text_or_themselves() -> None:
    column = numpy.array([0, 0.1], dtype="float32")
    assert boundfit.fit([0, 1], column, 0).vertices == [(Fraction(1, 10), 0)]
    assert boundfit.fit([0, 1], column, 0, reading="binary64").vertices == [(Fraction(float(numpy.float32(0.1))), 0)]
    assert boundfit.fit([0, 1], [0, 0.1], 0, reading="binary64").vertices == [(Fraction(0.1), 0)]


def test_bounds_of_every_kind() -> None:
    x, y = [0, 1, 2], [0, 1.5, 2]
    uniform = boundfit.fit(x, y, "1/2").vertices
    for eps in (0.5, Fraction(1, 2), Decimal("0.5"), numpy.float64(0.5), [0.5, "1/2", Decimal("0.5")], numpy.full(3, 0.5), pandas.Series([0.5] * 3)):
        assert boundfit.fit(x, y, eps).vertices == uniform
    lower, upper = numpy.array([-0.5, 1, 1.5]), numpy.array([0.5, 2, 2.5])
    assert boundfit.fit(x, lower=lower, upper=upper).vertices == uniform
    assert boundfit.fit(x, y, lower=lower, upper=upper).least_squares == boundfit.fit(x, y, 1).least_squares
    one_sided = boundfit.fit(x, lower=[0, None, 1], upper=[math.nan, 2, 3])
    assert one_sided.kind == "unbounded-polygon" or one_sided.kind == "polygon"
    assert boundfit.fit(x, y, "2*min").epsilon_min == Fraction(1, 4)
    assert boundfit.fit(x, ["0.0", "1.5", "2.0"], "10*written").vertices == uniform


def test_two_regressors_conditions_and_origins() -> None:
    phi = numpy.array([[1, 0], [0, 1], [1, 1]])
    y = ["2", "3", "5.1"]
    expected = boundfit.fit(([1, 0, 1], [0, 1, 1]), y, "0.1", where="theta1 + theta2 >= 5").vertices
    assert len(expected) == 3
    for x in (phi, pandas.DataFrame(phi), polars.DataFrame(phi, schema=["a", "b"]), pyarrow.table({"a": [1, 0, 1], "b": [0, 1, 1]})):
        assert boundfit.fit(x, y, "0.1", where=["theta1 + theta2 >= 5"]).vertices == expected
    years = boundfit.fit([1979, 1980, 1981], [4, 7, 8], 1, x_origin=1980)
    assert years.pui is not None and (years.pui.theta2.lower, years.pui.theta2.upper) == (6, 7)
    with pytest.raises(ValueError, match="with two regressors there is no offset"):
        boundfit.fit(phi, y, 1, through_origin=True)
    with pytest.raises(ValueError, match="x has 3 columns"):
        boundfit.fit(numpy.zeros((3, 3)), y, 1)


def test_names_of_series_are_those_of_reports() -> None:
    frame = pandas.DataFrame({"I": [0.1, 0.2], "U": [1.0, 2.0]})
    document = boundfit.fit(frame["I"], frame["U"], 0.1).to_dict()
    assert (document["input"]["x"], document["input"]["y"]) == (["I"], "U")
    assert boundfit.fit(frame["I"], frame["I"], 0.1).rows == 2


REFUSALS: list[tuple[dict[str, Any], str]] = [
    ({"x": [0, 1], "y": [0, math.nan]}, r'row 2, column 2 \(y\): "NaN": the value is missing.*missing="skip" leaves'),
    ({"x": numpy.array([0, math.inf]), "y": [0, 1]}, r"row 2, column 1 \(x\): \"inf\": not a number: not a finite number"),
    ({"x": [0, 1, 2], "y": [0, 1]}, 'the column "x" has 3 numbers, but "y" has 2'),
    ({"x": [0, "1o"], "y": [0, 1]}, r'row 2, column 1 \(x\): "1o": not a number'),
    ({"x": [0, None], "y": [0, 1]}, r"row 2, column 1 \(x\): \"\": the value is missing"),
    ({"x": [0, pandas.NA], "y": [0, 1]}, "row 2, column 1"),
    ({"x": [0, True], "y": [0, 1]}, "row 2 of x: True is a truth value"),
    ({"x": [0, {}], "y": [0, 1]}, "row 2 of x: dict is not a number"),
    ({"x": [], "y": []}, "readings: the columns are empty"),
    ({"x": 1, "y": [0]}, "x is of type int: expected an array or a list"),
    ({"x": [0], "y": numpy.zeros((2, 2))}, "y has 2 dimensions"),
    ({"x": [0], "y": [0], "eps": -1}, "eps=-1: negative"),
    ({"x": [0], "y": [0], "eps": [-1]}, r"row 1, column 3 \(eps\): \"-1\": the error bound is negative"),
    ({"x": [0], "y": [0], "eps": math.nan}, "eps="),
    ({"x": [0], "y": [0], "eps": "2%"}, "2% of what"),
    ({"x": [0], "y": [0], "eps": None}, "the bound on the errors is missing: eps, eps_column, lower or upper"),
    ({"x": [0], "y": None}, "y is missing"),
    ({"x": [0], "y": [0], "lower": [0]}, "the errors have one bound: eps, or eps_column, or lower and upper"),
    ({"x": [0], "y": None, "eps": None, "lower": [None]}, "row 1"),
    ({"x": [0], "y": [0], "where": "theta3 > 0"}, 'where="theta3 > 0"'),
    ({"x": [0], "y": [0], "reading": "binary"}, 'reading="binary": expected one of "decimal", "binary64"'),
    ({"x": [0], "y": [0], "missing": "drop"}, 'expected one of "refuse", "skip"'),
    ({"x": [0], "y": [0], "eps": "written"}, "stores numbers without their digits|last digit"),
    ({"x": ["1e999999999"], "y": [0]}, "row 1"),
]


@pytest.mark.parametrize(("arguments", "message"), REFUSALS, ids=[str(index) for index in range(len(REFUSALS))])
def test_what_is_wrong_is_told(arguments: dict[str, Any], message: str) -> None:
    if arguments.get("eps") == "written":
        arguments = {**arguments, "y": [0.5]}
    with pytest.raises(ValueError, match=message):
        boundfit.fit(**{"eps": 1, **arguments})


def test_rows_that_lack_a_number_are_left_out_where_that_is_asked_for() -> None:
    fit = boundfit.fit([0, 1, None, 3], [0, math.nan, 2, 3], 1, missing="skip")
    assert (fit.rows, fit.rows_total) == (2, 4)


def test_ends_are_rounded_outward() -> None:
    fit = boundfit.fit([0, 3], [0, 1], 0)
    assert fit.pui is not None
    lower, upper = fit.pui.theta1.lower, fit.pui.theta1.upper
    assert lower == upper == Fraction(1, 3)
    assert Fraction(float(lower)) < Fraction(1, 3) < Fraction(float(upper))
    assert math.nextafter(float(lower), 1) == float(upper)
    for number in (Fraction(1, 10), Fraction(10) ** 400, -(Fraction(10) ** 400), Fraction(1, 10**400), Fraction(3)):
        assert float(boundfit.LowerBound(number.numerator, number.denominator)) <= number
        assert float(boundfit.UpperBound(number.numerator, number.denominator)) >= number
    polygon = boundfit.fit([0, 3, 7], ["0.1", "1.2", "2.4"], "1/7")
    box, points = polygon.pui, polygon.to_numpy()
    assert box is not None and points.shape == (len(polygon.vertices), 2)
    for axis, interval in enumerate(box):
        assert Fraction(points[:, axis].min()) <= interval.lower and Fraction(points[:, axis].max()) >= interval.upper


def test_intervals_are_printed_outward() -> None:
    both = boundfit.fit([0, 3], ["0", "-1e-7"], "1e-9").pui
    assert both is not None
    assert f"{both.theta1:.3}" == "[-3.4e-8, -3.26e-8]" and f"{both.theta1:.20}" == "[-3.4e-8, -3.2666666666666666666e-8]"
    assert f"{both.theta2:.3g}" == "[-1e-9, 1e-9]" and f"{both.theta1}" == str(both.theta1)
    for digits in range(1, 30):
        lower, upper = (Fraction(end) for end in f"{both.theta1:.{digits}}"[1:-1].split(", "))
        assert both.theta1.lower is not None and both.theta1.upper is not None
        assert lower <= both.theta1.lower and both.theta1.upper <= upper
        assert max(both.theta1.lower - lower, upper - both.theta1.upper) < Fraction(10) ** (-7 - digits)
    assert f"{boundfit.Interval(None, boundfit.UpperBound(10**400)):.2}" == "[-inf, 1.0e+400]"
    for spec in ("d", ".0", ".5f", ".99999", "10.3"):
        with pytest.raises(ValueError, match="expected how many digits, such as .5"):
            format(both.theta1, spec)


def test_an_empty_set_is_an_answer() -> None:
    fit = boundfit.fit([0, 1, 2], [0, 1, 0], "0.4")
    assert fit.is_empty and fit.vertices == [] and fit.pui is None and fit.contradiction is not None
    assert [(term.row, term.bound) for term in fit.contradiction] == [(1, "upper"), (2, "lower"), (3, "upper")]
    assert "no parameters agree" in repr(fit) and fit.response(1) is None and (0, 0) not in fit
    assert "<pre" in fit._repr_html_()


def test_what_is_shown() -> None:
    fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], 0.5)
    assert repr(fit) == "<boundfit.Fit of 3 readings: polygon, about theta1 in [0.5, 1.5], theta2 in [-0.5, 0.5]>"
    assert "<svg" in fit._repr_html_() and "FPS" in str(fit) or "easible" in str(fit)
    assert (1, 0) in fit and (1, "1/4") in fit and (2, 0) not in fit


def test_many_readings_are_fitted_in_little_memory() -> None:
    random_numbers = numpy.random.default_rng(3)
    x = random_numbers.uniform(0, 1, 100_000)
    y = 2 * x + random_numbers.uniform(-0.1, 0.1, x.size)
    for reading in ("decimal", "binary64"):
        many = boundfit.fit(x, y, 0.1, reading=reading)  # type: ignore[arg-type]
        hull = numpy.argsort(x)[:: 1]
        assert many.rows == hull.size and many.eui is not None and not many.is_empty
        every = boundfit.fit(x[:9000], y[:9000], 0.1, reading=reading)  # type: ignore[arg-type]
        some = numpy.concatenate([x[:9000], x[:9000]]), numpy.concatenate([y[:9000], y[:9000]])
        assert boundfit.fit(*some, 0.1, reading=reading).vertices == every.vertices  # type: ignore[arg-type]
