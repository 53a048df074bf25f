// The documents that boundfit writes, of which `run` of boundfit.mjs answers with the first; made by `cargo xtask generate`.
// `JSON.parse(run(table, options))` is a `FitDocument`.

/** A fit: the feasible parameter set of the readings, and every estimate from it. */
export interface FitDocument {
  /** The name and number of this schema. */
  schema: "boundfit/fit/2";
  /** The program that wrote the document. */
  program: Program;
  /** The question. */
  input: Input;
  /** The least-squares estimate θ̂; null where the readings do not determine it. */
  least_squares: FitLeastSquares | null;
  /** The estimate uncertainty intervals of θ1 and θ2; null where they are not known. */
  eui: [ExactRange, ExactRange] | null;
  /** The feasible parameter set. */
  fps: ActiveRegion;
  /** The parameter uncertainty intervals of θ1 and θ2; null where no end is bounded. */
  pui: [Interval, Interval] | null;
  /** The central estimate; null where the set is empty or unbounded. */
  central: Central | null;
  /** The steepest and the shallowest line; null for an empty set and for two regressors. */
  slopes: Slopes | null;
  /** The least error bound with a feasible parameter, rounded up; null where bounds differ between readings (see `minimax`). */
  epsilon_min: Exact | null;
  /** Gain and offset, which turn readings into x; null unless the model is a line. */
  inverse: Inverses | null;
  /** The minimax estimate; null where no factor on the bounds leaves a feasible parameter. */
  minimax: Minimax | null;
  /** The area of the feasible set over that of its PUI box, rounded to nearest; null where the box has no finite area above 0. */
  tightness: Exact | null;
  /** The centroid of the area, rounded to nearest; null where the set has no finite area above 0. */
  area_centroid: [Exact, Exact] | null;
  /** The rows of an empty set whose removal alone makes it non-empty; null for other sets and where not all rows are in memory. */
  mended_without: number[] | null;
  /** The reason for each main part that is null. */
  reasons: Record<string, string>;
  /** The sets under scaled error bounds; absent unless asked for. */
  sweep?: Sweep;
  /** The guarantee for further readings; absent unless asked for, and where there is no least error bound. */
  guarantee?: Guarantee;
}

/** A fit of a line to readings whose x have errors, too. */
export interface XErrorDocument {
  /** The name and number of this schema. */
  schema: "boundfit/x-errors/2";
  /** The program that wrote the document. */
  program: Program;
  /** The question. */
  input: Input;
  /** The bound on the errors of all x, rounded up; null where a column has them. */
  x_epsilon: Exact | null;
  /** The column of bounds on the errors of x; null where one bound holds for all. */
  x_epsilon_column: string | null;
  /** `weak`: a line agrees with a reading for some x that the errors allow; `strong`: for every such x. */
  agreement: "weak" | "strong";
  /** The sets of lines with θ1 ≥ 0 and with θ1 ≤ 0, or the one set of both. */
  sides: XErrorSide[];
  /** The number of sets that make up all of it, without one that another contains. */
  pieces: number;
  /** True if two sets have lines with θ1 = 0 in common; null unless there are two. */
  joined: boolean | null;
  /** The parameter uncertainty intervals over all sets; null where no end is bounded. */
  pui: [Interval, Interval] | null;
  /** The central estimate; null where there are no lines or the set is unbounded. */
  central: XErrorCentral | null;
  /** The steepest and the shallowest line; null where there are no lines. */
  slopes: Slopes | null;
  /** The least factor on the bounds of x and y; null where it is not known. */
  factor: Factor | null;
  /** The least-squares estimate as if every x were exact; null where the readings do not determine it. */
  least_squares: XErrorLeastSquares | null;
  /** The estimate uncertainty intervals as if every x were exact, rounded outward; null where they are not known. */
  eui: [ExactRange, ExactRange] | null;
  /** The reason for each main part that is null. */
  reasons: Record<string, string>;
}

/** A group of readings, and what they say. */
export interface GroupDocument {
  /** The name and number of this schema. */
  schema: "boundfit/fleet/2";
  /** The input, the same for all lines. */
  input: LineInput;
  /** The text in the column of groups. */
  group: string;
  /** The number of readings of the group. */
  rows: number;
  /** The first row of the group; null where rows are not kept. */
  first_row: number | null;
  /** The least-squares estimate; null where the readings do not determine it. */
  least_squares: LeastSquares | null;
  /** The estimate uncertainty intervals, rounded outward; null where they are not known. */
  eui: [ExactRange, ExactRange] | null;
  /** The feasible parameter set of the group. */
  fps: GroupSet;
  /** The parameter uncertainty intervals; null where no end is bounded. */
  pui: [Interval, Interval] | null;
  /** The central estimate; null where the set is empty or unbounded. */
  central: Central | null;
  /** The least error bound with a feasible parameter, rounded up; null where bounds differ between readings. */
  epsilon_min: Exact | null;
  /** The least common factor on the bounds that leaves a feasible parameter, rounded up; null under one bound for all readings. */
  epsilon_factor: Exact | null;
}

/** A window of consecutive readings, and what they say. */
export interface WindowDocument {
  /** The name and number of this schema. */
  schema: "boundfit/window/1";
  /** The input, the same for all lines. */
  input: LineInput;
  /** The row of the first reading of the window. */
  first_row: number;
  /** The row of the last reading of the window. */
  last_row: number;
  /** The number of readings in it. */
  rows: number;
  /** The x of the oldest and of the newest reading, exact; null with two regressors. */
  x: [Exact, Exact] | null;
  /** The feasible parameter set of the window. */
  fps: FeasibleSet;
  /** The parameter uncertainty intervals; null where no end is bounded. */
  pui: [Interval, Interval] | null;
  /** The central estimate; null where the set is empty or unbounded. */
  central: Central | null;
  /** The least error bound with a feasible parameter, rounded up; null unless the model is a line under one bound without conditions. */
  epsilon_min: Exact | null;
}

/** The status of every reading: what the set of all readings, and that of the others, say of it. Each reading is on a line of its own. */
export interface StatusesDocument {
  /** The name and number of this schema. */
  schema: "boundfit/status/1";
  /** The question. */
  input: Input;
  /** The set of all readings. */
  set: JudgedSet;
  /** The rows whose removal may change the set: those with an irredundant bound, for an empty set those of the contradiction. */
  deciding: number[];
  /** The status of each reading. */
  rows: StatusRow[];
  /** The status of further readings; absent unless asked for. */
  new?: NewStatuses;
  /** The least total widening of the bounds of an empty set; absent unless asked for. */
  repair?: Repair;
}

/** The values of all feasible lines at given x, and the x that given readings may come from. */
export interface PredictionDocument {
  /** The name and number of this schema. */
  schema: "boundfit/predict/1";
  /** The question. */
  input: Input;
  /** The feasible parameter set. */
  fps: FeasibleSet;
  /** The error of a further reading; null where nothing is known of it, with a reason. */
  new_reading: NewReading | null;
  /** The prediction at each value asked for; empty where the set is empty. */
  at: Predicted[];
  /** The sources of each reading asked for; empty where the set is empty. */
  from: Source[];
  /** The reason for each part that is null or empty. */
  reasons: Record<string, string>;
}

/** The x where one more reading certainly makes the feasible set smaller, and the best x of a range. */
export interface NextReadingDocument {
  /** The name and number of this schema. */
  schema: "boundfit/next/1";
  /** The question. */
  input: Input;
  /** The feasible parameter set. */
  fps: FeasibleSet;
  /** The error of the next reading. */
  new_reading: NewReading;
  /** The open intervals of x, ascending, where a reading certainly makes the set smaller. Decimals and doubles are rounded inward. Null where the set is empty. */
  certain: ExactRange[] | null;
  /** The range in which the best x is looked for; null where the set is empty or the x of the readings are not known. */
  within: SearchRange | null;
  /** True if a reading certainly makes the set smaller somewhere in `within`; null where `within` is. */
  certain_within: boolean | null;
  /** The best x of the range for each goal; empty where `within` is null. */
  goals: Goal[];
  /** The reason for each part that is null and for each goal that is left out. */
  reasons: Record<string, string>;
}

/** The fewest readings to exclude so that a feasible parameter is left, and all ways to do so. */
export interface OutliersDocument {
  /** The name and number of this schema. */
  schema: "boundfit/outliers/1";
  /** The question. */
  input: Input;
  /** The fewest readings to exclude; null where the conditions contradict each other. */
  least: number | null;
  /** Every set of `least` rows whose exclusion leaves a feasible parameter, ascending, in lexicographic order; `[[]]` where no reading has to be excluded. */
  sets: number[][];
  /** True if these are all sets; false beyond the limit `sets`. */
  complete: boolean;
  /** For each set, in the order of `sets`, the vertices of the parameters that remain, counter-clockwise. The pieces have no point in common; together they are the parameters that miss at most `least` readings. */
  pieces: ExactActiveVertex[][];
  /** The rest of the piece of each set, in the same order. */
  regions: LeftRegion[];
  /** The ranges of θ1 and θ2 over all pieces, rounded outward; null where there are none. */
  pui: [ExactRange, ExactRange] | null;
  /** The sum of the areas of all pieces, rounded to nearest; null where it is infinite. */
  area: Exact | null;
  /** The parameters that miss at most 0, 1, 2, … readings, up to `least` or to the number asked for. */
  growth: Growth[];
  /** The proof that the conditions contradict each other; null otherwise. */
  certificate: Certificate | null;
  /** The reason for each main part that is null or not complete. */
  reasons: Record<string, string>;
}

/** The runs of consecutive readings that one line fits. Positions count from 1 in `order`. */
export interface LinearRangeDocument {
  /** The name and number of this schema. */
  schema: "boundfit/range/1";
  /** The question. */
  input: Input;
  /** The order of the readings: by x, or by row. */
  by: "x" | "row";
  /** The row at each position. */
  order: number[];
  /** First and last position of each run that cannot be made longer, ascending. */
  runs: [number, number][];
  /** The run with the most readings; null where no reading fits. */
  longest: [number, number] | null;
  /** The run with the widest range of x; null where the order is not by x or x is not known. */
  widest: [number, number] | null;
  /** The fewest runs that together have every reading that is in a run. */
  fewest: [number, number][];
  /** Each run with what stops it, in the order of `runs`. */
  parts: Run[];
  /** The readings that are in no run. */
  alone: Alone[];
  /** The fit of the longest run; null where there is none. */
  longest_fit: Longest | null;
}

/** The linearity of a calibration: the deviation of its average characteristic from four lines, hysteresis and repeatability. */
export interface LinearityDocument {
  /** The name and number of this schema. */
  schema: "boundfit/linearity/1";
  /** The question. */
  input: Calibration;
  /** The number that percents refer to, exact. */
  full_scale: Exact;
  /** The largest less the smallest y, exact. */
  span: Exact;
  /** The line with the least deviation. */
  independent: LinearityLine;
  /** The line through the first and the last point; null where all x are the same. */
  terminal: LinearityLine | null;
  /** The line through the point `through` with the least deviation. */
  zero_based: LinearityLine;
  /** The least-squares line; null where all x are the same. */
  least_squares: LinearityLine | null;
  /** The largest difference between both directions, rounded up; null where no x was read in both. */
  hysteresis: Exact | null;
  /** The largest difference between readings at one x in one direction, rounded up; null where there are none. */
  repeatability: Exact | null;
  /** Hysteresis in percent of full scale, rounded up; null where either is unknown or full scale is 0. */
  hysteresis_percent: Exact | null;
  /** Repeatability in percent of full scale, rounded up; null where either is unknown or full scale is 0. */
  repeatability_percent: Exact | null;
  /** Each x where hysteresis is reached. */
  hysteresis_at: Place[];
  /** Each x where repeatability is reached. */
  repeatability_at: Place[];
  /** The points that prove the independent linearity; none where it is 0. */
  proof: Alternating[];
  /** The point x, y through which the zero-based line goes, exact. */
  through: [Exact, Exact];
  /** The characteristic with rising x; null without directions. */
  up: Characteristic | null;
  /** The characteristic with falling x; null without directions. */
  down: Characteristic | null;
  /** The reason for each part that is null. */
  reasons: Record<string, string>;
}

/** The set that half-planes or generators of a file make. */
export interface PolygonDocument {
  /** The name and number of this schema. */
  schema: "boundfit/polygon/2";
  /** The question. */
  input: HalfPlaneFile;
  /** The set; `active` are rows of half-planes, or of generators the points that equal a vertex or are on a boundary. */
  region: RowNumberRegion;
  /** The rows that are not needed. */
  redundant: number[];
  /** The half-planes of a set that was given by generators; proofs name them by their number here, from 1. Absent otherwise. */
  facets?: HalfPlane[];
  /** The ranges of both coordinates with their proofs; null where no end is bounded. */
  bounds: [Interval, Interval] | null;
  /** The centroid of the area, rounded to nearest; null where the set has no finite area above 0. */
  area_centroid: [Exact, Exact] | null;
  /** The square of the largest distance of two points, exact; null for an empty and for an unbounded set. */
  squared_diameter: Exact | null;
  /** For each number whose fraction is too long to be written, the reason; absent if there are none. */
  reasons?: Record<string, string>;
}

/** The verdicts on the answers of LP solvers to the four linear programs of a fit. */
export interface CheckDocument {
  /** The name and number of this schema. */
  schema: "boundfit/check/2";
  /** The data of the answers. */
  input: CheckInput;
  /** The tolerance that was asked for. */
  tolerance: Exact;
  /** True if a claim may be off by the rounding of its last printed digit. */
  digits_as_printed: boolean;
  /** The readings of the programs. */
  readings: Readings;
  /** The answers, judged. */
  claims: Claim[];
  /** The worst verdict against the data as read, which decides the exit status; null without answers. */
  worst: Worst | null;
  /** The worst verdict against the doubles that a solver receives; null where no answer is judged by them. */
  worst_as_received: Worst | null;
  /** Approximations of the set by linear programs in many directions; null unless asked for. */
  directions: Directions | null;
}

/** The exact answer to a linear program, and the verdicts on solutions. Vectors have an entry per column, in the order of the model. */
export interface JudgeDocument {
  /** The name and number of this schema. */
  schema: "boundfit/judge/1";
  /** The model. */
  input: Model;
  /** The status. */
  status: "optimal" | "infeasible" | "unbounded";
  /** The optimum with the constant, exact; null unless optimal. */
  objective: Exact | null;
  /** All optimal points; null unless optimal. */
  face: Face | null;
  /** The columns. */
  columns: ModelColumn[];
  /** The rows. */
  rows: ModelRow[];
  /** Bounds with multipliers that prove infeasibility: the forms add up to 0, the bounds to more than 0. Null unless infeasible. */
  farkas: SideTerm[] | null;
  /** A feasible point, exact; null unless unbounded. */
  point: Exact[] | null;
  /** A direction that stays feasible and improves; null unless unbounded. */
  ray: Exact[] | null;
  /** The feasible set in the plane of the columns that bounds do not fix. */
  plane: Plane;
  /** The verdicts on solution files; absent if none was given. */
  solutions?: Solution[];
}

/** The verdict on a proof. */
export interface VerifyDocument {
  /** The name and number of this schema. */
  schema: "boundfit/verify/1";
  /** True if every statement is true of the data, and the question is the one asked. Only the rows and conditions of a theorem for Coq are compared: `coqc` alone checks what it concludes. */
  verified: boolean;
  /** The number of half-planes; null unless the proof is true. */
  half_planes: number | null;
  /** The first false statement, or the first of the differences; null when verified. */
  falsehood: string | null;
  /** The differences between the question of the proof and the one asked, a sentence each. */
  differences: string[];
  /** The file of the proof; null for standard input. */
  proof: string | null;
  /** The file of the data; null for standard input. */
  data: string | null;
  /** The question of the proof, whether the proof is true or not. */
  about: About;
  /** The proved facts about the feasible set; null unless the proof is true and about one set. */
  set: ProvedSet | null;
  /** The number of rows of a theorem for Coq, all of which are those of the data; null for other proofs. */
  theorem_rows: number | null;
  /** The proved statements, in the order of a proof `boundfit/proof/2`; null unless the proof is true and of that kind. */
  statements: Proved[] | null;
}

/** A proof of a fit: the feasible set and the ranges of both parameters. */
export interface ProofDocument {
  /** The name and number of this schema. */
  schema: "boundfit/proof/1";
  /** SHA-256 of the bytes of the data. */
  sha256: string;
  /** The character between cells. */
  delimiter: string;
  /** True if the first row names the columns. */
  header: boolean;
  /** First and last row of each range, one after the other. */
  rows: number[];
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** φ1, φ2, y and ε: the number of a column, and by how much it is multiplied. Column 0 holds 1 in every row. */
  model: [[number, string], [number, string], [number, string], [number, string]];
  /** The columns of lower and of upper bounds that take the place of y and ε; absent if there are none. */
  interval?: [number | null, number | null];
  /** The bounds above and below y beside ε: a quantity, `abs` or `written`, the number of a column, and by how much it is multiplied. Absent without a law. */
  law?: [[string, number, string][], [string, number, string][]];
  /** The number that is taken from the column of φ1 before it is multiplied; absent if it is 0. */
  x_origin?: string;
  /** The column of bounds on the errors of x, and by how much it is multiplied; absent where x is exact. */
  x_error?: [number, string];
  /** The columns whose sum takes the place of y, and by how much each is multiplied; absent if there are none. */
  response?: [number, string][];
  /** The conditions a1·θ1 + a2·θ2 ≤ b as a1, a2 and b; a fourth text `=` makes an equation. */
  conditions: string[][];
  /** The vertices θ. */
  vertices: [string, string][];
  /** Every half-plane whose border passes through a vertex, with the index of the vertex from 0. */
  active: [number, string][];
  /** The sides by angle, each with the index of the vertex where it meets the next one; null where it does not. */
  sides: [string, number | null][];
  /** The terms that prove an empty set; empty for other sets. */
  farkas: [string, string][];
  /** The ends of θ1 and of θ2, lower before upper; empty for an empty set. */
  bounds: [[string, string][], [string, string], [string, string]][];
}

/** A proof of statements, each about the set of some of the rows. */
export interface StatementsDocument {
  /** The name and number of this schema. */
  schema: "boundfit/proof/2";
  /** SHA-256 of the bytes of the data. */
  sha256: string;
  /** The character between cells. */
  delimiter: string;
  /** True if the first row names the columns. */
  header: boolean;
  /** First and last row of each range, one after the other. */
  rows: number[];
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** φ1, φ2, y and ε: the number of a column, and by how much it is multiplied. Column 0 holds 1 in every row. */
  model: [[number, string], [number, string], [number, string], [number, string]];
  /** The columns of lower and of upper bounds that take the place of y and ε; absent if there are none. */
  interval?: [number | null, number | null];
  /** The bounds above and below y beside ε: a quantity, `abs` or `written`, the number of a column, and by how much it is multiplied. Absent without a law. */
  law?: [[string, number, string][], [string, number, string][]];
  /** The number that is taken from the column of φ1 before it is multiplied; absent if it is 0. */
  x_origin?: string;
  /** The column of bounds on the errors of x, and by how much it is multiplied; absent where x is exact. */
  x_error?: [number, string];
  /** The columns whose sum takes the place of y, and by how much each is multiplied; absent if there are none. */
  response?: [number, string][];
  /** The conditions a1·θ1 + a2·θ2 ≤ b as a1, a2 and b; a fourth text `=` makes an equation. */
  conditions: string[][];
  /** The statements. */
  statements: Statement[];
}

/** The name of a half-plane. */
export interface Active {
  /** The number of the row in the file, from 1; null for a condition and for the sign of the slope. */
  row: number | null;
  /** The bound of the row, `upper` or `lower`; or the condition, `where:1`; of an equation `where:1 upper` (≤) or `where:1 lower` (≥). Under errors in x a corner of the box follows, `upper left`, and `theta1 >= 0` is the side itself. */
  bound: string;
}

/** Half-planes whose borders pass through a vertex, or are a side of the set. */
export interface ActiveList {
  /** The first 1,000 of these half-planes. */
  active: Active[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing. */
export interface ActiveRegion {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The vertices, counter-clockwise from the lexicographically smallest. */
  vertices: ExactActiveVertex[];
  /** Directions in which the set goes on without end, as coprime integers. */
  rays: [Exact, Exact][];
  /** Directions in which the set goes on without end both ways, as coprime integers. */
  lines: [Exact, Exact][];
  /** The half-planes behind each side of a set without vertices; otherwise empty. */
  boundaries: ActiveList[];
  /** A point of the set, exact; null for the empty set. */
  witness: [Exact, Exact] | null;
  /** The area, rounded to nearest; null for an empty and for an infinite set. */
  area: Exact | null;
  /** The proof that the set is empty; null for other sets and where `farkas` of the answer has it. */
  certificate: Certificate | null;
}

/** The blocks of a file. */
export interface Blocks {
  /** The number of blocks in the file. */
  total: number;
  /** The number of the block that was read, from 1; null where all were. */
  read: number | null;
  /** The name of that block; null where it has none. */
  name: string | null;
}

/** An end of an interval: a number with the terms that prove it. All forms of the number are null where nothing bounds. */
export interface Bound {
  /** The end as a fraction `p/q` or an integer; null where nothing bounds. */
  exact: string | null;
  /** A decimal, rounded outward; null where nothing bounds. */
  decimal: string | null;
  /** The nearest double; null where nothing bounds and beyond the largest double. */
  value: number | null;
  /** The next double that is not inside; null where nothing bounds and beyond the largest double. */
  outward: number | null;
  /** The terms that prove the end; empty where nothing bounds. */
  active: Term[];
}

/** A factor at which half-planes enter or leave the shape, and the set there. */
export interface Breakpoint {
  /** The factor, rounded up. */
  s: Exact;
  /** The error bound s·ε, rounded up; null where readings differ in their bounds. */
  epsilon: Exact | null;
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The vertices, counter-clockwise from the lexicographically smallest. */
  vertices: ExactActiveVertex[];
  /** Directions in which the set goes on without end, as coprime integers. */
  rays: [string, string][];
  /** Directions in which the set goes on without end both ways, as coprime integers. */
  lines: [string, string][];
  /** The sides of a set without vertices. */
  boundaries: ExactBoundary[];
  /** The parameter uncertainty intervals, rounded outward; null for an empty set. */
  pui: [ExactRange, ExactRange] | null;
  /** The area, rounded to nearest; null for an empty and for an infinite set. */
  area: Exact | null;
  /** The bounds that enter the shape here. */
  entering: Active[];
  /** The bounds that leave the shape here. */
  leaving: Active[];
}

/** The central estimate: the middle of the PUI box. */
export interface Central {
  /** θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error. */
  theta: [Exact, Exact];
  /** Half the width of each interval, rounded up so that it covers the rounding of `theta`. */
  guaranteed_error: [Exact, Exact];
}

/** The proof that a set is empty. */
export interface Certificate {
  /** The terms, at most three, that add up to 0 ≤ a negative number. */
  farkas: Term[];
}

/** An exact number and its forms. Decisions take `exact`. */
export interface Exact {
  /** The number as a fraction `p/q` or an integer; null where the fraction is longer than the limit `fraction`. */
  exact: string | null;
  /** A decimal, rounded to the significant digits asked for: ends of intervals outward, error bounds up, other numbers to nearest. */
  decimal: string;
  /** The nearest double; null beyond the largest double. */
  value: number | null;
  /** A double that is never inside: lower ends are rounded down, upper ends, error bounds and factors up. Null beyond the largest double; absent for other numbers. */
  outward?: number | null;
}

/** A vertex of a set. */
export interface ExactActiveVertex {
  /** θ1 and θ2, exact. */
  theta: [Exact, Exact];
  /** The first 1,000 of these half-planes. */
  active: Active[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** A side normal·θ ≤ offset of a set without vertices. */
export interface ExactBoundary {
  /** The outer normal, as coprime integers. */
  normal: [string, string];
  /** The largest value of normal·θ, exact. */
  offset: Exact;
  /** The first 1,000 of these half-planes. */
  active: Active[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds. */
export interface ExactRange {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: Exact | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: Exact | null;
}

/** The least-squares estimate, exact and in doubles. */
export interface FitLeastSquares {
  /** θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error where there is one. */
  theta: [Exact, Exact];
  /** True if the estimate is in the feasible set. */
  in_fps: boolean;
  /** The largest distance of each parameter to any in the feasible set, rounded up so that it covers the rounding of `theta`; null where the set is empty or unbounded. */
  guaranteed_error: [Exact, Exact] | null;
  /** The same estimate in doubles, by `qr` and by `pseudo_inverse`; an estimate is null where its method fails. Empty where not all readings are in memory. */
  binary64: Record<string, Float | null>;
}

/** An estimate computed in doubles. */
export interface Float {
  /** θ1 and θ2 as doubles. */
  theta: [number, number];
  /** The distance of each to the exact estimate, rounded up. */
  distance: [Exact, Exact];
}

/** A column whose cells are fractions such as `3/4`. */
export interface Fractions {
  /** The name of the column. */
  column: string;
  /** The number of cells that are fractions. */
  cells: number;
  /** The first such cell. */
  first: string;
}

/** An error bound that was found from the readings themselves. */
export interface FromLeast {
  /** The multiple that was asked for, exact. */
  factor: Exact;
  /** The least error bound that leaves a feasible parameter, rounded up. */
  epsilon_min: Exact;
  /** The assumption behind such a bound. */
  assumes: string;
}

/** A guarantee for further readings. */
export interface Guarantee {
  /** The confidence that was asked for, exact. */
  confidence: Exact;
  /** The share of further readings in the band of the least error bound, rounded down; 0 where nothing is guaranteed. */
  covered: Exact;
  /** The number of readings that it follows from. */
  readings: number;
  /** The number of unknowns. */
  unknowns: number;
  /** The assumptions. */
  assumes: string[];
  /** The source of the proof. */
  source: string;
}

/** The line that names the columns. */
export interface Header {
  /** The number of the line, or of the row of a sheet; null without names. */
  line: number | null;
  /** True if that line is a comment, or a row that begins as one. */
  comment: boolean;
  /** True if nothing told a header from a reading: every cell of the first line that is used is a number or missing. */
  open: boolean;
  /** True if each row begins with a name, so that it has a cell more than the header. */
  row_names: boolean;
}

/** The question: file, rows, columns, model, error bound and conditions. */
export interface Input {
  /** The file as it was named; null for standard input. */
  file: string | null;
  /** The number of rows that are used. */
  rows: number;
  /** The number of rows in the file. */
  rows_total: number;
  /** The rows that were asked for; absent if all were. */
  selection?: Selection;
  /** The number of rows that were skipped because a value is missing; absent if there are none. */
  rows_missing?: number;
  /** The format of the table as it was read; null for files that are neither text nor a sheet nor JSON. */
  table: Table | null;
  /** The columns whose cells are fractions; absent if there are none. */
  fractions?: Fractions[];
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** SHA-256 of the bytes of the file; null where they were not hashed. */
  sha256: string | null;
  /** `line-through-origin` means that θ2 is 0. */
  model: "line" | "line-through-origin" | "two-regressors";
  /** The column of x, or both columns of the regressors. */
  x: string[];
  /** The column of y; null where readings have only bounds. */
  y: string | null;
  /** The units of columns and parameters; absent if no name of a column has a unit, as in `U (mV)` or `U [mV]`. */
  units?: Units;
  /** The error bound ε of all readings, rounded up; null where each reading has its own. */
  epsilon: Exact | null;
  /** The column of error bounds; null where there is none. */
  epsilon_column: string | null;
  /** The law of the error bound as it was typed; absent without a law. */
  epsilon_law?: string;
  /** The columns of bounds that take the place of y and ε; absent if there are none. */
  interval?: IntervalColumns;
  /** The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise. */
  epsilon_from_least?: FromLeast;
  /** The value from which x is counted, exact; absent if it is 0. */
  x_origin?: Exact;
  /** The conditions on the parameters as they were typed. */
  where: string[];
}

/** The interval of a parameter, each end with its proof. */
export interface Interval {
  /** The lower end, rounded down. */
  lower: Bound;
  /** The upper end, rounded up. */
  upper: Bound;
}

/** The columns of bounds on each reading; one of them may be null. */
export interface IntervalColumns {
  /** The column of lower bounds; null where there is none. */
  lower: string | null;
  /** The column of upper bounds; null where there is none. */
  upper: string | null;
}

/** A parameter of the inverse line. */
export interface Inverse {
  /** The range over the feasible set: no interval, one, or two where slopes have both signs. Ends are rounded outward. */
  exact_range: ExactRange[];
  /** The range over the PUI box, rounded outward. */
  box_range: ExactRange[];
  /** The range over the EUI box, rounded outward; null where there is no EUI. */
  eui_range: ExactRange[] | null;
  /** The value for the central estimate, exact; null where there is none. */
  central: Exact | null;
  /** The value for the least-squares estimate, exact; null where there is none. */
  least_squares: Exact | null;
}

/** The inverse line x = gain · y + offset. */
export interface Inverses {
  /** 1/θ1. */
  gain: Inverse;
  /** −θ2/θ1. */
  offset: Inverse;
}

/** The function constant + slope·s, with exact fractions. */
export interface Linear {
  /** The value at s = 0. */
  constant: string;
  /** The factor of s. */
  slope: string;
}

/** A vertex of a set. */
export interface LinearActiveVertex {
  /** θ1 and θ2, exact. */
  theta: [Linear, Linear];
  /** The first 1,000 of these half-planes. */
  active: Active[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** A side normal·θ ≤ offset of a set without vertices. */
export interface LinearBoundary {
  /** The outer normal, as coprime integers. */
  normal: [string, string];
  /** The largest value of normal·θ, exact. */
  offset: Linear;
  /** The first 1,000 of these half-planes. */
  active: Active[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds. */
export interface LinearRange {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: Linear | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: Linear | null;
}

/** The estimate that survives the smallest error bounds. */
export interface Minimax {
  /** θ1 and θ2, exact. */
  theta: [Exact, Exact];
  /** True if no other parameter serves as well. */
  unique: boolean;
  /** The least error bound, rounded up; null where bounds differ between readings. */
  epsilon: Exact | null;
  /** The least common factor on the bounds, or on the widths of intervals, rounded up; null under one bound for all readings. */
  epsilon_factor: Exact | null;
  /** The terms that prove that no smaller bound or factor leaves a parameter. */
  proof: Term[];
}

/** The set between two breakpoints; every number is a function of s. */
export interface Piece {
  /** The factor at which it begins, rounded up. */
  from: Exact;
  /** The factor at which it ends, rounded up. */
  to: Exact;
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The vertices, counter-clockwise. */
  vertices: LinearActiveVertex[];
  /** Directions in which the set goes on without end, as coprime integers. */
  rays: [string, string][];
  /** Directions in which the set goes on without end both ways, as coprime integers. */
  lines: [string, string][];
  /** The sides of a set without vertices. */
  boundaries: LinearBoundary[];
  /** The parameter uncertainty intervals; null for an empty set. */
  pui: [LinearRange, LinearRange] | null;
  /** The area; null for an infinite set. */
  area: Quadratic | null;
}

/** The program that wrote a document. */
export interface Program {
  /** `boundfit`. */
  name: string;
  /** The version of the program. */
  version: string;
}

/** The function constant + slope·s + quadratic·s². A coefficient is null where its fraction is too long. */
export interface Quadratic {
  /** The value at s = 0, an exact fraction. */
  constant: string | null;
  /** The factor of s, an exact fraction. */
  slope: string | null;
  /** The factor of s², an exact fraction. */
  quadratic: string | null;
  /** Decimals of all three, rounded to nearest; absent if all fractions are written. */
  decimals?: [string, string, string];
}

/** The rows that were asked for. */
export interface Selection {
  /** The rows by number, such as `5,14-36`; null if not asked for. */
  rows: string | null;
  /** The excluded rows by number; null if there are none. */
  without: string | null;
  /** The conditions on cells, such as `V >= -6`. */
  where_row: string[];
}

/** The sheet that was read, and what a spreadsheet shows otherwise. */
export interface Sheet {
  /** The name of the sheet; null in a workbook of one sheet. */
  name: string | null;
  /** The number of the sheet, from 1. */
  number: number;
  /** The number of sheets in the workbook. */
  total: number;
  /** True if spreadsheets do not show the sheet. */
  hidden: boolean;
  /** The number of rows that were read although spreadsheets do not show them. */
  hidden_rows: number;
  /** The number of columns that spreadsheets do not show. */
  hidden_columns: number;
  /** The number of areas of merged cells. Their first cell alone has a value. */
  merged: number;
}

/** Lines that were passed over, and rows of another length. */
export interface Skipped {
  /** Lines before the table that were skipped because the names stand in a later one. */
  lines: number;
  /** Comment lines between rows. */
  comments: number;
  /** Rows with fewer cells than the first one. */
  short_rows: number;
  /** Rows with more cells than the first one. */
  long_rows: number;
  /** Rows that repeat the header; absent if there are none. */
  headers?: number;
}

/** A line at an end of the slopes. */
export interface Slope {
  /** Slope and intercept, exact. */
  theta: [Exact, Exact];
  /** The side that has the line, with errors in x only: `+` (θ1 ≥ 0), `-` (θ1 ≤ 0) or `both`. */
  side?: "+" | "-" | "both";
  /** The bounds that the line touches. */
  active: Active[];
}

/** The lines at the two ends of the slopes. */
export interface Slopes {
  /** The line with the largest slope; null where slopes have no upper end. */
  largest: Slope | null;
  /** The line with the smallest slope; null where slopes have no lower end. */
  smallest: Slope | null;
}

/** The feasible sets under all error bounds times s, from one factor s to another. */
export interface Sweep {
  /** The first factor, rounded up. */
  from: Exact;
  /** The last factor, rounded up. */
  to: Exact;
  /** The least factor that leaves a feasible parameter, rounded up; null where none does. */
  least: Exact | null;
  /** The factors at which the shape of the set changes, ascending, with the set there. */
  breakpoints: Breakpoint[];
  /** The sets between two breakpoints as functions of s. */
  pieces: Piece[];
}

/** The detected format of a table of text, JSON or a sheet. */
export interface Table {
  /** The line that names the columns. */
  header: Header;
  /** `comma`, `semicolon`, `tab`, `space`, `pipe` or the character; null for sheets and JSON. */
  delimiter: string | null;
  /** The decimal mark. */
  decimal: "point" | "comma";
  /** True if the comma that was taken for the decimal mark may as well group digits; absent otherwise. */
  decimal_open?: boolean;
  /** The character that groups digits; null where there is none. */
  thousands: string | null;
  /** The encoding of the text, such as `UTF-8`; null for sheets. */
  encoding: string | null;
  /** The characters that start a comment line; null where there are none. */
  comment: string | null;
  /** The sheet of a workbook; absent for other files. */
  sheet?: Sheet;
  /** The blocks of the file, and which was read; null for a file of one block. */
  blocks: Blocks | null;
  /** The lines and rows that are unusual. */
  skipped: Skipped;
}

/** A half-plane times a positive multiplier. The sum of all terms of a proof is the claim. */
export interface Term {
  /** The number of the row in the file, from 1; null for a condition and for the sign of the slope. */
  row: number | null;
  /** The bound of the row or the condition, as in `active`; `facet` for a half-plane of the list `facets`. */
  bound: string;
  /** The exact multiplier, greater than 0. */
  multiplier: Exact;
}

/** Units from the names of columns, and the units of the parameters that follow; null where unknown. */
export interface Units {
  /** The unit of each column of x. */
  x: (string | null)[];
  /** The unit of y. */
  y: string | null;
  /** The unit of θ1. */
  theta1: string | null;
  /** The unit of θ2. */
  theta2: string | null;
}

/** The least factor on the bounds of x and y that leaves a line: lower < factor ≤ upper, or both ends are the factor itself. */
export interface Factor {
  /** Less than the least factor, or the least factor where both ends are equal; a number of 17 digits, rounded down. */
  lower: Exact;
  /** At least the least factor; a number of 17 digits, rounded up. */
  upper: Exact;
  /** True if `upper` leaves a line. */
  attained: boolean;
  /** The side of the line, or of the last lines. */
  side: "+" | "-" | "both";
  /** A line that `upper` leaves, exact; null where there is none. */
  theta: [Exact, Exact] | null;
  /** Bounds that leave nothing under `lower`, or under smaller factors where both ends are equal. */
  fixed_by: Active[];
}

/** The central estimate of all sets. */
export interface XErrorCentral {
  /** θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error. */
  theta: [Exact, Exact];
  /** Half the width of each interval, rounded up so that it covers the rounding of `theta`. */
  guaranteed_error: [Exact, Exact];
  /** True if it is in one of the sets. */
  in_fps: boolean;
}

/** The least-squares estimate as if every x were exact. */
export interface XErrorLeastSquares {
  /** θ1 and θ2, exact. */
  theta: [Exact, Exact];
  /** True if the estimate is in one of the sets. */
  in_fps: boolean;
  /** True if the estimate is in the feasible set of exact x; null where that is not known. */
  in_fps_without_x_errors: boolean | null;
}

/** The feasible lines of one side. */
export interface XErrorSide {
  /** `+`: θ1 ≥ 0; `-`: θ1 ≤ 0; `both`: all lines. */
  side: "+" | "-" | "both";
  /** The set. */
  fps: ActiveRegion;
  /** The parameter uncertainty intervals of the set; null where no end is bounded. */
  pui: [Interval, Interval] | null;
}

/** The feasible parameter set of a group. */
export interface GroupSet {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The number of vertices. */
  vertex_count: number;
  /** The proof that the set is empty; null for other sets. */
  certificate: Certificate | null;
}

/** A least-squares estimate. */
export interface LeastSquares {
  /** θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error where there is one. */
  theta: [Exact, Exact];
  /** True if the estimate is in the feasible set. */
  in_fps: boolean;
  /** The largest distance of each parameter to any in the feasible set, rounded up so that it covers the rounding of `theta`; null where the set is empty or unbounded. */
  guaranteed_error: [Exact, Exact] | null;
}

/** The input of a report that has a line per answer: the same for all lines. */
export interface LineInput {
  /** The format of the table as it was read; null for files that are neither text nor a sheet nor JSON. */
  table: Table | null;
}

/** The kind of a set, and why it is empty. */
export interface FeasibleSet {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The proof that the set is empty; null for other sets. */
  certificate: Certificate | null;
}

/** The set of all readings. */
export interface JudgedSet {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The terms, at most three, that prove an empty set; null for other sets. */
  contradiction: Term[] | null;
}

/** The status of a further reading. Fields are null for the same reasons as for the readings of the set. */
export interface NewStatusRow {
  /** The row. */
  row: number;
  /** The width of the predicted interval over that of the reading; exact. */
  leverage: Exact | null;
  /** The distance of both middles over half the width of the reading, with its sign; exact. */
  residual: Exact | null;
  /** The status against the set. */
  status: "inner" | "boundary" | "outer" | "strictly outer" | "outlier" | null;
}

/** The status of further readings, against the set of all readings. */
export interface NewStatuses {
  /** The file of the further readings; null for standard input. */
  file: string | null;
  /** The status of each further reading. */
  rows: NewStatusRow[];
}

/** The least total widening that makes the set non-empty. */
export interface Repair {
  /** The least sum of the factors on all widths, each at least 1, exact. Null where the bounds and conditions that stay as they are contradict each other, or not all rows are in memory. */
  total: Exact | null;
  /** The number of readings with a width; null where `total` is. */
  count: number | null;
  /** The parameters that meet the wider bounds, exact; null where `total` is. */
  theta: [Exact, Exact] | null;
  /** The readings whose bounds are widened. */
  widened: Widened[];
  /** The multipliers of readings that prove the total. */
  multipliers: RowMultiplier[];
  /** The terms of bounds and conditions that stay as they are, which are part of the proof. */
  held: Term[];
  /** The contradiction of bounds and conditions that stay as they are; null where there is none. */
  contradiction: Term[] | null;
}

/** The multiplier of a reading. */
export interface RowMultiplier {
  /** The row. */
  row: number;
  /** The multiplier, exact, with its sign. */
  value: Exact;
}

/** The status of a reading. Leverage and residual are null where the values over the set have no end, or the reading has one bound or no width; all is null against an empty set. */
export interface StatusRow {
  /** The row. */
  row: number;
  /** The width of the predicted interval over that of the reading, from the set of all readings; exact. */
  leverage: Exact | null;
  /** The distance of both middles over half the width of the reading, with its sign; exact. */
  residual: Exact | null;
  /** The status against the set of all readings. */
  status: "inner" | "boundary" | null;
  /** The status against the set of the other readings. */
  without: "inner" | "boundary" | "outer" | "strictly outer" | "outlier" | null;
  /** The leverage from the set of the other readings. */
  without_leverage: Exact | null;
  /** The residual from the set of the other readings. */
  without_residual: Exact | null;
}

/** A reading whose bounds are widened. */
export interface Widened {
  /** The row. */
  row: number;
  /** The factor on its width, rounded up. */
  factor: Exact;
  /** Half of the width that it needs, rounded up. */
  half_width: Exact;
}

/** The bound on the error of a further reading. */
export interface NewReading {
  /** The bound, rounded up; null under a law. */
  epsilon: Exact | null;
  /** The law as it was typed; null without one. */
  law: string | null;
  /** True if the bound was given for further readings; otherwise it is that of the readings. */
  given: boolean;
}

/** An interval of x that a reading may come from. */
export interface Possible {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: Exact | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: Exact | null;
  /** True if the lower end belongs to the interval; null without end. */
  lower_included: boolean | null;
  /** True if the upper end belongs to the interval; null without end. */
  upper_included: boolean | null;
  /** The proof of both ends; null for an end that is not there. */
  proof: SourceEndRange;
}

/** The prediction at one value. */
export interface Predicted {
  /** The value asked for, exact: x, or both regressors. */
  x: Value;
  /** The interval of the feasible lines there, rounded outward. */
  line: ExactRange;
  /** The interval of a further reading there, rounded outward; null where nothing is known of its error. */
  reading: ExactRange | null;
  /** The proof of both ends of `line`; null for an end where the set is empty. The terms of a lower end prove −φ·θ ≤ −lower. */
  proof: ProofEndRange;
}

/** The proof of an end: where it is reached and the terms that prove it, or the ray along which there is none. */
export interface ProofEnd {
  /** The parameters that reach the end, exact; where there is no end, a point of the set. */
  theta: [Exact, Exact];
  /** The terms that prove the end; empty where there is none. */
  active: Term[];
  /** The direction along which the value goes on without end; null where there is an end. */
  ray: [Exact, Exact] | null;
}

/** The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds. */
export interface ProofEndRange {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: ProofEnd | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: ProofEnd | null;
}

/** The x that a reading may come from. */
export interface Source {
  /** The reading asked for, exact. */
  y: Exact;
  /** The intervals of x, ascending: none, one or two. */
  x: Possible[];
}

/** The proof of an end of x. */
export interface SourceEnd {
  /** The end of the line's interval that decides there. */
  line: "lower" | "upper";
  /** The parameters that reach the end, exact; where there is no end, a point of the set. */
  theta: [Exact, Exact];
  /** The terms that prove the end; empty where there is none. */
  active: Term[];
  /** The direction along which the value goes on without end; null where there is an end. */
  ray: [Exact, Exact] | null;
}

/** The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds. */
export interface SourceEndRange {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: SourceEnd | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: SourceEnd | null;
}

/** An x, or both regressors. */
export type Value = Exact | [Exact, Exact];

/** The best x for a goal. */
export interface Goal {
  /** The goal: the length of a parameter's interval, or the area of the set. */
  goal: "theta1" | "theta2" | "area";
  /** The value of the goal before the reading, rounded up; null where it has no bound. */
  now: Exact | null;
  /** The largest value after a reading at the best x, rounded up; null where it has no bound. */
  worst: Exact | null;
  /** The best x, exact, ascending; empty where the worst outcome leaves the goal as it is at every x of the range. */
  at: Exact[];
}

/** A range of x, both ends included. */
export interface SearchRange {
  /** The lower end, exact. */
  lower: Exact;
  /** The upper end, exact. */
  upper: Exact;
  /** True if the range was given; otherwise it is that of the readings. */
  given: boolean;
}

/** The parameters that miss at most so many readings. */
export interface Growth {
  /** The most readings that may be missed. */
  most: number;
  /** The number of pieces that are not connected. */
  pieces: number;
  /** The number of holes in them. */
  holes: number;
  /** The ranges of θ1 and θ2, rounded outward; null where there are no pieces. */
  pui: [ExactRange, ExactRange] | null;
  /** The area, rounded to nearest; null where there are no pieces or it is infinite. */
  area: Exact | null;
}

/** The parameters that remain without a set of readings, beside their vertices. */
export interface LeftRegion {
  /** The kind of the piece. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** Directions in which the piece goes on without end, as coprime integers. */
  rays: [Exact, Exact][];
  /** Directions in which the piece goes on without end both ways, as coprime integers. */
  lines: [Exact, Exact][];
  /** The half-planes behind each side of a piece without vertices; otherwise empty. */
  boundaries: ActiveList[];
  /** A point of the piece, exact. */
  witness: [Exact, Exact] | null;
  /** The ranges of θ1 and θ2 over the piece, rounded outward. */
  pui: [ExactRange, ExactRange] | null;
  /** The area, rounded to nearest; null where it is infinite. */
  area: Exact | null;
  /** The distance by which each excluded reading is missed; null for sets beyond the first 20,000 rows in all. */
  missed: Missed[] | null;
}

/** An excluded reading: the bound that is passed, and by how much. */
export interface Missed {
  /** The row. */
  row: number;
  /** The bound that the parameters pass; null for a row that no parameters meet. */
  bound: "lower" | "upper" | null;
  /** The amount by which they pass it, from the least to the most over the piece; null for a row that no parameters meet. */
  by: ExactRange | null;
}

/** A reading that is in no run. */
export interface Alone {
  /** The position of the reading. */
  position: number;
  /** The row of the reading. */
  row: number;
  /** The terms by which the readings at its x contradict each other or the conditions. */
  farkas: Term[];
}

/** The feasible set of the longest run. */
export interface Longest {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The parameter uncertainty intervals; null where no end is bounded. */
  pui: [Interval, Interval] | null;
  /** The central estimate; null where the set is unbounded. */
  central: Central | null;
  /** The least error bound with a feasible parameter, rounded up; null where bounds differ between readings. */
  epsilon_min: Exact | null;
}

/** A run with what stops it. */
export interface Run {
  /** The first position. */
  first: number;
  /** The last position. */
  last: number;
  /** The rows at both positions. */
  rows: [number, number];
  /** The least and the largest x, exact; null where x is not known. */
  x: [Exact, Exact] | null;
  /** The terms that contradict each other once the readings at the x before the run are added (by row: the reading before it); null at the first reading. */
  before: Term[] | null;
  /** The same of the readings after the run; null at the last reading. */
  after: Term[] | null;
}

/** A point that proves the independent linearity. */
export interface Alternating {
  /** The x of the point, exact. */
  x: Exact;
  /** The mean y of the point, exact. */
  y: Exact;
  /** The rows of the point. */
  rows: number[];
  /** y less the line, exact. */
  residual: Exact;
  /** The weight of the point in the proof, exact. */
  weight: Exact;
}

/** The question: file, rows, columns and full scale. */
export interface Calibration {
  /** The file as it was named; null for standard input. */
  file: string | null;
  /** The number of rows that are used. */
  rows: number;
  /** The number of rows in the file. */
  rows_total: number;
  /** The rows that were asked for; absent if all were. */
  selection?: Selection;
  /** The number of rows that were skipped because a value is missing. */
  rows_missing: number;
  /** The format of the table as it was read; null for files that are neither text nor a sheet nor JSON. */
  table: Table | null;
  /** The columns whose cells are fractions; absent if there are none. */
  fractions?: Fractions[];
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** SHA-256 of the bytes of the file; null where they were not hashed. */
  sha256: string | null;
  /** The column of x. */
  x: string;
  /** The column of y; null where each direction has a column of its own. */
  y: string | null;
  /** The column of readings with rising x; null otherwise. */
  up: string | null;
  /** The column of readings with falling x; null otherwise. */
  down: string | null;
  /** The column of directions; null without one. */
  direction: Direction | null;
  /** The number of points of the average characteristic. */
  points: number;
  /** The source of full scale: the span of y, or a given number. */
  full_scale: "span" | "given";
}

/** A characteristic: the mean y at each x, beside four lines. */
export interface Characteristic {
  /** The number that percents refer to, exact. */
  full_scale: Exact;
  /** The largest less the smallest y, exact. */
  span: Exact;
  /** The line with the least deviation. */
  independent: LinearityLine;
  /** The line through the first and the last point; null where all x are the same. */
  terminal: LinearityLine | null;
  /** The line through the point `through` with the least deviation. */
  zero_based: LinearityLine;
  /** The least-squares line; null where all x are the same. */
  least_squares: LinearityLine | null;
}

/** A column of directions. */
export interface Direction {
  /** The name of the column. */
  column: string;
  /** The words for rising x. */
  up: string[];
  /** The words for falling x. */
  down: string[];
}

/** A line beside a characteristic. */
export interface LinearityLine {
  /** The largest distance in y between characteristic and line, rounded up. */
  deviation: Exact;
  /** The deviation in percent of full scale, rounded up; null where full scale is 0. */
  percent: Exact | null;
  /** Slope and intercept, exact. */
  theta: [Exact, Exact];
  /** The rows where the deviation is reached. */
  rows: number[];
  /** True if no other line of this sort serves as well. */
  unique: boolean;
}

/** An x with its rows. */
export interface Place {
  /** The value of x, exact. */
  x: Exact;
  /** The rows with this x. */
  rows: number[];
}

/** A vertex of a set. */
export interface ExactRowNumberVertex {
  /** θ1 and θ2, exact. */
  theta: [Exact, Exact];
  /** The first 1,000 of these half-planes. */
  active: RowNumber[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** The half-plane a·θ ≤ b. */
export interface HalfPlane {
  /** The normal, exact. */
  a: [Exact, Exact];
  /** The offset, exact. */
  b: Exact;
}

/** A file of half-planes or generators. */
export interface HalfPlaneFile {
  /** The file as it was named; null for standard input. */
  file: string | null;
  /** The number of rows. */
  rows: number;
  /** The format of the table as it was read; null for files that are neither text nor a sheet nor JSON. */
  table: Table | null;
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** SHA-256 of the bytes of the file. */
  sha256: string;
}

/** The number of a row in the file, from 1. */
export type RowNumber = number;

/** Half-planes whose borders pass through a vertex, or are a side of the set. */
export interface RowNumberList {
  /** The first 1,000 of these half-planes. */
  active: RowNumber[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing. */
export interface RowNumberRegion {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The vertices, counter-clockwise from the lexicographically smallest. */
  vertices: ExactRowNumberVertex[];
  /** Directions in which the set goes on without end, as coprime integers. */
  rays: [Exact, Exact][];
  /** Directions in which the set goes on without end both ways, as coprime integers. */
  lines: [Exact, Exact][];
  /** The half-planes behind each side of a set without vertices; otherwise empty. */
  boundaries: RowNumberList[];
  /** A point of the set, exact; null for the empty set. */
  witness: [Exact, Exact] | null;
  /** The area, rounded to nearest; null for an empty and for an infinite set. */
  area: Exact | null;
  /** The proof that the set is empty; null for other sets and where `farkas` of the answer has it. */
  certificate: Certificate | null;
}

/** A polygon. */
export interface Approximation {
  /** The vertices, exact. */
  vertices: [Exact, Exact][];
  /** The area; null where it is infinite. */
  area: Exact | null;
}

/** The data of the answers. */
export interface CheckInput {
  /** The file as it was named; null for standard input. */
  file: string | null;
  /** The format of the table as it was read; null for files that are neither text nor a sheet nor JSON. */
  table: Table | null;
  /** The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise. */
  epsilon_from_least?: FromLeast;
}

/** The answers of one source. */
export interface Claim {
  /** The name of the solver or file. */
  source: string;
  /** The data that the answers are judged against. */
  reading: "decimal" | "binary64";
  /** The four ends, judged. */
  bounds: ClaimedEnd[];
  /** The worst verdict. */
  verdict: "exact" | "rounded" | "within tolerance" | "no answer" | "loose" | "infeasible point" | "unsafe" | "wrong status" | "inverted interval";
}

/** A claimed end of a parameter's interval, judged. */
export interface ClaimedEnd {
  /** The parameter. */
  target: "theta1" | "theta2";
  /** The end. */
  end: "lower" | "upper";
  /** The claimed end; null where none is claimed. */
  claimed: Exact | null;
  /** The verdict. */
  verdict: "exact" | "rounded" | "within tolerance" | "no answer" | "loose" | "infeasible point" | "unsafe" | "wrong status" | "inverted interval";
  /** The rounding that explains the claim; null unless the verdict is `rounded`. */
  rounded_to: RoundedTo | null;
  /** The true end, rounded outward; null where there is none. */
  exact: Exact | null;
  /** The distance of the claim outside the true interval, exact; negative inside. */
  excess: Exact | null;
  /** The excess in units in the last place of a double at the true end. */
  excess_in_ulps: Exact | null;
  /** The excess in `unit`; without its sign it is the smallest tolerance that excuses the claim. */
  excess_in_units: Exact | null;
  /** The unit: the `width` of the true interval; where that is 0 or infinite the `value` of the end, else `eps`. */
  unit: "width" | "value" | "eps" | null;
  /** The smallest τ with the claimed point in FPS(ε + τ), rounded up; null without a point. */
  tau: Exact | null;
  /** τ in units of ε, rounded up; null without a point. */
  tau_in_epsilon: Exact | null;
  /** The row of the half-plane that the claimed point violates most; null for a condition and without a violation. */
  row: number | null;
  /** The bound of that half-plane; null without a violation. */
  bound: string | null;
  /** The amount by which the point violates it, exact; null without a violation. */
  violation: Exact | null;
  /** A feasible point that an unsafe end cuts off, exact; null for other verdicts. */
  witness: [Exact, Exact] | null;
  /** The proof of a wrong status; null for other verdicts. */
  proof: Evidence | null;
  /** True if the rows with the largest duals prove the true end; null without duals, or with another number of them than rows. */
  repairable: boolean | null;
  /** The reason why there is no answer, or which duals are ignored and why; null otherwise. */
  reason: string | null;
}

/** Approximations of the set by linear programs in many directions. */
export interface Directions {
  /** The number of directions. */
  count: number;
  /** True if directions are even after both parameters are scaled by their intervals. */
  scaled: boolean;
  /** The number of directions without an optimum. */
  unbounded: number;
  /** The hull of the optimal points; null where there are none. */
  inner: Approximation | null;
  /** The set itself. */
  exact: Approximation;
  /** The intersection of the half-planes of all optima; null where there are none. */
  outer: Approximation | null;
}

/** The proof of a wrong status. */
export interface Evidence {
  /** The fact about the program that it shows. */
  shows: "infeasible" | "bounded" | "feasible" | "unbounded";
  /** Rows with multipliers; empty for `feasible` and `unbounded`. */
  rows: Term[];
  /** A feasible point, exact; null for `infeasible` and `bounded`. */
  theta: [Exact, Exact] | null;
  /** A direction without end; null unless it shows `unbounded`. */
  ray: [Exact, Exact] | null;
}

/** The readings of the programs. */
export interface Readings {
  /** The number of readings with rows in the programs; the others cannot bound anything. */
  asked: number;
  /** The number of readings that are fitted. */
  fitted: number;
}

/** The rounding that explains a claim. */
export interface RoundedTo {
  /** The target: doubles, or decimal digits. */
  kind: "binary64" | "digits";
  /** The number of significant digits; null for doubles. */
  digits: number | null;
}

/** The worst verdict against one reading of the data. */
export interface Worst {
  /** The verdict. */
  verdict: "exact" | "rounded" | "within tolerance" | "no answer" | "loose" | "infeasible point" | "unsafe" | "wrong status" | "inverted interval";
  /** The reading of numbers. */
  reading: "decimal" | "binary64";
  /** True if the verdict is a refutation. */
  refuted: boolean;
}

/** A vertex of a set. */
export interface ExactSideVertex {
  /** θ1 and θ2, exact. */
  theta: [Exact, Exact];
  /** The first 1,000 of these half-planes. */
  active: Side[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** The optimal points: the hull of the vertices, plus multiples of the rays that are not negative and any of the lines. All exact. */
export interface Face {
  /** The vertices. */
  vertices: Exact[][];
  /** A point on each line that bounds the face, where there is no vertex. */
  points: Exact[][];
  /** Directions without end. */
  rays: Exact[][];
  /** Directions without end both ways. */
  lines: Exact[][];
}

/** The verdict on an aspect of a solution; what does not apply is null. */
export interface Finding {
  /** The aspect. */
  aspect: "status" | "objective" | "primal" | "optimality" | "dual" | "complementary-slackness" | "duality-gap" | "ray" | "farkas";
  /** The verdict. */
  verdict: "exact" | "rounded" | "within tolerance" | "no answer" | "refuted";
  /** The line of the file. */
  line: number;
  /** The largest error, rounded up. */
  error: Exact | null;
  /** The error in units of its measure, rounded up. */
  relative: Exact | null;
  /** The row with the largest error. */
  row: string | null;
  /** The column with the largest error. */
  column: string | null;
  /** The bound with the largest error. */
  bound: "lower" | "upper" | null;
  /** The number that the file states. */
  claimed: Exact | null;
  /** The true number; at a bound its value. */
  exact: Exact | null;
  /** The tolerances that would excuse the error. */
  tolerance: Tolerance | null;
  /** The verdict as a sentence. */
  message: string;
}

/** A linear program in a file. */
export interface Model {
  /** The file as it was named; null for standard input. */
  file: string | null;
  /** SHA-256 of the bytes of the file. */
  sha256: string;
  /** The name of the model. */
  name: string;
  /** The sense: the objective is minimised or maximised. */
  sense: "min" | "max";
  /** The name of the objective. */
  objective: string;
  /** The constant of the objective. */
  constant: Exact;
}

/** A column of the model. */
export interface ModelColumn {
  /** The name. */
  name: string;
  /** The lower bound; null where there is none. */
  lower: Exact | null;
  /** The upper bound; null where there is none. */
  upper: Exact | null;
  /** The coefficient of the objective. */
  cost: Exact;
  /** The value at the first optimal point, exact; null unless optimal. */
  value: Exact | null;
  /** The reduced cost, exact; null unless optimal. */
  reduced_cost: Exact | null;
  /** The place in the basis; null unless optimal. */
  basis: "basic" | "lower" | "upper" | "free" | null;
}

/** A row of the model. */
export interface ModelRow {
  /** The name. */
  name: string;
  /** The lower bound; null where there is none. */
  lower: Exact | null;
  /** The upper bound; null where there is none. */
  upper: Exact | null;
  /** The value at the first optimal point, exact; null unless optimal. */
  value: Exact | null;
  /** The dual price, exact; null unless optimal. */
  dual: Exact | null;
  /** The place in the basis; null unless optimal. */
  basis: "basic" | "lower" | "upper" | "free" | null;
}

/** The feasible set in the plane of the columns that bounds do not fix. With fewer than two columns the missing coordinates are 0. */
export interface Plane {
  /** The names of these columns, at most two. */
  columns: string[];
  /** The set. */
  region: SideRegion;
  /** The range of each column, rounded outward; null for an empty set. */
  ranges: ExactRange[] | null;
}

/** A bound of a row or of a column. */
export interface Side {
  /** The name of the row; null for a column. */
  row: string | null;
  /** The name of the column; null for a row. */
  column: string | null;
  /** The bound: `lower` as it stands, `upper` negated. */
  side: "lower" | "upper";
}

/** Half-planes whose borders pass through a vertex, or are a side of the set. */
export interface SideList {
  /** The first 1,000 of these half-planes. */
  active: Side[];
  /** The number of half-planes beyond those listed; absent if there are none. */
  active_more?: number;
}

/** A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing. */
export interface SideRegion {
  /** The kind of the set. */
  kind: "empty" | "point" | "segment" | "ray" | "line" | "polygon" | "unbounded-polygon" | "strip" | "half-plane" | "plane";
  /** The vertices, counter-clockwise from the lexicographically smallest. */
  vertices: ExactSideVertex[];
  /** Directions in which the set goes on without end, as coprime integers. */
  rays: [Exact, Exact][];
  /** Directions in which the set goes on without end both ways, as coprime integers. */
  lines: [Exact, Exact][];
  /** The half-planes behind each side of a set without vertices; otherwise empty. */
  boundaries: SideList[];
  /** A point of the set, exact; null for the empty set. */
  witness: [Exact, Exact] | null;
  /** The area, rounded to nearest; null for an empty and for an infinite set. */
  area: Exact | null;
  /** The proof that the set is empty; null for other sets and where `farkas` of the answer has it. */
  certificate: Certificate | null;
}

/** A bound times a multiplier. */
export interface SideTerm {
  /** The name of the row; null for a column. */
  row: string | null;
  /** The name of the column; null for a row. */
  column: string | null;
  /** The bound: `lower` as it stands, `upper` negated. */
  side: "lower" | "upper";
  /** The multiplier, exact and greater than 0. */
  multiplier: Exact;
}

/** The verdict on a solution file. */
export interface Solution {
  /** The file as it was named. */
  file: string;
  /** The program whose format the file has. */
  writer: string;
  /** The status that the file states: `optimal`, `infeasible`, `unbounded`, `infeasible-or-unbounded` or other words of the solver. */
  status: string;
  /** The worst verdict. */
  verdict: "exact" | "rounded" | "within tolerance" | "no answer" | "refuted";
  /** The verdict on each aspect. */
  findings: Finding[];
  /** The part of the file that is not judged, and why; null where every part is. */
  not_judged: string | null;
}

/** The smallest tolerances that excuse an error, rounded up. */
export interface Tolerance {
  /** The tolerance in the units of the rows and bounds as the file has them. */
  absolute: Exact;
  /** The tolerance in units of the larger of 1, the value and the bound. */
  relative: Exact;
  /** The tolerance in the units of each row after a division by its largest coefficient. */
  scaled: Exact;
}

/** The question of a proof. */
export interface About {
  /** First and last number of each range of rows. */
  rows: [number, number][];
  /** The number of rows of the data; null where they were not read to the end. */
  rows_total: number | null;
  /** The reading of numbers: exactly as written, or as the nearest doubles. */
  reading: "decimal" | "binary64";
  /** True if the first row names the columns. */
  header: boolean;
  /** The character between cells. */
  delimiter: string;
  /** The first regressor, x of a line. */
  phi1: ColumnTimes;
  /** The second regressor, 1 of a line. */
  phi2: ColumnTimes;
  /** The reading. */
  y: ColumnTimes;
  /** The error bound. */
  epsilon: ColumnTimes;
  /** The number that is taken from the column of `phi1` first. */
  x_origin: Exact;
  /** The bound on the error of `phi1`; null where x is exact. */
  x_error: ColumnTimes | null;
  /** The columns that are added to y. */
  response: ColumnTimes[];
  /** The columns of bounds that take the place of y and ε; null where there are none. */
  interval: BoundColumnRange | null;
  /** The terms that are added to ε above and below y; null without a law. */
  law: Law | null;
  /** The conditions as text. */
  conditions: string[];
}

/** A column of bounds. */
export interface BoundColumn {
  /** The number of the column, from 1. */
  column: number;
  /** The name of the column in the header; null without one. */
  name: string | null;
}

/** The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds. */
export interface BoundColumnRange {
  /** The lower end; a number is rounded down. Null where nothing bounds from below. */
  lower: BoundColumn | null;
  /** The upper end; a number is rounded up. Null where nothing bounds from above. */
  upper: BoundColumn | null;
}

/** A column times a number. */
export interface ColumnTimes {
  /** The number of the column, from 1; column 0 holds 1 in every row. */
  column: number;
  /** The name of the column in the header; null without one. */
  name: string | null;
  /** The exact number by which the column is multiplied. */
  times: Exact;
}

/** A law of the error bound. */
export interface Law {
  /** The terms above y. */
  above: LawTerm[];
  /** The terms below y. */
  below: LawTerm[];
}

/** A term of a law. */
export interface LawTerm {
  /** The quantity of the number in the column: itself, without its sign, or half a unit of its last written digit. */
  quantity: "number" | "abs" | "written";
  /** The number of the column, from 1; column 0 holds 1 in every row. */
  column: number;
  /** The exact number by which the quantity is multiplied. */
  times: Exact;
}

/** A statement that is proved, and its scope. */
export interface Proved {
  /** The kind of the statement. */
  kind: "form" | "point" | "empty" | "least" | "set" | "left out" | "another";
  /** First and last number of each range of rows in the scope; null for all rows. */
  rows: [number, number][] | null;
  /** The rows that are left out. */
  without: number[];
  /** The numbers of the conditions in the scope, from 1; null for all conditions. */
  where: number[] | null;
  /** The factor on the error bounds; null where they are as asked. */
  factor: Exact | null;
  /** The bound that takes the place of the error bounds; null where they are as asked. */
  epsilon: Exact | null;
  /** The part of the set, with errors in x; null otherwise. */
  side: "+" | "-" | "strong" | null;
  /** The coefficients of the form; only for `form`. */
  form?: [Exact, Exact];
  /** The range of the form, rounded outward; only for `form`. */
  range?: ExactRange;
  /** The point, exact; only for `point`. */
  point?: [Exact, Exact];
  /** The extent of the set; only for `set`. */
  extent?: "empty" | "bounded" | "unbounded";
  /** The number of vertices; only for `set`. */
  vertices?: number;
  /** The number of sides; only for `set`. */
  sides?: number;
  /** The number of rows to leave out at least; only for `left out`. */
  least?: number;
  /** The sets of so many rows; only for `left out`, and absent where they are not stated. */
  sets?: number[][];
}

/** The proved facts about the feasible set. */
export interface ProvedSet {
  /** The extent of the set. */
  extent: "empty" | "bounded" | "unbounded";
  /** The number of vertices. */
  vertices: number;
  /** The number of sides. */
  sides: number;
  /** The ranges of both parameters, rounded outward; null for an empty set. */
  ranges: [ExactRange, ExactRange] | null;
}

/** A statement about the set of its scope. */
export type Statement = {
  /** The kind of the statement. */
  kind: "form" | "point" | "empty" | "least" | "set" | "left out";
  /** First and last row of each range, one after the other. */
  rows?: number[];
  /** The rows that are left out. */
  without?: number[];
  /** The numbers of the conditions that hold, from 1. */
  where?: number[];
  /** The factor on the error bounds. */
  factor?: string;
  /** The bound that takes the place of the error bounds. */
  epsilon?: string;
  /** The part of the set, with errors in x. */
  side?: "+" | "-" | "strong";
} & ({
  /** The coefficients of the form. */
  form: [string, string];
  /** The lower end. */
  lower: [[string, string][], [string, string], [string, string]];
  /** The upper end. */
  upper: [[string, string][], [string, string], [string, string]];
} | {
  /** A point that they leave. */
  point: [string, string];
  /** The terms that prove that smaller errors leave nothing. */
  multipliers: [string, string][];
} | {
  /** A point of the set. */
  point: [string, string];
  /** The vertices. */
  vertices: [string, string][];
  /** The sides by angle, each with the index of the vertex where it meets the next one; null where it does not. */
  sides: [string, number | null][];
} | {
  /** The point. */
  point: [string, string];
} | {
  /** The terms that prove it. */
  multipliers: [string, string][];
} | {
  /** The number of rows. */
  least: number;
  /** All sets of so many rows without which something is left; absent where they are not stated. */
  sets?: number[][];
  /** Sets of rows that are left out, each with terms that prove that the rest contradicts itself. */
  contradictions: [number[], [string, string][]][];
});
