// SPDX-License-Identifier: BSD-3-Clause
// Lines above the particles: axis, lengths, cells, the particle under the mouse.

const LEAST_CELL = 3;  // pixels

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
    if (option.cells) drawCells(pen, panel);
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
    if (x > left + 50 && x < left + wide - 62) text(Number(Math.abs(scene.mirrored ? value : NaN) || value), x, high - 9);
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
  for (const [colour, width] of [["rgba(255,255,255,.35)", 1.6], ["rgba(20,20,20,.5)", 0.6]]) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }
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
