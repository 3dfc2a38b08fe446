// What is known of the selected cell.
import { formatValue, make, spellOut } from './format.js';

/** \param onSelect is called with the cell of a neighbour that was chosen. */
export function showSelection(element, tissue, neighbors, cell, onSelect) {
  if (cell < 0) {
    element.replaceChildren(make('p', {}, 'No cell is selected.'));
    return;
  }
  const list = make('dl');
  for (const column of tissue.columns.filter((c) => c.kind !== 'label')) {
    list.append(make('dt', { title: column.name }, spellOut(column.name)));
    list.append(make('dd', {}, `${formatValue(column, cell)} ${column.unit}`.trim()));
  }
  const remarks = tissue.report.remarks.filter((remark) => String(remark.label) === tissue.labels[cell]);
  const chips = neighbors[cell].map((other) =>
    make('button', { type: 'button', title: `Select cell ${tissue.labels[other]}`, onclick: () => onSelect(other) }, tissue.labels[other]));
  element.replaceChildren(
    make('h3', {}, `Cell ${tissue.nameOf(cell)}`),
    ...remarks.map((remark) => make('p', {}, remark.text)),
    list,
    make('p', {}, chips.length > 0 ? 'Neighbours' : 'No neighbours'),
    make('div', { class: 'chips' }, ...chips),
  );
}
