// Draws a mesh, boxes and a ray with WebGL 2. Lines are quads as wide as we want them, because
// WebGL's own are one pixel wide. Flat normals come from derivatives, so none are stored.
const EYE = `#version 300 es
precision highp float;
uniform vec3 eye, right, up, back;
uniform vec4 lens;
vec4 seen(vec3 p) {
  p -= eye;
  vec3 v = vec3(dot(p, right), dot(p, up), dot(p, back));
  return vec4(v.xy * lens.xy, lens.z * v.z + lens.w, -v.z);
}
`;
const FACE_POINT = `${EYE}
in vec3 place;
uniform vec3 low, size;
out vec3 world;
void main() { world = low + place * size; gl_Position = seen(world); }`;
const FACE_COLOUR = `${EYE}
in vec3 world;
uniform vec3 colour;
out vec4 pixel;
void main() {
  vec3 n = normalize(cross(dFdx(world), dFdy(world)));
  float light = abs(dot(n, normalize(back + .5 * up + .3 * right)));
  pixel = vec4(colour * (.55 + .45 * light), 1);
}`;
const LINE_POINT = `${EYE}
in vec3 a, b;
uniform vec2 view;
uniform float wide;
out float along;
void main() {
  vec4 p = seen(a), q = seen(b);
  const float near = .001;
  bool gone = max(p.w, q.w) < near || !(a != b);
  if (p.w < near) p = mix(p, q, (near - p.w) / (q.w - p.w));
  else if (q.w < near) q = mix(q, p, (near - q.w) / (p.w - q.w));
  vec2 d = (q.xy / q.w - p.xy / p.w) * view;
  float l = length(d);
  d = l > 0. ? d / l : vec2(1, 0);
  vec2 n = vec2(-d.y, d.x) * (gl_VertexID % 2 == 0 ? 1. : -1.);
  bool end = gl_VertexID > 1;
  vec4 c = end ? q : p;
  c.xy += (n + (end ? d : -d)) * wide / view * c.w;
  c.z -= .0008 * c.w;
  along = end ? l * .5 : 0.;
  gl_Position = gone ? vec4(2, 2, 2, 1) : c;
}`;
const LINE_COLOUR = `${EYE}
in float along;
uniform vec4 tint;
uniform float dash;
out vec4 pixel;
void main() { if (dash > 0. && mod(along, dash) > dash * .6) discard; pixel = tint; }`;

const edgesOf = (box) => {
  const lines = [];
  for (let axis = 0; axis < 3; axis++) {
    for (let corner = 0; corner < 4; corner++) {
      const from = [0, 1, 2].map((k) => {
        const bit = k === axis ? 0 : k === (axis + 1) % 3 ? corner & 1 : corner >> 1;
        return box[k + 3 * bit];
      });
      lines.push(...from, ...from.map((x, k) => (k === axis ? box[k + 3] : x)));
    }
  }
  return lines;
};

// All boxes alike, or each level in its own colour: nodes 2^n - 1 to 2^(n + 1) - 2 are level n.
const LEVELS = [[1, .4, .4], [.85, .4, 1], [.45, .5, 1], [.3, .85, 1], [.35, 1, .6], [.75, 1, .3], [1, .85, .3]];
const boxRuns = ({ first, count, levels }) => {
  const past = first + count, runs = [];
  if (!levels) return [[first, past, [.62, .8, .3, .75]]];
  for (let level = 0; 2 ** level - 1 < past; level++) {
    const run = [Math.max(first, 2 ** level - 1), Math.min(past, 2 ** (level + 1) - 1)];
    if (run[0] < run[1]) runs.push([...run, LEVELS[level % LEVELS.length]]);
  }
  return runs;
};

// Whoever wants to know from where one looks is told so, whenever that changes.
const openSpace = (canvas, seen = null) => {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const build = (point, colour) => {
    const made = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, point], [gl.FRAGMENT_SHADER, colour]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    const places = {};
    return { made, at: (name) => (places[name] ??= gl.getUniformLocation(made, name)) };
  };
  const faces = build(FACE_POINT, FACE_COLOUR), lines = build(LINE_POINT, LINE_COLOUR);
  const points = gl.createBuffer(), corners = gl.createBuffer();
  const boxes = gl.createBuffer(), extra = gl.createBuffer();
  // East, up and north: with a yaw and a pitch of 0 one looks from the north.
  const home = { yaw: .6, pitch: .35, far: 3, at: [0, 0, 0], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] };
  let shown = null, view = { ...home }, start = home, waiting = false;

  const axes = () => {
    const { yaw, pitch, axes: [east, above, north] } = view, c = Math.cos(pitch);
    const back = [Math.sin(yaw) * c, Math.sin(pitch), Math.cos(yaw) * c];
    const right = [Math.cos(yaw), 0, -Math.sin(yaw)];
    const up = [back[1] * right[2], back[2] * right[0] - back[0] * right[2], -back[1] * right[0]];
    const placed = ([x, y, z]) => east.map((e, k) => x * e + y * above[k] + z * north[k]);
    return { back: placed(back), right: placed(right), up: placed(up) };
  };
  const look = (program, { back, right, up }) => {
    gl.useProgram(program.made);
    const near = view.far * .01, end = view.far + 60, f = 2.2;
    const eye = view.at.map((x, k) => x + back[k] * view.far);
    for (const [name, value] of Object.entries({ eye, right, up, back })) gl.uniform3fv(program.at(name), value);
    const flat = canvas.height / canvas.width;
    gl.uniform4f(program.at("lens"), f * Math.min(1, flat), f * Math.min(1 / flat, 1), (end + near) / (near - end), 2 * end * near / (near - end));
  };
  const draw = () => {
    waiting = false;
    if (seen) seen(view);
    const dense = Math.min(devicePixelRatio || 1, 2);
    // A canvas outside of the page, which makes snapshots, keeps its size.
    if (canvas.clientWidth) {
      canvas.width = canvas.clientWidth * dense;
      canvas.height = canvas.clientHeight * dense;
    }
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(.08, .09, .11, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (!shown) return;
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.disable(gl.BLEND);
    const at = axes();
    look(faces, at);
    gl.bindBuffer(gl.ARRAY_BUFFER, points);
    gl.disableVertexAttribArray(1);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribDivisor(0, 0);
    gl.vertexAttribPointer(0, 3, gl.UNSIGNED_SHORT, true, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners);
    gl.uniform3fv(faces.at("low"), shown.low);
    gl.uniform3fv(faces.at("size"), shown.size);
    for (const { colour, runs } of shown.faces) {
      gl.uniform3fv(faces.at("colour"), colour);
      for (let k = 0; k < runs.length; k += 2) gl.drawElements(gl.TRIANGLES, 3 * runs[k + 1], gl.UNSIGNED_INT, 12 * runs[k]);
    }
    look(lines, at);
    gl.uniform2f(lines.at("view"), canvas.width, canvas.height);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    for (const [first, past, colour] of boxRuns(shown)) {
      stroke(boxes, first * 12, (past - first) * 12, { colour, wide: 1.3 * dense, dash: 0 });
    }
    for (const one of shown.lines) {
      gl.bindBuffer(gl.ARRAY_BUFFER, extra);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(one.at), gl.DYNAMIC_DRAW);
      stroke(extra, 0, one.at.length / 6, { ...one, wide: one.wide * dense });
    }
    gl.depthMask(true);
  };
  // What lies behind the mesh shines through it.
  const stroke = (buffer, first, count, { colour, wide, dash }) => {
    if (count < 1) return;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    for (const k of [0, 1]) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribDivisor(k, 1);
      gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 24, 24 * first + 12 * k);
    }
    gl.uniform1f(lines.at("wide"), wide);
    gl.uniform1f(lines.at("dash"), dash || 0);
    for (const [test, alpha] of [[gl.GREATER, .3], [gl.LEQUAL, 1]]) {
      gl.depthFunc(test);
      gl.uniform4f(lines.at("tint"), colour[0], colour[1], colour[2], (colour[3] ?? 1) * alpha);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    }
  };
  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };
  const turn = (x, y) => {
    view.yaw += x;
    view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + y));
    redraw();
  };
  const zoom = (factor) => { view.far = Math.max(.05, Math.min(40, view.far * factor)); redraw(); };
  const pan = (x, y) => {
    const { right, up } = axes();
    view.at = view.at.map((p, k) => p + .9 * view.far * (y * up[k] - x * right[k]));
    redraw();
  };
  const reset = () => { view = { ...start, at: [...start.at] }; redraw(); };

  const held = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, event);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = held.get(event.pointerId);
    if (!last) return;
    const other = [...held.values()].find((one) => one.pointerId !== event.pointerId);
    const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY) + 1;
    if (other) zoom(apart(last) / apart(event));
    else if (event.shiftKey || event.buttons & 2) pan((event.clientX - last.clientX) / canvas.clientHeight, (event.clientY - last.clientY) / canvas.clientHeight);
    else turn((last.clientX - event.clientX) * .01, (event.clientY - last.clientY) * .01);
    held.set(event.pointerId, event);
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => held.delete(event.pointerId));
  // The right button moves what is seen.
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(event.deltaY * .001));
  }, { passive: false });
  const keys = { ArrowLeft: () => turn(-.1, 0), ArrowRight: () => turn(.1, 0), ArrowUp: () => turn(0, .1), ArrowDown: () => turn(0, -.1), "+": () => zoom(.85), "=": () => zoom(.85), "-": () => zoom(1 / .85), "0": reset, w: () => pan(0, .05), s: () => pan(0, -.05), a: () => pan(.05, 0), d: () => pan(-.05, 0) };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  new ResizeObserver(redraw).observe(canvas);

  return {
    zoom, reset, draw,
    // The mesh and all boxes go to the graphics card once; what is shown of them changes.
    load: (mesh, boxLines, from, now = {}) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, points);
      gl.bufferData(gl.ARRAY_BUFFER, mesh.places, gl.STATIC_DRAW);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.corners, gl.STATIC_DRAW);
      gl.bindBuffer(gl.ARRAY_BUFFER, boxes);
      gl.bufferData(gl.ARRAY_BUFFER, boxLines, gl.STATIC_DRAW);
      start = { ...home, ...from };
      view = { ...start, ...now };
      redraw();
    },
    show: (what) => { shown = what; redraw(); },
  };
};
