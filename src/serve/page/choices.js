// The controls of structures, their options and views.

import { $, lanes } from './page.js';

let choices = null; // what there is to choose from
let send = () => 0;
let asked = 0; // the last command that chose structures

/** Fills the controls with what there is, and sends what is chosen. */
export function offerChoices(greeting, sender) {
  choices = greeting;
  send = sender;
  for (const { select } of lanes) {
    select.replaceChildren(...choices.structures.map(({ name }) => new Option(name, name)));
  }
  $('view').replaceChildren(...choices.views.map(({ name }) => new Option(name, name)));
}

const structureNamed = (name) => choices.structures.find((one) => one.name === name);

/** Shows the controls of a structure as the program has it, unless they do already or it has not read them yet. */
export function sync(i, { structure, base }, answers) {
  const lane = lanes[i];
  if (lane.synced === structure || answers < asked) return;
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
    control.title = `${option.summary} (default: ${option.default})`;
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
  const chosenLanes = $('race').checked ? lanes : lanes.slice(0, 1);
  // The controls show it already; if it is refused, they will show what there is.
  for (const lane of chosenLanes) lane.synced = chosen(lane);
  asked = send({ structures: chosenLanes.map(chosen) });
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

export function describeView() {
  const view = choices.views.find(({ name }) => name === $('view').value);
  $('summary-view').textContent = view?.summary ?? '';
}
