'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const byId = id => document.getElementById(id);
const made = data.runs.filter(run => run.o);
const short = value => typeof value !== 'number' ? String(value === null ? '–' : value)
  : value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3) ? (+value.toPrecision(3)).toExponential().replace('+', '')
  : String(+value.toPrecision(4));
const isNumeric = p => data.runs.every(run => typeof run.p[p] === 'number');
const lastOf = name => name.split('/').filter(key => isNaN(key)).slice(-2).join('/');
const unitOf = outcome => outcome.unit && outcome.unit !== '-' ? ` [${outcome.unit}]` : '';

function element(parent, name, attributes = {}, text) {
  const svg = ['svg', 'g', 'line', 'circle', 'rect', 'text', 'title'].includes(name);
  const made = svg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return parent.appendChild(made);
}

const caption = run => data.parameters.map((p, i) => `${lastOf(p.name)} = ${short(run.p[i])}`).join(', ');

function choose(run, copy = true) {
  document.querySelectorAll('.chosen').forEach(e => e.classList.remove('chosen'));
  document.querySelectorAll(`[data-run="${run.id}"]`).forEach(e => e.classList.add('chosen'));
  byId('bar').hidden = false;
  byId('bar-title').textContent = `Run ${run.id}: ${caption(run)}`;
  byId('bar-command').textContent = run.command;
  byId('bar-copied').textContent = '';
  if (copy && navigator.clipboard)
    navigator.clipboard.writeText(run.command).then(() => byId('bar-copied').textContent = ' copied', () => {});
}

const kViridis = [[68,1,84],[72,40,120],[62,74,137],[49,104,142],[38,130,142],[31,158,137],[53,183,121],[109,205,89],
                  [180,222,44],[253,231,37]];
function colorOf(t) {
  const at = Math.min(Math.max(t, 0), 1) * (kViridis.length - 1), i = Math.min(Math.floor(at), kViridis.length - 2);
  return 'rgb(' + kViridis[i].map((c, k) => Math.round(c + (kViridis[i + 1][k] - c) * (at - i))).join() + ')';
}

// A scale from values to 0..1, with the ticks that an axis shows.
function numberScale(values, log) {
  const f = log ? Math.log10 : x => x, low = Math.min(...values.map(f)), high = Math.max(...values.map(f));
  const differ = high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high));
  const span = differ ? high - low : 1, start = differ ? low : low - 0.5;
  const place = value => (f(value) - start) / span;
  const step = [1, 2, 5, 10].map(k => k * 10 ** Math.floor(Math.log10(span / 4))).find(s => span / s <= 7);
  const ticks = [];
  for (let t = Math.ceil(start / step - 1e-9) * step; t <= start + span * (1 + 1e-9); t += step)
    ticks.push(log ? 10 ** t : +t.toPrecision(10));
  return {place, ticks};
}
function nameScale(values) {
  const names = [...new Set(values)];
  return {place: value => (names.indexOf(value) + 0.5) / names.length, ticks: names};
}
const parameterScale = p => isNumeric(p) ? numberScale(data.runs.map(run => run.p[p]), data.parameters[p].log)
                                         : nameScale(data.runs.map(run => run.p[p]));

const kWidth = 556, kHeight = 380, kLeft = 76, kBottom = 46, kTop = 30, kRight = 14;
function frame(figure, title) {
  figure.replaceChildren();
  const svg = element(figure, 'svg', {width: kWidth, height: kHeight, viewBox: `0 0 ${kWidth} ${kHeight}`});
  element(svg, 'text', {x: kLeft, y: 16, 'font-weight': 600}, title);
  return svg;
}
const px = t => kLeft + 8 + t * (kWidth - kLeft - kRight - 16), py = t => kHeight - kBottom - 8 - t * (kHeight - kBottom - kTop - 16);
function axes(svg, x, y, xName, yName) {
  for (const t of x.ticks) {
    element(svg, 'line', {class: 'grid', x1: px(x.place(t)), x2: px(x.place(t)), y1: kTop, y2: kHeight - kBottom});
    element(svg, 'text', {x: px(x.place(t)), y: kHeight - kBottom + 16, 'text-anchor': 'middle'}, short(t));
  }
  for (const t of y.ticks) {
    element(svg, 'line', {class: 'grid', x1: kLeft, x2: kWidth - kRight, y1: py(y.place(t)), y2: py(y.place(t))});
    element(svg, 'text', {x: kLeft - 6, y: py(y.place(t)) + 4, 'text-anchor': 'end'}, short(t));
  }
  element(svg, 'text', {x: (kLeft + kWidth) / 2, y: kHeight - 8, 'text-anchor': 'middle'}, xName);
  const up = {transform: `translate(14 ${(kHeight - kBottom) / 2 + 10}) rotate(-90)`, 'text-anchor': 'middle'};
  element(svg, 'text', up, yName);
}

function drawScatter(o, p, other) {
  const outcome = data.outcomes[o], runs = made.filter(run => run.o[o] !== null);
  const svg = frame(byId('scatter'), `${outcome.key}${unitOf(outcome)} against ${data.parameters[p].name}`);
  if (!runs.length) return element(svg, 'text', {x: kLeft, y: 60}, 'No run has this outcome.');
  const x = parameterScale(p), y = numberScale(runs.map(run => run.o[o]), false), c = parameterScale(other);
  axes(svg, x, y, data.parameters[p].name, outcome.key + unitOf(outcome));
  for (const run of runs) {
    const dot = element(svg, 'circle', {class: 'run', 'data-run': run.id, r: 5, cx: px(x.place(run.p[p])),
      cy: py(y.place(run.o[o])), fill: other === p ? 'var(--accent)' : colorOf(c.place(run.p[other]))});
    element(dot, 'title', {}, `Run ${run.id}: ${outcome.key} ${short(run.o[o])}; ${caption(run)}`);
    dot.onclick = () => choose(run);
  }
  const ends = isNumeric(other) ? [Math.min, Math.max].map(f => f(...data.runs.map(run => run.p[other])))
                                : [c.ticks[0], c.ticks.at(-1)];
  if (other !== p) element(byId('scatter'), 'div', {class: 'muted', style: `max-width: ${kWidth}px; font-size: 12px`},
    `Color: ${data.parameters[other].name}, from violet (${short(ends[0])}) to yellow (${short(ends[1])})`);
}

// Columns of the heat map: the values themselves if they are few, else ten equal intervals.
function bins(p) {
  const values = [...new Set(data.runs.map(run => run.p[p]))];
  if (!isNumeric(p) || values.length <= 12) {
    if (isNumeric(p)) values.sort((a, b) => a - b);
    return {labels: values.map(short), of: run => values.indexOf(run.p[p])};
  }
  const log = data.parameters[p].log, f = log ? Math.log10 : x => x, low = Math.min(...values.map(f));
  const width = (Math.max(...values.map(f)) - low) / 10, back = t => log ? 10 ** t : t;
  return {labels: Array.from({length: 10}, (_, i) => short(+back(low + (i + 0.5) * width).toPrecision(2))),
          of: run => Math.min(Math.floor((f(run.p[p]) - low) / width), 9)};
}

function drawHeat(o, p, q) {
  const outcome = data.outcomes[o], columns = bins(p), rows = bins(q), cells = new Map();
  for (const run of made.filter(run => run.o[o] !== null)) {
    const key = `${columns.of(run)},${rows.of(run)}`;
    cells.set(key, [...(cells.get(key) || []), run]);
  }
  const mean = runs => runs.reduce((sum, run) => sum + run.o[o], 0) / runs.length;
  const means = [...cells.values()].map(mean), low = Math.min(...means), high = Math.max(...means);
  const svg = frame(byId('heat'), `${outcome.key}${unitOf(outcome)}, the mean of each cell's runs`);
  const w = (kWidth - kLeft - kRight) / columns.labels.length, h = (kHeight - kBottom - kTop) / rows.labels.length;
  for (const [key, runs] of cells) {
    const [i, j] = key.split(',').map(Number), value = mean(runs), t = high > low ? (value - low) / (high - low) : 0.5;
    const at = {x: kLeft + i * w + 1, y: kHeight - kBottom - (j + 1) * h + 1};
    const cell = element(svg, 'rect', {class: 'run', 'data-run': runs[0].id, ...at, width: w - 2, height: h - 2,
                                       fill: colorOf(t)});
    element(cell, 'title', {}, runs.map(run => `Run ${run.id}: ${short(run.o[o])}; ${caption(run)}`).join('\n'));
    cell.onclick = () => choose(runs[0]);
    if (w > 40 && h > 16) element(svg, 'text', {x: at.x + w / 2 - 1, y: at.y + h / 2 + 3, 'text-anchor': 'middle',
      'pointer-events': 'none', style: `fill: ${t > 0.6 ? '#111' : '#fff'}`}, short(value));
  }
  columns.labels.forEach((label, i) => element(svg, 'text',
    {x: kLeft + (i + 0.5) * w, y: kHeight - kBottom + 16, 'text-anchor': 'middle'}, label));
  rows.labels.forEach((label, j) => element(svg, 'text',
    {x: kLeft - 6, y: kHeight - kBottom - (j + 0.5) * h + 4, 'text-anchor': 'end'}, label));
  element(svg, 'text', {x: (kLeft + kWidth) / 2, y: kHeight - 8, 'text-anchor': 'middle'}, data.parameters[p].name);
  element(svg, 'text', {transform: `translate(14 ${(kHeight - kBottom) / 2 + 10}) rotate(-90)`,
                        'text-anchor': 'middle'}, data.parameters[q].name);
}

function drawSheet() {
  for (const run of data.runs.filter(run => run.picture)) {
    const cell = element(byId('sheet'), 'button', {'data-run': run.id, title: run.command});
    element(cell, 'img', {src: run.picture, alt: `Run ${run.id}`, loading: 'lazy'});
    element(cell, 'span', {}, `${run.id}: ${caption(run)} → ${data.outcomes[0].key}: ${short(run.o[0])}`);
    cell.onclick = () => choose(run);
  }
  byId('pictures').hidden = !data.runs.some(run => run.picture);
}

let sorted = 0, descending = false;
function drawTable() {
  const columns = [['run', '', run => run.id], ...data.parameters.map((p, i) => [p.name, '', run => run.p[i]]),
    ...data.outcomes.flatMap((o, i) => o.main ? [[o.key + unitOf(o), o.meaning, run => run.o ? run.o[i] : null]] : [])];
  const anyError = data.runs.some(run => run.error), table = byId('table');
  table.replaceChildren();
  const head = element(table, 'tr');
  columns.forEach(([name, meaning], i) => {
    const cell = element(head, 'th', {title: meaning, class: 'number'}, name + (i === sorted ? (descending ? ' ▾' : ' ▴') : ''));
    cell.onclick = () => { descending = i === sorted ? !descending : false; sorted = i; drawTable(); };
  });
  if (anyError) element(head, 'th', {}, 'error');
  const value = columns[sorted][2], order = (a, b) => a === null ? 1 : b === null ? -1 : a < b ? -1 : a > b ? 1 : 0;
  for (const run of [...data.runs].sort((a, b) => order(value(a), value(b)) * (descending ? -1 : 1))) {
    const row = element(table, 'tr', {class: 'run', 'data-run': run.id, title: run.command});
    for (const column of columns) element(row, 'td', {class: 'number'}, short(column[2](run)));
    if (anyError) element(row, 'td', {class: 'error'}, run.error || '');
    row.onclick = () => choose(run);
  }
}

function select(id, names, chosen, titles) {
  const list = byId(id);
  names.forEach((name, i) => element(list, 'option', {value: i, title: titles ? titles[i] : name}, name));
  list.value = chosen;
  list.onchange = drawCharts;
}
function drawCharts() {
  const o = +byId('outcome').value, p = +byId('across').value, q = +byId('up').value;
  drawScatter(o, p, q);
  byId('heat').hidden = p === q;
  if (p !== q) drawHeat(o, p, q);
}

select('outcome', data.outcomes.map(o => o.key), 0, data.outcomes.map(o => o.meaning));
const names = data.parameters.map(p => p.name);
if (made.length && names.length) {
  select('across', names, 0);
  select('up', names, Math.min(1, names.length - 1));
  drawCharts();
} else {
  byId('plots').hidden = true;
}
drawSheet();
drawTable();
