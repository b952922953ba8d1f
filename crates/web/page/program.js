// Who answers the questions of the page: the program that has served it, on this machine.
'use strict';

class Engine {
  constructor() { this.asking = null; this.keeps = false; } // its address is new each time

  async start() {}

  // One question; `news` gets what is told on the way. Gives `{kind: 'done' | 'error' | 'died', ...}`, or `null` if it
  // was cancelled by another question or by `cancel`.
  async ask(question, request, file, news) {
    this.cancel();
    const own = this.asking = new AbortController();
    const tell = message => { if (news && this.asking === own) news(message); };
    const answer = await heard(question, request, file, own.signal, tell).catch(fault => ({
      kind: 'error', isGone: true, heading: 'The program does not answer.',
      text: 'It was ended in its terminal, or the file cannot be read any more.',
      ways: ['Choose the file again.', 'Start rough-contact app again; it opens a new page.'], detail: String(fault),
    }));
    if (this.asking !== own) return null;
    this.asking = null;
    return answer;
  }

  // The program stops when nobody waits any more.
  cancel() {
    if (this.asking) this.asking.abort();
    this.asking = null;
  }
}

// The request is the first line of what is sent, the file the rest; what comes back are lines, each a message.
async function heard(question, request, file, signal, tell) {
  const body = new Blob([JSON.stringify(request), '\n', ...(file ? [file] : [])]);
  const headers = { 'Content-Type': 'application/octet-stream' };
  const response = await fetch(`ask/${question}`, { method: 'POST', headers, body, signal });
  if (!response.ok) {
    return { kind: 'error', heading: 'The program refused the question.', text: await response.text(), detail: String(response.status) };
  }
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let answer = null;
  for (let pieces = [];;) {
    const { done, value } = await reader.read();
    if (done) break;
    const lines = value.split('\n');
    pieces.push(lines[0]);
    for (const next of lines.slice(1)) {
      const message = JSON.parse(pieces.join(''));
      if (message.kind === 'progress') tell(message); else answer = message;
      pieces = [next];
    }
  }
  return answer || { kind: 'died', detail: 'the answer broke off' };
}
