// A headless Chromium driven over a pipe, as a person would: DevTools protocol, no packages.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Browser {
  constructor(program = process.env.CHROMIUM || 'chromium') {
    this.home = mkdtempSync(join(tmpdir(), 'rough-contact-web-'));
    this.process = spawn(program, [
      '--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars', '--remote-debugging-pipe', '--no-first-run',
      `--user-data-dir=${this.home}`, 'about:blank',
    ], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.number = 0;
    this.waiting = new Map();
    this.listeners = [];
    let rest = Buffer.alloc(0);
    this.process.stdio[4].on('data', piece => {
      rest = Buffer.concat([rest, piece]);
      for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) this.hear(JSON.parse(rest.subarray(0, end)));
    });
  }

  hear(message) {
    const call = this.waiting.get(message.id);
    if (!call) { this.listeners.forEach(l => l(message)); return; }
    this.waiting.delete(message.id);
    if (message.error) call.fail(new Error(`${call.method}: ${message.error.message}`)); else call.settle(message.result);
  }

  call(method, params = {}, sessionId = undefined) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((settle, fail) => this.waiting.set(id, { settle, fail, method }));
  }

  // A new page at this address; it remembers what pages of the same `context` have kept, by default nothing.
  async open(address, { width = 1200, height = 900, dark = false, context = null } = {}) {
    const { browserContextId } = context || await this.call('Target.createBrowserContext');
    const { targetId } = await this.call('Target.createTarget', { url: 'about:blank', browserContextId });
    const { sessionId } = await this.call('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    await page.call('Page.enable');
    await page.call('Runtime.enable');
    await page.call('Log.enable');
    await page.call('Network.enable');
    await page.call('DOM.enable');
    await page.look(width, height, dark);
    await page.call('Page.navigate', { url: address });
    return page;
  }

  async close() {
    this.process.kill();
    await new Promise(done => this.process.on('exit', done));
    // Its helpers may write for a moment longer.
    for (let left = 20; ; left--) {
      try { rmSync(this.home, { recursive: true, force: true }); return; } catch (error) { if (!left) throw error; }
      await new Promise(done => setTimeout(done, 100));
    }
  }
}

export class Page {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target, faults: [], requests: [] });
    browser.listeners.push(({ method, params, sessionId }) => {
      if (sessionId !== session) return;
      if (method === 'Runtime.exceptionThrown') this.faults.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
      if (method === 'Log.entryAdded' && params.entry.level === 'error') this.faults.push(params.entry.text);
      if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
    });
  }

  call(method, params) { return this.browser.call(method, params, this.session); }

  async look(width, height, dark) {
    await this.call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    await this.call('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
  }

  // The value of an expression in the page.
  async value(expression) {
    const { result, exceptionDetails } = await this.call('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true, userGesture: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description || exceptionDetails.text}`);
    return result.value;
  }

  // Waits until an expression is true.
  async until(expression, seconds = 120) {
    const end = Date.now() + 1e3 * seconds;
    while (!await this.value(`Boolean(document.documentElement && (${expression}))`)) {
      if (Date.now() > end) throw new Error(`not within ${seconds} s: ${expression}; at ${await this.value('location.hash')}: ${await this.value("document.querySelector('#app>section.on').innerText.slice(0,300)")}`);
      await new Promise(done => setTimeout(done, 50));
    }
  }

  state(name, seconds) { return this.until(`document.querySelector('#s-${name}').classList.contains('on')`, seconds); }
  text(selector) { return this.value(`document.querySelector(${JSON.stringify(selector)}).textContent`); }

  // A click in the middle of an element, by the mouse.
  async click(selector) {
    const at = await this.value(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({block: 'center'}); const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
    for (const type of ['mousePressed', 'mouseReleased']) await this.call('Input.dispatchMouseEvent', { type, x: at[0], y: at[1], button: 'left', clickCount: 1 });
  }

  async key(key) {
    for (const type of ['keyDown', 'keyUp']) await this.call('Input.dispatchKeyEvent', { type, key, code: key, text: key === 'Enter' ? '\r' : key === ' ' ? ' ' : undefined, windowsVirtualKeyCode: { Enter: 13, Tab: 9, ' ': 32 }[key] });
  }

  async type(selector, text) {
    await this.value(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.focus(); e.select(); })()`);
    await this.call('Input.insertText', { text });
  }

  // Chooses a file, as the dialog would.
  async choose(path) {
    const { root } = await this.call('DOM.getDocument');
    const { nodeId } = await this.call('DOM.querySelector', { nodeId: root.nodeId, selector: '#file' });
    await this.call('DOM.setFileInputFiles', { files: [path], nodeId });
  }

  async picture(whole = true) {
    const { data } = await this.call('Page.captureScreenshot', { captureBeyondViewport: whole, ...(whole ? { clip: { x: 0, y: 0, scale: 1, ...await this.value('({width: document.documentElement.clientWidth, height: Math.min(6000, document.documentElement.scrollHeight)})') } } : {}) });
    return Buffer.from(data, 'base64');
  }
}
