// A case in a dialog over the page: made when it is opened, gone when it is closed.
import { block, h } from "./dom.js";
import { sceneView } from "./scene.js";

// How a case that the page does not hold is shown: a generated one by its id.
function commandFor(id, method) {
  const drawn = /^(.+)\/h([-\d.e+]+)\/s(\d+)/.exec(id);
  const ask = method ? ` --method '${method}'` : "";
  return drawn ? `graze generate ${drawn[1]} --hardness ${drawn[2]} --seed ${drawn[3]} --count 1 | graze show -${ask} --out case.html`
    : `graze show corpus/cases/*.json* --id ${id}${ask} --out case.html`;
}

export function caseOpener(scenes) {
  return (id, method) => {
    const scene = scenes?.[id];
    const view = scene ? sceneView(scene) : { element: h("div", {}, h("h2", {}, id),
      h("p", {}, "This page holds only the worst cases. This one is shown by"), block(commandFor(id, method), "command")), dispose() {} };
    const before = document.activeElement;
    const dialog = h("dialog", { class: "case", "aria-label": `case ${id}`, onclose: () => {
      view.dispose();
      dialog.remove();
      if (location.hash === `#${encodeURIComponent(id)}`) history.replaceState(null, "", location.pathname + location.search);
      before?.focus?.({ preventScroll: true });
    } }, h("form", { method: "dialog", class: "close" }, h("button", { class: "tool", "aria-label": "close" }, "Close")), view.element);
    document.body.append(dialog);
    dialog.showModal();
    history.replaceState(null, "", `#${encodeURIComponent(id)}`);
  };
}
