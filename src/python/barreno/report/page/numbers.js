// SPDX-License-Identifier: BSD-3-Clause
// Whole numbers as explore/codes.py packs them, and the values of their codes.

const ARRAYS = {u8: Uint8Array, i8: Int8Array, u16: Uint16Array, u32: Uint32Array};
const WHOLE = {u8: Uint8Array, i8: Uint8Array, u16: Uint16Array, u32: Uint32Array};

async function inflated(text) {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function joined(bytes, from, count, kind) {
  const found = new WHOLE[kind](count), wide = found.BYTES_PER_ELEMENT;
  for (let plane = 0; plane < wide; plane++)
    for (let i = 0; i < count; i++) found[i] += bytes[from + plane * count + i] * 2 ** (8 * plane);
  return found;
}

// Rows of a table of whole numbers: the first, and what columns that ever change have in the others.
async function unpacked(packed) {
  const bytes = await inflated(packed.data), {type, rows, columns, changed} = packed;
  const index = new Uint32Array(changed), mask = Math.ceil(columns / 8);
  for (let i = 0, k = 0; i < columns; i++) if (bytes[i >> 3] >> (i & 7) & 1) index[k++] = i;
  const first = joined(bytes, mask, columns, type), wide = first.BYTES_PER_ELEMENT;
  const later = joined(bytes, mask + wide * columns, (rows - 1) * changed, type);
  for (let k = 0; k < later.length; k++) later[k] += k < changed ? first[index[k]] : later[k - changed];  // modulo the type
  const out = new ARRAYS[type](columns);
  const plain = new WHOLE[type](out.buffer);
  return row => {
    plain.set(first);
    if (row > 0 && rows > 1) for (let k = 0, from = (row - 1) * changed; k < changed; k++) plain[index[k]] = later[from + k];
    return out;
  };
}

// The equation of explore/codes.py.
function valueOf(field, code) {
  if (!code) return NaN;
  const {table, middle, width, step, zero} = field.scale;
  return table ? table[code - 1] : middle + width * Math.sinh(step * (code - zero));
}

// Greatest difference between a code's value and one that has the code.
function slackOf(field, code) {
  if (!code || field.scale.table) return 0;
  const value = valueOf(field, code);
  return Math.max(valueOf(field, code + 0.5) - value, value - valueOf(field, code - 0.5));
}

// Number and the greatest difference from the value in the file, the rounding of both for reading included.
function withSlack(value, slack) {
  if (!(slack > 0)) return Number(value.toPrecision(6)).toString();
  const digits = 1 - Math.floor(Math.log10(slack)), rest = Math.max(0, Math.min(12, digits));
  const unit = 10 ** -rest, most = Math.ceil((slack + 0.5 * unit) / unit - 1e-9) * unit;
  const large = Math.abs(value) >= 1e6 || rest > 6;
  return large ? `${value.toExponential(3)} ± ${(slack + Math.abs(value) * 5e-4).toExponential(1)}`
    : `${value.toFixed(rest)} ± ${most.toFixed(rest)}`;
}

const timeText = time => `t = ${Number((time / MICRO).toPrecision(4))} µs`;

function ticksBetween(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= rough * 0.999);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(Number((k * step).toPrecision(10)));
  return found;
}
