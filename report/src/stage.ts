// 3-D view: particles as shaded discs, impactors as panels, an orbit camera.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  LinearFilter,
  Matrix4,
  Mesh,
  NearestFilter,
  PerspectiveCamera,
  Points,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  Sphere,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { BodyData, ImpactorData, Range } from "./bodies";
import { Kind, table } from "./colours";

const clipped = /* glsl */ `
  uniform vec4 plane; // hides where dot(normal, x) is above w
  bool isClipped(vec3 x) { return dot(plane.xyz, x) > plane.w; }
`;

const colouring = /* glsl */ `
  uniform sampler2D colours;
  uniform vec2 range;
  uniform bool isNumber;
  vec3 colourOf(float value) {
    float at = isNumber ? (value < 0.5 ? 0.0 : mod(value - 1.0, 10.0) + 1.0) / 255.0 : clamp((value - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0);
    return texture2D(colours, vec2(at * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
  }
`;

const particleVertex = /* glsl */ `
  attribute float ux, uy, uz, value, written;
  uniform vec3 low, steps, offset;
  uniform float warp, diameter, pixels;
  varying vec3 colour;
  varying float size;
  ${clipped}
  ${colouring}
  void main() {
    vec3 x = position + offset + warp * (low + steps * vec3(ux, uy, uz));
    vec4 seen = modelViewMatrix * vec4(x, 1.0);
    gl_Position = isClipped(x) || written < 0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * seen;
    size = pixels * diameter / -seen.z;
    gl_PointSize = max(size, 1.0);
    colour = colourOf(value);
  }
`;

const particleFragment = /* glsl */ `
  varying vec3 colour;
  varying float size;
  void main() {
    float light = 1.0;
    if (size > 4.0) {
      vec2 at = 2.0 * gl_PointCoord - 1.0;
      float off = dot(at, at);
      if (off > 1.0) discard;
      float ball = 0.62 + 0.38 * dot(vec3(at.x, -at.y, sqrt(1.0 - off)), vec3(-0.35, 0.45, 0.82));
      light = mix(1.0, ball, smoothstep(4.0, 9.0, size)); // shading of discs below a few pixels would cause aliasing
    }
    gl_FragColor = vec4(colour * light, 1.0);
  }
`;

const panelVertex = /* glsl */ `
  attribute vec3 edge; // distances from the sides; 1 for a diagonal of the panel
  attribute float value;
  varying vec3 place, seenPlace, fromEdge;
  varying float panelValue;
  void main() {
    vec4 x = modelMatrix * vec4(position, 1.0);
    vec4 seen = viewMatrix * x;
    place = x.xyz;
    seenPlace = seen.xyz;
    fromEdge = edge;
    panelValue = value;
    gl_Position = projectionMatrix * seen;
  }
`;

const panelFragment = /* glsl */ `
  uniform vec3 plain;
  uniform bool isColoured, hasEdges;
  uniform float opacity;
  varying vec3 place, seenPlace, fromEdge;
  varying float panelValue;
  ${clipped}
  ${colouring}
  void main() {
    if (isClipped(place)) discard;
    vec3 normal = normalize(cross(dFdx(seenPlace), dFdy(seenPlace)));
    float light = 0.5 + 0.5 * abs(dot(normal, normalize(vec3(-0.35, 0.45, 0.82))));
    vec3 colour = isColoured ? colourOf(panelValue) : plain;
    if (hasEdges) {
      vec3 width = fwidth(fromEdge);
      vec3 at = smoothstep(vec3(0.0), 1.2 * width, fromEdge);
      light *= 0.55 + 0.45 * min(at.x, min(at.y, at.z));
    }
    gl_FragColor = vec4(colour * light, opacity);
  }
`;

function texture(kind: Kind): DataTexture {
  const out = new DataTexture(table(kind), 256, 1, RGBAFormat);
  out.magFilter = out.minFilter = kind === "number" ? NearestFilter : LinearFilter;
  out.needsUpdate = true;
  return out;
}

/** Writes the positions of drawn corners, given the vertex of each. */
function cornersAt(vertices: Float32Array, drawnVertices: Uint32Array, out: Float32Array): Float32Array {
  drawnVertices.forEach((vertex, k) => out.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * k));
  return out;
}

export type View = "+x" | "-x" | "+y" | "-y" | "+z" | "-z" | "iso" | "fit";

const directions: Record<Exclude<View, "fit">, [number, number, number]> = {
  "+x": [1, 0, 0],
  "-x": [-1, 0, 0],
  "+y": [0, 1, 0],
  "-y": [0, -1, 0],
  "+z": [0, 0, 1],
  "-z": [0, 0, -1],
  iso: [0.55, -0.72, 0.5],
};

interface ShownBody {
  data: BodyData;
  points: Points<BufferGeometry, ShaderMaterial>;
}

interface ShownImpactor {
  data: ImpactorData;
  mesh: Mesh<BufferGeometry, ShaderMaterial>;
  perPanel: Uint8Array; // vertices drawn per panel: 3 or 6
  drawnVertices: Uint32Array; // the vertex of each drawn corner
}

export interface Hit {
  body: number;
  particle: number;
}

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(28, 1, 1e-3, 1e3);
  private readonly scene = new Scene();
  private readonly turning: OrbitControls;
  private readonly bodies: ShownBody[] = [];
  private readonly impactors: ShownImpactor[] = [];
  private readonly tables: Record<Kind, DataTexture> = { magnitude: texture("magnitude"), increase: texture("increase"), signed: texture("signed"), number: texture("number") };
  private readonly plane = new Vector4(0, 0, 0, 1);
  private isDrawing = false;
  private reach = 0; // diagonal of the bounding box of the bodies
  low = new Vector3(Infinity, Infinity, Infinity); // bounding box of everything shown
  high = new Vector3(-Infinity, -Infinity, -Infinity);

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly afterDrawing: (camera: PerspectiveCamera) => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.camera.up.set(0, 0, 1);
    this.turning = new OrbitControls(this.camera, canvas);
    this.turning.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.fitCanvas()).observe(canvas.parentElement!);
    canvas.addEventListener("keydown", (event) => this.turnByKey(event));
  }

  addBody(data: BodyData): void {
    const count = data.about.shown;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(data.undeformed, 3));
    for (const name of ["ux", "uy", "uz"]) geometry.setAttribute(name, new BufferAttribute(new Uint16Array(count), 1));
    geometry.setAttribute("value", new BufferAttribute(new Float32Array(count), 1));
    geometry.setAttribute("written", new BufferAttribute(new Uint8Array(count).fill(1), 1));
    const [x, y, z] = data.about.arrays;
    const points = new Points(
      geometry,
      new ShaderMaterial({
        vertexShader: particleVertex,
        fragmentShader: particleFragment,
        uniforms: {
          low: { value: new Vector3(x.low, y.low, z.low) },
          steps: { value: new Vector3(x.step, y.step, z.step) },
          offset: { value: new Vector3() },
          warp: { value: 1 },
          diameter: { value: 1.2 * data.about["spacing [m]"] },
          pixels: { value: 1 },
          plane: { value: this.plane },
          colours: { value: this.tables.magnitude },
          range: { value: new Vector2(0, 1) },
          isNumber: { value: false },
        },
      }),
    );
    points.frustumCulled = false; // displacements change its bounds
    this.bodies.push({ data, points });
    this.scene.add(points);
    this.include(data.undeformed);
    const { min, max } = new Box3().setFromArray(data.undeformed);
    for (const offset of data.about.offsets) for (const corner of [min, max]) this.include(new Vector3(...offset).add(corner).toArray());
    this.reach = this.low.distanceTo(this.high);
  }

  addImpactor(data: ImpactorData): void {
    const { corners, vertices } = data;
    const perPanel = new Uint8Array(data.about.panels);
    let drawn = 0;
    for (let panel = 0; panel < perPanel.length; ++panel) drawn += perPanel[panel] = corners[4 * panel + 3] < 0 ? 3 : 6;
    const drawnVertices = new Uint32Array(drawn); // of each drawn corner
    const edge = new Float32Array(3 * drawn);
    let at = 0;
    for (let panel = 0; panel < perPanel.length; ++panel) {
      const isQuad = perPanel[panel] === 6;
      const order = isQuad ? [0, 1, 2, 0, 2, 3] : [0, 1, 2];
      order.forEach((corner, k) => {
        drawnVertices[at / 3] = corners[4 * panel + corner];
        edge[at + (k % 3)] = 1;
        if (isQuad) edge[at + (k < 3 ? 1 : 2)] = 1; // the side opposite that corner is the diagonal
        at += 3;
      });
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(cornersAt(vertices, drawnVertices, new Float32Array(3 * drawn)), 3));
    geometry.setAttribute("edge", new BufferAttribute(edge, 3));
    geometry.setAttribute("value", new BufferAttribute(new Float32Array(drawn), 1));
    const mesh = new Mesh(
      geometry,
      new ShaderMaterial({
        vertexShader: panelVertex,
        fragmentShader: panelFragment,
        side: DoubleSide,
        uniforms: {
          plain: { value: new Color(0.62, 0.66, 0.7) },
          isColoured: { value: false },
          hasEdges: { value: false },
          opacity: { value: 1 },
          plane: { value: this.plane },
          colours: { value: this.tables.increase },
          range: { value: new Vector2(0, 1) },
          isNumber: { value: false },
        },
      }),
    );
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.renderOrder = 1; // drawn after the particles, which show through
    this.impactors.push({ data, mesh, perPanel, drawnVertices });
    this.scene.add(mesh);
    this.include(vertices);
  }

  /** Extends the bounding box by points; for impactors only by those near the bodies, so that a large ship does not dominate the view. */
  private include(points: ArrayLike<number>): void {
    const least = this.low.clone().subScalar(0.3 * this.reach);
    const most = this.high.clone().addScalar(0.3 * this.reach);
    const point = new Vector3();
    for (let k = 0; k < points.length; k += 3) {
      point.set(points[k], points[k + 1], points[k + 2]);
      if (this.reach > 0) point.clamp(least, most);
      this.low.min(point);
      this.high.max(point);
    }
  }

  /** Sets positions and colours of the particles of a body. */
  showBody(body: number, picture: number, values: Float32Array, kind: Kind, range: Range): void {
    const { data, points } = this.bodies[body];
    const arrays = data.pictures[picture];
    ["ux", "uy", "uz"].forEach((name, axis) => {
      const attribute = points.geometry.getAttribute(name) as BufferAttribute;
      attribute.array = arrays[axis];
      attribute.needsUpdate = true;
    });
    const attribute = points.geometry.getAttribute("value") as BufferAttribute;
    attribute.array = values;
    attribute.needsUpdate = true;
    const isWritten = data.isWritten(picture);
    if (isWritten) {
      const written = points.geometry.getAttribute("written") as BufferAttribute;
      written.array = isWritten;
      written.needsUpdate = true;
    }
    const { uniforms } = points.material;
    uniforms.offset.value.fromArray(data.about.offsets[picture]);
    uniforms.colours.value = this.tables[kind];
    uniforms.isNumber.value = kind === "number";
    uniforms.range.value.set(range.low, range.high);
    this.draw();
  }

  /** Sets the pose and the deformation of an impactor, and the colours of its panels if there are values. */
  showImpactor(impactor: number, picture: number, values: Float32Array | undefined, range: Range): void {
    const { data, mesh, perPanel, drawnVertices } = this.impactors[impactor];
    const m = data.about.motions[picture];
    mesh.matrix = new Matrix4().set(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11], 0, 0, 0, 1);
    mesh.matrixWorldNeedsUpdate = true;
    if (data.isDeformed) {
      const attribute = mesh.geometry.getAttribute("position") as BufferAttribute;
      cornersAt(data.deformed(picture), drawnVertices, attribute.array as Float32Array);
      attribute.needsUpdate = true;
    }
    const { uniforms } = mesh.material;
    uniforms.isColoured.value = values !== undefined;
    uniforms.range.value.set(range.low, range.high);
    if (values) {
      const attribute = mesh.geometry.getAttribute("value") as BufferAttribute;
      let at = 0;
      for (let panel = 0; panel < perPanel.length; ++panel) for (let k = 0; k < perPanel[panel]; ++k) attribute.array[at++] = values[panel];
      attribute.needsUpdate = true;
    }
    this.draw();
  }

  setParticles(diameters: number, warp: number): void {
    for (const { data, points } of this.bodies) {
      points.material.uniforms.diameter.value = diameters * data.about["spacing [m]"];
      points.material.uniforms.warp.value = warp;
    }
    this.draw();
  }

  setPanels(opacity: number, hasEdges: boolean): void {
    for (const { mesh } of this.impactors) {
      mesh.visible = opacity > 0;
      mesh.material.uniforms.opacity.value = opacity;
      mesh.material.uniforms.hasEdges.value = hasEdges;
      mesh.material.transparent = opacity < 1;
      mesh.material.depthWrite = opacity === 1;
    }
    this.draw();
  }

  /** Sets the clipping plane at `at` along a signed axis; off without an axis. */
  setClip(axis: number | undefined, sign: number, at: number): void {
    this.plane.set(axis === 0 ? sign : 0, axis === 1 ? sign : 0, axis === 2 ? sign : 0, axis === undefined ? 1 : sign * at);
    this.draw();
  }

  setGround(colour: string): void {
    this.scene.background = new Color(colour);
    this.draw();
  }

  /** Fits everything in view from the given direction, or from the current one. */
  view(view: View): void {
    const ball = new Sphere(this.low.clone().add(this.high).multiplyScalar(0.5), Math.max(this.high.distanceTo(this.low) / 2, 1e-9));
    const from = view === "fit" ? this.camera.position.clone().sub(this.turning.target) : new Vector3(...directions[view]);
    if (view === "+z" || view === "-z") from.y -= 1e-4; // y points up
    from.normalize();
    this.camera.position.copy(ball.center).addScaledVector(from, 1);
    this.camera.lookAt(ball.center);
    this.camera.updateMatrixWorld();
    // the smallest distance with all corners of the box in view
    const tall = Math.tan((this.camera.fov * Math.PI) / 360) * 0.94;
    const wide = tall * this.camera.aspect;
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3(corner & 1 ? this.high.x : this.low.x, corner & 2 ? this.high.y : this.low.y, corner & 4 ? this.high.z : this.low.z).sub(ball.center);
      distance = Math.max(distance, at.dot(from) + Math.max(Math.abs(at.dot(right)) / wide, Math.abs(at.dot(up)) / tall));
    }
    this.turning.target.copy(ball.center);
    this.camera.position.copy(ball.center).addScaledVector(from, distance);
    this.turning.update();
    this.draw();
  }

  private turnByKey(event: KeyboardEvent): void {
    const from = this.camera.position.clone().sub(this.turning.target);
    const by = Math.PI / 36;
    const axis = new Vector3(0, 0, 1);
    const sideways = new Vector3().crossVectors(axis, from).normalize();
    if (event.key === "ArrowLeft") from.applyAxisAngle(axis, -by);
    else if (event.key === "ArrowRight") from.applyAxisAngle(axis, by);
    else if (event.key === "ArrowUp" && from.angleTo(axis) > 2 * by) from.applyAxisAngle(sideways, -by);
    else if (event.key === "ArrowDown" && from.angleTo(axis) < Math.PI - 2 * by) from.applyAxisAngle(sideways, by);
    else if (event.key === "+" || event.key === "=") from.multiplyScalar(0.9);
    else if (event.key === "-") from.multiplyScalar(1 / 0.9);
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.camera.position.copy(this.turning.target).add(from);
    this.turning.update();
    this.draw();
  }

  private fitCanvas(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    if (clientWidth === 0 || clientHeight === 0 || window.matchMedia("print").matches) return;
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  /** Redraws at the next animation frame, once for all changes. */
  draw(): void {
    if (this.isDrawing) return;
    this.isDrawing = true;
    requestAnimationFrame(() => this.drawNow());
  }

  /** A copy of what is shown now, with `ratio` pixels per one of the page. The canvas itself changes only when the browser composes the page. */
  copy(ratio: number): HTMLCanvasElement {
    const before = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(ratio);
    this.drawNow();
    const out = document.createElement("canvas");
    out.width = this.canvas.width & ~1; // even, as encoders of films require
    out.height = this.canvas.height & ~1;
    out.getContext("2d")!.drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(before);
    this.drawNow();
    return out;
  }

  private drawNow(): void {
    this.isDrawing = false;
    const away = this.camera.position.distanceTo(this.turning.target);
    this.camera.near = 5e-3 * away;
    this.camera.far = away + 50 * (this.high.distanceTo(this.low) || 1); // impactors and fragments may be far outside the box
    this.camera.updateProjectionMatrix();
    const size = this.renderer.getDrawingBufferSize(new Vector2());
    for (const { points } of this.bodies) points.material.uniforms.pixels.value = 0.5 * size.y * this.camera.projectionMatrix.elements[5];
    this.renderer.render(this.scene, this.camera);
    this.afterDrawing(this.camera);
  }

  /** The frontmost particle at a point of the canvas, in the given frames. */
  hit(x: number, y: number, pictures: number[], warp: number): Hit | undefined {
    const { clientWidth, clientHeight } = this.canvas;
    const matrix = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const at = new Vector3();
    let found: Hit | undefined;
    let nearest = Infinity;
    this.bodies.forEach(({ data, points }, body) => {
      const arrays = data.pictures[pictures[body]];
      const descriptions = data.about.arrays;
      const radius = points.material.uniforms.diameter.value / 2;
      const isWritten = data.isWritten(pictures[body]);
      const offset = data.about.offsets[pictures[body]];
      for (let i = 0; i < data.about.shown; ++i) {
        if (isWritten && !isWritten[i]) continue;
        const place = [0, 1, 2].map((axis) => data.undeformed[3 * i + axis] + offset[axis] + warp * (descriptions[axis].low + descriptions[axis].step * arrays[axis][i]));
        at.set(place[0], place[1], place[2]);
        if (this.plane.x * at.x + this.plane.y * at.y + this.plane.z * at.z > this.plane.w) continue;
        const away = at.distanceTo(this.camera.position);
        const pixels = Math.max(2, (radius / away) * 0.5 * clientHeight * this.camera.projectionMatrix.elements[5]);
        at.applyMatrix4(matrix);
        const off = Math.hypot(((at.x + 1) / 2) * clientWidth - x, ((1 - at.y) / 2) * clientHeight - y);
        if (off <= pixels && at.z < nearest) {
          nearest = at.z;
          found = { body, particle: i };
        }
      }
    });
    return found;
  }
}
