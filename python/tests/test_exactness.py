"""One number, one meaning: exact types are exact whatever the reading is, and a float means the same wherever it is given."""

from __future__ import annotations

import copy
import io
import math
import pickle
from concurrent.futures import ProcessPoolExecutor
from decimal import Decimal
from fractions import Fraction
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Literal

import boundfit
import numpy
import pandas
import polars
import pyarrow
import pytest
from boundfit._reduction import readings
from boundfit.sklearn import BoundedErrorRegressor
from pyarrow import parquet

THIRD = Fraction(1, 3)
TENTH = Fraction(1, 10)


def test_the_least_bound_of_readings_as_stored_leaves_a_set() -> None:
    random = numpy.random.default_rng(1)
    for _ in range(200):
        x, y = random.normal(size=10), random.normal(size=10)
        least = boundfit.fit(x, y, 10, reading="binary64").epsilon_min
        assert least is not None
        tight = boundfit.fit(x, y, least, reading="binary64")
        assert not tight.is_empty and tight.epsilon_min == least
        assert not BoundedErrorRegressor(eps=least).fit(x.reshape(-1, 1), y).fit_.is_empty


@pytest.mark.parametrize("rows", [64, 65, 2_001, 10_000])
def test_readings_in_memory_have_an_eui_without_asking(rows: int) -> None:
    random = numpy.random.default_rng(rows)
    x = random.normal(size=rows)
    y = 2 * x + random.uniform(-1, 1, rows)
    asked, saved = boundfit.fit(x, y, 1), boundfit.fit(x, y, 1, eui=False)
    assert asked.eui is not None and saved.eui == asked.eui
    assert saved.to_json() == asked.to_json()


@pytest.mark.parametrize("third", [THIRD, "1/3"])
def test_exact_types_are_exact_under_either_reading(third: Any) -> None:
    for reading in ("decimal", "binary64"):
        how: dict[str, Any] = {"reading": reading}
        assert boundfit.fit([0, 1], [0, 0], third, **how).vertices[0] == (-2 * THIRD, THIRD)
        assert boundfit.fit([0, 1], [0, third], 0, **how).vertices == [(THIRD, 0)]
        assert boundfit.fit([0, 1], [0, 0], [third, third], **how).vertices[0] == (-2 * THIRD, THIRD)
        assert boundfit.fit([0, 1], lower=[0, third], upper=[0, third], **how).vertices == [(THIRD, 0)]
        assert boundfit.fit([1, 2], [0, 0], 1, x_origin=third, **how).response(third) is not None
        assert boundfit.fit([0, 1], [0, 0], 1, where="theta1 >= 1/3", **how).pui.theta1.lower == THIRD  # type: ignore[union-attr]
        assert boundfit.fit([0, 1], [0, Decimal("0.1")], 0, **how).vertices == [(TENTH, 0)]
        assert boundfit.fit([0, 1], pandas.Series([0, Decimal("0.1")]), 0, **how).vertices == [(TENTH, 0)]
        assert boundfit.fit([0, 1], polars.Series(["0", "0.1"]), 0, **how).vertices == [(TENTH, 0)]
        assert boundfit.fit([0, 1], [0, 10**40 + 1], 0, **how).vertices == [(10**40 + 1, 0)]


def test_floats_beside_exact_numbers_are_what_is_stored() -> None:
    stored = Fraction(0.1)
    for other in (THIRD, "1/3", Decimal("0.3"), 2**53 + 1):
        for column in ([0.1, other], pandas.Series([0.1, other], dtype=object)):
            fit = boundfit.fit([0, 1], column, 0, reading="binary64")
            assert fit.vertices == [(Fraction(other) - stored, stored)]
        of_columns = boundfit.fit([0.0, 0.1], [0, other], 0, reading="binary64")
        assert of_columns.vertices == [(Fraction(other) / stored, 0)]
        assert of_columns.reading == "binary64" and (Fraction(other) / stored, 0) in of_columns
        # What proofs are about says the same numbers.
        assert boundfit.verify(of_columns.proof(), of_columns.to_csv())
        of_columns.verify()
    short = numpy.array([0, 0.1], dtype="float32")
    assert boundfit.fit(short, [0, THIRD], 0, reading="binary64").vertices == [(THIRD / Fraction(float(short[1])), 0)]
    assert boundfit.fit([0.1, 0.2], [0.1, 0.2], 0, reading="binary64").to_csv() == b"x,y\n0.1,0.1\n0.2,0.2\n"
    gaps = boundfit.fit([0.1, None, 0.3], [THIRD, 1, 2], 1, reading="binary64", missing="skip")
    assert (gaps.rows, gaps.rows_total) == (2, 3)


def test_reductions_of_parts_that_are_read_differently_go_together() -> None:
    own = readings("x", "y", 0.1, reading="binary64")
    halves, others = [("0.5", 0.1), ("1.5", 0.2)], [("1/3", 0.3), ("0.1", 0.4)]
    from boundfit._reduction import Reduction, merged, reduce_columns

    texts = [reduce_columns([("x", [x for x, _ in part]), ("y", [y for _, y in part])], own) for part in (halves, others)]
    assert [b'"reading":"binary64"' in text for text in texts] == [True, False]
    fit = Reduction(merged(texts, own), own).fit()
    x, y = zip(*halves, *others, strict=True)
    assert fit.vertices == boundfit.fit(list(x), list(y), 0.1, reading="binary64").vertices
    assert fit.epsilon_min == boundfit.fit(list(x), list(y), 0.1, reading="binary64").epsilon_min


READINGS: list[Literal["decimal", "binary64"]] = ["decimal", "binary64"]


@pytest.mark.parametrize("reading", READINGS)
def test_a_float_means_the_same_wherever_it_is_given(reading: Literal["decimal", "binary64"]) -> None:
    tenth = TENTH if reading == "decimal" else Fraction(0.1)
    fit = boundfit.fit([0, 1, 2], [0, 0.1, 0.2], 0, reading=reading)
    assert fit.vertices == [(tenth, 0)]
    assert (0.1, 0) in fit and (numpy.float64(0.1), 0) in fit
    assert ("0.1", 0) in fit if reading == "decimal" else ("0.1", 0) not in fit
    assert ((numpy.float32(0.1), 0) in fit) == (reading == "decimal")
    pui = fit.pui
    assert pui is not None and 0.1 in pui.theta1 and tenth in pui.theta1
    assert ("0.1" in pui.theta1) == (reading == "decimal")
    line = boundfit.fit([0, 1], [0, 1], 0, reading=reading)
    for asked in (line.response(0.1), line.predict(0.1).at[0].line, line.predict([0.1, THIRD]).at[0].line, line.predict(grid=(0.1, 0.7, 2)).at[0].line):
        assert asked is not None and asked.lower == asked.upper == tenth and 0.1 in asked
    assert line.predict(from_=0.1, new_eps=0.1).from_[0].x[0].upper == 2 * tenth
    assert line.predict(1, new_eps=0.1).at[0].reading == boundfit.Interval(boundfit.LowerBound(1 - tenth), boundfit.UpperBound(1 + tenth))
    assert boundfit.fit([0, 1], [0, 0], 0.1, reading=reading).vertices[0] == (-2 * tenth, tenth)
    assert boundfit.fit([0, 1], [0, 1], 0, x_origin=0.1, reading=reading).vertices == [(1, tenth)]
    assert boundfit.fit([0, 1], [0, 0], 0, x_eps=0.1, reading=reading).pui is not None
    both = boundfit.fit(([1, 0], [0, 1]), [0.1, 1], 0, reading=reading)
    assert (0.1, 1) in both and both.response(0.1, 0) == boundfit.Interval(boundfit.LowerBound(tenth**2), boundfit.UpperBound(tenth**2))
    square = boundfit.polygon([[1, 0], [-1, 0], [0, 1], [0, -1]], [0.1, -0.1, 0, 0], reading=reading)
    assert square.vertices == [(tenth, 0)] and (0.1, 0) in square
    windows = boundfit.windows([0.0, 0.1, 0.2], [0, 1, 2], 1, window_x=0.1, reading=reading)
    assert [own.rows for own in windows][1] == 2


def test_a_float_beside_a_file_of_doubles_is_what_is_stored(tmp_path: Path) -> None:
    frame = pandas.DataFrame({"x": [0.0, 1.0, 2.0], "y": [0.0, 0.7, 1.0]})
    frame.to_csv(tmp_path / "doubles.csv", index=False)
    stored = boundfit.fit_file(tmp_path / "doubles.csv", "x", "y", 0.1, reading="binary64")
    assert stored.vertices == boundfit.fit(frame["x"], frame["y"], 0.1, reading="binary64").vertices
    exact = boundfit.fit_file(tmp_path / "doubles.csv", "x", "y", stored.epsilon_min, reading="binary64")
    assert not exact.is_empty and exact.epsilon_min == stored.epsilon_min


def stamps() -> numpy.ndarray[Any, Any]:
    """Stamps in microseconds with quarters: every second quarter lies between two shortest texts."""
    return 1.7e15 + numpy.random.default_rng(0).integers(0, 4_000_000, 20_000) / 4


def test_the_shortest_text_of_a_tie_is_that_of_python(tmp_path: Path) -> None:
    values = stamps()
    rest = numpy.arange(float(len(values)))
    expected = [repr(value) for value in values.tolist()]

    def texts(fit: boundfit.Fit) -> list[str]:
        return [line.split(",")[0] for line in fit.to_csv().decode().splitlines()[1:]]

    for column in (values, values.tolist(), [*values.tolist()[:-1], expected[-1]], pandas.Series(values), polars.Series(values), pyarrow.array(values)):
        assert texts(boundfit.fit(column, rest, 1e9, eui=False)) == expected
    # Numbers of every size, and those between two floats of 32 bits.
    random = numpy.random.default_rng(7)
    many = random.integers(0, 2**63, 20_000).view(numpy.float64)
    ties = numpy.concatenate([numpy.ldexp(random.integers(2**52, 2**53, 2000).astype(float), -k) for k in range(1, 30)])
    for values in (many[numpy.isfinite(many)], ties):
        found = boundfit.fit(numpy.arange(float(len(values))), values, "1e400", eui=False).to_csv().decode().splitlines()[1:]
        assert [Fraction(line.split(",")[1]) for line in found] == [Fraction(repr(value)) for value in values.tolist()]
    short = (random.integers(2**23, 2**24, 5000) / 8).astype("float32")
    found = boundfit.fit(short, numpy.arange(5000.0), "1e9", eui=False).to_csv().decode().splitlines()[1:]
    assert [Fraction(line.split(",")[0]) for line in found] == [Fraction(str(value)) for value in short]


def test_a_frame_of_ties_gives_the_answer_of_its_files(tmp_path: Path) -> None:
    frame = pandas.DataFrame({"t": stamps()[:500], "u": numpy.arange(500.0)})
    expected = boundfit.fit(frame["t"], frame["u"], 400)
    polars.from_pandas(frame).write_csv(tmp_path / "polars.csv")
    frame.to_csv(tmp_path / "pandas.csv", index=False)
    frame.to_parquet(tmp_path / "frame.parquet")
    parquet.write_table(pyarrow.table({"t": frame["t"].to_numpy(), "u": frame["u"].to_numpy()}), tmp_path / "arrow.parquet", compression="zstd")
    for name in ("polars.csv", "pandas.csv", "frame.parquet", "arrow.parquet"):
        fit = boundfit.fit_file(tmp_path / name, "t", "u", 400)
        assert (fit.vertices, fit.least_squares) == (expected.vertices, expected.least_squares), name
        reduced = tmp_path / f"{name}.reduced"
        reduced.write_bytes(boundfit.reduce_file(tmp_path / name, "t", "u"))
        assert boundfit.fit_file(reduced, "t", "u", 400).vertices == expected.vertices, name


def test_bounds_are_formatted_and_rounded_outward() -> None:
    lower, upper = boundfit.LowerBound(1, 3), boundfit.UpperBound(1, 3)
    assert (f"{lower:.3f}", f"{upper:.3f}") == ("0.333", "0.334")
    assert (f"{lower:.2e}", f"{upper:.2e}") == ("3.33e-1", "3.34e-1")
    assert (f"{lower:.3g}", f"{upper:.3}") == ("0.333", "0.334")
    assert (f"{lower:.1%}", f"{upper:.1%}") == ("33.3%", "33.4%")
    assert (f"{lower}", str(upper), f"{upper:>6}", f"{upper:f}") == ("1/3", "1/3", "   1/3", "0.333334")
    assert f"{boundfit.UpperBound(-1, 3):+8.2f}|" == "   -0.33|" and f"{boundfit.LowerBound(-1, 3):.2f}" == "-0.34"
    assert f"{boundfit.UpperBound(12345678, 10):,.0f}" == "1,234,568"
    assert (f"{boundfit.UpperBound(100):.3g}", f"{boundfit.LowerBound(1, 2):.4g}", f"{boundfit.LowerBound(0):.2f}") == ("100", "0.5", "0.00")
    assert (round(lower, 3), round(upper, 3)) == (Fraction(333, 1000), Fraction(334, 1000))
    assert isinstance(round(lower, 3), boundfit.LowerBound) and isinstance(round(upper, 3), boundfit.UpperBound)
    assert (round(lower), round(upper), round(boundfit.UpperBound(1234), -2)) == (0, 1, 1300)
    random = numpy.random.default_rng(3)
    for numerator, denominator, digits in random.integers([-(10**12), 1, 0], [10**12, 10**9, 15], (3000, 3)).tolist():
        value = Fraction(numerator, denominator)
        for kind in "feg":
            down, up = (Fraction(format(end(numerator, denominator), f".{digits}{kind}")) for end in (boundfit.LowerBound, boundfit.UpperBound))
            assert down <= value <= up
            unit = Fraction(10) ** -digits if kind == "f" else abs(up) * Fraction(10) ** -(digits if kind == "e" else max(digits, 1) - 1)
            assert value - down <= max(unit, abs(down)) and up - down <= 2 * unit + Fraction(10) ** -digits * (kind == "g") * abs(value)
        assert Fraction(float(boundfit.LowerBound(value))) <= value <= Fraction(float(boundfit.UpperBound(value)))
    for spec in ("d", "x", ".3n", "3f3"):
        with pytest.raises(ValueError, match="expected one of a float, such as .3f"):
            format(upper, spec)
    interval = boundfit.Interval(lower, None)
    low, high = interval
    assert (low, high) == (lower, None)
    assert repr(boundfit.fit([0, 3], [0, 1], 0).pui) == "<boundfit.Intervals: about theta1 in [0.333333, 0.333334], theta2 in [0, 0]>"


def test_a_refuted_proof_is_an_error(tmp_path: Path) -> None:
    fit = boundfit.fit([0, 1, 2], [0.1, 1.5, 2], "1/2")
    proof, data = fit.proof(), fit.to_csv(tmp_path / "readings.csv")
    assert boundfit.verify(proof, data) and boundfit.verify(proof, tmp_path / "readings.csv")
    with pytest.raises(ValueError, match="the proof is not true of the data: "):
        boundfit.verify(proof, data.replace(b"1.5", b"1.6"))
    with pytest.raises(ValueError, match="the proof is not true of the data: "):
        boundfit.verify(proof.replace('"1/2"', '"1/3"'), data)
    with pytest.raises(ValueError, match="data is the text of a table: expected its bytes"):
        boundfit.verify(proof, data.decode())
    with pytest.raises(ValueError):
        boundfit.verify("{}", data)


def fitted(numbers: list[float]) -> boundfit.Fit:
    return boundfit.fit(numbers, [2 * number for number in numbers], "0.5")


def test_fits_are_pickled_and_copied(tmp_path: Path) -> None:
    pandas.DataFrame({"x": [0, 1, 2], "y": [0, 1.5, 2]}).to_csv(tmp_path / "table.csv", index=False)
    reduced = tmp_path / "reduced.csv"
    reduced.write_bytes(boundfit.reduce([0, 1, 2], [0, 1.5, 2]))
    short = numpy.array([0, 0.1, 0.3], dtype="float32")
    for fit in (
        boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2", where="theta1 >= 0", eui=False),
        boundfit.fit([0.1, None, 2], ["1/3", 1, 2], Fraction(7, 3), missing="skip", reading="binary64"),
        boundfit.fit(short, numpy.array([1, 2, 3]), [0.5, 0.5, 0.75], confidence=0.99),
        boundfit.fit(([1, 0, 1], [0, 1, 1]), ["2", "3", "5.1"], Decimal("0.1")),
        boundfit.fit_file(tmp_path / "table.csv", "x", "y", 0.5, without="2"),
        boundfit.fit_file(reduced, "x", "y", 1),
    ):
        again = pickle.loads(pickle.dumps(fit))
        assert type(again) is boundfit.Fit and again.to_dict() == fit.to_dict()
        assert (again.vertices, again.pui, again.eui, again.reading, again.guarantee) == (fit.vertices, fit.pui, fit.eui, fit.reading, fit.guarantee)
        assert copy.copy(fit) is fit and copy.deepcopy({"fit": fit})["fit"].vertices == fit.vertices
    fit = fitted([0.0, 1.0, 2.0])
    for answer in (fit.predict(3), fit.status(), fit.outliers(), fit.range(), boundfit.fit([0, 1], [0, 1], 1, x_eps="1/10")):
        assert pickle.loads(pickle.dumps(answer)).to_json() == answer.to_json()
        assert copy.deepcopy(answer).report() == answer.report()
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        for found, numbers in zip(pool.map(fitted, [[0.0, 1.0], [0.0, 2.0, 3.0]]), [[0.0, 1.0], [0.0, 2.0, 3.0]], strict=True):
            assert found.vertices == fitted(numbers).vertices
    joblib = pytest.importorskip("joblib")
    assert [own.rows for own in joblib.Parallel(n_jobs=2)(joblib.delayed(fitted)([0.0, 1.0]) for _ in range(2))] == [2, 2]
    buffer = io.BytesIO()
    joblib.dump(fit, buffer)
    buffer.seek(0)
    assert joblib.load(buffer).vertices == fit.vertices


def test_reduced_fits_are_pickled() -> None:
    from boundfit._reduction import Reduction, reduce_columns

    own = readings("x", "y", 0.5, id="id")
    reduction = Reduction(reduce_columns([("x", [0, 1, 2]), ("y", [0, 1.5, 2]), ("id", ["a", "b", "c"])], own), own)
    fit = reduction.fit()
    again = pickle.loads(pickle.dumps(fit))
    assert type(again) is type(fit) and (again.ids, again.pui, again.rows) == (fit.ids, fit.pui, 3)
    assert pickle.loads(pickle.dumps(reduction)) == reduction


def test_the_version_is_that_of_the_package() -> None:
    from importlib.metadata import version

    assert boundfit.__version__ == version("boundfit")
    assert not math.isnan(float(boundfit.__version__.split(".")[0]))
