// SPDX-License-Identifier: BSD-3-Clause
// Switches, buttons, mouse and keys.

const PLAY_PAUSE = 160;  // ms from one output to the next

let playing = null;

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
  if (scene.loose) addSwitch("rubble", true, scene.rubbleColour, on => {
    if (on) hidden.delete(rubble); else hidden.add(rubble);
  });
  if (scene.measured) addSwitch(scene.measured.name, true, scene.measured.colour, on => { option.measured = on; });
  at("switches").append(shown("outlines of"));
  addSwitch("materials", option.outlines, null, on => { option.outlines = on; });
  addSwitch("particles", option.edges, null, on => { option.edges = on; });
  if (scene.grid) addSwitch("cells", option.cells, null, async on => {
    if (field.cell_size) await rowsOf("cell_size");
    option.cells = on;
    redraw();
  });
  if (scene.loose || blocks.some(one => one.jet)) addSwitch("plain jet and rubble", option.plain, null, on => {
    option.plain = on;
    paint("left");
    paint("right");
  });
  addSwitch("colours of the view", option.fitted, null, on => {
    option.fitted = on;
    for (const side of ["left", "right"]) {
      view.limits[side] = undefined;
      drawBar(side);
      paint(side);
    }
  });
}

function play(on) {
  clearInterval(playing);
  playing = on ? setInterval(() => setStep((view.step + 1) % scene.times.length), PLAY_PAUSE) : null;
  at("play").textContent = on ? "Stop" : "Play";
}

function listen() {
  const step = by => { play(false); setStep(view.step + by); };
  const keys = {ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => step(-1e9), End: () => step(1e9),
    " ": () => play(!playing), "+": () => zoom(1.4), "-": () => zoom(1 / 1.4), "0": goWhole, h: goToHole, t: () => tip()};
  const tip = () => { follow(true); goToTip(); redraw(); };
  at("time").max = scene.times.length - 1;
  at("time").addEventListener("input", () => { play(false); setStep(Number(at("time").value)); });
  at("play").addEventListener("click", () => play(!playing));
  at("back").addEventListener("click", () => step(-1));
  at("on").addEventListener("click", () => step(1));
  at("whole").addEventListener("click", goWhole);
  at("hole").addEventListener("click", goToHole);
  at("hole").disabled = !scene.hole;
  at("tip").addEventListener("click", tip);
  at("tip").disabled = scene.tips.every(one => one === null);
  at("in").addEventListener("click", () => zoom(1.4));
  at("out").addEventListener("click", () => zoom(1 / 1.4));
  for (const side of ["left", "right"]) at(side).addEventListener("change", () => setField(side, at(side).value));
  document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
    if (event.target.tagName === "SELECT" || event.target.type === "range") return;  // have arrow keys of their own
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
      const [across, along] = turnedBack(event.clientX - held[0], event.clientY - held[1]);
      view.x -= across;
      view.y -= along;
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
