// Who answers the questions of the page: the module inside it, in a worker that can be ended at any time.
'use strict';

class Engine {
  constructor() { this.worker = null; this.module = null; this.busy = false; this.keeps = true; }

  // Compiles once. A browser without WebAssembly throws here.
  async start() {
    const text = document.getElementById('engine').textContent.trim();
    this.module = await WebAssembly.compile(await unpacked(text));
  }

  fresh() {
    if (this.worker) this.worker.terminate();
    const source = new Blob([document.getElementById('worker').textContent], { type: 'text/javascript' });
    const address = URL.createObjectURL(source);
    this.worker = new Worker(address);
    URL.revokeObjectURL(address);
    this.worker.postMessage({ module: this.module });
    this.busy = false;
  }

  // One question; `news` gets what is told on the way. Gives `{kind: 'done' | 'error' | 'died', ...}`, or `null` if it
  // was cancelled by another question or by `cancel`.
  ask(question, request, file, news) {
    if (this.busy || !this.worker) this.cancel();
    this.busy = true;
    return new Promise(settle => {
      let answer = null;
      this.drop = () => settle(null);
      const died = detail => { this.busy = false; this.drop = null; settle({ kind: 'died', detail }); };
      this.worker.onerror = e => died(e.message || 'the worker ended');
      this.worker.onmessage = ({ data }) => {
        if (data.kind === 'progress') { if (news) news(data); return; }
        if (data.kind !== 'end') { answer = data; return; }
        this.memory = data.memory;
        if (!answer) { died(data.complaint || `ended with ${data.code}`); return; }
        this.busy = false; this.drop = null;
        settle(answer);
      };
      this.worker.postMessage({ question, request, file });
    });
  }

  // Ends what is computed now, and its memory with it.
  cancel() {
    const drop = this.drop;
    this.drop = null;
    this.fresh();
    if (drop) drop();
  }
}

// What is packed as base64 text. A data address would be a connection, which the policy of the page forbids.
async function unpacked(text) {
  const binary = atob(text), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(plain).arrayBuffer();
}
