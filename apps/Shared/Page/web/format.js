// Numbers and names for people.

/** A number in up to five digits; what is not known is a dash. */
export function formatNumber(value) {
  if (!Number.isFinite(value)) {
    return '–';
  }
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e15) {
    return String(value);
  }
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(3) : String(Number(value.toPrecision(5)));
  return text.replace('-', '−');
}

export function formatValue(column, row) {
  if (column.kind === 'flag') {
    return column.numbers[row] ? 'yes' : 'no';
  }
  return column.kind === 'number' ? formatNumber(column.numbers[row]) : String(column.values[row]);
}

/** `NumberOfNeighbors` as `Number of neighbors`. */
export function spellOut(name) {
  const words = name.replace(/([a-z])([A-Z0-9])/g, '$1 $2').replace(/([A-Z])([A-Z][a-z])/g, '$1 $2');
  return words.charAt(0).toUpperCase() + words.slice(1).replace(/[A-Z](?=[a-z])/g, (letter) => letter.toLowerCase());
}

/** `1 cell`, `2 cells`. */
export const countOf = (count, name) => `${count} ${name}${count === 1 ? '' : 's'}`;

export const withUnit = (name, unit) => (unit ? `${name} (${unit})` : name);

/** Round numbers from `least` to `greatest`, about `count` of them. */
export function chooseTicks(least, greatest, count) {
  const rough = (greatest - least) / count;
  if (!(rough > 0)) {
    return [least];
  }
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999);
  const ticks = [];
  for (let i = Math.ceil(least / step - 1e-9); i * step <= greatest + 1e-9 * step; ++i) {
    ticks.push(Number((i * step).toPrecision(12)));
  }
  return ticks;
}

/** An element with attributes, and children that are elements or text. */
export function make(name, attributes = {}, ...children) {
  const isSvg = ['svg', 'g', 'rect', 'text', 'line', 'path', 'circle', 'title', 'polyline'].includes(name);
  const element = isSvg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) {
      element.addEventListener(key.slice(2), value);
    } else if (value !== undefined && value !== false) {
      element.setAttribute(key, value);
    }
  }
  element.append(...children);
  return element;
}
