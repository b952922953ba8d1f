// The page as a person uses it, in headless Chromium: real formats, units that are missing, a hostile file, a
// cancellation; its numbers against those of the command. Arguments: folders with measured files to be solved as well.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { numbers, printed } from './compare.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const address = pathToFileURL(process.env.PAGE || join(root, 'target/page/rough-contact.html')).href;
const command = resolve(process.env.ROUGH_CONTACT || join(root, 'target/debug/rough-contact'));
const steel = ['--young', '210GPa', '--poisson', '0.3', '--young', '210GPa', '--poisson', '0.3'];
const folder = mkdtempSync(join(tmpdir(), 'rough-contact-page-'));
const at = name => join(folder, name);
const rough = (...args) => execFileSync(command, [...args, '--quiet', '--threads', '1'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
let browser = null;

before(() => {
  browser = new Browser();
  rough('synth', '--shape', '96,128', '--pixel', '1um', '--hurst', '0.8', '--rolloff', '30um', '--cutoff', '5um', '--rms-gradient', '0.1', '--seed', '7', '--out', 'map.x3p');
  rough('convert', 'map.x3p', '--out', 'map.npy');
  writeFileSync(at('holes.npy'), holes(readFileSync(at('map.npy'))));
  writeFileSync(at('map.txt'), matrix(readFileSync(at('map.npy'))));
  writeFileSync(at('hostile.npy'), claiming(readFileSync(at('map.npy')), '(96, 128)', '(4000000, 4000000)'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

// Answers that points are 1 µm apart and heights in metres.
async function metres(page) {
  await page.state('ask');
  await page.type('#dx', '1');
  await page.value("(() => { $('hu').value = 'm'; $('hu').dispatchEvent(new Event('input')); })()");
  await page.until("$('a-say').textContent.includes('usual')");
  await page.click('#use-units');
  await page.state('read');
}

// The heights as text, a line for each row, and nothing of their unit.
function matrix(file) {
  const first = file.length - 96 * 128 * 8;
  const row = y => Array.from({ length: 128 }, (_, x) => file.readDoubleLE(first + 8 * (128 * y + x))).join(' ');
  return Array.from({ length: 96 }, (_, y) => row(y)).join('\n') + '\n';
}

// A block and single points that the instrument did not see. Heights are doubles behind the header.
function holes(file) {
  const first = file.length - 96 * 128 * 8;
  for (let point = 0; point < 96 * 128; point++) {
    const [y, x] = [Math.floor(point / 128), point % 128];
    if ((y > 20 && y < 30 && x > 40 && x < 52) || point % 977 === 0) file.writeDoubleLE(NaN, first + 8 * point);
  }
  return file;
}

// Points far off their neighbours.
function spiky(file) {
  const first = file.length - 96 * 128 * 8;
  for (let point = 1000; point < 96 * 128; point += 1500) file.writeDoubleLE(file.readDoubleLE(first + 8 * (point + 3)) + 5e-6, first + 8 * point);
  return file;
}

// A header that claims something else, as long as before.
function claiming(file, was, is) {
  const text = file.toString('latin1');
  const changed = text.replace(was, is).replace(' '.repeat(is.length - was.length) + '\n', '\n');
  assert.equal(changed.length, text.length);
  return Buffer.from(changed, 'latin1');
}

async function opened(look) {
  const page = await browser.open(address, look);
  await page.until("document.documentElement.dataset.ready === 'true'");
  return page;
}

const planned = page => page.until("!$('compute-now').disabled && $('est-loads').textContent");
const result = page => page.value('({ ...now.answer.files })');

// Every number of the command, and what it prints.
function same(files, out) {
  const of = name => readFileSync(join(at(out), name), 'utf8');
  numbers(JSON.parse(files['results.json']).surfaces, JSON.parse(of('results.json')).surfaces);
  assert.deepEqual(printed(files['report.html']).split('\n'), printed(of('report.html')).split('\n'));
}

async function clean(page) {
  assert.deepEqual(page.faults, []);
  const asked = page.requests.filter(url => !url.startsWith('file:') && !url.startsWith('blob:') && !url.startsWith('data:') && url !== 'about:srcdoc');
  assert.deepEqual(asked, [], 'the page asked the network for something');
  await browser.call('Target.closeTarget', { targetId: page.target });
}

test('an X3P file is read, computed and gives the numbers of the command', async () => {
  const page = await opened();
  await page.choose(at('map.x3p'));
  await page.state('read');
  assert.match(await page.text('#h-read'), /^A height map of 128.µm × 96\.0.µm\./);
  assert.equal(await page.value("document.activeElement.id"), 'h-read');
  await planned(page);
  await page.click('#compute-now');
  await page.state('running');
  await page.state('result');
  rough('compare', 'map.x3p', ...steel, '--outliers', '8', '--fill', 'harmonic', '--out', 'x3p');
  same(await result(page), 'x3p');
  // What is saved is the report of the frame, byte for byte.
  await page.call('Page.setDownloadBehavior', { behavior: 'allow', downloadPath: folder });
  await page.click('[data-save="report.html"]');
  const saved = at('map.x3p-report.html');
  for (let i = 0; i < 100 && !existsSync(saved); i++) await new Promise(done => setTimeout(done, 50));
  assert.equal(readFileSync(saved, 'utf8'), (await result(page))['report.html']);
  assert.ok(await page.value("parseFloat($('report').style.height) > 2000"), 'the frame is as high as the report');
  await clean(page);
});

test('missing points are filled as ticked, and other bodies and loads are taken', async () => {
  const page = await opened();
  await page.choose(at('holes.npy'));
  await metres(page);
  assert.match(await page.text('#defects'), /points are missing/);
  const readings = await page.value("$('h-read').dataset.ready");
  await page.value("(() => { const e = document.querySelector('[data-key=fill]'); e.value = 'nearest'; e.dispatchEvent(new Event('change')); })()");
  await page.until(`$('h-read').dataset.ready > ${readings}`);
  await page.click('#s-read [data-go=bodies]');
  await page.state('bodies');
  await page.type('#e1', '70');
  await page.type('#n1', '0,33');
  await page.type('#e2', '∞');
  await page.click('[name=ld][value=pressure]');
  await page.type('#p1', '5MPa, 20MPa, 80MPa');
  await page.until("$('est-loads').textContent.startsWith('3 loads: 5')");
  assert.match(await page.text('#estar'), /E\* = 78.55.GPa/);
  await page.click('#compute');
  await page.state('result');
  rough('compare', 'holes.npy', '--pixel', '1um', '--height-unit', 'm', '--young', '70GPa', '--poisson', '0.33', '--pressure', '5MPa,20MPa,80MPa', '--outliers', '8', '--fill', 'nearest', '--out', 'holes');
  same(await result(page), 'holes');
  await clean(page);
});

test('a part is cut out, as the command cuts it', async () => {
  const page = await opened();
  await page.choose(at('holes.npy'));
  await metres(page);
  const choose = async value => {
    const readings = await page.value("$('h-read').dataset.ready");
    await page.value(`(() => { const e = $('part'); e.value = '${value}'; e.dispatchEvent(new Event('change')); })()`);
    await page.until(`$('h-read').dataset.ready > ${readings}`);
  };
  await choose('middle');
  assert.match(await page.text('#facts'), /48 rows × 64 columns, cut out from row 24, column 32/);
  assert.match(await page.text('#defects'), /points are missing/);
  await choose('complete');
  assert.doesNotMatch(await page.text('#defects'), /points are missing/);
  await planned(page);
  await page.click('#compute-now');
  await page.state('result');
  rough('compare', 'holes.npy', '--pixel', '1um', '--height-unit', 'm', ...steel, '--crop', 'complete', '--outliers', '8', '--fill', 'harmonic', '--out', 'part');
  same(await result(page), 'part');
  await clean(page);
});

test('each remedy says what it does to the area, as the command finds it', async () => {
  rough('convert', 'map.npy', '--pixel', '1um', '--height-unit', 'm', '--out', 'spiky.npy', '--force');
  writeFileSync(at('spiky.npy'), spiky(holes(readFileSync(at('spiky.npy')))));
  const page = await opened();
  const pictures = () => page.value("[...document.querySelectorAll('#pictures label')].map(e => e.textContent)");
  const shown = () => page.value("[document.querySelector('[name=pic]:checked').parentNode.textContent, document.querySelectorAll('#picture .rings circle').length]");
  await page.choose(at('spiky.npy'));
  await metres(page);
  const [raw, ringed, remedied] = ['As measured', 'Level, spikes ringed', 'With the ticked remedies'];
  assert.deepEqual(await pictures(), [raw, ringed, remedied]);
  assert.deepEqual(await shown(), [remedied, 0]);
  await page.click('#pictures label:nth-of-type(2) input');
  const [name, rings] = await shown();
  assert.equal(name, ringed);
  assert.ok(rings >= 1);
  await page.until("now.read.areas");
  const said = await page.value("Object.fromEntries(['spikes', 'fill'].map(key => [key, [...document.querySelectorAll(`[data-area=${key}]`)].map(e => e.innerText)]))");
  const read = ['spiky.npy', '--pixel', '1um', '--height-unit', 'm'];
  const gradient = JSON.parse(rough('stats', ...read, '--outliers', '8', '--fill', 'harmonic', '--json')).rms_gradient;
  const area = (...how) => JSON.parse(rough('solve', ...read, ...how, '--modulus', '100GPa', '--pressure', `${1e9 * gradient}Pa`, '--json')).points[0].area_fraction;
  const close = (text, expected) => assert.ok(Math.abs(100 * expected / parseFloat(text.match(/[\d.]+/)[0]) - 1) < 0.01, `${text}, and the command has ${100 * expected} %`);
  const clean8 = area('--outliers', '8', '--fill', 'harmonic');
  close(said.spikes[0], area('--fill', 'harmonic'));
  close(said.spikes[1], clean8);
  assert.ok(parseFloat(said.spikes[0].match(/[\d.]+/)[0]) < 0.8 * parseFloat(said.spikes[1].match(/[\d.]+/)[0]), 'spikes carry the load');
  const [smooth, nearest] = said.fill[0].split('\n');
  assert.match(smooth, /smoothly$/);
  close(smooth, clean8);
  close(nearest, area('--outliers', '8', '--fill', 'nearest'));
  // Ended by another question, it begins again when the page is back.
  const readings = await page.value("$('h-read').dataset.ready");
  await page.click('[data-key=plane], [data-key=spikes]');
  await page.until(`$('h-read').dataset.ready > ${readings}`);
  assert.deepEqual(await shown(), [ringed, rings], 'the picture that was chosen, of the map as measured');
  await page.click('#s-read [data-go=bodies]');
  await page.state('bodies');
  await page.click('.steps a[href="#read"]');
  await page.state('read');
  await page.until("now.read.areas && ![...document.querySelectorAll('[data-area]')].some(e => e.textContent === '…')");
  // A map without spikes has no such picture.
  await page.choose(at('map.x3p'));
  await page.until("document.querySelectorAll('#pictures label').length === 2");
  assert.deepEqual(await pictures(), [raw, remedied]);
  assert.deepEqual(await shown(), [remedied, 0]);
  await clean(page);
});

test('a text map without units is asked about, with what the answer would mean', async () => {
  const page = await opened();
  await page.choose(at('map.txt'));
  await page.state('ask');
  assert.match(await page.text('#h-ask'), /no pixel size and no height unit/);
  assert.ok(await page.value("$('use-units').disabled"));
  await page.type('#dx', '1');
  await page.until("!$('use-units').disabled");
  assert.match(await page.text('#a-say'), /too small|too large|flatter/, 'metres are not micrometres');
  await page.value("(() => { $('hu').value = 'm'; $('hu').dispatchEvent(new Event('input')); })()");
  await page.until("$('a-say').textContent.includes('usual')");
  assert.match(await page.text('#a-g'), /^0\.099$|^0\.1/);
  await page.click('#use-units');
  await page.state('read');
  await planned(page);
  await page.click('#compute-now');
  await page.state('result');
  rough('compare', 'map.txt', '--pixel', '1um', '--height-unit', 'm', ...steel, '--outliers', '8', '--fill', 'harmonic', '--out', 'txt');
  same(await result(page), 'txt');
  await clean(page);
});

test('a hostile file is refused before memory is taken, and the page goes on', async () => {
  const page = await opened();
  await page.choose(at('hostile.npy'));
  await page.state('error');
  assert.match(await page.text('#h-error'), /more than a browser can give|contradicts itself/);
  assert.match(await page.text('#e-detail'), /limit|malformed/);
  assert.ok(await page.value('engine.memory < 64e6'), 'memory was taken for what the file claims');
  const name = 'img src=x onerror=document.title="run"';
  writeFileSync(at(`<${name}>.txt`.replace('/', '')), 'no height map');
  await page.choose(at(`<${name}>.txt`));
  await page.until("$('e-detail').textContent.length > 0 && location.hash === '#error'");
  assert.notEqual(await page.value('document.title'), 'run');
  await page.choose(at('map.x3p'));
  await page.state('read');
  await clean(page);
});

test('a worker that dies leaves file and settings', async () => {
  const page = await opened();
  await page.choose(at('map.x3p'));
  await page.state('read');
  await planned(page);
  await page.value("(() => { const ask = engine.ask.bind(engine); engine.ask = (q, ...rest) => { if (q === 'run') { engine.ask = ask; return ask('no such question', 'not JSON for it', ...rest.slice(1)); } return ask(q, ...rest); }; })()");
  await page.click('#compute-now');
  await page.state('error');
  assert.ok(await page.value("[...document.querySelectorAll('#e-act button')].some(b => b.textContent.includes('again'))"));
  await page.click('#e-act button');
  await clean(page);
});

test('a computation is cancelled, stopped early, and a built-in surface solved', async () => {
  const page = await opened();
  await page.click('[data-example=ground]');
  await page.state('bodies');
  await page.until("$('est-loads').textContent.startsWith('15 loads')");
  await page.click('#compute');
  await page.state('running');
  await page.until('run.done.length >= 1');
  const map = await page.value("(async () => { const e = $('r-map'); await e.decode(); return [e.checkVisibility(), e.naturalWidth, e.alt, $('r-top').textContent]; })()");
  assert.deepEqual(map.slice(0, 2), [true, 501]); // 1001 points in squares of two
  assert.match(map[2], /^Contact map at .*Pa: .*% of the area touches$/);
  assert.match(map[3], /Pa( and more)?$/);
  await page.click('#cancel');
  await page.state('bodies');
  assert.equal(await page.value('engine.running'), false);
  await page.click('#compute');
  await page.state('running');
  await page.until('run.done.length >= 2', 300);
  await page.click('#stop');
  await page.state('result', 300);
  assert.match(await page.text('#result-note'), /^Stopped after \d+ of 15 loads/);
  const files = await result(page);
  const loads = JSON.parse(files['results.json']).surfaces[0].deterministic.points.length;
  assert.ok(loads >= 2 && loads < 15, `${loads} loads`);
  await clean(page);
});

test('bodies and loads are there the next time, what lies folded is not; where nothing may be kept, nothing is', async () => {
  const context = await browser.call('Target.createBrowserContext'), fields = ['m1', 'e1', 'n1', 'm2', 'e2', 'n2', 'p1', 'hard'];
  const filled = page => page.value(`[...${JSON.stringify(fields)}.map(id => $(id).value), document.querySelector('[name=ld]:checked').value, $('ld-pressure').hidden]`);
  const first = await opened({ context }), before = await filled(first);
  await first.click('[data-example=ground]');
  await first.state('bodies');
  await first.type('#e1', '71.5');
  await first.value("(() => { $('m2').value = 3; $('m2').dispatchEvent(new Event('change')); })()");
  await first.click('[name=ld][value=pressure]');
  await first.type('#p1', '5MPa, 20MPa');
  await first.value("(() => { $('hard').value = '2'; })()");
  await first.until("$('est-loads').textContent.startsWith('2 loads')");
  const wanted = await filled(first);
  assert.notDeepEqual(wanted, before);
  await clean(first);
  const again = await opened({ context });
  assert.deepEqual(await filled(again), wanted.map((value, i) => fields[i] === 'hard' ? '' : value));
  await again.choose(at('map.x3p'));
  await again.state('read');
  await planned(again);
  assert.match(await again.text('#read-cost'), /^2 loads: 5.*to 20/);
  assert.equal(await again.value("Object.keys(localStorage).join() + /map|x3p/.test(localStorage['rough-contact'])"), 'rough-contactfalse', 'nothing of the surface');
  await again.value("localStorage['rough-contact'] = '{\"fields\":7,\"materials\":\"x\",\"load\":[]}'");
  await clean(again);
  const spoilt = await opened({ context });
  assert.deepEqual(await filled(spoilt), before);
  await spoilt.call('Page.addScriptToEvaluateOnNewDocument', { source: "Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('refused', 'SecurityError'); } })" });
  await spoilt.call('Page.reload');
  await new Promise(done => setTimeout(done, 300));
  await spoilt.until("document.documentElement.dataset.ready === 'true'");
  assert.deepEqual(await filled(spoilt), before);
  await spoilt.click('[data-example=ground]');
  await spoilt.state('bodies');
  await spoilt.until("$('est-loads').textContent.startsWith('15 loads')");
  assert.match(await spoilt.text('#est-cost'), /^1\s002\s001\spoints; about [\d.]+\s(s|min) and 150\sMB of memory, up to [\d.]+\s(s|min) and 910\sMB where/u);
  await clean(spoilt);
});

test('by keyboard alone, in the dark, on a phone: nothing is wider than the screen', async () => {
  const page = await opened({ width: 420, height: 800, dark: true });
  const narrow = async () => assert.ok(await page.value('document.documentElement.scrollWidth <= document.documentElement.clientWidth'), await page.value('location.hash'));
  await narrow();
  await page.choose(at('map.x3p'));
  await page.state('read');
  await narrow();
  assert.equal(await page.value('getComputedStyle(document.body).backgroundColor'), 'rgb(21, 24, 27)');
  await planned(page);
  await page.value("$('compute-now').focus()");
  await page.key('Enter');
  await page.state('result');
  await narrow();
  await page.value('history.back()');
  await page.until("location.hash !== '#result'");
  await narrow();
  assert.deepEqual(await page.value("[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, ids) => ids.indexOf(id) !== i)"), []);
  await clean(page);
});

for (const given of process.argv.slice(2).filter(a => a !== '--' && existsSync(a))) {
  const wanted = readdirSync(given, { recursive: true }).map(String).filter(f => basename(f) === 'KautschukInfiniteFocus.x3p');
  for (const file of wanted) {
    test(`${file}, measured, with missing points`, async () => {
      const page = await opened();
      await page.choose(join(given, file));
      await page.state('read');
      await planned(page);
      await page.click('#compute-now');
      await page.state('result', 600);
      execFileSync(command, ['compare', basename(file), ...steel, '--outliers', '8', '--fill', 'harmonic', '--out', at('measured'), '--quiet', '--threads', '1'], { cwd: dirname(join(resolve(given), file)), stdio: 'ignore' });
      same(await result(page), 'measured');
      await clean(page);
    });
  }
}
