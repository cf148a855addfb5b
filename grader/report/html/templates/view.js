// The viewer's page: it turns the model here, and asks the program that served it for the rest.
(() => {
  const byId = (id) => document.getElementById(id);
  const { words, most } = JSON.parse(byId("data").textContent);
  const filled = (text, values) => text.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
  const stage = byId("stage"), traced = byId("traced"), paper = traced.getContext("2d");
  const level = byId("level"), only = byId("only"), mode = byId("mode"), scene = byId("scene");
  const list = byId("steps");
  let opened = null, state = null, subject = -1, tree = -1, look = null, sent = "", image = -1;
  // The subject whose mesh and camera are here; `subject` may still be on its way.
  let loaded = -1;

  // What the program says in a sentence when it will not or cannot answer; it goes on.
  class Failed extends Error {}
  // It said nothing, for once or for ever: that is told by whoever asks again and again.
  class Silent extends Error {}
  let failed = "";
  const lost = (error) => {
    if (error instanceof Silent) return;
    if (!(error instanceof Failed)) throw error;
    failed = byId("trouble").textContent = error.message;
    byId("trouble").hidden = false;
  };
  const ask = async (what, body) => {
    const answer = await fetch(what, body === undefined ? {} : { method: "POST", body: body instanceof Blob ? body : JSON.stringify(body) }).catch(() => { throw new Silent(what); });
    if (answer.status === 500 || answer.status === 400) throw new Failed(await answer.json());
    if (!answer.ok) throw new Silent(`${what}: ${answer.status}`);
    return answer;
  };
  const wish = (what, values = {}) => {
    failed = "";
    return ask("do", { what, ...values }).then((answer) => answer.json()).then(take).catch(lost);
  };

  // What is too large would be refused before it has been sent, and nobody would hear why.
  const open = (file) => {
    failed = "";
    const allowed = file.name.toLowerCase().endsWith(".json") ? most.json : most.mesh;
    if (file.size > allowed) return lost(new Failed(filled(words.large, { name: file.name, most: allowed.toLocaleString(document.documentElement.lang) })));
    return ask(`drop?name=${encodeURIComponent(file.name)}`, file).then((answer) => answer.json()).then(take).catch(lost);
  };

  // The camera goes to the program as soon as it has taken the one before.
  let underway = false;
  const tell = async () => {
    if (underway || !look || !opened) return;
    const dense = Math.min(devicePixelRatio || 1, 2);
    const size = [traced.clientWidth, traced.clientHeight].map((side) => Math.max(16, Math.round(side * dense)));
    const now = JSON.stringify({ ...look, size });
    if (now === sent) return;
    underway = true;
    try { await ask("look", { ...look, size }); sent = now; } catch (error) { lost(error); return; } finally { underway = false; }
    tell();
  };
  const space = openSpace(stage, (view) => { look = { yaw: view.yaw, pitch: view.pitch, far: view.far, at: view.at }; tell(); });
  byId("flat").hidden = space !== null;

  const show = () => {
    if (!opened || !state) return;
    const { node, ray, step } = state;
    // Its faces are those of the mesh that is here, unless another one is on its way.
    const marked = node && loaded === subject ? node.faces : [];
    Object.assign(opened.model, { node: null, expected_box: node ? node.right_box : null, marked, ray });
    const what = display(opened, { level: Number(level.value), only: only.checked, step });
    what.levels = true;
    // It may lie below the levels that the page was given.
    if (node && node.box) what.lines.push({ at: edgesOf(opened.moved(node.box)), colour: node.wrong ? COLOURS.node : COLOURS.marked, wide: 3 });
    byId("level-told").value = level.value < 0 ? "\u2013" : level.value;
    if (space) space.show(what);
  };

  const button = (text, action) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.addEventListener("click", action);
    return made;
  };
  // What is told again is left alone: a click, the focus and the scrollbar are somebody's.
  const family = byId("family");
  let noded = "null";
  const tellNode = ({ node }) => {
    if (node && document.activeElement !== byId("node")) byId("node").value = node.index;
    const key = JSON.stringify(node), held = [...family.children].indexOf(document.activeElement);
    if (key === noded) return;
    noded = key;
    byId("facts").textContent = node ? node.told : "";
    family.replaceChildren(...(node ? node.family : []).map(([name, index]) => button(`${name} ${index}`, () => wish("node", { node: index }))));
    if (held >= 0 && family.lastChild) (family.children[held] ?? family.lastChild).focus();
    byId("faults").replaceChildren(...(node ? node.faults : []).map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  };
  const noRay = byId("ray-told").textContent;
  let listed = "", reached = -1;
  const tellRay = ({ ray, step, lost }) => {
    const key = JSON.stringify([ray, lost]);
    if (key === listed && step === reached) return;
    byId("step-told").value = ray ? filled(words.step, { step, steps: ray.total }) : "";
    if (key !== listed) {
      byId("ray-told").textContent = ray ? ray.told : noRay;
      list.replaceChildren(...(ray ? ray.steps : []).map((one, place) => {
        const item = document.createElement("li");
        const what = one.node !== null ? filled(words.box, one) : one.face !== null ? filled(words.triangle, one) : words.unknown;
        item.textContent = `${what}: ${one.hit ? words.hit : words.missed}${place === lost ? ` \u2190 ${words.lost}` : ""}`;
        if (place === lost) item.className = "lost";
        item.addEventListener("click", () => wish("step", { step: place + 1 }));
        return item;
      }));
    }
    [listed, reached] = [key, step];
    [...list.children].forEach((item, place) => {
      if (place === step - 1) { item.setAttribute("aria-current", "step"); list.scrollTop = item.offsetTop - list.offsetTop - list.clientHeight / 2; }
      else item.removeAttribute("aria-current");
    });
  };
  const load = async (now) => {
    const model = await (await ask("model")).json();
    const next = model && await openModel(model);
    // Meanwhile another one may have been asked for.
    if (!next || subject !== now.subject || tree !== now.tree) return;
    const before = loaded === now.subject ? { ...look } : {};
    [opened, loaded] = [next, now.subject];
    // As long as there is no tree, the level that is wanted stays as it is.
    if (model.boxes.count) level.max = Math.floor(Math.log2(model.boxes.count));
    if (space) space.load(opened.mesh, opened.boxLines, model.home, before);
    else look = { ...model.home, ...before };
    document.body.dataset.shown = `${subject}.${tree}`;
  };
  let levelling = 0;
  const take = async (now) => {
    // An answer may come behind one that was given later.
    if (state && now.told < state.told) return;
    state = now;
    for (const id of ["status", "remark"]) if (byId(id).textContent !== now[id]) byId(id).textContent = now[id];
    // What was just refused comes first: an older trouble may stay for long.
    byId("trouble").textContent = [failed, now.trouble].filter(Boolean).join(" / ");
    byId("trouble").hidden = !(now.trouble || failed);
    byId("again").hidden = !now.ended;
    if (document.activeElement !== mode) mode.value = now.mode;
    if (now.scene && document.activeElement !== scene) scene.value = now.scene;
    byId("scale").hidden = !now.scale;
    byId("scale-most").textContent = now.scale ?? "";
    byId("scale-told").textContent = now.cost;
    byId("differ").textContent = now.differ;
    byId("differ").hidden = !now.differ;
    if (now.subject !== subject || now.tree !== tree) {
      const had = [subject, tree];
      [subject, tree] = [now.subject, now.tree];
      try { await load(now); } catch (error) {
        // Unless another one was asked for, this one is to be asked for again.
        if (subject === now.subject && tree === now.tree) [subject, tree] = had;
        throw error;
      }
      // Meanwhile something newer may have been told.
      now = state;
    }
    if (!levelling) [level.value, only.checked] = [now.level, now.only];
    tellNode(now);
    tellRay(now);
    show();
    tell();
  };
  const paint = async () => {
    const answer = await ask(`image?after=${image}`);
    if (answer.status === 204) return;
    const [width, height, version, share] = ["width", "height", "version", "share"].map((name) => Number(answer.headers.get(`x-${name}`)));
    const rgb = new Uint8Array(await answer.arrayBuffer()), rgba = new Uint8ClampedArray(4 * width * height);
    for (let k = 0, n = 0; k < rgba.length; k += 4, n += 3) { rgba[k] = rgb[n]; rgba[k + 1] = rgb[n + 1]; rgba[k + 2] = rgb[n + 2]; rgba[k + 3] = 255; }
    traced.width = width;
    traced.height = height;
    paper.putImageData(new ImageData(rgba, width, height), 0, 0);
    image = version;
    traced.dataset.share = share;
  };
  // One question after the other; one that fails is asked again, but not for ever.
  const again = async (action, pause) => {
    for (let failures = 0; ;) {
      try { await action(); failures = 0; } catch (error) {
        if (error instanceof Failed) lost(error);
        else if (++failures === 6) {
          byId("trouble").textContent = words.gone;
          byId("trouble").hidden = false;
          return lost(error);
        }
      }
      await new Promise((done) => setTimeout(done, failures ? 100 * 2 ** failures : pause));
    }
  };

  const choose = () => {
    show();
    levelling++;
    wish("level", { level: Number(level.value), only: only.checked }).finally(() => levelling--);
  };
  level.addEventListener("input", choose);
  only.addEventListener("change", choose);
  mode.addEventListener("change", () => wish("mode", { mode: mode.value }));
  scene.addEventListener("change", () => wish("scene", { scene: scene.value }));
  byId("next-node").addEventListener("click", () => wish("next-node"));
  byId("next-ray").addEventListener("click", () => wish("next-ray"));
  // Counted here as well: a key may be pressed again before the answer to it has come.
  const step = (by) => state && wish("step", { step: state.step += by });
  byId("before").addEventListener("click", () => step(-1));
  byId("after").addEventListener("click", () => step(1));
  byId("again").addEventListener("click", () => wish("again"));
  const keys = { n: () => wish("next-node"), r: () => wish("next-ray"), ",": () => step(-1), ".": () => step(1) };
  document.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select, [type=number]")) return;
    keys[event.key]();
  });
  byId("node").addEventListener("change", () => wish("node", { node: Number(byId("node").value) }));
  byId("anew").addEventListener("click", () => space && space.reset());
  byId("file").addEventListener("change", () => {
    [...byId("file").files].slice(-1).forEach(open);
    // Or the same file could not be chosen again, after it was changed.
    byId("file").value = "";
  });
  // Elsewhere on the page a browser would open the file itself.
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => { event.preventDefault(); [...event.dataTransfer.files].slice(-1).forEach(open); });
  const pixel = (canvas, event) => {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  };
  traced.addEventListener("click", (event) => wish("follow", { at: pixel(traced, event) }));
  let pressed = null;
  stage.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
  stage.addEventListener("pointerup", (event) => {
    const moved = pressed ? Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) : 9;
    if (moved < 3 && event.button === 0) wish("pick", { at: pixel(stage, event) });
  });
  byId("save").addEventListener("click", () => {
    if (space) space.draw();
    const both = Object.assign(document.createElement("canvas"), { width: 2 * traced.width + 8, height: traced.height });
    const drawn = both.getContext("2d");
    drawn.drawImage(stage, 0, 0, traced.width, traced.height);
    drawn.drawImage(traced, traced.width + 8, 0);
    const link = Object.assign(document.createElement("a"), { href: both.toDataURL(), download: "bvhgrade-view.png" });
    link.click();
  });
  new ResizeObserver(tell).observe(traced);
  again(() => ask("state").then((answer) => answer.json()).then(take), 200);
  again(paint, 10);
})();
