// The document that the engine makes of half-planes without readings, schema boundfit/polytope/1, and what the page makes of it.
// Every number is an exact fraction; half-planes are indices, vertices counter-clockwise.

interface PolytopeMultiplierData {
  half_plane: number;
  multiplier: Exact;
}

/** Why a half-plane changes nothing: always, same-as, dominated, empty-without; of a step: always, already-empty, dominated. */
interface PolytopeRedundancyData {
  why: string;
  /** Positive multiples of others that add up to it, with a right-hand side smaller by the slack. */
  by: PolytopeMultiplierData[];
  slack: Exact | null;
}

interface PolytopeHalfPlaneData {
  /** Of the text, from 1. */
  line: number;
  /** What it is called: counted over the lines that say something. */
  number: number;
  /** Of the two half-planes of an equation: upper (≤) or lower (≥). */
  side: "upper" | "lower" | null;
  text: string;
  a: Exact[];
  b: Exact;
  redundant: PolytopeRedundancyData | null;
}

interface PolytopeSetData {
  kind: Kind;
  /** The cone is the normal cone, counter-clockwise from the first generator to the second. */
  vertices: { theta: Exact[]; active: number[]; cone: { kind: "wedge" | "half-plane" | "plane"; generators: Exact[][] } }[];
  rays: Exact[][];
  lines: Exact[][];
  /** The half-planes that whole lines of the boundary belong to. */
  boundaries: number[][];
  /** Of an empty set: multiples of half-planes that add up to 0 ≤ sum, which is negative. */
  contradiction: { by: PolytopeMultiplierData[]; sum: Exact } | null;
  area: Exact | null;
}

interface PolytopeStepData {
  half_plane: number;
  set: PolytopeSetData;
  born: Exact[][];
  lost: Exact[][];
  redundant: PolytopeRedundancyData | null;
}

interface PolytopeFaceData {
  kind: "vertex" | "segment" | "ray" | "line" | "whole";
  points: Exact[][];
  direction: Exact[] | null;
}

type PolytopeObjectiveData = { form: Exact[] } & (
  | { outcome: "empty" }
  | { outcome: "unbounded"; point: Exact[]; ray: Exact[] }
  | {
      outcome: "bounded";
      value: Exact;
      proof: PolytopeMultiplierData[];
      face: PolytopeFaceData;
      /** All sets of at most two half-planes that prove the value, of which the first 12 are written. */
      ways: { count: number; unique: boolean; first: PolytopeMultiplierData[][] };
    }
);

interface PolytopeBasisData {
  half_planes: number[];
  vertex: number | null;
  theta: Exact[];
  value: Exact;
  multipliers: Exact[];
  pivot: {
    leaving: number;
    direction: Exact[];
    /** Null where nothing stops the way. */
    entering: number | null;
    length: Exact | null;
    degenerate: boolean;
  } | null;
}

interface PolytopeData {
  schema: "boundfit/polytope/1";
  /** Where lines cannot be read; then there is nothing else. */
  errors: { line: number; column: number; kind: string; message: string }[];
  half_planes: PolytopeHalfPlaneData[];
  steps: PolytopeStepData[];
  set: PolytopeSetData | null;
  objective: PolytopeObjectiveData | null;
  simplex: { start: number; outcome: "optimal" | "unbounded"; bases: PolytopeBasisData[] } | null;
}

/** A half-plane a·θ ≤ b by hand, or as the engine has it. */
interface PlainHalfPlane {
  a: Pair;
  b: Rational;
}

type PolytopeTab = "set" | "clip" | "objective" | "simplex" | "exercises";

/** What the view of half-planes shows. */
interface PolytopeState {
  /** One half-plane a line. */
  text: string;
  tab: PolytopeTab;
  objective: Pair;
  /** The vertex that the simplex method starts from; null: where the objective is least. */
  start: number | null;
  /** How many half-planes have been added. */
  step: number;
  /** How many pivots have been made. */
  pivot: number;
  /** The half-plane that is chosen, by index. */
  chosen: number | null;
  /** Whether touching the picture draws a line rather than scrolls the page. */
  drawing: boolean;
  /** The part of the plane that is shown; null: chosen to fit. */
  view: View | null;
  /** What the engine said last of lines that could all be read. */
  answer: PolytopeData | null;
  /** The text that the answer is about; null for the half-planes of an exercise. */
  answered: string | null;
  errors: PolytopeData["errors"];
  /** What the engine refused. */
  refused: (() => string) | null;
  seed: string;
  /** The exercise that is shown, by index. */
  exercise: number;
  /** For each exercise: what was typed, what is thought of it, and how much is told. */
  work: ExerciseWork[];
  language: string;
}

interface ExerciseWork {
  typed: string[];
  verdicts: Verdict[] | null;
  hints: number;
  explained: boolean;
}

interface PolytopeStore {
  get: () => PolytopeState;
  change: (changes: Partial<PolytopeState>) => void;
  subscribe: (listener: (state: PolytopeState, before: PolytopeState) => void) => void;
}

/** What is drawn, for what the pointer does. */
interface PolytopeDrawn {
  map: ScreenMap;
  /** Where the arrow of the objective starts, in pixels. */
  anchor: Place;
}

/** How far a set reaches in a direction. */
type Reach = { value: Rational; face: Pair[]; direction: Pair | null } | { ray: Pair } | null;

/** Numbers with their labels, or one of several words. */
type ExerciseAnswer =
  | { values: Rational[]; fields: TextValue[] }
  | { choice: string; choices: string[] };

interface Exercise {
  /** From 1 to 10, the harder the later. */
  number: number;
  id: string;
  halfPlanes: PlainHalfPlane[];
  objective: Pair | null;
  /** What the question, the hints and the explanation speak of. */
  values: TextValues;
  answer: ExerciseAnswer;
}

/** Whether what was typed is the answer; null: it cannot be read. */
type Verdict = boolean | null;
