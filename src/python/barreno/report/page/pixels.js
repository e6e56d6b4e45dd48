// SPDX-License-Identifier: BSD-3-Clause
// Particles as a table of pixels: outlines and the values under the mouse follow from it, and no graphics card is needed.

const OVERLAP = 1.02;  // shapes are rounded; the seams between neighbours are covered
const MOST_PIXELS = 2e6;  // beyond, screens with small pixels are drawn coarser
const VOID = 0xfff1ebe3;  // colour where no particle is: alpha, blue, green, red
const LEAST_EDGED = 4;  // pixels: particles with an outline

const HALF = 0.5;  // pixel

let pending = false;

// Writes a number into the pixels of a part whose centres a parallelogram covers, or into the one that has its centre. A parallelogram
// that is thinner than a pixel is a line: its few pixel centres would be a row of dots.
function fill(ids, wide, number, [x, y, ax, ay, bx, by], {left, right, top, bottom}) {
  const reachX = Math.max(Math.abs(ax) + Math.abs(bx), HALF), reachY = Math.max(Math.abs(ay) + Math.abs(by), HALF);
  if (x + reachX < left || x - reachX > right || y + reachY < top || y - reachY > bottom) return;
  const first = Math.max(top, Math.ceil(y - reachY - 0.5)), last = Math.min(bottom - 1, Math.floor(y + reachY - 0.5));
  const area = Math.abs(ax * by - ay * bx);
  const strips = [[by, bx, Math.max(area, HALF * Math.hypot(bx, by))], [ay, ax, Math.max(area, HALF * Math.hypot(ax, ay))]];
  let drawn = false;
  for (let row = first; row <= last; row++) {
    const dy = row + 0.5 - y;
    // Of the distance dx across: |dx by - dy bx| <= area and |dy ax - dx ay| <= area, but at least half a pixel off the middle.
    let low = -reachX, up = reachX;
    for (const [slope, along, size] of strips) {
      const shift = dy * along;
      if (Math.abs(slope) > 1e-9) {
        const one = (shift - size) / slope, other = (shift + size) / slope;
        low = Math.max(low, Math.min(one, other));
        up = Math.min(up, Math.max(one, other));
      } else if (Math.abs(shift) > size) up = -Infinity;
    }
    const end = Math.min(right - 1, Math.floor(x + up - 0.5));
    for (let column = Math.max(left, Math.ceil(x + low - 0.5)); column <= end; column++) {
      ids[row * wide + column] = number;
      drawn = true;
    }
  }
  const column = Math.floor(x), row = Math.floor(y);
  if (!drawn && column >= left && column < right && row >= top && row < bottom) ids[row * wide + column] = number;
}

// Colour of the line between two materials, 0 is the void: of the one that is drawn above the other. Pieces of a jet in the hole would
// be all line, so a jet has one towards other materials alone; rubble has one towards bodies alone, the wall of the hole.
function linesBetween() {
  const kinds = [{kind: 0}, ...blocks];
  const found = Array.from({length: rubble + 1}, () => new Uint32Array(rubble + 1));
  kinds.forEach((one, rank) => kinds.slice(0, rank).forEach(other => {
    if (one.jet && !other.kind) return;
    found[one.kind][other.kind] = found[other.kind][one.kind] = pixelOf(one.colour);
  }));
  for (const {kind, colour, jet} of blocks) if (!jet) found[kind][rubble] = found[rubble][kind] = pixelOf(colour);
  return found;
}

function redraw() {
  if (pending || !now.right) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    draw();
    drawMarks();
    hover();
  });
}

function fit() {
  const {wide, high} = size(), dense = Math.min(window.devicePixelRatio || 1, Math.sqrt(MOST_PIXELS / Math.max(wide * high, 1)));
  const pixels = [Math.max(1, Math.round(wide * dense)), Math.max(1, Math.round(high * dense))];
  for (const one of [canvas, marks]) if (one.width !== pixels[0] || one.height !== pixels[1]) [one.width, one.height] = pixels;
  if (picture.ids.length !== pixels[0] * pixels[1]) picture.ids = new Int32Array(pixels[0] * pixels[1]);
  [picture.wide, picture.high] = pixels;
  picture.dense = dense;
}

// Parts of the picture with a field of their own: the mirror image of the particles (-1) or themselves, on which panel, in which pixels.
function partsOf() {
  const {wide, high, change} = picture, all = {left: 0, right: wide, top: 0, bottom: high};
  const [before, after] = lying ? [{...all, bottom: change}, {...all, top: change}] : [{...all, right: change}, {...all, left: change}];
  return scene.mirrored ? [[-1, 0, before], [1, 0, after]] : [[1, 0, before], [1, 1, after]];
}

// The row or the column of pixels where the second field begins.
function changeOf() {
  const side = lying ? 1 : 0, most = lying ? picture.high : picture.wide;
  const middle = scene.mirrored ? screenOf(axisAt, 0)[side] * picture.dense : 0.5 * most;
  return Math.max(0, Math.min(most, Math.round(middle)));
}

// Which particle every pixel shows; -1 for none.
function place() {
  const {ids, wide, dense} = picture;
  ids.fill(-1);
  picture.change = changeOf();
  const bare = hidden.has(rubble);
  const unit = OVERLAP * scene.shapeUnit * scene.largest / scene.quantum;
  for (const [mirror, panel, part] of partsOf()) {
    const [x0, y0] = screenOf(mirror < 0 ? 2 * axisAt : 0, 0, panel).map(value => value * dense);
    const [[rx, ry], [ux, uy]] = [turned(mirror * dense, 0), turned(0, dense)];  // a step across y, and one along y
    for (const {kind, first, count: particles} of blocks) {
      if (hidden.has(kind)) continue;
      for (let i = first; i < first + particles; i++) {
        if (!now.there[i] || (bare && now.kind[i] === rubble)) continue;
        const across = now.place[2 * i], along = now.place[2 * i + 1], large = unit * sizes[i];
        const [ax, ay, bx, by] = [0, 1, 2, 3].map(k => large * now.shape[4 * i + k]);
        fill(ids, wide, i, [x0 + across * rx + along * ux, y0 + across * ry + along * uy,
          ax * rx + ay * ux, ax * ry + ay * uy, bx * rx + by * ux, bx * ry + by * uy], part);
      }
    }
  }
}

// Colours of the pixels, and lines where the next pixel is of another material.
function colour() {
  const {ids, wide, high, change} = picture, image = new ImageData(wide, high), pixels = new Uint32Array(image.data.buffer);
  const part = scene.shapeUnit * scene.largest / scene.quantum * view.scale * picture.dense * 20;
  const [lastColumn, lastRow] = lying ? [wide - 1, change - 1] : [change - 1, high - 1];  // whose neighbours are of the other field
  for (let row = 0, k = 0; row < high; row++) for (let column = 0; column < wide; column++, k++) {
    const id = ids[k], right = column + 1 < wide && column !== lastColumn ? ids[k + 1] : id;
    const below = row + 1 < high && row !== lastRow ? ids[k + wide] : id;
    pixels[k] = id < 0 ? VOID : ((lying ? row : column) < change ? now.left : now.right)[id];
    if (id === right && id === below) continue;
    const own = id < 0 ? 0 : now.kind[id], other = right < 0 ? 0 : now.kind[right], under = below < 0 ? 0 : now.kind[below];
    const line = option.outlines && (lineOf[own][other] || lineOf[own][under]);
    if (line) pixels[k] = line;
    else if (option.edges && id >= 0 && 2 * part * sizes[id] > LEAST_EDGED) pixels[k] = shaded(pixels[k]);
  }
  canvas.getContext("2d").putImageData(image, 0, 0);
}

function draw() {
  fit();
  place();
  closeGaps();
  if (option.fitted) fitColours();
  colour();
}

// Shapes are rounded: a single pixel between two of one material is none of the void.
function closeGaps() {
  const {ids, wide, high} = picture;
  const same = (one, other) => one >= 0 && other >= 0 && now.kind[one] === now.kind[other];
  for (let row = 1; row < high - 1; row++) for (let k = row * wide + 1; k < row * wide + wide - 1; k++) {
    if (ids[k] >= 0) continue;
    if (same(ids[k - 1], ids[k + 1])) ids[k] = ids[k - 1];
    else if (same(ids[k - wide], ids[k + wide])) ids[k] = ids[k - wide];
  }
}

// The range of colours becomes that of most of what is seen.
function fitColours() {
  const {ids, wide, change} = picture;
  for (const side of ["left", "right"]) {
    const one = field[view[side]], codes = one.classes || one.doubling ? null : rows[view[side]](view.step), found = [];
    if (!codes) continue;
    const plain = new Set(blocks.filter(block => isPlain(block, one)).map(block => block.kind));
    if (option.plain && !one.inJet) plain.add(rubble);
    const stride = 1 + Math.floor(ids.length / 20000) | 1;
    for (let k = 0; k < ids.length; k += stride) {
      const own = (lying ? Math.floor(k / wide) : k % wide) < change ? "left" : "right";
      const code = ids[k] >= 0 && !plain.has(now.kind[ids[k]]) ? codes[ids[k]] : 0;
      if (code && (own === side || view.left === view.right)) found.push(valueOf(one, code));
    }
    if (found.length < 50) continue;
    found.sort((a, b) => a - b);
    let [low, high] = [0.02, 0.98].map(part => found[Math.floor(part * (found.length - 1))]);
    if (one.neutral !== null) {
      const reach = Math.max(high - one.neutral, one.neutral - low);
      [low, high] = [one.neutral - reach, one.neutral + reach];
    }
    if (!(high - low > 1e-6 * (one.limits[1] - one.limits[0]))) continue;
    view.limits[side] = [low, high];
    drawBar(side);
    paint(side);
  }
}
