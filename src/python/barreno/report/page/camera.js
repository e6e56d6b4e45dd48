// SPDX-License-Identifier: BSD-3-Clause
// Where the view looks. In an upright view lengths along y run down the stage or up; in a lying view along it. A lying view may draw
// lengths across y larger than lengths along y, so that a long narrow hole can be seen.

const FILLED = 0.94;  // of the stage, by what is looked at
const STRETCHES = [12, 10, 8, 6, 5, 4, 3, 2, 1.5];

const size = () => ({wide: stage.clientWidth, high: stage.clientHeight});

function panelSize() {
  const {wide, high} = size();
  return lying ? {wide, high: high / panels} : {wide: wide / panels, high};
}

function extent() {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let i = 0; i < count; i++) for (let axis = 0; now.there[i] && axis < 2; axis++) {
    const value = now.place[2 * i + axis];
    low[axis] = Math.min(low[axis], value);
    high[axis] = Math.max(high[axis], value);
  }
  if (!(high[0] >= low[0])) return {low: [0, 0], high: [65535, 65535]};
  const half = scene.largest / scene.quantum * sizes.reduce((most, one) => Math.max(most, one), 0);
  for (const axis of [0, 1]) [low[axis], high[axis]] = [low[axis] - half, high[axis] + half];
  return {low: scene.mirrored ? [2 * axisAt - high[0], low[1]] : low, high};
}

// The part of the plane from low to high fills the stage; a lying view is stretched where that is asked for and there is room.
function lookAt(low, high, stretched = false) {
  const panel = panelSize(), room = lying ? [panel.high, panel.wide] : [panel.wide, panel.high];
  const [across, along] = [0, 1].map(axis => FILLED * room[axis] / Math.max(high[axis] - low[axis], 1));
  view.x = 0.5 * (low[0] + high[0]);
  view.y = 0.5 * (low[1] + high[1]);
  view.scale = Math.min(across, along);
  const stretch = stretched && lying ? STRETCHES.find(one => one <= across / view.scale) ?? 1 : 1;
  view.rest = {scale: view.scale, stretch};
}

// How many times larger than along y lengths across y are drawn: closer than the whole, less and less, until proportions are true.
function stretchNow() {
  const {scale, stretch} = view.rest;
  return Math.max(1, Math.min(stretch, stretch * scale / view.scale));
}

function goWhole() {
  const {low, high} = extent();
  lookAt(low, high, true);
  follow(false);
  redraw();
}

function goToHole() {
  if (!scene.hole) return;
  const [low, high] = [0, 1].map(end => scene.hole.map((ends, axis) => toQuantum(ends[end], axis)));
  lookAt(low, high, true);
  follow(false);
  redraw();
}

function goToTip() {
  const tip = scene.tips[view.step];
  if (tip === null) return;
  const reach = scene.around / scene.quantum, y = toQuantum(tip, 1), x = scene.mirrored ? axisAt : toQuantum(0, 0);
  const along = scene.down || scene.tips.some(one => one > tip) ? 1 : -1, beside = (lying ? 8 : 14) * reach;
  lookAt([x - beside, y - (along > 0 ? 16 : 10) * reach], [x + beside, y + (along > 0 ? 10 : 16) * reach]);
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

function panelAt(x, y) {
  const {wide, high} = panelSize();
  return Math.min(panels - 1, Math.max(0, Math.floor(lying ? y / high : x / wide)));
}

function middleOf(panel) {
  const {wide, high} = panelSize();
  return lying ? [0.5 * wide, (panel + 0.5) * high] : [(panel + 0.5) * wide, 0.5 * high];
}

// A step across y and a step along y on the screen, in pixels.
function turned(across, along) {
  const wide = across * view.scale * stretchNow(), deep = along * view.scale * forward;
  return lying ? [deep, wide] : [wide, deep];
}

function turnedBack(right, down) {
  const [wide, deep] = lying ? [down, right] : [right, down];
  return [wide / (view.scale * stretchNow()), deep * forward / view.scale];
}

function placeAt(x, y) {
  const [middleX, middleY] = middleOf(panelAt(x, y)), [across, along] = turnedBack(x - middleX, y - middleY);
  return {x: view.x + across, y: view.y + along};
}

function screenOf(x, y, panel = 0) {
  const [middleX, middleY] = middleOf(panel), [right, down] = turned(x - view.x, y - view.y);
  return [middleX + right, middleY + down];
}
