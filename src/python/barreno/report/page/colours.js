// SPDX-License-Identifier: BSD-3-Clause
// Colours of values.

const WITHOUT = 0xffbfbfbf;  // colour of a material that lacks the field
const EDGE = 0.72;  // shade of outlines of particles

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
