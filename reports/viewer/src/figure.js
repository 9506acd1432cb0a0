// Figures by Observable Plot, whose points can be pointed at, reached by the keyboard, and pressed.
import * as Plot from "@observablehq/plot";
import { h, power } from "./dom.js";

export { Plot };

const kFont = "system-ui, 'DejaVu Sans', sans-serif";

// 10⁻⁷ at whole powers, nothing between them.
export function powerTick(x) {
  const exponent = Math.log10(x);
  return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? power(Math.round(exponent)) : "";
}
// Whole powers over a range, thinned to about eight.
export function powers(values) {
  const logs = values.filter((x) => x > 0 && Number.isFinite(x)).map(Math.log10);
  if (logs.length === 0) return [];
  const low = Math.floor(Math.min(...logs)), high = Math.ceil(Math.max(...logs));
  const step = Math.max(1, Math.ceil((high - low) / 8));
  const out = [];
  for (let e = low; e <= high; e += step) out.push(10 ** e);
  return out;
}

// `make(width)`: a plot of that width. `points`: what the marks of the class "point" stand for, in order: {label, act}.
// It is drawn again when its width changes.
export function figure({ title, caption, make, points = [], table }) {
  const holder = h("div", { class: "plot" });
  const note = h("p", { class: "pointed", "aria-live": "polite" }, points.length ? "Point at a mark, or reach it by Tab." : "");
  const element = h("figure", { class: "figure" }, h("h3", {}, title), holder, note, caption && h("figcaption", {}, caption),
    table && h("details", {}, h("summary", {}, "The numbers"), table));
  let drawn = 0;
  const draw = () => {
    const width = Math.max(280, Math.min(holder.clientWidth, 1100));
    if (!holder.clientWidth || Math.abs(width - drawn) < 8) return;
    drawn = width;
    const plot = make(width);
    plot.style.fontFamily = kFont;
    holder.replaceChildren(plot);
    const marks = [...plot.querySelectorAll("g.point > *")];
    marks.forEach((mark, i) => {
      const datum = mark.__data__ ?? i; // of Plot: the index of what was drawn
      const point = points[datum];
      if (!point) return;
      mark.setAttribute("tabindex", "0");
      mark.setAttribute("role", point.act ? "button" : "img");
      mark.setAttribute("aria-label", point.label);
      const tell = () => (note.textContent = point.label);
      mark.addEventListener("pointerenter", tell);
      mark.addEventListener("focus", tell);
      if (!point.act) return;
      mark.classList.add("pressed");
      mark.addEventListener("click", point.act);
      mark.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        point.act();
      });
    });
  };
  new ResizeObserver(draw).observe(holder);
  return element;
}
