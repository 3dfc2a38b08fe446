// The legend of the colours, which is a histogram of the values too.
import { nameCategory, colorAt, toCss } from './colours.js';
import { chooseTicks, countOf, formatNumber, make, withUnit, spellOut } from './format.js';

const width = 300;
const plotHeight = 64;

function countBins(column, scale) {
  const isWhole = column.kind === 'count' && scale.greatest - scale.least <= 40;
  const numberOfBins = isWhole ? Math.round(scale.greatest - scale.least) + 1 : 30;
  const bins = new Array(numberOfBins).fill(0);
  let unknown = 0;
  for (const value of column.numbers) {
    if (Number.isFinite(value)) {
      const share = isWhole ? (value - scale.least + 0.5) / numberOfBins : scale.shareOf(value);
      ++bins[Math.min(Math.max(Math.floor(share * numberOfBins), 0), numberOfBins - 1)];
    } else {
      ++unknown;
    }
  }
  return { bins, unknown };
}

function drawRange(column, scale) {
  const { bins, unknown } = countBins(column, scale);
  const highest = Math.max(...bins, 1);
  const svg = make('svg', { viewBox: `0 0 ${width} ${plotHeight + 32}` });
  bins.forEach((count, i) => {
    const height = (count / highest) * (plotHeight - 12);
    const [x, w] = [(i / bins.length) * width, width / bins.length];
    const color = toCss(colorAt(scale.map, (i + 0.5) / bins.length));
    const bar = make('rect', { x, y: plotHeight - height, width: Math.max(w - 1, 0.5), height, fill: color });
    const [from, to] = [i, i + 1].map((k) => scale.least + (k / bins.length) * (scale.greatest - scale.least));
    bar.append(make('title', {}, `${countOf(count, 'cell')}: ${formatNumber(from)} to ${formatNumber(to)} ${column.unit}`));
    svg.append(bar);
  });
  svg.append(make('text', { x: width, y: 9, 'text-anchor': 'end', class: 'faint' }, `tallest: ${countOf(highest, 'cell')}`));
  for (let i = 0; i < 100; ++i) {
    const color = toCss(colorAt(scale.map, (i + 0.5) / 100));
    svg.append(make('rect', { x: i * 3, y: plotHeight + 2, width: 3.4, height: 10, fill: color }));
  }
  const ticks = chooseTicks(scale.least, scale.greatest, 4);
  for (const tick of ticks) {
    const x = scale.shareOf(tick) * width;
    const anchor = x < 20 ? 'start' : x > width - 20 ? 'end' : 'middle';
    svg.append(make('line', { x1: x, x2: x, y1: plotHeight + 12, y2: plotHeight + 16, stroke: 'currentColor' }));
    svg.append(make('text', { x, y: plotHeight + 28, 'text-anchor': anchor }, formatNumber(tick)));
  }
  const notes = [withUnit(spellOut(column.name), column.unit)];
  if (scale.isClipped) {
    notes.push('the ends hold all beyond');
  }
  if (unknown > 0) {
    notes.push(`grey: ${unknown} not known`);
  }
  return make('div', {}, svg, make('small', {}, notes.join('; ')));
}

function drawCategories(column, scale) {
  const list = make('div', { class: 'swatches' });
  const most = Math.max(...scale.counts);
  scale.values.forEach((value, i) => {
    const swatch = make('span', { class: 'swatch' });
    swatch.style.background = toCss(scale.colorOf(value));
    const bar = make('span', { class: 'swatch' });
    bar.style.cssText = `background:${toCss(scale.colorOf(value))};width:${(60 * scale.counts[i]) / most}px;height:.5em`;
    const row = make('span', {}, swatch, `${nameCategory(column, value)} `, bar, countOf(scale.counts[i], 'cell'));
    row.style.flexBasis = '100%';
    list.append(row);
  });
  return list;
}

/** Draws into an element; without a column every cell has a colour of its own. */
export function drawLegend(element, column, scale) {
  if (!column) {
    element.replaceChildren('Every cell has a colour unlike those of its neighbours.');
    element.setAttribute('aria-label', 'No legend');
    return;
  }
  const title = withUnit(spellOut(column.name), column.unit);
  element.replaceChildren(scale.kind === 'range' ? drawRange(column, scale) : drawCategories(column, scale));
  const range = scale.kind === 'range' ? `, from ${formatNumber(scale.least)} to ${formatNumber(scale.greatest)}` : '';
  element.setAttribute('aria-label', `Legend and histogram: ${title}${range}`);
}
