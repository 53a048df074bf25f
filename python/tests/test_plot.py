"""What is drawn on axes, and what a notebook shows."""

from __future__ import annotations

import html
import re
from fractions import Fraction
from typing import Any

import boundfit
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy
import pandas
import pytest
from matplotlib.axes import Axes
from matplotlib.path import Path
from scipy.optimize import linprog

from conftest import FIXTURES

NONE = None
SETS = {
    "polygon": boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2"),
    "two regressors": boundfit.fit(([1, 0, 1], [0, 1, 1]), [2, 3, 5], "0.1"),
    "point": boundfit.fit([0, 1], [2, 3], 0),
    "segment": boundfit.fit([0, 1], [2, 3], [0, 1]),
    "ray": boundfit.fit([0, 1], lower=[0, 1], upper=[0, NONE]),
    "line": boundfit.fit([1], [2], 0),
    "strip": boundfit.fit([1, 1], [1, 1.2], 1),
    "half-plane": boundfit.fit([1], lower=[0], upper=[NONE]),
    "unbounded-polygon": boundfit.fit([0, 1], lower=[0, 1], upper=[3, NONE]),
    # Its directions are nearly opposite: cut by a chord far out, it would lack what is near.
    "nearly a half-plane": boundfit.fit([-1, 1], lower=[0, 0], upper=[NONE, NONE], where="theta2 <= 1000*theta1 + 1000"),
}


@pytest.fixture
def ax() -> Any:
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def filled(axes: Axes) -> Path:
    [patch] = axes.patches
    path = patch.get_path()
    assert isinstance(path, Path)
    return path


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("limits", [None, ((-3.0, 4.0), (-2.5, 3.5)), ((0.4, 0.7), (10.0, 11.0))], ids=str)
def test_what_the_axes_show_is_the_set(name: str, limits: Any, ax: Axes) -> None:
    fit = SETS[name]
    if limits is not None:
        ax.set_xlim(*limits[0])
        ax.set_ylim(*limits[1])
    assert fit.plot(ax) is ax
    ax.figure.canvas.draw()
    if limits is not None:
        assert (ax.get_xlim(), ax.get_ylim()) == limits
    if fit.kind == "point":
        [marks] = ax.collections
        offsets: Any = marks.get_offsets()
        assert offsets.tolist() == [[1.0, 2.0]]
        return
    # Points of a grid that the axes show are in the drawn area if they are in the set. The area is too thin for that where it has
    # no inside; its corners have to be.
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    seen = 0
    if fit.area is None or fit.area > 0:
        drawn = filled(ax) if ax.patches else None
        for theta1 in numpy.linspace(left, right, 23)[1:-1] + 0.000123 * (right - left):
            for theta2 in numpy.linspace(low, high, 23)[1:-1] + 0.000123 * (high - low):
                inside = (Fraction(theta1), Fraction(theta2)) in fit
                seen += inside
                assert inside == (drawn is not None and drawn.contains_point((theta1, theta2))), (theta1, theta2)
        assert seen or limits is not None
    elif limits is None:
        vertices = filled(ax).vertices
        assert len(vertices) >= 2 and all((Fraction(theta1), Fraction(theta2)) in fit for theta1, theta2 in vertices)
    if limits is None:
        for theta1, theta2 in fit.vertices:
            assert left <= theta1 <= right and low <= theta2 <= high


def test_the_window_of_an_unbounded_set_has_its_boundary(ax: Axes) -> None:
    SETS["strip"].plot(ax)
    # 0.2 <= theta1 + theta2 <= 2.
    corners = [(theta1, theta2) for theta1 in ax.get_xlim() for theta2 in ax.get_ylim()]
    sums = [theta1 + theta2 for theta1, theta2 in corners]
    assert min(sums) < 0.2 and max(sums) > 2


def test_fixed_limits_of_one_axis_are_kept(ax: Axes) -> None:
    ax.set_ylim(-5, 7)
    SETS["unbounded-polygon"].plot(ax)
    assert ax.get_ylim() == (-5, 7) and ax.get_xlim()[0] < -2


def test_estimates_and_the_box_are_drawn_where_there_are_such(ax: Axes) -> None:
    fit = boundfit.fit_file(FIXTURES / "transducer" / "transducer.csv", "Vz", "z", "0.5e-3", rows="14..36")
    fit.plot(ax, facecolor="tab:orange", label="set")
    labels = ["set", "PUI box", "least squares (not feasible)", "minimax estimate", "central estimate"]
    assert ax.get_legend_handles_labels()[1] == labels and ax.get_legend() is None
    assert ax.patches[0].get_facecolor() == matplotlib.colors.to_rgba("tab:orange")
    box, *marks = ax.lines
    assert fit.pui is not None and fit.least_squares is not None and fit.central is not None and fit.minimax is not None
    x, y = (numpy.asarray(own, dtype=float) for own in box.get_data())
    assert (x.min(), x.max()) == fit.pui.theta1.to_floats() and (y.min(), y.max()) == fit.pui.theta2.to_floats()
    points = [tuple(float(own[0]) for own in mark.get_data()) for mark in marks]  # type: ignore[index]
    assert points == [tuple(map(float, own[:2])) for own in (fit.least_squares, fit.minimax[1:3], fit.central)]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("theta1 (z per Vz)", "theta2 (z)")
    # A half-plane has neither intervals nor estimates.
    plt.sca(ax)
    ax.clear()
    assert SETS["half-plane"].plot() is ax
    assert ax.get_legend_handles_labels()[1] == ["feasible parameter set (FPS)"] and ax.get_legend() is not None


def test_names_of_columns_are_no_formulas(ax: Axes) -> None:
    frame = pandas.DataFrame({"I\n in $\\frac{": [0.0, 1.0], "$": [1.0, 2.0]})
    boundfit.fit(frame.iloc[:, 0], frame["$"], 1).plot(ax)
    assert ax.get_xlabel() == "theta1 (\\$ per I in \\$\\frac{)"
    ax.figure.canvas.draw()
    SETS["two regressors"].plot(ax)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("theta1 (y per phi1)", "theta2 (y per phi2)")


def test_an_empty_set_says_so(ax: Axes) -> None:
    boundfit.fit([0, 1, 2], [0, 1, 0], "0.4").plot(ax)
    assert ax.get_title() == "No parameters agree with all readings\nthese contradict each other: row 1 upper, row 2 lower, row 3 upper"
    assert not ax.patches and len(ax.lines) == 2


def test_what_no_double_holds_is_refused(ax: Axes) -> None:
    with pytest.raises(ValueError, match="too far away to be drawn"):
        boundfit.fit(["0", "1"], ["0", "1e400"], 1).plot(ax)


def absolute(path: str) -> list[tuple[str, list[float]]]:
    """The commands of a path of SVG with absolute ends: an own reader of the grammar."""
    made: list[tuple[str, list[float]]] = []
    x = y = start_x = start_y = 0.0
    for command, text in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", path):
        numbers = [float(number) for number in re.findall(r"-?[\d.]+", text)]
        offset_x, offset_y = (x, y) if command.islower() else (0.0, 0.0)
        kind = command.upper()
        if kind == "Z":
            x, y = start_x, start_y
            made.append(("Z", []))
            continue
        if kind == "H":
            kind, numbers = "L", [numbers[0] + offset_x, y]
        elif kind == "V":
            kind, numbers = "L", [x, numbers[0] + offset_y]
        else:
            numbers = [number + (offset_y if index % 2 else offset_x) for index, number in enumerate(numbers)]
        x, y = numbers[-2:]
        if kind == "M":
            start_x, start_y = x, y
        made.append((kind, numbers))
    return made


def drawn(svg: str) -> list[tuple[str, list[float]]]:
    return [command for path in re.findall(r' d="([^"]*)"', svg) for command in absolute(path)]


@pytest.mark.parametrize("name", SETS)
def test_a_page_shows_the_picture_in_fewer_bytes_and_without_ids(name: str) -> None:
    fit = SETS[name]
    shown, picture = fit._repr_html_(), fit.svg()
    assert drawn(shown) == drawn(picture)
    assert len(shown) < min(0.75 * len(picture), 90_000)
    # Nothing in it is named, so that two of them do not clash, and no size but that of the page is fixed.
    assert not re.search(r"\bid=|\bhref=|url\(|<style", shown)
    assert re.search(r'<svg style="width:100%;max-width:\d+px;height:auto" xmlns="[^"]*" viewBox="0 0 [\d.]+ [\d.]+"', shown)
    assert shown.count("<svg") == shown.count("</svg>") == shown.count("<pre") == 1
    assert "theta1" in shown.partition("<pre")[2]


def test_strange_names_are_text_in_a_page() -> None:
    frame = pandas.DataFrame({"<b>": [0.0, 1.0], "a&b": [1.0, 2.0]})
    shown = boundfit.fit(frame["<b>"], frame["a&b"], 1)._repr_html_()
    assert "<b>" not in shown and "&lt;b&gt;" in shown and "a&amp;b" in shown


def test_a_path_of_more_than_whole_numbers_is_left_alone() -> None:
    from boundfit._html import in_page

    for path in ("M 0.5 1 L 2 3 Z", "M 0 0 A 1 1 0 0 1 2 2", "M 0 0 L 1 1 2 2"):
        assert f'd="{path}"' in in_page(f'<svg width="1" height="1"><path d="{path}"/></svg>')


def test_reports_keep_their_columns_in_a_page() -> None:
    fit = boundfit.fit([0, 1, 2, 3], [0, 1, 9, 3], "1/2")
    triangle = boundfit.polygon([[-1, 0], [0, -1], [2, 3]], [0, 0, 6])
    for answer in (fit.outliers(), fit.status(), boundfit.linearity([0, 1, 2], [0, 1, 2.5]), triangle):
        shown = answer._repr_html_()
        assert shown.startswith("<pre style='font-family:monospace;") and shown.endswith("</pre>")
        assert html.unescape(shown.partition(">")[2].removesuffix("</pre>")) == str(answer)


def test_a_judged_program_is_a_table() -> None:
    c, A, b = [-1, -1], [[1, 2], [3, 1]], [4, 6]
    assert boundfit.judge(c, A, b)._repr_html_() == "<p>exactly: <b>optimal</b>, -14/5, attained at (8/5, 6/5)</p>"
    result = linprog(c, A, b)
    result.fun -= 0.1
    shown = boundfit.judge(c, A, b, result=result)._repr_html_()
    assert "the result is, at worst, <b>refuted</b></p><table>" in shown
    assert "<tr><td>objective</td><td><b>refuted</b></td><td>about 0.1" in shown and "<tr><td>status</td><td>exact</td><td></td></tr>" in shown
    assert shown.count("<tr>") == 1 + len(boundfit.judge(c, A, b, result=result).findings)
    empty = boundfit.judge([1, 0], [[1, 0], [-1, 0]], [-1, -1], (None, None))
    assert empty._repr_html_() == "<p>exactly: <b>infeasible</b></p>"
    huge = boundfit.judge([1, 0], [[-1, 0], [0, -1]], ["-1" + "0" * 400, 0], (None, None))
    assert "about 1" in huge._repr_html_() and "e+400" in huge._repr_html_()
