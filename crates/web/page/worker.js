// Answers one question at a time. Each is a run of its own, whose memory is given back: nothing that a file did is left.
let engine = null;
onmessage = async ({ data }) => {
  if (data.module) { engine = data.module; return; }
  const { question, request, file } = data;
  try {
    const input = file ? new Uint8Array(await file.arrayBuffer()) : new Uint8Array();
    const end = await execute(engine, ['contact-web', question, JSON.stringify(request)], input,
      text => postMessage(JSON.parse(text)));
    postMessage({ kind: 'end', ...end });
  } catch (e) {
    postMessage({ kind: 'end', code: -1, complaint: String(e), memory: 0 });
  }
};
