// The questions that the command, Python and `rough-contact app` are asked too (fixtures/questions), to the engine in the page: every
// number is compared with the command's.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { numbers } from './compare.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const data = join(root, 'fixtures/questions');
const address = pathToFileURL(process.env.PAGE || join(root, 'target/page/rough-contact.html')).href;
const command = resolve(process.env.ROUGH_CONTACT || join(root, 'target/debug/rough-contact'));
const folder = mkdtempSync(join(tmpdir(), 'rough-contact-questions-'));
const questions = JSON.parse(readFileSync(join(data, 'questions.json'), 'utf8')).filter(q => !q.against);
let browser = null, page = null;

before(async () => {
  readdirSync(data).forEach(name => copyFileSync(join(data, name), join(folder, name)));
  browser = new Browser();
  page = await browser.open(address);
  await page.until("document.documentElement.dataset.ready === 'true'");
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

function options(q) {
  const words = [q.file, '--fill', q.fill || 'harmonic', '--threads', '1', '--quiet'];
  for (const body of q.bodies) for (const key of ['material', 'young', 'poisson']) if (key in body) words.push('--' + key, String(body[key]));
  const keys = ['hardness', 'pressure', 'load', 'area', 'pixel', 'lateral_unit', 'height_unit', 'level', 'edges', 'outliers', 'crop', 'layout', 'resistivity'];
  for (const key of keys) if (key in q) words.push('--' + key.replace('_', '-'), String(q[key]).replaceAll(' ', ''));
  return words;
}

function request(q) {
  return {
    name: q.file,
    bodies: q.bodies.map(b => ({ material: b.material || '', young: b.young || '', poisson: String(b.poisson ?? '') })),
    hardness: q.hardness || '', resistivities: q.resistivity || ['', ''],
    load: { by: q.load ? 'force' : 'pressure', list: q.load || q.pressure, area: q.area || '' },
    reading: { pixel: q.pixel ?? null, lateral_unit: q.lateral_unit ?? null, height_unit: q.height_unit ?? null, part: q.crop ?? null, layout: q.layout ?? null },
    remedies: { spikes: 'outliers' in q, plane: !('level' in q), mirror: q.edges === 'mirrored', fill: q.fill || 'harmonic' },
  };
}

questions.forEach((q, i) => test(q.name, async () => {
  await page.value('now.file = null');
  await page.choose(join(folder, q.file));
  await page.until('now.file');
  const answer = await page.value(`engine.ask('run', ${JSON.stringify(request(q))}, now.file)`);
  if (q.refused || q.lateral_unit) { assert.equal(answer.failure.kind, q.refused || 'profile'); return; }
  execFileSync(command, ['compare', ...options(q), '--out', String(i)], { cwd: folder, stdio: ['ignore', 'ignore', 'ignore'] });
  const [found, expected] = [answer.files['results.json'], readFileSync(join(folder, String(i), 'results.json'), 'utf8')].map(t => JSON.parse(t));
  numbers(found.settings, expected.settings);
  assert.ok(numbers(found.surfaces, expected.surfaces) > 100);
}));
