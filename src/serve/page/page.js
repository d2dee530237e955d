// The parts of the page that several scripts use.

export const $ = (id) => document.getElementById(id);

export const lanes = [0, 1].map((i) => ({
  figure: $(`lane-${i}`),
  canvas: $(`lane-${i}`).querySelector('canvas'),
  caption: $(`lane-${i}`).querySelector('figcaption'),
  select: $(`structure-${i}`),
  summary: $(`summary-${i}`),
  options: $(`options-${i}`),
  coarse: document.createElement('canvas'),
  synced: null, // the structure that the controls show
}));

/** The height at which a canvas shows its picture, in CSS pixels. */
export function shownHeight(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  return Math.max(1, Math.min(height, (width * canvas.height) / canvas.width));
}
