// From a file to a map: reading, units that it does not say, its defects.
'use strict';

function take(file) {
  if (!file) return;
  if (engine.running) {
    now.waiting = file;
    $('asking-text').textContent = `Stop this and read ${shownName(file.name)}?`;
    $('asking').hidden = false;
    $('asking-yes').focus();
    return;
  }
  Object.assign(now, { file, example: null, reading: {}, remedies: {}, plan: null, read: null, answer: null });
  look();
}

// Reads the file with what is said and ticked so far.
async function look() {
  now.last = look;
  const text = `Reading ${shownName(now.file.name)}, ${megabytes(now.file.size)}`;
  const patience = setTimeout(() => {
    $('reading-text').textContent = text;
    $('reading').hidden = false;
  }, 300);
  $('defects').classList.add('wait');
  const answer = now.file.size > now.place.most_bytes ? tooBig(now.file.size) : await engine.ask('inspect', request(), now.file);
  clearTimeout(patience);
  $('reading').hidden = true;
  $('defects').classList.remove('wait');
  if (!answer) return;
  if (answer.kind !== 'done') { now.read = null; fail(answer); return; }
  if (answer.state === 'ask') showAsk(answer); else showRead(answer);
}

function tooBig(size) {
  const { heading, text, ways } = now.place.too_big;
  return { kind: 'error', heading, text: `It has ${megabytes(size)}. ${text}`, ways, detail: `limit: ${size} bytes` };
}

function megabytes(bytes) {
  return bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toPrecision(3)} MB`;
}

function showRead(answer) {
  const first = now.read === null;
  now.read = answer;
  now.plan = answer.plan;
  $('read-file').textContent = answer.about;
  headed($('h-read'), answer.heading);
  showPictures(answer.pictures);
  const rows = answer.facts.flatMap(([term, text]) => [part('dt', {}, term), part('dd', {}, text)]);
  if (answer.channels.length > 1) {
    rows.push(...chosen('channel', 'Channel', answer.channels.map(c => ({ value: c.name, label: c.label, chosen: c.chosen, off: !c.readable }))));
  }
  rows.push(...chosen('part', 'Part', answer.parts));
  $('facts').replaceChildren(...rows);
  $('numbers').replaceChildren(...answer.numbers.map(([name, value]) =>
    part('tr', {}, part('th', { scope: 'row' }, name), part('td', { className: 'n' }, value))));
  showDefects(answer.defects);
  $('findings').replaceChildren(...answer.findings.map(finding => part('li', {}, tag(finding.weight), part('b', {}, finding.claim), ' ' + finding.text)));
  $('h-read').dataset.ready = String((Number($('h-read').dataset.ready) || 0) + 1);
  if (first) go('read'); else areas();
}

// A fact that is chosen from a list, and read with anew.
function chosen(key, name, options) {
  const choice = part('select', { id: key, onchange: e => { now.reading = { ...now.reading, [key]: e.target.value || null }; look(); } },
    ...options.map(o => part('option', { value: o.value || '', selected: o.chosen, disabled: o.off }, o.label)));
  return [part('dt', {}, part('label', { for: key }, name)), part('dd', {}, choice)];
}

// How much touches without each remedy and with it, told one by one when nothing else is asked. What comes between ends
// it; it begins again when the page is back.
async function areas() {
  const of = now.read, planned = await plan();
  const keys = of ? of.defects.map(defect => defect.key) : [];
  if (!planned || of !== now.read || keys.length === 0 || of.areas || engine.running) return;
  const cells = key => all('[data-area]').filter(cell => cell.dataset.area === key);
  const answer = await engine.ask('areas', request({ defects: keys }), now.file, news => {
    cells(news.key).forEach(cell => cell.replaceChildren(...broken(news.lines[cell.dataset.side])));
  });
  if (!answer || of !== now.read) return;
  of.areas = true;
  if (answer.kind !== 'done') { all('[data-area]').forEach(cell => cell.replaceChildren()); return; }
  if (answer.cut) $('defects-area').textContent = ` Area: of the middle, at most ${answer.cut} points a side, at a light load, 0.01\u202fE* Sdq.`;
}

// Lines of text, one below the other.
function broken(list) { return (list || []).flatMap((text, i) => i ? [part('br'), text] : [text]); }

function tag(weight) {
  const words = { check: 'Check', note: 'Note', passed: 'Passed' };
  return part('span', { className: 'tag ' + weight }, words[weight]);
}

// The pictures are drawn by the engine, from numbers alone. The one that was chosen is kept by its name, since not every
// map has spikes to ring; else the last is shown, the map that will be computed.
function showPictures(pictures) {
  const wanted = pictures.find(p => p.name === now.picture) || pictures[pictures.length - 1];
  const show = p => { $('picture').innerHTML = p.svg; };
  $('pictures').replaceChildren($('pictures').querySelector('legend'), ...pictures.map(p => part('label', {},
    part('input', { type: 'radio', name: 'pic', checked: p === wanted, onchange: () => { now.picture = p.name; show(p); } }), p.name)));
  show(wanted);
}

function showDefects(defects) {
  $('defects-lead').replaceChildren(...(defects.length
    ? ['Each remedy shows what it changes. Untick to keep the map as measured.', part('span', { id: 'defects-area' }, ' Area: at a light load, 0.01\u202fE* Sdq.')]
    : ['Nothing that has a remedy.']));
  $('defects').hidden = defects.length === 0;
  // A table that is read anew keeps the focus on the box that was ticked.
  const focused = document.activeElement && document.activeElement.dataset.key;
  const cell = (defect, i, label) => part('td', { className: 'n', 'data-l': label }, ...broken(defect.numbers && defect.numbers[i]),
    defect.key === 'fill' && i === 0 ? null : part('div', { 'data-area': defect.key, 'data-side': i }, '…'));
  $('defects').tBodies[0].replaceChildren(...defects.map(defect => part('tr', {},
    part('th', { scope: 'row' }, tag(defect.tag), part('b', {}, defect.claim), defect.text),
    part('td', { className: 'fix' }, remedy(defect)),
    cell(defect, 0, 'Without'), cell(defect, 1, 'With it'))));
  if (focused) { const again = document.querySelector(`[data-key="${focused}"]`); if (again) again.focus(); }
}

function remedy(defect) {
  if (defect.key === 'fill') {
    const choices = [['harmonic', 'Fill smoothly'], ['nearest', 'Fill with the nearest']];
    return part('select', { 'aria-label': 'Missing points', 'data-key': 'fill', onchange: e => { now.remedies.fill = e.target.value; look(); } },
      ...choices.map(([value, text]) => part('option', { value, selected: value === defect.fill }, text)));
  }
  return part('label', {}, part('input', {
    type: 'checkbox', checked: defect.ticked, 'data-key': defect.key,
    onchange: e => { now.remedies[defect.key] = e.target.checked; look(); },
  }), defect.label);
}

function showAsk(answer) {
  now.asked = answer;
  $('ask-file').textContent = answer.about;
  headed($('h-ask'), answer.heading);
  ['pixel', 'lateral_unit', 'height_unit'].forEach(key => { $('row-' + key).hidden = !answer.needs.includes(key); });
  go('ask');
  meaning();
}

// What is filled in, as the engine takes it.
function units() {
  const said = {}, needs = now.asked.needs;
  if (needs.includes('pixel')) said.pixel = $('dx').value.trim() + $('dxu').value;
  if (needs.includes('lateral_unit')) said.lateral_unit = $('lu').value;
  if (needs.includes('height_unit')) said.height_unit = $('hu').value;
  return said;
}

async function meaning() {
  if (!now.asked) return;
  const empty = now.asked.needs.includes('pixel') && !$('dx').value.trim();
  const answer = empty ? null : await engine.ask('meaning', { reading: units(), raw: now.asked.raw });
  const fine = answer && answer.kind === 'done';
  $('dx').setAttribute('aria-invalid', String(Boolean(answer) && !fine));
  $('use-units').disabled = !fine;
  $('a-size').textContent = fine ? answer.size : '…';
  $('a-h').textContent = fine ? answer.heights : '…';
  $('a-g').textContent = fine ? answer.gradient : '…';
  $('a-say').replaceChildren(...(fine ? [part('span', { className: 'tag ' + answer.tag, style: 'position:static' }, answer.tag === 'check' ? 'Check' : 'Passed'), ' ' + answer.text]
    : [answer ? answer.text : 'A distance of points is needed, such as 0.5 µm.']));
}

function wireSurface() {
  $('choose').onclick = () => $('file').click();
  $('file').onchange = e => { take(e.target.files[0]); e.target.value = ''; };
  addEventListener('dragover', e => { e.preventDefault(); $('drop').classList.add('over'); });
  addEventListener('dragleave', e => { if (!e.relatedTarget) $('drop').classList.remove('over'); });
  addEventListener('drop', e => { e.preventDefault(); $('drop').classList.remove('over'); take(e.dataTransfer.files[0]); });
  $('asking-yes').onclick = () => { $('asking').hidden = true; stopRunning(); take(now.waiting); };
  $('asking-no').onclick = () => { $('asking').hidden = true; now.waiting = null; $('h-run').focus(); };
  ['dx', 'dxu', 'lu', 'hu'].forEach(id => { $(id).oninput = meaning; });
  $('use-units').onclick = () => { now.reading = { ...now.reading, ...units() }; now.read = null; look(); };
}
