// Many bodies on a stage: each shape's mesh once, drawn as often as there are bodies of it. Places are rounded to float
// about the scene's middle; who looks closer at a pair takes these two out, and adds them as solids.
import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4,
  MeshLambertMaterial } from "three";
import { place } from "./motion.js";
import { Solid } from "./stage.js";

const kNowhere = new Matrix4().makeScale(0, 0, 0);

export class Crowd {
  // solids: a mesh each; members: {mesh, kind, poseAt(t)}, where kind names the colour.
  constructor(stage, meshes, members) {
    this.stage = stage;
    this.members = members;
    this.hidden = new Set();
    this.groups = meshes.map((mesh, k) => this.group(mesh, members.filter((member) => member.mesh === k))).filter(Boolean);
    const ends = this.groups.reduce((sum, group) => sum + group.edges.length * group.members.length, 0);
    this.lineGeometry = new BufferGeometry();
    this.lines = new BufferAttribute(new Float32Array(3 * ends), 3).setUsage(DynamicDrawUsage);
    this.lineGeometry.setAttribute("position", this.lines);
    this.lineMaterial = new LineBasicMaterial({ transparent: true });
    const edges = new LineSegments(this.lineGeometry, this.lineMaterial);
    edges.frustumCulled = false;
    stage.scene.add(edges);
    stage.before = () => this.paint();
  }

  group(mesh, members) {
    if (members.length === 0) return null;
    const solid = new Solid(mesh, "c");
    const geometry = new BufferGeometry(), n = solid.triangles.length;
    const positions = new Float32Array(9 * n), normals = new Float32Array(9 * n);
    solid.triangles.forEach((corners, f) => corners.forEach((i, c) => {
      positions.set(solid.vertices[i], 9 * f + 3 * c);
      normals.set(solid.normals[f][c], 9 * f + 3 * c);
    }));
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    const material = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const instances = new InstancedMesh(geometry, material, members.length);
    instances.frustumCulled = false;
    instances.instanceMatrix.setUsage(DynamicDrawUsage);
    this.stage.scene.add(instances);
    solid.dispose();
    return { geometry, material, instances, members, vertices: solid.vertices, edges: mesh.edges };
  }

  place(t) {
    const { stage } = this, matrix = new Matrix4(), scale = 1 / stage.size;
    let end = 0;
    for (const { instances, members, vertices, edges } of this.groups) {
      members.forEach((member, k) => {
        const hidden = this.hidden.has(member), pose = member.poseAt(t), [x, y, z] = stage.to(pose.position);
        const r = pose.rotation.map((row) => row.map((entry) => entry * scale));
        instances.setMatrixAt(k, hidden ? kNowhere : matrix.set(...r[0], x, ...r[1], y, ...r[2], z, 0, 0, 0, 1));
        if (edges.length === 0) return;
        const placed = hidden ? null : vertices.map((v) => stage.to(place(pose, v)));
        for (const i of edges) this.lines.array.set(placed ? placed[i] : [0, 0, 0], 3 * end++);
      });
      instances.instanceMatrix.needsUpdate = true;
    }
    this.lines.needsUpdate = true;
  }

  // The colours of the page, light or dark, as it is now.
  paint() {
    const { stage } = this, colour = new Color();
    const clear = stage.seeThrough || this.hidden.size > 0;
    const of = new Map();
    for (const { instances, members, material } of this.groups) {
      members.forEach((member, k) => {
        if (!of.has(member.kind)) of.set(member.kind, stage.colour(member.kind));
        instances.setColorAt(k, colour.set(of.get(member.kind)));
      });
      if (instances.instanceColor) instances.instanceColor.needsUpdate = true;
      if (material.transparent !== clear) material.needsUpdate = true; // its shader knows whether it is opaque
      material.transparent = clear;
      material.opacity = clear ? 0.16 : 1;
      material.depthWrite = !clear;
    }
    this.lineMaterial.color.set(stage.colour("soft"));
    this.lineMaterial.opacity = clear ? 0.25 : 0.8;
  }

  dispose() {
    for (const { geometry, material, instances } of this.groups) {
      geometry.dispose();
      material.dispose();
      instances.dispose();
    }
    this.lineGeometry.dispose();
    this.lineMaterial.dispose();
  }
}
