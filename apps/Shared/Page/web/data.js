// Reads the data of the page: see PageFile.h for what there is.

function toBytes(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) {
    bytes[i] = characters.charCodeAt(i);
  }
  return bytes;
}

const toFloats = (text) => new Float32Array(toBytes(text).buffer);
const toNumbers = (text) => new Uint32Array(toBytes(text).buffer);

/** The columns with `values` to show and `numbers` to sort and colour by; text has no numbers. */
function readColumn(column) {
  if (column.kind === 'number') {
    const numbers = toFloats(column.values);
    return { ...column, values: numbers, numbers };
  }
  const numbers = column.kind === 'text' ? null : Float64Array.from(column.values, Number);
  return { ...column, numbers };
}

export function readTissue(text) {
  const json = JSON.parse(text);
  const columns = json.columns.map(readColumn);
  const find = (name) => columns.find((column) => column.name === name);
  const labels = find('Label').values;
  const names = find('Name')?.values;
  return {
    unit: json.unit,
    origin: json.origin,
    points: toFloats(json.points),
    triangles: toNumbers(json.triangles),
    walls: toNumbers(json.walls),
    colors: toBytes(json.colors),
    columns,
    find,
    labels,
    nameOf: (row) => (names?.[row] ? `${labels[row]} (${names[row]})` : labels[row]),
    report: json.report,
    numberOfCells: labels.length,
  };
}

/** The rows of the cells that each cell shares a wall with, ascending. */
export function findNeighbors(tissue) {
  const neighbors = Array.from({ length: tissue.numberOfCells }, () => new Set());
  for (let w = 0; w < tissue.walls.length; w += 3) {
    const [a, b] = [tissue.walls[w] - 1, tissue.walls[w + 1] - 1];
    if (a >= 0 && b >= 0) {
      neighbors[a].add(b);
      neighbors[b].add(a);
    }
  }
  return neighbors.map((set) => [...set].sort((a, b) => a - b));
}
