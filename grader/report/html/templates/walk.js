// What of a model is shown: its mesh, boxes up to a level, the wrong node, a ray and its steps.
const unpack = async (text) => {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
};

// Everything is moved into a cube of side 2 around the origin, where float32 is good enough.
const openModel = async (model) => {
  const { low, high, vertices, faces } = model.mesh;
  const [packed, corners] = await Promise.all([unpack(model.mesh.data), unpack(model.boxes.data)]);
  const middle = low.map((x, k) => (x + high[k]) / 2);
  const scale = 2 / (Math.max(...low.map((x, k) => high[k] - x)) || 1);
  const moved = (p) => p.map((x, k) => Math.max(-1e4, Math.min(1e4, (x - middle[k % 3]) * scale)));
  const mesh = { places: new Uint16Array(packed, 0, 3 * vertices), corners: new Uint32Array(packed.slice(6 * vertices)) };
  const numbers = new Float32Array(corners), count = model.boxes.count;
  const box = (node) => {
    const found = numbers.subarray(6 * node, 6 * node + 6);
    return node < count && found[0] <= found[3] ? moved([...found]) : null;
  };
  const boxLines = new Float32Array(72 * count);
  for (let node = 0; node < count; node++) if (box(node)) boxLines.set(edgesOf(box(node)), 72 * node);
  const place = (face) => {
    const at = [...mesh.corners.subarray(3 * face, 3 * face + 3)];
    return at.map((v) => moved([0, 1, 2].map((k) => low[k] + (mesh.places[3 * v + k] / 65535) * (high[k] - low[k]))));
  };
  // A coarsened mesh has other faces than the one that the steps name.
  const whole = faces === model.faces;
  const outline = (face) => { const at = place(face); return at.flatMap((p, k) => [...p, ...at[(k + 1) % 3]]); };
  const tested = (face) => (whole && face !== null && face < faces ? outline(face) : null);
  return { model, mesh, box, boxLines, moved, scale, outline, tested, low: moved(low), size: low.map((x, k) => (high[k] - x) * scale) };
};

const COLOURS = { plain: [.80, .77, .70], marked: [1, .70, 0], node: [1, .35, .31], expected: [.22, .84, .48], ray: [.13, .72, .91], visited: [.54, .64, 1], now: [.97, .42, .9] };

const stepBox = (opened, step) => (step.node === null ? null : opened.box(step.node));

// The ray as a line, as far as anything happens on it, and dots where it hits.
const rayLines = (opened) => {
  const { ray } = opened.model, at = (t) => opened.moved(ray.origin.map((x, k) => x + t * ray.direction[k]));
  const length = Math.hypot(...ray.direction) * opened.scale || 1;
  const begin = opened.moved(ray.origin);
  const known = [ray.expected_t, ray.got_t].filter((t) => t !== null && Math.abs(t) * length < 1e3);
  const behind = (Math.hypot(...begin) + 1.8) / length;
  const end = ray.t_max !== null && ray.t_max * length < 1e3 ? ray.t_max : Math.max(...known, behind);
  const dot = (t) => [...at(t), ...at(t + .004 / length)];
  const lines = [{ at: [...at(0), ...at(end)], colour: COLOURS.ray, wide: 2.5 }, { at: dot(0), colour: COLOURS.ray, wide: 7 }];
  if (known.includes(ray.got_t)) lines.push({ at: dot(ray.got_t), colour: COLOURS.node, wide: 13 });
  if (known.includes(ray.expected_t)) lines.push({ at: dot(ray.expected_t), colour: COLOURS.expected, wide: 9 });
  return lines;
};

const stepLines = (opened, step) => {
  const { steps } = opened.model.ray, lines = [];
  const before = steps.slice(0, step).map((one) => stepBox(opened, one)).filter(Boolean);
  if (before.length) lines.push({ at: before.flatMap(edgesOf), colour: [...COLOURS.visited, .8], wide: 1.4 });
  const now = step > 0 && steps[step - 1], face = now && opened.tested(now.face);
  if (now && stepBox(opened, now)) lines.push({ at: edgesOf(stepBox(opened, now)), colour: COLOURS.now, wide: 3.5 });
  if (face) lines.push({ at: face, colour: COLOURS.now, wide: 5 });
  return lines;
};

// Few faces get an outline, so that one sees those that lie edge-on or behind others.
const markedLines = ({ model, outline }) => {
  const faces = [];
  for (let k = 0; k < model.marked.length && faces.length < 64; k += 2) {
    for (let n = 0; n < Math.min(64, model.marked[k + 1]); n++) faces.push(model.marked[k] + n);
  }
  return faces.length ? [{ at: faces.flatMap(outline), colour: COLOURS.marked, wide: 2 }] : [];
};

// The node with a wrong box, or the one that the ray should have come to.
const wrongBox = (opened) => {
  const { node, ray } = opened.model;
  const missing = ray && ray.lost !== null && !ray.steps.some((one) => one.node === ray.lost);
  return node !== null ? opened.box(node) : missing ? opened.box(ray.lost) : null;
};

const display = (opened, { level, only, step }) => {
  const { model } = opened, lines = [];
  const first = level < 0 || !only ? 0 : 2 ** level - 1, end = Math.min(2 ** (level + 1) - 1, model.boxes.count);
  const faces = [{ colour: COLOURS.plain, runs: [0, model.mesh.faces] }];
  if (model.marked.length) faces.push({ colour: COLOURS.marked, runs: model.marked });
  if (model.ray) lines.push(...stepLines(opened, step));
  lines.push(...markedLines(opened));
  const wrong = wrongBox(opened);
  if (wrong) lines.push({ at: edgesOf(wrong), colour: COLOURS.node, wide: 3.5 });
  if (model.expected_box) lines.push({ at: edgesOf(opened.moved(model.expected_box)), colour: COLOURS.expected, wide: 3.5, dash: 16 });
  if (model.ray) lines.push(...rayLines(opened));
  return { low: opened.low, size: opened.size, faces, lines, first, count: Math.max(0, end - first) };
};

// What there is to explain in this view, by the names of the legend.
const shownKeys = (opened, { level, step }) => {
  const { model } = opened, { ray } = model;
  return new Set([model.marked.length && "marked", wrongBox(opened) && "node", model.expected_box && "expected", level >= 0 && "boxes",
    ray && "ray", ray && ray.expected_t !== null && "hit", ray && ray.got_t !== null && "got", ray && step > 1 && "visited", ray && step > 0 && "now"]);
};

// All that matters fits into the view; a ray is seen best from the side.
const viewpoint = (opened) => {
  const { model, low, size } = opened, wrong = model.node === null ? null : opened.box(model.node);
  const all = wrong ? [wrong] : [[...low, ...low.map((x, k) => x + size[k])]];
  if (wrong && model.expected_box) all.push(opened.moved(model.expected_box));
  const from = [0, 1, 2].map((k) => Math.min(...all.map((box) => box[k])));
  const to = [3, 4, 5].map((k) => Math.max(...all.map((box) => box[k])));
  const wide = Math.hypot(...from.map((x, k) => to[k] - x));
  const view = { at: from.map((x, k) => (x + to[k]) / 2), far: Math.max(.4, Math.min(6, wide * 1.25)) };
  if (!model.ray) return view;
  const [x, y, z] = model.ray.direction, small = model.mesh.faces < 200;
  // Over a whole scene one looks nearly as its camera does.
  const yaw = small ? Math.atan2(x, z) + 1.25 : Math.atan2(-x, -z) + .5;
  return { ...view, yaw, pitch: small ? .3 : Math.max(-1.2, Math.min(1.2, Math.atan2(-y, Math.hypot(x, z)))) };
};
