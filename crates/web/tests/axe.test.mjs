// The page and a report as a screen reader and a keyboard meet them: the rules of axe-core (npm; its one file in $AXE, else this
// is left out), on a phone and on a desk.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const address = process.env.ADDRESS || pathToFileURL(process.env.PAGE || join(root, 'target/page/rough-contact.html')).href;
const axe = process.env.AXE && readFileSync(process.env.AXE, 'utf8');
const skip = axe ? false : 'AXE names no axe.min.js of axe-core';
let browser = null;
before(() => { browser = new Browser(); });
after(() => browser.close());

// What is wrong, each with the elements it is on.
async function found(page) {
  await page.value(`${axe}; 0`);
  const all = await page.value('axe.run(document, { iframes: false }).then(r => r.violations.map(v => [v.id, v.nodes.map(n => n.html.slice(0, 120))]))');
  return all;
}

async function clean(page, where) {
  assert.deepEqual(await found(page), [], where);
  assert.ok(await page.value('document.documentElement.scrollWidth <= document.documentElement.clientWidth'), `${where} is wider than the window`);
}

for (const width of [390, 1280]) {
  test(`steps and report at ${width} px`, { skip }, async () => {
    const page = await browser.open(address, { width, height: 900 });
    await page.until("document.documentElement.dataset.ready === 'true'");
    await clean(page, 'empty');
    await page.click('[data-example=polished]');
    await page.state('bodies');
    await page.until("$('est-loads').textContent");
    await page.value("document.querySelectorAll('details').forEach(d => { d.open = true; })");
    await clean(page, 'bodies');
    await page.click('[name=ld][value=pressure]');
    await page.type('#p1', '1MPa, 3MPa');
    await page.until("$('est-loads').textContent.startsWith('2 loads')");
    await page.click('#compute');
    await page.state('result', 600);
    await clean(page, 'result');
    const report = await page.value("now.answer.files['report.html']");
    const alone = await browser.open('about:blank', { width, height: 900 });
    // Without its policy, which keeps axe out.
    await alone.value(`document.write(${JSON.stringify(report.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>/, ''))}); document.close()`);
    await alone.until("document.readyState === 'complete'");
    await clean(alone, 'report');
  });
}
