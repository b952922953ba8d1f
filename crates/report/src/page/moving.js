(function(){document.querySelectorAll('img.first').forEach(function(first){
var section=first.closest('[data-loads]'),facts=JSON.parse(first.dataset.facts),loads,width,height;
var figures=[].map.call(section.querySelectorAll('img.relief'),function(relief){
var figure=relief.closest('figure'),svg=figure.querySelector('svg'),image=svg.querySelector('image'),title=svg.querySelector('title'),canvas=document.createElement('canvas'),wide=+image.getAttribute('width'),high=+image.getAttribute('height');
canvas.className='px moving';canvas.hidden=true;canvas.style.width=100*wide/svg.viewBox.baseVal.width+'%';canvas.style.aspectRatio=wide+'/'+high;figure.insertBefore(canvas,svg.nextSibling);
return{canvas:canvas,image:image,still:image.getAttribute('href'),relief:relief.src,part:relief.dataset.part.split(' ').map(Number),bar:svg.querySelector('rect[fill="#fff"]'),legend:svg.querySelector('.legend'),size:[wide,high],title:figure.contains(first)&&title,said:title&&title.textContent}});
function read(){if(loads)return;var c=document.createElement('canvas');width=c.width=first.naturalWidth;height=c.height=first.naturalHeight;
var x=c.getContext('2d');x.drawImage(first,0,0);var d=x.getImageData(0,0,width,height).data;loads=new Uint8Array(width*height);for(var i=0;i<loads.length;i++)loads[i]=d[4*i]}
function draw(f,i,off){var p=f.part,y0=Math.round(p[0]*height),x0=Math.round(p[1]*width),h=Math.max(1,Math.round(p[2]*height)),w=Math.max(1,Math.round(p[3]*width)),c=f.canvas,last=i*facts.step;
c.width=w;c.height=h;var x=c.getContext('2d'),d=x.createImageData(w,h),a=new Uint32Array(d.data.buffer),k=facts.colour,ink=new Uint32Array(new Uint8Array([k[0],k[1],k[2],255]).buffer)[0];
for(var y=0;y<h;y++)for(var j=0,o=(y0+y)*width+x0;j<w;j++,o++)if(loads[o]<=last&&!off[o])a[y*w+j]=ink;
x.putImageData(d,0,0);
if(f.bar){var at=function(n){return+f.bar.getAttribute(n)};x.clearRect(at('x')/f.size[0]*w,at('y')/f.size[1]*h,at('width')/f.size[0]*w,at('height')/f.size[1]*h)}}
section.addEventListener('read-off',function(e){var i=e.detail.load,home=e.detail.home;
if(!home)read();var off={};facts.lost.forEach(function(l){if(l[0]===i)off[l[1]]=1});
figures.forEach(function(f){f.canvas.hidden=home;f.image.setAttribute('href',home?f.still:f.relief);
if(f.legend)f.legend.setAttribute('visibility',home?'visible':'hidden');
if(f.title)f.title.textContent=home?f.said:facts.titles[i];if(!home)draw(f,i,off)})})})})();
