// The tissue as vtk.js draws it.
import '@kitware/vtk.js/Rendering/OpenGL/Actor';
import '@kitware/vtk.js/Rendering/OpenGL/Camera';
import '@kitware/vtk.js/Rendering/OpenGL/PolyDataMapper';
import '@kitware/vtk.js/Rendering/OpenGL/Renderer';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkOpenGLRenderWindow from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';
import vtkPlane from '@kitware/vtk.js/Common/DataModel/Plane';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkRenderer from '@kitware/vtk.js/Rendering/Core/Renderer';
import vtkRenderWindow from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import { cutCells } from './section.js';
import { add, cross, findSeen, listPrimitives, movePoints, pickCell, scaleTo, thickenEdges } from './surfaces.js';

// Lines are a little nearer than the surfaces they are on, those of the selected cell before everything.
const lineUniforms = 'uniform vec2 depthTerms;\n//VTK::Light::Dec';
const lineDepth = '  gl_FragDepth = gl_FragCoord.z - 0.004 * (depthTerms.x - gl_FragCoord.z);';
const frontDepth = '  gl_FragDepth = 0.01 * gl_FragCoord.z;';

const replace = (originalValue, replacementValue) => ({
  shaderType: 'Fragment',
  originalValue,
  replaceFirst: false,
  replacementValue,
  replaceAll: false,
});

/** Three values for each point. */
function setColorsOf({ data }, values) {
  data.getPointData().setScalars(vtkDataArray.newInstance({ name: 'Colors', numberOfComponents: 3, values }));
  data.modified();
}

export class Scene {
  /** \param onDraw is called after every picture. */
  constructor(container, surfaces, onDraw) {
    this.container = container;
    this.surfaces = surfaces;
    this.onDraw = onDraw;
    this.points = surfaces.points;
    this.isShown = new Array(surfaces.numberOfCells).fill(true);
    this.explosion = 0;
    this.colorOf = () => [0, 0, 0];
    this.cellOfCapPoint = [];
    this.plane = null;
    this.selected = -1;
    this.window = vtkRenderWindow.newInstance();
    this.renderer = vtkRenderer.newInstance();
    this.window.addRenderer(this.renderer);
    this.view = vtkOpenGLRenderWindow.newInstance();
    this.view.setContainer(container);
    this.window.addView(this.view);
    this.camera = this.renderer.getActiveCamera();
    this.cutPlane = vtkPlane.newInstance();
    this.cells = this.addActor((property) => {
      property.setAmbient(0.32);
      property.setDiffuse(0.72);
      property.setBackfaceCulling(true);
    });
    this.caps = this.addActor((property) => property.setLighting(false));
    this.edges = this.addActor((property) => property.setLighting(false));
    this.section = this.addActor((property) => property.setLighting(false));
    this.outline = this.addActor((property) => property.setLighting(false));
    for (const part of [this.edges, this.section]) {
      this.setShader(part, [replace('//VTK::Light::Dec', lineUniforms), replace('//VTK::Depth::Impl', lineDepth)]);
    }
    this.setShader(this.outline, [replace('//VTK::Depth::Impl', frontDepth)]);
    this.cells.data.getPointData().setNormals(
      vtkDataArray.newInstance({ name: 'Normals', numberOfComponents: 3, values: surfaces.normals }));
    this.updatePoints();
    this.updateShown();
    new ResizeObserver(() => this.resize()).observe(container);
    this.resize();
    this.resetCamera();
  }

  addActor(setUp) {
    const data = vtkPolyData.newInstance();
    const mapper = vtkMapper.newInstance();
    mapper.setInputData(data);
    const actor = vtkActor.newInstance();
    actor.setMapper(mapper);
    setUp(actor.getProperty());
    this.renderer.addActor(actor);
    return { actor, data, mapper };
  }

  /** Replaces places of a part's shader, and gives it the uniforms that it may have. */
  setShader({ mapper }, replacements) {
    const callback = (userData, cellBuffer) => {
      const program = cellBuffer.getProgram();
      const [near, far] = this.camera.getClippingRange();
      if (program.isUniformUsed('depthTerms')) {
        program.setUniform2f('depthTerms', far / (far - near), (far * near) / (far - near));
      }
    };
    mapper.setViewSpecificProperties({
      OpenGL: { ShaderReplacements: replacements },
      ShadersCallbacks: [{ callback, userData: null }],
    });
    mapper.modified();
  }

  cameraAxes() {
    const forward = this.camera.getDirectionOfProjection();
    const right = scaleTo(cross(forward, this.camera.getViewUp()), 1);
    return { right, up: cross(right, forward), forward };
  }

  resize() {
    const { width, height } = this.container.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const size = [width, height].map((length) => Math.max(Math.round(length * ratio), 1));
    if (String(size) !== String(this.view.getSize())) {
      this.view.setSize(...size);
      this.requestPicture();
    }
  }

  requestPicture() {
    this.request ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    cancelAnimationFrame(this.request);
    this.request = undefined;
    this.renderer.resetCameraClippingRange();
    this.window.render();
    this.onDraw?.();
  }

  setTheme(background, foreground) {
    this.renderer.setBackground(...background.map((channel) => channel / 255));
    this.outline.actor.getProperty().setColor(...foreground.map((channel) => channel / 255));
    this.section.actor.getProperty().setColor(0.08, 0.08, 0.08);
    this.requestPicture();
  }

  /** \param colorOf gives red, green and blue, 0 to 255, of a cell. */
  setColors(colorOf) {
    this.colorOf = colorOf;
    const { numberOfCells, pointStart } = this.surfaces;
    const colors = new Uint8Array(this.points.length);
    for (let c = 0; c < numberOfCells; ++c) {
      const [red, green, blue] = colorOf(c);
      for (let i = 3 * pointStart[c]; i < 3 * pointStart[c + 1]; i += 3) {
        colors[i] = red;
        colors[i + 1] = green;
        colors[i + 2] = blue;
      }
    }
    setColorsOf(this.cells, colors);
    setColorsOf(this.edges, colors.map((channel) => 0.35 * channel));
    this.colorCaps();
    this.requestPicture();
  }

  /** Moves each cell by a share of its way from the middle; the camera steps back as much. */
  setExplosion(share) {
    this.moveCamera((1 + share) / (1 + this.explosion));
    const wasApart = this.explosion > 0;
    this.explosion = share;
    if (wasApart !== share > 0) {
      this.updateShown();
    }
    this.points = movePoints(this.surfaces, share);
    this.updatePoints();
    this.updateSection();
    this.updateOutline();
    this.requestPicture();
  }

  setShown(isShown) {
    this.isShown = isShown;
    this.updateShown();
    this.updateSection();
    this.updateOutline();
    this.requestPicture();
  }

  /** Keeps what is above a plane, `normal` and `offset`; null keeps all. */
  setPlane(plane) {
    if (Boolean(plane) !== Boolean(this.plane)) {
      for (const { mapper } of [this.cells, this.edges]) {
        mapper.removeAllClippingPlanes();
        if (plane) {
          mapper.addClippingPlane(this.cutPlane);
        }
      }
    }
    this.plane = plane;
    if (plane) {
      this.cutPlane.setNormal(...plane.normal);
      this.cutPlane.setOrigin(...plane.normal.map((n) => n * plane.offset));
    }
    this.updateSection();
    this.requestPicture();
  }

  setSelected(cell) {
    this.selected = cell;
    this.updateOutline();
    this.requestPicture();
  }

  updatePoints() {
    for (const { data } of [this.cells, this.edges]) {
      data.getPoints().setData(this.points, 3);
      data.modified();
    }
  }

  updateShown() {
    const { corners, edges } = findSeen(this.surfaces, this.isShown, this.explosion > 0);
    this.cells.data.getPolys().setData(listPrimitives(corners, 3));
    this.edges.data.getLines().setData(listPrimitives(edges, 2));
    this.cells.data.modified();
    this.edges.data.modified();
  }

  /** What is cut is filled, flat in the colours of the cells, and outlined. */
  updateSection() {
    const none = { points: [], cellOfPoint: [], lines: [], triangles: [] };
    const section = this.plane ? cutCells(this.surfaces, this.points, this.isShown, this.plane) : none;
    const points = Float32Array.from(section.points);
    this.caps.data.getPolys().setData(listPrimitives(section.triangles, 3));
    this.section.data.getLines().setData(listPrimitives(section.lines, 2));
    for (const part of [this.caps, this.section]) {
      part.data.getPoints().setData(points, 3);
      part.data.modified();
      part.actor.setVisibility(points.length > 0);
    }
    this.cellOfCapPoint = section.cellOfPoint;
    this.colorCaps();
  }

  colorCaps() {
    const values = Uint8Array.from(this.cellOfCapPoint.flatMap((cell) => [...this.colorOf(cell)]));
    setColorsOf(this.caps, values);
  }

  updateOutline() {
    const isThere = this.selected >= 0 && this.isShown[this.selected];
    const points = isThere ? thickenEdges(this.surfaces, this.points, this.selected, this.edgeRadius()) : new Float32Array();
    const polys = listPrimitives(Array.from({ length: points.length / 3 }, (_, i) => i), 3);
    this.outline.data.getPoints().setData(points, 3);
    this.outline.data.getPolys().setData(polys);
    this.outline.data.modified();
    this.outline.actor.setVisibility(points.length > 0);
  }

  /** A share of the selected cell's size, unless it is all there is. */
  edgeRadius() {
    const sizeOf = ({ lower, upper }) => Math.hypot(...upper.map((x, axis) => x - lower[axis]));
    return Math.min(0.008 * sizeOf(this.boxOf(this.selected)), 0.003 * sizeOf(this.boxOf()));
  }

  /** Of a cell as it is moved, or of all that are shown. */
  boxOf(cell) {
    const box = { lower: [Infinity, Infinity, Infinity], upper: [-Infinity, -Infinity, -Infinity] };
    const { pointStart, numberOfCells } = this.surfaces;
    for (let c = cell ?? 0; c < (cell === undefined ? numberOfCells : cell + 1); ++c) {
      for (let i = 3 * pointStart[c]; (cell !== undefined || this.isShown[c]) && i < 3 * pointStart[c + 1]; ++i) {
        box.lower[i % 3] = Math.min(box.lower[i % 3], this.points[i]);
        box.upper[i % 3] = Math.max(box.upper[i % 3], this.points[i]);
      }
    }
    return box;
  }

  /** Looks at all that is shown, from above and before. */
  resetCamera() {
    this.camera.setFocalPoint(0, 0, 0);
    this.camera.setPosition(0.45, -1, 0.55);
    this.camera.setViewUp(0, 0, 1);
    const { lower, upper } = this.boxOf();
    if (lower[0] <= upper[0]) {
      this.renderer.resetCamera([lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]]);
      const { clientWidth, clientHeight } = this.container;
      this.moveCamera(0.78 * Math.max(1, clientHeight / (clientWidth || 1)));
    }
    this.requestPicture();
  }

  /** Nearer for a factor below 1. */
  moveCamera(factor) {
    const focus = this.camera.getFocalPoint();
    const from = this.camera.getPosition().map((x, axis) => focus[axis] + factor * (x - focus[axis]));
    this.camera.setPosition(...from);
    this.requestPicture();
  }

  turnCamera(toTheRight, upwards) {
    this.camera.azimuth(-toTheRight);
    this.camera.elevation(upwards);
    this.camera.orthogonalizeViewUp();
    this.requestPicture();
  }

  /** Moves what is seen by pixels of the page, to the right and down. */
  shiftCamera(x, y) {
    const { right, up } = this.cameraAxes();
    const size = this.pixelSize();
    const way = add(right.map((r) => -x * size * r), up.map((u) => y * size * u));
    this.camera.setFocalPoint(...add(this.camera.getFocalPoint(), way));
    this.camera.setPosition(...add(this.camera.getPosition(), way));
    this.requestPicture();
  }

  /** Turns about the middle of a cell from now on. */
  centerOn(cell) {
    const { lower, upper } = this.boxOf(cell);
    if (lower[0] > upper[0]) {
      return; // It has no surface.
    }
    const middle = lower.map((x, axis) => (x + upper[axis]) / 2);
    const way = middle.map((x, axis) => x - this.camera.getFocalPoint()[axis]);
    this.camera.setFocalPoint(...middle);
    this.camera.setPosition(...add(this.camera.getPosition(), way));
    this.requestPicture();
  }

  /** The length of a pixel of the page at the middle of the view. */
  pixelSize() {
    const height = this.container.clientHeight || 1;
    return (2 * this.camera.getDistance() * Math.tan((this.camera.getViewAngle() * Math.PI) / 360)) / height;
  }

  /** The cell at a place of the container, in pixels from its upper left, or -1. */
  pick(x, y) {
    const { right, up, forward } = this.cameraAxes();
    const size = this.pixelSize() / this.camera.getDistance();
    const [a, b] = [(x - this.container.clientWidth / 2) * size, (this.container.clientHeight / 2 - y) * size];
    const direction = forward.map((f, axis) => f + a * right[axis] + b * up[axis]);
    const ray = { origin: this.camera.getPosition(), direction };
    return pickCell(this.surfaces, this.points, this.isShown, ray, this.plane);
  }

  /** The picture as the address of a PNG. */
  capture() {
    this.draw();
    return this.view.getCanvas().toDataURL('image/png');
  }
}
