// The page: what its data says it is. graze.page/1: {"kind": "show", "play", "certify" or "price", "title", "scenes": […], …}.
import { h } from "./dom.js";
import { sceneView } from "./scene.js";
import { playView } from "./play.js";
import { reportPage } from "./report.js";

// One of what there is to see, or of several the one that is chosen from a list.
function showPage(page, data, viewOf) {
  const holder = h("div", { class: "holder" });
  let open = null;
  const show = (scene) => {
    open?.dispose();
    open = viewOf(scene, data.scenes.length > 1 ? "h2" : "h1");
    holder.replaceChildren(open.element);
  };
  if (data.scenes.length > 1) {
    page.append(h("h1", {}, data.title));
    const choose = h("select", { "aria-label": data.kind === "play" ? "scene" : "case", onchange: () => show(data.scenes[Number(choose.value)]) },
      data.scenes.map((scene, i) => h("option", { value: i },
        `${scene.id}${scene.broken ? `: ${scene.broken.law} is broken` : scene.answers?.some((answer) => answer.fault) ? ": an answer is at fault" : ""}`)));
    const step = (by) => () => {
      choose.value = String((Number(choose.value) + by + data.scenes.length) % data.scenes.length);
      show(data.scenes[Number(choose.value)]);
    };
    page.append(h("nav", { class: "choose" }, h("button", { type: "button", class: "tool", onclick: step(-1) }, "Previous"), choose,
      h("button", { type: "button", class: "tool", onclick: step(1) }, "Next")));
  }
  page.append(holder);
  if (data.scenes.length === 0) page.append(h("h1", {}, data.title));
  else show(data.scenes[0]);
}

const data = JSON.parse(document.getElementById("data").textContent);
const page = document.getElementById("page");
if (data.kind === "show") showPage(page, data, sceneView);
else if (data.kind === "play") showPage(page, data, playView);
else reportPage(page, data);
page.append(h("footer", { class: "small" }, h("details", {}, h("summary", {}, "Licences of what draws this page"),
  h("pre", { class: "licences", tabindex: 0 }, document.getElementById("licences").textContent))));
