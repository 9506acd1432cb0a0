// A scene of many bodies, played: graze.play/1. The bodies along their paths by a slider, the events as marks over it, one
// event at a time as the pair that meets, with normal and witnesses, and in words what was not simulated.
import { add, moves, norm, place, poseAt, inBody, sub, times } from "./motion.js";
import { Stage } from "./stage.js";
import { Crowd } from "./crowd.js";
import { block, copyable, count, full, h, plural, short } from "./dom.js";

const kSteps = 2000;
const kFlash = 0.03; // of the step: so long an event's point is seen after it
const kNear = 10;    // pixels: a press on the time line takes an event that is so near
const kAsks = { pair: "each pair's first contact", body: "each body's first contact", first: "the first contact of all", verdict: "does anything touch?" };
const kView = { right: [1, 0, 0], up: [0, 0, 1], towards: [0, -1, 0] };
const number = (x) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : x);
const clock = (t) => (t === 0 || Math.abs(t) > 1e-4 ? String(Number(t.toPrecision(6))) : t.toExponential(4));
const words = (outcome) => (outcome === "initially_overlapping" ? "in contact at the start" : outcome === "not_converged" ? "open: it may touch" : outcome);

// A body as motion.js places it; its quaternion is of any length.
function bodyOf(given) {
  const q = given.orientation ?? [1, 0, 0, 0], most = Math.max(...q.map(Math.abs)), scaled = q.map((x) => x / most);
  const length = Math.hypot(...scaled), zero = [0, 0, 0];
  return { name: given.name, shape: given.shape, position: given.position ?? zero, orientation: scaled.map((x) => x / length),
    displacement: given.displacement ?? zero, rotation: given.rotation ?? zero, pivot: given.pivot ?? zero, t_max: number(given.t_max) };
}
const still = (body) => ({ ...body, displacement: [0, 0, 0], rotation: [0, 0, 0] });

class Play {
  constructor(data, heading) {
    this.data = data;
    this.bodies = data.bodies.map(bodyOf);
    this.probes = data.probes.map(bodyOf);
    this.byName = new Map(this.bodies.map((body) => [body.name, body]));
    this.probeByName = new Map(this.probes.map((body) => [body.name, body]));
    this.events = [...data.events.map((event) => ({ ...event, time: number(event.toi.lower) })),
      ...data.probe_events.map((event) => ({ ...event, a: event.probe, of_probe: true, time: number(event.toi.lower) }))]
      .filter((event) => this.who(event).every(Boolean));
    this.last = number(data.t_max);
    this.time = 0;
    this.chosen = -1;
    this.makeStage();
    this.element = h("article", { class: "scene" }, this.head(heading), h("div", { class: "playing" },
      h("figure", {}, this.stage.element, this.tools()), this.side()), this.timeLine(), this.words(), this.more());
    this.show(0);
  }

  // The two of an event, as they move in it: a ray or a cast goes among bodies that stand.
  who(event) {
    const b = this.byName.get(event.b);
    return event.of_probe ? [this.probeByName.get(event.a), b && still(b)] : [this.byName.get(event.a), b];
  }

  head(heading) {
    const { data } = this, contacts = this.events.filter((event) => event.outcome !== "not_converged").length;
    const left = Object.entries(data.left_out).filter(([, n]) => n > 0);
    return h("header", {}, h(heading, {}, data.id),
      h("p", { class: "result" }, `${plural(contacts, "contact")}; asked: ${kAsks[data.ask]}, tier ${data.tier}` +
        (this.events.length > contacts ? `; ${count(this.events.length - contacts)} left open` : "") +
        (data.status === "complete" ? "" : `; ${data.status}`)),
      left.length > 0 && h("p", { class: "fault" }, `Not on this page: ${left.map(([what, n]) => `${count(n)} ${what.replaceAll("_", " ")}`).join(", ")}; the command has them all.`),
      data.comment && h("p", { class: "comment" }, data.comment));
  }

  makeStage() {
    const { bodies, probes, data } = this;
    const reach = data.shapes.map(({ mesh }) => {
      let most = 0;
      for (let i = 0; i < mesh.vertices.length; i += 3) most = Math.max(most, Math.hypot(mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]));
      return most;
    });
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const corners = [], moving = [];
    for (const body of bodies) {
      for (const t of moves(body) ? [0, this.last] : [0]) {
        const middle = poseAt(body, t).position, r = reach[body.shape];
        for (let i = 0; i < 3; ++i) {
          low[i] = Math.min(low[i], middle[i] - r);
          high[i] = Math.max(high[i], middle[i] + r);
        }
      }
      for (let i = 0; i < data.shapes[body.shape].mesh.vertices.length && corners.length < 20000; i += 3) {
        const x = data.shapes[body.shape].mesh.vertices.slice(i, i + 3);
        for (const t of moves(body) ? [0, this.last] : [0]) (moves(body) ? moving : corners).push(place(poseAt(body, t), x));
      }
    }
    const focus = bodies.length ? times(0.5, add(low, high)) : [0, 0, 0];
    const size = bodies.length ? norm(sub(high, low)) : 1;
    const stage = (this.stage = new Stage({ label: "All bodies at the time of the slider", name: "bodies", focus, size, view: kView }));
    const that_moves = moving.map(stage.to), all = [...corners.map(stage.to), ...that_moves];
    const whole = () => (all.length ? all : [[0, 0, 0]]);
    stage.everything = whole;
    // At first what moves, where the rest would make it small.
    stage.ready = () => {
      const reach = stage.reach();
      stage.everything = () => that_moves;
      const { middle } = stage.extent(), own = that_moves.length ? stage.reach() : Infinity;
      stage.everything = whole;
      if (own < 0.6 * reach) stage.aim(middle, stage.half / (1.3 * own));
    };
    this.reach = reach;
    this.members = new Map(bodies.map((body) => [body, { mesh: body.shape, poseAt: (t) => poseAt(body, t),
      kind: !moves(body) ? "c" : norm(body.rotation) > 0 ? "turning" : "moving" }]));
    this.crowd = new Crowd(stage, data.shapes.map(({ mesh }) => mesh), [...this.members.values()]);
    this.rays = probes.map((probe) => ({ probe, ...this.wayOf(probe, size) }));
    stage.draw = () => this.overlay();
  }

  // A ray or a cast, from where it starts to its first contact or its end; where it has none, out of the picture.
  wayOf(probe, size) {
    const own = this.events.filter((event) => event.of_probe && event.a === probe.name);
    const speed = norm(probe.displacement);
    const first = own.length && this.data.probes.find((one) => one.name === probe.name).ask !== "all" ? own[0].time : Infinity;
    const end = Math.min(first, probe.t_max, speed > 0 ? (2 * size) / speed : 0);
    const line = this.data.shapes[probe.shape].mesh.vertices.length <= 3;
    return { line, end, hits: own.map((event) => poseAt(probe, event.time).position) };
  }

  overlay() {
    const { stage } = this, event = this.events[this.chosen];
    for (const { probe, line, end, hits } of this.rays) {
      const from = stage.to(poseAt(probe, 0).position), to = stage.to(poseAt(probe, end).position);
      stage.line([from, to], "ray thin");
      const vertices = this.data.shapes[probe.shape].mesh.vertices;
      if (!line) {
        const points = [];
        for (let i = 0; i < vertices.length; i += 3) points.push(stage.to(place(poseAt(probe, end), vertices.slice(i, i + 3))));
        stage.outline(points, "ghost");
      }
      for (const hit of line ? hits : []) stage.dot(stage.to(hit), "contact", 2.5);
    }
    // Of a body that is too small to be seen, where it is.
    for (const [body, member] of this.members) {
      if ((this.reach[body.shape] / stage.size) * stage.pixels < 2 && !this.crowd.hidden.has(member))
        stage.dot(stage.to(member.poseAt(event?.of_probe ? 0 : this.time).position), `small ${member.kind}`, 1.8);
    }
    for (const one of this.events) {
      if (one.of_probe || !one.point_a || one.time > this.time || this.time - one.time > kFlash * this.last) continue;
      stage.dot(stage.to(one.point_a), "contact", 4);
    }
    if (!event) return;
    const pair = this.who(event), names = ["a", "b"];
    const points = event.point_a ? [event.point_a, event.point_b] : null;
    pair.forEach((body, k) => {
      if (points && moves(body) && this.last > 0) {
        const at = inBody(poseAt(body, event.time), points[k]), parts = norm(body.rotation) > 0 ? 96 : 1;
        const until = Math.max(event.time, event.of_probe ? event.time : this.last);
        stage.line(Array.from({ length: parts + 1 }, (_, i) => stage.to(place(poseAt(body, (until * i) / parts), at))), `path ${names[k]}`);
      }
      const middle = stage.project(stage.to(poseAt(body, this.time).position));
      stage.text([middle[0], middle[1] + 5], names[k].toUpperCase(), `${names[k]} big`);
    });
    if (!points) return;
    if (this.time === event.time) {
      stage.dot(stage.to(points[0]), "touch a", 5);
      stage.dot(stage.to(points[1]), "touch b", 3);
      if (event.normal) stage.arrow(stage.to(points[0]), event.normal, 56, "contact", "normal");
    } else {
      const now = pair.map((body, k) => stage.to(place(poseAt(body, this.time), inBody(poseAt(body, event.time), points[k]))));
      stage.line(now, "gap");
      now.forEach((p, k) => stage.dot(p, `touch ${names[k]}`, 3.5));
    }
  }

  tools() {
    const through = h("input", { type: "checkbox", onchange: () => {
      this.stage.seeThrough = through.checked;
      this.stage.render();
    } });
    const button = (label, act) => h("button", { type: "button", class: "tool", onclick: act }, label);
    this.ofPair = [button("Pair", () => this.frame("pair")), button("Contact", () => this.frame("contact"))];
    for (const one of this.ofPair) one.disabled = true;
    return h("figcaption", {}, h("span", { class: "tools" }, button("Whole", () => this.stage.whole()), this.ofPair,
      h("label", { class: "toggle" }, through, "see through"), this.legend()));
  }
  legend() {
    const kinds = [...new Set([...this.members.values()].map(({ kind }) => kind))];
    const names = { c: "at rest", moving: "moves", turning: "turns" };
    return h("span", { class: "legend small" }, kinds.map((kind) => h("span", {}, h("i", { style: `background: var(--${kind})` }), names[kind])));
  }

  frame(what) {
    const event = this.events[this.chosen];
    if (!event) return;
    const sizes = this.who(event).map((body) => this.reach[body.shape]).filter((r) => r > 0);
    const smaller = sizes.length ? Math.min(...sizes) : this.stage.size / 100;
    const at = event.point_a ?? poseAt(this.who(event)[0], event.time).position;
    this.stage.magnify(what === "pair" ? 3 * smaller : smaller / 4, at);
  }

  // The list of events: one thing to reach by Tab, whose lines are gone through by the arrow keys.
  side() {
    this.lines = this.events.map((event, i) => h("li", { role: "option", id: `event-${i}`, "aria-selected": "false", onclick: () => this.choose(i) },
      h("span", { class: "when" }, event.of_probe ? "" : `t = ${short(event.time, 4)}`), ` ${event.a} – ${event.b}`,
      event.outcome === "hit" ? "" : h("span", { class: "small" }, ` ${words(event.outcome)}`)));
    const first = this.data.events.length;
    this.list = h("ul", { class: "events", role: "listbox", tabindex: 0, "aria-label": "Events in the order of time", onkeydown: (event) => this.onKey(event) },
      this.lines.map((line, i) => (i === first ? [h("li", { class: "part small", role: "presentation" }, "Rays and casts, among the bodies as they stand at t = 0"), line] : line)));
    this.about = h("div", { class: "about", "aria-live": "polite" });
    return h("div", { class: "side" }, this.events.length ? this.list : h("p", {}, "Nothing touches."), this.about);
  }
  onKey(event) {
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity };
    if (!(event.key in steps) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const last = this.events.length - 1;
    this.choose(Math.max(0, Math.min(last, this.chosen < 0 ? (steps[event.key] === Infinity ? last : 0) : this.chosen + steps[event.key])));
  }

  // The pair of an event at its time; -1: none.
  choose(i) {
    const { stage, crowd } = this;
    if (this.playing) this.play();
    this.lines[this.chosen]?.setAttribute("aria-selected", "false");
    for (const solid of this.pair ?? []) stage.remove(solid);
    this.pair = null;
    crowd.hidden.clear();
    this.chosen = i;
    const event = this.events[i];
    for (const mark of this.strip.children) mark.classList.toggle("now", mark.dataset.event === String(i));
    for (const one of this.ofPair) one.disabled = !event;
    if (!event) {
      this.about.replaceChildren();
      this.list.removeAttribute("aria-activedescendant");
      stage.whole();
      return this.show(this.time);
    }
    const line = this.lines[i];
    line.setAttribute("aria-selected", "true");
    this.list.setAttribute("aria-activedescendant", line.id);
    const pair = this.who(event);
    this.pair = pair.map((body, k) => Object.assign(stage.add(this.data.shapes[body.shape].mesh, "ab"[k]), { body }));
    for (const name of event.of_probe ? [event.b] : [event.a, event.b]) crowd.hidden.add(this.members.get(this.byName.get(name)));
    this.about.replaceChildren(...this.tell(event));
    // Within the list, whose height the words beside it have changed; the page itself stays.
    const top = line.offsetTop;
    if (top < this.list.scrollTop || top + line.offsetHeight > this.list.scrollTop + this.list.clientHeight) this.list.scrollTop = top - this.list.clientHeight / 3;
    this.show(event.time);
    this.frame("pair");
  }

  tell(event) {
    const vector = (x) => copyable(`(${x.map((c) => short(c, 4)).join(", ")})`, full(x));
    const { lower, upper } = event.toi, term = (name, ...what) => [h("dt", {}, name), h("dd", {}, what)];
    return [h("h3", {}, h("span", { class: "in-a" }, event.a), " – ", h("span", { class: "in-b" }, event.b)),
      h("dl", {}, term("outcome", words(event.outcome)),
        event.outcome !== "initially_overlapping" && term("time", copyable(full(lower)), lower === upper ? "" : [" to ", copyable(full(upper))]),
        event.normal && term("normal", vector(event.normal)), event.point_a && term("on A", vector(event.point_a)), event.point_b && term("on B", vector(event.point_b)),
        term("simulated", event.simulated, event.because.length ? `: ${event.because.join(", ")}` : "")),
      h("details", {}, h("summary", {}, "The pair as a case"), block(this.caseOf(event), "the case as JSON"),
        h("p", { class: "small" }, "Saved as pair.json, ", h("code", {}, "graze show pair.json --out pair.html"), " shows it with its proof."))];
  }
  caseOf(event) {
    const given = (list, name) => {
      const { name: own, t_max, ask, group, mask, shape, ...rest } = list.find((one) => one.name === name);
      return { shape: this.data.shapes[shape].shape, ...rest };
    };
    const a = given(event.of_probe ? this.data.probes : this.data.bodies, event.a);
    const { displacement, rotation, ...standing } = given(this.data.bodies, event.b);
    const b = event.of_probe ? standing : { ...standing, displacement, rotation };
    const horizon = event.of_probe ? this.data.probes.find((one) => one.name === event.a).t_max : this.data.t_max;
    return JSON.stringify({ schema: "graze.case/1", id: `${this.data.id}/${event.a}-${event.b}`.replace(/[^\w/.-]/g, "-"), a, b,
      t_max: horizon, ...(this.data.target_distance > 0 ? { target_distance: this.data.target_distance } : {}) });
  }

  timeLine() {
    const { events, last } = this;
    this.slider = h("input", { type: "range", min: 0, max: kSteps, step: 1, "aria-label": "time",
      oninput: () => this.show((last * Number(this.slider.value)) / kSteps, false) });
    this.clock = h("output", { class: "clock" });
    this.button = h("button", { type: "button", class: "tool", onclick: () => this.play() }, "Play");
    const marks = events.map((event, i) => ({ event, i })).filter(({ event }) => !event.of_probe);
    this.strip = h("div", { class: "strip", "data-events": marks.length, onclick: (press) => {
      const { left, width } = this.strip.getBoundingClientRect(), x = press.clientX - left;
      const away = (time) => Math.abs((width * time) / last - x);
      const nearest = marks.reduce((best, one) => (best && away(best.event.time) <= away(one.event.time) ? best : one), null);
      if (nearest && away(nearest.event.time) <= kNear) this.choose(nearest.i);
      else this.show(Math.max(0, Math.min(last, (last * x) / width)));
    } }, marks.map(({ event, i }) => h("i", { style: `left: ${(100 * event.time) / last}%`, class: event.outcome, "data-event": i })));
    const step = (by) => () => this.choose((Math.max(this.chosen, by > 0 ? -1 : 0) + by + events.length) % events.length);
    return h("div", { class: "timeline" }, h("div", { class: "slide low" }, this.button, h("div", { class: "track" }, this.strip, this.slider), this.clock),
      events.length > 0 && h("div", { class: "marks" }, h("button", { type: "button", class: "tool", onclick: step(-1) }, "Event before"),
        h("button", { type: "button", class: "tool", onclick: step(1) }, "Next event"),
        h("button", { type: "button", class: "tool", onclick: () => this.choose(-1) }, "All bodies"),
        h("span", { class: "small" }, "Each mark over the slider is an event: press it to see the pair.")));
  }

  play() {
    if (this.playing) {
      cancelAnimationFrame(this.playing);
      this.playing = 0;
      this.button.textContent = "Play";
      return;
    }
    this.button.textContent = "Stop";
    const from = this.time >= this.last ? 0 : this.time, begun = performance.now();
    const step = (now) => {
      const t = Math.min(this.last, from + (this.last * Math.max(0, now - begun)) / 6000);
      this.show(t);
      if (t < this.last) {
        this.playing = requestAnimationFrame(step);
      } else {
        this.playing = 0;
        this.button.textContent = "Play";
      }
    };
    this.playing = requestAnimationFrame(step);
  }

  show(t, moveSlider = true) {
    this.time = t;
    const { stage } = this, event = this.events[this.chosen];
    // Bodies of a ray's event stand as at t = 0, whatever its own time is.
    this.crowd.place(event?.of_probe ? 0 : t);
    for (const solid of this.pair ?? []) solid.place(poseAt(solid.body, t), stage.to);
    if (moveSlider) this.slider.value = String(Math.round((kSteps * Math.min(t, this.last)) / this.last));
    this.clock.textContent = `t = ${clock(t)}`;
    this.slider.setAttribute("aria-valuetext", this.clock.textContent);
    stage.render();
  }

  words() {
    const { spared } = this.data;
    return h("section", { class: "spared" }, h("h3", {}, "What was simulated"), h("p", {}, spared.sentence),
      h("details", {}, h("summary", {}, "All counts"), h("ul", {}, spared.counts.map((line) => h("li", {}, line)))),
      h("p", { class: "small" }, "Bodies go on along their paths after they have met: an event is a pair's first contact, and nothing here answers it."));
  }
  more() {
    const { data } = this;
    return data.command && h("div", { class: "again" }, h("span", { class: "small" }, "Play it again:"), block(data.command, "command"));
  }

  dispose() {
    cancelAnimationFrame(this.playing);
    this.crowd.dispose();
    this.stage.dispose();
  }
}

export const playView = (data, heading = "h2") => new Play(data, heading);
