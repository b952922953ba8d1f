// The section through the contact at the load read off, along the part of the map that is seen.
(function () {
'use strict';
const bytes = text => Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
const sixteen = text => { const view = new DataView(bytes(text).buffer); return Array.from({ length: view.byteLength / 2 }, (_, i) => view.getUint16(2 * i, true)); };
const short = value => String(+value.toFixed(2));

document.querySelectorAll('span.cut').forEach(span => {
  const section = span.closest('[data-loads]'), figure = span.closest('figure'), svg = figure.querySelector('svg');
  const facts = JSON.parse(span.dataset.facts), { box: [left, top, right, bottom], heights: [low, high], length } = facts.scales;
  const still = svg.innerHTML, tall = figure.querySelector('.tall'), said = tall.textContent;
  let heights, gaps, pressures, load = +section.querySelector('.dial input').value, home = true, from = 0, to = 1, part = false;
  function draw() {
    const whole = from <= 0 && to >= 1;
    if (whole && (home || part)) { svg.innerHTML = still; tall.textContent = said; }
    part = !whole;
    if (home && whole) return;
    if (!heights) [heights, gaps, pressures] = [sixteen(facts.heights), sixteen(facts.gaps), bytes(facts.pressures)];
    const n = heights.length, flat = facts.flats[load], of = name => svg.querySelector('.' + name);
    const begin = Math.max(0, Math.floor(from * n) - 1), end = Math.min(n, Math.ceil(to * n) + 1);
    const x = place => left + (place / n - from) / (to - from) * (right - left), y = z => bottom - (z - low) / (high - low) * (bottom - top);
    const line = height => { let d = ''; for (let i = begin; i < end; i++) d += (d ? 'L' : 'M') + short(x(i + 0.5)) + ' ' + short(y(height(i))); return d; };
    const body = line(i => flat - facts.step * gaps[load * n + i]), level = short(y(flat));
    of('before').firstChild.setAttribute('d', line(i => facts.low + facts.step * heights[i]));
    of('pressed').firstChild.setAttribute('d', body);
    of('body').firstChild.setAttribute('d', body + 'L' + short(x(end - 0.5)) + ' ' + bottom + 'L' + short(x(begin + 0.5)) + ' ' + bottom + 'Z');
    of('above').firstChild.setAttribute('height', short(y(flat) - top));
    ['y1', 'y2'].forEach(name => of('flat').firstChild.setAttribute(name, level));
    of('name').firstChild.setAttribute('y', short(Math.max(top + 9, y(flat) - 6)));
    let marks = '';
    for (let i = begin, run = 0; i < end; i = run) {
      const p = pressures[load * n + i];
      for (run = i + 1; run < end && pressures[load * n + run] === p;) run++;
      if (p) marks += '<path d="M' + short(x(i)) + ' ' + level + 'H' + short(x(run)) + '" stroke="#' + facts.colours.substr(6 * (p - 1), 6) + '" stroke-width="5"/>';
    }
    of('touching').innerHTML = marks;
    svg.querySelector('desc').textContent = facts.titles[load];
    if (whole) return;
    // Ticks of the part that is seen; the vertical axis stays.
    const across = of('across'), [grid, ticks] = across.querySelectorAll('path'), texts = across.querySelectorAll('text'), model = texts[0].cloneNode();
    const span = (to - from) * length, power = 10 ** Math.floor(Math.log10(span / 5)), step = [1, 2, 5, 10].find(m => m * power >= span / 5) * power;
    const numbers = [];
    for (let k = Math.ceil(from * length / step); k * step <= to * length; k++) numbers.push(k * step);
    const lines = (begin, end) => numbers.map(v => 'M' + short(x(v / length * n)) + ' ' + begin + 'V' + end).join('');
    grid.setAttribute('d', lines(top, bottom));
    ticks.setAttribute('d', lines(bottom, bottom + 3.5));
    texts.forEach(text => text.remove());
    numbers.forEach(v => {
      const text = model.cloneNode();
      text.setAttribute('x', short(x(v / length * n)));
      text.textContent = +v.toPrecision(6);
      across.append(text);
    });
    tall.textContent = +(facts.tall * (to - from)).toPrecision(2);
  }
  section.addEventListener('read-off', e => { ({ load, home } = e.detail); draw(); });
  section.addEventListener('look', e => { ({ from, to } = e.detail); draw(); });
});
})();
