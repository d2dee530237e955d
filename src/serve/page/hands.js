// Mouse, wheel, touch and keys on the pictures.

import { lanes, shownHeight } from './page.js';

// One movement is under way at a time: what hands do meanwhile is the next one, as a whole.
const moves = { turn: [0, 0], pan: [0, 0], zoom: 1, since: null };
let underWay = 0; // the last command of the movement whose picture was not seen yet
let timed = null; // when that movement began
let timer = 0;
/** Where pictures take longer than this, movements do not wait for them, in milliseconds. */
const PATIENCE = 300;
let send = () => {};
let lastId = () => 0;

/** Sends what hands do from now on. */
export function followHands(sender, lastIdSent) {
  send = sender;
  lastId = lastIdSent;
}

/** Takes notice of the answer to a command. When the movement began that it answers; none if it answers none. */
export function noteAnswer(answers) {
  if (underWay === 0 || answers < underWay) return null;
  const since = timed;
  goOn();
  return since;
}

/** What was under way is over, or took too long. */
function goOn() {
  clearTimeout(timer);
  underWay = 0;
  sendMoves();
}

function move(kind, value, event) {
  if (kind === 'zoom') {
    moves.zoom *= value;
  } else {
    moves[kind][0] += value[0];
    moves[kind][1] += value[1];
  }
  moves.since ??= event.timeStamp;
  if (underWay === 0) sendMoves();
}

function sendMoves() {
  if (moves.since === null) return;
  const within = (value, limit) => Math.min(Math.max(value, -limit), limit);
  for (const kind of ['turn', 'pan']) {
    const [right, down] = moves[kind];
    if (right !== 0 || down !== 0) send({ [kind]: [within(right, 10), within(down, 10)] });
    moves[kind] = [0, 0];
  }
  if (moves.zoom !== 1) send({ zoom: Math.min(Math.max(moves.zoom, 0.01), 100) });
  moves.zoom = 1;
  [timed, moves.since] = [moves.since, null];
  underWay = lastId();
  timer = setTimeout(goOn, PATIENCE);
}

// Browsers keep `pointermove` back until the next frame; some have an event that comes at once.
const POINTER_MOVED = 'onpointerrawupdate' in window ? 'pointerrawupdate' : 'pointermove';

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
  canvas.addEventListener(POINTER_MOVED, (event) => {
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
