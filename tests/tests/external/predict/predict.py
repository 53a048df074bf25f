"""Predictions by linear programs in floats: intervals of a line at several x, and the x of readings by root searches on such.

Reads from standard input {"rows": [[x, y], ...], "eps": e, "at": [x, ...], "from": [[y, x, is_upper, bracket], ...]} and prints
{"at": [[lower, upper], ...], "from": [x, ...]}.
"""
import json
import sys

import numpy as np
from scipy.optimize import brentq, linprog

asked = json.load(sys.stdin)
x, y = np.array(asked["rows"]).T
eps = asked["eps"]
matrix = np.vstack([np.column_stack([x, np.ones_like(x)]), -np.column_stack([x, np.ones_like(x)])])
bounds = np.concatenate([y + eps, eps - y])


def most(at, sign):
    found = linprog([-sign * at, -sign], matrix, bounds, bounds=[(None, None)] * 2, method="highs-ds")
    assert found.status == 0, found
    return -sign * found.fun


def source(reading, is_upper, near):
    """Where the upper end of the line reaches the reading less its bound, or the lower one the reading and its bound."""
    sign = 1 if is_upper else -1
    miss = lambda at: most(at, sign) - (reading - sign * eps)
    return brentq(miss, near - asked["width"], near + asked["width"], xtol=1e-14, rtol=1e-15)


json.dump(
    {
        "at": [[most(at, -1), most(at, 1)] for at in asked["at"]],
        "from": [source(*question) for question in asked["from"]],
    },
    sys.stdout,
)
