(() => {
  const byId = (id) => document.getElementById(id);
  const { models, words } = JSON.parse(byId("data").textContent);
  const filled = (text, values) => text.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
  const number = (t) => (t === null ? words.none : String(Number(t.toPrecision(6))));

  for (const figure of document.querySelectorAll(".compare")) {
    const slider = figure.querySelector("input"), layers = figure.querySelector(".layers");
    const move = () => {
      figure.querySelector(".yours").style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`;
      figure.querySelector(".bar-of-slider").style.left = `${slider.value}%`;
    };
    const drag = (event) => {
      if (!event.buttons) return;
      const box = layers.getBoundingClientRect();
      slider.value = (100 * (event.clientX - box.left)) / box.width;
      move();
    };
    slider.addEventListener("input", move);
    for (const name of ["pointerdown", "pointermove"]) layers.addEventListener(name, drag);
    for (const image of layers.querySelectorAll("img")) image.draggable = false;
    figure.nextElementSibling.querySelector("img").src = figure.querySelector(".reference").src;
    move();
  }

  // On paper nothing can be unfolded.
  const folded = [];
  addEventListener("beforeprint", () => {
    for (const one of document.querySelectorAll("details:not([open])")) { folded.push(one); one.open = true; }
  });
  addEventListener("afterprint", () => { for (const one of folded.splice(0)) one.open = false; });
  const unfold = () => {
    const one = location.hash && byId(decodeURIComponent(location.hash.slice(1)));
    if (one && one.localName === "details") { one.open = true; one.scrollIntoView(); }
  };
  addEventListener("hashchange", unfold);
  unfold();
  if (!models.length) return;

  const room = byId("room"), chooser = byId("model"), level = byId("level"), only = byId("only");
  const step = byId("step"), list = byId("steps"), kept = new Map();
  room.hidden = false;
  byId("unscripted").hidden = true;
  const space = openSpace(byId("stage"));
  byId("flat").hidden = space !== null;
  byId("drawn").hidden = space === null;
  models.forEach((model, place) => chooser.add(new Option(model.name, place)));
  let opened = null;

  const say = (one) => {
    const what = one.node !== null ? filled(words.box, one) : one.face !== null ? filled(words.triangle, one) : words.unknown;
    const deep = one.node !== null && one.node >= opened.model.boxes.count ? ` (${words.deep})` : "";
    return `${what}: ${one.hit ? words.hit : words.missed}${deep}`;
  };
  // If the walk never came to a node, its parent was the last on the way, or the parent of that.
  const lostAt = ({ ray }) => {
    for (let node = ray ? ray.lost : null; node !== null && node >= 0; node = Math.ceil(node / 2) - 1) {
      const place = ray.steps.findLastIndex((one) => one.node === node);
      if (place >= 0) return place;
    }
    return -1;
  };
  const firstStep = (model) => lostAt(model) + 1;
  const listSteps = () => {
    const { ray } = opened.model, lost = lostAt(opened.model);
    list.replaceChildren(...ray.steps.map((one, place) => {
      const item = document.createElement("li");
      item.textContent = say(one);
      if (place === lost) { item.className = "lost"; item.textContent += ` \u2190 ${words.lost}`; }
      item.addEventListener("click", () => { step.value = place + 1; show(); });
      return item;
    }));
  };
  const tell = () => {
    const { model } = opened, { ray } = model, told = [];
    if (model.faces !== model.mesh.faces) told.push(filled(words.coarse, { faces: model.mesh.faces.toLocaleString("en").replaceAll(",", words.group) }));
    if (model.node !== null) told.push(filled(model.expected_box ? words.wrong : words.node, model));
    if (ray && ray.sentence) told.push(ray.sentence);
    if (ray) told.push(filled(words.outcome, { expected: number(ray.expected_t), got: number(ray.got_t) }));
    byId("told").textContent = told.join("; ");
  };
  const show = () => {
    if (!opened) return;
    const state = { level: Number(level.value), only: only.checked, step: Number(step.value) };
    byId("level-told").value = state.level < 0 ? "\u2013" : state.level;
    byId("step-told").value = filled(words.step, { step: state.step, steps: step.max });
    if (!state.step) list.scrollTop = 0;
    [...list.children].forEach((item, place) => {
      const now = place === state.step - 1;
      if (now) { item.setAttribute("aria-current", "step"); list.scrollTop = item.offsetTop - list.offsetTop - list.clientHeight / 2; }
      else item.removeAttribute("aria-current");
    });
    const keys = shownKeys(opened, state);
    for (const item of byId("key").children) item.hidden = !keys.has(item.dataset.key);
    if (space) space.show(display(opened, state));
  };
  const choose = async (place) => {
    chooser.value = place;
    if (!kept.has(place)) kept.set(place, openModel(models[place]));
    const now = await kept.get(place);
    if (Number(chooser.value) !== place) return;
    opened = now;
    const { ray, node, boxes } = now.model;
    level.max = Math.max(0, Math.floor(Math.log2(Math.max(1, boxes.count))));
    level.value = ray || node !== null ? -1 : Math.min(4, level.max);
    only.checked = !ray && node === null;
    byId("walk").hidden = !ray;
    step.max = ray ? ray.steps.length : 0;
    if (ray) listSteps();
    else list.replaceChildren();
    step.value = firstStep(now.model);
    if (space) space.load(now.mesh, now.boxLines, viewpoint(now));
    tell();
    show();
    room.dataset.shown = place;
  };
  chooser.addEventListener("change", () => choose(Number(chooser.value)));
  for (const input of [level, only, step]) input.addEventListener("input", show);
  const walk = (by) => { step.value = Number(step.value) + by; show(); };
  byId("before").addEventListener("click", () => walk(-1));
  byId("after").addEventListener("click", () => walk(1));
  if (space) {
    byId("nearer").addEventListener("click", () => space.zoom(.85));
    byId("farther").addEventListener("click", () => space.zoom(1 / .85));
    byId("anew").addEventListener("click", space.reset);
  }
  for (const button of document.querySelectorAll("[data-model]")) {
    button.hidden = false;
    button.addEventListener("click", async () => {
      await choose(Number(button.dataset.model));
      byId("space").scrollIntoView();
      (space ? byId("stage") : list).focus({ preventScroll: true });
    });
  }
  // Each failure shows its model at once, as it looks when one begins to turn it.
  const snapshots = async () => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 640, height: 400 });
    const camera = openSpace(canvas);
    if (!camera) return;
    for (const image of document.querySelectorAll("[data-model] img")) {
      const shot = await openModel(models[image.parentElement.dataset.model]);
      camera.load(shot.mesh, shot.boxLines, viewpoint(shot));
      camera.show(display(shot, { level: -1, only: false, step: firstStep(shot.model) }));
      camera.draw();
      image.src = canvas.toDataURL();
      image.hidden = false;
    }
    canvas.getContext("webgl2").getExtension("WEBGL_lose_context")?.loseContext();
  };
  // First the page, then what takes longer.
  requestAnimationFrame(() => setTimeout(() => choose(0).then(snapshots)));
})();
