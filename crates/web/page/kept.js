// Bodies and loads of the last time, never surfaces; where a browser refuses to keep them, nothing is kept. Hardness and
// resistivities, which lie folded, are not kept either: they would be computed unseen.
'use strict';
const KEPT = 'rough-contact', FIELDS = ['e1', 'n1', 'e2', 'n2', 'p1', 'f1', 'f2'];

function keep() {
  if (!engine.keeps) return;
  const fields = Object.fromEntries(FIELDS.map(id => [id, $(id).value]));
  const kept = { fields, materials: [1, 2].map(b => materials[$('m' + b).value]?.title ?? ''), load: document.querySelector('[name=ld]:checked').value };
  try { localStorage.setItem(KEPT, JSON.stringify(kept)); } catch { /* refused: the next time begins anew */ }
}

function restore() {
  let kept = null;
  try { kept = engine.keeps && JSON.parse(localStorage.getItem(KEPT)); } catch { /* refused, or not ours */ }
  if (!kept) return;
  FIELDS.forEach(id => { if (typeof kept.fields?.[id] === 'string') $(id).value = kept.fields[id]; });
  [1, 2].forEach(b => {
    const i = materials.findIndex(m => m.title === kept.materials?.[b - 1]);
    if (i >= 0) { $('m' + b).value = i; $('m' + b).onchange(); } else if (kept.materials?.[b - 1] === '') $('m' + b).value = '';
  });
  const radio = all('[name=ld]').find(r => r.value === kept.load);
  if (radio) { radio.checked = true; radio.onchange(); }
}
