/** Style of the element's shadow tree. A constructed sheet, so that a page's policy needs no 'unsafe-inline'. */
export const kEditorCss = `
:host {
  --dimline-ink: #1f2933;
  --dimline-accent: #c2410c;
  --dimline-handle: #e8650a;
  --dimline-halo: #fff;
  display: block;
  position: relative;
  height: 100%;
  min-height: 240px;
  overflow: hidden;
  contain: layout paint style;
  color: var(--dimline-ink);
  font: 500 14px/1.45 "Dimline Label", "Barlow", system-ui, sans-serif;
}
:host([hidden]) { display: none; }

.stage {
  position: absolute;
  inset: 0;
  overflow: hidden;
  direction: ltr; /* a drawing's numbers and units, on a page in any script */
  touch-action: none;
  -webkit-tap-highlight-color: transparent;
  -webkit-touch-callout: none;
  -webkit-user-select: none;
  user-select: none;
}
:host([touch-action="pan-y"]) .stage { touch-action: pan-y; }
.stage[data-cursor="handle"] { cursor: grab; }
.stage[data-cursor="camera-held"] { cursor: grabbing; }
.stage[data-cursor="text"] { cursor: text; }
.stage[data-cursor="ew"] { cursor: ew-resize; }
.stage[data-cursor="ns"] { cursor: ns-resize; }
.stage[data-cursor="nesw"] { cursor: nesw-resize; }
.stage[data-cursor="nwse"] { cursor: nwse-resize; }

canvas {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
  display: block;
  outline: none;
}
/* A canvas is black until something is drawn. */
canvas:not([data-drawn]) { visibility: hidden; }
canvas[data-ring] + .ring { opacity: 1; }
.ring {
  position: absolute;
  inset: 3px;
  border: 2px solid var(--dimline-accent);
  border-radius: 4px;
  opacity: 0;
  pointer-events: none;
}

.handles { position: absolute; inset: 0; pointer-events: none; }

/* A label's box is the layout's: advance width by line height, without kerning, so that both agree to a fraction of a pixel. */
.label {
  position: absolute;
  left: 0;
  top: 0;
  font: 500 14px/16.8px "Dimline Label", "Barlow", system-ui, sans-serif;
  font-kerning: none;
  font-variant-ligatures: none;
  letter-spacing: 0;
  white-space: pre;
  color: var(--dimline-ink);
  text-shadow: 0 0 2px var(--dimline-halo), 1.5px 0 var(--dimline-halo), -1.5px 0 var(--dimline-halo),
    0 1.5px var(--dimline-halo), 0 -1.5px var(--dimline-halo), 1px 1px var(--dimline-halo), -1px 1px var(--dimline-halo),
    1px -1px var(--dimline-halo), -1px -1px var(--dimline-halo), 0 0 5px var(--dimline-halo);
  cursor: inherit;
  border-radius: 2px;
  outline: none;
}
.label[role="slider"], .label[aria-hidden] { pointer-events: auto; }
.label[data-active] { color: var(--dimline-accent); }
/* Over the model a halo alone leaves a number among figures and tiles. */
.label[data-inside] {
  --plate: color-mix(in srgb, var(--dimline-halo) 65%, transparent);
  background: var(--plate);
  box-shadow: 0 0 0 2px var(--plate);
}
/* Where a number can be typed there is a field to be felt. */
@media (hover: hover) {
  .stage[data-cursor="text"] .label:hover { background: #fff; box-shadow: 0 0 0 4px #fff, 0 0 0 5px #c3cbd3; text-shadow: none; }
}
.label:focus-visible {
  outline: 2px solid var(--dimline-accent);
  outline-offset: 4px;
  background: #fff;
  box-shadow: 0 0 0 4px #fff, 0 0 0 9px rgb(255 255 255 / 80%);
  text-shadow: none;
}
.label[data-left] { opacity: 0.6; }
.label[data-covered] { visibility: hidden; }
/* A line without a text is still a slider for keyboards and screen readers: a dot at its handle. */
.label[data-textless] { width: 0; height: 0; overflow: hidden; }
.label[data-textless]:focus-visible { overflow: visible; outline-offset: 12px; border-radius: 50%; background: none; box-shadow: none; }

/* Switches and choices: what the layout reserves for them is their box, to the pixel. */
.pill, .options {
  position: absolute;
  left: 0;
  top: 0;
  box-sizing: border-box;
  border: 1px solid #c3cbd3;
  background: #fff;
  color: var(--dimline-ink);
  font: 500 14px/1 "Dimline Label", "Barlow", system-ui, sans-serif;
  pointer-events: auto;
  touch-action: manipulation;
}
.pill {
  display: flex;
  align-items: center;
  justify-content: space-between;
  margin: 0;
  padding: 0 5px 1px 11px;
  border-radius: 99px;
  box-shadow: 0 1px 2px rgb(31 41 51 / 14%);
  white-space: nowrap;
  cursor: pointer;
  transition: border-color 120ms, box-shadow 120ms;
}
.pill[inert] { pointer-events: none; }
.pill:focus-visible { outline: 2px solid var(--dimline-accent); outline-offset: 2px; }
.pill[aria-expanded="true"] { border-color: var(--dimline-ink); }
.pill .track {
  position: relative;
  flex: none;
  width: 26px;
  height: 16px;
  margin-bottom: -1px;
  border-radius: 8px;
  background: #7b8794;
  transition: background-color 140ms;
}
.pill .track::before {
  content: "";
  position: absolute;
  left: 2px;
  top: 2px;
  width: 12px;
  height: 12px;
  border-radius: 50%;
  background: #fff;
  transition: transform 140ms;
}
.pill[aria-pressed="true"] .track { background: var(--dimline-handle); }
.pill[aria-pressed="true"] .track::before { transform: translateX(10px); }
/* Where the visitor's own few colours stand for all, on and off need two of them. */
@media (forced-colors: active) {
  .pill .track { forced-color-adjust: none; background: ButtonBorder; }
  .pill .track::before { background: Canvas; }
  .pill[aria-pressed="true"] .track { background: Highlight; }
  .pill[aria-pressed="true"] .track::before { background: HighlightText; }
}
.pill .chevron, .option .tick {
  flex: none;
  width: 16px;
  height: 16px;
  margin: 0 2px -1px 0;
  fill: none;
  stroke: var(--dimline-handle);
  stroke-width: 2;
  stroke-linecap: round;
  stroke-linejoin: round;
}
.pill .chevron { transition: rotate 140ms; }
.pill[aria-expanded="true"] .chevron { rotate: 180deg; }

.options {
  z-index: 1;
  display: grid;
  grid-auto-rows: 1fr;
  overflow: hidden;
  border-radius: 12px;
  box-shadow: 0 4px 16px rgb(31 41 51 / 20%), 0 1px 3px rgb(31 41 51 / 16%);
}
.option {
  display: flex;
  align-items: center;
  justify-content: space-between;
  padding: 0 5px 1px 11px;
  outline: none;
  white-space: nowrap;
  cursor: pointer;
}
.option .tick { visibility: hidden; }
.option[aria-selected="true"] .tick { visibility: visible; }
.option:focus { background: #fdeee2; }
.option:focus-visible { box-shadow: inset 0 0 0 2px var(--dimline-accent); border-radius: 11px; }
@media (hover: hover) {
  .pill:hover { border-color: #7b8794; box-shadow: 0 1px 5px rgb(31 41 51 / 24%); }
}
/* A finger gets more than what it sees. */
@media (pointer: coarse) {
  .pill::after { content: ""; position: absolute; inset: -8px 0; }
}
.options[data-touch] { font-size: 16px; }

/* A value that is typed: its box in place of the label's, and a sentence beside it when it is none. */
.value-field {
  position: absolute;
  left: 0;
  top: 0;
  z-index: 2;
  display: grid;
  box-sizing: border-box;
  height: 28px;
  border: 1px solid var(--dimline-accent);
  border-radius: 5px;
  background: #fff;
  box-shadow: 0 0 0 1px var(--dimline-accent), 0 2px 10px rgb(31 41 51 / 22%);
  font: 500 14px/26px "Dimline Label", "Barlow", system-ui, sans-serif;
}
.value-field .mirror, .value-field input {
  grid-area: 1 / 1;
  box-sizing: border-box;
  margin: 0;
  padding: 0 8px;
  border: 0;
  font: inherit;
  color: inherit;
  text-align: center;
  white-space: pre;
}
.value-field .mirror { visibility: hidden; max-width: 240px; overflow: hidden; }
.value-field input {
  width: 100%;
  min-width: 0;
  height: 100%;
  background: none;
  outline: none;
  cursor: text;
  -webkit-user-select: text;
  user-select: text;
}
.value-field input::selection { background: #fbd9c0; }
.value-field[data-wrong] { border-color: #b42318; box-shadow: 0 0 0 1px #b42318, 0 2px 10px rgb(31 41 51 / 22%); }
.value-field .note {
  position: absolute;
  top: calc(100% + 8px);
  width: max-content;
  max-width: 260px;
  margin: 0;
  padding: 6px 10px 7px;
  border-radius: 5px;
  background: #fff;
  box-shadow: 0 2px 10px rgb(31 41 51 / 22%);
  color: #b42318;
  font-size: 13px;
  line-height: 17px;
  text-wrap: pretty;
}
.value-field .note[data-above] { top: auto; bottom: calc(100% + 8px); }
.value-field .note:empty { display: none; }
/* Phones zoom into fields with a smaller text. */
@media (pointer: coarse) {
  .value-field { height: 40px; font-size: 16px; line-height: 38px; }
  .value-field .note { font-size: 14px; line-height: 19px; }
}

.readout {
  position: absolute;
  left: 0;
  top: 0;
  z-index: 3;
  padding: 4px 9px 5px;
  border-radius: 5px;
  background: var(--dimline-ink);
  color: #fff;
  font-size: 13px;
  line-height: 16px;
  white-space: nowrap;
  pointer-events: none;
  opacity: 0;
  transition: opacity 120ms;
}
.readout[data-shown] { opacity: 1; }
.readout div { display: flex; gap: 8px; }
.readout :empty { display: none; }
.readout b { font-weight: 500; }
.readout b, .readout .difference { font-variant-numeric: tabular-nums; }
.readout .title:not(:only-child):has(+ b:not(:empty)), .readout .difference, .readout small { color: #cbd2d9; }
.readout .limit {
  margin: 0 -4px 0 0;
  padding: 0 5px;
  border-radius: 3px;
  background: #ffb27a;
  color: var(--dimline-ink);
}
.readout[data-limit] .limit { animation: limit 220ms ease-out; }
.readout small { display: block; margin-top: 1px; font-size: 12px; }
@keyframes limit {
  35% { transform: translateX(3px); }
  70% { transform: translateX(-2px); }
}
/* For screen readers alone. */
.live {
  position: absolute;
  width: 1px;
  height: 1px;
  margin: 0;
  overflow: hidden;
  clip-path: inset(50%);
  white-space: nowrap;
}
@media (pointer: coarse) {
  .readout { padding: 7px 12px 8px; border-radius: 7px; font-size: 15px; line-height: 18px; }
}
/* In a narrow picture a short box finds a place where a long one would not. */
@media (max-width: 479px) {
  .readout div:has(b:not(:empty)) { display: grid; grid-template-columns: repeat(3, auto); justify-content: start; gap: 2px 8px; }
  .readout div:has(b:not(:empty)) .title { grid-column: 1 / -1; }
}

.message {
  position: absolute;
  inset: 0;
  display: grid;
  place-content: center;
  justify-items: center;
  gap: 8px;
  padding: 24px;
  text-align: center;
  background: linear-gradient(#edf1f4, #fbfaf8);
}
.message[hidden] { display: none; }
.message p { margin: 0; max-width: 48ch; font-size: 15px; overflow-wrap: anywhere; text-wrap: balance; color: #52606d; }
.message .heading { font-size: 18px; color: inherit; }
.message button {
  margin-top: 12px;
  min-height: 44px;
  padding: 0 22px;
  border: 1px solid var(--dimline-ink);
  border-radius: 6px;
  background: #fff;
  color: inherit;
  font: inherit;
  font-size: 16px;
  cursor: pointer;
}
.message button:hover { background: var(--dimline-ink); color: #fff; }
.message button:focus-visible { outline: 2px solid var(--dimline-accent); outline-offset: 2px; }
.message button[hidden] { display: none; }

@media (prefers-reduced-motion: reduce) {
  .readout, .pill, .pill .track, .pill .track::before, .pill .chevron { transition: none; }
  .readout[data-limit] .limit { animation: none; }
}
`;
