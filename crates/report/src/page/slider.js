(function(){document.documentElement.classList.add('js');
document.querySelectorAll('[data-loads]').forEach(function(s){
var D=JSON.parse(s.querySelector('script[type="application/json"]').textContent),n=D.read.length-1,r=s.querySelector('.dial input'),home=+r.value,cur=s.querySelectorAll('.cur'),out=s.querySelector('.dial output');
function set(i){i=Math.max(0,Math.min(n,Math.round(i)));r.value=i;r.setAttribute('aria-valuetext',D.read[i]);out.textContent=D.read[i];
cur.forEach(function(c){c.setAttribute('transform','translate('+c.dataset.x.split(' ')[i]+' 0)')});
s.querySelectorAll('[data-k]').forEach(function(e){e.textContent=D.cells[e.dataset.k][i]});
s.dispatchEvent(new CustomEvent('read-off',{detail:{load:i,home:i===home}}))}
r.addEventListener('input',function(){set(+r.value)});
s.querySelector('.dial button').addEventListener('click',function(){set(home)});addEventListener('beforeprint',function(){set(home)});
cur.forEach(function(c){var v=c.ownerSVGElement,X=c.dataset.x.split(' ').map(Number);
v.addEventListener('pointermove',function(e){var b=v.getBoundingClientRect(),x=(e.clientX-b.left)*v.viewBox.baseVal.width/b.width,k=0;
if(x<X[0]-6||x>X[n]+6)return;X.forEach(function(q,j){if(Math.abs(q-x)<Math.abs(X[k]-x))k=j});set(k)});
v.addEventListener('pointerleave',function(e){if(e.pointerType==='mouse')set(home)})})})})();
