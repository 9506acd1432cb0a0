// Pictures of a page at two widths, light and dark: `node screenshots.mjs CHROMIUM PAGE.html OUT-PREFIX [SCRIPT]`, where
// SCRIPT is run in the page before each, to open or scroll to what is wanted.
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, file, prefix, script] = process.argv.slice(2);
const browser = await Browser.start(program);
try {
  for (const [name, width, height, phone] of [["wide", 1280, 900, false], ["phone", 390, 844, true]]) {
    for (const dark of [false, true]) {
      const page = await browser.open(pathToFileURL(resolve(file)).href, { width, height, dark, phone });
      if (script) {
        await page.value(script);
        await page.settle();
      }
      writeFileSync(`${prefix}-${name}-${dark ? "dark" : "light"}.png`, await page.picture({ whole: !script }));
      for (const complaint of page.complaints) console.log(complaint);
    }
  }
} finally {
  await browser.stop();
}
