"""Tables that others made, through frames of every library and type: the answer is that of the CSV that the frame writes."""

from __future__ import annotations

import datetime
import numbers
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
import pyarrow.csv
import pytest
import statsmodels.api
import vega_datasets
from boundfit import LowerBound, UpperBound
from sklearn import datasets

# vega_datasets reads its tables in a way that a later pandas will not have.
pytestmark = pytest.mark.filterwarnings("ignore:The 'convert_dates' keyword")

vega = vega_datasets.data
statistics = statsmodels.api.datasets


def of_statsmodels(name: str) -> pandas.DataFrame:
    table: pandas.DataFrame = getattr(statistics, name).load_pandas().data
    return table


# A table, its regressors and its response. Among the columns are integers, missing numbers, long doubles and large numbers.
TABLES: dict[str, tuple[Callable[[], pandas.DataFrame], list[str], str]] = {
    "cars": (vega.cars, ["Horsepower"], "Miles_per_Gallon"),
    "cars, integers": (vega.cars, ["Weight_in_lbs"], "Cylinders"),
    "iris": (vega.iris, ["petalLength", "petalWidth"], "sepalLength"),
    "wheat": (vega.wheat, ["year"], "wages"),
    "anscombe": (vega.anscombe, ["X"], "Y"),
    "driving": (vega.driving, ["miles"], "gas"),
    "employment": (vega.us_employment, ["manufacturing"], "wholesale_trade"),
    "airports": (vega.airports, ["longitude"], "latitude"),
    "weather": (vega.seattle_weather, ["temp_max"], "temp_min"),
    "longley": (lambda: of_statsmodels("longley"), ["GNP"], "TOTEMP"),
    "engel": (lambda: of_statsmodels("engel"), ["income"], "foodexp"),
    "nile": (lambda: of_statsmodels("nile"), ["year"], "volume"),
    "stack loss": (lambda: of_statsmodels("stackloss"), ["AIRFLOW", "WATERTEMP"], "STACKLOSS"),
    "sunspots": (lambda: of_statsmodels("sunspots"), ["YEAR"], "SUNACTIVITY"),
    "diabetes": (lambda: datasets.load_diabetes(as_frame=True).frame, ["bmi", "bp"], "target"),
}


def short(frame: pandas.DataFrame) -> pandas.DataFrame:
    floats = {name: "float32" for name in frame.columns if frame[name].dtype == "float64"}
    return frame.astype(floats)


def short_integers(frame: pandas.DataFrame) -> pandas.DataFrame:
    return frame.astype({name: "int32" for name in frame.columns if frame[name].dtype == "int64"})


def texts(frame: pandas.DataFrame, kind: Any) -> pandas.DataFrame:
    texts: pandas.DataFrame = frame.map(lambda value: None if value != value else repr(value)).astype(kind)
    return texts


def decimals(frame: pandas.DataFrame) -> pandas.DataFrame:
    made: pandas.DataFrame = frame.map(lambda value: None if value != value else Decimal(repr(value)))
    return made


def write_pandas(frame: Any, path: Path) -> None:
    frame.to_csv(path, index=False)


def write_polars(frame: Any, path: Path) -> None:
    frame.write_csv(path)


def write_arrow(frame: Any, path: Path) -> None:
    pyarrow.csv.write_csv(frame, path)


Frame = tuple[Callable[[pandas.DataFrame], Any], Callable[[Any, Path], None]]
FRAMES: dict[str, Frame] = {
    "pandas": (lambda frame: frame, write_pandas),
    "pandas short": (lambda frame: short(short_integers(frame)), write_pandas),
    "pandas half": (lambda frame: frame.clip(-60_000, 60_000).astype("float16"), write_pandas),
    "pandas nullable": (lambda frame: frame.convert_dtypes(), write_pandas),
    "pandas nullable short": (lambda frame: short(frame).convert_dtypes(), write_pandas),
    "pandas of arrow": (lambda frame: frame.convert_dtypes(dtype_backend="pyarrow"), write_pandas),
    # Of Arrow's short floats alone pandas writes the doubles, 0.10000000149011612 for 0.1; Arrow writes them as everyone does.
    "pandas of arrow short": (
        lambda frame: short(frame).convert_dtypes(dtype_backend="pyarrow"),
        lambda frame, path: write_arrow(pyarrow.Table.from_pandas(frame), path),
    ),
    "pandas categories": (lambda frame: frame.astype("category"), write_pandas),
    "pandas texts": (lambda frame: texts(frame, "string"), write_pandas),
    "pandas texts of arrow": (lambda frame: texts(frame, "string[pyarrow]"), write_pandas),
    "pandas decimals": (decimals, write_pandas),
    "polars": (polars.from_pandas, write_polars),
    "polars NaN": (lambda frame: polars.from_pandas(frame, nan_to_null=False), write_polars),
    "polars short": (lambda frame: polars.from_pandas(short(frame)), write_polars),
    "polars texts": (lambda frame: polars.from_pandas(texts(frame, "string")), write_polars),
    "polars categories": (lambda frame: polars.from_pandas(texts(frame, "string")).cast(polars.Categorical), write_polars),
    "pyarrow": (lambda frame: pyarrow.Table.from_pandas(frame, preserve_index=False), write_arrow),
    "pyarrow short": (lambda frame: pyarrow.Table.from_pandas(short(frame), preserve_index=False), write_arrow),
    "pyarrow texts": (lambda frame: pyarrow.Table.from_pandas(texts(frame, "string"), preserve_index=False), write_arrow),
}


def answer(fit: boundfit.Fit) -> dict[str, Any]:
    """All that a report says but where the readings come from."""
    document = fit.to_dict()
    where_from = document.pop("input")
    return {"x": where_from["x"], "y": where_from["y"], **document}


@pytest.mark.parametrize("kind", FRAMES)
@pytest.mark.parametrize("table", TABLES)
def test_a_frame_gives_the_answer_of_the_csv_that_it_writes(table: str, kind: str, tmp_path: Path) -> None:
    load, x, y = TABLES[table]
    make, write = FRAMES[kind]
    frame = make(load()[[*x, y]])
    write(frame, tmp_path / "table.csv")
    regressors = frame[x[0]] if len(x) == 1 else (frame[x[0]], frame[x[1]])
    eps = "1.25*min"
    expected = boundfit.fit_file(tmp_path / "table.csv", x, y, eps, missing="skip")
    fit = boundfit.fit(regressors, frame[y], eps, missing="skip")
    # A column of pyarrow has no name.
    names = {"x": x, "y": y} if isinstance(frame, pyarrow.Table) else {}
    assert {**answer(fit), **names} == answer(expected)
    assert fit.rows > 10 and (fit.rows, fit.rows_total) == (expected.rows, expected.rows_total)


@pytest.mark.parametrize("table", TABLES)
def test_stored_numbers_are_those_of_the_doubles_of_the_csv(table: str, tmp_path: Path) -> None:
    load, x, y = TABLES[table]
    frame = load()[[*x, y]]
    write_pandas(frame, tmp_path / "table.csv")
    expected = answer(boundfit.fit_file(tmp_path / "table.csv", x, y, "1.25*min", missing="skip", reading="binary64"))
    for made in (frame, frame.convert_dtypes(), polars.from_pandas(frame), pyarrow.Table.from_pandas(frame)):
        regressors = made[x[0]] if len(x) == 1 else (made[x[0]], made[x[1]])
        fit = boundfit.fit(regressors, made[y], "1.25*min", missing="skip", reading="binary64")
        assert {**answer(fit), "x": x, "y": y} == {**expected, "x": x, "y": y}


def test_short_floats_are_stored_as_they_are_however_they_come() -> None:
    for kind, stored in (("float32", Fraction(float(numpy.float32(0.1)))), ("float16", Fraction(float(numpy.float16(0.1))))):
        plain = numpy.array([0, 0.1, 0.5], dtype=kind)
        ways = [plain, list(plain), numpy.fromiter(plain, dtype=object), pandas.Series(plain), pyarrow.array(plain), polars.Series(plain)]
        ways += [pyarrow.array(plain).dictionary_encode()] if kind == "float32" else []
        ways += [pandas.Series(plain).astype("Float32"), pandas.Series(plain).astype("float[pyarrow]")] if kind == "float32" else []
        ways += [pandas.Series(plain, dtype="category")] if kind == "float32" else []
        ways += [plain.astype(plain.dtype.newbyteorder(">"))]
        for way in ways:
            for reading, tenth in (("decimal", Fraction(1, 10)), ("binary64", stored)):
                fit = boundfit.fit([0, 1, 5], way, 0, reading=reading)  # type: ignore[arg-type]
                assert fit.vertices == ([(tenth, 0)] if tenth == Fraction(1, 10) else []), (type(way), kind, reading)
                assert boundfit.fit([0, 1], way[:2], 0, reading=reading).vertices == [(tenth, 0)]  # type: ignore[arg-type]


def test_what_is_masked_is_missing() -> None:
    for kind in ("float64", "float32", "int64"):
        masked = numpy.ma.masked_array(numpy.array([0, 99, 1], dtype=kind), [False, True, False])
        with pytest.raises(ValueError, match="row 2, column 2 .*missing"):
            boundfit.fit([0, 1, 2], masked, 0)
        assert boundfit.fit([0, 1, 2], masked, 0, missing="skip").vertices == [(Fraction(1, 2), 0)]
    assert boundfit.fit([0, 1], numpy.ma.masked_array([0, 1]), 0).vertices == [(1, 0)]


def test_large_integers_that_lack_one_are_exact() -> None:
    large = 2**53 + 1
    for column in (
        pandas.Series([0, None, large], dtype="Int64"),
        pandas.Series([0, None, large], dtype="int64[pyarrow]"),
        polars.Series([0, None, large]),
        polars.Series([0, None, large], dtype=polars.Int128),
        pyarrow.array([0, None, large]),
    ):
        assert boundfit.fit([0, 5, 1], column, 0, missing="skip").vertices == [(large, 0)]
    assert boundfit.fit([0, 1], polars.Series([0, 2**100], dtype=polars.Int128), 0).vertices == [(2**100, 0)]


def test_one_column_of_a_frame_may_be_a_frame() -> None:
    table = {"a": [0.0, 1.0], "b": [1.0, 3.0]}
    for frame in (pandas.DataFrame(table), polars.DataFrame(table), pyarrow.table(table)):
        column = frame[["b"]] if not isinstance(frame, pyarrow.Table) else frame.select(["b"])
        assert boundfit.fit([0, 1], column, 0).vertices == [(2, 1)]
        with pytest.raises(ValueError, match="y has 2 columns: expected one"):
            boundfit.fit([0, 1], frame, 0)


def test_arrays_of_other_libraries_are_arrays() -> None:
    class Array:
        def __init__(self, values: Any) -> None:
            self.values = values

        def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
            return self.values

    short = numpy.array([0, 0.1], dtype="float32")
    assert boundfit.fit([0, 1], Array(short), 0).vertices == [(Fraction(1, 10), 0)]
    assert boundfit.fit([0, 1], Array(short), 0, reading="binary64").vertices == [(Fraction(float(short[1])), 0)]
    with pytest.raises(ValueError, match="y has 2 dimensions: expected a column"):
        boundfit.fit([0, 1], Array(numpy.zeros((2, 2))), 0)
    with pytest.raises(ValueError, match="y holds times"):
        boundfit.fit([0, 1], Array(numpy.array(DAYS[:2], dtype="datetime64[s]")), 0)


DAYS = [datetime.datetime(2020, 1, day) for day in (1, 2, 3)]
TIMES: dict[str, Any] = {
    "pandas": pandas.Series(DAYS),
    "pandas index": pandas.DatetimeIndex(DAYS),
    "pandas zone": pandas.Series(DAYS).dt.tz_localize("Europe/Rome"),
    "pandas spans": pandas.Series(DAYS) - DAYS[0],
    "pandas of arrow": pandas.Series(DAYS).astype("timestamp[us][pyarrow]"),
    "numpy": numpy.array(DAYS, dtype="datetime64[us]"),
    # Its list is one of integers: nanoseconds, which nobody asked for.
    "numpy spans": numpy.array([1, 2, 3], dtype="timedelta64[ns]"),
    "numpy nanoseconds": numpy.array(DAYS, dtype="datetime64[ns]"),
    "polars": polars.Series(DAYS),
    "polars dates": polars.Series(DAYS, dtype=polars.Date),
    "polars spans": polars.Series([datetime.timedelta(1)] * 3),
    "pyarrow": pyarrow.array(DAYS),
    "pyarrow dates": pyarrow.array(DAYS, pyarrow.date32()),
}


@pytest.mark.parametrize("kind", TIMES)
def test_times_are_refused(kind: str) -> None:
    with pytest.raises(ValueError, match=r"^x holds times \(.*\), not numbers: expected numbers, such as"):
        boundfit.fit(TIMES[kind], [1, 2, 3], 1)


def test_foreign_columns_of_times_and_words_are_refused_as_their_csv_is(tmp_path: Path) -> None:
    iowa = vega.iowa_electricity()
    with pytest.raises(ValueError, match="x holds times"):
        boundfit.fit(iowa["year"], iowa["net_generation"], 1)
    cars = vega.cars()
    write_pandas(cars, tmp_path / "cars.csv")
    with pytest.raises(ValueError, match='line 2, column 9 .Origin.: "USA": not a number'):
        boundfit.fit_file(tmp_path / "cars.csv", "Origin", "Acceleration", 1)
    for words in (cars["Origin"], cars["Origin"].astype("category"), cars["Origin"].astype("string[pyarrow]")):
        with pytest.raises(ValueError, match='row 1, column 1 .Origin.: "USA": not a number'):
            boundfit.fit(words, cars["Acceleration"], 1)
    with pytest.raises(ValueError, match='row 1, column 1 .x.: "USA": not a number'):
        boundfit.fit(pyarrow.Table.from_pandas(cars)["Origin"], cars["Acceleration"], 1)
    with pytest.raises(ValueError, match='row 1, column 1 .Origin.: "USA": not a number'):
        boundfit.fit(polars.from_pandas(cars)["Origin"].cast(polars.Categorical), cars["Acceleration"], 1)
    # The first car whose consumption nobody wrote down.
    first = int(cars["Miles_per_Gallon"].isna().to_numpy().argmax()) + 1
    with pytest.raises(ValueError, match=rf"row {first}, column 2 .Miles_per_Gallon.: \"NaN\": the value is missing, and in 7 rows more"):
        boundfit.fit(cars["Weight_in_lbs"], cars["Miles_per_Gallon"], 1)


@pytest.mark.parametrize("infinite", [numpy.inf, -numpy.inf])
def test_infinities_are_refused_everywhere(infinite: float) -> None:
    engel = of_statsmodels("engel")
    engel.loc[7, "income"] = infinite
    for frame in (engel, engel.convert_dtypes(), short(engel), polars.from_pandas(engel), pyarrow.Table.from_pandas(engel)):
        for missing in ("refuse", "skip"):
            with pytest.raises(ValueError, match=r'row 8, column 1 \(.*\): "-?inf": not a number: not a finite number'):
                boundfit.fit(frame["income"], frame["foodexp"], 1, missing=missing)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "column", [{1, 2}, {0: 1, 1: 2}, "12", b"12", polars.LazyFrame({"a": [1, 2]}), polars.col("a"), pyarrow.scalar(1), pandas.Timestamp(0)], ids=str
)
def test_what_has_no_order_is_no_column(column: Any) -> None:
    with pytest.raises(ValueError, match="y is of type .*: expected an array or a list of numbers"):
        boundfit.fit([1, 2], column, 1)


def test_groups_of_foreign_tables() -> None:
    cars = vega.cars()
    expected = boundfit.fit_groups(cars, by="Origin", x="Weight_in_lbs", y="Miles_per_Gallon", eps="1.1*min", missing="skip")
    # In the order of their first rows, complete or not.
    assert list(expected["Origin"]) == ["USA", "Europe", "Japan"]
    categories = cars.astype({"Origin": "category"}).convert_dtypes()
    for frame in (categories, polars.from_pandas(cars), pyarrow.Table.from_pandas(cars)):
        groups = boundfit.fit_groups(frame, by="Origin", x="Weight_in_lbs", y="Miles_per_Gallon", eps="1.1*min", missing="skip")
        columns = groups.to_pydict() if isinstance(groups, pyarrow.Table) else groups.to_dict()
        for name in ("Origin", "kind", "theta1_lower_exact", "theta2_upper_exact"):
            column = columns[name]
            assert list(column.values() if isinstance(column, dict) else column) == list(expected[name])
    # A key that is missing is one of its own, also where it refuses to be compared.
    frame = pandas.DataFrame({"key": pandas.array([1, None, 1], dtype="Int64"), "x": [0, 0, 1], "y": [1, 2, 3]})
    keys = list(boundfit.fit_groups(frame, by="key", x="x", y="y", eps=1)["key"])
    assert keys[0] == 1 and len(keys) == 2 and pandas.isna(keys[1])


class Binary:
    """As the floats of mpmath and of sympy: a binary number that prints fewer digits than it has."""

    def __init__(self, sign: int, magnitude: int, exponent: int) -> None:
        self._mpf_ = sign, magnitude, exponent, magnitude.bit_length()

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        return "0.3"

    @property
    def value(self) -> Fraction:
        sign, magnitude, exponent, _ = self._mpf_
        return (-1) ** sign * magnitude * Fraction(2) ** exponent


numbers.Real.register(Binary)


def test_long_binary_floats_are_what_they_hold() -> None:
    third = Binary(0, 3**99, -300)
    for reading in ("decimal", "binary64"):
        fit = boundfit.fit([0, 1], [0, third], 0, reading=reading)
        assert fit.vertices == [(third.value, 0)]
    assert boundfit.fit([0, 1], [0, Binary(1, 5, 3)], 0).vertices == [(-40, 0)]
    assert boundfit.fit([0, 1], [0, Binary(0, 0, 0)], third).epsilon_min == 0
    assert boundfit.fit([0], [0], third).response(0) == boundfit.Interval(LowerBound(-third.value), UpperBound(third.value))
    with pytest.raises(ValueError, match=r"^row 2 of y: a number of more than 10000 digits \(the limit\)$"):
        boundfit.fit([0, 1], [0, Binary(0, 1, 10**12)], 0)


class Printing:
    """Prints fewer digits than it has."""

    def __float__(self) -> float:
        return 0.123

    def __str__(self) -> str:
        return "0.1"


class OwnInt(int):
    __str__ = Printing.__str__


class OwnDecimal(Decimal):
    __str__ = Printing.__str__


class OwnFraction(Fraction):
    __str__ = Printing.__str__


class Ratio(Printing):
    def as_integer_ratio(self) -> tuple[int, int]:
        return 123, 1000


@pytest.mark.parametrize(
    ("number", "value"),
    [(OwnInt(3), 3), (OwnDecimal("0.25"), Fraction(1, 4)), (OwnFraction(1, 3), Fraction(1, 3)), (Ratio(), Fraction(123, 1000))],
)
def test_a_number_is_what_it_holds_and_not_what_it_prints(number: Any, value: Fraction) -> None:
    for reading in ("decimal", "binary64"):
        how: dict[str, Any] = {"reading": reading}
        assert boundfit.fit([0, 1], [0, number], 0, **how).vertices == [(value, 0)]
        assert boundfit.fit([0], [0], number, **how).response(0) == boundfit.Interval(LowerBound(-value), UpperBound(value))


def test_what_only_prints_a_number_is_refused() -> None:
    with pytest.raises(ValueError, match=r'^row 2 of y: "0.1" is what an object of type Printing prints, which may be rounded \(expected an int, '):
        boundfit.fit([0, 1], [0, Printing()], 0)


@pytest.mark.parametrize("kind", ["f2", "f4", "f8", "g"])
def test_print_options_of_numpy_change_no_number(kind: str) -> None:
    column = numpy.array([0, 0.12345679], kind)
    tiny = numpy.array([0, 1], kind) * numpy.dtype(kind).type(6e-5)

    def found() -> list[Any]:
        fits = [boundfit.fit([0, 1], own, 0).vertices for own in (column, list(column), tiny, list(tiny))]
        return [*fits, boundfit.fit([0], [0], column[1]).vertices, boundfit.fit([0, 1], list(column), 0, reading="binary64").vertices]

    expected = found()
    assert expected[0] == expected[1] and expected[2] == expected[3]
    with numpy.printoptions(legacy="1.13", precision=3):
        assert found() == expected


class PintQuantity:
    """As a scalar of pint."""

    def __init__(self, magnitude: Any, units: str) -> None:
        self.magnitude, self.units = magnitude, units

    def __float__(self) -> float:
        return float(self.magnitude)

    def __str__(self) -> str:
        return "1.235"


def test_a_quantity_of_pint_is_its_magnitude(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(PintQuantity, "__module__", "pint.registry")
    value = Fraction("1.23456789")
    for units in ("", "dimensionless"):
        for magnitude in (1.23456789, Decimal("1.23456789")):
            assert boundfit.fit([0, 1], [0, PintQuantity(magnitude, units)], 0).vertices == [(value, 0)]
            assert boundfit.fit([0], [0], PintQuantity(magnitude, units)).response(0) == boundfit.Interval(LowerBound(-value), UpperBound(value))
    with pytest.raises(ValueError, match=r'^row 2 of y: 1.235 has the unit mm: expected a number without one, such as that of m_as\("mm"\)$'):
        boundfit.fit([0, 1], [0, PintQuantity(1.5, "mm")], 0)


def test_short_floats_stay_short_in_categories_and_runs() -> None:
    import pyarrow.compute

    short = numpy.array([0, 0.1, 0.1, 0.3], dtype="float32")
    expected = boundfit.fit([0, 1, 2, 3], short, "1/10").vertices
    runs = pyarrow.compute.run_end_encode(pyarrow.array(short))
    columns = [pandas.Categorical(short), pandas.CategoricalIndex(short), pandas.Series(pandas.Categorical(short)), runs, pyarrow.chunked_array([runs])]
    for column in columns:
        assert boundfit.fit([0, 1, 2, 3], column, "1/10").vertices == expected
    gap = pyarrow.compute.run_end_encode(pyarrow.array([0, None, 0.1], pyarrow.float32()))
    for column in (gap, pandas.Categorical(numpy.array([0, None, 0.1], dtype="float32"))):
        assert boundfit.fit([0, 1, 2], column, 0, missing="skip").vertices == [(Fraction(1, 20), 0)]
