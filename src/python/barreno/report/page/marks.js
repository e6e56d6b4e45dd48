// SPDX-License-Identifier: BSD-3-Clause
// Lines above the particles: axis, lengths, cells, the particle under the mouse.

const LEAST_CELL = 3;  // pixels

function drawMarks() {
  const {wide, high} = size(), pen = marks.getContext("2d");
  pen.setTransform(picture.dense, 0, 0, picture.dense, 0, 0);
  pen.clearRect(0, 0, wide, high);
  at("hint").textContent = "";
  marks.setAttribute("aria-label", `${nameOf(0)}; ${nameOf(1)}`);
  for (let panel = 0; panel < panels; panel++) {
    pen.save();
    pen.beginPath();
    pen.rect(...boxOf(panel));
    pen.clip();
    if (option.cells) drawCells(pen, panel);
    if (scene.mirrored) drawAxis(pen);
    if (scene.measured && option.measured) drawMeasured(pen, panel);
    if (view.hit >= 0) drawHit(pen, panel);
    drawTicks(pen, panel);
    pen.restore();
  }
  const [left, top] = boxOf(1);
  if (panels === 2) line(pen, lying ? [[0, top], [wide, top]] : [[left, 0], [left, high]], "#555", 1);
}

function boxOf(panel) {
  const {wide, high} = panelSize();
  return lying ? [0, panel * high, wide, high] : [panel * wide, 0, wide, high];
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
  const {wide, high} = size(), [x, y] = screenOf(axisAt, 0);
  line(pen, lying ? [[0, y], [wide, y]] : [[x, 0], [x, high]], "rgba(0,0,0,.55)", 1);
  pen.setLineDash([]);
}

// A measured hole as dashes on both sides of its axis.
function drawMeasured(pen, panel) {
  const {wall, colour} = scene.measured;
  pen.setLineDash([6, 3]);
  for (const side of [-1, 1])
    line(pen, wall.map(([r, y]) => screenOf(toQuantum(side * r, 0), toQuantum(y, 1), panel)), colour, 1.6);
  pen.setLineDash([]);
}

function write(pen, words, x, y, align = "left") {
  pen.textAlign = align;
  pen.strokeStyle = "rgba(255,255,255,.85)";
  pen.lineWidth = 3;
  pen.strokeText(words, x, y);
  pen.fillStyle = "#222";
  pen.fillText(words, x, y);
}

const nameOf = axis => {
  const stretch = axis === 0 ? stretchNow() : 1, larger = Number(stretch.toPrecision(2));
  return `${axis === 0 ? scene.across : "y"} [mm]${larger > 1 ? `, ${larger} times larger than y` : ""}`;
};

// Lengths in mm along the lower edge of a panel and along the left one: across y and along y, or in a lying view the other way round.
function drawTicks(pen, panel) {
  const [left, top, wide, high] = boxOf(panel), right = left + wide, bottom = top + high, [flat, steep] = lying ? [1, 0] : [0, 1];
  const ends = [placeAt(left + 1, bottom - 1), placeAt(right - 1, top + 1)].map(({x, y}) => [x, y]);
  const values = (axis, most) => {
    const found = ends.map(one => toMetres(one[axis], axis) / MILLI);
    return ticksBetween(Math.min(...found), Math.max(...found), Math.max(2, most));
  };
  const spot = (value, axis) => screenOf(axis === 0 ? toQuantum(value * MILLI, 0) : 0, axis === 1 ? toQuantum(value * MILLI, 1) : 0, panel);
  const number = (value, axis) => String(axis === 0 && scene.mirrored ? Math.abs(value) : value);
  pen.font = "11px sans-serif";
  const name = nameOf(flat), room = pen.measureText(name).width + 25;
  for (const value of values(flat, wide / 90)) {
    const [x] = spot(value, flat);
    line(pen, [[x, bottom], [x, bottom - 6]], "#222", 1);
    if (x > left + 50 && x < right - room) write(pen, number(value, flat), x, bottom - 9, "center");
  }
  for (const value of values(steep, high / (lying ? 45 : 70))) {
    const [, y] = spot(value, steep);
    line(pen, [[left, y], [left + 6, y]], "#222", 1);
    if (y > top + 26 && y < bottom - 24) write(pen, number(value, steep), left + 9, y + 4);
  }
  write(pen, nameOf(steep), left + 6, top + 14);
  write(pen, name, right - 6, bottom - 9, "right");
}

// Cells of the grid in which particles are, each of its own size.
function drawCells(pen, panel) {
  const found = new Set(), codes = rows.cell_size?.(view.step), lower = [0, 1].map(axis => toQuantum(scene.grid.lower[axis], axis));
  const whole = scene.grid.size / scene.quantum;
  let smallest = Infinity;
  pen.beginPath();
  for (let i = 0; i < count; i++) {
    if (!now.there[i] || hidden.has(material[i]) || hidden.has(now.kind[i])) continue;
    const length = codes?.[i] ? valueOf(field.cell_size, codes[i]) / scene.quantum : whole;
    smallest = Math.min(smallest, length);
    const x = Math.floor((now.place[2 * i] - lower[0]) / length), y = Math.floor((now.place[2 * i + 1] - lower[1]) / length);
    const key = `${x},${y},${length}`;
    if (length * view.scale < LEAST_CELL || found.has(key)) continue;
    found.add(key);
    outline(pen, lower[0] + x * length, lower[1] + y * length, length, panel);
  }
  for (const [colour, width] of [["rgba(255,255,255,.35)", 1.6], ["rgba(20,20,20,.5)", 0.6]]) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }
  if (smallest * view.scale < LEAST_CELL) at("hint").textContent = "Zoom in: the smallest cells are too small to be outlined here.";
}

function outline(pen, x, y, length, panel) {
  const {wide, high} = size();
  for (const low of scene.mirrored ? [x, 2 * axisAt - x - length] : [x]) {
    const [left, one] = screenOf(low, y, panel), [right, two] = screenOf(low + length, y + length, panel);
    if (Math.max(left, right) < 0 || Math.min(left, right) > wide || Math.max(one, two) < 0 || Math.min(one, two) > high) continue;
    pen.rect(Math.min(left, right), Math.min(one, two), Math.abs(right - left), Math.abs(two - one));
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
