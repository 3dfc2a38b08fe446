// What lies over the view: the directions of the axes, and how long things are.
import { dot } from './surfaces.js';
import { chooseTicks, formatNumber, make } from './format.js';

const reach = 24;

export function drawAxes(element, scene) {
  const { right, up, forward } = scene.cameraAxes();
  const svg = make('svg', { viewBox: '-36 -36 72 72' });
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis, i) => ({
    name: 'xyz'[i],
    color: ['#d55e00', '#009e73', '#0072b2'][i],
    x: reach * dot(axis, right),
    y: -reach * dot(axis, up),
    depth: dot(axis, forward),
  }));
  for (const { name, color, x, y } of axes.sort((a, b) => b.depth - a.depth)) {
    svg.append(make('line', { x1: 0, y1: 0, x2: x, y2: y, stroke: color, 'stroke-width': 3, 'stroke-linecap': 'round' }));
    svg.append(make('text', { x: x * 1.35, y: y * 1.35 + 4, 'text-anchor': 'middle' }, name));
  }
  element.replaceChildren(svg);
}

/** A bar of a round length, as long as things at the middle of the view are. */
export function drawScale(element, scene, unit) {
  const size = scene.pixelSize();
  const length = chooseTicks(0, 140 * size, 3).pop();
  element.querySelector('span').textContent = `${formatNumber(length)} ${unit}`;
  element.querySelector('i').style.width = `${length / size}px`;
}
