"""What calls cost, beside what others cost for the same numbers: processor time, the least of several runs.

    python python/benches/timings.py
"""

from __future__ import annotations

import platform
import random
import resource
import sys
import time
from collections.abc import Callable
from decimal import Decimal
from typing import Any

import boundfit
import numpy


def seconds(call: Callable[[], Any], runs: int, calls: int = 1) -> float:
    """The least processor time of all threads per call."""
    best = float("inf")
    for _ in range(runs):
        start = time.process_time()
        for _ in range(calls):
            call()
        best = min(best, (time.process_time() - start) / calls)
    return best


def shown(name: str, took: float, beside: float | None = None) -> None:
    scaled = f"{took * 1e6:9.1f} µs" if took < 1e-3 else f"{took * 1e3:9.2f} ms"
    ratio = "" if beside is None else f"   {took / beside:8.1f} times numpy's min and max"
    print(f"{name:<58}{scaled}{ratio}", flush=True)


def few() -> None:
    chance = random.Random(1)
    x = [Decimal(chance.randint(-5000, 5000)).scaleb(-3) for _ in range(23)]
    y = [Decimal(chance.randint(-200, 200)).scaleb(-4) + 2 * value for value in x]
    arrays = [numpy.array([float(value) for value in column]) for column in (x, y)]
    texts = [[str(value) for value in column] for column in (x, y)]
    print("23 readings")
    for reading in ("decimal", "binary64"):
        shown(f"  fit of numpy arrays, {reading}", seconds(lambda: boundfit.fit(*arrays, 0.05, reading=reading), 20, 200))  # type: ignore[arg-type]  # noqa: B023
    shown("  fit of lists of str", seconds(lambda: boundfit.fit(*texts, 0.05), 20, 200))
    shown("  fit of lists of Decimal", seconds(lambda: boundfit.fit(x, y, 0.05), 20, 200))
    fit = boundfit.fit(*arrays, 0.05)
    shown("  vertices and intervals as fractions", seconds(lambda: (fit.vertices, fit.pui), 20, 200))
    shown("  the report as JSON text", seconds(fit.to_json, 20, 100))
    others(*arrays)


def others(x: Any, y: Any) -> None:
    ones = numpy.ones_like(x)
    matrix = numpy.vstack([numpy.column_stack([x, ones]), numpy.column_stack([-x, -ones])])
    ends = numpy.concatenate([y + 0.05, 0.05 - y])
    try:
        from scipy.optimize import linprog
    except ImportError:
        print("  (no scipy)")
    else:
        costs = [[1, 0], [-1, 0], [0, 1], [0, -1]]
        four = lambda: [linprog(c, matrix, ends, bounds=(None, None)) for c in costs]  # noqa: E731
        shown("  four programs of the intervals: scipy.optimize.linprog", seconds(four, 3, 3))
    try:
        import highspy
    except ImportError:
        print("  (no highspy)")
    else:

        def four() -> None:
            for cost in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
                highs = highspy.Highs()
                highs.setOptionValue("output_flag", False)
                highs.addVars(2, numpy.full(2, -highspy.kHighsInf), numpy.full(2, highspy.kHighsInf))
                highs.changeColsCost(2, numpy.array([0, 1], dtype="int32"), numpy.array(cost))
                rows = len(ends)
                highs.addRows(
                    rows, numpy.full(rows, -highspy.kHighsInf), ends, matrix.size,
                    numpy.arange(0, matrix.size, 2, dtype="int32"), numpy.tile(numpy.array([0, 1], dtype="int32"), rows),
                    matrix.ravel(),
                )  # fmt: skip
                highs.run()

        shown("  the same: highspy", seconds(four, 3, 3))
    try:
        import cdd
    except ImportError:
        print("  (no pycddlib)")
    else:
        rows = [[float(end), *(-row)] for end, row in zip(ends, matrix, strict=True)]

        def vertices() -> None:
            matrix_of = cdd.matrix_from_array(rows, rep_type=cdd.RepType.INEQUALITY)
            cdd.copy_generators(cdd.polyhedron_from_matrix(matrix_of))

        shown("  vertices in floats: pycddlib", seconds(vertices, 3, 3))


def many(rows: int) -> None:
    noise = numpy.random.default_rng(1)
    print(f"{rows:,} readings")
    for name, x in (("uniform x, 17 digits", noise.uniform(0, 1, rows)), ("4 digits", noise.integers(0, 10_000, rows) / 1e4)):
        y = 2 * x + noise.integers(-1000, 1000, rows) / 1e4
        least = seconds(lambda: (x.min(), x.max(), y.min(), y.max()), 3)  # noqa: B023
        for reading in ("binary64", "decimal"):
            for eui in (True, False):
                took = seconds(lambda: boundfit.fit(x, y, 0.2, reading=reading, eui=eui), 3)  # type: ignore[arg-type]  # noqa: B023
                shown(f"  {name}, {reading}, {'everything' if eui else 'without the EUI'}", took, least)


def groups() -> None:
    noise = numpy.random.default_rng(1)
    sensors = 10_000
    keys = numpy.repeat([f"s{index}" for index in range(sensors)], 23)
    x = noise.integers(0, 10_000, keys.size) / 1e4
    frame = {"s": list(keys), "x": x, "y": 2 * x + noise.integers(-1000, 1000, keys.size) / 1e4}
    took = seconds(lambda: boundfit.fit_groups(frame, by="s", x="x", y="y", eps=0.2), 3)
    print(f"fit_groups of {sensors:,} sensors with 23 readings: {sensors / took:,.0f} sensors per processor second")


def memory(rows: int) -> None:
    x = numpy.random.default_rng(1).uniform(0, 1, rows)
    y = 2 * x
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    boundfit.fit(x, y, 0.1, reading="binary64")
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"{rows:,} doubles in each of two columns ({16 * rows >> 20} MB): {(after - before) >> 10} MB more at the peak")


if __name__ == "__main__":
    print(f"CPython {platform.python_version()}, numpy {numpy.__version__}, {sys.platform}")
    memory(10_000_000)
    few()
    many(1_000_000)
    groups()
