// What `run` of boundfit.mjs takes; made by `cargo xtask generate`.

/** A question about readings, about half-planes or about a linear program. `ask` names the question, which has keys of its own; the other keys say which readings, and how the answer is written. */
export type Request = {
  /** The column of x, or those of two regressors. */
  x?: Regressors;
  /** The column of y. */
  y?: string;
  /** The bound on every error: a number, a law, or a multiple of the least bound such as `1.2*min`. */
  eps?: Given;
  /** The column with the bound on each error. */
  eps_column?: string;
  /** The column with the least value that the model may have at each reading. */
  lower?: string;
  /** The column with the largest value that the model may have at each reading. */
  upper?: string;
  /** Conditions that the parameters are known to satisfy, such as `theta1 >= 0`. */
  where?: Given[];
  /** `true` for lines without offset. */
  through_origin?: boolean;
  /** The origin that x is counted from. */
  x_origin?: Given;
  /** The bound on the errors of x: a number, or else the column with the bound of each reading. */
  x_eps?: Given;
  /** The column with the bound on the error of each x. */
  x_eps_column?: string;
  /** `true` if a line must agree for every x that the errors of x allow. */
  strong?: boolean;
  /** These rows only. */
  rows?: Rows;
  /** All but these rows. */
  without?: Rows;
  /** Rows for which a comparison of a column holds, such as `temperature >= 20`. */
  where_row?: Given[];
  /** `decimal`, numbers exactly as written, or `binary64`, the nearest double. */
  reading?: string;
  /** Names of columns in the first row: `yes`, `no` or `auto`. */
  header?: string;
  /** The name of an encoding, or `auto`. */
  encoding?: string;
  /** The delimiter of columns: `comma`, `semicolon`, `tab`, `space`, `pipe` or `auto`. */
  delimiter?: string;
  /** The decimal mark: `point`, `comma` or `auto`. */
  decimal?: string;
  /** The character between groups of three digits. */
  thousands?: string;
  /** The character that starts a line of comment, `none` or `auto`. */
  comment?: string;
  /** The number of lines that are passed over first. */
  skip_lines?: number;
  /** `true` if the row after the header has units. */
  units_row?: boolean;
  /** Treatment of rows that lack a number: `refuse` or `skip`. */
  missing?: string;
  /** Cells that say that a value is missing. */
  missing_as?: string[];
  /** The block of a file with several: its number, the comment before it, or `all`. */
  block?: string;
  /** The sheet of a workbook. */
  sheet?: string;
  /** The most that an input may ask for of something, by the names of limits: `{"digits": 20000}`. */
  limits?: Record<string, number>;
  /** The name of the table in reports and messages. */
  file?: string;
  /** The number of each row of the table, ascending, unless they are 1, 2, 3: such as `[3, [7, 8], 20]`. Reports, `rows` and `without` use these numbers. */
  row_numbers?: OfRows[];
  /** The form of the answer, one of those that the question has: such as `json` or `text`. */
  format?: string;
  /** The number of significant digits of decimals. */
  digits?: number;
  /** The rounding of the ends of intervals in reports: `outward` or `nearest`. */
  rounding?: string;
  /** `true` shows numbers of reports as fractions. */
  exact?: boolean;
} & ({
  /** The question which ends of the intervals of both parameters are right, of those that solvers find and others claim. */
  ask: "check";
  /** The solvers to judge, by name. Without solvers, claims and directions these are all solvers that there are. */
  solver?: string[];
  /** The files of claims to judge: JSON, or solutions of the linear programs of the fit. */
  claim?: ClaimFile[];
  /** The claimed ends to judge: each text is `LO1,HI1,LO2,HI2`, where `-inf` and `inf` claim that there is no end. */
  claim_pui?: string[];
  /** The distance by which an end may be off, in widths of its interval, and a point outside, in units of ε; 1e-6 by default. */
  tolerance?: Given;
  /** `false` takes numbers in texts for exact; otherwise they are as precise as printed. */
  digits_as_printed?: boolean;
  /** `true` gives solvers the rows of all readings, also of those that cannot bound the set. */
  all_rows?: boolean;
  /** The number of directions in which optimal points are compared with the set, from 3 to 10000. */
  directions?: number;
  /** `true` spreads the directions evenly after the box of both intervals is scaled to a square. */
  scaled?: boolean;
  /** The seconds that a solver may spend on one program, from 1 to 86400; 60 by default. */
  time_limit?: number;
} | {
  /** Every parameter pair that agrees with all readings: the set, its intervals and estimates. */
  ask: "fit";
  /** `true` skips results that need further passes over more readings than are kept in memory. */
  no_eui?: boolean;
  /** The factors on the error bounds, `FROM..TO` such as `0.5..2`, for which the sets are found too. */
  sweep?: string;
  /** The confidence, such as `0.99`, of the statement about the share of further readings that lies in the band of ε_min. */
  confidence?: Given;
  /** `true` makes the report ten lines. */
  brief?: boolean;
  /** `true` makes the report complete: with the proof of each end, every estimate, and least squares in doubles. */
  full?: boolean;
  /** `true` adds the inverse line also where 0 is in the interval of θ1. */
  inverse?: boolean;
} | {
  /** The lines that agree with every reading where x has errors, too. */
  ask: "fit-x-errors";
} | {
  /** The fit of each group of rows with the same text in a column. */
  ask: "fleet";
  /** The column whose equal texts make a group. */
  by: string;
} | {
  /** The exact answer to a linear program with at most two free variables, in MPS or in the LP format of CPLEX, and the findings about solutions of it. */
  ask: "judge";
  /** The solutions to judge: files of HiGHS, GLPK, CBC, CLP, SCIP, CPLEX (XML), Gurobi or MIPLIB, or JSON. */
  solution?: ClaimFile[];
  /** The error that an answer may have on either side, relative to its size; 1e-6 by default. */
  tolerance?: Given;
  /** `false` takes numbers in texts for exact; otherwise they are as precise as printed. */
  digits_as_printed?: boolean;
} | {
  /** Independent, terminal, zero-based and least-squares linearity of readings y, or of those in two columns, up and down. The bounds on the errors have no say in it. */
  ask: "linearity";
  /** The column of readings while x was rising. */
  up?: string;
  /** The column of readings while x was falling. */
  down?: string;
  /** The column that says whether x was rising, beside y. */
  direction?: string;
  /** The full scale of percents; the span of y by default. */
  full_scale?: Given;
  /** The point that the line of zero-based linearity goes through; 0,0 unless it is said. */
  through?: Through;
} | {
  /** The question where the next reading of a line certainly makes the set smaller, and which x of a range makes its worst outcome best. */
  ask: "next";
  /** The range of x in which the reading is to be taken, the lower end first; that of the readings unless it is said. */
  within?: [Given, Given];
  /** The goal: `theta1` or `theta2`, the length of its interval, or `area`; all three unless it is said. */
  goal?: string;
  /** The error bound of the reading; that of the fitted ones unless it is said. */
  new_eps?: Given;
} | {
  /** The fewest readings to leave out so that some parameters agree with all others. */
  ask: "outliers";
  /** The number of missed readings up to which the answer shows the growth of the set. */
  most?: number;
  /** The number of sets of readings to leave out that are listed. */
  max_sets?: number;
  /** The limit on the crossings of bounds that the search looks at. */
  max_steps?: number;
} | {
  /** The set of half-planes, rows of `a1`, `a2` and `b` or an H-representation of cdd and lrs; or of the generators of a V-representation. */
  ask: "polygon";
} | {
  /** The question for the line at an x, for the place of a further reading there, and for the x that a reading may come from. */
  ask: "predict";
  /** The x in question: each text is numbers, `3.7,9/2`, or a column of a table, `FILE:COL`. Two regressors have pairs, `1;2,3;4`, or `FILE:COL;COL2`. */
  at?: string[];
  /** The readings whose possible x are asked for, as in `at`. */
  from?: string[];
  /** Values of x in equal steps, `FROM..TO/N` such as `0..10/5`, before those of `at`. */
  grid?: string;
  /** The error bound of a further reading, where it is not that of the fitted ones: a number, or a law. */
  new_eps?: string;
  /** `true` shows in reports the readings that prove each end. */
  proofs?: boolean;
} | {
  /** Every run of readings that some parameters agree with: the linear range. */
  ask: "range";
  /** The order in which readings are taken: `x`, those at the same x in order of rows, or `row`. Unless it is said, readings of a line are taken in order of x, and those of two regressors in order of rows. */
  by?: string;
} | {
  /** The status of every reading: what it says of the set of all readings, and of that of all others. */
  ask: "status";
  /** A table of further readings, in the same columns, which are judged by the set as it is. */
  new?: string;
  /** `true` finds the least total widening of the bounds under which some parameters meet all of them. */
  repair?: boolean;
  /** `true` lists every reading in reports. */
  all?: boolean;
} | {
  /** The fits of the last readings, again and again as the window moves on. */
  ask: "window";
  /** The number of readings in a window, in order of rows. */
  window?: number;
  /** The reach of a window back in x from its newest reading, in order of x. */
  window_x?: Given;
  /** The number of readings that a window moves on; 1 by default. */
  step?: number;
});

/** A file of claims, or of a solution. */
export interface ClaimFile {
  /** The name, which tells `check` the program that a solution answers: `theta1-min`, `theta1-max`, `theta2-min` or `theta2-max`. */
  file: string;
  /** The content. */
  text: string;
}

/** A number of a request. A text such as `"0.1"` is read as the table's texts are; `{"exact": "1/3"}` and an integer are exactly what they say. */
export type Given = string | { exact: string } | number;

/** One row, or some that follow each other. */
export type OfRows = number | [number, number | null];

/** The column of x, or those of two regressors, by header names or by numbers from 1, as text. */
export type Regressors = string | [string, string];

/** Data rows, counted from 1 without the header: `[5, [14, 36], [40, null]]` or `"5,14..36,40.."` is 5, 14 to 36, and 40 to the end. */
export type Rows = string | OfRows[];

/** A point: `"2.5,-1/3"`, or a list of both numbers. */
export type Through = string | [Given, Given];
