// A model followed through all figures and tables: everything of the others fades.
(function () {
'use strict';
const root = document.documentElement;
let followed = '', kept = '';
const names = document.querySelectorAll('.models tr[data-m] th div');
function show() {
  root.classList.toggle('following', followed !== '');
  document.querySelectorAll('[data-m]').forEach(e => e.classList.toggle('followed', e.dataset.m === followed));
  names.forEach(name => name.setAttribute('aria-pressed', String(name.closest('tr').dataset.m === followed)));
}
function follow(name) { followed = name === followed ? '' : name; show(); }
names.forEach(name => {
  name.tabIndex = 0;
  name.setAttribute('role', 'button');
  name.addEventListener('click', () => follow(name.closest('tr').dataset.m));
  name.addEventListener('keydown', e => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); follow(name.closest('tr').dataset.m); } });
});
// Lines are thin: what lies within a few pixels of the click counts.
const NEAR = [[0, 0], [0, 3], [0, -3], [3, 0], [-3, 0], [0, 6], [0, -6], [6, 0], [-6, 0]];
document.querySelectorAll('figure svg').forEach(svg => svg.addEventListener('click', e => {
  for (const [x, y] of NEAR) {
    const hit = document.elementFromPoint(e.clientX + x, e.clientY + y), mark = hit && hit.closest('svg [data-m]');
    if (mark) { follow(mark.dataset.m); return; }
  }
}));
addEventListener('keydown', e => { if (e.key === 'Escape') { followed = ''; show(); } });
root.addEventListener('drawn', show); // new elements have appeared
addEventListener('beforeprint', () => { kept = followed; followed = ''; show(); });
addEventListener('afterprint', () => { followed = kept; show(); });
show();
})();
