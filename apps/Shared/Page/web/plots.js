// The report: the stages and times as plots, the remarks, and all the rest as lists.
import { chooseTicks, countOf, formatNumber, make, spellOut } from './format.js';


const width = 520;
const labelWidth = 150;
const barHeight = 15;

/** Stages and steps of the report, for people; others are as they are called. */
const stepNames = {
  closeGaps: 'closing of gaps',
  extractJunctions: 'search for junctions',
  delaunay: 'Delaunay',
  cleaned: 'clean-up',
  nerve: "image's own complex",
  optimized: 'optimization',
  dual: 'dual and fit',
  check: 'check and statistics',
};
const nameStep = (name) => stepNames[name] ?? spellOut(name).toLowerCase();

/** Horizontal bars in groups. \param groups of `name` and `bars`, of `value`, `text` and `color`. */
function drawBars(groups, greatest, axis) {
  const plotWidth = width - labelWidth - 60;
  const heights = groups.map((group) => group.bars.length * (barHeight + 2) + 9);
  const height = heights.reduce((sum, h) => sum + h, 0) + 34;
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': axis });
  const toX = (value) => labelWidth + (value / greatest) * plotWidth;
  for (const tick of chooseTicks(0, greatest, 5)) {
    const x = toX(tick);
    svg.append(make('line', { x1: x, x2: x, y1: 0, y2: height - 32, class: 'axis' }));
    svg.append(make('text', { x, y: height - 20, 'text-anchor': 'middle', class: 'faint' }, formatNumber(tick)));
  }
  svg.append(make('text', { x: labelWidth + plotWidth / 2, y: height - 4, 'text-anchor': 'middle' }, axis));
  let y = 3;
  groups.forEach((group, g) => {
    const middle = y + (heights[g] - 9) / 2 + 3;
    svg.append(make('text', { x: labelWidth - 8, y: middle, 'text-anchor': 'end' }, group.name));
    group.bars.forEach((bar, i) => {
      const top = y + i * (barHeight + 2);
      const length = Math.max(toX(bar.value) - labelWidth, 0.5);
      svg.append(make('rect', { x: labelWidth, y: top, width: length, height: barHeight, fill: bar.color, rx: 2 }));
      svg.append(make('text', { x: labelWidth + length + 5, y: top + 12 }, bar.text));
    });
    y += heights[g];
  });
  return svg;
}

function makeFigure(title, drawing, caption) {
  return make('figure', {}, make('h3', {}, title), drawing, make('figcaption', {}, ...[caption].flat()));
}

const measures = [
  ['adjacency2', 'pairs of neighbours (adjacency2)', 'var(--bar)'],
  ['adjacency4', 'groups of four cells (adjacency4)', '#e69f00'],
  ['adjacency4OfNeighbors', 'of four that are all neighbours', '#009e73'],
];

function drawStages(title, stages) {
  const groups = Object.entries(stages)
    .filter(([, stage]) => Number.isFinite(stage?.adjacency2))
    .map(([name, stage]) => ({
      name: nameStep(name),
      bars: measures
        .filter(([key]) => Number.isFinite(stage[key]))
        .map(([key, , color]) => ({ value: stage[key], text: stage[key].toFixed(3), color })),
    }));
  if (groups.length === 0) {
    return null;
  }
  const keys = measures.map(([, name, color]) => {
    const swatch = make('span', { class: 'swatch', style: `background:${color}` });
    return make('span', { style: 'white-space:nowrap;margin-right:1em' }, swatch, name);
  });
  return makeFigure(title, drawBars(groups, 1, 'share that is right, no unit (Jaccard index)'), keys);
}

function drawSeconds(seconds) {
  const steps = Object.entries(seconds).filter(([name, value]) => name !== 'threads' && value > 0);
  const total = steps.reduce((sum, [, value]) => sum + value, 0);
  const greatest = Math.max(...steps.map(([, value]) => value), 1e-3);
  const groups = steps.map(([name, value]) => ({
    name: nameStep(name),
    bars: [{ value, text: `${formatNumber(Number(value.toPrecision(3)))} s`, color: 'var(--bar)' }],
  }));
  const caption = `${formatNumber(Number(total.toPrecision(3)))} s in all, on ${countOf(seconds.threads, 'thread')}; without writing.`;
  return makeFigure('Time of the steps', drawBars(groups, greatest, 'time (s)'), caption);
}

function drawEnergy(cycles) {
  const values = cycles.map((cycle) => cycle.energy);
  const [least, greatest] = [Math.min(...values), Math.max(...values)];
  const [left, top, w, h] = [64, 8, 436, 150];
  const toX = (i) => left + (i / (values.length - 1)) * w;
  const toY = (value) => top + h - ((value - least) / (greatest - least || 1)) * h;
  const svg = make('svg', { viewBox: '0 0 520 200', role: 'img', 'aria-label': 'Energy of each cycle' });
  for (const tick of chooseTicks(least, greatest, 4)) {
    svg.append(make('line', { x1: left, x2: left + w, y1: toY(tick), y2: toY(tick), class: 'axis' }));
    svg.append(make('text', { x: left - 6, y: toY(tick) + 4, 'text-anchor': 'end', class: 'faint' }, formatNumber(tick)));
  }
  const line = values.map((value, i) => `${toX(i)},${toY(value)}`).join(' ');
  svg.append(make('polyline', { points: line, fill: 'none', stroke: 'var(--bar)', 'stroke-width': 2 }));
  for (const tick of chooseTicks(1, values.length, 6).filter(Number.isInteger)) {
    svg.append(make('text', { x: toX(tick - 1), y: top + h + 16, 'text-anchor': 'middle', class: 'faint' }, String(tick)));
  }
  svg.append(make('text', { x: left + w / 2, y: top + h + 34, 'text-anchor': 'middle' }, 'cycle of the optimization'));
  return makeFigure('Energy of the complex', svg, 'The energy after each cycle, no unit.');
}

export function drawPlots(element, report) {
  const { against, ...evaluation } = report.evaluation ?? {};
  const figures = [
    drawStages('Adjacency after each stage, by the image', report.stages ?? {}),
    report.evaluation ? drawStages(`Adjacency after each stage, by ${against}`, evaluation) : null,
    drawSeconds(report.seconds),
    report.cycles?.length > 1 ? drawEnergy(report.cycles) : null,
  ];
  element.replaceChildren(...figures.filter(Boolean));
  if (!figures[0] && !figures[1]) {
    element.prepend(makeFigure('Adjacency after each stage', '', 'There is no label image to compare the stages with.'));
  }
}

export function listWarnings(element, report) {
  if (report.warnings.length > 0) {
    element.replaceChildren(make('ul', {}, ...report.warnings.map((text) => make('li', {}, text))));
  }
}

const firstRemarks = 200;

/** \param onSelect is called with the label of a remark's cell. */
export function listRemarks(element, report, onSelect) {
  const { remarks } = report;
  const makeRow = (remark) => {
    const label = String(remark.label);
    const button = make('button', { type: 'button', title: `Select cell ${label}`, onclick: () => onSelect(label) }, label);
    return make('tr', {}, make('td', {}, button), make('td', {}, remark.text));
  };
  const body = make('tbody', {}, ...remarks.slice(0, firstRemarks).map(makeRow));
  const table = make('table', {},
    make('thead', {}, make('tr', {}, make('th', { scope: 'col' }, 'Cell'), make('th', { scope: 'col' }, 'Remark'))), body);
  const title = make('h3', {}, `Remarks on cells (${remarks.length})`);
  if (remarks.length === 0) {
    element.replaceChildren(title, 'None: no cell was lost or changed.');
    return;
  }
  element.replaceChildren(title, make('div', { class: 'list', tabindex: 0, role: 'region', 'aria-label': 'Remarks' }, table));
  if (remarks.length > firstRemarks) {
    const button = make('button', { type: 'button' }, `Show all ${remarks.length}`);
    button.addEventListener('click', () => {
      body.append(...remarks.slice(firstRemarks).map(makeRow));
      button.remove();
    });
    element.append(button);
  }
}

/** All values of an object as a list of names and texts, those of objects in it by both names. */
export function listFacts(element, facts) {
  const list = make('dl', { class: 'facts' });
  const toText = (value) => (value === null || value === '' ? '–' : typeof value === 'number' ? formatNumber(value)
    : Array.isArray(value) ? value.map(toText).join(', ') || 'none' : typeof value === 'boolean' ? (value ? 'yes' : 'no') : String(value));
  const append = (object, prefix) => {
    for (const [name, value] of Object.entries(object)) {
      const isList = Array.isArray(value) && value.some((item) => typeof item === 'object');
      if (value !== null && typeof value === 'object' && !Array.isArray(value)) {
        append(value, `${prefix}${spellOut(name)}: `);
      } else {
        const text = isList ? `${value.length}` : toText(value);
        list.append(make('div', {}, make('dt', {}, prefix + spellOut(name)), make('dd', {}, text)));
      }
    }
  };
  append(facts, '');
  element.replaceChildren(list);
}
