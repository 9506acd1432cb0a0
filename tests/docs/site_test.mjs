// The site in a real browser, opened from a disk: `node site_test.mjs CHROMIUM FOLDER`. Every failed check is a line.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "../reports/viewer/browser.mjs";

const [program, folder] = process.argv.slice(2);
const address = (name) => pathToFileURL(resolve(folder, name)).href;
let failures = 0, checks = 0;
function check(right, what) {
  ++checks;
  if (right) return;
  ++failures;
  console.log(`FAILED: ${what}`);
}
const until = (page, condition) =>
  page.value(`(async () => { for (let i = 0; i < 300 && !(${condition}); ++i) await new Promise((done) => setTimeout(done, 100)); return Boolean(${condition}); })()`);

// A page asks nothing of a network, writes nothing on the console, and fits the screen.
async function checkPage(browser, name, screen) {
  const page = await browser.open(address(name), screen);
  const asked = page.requests.filter((request) => !/^(file|data|blob|about):/.test(request));
  check(asked.length === 0, `${name}: asks the network for ${asked.join(", ")}`);
  const complaints = page.complaints.filter((words) => !/GPU stall due to ReadPixels/.test(words));
  check(complaints.length === 0, `${name}: complains: ${complaints.join(" | ")}`);
  const [wide, screenWidth] = await page.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
  check(wide <= screenWidth, `${name}: is ${wide} pixels wide on a screen of ${screenWidth}`);
  return page;
}

const scheme = (page) => page.value(`document.body.getAttribute("data-md-color-scheme")`);
const pages = ["index.html", "tutorials/cast.html", "reference/api.html", "reports/costs.html", "api/cast_8hpp.html", "live/index.html"];

for (const dark of [false, true]) {
  // A browser of its own for each: a site remembers the colours that it was first seen in.
  const browser = await Browser.start(program);
  try {
    for (const screen of [{ width: 1280, height: 900, dark }, { width: 390, height: 844, phone: true, dark }]) {
      for (const name of pages) {
        const page = await checkPage(browser, name, screen);
        if (!name.startsWith("api/")) check((await scheme(page)) === (dark ? "slate" : "default"), `${name}: is ${await scheme(page)} where the system is ${dark ? "dark" : "light"}`);
      }
    }
    if (dark) continue;

    const home = await browser.open(address("index.html"));
    await home.value(`document.querySelector('.md-header__option label:not([hidden])').click()`);
    check(await until(home, `document.body.getAttribute("data-md-color-scheme") === "slate"`), "the button for the dark does nothing");

    // Search, from a disk: words that stand on one page lead to it.
    await home.value(`document.querySelector("[data-md-component=search-query]").focus()`);
    await home.send("Input.insertText", { text: "certified bracket" });
    await home.key("Shift", { keyCode: 16 });
    check(await until(home, `document.querySelectorAll(".md-search-result__link").length > 2`), "search finds nothing");
    const links = await home.value(`[...document.querySelectorAll(".md-search-result__link")].map((link) => link.href)`);
    check(links.some((link) => link.includes("explanation/certified.html")), `search leads to ${links.join(", ")}`);

    // The live pages draw.
    const live = await browser.open(address("live/index.html"));
    const frames = await live.value(`[...document.querySelectorAll("iframe[src]")].map((frame) => frame.getAttribute("src"))`);
    check(frames.length === 3, `the live page has ${frames.length} frames`);
    for (const frame of frames) {
      const shown = await browser.open(address(`live/${frame}`));
      check(await until(shown, `document.querySelector("main canvas, main svg")`), `live/${frame}: draws nothing`);
    }
  } finally {
    await browser.stop();
  }
}
console.log(failures === 0 ? `${checks} checks passed` : `${failures} of ${checks} checks failed`);
process.exit(failures === 0 ? 0 : 1);
