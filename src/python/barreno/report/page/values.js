// SPDX-License-Identifier: BSD-3-Clause
// Values of the particle under the mouse.

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
  const made = i < 0 ? "" : names[material[i] - 1] + (now.kind[i] === rubble ? ", rubble" : "");
  const lines = [["particle", i < 0 ? "" : String(numbers[i])], ["material", made],
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
