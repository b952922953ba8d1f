// The contact map at every load of the slider, and as near as its points.
(function () {
'use strict';
const NEAREST = 8; // points across at least
const make = (tag, className, parent) => { const e = document.createElement(tag); e.className = className; if (parent) parent.append(e); return e; };
// Red, green and blue in the order of bytes that a picture has.
const pixels = rgb => Uint32Array.from({ length: rgb.length / 3 }, (_, i) => new Uint32Array(Uint8Array.of(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255).buffer)[0]);
const bytes = hex => Uint8Array.from(hex.match(/../g), pair => parseInt(pair, 16));

document.querySelectorAll('img.first').forEach(first => {
  const section = first.closest('[data-loads]'), facts = JSON.parse(first.dataset.facts);
  // The pressure of the load shown first in the dots of the contact; of others in squares of points.
  const pressures = section.querySelector('img.pressure'), pressed = new Map([...section.querySelectorAll('img.pressed')].map(image => [+image.dataset.load, image])), ramp = pixels(bytes(facts.ramp)), [colour] = pixels(facts.colour);
  const cut = section.querySelector('span.cut'), line = cut && JSON.parse(cut.dataset.facts).row;
  const reliefs = [...section.querySelectorAll('img.relief')];
  let load = +section.querySelector('.dial input').value, home = true, loads, pressure, height, width, spread = { load: -1, classes: null };
  const greys = image => {
    const canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, canvas.width, canvas.height).data.filter((_, i) => i % 4 === 0);
  };
  // Once something is asked for that the pictures do not show.
  let reading = null;
  const read = () => reading = reading || Promise.all([first, pressures, ...pressed.values(), ...reliefs].map(image => image.decode())).then(() => {
    [height, width] = [first.naturalHeight, first.naturalWidth];
    [loads, pressure] = [greys(first), greys(pressures)];
  });

  // For each dot the highest class of the squares that its points lie in; without a picture nothing.
  function classes() {
    if (home) return pressure;
    const image = pressed.get(load);
    if (!image || spread.load === load) return image ? spread.classes : null;
    const squares = greys(image), all = new Uint8Array(height * width), [ny, nx] = facts.points;
    const span = (i, n, m) => [Math.floor(i * n / m), Math.ceil((i + 1) * n / m) - 1].map(point => Math.floor(point / facts.block));
    const across = Array.from({ length: width }, (_, x) => span(x, nx, width));
    for (let y = 0, j = 0; y < height; y++) {
      const [top, bottom] = span(y, ny, height);
      for (let x = 0; x < width; x++, j++) for (let sy = top; sy <= bottom; sy++) for (let sx = across[x][0]; sx <= across[x][1]; sx++) {
        all[j] = Math.max(all[j], squares[sy * image.naturalWidth + sx]);
      }
    }
    spread = { load, classes: all };
    return all;
  }

  // One for the whole map, one for its enlargement. A part is [top, left, height, width] as shares of the map.
  const figures = reliefs.map(relief => {
    const figure = relief.closest('figure'), svg = figure.querySelector('svg'), image = svg.querySelector('image');
    const [wide, high] = ['width', 'height'].map(side => +image.getAttribute(side)), holder = make('div', 'pane');
    svg.replaceWith(holder);
    holder.append(svg);
    const over = make('div', 'over-map', holder);
    over.style.width = 100 * wide / svg.viewBox.baseVal.width + '%';
    over.style.aspectRatio = wide + '/' + high;
    const f = { figure, over, relief, canvas: make('canvas', 'px moving', over), legend: svg.querySelector('.legend'), end: svg.querySelector('.legend text:nth-of-type(2)'), whole: figure.contains(first) };
    f.still = f.end && f.end.textContent;
    f.part = f.given = relief.dataset.part.split(' ').map(Number);
    f.marks = (f.whole ? reliefs.filter(r => r !== relief).map(r => ['boxed', r.dataset.part.split(' ').map(Number)]) : [])
      .concat(line === null || line === undefined ? [] : [['along', [line, 0, 0, 1]]]).map(([name, at]) => ({ at, e: make('i', name, over) }));
    f.scale = make('span', 'scale', over);
    return f;
  });
  const map = figures.find(f => f.whole), svg = map.figure.querySelector('svg'), said = svg.querySelector('title').textContent;
  const zoomed = () => map.part[3] < 1 || map.part[2] < 1;

  // The points that a part covers: a part of the whole map always begins and ends between two points.
  const points = ([y, x, h, w]) => [Math.round(y * height), Math.round(x * width), Math.max(1, Math.round(h * height)), Math.max(1, Math.round(w * width))];
  function draw(f) {
    const [y0, x0, h, w] = points(f.part), pen = f.canvas.getContext('2d'), given = f.given;
    const behind = [(f.part[1] - given[1]) / given[3], (f.part[0] - given[0]) / given[2], f.part[3] / given[3], f.part[2] / given[2]];
    [f.canvas.width, f.canvas.height] = [w, h];
    pen.drawImage(f.relief, behind[0] * f.relief.naturalWidth, behind[1] * f.relief.naturalHeight, behind[2] * f.relief.naturalWidth, behind[3] * f.relief.naturalHeight, 0, 0, w, h);
    const picture = pen.getImageData(0, 0, w, h), to = new Uint32Array(picture.data.buffer), most = load * facts.step, colours = classes();
    const held = loads.slice(); // of this load: where a point has come off again, it does not touch
    facts.lost.forEach(([at, point]) => { if (at === load) held[point] = 255; });
    for (let y = 0; y < h; y++) for (let x = 0, from = (y0 + y) * width + x0, j = y * w; x < w; x++, from++, j++) {
      if (held[from] <= most) to[j] = colours ? ramp[colours[from]] : colour;
    }
    pen.putImageData(picture, 0, 0);
    // Points larger than pixels are squares; smaller ones share a pixel.
    f.canvas.classList.toggle('squares', w <= f.over.clientWidth * devicePixelRatio);
    const [py, px, ph, pw] = [y0 / height, x0 / width, h / height, w / width];
    f.marks.forEach(({ at, e }) => Object.assign(e.style, { top: 100 * (at[0] - py) / ph + '%', left: 100 * (at[1] - px) / pw + '%', height: 100 * at[2] / ph + '%', width: 100 * at[3] / pw + '%' }));
    const across = pw * facts.across, power = 10 ** Math.floor(Math.log10(across / 3)), length = [5, 2, 1].find(m => m * power <= across / 3) * power;
    f.scale.textContent = +length.toPrecision(1) + '\u202F' + facts.unit;
    f.scale.style.setProperty('--bar', 100 * length / across + 'cqw');
  }
  function show() {
    const drawn = !home || zoomed();
    const again = () => figures.forEach(f => {
      const on = !home || (f.whole && zoomed());
      f.over.classList.toggle('on', on);
      if (f.legend) {
        f.legend.setAttribute('visibility', home || pressed.has(load) ? 'visible' : 'hidden');
        f.end.textContent = (!home && facts.tops[load]) || f.still;
      }
      if (on) draw(f);
    });
    svg.querySelector('title').textContent = home ? said : facts.titles[load];
    map.over.setAttribute('aria-label', facts.titles[load]);
    if (drawn) read().then(again); else again();
  }
  section.addEventListener('read-off', e => { ({ load, home } = e.detail); show(); });

  // Nearer: by buttons, wheel with Ctrl, two fingers, keys. What is shown is a whole number of points.
  const bar = make('div', 'zoom'), button = (text, name, act) => {
    const b = make('button', '', bar);
    Object.assign(b, { type: 'button', textContent: text, onclick: act });
    b.setAttribute('aria-label', name);
    return b;
  };
  const out = button('−', 'Zoom out', () => zoom(1 / 1.6)), near = button('+', 'Zoom in', () => zoom(1.6)), all = button('whole map', 'Whole map', () => zoom(0));
  const say = make('span', 'near', bar);
  map.figure.querySelector('.pane').after(bar);
  map.over.tabIndex = 0;
  map.over.setAttribute('role', 'img');
  function look([y, x, h, w]) {
    const whole = Math.min(first.naturalHeight, first.naturalWidth), [ny, nx] = [first.naturalHeight, first.naturalWidth];
    const least = Math.min(1, NEAREST / whole), size = Math.max(least, Math.min(1, w));
    const [rows, columns] = [Math.max(1, Math.round(size * ny)), Math.max(1, Math.round(size * nx))];
    const place = (at, n, of) => Math.max(0, Math.min(of - n, Math.round(at * of)));
    map.part = [place(y, rows, ny) / ny, place(x, columns, nx) / nx, rows / ny, columns / nx];
    [out.disabled, all.disabled, near.disabled] = [!zoomed(), !zoomed(), size <= least];
    say.textContent = zoomed() ? columns + ' × ' + rows + ' of ' + nx + ' × ' + ny + ' points' : '';
    map.over.classList.toggle('near', zoomed());
    show();
    section.dispatchEvent(new CustomEvent('look', { detail: { from: map.part[1], to: map.part[1] + map.part[3] } }));
  }
  // `times` nearer around a place of what is seen; 0 is the whole map.
  function zoom(times, cx = 0.5, cy = 0.5) {
    const [y, x, h, w] = map.part, size = times ? Math.min(1, w / times) : 1;
    look([y + cy * (h - size), x + cx * (w - size), size, size]);
  }
  const move = (dy, dx) => look([map.part[0] + dy * map.part[2], map.part[1] + dx * map.part[3], map.part[2], map.part[3]]);
  const place = e => { const box = map.over.getBoundingClientRect(); return [(e.clientX - box.left) / box.width, (e.clientY - box.top) / box.height, box]; };
  map.over.addEventListener('wheel', e => {
    if (!e.ctrlKey && !e.metaKey) return;
    e.preventDefault();
    zoom(Math.exp(-e.deltaY / 250), ...place(e).slice(0, 2));
  }, { passive: false });
  const fingers = new Map();
  let drag = null; // where the map was when the fingers came down, not rounded on the way
  const begin = () => { drag = fingers.size ? { part: map.part, at: [...fingers.values()].map(f => place(f).slice(0, 2)) } : null; };
  map.over.addEventListener('pointerdown', e => { fingers.set(e.pointerId, e); map.over.setPointerCapture(e.pointerId); begin(); });
  ['pointerup', 'pointercancel'].forEach(type => map.over.addEventListener(type, e => { fingers.delete(e.pointerId); begin(); }));
  map.over.addEventListener('pointermove', e => {
    if (!fingers.has(e.pointerId)) return;
    fingers.set(e.pointerId, e);
    const now = [...fingers.values()].map(f => place(f).slice(0, 2)), [y, x, h, w] = drag.part, [a, b] = drag.at;
    if (now.length === 1 && zoomed()) look([y - (now[0][1] - a[1]) * h, x - (now[0][0] - a[0]) * w, h, w]);
    if (now.length !== 2) return;
    const apart = ([p, q]) => Math.hypot(p[0] - q[0], p[1] - q[1]), middle = ([p, q]) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const size = Math.min(1, w * apart([a, b]) / Math.max(1e-3, apart(now))), [mx, my] = middle([a, b]), [nx, ny] = middle(now);
    look([y + my * h - ny * size, x + mx * w - nx * size, size, size]);
  });
  map.over.addEventListener('keydown', e => {
    const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[e.key];
    if (step && zoomed()) move(step[0] / 8, step[1] / 8);
    else if (e.key === '+' || e.key === '=') zoom(1.6);
    else if (e.key === '-') zoom(1 / 1.6);
    else if (e.key === '0') zoom(0);
    else return;
    e.preventDefault();
  });
  let kept = null;
  addEventListener('beforeprint', () => { kept = map.part; zoom(0); });
  addEventListener('afterprint', () => { if (kept) look(kept); });
  first.decode().then(() => zoom(0));
});
})();
