// The distributions at the load read off, on axes wide enough for every load; on paper those of the load shown first.
(function () {
'use strict';
document.querySelectorAll('span.spread').forEach(span => {
  const section = span.closest('[data-loads]'), svg = span.closest('figure').querySelector('svg'), facts = JSON.parse(span.dataset.facts);
  const still = svg.innerHTML;
  function draw(load) {
    const [title, said] = svg.querySelectorAll('title, desc');
    svg.replaceChildren(title, said);
    svg.insertAdjacentHTML('beforeend', facts.under + facts.loads[load].marks + facts.over);
    said.textContent = facts.loads[load].title;
    document.documentElement.dispatchEvent(new CustomEvent('drawn'));
  }
  section.addEventListener('read-off', e => draw(e.detail.load));
  addEventListener('beforeprint', () => { svg.innerHTML = still; });
  draw(+section.querySelector('.dial input').value);
});
})();
