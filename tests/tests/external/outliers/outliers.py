"""The fewest readings to leave out by a mixed-integer program in floats, and what is left without a set by linear programs.

Reads from standard input {"rows": [[x, y], ...], "eps": e, "sets": [[row, ...], ...]} and prints
{"least": q, "ranges": [[[lower, upper], [lower, upper]], ...]}.
"""
import json
import sys

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, linprog, milp

asked = json.load(sys.stdin)
x, y = np.array(asked["rows"]).T
eps, count = asked["eps"], len(x)
# No reading is off by more than this. Solvers take 1 - 1e-6 for 1: with a larger one they leave out too few.
far = 50.0 * eps
phi = np.column_stack([x, np.ones_like(x)])
misses = LinearConstraint(
    np.vstack([np.hstack([phi, -far * np.eye(count)]), np.hstack([-phi, -far * np.eye(count)])]),
    ub=np.concatenate([y + eps, eps - y]),
)
free = Bounds([-np.inf] * 2 + [0] * count, [np.inf] * 2 + [1] * count)
found = milp(
    [0, 0] + [1] * count, integrality=[0, 0] + [1] * count, bounds=free, constraints=misses, options={"mip_rel_gap": 0}
)
assert found.status == 0, found


def ranges(without):
    kept = [row for row in range(count) if row + 1 not in without]
    matrix = np.vstack([phi[kept], -phi[kept]])
    bounds = np.concatenate([y[kept] + eps, eps - y[kept]])

    def most(form):
        own = linprog([-part for part in form], matrix, bounds, bounds=[(None, None)] * 2, method="highs-ds")
        assert own.status == 0, own
        return -own.fun

    return [[-most([-1, 0]), most([1, 0])], [-most([0, -1]), most([0, 1])]]


json.dump({"least": round(found.fun), "ranges": [ranges(without) for without in asked["sets"]]}, sys.stdout)
