// Colours that people with any colour vision tell apart.

const parse = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
const stops = (text) => text.split(' ').map((color) => parse(`#${color}`));

/** Perceptually even maps of values, from the least to the greatest: viridis (Smith, van der Walt), cividis (Nuñez et
 * al. 2018, doi:10.1371/journal.pone.0199239); the last, from blue over white to orange, is for values with a sign. */
export const colorMaps = {
  viridis: stops('440154 482475 414487 355f8d 2a788e 21918c 22a884 44bf70 7ad151 bddf26 fde725'),
  cividis: stops('00224e 123570 3b496c 575d6d 707173 8a8678 a59c74 c3b369 e1cc55 fee838'),
  signed: stops('1f4e79 3f7db0 82b0d2 c3d9e8 f4f4f1 f6d7b0 eba862 cc7218 8a4705'),
};

/** Okabe and Ito 2008, black last. */
const categories = stops('e69f00 56b4e9 009e73 f0e442 0072b2 d55e00 cc79a7 999999');
const unknown = [150, 150, 150];

/** The colour at `share`, 0 to 1, of a map. */
export function colorAt(map, share) {
  const place = Math.min(Math.max(share, 0), 1) * (map.length - 1);
  const i = Math.min(Math.floor(place), map.length - 2);
  return map[i].map((channel, c) => Math.round(channel + (place - i) * (map[i + 1][c] - channel)));
}

export const toCss = (color) => `rgb(${color.join(' ')})`;

const isCategory = (column) => column.kind === 'category' || column.kind === 'flag';

function quantile(sorted, share) {
  const place = share * (sorted.length - 1);
  const i = Math.floor(place);
  return sorted[i] + (place - i) * ((sorted[i + 1] ?? sorted[i]) - sorted[i]);
}

/** The values that the ends of the map stand for: all, or without the outermost 2 % of them. */
function chooseRange(numbers, isClipped, isSigned) {
  const sorted = Float64Array.from(numbers).filter(Number.isFinite).sort();
  if (sorted.length === 0) {
    return { least: 0, greatest: 1, isClipped: false };
  }
  let [least, greatest] = [sorted[0], sorted[sorted.length - 1]];
  const all = [least, greatest];
  if (isClipped) {
    [least, greatest] = [quantile(sorted, 0.02), quantile(sorted, 0.98)];
  }
  if (isSigned) {
    greatest = Math.max(Math.abs(least), Math.abs(greatest));
    least = -greatest;
  }
  if (!(greatest > least)) {
    [least, greatest] = [least - 0.5, greatest + 0.5];
  }
  return { least, greatest, isClipped: all[0] < least || all[1] > greatest };
}

/** What the values of a column are coloured by: `colorOf(number)`, and what a legend needs. */
export function makeScale(column, mapName, isClipped) {
  if (isCategory(column)) {
    const values = [...new Set(column.numbers)].sort((a, b) => a - b);
    const first = column.kind === 'category' ? 1 : 0;
    const colorOf = (value) =>
      value < first ? unknown : categories[(value - first) % categories.length];
    const counts = values.map((value) => column.numbers.reduce((sum, v) => sum + (v === value), 0));
    return { kind: 'categories', values, counts, colorOf };
  }
  const isSigned = column.name.endsWith('Curvature');
  const map = colorMaps[isSigned ? 'signed' : mapName];
  const range = chooseRange(column.numbers, isClipped, isSigned);
  const shareOf = (value) => (value - range.least) / (range.greatest - range.least);
  const colorOf = (value) => (Number.isFinite(value) ? colorAt(map, shareOf(value)) : unknown);
  return { kind: 'range', ...range, map, shareOf, colorOf };
}

/** What a category is called. */
export function nameCategory(column, value) {
  if (column.kind === 'flag') {
    return value ? 'yes' : 'no';
  }
  return nameLayer(value);
}

export function nameLayer(value) {
  return value === 0 ? 'in no layer' : value === 1 ? '1 (epidermis)' : String(value);
}
