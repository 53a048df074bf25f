"""Leverages and residuals of the readings of a line by linear programs in doubles, two for every set.

    python3 statuses.py FILE X Y EPS FIRST LAST

prints for each of the rows FIRST to LAST its number, leverage and residual against the set of all, and against that of the others;
nan where a set is empty or the values over it have no end.
"""

import csv
import sys

import numpy as np
from scipy.optimize import linprog


def ends(x, y, epsilon, at):
    """The least and the largest value at a place of all lines that keep within epsilon of the readings."""
    # Counted in units of epsilon from the middle, so that the solver's tolerances are small beside the answer.
    shift, scale = x.mean(), max(np.abs(x - x.mean()).max(), 1e-300)
    slope, offset = np.polyfit((x - shift) / scale, y, 1) if len(set(x)) > 1 else (0.0, y.mean())
    u = (x - shift) / scale
    rest = (y - slope * u - offset) / epsilon
    sides = np.column_stack([np.concatenate([u, -u]), np.concatenate([np.ones_like(u), -np.ones_like(u)])])
    bounds = np.concatenate([rest + 1, 1 - rest])
    form = np.array([(at - shift) / scale, 1.0])
    found = []
    for sign in (1, -1):
        solved = linprog(sign * form, A_ub=sides, b_ub=bounds, bounds=(None, None), method="highs-ds",
                         options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
        if solved.status != 0:
            return float("nan"), float("nan")
        # The corner as the crossing of the two sides that the solver found tight.
        tight = np.argsort(bounds - sides @ solved.x)[:2]
        corner = solved.x
        if abs(np.linalg.det(sides[tight])) > 1e-9:
            corner = np.linalg.solve(sides[tight], bounds[tight])
        found.append((form @ corner) * epsilon + slope * form[0] + offset)
    return found[0], found[1]


def main(file, x_name, y_name, epsilon, first, last):
    with open(file, newline="") as table:
        rows = list(csv.DictReader(table))[int(first) - 1:int(last)]
    x, y = (np.array([float(row[name]) for row in rows]) for name in (x_name, y_name))
    epsilon = float(epsilon)
    for place in range(len(rows)):
        others = np.arange(len(rows)) != place
        numbers = []
        for kept in (np.full(len(rows), True), others):
            least, most = ends(x[kept], y[kept], epsilon, x[place])
            numbers += [(most - least) / 2 / epsilon, (y[place] - (most + least) / 2) / epsilon]
        print(int(first) + place, *map(repr, map(float, numbers)))


if __name__ == "__main__":
    main(*sys.argv[1:])
