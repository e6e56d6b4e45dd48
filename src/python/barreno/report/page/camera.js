// SPDX-License-Identifier: BSD-3-Clause
// Where the view looks.

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
  const half = scene.largest / scene.quantum * sizes.reduce((most, one) => Math.max(most, one), 0);
  for (const axis of [0, 1]) [low[axis], high[axis]] = [low[axis] - half, high[axis] + half];
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
