// A page in a real browser: `node page_test.mjs CHROMIUM show|play|report|price|other PAGE.html`. Every check says what it saw.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, kind, file] = process.argv.slice(2);
const url = pathToFileURL(resolve(file)).href;
let failures = 0, checks = 0;
function check(right, what) {
  ++checks;
  if (right) return;
  ++failures;
  console.log(`FAILED: ${what}`);
}

// A software renderer says on the console that reading its pixels back is slow; nothing else is let pass.
const complaintsOf = (page) => page.complaints.filter((words) => !/GPU stall due to ReadPixels/.test(words));

// No request but for the page itself; what is in the page is asked for as data: or blob:.
function checkQuiet(page, name) {
  const asked = page.requests.filter((request) => request !== url && !/^(data|blob):/.test(request));
  check(asked.length === 0, `${name}: asks the network for ${asked.join(", ")}`);
  check(complaintsOf(page).length === 0, `${name}: complains: ${complaintsOf(page).join(" | ")}`);
}

// Nothing sticks out to the side: what is wide scrolls by itself.
async function checkWidth(page, name) {
  const [scroll, client] = await page.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
  check(scroll <= client, `${name}: is ${scroll} pixels wide on a screen of ${client}`);
}

// What a condition in the page's code left between its parts: a number or a word without an element of its own.
async function checkLeftovers(page, name) {
  const left = await page.value(`[...document.querySelectorAll("main, section, header, nav")].flatMap((part) => [...part.childNodes])
    .filter((node) => node.nodeType === Node.TEXT_NODE && /^(0|false|null|undefined|NaN)$/.test(node.data.trim())).map((node) => node.data)`);
  check(left.length === 0, `${name}: shows ${left.join(", ")} beside its parts`);
}

// How many pixels of a stage are drawn, and a number that changes with what they show.
const canvasDigest = (stage, root) => `(() => {
  const canvas = ${root}.querySelector('[data-stage="${stage}"] canvas');
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
  let drawn = 0, sum = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] > 0) ++drawn;
    sum = (sum * 31 + pixels[i] + 7 * pixels[i + 1] + 13 * pixels[i + 3]) % 1000000007;
  }
  return [drawn, sum, canvas.width * canvas.height];
})()`;

// Both stages show bodies; the slider, the mouse and the keys move what they should.
async function checkScene(page, name, root = "document") {
  for (const stage of ["bodies", "cso"]) {
    const [drawn, , all] = await page.value(canvasDigest(stage, root));
    check(drawn > all / 500, `${name}: ${stage} shows ${drawn} pixels of ${all}`);
  }
  const drawn = async (stage = "bodies") => (await page.value(canvasDigest(stage, root)))[1];
  const before = await drawn(), cso = await drawn("cso");
  const slider = `${root}.querySelector('input[type="range"]')`;
  await page.value(`${slider}.focus()`);
  await page.key("Home", { keyCode: 36 });
  await page.settle();
  check((await page.value(`${slider}.value`)) === "0", `${name}: the slider stays at ${await page.value(`${slider}.value`)} when Home is pressed`);
  check((await page.value(`${root}.querySelector(".clock").textContent`)) === "t = 0", `${name}: the clock does not say t = 0`);
  const moved = await drawn();
  check(moved !== before, `${name}: the slider moves no body`);
  check((await drawn("cso")) === cso, `${name}: the slider changes the difference`);
  await page.value(`[...${root}.querySelectorAll("[data-time]")].at(-1).click()`);
  await page.settle();
  check((await drawn()) !== moved, `${name}: a mark of time moves no body`);
  // By the keys, then by the mouse.
  await page.value(`${root}.querySelector('[data-stage="bodies"]').focus()`);
  const standing = await drawn();
  await page.key("ArrowLeft", { keyCode: 37 });
  await page.settle();
  const turned = await drawn();
  check(turned !== standing, `${name}: an arrow key does not turn the view`);
  const { x, y, width, height } = await page.value(`(() => { const r = ${root}.querySelector('[data-stage="bodies"]').getBoundingClientRect(); return { x: r.x, y: r.y, width: r.width, height: r.height }; })()`);
  await page.mouse("mousePressed", x + width / 2, y + height / 2);
  await page.mouse("mouseMoved", x + width / 2 + 60, y + height / 2 + 20, { buttons: 1 });
  await page.mouse("mouseReleased", x + width / 2 + 60, y + height / 2 + 20);
  await page.settle();
  check((await drawn()) !== turned, `${name}: the mouse does not turn the view`);
  const plain = await drawn();
  await page.value(`${root}.querySelector('.toggle input').click()`);
  await page.settle();
  check((await drawn()) !== plain, `${name}: seen through, the bodies look the same`);
}

// A scene plays: the slider, the marks of events, the list of them and the button move what they should.
async function checkPlay(page, name) {
  const drawn = async () => (await page.value(canvasDigest("bodies", "document")))[1];
  const clock = () => page.value(`document.querySelector(".clock").textContent`);
  const [seen, , all] = await page.value(canvasDigest("bodies", "document"));
  check(seen > all / 500, `${name}: the stage shows ${seen} pixels of ${all}`);
  const start = await drawn();
  check((await clock()) === "t = 0", `${name}: it begins at ${await clock()}`);
  await page.value(`document.querySelector('input[type="range"]').focus()`);
  await page.key("End", { keyCode: 35 });
  await page.settle();
  check((await drawn()) !== start, `${name}: the slider moves no body`);
  await page.key("Home", { keyCode: 36 });
  await page.settle();
  check((await drawn()) === start, `${name}: back at the start, the bodies are elsewhere`);
  const marks = await page.value(`document.querySelectorAll(".strip i").length`);
  const events = await page.value(`JSON.parse(document.getElementById("data").textContent).scenes[0].events`);
  check(marks === events.length && marks > 0, `${name}: ${marks} marks for ${events.length} events`);
  // An event whose mark has no other near it, pressed by the mouse.
  const lone = await page.value(`(() => {
    const marks = [...document.querySelectorAll(".strip i")].map((mark) => { const r = mark.getBoundingClientRect(); return { x: r.x + r.width / 2, y: r.y + r.height / 2, event: mark.dataset.event }; });
    return marks.find((one) => marks.every((other) => other === one || Math.abs(other.x - one.x) > 3));
  })()`);
  check(Boolean(lone), `${name}: every mark has another beside it`);
  if (!lone) return;
  await page.mouse("mousePressed", lone.x, lone.y);
  await page.mouse("mouseReleased", lone.x, lone.y);
  await page.settle();
  const chosen = events[Number(lone.event)], about = () => page.value(`document.querySelector(".about")?.textContent`);
  check((await about()).includes(chosen.a) && (await about()).includes(chosen.b), `${name}: the mark of ${chosen.a} and ${chosen.b} shows ${await about()}`);
  check((await about()).includes(String(chosen.toi.lower)), `${name}: the time of the event is not said`);
  check(Number((await clock()).slice(4)) === Number(chosen.toi.lower.toPrecision(6)), `${name}: the clock says ${await clock()} at ${chosen.toi.lower}`);
  check(await page.value(`Boolean(document.querySelector(".over path.contact")) && document.querySelectorAll(".over circle.touch").length === 2`), `${name}: no normal, or no witnesses, at the event`);
  check((await drawn()) !== start, `${name}: the pair of an event looks like all`);
  // The case to copy is that pair.
  const copied = await page.value(`JSON.parse(document.querySelector(".about pre").textContent)`);
  check(copied.schema === "graze.case/1" && copied.a.shape && copied.b.shape, `${name}: the case of an event is ${JSON.stringify(copied).slice(0, 80)}`);
  // By the keys, from the list.
  await page.value(`document.querySelector('[role="listbox"]').focus()`);
  await page.key("ArrowDown", { keyCode: 40 });
  await page.settle();
  const next = await page.value(`[...document.querySelectorAll('[role="option"]')].findIndex((line) => line.getAttribute("aria-selected") === "true")`);
  check(next === Number(lone.event) + 1, `${name}: after event ${lone.event} ArrowDown takes ${next}`);
  await page.key("End", { keyCode: 35 });
  await page.settle();
  check(await page.value(`(() => { const line = document.querySelector('[aria-selected="true"]').getBoundingClientRect(), list = document.querySelector('[role="listbox"]').getBoundingClientRect(); return line.top >= list.top - 1 && line.bottom <= list.bottom + 1; })()`), `${name}: the chosen line is out of sight`);
  await page.value(`[...document.querySelectorAll(".marks button")].find((one) => one.textContent === "All bodies").click()`);
  await page.value(`document.querySelector('input[type="range"]').focus()`);
  await page.key("Home", { keyCode: 36 });
  await page.value(`document.querySelector(".slide button").click()`);
  // A busy machine draws few frames: until the first that moves.
  let running = await clock();
  for (let i = 0; i < 40 && running === "t = 0"; ++i) {
    await new Promise((done) => setTimeout(done, 200));
    running = await clock();
  }
  await page.value(`document.querySelector(".slide button").click()`);
  check(running !== "t = 0" && (await page.value(`document.querySelector(".slide button").textContent`)) === "Play", `${name}: Play does not play`);
  check(/\d+ of \d+ pairs were simulated/.test(await page.value(`document.querySelector(".spared").textContent`)), `${name}: what was spared is not said`);
}

// Tab reaches everything that can be used, and shows where it is.
async function checkKeyboard(page, name, root = "document") {
  const usable = `[...${root}.querySelectorAll('button, input, select, summary, a[href], [tabindex="0"]')].filter((e) => e.checkVisibility() && !e.disabled && e.tabIndex >= 0)`;
  const groups = `new Set(${usable}.filter((e) => e.type === "radio").map((e) => e.name)).size`;
  const wanted = await page.value(`${usable}.filter((e) => e.type !== "radio").length + ${groups}`);
  await page.value(`(window.reached = new Set(), window.unseen = [], document.activeElement?.blur?.())`);
  let last = 0;
  for (let i = 0; i < wanted + 40; ++i) {
    await page.tab();
    last = await page.value(`(() => {
      const e = document.activeElement;
      if (${root} !== document && !${root}.contains(e)) return window.reached.size;
      if (e && e !== document.body && !window.reached.has(e)) {
        window.reached.add(e);
        const s = getComputedStyle(e);
        const plain = s.outlineStyle === "none" || parseFloat(s.outlineWidth) === 0;
        if (plain && !e.closest(".point")) window.unseen.push(e.outerHTML.slice(0, 80));
      }
      return window.reached.size;
    })()`);
    if (last >= wanted) break;
  }
  check(last >= wanted, `${name}: Tab reaches ${last} of ${wanted} things`);
  const unseen = await page.value("window.unseen");
  check(unseen.length === 0, `${name}: focus cannot be seen on ${unseen.slice(0, 3).join(", ")}`);
}

// Whatever is pressed has a name.
async function checkNames(page, name) {
  const nameless = await page.value(`[...document.querySelectorAll('button, input, select, [role="button"], [role="application"]')]
    .filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.title || e.closest("label")?.textContent.trim())).length`);
  check(nameless === 0, `${name}: ${nameless} things to press have no name`);
}

const browser = await Browser.start(program);
try {
  for (const [screen, width, height, phone] of [["wide", 1280, 900, false], ["phone", 390, 844, true]]) {
    for (const dark of [false, true]) {
      const name = `${screen}, ${dark ? "dark" : "light"}`;
      const page = await browser.open(url, { width, height, dark, phone });
      await checkWidth(page, name);
      await checkNames(page, name);
      await checkLeftovers(page, name);
      const first = screen === "wide" && !dark;
      if (kind === "show" && (first || (phone && dark))) await checkScene(page, name);
      if (kind === "play" && (first || (phone && dark))) await checkPlay(page, name);
      if ((kind === "show" || kind === "play") && first) await checkKeyboard(page, name);
      if (kind === "report" && first) {
        check((await page.value(`document.querySelector("h1").textContent.length`)) > 0, `${name}: there is no verdict`);
        check((await page.value(`document.querySelector("main > :first-child").matches(".verdict")`)), `${name}: the verdict is not first`);
        const marks = await page.value(`document.querySelectorAll(".point > [tabindex]").length`);
        check(marks > 0, `${name}: no mark of a figure can be pointed at`);
        await page.value(`document.querySelector(".point > [tabindex]").dispatchEvent(new PointerEvent("pointerenter"))`);
        check(/ns|µs|ms/.test(await page.value(`document.querySelector(".pointed").textContent`)), `${name}: a mark says nothing when it is pointed at`);
        await checkKeyboard(page, name);
        // The worst case, by the keyboard.
        await page.value(`document.querySelector("#worst button.held").focus()`);
        const wanted = await page.value(`document.activeElement.dataset.case`);
        await page.key("Enter", { keyCode: 13, text: "\r" });
        await page.settle();
        check(await page.value(`document.querySelector("dialog[open] h2")?.textContent === ${JSON.stringify(wanted)}`), `${name}: Enter does not open ${wanted}`);
        await checkScene(page, `${name}, ${wanted}`, `document.querySelector("dialog")`);
        await page.key("Escape", { keyCode: 27 });
        await page.settle();
        check(await page.value(`document.querySelector("dialog") === null`), `${name}: Escape does not close the case`);
        check(await page.value(`document.activeElement.dataset.case === ${JSON.stringify(wanted)}`), `${name}: focus does not come back to the case`);
        // One that the page does not hold is said to be shown by a command.
        const other = await page.value(`(() => { const b = document.querySelector(".heat button"); b?.click(); return Boolean(b); })()`);
        check(!other || (await page.value(`Boolean(document.querySelector("dialog[open]"))`)), `${name}: a cell of the table opens nothing`);
      }
      if (kind === "price" && first) {
        const users = await page.value(`[...document.querySelectorAll("#advice .user")].map((user) => user.textContent)`);
        check(users.length === 2 && /^For a game[^]*mpr\/float[^]*1 of 72 verdicts wrong, 6·10⁻⁸ from a tie[^]*gjk\/double 0.001/.test(users[0]) && /^For a robot.*that rotate: none/.test(users[1]), `${name}: says to whom ${users.join(" | ")}`);
        check(await page.value(`document.querySelector("#advice").compareDocumentPosition(document.querySelector("#diagrams")) === Node.DOCUMENT_POSITION_FOLLOWING`), `${name}: which method to take does not come before the figures`);
        check(/^A table has (\d+ to )?\d+ cases/.test(await page.value(`document.querySelector("#sizes")?.textContent ?? ""`)), `${name}: the number of cases is not said`);
        const marks = await page.value(`document.querySelectorAll(".point > [tabindex]").length`);
        check(marks > 0, `${name}: no mark of a figure can be pointed at`);
        const before = await page.value(`document.querySelector("#diagrams svg").outerHTML.length`);
        await page.value(`document.querySelector('input[name="price-of"][value="worst"]').click()`);
        await page.settle();
        await page.settle();
        check((await page.value(`document.querySelector("#diagrams svg")?.outerHTML.length`)) > 0 && before > 0, `${name}: there is no diagram`);
        await page.value(`document.querySelector(".point > .pressed").dispatchEvent(new MouseEvent("click", { bubbles: true }))`);
        await page.settle();
        check(await page.value(`Boolean(document.querySelector("dialog[open]"))`), `${name}: a mark opens no case`);
      }
      checkQuiet(page, name);
    }
  }
} finally {
  await browser.stop();
}
console.log(failures === 0 ? `${checks} checks passed` : `${failures} of ${checks} checks failed`);
process.exit(failures === 0 ? 0 : 1);
