// Elements, numbers as text, and numbers to copy.

// h("p", {class: "x", onclick: f}, "words", child, …)
export function h(tag, attributes = {}, ...children) {
  const svg = tag.startsWith("svg:");
  const element = svg
    ? document.createElementNS("http://www.w3.org/2000/svg", tag.slice(4))
    : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat(Infinity)) {
    if (child === undefined || child === null || child === false) continue;
    element.append(child);
  }
  return element;
}

const kSuperscripts = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
export const power = (exponent) => "10" + [...String(exponent)].map((c) => kSuperscripts[c]).join("");

// 3.2·10⁻⁷; plain from 0.001 to 9999.
export function short(x, digits = 2) {
  if (x === null || x === undefined || Number.isNaN(x)) return "–";
  if (x === "inf" || x === Infinity) return "∞";
  if (x === "-inf" || x === -Infinity) return "−∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 0.001 && size < 10000) return String(Number(x.toPrecision(digits + 1))).replace("-", "−");
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  return `${mantissa.replace("-", "−")}·${power(Number(exponent))}`;
}

// All digits, as they are read back.
export function full(x) {
  if (x === null || x === undefined) return "–";
  if (Array.isArray(x)) return `[${x.map(full).join(", ")}]`;
  return typeof x === "number" ? String(x) : x;
}

// A time in nanoseconds.
export function nanoseconds(ns) {
  if (ns === null || ns === undefined) return "–";
  if (ns < 1000) return `${Math.round(ns)} ns`;
  if (ns < 1e6) return `${Number((ns / 1e3).toPrecision(3))} µs`;
  return `${Number((ns / 1e6).toPrecision(3))} ms`;
}

export const count = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, " ");
export const plural = (n, one, many = one + "s") => `${count(n)} ${n === 1 ? one : many}`;

const status = h("div", { class: "status", role: "status", "aria-live": "polite" });
let hiding = 0;
export function say(words) {
  if (!status.isConnected) document.body.append(status);
  status.textContent = words;
  status.classList.add("shown");
  clearTimeout(hiding);
  hiding = setTimeout(() => status.classList.remove("shown"), 1800);
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // A page that is opened from a file may have no clipboard but the old way.
    const area = h("textarea", { class: "offscreen" });
    area.value = text;
    (document.querySelector("dialog[open]") ?? document.body).append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  say("copied");
}

// Words that are copied where they are pressed.
export function copyable(shown, text = shown) {
  return h("button", { class: "copy", type: "button", title: `copy ${text}`, onclick: () => copy(text) }, shown);
}

// A block of text with a button that copies it.
export function block(text, label) {
  return h("div", { class: "block" }, h("pre", { tabindex: 0, "aria-label": label }, text),
    h("button", { class: "tool", type: "button", onclick: () => copy(text) }, "Copy"));
}
