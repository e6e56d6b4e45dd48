// SPDX-License-Identifier: BSD-3-Clause
// Bars of colours.

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
  strip.style.setProperty("--colours", colours.map(six => `#${six}`).join(","));
  const put = (value, words, kind) => {
    const part = share(one, value, limits), mark = Object.assign(shown(words), {className: kind});
    if (!(part > -0.001 && part < 1.001)) return;
    mark.style.setProperty("--part", `${100 * part}%`);
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
  if (one.lacking.length) notes.push(small(`grey: without this field (${one.lacking.join(", ")})`));
  bar.append(strip, ...notes);
}
