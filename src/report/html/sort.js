// Sorts a table by the column whose heading is pressed; pressed again, the other way round. The page is
// complete without it.
'use strict';
const UNITS = {
  ns: 1e-9, 'µs': 1e-6, ms: 1e-3, s: 1, KiB: 1024, MiB: 1048576, GiB: 1073741824, k: 1e3, M: 1e6, G: 1e9,
};
// The number of a cell, or undefined: `12 345`, `4.50 MiB`, `12.3 %`.
const number = (text) => {
  const found = /^(-?[\d.]+(?:e-?\d+)?)(?:\u00a0(\S+))?/.exec(text.replaceAll('\u202f', ''));
  return found ? Number(found[1]) * (UNITS[found[2]] ?? 1) : undefined;
};
const text = (row, column) => (row.cells[column]?.firstChild?.textContent ?? '').trim();
const compare = (numeric, column) => (a, b) => {
  const [one, other] = [text(a, column), text(b, column)];
  if (!numeric) return one.localeCompare(other);
  const [x, y] = [number(one), number(other)];
  // What has no number comes last.
  if (x === undefined || y === undefined) return (x === undefined) - (y === undefined);
  return x - y;
};
const sort = (table, heading) => {
  const column = heading.cellIndex;
  const falls = heading.getAttribute('aria-sort') === 'ascending';
  const rows = [...table.tBodies[0].rows].sort(compare(heading.classList.contains('number'), column));
  if (falls) rows.reverse();
  for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
  heading.setAttribute('aria-sort', falls ? 'descending' : 'ascending');
  // Rows with equal first cells are no longer together.
  for (const row of rows) row.className = '';
  table.tBodies[0].append(...rows);
};
for (const table of document.querySelectorAll('table')) {
  if (table.tBodies[0].rows.length < 3) continue;
  for (const heading of table.tHead.rows[0].cells) {
    heading.classList.add('sorts');
    heading.tabIndex = 0;
    heading.title = 'Sort by this column';
    heading.addEventListener('click', () => sort(table, heading));
    heading.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      sort(table, heading);
    });
  }
}
