/** Types of `core.js`, whose comments are the manual. Points are in CSS pixels from the picture's top left. */

import type { Box, Camera, Fields, Frame, Gesture, Measure, Parameter, PlacedCamera, Point, Value, Values, ViewName } from "./dimline_editor.js";

export type PointerKind = "mouse" | "touch" | "pen";
/** What a pointer takes hold of, or would. */
export type PointerTarget = "handle" | "camera" | "";
/** Bits: 1 shift, 2 control, 4 alt, 8 command. */
export type Modifiers = number;

/** A line's or an arc's text, and its draggable ends. */
export interface Label {
  id: string;
  /** Its place among the parameters; a measure's is behind theirs. */
  parameter: number;
  name: string;
  text: string;
  box: Box | null;
  /** Its line lies on the model. */
  inside: boolean;
  opacity: number;
  hovered: boolean;
  dragged: boolean;
  measure: boolean;
  handles: { end: "start" | "end"; screen: Point }[];
}

/** A switch or a choice over the picture. */
export interface Pill {
  parameter: number;
  name: string;
  fading: boolean;
  value: Value;
  box: Box;
  opacity: number;
  options: { value: Value; box: Box }[];
}

/** A glTF document that was read; opaque. */
export type SceneBytes = Uint8Array;

export interface GltfDocument {
  bytes: Uint8Array;
  /** By the relative URI that the document names. */
  files?: Record<string, Uint8Array>;
}

export function createCore(options?: { url?: string | URL; attempt?: number }): Promise<Core>;

/** Made by `createCore()` alone. */
export class Core {
  private constructor();
  dispose(): void;

  models(): { name: string; title: string }[];
  setModel(name: string): void;
  readGltf(name: string, document: GltfDocument | Promise<GltfDocument>, noted?: (sentence: string) => void): Promise<SceneBytes>;
  setScene(scene: SceneBytes): void;
  parameters(): Parameter[];
  setParameters(values: Values): void;
  beginWith(values: Values): void;
  setParameterContinuous(name: string, value: Value): void;
  endContinuous(): void;
  resetParameter(name: string): void;
  parseValue(name: string, text: string): Value;
  inputText(name: string): string;
  setNumberFormat(format: { decimal: "." | "," }): void;
  measures(): Measure[];
  measuresShown: boolean;
  undo(): void;
  redo(): void;
  readonly canUndo: boolean;
  readonly canRedo: boolean;

  resize(widthCss: number, heightCss: number, devicePixelRatio: number): void;
  camera(): PlacedCamera;
  setCamera(camera: Camera): void;
  fitToView(): void;
  setStandardView(name: ViewName): void;
  orthographic: boolean;

  pointerDown(id: number, kind: PointerKind, button: number, x: number, y: number, modifiers: Modifiers): PointerTarget;
  pointerMove(id: number, kind: PointerKind, button: number, x: number, y: number, modifiers: Modifiers): PointerTarget;
  pointerUp(id: number, kind: PointerKind, button: number, x: number, y: number, modifiers: Modifiers): void;
  gestures(): Gesture[];
  handleAt(x: number, y: number, kind?: PointerKind): string | null;
  coverCost(box: Box): number;
  hover(id: number, kind: PointerKind, button: number, x: number, y: number, modifiers: Modifiers): PointerTarget;
  endHover(): void;
  cancelGesture(): void;
  cancelPointer(id: number): void;
  wheel(x: number, y: number, deltaPx: number, modifiers: Modifiers): void;

  attachContext(gl: WebGL2RenderingContext): void;
  detachContext(): void;
  contextLost(): void;
  readonly problem: string;
  frame(nowMs: number): boolean;
  readonly atRest: boolean;
  set reducedMotion(on: boolean);
  linesShown: boolean;
  hiddenShown: boolean;
  layout(): Frame;
  labels(): Label[];
  pills(): Pill[];
  takeEvents(): ("input" | "change" | "camera-change" | "load")[];

  fieldsFrom: "auto" | "cpu" | "gpu";
  measureFields(producer: "cpu" | "gpu"): Fields | null;
  timings(): Record<string, number | string>;
}
