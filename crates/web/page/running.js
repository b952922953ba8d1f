// The computation: load by load, cancelled or stopped, and the report at its end.
'use strict';

const STEPS = ['Read and cleaned', 'Contact', 'Closed formulas', 'How accurate it is', 'Report'];
const STAGES = { read: 1, loads: 1, iteration: 1, load: 1, models: 2, accuracy: 3, report: 4 };
let run = null;

async function compute(more) {
  const settings = { ...asked(), ...more };
  now.last = () => compute(more);
  run = { begun: performance.now(), first: null, loads: 0, done: [], stage: 0, settings };
  engine.running = true;
  now.answer = null;
  $('run-file').textContent = `${now.example || shownName(now.file.name)} · ${pair()}`;
  $('stop').disabled = true;
  $('r-contact').hidden = true;
  draw();
  go('running');
  const own = run;
  const answer = await engine.ask('run', request(settings), now.file, hear);
  if (run !== own) return;
  engine.running = false;
  $('asking').hidden = true;
  if (!answer) return;
  if (answer.kind !== 'done') { fail(answer); return; }
  now.answer = answer;
  showResult(answer);
}

function hear(news) {
  run.stage = Math.max(run.stage, STAGES[news.stage] ?? 0);
  if (news.stage === 'loads') { run.loads = news.count; run.first = performance.now(); }
  if (news.stage === 'iteration') run.part = news.share;
  if (news.stage === 'load') {
    // Of the pictures only the last is kept.
    const { map, ...load } = news;
    run.done.push(load);
    showMap(load, map);
    run.part = 0;
    if (run.done.length % 5 === 0) $('r-live').textContent = `${run.done.length} of ${run.loads} loads done`;
  }
  $('stop').disabled = run.done.length === 0 || run.stage > 1 || Boolean(run.settings.kept);
  draw();
}

function showMap(load, map) {
  $('r-contact').hidden = !map;
  if (!map) return;
  $('r-map').src = map.picture;
  $('r-map').alt = `Contact map at ${load.at}: ${load.touches || 'nothing'} of the area touches`;
  $('r-at').textContent = load.at;
  $('r-top').textContent = map.top;
}

// Gives the memory back; file, remedies and settings stay.
function stopRunning() {
  run = null;
  engine.running = false;
  engine.cancel();
}

function cancel() {
  stopRunning();
  go('bodies');
}

// Nothing is kept beside the page, and WebAssembly cannot be told to stop from outside: the loads that are done are
// solved once more, and only they.
function stopAndKeep() {
  const kept = run.done.filter(load => load.area !== null).map(load => load.pressure);
  const of = run.loads;
  stopRunning();
  now.stopped = `Stopped after ${kept.length} of ${of} loads; the report is of these.`;
  compute({ load: { by: 'pressure', list: kept.map(p => p + 'Pa').join(','), area: '' } });
}

function draw() {
  if (!run) return;
  const last = run.done[run.done.length - 1], count = run.loads || 1;
  headed($('h-run'), last && last.touches ? [[`At ${last.at}, `, false], [last.touches, true], [' touches so far', false]] : [['Computing', false]]);
  const share = run.stage > 1 ? 1 : (run.done.length + (run.part || 0)) / count;
  $('bar').value = 0.85 * share + 0.05 * Math.max(0, run.stage - 1);
  $('r-left').textContent = left(share, count);
  $('todo').replaceChildren(...STEPS.map((text, i) => part('li', { className: i < run.stage ? 'done' : i === run.stage ? 'now' : '' },
    text, i === 1 && run.loads ? part('span', {}, `${run.done.length} of ${run.loads} loads`) : null)));
  $('r-curve').innerHTML = curve();
}

// From measured loads alone.
function left(share, count) {
  if (run.stage > 1) return 'All loads done; formulas, accuracy and report follow.';
  if (!run.first || run.done.length === 0) return 'The time left is said after the first load.';
  const seconds = (performance.now() - run.first) / 1e3 * (1 - share) / share * 1.3;
  return `${run.done.length} of ${count} loads; about ${seconds < 10 ? Math.max(1, Math.ceil(seconds)) : Number(seconds.toPrecision(2))} s left`;
}

// Area over pressure on logarithmic axes; numbers only, so it may be markup.
function curve() {
  const [w, h, left, bottom, top, right] = [448, 300, 48, 42, 10, 12];
  const points = run.done.filter(load => load.area > 0);
  if (points.length === 0) return `<svg viewBox="0 0 ${w} ${h}" role="img" aria-label="No load is done yet"></svg>`;
  const decades = values => [Math.floor(Math.log10(Math.min(...values)) + 1e-9), Math.ceil(Math.log10(Math.max(...values)) + 1e-9)];
  let [x0, x1] = decades(points.map(p => p.pressure)), [y0, y1] = decades(points.map(p => p.area));
  x1 = Math.max(x1, x0 + 1); y1 = Math.max(y1, y0 + 1);
  const x = p => left + (Math.log10(p) - x0) / (x1 - x0) * (w - left - right);
  const y = a => h - bottom - (Math.log10(a) - y0) / (y1 - y0) * (h - bottom - top);
  const unit = x0 >= 6 ? [1e6, 'MPa'] : x0 >= 3 ? [1e3, 'kPa'] : [1, 'Pa'];
  let s = '';
  for (let d = x0; d <= x1; d++) s += `<path class="s-grid" d="M${x(10 ** d)} ${top}V${h - bottom}"/><text class="f-ink2" x="${x(10 ** d)}" y="${h - bottom + 17}" text-anchor="middle">${+(10 ** d / unit[0]).toPrecision(3)}</text>`;
  for (let d = y0; d <= y1; d++) s += `<path class="s-grid" d="M${left} ${y(10 ** d)}H${w - right}"/><text class="f-ink2" x="${left - 6}" y="${y(10 ** d) + 4}" text-anchor="end">${+(100 * 10 ** d).toPrecision(3)}</text>`;
  const line = points.map(p => `${x(p.pressure).toFixed(1)} ${y(p.area).toFixed(1)}`).join('L');
  s += `<path class="s-det" fill="none" stroke-width="2.4" d="M${line}"/>` + points.map(p => `<circle class="f-det" cx="${x(p.pressure)}" cy="${y(p.area)}" r="3.6"/>`).join('');
  return `<svg viewBox="0 0 ${w} ${h}" role="img" aria-label="Real contact area, ${points.length} of ${run.loads} loads" font-size="13">${s}<text class="f-ink" x="${(w + left) / 2}" y="${h - 4}" text-anchor="middle">Nominal pressure (${unit[1]})</text><text class="f-ink" transform="translate(12 ${h / 2 - 12}) rotate(-90)" text-anchor="middle">Real contact area (%)</text></svg>`;
}

// The report is the file that is saved, the same bytes; the page adds nothing inside. A copy for the frame tells its height.
const TELLER = '<script>(()=>{const tell=()=>parent.postMessage({height:document.documentElement.scrollHeight},"*");new ResizeObserver(tell).observe(document.body);tell()})()</' + 'script>';
function showResult(answer) {
  const report = answer.files['report.html'];
  $('h-result').textContent = answer.headline || 'Result';
  $('result-note').textContent = [now.stopped, `Computed in ${answer.seconds.toPrecision(2)} s.`].filter(Boolean).join(' ');
  now.stopped = null;
  $('result-trouble').hidden = !answer.trouble;
  $('result-trouble').textContent = answer.trouble ? answer.trouble.message : '';
  $('report').srcdoc = report.replace('</body>', () => TELLER + '</body>');
  run = null;
  go('result');
}

function save(name) {
  const types = { html: 'text/html', json: 'application/json', csv: 'text/csv', toml: 'application/toml' };
  const stem = (now.example || shownName(now.file.name)).replace(/[^\p{L}\p{N}._-]+/gu, '-');
  const link = part('a', { download: `${stem}-${name}`, href: URL.createObjectURL(new Blob([now.answer.files[name]], { type: types[name.split('.').pop()] })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function wireRunning() {
  addEventListener('message', ({ data, source }) => {
    const height = data && data.height;
    if (source === $('report').contentWindow && typeof height === 'number' && height > 0 && height < 200000) $('report').style.height = Math.ceil(height) + 'px';
  });
  $('stop').onclick = stopAndKeep;
  $('cancel').onclick = cancel;
  $('compute').onclick = $('compute-now').onclick = () => { now.stopped = null; compute(); };
  all('[data-save]').forEach(button => { button.onclick = () => save(button.dataset.save); });
}
