// What an update says, as text and bars.

import { describeView, sync } from './choices.js';
import { $, lanes, shownHeight } from './page.js';

let report = null; // of the newest update

const rate = (perSecond) => {
  if (perSecond === null || perSecond === undefined) return '–';
  if (perSecond >= 1e6) return `${(perSecond / 1e6).toPrecision(3)} M/s`;
  if (perSecond >= 1e3) return `${(perSecond / 1e3).toPrecision(3)} k/s`;
  return `${perSecond.toPrecision(3)} /s`;
};
const time = (seconds) => (seconds < 1 ? `${(seconds * 1000).toPrecision(3)} ms` : `${seconds.toFixed(2)} s`);
const size = (bytes) => {
  const units = ['B', 'kB', 'MB', 'GB'];
  const step = Math.min(Math.floor(Math.log10(Math.max(bytes, 1)) / 3), units.length - 1);
  return `${(bytes / 1000 ** step).toFixed(step > 0 ? 1 : 0)} ${units[step]}`;
};
const samples = (lane) => {
  if (lane.complete) return lane.all_samples === 1 ? '1' : `all ${lane.all_samples}`;
  if (lane.samples === 0) return 'a first look';
  const digits = [1, 10].filter((end) => lane.samples < end).length;
  return `${lane.samples.toFixed(digits)} of ${lane.all_samples}`;
};
const progress = (lane) => {
  if (lane.complete) return `finished in ${time(lane.seconds)}`;
  return lane.samples === 0 ? samples(lane) : `${samples(lane)} samples a pixel`;
};

/** Shows all of an update but its pictures. */
export function showFigures(update, threads) {
  report = update;
  const { lanes: racing } = report;
  document.title = `${report.scene} – srt view`;
  $('scene').textContent = report.scene;
  $('status').textContent = statusText();
  $('trouble').hidden = report.error === null;
  $('error').textContent = report.error ?? '';
  // The first error, whose line may not fit into a narrow page.
  $('trouble-title').textContent = /^error: (.*)$/m.exec(report.error ?? '')?.[1] ?? '';
  $('refusal').hidden = report.refusal === null;
  $('refusal').textContent = report.refusal ?? '';
  $('warned').hidden = report.warnings === '';
  $('warnings').textContent = report.warnings;
  $('camera').textContent = report.camera;
  $('reset').disabled = !report.moved;
  if (racing.length === 0) return;
  $('stage').classList.toggle('racing', racing.length > 1);
  lanes[1].figure.hidden = racing.length < 2;
  const legends = racing.map((lane) => lane.legend).filter((legend) => legend !== null);
  $('legend').hidden = legends.length === 0;
  // Coarse pictures have scales of their own, for a moment.
  $('legend').textContent = legends[0] ?? '';
  racing.forEach((lane, i) => {
    const { caption, canvas } = lanes[i];
    canvas.setAttribute('aria-label', `${report.scene}, ${report.view}, traced with ${lane.structure}`);
    setText(caption, [['name', lane.structure], ['progress', progress(lane)]]);
    sync(i, lane, report.answers);
  });
  sharpen();
  if (document.activeElement !== $('view')) $('view').value = report.view;
  describeView();
  showBars(racing, threads);
  showVerdict(racing);
  showTable(racing);
}

function statusText() {
  if (report.busy !== null) return `${report.busy} …`;
  if (report.lanes.length === 0) return 'nothing is traced';
  const shape = `${report.width} × ${report.height}`;
  return report.complete ? `${shape}, finished` : `${shape}, refining`;
}

/** Spans of these classes and texts. */
function setText(element, parts) {
  while (element.children.length < parts.length) element.append(document.createElement('span'));
  parts.forEach(([name, text], i) => {
    const part = element.children[i];
    part.className = name;
    if (part.textContent !== text) part.textContent = text;
  });
}

/** Pixels that are shown much larger than they are stay squares. */
export function sharpen() {
  if (!report) return;
  const scale = (window.devicePixelRatio * shownHeight(lanes[0].canvas)) / report.height;
  $('stage').classList.toggle('sharp', scale >= 3);
}

const ALL = 'all, with shading';
/** The shortest bar, as a part of a full one: what is thousands of times slower is still there. */
const LEAST_BAR = 0.006;

function showBars(racing, threadCount) {
  const names = [...new Set(racing.flatMap((lane) => lane.classes.map((one) => one.name)))];
  const rows = names.map((name) => ({
    name: `${name} rays`,
    rates: racing.map((lane) => lane.classes.find((one) => one.name === name)?.rays_per_second ?? null),
  }));
  rows.push({ name: ALL, rates: racing.map((lane) => lane.rays_per_second) });
  const most = scaleEnd(Math.max(1, ...rows.flatMap(({ rates }) => rates.map((one) => one ?? 0))));
  const bars = $('bars');
  while (bars.children.length > rows.length) bars.lastChild.remove();
  while (bars.children.length < rows.length) {
    const row = document.createElement('div');
    row.className = 'class';
    row.append(document.createElement('span'));
    bars.append(row);
  }
  rows.forEach(({ name, rates }, i) => showRow(bars.children[i], name, rates, most));
  const threads = threadCount === 1 ? '1 thread' : `${threadCount} threads`;
  $('speed-note').textContent =
    `A full bar is ${rate(most)}. Each class: while its rays are traced, on ${threads}.`;
}

function showRow(row, name, rates, most) {
  row.firstChild.textContent = name;
  while (row.children.length > 1 + rates.length) row.lastChild.remove();
  while (row.children.length < 1 + rates.length) {
    const bar = document.createElement('div');
    const [track, fill] = [document.createElement('div'), document.createElement('i')];
    track.className = 'track';
    fill.className = 'fill';
    track.append(fill);
    bar.append(track, document.createElement('output'));
    bar.className = `bar lane-${row.children.length - 1}`;
    row.append(bar);
  }
  rates.forEach((perSecond, lane) => {
    const bar = row.children[1 + lane];
    bar.querySelector('.fill').style.transform = `scaleX(${perSecond ? Math.max(perSecond / most, LEAST_BAR) : 0})`;
    bar.querySelector('output').textContent = rate(perSecond);
  });
}

/** The next of 1, 2, 5, 10, …: the scale stands still while the bars move. */
function scaleEnd(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((step) => step * power).find((end) => end >= value);
}

function showVerdict(racing) {
  const [a, b] = racing;
  const known = b && a.rays_per_second && b.rays_per_second;
  $('verdict').hidden = !known;
  if (!known) return;
  const [fast, slow] = a.rays_per_second >= b.rays_per_second ? [a, b] : [b, a];
  const ratio = fast.rays_per_second / slow.rays_per_second;
  const factor = ratio < 100 ? ratio.toPrecision(3) : Math.round(ratio).toLocaleString('en');
  $('verdict').textContent = `${fast.structure} is ${factor} × as fast as ${slow.structure}`;
}

let delay = null;

function showTable(racing) {
  const rows = [
    ['Samples a pixel', racing.map(samples)],
    ['Time so far', racing.map((lane) => time(lane.seconds))],
    ['Rays', racing.map((lane) => lane.rays.toLocaleString('en'))],
    ['Built in', racing.map((lane) => time(lane.build_seconds))],
    ['Memory', racing.map((lane) => size(lane.bytes))],
  ];
  if (report.complete) rows[1][0] = 'Time';
  if (delay !== null) rows.push(['Seen after a move', [`${Math.round(delay)} ms`, ...racing.slice(1).map(() => '')]]);
  const figures = $('figures');
  figures.classList.toggle('two', racing.length > 1);
  const cells = rows.flatMap(([name, values]) => [['dt', name], ...values.map((value) => ['dd', value])]);
  const fits = figures.children.length === cells.length &&
    cells.every(([tag], i) => figures.children[i].localName === tag);
  if (!fits) figures.replaceChildren(...cells.map(([tag]) => document.createElement(tag)));
  cells.forEach(([, text], i) => { figures.children[i].textContent = text; });
}

/** Shows how long after a movement its first picture was on the screen. */
export function showDelay(milliseconds) {
  delay = milliseconds;
  // For whoever measures: each delay, in milliseconds.
  const { dataset } = $('stage');
  dataset.delays = `${dataset.delays ? `${dataset.delays} ` : ''}${milliseconds.toFixed(1)}`.slice(-4000);
}
