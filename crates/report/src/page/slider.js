// The load read off: slider, numbers, dotted lines, and over a curve what every model says there. Played, it runs from load
// to load; never by itself, and not where less motion is wanted.
(function () {
'use strict';
const root = document.documentElement;
root.classList.add('js');
const list = document.createElement('div');
Object.assign(list, { className: 'values', hidden: true });
list.setAttribute('aria-hidden', 'true'); // the same numbers stand in the table and in the read-out
document.body.append(list);
addEventListener('pointerdown', e => { if (!e.target.closest('svg')) list.hidden = true; });

const less = matchMedia('(prefers-reduced-motion: reduce)'), PACE = 700; // milliseconds a load

document.querySelectorAll('[data-loads]').forEach(section => {
  const element = section.querySelector('script[type="application/json"]'), range = section.querySelector('.dial input');
  if (!element || !range) return; // one load: nothing moves
  const data = JSON.parse(element.textContent), last = data.read.length - 1, home = +range.value;
  const lines = section.querySelectorAll('.cur'), out = section.querySelector('.dial output');
  let at = home;
  function set(load) {
    at = Math.max(0, Math.min(last, Math.round(load)));
    range.value = at;
    range.setAttribute('aria-valuetext', data.read[at]);
    out.textContent = data.read[at];
    lines.forEach(line => line.setAttribute('transform', 'translate(' + line.dataset.x.split(' ')[at] + ' 0)'));
    section.querySelectorAll('[data-k]').forEach(e => { const cells = data.cells[e.dataset.k]; if (cells) e.textContent = cells[at]; });
    section.dispatchEvent(new CustomEvent('read-off', { detail: { load: at, home: at === home } }));
  }
  const play = section.querySelector('.dial .play');
  let clock = 0;
  function stop() {
    clearInterval(clock);
    clock = 0;
    play.textContent = 'Play';
  }
  function start() {
    if (less.matches) return;
    play.textContent = 'Stop';
    set(at === last ? 0 : at + 1);
    clock = setInterval(() => { if (at === last) stop(); else set(at + 1); }, PACE);
  }
  play.addEventListener('click', () => { if (clock) stop(); else start(); });
  less.addEventListener('change', stop);
  addEventListener('keydown', e => { if (e.key === 'Escape') stop(); });
  range.addEventListener('input', () => { stop(); set(+range.value); });
  section.querySelector('.dial .back').addEventListener('click', () => { stop(); set(home); });
  let kept = home;
  addEventListener('beforeprint', () => { stop(); kept = at; list.hidden = true; set(home); });
  addEventListener('afterprint', () => set(kept));

  // What each model says at this load, beside the point (x, y) of the window.
  function tell({ v: letter, of }, x, y) {
    const rows = data.models.filter(m => m.of === of && data.cells[letter + '-' + m.name]).map(m => {
      const row = document.createElement('div');
      row.style.color = 'var(--' + m.class + ')';
      if (m.name !== 'det' && m.name !== 'elastic') row.dataset.m = m.name;
      [m.label, data.cells[letter + '-' + m.name][at]].forEach(text => row.append(Object.assign(document.createElement('span'), { textContent: text })));
      return row;
    });
    const head = document.createElement('b');
    head.textContent = data.cells.load[at];
    list.replaceChildren(head, ...rows);
    list.hidden = false;
    root.dispatchEvent(new CustomEvent('drawn'));
    const wide = list.offsetWidth, right = x + 18 + wide <= root.clientWidth;
    list.style.left = Math.max(4, right ? x + 18 : x - 18 - wide) + scrollX + 'px';
    list.style.top = Math.max(4, Math.min(y - 30, root.clientHeight - list.offsetHeight - 4)) + scrollY + 'px';
  }
  lines.forEach(line => {
    const svg = line.ownerSVGElement, places = line.dataset.x.split(' ').map(Number);
    let before = null; // the load to go back to when the mouse leaves
    svg.tabIndex = 0;
    const scale = () => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    function focused() {
      const box = svg.getBoundingClientRect();
      tell(line.dataset, box.left + places[at] * scale(), box.top + 60);
    }
    function point(e) {
      const x = (e.clientX - svg.getBoundingClientRect().left) / scale();
      if (x < places[0] - 6 || x > places[last] + 6) { if (e.pointerType === 'mouse') leave(e); return; }
      let nearest = 0;
      places.forEach((place, i) => { if (Math.abs(place - x) < Math.abs(places[nearest] - x)) nearest = i; });
      stop();
      if (before === null) before = at;
      if (nearest !== at) set(nearest);
      tell(line.dataset, e.clientX, e.clientY);
    }
    function leave(e) {
      if (e.pointerType !== 'mouse') return; // what a finger showed stays
      list.hidden = true;
      if (before !== null) set(before);
      before = null;
    }
    svg.addEventListener('pointermove', point);
    svg.addEventListener('pointerdown', e => { point(e); before = null; });
    svg.addEventListener('pointerleave', leave);
    svg.addEventListener('focus', () => { if (svg.matches(':focus-visible')) focused(); });
    svg.addEventListener('blur', () => { list.hidden = true; });
    svg.addEventListener('keydown', e => {
      const to = { ArrowLeft: at - 1, ArrowDown: at - 1, ArrowRight: at + 1, ArrowUp: at + 1, Home: 0, End: last }[e.key];
      if (e.key === 'Escape') { list.hidden = true; return; }
      if (to === undefined) return;
      e.preventDefault();
      stop();
      before = null;
      set(to);
      focused();
    });
  });
});
})();
