'use strict';
// The page of `srt view`: sends what hands do, draws what comes. All that is known of the scene is in the updates.

const $ = (id) => document.getElementById(id);
const lanes = [0, 1].map((i) => ({
  figure: $(`lane-${i}`),
  canvas: $(`lane-${i}`).querySelector('canvas'),
  caption: $(`lane-${i}`).querySelector('figcaption'),
  select: $(`structure-${i}`),
  summary: $(`summary-${i}`),
  options: $(`options-${i}`),
  coarse: document.createElement('canvas'),
  synced: null, // the structure that the controls show
}));
let choices = null; // what there is to choose from: the greeting
let report = null; // the figures of the newest update
let update = null; // an update that is not drawn yet
let lastId = 0;

// ---- To the program ---------------------------------------------------------------------------------------------

const address = new URL('socket', location.href);
address.protocol = 'ws:';
const socket = new WebSocket(address);
socket.binaryType = 'arraybuffer';

function send(command) {
  if (socket.readyState !== WebSocket.OPEN) return;
  lastId += 1;
  socket.send(JSON.stringify({ id: lastId, do: command }));
}

// Movements between two frames are one; the first event of a movement that was not seen yet is timed.
const moves = { turn: [0, 0], pan: [0, 0], zoom: 1, waiting: false };
let timed = null;

function move(kind, value, event) {
  if (kind === 'zoom') {
    moves.zoom *= value;
  } else {
    moves[kind][0] += value[0];
    moves[kind][1] += value[1];
  }
  timed ??= { since: event.timeStamp, id: Infinity };
  if (moves.waiting) return;
  moves.waiting = true;
  requestAnimationFrame(sendMoves);
}

function sendMoves() {
  const within = (value, limit) => Math.min(Math.max(value, -limit), limit);
  moves.waiting = false;
  for (const kind of ['turn', 'pan']) {
    const [right, down] = moves[kind];
    if (right !== 0 || down !== 0) send({ [kind]: [within(right, 10), within(down, 10)] });
    moves[kind] = [0, 0];
  }
  if (moves.zoom !== 1) send({ zoom: Math.min(Math.max(moves.zoom, 0.01), 100) });
  moves.zoom = 1;
  if (timed && timed.id === Infinity) timed.id = lastId;
}

// ---- From the program -------------------------------------------------------------------------------------------

socket.onmessage = ({ data }) => {
  if (typeof data === 'string') {
    choices = JSON.parse(data).greeting;
    offerChoices();
    return;
  }
  const length = new DataView(data).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(data, 4, length));
  update = { report: JSON.parse(text), data, start: 4 + length };
  requestAnimationFrame(draw);
};

socket.onclose = ({ code, reason }) => {
  document.body.classList.add('ended');
  $('status').textContent = code === 1008 && reason
    ? `closed: ${reason}`
    : 'srt has ended. Start srt view again, and open the address that it prints.';
  for (const control of document.querySelectorAll('select, input, button')) control.disabled = true;
};

function draw() {
  if (!update) return;
  const { data, start } = update;
  report = update.report;
  update = null;
  let offset = start;
  report.lanes.forEach((lane, i) => {
    if (lane.picture_bytes === 0) return;
    const bytes = new Uint8ClampedArray(data, offset, lane.picture_bytes);
    drawPicture(lanes[i], new ImageData(bytes, lane.picture_width, lane.picture_height));
    offset += lane.picture_bytes;
  });
  showFigures();
  socket.send('drawn');
  if (timed && report.answers >= timed.id && report.lanes.length > 0) {
    const { since } = timed;
    timed = null;
    // The frame in which the picture is on the screen.
    requestAnimationFrame(() => showDelay(performance.now() - since));
  }
}

function drawPicture({ canvas, coarse }, pixels) {
  const { width, height } = report;
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext('2d');
  if (pixels.width === width && pixels.height === height) {
    context.putImageData(pixels, 0, 0);
    return;
  }
  coarse.width = pixels.width;
  coarse.height = pixels.height;
  coarse.getContext('2d').putImageData(pixels, 0, 0);
  context.imageSmoothingQuality = 'high';
  context.drawImage(coarse, 0, 0, width, height);
}

// ---- Figures ----------------------------------------------------------------------------------------------------

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
  return `${lane.samples.toFixed(lane.samples < 10 ? 1 : 0)} of ${lane.all_samples}`;
};

function showFigures() {
  const { lanes: racing } = report;
  document.title = `${report.scene} – srt view`;
  $('scene').textContent = report.scene;
  $('status').textContent = statusText();
  $('trouble').hidden = report.error === null;
  $('error').textContent = report.error ?? '';
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
  $('legend').textContent = racing.length > 1 && legends.length > 1
    ? racing.map((lane) => `${lane.structure}: ${lane.legend}`).join(' · ')
    : legends.join('');
  racing.forEach((lane, i) => {
    const { caption, canvas } = lanes[i];
    canvas.setAttribute('aria-label', `${report.scene}, ${report.view}, traced with ${lane.structure}`);
    const done = lane.complete ? `finished in ${time(lane.seconds)}` : `${samples(lane)} samples a pixel`;
    setText(caption, [['name', lane.structure], ['progress', done]]);
    sync(i, lane);
  });
  sharpen();
  if (document.activeElement !== $('view')) $('view').value = report.view;
  describeView();
  showBars(racing);
  showVerdict(racing);
  showTable(racing);
}

function statusText() {
  if (report.busy !== null) return `${report.busy} …`;
  if (report.lanes.length === 0) return 'no structure can trace this scene';
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
function sharpen() {
  const scale = (window.devicePixelRatio * shownHeight(lanes[0].canvas)) / report.height;
  $('stage').classList.toggle('sharp', scale >= 3);
}

const ALL = 'all rays, shading included';

function showBars(racing) {
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
  const threads = choices.threads === 1 ? '1 thread' : `${choices.threads} threads`;
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
    bar.querySelector('.fill').style.transform = `scaleX(${(perSecond ?? 0) / most})`;
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

function showDelay(milliseconds) {
  delay = milliseconds;
  // For whoever measures: each delay, in milliseconds.
  const { dataset } = $('stage');
  dataset.delays = `${dataset.delays ? `${dataset.delays} ` : ''}${milliseconds.toFixed(1)}`.slice(-4000);
}

// ---- Structures and views ---------------------------------------------------------------------------------------

function offerChoices() {
  for (const { select } of lanes) {
    select.replaceChildren(...choices.structures.map(({ name }) => new Option(name, name)));
  }
  $('view').replaceChildren(...choices.views.map(({ name }) => new Option(name, name)));
}

const structureNamed = (name) => choices.structures.find((one) => one.name === name);

/** Shows the controls of a structure as the program has it, unless they do already. */
function sync(i, { structure, base }) {
  const lane = lanes[i];
  if (lane.synced === structure) return;
  lane.synced = structure;
  lane.select.value = base;
  const options = structure.slice(base.length + 1);
  const given = new Map(options === '' ? [] : options.split(',').map((option) => option.split('=')));
  offerOptions(i, base, given);
  if (i === 1) showRival(true);
}

function offerOptions(i, base, given) {
  const { summary, options } = structureNamed(base);
  lanes[i].summary.textContent = summary;
  lanes[i].options.replaceChildren(...options.map((option) => {
    const box = document.createElement('div');
    const label = document.createElement('label');
    const control = document.createElement(option.words ? 'select' : 'input');
    control.id = `option-${i}-${option.name}`;
    control.name = option.name;
    control.title = option.summary;
    label.htmlFor = control.id;
    label.textContent = option.name;
    if (option.words) {
      control.append(new Option(`default (${option.default})`, ''));
      control.append(...option.words.map((word) => new Option(word, word)));
    } else {
      [control.type, control.min, control.max] = ['number', ...option.numbers];
      control.placeholder = option.default;
    }
    control.value = given.get(option.name) ?? '';
    control.addEventListener('change', chooseStructures);
    box.append(label, control);
    return box;
  }));
}

/** The name of a structure with the options that its controls have. */
function chosen({ select, options }) {
  const given = [...options.querySelectorAll('select, input')].filter((control) => control.value !== '');
  const text = given.map((control) => `${control.name}=${control.value}`).join(',');
  return text === '' ? select.value : `${select.value}:${text}`;
}

function chooseStructures() {
  const names = [chosen(lanes[0])];
  if ($('race').checked) names.push(chosen(lanes[1]));
  // What is refused is shown as it was before.
  for (const lane of lanes) lane.synced = null;
  send({ structures: names });
}

lanes.forEach(({ select }, i) => select.addEventListener('change', () => {
  offerOptions(i, select.value, new Map());
  chooseStructures();
}));

function showRival(shown) {
  $('race').checked = shown;
  $('rival').hidden = !shown;
}

$('race').addEventListener('change', ({ target }) => {
  showRival(target.checked);
  if (target.checked) {
    const first = lanes[0].select.value;
    const rival = ['bvh', 'cwbvh', 'none'].find((name) => name !== first && structureNamed(name)) ?? first;
    lanes[1].select.value = rival;
    offerOptions(1, rival, new Map());
  }
  chooseStructures();
});

$('view').addEventListener('change', ({ target }) => {
  describeView();
  send({ view: target.value });
});

function describeView() {
  const view = choices.views.find(({ name }) => name === $('view').value);
  $('summary-view').textContent = view?.summary ?? '';
}

// ---- Hands ------------------------------------------------------------------------------------------------------

/** The height at which a canvas shows its picture, in CSS pixels. */
function shownHeight(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  return Math.max(1, Math.min(height, (width * canvas.height) / canvas.width));
}

for (const { canvas } of lanes) {
  const pointers = new Map();
  const middle = () => {
    const all = [...pointers.values()];
    const mean = (key) => all.reduce((sum, one) => sum + one[key], 0) / all.length;
    const [x, y] = [mean('x'), mean('y')];
    return { x, y, spread: Math.hypot(all[0].x - x, all[0].y - y) };
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add('held');
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = middle();
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const now = middle();
    const height = shownHeight(canvas);
    const by = [(now.x - before.x) / height, (now.y - before.y) / height];
    if (by[0] !== 0 || by[1] !== 0) {
      const pans = pointers.size > 1 || event.shiftKey || (event.buttons & 6) !== 0;
      move(pans ? 'pan' : 'turn', by, event);
    }
    if (pointers.size > 1 && before.spread > 0 && now.spread > 0) move('zoom', now.spread / before.spread, event);
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    canvas.addEventListener(end, (event) => {
      pointers.delete(event.pointerId);
      canvas.classList.toggle('held', pointers.size > 0);
    });
  }
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    // A pinch on a touchpad comes as a wheel with Ctrl, in small steps.
    const speed = event.ctrlKey ? 0.01 : 0.0015;
    move('zoom', Math.exp(-Math.min(Math.max(pixels * speed, -1), 1)), event);
  }, { passive: false });

  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const arrow = arrows[event.key];
    if (arrow) move(event.shiftKey ? 'pan' : 'turn', arrow.map((step) => 0.05 * step), event);
    else if (event.key === '+' || event.key === '=') move('zoom', 1.15, event);
    else if (event.key === '-' || event.key === '_') move('zoom', 1 / 1.15, event);
    else if (event.key === '0' || event.key === 'Home') send('reset');
    else return;
    event.preventDefault();
  });
}

$('reset').addEventListener('click', () => send('reset'));

$('copy').addEventListener('click', async ({ target }) => {
  const selection = getSelection();
  selection.selectAllChildren($('camera'));
  let done = true;
  try {
    // Browsers have a clipboard for pages of this machine, and not for those of others without encryption.
    await navigator.clipboard.writeText($('camera').textContent);
  } catch {
    done = document.execCommand('copy');
  }
  target.textContent = done ? 'Copied' : 'Press Ctrl+C';
  setTimeout(() => { target.textContent = 'Copy'; }, 1500);
});

window.addEventListener('resize', () => { if (report) sharpen(); });
