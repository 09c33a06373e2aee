// Values under the pointer and zoom for every chart of a page. Without it the charts are plain pictures.
(() => {
'use strict';
const SVG = 'http://www.w3.org/2000/svg';
let charts = 0;

const make = (name, attributes, parent) => {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (parent) parent.append(made);
  return made;
};

// Three significant digits, or more where the range shown is narrow.
const number = (value, span) => {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(2).replace('-', '−');
  const of = d => Math.floor(Math.log10(d));
  const most = size > 0 ? of(size) : 0;
  const decimals = Math.max(2 - most, span > 0 ? 2 - of(span) : 0);
  return value.toFixed(Math.min(Math.max(decimals, 0), 6)).replace('-', '−');
};

// Name and unit of a label such as "force of the soil [N]".
const split = label => {
  const found = /^(.*?)\s*\[([^\]]*)\]\s*$/.exec(label);
  return found ? [found[1], found[2] === '–' ? '' : found[2]] : [label, ''];
};

// Text with subscripts: letters and digits after "_" are lowered.
const marked = (text, parent) => text.split('_').forEach((piece, n) => {
  const low = n ? /^[\p{L}\p{N}]*/u.exec(piece)[0] : '';
  if (low) parent.append(Object.assign(document.createElement('sub'), { textContent: low }));
  parent.append(piece.slice(low.length));
});

const ticks = ([low, high], count, logarithmic) => {
  const span = high - low;
  const found = [];
  if (logarithmic && span > 0.7) {
    const steps = span < 3 ? [1, 2, 5] : [1];
    for (let decade = Math.floor(low); decade <= high; decade++) {
      for (const step of steps) found.push([decade + Math.log10(step), step * 10 ** decade]);
    }
  } else {
    const raw = span / count;
    const decade = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 2.5, 5, 10].map(m => m * decade).find(s => s >= raw * 0.999) || decade * 10;
    for (let n = Math.ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; n++) {
      found.push([n * step, logarithmic ? 10 ** (n * step) : n * step]);
    }
  }
  const inside = found.filter(([at]) => at >= low - 1e-9 * span && at <= high + 1e-9 * span);
  const gap = inside.length > 1 ? Math.abs(inside[1][1] - inside[0][1]) : span;
  return inside.map(([at, value]) => {
    const size = Math.abs(value);
    if (size >= 1e6 || (size > 0 && size < 1e-5)) return [at, value.toExponential(1).replace('-', '−')];
    const decimals = Math.min(Math.max(0, -Math.floor(Math.log10(logarithmic ? size || 1 : gap) + 1e-9)), 8);
    const whole = Math.abs(value * 10 ** decimals - Math.round(value * 10 ** decimals)) < 1e-6;
    return [at, value.toFixed(whole ? decimals : decimals + 1).replace('-', '−')];
  });
};

class Chart {
  constructor(svg) {
    this.svg = svg;
    const range = svg.dataset.range.split(' ').map(Number);
    this.whole = { x: range.slice(0, 2), y: range.slice(2) };
    this.shown = this.whole;
    [this.left, this.right, this.top, this.bottom] = svg.dataset.box.split(' ').map(Number);
    this.down = 'down' in svg.dataset;
    this.logarithmic = { x: svg.dataset.logarithmic.includes('x'), y: svg.dataset.logarithmic.includes('y') };
    [this.x, this.y] = [svg.dataset.x, svg.dataset.y].map(split);
    this.group = svg.querySelector('.curves');
    this.curves = [...this.group.querySelectorAll('path[data-name]')].map(path => this.curve(path));
    this.clip();
    this.readout();
    this.listen();
  }

  curve(path) {
    const points = [];
    const dots = path.getAttribute('stroke-linecap') === 'round';
    for (const [, letter, x, y] of path.getAttribute('d').matchAll(/([ML])(-?[\d.]+) (-?[\d.]+)/g)) {
      points.push({ x: this.value('x', +x), y: this.value('y', +y), gap: letter === 'M' });
    }
    const rises = points.every((p, n) => !n || p.x >= points[n - 1].x);
    return { name: path.dataset.name, colour: path.getAttribute('stroke'), points, dots, rises };
  }

  // From a position in the picture to a value on an axis, and back; logarithms on a logarithmic axis.
  value(axis, at, range = this.whole[axis]) {
    const part = axis === 'x' ? (at - this.left) / (this.right - this.left)
      : this.down ? (at - this.top) / (this.bottom - this.top) : (this.bottom - at) / (this.bottom - this.top);
    return range[0] + part * (range[1] - range[0]);
  }

  at(axis, value, range = this.shown[axis]) {
    const part = (value - range[0]) / (range[1] - range[0]);
    return axis === 'x' ? this.left + part * (this.right - this.left)
      : this.down ? this.top + part * (this.bottom - this.top) : this.bottom - part * (this.bottom - this.top);
  }

  real(axis, value) { return this.logarithmic[axis] ? 10 ** value : value; }

  clip() {
    const id = `clip-${charts++}`;
    const path = make('clipPath', { id }, this.svg);
    make('rect', { x: this.left, y: this.top, width: this.right - this.left, height: this.bottom - this.top }, path);
    this.levels = [...this.svg.querySelectorAll('.level')].map(level => {
      const text = level.querySelector('text');
      this.group.append(level.querySelector('path'));
      level.setAttribute('clip-path', `url(#${id})`);
      const beside = text.getAttribute('text-anchor') === 'end' ? -4 : 4;
      return { text, beside, x: +text.getAttribute('x') - beside, y: +text.getAttribute('y') + 8 };
    });
    const outer = make('g', { 'clip-path': `url(#${id})` });
    this.group.replaceWith(outer);
    outer.append(this.group);
    this.marks = make('g', { class: 'marks', 'pointer-events': 'none' }, this.svg);
  }

  readout() {
    this.figure = document.createElement('div');
    this.figure.className = 'chart-holder';
    this.svg.replaceWith(this.figure);
    this.tip = Object.assign(document.createElement('div'), { className: 'tip', hidden: true });
    this.reset = Object.assign(document.createElement('button'), { className: 'reset', type: 'button', hidden: true, textContent: 'whole range' });
    this.reset.addEventListener('click', () => this.zoom(this.whole));
    this.figure.append(this.svg, this.tip, this.reset);
    this.svg.tabIndex = 0;
  }

  listen() {
    const svg = this.svg;
    svg.addEventListener('pointermove', event => this.move(event));
    // What a finger has shown stays until another place is touched.
    svg.addEventListener('pointerleave', event => { if (!this.start && event.pointerType !== 'touch') this.hide(); });
    svg.addEventListener('pointerdown', event => this.press(event));
    svg.addEventListener('pointerup', event => this.release(event));
    svg.addEventListener('pointercancel', () => { this.start = null; this.hide(); });
    svg.addEventListener('dblclick', () => this.zoom(this.whole));
    svg.addEventListener('blur', () => this.hide());
    svg.addEventListener('keydown', event => this.key(event));
  }

  place(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = this.svg.viewBox.baseVal.width / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  }

  inside([x, y]) { return x >= this.left && x <= this.right && y >= this.top && y <= this.bottom; }

  press(event) {
    const at = this.place(event);
    if (event.pointerType === 'touch') { this.show(at); return; }
    if (event.button === 0 && this.inside(at)) {
      this.start = at;
      this.svg.setPointerCapture(event.pointerId);
    }
  }

  move(event) {
    const at = this.place(event);
    if (!this.start) { this.inside(at) ? this.show(at) : this.hide(); return; }
    this.hide();
    const [a, b] = this.span(at);
    make('rect', { x: a[0], y: b[0], width: a[1] - a[0], height: b[1] - b[0], fill: 'currentColor', 'fill-opacity': 0.12, stroke: 'currentColor', 'stroke-opacity': 0.5 }, this.marks);
  }

  // The range from where the pointer was pressed: all heights while it has hardly moved up or down.
  span(at) {
    const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
    const x = [this.start[0], clamp(at[0], this.left, this.right)].sort((a, b) => a - b);
    const y = [this.start[1], clamp(at[1], this.top, this.bottom)].sort((a, b) => a - b);
    return [x, y[1] - y[0] < 18 ? [this.top, this.bottom] : y];
  }

  release(event) {
    if (!this.start) return;
    const [x, y] = this.span(this.place(event));
    this.start = null;
    this.hide();
    if (x[1] - x[0] < 6) return;
    const ends = (axis, pair) => pair.map(at => this.value(axis, at, this.shown[axis])).sort((a, b) => a - b);
    const range = { x: ends('x', x), y: ends('y', y) };
    if (y[1] - y[0] >= this.bottom - this.top) range.y = this.heights(range.x);
    this.zoom(range);
  }

  // The range of heights of all curves between two abscissae.
  heights([from, to]) {
    const inside = this.curves.flatMap(c => c.points).filter(p => p.x >= from && p.x <= to).map(p => p.y);
    if (inside.length < 2) return this.shown.y;
    const [low, high] = [Math.min(...inside), Math.max(...inside)];
    const margin = 0.06 * (high - low) || 0.05 * Math.abs(high) || 1;
    return [low - margin, high + margin];
  }

  zoom(range) {
    const narrow = axis => (range[axis][1] - range[axis][0]) < 1e-4 * (this.whole[axis][1] - this.whole[axis][0]);
    if (narrow('x') || narrow('y')) return;
    this.shown = range;
    const isWhole = range === this.whole;
    const size = axis => (this.whole[axis][1] - this.whole[axis][0]) / (range[axis][1] - range[axis][0]);
    const origin = (axis, end) => this.at(axis, this.value(axis, end)) - size(axis) * end;
    this.group.setAttribute('transform', `matrix(${size('x')} 0 0 ${size('y')} ${origin('x', this.left)} ${origin('y', this.top)})`);
    if (isWhole) this.group.removeAttribute('transform');
    for (const mark of this.group.querySelectorAll('.mark')) {
      const place = /translate\([^)]*\)/.exec(mark.getAttribute('transform'))[0];
      mark.setAttribute('transform', isWhole ? place : `${place} scale(${1 / size('x')} ${1 / size('y')})`);
    }
    this.group.classList.toggle('zoomed', !isWhole);
    for (const { text, beside, x, y } of this.levels) {
      text.setAttribute('x', Math.max(Math.min(this.at('x', this.value('x', x)), this.right), this.left) + beside);
      text.setAttribute('y', this.at('y', this.value('y', y)) - 8);
    }
    this.grid();
    this.hide();
    this.reset.hidden = isWhole;
  }

  grid() {
    const group = this.svg.querySelector('.ticks');
    this.original ||= [...group.childNodes];
    if (this.shown === this.whole) { group.replaceChildren(...this.original); return; }
    group.replaceChildren();
    const line = d => make('path', { d, stroke: 'currentColor', 'stroke-opacity': 0.13 }, group);
    const text = (label, attributes) => { make('text', { opacity: 0.8, ...attributes }, group).textContent = label; };
    for (const [value, label] of ticks(this.shown.x, 6, this.logarithmic.x)) {
      const x = this.at('x', value);
      line(`M${x} ${this.top}V${this.bottom}`);
      text(label, { x, y: this.bottom + 16, 'text-anchor': 'middle' });
    }
    for (const [value, label] of ticks(this.shown.y, 6, this.logarithmic.y)) {
      const y = this.at('y', value);
      line(`M${this.left} ${y}H${this.right}`);
      text(label, { x: this.left - 7, y: y + 4, 'text-anchor': 'end' });
    }
  }

  // The point of a curve that belongs to a position: of one that runs along x the value there, otherwise the nearest point.
  pick(curve, [px, py]) {
    const x = this.value('x', px, this.shown.x);
    const { points } = curve;
    if (curve.rises && !curve.dots) {
      let n = points.findIndex(p => p.x >= x);
      if (n < 0 || (n === 0 && points[0].x > x)) return null;
      const [a, b] = [points[Math.max(n - 1, 0)], points[n]];
      if (b.gap && b.x !== x) return null;
      const part = b.x > a.x ? (x - a.x) / (b.x - a.x) : 1;
      return { x, y: a.y + part * (b.y - a.y) };
    }
    const away = p => Math.hypot(this.at('x', p.x) - px, curve.dots && curve.rises ? 0 : this.at('y', p.y) - py);
    let best = null;
    for (const p of points) if (!best || away(p) < away(best)) best = p;
    return best && away(best) < 30 ? best : null;
  }

  show(at) {
    this.hide();
    this.cursor = at;
    const x = Math.min(Math.max(at[0], this.left), this.right);
    make('path', { d: `M${x} ${this.top}V${this.bottom}`, stroke: 'currentColor', 'stroke-opacity': 0.55 }, this.marks);
    const span = axis => Math.abs(this.real(axis, this.shown[axis][1]) - this.real(axis, this.shown[axis][0]));
    const abscissa = number(this.real('x', this.value('x', x, this.shown.x)), span('x'));
    const head = document.createElement('b');
    marked(this.x[0], head);
    head.append(` ${abscissa} ${this.x[1]}`);
    this.tip.replaceChildren(head);
    for (const curve of this.curves.filter(c => c.name)) {
      const point = this.pick(curve, [x, at[1]]);
      if (!point) continue;
      const [px, py] = [this.at('x', point.x), this.at('y', point.y)];
      if (this.inside([px, py])) make('circle', { cx: px, cy: py, r: 3.5, fill: curve.colour, stroke: 'var(--page, #fff)' }, this.marks);
      const row = document.createElement('span');
      const key = document.createElement('i');
      key.style.background = curve.colour;
      row.append(key);
      marked(curve.name, row);
      const value = number(this.real('y', point.y), span('y'));
      const where = curve.rises && !curve.dots ? '' : ` at ${number(this.real('x', point.x), span('x'))}`;
      row.append(Object.assign(document.createElement('em'), { textContent: `${value} ${this.y[1]}${where}` }));
      this.tip.append(row);
    }
    this.tip.hidden = false;
    const share = this.svg.getBoundingClientRect().width / this.svg.viewBox.baseVal.width;
    const room = this.figure.clientWidth - this.tip.offsetWidth;
    const beside = x * share + 14 > room ? x * share - this.tip.offsetWidth - 14 : x * share + 14;
    this.tip.style.left = `${Math.min(Math.max(beside, 0), Math.max(room, 0))}px`;
    this.tip.style.top = `${this.top * share + 6}px`;
  }

  hide() {
    this.marks.replaceChildren();
    this.tip.hidden = true;
  }

  key(event) {
    const step = { ArrowLeft: -6, ArrowRight: 6 }[event.key];
    const cursor = this.cursor || [0.5 * (this.left + this.right), 0.5 * (this.top + this.bottom)];
    const factor = { '+': 0.6, '=': 0.6, '-': 1 / 0.6 }[event.key];
    if (step) {
      this.show([Math.min(Math.max(cursor[0] + step * (event.shiftKey ? 6 : 1), this.left), this.right), cursor[1]]);
    } else if (factor) {
      const middle = this.value('x', cursor[0], this.shown.x);
      const ends = this.shown.x.map(x => middle + factor * (x - middle));
      const x = [Math.max(ends[0], this.whole.x[0]), Math.min(ends[1], this.whole.x[1])];
      const isWhole = x[0] === this.whole.x[0] && x[1] === this.whole.x[1];
      this.zoom(isWhole ? this.whole : { x, y: this.heights(x) });
      this.show([this.at('x', middle), cursor[1]]);
    } else if (event.key === '0' || event.key === 'Escape') {
      this.zoom(this.whole);
    } else {
      return;
    }
    event.preventDefault();
  }
}

for (const svg of document.querySelectorAll('svg.chart')) new Chart(svg);

// Whatever is folded is printed open, and folded again afterwards.
addEventListener('beforeprint', () => {
  for (const folded of document.querySelectorAll('details:not([open])')) folded.dataset.folded = folded.open = true;
});
addEventListener('afterprint', () => {
  for (const folded of document.querySelectorAll('details[data-folded]')) { folded.open = false; delete folded.dataset.folded; }
});

for (const button of document.querySelectorAll('button[data-copies]')) {
  button.hidden = false;
  button.addEventListener('click', async () => {
    const source = document.getElementById(button.dataset.copies);
    try {
      await navigator.clipboard.writeText(source.textContent);
    } catch {
      // A page from a file may not be allowed to write to the clipboard itself.
      getSelection().selectAllChildren(source);
      document.execCommand('copy');
      getSelection().removeAllRanges();
    }
    button.textContent = 'copied';
  });
}
})();
