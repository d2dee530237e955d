// The page of `srt view`: sends what hands do, draws what comes. All that is known of the scene is in the updates.

import { offerChoices } from './choices.js';
import { sharpen, showDelay, showFigures } from './figures.js';
import { followHands, noteAnswer } from './hands.js';
import { $, lanes } from './page.js';

let threads = 1;
let update = null; // one that is not drawn yet
let lastId = 0;

const address = new URL('socket', location.href);
address.protocol = 'ws:';
const socket = new WebSocket(address);
socket.binaryType = 'arraybuffer';

function send(command) {
  if (socket.readyState !== WebSocket.OPEN) return lastId;
  lastId += 1;
  socket.send(JSON.stringify({ id: lastId, do: command }));
  return lastId;
}

socket.onmessage = ({ data }) => {
  if (typeof data === 'string') {
    const { greeting } = JSON.parse(data);
    threads = greeting.threads;
    offerChoices(greeting, send);
    followHands(send, () => lastId);
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
  const { report, data, start } = update;
  update = null;
  let offset = start;
  report.lanes.forEach((lane, i) => {
    if (lane.picture_bytes === 0) return;
    const bytes = new Uint8ClampedArray(data, offset, lane.picture_bytes);
    const pixels = new ImageData(bytes, lane.picture_width, lane.picture_height);
    drawPicture(lanes[i], pixels, report);
    offset += lane.picture_bytes;
  });
  showFigures(report, threads);
  socket.send('drawn');
  const since = report.lanes.length > 0 ? noteAnswer(report.answers) : null;
  // The frame in which the picture is on the screen.
  if (since !== null) requestAnimationFrame(() => showDelay(performance.now() - since));
}

/** Draws a picture in the size of the finished one; a coarse one has fewer pixels. */
function drawPicture({ canvas, coarse }, pixels, { width, height }) {
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

window.addEventListener('resize', sharpen);
