import { modelOf, valuesOf, withModel, withValues } from "./address.js";
import "./dimline_editor.js";
import { setEnabled } from "./dom.js";
import { isGltfUrl } from "./gltf_files.js";
import { ModelPicker } from "./model_picker.js";
import { stepped } from "./numbers.js";
import { Panel } from "./panel.js";

const byId = (id) => document.getElementById(id);

const editor = byId("editor");
const panelNode = byId("panel");
const projection = byId("projection");
const hidden = byId("hidden-lines");
const measures = byId("measures");
const hint = byId("hint");
const narrow = matchMedia("(max-width: 639px), (max-width: 1023px) and (orientation: portrait)");

// The address says which model is shown, or none for the one the page was written with, and what has been changed in it.
const firstModel = editor.model;
const modelOfAddress = () => modelOf(location.href) ?? firstModel;
editor.model = modelOfAddress();

let loads = 0;
let shownModel = null;
let refusedModel = null; // was asked for last and could not be had, so that the one before it is shown
// The one that is shown, or on its way.
const wantedModel = () => (editor.model === refusedModel ? shownModel : editor.model);
const onItsWay = () => wantedModel() !== shownModel;

function askFor(name) {
  refusedModel = null;
  editor.model = name;
}

// What the row in use is about, or else how to begin.
const coarse = matchMedia("(pointer: coarse)");
function showHint(sentence = "") {
  hint.textContent = sentence || (coarse.matches ? hint.dataset.touchText : hint.dataset.text);
}
showHint();

const picker = new ModelPicker(byId("model"), byId("models"), (name) => {
  if (name !== wantedModel()) askFor(name);
});

let sliding = false; // by a control of the panel

function slide(name, value) {
  sliding = true;
  attempt(() => editor.setParameterContinuous(name, value));
}

const parameterOf = (name) => editor.getParameters().find((parameter) => parameter.name === name);

const panel = new Panel(byId("parameters"), {
  tell,
  set: (values) => attempt(() => editor.setParameters(values)),
  slide,
  step: (name, steps) => slide(name, stepped(parameterOf(name), steps)),
  endSlide: () => {
    if (!sliding) return;
    sliding = false;
    attempt(() => editor.endContinuous());
    markIdle(); // one that ends where it began is followed by no change
  },
  read: (name, text) => editor.parseValue(name, text),
  mark: () => editor.decimalMark,
  refresh: (name) => attempt(() => panel.refresh(parameterOf(name))),
  point: (name) => editor.pointAt(name),
  travel: (step) => editor[step](),
  help: showHint,
});

// What the visitor does never throws into the void: after a failure the panel shows what holds.
function attempt(action) {
  try {
    action();
  } catch (error) {
    say(error.message);
  }
}

const kSentenceMs = 8000;
let silence = 0;

function say(sentence) {
  byId("status").textContent = sentence;
  clearTimeout(silence);
  silence = setTimeout(hush, kSentenceMs);
}

const hush = () => (byId("status").textContent = "");
addEventListener("pointerdown", hush); // whoever goes on has read it

// For those who hear the page: what they can see is not said.
function tell(sentence) {
  byId("told").textContent = "";
  setTimeout(() => (byId("told").textContent = sentence)); // the same again is said again
}

function showHistory() {
  setEnabled(byId("undo"), editor.canUndo);
  setEnabled(byId("redo"), editor.canRedo);
}

// live: a drag in the picture drives them, and rows that change are marked; underWay: they go on changing, and what is dear waits until they do not.
function showValues({ live = false, underWay = live } = {}) {
  const parameters = editor.getParameters();
  panel.show(parameters, live);
  panel.showMeasures(editor.getMeasures());
  if (!underWay) markIdle();
  setEnabled(byId("reset-all"), parameters.some((p) => p.value !== p.default));
  showHistory();
}

// Where the fields come from a graphics card, the lines of this frame may be those of the last: it is looked again when all is at rest.
let settling = null;
function markIdle() {
  const mark = () =>
    attempt(() => {
      const idle = editor.layout().hidden.filter(({ reason }) => reason === "no-scope");
      panel.markIdle(idle.map(({ parameter }) => parameter));
    });
  mark();
  settling ??= editor.settled().then(
    () => {
      settling = null;
      mark();
    },
    () => (settling = null),
  );
}

function showProjection() {
  const { orthographic } = editor;
  if (projection.getAttribute("aria-pressed") === String(orthographic)) return;
  projection.setAttribute("aria-pressed", orthographic);
  projection
    .querySelector("use")
    .setAttribute("href", `assets/icons/icons.svg#${orthographic ? "orthographic" : "perspective"}`);
}

function showDocument() {
  shownModel = editor.model;
  refusedModel = null;
  const models = editor.getModels();
  const title = models.find((model) => model.name === editor.model)?.title ?? editor.model.split("/").pop();
  byId("title").textContent = byId("document").textContent = title;
  document.title = `${title} – Dimline`;
  picker.show(models, editor.model);
  panel.build(editor.getParameters());
  panelNode.dataset.state = "ready";
  for (const button of document.querySelectorAll(".views button")) button.disabled = false;
  showValues();
  showProjection();
  showMore();
  if (loads++ > 0) tell(`${title} is shown.`);
  byId("parameters").parentElement.scrollTop = 0; // what was scrolled to was the last model's
  remember();
}

// Which lines there are beyond those that the picture needs. A model without measures needs no button for them.
function showMore() {
  hidden.setAttribute("aria-pressed", editor.hiddenShown);
  measures.setAttribute("aria-pressed", editor.measuresShown);
  measures.hidden = editor.getMeasures().length === 0;
}

const addresses = new Map(); // of each model that was shown, as it was left

// Another model is a step in the browser's history, unless the address says so already: then it is where the model came from.
function remember() {
  const parameters = editor.getParameters();
  if (modelOfAddress() !== shownModel) history.pushState(null, "", withModel(location.href, shownModel));
  const address = withValues(location.href, parameters);
  addresses.set(shownModel, address);
  if (address === location.href) return;
  try {
    history.replaceState(null, "", address);
  } catch {
    // Some browsers take no more than a hundred in half a minute; the next one will say it all.
  }
}

// A model begins with what the address says, or, when it was chosen in the page, as it was left; at first with its defaults.
function addressedValues(parameters) {
  const address = modelOfAddress() === wantedModel() ? location.href : addresses.get(wantedModel());
  if (!address) return {};
  const { values, problems } = valuesOf(address, parameters);
  if (problems.length > 0) say(problems.join(" "));
  return values;
}
editor.initialValues = addressedValues;

function recall() {
  say(""); // it was about the address before
  const parameters = editor.getParameters();
  attempt(() => editor.setParameters({ ...panel.defaults(parameters), ...addressedValues(parameters) }));
  remember();
}

// A visitor knows models by the names in the menu, not by those in addresses.
function sentenceFor(model, error) {
  const isBuiltIn = editor.getModels().some(({ name }) => name === model);
  return isBuiltIn || isGltfUrl(model) ? error.message : `There is no model “${model}”. The menu at the top left lists all models.`;
}

// The editor itself tells why it cannot go on; the page tells why a document could not be loaded while another is shown.
function showFailure(error) {
  if (panelNode.dataset.state !== "ready" && !editor.error && editor.model !== firstModel) {
    // The address names a model that there is not.
    const wanted = editor.model;
    history.replaceState(null, "", location.pathname);
    editor.model = firstModel;
    say(sentenceFor(wanted, error));
    return;
  }
  if (panelNode.dataset.state !== "ready") panelNode.dataset.state = "failed";
  else if (!editor.error) {
    say(sentenceFor(editor.model, error));
    refusedModel = editor.model;
    history.replaceState(null, "", withModel(location.href, shownModel));
    remember();
  }
}

// The first picture does not wait for the panel beside it, which takes a while to build: it is painted first.
editor.addEventListener("load", () => requestAnimationFrame(() => setTimeout(showDocument)), { once: true });
editor.addEventListener("load", () => {
  if (panelNode.dataset.state === "ready") showDocument();
});
editor.addEventListener("error", (event) => showFailure(event.error));
// What a drag drives is marked while it lasts. One that ends where it began is followed by no change, so its end is looked for.
let dragging = false;
function untilDragEnds() {
  if (editor.gestures.length > 0) return requestAnimationFrame(untilDragEnds);
  dragging = false;
  attempt(showValues);
}
editor.addEventListener("input", () => {
  showValues({ live: !sliding, underWay: true });
  if (dragging || editor.gestures.length === 0) return;
  dragging = true;
  requestAnimationFrame(untilDragEnds);
});
editor.addEventListener("change", () => {
  showValues();
  // What is done while another model is on its way goes when that comes.
  if (panelNode.dataset.state === "ready" && !onItsWay()) remember();
});
editor.addEventListener("camera-change", showProjection);

// Numbers in another manner: the editor has changed by now, for it heard first.
function writeAnew() {
  if (panelNode.dataset.state !== "ready") return;
  for (const parameter of editor.getParameters()) panel.refresh(parameter);
  panel.showMeasures(editor.getMeasures());
}
new MutationObserver(writeAnew).observe(editor, { attributeFilter: ["lang"] });
addEventListener("languagechange", writeAnew);

byId("undo").addEventListener("click", () => editor.canUndo && editor.undo());
byId("redo").addEventListener("click", () => editor.canRedo && editor.redo());
byId("fit").addEventListener("click", () => editor.fitToView());
projection.addEventListener("click", () => {
  editor.orthographic = !editor.orthographic;
});
// A click switches; holding the button shows the lines as long as it is held, as its key does.
const kHoldMs = 400;
let heldSinceMs = Infinity;
hidden.addEventListener("pointerdown", (event) => {
  if (event.button !== 0 || editor.hiddenShown) return;
  heldSinceMs = event.timeStamp;
  hidden.setPointerCapture(event.pointerId); // or a hold that ends off the button would not end
  editor.hiddenShown = true;
  showMore();
});
const letGo = (event) => {
  if (event.timeStamp - heldSinceMs > kHoldMs) editor.hiddenShown = false;
  showMore();
};
hidden.addEventListener("pointerup", letGo);
hidden.addEventListener("pointercancel", (event) => {
  letGo(event);
  heldSinceMs = Infinity; // no click follows
});
hidden.addEventListener("click", (event) => {
  // With a pointer, its going down has switched it on.
  const switchedOn = heldSinceMs !== Infinity;
  heldSinceMs = Infinity;
  if (!switchedOn) editor.hiddenShown = !editor.hiddenShown;
  showMore();
});
hidden.addEventListener("contextmenu", (event) => event.preventDefault()); // of a finger that holds it
measures.addEventListener("click", () => {
  editor.measuresShown = !editor.measuresShown;
  showMore();
});
for (const button of document.querySelectorAll("[data-view]")) {
  button.addEventListener("click", () => editor.setView(button.dataset.view));
}
byId("reset-all").addEventListener("click", () => {
  const defaults = panel.defaults(editor.getParameters());
  if (Object.keys(defaults).length === 0) return;
  attempt(() => editor.setParameters(defaults));
  tell("All values are reset.");
});
addEventListener("popstate", () => {
  if (wantedModel() !== modelOfAddress()) askFor(modelOfAddress());
  else if (panelNode.dataset.state === "ready" && !onItsWay()) recall();
});

// On a phone the panel is a sheet under the picture, which folds.
const fold = byId("fold");
fold.addEventListener("click", () => {
  const open = fold.getAttribute("aria-expanded") !== "true";
  fold.setAttribute("aria-expanded", open);
  panelNode.toggleAttribute("data-folded", !open);
});
narrow.addEventListener("change", () => {
  fold.setAttribute("aria-expanded", true);
  panelNode.removeAttribute("data-folded");
});

// The editor's keys work wherever the focus is, except where keys mean text or a value.
document.addEventListener("keydown", (event) => {
  if (event.target === editor) return;
  attempt(() => editor.handleKey(event) && showMore());
});
editor.addEventListener("keydown", showMore);
