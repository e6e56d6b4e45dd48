// SPDX-License-Identifier: BSD-3-Clause
// The explorable view of a report's page (docs/report.md). The data are the JSON that explore.py writes: whole numbers, packed by
// explore_codes.py. Particles are drawn into a table of pixels, each with the number of the particle that it shows: outlines and the values
// under the mouse follow from it, and no graphics card is needed. uPlot draws the curves.
(() => {
"use strict";

const MILLI = 1e-3, MICRO = 1e-6;
const WITHOUT = 0xffbfbfbf;  // colour of a material that lacks the field
const PLAY_PAUSE = 160;  // ms from one output to the next
const OVERLAP = 1.02;  // shapes are rounded; the seams between neighbours are covered
const MOST_PIXELS = 2e6;  // beyond, screens with small pixels are drawn coarser
const VOID = 0xfff1ebe3;  // colour where no particle is: alpha, blue, green, red
const EDGE = 0.72;  // shade of outlines of particles
const LEAST_EDGED = 4;  // pixels: particles with an outline
const LEAST_CELL = 3;  // pixels
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

function share(field, value, [low, high] = field.limits) {
  if (field.doubling) return value > 0 ? Math.log(value / low) / Math.log(high / low) : NaN;
  return (value - low) / (high - low);
}

// Colours of a field's codes from 1 on as pixels; 0 has none.
function paletteOf(field) {
  const colours = field.classes ? field.colours : field.palette.match(/.{6}/g).map(six => `#${six}`);
  return Uint32Array.from([WITHOUT, ...colours.map(pixelOf)]);
}

function pixelOf(colour) {
  const [red, green, blue] = [1, 3, 5].map(i => parseInt(rgb(colour).slice(i, i + 2), 16));
  return (255 << 24 | blue << 16 | green << 8 | red) >>> 0;
}

function shaded(pixel) {
  const part = shift => Math.round(EDGE * (pixel >> shift & 255)) << shift;
  return (255 << 24 | part(16) | part(8) | part(0)) >>> 0;
}

// Colours by name as six digits.
function rgb(colour) {
  const pen = document.createElement("canvas").getContext("2d");
  pen.fillStyle = colour;
  return pen.fillStyle;
}

// Number in the palette of every code.
function coloursOf(field, limits) {
  if (field.classes) return code => code;
  const known = new Map();
  const colour = code => {
    const part = share(field, valueOf(field, code), limits);
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

// Writes a number into the pixels whose centres a parallelogram covers, or into the one that has its centre.
function fill(ids, wide, high, number, [x, y, ax, ay, bx, by], from, to) {
  const reachX = Math.abs(ax) + Math.abs(bx), reachY = Math.abs(ay) + Math.abs(by);
  if (x + reachX < from || x - reachX > to || y + reachY < 0 || y - reachY > high) return;
  const first = Math.max(0, Math.ceil(y - reachY - 0.5)), last = Math.min(high - 1, Math.floor(y + reachY - 0.5));
  const area = ax * by - ay * bx;
  let drawn = false;
  for (let row = first; row <= last; row++) {
    const dy = row + 0.5 - y;
    // Of the distance dx across: |dx by - dy bx| <= |area| and |dy ax - dx ay| <= |area|.
    let low = -reachX, up = reachX;
    for (const [slope, shift] of [[by, dy * bx], [ay, dy * ax]]) {
      const size = Math.abs(area);
      if (Math.abs(slope) > 1e-9) {
        const one = (shift - size) / slope, other = (shift + size) / slope;
        low = Math.max(low, Math.min(one, other));
        up = Math.min(up, Math.max(one, other));
      } else if (Math.abs(shift) > size) up = -Infinity;
    }
    const end = Math.min(to - 1, Math.floor(x + up - 0.5));
    for (let column = Math.max(from, Math.ceil(x + low - 0.5)); column <= end; column++) {
      ids[row * wide + column] = number;
      drawn = true;
    }
  }
  const column = Math.floor(x), row = Math.floor(y);
  if (!drawn && column >= from && column < to && row >= 0 && row < high) ids[row * wide + column] = number;
}

// State of the view; numbers are in steps of the places ("quantum") where not said otherwise.
async function start(scene) {
  const field = Object.fromEntries(scene.fields.map(one => [one.name, one]));
  const [numberRow, thereRow, placeRow, shapeRow, sizeRow, materialRow, stateRow] = await Promise.all([scene.numbers, scene.there,
    scene.places, scene.shapes, scene.sizes, field.material.codes, field.state.codes].map(unpacked));
  const numbers = numberRow(0), sizes = sizeRow(0), material = materialRow(0), count = numbers.length;
  const canvas = at("particles"), marks = at("marks"), stage = at("stage");
  const palettes = {}, picture = {ids: new Int32Array(0), wide: 0, high: 0, dense: 1, axis: 0};
  const rows = {material: materialRow, state: stateRow};
  const names = field.material.classes, blocks = blocksOf(material, names.length);
  const hidden = new Set(), view = {x: 0, y: 0, scale: 1, follow: false, step: 0, left: null, right: null, mouse: null, hit: -1,
    limits: {left: undefined, right: undefined}};
  const now = {there: null, place: null, shape: null, left: null, right: null, state: null};
  const toQuantum = (metres, axis) => (metres - scene.low[axis]) / scene.quantum;
  const toMetres = (quanta, axis) => quanta * scene.quantum + scene.low[axis];
  const axisAt = scene.mirrored ? toQuantum(0, 0) : 0;  // x of the mirror
  const panels = scene.mirrored ? 1 : 2, flip = scene.down ? -1 : 1;
  let pending = false, playing = null, outlines = true, edges = false, cells = false, fitted = false;

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
    const name = view[side], codes = rows[name](view.step), colour = coloursOf(field[name], view.limits[side]);
    const found = new Uint32Array(count), pixels = palettes[side];
    for (let i = 0; i < count; i++) found[i] = pixels[colour(codes[i])];
    now[side] = found;
  }

  function setStep(step) {
    view.step = Math.max(0, Math.min(scene.times.length - 1, step));
    now.there = thereRow(view.step);
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
    const {wide, high} = size(), dense = Math.min(window.devicePixelRatio || 1, Math.sqrt(MOST_PIXELS / Math.max(wide * high, 1)));
    const pixels = [Math.max(1, Math.round(wide * dense)), Math.max(1, Math.round(high * dense))];
    for (const one of [canvas, marks]) if (one.width !== pixels[0] || one.height !== pixels[1]) [one.width, one.height] = pixels;
    if (picture.ids.length !== pixels[0] * pixels[1]) picture.ids = new Int32Array(pixels[0] * pixels[1]);
    [picture.wide, picture.high] = pixels;
    picture.dense = dense;
  }

  // Which particle every pixel shows; -1 for none.
  function place() {
    const {ids, wide, high, dense} = picture, zoom = view.scale * dense;
    ids.fill(-1);
    picture.axis = scene.mirrored ? Math.max(0, Math.min(wide, Math.round(screenOf(axisAt, 0)[0] * dense))) : 0;
    const half = Math.round(wide / 2);
    const parts = scene.mirrored ? [[-1, 0, 0, picture.axis], [1, 0, picture.axis, wide]] : [[1, 0, 0, half], [1, 1, half, wide]];
    const unit = OVERLAP * scene.shapeUnit * scene.largest / scene.quantum * zoom;
    for (const [mirror, panel, from, to] of parts) {
      const [x0, y0] = screenOf(mirror < 0 ? 2 * axisAt : 0, 0, panel).map(value => value * dense);
      for (const {kind, first, count: particles} of blocks) {
        if (hidden.has(kind)) continue;
        for (let i = first; i < first + particles; i++) {
          if (!now.there[i]) continue;
          const part = unit * sizes[i], x = x0 + mirror * zoom * now.place[2 * i], y = y0 - flip * zoom * now.place[2 * i + 1];
          fill(ids, wide, high, i, [x, y, mirror * part * now.shape[4 * i], -flip * part * now.shape[4 * i + 1],
            mirror * part * now.shape[4 * i + 2], -flip * part * now.shape[4 * i + 3]], from, to);
        }
      }
    }
  }

  // Colour of the line between two materials, 0 is the void: of the one that is drawn above the other. Pieces of a jet in the hole would
  // be all line, so a jet has one towards other materials alone.
  const kinds = [{kind: 0}, ...blocks];
  const lineOf = Array.from({length: names.length + 1}, () => new Uint32Array(names.length + 1));
  kinds.forEach((one, rank) => kinds.slice(0, rank).forEach(other => {
    if (one.jet && !other.kind) return;
    lineOf[one.kind][other.kind] = lineOf[other.kind][one.kind] = pixelOf(one.colour);
  }));

  // Colours of the pixels, and lines where the next pixel is of another material.
  function colour() {
    const {ids, wide, high, axis} = picture, image = new ImageData(wide, high), pixels = new Uint32Array(image.data.buffer);
    const change = scene.mirrored ? axis : Math.round(wide / 2);
    const part = scene.shapeUnit * scene.largest / scene.quantum * view.scale * picture.dense * 20;
    for (let row = 0, k = 0; row < high; row++) for (let column = 0; column < wide; column++, k++) {
      const id = ids[k], right = column + 1 < wide && column + 1 !== change ? ids[k + 1] : id, below = row + 1 < high ? ids[k + wide] : id;
      pixels[k] = id < 0 ? VOID : (column < change ? now.left : now.right)[id];
      if (id === right && id === below) continue;
      const own = id < 0 ? 0 : material[id], other = right < 0 ? 0 : material[right], under = below < 0 ? 0 : material[below];
      const line = outlines && (lineOf[own][other] || lineOf[own][under]);
      if (line) pixels[k] = line;
      else if (edges && id >= 0 && 2 * part * sizes[id] > LEAST_EDGED) pixels[k] = shaded(pixels[k]);
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
  }

  function draw() {
    fit();
    place();
    closeGaps();
    if (fitted) fitColours();
    colour();
  }

  // Shapes are rounded: a single pixel between two of one material is none of the void.
  function closeGaps() {
    const {ids, wide, high} = picture;
    const same = (one, other) => one >= 0 && other >= 0 && material[one] === material[other];
    for (let row = 1; row < high - 1; row++) for (let k = row * wide + 1; k < row * wide + wide - 1; k++) {
      if (ids[k] >= 0) continue;
      if (same(ids[k - 1], ids[k + 1])) ids[k] = ids[k - 1];
      else if (same(ids[k - wide], ids[k + wide])) ids[k] = ids[k - wide];
    }
  }

  // The range of colours becomes that of most of what is seen.
  function fitColours() {
    const {ids, wide} = picture, change = scene.mirrored ? picture.axis : Math.round(wide / 2);
    for (const side of ["left", "right"]) {
      const one = field[view[side]], codes = one.classes || one.doubling ? null : rows[view[side]](view.step), found = [];
      if (!codes) continue;
      const stride = 1 + Math.floor(ids.length / 20000) | 1;
      for (let k = 0; k < ids.length; k += stride) {
        const own = k % wide < change ? "left" : "right";
        if (ids[k] >= 0 && codes[ids[k]] && (own === side || view.left === view.right)) found.push(valueOf(one, codes[ids[k]]));
      }
      if (found.length < 50) continue;
      found.sort((a, b) => a - b);
      let [low, high] = [0.02, 0.98].map(part => found[Math.floor(part * (found.length - 1))]);
      if (one.neutral !== null) {
        const reach = Math.max(high - one.neutral, one.neutral - low);
        [low, high] = [one.neutral - reach, one.neutral + reach];
      }
      if (!(high - low > 1e-6 * (one.limits[1] - one.limits[0]))) continue;
      view.limits[side] = [low, high];
      drawBar(side);
      paint(side);
    }
  }

  function drawMarks() {
    const {wide, high} = size(), pen = marks.getContext("2d");
    pen.setTransform(picture.dense, 0, 0, picture.dense, 0, 0);
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
    const from = placeAt(left + 1, high - 1), to = placeAt(left + wide - 1, 1);
    const step = (one, two) => [Math.min(one, two), Math.max(one, two)];
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
      if (!now.there[i] || hidden.has(material[i])) continue;
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
    const {ids, wide, high, dense} = picture, column = Math.floor(x * dense), row = Math.floor(y * dense);
    return column >= 0 && column < wide && row >= 0 && row < high ? ids[row * wide + column] : -1;
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

  function drawBar(side) {
    const bar = at(`bar-${side}`), one = field[view[side]], limits = view.limits[side] ?? one.limits;
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
      const part = share(one, value, limits), mark = Object.assign(shown(words), {className: kind});
      if (!(part > -0.001 && part < 1.001)) return;
      mark.style.bottom = `${100 * part}%`;
      strip.append(mark);
    };
    const [low, high] = limits.map(value => value / one.size);
    const few = one.doubling && one.scale.table && one.scale.table.length <= 8 ? one.scale.table.map(value => value / one.size) : null;
    for (const value of few ?? ticksBetween(low, high, 6)) put(value * one.size, Number(value.toPrecision(4)), "explore-tick");
    const small = words => Object.assign(shown(words), {className: "explore-small"});
    const notes = one.initial.map(({value, materials}) => {
      put(value, "", "explore-start");
      return small(`\u2501 at the start ${Number((value / one.size).toPrecision(3))} (${materials.join(", ")})`);
    });
    if (one.lacking.length) notes.push(small(`grey: ${one.lacking.join(", ")} without it`));
    bar.append(strip, ...notes);
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
      });
    }
    at("switches").append(shown("outlines of"));
    addSwitch("materials", outlines, null, on => { outlines = on; });
    addSwitch("particles", edges, null, on => { edges = on; });
    if (scene.grid) addSwitch("cells", cells, null, async on => {
      if (field.cell_size) await rowsOf("cell_size");
      cells = on;
      redraw();
    });
    addSwitch("colours fitted to the view", fitted, null, on => {
      fitted = on;
      for (const side of ["left", "right"]) {
        view.limits[side] = undefined;
        drawBar(side);
        paint(side);
      }
    });
  }

  // ---- curves ----

  const INK = ["#1f4e79", "#c0392b", "#2e7d32"];

  function addCurves() {
    for (const {title, time, curves} of scene.plots) {
      const box = document.createElement("div"), head = document.createElement("div");
      head.className = "explore-curve";
      at("curves").append(head, box);
      const chart = new window.uPlot({
        width: box.clientWidth || 300, height: 112, cursor: {drag: {x: false, y: false}, points: {size: 5}},
        legend: {show: false}, scales: {x: {time: false}},
        axes: [{size: 26, font: "11px sans-serif", space: 40, values: (_, ticks) => ticks}, {size: 46, font: "11px sans-serif", space: 24}],
        series: [{label: "t [µs]"}, ...curves.map(({name}, i) => ({label: name, stroke: INK[i % 3], width: 1.4, points: {show: false}}))],
      }, [time, ...curves.map(one => one.values)], box);
      const marker = Object.assign(document.createElement("div"), {className: "explore-now"});
      marker.move = when => {
        marker.style.left = `${chart.valToPos(when, "x")}px`;
        const heading = Object.assign(shown(`${title} against time [µs]`), {className: "explore-title"});
        head.replaceChildren(heading, ...curves.map(({name, values: known}, i) => {
          const words = shown(`${name} ${valueBetween(time, known, when)}`);
          words.style.color = INK[i % 3];
          return words;
        }));
      };
      chart.over.append(marker);
      chart.over.addEventListener("click", event => setStep(nearest(chart.posToVal(event.offsetX, "x") * MICRO)));
      new ResizeObserver(() => {
        chart.setSize({width: box.clientWidth, height: 112});
        marker.move(scene.times[view.step] / MICRO);
      }).observe(box);
    }
  }

  function valueBetween(time, known, when) {
    let k = time.findIndex(one => one >= when - 1e-9);
    if (k < 0) k = time.length - 1;
    const part = k > 0 ? Math.min(1, Math.max(0, (when - time[k - 1]) / (time[k] - time[k - 1] || 1))) : 1;
    const from = known[Math.max(0, k - 1)], to = known[k];
    if (to === null || (from === null && part < 1)) return "\u2013";
    return Number((part < 1 ? from + part * (to - from) : to).toPrecision(4));
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
    new ResizeObserver(redraw).observe(stage);
  }

  for (const side of ["left", "right"]) at(side).append(...scene.fields.map(one =>
    Object.assign(document.createElement("option"), {value: one.name, textContent: one.words})));
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
  if (typeof DecompressionStream === "undefined")
    return say("This browser is too old for the view to explore; the pictures below are complete.");
  if (!document.createElement("canvas").getContext("2d"))
    return say("This browser lets no page draw, which the view to explore needs; the pictures below are complete.");
  await start(scene);
}

run().catch(error => {
  document.getElementById("explore").hidden = true;
  say("The view to explore could not be shown; the pictures below are complete.");
  console.error(error);
});
})();
