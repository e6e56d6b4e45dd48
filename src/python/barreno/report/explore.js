// SPDX-License-Identifier: BSD-3-Clause
// The explorable view of a report's page (docs/report.md). The data are the JSON that explore.py writes: whole numbers, packed by
// explore_codes.py. regl draws the particles with WebGL, uPlot the curves.
(() => {
"use strict";

const MILLI = 1e-3, MICRO = 1e-6;
const WITHOUT = [191, 191, 191], HIDDEN = 255;  // colour of a material that lacks the field; code of what is not drawn
const PLAY_PAUSE = 160;  // ms from one output to the next
const OVERLAP = 1.02;  // shapes are rounded; the seams between neighbours are covered
const LEAST_CELL = 3;  // pixels
const HALO = 1.3;  // pixels: outline of a material
const ARRAYS = {u8: Uint8Array, i8: Int8Array, u16: Uint16Array, u32: Uint32Array};
const WHOLE = {u8: Uint8Array, i8: Uint8Array, u16: Uint16Array, u32: Uint32Array};

const at = name => document.getElementById(`explore-${name}`);

// ---- numbers ----

async function inflated(text) {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function joined(bytes, from, count, kind) {
  const found = new WHOLE[kind](count), wide = found.BYTES_PER_ELEMENT;
  for (let plane = 0; plane < wide; plane++)
    for (let i = 0; i < count; i++) found[i] += bytes[from + plane * count + i] * 2 ** (8 * plane);
  return found;
}

// Rows of a table of whole numbers: the first, and what columns that ever change have in the others.
async function unpacked(packed) {
  const bytes = await inflated(packed.data), {type, rows, columns, changed} = packed;
  const index = new Uint32Array(changed), mask = Math.ceil(columns / 8);
  for (let i = 0, k = 0; i < columns; i++) if (bytes[i >> 3] >> (i & 7) & 1) index[k++] = i;
  const first = joined(bytes, mask, columns, type), wide = first.BYTES_PER_ELEMENT;
  const later = joined(bytes, mask + wide * columns, (rows - 1) * changed, type);
  for (let k = 0; k < later.length; k++) later[k] += k < changed ? first[index[k]] : later[k - changed];  // modulo the type
  const out = new ARRAYS[type](columns);
  const plain = new WHOLE[type](out.buffer);
  return row => {
    plain.set(first);
    if (row > 0 && rows > 1) for (let k = 0, from = (row - 1) * changed; k < changed; k++) plain[index[k]] = later[from + k];
    return out;
  };
}

// ---- values of codes (explore_codes.py has the equation) ----

function valueOf(field, code) {
  if (!code) return NaN;
  const {table, middle, width, step, zero} = field.scale;
  return table ? table[code - 1] : middle + width * Math.sinh(step * (code - zero));
}

// Greatest difference between a code's value and one that has the code.
function slackOf(field, code) {
  if (!code || field.scale.table) return 0;
  const value = valueOf(field, code);
  return Math.max(valueOf(field, code + 0.5) - value, value - valueOf(field, code - 0.5));
}

function share(field, value) {
  const [low, high] = field.limits;
  if (field.doubling) return value > 0 ? Math.log(value / low) / Math.log(high / low) : NaN;
  return (value - low) / (high - low);
}

function paletteOf(field) {
  const pixels = new Uint8Array(4 * 256).fill(255);
  const colours = field.classes ? field.colours : field.palette.match(/.{6}/g).map(six => `#${six}`);
  pixels.set(WITHOUT, 0);
  colours.slice(0, 254).forEach((colour, i) => {
    for (let part = 0; part < 3; part++) pixels[4 * (i + 1) + part] = parseInt(rgb(colour).slice(1 + 2 * part, 3 + 2 * part), 16);
  });
  return pixels;
}

// Colours by name as six digits.
function rgb(colour) {
  const pen = document.createElement("canvas").getContext("2d");
  pen.fillStyle = colour;
  return pen.fillStyle;
}

// Colour of every code, for the texture above.
function coloursOf(field) {
  if (field.classes) return code => code % 255;
  const known = new Map();
  const colour = code => {
    const part = share(field, valueOf(field, code));
    return Number.isFinite(part) ? 1 + Math.round(253 * Math.min(1, Math.max(0, part))) : 0;
  };
  return code => {
    if (!known.has(code)) known.set(code, colour(code));
    return known.get(code);
  };
}

// Number and the greatest difference from the value in the file, the rounding of both for reading included.
function withSlack(value, slack) {
  if (!(slack > 0)) return Number(value.toPrecision(6)).toString();
  const digits = 1 - Math.floor(Math.log10(slack)), rest = Math.max(0, Math.min(12, digits));
  const unit = 10 ** -rest, most = Math.ceil((slack + 0.5 * unit) / unit - 1e-9) * unit;
  const large = Math.abs(value) >= 1e6 || rest > 6;
  return large ? `${value.toExponential(3)} ± ${(slack + Math.abs(value) * 5e-4).toExponential(1)}`
    : `${value.toFixed(rest)} ± ${most.toFixed(rest)}`;
}

const timeText = time => `t = ${Number((time / MICRO).toPrecision(4))} µs`;

function ticksBetween(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= rough * 0.999);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(Number((k * step).toPrecision(10)));
  return found;
}

// ---- the page ----

const shown = text => Object.assign(document.createElement("span"), {textContent: text});

function say(words) {
  at("why").textContent = words;
  at("why").hidden = false;
}

const VERTEX = `
precision highp float;
attribute vec2 corner;
attribute vec2 place;
attribute vec4 shape;
attribute float size, colour;
uniform vec2 origin, scale, pixel;
uniform float mirror, unit, sizeUnit, halo;
varying vec2 inside, edge;
varying float code;
void main() {
  vec4 half_edges = shape * (unit * sizeUnit * size);
  vec2 lengths = vec2(length(half_edges.xy * pixel), length(half_edges.zw * pixel));
  vec2 grown = corner * (${OVERLAP} + halo / max(lengths, vec2(0.01)));
  vec2 at = place - origin * vec2(mirror, 1.0) + grown.x * half_edges.xy + grown.y * half_edges.zw;
  inside = corner;
  edge = lengths;
  code = colour;
  gl_Position = colour > 254.5 ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(at * scale * vec2(mirror, 1.0), 0.0, 1.0);
}`;

const FRAGMENT = `
precision highp float;
uniform sampler2D palette;
uniform vec3 plain;
uniform float plainly, edges;
varying vec2 inside, edge;
varying float code;
void main() {
  vec3 found = texture2D(palette, vec2((code + 0.5) / 256.0, 0.5)).rgb;
  vec2 from = (1.0 - abs(inside)) * edge;
  float dark = edges * (min(from.x, from.y) < 0.7 ? 0.3 : 0.0) * (min(edge.x, edge.y) > 2.5 ? 1.0 : 0.0);
  gl_FragColor = vec4(mix(found * (1.0 - dark), plain, plainly), 1.0);
}`;

function startedDrawing(canvas, scene, count) {
  const regl = window.createREGL({canvas, extensions: ["ANGLE_instanced_arrays"], attributes: {antialias: true, alpha: false}});
  const filled = (array, type) => regl.buffer({data: array, type, usage: "dynamic"});
  const buffers = {
    place: filled(new Uint16Array(2 * count), "uint16"), shape: filled(new Int8Array(4 * count), "int8"),
    size: filled(new Uint16Array(count), "uint16"), left: filled(new Uint8Array(count), "uint8"),
    right: filled(new Uint8Array(count), "uint8"),
  };
  const attribute = (buffer, size, type, bytes) => (_, props) => ({buffer: buffers[buffer ?? props.side], size, type,
    offset: bytes * props.first, stride: bytes, divisor: 1});
  const quads = regl({
    vert: VERTEX, frag: FRAGMENT, primitive: "triangle strip", count: 4, depth: {enable: false},
    instances: regl.prop("instances"),
    attributes: {
      corner: regl.buffer([[-1, -1], [1, -1], [-1, 1], [1, 1]]), place: attribute("place", 2, "uint16", 4),
      shape: attribute("shape", 4, "int8", 4), size: attribute("size", 1, "uint16", 2), colour: attribute(null, 1, "uint8", 1),
    },
    uniforms: {
      origin: regl.prop("origin"), scale: regl.prop("scale"), pixel: regl.prop("pixel"), mirror: regl.prop("mirror"),
      unit: scene.shapeUnit, sizeUnit: scene.largest / scene.quantum, halo: regl.prop("halo"), palette: regl.prop("palette"),
      plain: regl.prop("plain"), plainly: regl.prop("plainly"), edges: regl.prop("edges"),
    },
    viewport: regl.prop("viewport"), scissor: {enable: true, box: regl.prop("viewport")},
  });
  const texture = () => regl.texture({width: 256, height: 1, data: new Uint8Array(1024), mag: "nearest", min: "nearest"});
  return {regl, buffers, quads, palettes: {left: texture(), right: texture()}};
}

// State of the view; numbers are in steps of the places ("quantum") where not said otherwise.
async function start(scene) {
  const field = Object.fromEntries(scene.fields.map(one => [one.name, one]));
  const [numberRow, thereRow, placeRow, shapeRow, sizeRow, materialRow, stateRow] = await Promise.all([scene.numbers, scene.there,
    scene.places, scene.shapes, scene.sizes, field.material.codes, field.state.codes].map(unpacked));
  const numbers = numberRow(0), sizes = sizeRow(0), material = materialRow(0), count = numbers.length;
  const canvas = at("particles"), marks = at("marks"), stage = at("stage");
  const {regl, buffers, quads, palettes} = startedDrawing(canvas, scene, count);
  const rows = {material: materialRow, state: stateRow};
  const names = field.material.classes, blocks = blocksOf(material, names.length);
  const hidden = new Set(), view = {x: 0, y: 0, scale: 1, follow: false, step: 0, left: null, right: null, mouse: null, hit: -1};
  const now = {there: null, place: null, shape: null, left: null, right: null, state: null};
  const toQuantum = (metres, axis) => (metres - scene.low[axis]) / scene.quantum;
  const toMetres = (quanta, axis) => quanta * scene.quantum + scene.low[axis];
  const axisAt = scene.mirrored ? toQuantum(0, 0) : 0;  // x of the mirror
  const panels = scene.mirrored ? 1 : 2, flip = scene.down ? -1 : 1;
  let pending = false, playing = null, outlines = true, edges = false, cells = false;

  function blocksOf(codes, kinds) {
    const found = [];
    for (let kind = 1; kind <= kinds; kind++) {
      const first = codes.indexOf(kind);
      if (first >= 0) found.push({kind, name: names[kind - 1], first, count: codes.lastIndexOf(kind) - first + 1,
        colour: field.material.colours[kind - 1], jet: names[kind - 1] === scene.jet});
    }
    return found.sort((a, b) => a.jet - b.jet);  // the jet above the others
  }

  // ---- choice of time and fields ----

  async function rowsOf(name) {
    rows[name] ??= await unpacked(field[name].codes);
    return rows[name];
  }

  function paint(side) {
    const name = view[side], codes = rows[name](view.step), colour = coloursOf(field[name]);
    const bytes = new Uint8Array(count);
    for (let i = 0; i < count; i++) bytes[i] = now.there[i] && !hidden.has(material[i]) ? colour(codes[i]) : HIDDEN;
    now[side] = bytes;
    buffers[side].subdata(bytes);
  }

  function setStep(step) {
    view.step = Math.max(0, Math.min(scene.times.length - 1, step));
    now.there = thereRow(view.step);
    now.place = placeRow(view.step);
    now.shape = shapeRow(view.step);
    now.state = stateRow(view.step).slice();
    buffers.place.subdata(now.place);
    buffers.shape.subdata(now.shape);
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
    palettes[side].subimage({width: 256, height: 1, data: paletteOf(field[name])});
    at(side).value = name;
    drawBar(at(`bar-${side}`), field[name]);
    if (now.there) paint(side);
    redraw();
  }

  // ---- camera ----

  const size = () => ({wide: stage.clientWidth, high: stage.clientHeight});
  const panelWide = () => size().wide / panels;

  function extent() {
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (let i = 0; i < count; i++) for (let axis = 0; now.there[i] && axis < 2; axis++) {
      const value = now.place[2 * i + axis];
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    }
    if (!(high[0] >= low[0])) return {low: [0, 0], high: [65535, 65535]};
    return {low: scene.mirrored ? [2 * axisAt - high[0], low[1]] : low, high};
  }

  function lookAt(low, high) {
    view.x = 0.5 * (low[0] + high[0]);
    view.y = 0.5 * (low[1] + high[1]);
    view.scale = 0.94 * Math.min(panelWide() / Math.max(high[0] - low[0], 1), size().high / Math.max(high[1] - low[1], 1));
  }

  function goWhole() {
    const {low, high} = extent();
    lookAt(low, high);
    follow(false);
    redraw();
  }

  function goToTip() {
    const tip = scene.tips[view.step];
    if (tip === null) return;
    const reach = scene.around / scene.quantum, y = toQuantum(tip, 1), x = scene.mirrored ? axisAt : toQuantum(0, 0);
    const along = scene.down || scene.tips.some(one => one > tip) ? 1 : -1;
    lookAt([x - 14 * reach, y - (along > 0 ? 16 : 10) * reach], [x + 14 * reach, y + (along > 0 ? 10 : 16) * reach]);
  }

  function follow(on) {
    view.follow = on;
    at("tip").setAttribute("aria-pressed", on);
  }

  function zoom(factor, x = 0.5 * size().wide, y = 0.5 * size().high) {
    const before = placeAt(x, y);
    view.scale = Math.max(1e-4, Math.min(50, view.scale * factor));
    const after = placeAt(x, y);
    view.x += before.x - after.x;
    view.y += before.y - after.y;
    follow(false);
    redraw();
  }

  const middleOf = panel => (panel + 0.5) * panelWide();
  const panelAt = x => Math.min(panels - 1, Math.max(0, Math.floor(x / panelWide())));

  function placeAt(x, y) {
    return {x: view.x + (x - middleOf(panelAt(x))) / view.scale, y: view.y - flip * (y - 0.5 * size().high) / view.scale};
  }

  const screenOf = (x, y, panel = 0) => [middleOf(panel) + (x - view.x) * view.scale,
    0.5 * size().high - flip * (y - view.y) * view.scale];

  // ---- drawing ----

  function redraw() {
    if (pending || !now.right) return;
    pending = true;
    requestAnimationFrame(() => {
      pending = false;
      draw();
      drawMarks();
      hover();
    });
  }

  function fit() {
    const {wide, high} = size(), dense = window.devicePixelRatio || 1;
    for (const one of [canvas, marks]) {
      if (one.width === Math.round(wide * dense) && one.height === Math.round(high * dense)) continue;
      one.width = Math.round(wide * dense);
      one.height = Math.round(high * dense);
    }
    return dense;
  }

  function draw() {
    const dense = fit(), {high} = size(), wide = panelWide();
    regl.poll();
    regl.clear({color: [0.89, 0.922, 0.945, 1]});
    const halves = scene.mirrored ? [["left", -1, 0], ["right", 1, 0]] : [["left", 1, 0], ["right", 1, 1]];
    for (const [side, mirror, panel] of halves) {
      const common = {
        side, mirror, edges: edges ? 1 : 0, palette: palettes[side],
        // The mirror is at x = axisAt: x' = 2 axisAt - x.
        origin: [mirror < 0 ? view.x - 2 * axisAt : view.x, view.y],
        scale: [2 * view.scale / wide, 2 * flip * view.scale / high], pixel: [view.scale * dense, view.scale * dense],
        viewport: {x: Math.round(panel * wide * dense), y: 0, width: Math.round(wide * dense), height: Math.round(high * dense)},
      };
      const list = [];
      for (const {first, count: instances, colour} of blocks) {
        const plain = [1, 3, 5].map(i => parseInt(rgb(colour).slice(i, i + 2), 16) / 255);
        if (outlines) list.push({...common, first, instances, halo: HALO * dense, plain, plainly: 1});
        list.push({...common, first, instances, halo: 0, plain, plainly: 0});
      }
      quads(list);
    }
  }

  function drawMarks() {
    const dense = window.devicePixelRatio || 1, {wide, high} = size(), pen = marks.getContext("2d");
    pen.setTransform(dense, 0, 0, dense, 0, 0);
    pen.clearRect(0, 0, wide, high);
    at("hint").textContent = "";
    for (let panel = 0; panel < panels; panel++) {
      pen.save();
      pen.beginPath();
      pen.rect(panel * panelWide(), 0, panelWide(), high);
      pen.clip();
      if (cells) drawCells(pen, panel);
      if (scene.mirrored) drawAxis(pen);
      if (view.hit >= 0) drawHit(pen, panel);
      drawTicks(pen, panel);
      pen.restore();
    }
    if (panels === 2) line(pen, [[panelWide(), 0], [panelWide(), high]], "#555", 1);
  }

  function line(pen, points, colour, width) {
    pen.beginPath();
    points.forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  function drawAxis(pen) {
    pen.setLineDash([10, 5, 2, 5]);
    const [x] = screenOf(axisAt, 0);
    line(pen, [[x, 0], [x, size().high]], "rgba(0,0,0,.55)", 1);
    pen.setLineDash([]);
  }

  // Lengths in mm along the lower and the left edge.
  function drawTicks(pen, panel) {
    const {high} = size(), left = panel * panelWide(), wide = panelWide();
    const mm = (quanta, axis) => toMetres(quanta, axis) / MILLI, back = (value, axis) => toQuantum(value * MILLI, axis);
    const from = placeAt(left + 1, high - 1), to = placeAt(left + wide - 1, 1), step = (one, two) => [Math.min(one, two), Math.max(one, two)];
    pen.font = "11px sans-serif";
    pen.lineWidth = 3;
    pen.strokeStyle = "rgba(255,255,255,.85)";
    const text = (words, x, y) => {
      pen.strokeStyle = "rgba(255,255,255,.85)";
      pen.lineWidth = 3;
      pen.strokeText(words, x, y);
      pen.fillStyle = "#222";
      pen.fillText(words, x, y);
    };
    pen.textAlign = "center";
    for (const value of ticksBetween(...step(mm(from.x, 0), mm(to.x, 0)), Math.max(2, wide / 90))) {
      const [x] = screenOf(back(value, 0), 0, panel);
      line(pen, [[x, high], [x, high - 6]], "#222", 1);
      if (x > left + 50 && x < left + wide - 40) text(Number(Math.abs(scene.mirrored ? value : NaN) || value), x, high - 9);
    }
    pen.textAlign = "left";
    for (const value of ticksBetween(...step(mm(from.y, 1), mm(to.y, 1)), Math.max(2, high / 70))) {
      const [, y] = screenOf(0, back(value, 1), panel);
      line(pen, [[left, y], [left + 6, y]], "#222", 1);
      if (y > 26 && y < high - 24) text(value, left + 9, y + 4);
    }
    text("y [mm]", left + 6, 14);
    pen.textAlign = "right";
    text(`${scene.across} [mm]`, left + wide - 6, high - 9);
    pen.textAlign = "left";
  }

  // Cells of the grid in which particles are, each of its own size.
  function drawCells(pen, panel) {
    const found = new Set(), codes = rows.cell_size?.(view.step), lower = [0, 1].map(axis => toQuantum(scene.grid.lower[axis], axis));
    const whole = scene.grid.size / scene.quantum;
    let smallest = Infinity;
    pen.beginPath();
    for (let i = 0; i < count; i++) {
      if (now.left[i] === HIDDEN) continue;
      const length = codes?.[i] ? valueOf(field.cell_size, codes[i]) / scene.quantum : whole;
      smallest = Math.min(smallest, length);
      const x = Math.floor((now.place[2 * i] - lower[0]) / length), y = Math.floor((now.place[2 * i + 1] - lower[1]) / length);
      const key = `${x},${y},${length}`;
      if (length * view.scale < LEAST_CELL || found.has(key)) continue;
      found.add(key);
      outline(pen, lower[0] + x * length, lower[1] + y * length, length, panel);
    }
    pen.strokeStyle = "rgba(20,20,20,.45)";
    pen.lineWidth = 0.6;
    pen.stroke();
    if (smallest * view.scale < LEAST_CELL) at("hint").textContent = "Zoom in: the smallest cells are too small to be outlined here.";
  }

  function outline(pen, x, y, length, panel) {
    for (const low of scene.mirrored ? [x, 2 * axisAt - x - length] : [x]) {
      const [left, one] = screenOf(low, y, panel), [right, two] = screenOf(low + length, y + length, panel);
      if (right < 0 || left > size().wide || Math.max(one, two) < 0 || Math.min(one, two) > size().high) continue;
      pen.rect(left, Math.min(one, two), right - left, Math.abs(two - one));
    }
  }

  const halfEdges = i => {
    const part = scene.shapeUnit * scene.largest / scene.quantum * sizes[i];
    return [0, 1, 2, 3].map(k => now.shape[4 * i + k] * part);
  };

  function drawHit(pen, panel) {
    const i = view.hit, [ax, ay, bx, by] = halfEdges(i), x = now.place[2 * i], y = now.place[2 * i + 1];
    for (const mirror of scene.mirrored ? [-1, 1] : [1]) {
      const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1], [1, -1]].map(([u, v]) => {
        const across = x + u * ax + v * bx;
        return screenOf(mirror < 0 ? 2 * axisAt - across : across, y + u * ay + v * by, panel);
      });
      line(pen, corners, "white", 3);
      line(pen, corners, "black", 1.2);
    }
  }

  // ---- values under the mouse ----

  function particleAt(x, y) {
    const place = placeAt(x, y), px = scene.mirrored && place.x < axisAt ? 2 * axisAt - place.x : place.x;
    for (let k = blocks.length - 1; k >= 0; k--) {
      const {first, count: instances} = blocks[k];
      for (let i = first + instances - 1; i >= first; i--) {
        if (now.left[i] === HIDDEN) continue;
        const dx = px - now.place[2 * i], dy = place.y - now.place[2 * i + 1];
        const far = 9.2 * scene.largest / scene.quantum * sizes[i];
        if (Math.abs(dx) > far || Math.abs(dy) > far) continue;
        const [ax, ay, bx, by] = halfEdges(i), area = ax * by - ay * bx;
        if (Math.abs(dx * by - dy * bx) <= Math.abs(area) && Math.abs(ax * dy - ay * dx) <= Math.abs(area) && area) return i;
      }
    }
    return -1;
  }

  function fieldText(one, code) {
    if (one.classes) return code ? one.classes[code - 1] : "not known of this material";
    if (!code) return "not of this material";
    return `${withSlack(valueOf(one, code) / one.size, slackOf(one, code) / one.size)} ${one.unit}`.trim();
  }

  function values(i) {
    const mm = axis => toMetres(now.place[2 * i + axis], axis) / MILLI, slack = 0.5 * scene.quantum / MILLI;
    const lines = [["particle", i < 0 ? "" : String(numbers[i])], ["material", i < 0 ? "" : names[material[i] - 1]],
      ["state", i < 0 ? "" : fieldText(field.state, now.state[i])]];
    for (const name of new Set([view.left, view.right])) {
      if (name === "material" || name === "state") continue;
      lines.push([field[name].words, i < 0 ? "" : fieldText(field[name], rows[name](view.step)[i])]);
    }
    lines.push([scene.across, i < 0 ? "" : `${withSlack(mm(0), slack)} mm`], ["y", i < 0 ? "" : `${withSlack(mm(1), slack)} mm`]);
    return lines;
  }

  function hover() {
    if (!view.right) return;  // not all is there yet
    const before = view.hit;
    view.hit = view.mouse ? particleAt(...view.mouse) : -1;
    at("values").tBodies[0].replaceChildren(...values(view.hit).map(([name, value]) => {
      const row = document.createElement("tr");
      row.append(Object.assign(document.createElement("th"), {textContent: name}),
        Object.assign(document.createElement("td"), {textContent: value || "\u2013"}));
      return row;
    }));
    if (before !== view.hit) drawMarks();
  }

  // ---- bar of colours ----

  function drawBar(bar, one) {
    bar.replaceChildren(Object.assign(shown(one.label), {className: "explore-label"}));
    if (one.classes) {
      const list = document.createElement("ul");
      list.append(...one.classes.map((name, i) => {
        const item = document.createElement("li"), box = document.createElement("i");
        box.style.background = one.colours[i];
        item.append(box, shown(name));
        return item;
      }));
      bar.append(list);
      return;
    }
    const strip = document.createElement("div"), colours = one.palette.match(/.{6}/g);
    strip.className = "explore-strip";
    strip.style.background = `linear-gradient(to top, ${colours.map(six => `#${six}`).join(",")})`;
    const put = (value, words, kind) => {
      const part = share(one, value), mark = Object.assign(shown(words), {className: kind});
      if (!(part > -0.001 && part < 1.001)) return;
      mark.style.bottom = `${100 * part}%`;
      strip.append(mark);
    };
    const [low, high] = one.limits.map(value => value / one.size);
    const few = one.doubling && one.scale.table && one.scale.table.length <= 8 ? one.scale.table.map(value => value / one.size) : null;
    for (const value of few ?? ticksBetween(low, high, 6)) put(value * one.size, Number(value.toPrecision(4)), "explore-tick");
    for (const {value, materials} of one.initial) put(value, `at the start: ${materials.join(", ")}`, "explore-start");
    bar.append(strip, Object.assign(shown("grey: not of this material"), {className: "explore-small"}));
  }

  // ---- switches ----

  function addSwitch(label, on, colour, change) {
    const box = Object.assign(document.createElement("input"), {type: "checkbox", checked: on});
    const whole = document.createElement("label"), swatch = document.createElement("i");
    box.addEventListener("change", () => { change(box.checked); redraw(); });
    whole.append(box);
    if (colour) { swatch.style.background = colour; whole.append(swatch); }
    whole.append(shown(label));
    at("switches").append(whole);
    return box;
  }

  function addSwitches() {
    for (const {kind, name, colour, jet} of [...blocks].reverse()) {
      addSwitch(jet ? `jet (${name})` : name, true, colour, on => {
        if (on) hidden.delete(kind); else hidden.add(kind);
        paint("left");
        paint("right");
      });
    }
    addSwitch("outlines of materials", outlines, null, on => { outlines = on; });
    addSwitch("outlines of particles", edges, null, on => { edges = on; });
    if (scene.grid) addSwitch("outlines of cells", cells, null, async on => {
      if (field.cell_size) await rowsOf("cell_size");
      cells = on;
      redraw();
    });
  }

  // ---- curves ----

  const INK = ["#1f4e79", "#c0392b", "#2e7d32"];

  function addCurves() {
    for (const {title, time, curves} of scene.plots) {
      const box = document.createElement("div");
      at("curves").append(box);
      const chart = new window.uPlot({
        width: box.clientWidth || 300, height: 148, title, cursor: {drag: {x: false, y: false}, points: {size: 5}},
        legend: {live: true}, scales: {x: {time: false}},
        axes: [{size: 26, font: "11px sans-serif", space: 40, values: (_, ticks) => ticks}, {size: 46, font: "11px sans-serif", space: 24}],
        series: [{label: "t [µs]"}, ...curves.map(({name}, i) => ({label: name, stroke: INK[i % 3], width: 1.4, points: {show: false}}))],
      }, [time, ...curves.map(one => one.values)], box);
      const marker = Object.assign(document.createElement("div"), {className: "explore-now"});
      marker.move = when => { marker.style.left = `${chart.valToPos(when, "x")}px`; marker.dataset.time = when; };
      chart.over.append(marker);
      chart.over.addEventListener("click", event => setStep(nearest(chart.posToVal(event.offsetX, "x") * MICRO)));
      new ResizeObserver(() => {
        chart.setSize({width: box.clientWidth, height: 148});
        marker.move(scene.times[view.step] / MICRO);
      }).observe(box);
    }
  }

  const nearest = time => scene.times.reduce((best, one, i) => Math.abs(one - time) < Math.abs(scene.times[best] - time) ? i : best, 0);

  // ---- mouse and keys ----

  function play(on) {
    clearInterval(playing);
    playing = on ? setInterval(() => setStep((view.step + 1) % scene.times.length), PLAY_PAUSE) : null;
    at("play").textContent = on ? "Stop" : "Play";
  }

  function listen() {
    const step = by => { play(false); setStep(view.step + by); };
    const keys = {ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => step(-1e9), End: () => step(1e9),
      " ": () => play(!playing), "+": () => zoom(1.4), "-": () => zoom(1 / 1.4), "0": goWhole, t: () => tip()};
    const tip = () => { follow(true); goToTip(); redraw(); };
    at("time").max = scene.times.length - 1;
    at("time").addEventListener("input", () => { play(false); setStep(Number(at("time").value)); });
    at("play").addEventListener("click", () => play(!playing));
    at("back").addEventListener("click", () => step(-1));
    at("on").addEventListener("click", () => step(1));
    at("whole").addEventListener("click", goWhole);
    at("tip").addEventListener("click", tip);
    at("tip").disabled = scene.tips.every(one => one === null);
    at("in").addEventListener("click", () => zoom(1.4));
    at("out").addEventListener("click", () => zoom(1 / 1.4));
    for (const side of ["left", "right"]) at(side).addEventListener("change", () => setField(side, at(side).value));
    document.addEventListener("keydown", event => {
      if (event.ctrlKey || event.altKey || event.metaKey || /^(SELECT|INPUT|TEXTAREA|BUTTON)$/.test(event.target.tagName)) return;
      if (!keys[event.key]) return;
      if (/^(Home|End| )$/.test(event.key) && event.target !== stage) return;  // these scroll the page
      event.preventDefault();
      keys[event.key]();
    });
    let held = null;
    stage.addEventListener("pointerdown", event => {
      held = [event.clientX, event.clientY];
      stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener("pointerup", () => { held = null; });
    stage.addEventListener("pointermove", event => {
      const box = stage.getBoundingClientRect();
      view.mouse = [event.clientX - box.left, event.clientY - box.top];
      if (held && (event.clientX !== held[0] || event.clientY !== held[1])) {
        view.x -= (event.clientX - held[0]) / view.scale;
        view.y += flip * (event.clientY - held[1]) / view.scale;
        held = [event.clientX, event.clientY];
        follow(false);
        redraw();
      } else hover();
    });
    stage.addEventListener("pointerleave", () => { view.mouse = null; hover(); });
    stage.addEventListener("wheel", event => {
      const box = stage.getBoundingClientRect();
      event.preventDefault();
      zoom(1.0015 ** -event.deltaY, event.clientX - box.left, event.clientY - box.top);
    }, {passive: false});
    canvas.addEventListener("webglcontextlost", () => say("The browser has stopped drawing the particles; load the page again."));
    new ResizeObserver(redraw).observe(stage);
  }

  for (const side of ["left", "right"]) at(side).append(...scene.fields.map(one =>
    Object.assign(document.createElement("option"), {value: one.name, textContent: one.words})));
  buffers.size.subdata(sizes);
  at("cut").textContent = scene.cut ? "In three dimensions the view is the cut of the pictures below." : "";
  document.getElementById("explore").hidden = false;
  addSwitches();
  addCurves();
  await setField("left", scene.left);
  await setField("right", scene.right);
  listen();
  setStep(scene.times.length - 1);
  goWhole();
}

async function run() {
  const scene = JSON.parse(document.getElementById("explore-data").textContent);
  for (const one of scene.fields) one.words = one.label.replace(/ \[.*\]$/, "");
  if (typeof DecompressionStream === "undefined") return say("This browser is too old for the view to explore; the pictures below need no scripts.");
  const trial = document.createElement("canvas").getContext("webgl");
  if (!trial || !trial.getExtension("ANGLE_instanced_arrays"))
    return say("This browser has no WebGL, which the view to explore needs; the pictures below are the same without it.");
  trial.getExtension("WEBGL_lose_context")?.loseContext();
  await start(scene);
}

run().catch(error => {
  document.getElementById("explore").hidden = true;
  say("The view to explore could not be shown; the pictures below are complete.");
  console.error(error);
});
})();
