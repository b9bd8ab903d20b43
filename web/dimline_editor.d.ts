/** Types of `dimline_editor.js`, whose comments are the manual. Points are in CSS pixels from the picture's top left on screen, in metres in the world. */

export type Point = [x: number, y: number];
export type Point3 = [x: number, y: number, z: number];
export type Box = [x0: number, y0: number, x1: number, y1: number];

export type Value = number | boolean | string;
export type Values = Record<string, Value>;

export interface Parameter {
  name: string;
  title: string;
  help: string;
  group: string;
  type: "float" | "int" | "angle" | "bool" | "choice";
  /** Angles are in degrees; of a choice its name. */
  value: Value;
  default: Value;
  /** Null for a switch and a choice, as are `max` and `step`. */
  min: number | null;
  max: number | null;
  step: number | null;
  unit: "m" | "deg" | "m2" | "";
  choices: string[];
  annotation: string;
}

export interface Measure {
  name: string;
  title: string;
  help: string;
  unit: string;
  value: number;
  text: string;
}

interface CameraPose {
  eye: Point3;
  target: Point3;
  up?: Point3;
}
export type Camera = CameraPose & ({ fovDeg: number } | { orthoHeight: number });
/** As it is given back: nothing is left out. */
export type PlacedCamera = Required<CameraPose> & ({ fovDeg: number } | { orthoHeight: number });

export type ViewName = "three-quarter" | "front" | "back" | "left" | "right" | "top";

export interface Handle {
  end: "start" | "end";
  screen: Point;
}

export interface Line {
  parameter: string;
  scope: string;
  scopeIndex: number;
  type: string;
  slip: "scope" | "object" | "billboard" | "none";
  value: Value;
  text: string;
  indirect: boolean;
  /** Equal for the members of one chain, null for a line of its own. */
  chain: number | null;
  placement: "outside" | "guide" | "inside";
  plane: { kind: "scope" | "billboard" | "object" | "none"; point: Point3; normal: Point3; facing: "front" | "back" | "none" };
  base: { world: [Point3, Point3]; screen: [Point, Point] };
  line: { world: [Point3, Point3]; screen: [Point, Point] };
  /** Polylines from the base line's ends to the line's, base end first; empty for a line inside. */
  extensions: [Point[], Point[]];
  label: { box: Box } | null;
  handles: Handle[];
  /** Equal in two frames when the choice is the same. */
  identity: string;
}

/** An angle, a switch or a choice. */
export interface OtherHandle {
  parameter: string;
  scope: string;
  scopeIndex: number;
  type: string;
  value: Value;
  text: string;
  placement: "outside" | "guide" | "inside";
  anchor: Point;
  box: Box;
  handles: Handle[];
  /** Of a choice. */
  options?: { value: Value; box: Box }[];
  identity: string;
}

/** One frame as it is drawn. Every annotated parameter is in exactly one of lines, others and hidden; none is in any while the element has no size, or lines are not shown (`linesShown`). */
export interface Frame {
  size: [width: number, height: number];
  /** Column-major, OpenGL clip space. */
  view: number[];
  projection: number[];
  lines: Line[];
  /** Only while measures are shown. */
  measures?: Line[];
  others: OtherHandle[];
  hidden: { parameter: string; reason: "occluded" | "out-of-view" | "too-short" | "foreshortened" | "crowded" | "no-scope" }[];
  visible: [scope: string, index: number][];
}

export interface Gesture {
  id: number;
  parameter: string;
  kind: "line" | "arc";
  value: Value;
  text: string;
  difference: string;
  limit: "min" | "max" | null;
  handle: Point;
  direction: Point;
  pointer: "mouse" | "touch" | "pen";
  snap: "step" | "fine" | "none";
}

export interface Fields {
  width: number;
  height: number;
  left: (number | null)[];
  right: (number | null)[];
  top: (number | null)[];
  bottom: (number | null)[];
}

export class DimlineEditor extends HTMLElement {
  readonly ready: Promise<void>;
  get model(): string;
  set model(name: string | null);
  get initialValues(): Values | ((parameters: Parameter[]) => Values) | null;
  set initialValues(values: Values | ((parameters: Parameter[]) => Values) | null);
  coreUrl: string;

  getParameters(): Parameter[];
  setParameters(values: Values): void;
  getCamera(): PlacedCamera;
  setCamera(camera: Camera): void;
  settled(): Promise<void>;
  layout(): Frame;
  undo(): void;
  redo(): void;

  readonly error: Error | null;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  getModels(): { name: string; title: string }[];
  setParameterContinuous(name: string, value: Value): void;
  endContinuous(): void;
  fitToView(): void;
  setView(name: ViewName): void;
  orthographic: boolean;
  linesShown: boolean;
  handleKey(event: KeyboardEvent): boolean;
  hiddenShown: boolean;
  getMeasures(): Measure[];
  measuresShown: boolean;
  readonly decimalMark: "." | ",";
  parseValue(name: string, text: string): Value;
  pointAt(name: string | null): void;
  readonly gestures: Gesture[];
  resetParameter(name: string): void;

  fieldsFrom: "auto" | "cpu" | "gpu";
  measureFields(producer: "cpu" | "gpu"): Fields | null;
  timings(): Record<string, number | string>;

  addEventListener<K extends keyof DimlineEditorEventMap>(type: K, listener: (this: DimlineEditor, event: DimlineEditorEventMap[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

export interface DimlineEditorEventMap extends Omit<HTMLElementEventMap, "input"> {
  load: Event;
  error: ErrorEvent;
  input: Event;
  change: Event;
  "camera-change": Event;
}

declare global {
  interface HTMLElementTagNameMap {
    "dimline-editor": DimlineEditor;
  }
}
