// The document that the engine hands to the page, schema `boundfit/lesson/3`, made by `crates/lesson/src/data.rs`.
// Half-planes a·θ ≤ b, readings and points of the parameter plane are referred to by their index in the lists
// `half_planes`, `readings` and `points`. Half-planes come reading by reading, the upper bound before the lower one where there
// are both; those of the conditions follow.

/** An exact number: "p/q" in lowest terms, or "n". */
type Exact = string;

/** A number with the decimal that reports have for it: ends of intervals outward, error bounds up, else to nearest. */
interface NumberData {
  exact: Exact;
  decimal: string;
}

/** A sum over the whole set: its fraction may be too long to be written, its decimal is there always. */
interface MeasureData {
  exact: Exact | null;
  decimal: string;
}

/** A part of a document as a person gets it: numbers are without their doubles, and have fractions unless they are measures. */
type Shown<T> = T extends import("../../engine/answers.d.mts").Exact
  ? NumberData
  : T extends object
    ? { [K in keyof T]: Shown<T[K]> }
    : T;

/** constant + slope·s, or constant + slope·s + quadratic·s², where s multiplies every error bound. */
interface PolynomialData {
  constant: Exact;
  slope: Exact;
  quadratic?: Exact;
}

/** An area between two breakpoints: coefficients that are too long to be written are null. */
interface AreaPolynomialData {
  constant: Exact | null;
  slope: Exact | null;
  quadratic: Exact | null;
}

/** The name of a half-plane. */
type BoundName = import("../../engine/answers.d.mts").Active;

type Kind = import("../../engine/answers.d.mts").FeasibleSet["kind"];

/** A region whose vertices are points and whose boundaries are half-planes, both by index. */
interface RegionData {
  kind: Kind;
  vertices: number[];
  rays: Exact[][];
  lines: Exact[][];
  boundaries: number[];
}

/** How a text or a sheet was read. */
type TableData = import("../../engine/answers.d.mts").Table;

/** The document of `fit`; sums over the whole set may lack their fractions. */
type FitData = Shown<Omit<import("../../engine/answers.d.mts").FitDocument, "fps" | "area_centroid" | "tightness">> & {
  fps: Shown<Omit<import("../../engine/answers.d.mts").ActiveRegion, "area">> & { area: MeasureData | null };
  area_centroid: MeasureData[] | null;
  tightness: MeasureData | null;
};

interface ReadingData {
  row: number;
  phi: NumberData[];
  y: NumberData;
  /** The cells of the table as they are written, where that is known: regressors, y, and bounds where they are columns. */
  cells?: string[];
}

/** A reading with bounds about their middle (y, if that is left out) that grow with the factor, or with fixed ones. */
interface FittedReadingData extends ReadingData {
  epsilon?: NumberData;
  middle?: NumberData;
  lower?: NumberData;
  upper?: NumberData;
}

interface HalfPlaneData {
  name: BoundName;
  a: Exact[];
  b: Exact;
  irredundant: boolean;
}

/** The k-th line holds up to the k-th breakpoint of x; null: from or to infinity. */
interface EnvelopeData {
  from: Exact | null;
  to: Exact | null;
  nowhere: boolean;
  lines: number[];
  breakpoints: Exact[];
}

interface RedundancyData {
  why: string;
  by: { half_plane: number; multiplier: NumberData }[];
  slack: NumberData | null;
}

/** What adding one half-plane did; `born` and `lost` are points. */
interface StepData extends RegionData {
  half_plane: number;
  born: number[];
  lost: number[];
  redundant: RedundancyData | null;
}

/** Clipping by all half-planes in one order. */
interface OrderData {
  id: string;
  name: MessageData;
  note: MessageData;
  steps: StepData[];
}

/** The set at a factor where half-planes enter or leave; vertices are indices of the sweep's own. */
type BreakpointData = Shown<Omit<import("../../engine/answers.d.mts").Breakpoint, "area" | "vertices">> & {
  area: MeasureData | null;
  vertices: number[];
};

/** The set between two breakpoints; vertices are indices of the sweep's own. */
type PieceData = Shown<Omit<import("../../engine/answers.d.mts").Piece, "area" | "vertices">> & {
  area: AreaPolynomialData | null;
  vertices: number[];
};

/** The sets under error bounds multiplied by s; `least` is the smallest s that leaves a feasible parameter. */
interface SweepData {
  least: NumberData | null;
  /** Both parameters of each vertex of these sets, as functions of s. */
  vertices: PolynomialData[][];
  breakpoints: BreakpointData[];
  pieces: PieceData[];
}

/** What an LP solver answered, and what the referee says of it. */
interface ClaimData {
  parameter: string;
  end: string;
  verdict: string;
  claimed: NumberData | null;
  point: NumberData[] | null;
  reason: MessageData | null;
}

/** The set without one reading. */
interface WithoutData extends RegionData {
  row: number;
  matters: boolean;
  moved: { parameter: string; end: string; by: NumberData | null }[];
}

/** A text of the table in the page by its key, with what stands in its places. */
interface MessageData {
  text: string;
  values?: TextValues;
}

type ShowData = { kind: "vertex"; index: number } | { kind: "row"; row: number } | { kind: "layer"; layer: string };

interface QuestionData {
  id: string;
  question: MessageData;
  answer: MessageData;
  show: ShowData | null;
}

/**
 * What was asked: the options of docs/wasm.md with which the engine makes this document again from the page's readings as a table
 * (`tableOf` of model/table.js).
 */
interface AskedData {
  file: string;
  title?: string;
  x_unit?: string;
  y_unit?: string;
  x: string | string[];
  /** Absent where readings have but bounds. */
  y?: string;
  eps?: string;
  eps_column?: string;
  lower?: string;
  upper?: string;
  where?: string[];
  through_origin?: true;
  x_origin?: Exact;
  reading: "decimal" | "binary64";
  max_readings?: number;
  header: "yes";
  delimiter: "comma" | "semicolon";
  decimal: DecimalMark;
  comment: "none";
  /** First and last of the numbers of all rows of the table that follow each other without a gap. */
  row_numbers: number[][];
  /** Likewise of those that are fitted. */
  rows: number[][];
}

interface LessonData {
  schema: "boundfit/lesson/3";
  title: string;
  /** Whether the title was made of the file and the columns. */
  is_default_title: boolean;
  file: string;
  asked: AskedData;
  /** The names of the columns of that table. */
  columns: string[];
  units: { x: string | null; y: string | null; theta1: string | null; theta2: string | null };
  model:
    | { kind: "line"; x: string; y: string }
    | { kind: "two-regressors"; regressors: string[]; y: string };
  /** One error bound for all readings, or the column that has one for each. */
  /** Both are null where readings have bounds of their own. */
  epsilon: { uniform: NumberData; column: null } | { uniform: null; column: string | null };
  readings: FittedReadingData[];
  /** Readings of the file that are not fitted. */
  others: ReadingData[];
  conditions: { number: number; text: string }[];
  half_planes: HalfPlaneData[];
  points: NumberData[][];
  fit: FitData;
  corridor: { upper: EnvelopeData; lower: EnvelopeData } | null;
  orders: OrderData[];
  sweep: SweepData | null;
  layers: {
    directions: { count: number; inner: number[] | null; outer: number[] | null };
    lp: { source: string; claims: ClaimData[] }[];
  };
  leave_one_out: WithoutData[];
  /** The fewest readings without which some parameters are left, one list of rows for each way; null where all agree or it is not known. */
  outliers: { least: number; ways: number[][]; complete: boolean } | null;
  questions: QuestionData[];
}
