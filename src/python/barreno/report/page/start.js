// SPDX-License-Identifier: BSD-3-Clause
// Reads the data and shows the view; where a browser cannot, the page says so.

async function start() {
  field = Object.fromEntries(scene.fields.map(one => [one.name, one]));
  const {there, places, shapes} = scene, codes = [field.material.codes, field.state.codes];
  const tables = [scene.numbers, scene.sizes, there, scene.rubble, places, shapes, ...codes];
  const [numberRow, sizeRow, ...others] = await Promise.all(tables.map(unpacked));
  [thereRow, rubbleRow, placeRow, shapeRow, rows.material, rows.state] = others;
  stateRow = rows.state;
  numbers = numberRow(0);
  sizes = sizeRow(0);
  material = rows.material(0);
  count = numbers.length;
  names = field.material.classes;
  blocks = blocksOf(material, names.length);
  rubble = names.length + 1;
  lineOf = linesBetween();
  axisAt = scene.mirrored ? toQuantum(0, 0) : 0;
  panels = scene.mirrored ? 1 : 2;
  lying = scene.lying;
  forward = lying ? (scene.up ? -1 : 1) : (scene.down ? 1 : -1);
  [canvas, marks, stage] = ["particles", "marks", "stage"].map(at);
  for (const side of ["left", "right"]) at(side).append(...scene.fields.map(one =>
    Object.assign(document.createElement("option"), {value: one.name, textContent: one.words})));
  at("cut").textContent = scene.cut ? "In three dimensions the view is the cut of the pictures below." : "";
  for (const [side, where] of lying ? [["left", "above"], ["right", "below"]] : []) at(`side-${side}`).textContent = where;
  document.getElementById("explore").classList.toggle("explore-lying", lying);
  document.getElementById("explore").hidden = false;
  addSwitches();
  addCurves();
  await setField("left", scene.left);
  await setField("right", scene.right);
  listen();
  setStep(scene.times.length - 1);
  if (lying && scene.hole) goToHole(); else goWhole();
}

async function run() {
  scene = JSON.parse(document.getElementById("explore-data").textContent);
  for (const one of scene.fields) one.words = one.label.replace(/( \[|:).*$/, "");
  if (typeof DecompressionStream === "undefined")
    return say("This browser is too old for the view to explore; the pictures below are complete.");
  if (!document.createElement("canvas").getContext("2d"))
    return say("This browser lets no page draw, which the view to explore needs; the pictures below are complete.");
  await start();
}

run().catch(error => {
  document.getElementById("explore").hidden = true;
  say("The view to explore could not be shown; the pictures below are complete.");
  console.error(error);
});
