"""The set on axes of matplotlib."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from ._bounds import Point

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._fit import Fit

#: What an interval of the axes is: of theta1 and of theta2.
Window = tuple[tuple[float, float], tuple[float, float]]
#: The half-plane a1*theta1 + a2*theta2 <= b.
HalfPlane = tuple[Fraction, Fraction, Fraction]

# The colours of the package's own figures, which colour-blind readers tell apart.
BLUE, VERMILLION, GREEN, INK = "#0072b2", "#d55e00", "#009e73", "#262626"


def plot(fit: Fit, ax: Axes | None = None, **style: Any) -> Axes:
    """Draws the set, the box of its intervals and the estimates; of an unbounded set what the axes show."""
    try:
        return _plot(fit, ax, style)
    except OverflowError:
        raise ValueError("the set is too far away to be drawn: its numbers are larger than doubles") from None


def _plot(fit: Fit, ax: Axes | None, style: dict[str, Any]) -> Axes:
    own_axes = ax is None
    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.gca()
    first, second = _labels(fit)
    ax.set_xlabel(first)
    ax.set_ylabel(second)
    if fit.is_empty:
        ax.set_title(f"No parameters agree with all readings\n{_reason(fit)}".strip(), fontsize="medium")
    else:
        _set(fit, ax, style)
    _estimates(fit, ax)
    if own_axes and ax.get_legend_handles_labels()[0]:
        ax.legend(fontsize="small")
    return ax


def _reason(fit: Fit) -> str:
    """Which bounds contradict each other."""
    names = [own.bound if own.row is None else f"row {own.row} {own.bound}" for own in fit.contradiction or ()]
    return f"these contradict each other: {', '.join(names)}" if names else ""


def _labels(fit: Fit) -> tuple[str, str]:
    """What the axes are: the parameters, with the names of the columns that they belong to."""
    regressors, response = fit._core.names
    # A dollar sign would begin a formula.
    names = [" ".join(name.split()).replace("$", r"\$") for name in (*regressors, response)]
    if len(names) == 2:
        return f"theta1 ({names[1]} per {names[0]})", f"theta2 ({names[1]})"
    return f"theta1 ({names[2]} per {names[0]})", f"theta2 ({names[2]} per {names[1]})"


def _estimates(fit: Fit, ax: Axes) -> None:
    def mark(point: Point, marker: str, colour: str, label: str) -> None:
        ax.plot([float(point[0])], [float(point[1])], marker=marker, color=colour, linestyle="none", label=label, zorder=3)

    if fit.least_squares is not None:
        feasible = "" if fit.least_squares_is_feasible else " (not feasible)"
        mark(fit.least_squares, "x", VERMILLION, f"least squares{feasible}")
    if fit.minimax is not None:
        mark(fit.minimax[1:3], "^", GREEN, "minimax estimate")
    if fit.central is not None:
        mark(fit.central[:2], "D", INK, "central estimate")


def _set(fit: Fit, ax: Axes, style: dict[str, Any]) -> None:
    """Draws a set that is not empty, and the box of its intervals."""
    pui = fit.pui
    assert pui is not None
    ends = [interval.to_floats() for interval in pui]
    is_bounded = all(math.isfinite(end) for interval in ends for end in interval)
    look = {"facecolor": (0.0, 0.447, 0.698, 0.3), "edgecolor": BLUE, "label": "feasible parameter set (FPS)", **style}
    if fit.area == 0:
        look = {"linewidth": 2.5, **look}
    window: Window | None = None
    if is_bounded:
        (left, right), (low, high) = ends
        corners = fit.vertices
    else:
        planes = _half_planes(fit)
        window = _window(fit, planes, ax)
        # What is cut off is cut where it cannot be seen.
        wide = [(lower - (upper - lower), upper + (upper - lower)) for lower, upper in window]
        (left, right), (low, high) = ((max(end, cut), min(last, stop)) for (end, last), (cut, stop) in zip(ends, wide, strict=True))
        corners = _clipped(planes, wide)
    points = [(float(theta1), float(theta2)) for theta1, theta2 in corners]
    if len(points) == 1:
        # Larger than the marks of the estimates, which are the same point.
        ax.scatter([points[0][0]], [points[0][1]], **{"s": 160, **look})
    elif points:
        ax.fill([own[0] for own in points], [own[1] for own in points], **look)
    if any(math.isfinite(end) for interval in ends for end in interval):
        ax.plot(
            [left, right, right, left, left], [low, low, high, high, low],
            color=BLUE, linestyle="--", linewidth=1.0, label="PUI box",
        )  # fmt: skip
    if window is not None:
        ax.set_xlim(*window[0])
        ax.set_ylim(*window[1])


def _window(fit: Fit, planes: list[HalfPlane], ax: Axes) -> Window:
    """What the axes show of an unbounded set: their limits where they are fixed; else what they have, and what there is of the
    set: its vertices, a point of it, the ends that there are and the estimates, with as much around."""
    points = [point for point in (*fit.vertices, fit.witness, fit.least_squares) if point is not None]
    if fit.minimax is not None:
        points.append(fit.minimax[1:3])
    if not fit.vertices and fit.witness is not None:
        # The points next to it on all boundaries.
        theta1, theta2 = fit.witness
        for a1, a2, b in planes:
            step = (b - a1 * theta1 - a2 * theta2) / (a1 * a1 + a2 * a2)
            points.append((theta1 + step * a1, theta2 + step * a2))
    pui = fit.pui
    assert pui is not None

    def interval(axis: int, is_free: bool, limits: tuple[float, float], data: tuple[float, float]) -> tuple[float, float]:
        if not is_free:
            return min(limits), max(limits)
        values = [float(point[axis]) for point in points] + [float(end) for end in (pui[axis].lower, pui[axis].upper) if end is not None]
        values += [own for own in data if math.isfinite(own)]
        around = (max(values) - min(values)) / 2 or abs(values[0]) / 2 or 1.0
        return min(values) - around, max(values) + around

    data = ax.dataLim
    return (
        interval(0, ax.get_autoscalex_on(), ax.get_xlim(), (data.x0, data.x1)),
        interval(1, ax.get_autoscaley_on(), ax.get_ylim(), (data.y0, data.y1)),
    )


def _half_planes(fit: Fit) -> list[HalfPlane]:
    """Those whose intersection the set is; an equation is two of them."""
    head, _, body = fit.report("ine").partition("begin\n")
    equations: set[int] = set()
    for line in head.splitlines():
        if line.startswith("linearity"):
            equations.update(map(int, line.split()[2:]))
    planes: list[HalfPlane] = []
    rows = body.partition("end")[0].splitlines()[1:]
    for number, row in enumerate(rows, start=1):
        b, a1, a2 = map(Fraction, row.split())
        planes.append((-a1, -a2, b))
        if number in equations:
            planes.append((a1, a2, -b))
    return planes


def _clipped(planes: list[HalfPlane], window: list[tuple[float, float]]) -> list[Point]:
    """The corners of what a window shows of an intersection of half-planes, exactly; none where it shows nothing.

    Half-plane by half-plane: Sutherland and Hodgman, Reentrant polygon clipping, 1974.
    """
    (left, right), (low, high) = ((Fraction(first), Fraction(last)) for first, last in window)
    corners: list[Point] = [(left, low), (right, low), (right, high), (left, high)]
    for a1, a2, b in planes:
        kept: list[Point] = []
        slack = [b - a1 * theta1 - a2 * theta2 for theta1, theta2 in corners]
        for index, corner in enumerate(corners):
            before, previous = slack[index - 1], corners[index - 1]
            if before * slack[index] < 0:
                share = before / (before - slack[index])
                kept.append((previous[0] + share * (corner[0] - previous[0]), previous[1] + share * (corner[1] - previous[1])))
            if slack[index] >= 0:
                kept.append(corner)
        corners = list(dict.fromkeys(kept))
    return corners
