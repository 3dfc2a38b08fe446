// Puts the page together: what the user chooses, and who has to know of it.
import { colorMaps, makeScale, nameLayer, toCss } from './colours.js';
import { findNeighbors, readTissue } from './data.js';
import { countOf, formatNumber, make, spellOut, withUnit } from './format.js';
import { drawLegend } from './legend.js';
import { listenToKeys, navigate } from './navigation.js';
import { drawAxes, drawScale } from './overlay.js';
import { drawPlots, listFacts, listRemarks, listWarnings } from './plots.js';
import { Scene } from './scene.js';
import { showSelection } from './selection.js';
import { buildSurfaces, dot } from './surfaces.js';
import { CellTable } from './table.js';

const get = (id) => document.getElementById(id);
const dark = matchMedia('(prefers-color-scheme: dark)');

// In none of the maps.
const selectionColor = [255, 74, 28];

class Page {
  constructor(tissue) {
    this.tissue = tissue;
    this.neighbors = findNeighbors(tissue);
    this.selected = -1;
    this.hiddenLayers = new Set();
    this.plane = null;
    this.writeHead();
    this.makeColorChoices();
    this.makeLayers();
  }

  writeHead() {
    const { input, mesh, program } = this.tissue.report;
    const name = input.file.split(/[/\\]/).pop();
    document.title = `${name}: ${countOf(this.tissue.numberOfCells, 'cell')}`;
    get('title').textContent = name;
    const facts = [countOf(this.tissue.numberOfCells, 'cell'), countOf(mesh.walls, 'wall'), countOf(mesh.triangles, 'triangle'),
      input.unit || input.pointUnit ? `lengths in ${this.tissue.unit}` : 'unit of lengths not known'];
    get('facts').textContent = facts.join(', ');
    get('maker').textContent = `${program.name} ${program.version}`;
  }

  /** Shows the view; the rest of the page does without. */
  start() {
    try {
      this.scene = new Scene(get('view'), buildSurfaces(this.tissue), () => this.drawOverlay());
    } catch (error) {
      get('failure').hidden = false;
      get('failure').textContent = `The view needs WebGL 2, which this browser does not give (${error.message}).`;
    }
    this.updateColors();
    this.setTheme();
    dark.addEventListener('change', () => this.setTheme());
    if (this.scene) {
      navigate(get('view'), this.scene, (x, y) => this.select(this.scene.pick(x, y)));
      this.listen();
      this.scene.draw();
    }
    requestAnimationFrame(() => {
      document.documentElement.dataset.firstPicture = Math.round(performance.now());
      setTimeout(() => this.startRest());
    });
  }

  startRest() {
    const { report, numberOfCells } = this.tissue;
    this.table = new CellTable(get('table'), get('rows'), this.tissue, (cell) => this.select(cell));
    this.table.isShown = (cell) => this.isShown(cell);
    get('find').addEventListener('input', (event) => this.table.find(event.target.value));
    showSelection(get('selection'), this.tissue, this.neighbors, -1);
    listWarnings(get('warnings'), report);
    drawPlots(get('plots'), report);
    listRemarks(get('remarks'), report, (label) => this.select(this.tissue.labels.indexOf(label)));
    listFacts(get('mesh'), { mesh: report.mesh, input: report.input });
    listFacts(get('options'), report.options);
    document.addEventListener('keydown', (event) => event.key === 'Escape' && this.select(-1));
    document.documentElement.dataset.ready = numberOfCells;
  }

  makeColorChoices() {
    const choices = this.tissue.columns.filter((column) => column.kind !== 'label' && column.numbers);
    get('color-by').append(make('option', { value: '' }, 'Cell'),
      ...choices.map((column) => make('option', { value: column.name }, withUnit(spellOut(column.name), column.unit))));
    get('color-by').value = this.tissue.find('Volume') ? 'Volume' : '';
    const maps = Object.keys(colorMaps).filter((name) => name !== 'signed');
    get('color-map').append(...maps.map((name) => make('option', { value: name }, name)));
    for (const id of ['color-by', 'color-map', 'clip-range']) {
      get(id).addEventListener('change', () => this.updateColors());
    }
  }

  makeLayers() {
    const layer = this.tissue.find('Layer');
    const values = layer ? [...new Set(layer.numbers)].sort((a, b) => (a || Infinity) - (b || Infinity)) : [];
    const { colorOf } = layer ? makeScale(layer) : {};
    get('layers').replaceChildren(...values.map((value) => {
      const box = make('input', { type: 'checkbox', checked: '', 'data-layer': value });
      box.addEventListener('change', () => {
        this.hiddenLayers[box.checked ? 'delete' : 'add'](value);
        this.updateShown();
      });
      const swatch = make('span', { class: 'swatch', style: `background:${toCss(colorOf(value))}` });
      const count = layer.numbers.reduce((sum, v) => sum + (v === value), 0);
      return make('label', { title: countOf(count, 'cell') }, box, ' ', swatch, `${value ? 'layer ' : ''}${nameLayer(value)}`);
    }));
    get('scope').addEventListener('change', () => this.updateShown());
  }

  listen() {
    const { scene } = this;
    get('zoom-in').addEventListener('click', () => scene.moveCamera(1 / 1.2));
    get('zoom-out').addEventListener('click', () => scene.moveCamera(1.2));
    get('reset').addEventListener('click', () => this.reset());
    get('save').addEventListener('click', () => this.save());
    get('explode').addEventListener('input', () => {
      scene.setExplosion(Number(get('explode').value));
      this.updateCut();
    });
    get('cut-axis').addEventListener('change', () => this.chooseCut());
    get('cut-at').addEventListener('input', () => this.updateCut());
    get('cut-flip').addEventListener('change', () => this.updateCut());
    listenToKeys(get('view'), this.makeKeys());
  }

  makeKeys() {
    const { scene } = this;
    const slide = (id, step) => () => {
      get(id).value = Number(get(id).value) + step;
      get(id).dispatchEvent(new Event('input'));
    };
    const turn = (x, y) => () => scene.turnCamera(x, y);
    const move = (x, y) => () => scene.shiftCamera(x, y);
    return {
      ArrowLeft: turn(-8, 0), ArrowRight: turn(8, 0), ArrowUp: turn(0, -8), ArrowDown: turn(0, 8),
      ShiftArrowLeft: move(-30, 0), ShiftArrowRight: move(30, 0), ShiftArrowUp: move(0, -30), ShiftArrowDown: move(0, 30),
      '+': () => scene.moveCamera(1 / 1.2), '=': () => scene.moveCamera(1 / 1.2), '-': () => scene.moveCamera(1.2),
      r: () => this.reset(),
      n: () => this.table?.step(1), p: () => this.table?.step(-1),
      f: () => this.selected >= 0 && scene.centerOn(this.selected),
      e: slide('explode', 0.1), E: slide('explode', -0.1),
      '[': slide('cut-at', -0.02), ']': slide('cut-at', 0.02),
      c: () => {
        const axis = get('cut-axis');
        axis.selectedIndex = (axis.selectedIndex + 1) % axis.options.length;
        this.chooseCut();
      },
    };
  }

  /** As the page was at first, but for colours. */
  reset() {
    get('explode').value = 0;
    get('cut-axis').value = 'none';
    this.scene.setExplosion(0);
    this.chooseCut();
    this.scene.resetCamera();
  }

  save() {
    const name = get('title').textContent.replace(/\.[^.]*$/, '');
    make('a', { href: this.scene.capture(), download: `${name || 'cells'}.png` }).click();
  }

  setTheme() {
    const background = getComputedStyle(document.documentElement).getPropertyValue('--stage').trim();
    const channels = [1, 3, 5].map((at) => parseInt(background.slice(at, at + 2), 16));
    this.scene?.setTheme(channels, selectionColor);
  }

  drawOverlay() {
    drawAxes(get('axes'), this.scene);
    drawScale(get('scale'), this.scene, this.tissue.unit);
  }

  updateColors() {
    const column = this.tissue.find(get('color-by').value);
    const scale = column && makeScale(column, get('color-map').value, get('clip-range').checked);
    get('color-options').hidden = scale?.kind !== 'range';
    get('color-map').disabled = Boolean(column?.name.endsWith('Curvature'));
    drawLegend(get('legend'), column, scale);
    const { colors } = this.tissue;
    this.scene?.setColors((cell) => (scale ? scale.colorOf(column.numbers[cell]) : colors.subarray(3 * cell, 3 * cell + 3)));
  }

  isShown(cell) {
    const layer = this.tissue.find('Layer');
    const scope = this.selected < 0 ? 'all' : get('scope').value;
    return !(layer && this.hiddenLayers.has(layer.numbers[cell])) &&
      (scope === 'all' || cell === this.selected || (scope === 'neighbors' && this.neighbors[this.selected].includes(cell)));
  }

  updateShown() {
    this.scene?.setShown(this.tissue.labels.map((_, cell) => this.isShown(cell)));
    this.table?.draw();
  }

  select(cell) {
    if (cell !== this.selected) {
      this.selected = cell;
      this.scene?.setSelected(cell);
      if (get('scope').value !== 'all') {
        this.updateShown();
      }
      showSelection(get('selection'), this.tissue, this.neighbors, cell, (other) => this.select(other));
    }
    this.table?.select(cell);
  }

  /** The normal of the cut is chosen, of a cut that faces the view only now. */
  chooseCut() {
    const axis = get('cut-axis').value;
    const { forward } = this.scene.cameraAxes();
    const normals = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], view: forward };
    this.normal = axis === 'none' ? null : normals[axis];
    // What is kept is behind the cut, so that the cut is seen.
    this.sign = this.normal && dot(this.normal, forward) < 0 ? -1 : 1;
    this.axis = axis;
    get('cut-at').disabled = !this.normal;
    get('cut-flip').disabled = !this.normal;
    get('cut-at').value = 0.5;
    this.updateCut();
  }

  updateCut() {
    if (!this.normal) {
      get('cut-place').textContent = '';
      this.scene.setPlane(null);
      return;
    }
    const { lower, upper } = this.scene.boxOf();
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => dot(this.normal, [0, 1, 2].map((a) => ((k >> a) & 1 ? upper : lower)[a])));
    const [least, greatest] = [Math.min(...corners), Math.max(...corners)];
    const offset = least + Number(get('cut-at').value) * (greatest - least);
    const sign = get('cut-flip').checked ? -this.sign : this.sign;
    this.scene.setPlane({ normal: this.normal.map((n) => sign * n), offset: sign * offset });
    const place = this.axis === 'view' ? offset - least : offset + dot(this.normal, this.tissue.origin);
    const name = this.axis === 'view' ? 'depth' : this.axis;
    get('cut-place').textContent = `${name} = ${formatNumber(Number(place.toPrecision(4)))} ${this.tissue.unit}`;
  }
}

new Page(readTissue(get('tissue-data').textContent)).start();
