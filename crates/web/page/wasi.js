// What a program for WASI preview 1 asks of its system, as far as this one does: arguments, one file to read (0), two to
// write (1, 2), the time, chance. Everything else is refused.
'use strict';

const ERRNO = { success: 0, bad: 8, unsupported: 52 };

class Exit extends Error {
  constructor(code) { super(`exit ${code}`); this.code = code; }
}

// Runs a module once. `said` gets each line of standard output; the promise gives the exit code and standard error.
async function execute(module, args, input, said) {
  const coder = new TextEncoder(), decoder = new TextDecoder();
  const all = args.map(a => coder.encode(a + '\0'));
  let memory = null, at = 0, complaint = '', pending = [];
  const view = () => new DataView(memory.buffer), bytes = () => new Uint8Array(memory.buffer);
  // A line may come in pieces, and is read as text only when it is whole.
  const line = piece => {
    let from = 0;
    for (let end; (end = piece.indexOf(10, from)) >= 0; from = end + 1) {
      pending.push(piece.slice(from, end));
      const whole = new Uint8Array(pending.reduce((n, p) => n + p.length, 0));
      pending.reduce((n, p) => (whole.set(p, n), n + p.length), 0);
      pending = [];
      said(decoder.decode(whole));
    }
    if (from < piece.length) pending.push(piece.slice(from));
  };
  const each = (list, count, visit) => {
    for (let i = 0; i < count; i++) visit(view().getUint32(list + 8 * i, true), view().getUint32(list + 8 * i + 4, true));
  };
  const system = {
    args_sizes_get(count, size) {
      view().setUint32(count, all.length, true);
      view().setUint32(size, all.reduce((n, a) => n + a.length, 0), true);
      return ERRNO.success;
    },
    args_get(list, text) {
      all.forEach((a, i) => { view().setUint32(list + 4 * i, text, true); bytes().set(a, text); text += a.length; });
      return ERRNO.success;
    },
    environ_sizes_get(count, size) { view().setUint32(count, 0, true); view().setUint32(size, 0, true); return ERRNO.success; },
    environ_get() { return ERRNO.success; },
    clock_time_get(id, precision, result) {
      const milliseconds = id === 0 ? Date.now() : performance.now();
      view().setBigUint64(result, BigInt(Math.round(milliseconds * 1e6)), true);
      return ERRNO.success;
    },
    random_get(to, count) {
      for (let i = 0; i < count; i += 65536) crypto.getRandomValues(bytes().subarray(to + i, to + Math.min(count, i + 65536)));
      return ERRNO.success;
    },
    fd_read(file, list, count, result) {
      if (file !== 0) return ERRNO.bad;
      let read = 0;
      each(list, count, (to, size) => {
        const part = input.subarray(at, at + size);
        bytes().set(part, to); at += part.length; read += part.length;
      });
      view().setUint32(result, read, true);
      return ERRNO.success;
    },
    fd_write(file, list, count, result) {
      if (file !== 1 && file !== 2) return ERRNO.bad;
      let written = 0;
      each(list, count, (from, size) => {
        const piece = bytes().subarray(from, from + size);
        if (file === 1) line(piece); else complaint += decoder.decode(piece);
        written += size;
      });
      view().setUint32(result, written, true);
      return ERRNO.success;
    },
    proc_exit(code) { throw new Exit(code); },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ||= {};
    imports[from][name] = system[name] || (() => ERRNO.unsupported);
  }
  const instance = await WebAssembly.instantiate(module, imports);
  memory = instance.exports.memory;
  let code = 0, trap = '';
  try { instance.exports._start(); } catch (e) { if (e instanceof Exit) code = e.code; else { code = -1; trap = String(e); } }
  return { code, complaint: [complaint.trim(), trap].filter(Boolean).join('\n'), memory: memory.buffer.byteLength };
}
