// The program in a worker: one request at a time, the newest waits, what takes long makes way for it.

const LONG = 1000; // ms after which any request makes way for a newer one
const PATIENCE = 30000; // ms after which a request is given up: the page's own cases take a tenth of it at most

async function compiled() {
  const text = document.getElementById("program").textContent.trim();
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

class Asking {
  constructor(module) {
    this.module = module;
    this.address = URL.createObjectURL(new Blob([document.getElementById("worker").textContent], { type: "text/javascript" }));
    this.id = 0;
  }

  stop() {
    this.worker?.terminate();
    clearTimeout(this.clock);
    this.worker = this.running = undefined;
  }

  // One worker lives through many requests; a new one takes the compiled module along.
  send(one) {
    const fresh = !this.worker;
    if (fresh) {
      this.worker = new Worker(this.address);
      this.worker.onmessage = ({ data }) => this.came(data);
      this.worker.onerror = (event) => this.came({ id: this.id, broken: event.message });
    }
    this.running = { ...one, id: ++this.id, since: performance.now() };
    this.clock = setTimeout(() => this.came({ id: this.id, broken: `no answer within ${PATIENCE / 1000} s` }), PATIENCE);
    this.worker.postMessage({ module: fresh ? this.module : undefined, id: this.id, request: one.request });
  }

  came({ id, reply, broken }) {
    if (id !== this.running?.id) return;
    const { done } = this.running;
    if (broken) this.stop();
    clearTimeout(this.clock);
    this.running = undefined;
    const next = this.waiting;
    this.waiting = undefined;
    if (next) this.send(next);
    done(broken ? { failed: `the program gave up (${broken}): change a value, or run the case file with the command` } : reply);
  }

  // Quick requests wait for one another, the newest alone; slow ones, and those that turn out to be, are stopped by whatever comes.
  ask(request, done, slow = false) {
    const one = { request, done, slow };
    if (this.running?.slow || performance.now() - this.running?.since > LONG) this.stop();
    if (this.running) this.waiting = one;
    else this.send(one);
  }
}
