// MuJoCo, as the package mujoco-js gives it to a program in JavaScript: a model of two geoms that nothing moves.
//
//   distance, penetration, overlap   mj_geomDistance, with a distmax that no two points can exceed
//   ray                              mj_ray
//
// --setting default    the options as they are made: ccd_tolerance 1e-6, ccd_iterations 35
// --setting tightest   ccd_tolerance kLeastTolerance, ccd_iterations kMostIterations
//
// What is documented: XML reference, option: ccd_tolerance ends the convex collision early, ccd_iterations ends it at
// all; API reference: mj_geomDistance gives the smallest signed distance and the segment "from geom1 to geom2", mj_ray the
// distance to the nearest surface, from inside as well. No error is bounded, and nothing is said of touching.
//
// Vertices of a mesh are held in floats, about its centre and along its principal axes; all else in doubles. So the
// scalar is said to be float. A mesh without volume is refused when the model is compiled.

import initialize from "mujoco-js";
import { bounding_radius, norm, subtract } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["geomDistance"]);
const setting = option("setting", ["default", "tightest"]);

const kLeastTolerance = 1e-12;
// 200 make the package trap: the polytope of the expanding polytope algorithm lies on its stack.
const kMostIterations = 100;
const kModel = "/question.xml";

const log = (line) => console.error(line);
const mujoco = await initialize({ print: log, printErr: log });
const segment = new mujoco.DoubleBuffer(6);
const hit_geom = new mujoco.IntBuffer(1);
const kEveryGroup = [1, 1, 1, 1, 1, 1];
const kStaticToo = 1;
const kNoBody = -1;

const options = setting === "tightest" ? `<option ccd_tolerance="${kLeastTolerance}" ccd_iterations="${kMostIterations}"/>` : "";

// -> { asset, attributes } of the XML of a geom.
function geom_of(shape, name) {
  const plain = (type, ...size) => ({ asset: "", attributes: `type="${type}" size="${size.join(" ")}"` });
  switch (shape.type) {
    case "sphere":
      return plain("sphere", shape.radius);
    case "capsule":
    case "cylinder":
      return plain(shape.type, shape.radius, shape.half_height);
    case "box":
      return plain("box", ...shape.half_extents);
    case "ellipsoid":
      return plain("ellipsoid", ...shape.radii);
    case "hull":
      return {
        asset: `<mesh name="${name}" inertia="convex" vertex="${shape.vertices.flat().join(" ")}"/>`,
        attributes: `type="mesh" mesh="${name}"`,
      };
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

function model_of(bodies) {
  const geoms = bodies.map((body, k) => ({ body, ...geom_of(body.shape, `mesh${k}`) }));
  const placed = geoms.map(({ body, attributes }) =>
    `<geom ${attributes} pos="${body.position.join(" ")}" quat="${body.orientation.join(" ")}"/>`);
  const assets = geoms.map(({ asset }) => asset);
  mujoco.FS.writeFile(kModel,
    `<mujoco>${options}<asset>${assets.join("")}</asset><worldbody>${placed.join("")}</worldbody></mujoco>`);
  let model;
  try {
    model = mujoco.MjModel.loadFromXML(kModel);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw error;
    throw new Unsupported(`MuJoCo compiles no model of this: ${error?.message ?? error}`);
  }
  if (!model) throw new Unsupported("MuJoCo compiles no model of this");
  const data = new mujoco.MjData(model);
  mujoco.mj_kinematics(model, data);
  const release = () => {
    data.delete();
    model.delete();
  };
  return { model, data, release };
}

const between = (read) => ({ a, b }) => {
  const { model, data, release } = model_of([a, b]);
  const most = 2 * (norm(subtract(b.position, a.position)) + bounding_radius(a.shape) + bounding_radius(b.shape));
  return {
    release,
    run: () => mujoco.mj_geomDistance(model, data, 0, 1, most, segment),
    read: (gap) => {
      if (gap >= most) return { outcome: "not_converged", message: "nothing within a distance beyond reach" };
      const ends = Array.from(segment.GetView());
      return read(gap, { point_a: ends.slice(0, 3), point_b: ends.slice(3) });
    },
  };
};

const overlap = between((gap) => ({ outcome: gap > 0 ? "miss" : "initially_overlapping" }));

const distance = between((gap, points) =>
  gap > 0 ? { outcome: "miss", distance: gap, ...points } : { outcome: "initially_overlapping", distance: 0, ...points });

const penetration = between((gap, points) =>
  gap > 0 ? { outcome: "miss" } : { outcome: "initially_overlapping", depth: -gap, ...points });

function ray({ a, origin, direction, t_max }) {
  const { model, data, release } = model_of([a]);
  return {
    release,
    run: () => mujoco.mj_ray(model, data, origin, direction, kEveryGroup, kStaticToo, kNoBody, hit_geom),
    read: (time) => (time < 0 || time > t_max ? { outcome: "miss" } : { outcome: "hit", time }),
  };
}

serve(
  {
    name: `mujoco-${call}-${setting}`,
    version: "0.0.7",
    about: "MuJoCo 3.3.8 by mujoco-js: mj_geomDistance of two geoms, mj_ray",
    scalar: "float",
    shapes: ["sphere", "capsule", "box", "ellipsoid", "cylinder", "hull"],
    infinite_t_max: true,
  },
  {
    ray: { declares: { answers: ["time"], starts: false, touching: "either" }, ask: ray },
    overlap: { declares: { answers: [], touching: "either" }, ask: overlap },
    distance: { declares: { answers: ["distance", "witnesses"], touching: "either" }, ask: distance },
    penetration: { declares: { answers: ["depth", "witnesses"], touching: "either" }, ask: penetration },
  });
