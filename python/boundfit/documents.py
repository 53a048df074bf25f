"""The documents that boundfit writes, as types: what ``to_dict()`` gives. Made by ``cargo xtask generate``."""

from __future__ import annotations

from typing import Literal, NotRequired, TypedDict, Union


class FitDocument(TypedDict):
    """A fit: the feasible parameter set of the readings, and every estimate from it."""

    schema: Literal["boundfit/fit/2"]
    """The name and number of this schema."""
    program: Program
    """The program that wrote the document."""
    input: Input
    """The question."""
    least_squares: FitLeastSquares | None
    """The least-squares estimate θ̂; null where the readings do not determine it."""
    eui: list[ExactRange] | None
    """The estimate uncertainty intervals of θ1 and θ2; null where they are not known."""
    fps: ActiveRegion
    """The feasible parameter set."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals of θ1 and θ2; null where no end is bounded."""
    central: Central | None
    """The central estimate; null where the set is empty or unbounded."""
    slopes: Slopes | None
    """The steepest and the shallowest line; null for an empty set and for two regressors."""
    epsilon_min: Exact | None
    """The least error bound with a feasible parameter, rounded up; null where bounds differ between readings (see `minimax`)."""
    inverse: Inverses | None
    """Gain and offset, which turn readings into x; null unless the model is a line."""
    minimax: Minimax | None
    """The minimax estimate; null where no factor on the bounds leaves a feasible parameter."""
    tightness: Exact | None
    """The area of the feasible set over that of its PUI box, rounded to nearest; null where the box has no finite area above 0."""
    area_centroid: list[Exact] | None
    """The centroid of the area, rounded to nearest; null where the set has no finite area above 0."""
    mended_without: list[int] | None
    """The rows of an empty set whose removal alone makes it non-empty; null for other sets and where not all rows are in memory."""
    reasons: dict[str, str]
    """The reason for each main part that is null."""
    sweep: NotRequired[Sweep]
    """The sets under scaled error bounds; absent unless asked for."""
    guarantee: NotRequired[Guarantee]
    """The guarantee for further readings; absent unless asked for, and where there is no least error bound."""


class XErrorDocument(TypedDict):
    """A fit of a line to readings whose x have errors, too."""

    schema: Literal["boundfit/x-errors/2"]
    """The name and number of this schema."""
    program: Program
    """The program that wrote the document."""
    input: Input
    """The question."""
    x_epsilon: Exact | None
    """The bound on the errors of all x, rounded up; null where a column has them."""
    x_epsilon_column: str | None
    """The column of bounds on the errors of x; null where one bound holds for all."""
    agreement: Literal["weak", "strong"]
    """`weak`: a line agrees with a reading for some x that the errors allow; `strong`: for every such x."""
    sides: list[XErrorSide]
    """The sets of lines with θ1 ≥ 0 and with θ1 ≤ 0, or the one set of both."""
    pieces: int
    """The number of sets that make up all of it, without one that another contains."""
    joined: bool | None
    """True if two sets have lines with θ1 = 0 in common; null unless there are two."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals over all sets; null where no end is bounded."""
    central: XErrorCentral | None
    """The central estimate; null where there are no lines or the set is unbounded."""
    slopes: Slopes | None
    """The steepest and the shallowest line; null where there are no lines."""
    factor: Factor | None
    """The least factor on the bounds of x and y; null where it is not known."""
    least_squares: XErrorLeastSquares | None
    """The least-squares estimate as if every x were exact; null where the readings do not determine it."""
    eui: list[ExactRange] | None
    """The estimate uncertainty intervals as if every x were exact, rounded outward; null where they are not known."""
    reasons: dict[str, str]
    """The reason for each main part that is null."""


class GroupDocument(TypedDict):
    """A group of readings, and what they say."""

    schema: Literal["boundfit/fleet/2"]
    """The name and number of this schema."""
    input: LineInput
    """The input, the same for all lines."""
    group: str
    """The text in the column of groups."""
    rows: int
    """The number of readings of the group."""
    first_row: int | None
    """The first row of the group; null where rows are not kept."""
    least_squares: LeastSquares | None
    """The least-squares estimate; null where the readings do not determine it."""
    eui: list[ExactRange] | None
    """The estimate uncertainty intervals, rounded outward; null where they are not known."""
    fps: GroupSet
    """The feasible parameter set of the group."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals; null where no end is bounded."""
    central: Central | None
    """The central estimate; null where the set is empty or unbounded."""
    epsilon_min: Exact | None
    """The least error bound with a feasible parameter, rounded up; null where bounds differ between readings."""
    epsilon_factor: Exact | None
    """The least common factor on the bounds that leaves a feasible parameter, rounded up; null under one bound for all readings."""


class WindowDocument(TypedDict):
    """A window of consecutive readings, and what they say."""

    schema: Literal["boundfit/window/1"]
    """The name and number of this schema."""
    input: LineInput
    """The input, the same for all lines."""
    first_row: int
    """The row of the first reading of the window."""
    last_row: int
    """The row of the last reading of the window."""
    rows: int
    """The number of readings in it."""
    x: list[Exact] | None
    """The x of the oldest and of the newest reading, exact; null with two regressors."""
    fps: FeasibleSet
    """The feasible parameter set of the window."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals; null where no end is bounded."""
    central: Central | None
    """The central estimate; null where the set is empty or unbounded."""
    epsilon_min: Exact | None
    """The least error bound with a feasible parameter, rounded up; null unless the model is a line under one bound without conditions."""


class StatusesDocument(TypedDict):
    """The status of every reading: what the set of all readings, and that of the others, say of it. Each reading is on a line of its own."""

    schema: Literal["boundfit/status/1"]
    """The name and number of this schema."""
    input: Input
    """The question."""
    set: JudgedSet
    """The set of all readings."""
    deciding: list[int]
    """The rows whose removal may change the set: those with an irredundant bound, for an empty set those of the contradiction."""
    rows: list[StatusRow]
    """The status of each reading."""
    new: NotRequired[NewStatuses]
    """The status of further readings; absent unless asked for."""
    repair: NotRequired[Repair]
    """The least total widening of the bounds of an empty set; absent unless asked for."""


PredictionDocument = TypedDict(
    "PredictionDocument",
    {
        # The name and number of this schema.
        "schema": "Literal[\"boundfit/predict/1\"]",
        # The question.
        "input": "Input",
        # The feasible parameter set.
        "fps": "FeasibleSet",
        # The error of a further reading; null where nothing is known of it, with a reason.
        "new_reading": "NewReading | None",
        # The prediction at each value asked for; empty where the set is empty.
        "at": "list[Predicted]",
        # The sources of each reading asked for; empty where the set is empty.
        "from": "list[Source]",
        # The reason for each part that is null or empty.
        "reasons": "dict[str, str]",
    },
)
"""The values of all feasible lines at given x, and the x that given readings may come from."""


class NextReadingDocument(TypedDict):
    """The x where one more reading certainly makes the feasible set smaller, and the best x of a range."""

    schema: Literal["boundfit/next/1"]
    """The name and number of this schema."""
    input: Input
    """The question."""
    fps: FeasibleSet
    """The feasible parameter set."""
    new_reading: NewReading
    """The error of the next reading."""
    certain: list[ExactRange] | None
    """The open intervals of x, ascending, where a reading certainly makes the set smaller. Decimals and doubles are rounded inward. Null where the set is empty."""
    within: SearchRange | None
    """The range in which the best x is looked for; null where the set is empty or the x of the readings are not known."""
    certain_within: bool | None
    """True if a reading certainly makes the set smaller somewhere in `within`; null where `within` is."""
    goals: list[Goal]
    """The best x of the range for each goal; empty where `within` is null."""
    reasons: dict[str, str]
    """The reason for each part that is null and for each goal that is left out."""


class OutliersDocument(TypedDict):
    """The fewest readings to exclude so that a feasible parameter is left, and all ways to do so."""

    schema: Literal["boundfit/outliers/1"]
    """The name and number of this schema."""
    input: Input
    """The question."""
    least: int | None
    """The fewest readings to exclude; null where the conditions contradict each other."""
    sets: list[list[int]]
    """Every set of `least` rows whose exclusion leaves a feasible parameter, ascending, in lexicographic order; `[[]]` where no reading has to be excluded."""
    complete: bool
    """True if these are all sets; false beyond the limit `sets`."""
    pieces: list[list[ExactActiveVertex]]
    """For each set, in the order of `sets`, the vertices of the parameters that remain, counter-clockwise. The pieces have no point in common; together they are the parameters that miss at most `least` readings."""
    regions: list[LeftRegion]
    """The rest of the piece of each set, in the same order."""
    pui: list[ExactRange] | None
    """The ranges of θ1 and θ2 over all pieces, rounded outward; null where there are none."""
    area: Exact | None
    """The sum of the areas of all pieces, rounded to nearest; null where it is infinite."""
    growth: list[Growth]
    """The parameters that miss at most 0, 1, 2, … readings, up to `least` or to the number asked for."""
    certificate: Certificate | None
    """The proof that the conditions contradict each other; null otherwise."""
    reasons: dict[str, str]
    """The reason for each main part that is null or not complete."""


class LinearRangeDocument(TypedDict):
    """The runs of consecutive readings that one line fits. Positions count from 1 in `order`."""

    schema: Literal["boundfit/range/1"]
    """The name and number of this schema."""
    input: Input
    """The question."""
    by: Literal["x", "row"]
    """The order of the readings: by x, or by row."""
    order: list[int]
    """The row at each position."""
    runs: list[list[int]]
    """First and last position of each run that cannot be made longer, ascending."""
    longest: list[int] | None
    """The run with the most readings; null where no reading fits."""
    widest: list[int] | None
    """The run with the widest range of x; null where the order is not by x or x is not known."""
    fewest: list[list[int]]
    """The fewest runs that together have every reading that is in a run."""
    parts: list[Run]
    """Each run with what stops it, in the order of `runs`."""
    alone: list[Alone]
    """The readings that are in no run."""
    longest_fit: Longest | None
    """The fit of the longest run; null where there is none."""


class LinearityDocument(TypedDict):
    """The linearity of a calibration: the deviation of its average characteristic from four lines, hysteresis and repeatability."""

    schema: Literal["boundfit/linearity/1"]
    """The name and number of this schema."""
    input: Calibration
    """The question."""
    full_scale: Exact
    """The number that percents refer to, exact."""
    span: Exact
    """The largest less the smallest y, exact."""
    independent: LinearityLine
    """The line with the least deviation."""
    terminal: LinearityLine | None
    """The line through the first and the last point; null where all x are the same."""
    zero_based: LinearityLine
    """The line through the point `through` with the least deviation."""
    least_squares: LinearityLine | None
    """The least-squares line; null where all x are the same."""
    hysteresis: Exact | None
    """The largest difference between both directions, rounded up; null where no x was read in both."""
    repeatability: Exact | None
    """The largest difference between readings at one x in one direction, rounded up; null where there are none."""
    hysteresis_percent: Exact | None
    """Hysteresis in percent of full scale, rounded up; null where either is unknown or full scale is 0."""
    repeatability_percent: Exact | None
    """Repeatability in percent of full scale, rounded up; null where either is unknown or full scale is 0."""
    hysteresis_at: list[Place]
    """Each x where hysteresis is reached."""
    repeatability_at: list[Place]
    """Each x where repeatability is reached."""
    proof: list[Alternating]
    """The points that prove the independent linearity; none where it is 0."""
    through: list[Exact]
    """The point x, y through which the zero-based line goes, exact."""
    up: Characteristic | None
    """The characteristic with rising x; null without directions."""
    down: Characteristic | None
    """The characteristic with falling x; null without directions."""
    reasons: dict[str, str]
    """The reason for each part that is null."""


class PolygonDocument(TypedDict):
    """The set that half-planes or generators of a file make."""

    schema: Literal["boundfit/polygon/2"]
    """The name and number of this schema."""
    input: HalfPlaneFile
    """The question."""
    region: RowNumberRegion
    """The set; `active` are rows of half-planes, or of generators the points that equal a vertex or are on a boundary."""
    redundant: list[int]
    """The rows that are not needed."""
    facets: NotRequired[list[HalfPlane]]
    """The half-planes of a set that was given by generators; proofs name them by their number here, from 1. Absent otherwise."""
    bounds: list[Interval] | None
    """The ranges of both coordinates with their proofs; null where no end is bounded."""
    area_centroid: list[Exact] | None
    """The centroid of the area, rounded to nearest; null where the set has no finite area above 0."""
    squared_diameter: Exact | None
    """The square of the largest distance of two points, exact; null for an empty and for an unbounded set."""
    reasons: NotRequired[dict[str, str]]
    """For each number whose fraction is too long to be written, the reason; absent if there are none."""


class CheckDocument(TypedDict):
    """The verdicts on the answers of LP solvers to the four linear programs of a fit."""

    schema: Literal["boundfit/check/2"]
    """The name and number of this schema."""
    input: CheckInput
    """The data of the answers."""
    tolerance: Exact
    """The tolerance that was asked for."""
    digits_as_printed: bool
    """True if a claim may be off by the rounding of its last printed digit."""
    readings: Readings
    """The readings of the programs."""
    claims: list[Claim]
    """The answers, judged."""
    worst: Worst | None
    """The worst verdict against the data as read, which decides the exit status; null without answers."""
    worst_as_received: Worst | None
    """The worst verdict against the doubles that a solver receives; null where no answer is judged by them."""
    directions: Directions | None
    """Approximations of the set by linear programs in many directions; null unless asked for."""


class JudgeDocument(TypedDict):
    """The exact answer to a linear program, and the verdicts on solutions. Vectors have an entry per column, in the order of the model."""

    schema: Literal["boundfit/judge/1"]
    """The name and number of this schema."""
    input: Model
    """The model."""
    status: Literal["optimal", "infeasible", "unbounded"]
    """The status."""
    objective: Exact | None
    """The optimum with the constant, exact; null unless optimal."""
    face: Face | None
    """All optimal points; null unless optimal."""
    columns: list[ModelColumn]
    """The columns."""
    rows: list[ModelRow]
    """The rows."""
    farkas: list[SideTerm] | None
    """Bounds with multipliers that prove infeasibility: the forms add up to 0, the bounds to more than 0. Null unless infeasible."""
    point: list[Exact] | None
    """A feasible point, exact; null unless unbounded."""
    ray: list[Exact] | None
    """A direction that stays feasible and improves; null unless unbounded."""
    plane: Plane
    """The feasible set in the plane of the columns that bounds do not fix."""
    solutions: NotRequired[list[Solution]]
    """The verdicts on solution files; absent if none was given."""


class VerifyDocument(TypedDict):
    """The verdict on a proof."""

    schema: Literal["boundfit/verify/1"]
    """The name and number of this schema."""
    verified: bool
    """True if every statement is true of the data, and the question is the one asked. Only the rows and conditions of a theorem for Coq are compared: `coqc` alone checks what it concludes."""
    half_planes: int | None
    """The number of half-planes; null unless the proof is true."""
    falsehood: str | None
    """The first false statement, or the first of the differences; null when verified."""
    differences: list[str]
    """The differences between the question of the proof and the one asked, a sentence each."""
    proof: str | None
    """The file of the proof; null for standard input."""
    data: str | None
    """The file of the data; null for standard input."""
    about: About
    """The question of the proof, whether the proof is true or not."""
    set: ProvedSet | None
    """The proved facts about the feasible set; null unless the proof is true and about one set."""
    theorem_rows: int | None
    """The number of rows of a theorem for Coq, all of which are those of the data; null for other proofs."""
    statements: list[Proved] | None
    """The proved statements, in the order of a proof `boundfit/proof/2`; null unless the proof is true and of that kind."""


class ProofDocument(TypedDict):
    """A proof of a fit: the feasible set and the ranges of both parameters."""

    schema: Literal["boundfit/proof/1"]
    """The name and number of this schema."""
    sha256: str
    """SHA-256 of the bytes of the data."""
    delimiter: str
    """The character between cells."""
    header: bool
    """True if the first row names the columns."""
    rows: list[int]
    """First and last row of each range, one after the other."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    model: list[list[int | str]]
    """φ1, φ2, y and ε: the number of a column, and by how much it is multiplied. Column 0 holds 1 in every row."""
    interval: NotRequired[list[int | None]]
    """The columns of lower and of upper bounds that take the place of y and ε; absent if there are none."""
    law: NotRequired[list[list[list[str | int | str]]]]
    """The bounds above and below y beside ε: a quantity, `abs` or `written`, the number of a column, and by how much it is multiplied. Absent without a law."""
    x_origin: NotRequired[str]
    """The number that is taken from the column of φ1 before it is multiplied; absent if it is 0."""
    x_error: NotRequired[list[int | str]]
    """The column of bounds on the errors of x, and by how much it is multiplied; absent where x is exact."""
    response: NotRequired[list[list[int | str]]]
    """The columns whose sum takes the place of y, and by how much each is multiplied; absent if there are none."""
    conditions: list[list[str]]
    """The conditions a1·θ1 + a2·θ2 ≤ b as a1, a2 and b; a fourth text `=` makes an equation."""
    vertices: list[list[str]]
    """The vertices θ."""
    active: list[list[int | str]]
    """Every half-plane whose border passes through a vertex, with the index of the vertex from 0."""
    sides: list[list[str | int | None]]
    """The sides by angle, each with the index of the vertex where it meets the next one; null where it does not."""
    farkas: list[list[str]]
    """The terms that prove an empty set; empty for other sets."""
    bounds: list[list[list[list[str]] | list[str]]]
    """The ends of θ1 and of θ2, lower before upper; empty for an empty set."""


class StatementsDocument(TypedDict):
    """A proof of statements, each about the set of some of the rows."""

    schema: Literal["boundfit/proof/2"]
    """The name and number of this schema."""
    sha256: str
    """SHA-256 of the bytes of the data."""
    delimiter: str
    """The character between cells."""
    header: bool
    """True if the first row names the columns."""
    rows: list[int]
    """First and last row of each range, one after the other."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    model: list[list[int | str]]
    """φ1, φ2, y and ε: the number of a column, and by how much it is multiplied. Column 0 holds 1 in every row."""
    interval: NotRequired[list[int | None]]
    """The columns of lower and of upper bounds that take the place of y and ε; absent if there are none."""
    law: NotRequired[list[list[list[str | int | str]]]]
    """The bounds above and below y beside ε: a quantity, `abs` or `written`, the number of a column, and by how much it is multiplied. Absent without a law."""
    x_origin: NotRequired[str]
    """The number that is taken from the column of φ1 before it is multiplied; absent if it is 0."""
    x_error: NotRequired[list[int | str]]
    """The column of bounds on the errors of x, and by how much it is multiplied; absent where x is exact."""
    response: NotRequired[list[list[int | str]]]
    """The columns whose sum takes the place of y, and by how much each is multiplied; absent if there are none."""
    conditions: list[list[str]]
    """The conditions a1·θ1 + a2·θ2 ≤ b as a1, a2 and b; a fourth text `=` makes an equation."""
    statements: list[Statement]
    """The statements."""


class Active(TypedDict):
    """The name of a half-plane."""

    row: int | None
    """The number of the row in the file, from 1; null for a condition and for the sign of the slope."""
    bound: str
    """The bound of the row, `upper` or `lower`; or the condition, `where:1`; of an equation `where:1 upper` (≤) or `where:1 lower` (≥). Under errors in x a corner of the box follows, `upper left`, and `theta1 >= 0` is the side itself."""


class ActiveList(TypedDict):
    """Half-planes whose borders pass through a vertex, or are a side of the set."""

    active: list[Active]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class ActiveRegion(TypedDict):
    """A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    vertices: list[ExactActiveVertex]
    """The vertices, counter-clockwise from the lexicographically smallest."""
    rays: list[list[Exact]]
    """Directions in which the set goes on without end, as coprime integers."""
    lines: list[list[Exact]]
    """Directions in which the set goes on without end both ways, as coprime integers."""
    boundaries: list[ActiveList]
    """The half-planes behind each side of a set without vertices; otherwise empty."""
    witness: list[Exact] | None
    """A point of the set, exact; null for the empty set."""
    area: Exact | None
    """The area, rounded to nearest; null for an empty and for an infinite set."""
    certificate: Certificate | None
    """The proof that the set is empty; null for other sets and where `farkas` of the answer has it."""


class Blocks(TypedDict):
    """The blocks of a file."""

    total: int
    """The number of blocks in the file."""
    read: int | None
    """The number of the block that was read, from 1; null where all were."""
    name: str | None
    """The name of that block; null where it has none."""


class Bound(TypedDict):
    """An end of an interval: a number with the terms that prove it. All forms of the number are null where nothing bounds."""

    exact: str | None
    """The end as a fraction `p/q` or an integer; null where nothing bounds."""
    decimal: str | None
    """A decimal, rounded outward; null where nothing bounds."""
    value: float | None
    """The nearest double; null where nothing bounds and beyond the largest double."""
    outward: float | None
    """The next double that is not inside; null where nothing bounds and beyond the largest double."""
    active: list[Term]
    """The terms that prove the end; empty where nothing bounds."""


class Breakpoint(TypedDict):
    """A factor at which half-planes enter or leave the shape, and the set there."""

    s: Exact
    """The factor, rounded up."""
    epsilon: Exact | None
    """The error bound s·ε, rounded up; null where readings differ in their bounds."""
    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    vertices: list[ExactActiveVertex]
    """The vertices, counter-clockwise from the lexicographically smallest."""
    rays: list[list[str]]
    """Directions in which the set goes on without end, as coprime integers."""
    lines: list[list[str]]
    """Directions in which the set goes on without end both ways, as coprime integers."""
    boundaries: list[ExactBoundary]
    """The sides of a set without vertices."""
    pui: list[ExactRange] | None
    """The parameter uncertainty intervals, rounded outward; null for an empty set."""
    area: Exact | None
    """The area, rounded to nearest; null for an empty and for an infinite set."""
    entering: list[Active]
    """The bounds that enter the shape here."""
    leaving: list[Active]
    """The bounds that leave the shape here."""


class Central(TypedDict):
    """The central estimate: the middle of the PUI box."""

    theta: list[Exact]
    """θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error."""
    guaranteed_error: list[Exact]
    """Half the width of each interval, rounded up so that it covers the rounding of `theta`."""


class Certificate(TypedDict):
    """The proof that a set is empty."""

    farkas: list[Term]
    """The terms, at most three, that add up to 0 ≤ a negative number."""


class Exact(TypedDict):
    """An exact number and its forms. Decisions take `exact`."""

    exact: str | None
    """The number as a fraction `p/q` or an integer; null where the fraction is longer than the limit `fraction`."""
    decimal: str
    """A decimal, rounded to the significant digits asked for: ends of intervals outward, error bounds up, other numbers to nearest."""
    value: float | None
    """The nearest double; null beyond the largest double."""
    outward: NotRequired[float | None]
    """A double that is never inside: lower ends are rounded down, upper ends, error bounds and factors up. Null beyond the largest double; absent for other numbers."""


class ExactActiveVertex(TypedDict):
    """A vertex of a set."""

    theta: list[Exact]
    """θ1 and θ2, exact."""
    active: list[Active]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class ExactBoundary(TypedDict):
    """A side normal·θ ≤ offset of a set without vertices."""

    normal: list[str]
    """The outer normal, as coprime integers."""
    offset: Exact
    """The largest value of normal·θ, exact."""
    active: list[Active]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class ExactRange(TypedDict):
    """The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds."""

    lower: Exact | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: Exact | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""


class FitLeastSquares(TypedDict):
    """The least-squares estimate, exact and in doubles."""

    theta: list[Exact]
    """θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error where there is one."""
    in_fps: bool
    """True if the estimate is in the feasible set."""
    guaranteed_error: list[Exact] | None
    """The largest distance of each parameter to any in the feasible set, rounded up so that it covers the rounding of `theta`; null where the set is empty or unbounded."""
    binary64: dict[str, Float | None]
    """The same estimate in doubles, by `qr` and by `pseudo_inverse`; an estimate is null where its method fails. Empty where not all readings are in memory."""


class Float(TypedDict):
    """An estimate computed in doubles."""

    theta: list[float]
    """θ1 and θ2 as doubles."""
    distance: list[Exact]
    """The distance of each to the exact estimate, rounded up."""


class Fractions(TypedDict):
    """A column whose cells are fractions such as `3/4`."""

    column: str
    """The name of the column."""
    cells: int
    """The number of cells that are fractions."""
    first: str
    """The first such cell."""


class FromLeast(TypedDict):
    """An error bound that was found from the readings themselves."""

    factor: Exact
    """The multiple that was asked for, exact."""
    epsilon_min: Exact
    """The least error bound that leaves a feasible parameter, rounded up."""
    assumes: str
    """The assumption behind such a bound."""


class Guarantee(TypedDict):
    """A guarantee for further readings."""

    confidence: Exact
    """The confidence that was asked for, exact."""
    covered: Exact
    """The share of further readings in the band of the least error bound, rounded down; 0 where nothing is guaranteed."""
    readings: int
    """The number of readings that it follows from."""
    unknowns: int
    """The number of unknowns."""
    assumes: list[str]
    """The assumptions."""
    source: str
    """The source of the proof."""


class Header(TypedDict):
    """The line that names the columns."""

    line: int | None
    """The number of the line, or of the row of a sheet; null without names."""
    comment: bool
    """True if that line is a comment, or a row that begins as one."""
    open: bool
    """True if nothing told a header from a reading: every cell of the first line that is used is a number or missing."""
    row_names: bool
    """True if each row begins with a name, so that it has a cell more than the header."""


class Input(TypedDict):
    """The question: file, rows, columns, model, error bound and conditions."""

    file: str | None
    """The file as it was named; null for standard input."""
    rows: int
    """The number of rows that are used."""
    rows_total: int
    """The number of rows in the file."""
    selection: NotRequired[Selection]
    """The rows that were asked for; absent if all were."""
    rows_missing: NotRequired[int]
    """The number of rows that were skipped because a value is missing; absent if there are none."""
    table: Table | None
    """The format of the table as it was read; null for files that are neither text nor a sheet nor JSON."""
    fractions: NotRequired[list[Fractions]]
    """The columns whose cells are fractions; absent if there are none."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    sha256: str | None
    """SHA-256 of the bytes of the file; null where they were not hashed."""
    model: Literal["line", "line-through-origin", "two-regressors"]
    """`line-through-origin` means that θ2 is 0."""
    x: list[str]
    """The column of x, or both columns of the regressors."""
    y: str | None
    """The column of y; null where readings have only bounds."""
    units: NotRequired[Units]
    """The units of columns and parameters; absent if no name of a column has a unit, as in `U (mV)` or `U [mV]`."""
    epsilon: Exact | None
    """The error bound ε of all readings, rounded up; null where each reading has its own."""
    epsilon_column: str | None
    """The column of error bounds; null where there is none."""
    epsilon_law: NotRequired[str]
    """The law of the error bound as it was typed; absent without a law."""
    interval: NotRequired[IntervalColumns]
    """The columns of bounds that take the place of y and ε; absent if there are none."""
    epsilon_from_least: NotRequired[FromLeast]
    """The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise."""
    x_origin: NotRequired[Exact]
    """The value from which x is counted, exact; absent if it is 0."""
    where: list[str]
    """The conditions on the parameters as they were typed."""


class Interval(TypedDict):
    """The interval of a parameter, each end with its proof."""

    lower: Bound
    """The lower end, rounded down."""
    upper: Bound
    """The upper end, rounded up."""


class IntervalColumns(TypedDict):
    """The columns of bounds on each reading; one of them may be null."""

    lower: str | None
    """The column of lower bounds; null where there is none."""
    upper: str | None
    """The column of upper bounds; null where there is none."""


class Inverse(TypedDict):
    """A parameter of the inverse line."""

    exact_range: list[ExactRange]
    """The range over the feasible set: no interval, one, or two where slopes have both signs. Ends are rounded outward."""
    box_range: list[ExactRange]
    """The range over the PUI box, rounded outward."""
    eui_range: list[ExactRange] | None
    """The range over the EUI box, rounded outward; null where there is no EUI."""
    central: Exact | None
    """The value for the central estimate, exact; null where there is none."""
    least_squares: Exact | None
    """The value for the least-squares estimate, exact; null where there is none."""


class Inverses(TypedDict):
    """The inverse line x = gain · y + offset."""

    gain: Inverse
    """1/θ1."""
    offset: Inverse
    """−θ2/θ1."""


class Linear(TypedDict):
    """The function constant + slope·s, with exact fractions."""

    constant: str
    """The value at s = 0."""
    slope: str
    """The factor of s."""


class LinearActiveVertex(TypedDict):
    """A vertex of a set."""

    theta: list[Linear]
    """θ1 and θ2, exact."""
    active: list[Active]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class LinearBoundary(TypedDict):
    """A side normal·θ ≤ offset of a set without vertices."""

    normal: list[str]
    """The outer normal, as coprime integers."""
    offset: Linear
    """The largest value of normal·θ, exact."""
    active: list[Active]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class LinearRange(TypedDict):
    """The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds."""

    lower: Linear | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: Linear | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""


class Minimax(TypedDict):
    """The estimate that survives the smallest error bounds."""

    theta: list[Exact]
    """θ1 and θ2, exact."""
    unique: bool
    """True if no other parameter serves as well."""
    epsilon: Exact | None
    """The least error bound, rounded up; null where bounds differ between readings."""
    epsilon_factor: Exact | None
    """The least common factor on the bounds, or on the widths of intervals, rounded up; null under one bound for all readings."""
    proof: list[Term]
    """The terms that prove that no smaller bound or factor leaves a parameter."""


Piece = TypedDict(
    "Piece",
    {
        # The factor at which it begins, rounded up.
        "from": "Exact",
        # The factor at which it ends, rounded up.
        "to": "Exact",
        # The kind of the set.
        "kind": "Literal[\"empty\", \"point\", \"segment\", \"ray\", \"line\", \"polygon\", \"unbounded-polygon\", \"strip\", \"half-plane\", \"plane\"]",
        # The vertices, counter-clockwise.
        "vertices": "list[LinearActiveVertex]",
        # Directions in which the set goes on without end, as coprime integers.
        "rays": "list[list[str]]",
        # Directions in which the set goes on without end both ways, as coprime integers.
        "lines": "list[list[str]]",
        # The sides of a set without vertices.
        "boundaries": "list[LinearBoundary]",
        # The parameter uncertainty intervals; null for an empty set.
        "pui": "list[LinearRange] | None",
        # The area; null for an infinite set.
        "area": "Quadratic | None",
    },
)
"""The set between two breakpoints; every number is a function of s."""


class Program(TypedDict):
    """The program that wrote a document."""

    name: str
    """`boundfit`."""
    version: str
    """The version of the program."""


class Quadratic(TypedDict):
    """The function constant + slope·s + quadratic·s². A coefficient is null where its fraction is too long."""

    constant: str | None
    """The value at s = 0, an exact fraction."""
    slope: str | None
    """The factor of s, an exact fraction."""
    quadratic: str | None
    """The factor of s², an exact fraction."""
    decimals: NotRequired[list[str]]
    """Decimals of all three, rounded to nearest; absent if all fractions are written."""


class Selection(TypedDict):
    """The rows that were asked for."""

    rows: str | None
    """The rows by number, such as `5,14-36`; null if not asked for."""
    without: str | None
    """The excluded rows by number; null if there are none."""
    where_row: list[str]
    """The conditions on cells, such as `V >= -6`."""


class Sheet(TypedDict):
    """The sheet that was read, and what a spreadsheet shows otherwise."""

    name: str | None
    """The name of the sheet; null in a workbook of one sheet."""
    number: int
    """The number of the sheet, from 1."""
    total: int
    """The number of sheets in the workbook."""
    hidden: bool
    """True if spreadsheets do not show the sheet."""
    hidden_rows: int
    """The number of rows that were read although spreadsheets do not show them."""
    hidden_columns: int
    """The number of columns that spreadsheets do not show."""
    merged: int
    """The number of areas of merged cells. Their first cell alone has a value."""


class Skipped(TypedDict):
    """Lines that were passed over, and rows of another length."""

    lines: int
    """Lines before the table that were skipped because the names stand in a later one."""
    comments: int
    """Comment lines between rows."""
    short_rows: int
    """Rows with fewer cells than the first one."""
    long_rows: int
    """Rows with more cells than the first one."""
    headers: NotRequired[int]
    """Rows that repeat the header; absent if there are none."""


class Slope(TypedDict):
    """A line at an end of the slopes."""

    theta: list[Exact]
    """Slope and intercept, exact."""
    side: NotRequired[Literal["+", "-", "both"]]
    """The side that has the line, with errors in x only: `+` (θ1 ≥ 0), `-` (θ1 ≤ 0) or `both`."""
    active: list[Active]
    """The bounds that the line touches."""


class Slopes(TypedDict):
    """The lines at the two ends of the slopes."""

    largest: Slope | None
    """The line with the largest slope; null where slopes have no upper end."""
    smallest: Slope | None
    """The line with the smallest slope; null where slopes have no lower end."""


Sweep = TypedDict(
    "Sweep",
    {
        # The first factor, rounded up.
        "from": "Exact",
        # The last factor, rounded up.
        "to": "Exact",
        # The least factor that leaves a feasible parameter, rounded up; null where none does.
        "least": "Exact | None",
        # The factors at which the shape of the set changes, ascending, with the set there.
        "breakpoints": "list[Breakpoint]",
        # The sets between two breakpoints as functions of s.
        "pieces": "list[Piece]",
    },
)
"""The feasible sets under all error bounds times s, from one factor s to another."""


class Table(TypedDict):
    """The detected format of a table of text, JSON or a sheet."""

    header: Header
    """The line that names the columns."""
    delimiter: str | None
    """`comma`, `semicolon`, `tab`, `space`, `pipe` or the character; null for sheets and JSON."""
    decimal: Literal["point", "comma"]
    """The decimal mark."""
    decimal_open: NotRequired[bool]
    """True if the comma that was taken for the decimal mark may as well group digits; absent otherwise."""
    thousands: str | None
    """The character that groups digits; null where there is none."""
    encoding: str | None
    """The encoding of the text, such as `UTF-8`; null for sheets."""
    comment: str | None
    """The characters that start a comment line; null where there are none."""
    sheet: NotRequired[Sheet]
    """The sheet of a workbook; absent for other files."""
    blocks: Blocks | None
    """The blocks of the file, and which was read; null for a file of one block."""
    skipped: Skipped
    """The lines and rows that are unusual."""


class Term(TypedDict):
    """A half-plane times a positive multiplier. The sum of all terms of a proof is the claim."""

    row: int | None
    """The number of the row in the file, from 1; null for a condition and for the sign of the slope."""
    bound: str
    """The bound of the row or the condition, as in `active`; `facet` for a half-plane of the list `facets`."""
    multiplier: Exact
    """The exact multiplier, greater than 0."""


class Units(TypedDict):
    """Units from the names of columns, and the units of the parameters that follow; null where unknown."""

    x: list[str | None]
    """The unit of each column of x."""
    y: str | None
    """The unit of y."""
    theta1: str | None
    """The unit of θ1."""
    theta2: str | None
    """The unit of θ2."""


class Factor(TypedDict):
    """The least factor on the bounds of x and y that leaves a line: lower < factor ≤ upper, or both ends are the factor itself."""

    lower: Exact
    """Less than the least factor, or the least factor where both ends are equal; a number of 17 digits, rounded down."""
    upper: Exact
    """At least the least factor; a number of 17 digits, rounded up."""
    attained: bool
    """True if `upper` leaves a line."""
    side: Literal["+", "-", "both"]
    """The side of the line, or of the last lines."""
    theta: list[Exact] | None
    """A line that `upper` leaves, exact; null where there is none."""
    fixed_by: list[Active]
    """Bounds that leave nothing under `lower`, or under smaller factors where both ends are equal."""


class XErrorCentral(TypedDict):
    """The central estimate of all sets."""

    theta: list[Exact]
    """θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error."""
    guaranteed_error: list[Exact]
    """Half the width of each interval, rounded up so that it covers the rounding of `theta`."""
    in_fps: bool
    """True if it is in one of the sets."""


class XErrorLeastSquares(TypedDict):
    """The least-squares estimate as if every x were exact."""

    theta: list[Exact]
    """θ1 and θ2, exact."""
    in_fps: bool
    """True if the estimate is in one of the sets."""
    in_fps_without_x_errors: bool | None
    """True if the estimate is in the feasible set of exact x; null where that is not known."""


class XErrorSide(TypedDict):
    """The feasible lines of one side."""

    side: Literal["+", "-", "both"]
    """`+`: θ1 ≥ 0; `-`: θ1 ≤ 0; `both`: all lines."""
    fps: ActiveRegion
    """The set."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals of the set; null where no end is bounded."""


class GroupSet(TypedDict):
    """The feasible parameter set of a group."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    vertex_count: int
    """The number of vertices."""
    certificate: Certificate | None
    """The proof that the set is empty; null for other sets."""


class LeastSquares(TypedDict):
    """A least-squares estimate."""

    theta: list[Exact]
    """θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error where there is one."""
    in_fps: bool
    """True if the estimate is in the feasible set."""
    guaranteed_error: list[Exact] | None
    """The largest distance of each parameter to any in the feasible set, rounded up so that it covers the rounding of `theta`; null where the set is empty or unbounded."""


class LineInput(TypedDict):
    """The input of a report that has a line per answer: the same for all lines."""

    table: Table | None
    """The format of the table as it was read; null for files that are neither text nor a sheet nor JSON."""


class FeasibleSet(TypedDict):
    """The kind of a set, and why it is empty."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    certificate: Certificate | None
    """The proof that the set is empty; null for other sets."""


class JudgedSet(TypedDict):
    """The set of all readings."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    contradiction: list[Term] | None
    """The terms, at most three, that prove an empty set; null for other sets."""


class NewStatusRow(TypedDict):
    """The status of a further reading. Fields are null for the same reasons as for the readings of the set."""

    row: int
    """The row."""
    leverage: Exact | None
    """The width of the predicted interval over that of the reading; exact."""
    residual: Exact | None
    """The distance of both middles over half the width of the reading, with its sign; exact."""
    status: Literal["inner", "boundary", "outer", "strictly outer", "outlier"] | None
    """The status against the set."""


class NewStatuses(TypedDict):
    """The status of further readings, against the set of all readings."""

    file: str | None
    """The file of the further readings; null for standard input."""
    rows: list[NewStatusRow]
    """The status of each further reading."""


class Repair(TypedDict):
    """The least total widening that makes the set non-empty."""

    total: Exact | None
    """The least sum of the factors on all widths, each at least 1, exact. Null where the bounds and conditions that stay as they are contradict each other, or not all rows are in memory."""
    count: int | None
    """The number of readings with a width; null where `total` is."""
    theta: list[Exact] | None
    """The parameters that meet the wider bounds, exact; null where `total` is."""
    widened: list[Widened]
    """The readings whose bounds are widened."""
    multipliers: list[RowMultiplier]
    """The multipliers of readings that prove the total."""
    held: list[Term]
    """The terms of bounds and conditions that stay as they are, which are part of the proof."""
    contradiction: list[Term] | None
    """The contradiction of bounds and conditions that stay as they are; null where there is none."""


class RowMultiplier(TypedDict):
    """The multiplier of a reading."""

    row: int
    """The row."""
    value: Exact
    """The multiplier, exact, with its sign."""


class StatusRow(TypedDict):
    """The status of a reading. Leverage and residual are null where the values over the set have no end, or the reading has one bound or no width; all is null against an empty set."""

    row: int
    """The row."""
    leverage: Exact | None
    """The width of the predicted interval over that of the reading, from the set of all readings; exact."""
    residual: Exact | None
    """The distance of both middles over half the width of the reading, with its sign; exact."""
    status: Literal["inner", "boundary"] | None
    """The status against the set of all readings."""
    without: Literal["inner", "boundary", "outer", "strictly outer", "outlier"] | None
    """The status against the set of the other readings."""
    without_leverage: Exact | None
    """The leverage from the set of the other readings."""
    without_residual: Exact | None
    """The residual from the set of the other readings."""


class Widened(TypedDict):
    """A reading whose bounds are widened."""

    row: int
    """The row."""
    factor: Exact
    """The factor on its width, rounded up."""
    half_width: Exact
    """Half of the width that it needs, rounded up."""


class NewReading(TypedDict):
    """The bound on the error of a further reading."""

    epsilon: Exact | None
    """The bound, rounded up; null under a law."""
    law: str | None
    """The law as it was typed; null without one."""
    given: bool
    """True if the bound was given for further readings; otherwise it is that of the readings."""


class Possible(TypedDict):
    """An interval of x that a reading may come from."""

    lower: Exact | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: Exact | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""
    lower_included: bool | None
    """True if the lower end belongs to the interval; null without end."""
    upper_included: bool | None
    """True if the upper end belongs to the interval; null without end."""
    proof: SourceEndRange
    """The proof of both ends; null for an end that is not there."""


class Predicted(TypedDict):
    """The prediction at one value."""

    x: Value
    """The value asked for, exact: x, or both regressors."""
    line: ExactRange
    """The interval of the feasible lines there, rounded outward."""
    reading: ExactRange | None
    """The interval of a further reading there, rounded outward; null where nothing is known of its error."""
    proof: ProofEndRange
    """The proof of both ends of `line`; null for an end where the set is empty. The terms of a lower end prove −φ·θ ≤ −lower."""


class ProofEnd(TypedDict):
    """The proof of an end: where it is reached and the terms that prove it, or the ray along which there is none."""

    theta: list[Exact]
    """The parameters that reach the end, exact; where there is no end, a point of the set."""
    active: list[Term]
    """The terms that prove the end; empty where there is none."""
    ray: list[Exact] | None
    """The direction along which the value goes on without end; null where there is an end."""


class ProofEndRange(TypedDict):
    """The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds."""

    lower: ProofEnd | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: ProofEnd | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""


class Source(TypedDict):
    """The x that a reading may come from."""

    y: Exact
    """The reading asked for, exact."""
    x: list[Possible]
    """The intervals of x, ascending: none, one or two."""


class SourceEnd(TypedDict):
    """The proof of an end of x."""

    line: Literal["lower", "upper"]
    """The end of the line's interval that decides there."""
    theta: list[Exact]
    """The parameters that reach the end, exact; where there is no end, a point of the set."""
    active: list[Term]
    """The terms that prove the end; empty where there is none."""
    ray: list[Exact] | None
    """The direction along which the value goes on without end; null where there is an end."""


class SourceEndRange(TypedDict):
    """The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds."""

    lower: SourceEnd | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: SourceEnd | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""


class Goal(TypedDict):
    """The best x for a goal."""

    goal: Literal["theta1", "theta2", "area"]
    """The goal: the length of a parameter's interval, or the area of the set."""
    now: Exact | None
    """The value of the goal before the reading, rounded up; null where it has no bound."""
    worst: Exact | None
    """The largest value after a reading at the best x, rounded up; null where it has no bound."""
    at: list[Exact]
    """The best x, exact, ascending; empty where the worst outcome leaves the goal as it is at every x of the range."""


class SearchRange(TypedDict):
    """A range of x, both ends included."""

    lower: Exact
    """The lower end, exact."""
    upper: Exact
    """The upper end, exact."""
    given: bool
    """True if the range was given; otherwise it is that of the readings."""


class Growth(TypedDict):
    """The parameters that miss at most so many readings."""

    most: int
    """The most readings that may be missed."""
    pieces: int
    """The number of pieces that are not connected."""
    holes: int
    """The number of holes in them."""
    pui: list[ExactRange] | None
    """The ranges of θ1 and θ2, rounded outward; null where there are no pieces."""
    area: Exact | None
    """The area, rounded to nearest; null where there are no pieces or it is infinite."""


class LeftRegion(TypedDict):
    """The parameters that remain without a set of readings, beside their vertices."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the piece."""
    rays: list[list[Exact]]
    """Directions in which the piece goes on without end, as coprime integers."""
    lines: list[list[Exact]]
    """Directions in which the piece goes on without end both ways, as coprime integers."""
    boundaries: list[ActiveList]
    """The half-planes behind each side of a piece without vertices; otherwise empty."""
    witness: list[Exact] | None
    """A point of the piece, exact."""
    pui: list[ExactRange] | None
    """The ranges of θ1 and θ2 over the piece, rounded outward."""
    area: Exact | None
    """The area, rounded to nearest; null where it is infinite."""
    missed: list[Missed] | None
    """The distance by which each excluded reading is missed; null for sets beyond the first 20,000 rows in all."""


class Missed(TypedDict):
    """An excluded reading: the bound that is passed, and by how much."""

    row: int
    """The row."""
    bound: Literal["lower", "upper"] | None
    """The bound that the parameters pass; null for a row that no parameters meet."""
    by: ExactRange | None
    """The amount by which they pass it, from the least to the most over the piece; null for a row that no parameters meet."""


class Alone(TypedDict):
    """A reading that is in no run."""

    position: int
    """The position of the reading."""
    row: int
    """The row of the reading."""
    farkas: list[Term]
    """The terms by which the readings at its x contradict each other or the conditions."""


class Longest(TypedDict):
    """The feasible set of the longest run."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    pui: list[Interval] | None
    """The parameter uncertainty intervals; null where no end is bounded."""
    central: Central | None
    """The central estimate; null where the set is unbounded."""
    epsilon_min: Exact | None
    """The least error bound with a feasible parameter, rounded up; null where bounds differ between readings."""


class Run(TypedDict):
    """A run with what stops it."""

    first: int
    """The first position."""
    last: int
    """The last position."""
    rows: list[int]
    """The rows at both positions."""
    x: list[Exact] | None
    """The least and the largest x, exact; null where x is not known."""
    before: list[Term] | None
    """The terms that contradict each other once the readings at the x before the run are added (by row: the reading before it); null at the first reading."""
    after: list[Term] | None
    """The same of the readings after the run; null at the last reading."""


class Alternating(TypedDict):
    """A point that proves the independent linearity."""

    x: Exact
    """The x of the point, exact."""
    y: Exact
    """The mean y of the point, exact."""
    rows: list[int]
    """The rows of the point."""
    residual: Exact
    """y less the line, exact."""
    weight: Exact
    """The weight of the point in the proof, exact."""


class Calibration(TypedDict):
    """The question: file, rows, columns and full scale."""

    file: str | None
    """The file as it was named; null for standard input."""
    rows: int
    """The number of rows that are used."""
    rows_total: int
    """The number of rows in the file."""
    selection: NotRequired[Selection]
    """The rows that were asked for; absent if all were."""
    rows_missing: int
    """The number of rows that were skipped because a value is missing."""
    table: Table | None
    """The format of the table as it was read; null for files that are neither text nor a sheet nor JSON."""
    fractions: NotRequired[list[Fractions]]
    """The columns whose cells are fractions; absent if there are none."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    sha256: str | None
    """SHA-256 of the bytes of the file; null where they were not hashed."""
    x: str
    """The column of x."""
    y: str | None
    """The column of y; null where each direction has a column of its own."""
    up: str | None
    """The column of readings with rising x; null otherwise."""
    down: str | None
    """The column of readings with falling x; null otherwise."""
    direction: Direction | None
    """The column of directions; null without one."""
    points: int
    """The number of points of the average characteristic."""
    full_scale: Literal["span", "given"]
    """The source of full scale: the span of y, or a given number."""


class Characteristic(TypedDict):
    """A characteristic: the mean y at each x, beside four lines."""

    full_scale: Exact
    """The number that percents refer to, exact."""
    span: Exact
    """The largest less the smallest y, exact."""
    independent: LinearityLine
    """The line with the least deviation."""
    terminal: LinearityLine | None
    """The line through the first and the last point; null where all x are the same."""
    zero_based: LinearityLine
    """The line through the point `through` with the least deviation."""
    least_squares: LinearityLine | None
    """The least-squares line; null where all x are the same."""


class Direction(TypedDict):
    """A column of directions."""

    column: str
    """The name of the column."""
    up: list[str]
    """The words for rising x."""
    down: list[str]
    """The words for falling x."""


class LinearityLine(TypedDict):
    """A line beside a characteristic."""

    deviation: Exact
    """The largest distance in y between characteristic and line, rounded up."""
    percent: Exact | None
    """The deviation in percent of full scale, rounded up; null where full scale is 0."""
    theta: list[Exact]
    """Slope and intercept, exact."""
    rows: list[int]
    """The rows where the deviation is reached."""
    unique: bool
    """True if no other line of this sort serves as well."""


class Place(TypedDict):
    """An x with its rows."""

    x: Exact
    """The value of x, exact."""
    rows: list[int]
    """The rows with this x."""


class ExactRowNumberVertex(TypedDict):
    """A vertex of a set."""

    theta: list[Exact]
    """θ1 and θ2, exact."""
    active: list[RowNumber]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class HalfPlane(TypedDict):
    """The half-plane a·θ ≤ b."""

    a: list[Exact]
    """The normal, exact."""
    b: Exact
    """The offset, exact."""


class HalfPlaneFile(TypedDict):
    """A file of half-planes or generators."""

    file: str | None
    """The file as it was named; null for standard input."""
    rows: int
    """The number of rows."""
    table: Table | None
    """The format of the table as it was read; null for files that are neither text nor a sheet nor JSON."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    sha256: str
    """SHA-256 of the bytes of the file."""


class RowNumberList(TypedDict):
    """Half-planes whose borders pass through a vertex, or are a side of the set."""

    active: list[RowNumber]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class RowNumberRegion(TypedDict):
    """A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    vertices: list[ExactRowNumberVertex]
    """The vertices, counter-clockwise from the lexicographically smallest."""
    rays: list[list[Exact]]
    """Directions in which the set goes on without end, as coprime integers."""
    lines: list[list[Exact]]
    """Directions in which the set goes on without end both ways, as coprime integers."""
    boundaries: list[RowNumberList]
    """The half-planes behind each side of a set without vertices; otherwise empty."""
    witness: list[Exact] | None
    """A point of the set, exact; null for the empty set."""
    area: Exact | None
    """The area, rounded to nearest; null for an empty and for an infinite set."""
    certificate: Certificate | None
    """The proof that the set is empty; null for other sets and where `farkas` of the answer has it."""


class Approximation(TypedDict):
    """A polygon."""

    vertices: list[list[Exact]]
    """The vertices, exact."""
    area: Exact | None
    """The area; null where it is infinite."""


class CheckInput(TypedDict):
    """The data of the answers."""

    file: str | None
    """The file as it was named; null for standard input."""
    table: Table | None
    """The format of the table as it was read; null for files that are neither text nor a sheet nor JSON."""
    epsilon_from_least: NotRequired[FromLeast]
    """The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise."""


class Claim(TypedDict):
    """The answers of one source."""

    source: str
    """The name of the solver or file."""
    reading: Literal["decimal", "binary64"]
    """The data that the answers are judged against."""
    bounds: list[ClaimedEnd]
    """The four ends, judged."""
    verdict: Literal["exact", "rounded", "within tolerance", "no answer", "loose", "infeasible point", "unsafe", "wrong status", "inverted interval"]
    """The worst verdict."""


class ClaimedEnd(TypedDict):
    """A claimed end of a parameter's interval, judged."""

    target: Literal["theta1", "theta2"]
    """The parameter."""
    end: Literal["lower", "upper"]
    """The end."""
    claimed: Exact | None
    """The claimed end; null where none is claimed."""
    verdict: Literal["exact", "rounded", "within tolerance", "no answer", "loose", "infeasible point", "unsafe", "wrong status", "inverted interval"]
    """The verdict."""
    rounded_to: RoundedTo | None
    """The rounding that explains the claim; null unless the verdict is `rounded`."""
    exact: Exact | None
    """The true end, rounded outward; null where there is none."""
    excess: Exact | None
    """The distance of the claim outside the true interval, exact; negative inside."""
    excess_in_ulps: Exact | None
    """The excess in units in the last place of a double at the true end."""
    excess_in_units: Exact | None
    """The excess in `unit`; without its sign it is the smallest tolerance that excuses the claim."""
    unit: Literal["width", "value", "eps"] | None
    """The unit: the `width` of the true interval; where that is 0 or infinite the `value` of the end, else `eps`."""
    tau: Exact | None
    """The smallest τ with the claimed point in FPS(ε + τ), rounded up; null without a point."""
    tau_in_epsilon: Exact | None
    """τ in units of ε, rounded up; null without a point."""
    row: int | None
    """The row of the half-plane that the claimed point violates most; null for a condition and without a violation."""
    bound: str | None
    """The bound of that half-plane; null without a violation."""
    violation: Exact | None
    """The amount by which the point violates it, exact; null without a violation."""
    witness: list[Exact] | None
    """A feasible point that an unsafe end cuts off, exact; null for other verdicts."""
    proof: Evidence | None
    """The proof of a wrong status; null for other verdicts."""
    repairable: bool | None
    """True if the rows with the largest duals prove the true end; null without duals, or with another number of them than rows."""
    reason: str | None
    """The reason why there is no answer, or which duals are ignored and why; null otherwise."""


class Directions(TypedDict):
    """Approximations of the set by linear programs in many directions."""

    count: int
    """The number of directions."""
    scaled: bool
    """True if directions are even after both parameters are scaled by their intervals."""
    unbounded: int
    """The number of directions without an optimum."""
    inner: Approximation | None
    """The hull of the optimal points; null where there are none."""
    exact: Approximation
    """The set itself."""
    outer: Approximation | None
    """The intersection of the half-planes of all optima; null where there are none."""


class Evidence(TypedDict):
    """The proof of a wrong status."""

    shows: Literal["infeasible", "bounded", "feasible", "unbounded"]
    """The fact about the program that it shows."""
    rows: list[Term]
    """Rows with multipliers; empty for `feasible` and `unbounded`."""
    theta: list[Exact] | None
    """A feasible point, exact; null for `infeasible` and `bounded`."""
    ray: list[Exact] | None
    """A direction without end; null unless it shows `unbounded`."""


class Readings(TypedDict):
    """The readings of the programs."""

    asked: int
    """The number of readings with rows in the programs; the others cannot bound anything."""
    fitted: int
    """The number of readings that are fitted."""


class RoundedTo(TypedDict):
    """The rounding that explains a claim."""

    kind: Literal["binary64", "digits"]
    """The target: doubles, or decimal digits."""
    digits: int | None
    """The number of significant digits; null for doubles."""


class Worst(TypedDict):
    """The worst verdict against one reading of the data."""

    verdict: Literal["exact", "rounded", "within tolerance", "no answer", "loose", "infeasible point", "unsafe", "wrong status", "inverted interval"]
    """The verdict."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers."""
    refuted: bool
    """True if the verdict is a refutation."""


class ExactSideVertex(TypedDict):
    """A vertex of a set."""

    theta: list[Exact]
    """θ1 and θ2, exact."""
    active: list[Side]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class Face(TypedDict):
    """The optimal points: the hull of the vertices, plus multiples of the rays that are not negative and any of the lines. All exact."""

    vertices: list[list[Exact]]
    """The vertices."""
    points: list[list[Exact]]
    """A point on each line that bounds the face, where there is no vertex."""
    rays: list[list[Exact]]
    """Directions without end."""
    lines: list[list[Exact]]
    """Directions without end both ways."""


class Finding(TypedDict):
    """The verdict on an aspect of a solution; what does not apply is null."""

    aspect: Literal["status", "objective", "primal", "optimality", "dual", "complementary-slackness", "duality-gap", "ray", "farkas"]
    """The aspect."""
    verdict: Literal["exact", "rounded", "within tolerance", "no answer", "refuted"]
    """The verdict."""
    line: int
    """The line of the file."""
    error: Exact | None
    """The largest error, rounded up."""
    relative: Exact | None
    """The error in units of its measure, rounded up."""
    row: str | None
    """The row with the largest error."""
    column: str | None
    """The column with the largest error."""
    bound: Literal["lower", "upper"] | None
    """The bound with the largest error."""
    claimed: Exact | None
    """The number that the file states."""
    exact: Exact | None
    """The true number; at a bound its value."""
    tolerance: Tolerance | None
    """The tolerances that would excuse the error."""
    message: str
    """The verdict as a sentence."""


class Model(TypedDict):
    """A linear program in a file."""

    file: str | None
    """The file as it was named; null for standard input."""
    sha256: str
    """SHA-256 of the bytes of the file."""
    name: str
    """The name of the model."""
    sense: Literal["min", "max"]
    """The sense: the objective is minimised or maximised."""
    objective: str
    """The name of the objective."""
    constant: Exact
    """The constant of the objective."""


class ModelColumn(TypedDict):
    """A column of the model."""

    name: str
    """The name."""
    lower: Exact | None
    """The lower bound; null where there is none."""
    upper: Exact | None
    """The upper bound; null where there is none."""
    cost: Exact
    """The coefficient of the objective."""
    value: Exact | None
    """The value at the first optimal point, exact; null unless optimal."""
    reduced_cost: Exact | None
    """The reduced cost, exact; null unless optimal."""
    basis: Literal["basic", "lower", "upper", "free"] | None
    """The place in the basis; null unless optimal."""


class ModelRow(TypedDict):
    """A row of the model."""

    name: str
    """The name."""
    lower: Exact | None
    """The lower bound; null where there is none."""
    upper: Exact | None
    """The upper bound; null where there is none."""
    value: Exact | None
    """The value at the first optimal point, exact; null unless optimal."""
    dual: Exact | None
    """The dual price, exact; null unless optimal."""
    basis: Literal["basic", "lower", "upper", "free"] | None
    """The place in the basis; null unless optimal."""


class Plane(TypedDict):
    """The feasible set in the plane of the columns that bounds do not fix. With fewer than two columns the missing coordinates are 0."""

    columns: list[str]
    """The names of these columns, at most two."""
    region: SideRegion
    """The set."""
    ranges: list[ExactRange] | None
    """The range of each column, rounded outward; null for an empty set."""


class Side(TypedDict):
    """A bound of a row or of a column."""

    row: str | None
    """The name of the row; null for a column."""
    column: str | None
    """The name of the column; null for a row."""
    side: Literal["lower", "upper"]
    """The bound: `lower` as it stands, `upper` negated."""


class SideList(TypedDict):
    """Half-planes whose borders pass through a vertex, or are a side of the set."""

    active: list[Side]
    """The first 1,000 of these half-planes."""
    active_more: NotRequired[int]
    """The number of half-planes beyond those listed; absent if there are none."""


class SideRegion(TypedDict):
    """A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing."""

    kind: Literal["empty", "point", "segment", "ray", "line", "polygon", "unbounded-polygon", "strip", "half-plane", "plane"]
    """The kind of the set."""
    vertices: list[ExactSideVertex]
    """The vertices, counter-clockwise from the lexicographically smallest."""
    rays: list[list[Exact]]
    """Directions in which the set goes on without end, as coprime integers."""
    lines: list[list[Exact]]
    """Directions in which the set goes on without end both ways, as coprime integers."""
    boundaries: list[SideList]
    """The half-planes behind each side of a set without vertices; otherwise empty."""
    witness: list[Exact] | None
    """A point of the set, exact; null for the empty set."""
    area: Exact | None
    """The area, rounded to nearest; null for an empty and for an infinite set."""
    certificate: Certificate | None
    """The proof that the set is empty; null for other sets and where `farkas` of the answer has it."""


class SideTerm(TypedDict):
    """A bound times a multiplier."""

    row: str | None
    """The name of the row; null for a column."""
    column: str | None
    """The name of the column; null for a row."""
    side: Literal["lower", "upper"]
    """The bound: `lower` as it stands, `upper` negated."""
    multiplier: Exact
    """The multiplier, exact and greater than 0."""


class Solution(TypedDict):
    """The verdict on a solution file."""

    file: str
    """The file as it was named."""
    writer: str
    """The program whose format the file has."""
    status: str
    """The status that the file states: `optimal`, `infeasible`, `unbounded`, `infeasible-or-unbounded` or other words of the solver."""
    verdict: Literal["exact", "rounded", "within tolerance", "no answer", "refuted"]
    """The worst verdict."""
    findings: list[Finding]
    """The verdict on each aspect."""
    not_judged: str | None
    """The part of the file that is not judged, and why; null where every part is."""


class Tolerance(TypedDict):
    """The smallest tolerances that excuse an error, rounded up."""

    absolute: Exact
    """The tolerance in the units of the rows and bounds as the file has them."""
    relative: Exact
    """The tolerance in units of the larger of 1, the value and the bound."""
    scaled: Exact
    """The tolerance in the units of each row after a division by its largest coefficient."""


class About(TypedDict):
    """The question of a proof."""

    rows: list[list[int]]
    """First and last number of each range of rows."""
    rows_total: int | None
    """The number of rows of the data; null where they were not read to the end."""
    reading: Literal["decimal", "binary64"]
    """The reading of numbers: exactly as written, or as the nearest doubles."""
    header: bool
    """True if the first row names the columns."""
    delimiter: str
    """The character between cells."""
    phi1: ColumnTimes
    """The first regressor, x of a line."""
    phi2: ColumnTimes
    """The second regressor, 1 of a line."""
    y: ColumnTimes
    """The reading."""
    epsilon: ColumnTimes
    """The error bound."""
    x_origin: Exact
    """The number that is taken from the column of `phi1` first."""
    x_error: ColumnTimes | None
    """The bound on the error of `phi1`; null where x is exact."""
    response: list[ColumnTimes]
    """The columns that are added to y."""
    interval: BoundColumnRange | None
    """The columns of bounds that take the place of y and ε; null where there are none."""
    law: Law | None
    """The terms that are added to ε above and below y; null without a law."""
    conditions: list[str]
    """The conditions as text."""


class BoundColumn(TypedDict):
    """A column of bounds."""

    column: int
    """The number of the column, from 1."""
    name: str | None
    """The name of the column in the header; null without one."""


class BoundColumnRange(TypedDict):
    """The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds."""

    lower: BoundColumn | None
    """The lower end; a number is rounded down. Null where nothing bounds from below."""
    upper: BoundColumn | None
    """The upper end; a number is rounded up. Null where nothing bounds from above."""


class ColumnTimes(TypedDict):
    """A column times a number."""

    column: int
    """The number of the column, from 1; column 0 holds 1 in every row."""
    name: str | None
    """The name of the column in the header; null without one."""
    times: Exact
    """The exact number by which the column is multiplied."""


class Law(TypedDict):
    """A law of the error bound."""

    above: list[LawTerm]
    """The terms above y."""
    below: list[LawTerm]
    """The terms below y."""


class LawTerm(TypedDict):
    """A term of a law."""

    quantity: Literal["number", "abs", "written"]
    """The quantity of the number in the column: itself, without its sign, or half a unit of its last written digit."""
    column: int
    """The number of the column, from 1; column 0 holds 1 in every row."""
    times: Exact
    """The exact number by which the quantity is multiplied."""


class Proved(TypedDict):
    """A statement that is proved, and its scope."""

    kind: Literal["form", "point", "empty", "least", "set", "left out", "another"]
    """The kind of the statement."""
    rows: list[list[int]] | None
    """First and last number of each range of rows in the scope; null for all rows."""
    without: list[int]
    """The rows that are left out."""
    where: list[int] | None
    """The numbers of the conditions in the scope, from 1; null for all conditions."""
    factor: Exact | None
    """The factor on the error bounds; null where they are as asked."""
    epsilon: Exact | None
    """The bound that takes the place of the error bounds; null where they are as asked."""
    side: Literal["+", "-", "strong"] | None
    """The part of the set, with errors in x; null otherwise."""
    form: NotRequired[list[Exact]]
    """The coefficients of the form; only for `form`."""
    range: NotRequired[ExactRange]
    """The range of the form, rounded outward; only for `form`."""
    point: NotRequired[list[Exact]]
    """The point, exact; only for `point`."""
    extent: NotRequired[Literal["empty", "bounded", "unbounded"]]
    """The extent of the set; only for `set`."""
    vertices: NotRequired[int]
    """The number of vertices; only for `set`."""
    sides: NotRequired[int]
    """The number of sides; only for `set`."""
    least: NotRequired[int]
    """The number of rows to leave out at least; only for `left out`."""
    sets: NotRequired[list[list[int]]]
    """The sets of so many rows; only for `left out`, and absent where they are not stated."""


class ProvedSet(TypedDict):
    """The proved facts about the feasible set."""

    extent: Literal["empty", "bounded", "unbounded"]
    """The extent of the set."""
    vertices: int
    """The number of vertices."""
    sides: int
    """The number of sides."""
    ranges: list[ExactRange] | None
    """The ranges of both parameters, rounded outward; null for an empty set."""


class Statement(TypedDict):
    """A statement about the set of its scope."""

    kind: Literal["form", "point", "empty", "least", "set", "left out"]
    """The kind of the statement."""
    rows: NotRequired[list[int]]
    """First and last row of each range, one after the other."""
    without: NotRequired[list[int]]
    """The rows that are left out."""
    where: NotRequired[list[int]]
    """The numbers of the conditions that hold, from 1."""
    factor: NotRequired[str]
    """The factor on the error bounds."""
    epsilon: NotRequired[str]
    """The bound that takes the place of the error bounds."""
    side: NotRequired[Literal["+", "-", "strong"]]
    """The part of the set, with errors in x."""
    form: NotRequired[list[str]]
    """The coefficients of the form."""
    lower: NotRequired[list[list[list[str]] | list[str]]]
    """The lower end."""
    upper: NotRequired[list[list[list[str]] | list[str]]]
    """The upper end."""
    point: NotRequired[list[str]]
    """A point that they leave."""
    multipliers: NotRequired[list[list[str]]]
    """The terms that prove that smaller errors leave nothing."""
    vertices: NotRequired[list[list[str]]]
    """The vertices."""
    sides: NotRequired[list[list[str | int | None]]]
    """The sides by angle, each with the index of the vertex where it meets the next one; null where it does not."""
    least: NotRequired[int]
    """The number of rows."""
    sets: NotRequired[list[list[int]]]
    """All sets of so many rows without which something is left; absent where they are not stated."""
    contradictions: NotRequired[list[list[list[int] | list[list[str]]]]]
    """Sets of rows that are left out, each with terms that prove that the rest contradicts itself."""


Value = Union[Exact, list[Exact]]
"""An x, or both regressors."""

RowNumber = Union[int]
"""The number of a row in the file, from 1."""
