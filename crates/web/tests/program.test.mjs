// The page as `rough-contact app` serves it, in headless Chromium: computed by the program, number by number as the
// command, cancelled, and left alone. $PICTURES is a folder for pictures of it.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Browser } from './browser.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const command = resolve(process.env.ROUGH_CONTACT || join(root, 'target/debug/rough-contact'));
const folder = mkdtempSync(join(tmpdir(), 'rough-contact-app-'));
const at = name => join(folder, name);
const rough = (...args) => execFileSync(command, [...args, '--quiet', '--threads', '1'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
let browser = null, program = null, address = null, terminal = '';

before(async () => {
  rough('synth', '--shape', '96,128', '--pixel', '1um', '--hurst', '0.8', '--rolloff', '30um', '--cutoff', '5um', '--rms-gradient', '0.1', '--seed', '7', '--out', 'map.x3p');
  writeFileSync(at('short.x3p'), readFileSync(at('map.x3p')).subarray(0, 3000));
  program = spawn(command, ['app', '--no-open', '--threads', '1'], { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
  program.stderr.on('data', text => { terminal += text; });
  address = await new Promise(settle => program.stdout.once('data', text => settle(String(text).trim())));
  assert.match(address, /^http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/$/);
  browser = new Browser();
});
after(async () => {
  program.kill();
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

async function opened(look) {
  const page = await browser.open(address, look);
  await page.until("document.documentElement.dataset.ready === 'true'");
  return page;
}

const planned = page => page.until("!$('compute-now').disabled && $('est-loads').textContent");
async function picture(page, name) {
  if (process.env.PICTURES) writeFileSync(join(process.env.PICTURES, `${name}.png`), await page.picture());
}
// Everything but what a clock makes different.
const timeless = object => JSON.parse(JSON.stringify(object), (key, value) => /seconds|speed/.test(key) ? undefined : value);

// No fault, and nobody asked but the program.
async function clean(page) {
  assert.deepEqual(page.faults, []);
  const others = page.requests.filter(url => !url.startsWith(address) && !url.startsWith('blob:') && !url.startsWith('data:') && url !== 'about:srcdoc');
  assert.deepEqual(others, []);
  await browser.call('Target.closeTarget', { targetId: page.target });
}

test('a measurement is computed by the program and gives every number of the command', async () => {
  const page = await opened();
  assert.match(await page.text('#s-empty'), /read by the program that opened this page.*16384 × 16384 points and a file of 4 GB/);
  await picture(page, 'app-empty');
  await page.choose(at('map.x3p'));
  await page.state('read');
  await planned(page);
  await picture(page, 'app-read');
  await page.click('#compute-now');
  await page.state('result');
  await page.until("parseFloat($('report').style.height) > 2000");
  await picture(page, 'app-result');
  const steel = ['--young', '210GPa', '--poisson', '0.3', '--young', '210GPa', '--poisson', '0.3'];
  rough('compare', 'map.x3p', ...steel, '--outliers', '8', '--fill', 'harmonic', '--out', 'x3p');
  const files = await page.value('({ ...now.answer.files })');
  const of = text => timeless(JSON.parse(text).surfaces);
  assert.deepEqual(of(files['results.json']), of(readFileSync(at('x3p/results.json'), 'utf8')));
  assert.equal(files['curves.csv'].split('\n').length, readFileSync(at('x3p/curves.csv'), 'utf8').split('\n').length);
  await clean(page);
});

test('a damaged file is refused in words, and another site cannot ask', async () => {
  const page = await opened();
  await page.choose(at('short.x3p'));
  await page.state('error');
  assert.match(await page.text('#e-detail'), /^malformed|^unknown/i);
  await clean(page);
  // A page of another origin: one that is served from nowhere.
  const other = await browser.open('about:blank');
  await other.until('true');
  const asked = await other.value(`fetch('${address}ask/start', {method: 'POST', body: '{}\\n'}).then(() => 'answered', () => 'refused')`);
  assert.equal(asked, 'refused');
  const read = await other.value(`fetch('${address}').then(() => 'read', () => 'refused')`);
  assert.equal(read, 'refused');
  await browser.call('Target.closeTarget', { targetId: other.target });
});

test('cancel stops the program, which answers the next question; stop keeps what is done', async () => {
  const page = await opened();
  await page.click('[data-example=ground]');
  await page.state('bodies');
  await page.until("$('est-loads').textContent.startsWith('15 loads')");
  await page.click('#compute');
  await page.state('running');
  await page.until('run.done.length >= 1');
  await picture(page, 'app-running');
  terminal = '';
  await page.click('#cancel');
  await page.state('bodies');
  for (let i = 0; i < 600 && !terminal.includes('stopped after'); i++) await new Promise(done => setTimeout(done, 50));
  assert.match(terminal, /stopped after/);
  assert.doesNotMatch(terminal, /computed in/);
  await page.until("$('est-loads').textContent.startsWith('15 loads')");
  await page.click('#compute');
  await page.until('run && run.done.length >= 2', 300);
  await page.click('#stop');
  await page.state('result', 300);
  assert.match(await page.text('#result-note'), /^Stopped after \d+ of 15 loads/);
  await clean(page);
});

test('a program that was ended is said to be, on a phone too', async () => {
  const page = await opened({ width: 420, height: 800, dark: true });
  await page.choose(at('map.x3p'));
  await page.state('read');
  await planned(page);
  assert.ok(await page.value('document.documentElement.scrollWidth <= document.documentElement.clientWidth'));
  program.kill();
  await new Promise(done => program.on('exit', done));
  await page.click('[data-key=spikes], [data-key=fill], #compute-now');
  await page.state('error');
  assert.equal(await page.text('#h-error'), 'The program does not answer.');
  await picture(page, 'app-ended');
});
