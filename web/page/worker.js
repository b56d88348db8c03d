// Holds the program: a request in, a reply out, one after the other.
let program;
onmessage = async ({ data: { module, id, request } }) => {
  try {
    if (module) program = (await WebAssembly.instantiate(module, {})).exports;
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const at = program.take(bytes.length);
    new Uint8Array(program.memory.buffer, at, bytes.length).set(bytes);
    const length = program.answer();
    // memory may have grown, and moved, meanwhile
    const reply = new TextDecoder().decode(new Uint8Array(program.memory.buffer, program.give(), length));
    postMessage({ id, reply: JSON.parse(reply) });
  } catch (error) {
    postMessage({ id, broken: String(error) });
  }
};
