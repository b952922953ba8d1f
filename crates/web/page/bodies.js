// Which two bodies, and how hard pressed. Numbers stay text until the engine reads them.
'use strict';

let materials = [];
function buildBodies(list) {
  materials = list;
  all('.body').forEach(field => {
    const b = field.dataset.b;
    const row = (id, label, input, ...rest) => part('div', { className: 'row' }, part('label', { for: id }, label), part('div', { className: 'in' }, input, ...rest.filter(r => r.tagName !== 'SMALL')), ...rest.filter(r => r.tagName === 'SMALL'));
    const pick = part('select', { id: 'm' + b }, ...list.map((m, i) => part('option', { value: i }, m.title)), part('option', { value: '' }, 'Own values'));
    const said = part('small', { className: 'why', id: 's' + b });
    const text = (id, value) => part('input', { type: 'text', id, inputMode: 'decimal', value });
    field.append(row('m' + b, 'Material', pick, said), row('e' + b, 'Young’s modulus E', text('e' + b, list[0].young), part('span', {}, 'GPa')),
      row('n' + b, 'Poisson’s ratio ν', text('n' + b, list[0].poisson)));
    pick.onchange = () => {
      const m = list[pick.value];
      said.textContent = m ? m.said : '';
      if (pick.value !== '') { $('e' + b).value = m.young; $('n' + b).value = m.poisson; } else $('e' + b).focus();
      plan();
    };
    ['e', 'n'].forEach(k => { $(k + b).oninput = () => { pick.value = ''; said.textContent = ''; plan(); }; });
  });
  $('elastic').onchange = () => { $('hard').disabled = $('elastic').checked; plan(); };
  ['hard', 'res1', 'res2', 'p1', 'f1', 'f2'].forEach(id => { $(id).oninput = plan; });
  all('[name=ld]').forEach(radio => { radio.onchange = () => {
    ['pressure', 'force'].forEach(kind => { $('ld-' + kind).hidden = radio.value !== kind; });
    plan();
  }; });
}

const unit = (text, name) => text.trim() ? text.trim() + ' ' + name : '';
// "steel-304 on copper"; own values as numbers.
function pair() {
  const named = m => m && (m.name || m.title.toLowerCase());
  const body = b => named(materials[$('m' + b).value]) ?? ($('e' + b).value.trim() === '∞' ? 'rigid' : `E = ${$('e' + b).value}\u202fGPa`);
  return `${body(1)} on ${body(2)}`;
}

// What is filled in, as the engine takes it.
function asked() {
  const by = document.querySelector('[name=ld]:checked').value;
  return {
    bodies: [1, 2].map(b => ({ material: materials[$('m' + b).value]?.name ?? '', young: $('e' + b).value.trim() === '∞' ? '∞' : unit($('e' + b).value, 'GPa'), poisson: $('n' + b).value })),
    hardness: $('elastic').checked ? 'elastic' : unit($('hard').value, 'GPa'),
    resistivities: [unit($('res1').value, 'nohm m'), unit($('res2').value, 'nohm m')],
    load: { by, list: by === 'force' ? $('f1').value : by === 'pressure' ? $('p1').value : '', area: by === 'force' ? $('f2').value : '' },
  };
}

// Says what that comes to; a computation that runs is not disturbed. Gives whether it was said.
async function plan() {
  if (engine.running || !(now.file || now.example)) return false;
  const answer = await engine.ask('plan', request({ ...asked(), facts: now.plan, pace: now.pace }));
  if (!answer) return false;
  if (answer.kind === 'died' || answer.isGone) { fail(answer); return false; }
  const fine = answer.kind === 'done';
  if (fine) { now.pace = answer.pace; keep(); }
  $('estar').textContent = fine ? answer.modulus : answer.text || 'The computation stopped.';
  $('estar').classList.toggle('no', !fine);
  $('est-loads').textContent = fine ? answer.loads || '' : '';
  $('est-cost').textContent = fine ? answer.cost || '' : '';
  $('compute').disabled = !fine;
  $('bears').textContent = fine ? answer.bears : '';
  $('compute-now').textContent = fine ? `Compute ${pair()}, ${answer.count === 1 ? '1 load' : answer.count + ' loads'}` : 'Compute';
  $('compute-now').disabled = !fine;
  $('read-cost').textContent = fine && answer.cost ? `${answer.loads} ${answer.cost}. You can change everything afterwards.` : '';
  return true;
}
