"""What is asked of readings is answered as by the program, byte for byte of files, and of columns with the same numbers."""

from __future__ import annotations

import csv
import json
import math
import pickle
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any, get_type_hints

import boundfit
import numpy
import pandas
import pytest

from conftest import FIXTURES, ROOT, Program

TRANSDUCER = ("transducer/transducer.csv", "Vz", "z")

# A file with its columns of x and y, arguments of fit_file, and the options of the program.
FILES: list[tuple[tuple[str, Any, str | None], dict[str, Any], list[str]]] = [
    (TRANSDUCER, {"eps": "0.5e-3", "rows": "14..36"}, ["--eps", "0.5e-3", "--rows", "14..36"]),
    (TRANSDUCER, {"eps": "0.5e-3"}, ["--eps", "0.5e-3"]),
    (TRANSDUCER, {"eps": "1.2*min", "reading": "binary64"}, ["--eps", "1.2*min", "--reading", "binary64"]),
    (
        TRANSDUCER,
        {"eps": "1%*|y| + 1e-3", "where": ["theta1 >= 0"], "without": "1..13"},
        ["--eps", "1%*|y| + 1e-3", "--where", "theta1 >= 0", "--without", "1..13"],
    ),
    (("norris/norris.csv", "x", "y"), {"eps": 2}, ["--eps", "2"]),
    (("steam-generator/steam_generator.csv", "x", "y"), {"eps": "3", "through_origin": True}, ["--eps", "3", "--through-origin"]),
    (("clock/offset.csv", 1, None), {"lower": "at_least", "upper": "at_most"}, ["--lower", "at_least", "--upper", "at_most"]),
]
NAMES = ["feasible", "contradicting", "multiple", "law", "norris", "origin", "intervals"]

# A question of a fit, and the command of the program with its options; which of the files it is asked about.
QUESTIONS: dict[str, tuple[Callable[[boundfit.Fit], boundfit.Answer], list[str]]] = {
    "status": (lambda fit: fit.status(), ["status"]),
    "repair": (lambda fit: fit.status(repair=True), ["status", "--repair"]),
    "at": (lambda fit: fit.predict(at=["3.7", "9/2"], new_eps="0.1"), ["predict", "--at", "3.7,9/2", "--new-eps", "0.1"]),
    "from": (lambda fit: fit.predict(from_="0.012", new_eps="0.1"), ["predict", "--from", "0.012", "--new-eps", "0.1"]),
    "grid": (lambda fit: fit.predict(grid=("-1", 2, 7)), ["predict", "--grid", "-1..2/7"]),
    "outliers": (lambda fit: fit.outliers(), ["outliers"]),
    "range": (lambda fit: fit.range(), ["range"]),
    "range by row": (lambda fit: fit.range(by="row"), ["range", "--by-row"]),
    "next": (lambda fit: fit.next((-10, "21/2"), new_eps="0.1"), ["next", "--within", "-10..21/2", "--new-eps", "0.1"]),
    "next slope": (lambda fit: fit.next(goal="theta1", new_eps="1/7"), ["next", "--goal", "theta1", "--new-eps", "1/7"]),
}


def asked_of_program(program: Program, own: list[str], file: tuple[str, Any, str | None], options: list[str], *more: str) -> str:
    path, x, y = file
    response = [] if y is None else ["--y", y]
    return program(own[0], f"fixtures/{path}", "--x", str(x), *response, *options, *own[1:], *more)


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize(("file", "arguments", "options"), FILES, ids=NAMES)
def test_a_file_is_asked_like_by_the_program(
    question: str,
    file: tuple[str, Any, str | None],
    arguments: dict[str, Any],
    options: list[str],
    program: Program,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(ROOT)
    ask, own = QUESTIONS[question]
    path, x, y = file
    answer = ask(boundfit.fit_file(f"fixtures/{path}", x, y, **arguments))
    assert answer.to_json() == asked_of_program(program, own, file, options, "--format", "json")
    assert answer.to_dict() == json.loads(answer.to_json())
    # What the program does not write is left out.
    formats = {"repair": ("text", "markdown", "latex"), "range": ("text", "csv"), "range by row": ("text", "csv")}
    for format in formats.get(question, ("text", "markdown", "latex", "csv")):
        assert answer.report(format) == asked_of_program(program, own, file, options, "--format", format)


def columns_of(path: str, x: str, y: str, first: int, last: int | None) -> tuple[list[str], list[str]]:
    with open(FIXTURES / path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))[first - 1 : last]
    return [row[x].strip() for row in rows], [row[y].strip() for row in rows]


def without_input(answer: boundfit.Answer) -> dict[str, Any]:
    document = answer.to_dict()
    del document["input"]
    return document


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("eps", ["0.5e-3", "1.2*min"])
def test_columns_are_asked_like_their_file(question: str, eps: str, tmp_path: Path) -> None:
    x, y = columns_of(*TRANSDUCER, 5, 30)  # type: ignore[arg-type]
    lines = [f"{a},{b}" for a, b in zip(x, y, strict=True)]
    (tmp_path / "part.csv").write_text("\n".join(["x,y", *lines, ""]))
    ask, _ = QUESTIONS[question]
    expected = without_input(ask(boundfit.fit_file(tmp_path / "part.csv", "x", "y", eps)))
    floats = numpy.array(x, dtype=float), pandas.Series([float(own) for own in y])
    for columns in ((x, y), ([Fraction(own) for own in x], y), floats):
        assert without_input(ask(boundfit.fit(*columns, eps))) == expected


def test_functions_are_methods_of_fits() -> None:
    x, y = columns_of(*TRANSDUCER, 1, 16)  # type: ignore[arg-type]
    how: dict[str, Any] = {"where": "theta1 >= 0", "x_origin": "1/2", "reading": "binary64"}
    fit = boundfit.fit(x, y, "0.5e-3", **how)
    assert boundfit.status(x, y, "0.5e-3", repair=True, **how).to_json() == fit.status(repair=True).to_json()
    assert boundfit.predict(x, y, "0.5e-3", at=[1, 2], **how).to_json() == fit.predict([1, 2]).to_json()
    assert boundfit.outliers(x, y, "0.5e-3", most=1, **how).to_json() == fit.outliers(most=1).to_json()
    assert boundfit.range(x, y, "0.5e-3", by="row", **how).to_json() == fit.range(by="row").to_json()
    assert boundfit.next(x, y, "0.5e-3", within=(0, 9), goal="area", **how).to_json() == fit.next((0, 9), goal="area").to_json()
    assert boundfit.windows(x, y, "0.5e-3", window=5, **how) == fit.windows(5)


def test_many_readings_are_kept_for_questions() -> None:
    chance = numpy.random.default_rng(7)
    x = numpy.round(chance.uniform(-5, 5, 12_000), 3)
    y = numpy.round(2 * x + 1 + chance.uniform(-0.1, 0.1, x.size), 3)
    y[77] += 9
    fit = boundfit.fit(x, y, "0.1")
    x[:], y[:] = 0, 0
    assert fit.is_empty and fit.rows == 12_000
    assert fit.outliers().sets == [[78]]
    assert [own.row for own in fit.status().rows if own.without == "outlier"] == [78]
    runs = fit.range(by="row").runs
    assert (runs[0].rows, runs[-1].rows) == ((1, 77), (79, 12_000))


def test_typed_answers_are_those_of_the_documents() -> None:
    fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")
    statuses = fit.status()
    assert statuses.kind == "polygon" and statuses.contradiction is None and statuses.repair is None
    assert [own.status for own in statuses.rows] == ["boundary"] * 3 and statuses.deciding == [1, 2, 3]
    assert statuses.rows[0].leverage == 1 and statuses.rows[0].residual == 0
    predicted = fit.predict(at=[0.5, 3], from_=[1, 100])
    assert [own.x for own in predicted.at] == [Fraction(1, 2), 3]
    assert predicted.at[1].line == fit.response(3)
    assert predicted.at[1].reading == boundfit.Interval(boundfit.LowerBound(3, 2), boundfit.UpperBound(9, 2))
    assert isinstance(predicted.at[1].line.lower, boundfit.LowerBound)
    assert predicted.from_[0].y == 1 and len(predicted.from_[0].x) == 1
    empty = boundfit.fit([0, 1, 2, 3], [0, 1, 2, 9], 1)
    assert empty.status().contradiction is not None
    repaired = empty.status(repair=True).repair
    assert repaired is not None and repaired.total is not None and repaired.total > 4 and len(repaired.widened) >= 1
    found = empty.outliers(most=2)
    assert (found.least, found.is_complete, len(found.pieces)) == (1, True, len(found.sets))
    assert [own.most for own in found.growth] == [0, 1, 2] and found.growth[0].pui is None
    pui = found.pui
    assert pui is not None and pui.theta1.lower is not None
    runs = empty.range()
    assert runs.order == [1, 2, 3, 4] and runs.longest == runs.widest == runs.runs[0]
    assert runs.longest is not None and runs.longest.rows == (1, 3) and runs.longest.x == (0, 2)
    assert runs.pui == boundfit.Intervals(*(boundfit.ProvedInterval(*own) for own in zip_ends(boundfit.fit([0, 1, 2], [0, 1, 2], 1))))
    assert "polygon" in str(statuses.to_dict()) and statuses._repr_html_().startswith("<pre ")


def zip_ends(fit: boundfit.Fit) -> list[tuple[Any, Any, Any, Any]]:
    assert fit.pui is not None
    return [(own.lower, own.upper, own.lower_proof, own.upper_proof) for own in fit.pui]  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("file", "own", "options"),
    [
        ("transducer/transducer.csv", {"x": "Vz", "y": "z"}, ["--x", "Vz", "--y", "z"]),
        (
            "linearity/lvdt.csv",
            {"x": "x_mm", "up": "up_mV", "down": "down_mV", "full_scale": "40"},
            ["--x", "x_mm", "--up", "up_mV", "--down", "down_mV", "--full-scale", "40"],
        ),
        (
            "linearity/cycles.csv",
            {"x": "x_mm", "y": "mV", "direction": "direction", "through": ("1/2", -1)},
            ["--x", "x_mm", "--y", "mV", "--direction", "direction", "--through", "1/2,-1"],
        ),
    ],
    ids=["one", "two", "directed"],
)
def test_linearity_is_the_programs(
    file: str, own: dict[str, Any], options: list[str], program: Program, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    path = f"fixtures/{file}"
    found = boundfit.linearity_file(path, **own)
    assert found.to_json() == program("linearity", path, *options, "--format", "json")
    for format in ("text", "markdown", "latex", "csv"):
        assert found.report(format) == program("linearity", path, *options, "--format", format)
    frame = pandas.read_csv(path, dtype=str, comment="#", skipinitialspace=True)
    roles = ("x", "y", "up", "down", "direction")
    columns = {name: list(frame[value].fillna("")) if name in roles else value for name, value in own.items()}
    assert without_input(boundfit.linearity(**columns)) == without_input(found)


def test_windows_are_the_programs(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    options = ["fit", "fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--eps", "0.5e-3", "--format", "json"]
    fit = boundfit.fit_file("fixtures/transducer/transducer.csv", "Vz", "z", "0.5e-3")
    for arguments, flags in (
        ({"window": 10, "step": 5}, ["--window", "10", "--step", "5"]),
        ({"window_x": "1.5"}, ["--window-x", "1.5"]),
        ({"window": 100}, ["--window", "100"]),
    ):
        expected = [json.loads(line) for line in program(*options, *flags).splitlines()]
        windows = fit.windows(**arguments)  # type: ignore[arg-type]
        assert [own.document for own in windows] == expected and windows
    for own in fit.windows(10, step=12):
        alone = boundfit.fit_file("fixtures/transducer/transducer.csv", "Vz", "z", "0.5e-3", rows=f"{own.first_row}..{own.last_row}")
        assert (own.kind, own.rows, own.epsilon_min) == (alone.kind, alone.rows, alone.epsilon_min)
        ends = lambda pui: pui and [(one.lower, one.upper) for one in pui]  # noqa: E731
        assert ends(own.pui) == ends(alone.pui)


@pytest.mark.parametrize("strong", [False, True])
@pytest.mark.parametrize("eps", ["0.5e-3", "0.05%*|y| + 1e-4"])
def test_errors_in_x_are_the_programs(strong: bool, eps: str, program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    path = "fixtures/transducer/transducer.csv"
    options = ["--x", "Vz", "--y", "z", "--eps", eps, "--rows", "14..36", "--x-eps", "0.05", *(["--strong"] if strong else [])]
    fit = boundfit.fit_file(path, "Vz", "z", eps, rows="14..36", x_eps="0.05", strong=strong)
    assert fit.to_json() == program("fit", path, *options, "--format", "json")
    for format in ("text", "markdown", "latex", "csv"):
        assert fit.report(format) == program("fit", path, *options, "--format", format)
    x, y = columns_of(*TRANSDUCER, 14, 36)  # type: ignore[arg-type]
    for x_eps in ("0.05", 0.05, [0.05] * len(x)):
        own = boundfit.fit(x, y, eps, x_eps=x_eps, strong=strong)
        assert [side.vertices for side in own.sides] == [side.vertices for side in fit.sides]
        assert own.factor == fit.factor and own.central == fit.central and own.eui == fit.eui


def test_without_width_errors_in_x_change_nothing() -> None:
    exact = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")
    own = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2", x_eps=0)
    assert [side.vertices for side in own.sides] == [exact.vertices] and own.pieces == 1 and not own.is_empty
    assert own.factor is not None and own.factor.value == Fraction(1, 2) and own.least_squares == exact.least_squares


def test_a_guarantee_is_the_programs(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    path = "fixtures/transducer/transducer.csv"
    options = ["--x", "Vz", "--y", "z", "--eps", "0.5e-3", "--rows", "14..36", "--confidence", "0.9"]
    fit = boundfit.fit_file(path, "Vz", "z", "0.5e-3", rows="14..36", confidence=0.9)
    assert fit.to_json() == program("fit", path, *options, "--format", "json")
    assert fit.report("markdown") == program("fit", path, *options, "--format", "markdown")
    assert fit.guarantee is not None and fit.guarantee.confidence == Fraction(9, 10) and 0 < fit.guarantee.covered < 1
    assert boundfit.fit([0, 1], [0, 1], 1).guarantee is None


def test_new_readings_are_judged(program: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "old.csv").write_text("x,y,e\n0,0,0.5\n1,1.5,0.5\n2,2,0.5\n")
    (tmp_path / "new.csv").write_text("x,y,e\n3,3,0.5\n3,9,0.5\n")
    options = ["--x", "x", "--y", "y", "--eps-column", "e", "--new", str(tmp_path / "new.csv")]
    fit = boundfit.fit_file("old.csv", "x", "y", eps_column="e")
    statuses = fit.status(new=str(tmp_path / "new.csv"))
    expected = json.loads(program("status", tmp_path / "old.csv", *options, "--format", "json"))
    document = statuses.to_dict()
    del document["input"], expected["input"]
    assert document == expected
    assert [own.status for own in statuses.new] == ["inner", "outlier"] or len(statuses.new) == 2
    in_memory = boundfit.fit([0, 1, 2], [0, 1.5, 2], [0.5] * 3).status(new=([3, 3], [3, 9], [0.5, 0.5]))
    assert in_memory.new == statuses.new and in_memory.rows == statuses.rows
    uniform = boundfit.fit([0, 1, 2], [0, 1.5, 2], 0.5).status(new=([3, 3], [3, 9]))
    assert uniform.new == statuses.new
    assert uniform.report("csv").count("\n") == 6
    with pytest.raises(ValueError, match="new has 1 column: expected x, y"):
        boundfit.fit([0, 1], [0, 1], 1).status(new=([1],))
    with pytest.raises(ValueError, match="new: row 1, column 2"):
        boundfit.fit([0, 1], [0, 1], 1).status(new=([1], [math.nan]))
    with pytest.raises(ValueError, match=r"such as \(x, y\)"):
        boundfit.fit([0, 1], [0, 1], 1).status(new=[1])


def test_proofs_of_columns_are_about_their_csv(program: Program, tmp_path: Path) -> None:
    chance = random.Random(3)
    data, proof = tmp_path / "readings.csv", tmp_path / "proof.json"
    names = ["x", "#Vz [V]", "a,b", 'say "x"', "%", "two\nlines", "Größe"]
    for case, name in enumerate(names * 2):
        rows = chance.choice([3, 5, 9])
        kind = ["float64", "float32", "object", "int"][case % 4]
        values: Any = [round(chance.uniform(-9, 9), 2) for _ in range(rows)]
        x: Any = values if kind == "object" else numpy.array(values).astype(kind)
        x = pandas.Series([Fraction(str(own)) for own in values] if kind == "object" else x, name=name)
        y = [chance.choice([1, -3, 2.5, "7/3", "1e-3"]) for _ in range(rows)]
        fit = boundfit.fit(x, y, [chance.choice([1, 0.5, "1/3"]) for _ in range(rows)], reading=("decimal", "binary64")[case % 2])
        text = fit.to_csv(data)
        assert data.read_bytes() == text
        proof.write_text(fit.proof())
        assert boundfit.verify(fit.proof(), text)
        program("verify", proof, data)
        # It is the same set that is proved.
        again = boundfit.fit_file(data, 1, 2, eps_column=3, reading=fit.reading, header=True)  # type: ignore[arg-type]
        assert again.vertices == fit.vertices and again.to_dict()["fps"] == fit.to_dict()["fps"]
        wrong = text.replace(b"\n", b"\n1", 2)
        with pytest.raises(ValueError, match="sha256: is not that of the data"):
            boundfit.verify(fit.proof(), wrong)


def test_proofs_of_other_answers_are_about_the_same_csv(program: Program, tmp_path: Path) -> None:
    data, file = tmp_path / "readings.csv", tmp_path / "proof.json"
    for x, y in (([0, 1, 2, 3], [0, 1, 2, 9]), ([0, 1, 2, 3], [0, 1.5, 2, 3])):
        fit = boundfit.fit(x, y, 1)
        fit.to_csv(data)
        answers = [fit.status(), fit.outliers(), fit.range(), boundfit.fit(x, y, 1, x_eps="0.1"), boundfit.linearity(x, y)]
        if not fit.is_empty:
            answers.append(fit.predict(at=[5], from_=[1]))
        for answer in answers:
            file.write_text(answer.proof())
            assert boundfit.verify(answer.proof(), data), type(answer)
            program("verify", file, data)


def test_missing_numbers_are_missing_in_the_csv() -> None:
    fit = boundfit.fit([0, 1, None, 3], ["0", "1", "2", "NaN"], 1, missing="skip")
    assert fit.to_csv() == b"x,y\n0,0\n1,1\n,2\n3,NaN\n"
    one_sided = boundfit.fit([0, 1, 2], lower=[0, None, math.nan], upper=[1, 2, 3])
    assert boundfit.verify(one_sided.proof(), one_sided.to_csv())
    with pytest.raises(ValueError, match="the readings come from a file"):
        boundfit.fit_file(FIXTURES / "norris" / "norris.csv", "x", "y", 2).to_csv()


def test_dialects_of_files(tmp_path: Path, program: Program) -> None:
    german = tmp_path / "german.csv"
    german.write_text("! Messung\nx;y\nm;V\n1.000,5;1,5\n2.000,5;2,5\n! Ende\n")
    how: dict[str, Any] = {"decimal": "comma", "thousands": ".", "comment": "!", "delimiter": "semicolon", "units_row": True}
    fit = boundfit.fit_file(german, "x", "y", "0.5", **how)
    options = ["--decimal", "comma", "--thousands", ".", "--comment", "!", "--delimiter", "semicolon", "--units-row"]
    assert fit.to_json() == program("fit", german, "--x", "x", "--y", "y", "--eps", "0.5", *options, "--format", "json")
    assert fit.rows == 2 and fit.status().to_dict()["input"]["table"]
    skipped = tmp_path / "skipped.csv"
    skipped.write_text("made on Monday\nx,y\n#1,2\n")
    with pytest.raises(ValueError, match="not a number"):
        boundfit.fit_file(skipped, "x", "y", 1, skip_lines=1, comment="none")
    utf16 = tmp_path / "utf16.csv"
    utf16.write_text("x\ty\n1\t2\n2\t3\n", encoding="utf-16")
    assert boundfit.fit_file(utf16, "x", "y", 0).vertices == [(1, 1)]
    latin1 = tmp_path / "latin1.csv"
    latin1.write_bytes(b"x,y,\xb0C\n1,2,3\n2,3,4\n")
    assert boundfit.fit_file(latin1, "x", "y", 0).vertices == [(1, 1)]
    assert boundfit.fit_file(latin1, "x", "y", 0, encoding="iso-8859-1").vertices == [(1, 1)]
    lines = tmp_path / "lines.ndjson"
    lines.write_text('{"x":0.1,"y":0.2}\n{"x":1.1,"y":1.2}\n')
    assert boundfit.fit_file(lines, "x", "y", 0).vertices == [(1, Fraction(1, 10))]
    for wrong, message in (
        ({"decimal": "dot"}, 'decimal="dot": expected one of "point", "comma"'),
        ({"thousands": "x"}, 'thousands="x": expected'),
        ({"encoding": "utf-7"}, 'encoding="utf-7": expected one of "auto", "utf-8"'),
        ({"comment": "ab"}, 'comment="ab": expected auto, none or one character'),
        ({"decimal": "comma", "thousands": ","}, "name one mark"),
        ({"limits": {"bytes": 1}}, 'limits="bytes": expected one of "digits"'),
    ):
        with pytest.raises(ValueError, match=message):
            boundfit.fit_file(german, "x", "y", "0.5", **wrong)  # type: ignore[arg-type]


def test_limits_are_named_and_raised(tmp_path: Path) -> None:
    long = tmp_path / "long.csv"
    long.write_text(f"x,y\n0,0\n1,1.{'3' * 10_500}\n")
    with pytest.raises(ValueError, match=r'limits=\{"digits": \.\.\.\} raises it'):
        boundfit.fit_file(long, "x", "y", 1)
    assert boundfit.fit_file(long, "x", "y", 1, limits={"digits": 20_000}, eui=False).kind == "polygon"
    with pytest.raises(ValueError, match=r'limits=\{"rows": \.\.\.\} raises it'):
        boundfit.fit_file(long, "x", "y", 1, limits={"rows": 1, "digits": 20_000}).range()


def test_what_is_wrong_is_told() -> None:
    x, y = [0, 1, 2], [0, 1.5, 2]
    fit = boundfit.fit(x, y, "1/2")
    planar = boundfit.fit(([1, 0, 1], [0, 1, 1]), [2, 3, 5], 1)
    refused: list[tuple[str, Callable[[], Any]]] = [
        (r"row 2, column 2 \(y\)", lambda: boundfit.status(x, [0, math.nan, 1], 1)),
        ('"x" has 3 numbers, but "y" has 2', lambda: boundfit.outliers(x, [0, 1], 1)),
        ("the bound on the errors is missing", lambda: boundfit.range(x, y)),
        ("row 2 of at: list is not a number", lambda: fit.predict(at=[1, [2], 3])),
        (r"^at: row 2, column 1 \(at\)", lambda: fit.predict(at=[1, math.nan])),
        ("nothing is to be predicted", lambda: fit.predict()),
        ("expected .from, to, steps.", lambda: fit.predict(grid=(1, 0, 5))),
        ("from_ and grid are about a line", lambda: planar.predict(from_=1)),
        ("at: expected pairs of numbers", lambda: planar.predict(at=1)),
        ("row 1 of at: list is not a number", lambda: fit.predict(at=([1, 2], [3, 4], [5, 6]))),
        ("at: expected numbers", lambda: fit.predict(at=numpy.zeros((3, 2)))),
        ('new_eps="min": a multiple of the least bound', lambda: fit.predict(at=1, new_eps="min")),
        ("from_ needs the error bound of the reading", lambda: boundfit.predict(x, y, [1, 1, 1], from_=1)),
        ("ask at or grid, and from_, in calls of their own", lambda: fit.predict(at=1, from_=1).report("csv")),
        ('format="pdf": expected "text"', lambda: fit.status().report("pdf")),
        ('by="y": expected x or row', lambda: fit.range(by="y")),  # type: ignore[arg-type]
        ("two regressors have no order of x", lambda: planar.range(by="x")),
        ("window or window_x says how far a window reaches back", lambda: fit.windows()),
        ("window=0: expected", lambda: fit.windows(0)),
        ("step=0: expected", lambda: fit.windows(2, step=0)),
        ("both say how far a window reaches back", lambda: fit.windows(2, window_x=1)),
        ("two regressors have no x to look back", lambda: planar.windows(window_x=1)),
        ("expected a number above 0", lambda: fit.windows(window_x=-1)),
        ("more than 0; max_steps=... raises it", lambda: boundfit.outliers(range(40), [own % 7 for own in range(40)], 0, max_steps=0)),
        ("x_eps is about a line", lambda: boundfit.fit(([1, 0], [0, 1]), [2, 3], 1, x_eps=1)),
        ("strong is about errors in x", lambda: boundfit.fit(x, y, 1, strong=True)),
        ("x_eps=-1: negative", lambda: boundfit.fit(x, y, 1, x_eps=-1)),
        ("is found as if every x were exact", lambda: boundfit.fit(x, y, "min", x_eps=1)),
        ("confidence is about the band", lambda: boundfit.fit(x, y, 1, x_eps=1, confidence=0.5)),  # type: ignore[call-overload]
        ("confidence=1: expected a number between 0 and 1", lambda: boundfit.fit(x, y, 1, confidence=1)),
        ("confidence is about error bounds", lambda: boundfit.fit(x, lower=y, confidence=0.5)),
        ("expected y, or y and direction, or up and down", lambda: boundfit.linearity(x, up=y)),
        ("third direction", lambda: boundfit.linearity(x, y, direction=["a", "b", "c"])),
        ("neither direction", lambda: boundfit.linearity(x, up=[1, None, 2], down=[1, None, 2])),
        ("full_scale=0: expected a number above 0", lambda: boundfit.linearity(x, y, full_scale=0)),
        ("readings: the columns are empty", lambda: boundfit.linearity([], [])),
        ("readings: the columns are empty", lambda: boundfit.status([], [], 1)),
    ]
    for message, call in refused:
        with pytest.raises(ValueError, match=message):
            call()


def test_degenerate_readings_are_answered() -> None:
    for x, y in (([1], [2]), ([1, 1, 1], [2, 2.5, 3]), ([1, 1], [0, 9])):
        fit = boundfit.fit(x, y, 1)
        statuses, found, runs = fit.status(repair=True), fit.outliers(), fit.range()
        assert len(statuses.rows) == len(x) and found.least == (1 if y == [0, 9] else 0)
        # Readings at one x that no line meets belong to no run.
        assert sum(run.last - run.first + 1 for run in runs.fewest) >= (0 if y == [0, 9] else len(x))
        predicted = fit.predict(at=[1, 2], from_=2)
        assert [own.line.lower is None for own in predicted.at] == [True, True] or len(set(x)) == 1
        assert all(own.kind for own in fit.windows(1))
        for answer in (statuses, found, runs, predicted):
            assert answer.report("text") and json.loads(answer.to_json()) == answer.to_dict()
        boundfit.linearity(x, y).report("text")
        assert boundfit.fit(x, y, 1, x_eps=1).pieces >= 0
    planar = boundfit.fit(([1, 0, 1], [0, 1, 1]), [2, 3, 5], "1/2")
    predicted = planar.predict(at=[(1, 1), ("1/2", 0)])
    assert [own.x for own in predicted.at] == [(1, 1), (Fraction(1, 2), 0)]
    assert predicted.at[0].line == planar.response(1, 1)
    assert planar.predict(at=(1, 1)).at == planar.predict(at=numpy.array([[1, 1]])).at == predicted.at[:1]
    assert planar.range().order == [1, 2, 3] and planar.outliers().least == 0 and len(planar.status().rows) == 3


def test_intervals_are_asked_too() -> None:
    lower, upper = [0, 1, 1, None], [1, 2, 3, 4]
    fit = boundfit.fit([0, 1, 2, 3], lower=lower, upper=upper)
    assert fit.predict(at=1).at[0].reading is None
    assert len(fit.status().rows) == 4 and fit.outliers().least == 0 and fit.range().longest is not None


def test_answers_say_what_they_are_in_a_line() -> None:
    x, y = [0, 1, 2, 3], [0, 1, 5, 3]
    assert repr(boundfit.status(x, y, 2)) == "<boundfit.Statuses of 4 readings: polygon, decided by rows [1, 3, 4]>"
    assert repr(boundfit.predict(x, y, 2, at=["1/3"], from_=[1])) == "<boundfit.Prediction at 1 x and from 1 reading: polygon>"
    assert repr(boundfit.outliers(x, y, "0.1")) == "<boundfit.Outliers: 1 reading to leave out, 1 set>"
    assert repr(boundfit.range(x, y, "0.1")) == "<boundfit.LinearRange: 3 runs, the longest from row 1 to row 2>"
    assert repr(boundfit.linearity(x, [0, 1, 2, 4])) == "<boundfit.Linearity: independent 0.333334, 8.33334 % of full scale>"
    assert repr(boundfit.polygon([[1, 0], [0, 1]], [1, 1])) == "<boundfit.Polygon: unbounded-polygon, 1 vertex>"


def test_sets_without_any_end_have_intervals_as_fits_have() -> None:
    free = boundfit.fit([1], [2], "1/2").pui
    assert free == boundfit.Intervals(boundfit.ProvedInterval(None, None), boundfit.ProvedInterval(None, None))
    assert boundfit.fit([1], [2], "1/2", x_eps="1/10").pui == free
    assert [own.pui for own in boundfit.windows([1, 2], [2, 3], "1/2", window=1)] == [free, free]
    assert boundfit.range([1], [2], "1/2").pui == free
    never = boundfit.fit([1, 1], [0, 9], 1, x_eps=0)
    assert never.pui is None and {own.pui for own in never.sides if own.kind == "empty"} == {None}
    assert boundfit.windows([1, 1], [0, 9], 1, window=2)[0].pui is None
    for proved in (boundfit.Fit, boundfit.XErrorFit, boundfit.LinearRange):
        assert get_type_hints(proved.pui.fget)["return"] == boundfit.Intervals[boundfit.ProvedInterval] | None


def test_a_reading_is_certain_to_help_strictly_between_ends_rounded_inward() -> None:
    fit = boundfit.fit(["1/3", "10/3"], [0, 1], "1/2")
    below, above = fit.next((0, 1)).certain
    third, other = Fraction(1, 3), Fraction(10, 3)
    assert (below.lower, below.upper, above.lower, above.upper) == (None, third, other, None)
    assert third not in below and other not in above and 0 in below and 4 in above
    for double in (below.to_floats()[1], float(below.upper or 0), above.to_floats()[0], float(above.lower or 0)):
        assert double in (below if double < 1 else above)
        line = fit.response(Fraction(double))
        assert line is not None and line.width is not None and line.width > 1
    for kind in ("f2", "f4", "f8", "O"):
        assert Fraction(float(numpy.asarray(below, dtype=kind)[1])) < third and Fraction(float(numpy.asarray(above, dtype=kind)[0])) > other
    assert (f"{below:.4}", f"{above:.4}") == ("(-inf, 0.3333)", "(3.334, inf)")
    assert (f"{below.upper:.3f}", round(above.lower or 0, 2)) == ("0.333", Fraction(334, 100))
    copied = pickle.loads(pickle.dumps(below))
    assert copied == below and list(copied) == [None, third] and copied.width is None
    assert "OpenInterval(lower=None, upper=InnerUpperBound(1, 3))" in repr(fit.next((0, 1)))


def test_the_x_of_a_reading_exclude_ends_that_no_line_reaches() -> None:
    below, above = boundfit.fit([1], [-2], "1/2").predict(from_=3).from_[0].x
    assert 1 not in below and 1 not in above and "0.999" in below and "1.001" in above
    assert (below.upper_included, above.lower_included, below.lower_included) == (False, False, True)
    assert repr(below) == "Interval(lower=None, upper=UpperBound(1, 1), upper_included=False)" and f"{below:.3}" == "[-inf, 1)"
    assert below == boundfit.Interval(None, boundfit.UpperBound(1), upper_included=False) != boundfit.Interval(None, boundfit.UpperBound(1))
    assert pickle.loads(pickle.dumps(below)) == below
