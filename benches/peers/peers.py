"""The same work in Python libraries: peers.py WORK FILE EPS RUNS prints one line of JSON with medians in seconds.

FILE has the columns x and y, for fleet-... also sensor, sorted by sensor. Each library is imported where it is used:
one that is missing fails alone."""

import json
import statistics
import sys
import time

# Work that is shorter than this is repeated within one run: clocks are coarse.
SHORTEST_RUN = 0.005


def timed(runs, work):
    """The medians of wall clock and processor time, and the result. One run is not repeated: it may be a long one."""
    repetitions = 1
    if runs > 1:
        start = time.perf_counter()
        work()
        repetitions += int(SHORTEST_RUN / (time.perf_counter() - start))
    walls, processors = [], []
    for _ in range(runs):
        wall, processor = time.perf_counter(), time.process_time()
        for _ in range(repetitions):
            result = work()
        walls.append((time.perf_counter() - wall) / repetitions)
        processors.append((time.process_time() - processor) / repetitions)
    times = {"wall": statistics.median(walls), "cpu": statistics.median(processors), "runs": runs}
    return times, result


def columns(file, which=(0, 1)):
    import numpy

    return numpy.loadtxt(file, delimiter=",", skiprows=1, usecols=which, unpack=True)


def sensors(file):
    """x and y of each sensor."""
    groups = {}
    with open(file) as lines:
        next(lines)
        for line in lines:
            name, x, y = line.split(",")
            group = groups.setdefault(name, ([], []))
            group[0].append(float(x))
            group[1].append(float(y))
    return list(groups.values())


def qhull(file, _epsilon, runs):
    import numpy
    import scipy
    from scipy.spatial import ConvexHull

    points = numpy.column_stack(columns(file))
    times, hull = timed(runs, lambda: ConvexHull(points))
    return {**times, "corners": len(hull.vertices), "versions": [f"SciPy {scipy.__version__}"]}


def least_squares(file, _epsilon, runs):
    import numpy

    x, y = columns(file)
    regressors = numpy.column_stack([x, numpy.ones_like(x)])
    times, answer = timed(runs, lambda: numpy.linalg.lstsq(regressors, y))
    return {**times, "least_squares": list(answer[0]), "versions": [f"NumPy {numpy.__version__}"]}


def sum_of_columns(file, _epsilon, runs):
    import numpy

    x, y = columns(file)
    return {**timed(runs, lambda: (x.sum(), y.sum()))[0], "versions": [f"NumPy {numpy.__version__}"]}


def interval_ends(highspy, x, y, epsilon):
    """The PUI by one ranged row for each reading and four objectives, each started from the optimum before it."""
    import numpy

    count = len(x)
    highs = highspy.Highs()
    highs.setOptionValue("output_flag", False)
    highs.setOptionValue("threads", 1)
    program = highspy.HighsLp()
    program.num_col_, program.num_row_ = 2, count
    program.col_cost_ = numpy.zeros(2)
    program.col_lower_, program.col_upper_ = numpy.full(2, -numpy.inf), numpy.full(2, numpy.inf)
    program.row_lower_, program.row_upper_ = y - epsilon, y + epsilon
    program.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    program.a_matrix_.start_ = numpy.array([0, count, 2 * count], dtype=numpy.int32)
    program.a_matrix_.index_ = numpy.tile(numpy.arange(count, dtype=numpy.int32), 2)
    program.a_matrix_.value_ = numpy.concatenate([x, numpy.ones(count)])
    highs.passModel(program)
    ends = []
    for column in range(2):
        for cost in (1.0, -1.0):
            highs.changeColCost(0, cost if column == 0 else 0.0)
            highs.changeColCost(1, cost if column == 1 else 0.0)
            highs.run()
            if highs.getModelStatus() != highspy.HighsModelStatus.kOptimal:
                raise RuntimeError(highs.modelStatusToString(highs.getModelStatus()))
            ends.append(highs.getSolution().col_value[column])
    return [ends[:2], ends[2:]]


def highs(file, epsilon, runs):
    import highspy

    x, y = columns(file)
    times, pui = timed(runs, lambda: interval_ends(highspy, x, y, epsilon))
    return {**times, "pui": pui, "versions": [f"HiGHS {highspy.Highs().version()}"]}


def fleet_highs(file, epsilon, runs):
    import highspy
    import numpy

    fleet = [(numpy.array(x), numpy.array(y)) for x, y in sensors(file)]
    times, pui = timed(runs, lambda: [interval_ends(highspy, x, y, epsilon) for x, y in fleet])
    return {**times, "pui": pui, "versions": [f"HiGHS {highspy.Highs().version()}"]}


def fleet_linprog(file, epsilon, runs):
    import numpy
    import scipy
    from scipy.optimize import linprog

    def programs(x, y):
        regressors = numpy.column_stack([x, numpy.ones(len(x))])
        return numpy.vstack([regressors, -regressors]), numpy.concatenate([y, -numpy.array(y)]) + epsilon

    def ends(rows, bounds):
        def end(cost, column):
            return linprog(cost, A_ub=rows, b_ub=bounds, bounds=(None, None), method="highs").x[column]

        return [[end((1, 0), 0), end((-1, 0), 0)], [end((0, 1), 1), end((0, -1), 1)]]

    fleet = [programs(x, y) for x, y in sensors(file)]
    times, pui = timed(runs, lambda: [ends(*rows) for rows in fleet])
    return {**times, "pui": pui, "versions": [f"SciPy {scipy.__version__}"]}


def read_polars(file, _epsilon, runs):
    import polars

    times, table = timed(runs, lambda: polars.read_csv(file))
    return {**times, "rows": table.height, "versions": [f"polars {polars.__version__}"]}


def read_polars_least_squares(file, _epsilon, runs):
    import numpy
    import polars

    def work():
        table = polars.read_csv(file)
        x, y = table["x"].to_numpy(), table["y"].to_numpy()
        return numpy.linalg.lstsq(numpy.column_stack([x, numpy.ones_like(x)]), y)[0]

    times, theta = timed(runs, work)
    return {**times, "least_squares": list(theta), "versions": [f"polars {polars.__version__}"]}


def read_duckdb(file, _epsilon, runs):
    import duckdb

    connection = duckdb.connect()
    connection.execute("SET threads = 2")

    def work():
        connection.execute(f"CREATE OR REPLACE TABLE readings AS SELECT * FROM read_csv('{file}')")
        return connection.execute("SELECT count(*) FROM readings").fetchone()[0]

    times, rows = timed(runs, work)
    return {**times, "rows": rows, "versions": [f"duckdb {duckdb.__version__}"]}


def boundfit_fit(file, epsilon, runs):
    import boundfit

    x, y = columns(file)
    times, _ = timed(runs, lambda: boundfit.fit(x, y, epsilon))
    return {**times, "rows": len(x)}


def boundfit_groups(file, epsilon, runs):
    import boundfit
    import polars

    frame = polars.read_csv(file)
    times, _ = timed(runs, lambda: boundfit.fit_groups(frame, by="sensor", x="x", y="y", eps=epsilon))
    return {**times, "rows": frame.height}


WORK = {
    "qhull": qhull,
    "least-squares": least_squares,
    "sum": sum_of_columns,
    "highs": highs,
    "fleet-highs": fleet_highs,
    "fleet-linprog": fleet_linprog,
    "read-polars": read_polars,
    "read-polars-least-squares": read_polars_least_squares,
    "read-duckdb": read_duckdb,
    "boundfit-fit": boundfit_fit,
    "boundfit-groups": boundfit_groups,
}


def main():
    if len(sys.argv) != 5 or sys.argv[1] not in WORK:
        sys.exit(f"usage: peers.py {'|'.join(WORK)} FILE EPS RUNS")
    work, file, epsilon, runs = sys.argv[1:]
    try:
        print(json.dumps(WORK[work](file, float(epsilon), int(runs))))
    except ModuleNotFoundError as error:
        print(json.dumps({"missing": error.name}))


main()
