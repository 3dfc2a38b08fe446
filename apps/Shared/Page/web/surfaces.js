// The closed surface of each cell by points of its own, so that each can be moved, hidden and picked by itself.

/** Each wall by its own points, with their normals, its triangles and its outline: as the wall is in its first cell. */
function collectWalls(tissue) {
  const { points, triangles, walls } = tissue;
  const isOnLine = findLines(tissue);
  const owner = new Int32Array(points.length / 3).fill(-1);
  const number = new Int32Array(points.length / 3);
  const collected = [];
  for (let w = 0, t = 0; 3 * w < walls.length; ++w) {
    const end = t + walls[3 * w + 2];
    const ids = [];
    const corners = new Uint32Array(3 * (end - t));
    for (let i = 3 * t; i < 3 * end; ++i) {
      const p = triangles[i];
      if (owner[p] !== w) {
        owner[p] = w;
        number[p] = ids.length;
        ids.push(p);
      }
      corners[i - 3 * t] = number[p];
    }
    const position = new Float32Array(3 * ids.length);
    ids.forEach((p, i) => {
      position[3 * i] = points[3 * p];
      position[3 * i + 1] = points[3 * p + 1];
      position[3 * i + 2] = points[3 * p + 2];
    });
    const outline = findOutline(corners, ids.map((p) => isOnLine[p]));
    collected.push({ ids, position, normal: computeNormals(position, corners), corners, outline });
    t = end;
  }
  return collected;
}

/** Whether each point is of several walls. */
function findLines({ points, triangles, walls }) {
  const first = new Int32Array(points.length / 3).fill(-1);
  const isOnLine = new Uint8Array(points.length / 3);
  for (let w = 0, i = 0; 3 * w < walls.length; ++w) {
    for (const end = i + 3 * walls[3 * w + 2]; i < end; ++i) {
      const p = triangles[i];
      if (first[p] < 0) {
        first[p] = w;
      } else if (first[p] !== w) {
        isOnLine[p] = 1;
      }
    }
  }
  return isOnLine;
}

/** The sum of the triangles' normals, by their areas, at each point; of length 1. */
function computeNormals(position, corners) {
  const normal = new Float32Array(position.length);
  for (let i = 0; i < corners.length; i += 3) {
    const a = 3 * corners[i];
    const b = 3 * corners[i + 1];
    const c = 3 * corners[i + 2];
    const ux = position[b] - position[a];
    const uy = position[b + 1] - position[a + 1];
    const uz = position[b + 2] - position[a + 2];
    const vx = position[c] - position[a];
    const vy = position[c + 1] - position[a + 1];
    const vz = position[c + 2] - position[a + 2];
    for (let k = 0; k < 3; ++k) {
      const p = 3 * corners[i + k];
      normal[p] += uy * vz - uz * vy;
      normal[p + 1] += uz * vx - ux * vz;
      normal[p + 2] += ux * vy - uy * vx;
    }
  }
  for (let p = 0; p < normal.length; p += 3) {
    const length = Math.sqrt(normal[p] ** 2 + normal[p + 1] ** 2 + normal[p + 2] ** 2) || 1;
    normal[p] /= length;
    normal[p + 1] /= length;
    normal[p + 2] /= length;
  }
  return normal;
}

// Above any number of points of a wall; two of them make a number that is still exact.
const span = 2 ** 26;

/** The edges that one triangle has alone, two points each; they are all between points that the wall shares. A wall that
 * shares none, as that of a cell with no neighbour, has no outline. */
function findOutline(corners, isShared) {
  const edges = new Set();
  for (let i = 0; i < corners.length; ++i) {
    const a = corners[i];
    const b = corners[i % 3 === 2 ? i - 2 : i + 1];
    if (isShared[a] && isShared[b] && !edges.delete(b * span + a)) {
      edges.add(a * span + b);
    }
  }
  const outline = [];
  for (const edge of edges) {
    outline.push(Math.floor(edge / span), edge % span);
  }
  return outline;
}

/** How many points, corners and ends of edges each cell has, summed up: `starts[c]` is the first of cell c. */
function sumUp(tissue, collected, sizeOf) {
  const starts = new Uint32Array(tissue.numberOfCells + 1);
  for (let w = 0; w < collected.length; ++w) {
    for (const row of [tissue.walls[3 * w], tissue.walls[3 * w + 1]]) {
      if (row > 0) {
        starts[row] += sizeOf(collected[w]);
      }
    }
  }
  for (let c = 0; c < tissue.numberOfCells; ++c) {
    starts[c + 1] += starts[c];
  }
  return starts;
}

/** The ways from the mean of all cells' centres to each. */
function findWays(tissue) {
  const ways = new Float32Array(3 * tissue.numberOfCells);
  ['CenterX', 'CenterY', 'CenterZ'].forEach((name, axis) => {
    const numbers = tissue.find(name).numbers;
    const mean = numbers.reduce((sum, value) => sum + value, 0) / numbers.length;
    numbers.forEach((value, c) => {
      ways[3 * c + axis] = value - mean;
    });
  });
  return ways;
}

/** Adds a wall to the surface of a cell, `side` 0 for the first of its cells and 1 for the second, at the places `at` of
 * the next point, corner and edge. */
function addPart(surfaces, wall, side, cell, other, at) {
  const first = at.point[cell];
  const part = { cell, other, corners: [at.corner[cell]], edges: [at.edge[cell]] };
  surfaces.ids.set(wall.ids, first);
  surfaces.points.set(wall.position, 3 * first);
  surfaces.normals.set(side === 0 ? wall.normal : wall.normal.map((n) => -n), 3 * first);
  for (let i = 0; i < wall.corners.length; ++i) {
    // The second cell sees the wall's triangles from behind.
    const turned = side === 0 || i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1;
    surfaces.corners[at.corner[cell]++] = first + wall.corners[turned];
  }
  for (let i = 0; i < wall.outline.length; i += 2) {
    surfaces.edges[at.edge[cell]++] = first + wall.outline[i + side];
    surfaces.edges[at.edge[cell]++] = first + wall.outline[i + 1 - side];
  }
  at.point[cell] += wall.ids.length;
  part.corners.push(at.corner[cell]);
  part.edges.push(at.edge[cell]);
  surfaces.parts.push(part);
}

/** \brief The surfaces of all cells, those of cell c from `pointStart[c]`, `cornerStart[c]` and `edgeStart[c]` on.
 *
 * Three `corners` are a triangle, turned outwards, two of `edges` an edge of a wall, both by numbers of `points`; `ids` are
 * the points' numbers in the mesh. */
export function buildSurfaces(tissue) {
  const collected = collectWalls(tissue);
  const pointStart = sumUp(tissue, collected, (wall) => wall.ids.length);
  const cornerStart = sumUp(tissue, collected, (wall) => wall.corners.length);
  const edgeStart = sumUp(tissue, collected, (wall) => wall.outline.length);
  const last = tissue.numberOfCells;
  const surfaces = {
    numberOfCells: last,
    pointStart,
    cornerStart,
    edgeStart,
    ways: findWays(tissue),
    ids: new Uint32Array(pointStart[last]),
    numberOfIds: tissue.points.length / 3,
    points: new Float32Array(3 * pointStart[last]),
    normals: new Float32Array(3 * pointStart[last]),
    corners: new Uint32Array(cornerStart[last]),
    edges: new Uint32Array(edgeStart[last]),
    // The walls of the cells, each on its side: the cells, the other -1 outside, and where its corners and edges are.
    parts: [],
  };
  const at = { point: pointStart.slice(), corner: cornerStart.slice(), edge: edgeStart.slice() };
  collected.forEach((wall, w) => {
    const cells = [tissue.walls[3 * w] - 1, tissue.walls[3 * w + 1] - 1];
    for (const side of [0, 1].filter((k) => cells[k] >= 0)) {
      addPart(surfaces, wall, side, cells[side], cells[1 - side], at);
    }
  });
  return surfaces;
}

/** The points with every cell moved by a share of its way. */
export function movePoints(surfaces, share) {
  const moved = surfaces.points.slice();
  for (let c = 0; share > 0 && c < surfaces.numberOfCells; ++c) {
    for (let i = 3 * surfaces.pointStart[c]; i < 3 * surfaces.pointStart[c + 1]; ++i) {
      moved[i] += share * surfaces.ways[3 * c + (i % 3)];
    }
  }
  return moved;
}

/** For vtkCellArray: polygons or lines of `size` points, with that number before each. */
export function listPrimitives(indices, size) {
  const list = new Uint32Array((indices.length / size) * (size + 1));
  for (let i = 0, at = 0; i < indices.length; ++i) {
    if (i % size === 0) {
      list[at++] = size;
    }
    list[at++] = indices[i];
  }
  return list;
}

/** \brief The corners and edges that can be seen of the cells that are shown.
 *
 * Of cells that are together, these are those of walls with nothing behind them. Of cells apart an edge is in two walls of
 * a cell, and listed for one. */
export function findSeen(surfaces, isShown, isApart) {
  const { corners, edges, ids, parts } = surfaces;
  const seen = { corners: [], edges: [] };
  for (const part of parts) {
    if (isShown[part.cell] && (isApart || part.other < 0 || !isShown[part.other])) {
      for (let i = part.corners[0]; i < part.corners[1]; ++i) {
        seen.corners.push(corners[i]);
      }
      for (let i = part.edges[0]; i < part.edges[1]; i += 2) {
        if (!isApart || ids[edges[i]] < ids[edges[i + 1]]) {
          seen.edges.push(edges[i], edges[i + 1]);
        }
      }
    }
  }
  return seen;
}

/** The cell that a ray meets first, or -1. What is below the plane is cut away, and a cell that the ray is in there is
 * met at the plane. */
export function pickCell(surfaces, points, isShown, ray, plane) {
  const start = plane ? (plane.offset - dot(plane.normal, ray.origin)) / dot(plane.normal, ray.direction) : 0;
  let nearest = { distance: Infinity, cell: -1 };
  for (let c = 0; c < surfaces.numberOfCells; ++c) {
    const hit = isShown[c] ? findFirstHit(surfaces, points, c, ray, plane) : null;
    const distance = hit && (hit.isLeft && plane ? start : hit.distance);
    if (hit && distance < nearest.distance) {
      nearest = { distance, cell: c };
    }
  }
  return nearest.cell;
}

/** Where a ray meets the surface of a cell first, and whether it leaves the cell there; null where it does not. */
function findFirstHit(surfaces, points, cell, ray, plane) {
  const [ox, oy, oz] = ray.origin;
  const [dx, dy, dz] = ray.direction;
  const { corners, cornerStart } = surfaces;
  let hit = null;
  for (let i = cornerStart[cell]; i < cornerStart[cell + 1]; i += 3) {
    // Möller and Trumbore 1997, doi:10.1080/10867651.1997.10487468.
    const [a, b, c] = [3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2]];
    const [ux, uy, uz] = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
    const [vx, vy, vz] = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const determinant = ux * px + uy * py + uz * pz;
    const [sx, sy, sz] = [ox - points[a], oy - points[a + 1], oz - points[a + 2]];
    const first = (sx * px + sy * py + sz * pz) / determinant;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const second = (dx * qx + dy * qy + dz * qz) / determinant;
    const distance = (vx * qx + vy * qy + vz * qz) / determinant;
    const isMet = first >= 0 && second >= 0 && first + second <= 1 && distance > 0 && distance < (hit?.distance ?? Infinity);
    const at = [ox + distance * dx, oy + distance * dy, oz + distance * dz];
    if (isMet && !(plane && dot(plane.normal, at) < plane.offset)) {
      hit = { distance, isLeft: determinant < 0 };
    }
  }
  return hit;
}

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The edges of a cell's walls; those of all its triangles where it has one wall alone. */
function listEdges({ edges, edgeStart, corners, cornerStart }, cell) {
  const own = [...edges.subarray(edgeStart[cell], edgeStart[cell + 1])];
  const all = corners.subarray(cornerStart[cell], cornerStart[cell + 1]);
  return own.length > 0 ? own : [...all].flatMap((p, i) => [p, all[i % 3 === 2 ? i - 2 : i + 1]]);
}

/** Bars of four sides along the edges of a cell: three coordinates for each corner of their triangles. */
export function thickenEdges(surfaces, points, cell, radius) {
  const coordinates = [];
  const edges = listEdges(surfaces, cell);
  for (let i = 0; i < edges.length; i += 2) {
    const [a, b] = [edges[i], edges[i + 1]].map((p) => points.subarray(3 * p, 3 * p + 3));
    const along = [0, 1, 2].map((axis) => b[axis] - a[axis]);
    const least = along.reduce((best, value, axis) => (Math.abs(value) < Math.abs(along[best]) ? axis : best), 0);
    const u = scaleTo(cross(along, [0, 1, 2].map((axis) => Number(axis === least))), radius);
    const v = scaleTo(cross(along, u), radius);
    const sides = [u, v, u.map((x) => -x), v.map((x) => -x)];
    sides.forEach((side, k) => {
      const next = sides[(k + 1) % 4];
      const [p, q, r, s] = [add(a, side), add(b, side), add(b, next), add(a, next)];
      coordinates.push(...p, ...q, ...r, ...p, ...r, ...s);
    });
  }
  return Float32Array.from(coordinates);
}

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export function scaleTo(vector, length) {
  const factor = length / (Math.hypot(...vector) || 1);
  return vector.map((x) => x * factor);
}
