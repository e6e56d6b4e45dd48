// SPDX-License-Identifier: BSD-3-Clause
// What the page has and shows. Places are whole numbers, steps of scene.quantum, where not said otherwise.

const MILLI = 1e-3, MICRO = 1e-6;

// Of the page, set once: the data, fields by name, rows of the tables of an output, particles, and where the mirror is.
let scene, field, thereRow, rubbleRow, placeRow, shapeRow, stateRow, numbers, sizes, material, count, names, blocks, lineOf, axisAt, panels;
let rubble;  // number of the kind of loose pieces of the target in the hole, behind those of materials
let lying, forward;  // whether y runs along the stage; 1 where y grows to the right or downwards on it, else -1
let canvas, marks, stage;
const rows = {};  // codes of the fields that were read, by name

// What is shown: camera (pixels per step along y; those of the view that was last gone to, and its stretch), output, fields, ranges of
// colours that are not the field's own, mouse, particle under it, materials left out.
const view = {x: 0, y: 0, scale: 1, rest: {scale: 1, stretch: 1}, follow: false, step: 0, left: null, right: null, mouse: null, hit: -1,
  limits: {left: undefined, right: undefined}};
const hidden = new Set(), option = {outlines: true, edges: false, cells: false, fitted: false, plain: true, measured: true};
const palettes = {};  // pixels of the codes of colours, by side
const now = {there: null, kind: null, place: null, shape: null, left: null, right: null, state: null};  // rows of the output
const picture = {ids: new Int32Array(0), wide: 0, high: 0, dense: 1, change: 0};  // the particle of every pixel

const at = name => document.getElementById(`explore-${name}`);
const shown = text => Object.assign(document.createElement("span"), {textContent: text});

function say(words) {
  at("why").textContent = words;
  at("why").hidden = false;
}

const toQuantum = (metres, axis) => (metres - scene.low[axis]) / scene.quantum;
const toMetres = (quanta, axis) => quanta * scene.quantum + scene.low[axis];

function blocksOf(codes, kinds) {
  const found = [];
  for (let kind = 1; kind <= kinds; kind++) {
    const first = codes.indexOf(kind);
    if (first >= 0) found.push({kind, name: names[kind - 1], first, count: codes.lastIndexOf(kind) - first + 1,
      colour: field.material.colours[kind - 1], jet: names[kind - 1] === scene.jet});
  }
  return found.sort((a, b) => a.jet - b.jet);  // the jet above the others
}

// Number of the material of every particle; loose pieces of the target in the hole have one of their own.
function kindsOf(loose) {
  const found = material.slice();
  for (let i = 0; i < count; i++) if (loose[i]) found[i] = rubble;
  return found;
}

async function rowsOf(name) {
  rows[name] ??= await unpacked(field[name].codes);
  return rows[name];
}

function paint(side) {
  const name = view[side], codes = rows[name](view.step), colour = coloursOf(field[name], view.limits[side]);
  const found = new Uint32Array(count), pixels = palettes[side];
  const loose = option.plain && !field[name].inJet ? pixelOf(scene.rubbleColour) : 0;
  for (let i = 0; i < count; i++) found[i] = loose && now.kind[i] === rubble ? loose : pixels[colour(codes[i])];
  for (const one of blocks) if (isPlain(one, field[name])) found.fill(pixelOf(one.colour), one.first, one.first + one.count);
  now[side] = found;
}

// A jet is in its own colour where the field is not looked at in a jet.
const isPlain = (block, one) => block.jet && option.plain && !one.inJet;

function setStep(step) {
  view.step = Math.max(0, Math.min(scene.times.length - 1, step));
  now.there = thereRow(view.step);
  now.kind = kindsOf(rubbleRow(view.step));
  now.place = placeRow(view.step);
  now.shape = shapeRow(view.step);
  now.state = stateRow(view.step).slice();
  paint("left");
  paint("right");
  at("time").value = view.step;
  at("when").textContent = `${timeText(scene.times[view.step])} (${view.step + 1} of ${scene.times.length})`;
  for (const marker of document.querySelectorAll(".explore-now")) marker.move(scene.times[view.step] / MICRO);
  if (view.follow) goToTip();
  redraw();
}

async function setField(side, name) {
  await rowsOf(name);
  view[side] = name;
  palettes[side] = paletteOf(field[name]);
  at(side).value = name;
  view.limits[side] = undefined;
  drawBar(side);
  if (now.there) paint(side);
  redraw();
}
