// Small things that every state of the page uses. Text from files goes in as text, never as markup.
'use strict';
const $ = id => document.getElementById(id);
const all = selector => [...document.querySelectorAll(selector)];

// An element with properties and children; text stays text.
function part(name, properties, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties || {})) {
    if (key.startsWith('data-') || key.startsWith('aria-') || key === 'role' || key === 'for' || key === 'scope') made.setAttribute(key, value);
    else made[key] = value;
  }
  made.append(...children.filter(c => c !== null && c !== undefined));
  return made;
}

// A heading of pieces, some of them bold.
function headed(heading, pieces) {
  heading.replaceChildren(...pieces.map(([text, bold]) => bold ? part('b', {}, text) : text));
}

// Names as they may stand on a page: no controls, none that turn the direction of writing, cut in the middle.
function shownName(name) {
  const clean = name.replace(/[\u0000-\u001f\u007f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, '');
  return clean.length <= 80 ? clean : clean.slice(0, 40) + '…' + clean.slice(-39);
}

// What the page knows; the file itself stays where it is until it is asked for.
const now = {
  file: null, example: null, reading: {}, remedies: {}, plan: null, read: null, answer: null, stopped: null, place: null, pace: null,
};
const engine = new Engine();

function request(more) {
  return {
    name: now.file ? shownName(now.file.name) : '', example: now.example,
    reading: now.reading, remedies: now.remedies, ...more,
  };
}

// One state at a time. The address names it, so Back works; focus goes to the new heading.
const STATES = ['empty', 'read', 'ask', 'bodies', 'running', 'result', 'error'];
let current = 'empty';
function go(state) {
  if (location.hash.slice(1) === state) show(); else location.hash = state;
}

function show() {
  const wanted = location.hash.slice(1);
  // What is not there yet, or no longer, cannot be gone back to.
  const there = { read: now.read, ask: now.file, bodies: now.file || now.example, running: engine.running, result: now.answer, error: now.error };
  const state = STATES.includes(wanted) && (wanted === 'empty' || there[wanted]) ? wanted : 'empty';
  if (current === 'running' && state !== 'running' && engine.running) stopRunning();
  current = state;
  STATES.forEach(name => $('s-' + name).classList.toggle('on', name === state));
  // Steps that were passed lead back; not while it computes, which a slip would end.
  const ways = [now.read ? 'read' : 'empty', 'bodies', 'result'], open = [true, there.bodies, there.result];
  all('.steps li').forEach((step, i) => {
    const text = step.textContent, here = step.dataset.s.split(' ').includes(state);
    step.replaceChildren(open[i] && !here && state !== 'running' ? part('a', { href: '#' + ways[i] }, text) : text);
    if (step.dataset.s.split(' ').includes(state)) step.setAttribute('aria-current', 'step');
    else step.removeAttribute('aria-current');
  });
  $('s-' + state).querySelector('h1').focus({ preventScroll: true });
  scrollTo(0, 0);
  dispatchEvent(new CustomEvent('state', { detail: state }));
}

// What happened, its effect, what to do; the line for a bug report stays closed.
function fail(answer) {
  const died = answer.kind === 'died';
  now.error = true;
  $('h-error').textContent = died ? 'The computation stopped without saying why.' : answer.heading;
  $('e-text').textContent = died
    ? `Your file and settings are still here. ${now.place ? now.place.died : ''}` : answer.text;
  $('e-ways').replaceChildren(...(answer.ways || []).map(way => part('li', {}, way)));
  $('e-detail').textContent = answer.detail || '';
  const buttons = [];
  const button = (text, act, first) => buttons.push(part('button', { type: 'button', className: first ? 'go' : '', onclick: act }, text));
  if (died && now.last) button('Try again', now.last, true);
  if (now.read) button('Look at the file again', () => go('read'));
  if (now.example || now.read) button('Other bodies or loads', () => go('bodies'));
  button('Choose another file', () => go('empty'), !died);
  $('e-act').replaceChildren(...buttons);
  go('error');
}
