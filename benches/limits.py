"""What each kind of work costs beside what it cannot be cheaper than, or what it aims at: `side-by-side --only limit`.

The readings are written by polars and NumPy (`peers/tables.py`), in all the ways in which programs print numbers."""

from dataclasses import dataclass, field

LINE = ["--x", "x", "--y", "y"]
MILLIONS = 10_000_000


@dataclass
class Work:
    """One line: a command on a table, and what its CPU time is compared with."""

    name: str
    # What `tables.py` writes: kind, rows, ending.
    table: tuple
    # The words behind the command's name and the table.
    options: list
    # So many times polars' time for reading the table, or so many seconds.
    aim: tuple
    command: str = "fit"
    # Statuses that say what the work is about, such as that of a refuted claim.
    statuses: tuple = (0,)
    # Files that are made before: name and the words that write them.
    before: list = field(default_factory=list)


def line(*options, eps="0.5"):
    return [*LINE, "--eps", eps, "--no-lp", *options]


def texts():
    """10^7 rows of text against polars, which reads and does nothing else."""
    kinds = [
        ("short decimals", "short", "0.5", 0.5, 0.7),
        ("doubles of 15 to 17 digits", "doubles", "0.5", 1, 1),
        ("18 digits with exponents", "long-exponents", "0.5", 1, 1),
        ("quoted cells", "quoted", "0.5", 1.2, 1.2),
        ("time stamps of 19 digits", "times", "0.5", 1.2, 1.2),
        ("integers with ties", "codes", "10", 1.2, 1.2),
        ("7 digits with exponents", "exponents", "0.5", 1.2, 1.2),
    ]
    for name, kind, eps, without, with_eui in kinds:
        table = (kind, MILLIONS, "csv")
        yield Work(f"{name}, CSV, no EUI", table, line("--no-eui", eps=eps), ("polars", without))
        yield Work(f"{name}, CSV", table, line(eps=eps), ("polars", with_eui))
    for name, kind, eps, aim in (("doubles of 15 to 17 digits", "doubles", "0.5", 0.6), ("integers with ties", "codes", "10", 0.35)):
        rounded = line("--no-eui", "--reading", "binary64", eps=eps)
        yield Work(f"{name}, CSV, binary64, no EUI", (kind, MILLIONS, "csv"), rounded, ("s", aim))


def binaries():
    """10^7 rows of doubles in columns."""
    for ending in ("parquet", "arrow"):
        short, doubles = ("short", MILLIONS, ending), ("doubles", MILLIONS, ending)
        yield Work(f"short decimals, {ending}", short, line("--no-eui"), ("s", 0.3))
        yield Work(f"17 digits, {ending}", doubles, line("--no-eui"), ("s", 0.8))
        yield Work(f"17 digits, {ending}, binary64", doubles, line("--reading", "binary64"), ("s", 0.3))
    codes = ("codes", MILLIONS, "parquet")
    yield Work("integers with ties, parquet", codes, line(eps="10"), ("s", 0.8))
    yield Work("integers with ties, parquet, binary64", codes, line("--reading", "binary64", eps="10"), ("s", 1.2))


def digits():
    """2·10^5 rows of ever longer numbers: no cliff."""
    for count in (15, 17, 18, 20, 24, 30, 40):
        yield Work(f"{count} digits, 2·10⁵ rows", (f"digits-{count}", 200_000, "csv"), line(eps="0.6"), ("s", 0.22))


def unlucky():
    """Readings that are ordinary but for their ties, their hull or their denominators."""
    stuck, quantised = ("stuck", 3_000_000, "csv"), ("quantised", 1_000_000, "csv")
    yield Work("3·10⁶ rows of two readings", stuck, line(eps="1"), ("polars", 1.2))
    yield Work("3·10⁶ rows of two readings, json", stuck, line("--format", "json", eps="1"), ("polars", 1.5))
    yield Work("10⁶ quantised rows", quantised, line(eps="3"), ("polars", 1.2))
    for rows, name, eps, csv, text in ((100_000, "10⁵", "3e9", 0.03, 0.1), (1_000_000, "10⁶", "3e11", 0.3, 1)):
        table = ("parabola", rows, "csv")
        yield Work(f"{name} rows, all extreme, csv", table, line("--format", "csv", eps=eps), ("s", csv))
        yield Work(f"{name} rows, all extreme, text", table, line(eps=eps), ("s", text))
        yield Work(f"{name} rows, all extreme, ine", table, line("--format", "ine", eps=eps), ("s", 3 * rows / 1e6))
    yield Work("10⁵ rows from 1e-300 to 1e300", ("wide", 100_000, "csv"), line(eps="1e305"), ("s", 0.2))
    root = ("root", 10_000, "csv")
    yield Work("10⁴ rows of a smooth curve, 15 decimals", root, line(eps="3"), ("s", 0.1))
    yield Work("10⁴ rows of a smooth curve, with the exact area", root, line("--exact", eps="3"), ("s", 0.5))
    few = ("root", 300, "csv")
    yield Work("300 of them, over ε", few, line("--sweep", "2..4", eps="3"), ("s", 2))
    yield Work("300 of them, the lesson", few, [*LINE, "--eps", "3", "-o", "{out}.html"], ("s", 2), command="lesson")


def models():
    """10^6 rows of two regressors and under bounds of their own."""
    two = ["--x", "u,v", "--y", "y", "--eps", "0.5", "--no-lp"]
    each = [*LINE, "--eps-column", "eps", "--no-lp"]
    ends = ["--x", "x", "--lower", "lower", "--upper", "upper", "--no-lp"]
    million = 1_000_000
    yield Work("two regressors", ("regressors", million, "csv"), two, ("s", 0.08))
    yield Work("two regressors, 17 digits", ("regressors-of-doubles", million, "csv"), two, ("s", 0.2))
    yield Work("a bound for each row", ("bounds", million, "csv"), each, ("s", 0.08))
    yield Work("a bound for each row, 17 digits", ("bounds-of-doubles", million, "csv"), each, ("s", 0.15))
    yield Work("an interval for each row", ("bounds", million, "csv"), ends, ("s", 0.1))
    yield Work("an interval for each row, 17 digits", ("intervals-of-doubles", million, "csv"), ends, ("s", 0.2))
    for rows, name, aim in ((1_000, "10³", 0.02), (100_000, "10⁵", 0.1), (million, "10⁶", 0.5)):
        yield Work(f"errors of x too, {name} rows", ("short", rows, "csv"), line("--x-eps", "0.01"), ("s", aim))


def fleets():
    """10^5 sensors of 23 rows."""
    by = [*LINE, "--by", "sensor", "--eps", "0.5", "--format"]
    short, doubles = ("fleet", 100_000, "csv"), ("fleet-of-doubles", 100_000, "csv")
    yield Work("10⁵ sensors × 23 rows, csv", short, [*by, "csv"], ("s", 0.4))
    yield Work("10⁵ sensors × 23 rows, NDJSON", short, [*by, "json"], ("s", 1.3))
    yield Work("10⁵ sensors × 23 rows, 17 digits, csv", doubles, [*by, "csv"], ("s", 0.8))
    groups = line("--by", "g", "--format", "csv")
    yield Work("10⁶ rows of two groups that take turns", ("two-groups", 1_000_000, "csv"), groups, ("s", 0.1))
    yield Work("10⁶ rows of 10⁵ groups without order", ("many-groups", 1_000_000, "csv"), groups, ("s", 0.6))


def commands():
    """The other commands on many rows."""
    short, fewer = ("short", 1_000_000, "csv"), ("short", 100_000, "csv")
    bound = [*LINE, "--eps", "0.5"]
    claim = ["--claim-pui=1.9,2.1,-0.1,0.1"]
    yield Work("23 rows, a process", ("short", 23, "csv"), line(), ("s", 0.0016))
    yield Work("23 rows with the line about an LP solver", ("short", 23, "csv"), bound, ("s", 0.0022))
    yield Work("10⁴ rows with the line about an LP solver", ("short", 10_000, "csv"), bound, ("s", 0.02))
    yield Work("plot --figure data, 10⁶ rows", short, [*bound, "--figure", "data", "-o", "{out}.svg"], ("s", 0.3), "plot")
    yield Work("status, 10⁶ rows", short, bound, ("s", 0.3), "status")
    yield Work("linearity, 10⁶ rows", short, LINE, ("s", 0.3), "linearity")
    yield Work("windows of 100, 10⁵ rows", fewer, line("--window", "100", "--format", "csv"), ("s", 0.5))
    for rows, name, aim in ((10_000, "10⁴", 0.05), (100_000, "10⁵", 0.5)):
        yield Work(f"outliers, 0.1 % wrong, {name} rows", ("wrong", rows, "csv"), bound, ("s", aim), "outliers", (0, 1, 3))
    proof = [("fit", [*line(), "--proof", "{out}.proof", "-o", "{out}.txt"])]
    yield Work("verify, 10⁶ rows", short, ["{out}.proof", "{table}"], ("s", 0.15), "verify", before=proof)
    parabola = ("parabola", 1_000_000, "csv")
    cdd = [("fit", [*line(eps="3e11"), "--format", "ine", "-o", "{out}.ine"])]
    # They take more memory than may be held unless more is asked for.
    asked = ["{out}.ine", "--limit", "memory=4GiB"]
    yield Work("polygon of 10⁶ half-planes", parabola, asked, ("s", 1.5), "polygon", before=cdd)
    yield Work("check --claim-pui, 10⁵ rows", fewer, [*bound, *claim], ("s", 0.3), "check", statuses=(0, 4))
    yield Work("check with all solvers, 10⁵ rows", fewer, bound, ("s", 1), "check")
    mps = ["--to", "mps", "--objective", "theta1-min", "-o", "{out}.mps"]
    yield Work("convert --to mps, 10⁶ rows", short, [*bound, *mps], ("s", 1.5), "convert")


def surfaces():
    """What Python takes for one call: name, what `peers.py` does, the table, ε and the aim in seconds."""
    for digits, kind, aim in (("short decimals", "short", 12e-6), ("17 digits", "doubles", 20e-6)):
        yield f"Python, fit of 23 rows, {digits}", "boundfit-fit", (kind, 23), "0.5", aim
    for rows, name, aim in ((1_000, "1 000", 0.3e-3), (10_000, "10 000", 1.2e-3), (10_001, "10 001", 1.2e-3)):
        yield f"Python, fit of {name} rows, 17 digits", "boundfit-fit", ("doubles", rows), "0.5", aim
    yield "Python, fit_groups of 10⁵ sensors × 23 rows", "boundfit-groups", ("fleet", 100_000), "0.5", 0.7


# The rows of a lesson about a smooth curve, and the seconds that an edit of it should take.
LESSONS = {100: 0.06, 300: 0.2}


def works():
    for kind in (texts, binaries, digits, unlucky, models, fleets, commands):
        yield from kind()


def arguments(work, table, out):
    """The words of a command; it begins with its table unless it names that itself or what was made of it."""
    words = [word.format(table=table, out=out) for word in work.options]
    named = any("{table}" in word or word.endswith(".ine") and "-o" not in work.options for word in work.options)
    return [work.command, *([] if named else [table]), *words]
