// The table of the cells: sorts, finds, and makes only the rows that are seen.
import { countOf, formatValue, make, spellOut } from './format.js';

const rowHeight = 28;
const spare = 8;

export class CellTable {
  /** \param onSelect is called with the cell of a row that was chosen. */
  constructor(element, status, tissue, onSelect) {
    this.tissue = tissue;
    this.status = status;
    this.onSelect = onSelect;
    this.order = Array.from({ length: tissue.numberOfCells }, (_, c) => c);
    this.sortedBy = { column: tissue.find('Label'), isAscending: true };
    this.wanted = '';
    this.selected = -1;
    this.isShown = () => true;
    this.columns = [...tissue.columns].sort((a, b) => this.rank(a) - this.rank(b));
    this.body = make('tbody');
    const heads = this.columns.map((column) => this.makeHead(column));
    this.heads = heads;
    const table = make('table', { 'aria-label': 'Cells', 'aria-rowcount': tissue.numberOfCells + 1 },
      make('thead', {}, make('tr', {}, ...heads)), this.body);
    this.grid = make('div', { class: 'grid', tabindex: 0, 'aria-label': 'Table of cells', role: 'region' }, table);
    this.grid.addEventListener('scroll', () => this.firstRow() !== this.first && this.draw());
    this.grid.addEventListener('keydown', (event) => this.press(event));
    this.body.addEventListener('click', (event) => {
      const row = event.target.closest('tr[data-cell]');
      if (row) {
        this.onSelect(Number(row.dataset.cell));
      }
    });
    element.replaceChildren(this.grid);
    this.sort();
  }

  /** Names come after labels. */
  rank(column) {
    return column.kind === 'label' ? 0 : column.kind === 'text' ? 1 : 2;
  }

  makeHead(column) {
    const title = column.name + (column.unit ? ` in ${column.unit}` : '');
    const text = spellOut(column.name).replace(/ (?=\S+$)/, '\n') + (column.unit ? ` (${column.unit})` : '');
    const button = make('button', { type: 'button', title: `Sort by ${title}`, onclick: () => this.sortBy(column) }, text);
    return make('th', { scope: 'col', 'data-column': column.name }, button);
  }

  sortBy(column) {
    const isAscending = this.sortedBy.column === column ? !this.sortedBy.isAscending : true;
    this.sortedBy = { column, isAscending };
    this.sort();
  }

  /** Only the rows whose label or name has this text. */
  find(text) {
    this.wanted = text.trim().toLowerCase();
    this.sort();
  }

  sort() {
    const { column, isAscending } = this.sortedBy;
    const sign = isAscending ? 1 : -1;
    const compare = column.numbers
      ? (a, b) => column.numbers[a] - column.numbers[b]
      : (a, b) => column.values[a].localeCompare(column.values[b], undefined, { numeric: true });
    const isUnknown = (c) => (column.numbers ? Number.isNaN(column.numbers[c]) : column.values[c] === '');
    this.order = Array.from({ length: this.tissue.numberOfCells }, (_, c) => c)
      .filter((c) => this.tissue.nameOf(c).toLowerCase().includes(this.wanted))
      .sort((a, b) => isUnknown(a) - isUnknown(b) || sign * compare(a, b) || a - b);
    this.heads.forEach((head) => {
      const isSorted = head.dataset.column === column.name;
      head.setAttribute('aria-sort', isSorted ? (isAscending ? 'ascending' : 'descending') : 'none');
    });
    const all = this.tissue.numberOfCells;
    this.status.textContent = this.wanted ? `${this.order.length} of ${countOf(all, 'cell')}` : countOf(all, 'cell');
    this.draw();
  }

  /** The first row to make: it changes once in some rows, so that most scrolling keeps the rows. */
  firstRow() {
    return Math.max((Math.floor(this.grid.scrollTop / rowHeight / spare) - 1) * spare, 0);
  }

  /** Makes the rows that are seen, and space for all others. */
  draw() {
    this.first = this.firstRow();
    const { first } = this;
    const last = Math.min(first + Math.ceil(this.grid.clientHeight / rowHeight) + 3 * spare, this.order.length);
    const space = (rows) => make('tr', { 'aria-hidden': 'true', style: `height:${rows * rowHeight}px` });
    const rows = this.order.slice(first, last).map((cell, i) => this.makeRow(cell, first + i));
    this.body.replaceChildren(space(first), ...rows, space(this.order.length - last));
  }

  makeRow(cell, place) {
    const row = make('tr', {
      'data-cell': cell,
      'aria-rowindex': place + 2,
      'aria-selected': String(cell === this.selected),
      class: this.isShown(cell) ? undefined : 'out',
    });
    for (const column of this.columns) {
      row.append(make('td', { class: column.kind === 'text' ? 'text' : undefined }, formatValue(column, cell)));
    }
    return row;
  }

  /** Marks the row of a cell and scrolls to it; -1 for none. */
  select(cell) {
    this.selected = cell;
    const place = this.order.indexOf(cell);
    if (place >= 0) {
      const head = this.grid.querySelector('thead').offsetHeight;
      const top = place * rowHeight;
      const seen = this.grid.clientHeight - head - rowHeight;
      if (top < this.grid.scrollTop || top > this.grid.scrollTop + seen) {
        this.grid.scrollTop = top - seen / 2;
      }
    }
    this.draw();
  }

  /** The cell some rows on from the selected one. */
  step(rows) {
    const place = this.order.indexOf(this.selected);
    const next = place < 0 ? 0 : Math.min(Math.max(place + rows, 0), this.order.length - 1);
    if (this.order.length > 0) {
      this.onSelect(this.order[next]);
    }
  }

  press(event) {
    const rows = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 }[event.key];
    if (rows && event.target === this.grid) {
      event.preventDefault();
      this.step(rows);
    }
  }
}
