// What the script makes of the document. These names are known in every module; they vanish before a browser sees them.

type Rational = import("./model/rational.js").Rational;
type ParameterFrame = import("./planes/view.js").ParameterFrame;

/** Two exact coordinates: a parameter θ, a regressor φ, a direction. */
type Pair = Rational[];

/** Two numbers: coordinates in a frame, or pixels. */
type Place = number[];

/** The engine in the page. */
interface Engine {
  /**
   * The answer, as JSON or as the text that the options ask for; an Error in the words of the program where table or options are
   * wrong. `options` are those of docs/wasm.md.
   */
  ask(what: "columns" | "lesson" | "polytope" | "run", table: string | Uint8Array, options: object): Promise<string>;
  /** Starts it where it is not, so that the first question of a reader is not the slow one. */
  wake(): void;
}

interface Reading {
  index: number;
  row: number;
  phi: Pair;
  y: Rational;
  /** Between the bounds; y where these come from it. */
  middle: Rational;
  /** Half the distance of the bounds; 0 for bounds that do not grow with the others. */
  epsilon: Rational;
  /** The bounds that do not grow; null for those that do. */
  fixed: { upper: Rational | null; lower: Rational | null } | null;
  /** Indices of the half-planes. */
  halfPlanes: { upper: number | null; lower: number | null };
}

/** A reading that is not fitted. */
type OtherReading = Pick<Reading, "row" | "phi" | "y">;

/** a·θ ≤ b; `reading` is null for a condition. */
interface HalfPlane {
  index: number;
  name: BoundName;
  irredundant: boolean;
  a: Pair;
  b: Rational;
  reading: Reading | null;
}

/** A half-plane in frame coordinates, with |a| = 1. */
interface Line {
  a: Place;
  b: number;
}

interface Vertex {
  theta: Pair;
  /** Found when first asked for if the document does not say. */
  active: BoundName[] | null;
}

/** What the document says of a region, in any of its forms. */
interface RegionSource {
  kind: Kind;
  vertices: (number | { theta: NumberData[]; active: BoundName[] })[];
  rays: (Exact | NumberData)[][];
  lines: (Exact | NumberData)[][];
  boundaries: (number | { active: BoundName[] })[];
}

/** A region in one form, whichever part of the document it comes from. */
interface Region {
  kind: Kind;
  vertices: Vertex[];
  rays: Pair[];
  lines: Pair[];
  /** The factor on the error bounds. */
  s: Rational;
  /** Half-planes, one for each whole line that bounds a region without vertices. */
  boundaries: number[];
  /** The rows that are switched off, ascending. */
  without: number[];
  /** The half-planes added so far; null: all of them. */
  among: number[] | null;
}

/** A stop of the ε slider: a breakpoint, or within a piece. */
interface Stop {
  s: Rational;
  breakpoint: number | null;
  piece: number | null;
}

interface Lesson {
  data: LessonData;
  readings: Reading[];
  others: OtherReading[];
  isLine: boolean;
  halfPlanes: HalfPlane[];
  points: Pair[];
  /** The index of the reading of a row. */
  rowIndex: Map<number, number>;
  /** How far the readings lie apart in each column. */
  widths: { phi: Rational[]; y: Rational };
  fps: Region;
  /** Whether leaving out the reading of a row changes the set. */
  matters: Map<number, boolean>;
  leastSquares: Pair | null;
  /** The line that heights can be shown relative to. */
  reference: { theta: Pair; name: string } | null;
  /** The one error bound of all readings; null when each has its own, or when there is no error at all. */
  epsilon: Rational | null;
  stops: Stop[];
}

/** Ends of an interval; null: infinite. */
interface Ends {
  lower: Rational | null;
  upper: Rational | null;
}

/** The part of a frame that is shown. */
interface View {
  x: number[];
  y: number[];
}

/** A drawing area in pixels. */
interface Area {
  left: number;
  top: number;
  width: number;
  height: number;
}

interface Size {
  width: number;
  height: number;
}

/** From frame coordinates to pixels and back. */
interface ScreenMap {
  area: Area;
  view: View;
  to: (place: Place) => Place;
  from: (pixel: Place) => Place;
}

/** A line v = slope·u + start in frame coordinates. */
interface Height {
  slope: number;
  start: number;
}

/** The frame of the data plane: exact origins and units; in the residual view heights are relative to a line. */
interface DataFrame {
  isLine: boolean;
  exact: (axis: number, number: number) => Rational;
  number: (axis: number, value: Rational) => number;
  across: (reading: Reading) => number;
  height: (phi: Pair, value: Rational) => number;
  /** The value of which `height` gives this number. */
  measured: (phi: Pair, number: number) => Rational;
  length: (epsilon: Rational) => number;
  /** The line of θ. */
  line: (theta: Pair) => Height;
  prediction: (reading: Reading, theta: Pair) => number;
  direction: (ray: Pair) => Height;
}

/** Ticks along an axis, and what to write beside it. */
interface AxisMarks {
  marks: { at: number; label: string }[];
  note: string;
}

/** A corner of a polygon; `cut` when the edge to the next one is not one of the polygon's own. */
interface Corner {
  point: Place;
  cut: boolean;
}

type Mode = "explore" | "clip" | "epsilon" | "leave-one-out" | "worst-line";

type WorstName = "steepest" | "shallowest";

/** The heights of the lines by hand at the least and the greatest x of the readings. */
type HandLines = Record<WorstName, Rational[]>;

interface VertexChoice {
  kind: "vertex";
  index: number;
  /** The half-planes active there. */
  active?: Set<number>;
}

interface ReadingChoice {
  kind: "reading";
  row: number;
}

interface PointChoice {
  kind: "point";
  theta: Pair;
  /** The half-plane whose boundary is near. */
  near?: number;
  /** The rows of the readings that the point violates. */
  violated?: Set<number>;
}

/** What the reader has chosen or points at. */
type Choice = VertexChoice | ReadingChoice | PointChoice;

/** What the page shows. */
interface State {
  mode: Mode;
  /** The order of clipping, by index. */
  order: number;
  /** How many half-planes have been added. */
  step: number;
  /** The stop of the ε slider, by index. */
  stop: number;
  /** The rows that are switched off, ascending. */
  without: number[];
  selection: Choice | null;
  /** What the pointer or the focus is on; it wins over the selection. */
  hover: Choice | null;
  /** The ids of the layers shown. */
  layers: Set<string>;
  /** The worst lines as they were laid by hand; null: from corner to corner. */
  hand: HandLines | null;
  /** Whether the exact worst lines are shown beside them. */
  exactLines: boolean;
  /** Whether heights are relative to the reference line. */
  residual: boolean;
  /** Whether the second axis shows the height at the middle x. */
  straighten: boolean;
  /** The part of the parameter plane that is shown; null: chosen to fit. */
  parameterView: View | null;
  dataView: View | null;
  /** Whether the steps run by themselves. */
  playing: boolean;
  /** The code of the language that the page speaks. */
  language: string;
}

type Listener = (state: State, before: State) => void;

interface Store {
  /** The lesson shown. Keep none: the next change may be another lesson. */
  lesson: () => Lesson;
  /** Shows another lesson, with as much of the state as means the same there. */
  replace: (lesson: Lesson) => void;
  get: () => State;
  subscribe: (listener: Listener) => void;
  change: (changes: Partial<State>) => void;
}

interface SceneLine {
  halfPlane: HalfPlane;
  line: Line;
}

/** What a state amounts to. */
interface Scene {
  frame: ParameterFrame;
  region: Region;
  /** The region that the one shown is compared with. */
  before: Region | null;
  /** The step of clipping that led here. */
  current: StepData | null;
  s: Rational;
  bounds: Ends[] | null;
  lines: SceneLine[];
  /** The half-planes without which the region would be another one. */
  shaping: Set<number>;
  among: Set<number> | null;
  summary: string;
  /** The vertices in frame coordinates. */
  places: Place[];
}

/** What is drawn at the moment, for what the pointer does. */
interface Drawn {
  lesson: Lesson;
  layers: Layer[];
  scene: Scene;
  dataMap: ScreenMap;
  parameterMap: ScreenMap;
  state?: State;
}

/** The vertex and the reading that the Tab key reaches. */
interface Roving {
  vertex: number;
  reading: number;
}

/** Something that can be drawn over the set; `why` says why it cannot be shown. */
interface Layer {
  id: string;
  name: string;
  note: string;
  shape: Shape | null;
  polygon: Pair[] | null;
  points: Pair[];
  why: string | null;
}

type Shape = "cross" | "plus" | "diamond" | "triangle" | "square" | "ring" | "upper-end" | "lower-end";

type Attributes = Record<string, unknown>;

/** An element as it should be. */
interface Description {
  tag: string;
  attributes: Attributes;
  children: (Description | string)[];
}

type Content = Description | string | number | null | undefined | false | Content[];

/** A value in a text of the table: `number` has the decimal mark of the language, `list` is an enumeration, `text` another text. */
type TextValue =
  | string
  | number
  | Description
  | (Description | string)[]
  | { text: string; values?: TextValues }
  | { number: string }
  | { formula: string }
  | { list: TextValue[]; by?: string; more?: number };

type TextValues = Record<string, TextValue>;

/** A place for a value: how it is written, and the forms that a count chooses from. */
interface TextPlace {
  name: string;
  written: string[];
  forms: TextPart[][];
}

/** A piece of a text: words, a place for a value, or mark-up. */
type TextPart = string | TextPlace | { tag: string; attributes: Attributes; parts: TextPart[] };

/** An element of the page by its id: whichever kind it is, these are the properties that the script uses. */
type PageElement = HTMLInputElement;

type Given = import("../../engine/request.d.mts").Given;

/** The request of the page: a fit, of readings that are named, without rows that it names by first and last. */
type FitRequest = Omit<Extract<import("../../engine/request.d.mts").Request, { ask: "fit" }>, "x" | "without"> & {
  x: import("../../engine/request.d.mts").Regressors;
  without?: [number, number][];
};

/** The key of a request that names a column. */
type Role = "x" | "y" | "eps_column" | "lower" | "upper";

/** What an address says: a request for the engine to judge, the readings as text unless they are the page's own, and the words of the page. */
interface Link {
  request: Record<string, any>;
  table: string | null;
  page: Record<string, string>;
}

interface SheetRow {
  cells: string[];
  isFitted: boolean;
}

/** Readings as text, and what is asked of them; never changed. */
interface Sheet {
  /** The names of the columns. */
  columns: string[];
  rows: SheetRow[];
  /** The request but for what follows from the cells: rows that are left out, and the dialect. */
  request: FitRequest;
  /** What the page says besides: the keys of a lesson in docs/wasm.md. */
  page: Record<string, any>;
}

/** What the engine refused, and where: a row with a column, a key of the question, or nothing of these. */
interface Problem {
  row: number | null;
  column: number | null;
  key: string | null;
  refusal: Refusal;
}

/** What the engine refused, as data: `wasm/src/refusal.rs` makes it. */
interface Refusal {
  /** The name of the problem; the page has words for those that it knows. */
  kind: string;
  /** What is wrong, in English, without what could be done elsewhere. */
  words: string;
  /** A part of the question. */
  key?: string;
  line?: number;
  column?: number;
  /** The name of the column. */
  name?: string;
  /** What stands there. */
  text?: string;
  /** The character in it, from 1. */
  position?: number;
  values?: TextValues;
}

type DecimalMark = "point" | "comma";

/** One reader's work on a sheet. */
interface Session {
  sheet: () => Sheet;
  /** The sheet whose lesson is shown. */
  right: () => Sheet;
  problem: () => Problem | null;
  isBusy: () => boolean;
  canUndo: () => boolean;
  canRedo: () => boolean;
  /** Takes another sheet; edits with the same key in a row are undone together. `about` says what was done. */
  edit: (sheet: Sheet, about: string, key?: string | null) => void;
  /** Ends a row of edits that are undone together. */
  settle: () => void;
  /** When the engine has answered all that it was asked. */
  settled: () => Promise<void>;
  undo: (about: string) => void;
  redo: (about: string) => void;
}

/** What can be done to readings in the picture; rows are numbers of readings. */
interface ReadingEdits {
  /** x is null where it stays; steps with the same key are undone together. */
  move: (row: number, x: Rational | null, y: Rational, key: string) => void;
  settle: () => void;
  remove: (row: number) => void;
  add: (x: Rational, y: Rational) => void;
}

/** A table whose columns are being chosen. */
interface Import {
  table: string | Uint8Array;
  /** The name of the file; null for a table that was pasted. */
  file: string | null;
  columns: string[];
  /** Whether the table has these names, and they were not made. */
  hasHeader: boolean;
  /** What the table was taken for, as far as that is known. */
  notes: TableData | null;
  /** The numbers of the columns, by what they are for. */
  choice: Record<string, string>;
  /** How it is written, as far as the reader has said it, with the keys of docs/wasm.md. */
  how: Record<string, any>;
  /** Whether rows with missing values are left out. */
  skip: boolean;
  problem: Refusal | null;
}

/** What the parts of the editor share. */
interface Workbench {
  engine: Engine;
  store: Store;
  current: () => Drawn;
  session: Session;
  /** The sheet that the page was made with. */
  own: Sheet;
  /** Whether it was made without readings. */
  isBlank: boolean;
  /** Whether the cells are shown. */
  isOpen: boolean;
  /** Whether the engine takes so long that it is worth saying. */
  isSlow: boolean;
  /** What is being typed, and where: it is not to be drawn over. */
  typing: { place: string, text: string } | null;
  pending: Import | null;
  /** What went wrong, said in the language that the page has when it is drawn. */
  notice: (() => string) | null;
  /** What the table that was taken in last was taken for. */
  taken: TableData | null;
  /** The address with the readings; null for readings that are too many for one. */
  link: string | null;
  /** The link that is being followed. */
  following: Promise<void> | null;
  /** The number of a reading that is to have the focus when it is there. */
  focusOn: number | null;
  draw: () => void;
}

/** The editor for the rest of the page, the console of the browser, and tests. */
interface Editor {
  /** Writes the readings into the address of the page. */
  address: () => Promise<void>;
  sheet: () => Sheet;
  problem: () => Problem | null;
  settled: () => Promise<void>;
  edit: (sheet: Sheet) => void;
  undo: () => void;
  csvOf: (sheet: Sheet) => string;
  /** The readings shown as delimited text, and the command that fits them. */
  csv: () => string;
  command: () => string | null;
  request: () => FitRequest;
}
