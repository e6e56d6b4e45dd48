// SPDX-License-Identifier: BSD-3-Clause
// Curves against time, with a line at the output that is shown.

const INK = ["#1f4e79", "#c0392b", "#2e7d32"];
const DASHES = [[], [6, 5], [2, 4]];  // curves that coincide, as depth and open channel, are all seen

function addCurves() {
  for (const {title, time, curves} of scene.plots) {
    const [whole, head, box] = ["div", "div", "div"].map(kind => document.createElement(kind));
    head.className = "explore-curve";
    whole.append(head, box);
    at("curves").append(whole);
    const chart = new window.uPlot({
      width: box.clientWidth || 300, height: 112, cursor: {drag: {x: false, y: false}, points: {size: 5}},
      legend: {show: false}, scales: {x: {time: false}},
      axes: [{size: 26, font: "11px sans-serif", space: 40, values: (_, ticks) => ticks}, {size: 46, font: "11px sans-serif", space: 24,
        values: (_, ticks) => ticks.map(one => String(Number(one.toPrecision(3))))}],
      series: [{label: "t [µs]"}, ...curves.map(({name}, i) => ({
        label: name, stroke: INK[i % 3], dash: DASHES[i % 3], width: 1.4, points: {show: false},
      }))],
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
