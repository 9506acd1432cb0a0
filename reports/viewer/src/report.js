// A certification, or a price list, or both.
import { Plot, figure, powers, powerTick } from "./figure.js";
import { caseOpener } from "./open_case.js";
import { block, count, h, nanoseconds, plural, short } from "./dom.js";
import { pricePage } from "./price.js";

const number = (x) => (x === "inf" ? Infinity : x);
const kKinds = { linear: "Linear casts", rotating: "Casts of rotating bodies", query: "Queries beside the cast" };
const faulty = (one) => Object.values(one.faults).reduce((sum, n) => sum + n, 0);
const rate = (part, whole) => (part === 0 ? "0" : `${count(part)}${whole > 0 ? ` (${short((100 * part) / whole, 1)} %)` : ""}`);
// Errors over what is granted: 1 is the limit.
const ofLimit = (x) => (x === null ? "–" : x === 0 ? "0" : short(number(x), 2));

export function reportPage(page, data) {
  const open = caseOpener(data.scenes);
  if (data.kind === "certify") certifyPage(page, data, open);
  if (data.price) pricePage(page, data.price, open, data.kind === "price" ? data : null);
  const asked = decodeURIComponent(location.hash.slice(1));
  if (data.scenes?.[asked]) open(asked);
}

function certifyPage(page, data, open) {
  const ours = data.methods.filter((m) => m.ours), others = data.methods.filter((m) => !m.ours);
  page.append(
    verdict(data),
    contents(data, others),
    others.length > 0 ? engines(data, others, open) : "",
    ours.length > 0 ? keepers(data, ours, open) : "",
    accuracyAgainstTime(data, open),
    heat(data, open),
    worstCases(data, open),
    data.findings.length > 0 ? findings(data, open) : "",
    glossary(),
  );
}

function verdict(data) {
  const wrong = data.methods.reduce((sum, m) => sum + faulty(m), 0);
  const broken = data.methods.filter((m) => !m.held);
  return h("header", { class: `verdict ${data.held ? "good" : "poor"}` },
    h("p", { class: "small" }, "graze certify"),
    h("h1", {}, data.held ? "Every method keeps its guarantee" : broken.length ?
      `${plural(broken.length, "method")} of ${data.methods.length} ${broken.length === 1 ? "breaks its" : "break their"} guarantee` : "A guarantee is broken"),
    h("p", {}, `${plural(data.answers, "answer")} to ${plural(data.cases, "case")} were judged in ${Number(data.seconds.toPrecision(3))} s; `,
      wrong === 0 ? "none is at fault." : `${plural(wrong, "fault")} ${wrong === 1 ? "was" : "were"} found.`),
    data.breaches.length > 0 && h("ul", { class: "breaches" }, data.breaches.slice(0, 12).map((line) => h("li", {}, line)),
      data.breaches.length > 12 && h("li", {}, `and ${data.breaches.length - 12} more, in certification.json`)),
    data.unfinished.length > 0 && h("p", { class: "bad" }, `Not finished: ${data.unfinished.join(", ")}`),
    block(data.command, "command"));
}

function contents(data, others) {
  const all = [others.length && ["engines", "Engines"], ["methods", "Guarantees kept"], ["price", "Accuracy and time"], ["families", "By family"],
    ["worst", "Worst cases"], data.findings.length && ["findings", "Findings"], ["words", "Words"]].filter(Boolean);
  return h("nav", { class: "contents", "aria-label": "contents" }, all.map(([id, name]) => h("a", { href: `#${id}`, onclick: (event) => {
    event.preventDefault();
    document.getElementById(id)?.scrollIntoView();
  } }, name)));
}

// A part of the limit as a bar: full at 1, logarithmic, so that 10⁻³ can be told from 10⁻⁶.
function bar(x) {
  if (x === null) return "";
  const part = x === 0 ? 0 : Math.max(0, Math.min(1, 1 + Math.log10(number(x)) / 8));
  return h("span", { class: `bar ${number(x) > 1 ? "beyond" : ""}`, "aria-hidden": "true" }, h("i", { style: `width:${(100 * part).toFixed(1)}%` }));
}

// The case of a method whose error is the largest part of its limit.
function worstOf(data, method) {
  const index = data.methods.indexOf(method);
  let worst = null;
  for (const cell of data.cells) {
    if (cell.method === index && cell.worst && (!worst || number(cell.over_limit) > number(worst.over_limit))) worst = cell;
  }
  return worst;
}

function sortable(table) {
  const head = [...table.tHead.rows[0].cells];
  head.forEach((cell, i) => {
    if (!cell.dataset.sort) return;
    const words = [...cell.childNodes];
    const button = h("button", { type: "button", class: "sort" }, ...words);
    cell.replaceChildren(button);
    button.addEventListener("click", () => {
      const up = cell.getAttribute("aria-sort") !== "ascending";
      for (const other of head) other.removeAttribute("aria-sort");
      cell.setAttribute("aria-sort", up ? "ascending" : "descending");
      const value = (row) => {
        const cellOf = row.cells[i];
        return cellOf.dataset.value === undefined ? cellOf.textContent : Number(cellOf.dataset.value);
      };
      const rows = [...table.tBodies[0].rows].sort((l, r) => {
        const [x, y] = [value(l), value(r)];
        const order = typeof x === "number" ? (Number.isNaN(x) ? 1 : Number.isNaN(y) ? -1 : x - y) : x.localeCompare(y);
        return up ? order : -order;
      });
      table.tBodies[0].append(...rows);
    });
  });
  return table;
}

const wide = (label, table) => h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": label }, table);

function keepers(data, methods, open) {
  const heads = [["method", 1], ["promise"], ["kept", 1], ["answers", 1], ["wrong", 1], ["late", 1], ["other faults", 1], ["stalls", 1],
    ["worst error of its limit", 1], ["most supports", 1], ["median time", 1]];
  const rows = methods.map((m) => {
    const { wrong = 0, late = 0, ...rest } = m.faults;
    const other = Object.values(rest).reduce((sum, n) => sum + n, 0);
    const worst = worstOf(data, m);
    const cell = (value, shown, bad) => h("td", { "data-value": value ?? NaN, class: `number ${bad ? "bad" : ""}` }, shown);
    return h("tr", { class: m.held ? "" : "wrong" }, h("th", { scope: "row" }, m.name),
      h("td", { class: "promise" }, m.promise),
      h("td", { "data-value": m.held ? 1 : 0 }, m.held ? "yes" : h("strong", { class: "bad" }, "no")),
      cell(m.cases, count(m.cases)), cell(wrong, count(wrong), wrong > 0), cell(late, count(late), late > 0), cell(other, count(other), other > 0),
      cell(m.stalled, rate(m.stalled, m.cases)),
      h("td", { "data-value": number(m.over_limit) ?? NaN, class: "number" }, worst
        ? h("button", { type: "button", class: "open", onclick: () => open(worst.worst, m.name), title: `look at ${worst.worst}` }, bar(m.over_limit), ofLimit(m.over_limit))
        : ofLimit(m.over_limit)),
      cell(number(m.supports), m.supports === null ? "–" : count(m.supports)),
      cell(number(m.ns), m.ns === null ? "–" : nanoseconds(m.ns)));
  });
  // A table a kind: what one sees first is what most come for.
  const table = (kind) => {
    const own = rows.filter((_, i) => methods[i].kind === kind);
    return own.length === 0 ? "" : wide(kKinds[kind], sortable(h("table", { class: "keepers" }, h("thead", {}, h("tr", {}, heads.map(([name, sorts]) => h("th", { scope: "col", "data-sort": sorts }, name)))), h("tbody", {}, own))));
  };
  const part = (kind, inside) => inside && [h("h3", {}, kKinds[kind]), inside];
  const asked = table("query");
  return h("section", { id: "methods" }, h("h2", {}, "Guarantees kept, and their cost"),
    h("p", {}, "Each method on all its families together. An error at its limit is 1; press it to look at the case. Times are of this machine; which method to take for a game, a robot or a CAD tool, graze price --report says first."),
    part("linear", table("linear")), part("rotating", table("rotating")),
    asked && h("details", {}, h("summary", {}, `${kKinds.query}: ${plural(methods.filter((m) => m.kind === "query").length, "method")}`), asked));
}

function engines(data, methods, open) {
  const heads = [["engine", 1], ["asked", 1], ["not asked", 1], ["wrong", 1], ["late", 1], ["early or off", 1], ["contact off", 1], ["stalls", 1], ["failed", 1],
    ["would have passed at, over scale", 1], ["needed by"], ["median time", 1]];
  const rows = methods.map((m) => {
    const f = (name) => m.faults[name] ?? 0;
    const cell = (value, shown = count(value), bad = value > 0) => h("td", { "data-value": value ?? NaN, class: `number ${bad ? "bad" : ""}` }, shown);
    const failed = Object.entries(m.failures).map(([name, n]) => `${name} ${n}`).join(", ");
    return h("tr", { class: m.held ? "" : "wrong" }, h("th", { scope: "row" }, m.name), cell(m.cases, undefined, false), cell(m.not_asked, undefined, false),
      cell(f("wrong")), cell(f("late")), cell(f("early") + f("off")), cell(f("contact off")), cell(m.stalled, undefined, false),
      h("td", { "data-value": f("failed") }, failed || "0"),
      cell(number(m.least), short(number(m.least)), false),
      h("td", {}, m.least_by ? h("button", { type: "button", class: "open", onclick: () => open(m.least_by, m.name) }, m.least_by) : "–"),
      cell(number(m.ns), m.ns === null ? "–" : nanoseconds(m.ns), false));
  });
  return h("section", { id: "engines" }, h("h2", {}, "Engines side by side"),
    h("p", {}, "Each is measured against the question as it saw it. One that declares nothing is convicted of failures only; what it would have passed at says how accurate it was."),
    wide("Engines", sortable(h("table", {}, h("thead", {}, h("tr", {}, heads.map(([name, sorts]) => h("th", { scope: "col", "data-sort": sorts }, name)))), h("tbody", {}, rows)))));
}

// One mark a method: how long it takes, how far it is off at the worst.
function accuracyAgainstTime(data, open) {
  const all = data.methods.filter((m) => m.ns > 0 && m.backward.worst !== null);
  if (all.length === 0) return "";
  const exact = all.filter((m) => number(m.backward.worst) > 0).map((m) => number(m.backward.worst)).filter(Number.isFinite);
  const least = exact.length ? 10 ** Math.floor(Math.log10(Math.min(...exact)) - 1) : 1e-18;
  const rows = all.map((m) => {
    const worst = worstOf(data, m), value = number(m.backward.worst);
    return { m, x: m.ns, y: value > 0 ? (Number.isFinite(value) ? value : 1) : least, zero: value === 0,
      kind: `${m.ours ? "" : "engine, "}${m.kind === "rotating" ? "rotating" : "linear"}, ${m.scalar}`, name: m.name.replace(/^rotating /, ""), worst };
  });
  const points = rows.map(({ m, worst }) => ({
    label: `${m.name}: ${nanoseconds(m.ns)}, worst backward error ${short(number(m.backward.worst))} of scale${worst ? `; press for ${worst.worst}` : ""}`,
    act: worst ? () => open(worst.worst, m.name) : null,
  }));
  const kinds = [...new Set(rows.map((row) => row.kind))];
  // Names that would lie on each other are left to the pointing.
  const placed = [];
  const apart = (a, b) => Math.abs(Math.log10(a.x / b.x)) > 0.55 || Math.abs(Math.log10(a.y / b.y)) > 0.75;
  for (const row of rows) if (placed.every((other) => apart(row, other))) placed.push(row);
  const make = (width) => Plot.plot({
    width, height: Math.min(440, 260 + width * 0.16), marginLeft: 52, marginBottom: 42, marginTop: 26, marginRight: width > 600 ? 90 : 30,
    style: { background: "none", fontSize: "12px", overflow: "visible" },
    x: { type: "log", label: "median time of a cast, ns →", ticks: powers(rows.map((r) => r.x)), tickFormat: powerTick, grid: true, nice: true },
    y: { type: "log", label: "↑ worst backward error over scale", ticks: powers(rows.map((r) => r.y)), tickFormat: (y) => (rows.some((r) => r.zero) && y <= least * 1.01 ? "0" : powerTick(y)), grid: true, nice: true },
    symbol: { domain: kinds, legend: true, range: ["circle", "square", "triangle", "diamond2", "star", "cross"] },
    color: { domain: kinds, range: ["var(--a-ink)", "var(--b-ink)", "var(--proof)", "var(--contact)", "var(--wrong)", "var(--soft)"] },
    marks: [
      Plot.dot(rows, { x: "x", y: "y", symbol: "kind", stroke: "kind", fill: "var(--card)", strokeWidth: 2, r: 6, className: "point" }),
      Plot.text(placed, { x: "x", y: "y", text: width > 600 ? "name" : (r) => r.name.split("/")[0], dx: 10, textAnchor: "start", fill: "var(--ink)", stroke: "var(--ground)", strokeWidth: 3 }),
    ],
  });
  return h("section", { id: "price" }, figure({ title: "Accuracy and time", make, points,
    caption: "Lower is more accurate, left is faster. The worst of the cases that an oracle measured, over all families; the median time over those that were timed." }));
}

// Methods by families: how near to its limit each comes.
function heat(data, open) {
  const tables = Object.entries(kKinds).map(([kind, title]) => {
    const methods = data.methods.map((m, i) => ({ m, i })).filter(({ m }) => m.kind === kind);
    const families = data.families.map((f, i) => ({ f, i })).filter(({ i }) => data.cells.some((c) => c.family === i && methods.some((m) => m.i === c.method)));
    if (methods.length === 0 || families.length === 0) return "";
    const byPlace = new Map(data.cells.map((c) => [`${c.method} ${c.family}`, c]));
    const cell = (m, i, f, j) => {
      const c = byPlace.get(`${i} ${j}`);
      if (!c) return h("td", { class: "none" }, "");
      const x = number(c.over_limit), bad = faulty(c);
      const level = bad > 0 ? "fault" : x === null ? "unknown" : x > 1 ? "beyond" : x === 0 ? "l0" : `l${Math.max(1, Math.min(6, Math.ceil(6 + Math.log10(x) * 1.2)))}`;
      const words = `${m.name} on ${f.name}: ${plural(c.cases, "case")}, ${plural(bad, "fault")}, worst error ${ofLimit(c.over_limit)} of its limit${c.stalled ? `, ${plural(c.stalled, "stall")}` : ""}`;
      const shown = bad > 0 ? `${bad} ✗` : x === null ? "·" : x === 0 ? "0" : x >= 1000 ? short(x, 1) : x >= 0.01 ? String(Number(x.toPrecision(2))) : short(x, 1);
      return h("td", { class: level }, c.worst ? h("button", { type: "button", title: words, "aria-label": words, onclick: () => open(c.worst, m.name) }, shown)
        : h("span", { title: words }, shown));
    };
    return h("div", {}, h("h3", {}, title), wide(title, h("table", { class: "heat" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "family"), methods.map(({ m }) => h("th", { scope: "col" },
        ...m.name.replace(/^rotating /, "").split(/[ /]/).flatMap((part) => [part, h("br")]))))),
      h("tbody", {}, families.map(({ f, i: j }) => h("tr", {}, h("th", { scope: "row", title: f.sentence || f.name }, f.name.replaceAll("_", " ")), methods.map(({ m, i }) => cell(m, i, f, j))))))));
  });
  return h("section", { id: "families" }, h("h2", {}, "By family"),
    h("p", {}, "The worst error of each method on each family, over the limit that its guarantee grants it: 1 is the limit. The stronger the colour, the nearer; red is a fault. Framed is an error beyond the limit that is let pass: the answer says so itself, or the question hangs on less than the limit. Press a number to look at its case."), tables);
}

// What is named beside faults.
const harmless = ["worst", "stalled", "most supports"];

function worstCases(data, open) {
  const kMost = 24;
  const seen = new Set();
  const all = data.named.filter((one) => !seen.has(one.id + one.method) && seen.add(one.id + one.method));
  const faults = all.filter((one) => !harmless.includes(one.what));
  const rows = all.slice(0, Math.max(kMost, Math.min(faults.length, 60))).map((one) => {
    const m = data.methods[one.method];
    const bad = !harmless.includes(one.what);
    return h("tr", { class: bad ? "wrong" : "" }, h("td", {}, h("button", { type: "button", class: `open ${data.scenes[one.id] ? "held" : ""}`, "data-case": one.id, onclick: () => open(one.id, m.name) }, one.id)),
      h("td", {}, m.name), h("td", {}, bad ? h("strong", { class: "bad" }, one.what) : one.what === "worst" ? "within its limit" : one.what),
      h("td", { class: "number" }, ofLimit(one.over_limit)), faults.length > 0 && h("td", { class: "why" }, one.why || "–"));
  });
  return h("section", { id: "worst" }, h("h2", {}, "Worst cases"),
    h("p", {}, faults.length > 0 ? "Faults first; then, of each method, the case whose error is the largest part of its limit and the one that took the most support evaluations."
      : "Nothing is at fault. For each method, these are the case whose error is the largest part of its limit, the one that took the most support evaluations, and those that did not converge."),
    wide("Worst cases", h("table", {}, h("thead", {}, h("tr", {}, ["case", "method", "", "of its limit", faults.length > 0 && "why"].filter((name) => name !== false).map((name) => h("th", { scope: "col" }, name)))), h("tbody", {}, rows))));
}

function findings(data, open) {
  return h("section", { id: "findings" }, h("h2", {}, "Findings"), h("p", {}, "One case for each engine and kind of fault, shrunk as far as the fault remains."),
    wide("Findings", h("table", {}, h("thead", {}, h("tr", {}, ["engine", "fault", "met in", "times", "case", "why"].map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, data.findings.map((one) => h("tr", {}, h("th", { scope: "row" }, one.method), h("td", {}, one.fault), h("td", {}, one.family), h("td", { class: "number" }, count(one.times)),
        h("td", {}, h("button", { type: "button", class: "open held", onclick: () => open(one.id, one.method) }, one.id)), h("td", { class: "why" }, one.reason)))))));
}

function glossary() {
  const words = [["backward error", "of a time: how far the path is from contact at that time, or how deep it has gone before it; the least change of the shapes that would make the time right"],
    ["scale", "the largest of the two bodies' diagonals and the distance of their middles; errors are given over it"],
    ["limit", "the error that a method's guarantee grants it, by the table of guarantees"],
    ["wrong", "the verdict (contact or none) is wrong by more than the limit"], ["late", "the time handed to a simulator is past the contact by more than the limit"],
    ["stall", "the method gives up and says so; how often it may is part of its guarantee"]];
  return h("section", { id: "words" }, h("h2", {}, "Words"), h("dl", {}, words.map(([word, means]) => [h("dt", {}, word), h("dd", {}, means)])));
}
