// Puts the page together when it is opened.
'use strict';

document.addEventListener('click', e => { const to = e.target.closest('[data-go]'); if (to) go(to.dataset.go); });

function example(one) {
  const choose = async () => {
    Object.assign(now, { file: null, example: one.name, reading: {}, remedies: {}, plan: null, read: null, answer: null, last: choose });
    $('bodies-file').textContent = `${one.name} · ${one.size} · ${one.points}`;
    go('bodies');
    const made = await engine.ask('inspect', request());
    if (!made) return;
    if (made.kind !== 'done') { fail(made); return; }
    now.plan = made.plan;
    plan();
  };
  return part('button', { type: 'button', 'data-example': one.name, onclick: choose },
    part('img', { className: 'px', alt: '', src: one.picture }),
    part('span', {}, part('b', {}, one.name), one.description, part('br'), part('small', {}, `${one.size}, ${one.points}`)));
}

async function begin() {
  wireSurface();
  wireRunning();
  $('bodies-back').onclick = () => go(now.read ? 'read' : 'empty');
  addEventListener('state', e => {
    if (e.detail === 'read' && !now.read.areas) areas();
    if (e.detail === 'bodies' && now.file) { $('bodies-file').textContent = now.read ? now.read.about : ''; plan(); }
  });
  addEventListener('hashchange', show);
  if (location.hash && location.hash !== '#empty') history.replaceState(null, '', '#empty');
  show();
  try {
    await engine.start();
  } catch (e) {
    fail({
      heading: 'This browser cannot run WebAssembly.', text: 'The page computes with it.',
      ways: ['Any current Edge, Chrome, Firefox or Safari can.', 'The command rough-contact needs no browser.'], detail: String(e),
    });
    return;
  }
  const start = await engine.ask('start', {});
  if (!start || start.kind !== 'done') { fail(start || { kind: 'died' }); return; }
  now.place = start.place;
  const names = start.formats.map(f => f.name);
  $('formats').textContent = `${names.slice(0, 12).join(', ')} and ${names.length - 12} others: recognised by content, not by name.`;
  $('formats').title = names.join(', ');
  $('version').textContent = `rough-contact ${start.version}.`;
  $('examples').replaceChildren(...start.examples.map(example));
  buildBodies(start.materials);
  restore();
  document.documentElement.dataset.ready = 'true';
}
begin();
