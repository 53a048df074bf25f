"""Writes generated readings with polars and NumPy, as programs print them: tables.py KIND ROWS FILE.

The same arguments give the same bytes, of the same version of the libraries. KIND is one of those in KINDS; a file that
ends in .parquet or .arrow holds the numbers as doubles, any other text."""

import json
import sys

SENSOR_ROWS = 23


def line(x, spread, random):
    return 2 * x + random.uniform(-spread, spread, len(x))


def short(n, random):
    """x with 4 and y with 7 decimals, as doubles nearest to them are printed."""
    x = random.integers(-99_999, 99_999, n)
    return {"x": x / 1e4, "y": (2000 * x + random.integers(-4_900_000, 4_900_000, n)) / 1e7}


def doubles(n, random):
    """15 to 17 digits."""
    x = random.normal(size=n)
    return {"x": x, "y": line(x, 0.49, random)}


def times(n, random):
    """Nanoseconds since 1970, of 19 digits."""
    import numpy

    start, span = 1_700_000_000 * 10**9, 10**15
    x = start + numpy.sort(random.integers(0, span, n))
    return {"x": x, "y": numpy.round((x - start) / span * 3 + random.uniform(-0.4, 0.4, n), 6)}


def codes(n, random):
    """Integers of a 12-bit converter, with many ties."""
    x = random.integers(0, 4096, n)
    return {"x": x, "y": 3 * x + random.integers(-8, 9, n)}


def quantised(n, random):
    """16 values of x."""
    x = random.integers(0, 16, n)
    return {"x": x, "y": 2 * x + random.integers(-2, 3, n)}


def stuck(n, _random):
    """Two readings, again and again."""
    import numpy

    return {"x": numpy.tile([1, 2], n // 2), "y": numpy.ones(n // 2 * 2, dtype=int)}


def parabola(n, _random):
    """Every row extreme."""
    import numpy

    x = numpy.arange(n)
    return {"x": x, "y": x * x}


def root(n, random):
    """A smooth curve at uneven x, both with 15 decimals: every vertex has a denominator of its own."""
    import numpy

    x = numpy.sort(random.uniform(0, 100, n))
    return {"x": [f"{each:.15f}" for each in x], "y": [f"{each:.15f}" for each in numpy.sqrt(x)]}


def regressors(n, random):
    import numpy

    u, v = random.integers(-9999, 9999, n) / 1e3, random.integers(-9999, 9999, n) / 1e3
    return {"u": u, "v": v, "y": numpy.round(1.5 * u - 2 * v + random.uniform(-0.49, 0.49, n), 5)}


def regressors_of_doubles(n, random):
    u, v = random.normal(size=n), random.normal(size=n)
    return {"u": u, "v": v, "y": 1.5 * u - 2 * v + random.uniform(-0.49, 0.49, n)}


def bounds(n, random):
    """An error bound and an interval for each row."""
    import numpy

    x = random.integers(-99_999, 99_999, n) / 1e4
    y, eps = numpy.round(line(x, 0.4, random), 7), numpy.round(random.uniform(0.4, 0.6, n), 4)
    return {"x": x, "y": y, "eps": eps, "lower": numpy.round(y - eps, 7), "upper": numpy.round(y + eps, 7)}


def bounds_of_doubles(n, random):
    x, eps = random.normal(size=n), random.uniform(0.4, 0.6, n)
    return {"x": x, "y": line(x, 0.4, random), "eps": eps}


def intervals_of_doubles(n, random):
    x, eps = random.normal(size=n), random.uniform(0.4, 0.6, n)
    y = line(x, 0.4, random)
    return {"x": x, "lower": y - eps, "upper": y + eps}


def fleet(n, random):
    """`n` sensors of 23 rows."""
    import numpy

    x = numpy.tile(numpy.arange(SENSOR_ROWS), n) + random.integers(0, 99, SENSOR_ROWS * n) / 100
    return {"sensor": numpy.repeat(numpy.arange(n), SENSOR_ROWS), "x": x, "y": numpy.round(line(x, 0.4, random), 4)}


def fleet_of_doubles(n, random):
    import numpy

    x = numpy.tile(numpy.arange(SENSOR_ROWS), n) + random.uniform(0, 1, SENSOR_ROWS * n)
    return {"sensor": numpy.repeat(numpy.arange(n), SENSOR_ROWS), "x": x, "y": line(x, 0.4, random)}


def groups(count):
    """Readings that belong to so many groups without order; two take turns."""

    def columns(n, random):
        import numpy

        g = numpy.arange(n) % 2 if count == 2 else random.integers(0, count, n)
        return {"g": g, **short(n, random)}

    return columns


def wrong(n, random):
    """One reading of a thousand is wrong."""
    columns = short(n, random)
    columns["y"][random.choice(n, n // 1000, replace=False)] += 30
    return columns


def wide(n, random):
    """Numbers between 1e-300 and 1e300."""
    x = 10.0 ** random.uniform(-300, 300, n)
    return {"x": x, "y": x * random.uniform(1.9, 2.1, n)}


def digits(count):
    """Numbers between 0 and 1 with so many decimals."""

    def columns(n, random):
        def column():
            return ["0." + "".join(map(str, row)) for row in random.integers(0, 10, (n, count))]

        return {"x": column(), "y": column()}

    return columns


KINDS = {
    "short": (short, {}),
    "quoted": (short, {"quote_style": "always"}),
    "doubles": (doubles, {}),
    "exponents": (doubles, {"float_scientific": True, "float_precision": 6}),
    "long-exponents": (doubles, {"float_scientific": True, "float_precision": 18}),
    "times": (times, {}),
    "codes": (codes, {}),
    "quantised": (quantised, {}),
    "stuck": (stuck, {}),
    "parabola": (parabola, {}),
    "root": (root, {"quote_style": "never"}),
    "regressors": (regressors, {}),
    "regressors-of-doubles": (regressors_of_doubles, {}),
    "bounds": (bounds, {}),
    "bounds-of-doubles": (bounds_of_doubles, {}),
    "intervals-of-doubles": (intervals_of_doubles, {}),
    "two-groups": (groups(2), {}),
    "many-groups": (groups(100_000), {}),
    "wrong": (wrong, {}),
    "wide": (wide, {}),
    "fleet": (fleet, {}),
    "fleet-of-doubles": (fleet_of_doubles, {}),
    **{f"digits-{count}": (digits(count), {"quote_style": "never"}) for count in (15, 17, 18, 20, 24, 30, 40)},
}


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in KINDS:
        sys.exit(f"usage: tables.py {'|'.join(KINDS)} ROWS FILE")
    kind, rows, file = sys.argv[1:]
    try:
        import numpy
        import polars
    except ModuleNotFoundError as error:
        print(json.dumps({"missing": error.name}))
        return
    columns, style = KINDS[kind]
    table = polars.DataFrame(columns(int(rows), numpy.random.default_rng(7)))
    if file.endswith((".parquet", ".arrow")):
        table = table.cast(polars.Float64)
        table.write_parquet(file) if file.endswith(".parquet") else table.write_ipc(file)
    else:
        table.write_csv(file, **style)
    print(json.dumps({"rows": table.height}))


main()
