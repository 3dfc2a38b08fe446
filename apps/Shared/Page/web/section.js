// The plane figures that a plane cuts out of cells.
import earcut from 'earcut';
import { cross, dot, scaleTo } from './surfaces.js';

/** The outlines of the figure of a cell, of points one after another, counter-clockwise around the cell as seen against
 * the normal. What does not close is left out. */
function traceOutlines(surfaces, points, height, cell) {
  const { ids, numberOfIds, corners, cornerStart } = surfaces;
  // From where it enters a triangle to where it leaves it: edges, by the points of the mesh, which walls share.
  const next = new Map();
  for (let i = cornerStart[cell]; i < cornerStart[cell + 1]; i += 3) {
    let [from, to] = [null, null];
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [corners[i + k], corners[i + ((k + 1) % 3)]];
      const [isAbove, isNextAbove] = [height[a] >= 0, height[b] >= 0];
      if (isAbove !== isNextAbove) {
        const key = Math.min(ids[a], ids[b]) * numberOfIds + Math.max(ids[a], ids[b]);
        const share = height[a] / (height[a] - height[b]);
        const point = [0, 1, 2].map((axis) => points[3 * a + axis] + share * (points[3 * b + axis] - points[3 * a + axis]));
        if (isAbove) {
          to = key;
        } else {
          from = { key, point };
        }
      }
    }
    if (from) {
      next.set(from.key, { to, point: from.point });
    }
  }
  const outlines = [];
  while (next.size > 0) {
    const start = next.keys().next().value;
    const outline = [];
    let key = start;
    while (next.has(key)) {
      const { to, point } = next.get(key);
      next.delete(key);
      outline.push(point);
      key = to;
    }
    if (key === start && outline.length > 2) {
      outlines.push(outline);
    }
  }
  return outlines;
}

const areaOf = (ring) =>
  ring.reduce((sum, [x, y], i) => sum + x * ring[(i + 1) % ring.length][1] - ring[(i + 1) % ring.length][0] * y, 0) / 2;

function isInside([x, y], ring) {
  let inside = false;
  ring.forEach(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) {
      inside = !inside;
    }
  });
  return inside;
}

/** Fills outlines, some of which may be holes in others: numbers of their points, one outline after the other. */
function fill(outlines, u, v) {
  const rings = outlines.map((outline) => outline.map((point) => [dot(point, u), dot(point, v)]));
  const firsts = outlines.map((_, r) => outlines.slice(0, r).reduce((sum, outline) => sum + outline.length, 0));
  const largest = rings.reduce((best, ring) => (Math.abs(areaOf(ring)) > Math.abs(best) ? areaOf(ring) : best), 0);
  const isHole = rings.map((ring) => areaOf(ring) * largest < 0);
  const filled = [];
  rings.forEach((ring, r) => {
    if (!isHole[r]) {
      const holes = rings.map((_, h) => h).filter((h) => isHole[h] && isInside(rings[h][0], ring));
      const parts = [r, ...holes];
      const numbers = parts.flatMap((part) => rings[part].map((_, i) => firsts[part] + i));
      const starts = holes.map((_, i) => parts.slice(0, i + 1).reduce((sum, part) => sum + rings[part].length, 0));
      filled.push(...earcut(parts.flatMap((part) => rings[part].flat()), starts).map((i) => numbers[i]));
    }
  });
  return filled;
}

/** \brief The figures of the cells that are shown.
 *
 * \returns `points`, three coordinates each, `cellOfPoint`, and the numbers of the ends of `lines` and of the corners of
 * `triangles`. */
export function cutCells(surfaces, points, isShown, plane) {
  const height = new Float32Array(points.length / 3);
  for (let p = 0; p < height.length; ++p) {
    height[p] = plane.normal[0] * points[3 * p] + plane.normal[1] * points[3 * p + 1] + plane.normal[2] * points[3 * p + 2] - plane.offset;
  }
  const u = scaleTo(cross(plane.normal, Math.abs(plane.normal[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]), 1);
  const v = cross(plane.normal, u);
  const section = { points: [], cellOfPoint: [], lines: [], triangles: [] };
  for (let c = 0; c < surfaces.numberOfCells; ++c) {
    const outlines = isShown[c] ? traceOutlines(surfaces, points, height, c) : [];
    const first = section.cellOfPoint.length;
    section.triangles.push(...fill(outlines, u, v).map((i) => first + i));
    for (const outline of outlines) {
      const begin = section.cellOfPoint.length;
      outline.forEach((point, i) => {
        section.points.push(...point);
        section.cellOfPoint.push(c);
        section.lines.push(begin + i, begin + ((i + 1) % outline.length));
      });
    }
  }
  return section;
}
