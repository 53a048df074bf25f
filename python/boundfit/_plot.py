"""The set on axes of matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._fit import Fit


def plot(fit: Fit, ax: Axes | None = None, **style: Any) -> Axes:
    """Draws the set, the box of its intervals and the estimates."""
    if fit.kind not in ("polygon", "segment", "point"):
        raise ValueError(f"the set is {fit.kind}: nothing but a bounded set is drawn on axes (fit.svg draws every set)")
    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.gca()
    points = [(float(theta1), float(theta2)) for theta1, theta2 in fit.vertices]
    pui = fit.pui
    assert pui is not None
    (left, right), (low, high) = (interval.to_floats() for interval in pui)
    box_style = {"color": "0.6", "linestyle": "--", "linewidth": 1.0, "label": "PUI"}
    ax.plot([left, right, right, left, left], [low, low, high, high, low], **box_style)  # type: ignore[arg-type]
    closed = [*points, points[0]]
    shown = {"facecolor": "tab:blue", "edgecolor": "tab:blue", "alpha": 0.35, "label": "FPS", **style}
    ax.fill([theta1 for theta1, _ in closed], [theta2 for _, theta2 in closed], **shown)
    if fit.central is not None:
        ax.plot(float(fit.central.theta1), float(fit.central.theta2), "k+", label="central estimate")
    if fit.least_squares is not None:
        ax.plot(*(float(own) for own in fit.least_squares), "rx", label="least squares")
    ax.set_xlabel("theta1")
    ax.set_ylabel("theta2")
    return ax
