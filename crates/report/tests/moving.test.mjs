// The report as a person moves it, in headless Chromium: slider, values beside the curves, a model followed, the map
// from near, section, paper, no scripts. What moves is held against maps that the command solves.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from '../../web/tests/browser.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const command = resolve(process.env.ROUGH_CONTACT || join(root, 'target/debug/rough-contact'));
const folder = mkdtempSync(join(tmpdir(), 'rough-contact-report-'));
const at = name => join(folder, name);
const rough = (...args) => execFileSync(command, [...args, '--quiet', '--threads', '1'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
const [ROWS, COLUMNS] = [96, 128];
const pictures = process.env.PICTURES; // a folder for screenshots, to be looked at
let browser = null, surface = null;

before(() => {
  browser = new Browser();
  if (pictures) mkdirSync(pictures, { recursive: true });
  rough('synth', '--shape', `${ROWS},${COLUMNS}`, '--pixel', '1um', '--hurst', '0.8', '--rolloff', '30um', '--cutoff', '5um', '--rms-gradient', '0.1', '--seed', '7', '--out', 'map.x3p');
  rough('compare', 'map.x3p', '--modulus', '110GPa', '--out', 'report');
  surface = JSON.parse(readFileSync(at('report/results.json'), 'utf8')).surfaces[0];
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

const points = () => surface.deterministic.points;
const headline = () => points().findIndex(p => p.mean_pressure === surface.headline_pressure);

async function opened(look, name = 'report/report.html') {
  const page = await browser.open(pathToFileURL(at(name)).href, look);
  await page.until("document.readyState === 'complete' && document.querySelector('.zoom')");
  await page.value("new Promise(done => setTimeout(done, 200))");
  return page;
}

async function shown(page, name) { if (pictures) writeFileSync(join(pictures, `${name}.png`), await page.picture()); }

async function clean(page) {
  assert.deepEqual(page.faults, []);
  assert.deepEqual(page.requests.filter(url => !url.startsWith('file:') && !url.startsWith('data:')), []);
  await browser.call('Target.closeTarget', { targetId: page.target });
}

const load = (page, i) => page.value(`(() => { const e = document.querySelector('.dial input'); e.value = ${i}; e.dispatchEvent(new Event('input')); return new Promise(done => setTimeout(done, 60)); })()`);
const mouse = (page, type, x, y, more = {}) => page.call('Input.dispatchMouseEvent', { type, x, y, ...more });
const box = (page, selector) => page.value(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({ block: 'center' }); const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()`);

// What the canvas of the map holds: its size, and 1 where it is coloured.
const canvas = page => page.value(`(() => {
  const c = document.querySelector('.over-map canvas'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  let on = ''; for (let i = 0; i < d.length; i += 4) on += d[i] === d[i + 1] && d[i + 1] === d[i + 2] ? '0' : '1';
  return [c.height, c.width, on]; })()`);

// Maps of pressure that the command solves at the loads of the report.
function solved(name = 'map.x3p', loads = points(), count = ROWS * COLUMNS) {
  const pressures = loads.map(p => `${p.mean_pressure}Pa`).join(',');
  rough('solve', name, '--modulus', '110GPa', '--pressure', pressures, '--maps', 'maps', '--force');
  const files = readdirSync(at('maps')).filter(f => /pressure.*\.npy$/.test(f)).sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
  assert.ok(files.length >= loads.length, files.join());
  return files.slice(0, loads.length).map(file => {
    const bytes = readFileSync(join(at('maps'), file)), begin = bytes.length - 8 * count;
    return Float64Array.from({ length: count }, (_, i) => bytes.readDoubleLE(begin + 8 * i));
  });
}

// The step of the ramp that each point of the canvas has, 0 where it is grey; and the number at the end of the bar.
const colours = page => page.value(`(() => {
  const facts = JSON.parse(document.querySelector('img.first').dataset.facts), hex = facts.ramp.match(/.{6}/g), of = new Map(hex.map((c, i) => [parseInt(c, 16), i]));
  const c = document.querySelector('.over-map canvas'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, steps = [];
  for (let i = 0; i < d.length; i += 4) steps.push(d[i] === d[i + 1] && d[i + 1] === d[i + 2] ? 0 : of.get(d[i] << 16 | d[i + 1] << 8 | d[i + 2]) ?? -1);
  return [steps, document.querySelector('.legend').getAttribute('visibility') === 'hidden' ? null : document.querySelector('.legend text:nth-of-type(2)').textContent]; })()`);

// Held against pressures: to a step of the scale that ends at two digits of the 99th percentile of those in contact.
function coloured([steps, end], pressures, said, slack) {
  const contact = pressures.filter(p => p > 0).sort(), top = Number(contact[Math.floor((contact.length - 1) * 99 / 100)].toPrecision(2));
  assert.equal(Number(end.replace(/[≥\u202f]/g, '')), Number((top / 10 ** (3 * Math.round(Math.log10(top / Number(end.replace('≥', ''))) / 3))).toPrecision(2)), `${said}: the end of the bar is ${end}, the pressures end at ${top}`);
  assert.equal(end.startsWith('≥'), contact[contact.length - 1] > top);
  const off = Array.from(pressures, (p, i) => p > 0 ? Math.abs(steps[i] - Math.max(1, 255 * Math.min(1, p / top))) : steps[i]);
  assert.ok(Math.max(...off.map(Math.abs)) <= slack, `${said}: ${Math.max(...off)} steps off`);
}

test('map and section are the solver\'s at every load of the slider', async () => {
  const page = await opened(), maps = solved();
  const row = await page.value("Math.round(JSON.parse(document.querySelector('span.cut').dataset.facts).row * " + ROWS + " - 0.5)");
  for (const [i, point] of points().entries()) {
    if (i === headline()) continue; // the still picture is shown there
    await load(page, i);
    const [height, width, on] = await canvas(page);
    assert.deepEqual([height, width], [ROWS, COLUMNS]);
    const expected = Array.from(maps[i], p => p > 0 ? '1' : '0').join('');
    assert.ok(on === expected, `load ${i}: ${[...on].filter((c, k) => c !== expected[k]).length} points differ`);
    assert.equal([...on].filter(c => c === '1').length, point.contact_pixels);
    coloured(await colours(page), maps[i], `load ${i}`, 1);
    // The coloured stretches of the section are the points of that row that touch; the flat stands at the mean gap.
    const [marks, flat, [left, top, right, bottom], [low, high]] = await page.value(`(() => {
      const svg = document.querySelector('span.cut').closest('figure').querySelector('svg'), scales = JSON.parse(document.querySelector('span.cut').dataset.facts).scales;
      return [[...svg.querySelectorAll('.touching path')].map(p => p.getAttribute('d').match(/[\\d.]+/g).map(Number)), +svg.querySelector('.flat line').getAttribute('y1'), scales.box, scales.heights]; })()`);
    const touching = new Set();
    const part = x => (x - left) / (right - left) * COLUMNS;
    for (const [from, , to] of marks) for (let k = Math.round(part(from)); k < Math.round(part(to)); k++) touching.add(k);
    const along = Array.from({ length: COLUMNS }, (_, k) => k).filter(k => maps[i][row * COLUMNS + k] > 0);
    assert.deepEqual([...touching].sort((a, b) => a - b), along, `section at load ${i}`);
    const height2 = low + (bottom - flat) / (bottom - top) * (high - low);
    assert.ok(Math.abs(height2 - point.mean_gap) < 0.02 * (high - low), `flat at load ${i}: ${height2}, mean gap ${point.mean_gap}`);
    assert.match(await page.text('.over-map canvas + *, .dial output'), /./);
    assert.equal(await page.value("document.querySelector('.over-map').getAttribute('aria-label').match(/: ([\\d\\u202f]+) of/)[1].replace(/\\D/g, '')"), String(point.contact_pixels));
  }
  await shown(page, 'last-load');
  await page.click('.dial .back');
  assert.equal(await page.value("getComputedStyle(document.querySelector('.over-map canvas')).display"), 'none', 'the still picture again');
  await clean(page);
});

test('the distributions are those of the load read off, and on paper those of the headline', async () => {
  const page = await opened(), maps = solved();
  const cells = async () => Object.fromEntries(await page.value("[...document.querySelectorAll('[data-k^=\"d-\"]')].map(e => [e.dataset.k, e.textContent])"));
  // How high the bars are, what the figure says, and whether the theory stands in it.
  const figure = () => page.value(`(() => { const svg = document.querySelector('span.spread').closest('figure').querySelector('svg');
    return [(svg.querySelector('path[fill-opacity]')?.getAttribute('d') ?? '').split('Z').slice(0, -1).map(bar => bar.match(/[-\\d.]+/g).map(Number)).map(([left, bottom, top]) => bottom - top), svg.querySelector('desc').textContent, svg.querySelectorAll('[data-m=persson]').length]; })()`);
  const many = points().map((point, i) => i).filter(i => points()[i].contact_pixels >= 200), few = points().findIndex(point => point.contact_pixels < 200);
  assert.ok(many.length > 5 && few >= 0, 'loads with many points and with few');
  for (const i of many) {
    await load(page, i);
    const said = await cells(), touching = maps[i].filter(p => p > 0), share = touching.length / (ROWS * COLUMNS);
    const near = (text, value, slack) => assert.ok(Math.abs(parseFloat(text.replace('\u202f', '')) / value - 1) < slack, `load ${i}: ${text}, expected ${value}`);
    near(said['d-touches'], 100 * share, 0.06);
    // Bars are as high as the points of their class are many.
    const [bars] = await figure(), highest = touching.reduce((a, b) => Math.max(a, b));
    const counts = new Array(40).fill(0);
    touching.forEach(p => { counts[Math.min(39, Math.floor(p / (highest / 40)))]++; });
    const shown = counts.filter(n => n > 0).slice(0, bars.length), each = bars.reduce((a, b) => a + b) / shown.reduce((a, b) => a + b);
    bars.forEach((bar, k) => assert.ok(Math.abs(bar - each * shown[k]) < 0.02 + 0.01 * bar, `load ${i}, bar ${k}: ${bar} for ${shown[k]} points, ${each} for each`));
    assert.ok(bars.length > 9);
  }
  await load(page, few);
  assert.match((await figure())[1], /^Fewer than 200 points touch/);
  assert.equal((await cells())['d-half'], '–');
  assert.equal((await figure())[2], 1, 'the theory stays');
  await shown(page, 'few');
  await page.value("addEventListener('beforeprint', () => { window.printed = document.querySelector('span.spread').closest('figure').querySelector('desc').textContent; })");
  await page.call('Page.printToPDF', {});
  assert.match(await page.value('window.printed'), /^Density of the pressure over the contact/);
  assert.match((await figure())[1], /^Fewer/, 'back on screen');
  await clean(page);
});

test('a large map is coloured by the highest pressure of each square of points', async () => {
  const [rows, columns] = [520, 610];
  rough('synth', '--shape', `${rows},${columns}`, '--pixel', '1um', '--hurst', '0.8', '--rolloff', '60um', '--cutoff', '4um', '--rms-gradient', '0.1', '--seed', '3', '--out', 'wide.x3p');
  rough('compare', 'wide.x3p', '--modulus', '110GPa', '--pressure', '20MPa,200MPa,1GPa', '--out', 'wide');
  const found = JSON.parse(readFileSync(at('wide/results.json'), 'utf8')).surfaces[0], loads = found.deterministic.points;
  const maps = solved('wide.x3p', loads, rows * columns), page = await opened({}, 'wide/report.html');
  const shown = loads.map((_, i) => i).filter(i => loads[i].mean_pressure !== found.headline_pressure);
  assert.equal(shown.length, 2);
  for (const i of shown) {
    await load(page, i);
    await page.value("new Promise(done => setTimeout(done, 500))");
    const highest = new Float64Array(Math.ceil(rows / 2) * Math.ceil(columns / 2)), square = k => Math.floor(Math.floor(k / columns) / 2) * Math.ceil(columns / 2) + Math.floor(k % columns / 2);
    maps[i].forEach((p, k) => { highest[square(k)] = Math.max(highest[square(k)], p); });
    const [steps, end] = await colours(page), contact = maps[i].filter(p => p > 0).sort(), top = Number(contact[Math.floor((contact.length - 1) * 99 / 100)].toPrecision(2));
    const off = Array.from(maps[i], (p, k) => p > 0 ? Math.abs(steps[k] - Math.max(1, 255 * Math.min(1, highest[square(k)] / top))) : steps[k]);
    assert.ok(off.reduce((a, b) => Math.max(a, b)) <= 1, `load ${i}, to ${end}`);
  }
  await clean(page);
});

test('played, it runs to the heaviest load, stops when asked, and not at all where less motion is wanted', async () => {
  const page = await opened(), at = () => page.value("+document.querySelector('.dial input').value"), last = points().length - 1;
  const says = () => page.text('.dial .play');
  await load(page, last - 2);
  await page.value("document.querySelector('.dial .play').focus()");
  await page.key('Enter');
  assert.deepEqual([await at(), await says()], [last - 1, 'Stop']);
  await page.until(`+document.querySelector('.dial input').value === ${last} && document.querySelector('.dial .play').textContent === 'Play'`);
  await page.click('.dial .play');
  assert.equal(await at(), 0, 'from the lightest again');
  await page.until("+document.querySelector('.dial input').value === 1");
  await page.key('Escape');
  const stopped = await at();
  await page.value('new Promise(done => setTimeout(done, 900))');
  assert.deepEqual([await at(), await says()], [stopped, 'Play']);
  await page.click('.dial .play');
  await page.call('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  await page.until("document.querySelector('.dial .play').textContent === 'Play'");
  assert.equal(await page.value("document.querySelector('.dial .play').checkVisibility()"), false);
  await clean(page);
});

test('beside a curve stand the values of every model, by mouse and by keyboard', async () => {
  const page = await opened();
  const names = surface.models.filter(m => m.points).length;
  for (const [k, unit] of [[0, /%$/], [1, /Pa$/], [2, /%$/]]) {
    const [x, y, width, height] = await page.value(`(() => { const s = document.querySelectorAll('.cur')[${k}].ownerSVGElement; s.scrollIntoView({ block: 'center' }); const b = s.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()`);
    await mouse(page, 'mouseMoved', x + 0.55 * width, y + 0.5 * height);
    await page.until("!document.querySelector('.values').hidden");
    const rows = await page.value("[...document.querySelectorAll('.values div')].map(r => [...r.children].map(c => c.textContent))");
    assert.equal(rows.length, names + (k < 2 ? 1 : 0));
    for (const [, value] of rows) assert.match(value, unit, JSON.stringify(rows));
    assert.equal(await page.text('.values b'), (await page.text('.models thead [data-k=load]')), 'the load of the list and of the table');
    if (k === 0) {
      const table = await page.value("[...document.querySelectorAll('.models [data-k^=\"a-\"]')].map(e => e.textContent)");
      assert.deepEqual(rows.map(r => r[1]).sort(), table.sort());
      await shown(page, 'values');
    }
    await mouse(page, 'mouseMoved', 2, 2);
    await page.until("document.querySelector('.values').hidden");
    assert.equal(await page.value("+document.querySelector('.dial input').value"), headline(), 'leaving goes back');
  }
  await page.value("document.querySelectorAll('.cur')[1].ownerSVGElement.focus()");
  await page.key('ArrowRight');
  assert.equal(await page.value("+document.querySelector('.dial input').value"), headline() + 1);
  assert.equal(await page.value("document.querySelector('.values').hidden"), false);
  await page.key('Home');
  assert.equal(await page.value("+document.querySelector('.dial input').value"), 0);
  await page.key('Escape');
  assert.ok(await page.value("document.querySelector('.values').hidden"));
  await clean(page);
});

test('a model is followed through figures and table until it is let go', async () => {
  const page = await opened();
  const opacity = name => page.value(`[...document.querySelectorAll('svg [data-m="${name}"], tr[data-m="${name}"]')].map(e => getComputedStyle(e).opacity)`);
  const all = async (name, wanted) => { const found = await opacity(name); assert.ok(found.length >= 8, `${name} is marked ${found.length} times`); assert.ok(found.every(wanted), `${name}: ${found}`); };
  await page.click('.models tr[data-m=persson] th div');
  await all('persson', o => o === '1');
  await all('gw', o => Number(o) < 0.5);
  assert.equal(await page.value("document.querySelector('tr[data-m=persson] th div').getAttribute('aria-pressed')"), 'true');
  await shown(page, 'following');
  await page.value("document.querySelector('tr[data-m=gw] th div').focus()");
  await page.key('Enter');
  await all('gw', o => o === '1');
  await all('persson', o => Number(o) < 0.5);
  await page.key(' ');
  await all('persson', o => o === '1');
  // By its label in a figure, and Escape.
  await page.value("document.querySelector('svg [data-m=bgt] text').setAttribute('id', 'there')");
  await page.click('#there');
  await all('bgt', o => o === '1');
  await all('gw', o => Number(o) < 0.5);
  await page.key('Escape');
  await all('gw', o => o === '1');
  assert.deepEqual(await page.value("[...document.querySelectorAll('[aria-pressed=true]')].length"), 0);
  await clean(page);
});

test('the map from near shows the points of the solver, by every way in', async () => {
  const page = await opened(), maps = solved();
  const near = () => page.value("(() => { const t = document.querySelector('.zoom .near').textContent; return t ? t.match(/\\d+/g).map(Number) : [128, 96, 128, 96]; })()");
  const place = () => page.value("window.place");
  await page.value("document.querySelector('[data-loads]').addEventListener('look', e => window.place = [e.detail.from, e.detail.to])");
  await page.value("document.querySelector('.over-map').focus()");
  for (let k = 0; k < 3; k++) await page.key('+');
  const [columns, rows] = await near();
  assert.ok(columns < 40 && rows < 30, `${columns} × ${rows}`);
  for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowUp']) await page.key(key);
  await page.value("new Promise(done => setTimeout(done, 200))");
  // At the load of the headline the colours are pressures; where there is one, the solver has one, wherever it is.
  const map = maps[headline()];
  async function isPart() {
    const [height, width, on] = await canvas(page), left = Math.round((await place())[0] * COLUMNS);
    const fits = top => [...on].every((c, k) => (c === '1') === (map[(top + Math.floor(k / width)) * COLUMNS + left + k % width] > 0));
    assert.ok(Array.from({ length: ROWS - height + 1 }, (_, top) => top).some(fits), 'the window is not a part of the solver\'s map');
    return [width, height, [...on].filter(c => c === '1').length];
  }
  assert.deepEqual((await isPart()).slice(0, 2), [columns, rows]);
  assert.ok(await page.value("document.querySelector('.over-map canvas').classList.contains('squares')"));
  const axis = await page.value("[...document.querySelectorAll('.across text')].map(t => +t.textContent)");
  const [from, to] = await place();
  assert.ok(axis.every(v => v >= from * COLUMNS - 1e-6 && v <= to * COLUMNS + 1e-6), `${axis} within ${from * COLUMNS} to ${to * COLUMNS}`);
  await shown(page, 'near');
  await page.key('0');
  assert.deepEqual(await near(), [128, 96, 128, 96]);
  // The wheel scrolls the page, and with Ctrl it is the map's, around the pointer.
  const [x, y, w, h] = await box(page, '.over-map');
  await mouse(page, 'mouseWheel', x + 0.9 * w, y + h / 2, { deltaX: 0, deltaY: -200, modifiers: 2 });
  await page.until("document.querySelector('.zoom .near').textContent");
  const [begin, end] = await place();
  await page.key('0');
  // Around the highest pressure there is something to be seen.
  const highest = map.indexOf(Math.max(...map)), [hx, hy] = [highest % COLUMNS + 0.5, Math.floor(highest / COLUMNS) + 0.5];
  for (let k = 0; k < 3; k++) await mouse(page, 'mouseWheel', x + hx / COLUMNS * w, y + hy / ROWS * h, { deltaX: 0, deltaY: -150, modifiers: 2 });
  await page.until("document.querySelector('.over-map canvas').width < 40");
  await page.value("new Promise(done => setTimeout(done, 200))");
  assert.ok((await isPart())[2] > 20, 'points that touch');
  await shown(page, 'nearest');
  assert.ok(begin > 0.3 && Math.abs(begin + 0.9 * (end - begin) - 0.9) < 0.02, `${begin} to ${end}`);
  // Dragged to the left edge, no further.
  await mouse(page, 'mousePressed', x + 10, y + h / 2, { button: 'left', clickCount: 1 });
  await mouse(page, 'mouseMoved', x + w - 5, y + h / 2, { button: 'left' });
  await mouse(page, 'mouseMoved', x + 3 * w, y + h / 2, { button: 'left' });
  await mouse(page, 'mouseReleased', x + 3 * w, y + h / 2, { button: 'left' });
  assert.equal((await place())[0], 0);
  await page.click('.zoom button:nth-child(3)');
  assert.deepEqual(await near(), [128, 96, 128, 96]);
  await page.click('.zoom button:nth-child(2)');
  assert.ok((await near())[0] < 128);
  await page.click('.zoom button:nth-child(1)');
  assert.deepEqual(await near(), [128, 96, 128, 96]);
  // Two fingers.
  await page.call('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
  const touch = (type, apart) => page.call('Input.dispatchTouchEvent', { type, touchPoints: apart ? [-apart, apart].map((d, id) => ({ x: x + w / 2 + d, y: y + h / 2, id })) : [] });
  await box(page, '.over-map');
  await touch('touchStart', 40);
  await touch('touchMove', 80);
  await touch('touchMove', 120);
  await touch('touchEnd');
  const pinched = (await near())[0];
  assert.ok(Math.abs(pinched - COLUMNS / 3) <= 3, `${pinched} columns, of a pinch by three`);
  await clean(page);
});

test('paper shows the headline and every model, and the screen comes back as it was', async () => {
  const page = await opened();
  await load(page, 2);
  await page.click('.models tr[data-m=persson] th div');
  await page.click('.zoom button:nth-child(2)');
  await page.value("addEventListener('beforeprint', () => { window.printed = [+document.querySelector('.dial input').value, document.documentElement.classList.contains('following'), document.querySelector('.zoom .near').textContent]; })");
  await page.call('Page.printToPDF', {});
  assert.deepEqual(await page.value('window.printed'), [headline(), false, '']);
  const after = () => page.value("[+document.querySelector('.dial input').value, document.documentElement.classList.contains('following'), document.querySelector('.zoom .near').textContent !== '']");
  assert.deepEqual(await after(), [2, true, true]);
  await clean(page);
});

test('without scripts all of it reads; on a phone and in the dark nothing is wider than the screen', async () => {
  const file = readFileSync(at('report/report.html'), 'utf8');
  writeFileSync(at('still.html'), file.replace(/<script>[\s\S]*?<\/script>/, ''));
  const still = await browser.open(pathToFileURL(at('still.html')).href);
  await still.until("document.readyState === 'complete'");
  const visible = selector => still.value(`[...document.querySelectorAll(${JSON.stringify(selector)})].filter(e => e.checkVisibility()).length`);
  assert.equal(await visible('.dial, .moves, .zoom, .values, img.first, img.pressure, img.pressed, span.cut, span.spread'), 0, 'nothing that would not work');
  const headings = html => [...html.matchAll(/<(h[123])[^>]*>([\s\S]*?)<\/\1>/g)].length;
  assert.equal(await visible('h1, h2, h3'), headings(file));
  assert.equal(await visible('figure svg'), file.match(/<figure/g).length);
  assert.ok(await visible('.touching path') > 0, 'the section of the headline is coloured where it touches');
  await shown(still, 'still');
  await clean(still);
  const page = await opened({ width: 420, height: 800, dark: true });
  const narrow = () => page.value('document.documentElement.scrollWidth <= document.documentElement.clientWidth');
  assert.ok(await narrow());
  await load(page, points().length - 1);
  await page.click('.zoom button:nth-child(2)');
  assert.ok(await narrow());
  assert.equal(await page.value('getComputedStyle(document.body).backgroundColor'), 'rgb(21, 24, 27)');
  assert.deepEqual(await page.value("[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, ids) => ids.indexOf(id) !== i)"), []);
  await shown(page, 'phone');
  await clean(page);
});
