"""Answers about files are the program's, byte for byte where they are text."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import boundfit
import pytest

from conftest import FIXTURES, ROOT, Program

# Arguments of fit_file, and the options of the program.
FILES: list[tuple[str, dict[str, Any], list[str]]] = [
    (
        "transducer/transducer.csv",
        {"x": "Vz", "y": "z", "eps": "0.5e-3", "rows": "14..36"},
        ["--x", "Vz", "--y", "z", "--eps", "0.5e-3", "--rows", "14..36"],
    ),
    (
        "transducer/transducer.csv",
        {"x": "Vz", "y": "z", "eps": "1.2*min", "without": "1..13,37..", "where": ["theta1 >= 0"], "reading": "binary64"},
        ["--x", "Vz", "--y", "z", "--eps", "1.2*min", "--without", "1..13,37..", "--where", "theta1 >= 0", "--reading", "binary64"],
    ),
    ("norris/norris.csv", {"x": "x", "y": "y", "eps": 2}, ["--x", "x", "--y", "y", "--eps", "2"]),
    ("norris/norris.csv", {"x": "x", "y": "y", "eps": "1%*|y| + 1"}, ["--x", "x", "--y", "y", "--eps", "1%*|y| + 1"]),
    (
        "steam-generator/steam_generator.csv",
        {"x": "x", "y": "y", "eps": "3", "through_origin": True},
        ["--x", "x", "--y", "y", "--eps", "3", "--through-origin"],
    ),
    ("clock/offset.csv", {"x": 1, "lower": "at_least", "upper": "at_most"}, ["--x", "1", "--lower", "at_least", "--upper", "at_most"]),
    *(
        (
            f"hard-lp/{case.stem}.csv",
            {"x": "x", "y": "y", "eps": json.loads(case.read_text())["eps"], "reading": reading},
            ["--x", "x", "--y", "y", "--eps", json.loads(case.read_text())["eps"], "--reading", reading],
        )
        for case in sorted((FIXTURES / "hard-lp").glob("*.json"))
        for reading in ("decimal", "binary64")
    ),
]


@pytest.mark.parametrize(("file", "arguments", "options"), FILES, ids=lambda own: own if isinstance(own, str) else "")
def test_a_file_is_fitted_like_by_the_program(
    file: str, arguments: dict[str, Any], options: list[str], program: Program, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    path = f"fixtures/{file}"
    fit = boundfit.fit_file(path, **arguments)
    assert fit.to_json() == program("fit", path, *options, "--format", "json")
    for format in ("markdown", "latex", "csv", "wkt", "ine", "ext"):
        if format == "wkt" and not fit.kind == "polygon":
            continue
        assert fit.report(format) == program("fit", path, *options, "--format", format)
    fit.verify()
    document = fit.to_dict()
    assert [tuple(number["exact"] for number in own["theta"]) for own in document["fps"]["vertices"]] == [
        tuple(map(str, vertex)) for vertex in fit.vertices
    ]


@pytest.mark.parametrize("file", ["pyarrow.parquet", "pyarrow.arrow", "polars.parquet", "polars.arrow", "pyarrow.arrows", "readings.csv"])
def test_every_format_gives_the_same_set(file: str) -> None:
    names = (FIXTURES / "arrow" / "readings.csv").read_text().splitlines()[0].split(",")
    fits = [boundfit.fit_file(FIXTURES / "arrow" / own, names[1], names[2], 1) for own in (file, "readings.csv")]
    assert fits[0].vertices == fits[1].vertices


def test_a_proof_of_a_file_is_the_programs_and_is_verified(program: Program, tmp_path: Path) -> None:
    path = FIXTURES / "transducer" / "transducer.csv"
    fit = boundfit.fit_file(path, "Vz", "z", "0.5e-3", rows="14..36")
    own = tmp_path / "proof.json"
    program("fit", path, "--x", "Vz", "--y", "z", "--eps", "0.5e-3", "--rows", "14..36", "--proof", own, "--brief")
    assert fit.proof() == own.read_text()
    assert boundfit.verify(fit.proof(), path)
    assert boundfit.verify(own, path.read_bytes())
    with pytest.raises(ValueError, match="sha256: is not that of the data"):
        boundfit.verify(fit.proof(), path.read_bytes() + b"1,2\n")
    with pytest.raises(ValueError, match="not a proof"):
        boundfit.verify("{}", b"x,y\n")
    names = (FIXTURES / "arrow" / "readings.csv").read_text().splitlines()[0].split(",")
    stored = boundfit.fit_file(FIXTURES / "arrow" / "pyarrow.parquet", names[1], names[2], 1)
    for refused in (stored, stored.status()):
        with pytest.raises(ValueError, match="save (them|the table) as CSV"):
            refused.proof()


def test_figures_and_lesson_are_the_programs(program: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    path = "fixtures/transducer/transducer.csv"
    options = [path, "--x", "Vz", "--y", "z", "--eps", "0.5e-3"]
    fit = boundfit.fit_file(path, "Vz", "z", "0.5e-3")
    for figure in ("data", "eui", "pui", "fps", "corridor", "directions"):
        assert fit.svg(figure) == program("plot", *options, "--figure", figure)
    assert fit.png("fps").startswith(b"\x89PNG")
    look = ["--size", "85mm", "--font-size", "8pt", "--title", "", "--x-label", "slope", "--y-label", "", "--greyscale",
            "--x-range", "0.0017..0.00185", "--y-range", "0.02..0.0235"]  # fmt: skip
    own = {"width": 85, "font_size": 8, "title": "", "x_label": "slope", "y_label": "", "greyscale": True,
           "x_range": ("0.0017", 0.00185), "y_range": (Fraction(1, 50), 0.0235)}  # fmt: skip
    for form in ("svg", "tikz", "tex"):
        assert fit.figure("fps", form, **own).decode() == program("plot", *options, "--format", form, *look)  # type: ignore[arg-type]
    assert fit.figure("data", "pdf").startswith(b"%PDF-")
    assert len(fit.figure("fps", "png", dpi=96)) < len(fit.png())
    for refused, problem in [
        ({"format": "gif"}, 'expected one of "svg", "png", "pdf", "tikz", "tex"'),
        ({"width": 5}, "width=5: expected 10 to 2000 millimetres"),
        ({"font_size": 0.5}, "font_size=0.5: expected 1 to 200 points"),
        ({"width": 30, "font_size": 8}, "27 to 266 times as wide"),
        ({"dpi": 20}, "dpi=20: expected 30 to 1200"),
        ({"x_range": (1, 1)}, "x_range: the lower end is not below the upper one"),
        ({"y_range": ("a", 1)}, "y_range"),
        ({"figure": "status", "x_range": (0, 1)}, 'the axes of "status" are residuals and leverages'),
        ({"directions": 2}, "directions=2: expected 3 to 1000"),
    ]:
        with pytest.raises(ValueError, match=problem):
            fit.figure(**refused)  # type: ignore[arg-type]
    fit.lesson(tmp_path / "lesson.html")
    page = (tmp_path / "lesson.html").read_text(encoding="utf-8")
    assert page.startswith("<!") and "Vz" in page
    with pytest.raises(ValueError, match='expected one of "data"'):
        fit.svg("nothing")


@pytest.mark.parametrize("file", ["house.ine", "house.csv", "segment.ine", "gable.ext", "cone.ext", "empty-by-lrs.ext", "upper-half-by-cdd.ext"])
def test_a_polygon_is_the_programs(file: str, program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    path = f"fixtures/polygon/{file}"
    polygon = boundfit.polygon_file(path)
    assert polygon.to_dict() == json.loads(program("polygon", path, "--format", "json"))
    assert polygon.report("ext") == program("polygon", path, "--format", "ext")


def test_polygons_in_memory() -> None:
    import numpy

    square = boundfit.polygon(numpy.array([[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1.5]]), [1, 0, 1, 0, 9])
    assert square.vertices == [(0, 0), (1, 0), (1, 1), (0, 1)]
    assert square.redundant == [4] and square.area == 1 and (0.5, "1/3") in square and (2, 0) not in square
    assert square.bounds is not None and square.bounds.theta1.upper == 1
    assert boundfit.polygon([[0.1, 0]], [1]).bounds.theta1.upper == 10  # type: ignore[union-attr]
    wider = boundfit.polygon([[0.1, 0]], [1], reading="binary64").bounds
    assert wider is not None and wider.theta1.upper == 1 / Fraction(0.1)
    cone = boundfit.generators([[0, 0]], [[1, 0], [0, 2]])
    assert cone.rays == [(1, 0), (0, 1)] and cone.kind == "unbounded-polygon"
    assert boundfit.generators([], []).is_empty
    assert boundfit.generators([[1, 1]], lines=[[0, 3]]).kind == "line"
    with pytest.raises(ValueError, match='row 2 of A="NaN": not a finite number'):
        boundfit.polygon([[1, 0], [1, float("nan")]], [1, 1])
    with pytest.raises(ValueError, match="A has 1 rows, but b has 2"):
        boundfit.polygon([[1, 0]], [1, 1])


def test_a_reduction_of_memory_is_fitted_like_the_whole(tmp_path: Path) -> None:
    import numpy

    random = numpy.random.default_rng(5)
    x = numpy.round(random.uniform(-5, 5, 30_000), 3)
    y = numpy.round(2 * x + 1 + random.uniform(-0.1, 0.1, x.size), 3)
    whole = boundfit.fit(x, y, 0.1)
    text = boundfit.reduce(x[:17_000], y[:17_000]) + boundfit.reduce(x[17_000:], y[17_000:])
    (tmp_path / "reduced.csv").write_bytes(text)
    reduced = boundfit.fit_file(tmp_path / "reduced.csv", "x", "y", 0.1)
    assert len(text) < 20_000 and reduced.rows == 30_000
    assert (reduced.vertices, reduced.least_squares, reduced.minimax) == (whole.vertices, whole.least_squares, whole.minimax)
    again = boundfit.reduce_file(tmp_path / "reduced.csv", "x", "y")
    (tmp_path / "again.csv").write_bytes(again)
    assert boundfit.fit_file(tmp_path / "again.csv", "x", "y", 0.1).vertices == whole.vertices
