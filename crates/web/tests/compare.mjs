// Two answers to the same question: by the command and by the page.
import assert from 'node:assert/strict';

// The last bits of a transform depend on the processor: with fused multiply-add, as most have, and without, as in
// WebAssembly. Answers move by less than this, relative to their size.
const ROUNDING = 1e-6;
// What an iteration leaves over is a small difference of large numbers, and rounding is a larger part of it.
const LEFT_OVER = /residuals|iteration|duality_gap|energy_bound|seam|stiffness/;
const LEFT_OVER_ROUNDING = 1e-3;
// Steps are guessed in single precision: of leftovers that are a part of something (of the energy, of the area) its rounding comes.
const LEAST_LEFT = 2 ** -24;
// What two machines differ in.
const OWN = /seconds|platform|speed|sha256/;

// Asserts that every number is the same but for rounding, every word and every count exactly. `answer` is the number that this
// one is a part of: the end of an interval and a part of an uncertainty are differences of answers, and known as well as these.
export function numbers(found, expected, path = '', answer = 0) {
  if (OWN.test(path)) return 0;
  if (expected === null || typeof expected === 'string' || typeof expected === 'boolean') {
    if (typeof expected === 'string' && /message|text|claim/.test(path)) return 0; // these are compared as printed
    assert.equal(found, expected, path);
    return 0;
  }
  if (typeof expected === 'number') {
    const off = Math.abs(found - expected), size = Math.max(Math.abs(found), Math.abs(expected));
    if (Number.isInteger(expected) && Math.abs(expected) < 1e9) { assert.equal(found, expected, path); return 1; }
    const limit = LEFT_OVER.test(path) ? Math.max(LEFT_OVER_ROUNDING * size, LEAST_LEFT * Math.max(1, answer)) : ROUNDING * Math.max(size, answer);
    assert.ok(off <= limit, `${path}: ${found} in the page, ${expected} by the command`);
    return 1;
  }
  assert.deepEqual(Object.keys(found), Object.keys(expected), path);
  const part = key => {
    if (/interval$/.test(path)) {
      const ends = expected.filter(end => end !== null).map(Math.abs);
      // The load over an end of the area, which is known as well as the upper end of that.
      return /pressure_interval$/.test(path) ? expected[key] ** 2 / Math.min(...ends) : Math.max(...ends);
    }
    if (key !== 'budget' || !expected.budget) return answer;
    return { area: expected.area_fraction, mean_gap: expected.mean_gap, stiffness: expected.stiffness };
  };
  const of = key => (/budget$/.test(path) ? Math.abs(answer[key] || 0) : part(key));
  const seen = Object.keys(expected).map(key => numbers(found[key], expected[key], `${path}/${key}`, of(key)));
  return seen.reduce((a, b) => a + b, 0);
}

// The words and numbers that the report shows, without what a machine, a clock and a path make different.
export function printed(html) {
  const body = html.replace(/<script[\s\S]*?<\/script>/g, '').replace(/<svg[\s\S]*?<\/svg>/g, '').replace(/<style[\s\S]*?<\/style>/g, '');
  const text = body.replace(/<[^>]+>/g, '\n').replace(/[ \u202f\u00a0]/g, ' ').split('\n').map(line => line.trim()).filter(Boolean);
  const time = /(at most )?\b\d[\d.]* ?(ns|µs|ms|s|min|h)\b/g;
  const ratios = [/\b[\d.,  ]+(million |billion |thousand )?times faster/g, /they take [\d.]+ % of the time/g, /[\d.]+ times (slower|the time)/g];
  // Which of two that take nanoseconds is the cheaper one is said by the clock.
  ratios.push(/(?<=^Cheapest closed form within 10 %: ).*$/);
  const still = line => ratios.reduce((l, ratio) => l.replace(ratio, '…'), line).replace(time, '…');
  const own = /^Repeat|rough-contact compare|rough-contact \d|linux|wasi|wasm|\d{1,2} \w+ 20\d\d/i;
  return text.map(still).filter(line => !own.test(line)).join('\n');
}
