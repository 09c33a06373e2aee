// The soil surface and the bodies over time, drawn by a rasteriser with a depth buffer: the same picture in every browser, on screen
// and on paper, without a graphics card.
(() => {
'use strict';
const holder = document.getElementById('view');
if (!holder) return;
const data = JSON.parse(document.getElementById('view-data').textContent);
const canvas = holder.querySelector('canvas');
const slider = holder.querySelector('input[type=range]');
const playButton = holder.querySelector('button[data-play]');
const readout = holder.querySelector('output');
const context = canvas.getContext('2d');
const calm = matchMedia('(prefers-reduced-motion: reduce)');
const night = matchMedia('(prefers-color-scheme: dark)');
const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const colours = data.colours.match(/.{6}/g).map(c => [0, 2, 4].map(n => parseInt(c.slice(n, n + 2), 16)));

// Heights of every time, each as the change since the time before: numbers of seven bits a byte, runs of zeros counted.
const unpack = (packed, frames, count) => {
  const all = [];
  let at = 0;
  const next = () => {
    let [value, shift] = [0, 0];
    for (;;) {
      const byte = packed[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
      shift += 7;
    }
  };
  let before = new Int32Array(count);
  for (let frame = 0; frame < frames; frame++) {
    const now = before.slice();
    for (let n = 0; n < count; n++) {
      const change = next();
      if (change === 0) { n += next() - 1; continue; }
      now[n] += change & 1 ? -((change + 1) / 2) : change / 2;
    }
    all.push(now);
    before = now;
  }
  return all;
};

const [columns, rows] = [data.x.length, data.y.length];
const frames = data.times.length;
const steps = unpack(bytes(data.heights), frames, columns * rows);
const height = (frame, n) => steps[frame][n] > 0 ? data.low + data.step * (steps[frame][n] - 1) : NaN;

const bodies = data.bodies.map(body => {
  const raw = new Uint16Array(bytes(body.points).buffer);
  const points = Float64Array.from(raw, (q, n) => body.low[n % 3] + body.step * q);
  const triangles = new Uint16Array(bytes(body.triangles).buffer);
  return { points, triangles, poses: body.poses, turns: body.turns };
});

// ---- triangles: places, colours, corners ----
const surfaceCount = columns * rows;
const rim = [];
for (let i = 0; i < columns; i++) rim.push(i);
for (let j = 1; j < rows; j++) rim.push(j * columns + columns - 1);
for (let i = columns - 2; i >= 0; i--) rim.push((rows - 1) * columns + i);
for (let j = rows - 2; j >= 0; j--) rim.push(j * columns);
const corners = surfaceCount + 2 * rim.length + bodies.reduce((sum, b) => sum + b.triangles.length, 0);
const place = new Float32Array(3 * corners);
const colour = new Float32Array(3 * corners);
const faces = [];
for (let j = 1; j < rows; j++) {
  for (let i = 1; i < columns; i++) {
    const [a, b, c, d] = [(j - 1) * columns + i - 1, (j - 1) * columns + i, j * columns + i, j * columns + i - 1];
    faces.push(a, b, c, a, c, d);
  }
}
for (let n = 0; n < rim.length; n++) {
  const [top, low] = [surfaceCount + 2 * n, surfaceCount + 2 * n + 1];
  const m = (n + 1) % rim.length;
  if (m) faces.push(top, low, low + 2, top, low + 2, top + 2);
}
let first = surfaceCount + 2 * rim.length;
for (const body of bodies) {
  body.first = first;
  for (let n = 0; n < body.triangles.length; n++) faces.push(first++);
}
const triangles = Uint32Array.from(faces);

// Lowest and highest place of soil and bodies at any time, and the largest rise or fall of the soil.
const low = [data.x[0], data.y[0], Infinity];
const high = [data.x[columns - 1], data.y[rows - 1], -Infinity];
let most = 1e-6;
for (let frame = 0; frame < frames; frame++) {
  for (let n = 0; n < surfaceCount; n++) {
    const z = height(frame, n);
    if (Number.isNaN(z)) continue;
    low[2] = Math.min(low[2], z);
    high[2] = Math.max(high[2], z);
    most = Math.max(most, Math.abs(z - data.level));
  }
}
if (!Number.isFinite(low[2])) { low[2] = high[2] = data.level; }
// A heap stands on its floor; level ground is shown as a block.
const base = !data.levelled ? Math.min(low[2], data.level) : low[2] - 0.06 * Math.max(high[0] - low[0], high[1] - low[1]) - 0.25 * (high[2] - low[2]);
// How high anything reaches.
let ceiling = high[2];
for (const body of bodies) {
  const size = [0, 1, 2].map(k => body.points.reduce((most, v, n) => n % 3 === k ? Math.max(most, Math.abs(v)) : most, 0));
  for (const pose of body.poses) ceiling = Math.max(ceiling, pose[11] + Math.abs(pose[6]) * size[0] + Math.abs(pose[7]) * size[1] + Math.abs(pose[8]) * size[2]);
}
const light = [0.36, -0.48, 0.8];

const ramp = rise => {
  const part = data.levelled ? 0.5 + 0.5 * rise / most : rise / most;
  const at = Math.min(Math.max(part, 0), 1) * (colours.length - 1);
  const n = Math.min(Math.floor(at), colours.length - 2);
  return colours[n].map((c, k) => c + (at - n) * (colours[n + 1][k] - c));
};

const place3 = (n, x, y, z) => { place[3 * n] = x; place[3 * n + 1] = y; place[3 * n + 2] = z; };
const paint = (n, rgb, shade) => { for (let k = 0; k < 3; k++) colour[3 * n + k] = Math.min(255, rgb[k] * shade); };

const soil = frame => {
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const n = j * columns + i;
      const z = height(frame, n);
      place3(n, data.x[i], data.y[j], z);
      if (Number.isNaN(z)) continue;
      const slope = (a, b, axis, at) => {
        const change = (height(frame, b) - height(frame, a)) / (axis[Math.min(at + 1, axis.length - 1)] - axis[Math.max(at - 1, 0)]);
        return Number.isFinite(change) ? change : 0;
      };
      const sx = slope(j * columns + Math.max(i - 1, 0), j * columns + Math.min(i + 1, columns - 1), data.x, i);
      const sy = slope(Math.max(j - 1, 0) * columns + i, Math.min(j + 1, rows - 1) * columns + i, data.y, j);
      const lit = (light[2] - light[0] * sx - light[1] * sy) / Math.hypot(1, sx, sy);
      paint(n, ramp(z - data.level), 0.5 + 0.62 * Math.max(lit, 0));
    }
  }
  rim.forEach((n, m) => {
    const [top, foot] = [surfaceCount + 2 * m, surfaceCount + 2 * m + 1];
    place3(top, place[3 * n], place[3 * n + 1], place[3 * n + 2]);
    place3(foot, place[3 * n], place[3 * n + 1], base);
    paint(top, [150, 116, 82], 0.9);
    paint(foot, [110, 84, 60], 0.75);
  });
};

const solid = (body, frame) => {
  const pose = body.poses[frame];
  for (let t = 0; t < body.triangles.length; t += 3) {
    const [centre, at] = [[0, 0, 0], []];
    for (let k = 0; k < 3; k++) {
      const p = 3 * body.triangles[t + k];
      const [x, y, z] = [body.points[p], body.points[p + 1], body.points[p + 2]];
      centre[0] += x / 3; centre[1] += y / 3; centre[2] += z / 3;
      at.push([0, 1, 2].map(r => pose[9 + r] + pose[3 * r] * x + pose[3 * r + 1] * y + pose[3 * r + 2] * z));
      place3(body.first + t + k, ...at[k]);
    }
    const [u, v] = [1, 2].map(k => at[k].map((c, r) => c - at[0][r]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const size = Math.hypot(...normal) || 1;
    const lit = normal.reduce((sum, c, r) => sum + c * light[r], 0) / size;
    // Quarters of two tones show how a body turns.
    const tone = body.turns && centre[0] * centre[2] > 0 ? 0.74 : 1;
    for (let k = 0; k < 3; k++) paint(body.first + t + k, [196, 204, 214], tone * (0.62 + 0.38 * lit));
  }
};

// ---- camera ----
const span = Math.hypot(high[0] - low[0], high[1] - low[1], ceiling - base);
const views = { oblique: [-0.85, 0.5], side: [0, 0.02], above: [0, 1.55], front: [1.5707, 0.12] };
const camera = {};
const look = name => {
  [camera.yaw, camera.pitch] = views[name];
  camera.target = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (base + ceiling)];
  camera.distance = 1.45 * span;
};

const axes = () => {
  const [cy, sy, cp, sp] = [Math.cos(camera.yaw), Math.sin(camera.yaw), Math.cos(camera.pitch), Math.sin(camera.pitch)];
  return { right: [cy, sy, 0], up: [-sy * sp, cy * sp, cp], ahead: [-sy * cp, cy * cp, -sp] };
};

let [depth, pixels, image, dim] = [null, null, null, 1];
const shown = new Float32Array(3 * corners);

const draw = fine => {
  const ratio = fine ? Math.max(2, Math.min(devicePixelRatio, 2)) : 1;
  const [wide, tall] = [canvas.clientWidth, canvas.clientHeight].map(v => Math.max(2, Math.round(v * ratio)));
  if (canvas.width !== wide || canvas.height !== tall || !image) {
    [canvas.width, canvas.height] = [wide, tall];
    image = context.createImageData(wide, tall);
    pixels = new Uint32Array(image.data.buffer);
    depth = new Float32Array(wide * tall);
  }
  pixels.fill(0);
  depth.fill(0);
  project(wide, tall);
  dim = night.matches ? 0.88 : 1;
  for (let t = 0; t < triangles.length; t += 3) fill(triangles[t], triangles[t + 1], triangles[t + 2], wide, tall);
  context.putImageData(image, 0, 0);
};

const project = (wide, tall) => {
  const { right, up, ahead } = axes();
  const eye = camera.target.map((c, k) => c - camera.distance * ahead[k]);
  const focal = 1.5 * Math.min(tall * 1.35, wide);
  for (let n = 0; n < corners; n++) {
    const [x, y, z] = [place[3 * n] - eye[0], place[3 * n + 1] - eye[1], place[3 * n + 2] - eye[2]];
    const w = 1 / (x * ahead[0] + y * ahead[1] + z * ahead[2]);
    shown[3 * n] = 0.5 * wide + focal * w * (x * right[0] + y * right[1] + z * right[2]);
    shown[3 * n + 1] = 0.5 * tall - focal * w * (x * up[0] + y * up[1] + z * up[2]);
    shown[3 * n + 2] = w;
  }
};

// Fills a triangle where it is nearer than what is there; depths and colours vary linearly over it.
const fill = (a, b, c, wide, tall) => {
  const [ax, ay, aw] = [shown[3 * a], shown[3 * a + 1], shown[3 * a + 2]];
  const bx = shown[3 * b], by = shown[3 * b + 1], bw = shown[3 * b + 2];
  const cx = shown[3 * c], cy = shown[3 * c + 1], cw = shown[3 * c + 2];
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  // Also false for soil that is missing, whose places are no numbers.
  if (!(aw > 0 && bw > 0 && cw > 0 && Math.abs(area) > 1e-9)) return;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5)), right = Math.min(wide - 1, Math.floor(Math.max(ax, bx, cx) - 0.5) + 1);
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)), bottom = Math.min(tall - 1, Math.floor(Math.max(ay, by, cy) - 0.5) + 1);
  const per = 1 / area, slack = -1e-6;
  const bStep = (cy - ay) * per, cStep = -(by - ay) * per;
  for (let y = top; y <= bottom; y++) {
    const py = y + 0.5 - ay;
    let px = left + 0.5 - ax;
    let beta = (px * (cy - ay) - py * (cx - ax)) * per;
    let gamma = (py * (bx - ax) - px * (by - ay)) * per;
    for (let x = left, n = y * wide + left; x <= right; x++, n++, beta += bStep, gamma += cStep) {
      const alpha = 1 - beta - gamma;
      if (beta < slack || gamma < slack || alpha < slack) continue;
      const w = alpha * aw + beta * bw + gamma * cw;
      if (w <= depth[n]) continue;
      depth[n] = w;
      const red = dim * (alpha * colour[3 * a] + beta * colour[3 * b] + gamma * colour[3 * c]);
      const green = dim * (alpha * colour[3 * a + 1] + beta * colour[3 * b + 1] + gamma * colour[3 * c + 1]);
      const blue = dim * (alpha * colour[3 * a + 2] + beta * colour[3 * b + 2] + gamma * colour[3 * c + 2]);
      pixels[n] = 0xff000000 | (blue & 255) << 16 | (green & 255) << 8 | (red & 255);
    }
  }
};

// ---- time, and what people do ----
let frame = frames - 1;
let [due, rest, playing] = [0, 0, 0];

const redraw = fine => {
  cancelAnimationFrame(due);
  due = requestAnimationFrame(() => {
    draw(fine);
    clearTimeout(rest);
    if (!fine) rest = setTimeout(() => redraw(true), 140);
  });
};

const show = (n, fine = true) => {
  frame = Math.min(Math.max(n, 0), frames - 1);
  soil(frame);
  bodies.forEach(body => solid(body, frame));
  slider.value = frame;
  const way = data.displacements[frame];
  const moved = data.displacements.some(u => Math.abs(u) > 5e-4) ? `, u = ${way.toFixed(3).replace('-', '−')} m` : '';
  readout.textContent = `t = ${data.times[frame].toPrecision(3)} s${moved}`;
  slider.setAttribute('aria-valuetext', readout.textContent);
  redraw(fine);
};

const stop = () => {
  clearInterval(playing);
  playing = 0;
  playButton.textContent = '▶ play';
  redraw(true);
};

const play = () => {
  if (playing) { stop(); return; }
  if (frame === frames - 1) show(0, false);
  playButton.textContent = '❚❚ pause';
  const pause = calm.matches ? 700 : Math.min(Math.max(5000 / frames, 60), 250);
  playing = setInterval(() => { if (frame === frames - 1) stop(); else show(frame + 1, false); }, pause);
};

const turn = (yaw, pitch) => {
  camera.yaw += yaw;
  camera.pitch = Math.min(Math.max(camera.pitch + pitch, -0.3), 1.57);
  redraw(false);
};
const zoom = factor => {
  camera.distance = Math.min(Math.max(camera.distance * factor, 0.08 * span), 6 * span);
  redraw(false);
};
const pan = (across, upward) => {
  const { right, up } = axes();
  const scale = camera.distance / Math.min(canvas.clientHeight * 1.35, canvas.clientWidth) / 1.5;
  camera.target = camera.target.map((c, k) => c + scale * (upward * up[k] - across * right[k]));
  redraw(false);
};

const fingers = new Map();
canvas.addEventListener('pointerdown', event => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
});
canvas.addEventListener('pointermove', event => {
  const before = fingers.get(event.pointerId);
  if (!before) return;
  const now = [event.clientX, event.clientY];
  const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
  if (fingers.size === 2) {
    const [, other] = [...fingers].find(([id]) => id !== event.pointerId);
    const apart = at => Math.hypot(at[0] - other[0], at[1] - other[1]);
    zoom(apart(before) / Math.max(apart(now), 1));
    pan(0.5 * dx, 0.5 * dy);
  } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
    pan(dx, dy);
  } else {
    turn(-0.008 * dx, 0.008 * dy);
  }
  fingers.set(event.pointerId, now);
});
for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, event => fingers.delete(event.pointerId));
canvas.addEventListener('contextmenu', event => event.preventDefault());
// The page scrolls over a picture that nobody has chosen.
canvas.addEventListener('wheel', event => {
  if (document.activeElement !== canvas && !event.ctrlKey) return;
  event.preventDefault();
  zoom(Math.exp(0.0012 * event.deltaY));
}, { passive: false });
canvas.addEventListener('keydown', event => {
  const keys = {
    ArrowLeft: () => turn(0.1, 0), ArrowRight: () => turn(-0.1, 0), ArrowUp: () => turn(0, 0.1), ArrowDown: () => turn(0, -0.1),
    '+': () => zoom(0.85), '=': () => zoom(0.85), '-': () => zoom(1 / 0.85), ' ': play, 0: () => { look('oblique'); redraw(true); },
    ',': () => show(frame - 1), '.': () => show(frame + 1),
  };
  if (!keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});
playButton.addEventListener('click', play);
slider.addEventListener('input', () => { if (playing) stop(); show(+slider.value, false); });
for (const button of holder.querySelectorAll('button[data-look]')) {
  button.addEventListener('click', () => { look(button.dataset.look); redraw(true); });
}
night.addEventListener('change', () => redraw(true));
addEventListener('resize', () => redraw(true));
addEventListener('beforeprint', () => { cancelAnimationFrame(due); draw(true); });

const bar = holder.querySelector('.ramp');
bar.style.background = `linear-gradient(to right, ${colours.map(c => `rgb(${c})`).join()})`;
const ends = holder.querySelectorAll('.ends span');
const millimetres = value => `${value > 0 ? '+' : value < 0 ? '−' : ''}${(1e3 * Math.abs(value)).toPrecision(3)} mm`;
[data.levelled ? -most : 0, data.levelled ? 0 : 0.5 * most, most].forEach((value, n) => { ends[n].textContent = value ? millimetres(value) : '0'; });

holder.hidden = false;
slider.max = frames - 1;
slider.hidden = playButton.hidden = frames < 2;
// A strip of plane strain is seen from its side.
look(rows === 2 ? 'side' : 'oblique');
show(frames - 1);
})();
