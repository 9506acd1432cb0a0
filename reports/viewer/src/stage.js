// A stage: convex bodies shaded by three.js, and over them, as SVG, what must be seen whatever is in front: points, paths,
// arrows, planes, names, axes, a scale. Parallel projection, so that lengths across the view can be compared anywhere.
import {
  AmbientLight, BufferAttribute, BufferGeometry, DirectionalLight, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, OrthographicCamera, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { add, apply, cross, dot, norm, place, sub, times, unit } from "./motion.js";
import { h, short } from "./dom.js";

const kSmooth = Math.cos(0.5); // of a curved body: faces that differ by less share their normals
const kMostZoom = 1e7, kLeastZoom = 0.05;

const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3));

// A mesh of a scene, ready to be placed again and again.
export class Solid {
  constructor(mesh, name) {
    this.name = name;
    this.vertices = triples(mesh.vertices);
    this.triangles = triples(mesh.triangles);
    this.normals = this.cornerNormals(mesh.curved);
    this.edges = mesh.edges;
    this.geometry = new BufferGeometry();
    this.positions = new BufferAttribute(new Float32Array(9 * this.triangles.length), 3);
    this.normalsPlaced = new BufferAttribute(new Float32Array(9 * this.triangles.length), 3);
    this.geometry.setAttribute("position", this.positions);
    this.geometry.setAttribute("normal", this.normalsPlaced);
    this.material = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.lineGeometry = new BufferGeometry();
    this.linePositions = new BufferAttribute(new Float32Array(3 * this.edges.length), 3);
    this.lineGeometry.setAttribute("position", this.linePositions);
    this.lineMaterial = new LineBasicMaterial();
    this.group = new Group();
    for (const object of [new Mesh(this.geometry, this.material), new LineSegments(this.lineGeometry, this.lineMaterial)]) {
      object.frustumCulled = false;
      this.group.add(object);
    }
  }

  cornerNormals(curved) {
    const faces = this.triangles.map(([i, j, k]) => {
      const [x, y, z] = [this.vertices[i], this.vertices[j], this.vertices[k]];
      return unit(cross(sub(y, x), sub(z, x)));
    });
    if (!curved) return faces.map((n) => [n, n, n]);
    const around = this.vertices.map(() => []);
    this.triangles.forEach((corners, f) => corners.forEach((i) => around[i].push(f)));
    return this.triangles.map((corners, f) => corners.map((i) => {
      let sum = [0, 0, 0];
      for (const g of around[i]) if (dot(faces[f], faces[g]) > kSmooth) sum = add(sum, faces[g]);
      return norm(sum) > 0 ? unit(sum) : faces[f];
    }));
  }

  // `to`: a place of the scene to the stage's coordinates.
  place(pose, to) {
    this.placed = this.vertices.map((x) => to(place(pose, x)));
    const p = this.positions.array, n = this.normalsPlaced.array;
    this.triangles.forEach((corners, f) => corners.forEach((i, c) => {
      p.set(this.placed[i], 9 * f + 3 * c);
      n.set(apply(pose.rotation, this.normals[f][c]), 9 * f + 3 * c);
    }));
    this.edges.forEach((i, e) => this.linePositions.array.set(this.placed[i], 3 * e));
    this.positions.needsUpdate = this.normalsPlaced.needsUpdate = this.linePositions.needsUpdate = true;
  }

  dispose() {
    for (const one of [this.geometry, this.material, this.lineGeometry, this.lineMaterial]) one.dispose();
  }
}

// The hull of points in the plane, counter-clockwise.
export function flatHull(points) {
  const sorted = [...points].sort((l, r) => l[0] - r[0] || l[1] - r[1]);
  const half = (list) => {
    const out = [];
    for (const p of list) {
      while (out.length > 1) {
        const [a, b] = [out[out.length - 2], out[out.length - 1]];
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        out.pop();
      }
      out.push(p);
    }
    out.pop();
    return out;
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}

export class Stage {
  // focus, size: the place, and the length, of the scene that are 0 and 1 on the stage. view: right, up, towards.
  constructor({ label, focus, size, view, name }) {
    this.focus = focus;
    this.size = size > 0 ? size : 1;
    this.to = (x) => times(1 / this.size, sub(x, focus));
    this.view = view;
    this.solids = [];
    this.draw = () => {};
    this.before = () => {};
    this.everything = () => [[0, 0, 0]];
    this.svg = h("svg:svg", { class: "over", "aria-hidden": "true" });
    this.corner = h("div", { class: "corner" });
    this.element = h("div", {
      class: "stage", tabindex: 0, role: "application", "aria-label":
        `${label}. Arrow keys turn the view, plus and minus magnify, 0 shows the whole.`, "data-stage": name,
    });
    try {
      this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    } catch {
      this.element.append(h("p", { class: "lacks" }, "This browser has no WebGL: the bodies are drawn as outlines only."));
    }
    if (this.renderer) {
      this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
      this.element.append(this.renderer.domElement);
    }
    this.element.append(this.svg, this.corner);
    this.scene = new Scene();
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.5));
    const light = new DirectionalLight(0xffffff, 1.8);
    light.position.set(-0.5, 0.9, 1);
    this.camera.add(light);
    this.controls = new OrbitControls(this.camera, this.element);
    this.controls.enableDamping = false;
    this.controls.enableZoom = false; // until the stage has been taken, so that a page can be scrolled past it
    this.controls.minZoom = kLeastZoom;
    this.controls.maxZoom = kMostZoom;
    this.controls.zoomToCursor = false;
    this.controls.addEventListener("change", () => this.render());
    this.element.addEventListener("focus", () => (this.controls.enableZoom = true));
    this.element.addEventListener("blur", () => (this.controls.enableZoom = false));
    this.element.addEventListener("pointerdown", () => this.element.focus({ preventScroll: true }));
    this.element.addEventListener("keydown", (event) => this.onKey(event));
    this.half = 1;
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(this.element);
    this.scheme = window.matchMedia("(prefers-color-scheme: dark)");
    this.onScheme = () => this.render();
    this.scheme.addEventListener("change", this.onScheme);
    this.look(0.5, 0.38);
  }

  add(mesh, name) {
    const solid = new Solid(mesh, name);
    this.solids.push(solid);
    this.scene.add(solid.group);
    return solid;
  }

  remove(solid) {
    this.solids = this.solids.filter((one) => one !== solid);
    this.scene.remove(solid.group);
    solid.dispose();
  }

  // From the scene's own view, turned by so many radians to the side and up.
  look(aside, up) {
    const { right, up: top, towards } = this.view;
    const level = add(times(Math.cos(aside), towards), times(Math.sin(aside), right));
    const from = add(times(Math.cos(up), level), times(Math.sin(up), top));
    this.camera.up.set(...top);
    this.camera.position.set(...times(10, from));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
  }

  // Half of the larger extent of everything, as it is seen now.
  reach() {
    const { width, height } = this.extent();
    return Math.max(width, height) / 2;
  }
  extent() {
    this.camera.updateMatrixWorld();
    const e = this.camera.matrixWorld.elements, right = [e[0], e[1], e[2]], up = [e[4], e[5], e[6]], towards = [e[8], e[9], e[10]];
    const points = this.everything();
    const range = (axis) => {
      let low = Infinity, high = -Infinity;
      for (const p of points) {
        const x = dot(axis, p);
        low = Math.min(low, x);
        high = Math.max(high, x);
      }
      return [low, high];
    };
    const [u, v, w] = [right, up, towards].map(range);
    const middle = [u, v, w].map(([low, high]) => (low + high) / 2);
    return { width: u[1] - u[0], height: v[1] - v[0],
      middle: add(add(times(middle[0], right), times(middle[1], up)), times(middle[2], towards)) };
  }
  whole() {
    if (!this.width) return;
    const room = 1.16, { width, height, middle } = this.extent();
    const side = Math.min(this.width, this.height);
    this.half = Math.max((width / 2) * (side / this.width), (height / 2) * (side / this.height), 1e-12) * room;
    this.aim(middle, 1);
  }
  // Magnifies what is at `point` of the stage.
  aim(point, zoom) {
    const target = new Vector3(...point);
    const from = this.camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(target);
    this.camera.position.copy(target).add(from);
    this.camera.zoom = Math.min(kMostZoom, Math.max(kLeastZoom, zoom));
    this.controls.update();
    this.resize();
  }
  magnify(half, place = this.focus) {
    this.aim(this.to(place), (this.half * this.size) / half);
  }

  onKey(event) {
    const step = 0.12;
    const turn = (aside, up) => {
      const from = this.camera.position.clone().sub(this.controls.target);
      const top = new Vector3(...this.view.up);
      const side = new Vector3().crossVectors(top, from).normalize();
      from.applyAxisAngle(top, -aside);
      const steep = from.angleTo(top);
      if (up !== 0 && steep + up > 0.02 && steep + up < Math.PI - 0.02) from.applyAxisAngle(side, up);
      this.camera.position.copy(this.controls.target).add(from);
      this.controls.update();
    };
    const acts = {
      ArrowLeft: () => turn(-step, 0), ArrowRight: () => turn(step, 0),
      ArrowUp: () => turn(0, -step), ArrowDown: () => turn(0, step),
      "+": () => this.zoomBy(1.25), "=": () => this.zoomBy(1.25), "-": () => this.zoomBy(0.8), 0: () => this.whole(),
    };
    if (!acts[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    acts[event.key]();
  }
  zoomBy(factor) {
    this.camera.zoom = Math.min(kMostZoom, Math.max(kLeastZoom, this.camera.zoom * factor));
    this.camera.updateProjectionMatrix();
    this.render();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    const first = !this.width;
    this.width = width;
    this.height = height;
    this.renderer?.setSize(width, height, false);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const short_side = Math.min(width, height);
    const right = (this.half * width) / short_side, top = (this.half * height) / short_side;
    Object.assign(this.camera, { left: -right, right, top, bottom: -top });
    this.camera.updateProjectionMatrix();
    if (first) {
      this.whole();
      this.ready?.();
    }
    this.render();
  }

  colour(name) {
    return getComputedStyle(this.element).getPropertyValue(`--${name}`).trim();
  }

  render() {
    if (!this.width) return;
    this.camera.updateMatrixWorld();
    const e = this.camera.matrixWorldInverse.elements;
    this.pixels = (this.width / (this.camera.right - this.camera.left)) * this.camera.zoom;
    this.project = (p) => [
      this.width / 2 + this.pixels * (e[0] * p[0] + e[4] * p[1] + e[8] * p[2] + e[12]),
      this.height / 2 - this.pixels * (e[1] * p[0] + e[5] * p[1] + e[9] * p[2] + e[13]),
    ];
    this.direct = (d) => [e[0] * d[0] + e[4] * d[1] + e[8] * d[2], -(e[1] * d[0] + e[5] * d[1] + e[9] * d[2])];
    for (const solid of this.solids) {
      const clear = this.seeThrough;
      if (!solid.placed) continue;
      solid.material.color.set(this.colour(solid.name));
      solid.lineMaterial.color.set(this.colour(`${solid.name}-line`));
      const thin = clear || solid.pale === true;
      if (solid.material.transparent !== thin) solid.material.needsUpdate = true; // its shader knows whether it is opaque
      solid.material.transparent = thin;
      solid.material.opacity = clear ? 0.3 : solid.pale ? 0.55 : 1;
      solid.material.depthWrite = !clear && !solid.pale;
    }
    this.before();
    this.renderer?.render(this.scene, this.camera);
    this.svg.replaceChildren();
    // What words must keep clear of: the corner's, the axes, the scale. Boxes of pixels: left, top, right, bottom.
    this.taken = [[0, 0, 230, 24], [0, this.height - 84, 84, this.height], [this.width - 160, this.height - 34, this.width, this.height]];
    if (!this.renderer) for (const solid of this.solids) this.outline(solid.placed, `body ${solid.name}`);
    this.draw(this);
    this.axes();
    this.scaleBar();
    const from = unit([e[2], e[6], e[10]]);
    this.corner.textContent = `seen from ${from.map((x) => x.toFixed(2).replace("-", "−")).join(", ")}` +
      (this.camera.zoom > 1.5 ? ` · × ${short(this.camera.zoom)}` : "");
  }

  // What is drawn over the bodies; places in the stage's coordinates.
  put(tag, attributes, ...children) {
    const element = h(`svg:${tag}`, attributes, ...children);
    this.svg.append(element);
    return element;
  }
  // Far away ends are brought near, where the browser still draws them in place.
  path(points, closed = false) {
    const far = 1e5;
    const all = points.map((p) => this.project(p).map((x) => Math.max(-far, Math.min(far, x)).toFixed(2)));
    return `M${all.map((p) => p.join(" ")).join("L")}${closed ? "Z" : ""}`;
  }
  line(points, kind) {
    if (points.length > 1) this.put("path", { d: this.path(points), class: kind });
  }
  polygon(points, kind) {
    if (points.length > 1) this.put("path", { d: this.path(points, true), class: kind });
  }
  outline(points, kind) {
    const flat = flatHull(points.map((p) => this.project(p)));
    if (flat.length < 2) return this.put("circle", { cx: flat[0][0], cy: flat[0][1], r: 3, class: kind });
    const far = 1e5;
    const d = flat.map((p) => p.map((x) => Math.max(-far, Math.min(far, x)).toFixed(2)).join(" ")).join("L");
    return this.put("path", { d: `M${d}Z`, class: kind });
  }
  dot(point, kind, radius = 4) {
    const [x, y] = this.project(point);
    if (Math.abs(x) < 1e5 && Math.abs(y) < 1e5) this.put("circle", { cx: x, cy: y, r: radius, class: kind });
  }
  // Of so many pixels, whatever the magnification; `name` at its tip.
  arrow(point, direction, pixels, kind, name = "") {
    const [x, y] = this.project(point), d = this.direct(unit(direction));
    const length = Math.hypot(d[0], d[1]) * pixels;
    if (!(length > 6)) return;
    this.head([x, y], [x + d[0] * pixels, y + d[1] * pixels], kind, name);
  }
  head([x, y], [u, v], kind, name = "") {
    const length = Math.hypot(u - x, v - y), a = [(u - x) / length, (v - y) / length];
    if (!(length > 1) || Math.abs(u) > 1e5 || Math.abs(v) > 1e5) return;
    const wing = (s) => `${u - 8 * a[0] - s * 3.5 * a[1]} ${v - 8 * a[1] + s * 3.5 * a[0]}`;
    this.put("path", { d: `M${x} ${y}L${u} ${v}M${wing(1)}L${u} ${v}L${wing(-1)}`, class: kind });
    if (name) this.text([u + 9 * a[0], v + 9 * a[1] + 4], name, kind);
  }
  // Moved, up to a few lines, off what is written there already; where there is no room it stays.
  text([x, y], words, kind, anchor = "middle") {
    const big = /\bbig\b/.test(kind), half = (words.length * (big ? 9 : 6.8)) / 2 + 2, line = big ? 17 : 14;
    const box = ([dx, dy]) => [x + dx - half, y + dy - line + 3, x + dx + half, y + dy + 3];
    const free = (b) => b[0] >= 0 && b[1] >= 0 && b[2] <= this.width && b[3] <= this.height &&
      this.taken.every((o) => b[2] <= o[0] || o[2] <= b[0] || b[3] <= o[1] || o[3] <= b[1]);
    const tries = [0, 1, 2, 3].flatMap((k) => (k === 0 ? [[0, 0]] : [[0, -k * line], [0, k * line], [k * half, 0], [-k * half, 0]]));
    const move = tries.find((by) => free(box(by))) ?? [0, 0];
    this.taken.push(box(move));
    this.put("text", { x: x + move[0], y: y + move[1], class: `name ${kind}`, "text-anchor": anchor }, words);
  }

  axes() {
    this.taken = []; // this corner, and the scale's, are their own
    const middle = [44, this.height - 42];
    for (const [i, name] of ["x", "y", "z"].entries()) {
      const d = this.direct([0, 1, 2].map((k) => (k === i ? 1 : 0)));
      const tip = [middle[0] + 24 * d[0], middle[1] + 24 * d[1]];
      if (Math.hypot(...d) > 0.15) this.head(middle, tip, "axis", name);
    }
  }
  // The longest of 1, 2, 5 times a power of ten that takes no more than a quarter of the width.
  scaleBar() {
    const most = Math.min(this.width / 4, 140) * (this.size / this.pixels);
    const ten = 10 ** Math.floor(Math.log10(most));
    const length = (most >= 5 * ten ? 5 : most >= 2 * ten ? 2 : 1) * ten;
    const right = this.width - 14, left = right - (length / this.size) * this.pixels, y = this.height - 14;
    this.put("path", { d: `M${left} ${y - 4}V${y + 3}M${left} ${y}H${right}M${right} ${y - 4}V${y + 3}`, class: "axis" });
    this.text([(left + right) / 2, y - 7], short(length), "axis");
  }

  dispose() {
    this.resizing.disconnect();
    this.scheme.removeEventListener("change", this.onScheme);
    this.controls.dispose();
    for (const solid of this.solids) solid.dispose();
    this.renderer?.dispose();
    this.renderer?.forceContextLoss();
  }
}
