// A price list, graze.price/1: what accuracy costs in time. Work-precision diagrams, growth, what each request adds.
import { Plot, figure, powers, powerTick } from "./figure.js";
import { block, count, h, nanoseconds, plural, short } from "./dom.js";

const kColours = ["var(--a-ink)", "var(--b-ink)", "var(--contact)", "var(--proof)", "#8a8f2a", "#2a8f8a", "#b0589a", "#9a6b3f", "var(--soft)"];
const kSymbols = ["circle", "square", "triangle", "diamond2", "star", "cross", "wye", "hexagon", "asterisk", "plus"];
const kGroups = { smooth: "Smooth shapes", rotation: "Rotating bodies", sums: "Curved sums", large: "Large hulls", ties: "Near ties", polytopes: "Polytopes" };

const series = (row) => `${row.method}/${row.scalar}`;
const failed = (row) => row.failures.not_converged + row.failures.no_time + row.failures.refused;
// One colour and symbol for a method in all figures.
function styles(price) {
  const names = [...new Set(price.tables.flatMap((table) => table.rows.map(series)))];
  return new Map(names.map((name, i) => [name, { colour: kColours[i % kColours.length], symbol: kSymbols[i % kSymbols.length] }]));
}

export function pricePage(page, price, open, data) {
  const style = styles(price);
  const of = (part) => price.tables.filter((table) => table.part === part);
  const state = { error: "backward", of: "median" };
  page.append(
    h("header", { class: "verdict plain" }, h("p", { class: "small" }, "graze price"), h("h1", {}, "What accuracy costs in time"),
      h("p", { class: "small" }, `${price.machine.processor}, ${plural(price.machine.cores, "core")}; ${price.machine.compiler}, ${price.machine.build}; ${plural(price.rounds, "round")}, seed ${price.seed}` +
        (price.machine.load === null ? "" : `; load ${short(price.machine.load)}`) + (price.finished ? "" : "; not finished")),
      tableSizes(price.tables), data?.command && block(data.command, "command")),
    advice(price), diagrams(of("family"), style, state, open), growth(of("growth"), style, open), requests(of("request"), open), queries(of("query"), open), more(price));
}

// On how many cases it all stands: of so few a p99 is the worst, and "never" is of these.
function tableSizes(tables) {
  const sizes = tables.map(({ cases }) => cases).filter((n) => n > 0);
  if (sizes.length === 0) return "";
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
  return h("p", { class: "small", id: "sizes" }, `A table has ${least === most ? plural(least, "case") : `${least} to ${plural(most, "case")}`}` +
    (most < 100 ? ": a p99 is the worst of them, and “never” means of these." : "."));
}

// Which method to take, a card a user: what it asks of an answer, and for each kind of bodies the cheapest that gives it.
function advice({ advice = [] }) {
  const users = [...new Set(advice.map(({ user }) => user))];
  if (users.length === 0) return "";
  const choice = (one) => h("div", { class: "choice" },
    h("p", {}, `Bodies ${one.bodies}: `, h("strong", {}, one.label ?? "none")),
    one.call && block(one.call, "call"),
    one.cost && h("p", { class: "small" }, `${one.cost.median.toPrecision(2)} times the time of ${one.baseline}` +
      (one.tables > 1 ? ` in the mean of ${one.tables} families, ${one.cost.low.toPrecision(2)} to ${one.cost.high.toPrecision(2)}` : "") +
      `; off by ${short(one.worst, 1)} of the bodies' size at worst` + (one.wrong > 0 ? `; ${one.wrong} of ${plural(one.asked, "verdict")} wrong, ${short(one.denied, 1)} from a tie at most` : "") + "."),
    h("p", { class: "small" }, `Why: ${one.because}.`));
  return h("section", { id: "advice" }, h("h2", {}, "Which method to take"),
    h("div", { class: "users" }, users.map((user) => {
      const mine = advice.filter((one) => one.user === user);
      return h("article", { class: "user" }, h("h3", {}, `For ${user}`), h("p", {}, `Wants ${mine[0].wants}.`), mine.map(choice));
    })));
}

// What the run says in words, below the figures.
function more({ sentences }) {
  if (sentences.length === 0) return "";
  return h("section", { id: "more" }, h("h2", {}, "In words"),
    h("dl", {}, sentences.flatMap(({ topic, text }) => [h("dt", {}, topic.replaceAll("_", " ")), h("dd", {}, text)])));
}

const wide = (label, table) => h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": label }, table);
function rowsTable(table, open) {
  const heads = ["", "median", "p95", "p99", "ratio to baseline", "backward: median", "p99", "worst", "forward: worst", "wrong", "late", "failed", "supports"];
  const cell = (shown, bad) => h("td", { class: `number ${bad ? "bad" : ""}` }, shown);
  return wide(table.title, h("table", {}, h("thead", {}, h("tr", {}, heads.map((name) => h("th", { scope: "col" }, name)))),
    h("tbody", {}, table.rows.map((row) => h("tr", {}, h("th", { scope: "row" }, row.label, row.on_front ? h("span", { class: "front", title: "on the Pareto front" }, " ●") : ""),
      cell(nanoseconds(row.time?.median)), cell(nanoseconds(row.time?.p95)), cell(nanoseconds(row.time?.p99)),
      cell(row.ratio ? `${row.ratio.median.toPrecision(3)} (${row.ratio.low.toPrecision(3)}–${row.ratio.high.toPrecision(3)})` : "–"),
      cell(short(row.backward.median)), cell(short(row.backward.p99)),
      h("td", { class: "number" }, row.worst_case && row.backward.worst !== null ? h("button", { type: "button", class: "open", onclick: () => open(row.worst_case, row.label) }, short(row.backward.worst)) : short(row.backward.worst)),
      cell(short(row.forward.worst)), cell(count(row.wrong), row.wrong > 0), cell(count(row.late), row.late > 0), cell(count(failed(row)), failed(row) > 0),
      cell(short(row.supports.mean)))))));
}

// Names at the ends of lines, moved up where they would lie on each other.
function endNames(ends, text, colour, on = (x) => x) {
  const placed = [];
  for (const end of [...ends].sort((l, r) => l.x - r.x)) {
    let up = 0;
    for (const other of placed) {
      if (Math.abs(Math.log10(end.x / other.end.x)) < 0.3 && Math.abs(Math.log10(end.y / other.end.y)) < 1) up = Math.max(up, other.up + 13);
    }
    placed.push({ end, up });
  }
  return placed.map(({ end, up }) => Plot.text([end], { x: (d) => on(d.x), y: "y", text, dx: 9, dy: -up, textAnchor: "start", fill: colour, stroke: "var(--ground)", strokeWidth: 3 }));
}

function labelOf(row) {
  const trouble = [row.wrong && `${row.wrong} wrong`, row.late && `${row.late} late`, failed(row) && `${failed(row)} without an answer`].filter(Boolean).join(", ");
  return `${row.label}: ${nanoseconds(row.time.median)} (p99 ${nanoseconds(row.time.p99)}); backward error ${short(row.backward.median)} median, ${short(row.backward.worst)} worst; ${trouble || "never wrong, never late"}`;
}

function diagrams(tables, style, state, open) {
  const holder = h("div", {});
  const draw = () => {
    holder.replaceChildren(...Object.entries({ ...kGroups, "": "Others" }).flatMap(([group, title]) => {
      const inside = tables.filter((table) => table.group === group);
      if (inside.length === 0) return [];
      return [h("h3", { class: "group" }, title), h("div", { class: "many" }, inside.map((table) => diagram(table, style, state, open)))];
    }));
  };
  const choice = (key, options) => h("fieldset", {}, h("legend", {}, key === "of" ? "of the cases" : "error"), options.map(([value, label]) => {
    const input = h("input", { type: "radio", name: `price-${key}`, value, checked: state[key] === value, onchange: () => {
      state[key] = value;
      draw();
    } });
    return h("label", { class: "toggle" }, input, label);
  }));
  draw();
  return h("section", { id: "diagrams" }, h("h2", {}, "Error against time"),
    h("p", {}, "Work-precision diagrams: each line is a method at tolerances from loose to tight. Lower is nearer, left is quicker; a filled mark is on the Pareto front (nothing is quicker and nearer), a cross marks a setting with wrong, late or missing answers."),
    h("div", { class: "choices" }, choice("error", [["backward", "backward"], ["forward", "forward"]]), choice("of", [["median", "median"], ["p99", "p99"], ["worst", "worst"]])), holder);
}

function diagram(table, style, state, open) {
  const rows = table.rows.filter((row) => row.time && row[state.error][state.of] !== null);
  const positive = rows.map((row) => row[state.error][state.of]).filter((y) => y > 0);
  const floor = positive.length ? 10 ** (Math.floor(Math.log10(Math.min(...positive))) - 1) : 1e-18;
  const data = rows.map((row) => ({ row, x: row.time.median, y: row[state.error][state.of] > 0 ? row[state.error][state.of] : floor, s: series(row),
    bad: row.wrong + row.late + failed(row) > 0 }));
  const zero = data.some((d) => d.y === floor && !(d.row[state.error][state.of] > 0));
  const names = [...new Set(data.map((d) => d.s))];
  const colour = (d) => style.get(d.s).colour;
  const lines = [...data].sort((l, r) => r.row.tolerance - l.row.tolerance);
  // The last mark of each line carries its name.
  const ends = names.map((name) => data.filter((d) => d.s === name).reduce((l, r) => (r.y < l.y || (r.y === l.y && r.x > l.x) ? r : l)));
  const points = data.map(({ row }) => ({ label: labelOf(row), act: row.worst_case ? () => open(row.worst_case, row.label) : null }));
  const make = (width) => Plot.plot({
    width, height: 330, marginLeft: 46, marginBottom: 40, marginTop: 24, marginRight: 84,
    style: { background: "none", fontSize: "11.5px", overflow: "visible" },
    x: { type: "log", label: "median time, ns →", ticks: powers(data.map((d) => d.x)), tickFormat: powerTick, grid: true, nice: true },
    y: { type: "log", label: `↑ ${state.error} error over scale, ${state.of}`, ticks: [...(zero ? [floor] : []), ...powers(positive)].filter((y, i, all) => all.indexOf(y) === i), tickFormat: (y) => (zero && y <= floor * 1.01 ? "0" : powerTick(y)), grid: true },
    marks: [
      Plot.line(lines, { x: "x", y: "y", z: "s", stroke: colour, strokeWidth: 1.5, strokeOpacity: 0.75 }),
      Plot.dot(data, { x: "x", y: "y", stroke: colour, fill: (d) => (d.row.on_front ? style.get(d.s).colour : "var(--ground)"), symbol: (d) => (d.bad ? "times" : "circle"), strokeWidth: 2, r: 4.5, className: "point" }),
      endNames(ends, (d) => d.s.replace("/double", ""), colour),
    ],
    symbol: { type: "identity" }, color: { type: "identity" },
  });
  return figure({ title: table.title, caption: `${table.sentence} ${plural(table.cases, "case")}.`, make: data.length ? make : () => h("p", {}, "Nothing was timed."), points, table: rowsTable(table, open) });
}

function growth(tables, style, open) {
  const all = new Map();
  for (const table of tables) all.set(table.series, [...(all.get(table.series) ?? []), table]);
  if (all.size === 0) return "";
  const figures = [...all].map(([name, list]) => {
    const data = list.flatMap((table) => table.rows.filter((row) => row.time).map((row) => ({ table, row, x: table.x, y: row.time.median, s: row.label }))).filter((d) => d.x !== null);
    const xs = [...new Set(data.map((d) => d.x))].sort((l, r) => l - r);
    const log = xs.length > 1 && xs[0] > 0 && xs[xs.length - 1] / xs[0] > 20;
    const ends = [...new Set(data.map((d) => d.s))].map((s) => data.filter((d) => d.s === s).reduce((l, r) => (r.x > l.x ? r : l)));
    const colour = (d) => style.get(series(d.row)).colour;
    // By its logarithm on a plain axis: one of a logarithm leaves labels out that are no powers of its base.
    const on = (x) => (log ? Math.log10(x) : x);
    const points = data.map(({ table, row }) => ({ label: `${table.x_name} ${table.x}, ${labelOf(row)}`, act: row.slowest_case ? () => open(row.slowest_case, row.label) : null }));
    const make = (width) => Plot.plot({
      width, height: 330, marginLeft: 46, marginBottom: 40, marginTop: 24, marginRight: 100, style: { background: "none", fontSize: "11.5px", overflow: "visible" },
      x: { label: `${list[0].x_name} →`, ticks: xs.length <= 10 ? xs.map(on) : undefined, tickFormat: (x) => short(log ? 10 ** x : x, 3), grid: true },
      y: { type: "log", label: "↑ median time, ns", ticks: powers(data.map((d) => d.y)), tickFormat: powerTick, grid: true, nice: true },
      color: { type: "identity" },
      marks: [Plot.line(data, { x: (d) => on(d.x), y: "y", z: "s", stroke: colour, strokeWidth: 1.6, sort: "x" }),
        Plot.dot(data, { x: (d) => on(d.x), y: "y", stroke: colour, fill: "var(--ground)", r: 4, strokeWidth: 2, className: "point" }),
        endNames(ends, (d) => d.s.replace("/double", ""), colour, on)],
    });
    return figure({ title: name.replaceAll("_", " "), caption: list[0].sentence, make, points });
  });
  return h("section", { id: "growth" }, h("h2", {}, "Growth"), h("div", { class: "many" }, figures));
}

// What each request adds: a bar a row, of the ratio to the verdict alone.
function requests(tables, open) {
  if (tables.length === 0) return "";
  const figures = tables.map((table) => {
    const data = table.rows.filter((row) => row.time).map((row) => ({ row, name: row.label.replace("/double", ""), y: row.time.median }));
    const points = data.map(({ row }) => ({ label: labelOf(row), act: row.slowest_case ? () => open(row.slowest_case, row.label) : null }));
    const make = (width) => Plot.plot({
      width, height: 46 + 24 * data.length, marginLeft: Math.min(190, width * 0.42), marginRight: 70, marginBottom: 36, style: { background: "none", fontSize: "11.5px", overflow: "visible" },
      x: { label: "median time, ns →", grid: true, zero: true }, y: { label: null, domain: data.map((d) => d.name) },
      marks: [Plot.barX(data, { x: "y", y: "name", fill: "var(--a)", className: "point" }),
        Plot.text(data, { x: "y", y: "name", text: (d) => `${nanoseconds(d.y)}${d.row.ratio ? `, × ${d.row.ratio.median.toPrecision(3)}` : ""}`, dx: 5, textAnchor: "start" })],
    });
    return figure({ title: table.title, caption: table.sentence, make, points, table: rowsTable(table, open) });
  });
  return h("section", { id: "requests" }, h("h2", {}, "What each request adds"), h("div", { class: "many" }, figures));
}

function queries(tables, open) {
  if (tables.length === 0) return "";
  return h("section", { id: "queries" }, h("h2", {}, "Queries beside the cast"), tables.map((table) => h("div", {}, h("h3", {}, table.title), h("p", { class: "small" }, table.sentence), rowsTable(table, open))));
}
