// What a reader does with the machine in 3D: turn it, play its motion, and move it by hand where the page brings its geometry. Two modes,
// which share the picture: in "Motion" the bodies come from the model's animation, and the time is that of all plots; in "By hand" they
// come from the coordinates that the reader sets.

// ---- The reader's hands ----

const speeds = [["0.1", "×0.1"], ["0.25", "×0.25"], ["0.5", "×0.5"], ["1", "true speed"], ["2", "×2"], ["5", "×5"]];

function button(label, attributes, act) {
  const made = element("button", { type: "button", class: "view-button", ...attributes }, label);
  made.addEventListener("click", act);
  return made;
}

function group(label, names, act) {
  return element("div", { class: "view-choice", role: "group", "aria-label": label }, ...names.map((name) => button(name, {}, () => act(name))));
}

// The canvas and the camera before it; null without WebGL 2. `hands`: grab(body, place) may take a drag that begins on a body, -1 for none,
// and answers with what follows it; hover(body), where `body()` is that under the pointer; space(); painted(camera, width, height).
function makeStage(box, model, canvas, hands) {
  const points = reachOf(model), low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k]))), high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
  const wide = Math.max(Math.hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
  const reference = model.platform >= 0 ? model.bodies[model.platform] : null, path = [], trace = reference?.translations;
  for (let k = 0; trace && k + 3 < trace.length; k += 3) path.push(...trace.subarray(k, k + 6));
  const centre = along(low, [0.5, less(high, low)]), reach = 1.15 * wide;
  const stage = {
    ground: low[2] - 2e-4 * wide, middle: [centre[0], centre[1]], reach, step: roundStep(wide / 25), frame: 0.16 * wide, path, centre, depth: 3 * wide,
  };
  let painter = makePainter(canvas, model, stage);
  if (!painter) return null;

  const dark = matchMedia("(prefers-color-scheme: dark)");
  const size = () => [canvas.clientWidth || 1, canvas.clientHeight || 1];
  const names = ["x", "y", "z"].map((name) => element("span", { class: "axis axis-" + name, "aria-hidden": "true" }, name));
  box.append(...names);
  let home = framing(points, standpoints.Isometric, 1.5), camera = home, asked = null, inSight = true, untouched = true;
  const show = { poses: posesAt(model, model.begin), marked: -1, room: 1 };  // room: for what moves farther than the motion
  const framed = (name, aspect) => {
    const tight = framing(points, standpoints[name], aspect);
    return { ...tight, height: tight.height * show.room };
  };

  // Where drawing is slow, as without a graphics card, it is coarse while things move, and fine once they rest.
  let pace = 0, rest = null, rested = false;
  const paint = () => {
    if (!rested) pace = 0.5 * (pace + performance.now() - asked);
    asked = null;
    if (!inSight || !painter) return;
    const quick = pace > 50 && !rested;
    rested = false;
    clearTimeout(rest);
    if (quick)
      rest = setTimeout(() => {
        rested = true;
        draw();
      }, 250);
    const [width, height] = size(), pixels = quick ? 1 : Math.min(devicePixelRatio || 1, 3);
    if (canvas.width !== Math.round(width * pixels)) canvas.width = Math.round(width * pixels);
    if (canvas.height !== Math.round(height * pixels)) canvas.height = Math.round(height * pixels);
    if (untouched) camera = home = framed("Isometric", width / height);
    painter(show.poses, camera, { dark: dark.matches, marked: show.marked, quick });
    names.forEach((name, axis) => {
      const [x, y] = seen(camera, [0, 1, 2].map((k) => (k === axis ? 1.12 * stage.frame : 0)), width, height);
      name.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    });
    hands.painted(camera, width, height);
  };
  const draw = () => {
    if (asked !== null) return;
    asked = performance.now();
    requestAnimationFrame(paint);
  };
  const look = (next) => {
    camera = next;
    untouched = false;
    draw();
  };
  const stand = (name) => {
    const [width, height] = size();
    home = framed(name, width / height);
    look(home);
  };
  const reset = () => {
    untouched = true;
    draw();
  };

  new ResizeObserver(draw).observe(canvas);
  addEventListener("resize", draw);
  dark.addEventListener("change", draw);
  new IntersectionObserver((entries) => {
    inSight = entries[entries.length - 1].isIntersecting;
    draw();
  }).observe(canvas);
  // A browser may take the graphics card away, and give it back. Until then the still picture stands in.
  const still = element("div", { class: "view-lost", role: "status" });
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    painter = null;
    const cover = document.querySelector(".front figure img");
    still.replaceChildren(element("p", { class: "note" }, "The browser has lost its connection to the graphics card, and cannot draw in 3D until it is back." + (cover ? " The picture shows the machine at home." : "")));
    if (cover) still.append(element("img", { src: cover.src, alt: cover.alt }));
    box.append(still);
  });
  canvas.addEventListener("webglcontextrestored", () => {
    painter = makePainter(canvas, model, stage);
    if (painter) still.remove();
    draw();
  });

  // The ray of a place in the picture: from the plane through the target, towards the machine's far side.
  const bodyAt = ([x, y]) => {
    const [width, height] = size(), towards = axesOf(camera).towards;
    return pick(model, show.poses, along(pointed(camera, x, y, width, height), [stage.depth, towards]), towards.map((v) => -v));
  };
  const placeOf = (event) => {
    const area = canvas.getBoundingClientRect();
    return [event.clientX - area.left, event.clientY - area.top];
  };

  // Pointers that are down, and where. One turns the picture or holds a body; two move and zoom it.
  const down = new Map();
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse" && event.button > 1) return;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, placeOf(event));
    if (event.button === 1) event.preventDefault();
    if (down.size > 1) held = null;
    else if (event.button === 0 && !event.shiftKey) held = hands.grab(bodyAt(placeOf(event))?.body ?? -1, placeOf(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const [x, y] = placeOf(event), before = down.get(event.pointerId), [width, height] = size();
    if (!before) {
      if (event.pointerType === "mouse") hands.hover(() => bodyAt([x, y])?.body ?? -1);
      return;
    }
    const [dx, dy] = [x - before[0], y - before[1]];
    if (held) held([x, y]);
    else if (down.size === 2) {
      const other = [...down].find(([id]) => id !== event.pointerId)[1], far = (p) => Math.max(20, Math.hypot(p[0] - other[0], p[1] - other[1]));
      const moved = { ...camera, target: shifted(camera, camera.target, -dx / 2, -dy / 2, height) };
      look(zoomed(moved, far([x, y]) / far(before), (x + other[0]) / 2, (y + other[1]) / 2, width, height, home));
    } else if (event.shiftKey || event.buttons === 4) look({ ...camera, target: shifted(camera, camera.target, -dx, -dy, height) });
    else look(orbited(camera, -dx * 0.008, event.pointerType === "touch" ? 0 : dy * 0.008));
    down.set(event.pointerId, [x, y]);
  });
  canvas.addEventListener("pointerleave", () => hands.hover(() => -1));
  for (const over of ["pointerup", "pointercancel"])
    canvas.addEventListener(over, (event) => {
      down.delete(event.pointerId);
      held = null;
    });
  // One finger scrolls the page up and down; two are ours, and so is one that holds a body.
  for (const touch of ["touchstart", "touchmove"])
    canvas.addEventListener(touch, (event) => event.touches.length > 1 || held ? event.cancelable && event.preventDefault() : null, { passive: false });
  // The wheel scrolls the page until the picture has been chosen.
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1), [x, y] = placeOf(event), [width, height] = size();
    look(zoomed(camera, Math.exp(-clamped(pixels, -200, 200) * (event.ctrlKey ? 0.01 : 0.0015)), x, y, width, height, home));
  }, { passive: false });
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const [width, height] = size(), far = event.shiftKey ? 30 : 5 * deg;
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const zoom = { "+": 1.2, "=": 1.2, "-": 1 / 1.2, "_": 1 / 1.2 }[event.key];
    if (arrow && event.shiftKey) look({ ...camera, target: shifted(camera, camera.target, -far * arrow[0], -far * arrow[1], height) });
    else if (arrow) look(orbited(camera, -far * arrow[0], far * arrow[1]));
    else if (zoom) look(zoomed(camera, zoom, width / 2, height / 2, width, height, home));
    else if (event.key === "Home" || event.key === "0") reset();
    else if (event.key === " ") hands.space();
    else return;
    event.preventDefault();
  });
  draw();
  return { show, draw, stand, reset, size, camera: () => camera, step: stage.step };
}

// Play, time and speed; null where the model does not move. `followed` is called with each time.
function makePlayer(model, followed) {
  if (model.times.length < 2) return null;
  const low = model.begin + model.times[0], high = model.begin + model.times[model.times.length - 1];
  let time = low, playing = false, ours = null, before = 0;
  const slider = timeSlider(low, high);
  const speed = element("select", { "aria-label": "Speed" }, ...speeds.map(([value, name]) => element("option", value === "1" ? { value, selected: "" } : { value }, name)));
  const toggle = () => set(!playing);
  const play = button("▶ Play", { class: "view-button play" }, toggle);
  const set = (on) => {
    if (on === playing) return;
    playing = on;
    play.textContent = on ? "❚❚ Pause" : "▶ Play";
    before = performance.now();
    if (on) requestAnimationFrame(step);
  };
  const step = (now) => {
    if (!playing) return;
    ours = nextTime(time, (Math.max(0, now - before) / 1000) * Number(speed.value), low, high);
    before = now;
    clock.move(ours);
    requestAnimationFrame(step);
  };
  // Whoever else moves the time has it.
  clock.followers.push((asked) => {
    if (playing && asked !== ours) set(false);
    time = clamped(asked, low, high);
    slider.follow(time);
    followed(time);
  });
  slider.follow(time);
  return { row: element("div", { class: "view-row" }, play, slider.row, speed), toggle, set, time: () => time };
}

// A slider with its number, which may be typed as well. `move(value)` gets what the reader asks for, in the unit of the item, and answers
// what stands beside the number then: why it was not taken, or how. A remark stays until something else is asked for.
function makeEntry(name, unit, low, high, move) {
  const label = unit ? name + " in " + unit : name;
  const slider = element("input", { type: "range", min: low, max: high, step: "any", "aria-label": label });
  const number = element("input", { type: "text", inputmode: "decimal", class: "entry", autocomplete: "off", "aria-label": label + ", as a number" });
  const remark = element("span", { class: "remark", role: "status" });
  let at = low, text = "";
  const say = (words, refused) => {
    remark.textContent = words;
    number.setAttribute("aria-invalid", String(refused));
  };
  const follow = (value) => {
    at = value;
    text = told(value, low, low + (high - low) / 10);  // a digit more than a plot tells
    slider.value = value;
    slider.setAttribute("aria-valuetext", withUnit(text, unit));
    if (document.activeElement !== number) number.value = text;
    say("", false);
  };
  slider.addEventListener("input", () => move(Number(slider.value)));
  slider.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (steps === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    move(clamped(Number(slider.value) + (steps * (high - low)) / 200, low, high));
  });
  number.addEventListener("input", () => say("", false));
  number.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    number.value = text;
    say("", false);
    number.blur();
  });
  number.addEventListener("change", () => {
    const written = number.value, typed = numberTyped(written);
    number.blur();
    const answer = typed === null ? { refused: "no number" } : move(typed);
    if (typed === null) follow(at);
    if (answer.refused) say(remarkOf(written, answer.refused), true);
    else if (answer.taken) say(answer.taken, false);
  });
  return { slider, number, remark, follow };
}

// The machine by hand: coordinates and actuators to set, and what comes of it. `moved(state)` is called with each pose that is reached.
function makeHands(live, moved) {
  let x = live.home, state = live.at(x), quiet = null;
  const status = element("p", { class: "hand-status" }), spoken = element("p", { class: "unseen", "aria-live": "polite" });
  const condition = element("strong", {}), limits = element("tbody", {});
  const say = (text, bad) => {
    status.textContent = text;
    status.classList.toggle("broken", bad);
    clearTimeout(quiet);
    quiet = setTimeout(() => spoken.textContent !== text && (spoken.textContent = text), 700);
  };

  // Whether it went there.
  const set = (next, why = "reach") => {
    const reached = next && live.at(next);
    if (!reached || !reached.reachable) {
      say(refusalOf(why), true);
      follow();
      return false;
    }
    x = next;
    state = reached;
    say(verdictOf(state), state.margins.some((m) => m.broken));
    follow();
    moved(state);
    return true;
  };

  const entryCell = (entry, unit) => element("td", { class: "number value" }, entry.number, " ", element("span", { class: "unit" }, unit), entry.remark);
  // What an entry says of a move to here.
  const answerOf = (moved, why) => (moved ? {} : { refused: refusals[why][0].toLowerCase() + refusals[why].slice(1) });
  const coordinates = live.coordinates.map(({ symbol, title, unit, factor, min, max }, i) => {
    const entry = makeEntry(symbol, unit, min * factor, max * factor, (value) => answerOf(set(Array.from(x, (old, k) => (k === i ? value / factor : old))), "reach"));
    const row = element("tr", {}, element("th", { scope: "row", title }, symbol), element("td", {}, entry.slider), entryCell(entry, unit));
    return { row, follow: () => entry.follow(x[i] * factor) };
  });
  const actuators = live.actuators.map(({ symbol, title, unit, factor, rotary, min, max, effort }, i) => {
    const bounded = Number.isFinite(min) && Number.isFinite(max), here = state.actuators[i], reach = bounded ? (max - min) / 10 : Math.abs(here) || 1;
    const from = (bounded ? min : here) - reach, to = (bounded ? max : here) + reach;
    const entry = makeEntry(symbol, unit, from * factor, to * factor, (value) => {
      const how = {}, moved = set(live.solve(Array.from(state.actuators, (old, k) => (k === i ? value / factor : old)), x, how), how.why);
      if (moved && rotary) return { taken: turnsTold(value / factor / deg, state.actuators[i] / deg) };
      return answerOf(moved, how.why || "reach");
    });
    const word = element("span", { class: "word" }), push = element("td", { class: "number force" });
    const row = element("tr", {}, element("th", { scope: "row", title }, symbol, " ", word), element("td", {}, element("div", { class: bounded ? "stroke" : "" }, entry.slider)), entryCell(entry, unit), push);
    const follow = () => {
      const value = state.actuators[i], beyond = state.margins[i].broken;
      entry.follow(value * factor);
      word.textContent = beyond ? "beyond" : "";
      row.classList.toggle("broken", beyond);
      const most = Math.max(...state.forces.map((force) => Math.abs(force * effort.factor)));
      push.textContent = withUnit(told(state.forces[i] * effort.factor, 0, most), effort.unit);
    };
    return { row, follow };
  });

  const follow = () => {
    for (const item of [...coordinates, ...actuators]) item.follow();
    condition.textContent = Number.isFinite(state.condition) ? told(state.condition) : "–";
    limits.replaceChildren(...byRoom(state.margins).slice(0, 6).map((m) => {
      const left = toldLimited(Math.abs(m.margin), m);
      return element("tr", m.broken ? { class: "broken" } : {}, element("th", { scope: "row" }, m.name), element("td", { class: "number" }, toldLimited(m.value, m)),
        element("td", { class: "number" }, limitsOf(m)), element("td", { class: "number" }, m.broken ? "broken by " + left : left));
    }));
  };
  const effort = live.actuators.every((a) => a.effort.name === live.actuators[0].effort.name) ? live.actuators[0].effort.name : "effort";
  const verdict = element("div", { class: "hand-verdict" }, status, spoken);
  const panel = element("div", { class: "hand" },
    element("div", { class: "hand-columns" },
      makeTable("hand-table", "Coordinates", [heading("Coordinate"), heading("Range"), heading("Value", "number")], coordinates.map(({ row }) => row)),
      makeTable("hand-table", "Actuators", [heading("Actuator"), heading("Stroke"), heading("Value", "number"), heading("Static " + effort, "number")], actuators.map(({ row }) => row))),
    element("p", { class: "hand-condition" }, "Condition number of the Jacobian: ", condition,
      `. Static: at rest under all weights and the load of the scenario${live.load.varies ? ", that of its first instant" : ""}.`),
    element("table", { class: "hand-limits" }, element("caption", {}, "Limits, the nearest first"),
      element("thead", {}, element("tr", {}, heading("What is limited"), heading("Value", "number"), heading("Allowed", "number"), heading("Left", "number"))), limits));
  say(verdictOf(state), state.margins.some((m) => m.broken));
  follow();
  return { panel, verdict, toHome: button("Home pose", {}, () => set(live.home)), set, x: () => x, state: () => state };
}

// Whether there is anything to see.
function showMachine(section, model, live) {
  const help = element("p", { class: "note view-help", id: "view-help" });
  const canvas = element("canvas", { tabindex: 0, role: "application", "aria-label": "The machine in 3D", "aria-describedby": "view-help" });
  const box = element("div", { class: "view-stage" }, canvas);
  let mode = "Motion", hand = null, player = null, begin = () => {};
  const platform = model.platform;

  const drag = (from) => {
    const start = hand.state().bodies[platform].origin, [, height] = stage.size();
    return (to) => hand.set(live.dragged(hand.x(), shifted(stage.camera(), start, to[0] - from[0], to[1] - from[1], height)));
  };
  const mark = (bodyThere) => {
    const marked = mode === "By hand" && bodyThere() === platform ? platform : -1;
    canvas.classList.toggle("on-platform", marked >= 0);
    if (stage.show.marked === marked) return;
    stage.show.marked = marked;
    stage.draw();
  };
  const grip = button("", { class: "grip", "aria-label": "The platform: arrow keys move it parallel to the picture" }, () => {});
  const stage = makeStage(box, model, canvas, {
    grab: (body, place) => (mode === "By hand" && body === platform ? drag(place) : null),
    hover: mark,
    space: () => mode === "Motion" && player?.toggle(),
    painted: (camera, width, height) => {
      if (mode !== "By hand") return;
      const [x, y] = seen(camera, hand.state().bodies[platform].origin, width, height);
      grip.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    },
  });
  if (!stage) {
    const text = "This browser has no WebGL 2, which the view in 3D needs. The picture above shows the machine, and data/model.glb is the same model for other programs.";
    section.append(element("p", { class: "note" }, text));
    return false;
  }

  player = makePlayer(model, (time) => {
    if (mode !== "Motion") return;
    stage.show.poses = posesAt(model, time);
    stage.draw();
  });
  const views = group("View from", Object.keys(standpoints), stage.stand);
  const bar = element("div", { class: "view-row" });
  const below = element("div", { class: "view-below" });
  section.append(bar, box, below, help);
  if (player) below.append(player.row);

  if (live && platform >= 0) {
    hand = makeHands(live, ({ bodies }) => {
      stage.show.poses = bodies;
      stage.draw();
    });
    let grabbed = null;
    const placeOf = (event) => [event.clientX, event.clientY];
    grip.addEventListener("pointerdown", (event) => {
      grip.setPointerCapture(event.pointerId);
      grabbed = drag(placeOf(event));
    });
    grip.addEventListener("pointermove", (event) => grabbed?.(placeOf(event)));
    for (const over of ["pointerup", "pointercancel"]) grip.addEventListener(over, () => (grabbed = null));
    grip.addEventListener("keydown", (event) => {
      const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!arrow || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      const far = event.shiftKey ? 20 : 4;
      drag([0, 0])([far * arrow[0], far * arrow[1]]);
    });
    const modes = group("What moves the machine", ["Motion", "By hand"], (name) => change(name));
    const change = (name) => {
      mode = name;
      for (const one of modes.children) one.setAttribute("aria-pressed", String(one.textContent === name));
      const byHand = name === "By hand";
      player?.set(false);
      section.classList.toggle("by-hand", byHand);
      below.replaceChildren(...(byHand ? [hand.panel] : player ? [player.row] : []));
      stage.show.poses = byHand ? hand.state().bodies : posesAt(model, player ? player.time() : model.begin);
      for (const part of [grip, hand.verdict, hand.toHome]) part.remove();
      if (byHand) {
        box.append(grip, hand.verdict);
        views.before(hand.toHome);
      }
      stage.show.room = byHand ? 1.2 : 1;
      mark(() => -1);
      stage.draw();
    };
    if (player) bar.append(modes);
    begin = () => change(player ? "Motion" : "By hand");
  }
  bar.append(views, button("Reset", { "aria-label": "Reset the view" }, stage.reset));
  begin();
  const step = String(Number((stage.step * 5000).toPrecision(3)));
  help.append(
    element("span", { class: "for-mouse" }, "Drag to turn, Shift and drag to move, wheel to zoom once the picture is chosen. Keys: arrows turn, Shift and arrows move, + and − zoom, " +
      (player ? "Space plays, " : "") + "Home resets."),
    element("span", { class: "for-fingers" }, "One finger turns it sideways, two fingers move and zoom it."),
    element("span", { class: "for-hands" }, " Drag the platform, or choose its ring and press arrow keys, to move it parallel to the picture."),
    ` Strong lines of the ground are ${step} mm apart.`);
  return true;
}

async function startView() {
  const source = document.getElementById("machine-model"), section = document.getElementById("machine-view");
  if (!source || !section) return;
  section.hidden = false;
  const place = document.querySelector('#contents a[href="#summary"]')?.parentElement;
  place?.after(element("li", {}, element("a", { href: "#machine-view" }, "3D view")));
  let model;
  try {
    model = readModel(await unpacked(source.textContent));
  } catch (error) {
    section.append(element("p", { class: "note" }, "This browser cannot unpack the model in this page (" + error.message + "). data/model.glb beside it opens in other programs."));
    return;
  }
  source.remove();
  if (showMachine(section, model, liveModel ? makeLive(liveModel) : null))
    document.querySelector(".front figure figcaption")?.append(element("span", { class: "to-view" }, " · ", element("a", { href: "#machine-view" }, "in 3D, to turn and play")));
}
