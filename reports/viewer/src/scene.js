// One case: its bodies, the difference of them, a slider for time, and the numbers.
import { add, across, cross, dot, moves, norm, place, poseAt, inBody, sub, times, turnBy, apply, unit } from "./motion.js";
import { Stage } from "./stage.js";
import { block, copyable, full, h, short } from "./dom.js";

const kSteps = 2000;
const number = (x) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : x);
const lower = (answer) => (answer?.toi ? number(answer.toi.lower) : undefined);
// Without the hexfloats that stand before the numbers that they are.
const plain = (fault) => fault.replace(/-?0x[0-9a-f.]+p[-+]?\d+ \(([^()]*)\)/g, "$1");
const words = (outcome) => String(outcome ?? "unknown").replaceAll("_", " ");

// The last time that the slider reaches: past everything that is claimed, no further than the case.
function lastTime(scene) {
  const all = [scene.moment, scene.end, lower(scene.truth), ...scene.answers.map(lower)]
    .filter((t) => Number.isFinite(t) && t >= 0);
  const horizon = number(scene.t_max);
  const last = Math.max(...all) * 1.15;
  const end = last > 0 ? Math.min(last, Math.max(horizon, ...all)) : Number.isFinite(horizon) ? horizon : 1;
  return end > 0 ? end : 1;
}

function timeOf(answer) {
  if (!answer) return "–";
  if (answer.toi === undefined || answer.outcome === "miss") return words(answer.outcome);
  return answer.outcome === "hit" ? "" : words(answer.outcome);
}

// The axis that parts the bodies at time t, as the proof has it; nothing where it has none.
function axisAt(scene, t) {
  const proof = scene.proof;
  if (!proof) return null;
  if (proof.kind === "linear") {
    if (norm(proof.axis) === 0) return null;
    return number(proof.claims.lower) >= t ? proof.axis : null;
  }
  const slice = proof.chain.find((one) => number(one.begin) <= t && t <= number(one.end));
  if (!slice) return null;
  const spin = slice.frame === "a" ? scene.a.rotation : slice.frame === "b" ? scene.b.rotation : [0, 0, 0];
  return unit(apply(turnBy(times(t, spin)), slice.axis));
}

class SceneView {
  constructor(scene, heading) {
    this.scene = scene;
    this.heading = heading;
    this.last = lastTime(scene);
    this.time = scene.moment;
    this.velocity = sub(scene.b.displacement, scene.a.displacement);
    this.wrong = scene.answers.filter((answer) => answer.fault).slice(0, 3);
    this.bodies = this.makeBodies();
    this.cso = this.makeDifference();
    this.element = h("article", { class: "scene" }, this.head(), this.stages(), this.timeLine(), this.numbers(), this.more());
    this.show(this.time);
    this.bodies.ready = () => this.frame("start");
  }

  head() {
    const { scene } = this;
    return h("header", {},
      h(this.heading, {}, scene.id),
      h("p", { class: "result" }, scene.result, scene.margin ? `; ${scene.margin.name}: ${short(scene.margin.length)}` : ""),
      scene.broken && h("p", { class: "fault" }, h("strong", {}, `Broken: ${scene.broken.law}. `), `${scene.broken.sentence} ${plain(scene.broken.words)}`),
      this.wrong.map((answer) => h("p", { class: "fault" },
        h("strong", {}, answer.label), answer.failed ? " gives no answer that can be taken" : ` claims ${words(answer.outcome)}`,
        Number.isFinite(lower(answer)) ? ` at t = ${full(lower(answer))}` : "", `: ${plain(answer.fault)}`)),
      scene.comment && h("p", { class: "comment" }, scene.comment));
  }

  makeBodies() {
    const { scene } = this;
    const stage = new Stage({ label: "Both bodies at the time of the slider", name: "bodies", focus: scene.focus, size: scene.scale, view: scene.view });
    // Beside a body that fills the view, along the plane between the two.
    const sizes = [scene.a.diagonal, scene.b.diagonal];
    if (Math.min(...sizes) < Math.max(...sizes) / 20) stage.look(0.35, 0);
    this.solidA = stage.add(scene.a.mesh, "a");
    this.solidB = stage.add(scene.b.mesh, "b");
    const touch = (body, t) => place(poseAt(body, t), inBody(poseAt(body, scene.moment), body.touching));
    const until = Math.max(scene.moment, scene.end);
    const parts = scene.turns ? 128 : 1;
    const path = (body) => Array.from({ length: parts + 1 }, (_, k) => stage.to(touch(body, (until * k) / parts)));
    const ghosts = [];
    stage.everything = () => [...ghosts.flatMap(({ points }) => points), ...this.atMoment, ...paths.flatMap(([, points]) => points)];
    const standing = (body, solid) => solid.vertices.map((x) => stage.to(place(poseAt(body, scene.moment), x)));
    this.atMoment = [...standing(scene.a, this.solidA), ...standing(scene.b, this.solidB)];
    for (const [body, solid, name] of [[scene.a, this.solidA, "a"], [scene.b, this.solidB, "b"]]) {
      if (!moves(body)) continue;
      const at = (t) => solid.vertices.map((x) => stage.to(place(poseAt(body, t), x)));
      if (scene.moment > 0) ghosts.push({ points: at(0), kind: `ghost ${name}`, label: `${name.toUpperCase()}, t = 0` });
      for (const answer of this.wrong) {
        const t = lower(answer);
        if (Number.isFinite(t)) ghosts.push({ points: at(t), kind: "ghost wrong", label: `${name.toUpperCase()} as claimed` });
      }
    }
    const paths = [["a", scene.a], ["b", scene.b]].filter(([, body]) => moves(body)).map(([name, body]) => [name, path(body)]);
    stage.draw = () => {
      for (const { points, kind } of ghosts) stage.outline(points, kind);
      for (const [name, points] of paths) {
        stage.line(points, `path ${name}`);
        const [from, tip] = points.slice(-2).map((p) => stage.project(p));
        if (Math.hypot(tip[0] - from[0], tip[1] - from[1]) > 12) stage.head(from, tip, `path ${name}`);
      }
      this.drawPlane(stage);
      this.drawContact(stage);
      for (const { points, kind, label } of ghosts) this.nameIt(stage, points, label, kind);
      this.nameIt(stage, this.solidA.placed, "A", "a");
      this.nameIt(stage, this.solidB.placed, "B", "b");
    };
    return stage;
  }

  // In the middle of the body, where that is on the stage.
  nameIt(stage, points, name, kind) {
    const flat = points.map((p) => stage.project(p));
    const range = (i) => [Math.min(...flat.map((p) => p[i])), Math.max(...flat.map((p) => p[i]))];
    const [left, right] = range(0), [top, bottom] = range(1);
    const inside = [Math.max(left, 0), Math.min(right, stage.width), Math.max(top, 0), Math.min(bottom, stage.height)];
    if (inside[1] < inside[0] || inside[3] < inside[2]) return;
    const small = right - left < 24 || bottom - top < 20;
    const ghost = kind.startsWith("ghost");
    const y = small || ghost ? Math.max(34, inside[2] - 6) : (inside[2] + inside[3]) / 2 + 5;
    stage.text([(inside[0] + inside[1]) / 2, y], name, `${kind} ${ghost ? "" : "big"}`);
  }

  // The plane between the bodies that the proof's axis makes, at the slider's time.
  drawPlane(stage) {
    const axis = this.withProof.checked ? axisAt(this.scene, this.time) : null;
    if (!axis) return;
    const n = unit(axis);
    const most = Math.max(...this.solidA.placed.map((p) => dot(n, p)));
    const least = Math.min(...this.solidB.placed.map((p) => dot(n, p)));
    const margin = this.scene.target_distance / stage.size;
    const middle = (most + least) / 2;
    const at = stage.to(this.meeting());
    const centre = add(at, times(middle - dot(n, at), n));
    const [u, v] = across(n), radius = 0.35 * Math.min(1, Math.max(this.scene.a.diagonal, this.scene.b.diagonal) / stage.size);
    const disc = Array.from({ length: 40 }, (_, k) => {
      const angle = (2 * Math.PI * k) / 40;
      return add(centre, add(times(radius * Math.cos(angle), u), times(radius * Math.sin(angle), v)));
    });
    stage.polygon(disc, "plane");
    stage.arrow(centre, n, 40, "proof", "n");
    this.gap = Math.max(0, least - most - margin) * stage.size;
  }

  // Between the points of the two bodies that touch, or come nearest, as they stand.
  meeting() {
    const { scene } = this;
    const [x, y] = [scene.a, scene.b].map((body) =>
      place(poseAt(body, this.time), inBody(poseAt(body, scene.moment), body.touching)));
    return times(0.5, add(x, y));
  }

  drawContact(stage) {
    const { scene } = this;
    const points = [["a", scene.a], ["b", scene.b]].map(([name, body]) => [name,
      stage.to(place(poseAt(body, this.time), inBody(poseAt(body, scene.moment), body.touching)))]);
    stage.line(points.map(([, p]) => p), "gap");
    for (const [name, p] of points) stage.dot(p, `touch ${name}`, name === "a" ? 4.5 : 3);
    if (this.time === scene.moment && scene.contact && norm(scene.normal) > 0)
      stage.arrow(stage.to(scene.focus), scene.normal, 52, "contact", "normal");
    for (const answer of this.wrong) {
      if (this.time !== lower(answer) || !answer.normal) continue;
      stage.arrow(stage.to(answer.point_a ?? scene.focus), answer.normal, 52, "wrong", "claimed");
      if (answer.point_a) stage.dot(stage.to(answer.point_a), "wrong");
      if (answer.point_b) stage.dot(stage.to(answer.point_b), "wrong");
    }
  }

  makeDifference() {
    const { scene } = this;
    const mesh = scene.cso.mesh;
    const xs = [0, 1, 2].map((i) => mesh.vertices.filter((_, k) => k % 3 === i));
    const low = xs.map((x) => Math.min(...x)), high = xs.map((x) => Math.max(...x));
    const size = norm(sub(high, low));
    const ray = scene.turns ? [0, 0, 0] : this.velocity;
    const at = times(scene.turns ? 0 : scene.moment, ray);
    const stage = new Stage({ label: "The difference A − B of the bodies, and the path of the origin in it", name: "cso",
      focus: at, size: Math.max(size, norm(at)) || 1, view: scene.view });
    const solid = stage.add(mesh, "c");
    solid.pale = true;
    solid.place({ rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], position: [0, 0, 0] }, stage.to);
    const speed = norm(ray), horizon = number(scene.t_max);
    const span = Math.max(size, norm(at));
    const end = speed > 0 ? Math.min(horizon, Math.max(this.last, (2 * span) / speed)) : 0;
    stage.draw = () => {
      const proof = scene.proof;
      const on = this.withProof.checked;
      stage.line([stage.to([0, 0, 0]), stage.to(times(end, ray))], "ray");
      if (speed > 0) {
        const tip = stage.project(stage.to(times(end, ray))), from = stage.project(stage.to([0, 0, 0]));
        stage.head([tip[0] - 0.01 * (tip[0] - from[0]), tip[1] - 0.01 * (tip[1] - from[1])], tip, "ray", "t v");
      }
      if (on && proof?.portal?.length) {
        const corners = proof.portal.map(stage.to);
        if (corners.length > 3) {
          for (const [i, p] of corners.entries()) for (const q of corners.slice(0, i)) stage.line([p, q], "portal");
        } else {
          stage.polygon(corners, "portal");
        }
        for (const corner of corners) stage.dot(corner, "portal", 3);
      }
      const axis = proof?.kind === "linear" ? proof.axis : axisAt(scene, scene.moment);
      if (on && axis && norm(axis) > 0) {
        const n = unit(axis), reach = Math.max(...solid.placed.map((p) => dot(n, p)));
        const centre = times(reach, n), p = stage.to(at);
        const foot = add(p, times(reach - dot(n, p), n));
        const [u, v] = across(n);
        const disc = Array.from({ length: 40 }, (_, k) => {
          const angle = (2 * Math.PI * k) / 40, radius = (0.22 * size) / stage.size;
          return add(foot, add(times(radius * Math.cos(angle), u), times(radius * Math.sin(angle), v)));
        });
        stage.polygon(disc, "plane");
        stage.arrow(foot, n, 44, "proof", "n");
      }
      stage.dot(stage.to([0, 0, 0]), "origin", 4);
      stage.text([stage.project(stage.to([0, 0, 0]))[0] - 10, stage.project(stage.to([0, 0, 0]))[1] - 6], "0", "origin");
      if (!scene.turns && scene.contact) stage.dot(stage.to(at), "contact", 4);
      if (!scene.turns) stage.dot(stage.to(times(this.time, ray)), "now", 6);
      for (const answer of this.wrong) {
        if (Number.isFinite(lower(answer)) && !scene.turns) stage.dot(stage.to(times(lower(answer), ray)), "wrong", 3.5);
      }
    };
    stage.everything = () => [...solid.placed, stage.to([0, 0, 0]), stage.to(times(Math.min(end, 1.3 * scene.moment), ray))];
    return stage;
  }

  stages() {
    const toggle = (label, checked, act) => {
      const box = h("input", { type: "checkbox", checked, onchange: () => act(box.checked) });
      return [box, h("label", { class: "toggle" }, box, label)];
    };
    const [, through] = toggle("see through", false, (on) => {
      for (const stage of [this.bodies, this.cso]) {
        stage.seeThrough = on;
        stage.render();
      }
    });
    const [proof, proofLabel] = toggle("proof", true, () => {
      this.bodies.render();
      this.cso.render();
    });
    this.withProof = proof;
    const button = (label, what) => h("button", { type: "button", class: "tool", "data-frame": what, onclick: () => this.frame(what) }, label);
    const { scene } = this;
    const what = scene.turns ? `A − B as it is at t = ${short(scene.cso.time, 4)}: in contact where it holds 0`
      : "A − B at t = 0: in contact at t where it holds t v";
    return h("div", { class: "stages" },
      h("figure", {}, this.bodies.element, h("figcaption", {}, h("span", { class: "tools" },
        button("Whole", "whole"), button("Bodies", "start"), button("Contact", "contact"), through, scene.proof && proofLabel))),
      h("figure", {}, this.cso.element, h("figcaption", {}, what)));
  }

  // "whole": everything that is drawn; "start": the smaller body at the contact, where the whole would not show it.
  frame(what) {
    const { scene } = this;
    const sizes = [scene.a.diagonal, scene.b.diagonal].filter((d) => d > 0);
    const smaller = sizes.length ? Math.min(...sizes) : scene.scale || 1;
    const reach = this.bodies.reach() * this.bodies.size;
    if (what === "whole" || (what === "start" && reach < 6 * smaller)) return this.bodies.whole();
    if (what === "start") return this.bodies.magnify(1.4 * smaller);
    const margin = scene.margin?.length > 0 ? 4 * scene.margin.length : Infinity;
    return this.bodies.magnify(Math.max(Math.min(margin, smaller / 12), reach * 1e-7));
  }

  timeLine() {
    const { scene } = this;
    this.slider = h("input", { type: "range", min: 0, max: kSteps, step: 1, "aria-label": "time",
      oninput: () => this.show((this.last * Number(this.slider.value)) / kSteps, false) });
    this.clock = h("output", { class: "clock" });
    const marks = [["start", 0]];
    const truth = lower(scene.truth);
    const name = scene.contact ? "contact" : "nearest";
    if (scene.moment > 0) marks.push([Number.isFinite(truth) && truth === scene.moment ? "true time" : name, scene.moment]);
    for (const answer of this.wrong) {
      if (Number.isFinite(lower(answer))) marks.push([`claimed: ${answer.label}`, lower(answer), "wrong"]);
    }
    const play = h("button", { type: "button", class: "tool", onclick: () => this.play(play) }, "Play");
    this.playing = 0;
    return h("div", { class: "timeline" }, h("div", { class: "slide" }, play, this.slider, this.clock),
      h("div", { class: "marks" }, marks.map(([label, t, kind]) =>
        h("button", { type: "button", class: `tool ${kind ?? ""}`, "data-time": t, onclick: () => this.show(t) }, label))));
  }

  play(button) {
    if (this.playing) {
      cancelAnimationFrame(this.playing);
      this.playing = 0;
      button.textContent = "Play";
      return;
    }
    button.textContent = "Stop";
    const begun = performance.now();
    const step = (now) => {
      const part = Math.min(1, (now - begun) / 4000);
      this.show(this.last * part);
      if (part < 1) {
        this.playing = requestAnimationFrame(step);
      } else {
        this.playing = 0;
        button.textContent = "Play";
      }
    };
    this.playing = requestAnimationFrame(step);
  }

  show(t, moveSlider = true) {
    this.time = t;
    const { bodies, scene } = this;
    this.solidA.place(poseAt(scene.a, t), bodies.to);
    this.solidB.place(poseAt(scene.b, t), bodies.to);
    if (moveSlider) this.slider.value = String(Math.round((kSteps * t) / this.last));
    this.clock.textContent = `t = ${t === 0 || Math.abs(t) > 1e-4 ? Number(t.toPrecision(6)) : t.toExponential(4)}`;
    this.slider.setAttribute("aria-valuetext", this.clock.textContent);
    bodies.render();
    this.cso.render();
  }

  numbers() {
    const { scene } = this;
    const bracket = (toi) => {
      if (!toi) return "–";
      const [l, u] = [toi.lower, toi.upper].map(full);
      return l === u ? copyable(l) : [copyable(l), " to ", copyable(u)];
    };
    const vector = (x) => (x ? copyable(`(${x.map((c) => short(c, 3)).join(", ")})`, full(x)) : "–");
    const row = (kind, who, answer) => h("tr", { class: kind },
      h("th", { scope: "row" }, who),
      h("td", {}, words(answer.outcome)),
      h("td", {}, answer.outcome === "miss" ? "–" : bracket(answer.toi ?? answer.distance ?? answer.depth ?? answer.t_in)),
      h("td", {}, vector(answer.normal)),
      h("td", {}, vector(answer.world_a)), h("td", {}, vector(answer.world_b)),
      h("td", {}, answer.fault ? h("span", { class: "bad" }, h("strong", {}, answer.faults.join(", ")), Number.isFinite(answer.errors?.backward) ? `; backward error ${short(answer.errors.backward)} of scale` : "", answer.promises ? "" : " (it promises nothing, and is held to 10⁻⁶)")
        : answer.unjudged ? answer.unjudged
        : answer.errors ? `within its limit${Number.isFinite(answer.errors.over_limit) ? `: ${short(answer.errors.over_limit)} of it` : ""}; backward error ${short(answer.errors.backward)} of scale`
        : answer.note ?? "–"));
    const rows = [];
    if (scene.truth) {
      const length = (name) => scene.truth[name] && `${name} ${short(scene.truth[name].lower, 3)}`;
      rows.push(row("truth", "true", { ...scene.truth, note: [scene.truth.by, length("clearance"), length("depth")].filter(Boolean).join("; ") }));
    }
    if (scene.reference) rows.push(row("", scene.reference.label, { ...scene.reference,
      note: scene.proof ? `proof ${scene.proof.accepted ? "accepted by the checker" : `refused: ${scene.proof.refusal}`}` : "–" }));
    for (const answer of scene.answers) rows.push(row(answer.fault ? "wrong" : "", answer.label, answer));
    if (rows.length === 0) return null;
    return h("div", { class: "wide" , tabindex: 0, role: "region", "aria-label": "Answers" }, h("table", { class: "answers" },
      h("thead", {}, h("tr", {}, ["answer", "outcome", "time", "normal", "on A", "on B", "judged"].map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, rows)));
  }

  more() {
    const { scene } = this;
    const still = scene.still && h("details", {}, h("summary", {}, "Still picture, with the contact magnified"), this.still());
    return h("div", { class: "more" },
      scene.command && h("div", { class: "again" }, h("span", { class: "small" }, "Show it again:"), block(scene.command, "command")),
      h("details", {}, h("summary", {}, "The case"), block(scene.case, "the case as JSON")), still);
  }
  still() {
    const holder = h("div", { class: "still" });
    // Our own SVG, written by the command; parsed as an image would be, so that nothing in it could run.
    const parsed = new DOMParser().parseFromString(this.scene.still, "image/svg+xml").documentElement;
    for (const script of parsed.querySelectorAll("script")) script.remove();
    holder.append(document.importNode(parsed, true));
    return holder;
  }

  dispose() {
    cancelAnimationFrame(this.playing);
    this.bodies.dispose();
    this.cso.dispose();
  }
}

export function sceneView(scene, heading = "h2") {
  if (!scene.drawable) {
    return { element: h("article", { class: "scene" }, h(heading, {}, scene.id), h("p", {}, scene.result),
      block(scene.case, "the case as JSON")), dispose() {} };
  }
  return new SceneView(scene, heading);
}
